// Tests the readers of OBJ, MTL and TGA without a browser.
import assert from "node:assert/strict";
import { readMtl, readObj, materialOf } from "../../tools/web/obj.js";
import { decodeTga } from "../../tools/web/tga.js";
import { run, test } from "./results.mjs";

const square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

function refuses(text, words) {
    assert.throws(() => readObj("m.obj", text), (error) => {
        assert.equal(error.message, words);
        return true;
    });
}

test("a polygon is a fan", () => {
    const { parts } = readObj("m.obj", square + "f 1 2 3 4\n");
    assert.deepEqual([...parts[0].indices], [0, 1, 2, 0, 2, 3]);
    assert.deepEqual([...parts[0].positions], [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
    assert.deepEqual([...parts[0].normals], Array(12).fill(0));
    assert.equal(parts[0].texcoords, null);
});

test("negative indices count from the face's place", () => {
    const { parts } = readObj("m.obj", "v 9 9 9\n" + square + "f -4 -3 -2\nv 5 5 5\n");
    assert.deepEqual([...parts[0].positions], [0, 0, 0, 1, 0, 0, 1, 1, 0]);
});

test("all forms of corners", () => {
    const head = square + "vt 0.5 0.25\nvt 1\nvn 0 0 1\n";
    assert.deepEqual([...readObj("m.obj", head + "f 1/1 2/2 3/1\n").parts[0].texcoords], [0.5, 0.25, 1, 0, 0.5, 0.25]);
    const normals = readObj("m.obj", head + "f 1//1 2//1 3//1\n").parts[0];
    assert.equal(normals.texcoords, null);
    assert.deepEqual([...normals.normals], [0, 0, 1, 0, 0, 1, 0, 0, 1]);
    const both = readObj("m.obj", head + "f 1/1/1 2/1/1 3/1/1 1/1/1\n").parts[0];
    assert.equal(both.positions.length / 3, 3);
});

test("numbers are the nearest floats, and colours of vertices are not read", () => {
    const { parts } = readObj("m.obj", "v 0.1 1e-3 -.5 1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert.deepEqual([...parts[0].positions.slice(0, 3)], [0.1, 1e-3, -0.5].map(Math.fround));
});

test("the fourth number of a vertex divides", () => {
    const { parts } = readObj("m.obj", "v 2 4 6 2\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert.deepEqual([...parts[0].positions.slice(0, 3)], [1, 2, 3]);
});

test("comments, continued lines and carriage returns", () => {
    const { parts } = readObj("m.obj", "# v 1\r\nv 0 0 0 # here\r\nv 1 0 \\\r\n0\r\nv 0 1 0\r\nf 1 2 3\r\n");
    assert.equal(parts[0].indices.length, 3);
});

test("parts are the triangles of a material", () => {
    const text = square + "mtllib a b.mtl\nusemtl red one\nf 1 2 3\ng x\nusemtl\nf 1 2 4\nusemtl red one\nf 1 3 4\nl 1 2\nl 2 3\n";
    const read = readObj("m.obj", text);
    assert.deepEqual(read.parts.map((part) => [part.material, part.indices.length]), [["red one", 6], ["", 3]]);
    assert.deepEqual(read.libraries, [{ line: 5, name: "a b.mtl" }]);
    assert.deepEqual(read.warnings, ['m.obj:13: "l" is not read (2 lines)']);
});

test("what is wrong is said with file and line", () => {
    refuses(square, "m.obj: there are no triangles in it: no line has a face, f");
    refuses(square + "f 1 2 5\n", "m.obj:5: f names v 5, but there are only 4 before it");
    refuses(square + "f 1 2 -5\n", "m.obj:5: f names v -5, but there are only 4 before it");
    refuses(square + "f 1 2 0\n", 'm.obj:5: "0": "0" is not the number of a v');
    refuses(square + "f 1 2 x\n", 'm.obj:5: "x": "x" is not the number of a v');
    refuses(square + "f 1/1 2/1 3/1\n", "m.obj:5: f names vt 1, but there are only 0 before it");
    refuses(square + "f 1 2\n", "m.obj:5: f takes at least three corners, not 2");
    refuses(square + "vt 0 0\nf 1/1 2 3\n", "m.obj:6: the corners of the face do not have the same form");
    refuses("v 0 zero 0\n", 'm.obj:1: "zero" after v is not a finite number');
    refuses("v 0 1e99 0\n", 'm.obj:1: "1e99" after v is not a finite number');
    refuses("v 0 0\n", "m.obj:1: v takes three numbers, and colours or w after them, not 2");
    refuses("v 0 0 0 0\n", "m.obj:1: the fourth number of v is 0");
    refuses("v 0 0 0\0", "m.obj: it has a NUL byte, so it is not a text");
    refuses(square + "f 1 2 \\\n3 \\\n9\n", "m.obj:5: f names v 9, but there are only 4 before it");
});

test("materials", () => {
    const materials = new Map();
    readMtl("m.mtl", "newmtl red one\nKd 1 0 0\nKs 0.5\nNs 2000\nmap_Kd -s 2 2 -clamp on my map.png\n" +
        "map_Bump -bm 0.5 n.png\nmap_Ks s.png\nmap_Ke g.png\nnewmtl bare\n", materials);
    const red = materialOf({ material: "red one" }, materials);
    assert.deepEqual(red.color, [1, 0, 0]);
    assert.deepEqual(red.specular, [0.5, 0.5, 0.5]);
    assert.equal(red.exponent, 1024);
    assert.deepEqual(red.maps.diffuse, { name: "my map.png", line: 5, from: "m.mtl" });
    assert.equal(red.maps.normal.name, "n.png");
    assert.equal(red.maps.specular.name, "s.png");
    assert.equal(red.maps.glow.name, "g.png");
    assert.deepEqual(materialOf({ material: "bare" }, materials).color, [0.6, 0.6, 0.6]);
    assert.deepEqual(materialOf({ material: "" }, materials).color, [0.8, 0.8, 0.8]);
    assert.throws(() => readMtl("m.mtl", "Kd 1 1 1\n", new Map()), /^Error: m\.mtl:1: Kd stands before the first newmtl$/);
    assert.throws(() => readMtl("m.mtl", "newmtl a\nKd 1 red 1\n", new Map()), /m\.mtl:2: "red" after Kd is not a finite number/);
    assert.throws(() => readMtl("m.mtl", "newmtl a\nmap_Kd\n", new Map()), /m\.mtl:2: map_Kd has no file name/);
});

test("TGA images", () => {
    const head = (type, width, height, bits, flags) =>
        [0, 0, type, 0, 0, 0, 0, 0, 0, 0, 0, 0, width, 0, height, 0, bits, flags];
    const plain = decodeTga("t.tga", new Uint8Array([...head(2, 1, 2, 24, 0), 1, 2, 3, 4, 5, 6]));
    assert.deepEqual([...plain.texels], [6, 5, 4, 255, 3, 2, 1, 255]);
    const runs = decodeTga("t.tga", new Uint8Array([...head(10, 3, 1, 32, 0x20), 129, 1, 2, 3, 4, 0, 5, 6, 7, 8]));
    assert.deepEqual([...runs.texels], [3, 2, 1, 4, 3, 2, 1, 4, 7, 6, 5, 8]);
    const grey = decodeTga("t.tga", new Uint8Array([...head(3, 2, 1, 8, 0x10), 9, 10]));
    assert.deepEqual([...grey.texels], [10, 10, 10, 255, 9, 9, 9, 255]);
    assert.throws(() => decodeTga("t.tga", new Uint8Array(head(2, 2, 2, 24, 0))), /t\.tga: it is cut short/);
    assert.throws(() => decodeTga("t.tga", new Uint8Array(head(1, 2, 2, 8, 0))), /type 1 is not read/);
});

await run();
