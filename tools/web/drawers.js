// What draws: an engine on the page's own thread, the workers, and the dropped model, which all of them
// have. Each exchange of one of them waits for the exchange before it, so that it finds the others whole.
import { compileModule, Engine } from "./engine.js";
import { LocalPool, Pool } from "./pool.js";

export class Drawers {
    // Sets page.engine, page.pool and page.model. drawn() returns a promise that resolves when no picture is
    // being drawn. exchanged() is called after each exchange.
    constructor(page, drawn, exchanged) {
        this.page = page;
        this.drawn = drawn;
        this.exchanged = exchanged;
        this.module = null;
        this.waiting = 0;
        this.last = Promise.resolve();
    }

    isIdle() {
        return this.waiting === 0;
    }

    // Calls action(), which uses the functions below, after all exchanges that were asked for before. Returns
    // its promise.
    async exchange(action) {
        ++this.waiting;
        const done = this.last.then(action);
        this.last = done.catch(() => {}); // who asked for an exchange says that it failed
        try {
            return await done;
        } finally {
            --this.waiting;
            this.exchanged();
        }
    }

    // Loads a module, with the state and the model of the engine before. Its workers end.
    async useModule(url) {
        const { page } = this;
        const module = await compileModule(url);
        const engine = await Engine.create(module);
        await this.drawn();
        if (page.model)
            engine.loadModel(page.model);
        if (page.engine)
            engine.setState(page.engine.state());
        this.module = module;
        page.engine = engine;
        page.pool?.end();
        page.pool = new LocalPool(page);
    }

    // An engine of the module in use.
    createEngine() {
        return Engine.create(this.module);
    }

    // Starts workers. The pool before draws until they are ready, and if they cannot be started.
    async useWorkers(threads) {
        const { page } = this;
        const pool = await Pool.create(this.module, threads);
        try {
            if (page.model)
                await pool.loadModel(page.model);
        } catch (error) {
            pool.end();
            throw error;
        }
        await this.drawn();
        page.pool.end();
        page.pool = pool;
    }

    // Uses an engine that has read a model, and hands the model to the workers. If one of them refuses it,
    // they get the model before.
    async useModel(model, engine) {
        const { page } = this;
        await this.drawn();
        try {
            await page.pool.loadModel(model);
        } catch (error) {
            if (page.model)
                await page.pool.loadModel(page.model);
            throw error;
        }
        engine.setState(page.engine.state());
        page.engine = engine;
        page.model = model;
    }
}
