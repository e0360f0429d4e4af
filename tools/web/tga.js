// Decodes TGA images, which browsers do not, as tools/gnomon/image_tga.c does: true colour, grey and
// colour maps, plain and run-length encoded (Truevision TGA File Format Specification, version 2.0).
import { GnomonError } from "./engine.js";

const HEADER_SIZE = 18;
const FOOTER_SIZE = 26;
const EXTENSION_SIZE = 495;
const ATTRIBUTES_TYPE = 494;
const MARK = "TRUEVISION-XFILE.\0";

// Field 24, the attributes type: what alpha means. Smaller values say that it means nothing.
const ALPHA_IS_USEFUL = 3;
const ALPHA_IS_PREMULTIPLIED = 4;

const COLOR_BITS = [15, 16, 24, 32];

// A packet of run lengths has at most this many pixels, behind one byte.
const PACKET_PIXELS = 128;

// Returns field 24; ALPHA_IS_USEFUL if the file has no extension area.
function attributesType(bytes, view) {
    const footer = bytes.length - FOOTER_SIZE;
    if (footer < HEADER_SIZE || String.fromCharCode(...bytes.subarray(footer + 8)) !== MARK)
        return ALPHA_IS_USEFUL;
    const at = view.getUint32(footer, true);
    if (at < HEADER_SIZE || at + EXTENSION_SIZE > bytes.length || view.getUint16(at, true) < EXTENSION_SIZE)
        return ALPHA_IS_USEFUL;
    return bytes[at + ATTRIBUTES_TYPE];
}

function readHeader(bytes, fail) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    const type = bytes[2];
    const kind = type & ~8;
    const isMapped = kind === 1;
    const isGrey = kind === 3;
    const width = view.getUint16(12, true);
    const height = view.getUint16(14, true);
    const bits = bytes[16];
    const descriptor = bytes[17];
    const mapBits = bytes[7];
    const colorBits = isMapped ? mapBits : bits;
    if (bytes[1] > 1 || kind < 1 || kind > 3 || (isMapped && bytes[1] !== 1))
        fail(`a TGA image of type ${type} is not read (true colour, grey and colour maps are)`);
    if (width === 0 || height === 0)
        fail(`a TGA image of ${width}x${height} texels is not read`);
    if (kind === 2 ? !COLOR_BITS.includes(bits) : bits !== 8 && bits !== 16)
        fail(`a TGA image of type ${type} with ${bits} bits a pixel is not read`);
    if (isMapped && !COLOR_BITS.includes(mapBits))
        fail(`a TGA image with ${mapBits} bits an entry of the colour map is not read`);
    if ((descriptor & 0xc0) !== 0)
        fail("a TGA image with interleaved rows is not read");

    const attributes = attributesType(bytes, view);
    const hasAlpha =
        (descriptor & 15) !== 0 && attributes >= ALPHA_IS_USEFUL && (colorBits === 16 || colorBits === 32);
    const mapLength = bytes[1] === 1 ? view.getUint16(5, true) : 0;
    const mapAt = HEADER_SIZE + bytes[0];
    const pixelSize = Math.ceil(bits / 8);
    const pixelsAt = mapAt + mapLength * Math.ceil(mapBits / 8);
    const isCompressed = type > 8;
    const least = isCompressed ? Math.ceil(width * height / PACKET_PIXELS) * (1 + pixelSize) : width * height * pixelSize;
    if (bytes.length < pixelsAt + least)
        fail("it is cut short");
    return {
        width, height, isMapped, isGrey, isCompressed, colorBits, hasAlpha, mapLength, mapAt, pixelSize, pixelsAt,
        mapFirst: view.getUint16(3, true),
        isTopDown: (descriptor & 0x20) !== 0,
        isRightToLeft: (descriptor & 0x10) !== 0,
        isPremultiplied: hasAlpha && attributes === ALPHA_IS_PREMULTIPLIED,
    };
}

// Returns red, green, blue and alpha of a pixel or an entry. 16 bits are, from the highest: one of
// alpha, five of red, of green and of blue.
function colorAt(h, bytes, at) {
    if (h.isGrey)
        return [bytes[at], bytes[at], bytes[at], h.hasAlpha ? bytes[at + 1] : 255];
    if (h.colorBits > 16)
        return [bytes[at + 2], bytes[at + 1], bytes[at], h.hasAlpha ? bytes[at + 3] : 255];
    const word = bytes[at] | bytes[at + 1] << 8;
    const fromFiveBits = (value) => Math.round((value & 31) * 255 / 31);
    const alpha = h.hasAlpha && word >> 15 === 0 ? 0 : 255;
    return [fromFiveBits(word >> 10), fromFiveBits(word >> 5), fromFiveBits(word), alpha];
}

// Returns { width, height, texels }, the top row first, with colours that are not multiplied by alpha.
export function decodeTga(name, bytes) {
    const fail = (reason) => {
        throw new GnomonError(`${name}: ${reason}`);
    };
    if (bytes.length < HEADER_SIZE)
        fail("it is shorter than the header of a TGA image");
    const h = readHeader(bytes, fail);
    const { width, height, pixelSize } = h;
    const texels = new Uint8Array(width * height * 4);
    const put = (pixel, from) => {
        const x = pixel % width;
        const y = Math.floor(pixel / width);
        let at = from;
        if (h.isMapped) {
            const index = pixelSize === 2 ? bytes[from] | bytes[from + 1] << 8 : bytes[from];
            if (index < h.mapFirst || index >= h.mapFirst + h.mapLength)
                fail(`a pixel names entry ${index} of a colour map with ${h.mapLength} entries from ${h.mapFirst} on`);
            at = h.mapAt + (index - h.mapFirst) * Math.ceil(h.colorBits / 8);
        }
        const color = colorAt(h, bytes, at);
        for (let c = 0; c < 3 && h.isPremultiplied; ++c)
            color[c] = color[3] > 0 ? Math.min(255, Math.round(color[c] * 255 / color[3])) : 0;
        texels.set(color, 4 * ((h.isTopDown ? y : height - 1 - y) * width + (h.isRightToLeft ? width - 1 - x : x)));
    };
    let at = h.pixelsAt;
    const need = (count) => {
        if (at + count > bytes.length)
            fail("it is cut short");
    };
    for (let pixel = 0; pixel < width * height;) {
        let count = 1;
        let isRun = false;
        if (h.isCompressed) {
            need(1);
            count = Math.min((bytes[at] & 127) + 1, width * height - pixel);
            isRun = bytes[at] > 127;
            ++at;
        }
        need(isRun ? pixelSize : pixelSize * count);
        for (let i = 0; i < count; ++i)
            put(pixel + i, isRun ? at : at + pixelSize * i);
        at += isRun ? pixelSize : pixelSize * count;
        pixel += count;
    }
    return { width, height, texels };
}
