// Gnomon as a WebAssembly module: loading it, and the functions of page.h with texts and arrays of
// JavaScript. The page, its workers and the tests use the same class.

export class GnomonError extends Error {}

// A module whose only function uses a vector of 128 bits. It is valid where SIMD is.
const simdProbe = new Uint8Array([
    0x00, 0x61, 0x73, 0x6d, 0x01, 0x00, 0x00, 0x00, // magic number, version
    0x01, 0x04, 0x01, 0x60, 0x00, 0x00, // one type: no arguments, no result
    0x03, 0x02, 0x01, 0x00, // one function of that type
    0x0a, 0x17, 0x01, 0x15, 0x00, // its code, without local variables
    0xfd, 0x0c, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, // v128.const 0
    0x1a, 0x0b, // drop, end
]);

export function hasSimd() {
    return WebAssembly.validate(simdProbe);
}

export async function compileModule(url) {
    const response = await fetch(url);
    if (!response.ok)
        throw new GnomonError(`${url} cannot be loaded: ${response.status} ${response.statusText}`);
    // Not compileStreaming: it refuses files of servers that do not know the type of .wasm.
    return WebAssembly.compile(await response.arrayBuffer());
}

const encoder = new TextEncoder();
const decoder = new TextDecoder();

export class Engine {
    static async create(module) {
        return new Engine(await WebAssembly.instantiate(module, {}));
    }

    constructor(instance) {
        this.c = instance.exports;
        this.memory = instance.exports.memory;
        if (this.c._initialize)
            this.c._initialize();
    }

    // Memory may have grown, so views are made anew for each use.
    bytes(address, length) {
        return new Uint8Array(this.memory.buffer, address >>> 0, length);
    }

    text(address) {
        const all = new Uint8Array(this.memory.buffer);
        const from = address >>> 0;
        return from === 0 ? "" : decoder.decode(all.subarray(from, all.indexOf(0, from)));
    }

    message() {
        return this.text(this.c.page_message()) || "the reason is not known";
    }

    allocate(size) {
        const address = this.c.page_allocate(size) >>> 0;
        if (address === 0)
            throw new GnomonError(`not enough memory for ${size} bytes`);
        return address;
    }

    // Calls a function with texts in the module's memory.
    withTexts(texts, call) {
        const addresses = texts.map((text) => {
            const encoded = encoder.encode(text + "\0");
            const address = this.allocate(encoded.length);
            this.bytes(address, encoded.length).set(encoded);
            return address;
        });
        try {
            return call(...addresses);
        } finally {
            addresses.forEach((address) => this.c.page_free(address));
        }
    }

    check(result) {
        if (result !== 0)
            throw new GnomonError(this.message());
    }

    set(key, value) {
        this.check(this.withTexts([key, value], (k, v) => this.c.page_set(k, v)));
    }

    setState(state) {
        this.check(this.withTexts([state], (s) => this.c.page_set_state(s)));
    }

    state() {
        return this.text(this.c.page_state());
    }

    turn(right, down) {
        this.check(this.c.page_turn(right, down));
    }

    pan(right, down) {
        this.check(this.c.page_pan(right, down));
    }

    zoom(steps) {
        this.check(this.c.page_zoom(steps));
    }

    build() {
        this.check(this.c.page_build());
    }

    // Draws rows from the bottom. The result is a view of the module's memory: all rows, of which
    // only these are specified.
    draw(from, end) {
        this.check(this.c.page_draw(from, end));
        return this.bytes(this.c.page_color(), this.width() * this.height() * 4);
    }

    width() {
        return this.c.page_width();
    }

    height() {
        return this.c.page_height();
    }

    hash(pixels, width, height) {
        const address = this.allocate(pixels.length);
        this.bytes(address, pixels.length).set(pixels);
        try {
            return this.text(this.c.page_hash(address, width, height));
        } finally {
            this.c.page_free(address);
        }
    }

    describe() {
        const text = this.text(this.c.page_describe());
        if (text === "")
            throw new GnomonError(this.message());
        return JSON.parse(text);
    }

    backend() {
        return this.text(this.c.page_backend());
    }

    version() {
        return this.text(this.c.page_version());
    }

    // A pixel taken apart, as an object; only the module for it has the function.
    explain(x, y) {
        const text = this.text(this.c.page_explain(x, y));
        if (text === "")
            throw new GnomonError(this.message());
        return JSON.parse(text);
    }

    // Reads a model from files, { name, bytes }. Returns what page_model_describe says of it.
    readModel(files) {
        this.c.page_model_begin();
        for (const { name, bytes } of files) {
            const address = this.withTexts([name], (text) => this.c.page_model_file(text, bytes.length));
            if (address === 0)
                throw new GnomonError(`${name}: ${this.message()}`);
            this.bytes(address, bytes.length).set(bytes);
        }
        this.check(this.c.page_model_read());
        return this.describeModel();
    }

    describeModel() {
        const text = this.text(this.c.page_model_describe());
        if (text === "")
            throw new GnomonError(this.message());
        return JSON.parse(text);
    }

    // Sets the images of the model that was read: { number, name, width, height, texels }.
    completeModel(images) {
        for (const { number, name, width, height, texels } of images) {
            const address = this.c.page_model_image(number, width, height);
            if (address === 0)
                throw new GnomonError(`${name}: ${this.message()}`);
            this.bytes(address, texels.length).set(texels);
        }
        this.check(this.c.page_model_end());
    }

    // Makes a model (model.js) the one that is called "dropped".
    loadModel({ files, images }) {
        this.readModel(files);
        this.completeModel(images);
    }
}
