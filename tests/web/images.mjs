// Tests the readers of TGA and Exif data without a browser.
import assert from "node:assert/strict";
import { withoutOrientation } from "../../tools/web/exif.js";
import { decodeTga } from "../../tools/web/tga.js";
import { run, test } from "./results.mjs";

test("TGA images", () => {
    const head = (type, width, height, bits, flags) =>
        [0, 0, type, 0, 0, 0, 0, 0, 0, 0, 0, 0, width, 0, height, 0, bits, flags];
    const plain = decodeTga("t.tga", new Uint8Array([...head(2, 1, 2, 24, 0), 1, 2, 3, 4, 5, 6]));
    assert.deepEqual([...plain.texels], [6, 5, 4, 255, 3, 2, 1, 255]);
    const runs = decodeTga("t.tga", new Uint8Array([...head(10, 3, 1, 32, 0x28), 129, 1, 2, 3, 4, 0, 5, 6, 7, 8]));
    assert.deepEqual([...runs.texels], [3, 2, 1, 4, 3, 2, 1, 4, 7, 6, 5, 8]);
    const grey = decodeTga("t.tga", new Uint8Array([...head(3, 2, 1, 8, 0x10), 9, 10]));
    assert.deepEqual([...grey.texels], [10, 10, 10, 255, 9, 9, 9, 255]);
    assert.throws(() => decodeTga("t.tga", new Uint8Array(head(2, 2, 2, 24, 0))), /t\.tga: it is cut short/);
    assert.throws(() => decodeTga("t.tga", new Uint8Array(head(1, 2, 2, 8, 0))), /type 1 is not read/);
    assert.throws(() => decodeTga("t.tga", new Uint8Array(head(2, 2, 2, 8, 0))), /type 2 with 8 bits a pixel/);
    assert.throws(() => decodeTga("t.tga", new Uint8Array(head(2, 2, 2, 24, 0x40))), /interleaved/);
});

// The values are those of tests/command/test_images.c, derived from the specification there.
function tga({ type, width, height = 1, bits, flags = 0, id = 0, first = 0, length = 0, entryBits = 0 }, ...rest) {
    const two = (n) => [n & 255, n >> 8];
    const head = [id, length > 0 ? 1 : 0, type, ...two(first), ...two(length), entryBits, 11, 0, 12, 0,
        ...two(width), ...two(height), bits, flags];
    return new Uint8Array([...head, ...Array(id).fill(0xee), ...rest]);
}

// With the extension area that has this attributes type.
function withExtension(file, attributesType) {
    const area = [495 & 255, 495 >> 8, ...Array(492).fill(0), attributesType];
    const footer = [file.length & 255, file.length >> 8, 0, 0, 0, 0, 0, 0, ...Buffer.from("TRUEVISION-XFILE.\0")];
    return new Uint8Array([...file, ...area, ...footer]);
}

function texelsOf(file) {
    const { width, height, texels } = decodeTga("t.tga", file);
    return Array.from({ length: width * height }, (_, i) => Buffer.from(texels.subarray(4 * i, 4 * i + 4)).toString("hex"))
        .join(" ");
}

test("TGA images begin in any corner", () => {
    const levels = (flags) => {
        const { texels } = decodeTga("t.tga", tga({ type: 3, width: 3, height: 2, bits: 8, flags }, 1, 2, 3, 4, 5, 6));
        return [0, 1, 2, 3, 4, 5].map((i) => texels[4 * i]);
    };
    assert.deepEqual(levels(0x20), [1, 2, 3, 4, 5, 6]);
    assert.deepEqual(levels(0x30), [3, 2, 1, 6, 5, 4]);
    assert.deepEqual(levels(0x00), [4, 5, 6, 1, 2, 3]);
    assert.deepEqual(levels(0x10), [6, 5, 4, 3, 2, 1]);
});

test("TGA images of all depths", () => {
    assert.equal(texelsOf(tga({ type: 2, width: 2, bits: 32 }, 1, 2, 3, 0, 4, 5, 6, 7)), "030201ff 060504ff");
    assert.equal(texelsOf(tga({ type: 2, width: 2, bits: 32, flags: 8 }, 1, 2, 3, 0, 4, 5, 6, 7)), "03020100 06050407");
    assert.equal(texelsOf(tga({ type: 2, width: 2, bits: 16 }, 0x03, 0x04, 0x10, 0xfc)), "080019ff ff0084ff");
    assert.equal(texelsOf(tga({ type: 2, width: 2, bits: 16, flags: 1 }, 0x03, 0x04, 0x10, 0xfc)), "08001900 ff0084ff");
    assert.equal(texelsOf(tga({ type: 2, width: 2, bits: 15, flags: 1 }, 0x20, 0, 0xe0, 0x83)), "000800ff 00ff00ff");
    assert.equal(texelsOf(tga({ type: 3, width: 2, bits: 16, flags: 8 }, 9, 0, 10, 200)), "09090900 0a0a0ac8");
});

