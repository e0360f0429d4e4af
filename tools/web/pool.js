// Draws a picture with several workers, each of which draws a band of rows.
import { GnomonError } from "./engine.js";

class Hand {
    constructor() {
        this.waiting = new Map();
        this.next = 0;
        this.worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
        this.worker.onmessage = ({ data }) => this.settle(data.id, data);
        this.worker.onerror = (event) => {
            // The browser says nothing about a worker's file that it could not load.
            this.settleAll(event.message || "worker.js cannot be loaded");
        };
    }

    settleAll(error) {
        for (const id of [...this.waiting.keys()])
            this.settle(id, { error });
    }

    end() {
        this.worker.terminate();
        this.settleAll("the worker has been ended");
    }

    settle(id, data) {
        const { resolve, reject } = this.waiting.get(id);
        this.waiting.delete(id);
        if (data.error)
            reject(new GnomonError(data.error));
        else
            resolve(data);
    }

    ask(message) {
        return new Promise((resolve, reject) => {
            const id = this.next++;
            this.waiting.set(id, { resolve, reject });
            this.worker.postMessage({ ...message, id });
        });
    }
}

// Whether workers can write to one picture.
export function canShare() {
    return typeof SharedArrayBuffer === "function" && globalThis.crossOriginIsolated === true;
}

export class Pool {
    static async create(module, threads) {
        const pool = new Pool(threads);
        try {
            await pool.all({ type: "begin", module });
        } catch (error) {
            pool.end();
            throw error;
        }
        return pool;
    }

    constructor(threads) {
        this.hands = Array.from({ length: threads }, () => new Hand());
        this.shared = null;
    }

    all(message) {
        return Promise.all(this.hands.map((hand) => hand.ask(message)));
    }

    loadModel(model) {
        return this.all({ type: "model", model });
    }

    // Returns the picture, and the longest time that a worker has drawn.
    async draw(state, width, height) {
        const size = width * height * 4;
        if (canShare() && this.shared?.byteLength !== size)
            this.shared = new SharedArrayBuffer(size);

        const count = Math.min(this.hands.length, height);
        const edge = (i) => Math.floor((height * i) / count);
        const bands = await Promise.all(
            this.hands.slice(0, count).map((hand, i) =>
                hand.ask({ type: "draw", state, from: edge(i), end: edge(i + 1), shared: this.shared })
            )
        );
        const pixels = new Uint8Array(size);
        if (this.shared)
            pixels.set(new Uint8Array(this.shared));
        else
            bands.forEach(({ band }, i) => pixels.set(band, edge(i) * width * 4));
        return { pixels, milliseconds: Math.max(...bands.map((band) => band.milliseconds)) };
    }

    end() {
        this.hands.forEach((hand) => hand.end());
    }
}

// Draws where there are no workers, with the page's own engine.
export class LocalPool {
    constructor(page) {
        this.page = page;
    }

    async loadModel() {
        // The page's engine has the model.
    }

    async draw(state, width, height) {
        const started = performance.now();
        const pixels = this.page.engine.draw(0, height).slice();
        return { pixels, milliseconds: performance.now() - started };
    }

    end() {}
}
