// A worker with an instance of the module of its own. It draws bands of rows: into memory that it
// shares with the page if there is some, otherwise into a copy that is handed over.
import { Engine } from "./engine.js";

let engine = null;

async function begin(message) {
    engine = await Engine.create(message.module);
}

function draw(message) {
    const { state, from, end, shared } = message;
    engine.setState(state);
    engine.build();

    const started = performance.now();
    const pixels = engine.draw(from, end);
    const milliseconds = performance.now() - started;
    const row = engine.width() * 4;
    const band = pixels.subarray(from * row, end * row);

    if (shared) {
        new Uint8Array(shared).set(band, from * row);
        return { milliseconds };
    }
    return { milliseconds, band: band.slice() };
}

self.onmessage = async ({ data }) => {
    const answer = { id: data.id };
    try {
        if (data.type === "begin")
            await begin(data);
        else if (data.type === "model")
            engine.loadModel(data.model);
        else
            Object.assign(answer, draw(data));
    } catch (error) {
        answer.error = error.message || String(error);
    }
    self.postMessage(answer, answer.band ? [answer.band.buffer] : []);
};
