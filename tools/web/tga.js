// Decodes TGA images, which browsers do not: true colour and grey, plain and run-length encoded.
import { ModelError } from "./obj.js";

// Returns { width, height, texels }, the top row first.
export function decodeTga(name, bytes) {
    const fail = (reason) => {
        throw new ModelError(`${name}: ${reason}`);
    };
    if (bytes.length < 18)
        fail("it is shorter than the header of a TGA image");
    const type = bytes[2];
    const width = bytes[12] | bytes[13] << 8;
    const height = bytes[14] | bytes[15] << 8;
    const size = bytes[16] / 8;
    const isGrey = type === 3 || type === 11;
    if (bytes[1] !== 0 || ![2, 3, 10, 11].includes(type))
        fail(`a TGA image of type ${type} is not read (true colour and grey are)`);
    if (width === 0 || height === 0 || !(isGrey ? size === 1 : size === 3 || size === 4))
        fail(`a TGA image of ${width}x${height} texels and ${bytes[16]} bits is not read`);

    const texels = new Uint8Array(width * height * 4);
    const isTopDown = (bytes[17] & 0x20) !== 0;
    const isRightLeft = (bytes[17] & 0x10) !== 0;
    let at = 18 + bytes[0];
    let next = 0;
    const put = (from) => {
        const x = next % width;
        const y = Math.floor(next / width);
        const to = 4 * ((isTopDown ? y : height - 1 - y) * width + (isRightLeft ? width - 1 - x : x));
        texels[to] = bytes[isGrey ? from : from + 2];
        texels[to + 1] = bytes[isGrey ? from : from + 1];
        texels[to + 2] = bytes[from];
        texels[to + 3] = size === 4 ? bytes[from + 3] : 255;
        ++next;
    };
    const need = (count) => {
        if (at + count > bytes.length)
            fail("it is cut short");
    };
    while (next < width * height) {
        if (type < 10) {
            need(size);
            put(at);
            at += size;
            continue;
        }
        need(1);
        const head = bytes[at++];
        const count = Math.min((head & 127) + 1, width * height - next);
        const isRun = head > 127;
        need(isRun ? size : size * count);
        for (let i = 0; i < count; ++i)
            put(isRun ? at : at + size * i);
        at += isRun ? size : size * count;
    }
    return { width, height, texels };
}
