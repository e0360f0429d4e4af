// A module of the page in Node, with JavaScript's types: strings for texts, errors for faults.
import { readFile } from 'node:fs/promises';

export class Page {
    static async load(path) {
        const page = new Page();
        page.module = await WebAssembly.compile(await readFile(path));
        page.exports = (await WebAssembly.instantiate(page.module, {})).exports;
        return page;
    }

    // The memory may grow in any call, so that every view is a new one.
    bytes(at, count) {
        return new Uint8Array(this.exports.memory.buffer, at, count);
    }

    text(at) {
        const memory = new Uint8Array(this.exports.memory.buffer);
        return new TextDecoder().decode(memory.slice(at, memory.indexOf(0, at)));
    }

    // Calls a function with arguments of which some are texts.
    withTexts(name, ...texts) {
        const places = [];
        const values = texts.map((text) => {
            if (typeof text === 'number')
                return text;
            const encoded = new TextEncoder().encode(`${text}\0`);
            const at = this.exports.page_allocate(encoded.length);
            this.bytes(at, encoded.length).set(encoded);
            places.push(at);
            return at;
        });
        const result = this.exports[name](...values);
        places.forEach((at) => this.exports.page_free(at));
        return result;
    }

    get message() {
        return this.text(this.exports.page_message());
    }

    get state() {
        return this.text(this.exports.page_state());
    }

    must(fault) {
        if (fault !== 0)
            throw new Error(this.message || 'a fault without a message');
    }

    set(key, value) {
        this.must(this.withTexts('page_set', key, value));
    }

    setState(state) {
        this.must(this.withTexts('page_set_state', state));
    }

    build() {
        this.must(this.exports.page_build());
    }

    draw(from = 0, end = this.exports.page_height()) {
        this.must(this.exports.page_draw(from, end));
    }

    // The picture's rows, as a copy.
    picture(from = 0, end = this.exports.page_height()) {
        const row = 4 * this.exports.page_width();
        return this.bytes(this.exports.page_color() + from * row, (end - from) * row).slice();
    }

    // The hash of a picture of the state's size.
    hash(picture) {
        const at = this.exports.page_allocate(picture.length);
        this.bytes(at, picture.length).set(picture);
        const hash = this.text(
            this.exports.page_hash(at, this.exports.page_width(), this.exports.page_height()),
        );
        this.exports.page_free(at);
        return hash;
    }

    describe() {
        return JSON.parse(this.text(this.exports.page_describe()));
    }
}

// The contract's pictures: states and hashes.
export async function readPictures(path) {
    const lines = (await readFile(path, 'utf8')).split('\n');
    return lines
        .filter((line) => /^[0-9a-f]{16}( |$)/.test(line))
        .map((line) => ({ hash: line.slice(0, 16), state: line.slice(17) }));
}