test("TGA images with colour maps", () => {
    const map = { type: 1, width: 3, bits: 8, first: 5, length: 2, entryBits: 24 };
    assert.equal(texelsOf(tga(map, 1, 2, 3, 4, 5, 6, 6, 5, 6)), "060504ff 030201ff 060504ff");
    assert.equal(texelsOf(tga({ ...map, type: 9 }, 1, 2, 3, 4, 5, 6, 0x81, 6, 0, 5)), "060504ff 060504ff 030201ff");
    const wide = { ...map, entryBits: 32, flags: 8 };
    assert.equal(texelsOf(tga(wide, 1, 2, 3, 0, 4, 5, 6, 7, 5, 6, 6)), "03020100 06050407 06050407");
    const narrow = { ...map, entryBits: 16, flags: 1 };
    assert.equal(texelsOf(tga(narrow, 0x1f, 0x80, 0x00, 0x7c, 5, 6, 5)), "0000ffff ff000000 0000ffff");
    const long = { ...map, width: 2, bits: 16, first: 300, id: 3 };
    assert.equal(texelsOf(tga(long, 1, 2, 3, 4, 5, 6, 0x2d, 1, 0x2c, 1)), "060504ff 030201ff");
    assert.equal(texelsOf(tga({ ...map, type: 2, width: 1, bits: 24 }, 1, 2, 3, 4, 5, 6, 7, 8, 9)), "090807ff");
    assert.throws(() => texelsOf(tga(map, 1, 2, 3, 4, 5, 6, 5, 6, 7)), /entry 7 of a colour map with 2 entries from 5/);
    assert.throws(() => texelsOf(tga(map, 1, 2, 3, 4, 5, 6, 4, 6, 6)), /entry 4/);
});

test("TGA images say what alpha means", () => {
    const file = tga({ type: 2, width: 3, bits: 32, flags: 8 }, 1, 2, 3, 0, 100, 50, 200, 200, 255, 0, 40, 100);
    for (const type of [0, 1, 2])
        assert.equal(texelsOf(withExtension(file, type)), "030201ff c83264ff 2800ffff");
    assert.equal(texelsOf(withExtension(file, 3)), "03020100 c83264c8 2800ff64");
    assert.equal(texelsOf(withExtension(file, 4)), "00000000 ff4080c8 6600ff64");
});

test("the orientation of a JPEG or PNG is found and removed", () => {
    const tiff = (little, orientation) => {
        const two = (n) => little ? [n & 255, n >> 8] : [n >> 8, n & 255];
        const four = (n) => little ? [...two(n), 0, 0] : [0, 0, ...two(n)];
        return [...Buffer.from(little ? "II*\0" : "MM\0*"), ...four(8), ...two(2),
            ...two(0x0100), ...two(3), ...four(1), ...two(9), 0, 0,
            ...two(0x0112), ...two(3), ...four(1), ...two(orientation), 0, 0];
    };
    const jpeg = (data) => [0xff, 0xd8, 0xff, 0xe0, 0, 4, 1, 2, 0xff,
        ...data ? [0xff, 0xe1, 0, data.length + 8, ...Buffer.from("Exif\0\0"), ...data] : [], 0xff, 0xda];
    const png = (data) => [...Buffer.from("\x89PNG\r\n\x1a\n", "latin1"), 0, 0, 0, 1, 1, 2, 3, 4, 5, 6, 7, 8, 9,
        ...data ? [0, 0, 0, data.length, ...Buffer.from("eXIf"), ...data, 1, 2, 3, 4] : [], 0, 0, 0, 0, 1, 2, 3, 4, 1, 2, 3, 4];
    for (const file of [jpeg, png]) {
        for (const little of [true, false]) {
            for (let o = 0; o <= 9; ++o) {
                const bytes = new Uint8Array(file(tiff(little, o)));
                const result = withoutOrientation(bytes);
                const isKnown = o >= 2 && o <= 8;
                assert.equal(result.orientation, isKnown ? o : 1);
                assert.deepEqual([...result.bytes], isKnown ? file(null) : [...bytes]);
            }
            const full = new Uint8Array(file(tiff(little, 6)));
            const tail = file === jpeg ? 2 : 12;
            for (let size = 0; size < full.length - tail; ++size)
                assert.equal(withoutOrientation(full.slice(0, size)).orientation, 1);
        }
        assert.equal(withoutOrientation(new Uint8Array(file(null))).orientation, 1);
    }
    assert.equal(withoutOrientation(new Uint8Array(Buffer.from("GIF89a"))).orientation, 1);
});

await run();
