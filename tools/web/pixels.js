// The pixel cursor, and the pixel that is taken apart right below the pictures.
import { compileModule, Engine } from "./engine.js";
import { copy, fault, say, words } from "./messages.js";

const $ = (id) => document.getElementById(id);

export class Pixels {
    // Reads page.engine, page.model, page.webgl, page.view and page.last; sets page.cursor and page.own.pixel. module
    // is the address of the module that explains; drawn() returns a promise that resolves when no picture is being drawn;
    // chosen() is called when a pixel is chosen.
    constructor(page, { module, drawn, chosen }) {
        this.page = page;
        this.module = module;
        this.drawn = drawn;
        this.chosen = chosen;
        this.engine = null; // which explains
        this.model = null; // of that engine
        this.explained = null; // the state whose pixel is shown
        this.cursorIsOn = false;
    }

    async explainEngine() {
        const { model } = this.page;
        if (!this.engine) {
            this.engine = await Engine.create(await compileModule(this.module));
            this.model = null;
        }
        if (model && this.model !== model) {
            this.engine.loadModel(model);
            this.model = model;
        }
        return this.engine;
    }

    // Takes a pixel apart. The panel is scrolled to if it is not in view and `scrolls` is set.
    async explain(x, y, scrolls = true) {
        const { page } = this;
        $("pixel-x").value = x;
        $("pixel-y").value = y;
        page.cursor = [x, y];
        page.own.pixel = `${x},${y}`;
        this.showCursor();
        this.chosen();
        $("pixel").setAttribute("aria-busy", "true");
        try {
            const state = page.engine.state();
            const [engine, { showExplained }, { factsOf }, { sentenceOf }] = await Promise.all(
                [this.explainEngine(), import("./explain.js"), import("./facts.js"), import("./why.js")]);
            engine.setState(state);
            engine.build();
            const explained = engine.explain(x, y);
            await this.drawn();
            const why = page.last.state === state ? sentenceOf(factsOf(explained, page.last, page.webgl)) : "The picture has changed.";
            showExplained($("pixel"), explained, why, page.last, (text) => copy(text, "The text"));
            this.explained = state;
            page.view.edges = explained;
            page.view.draw();
            fault("explain", "");
            say(`Pixel ${x}, ${y}: ${why}`);
        } catch (error) {
            this.forget();
            fault("explain", `The pixel ${x}, ${y} cannot be taken apart: ${words(error)}`, $("pixel-form"));
        }
        $("pixel").removeAttribute("aria-busy");
        if (scrolls)
            ($("pixel").querySelector(".why") ?? $("pixel-form")).scrollIntoView({ block: "nearest", behavior: "smooth" });
    }

    forget() {
        this.explained = null;
        this.page.view.edges = null;
        $("pixel").replaceChildren();
    }

    // The tables stay when the picture changes, and say so.
    noteStale() {
        const isStale = this.explained !== null && this.explained !== this.page.last.state;
        if (isStale)
            this.page.view.edges = null;
        $("pixel").querySelector(".stale")?.remove();
        if (!isStale)
            return;
        const note = document.createElement("p");
        note.className = "help stale";
        note.textContent = "The picture has changed since.";
        $("pixel").prepend(note);
    }

    showCursor() {
        const { page } = this;
        const { cursor, last } = page;
        document.querySelectorAll(".cursor").forEach((mark) => mark.remove());
        if (!cursor || !last)
            return;
        const shares = page.view.shareOf(...cursor);
        if (!shares)
            return;
        for (const frame of document.querySelectorAll(".frame")) {
            const mark = document.createElement("div");
            mark.className = "cursor";
            [mark.style.left, mark.style.top] = shares.map((share) => `${share * 100}%`);
            frame.append(mark);
        }
    }

    toggleCursor() {
        const { page } = this;
        if (!page.last)
            return;
        const { width, height } = page.last;
        this.cursorIsOn = !this.cursorIsOn;
        page.cursor = this.cursorIsOn ? page.cursor ?? [width >> 1, height >> 1] : null;
        this.showCursor();
        say(this.cursorIsOn ? `Pixel cursor at ${page.cursor.join(", ")}` : "Pixel cursor off");
    }

    // Moves the cursor by an arrow, [right, down]; without an arrow, takes its pixel apart.
    moveCursor(arrow, isFast) {
        const { page } = this;
        const { width, height } = page.last;
        if (!arrow) {
            this.explain(...page.cursor);
            return;
        }
        const step = isFast ? 10 : 1;
        page.cursor = [
            Math.min(width - 1, Math.max(0, page.cursor[0] + arrow[0] * step)),
            Math.min(height - 1, Math.max(0, page.cursor[1] - arrow[1] * step)),
        ];
        page.view.reveal(...page.cursor);
        this.showCursor();
        say(`Pixel ${page.cursor.join(", ")}`, 300);
    }
}
