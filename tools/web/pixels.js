// The pixel cursor, and the pixel that is taken apart below the pictures.
import { compileModule, Engine } from "./engine.js";
import { copy, fault, say, words } from "./messages.js";

const $ = (id) => document.getElementById(id);

export class Pixels {
    // Reads page.engine, page.model and page.last; sets page.cursor and page.own.pixel. module is the address
    // of the module that explains; drawn() returns a promise that resolves when no picture is being drawn;
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

    async explain(x, y) {
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
            const [engine, { showExplained }] = await Promise.all([this.explainEngine(), import("./explain.js")]);
            engine.setState(state);
            engine.build();
            const explained = engine.explain(x, y);
            await this.drawn();
            showExplained($("pixel"), explained, page.last, (text) => copy(text, "The text"));
            this.explained = state;
            fault("explain", "");
            const count = explained.fragments.length;
            say(`Pixel ${x}, ${y} is taken apart below: ${count} ${count === 1 ? "fragment" : "fragments"}.`);
        } catch (error) {
            this.explained = null;
            $("pixel").replaceChildren();
            fault("explain", `The pixel ${x}, ${y} cannot be taken apart: ${words(error)}`);
        }
        $("pixel").removeAttribute("aria-busy");
    }

    // The tables stay when the picture changes, and say so.
    noteStale() {
        const isStale = this.explained !== null && this.explained !== this.page.last.state;
        $("pixel").querySelector(".stale")?.remove();
        if (!isStale)
            return;
        const note = document.createElement("p");
        note.className = "help stale";
        note.textContent = "The picture has changed since.";
        $("pixel").prepend(note);
    }

    showCursor() {
        const { cursor, last } = this.page;
        document.querySelectorAll(".cursor").forEach((mark) => mark.remove());
        if (!cursor || !last)
            return;
        const { width, height } = last;
        const [x, y] = cursor;
        for (const frame of document.querySelectorAll(".frame")) {
            const mark = document.createElement("div");
            mark.className = "cursor";
            mark.style.left = `${((x + 0.5) / width) * 100}%`;
            mark.style.top = `${((height - y - 0.5) / height) * 100}%`;
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
        this.showCursor();
        say(`Pixel ${page.cursor.join(", ")}`, 300);
    }
}
