// Tests dropped models of all formats through the page's modules, in Node: what the page's JavaScript hands
// to a module, and what the module draws of it.
// usage: models.mjs BUILD [NAME ...]
import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { join } from "node:path";
import { Engine } from "../../tools/web/engine.js";
import { readModel } from "../../tools/web/model.js";
import { run, test } from "./results.mjs";

const [build] = process.argv.splice(2, 1);
const modules = await Promise.all(["gnomon.wasm", "gnomon-simd.wasm"].map(async (name) =>
    WebAssembly.compile(await readFile(join(build, "web", name)))
));

const square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

const filesOf = (contents) => contents.map(([name, bytes]) => new File([bytes], name));

async function read(...contents) {
    const engine = await Engine.create(modules[0]);
    return { engine, model: await readModel(engine, filesOf(contents)) };
}

// The draws of a dropped model, with their arrays in place of addresses.
async function drawsOf(...contents) {
    const { engine, model } = await read(...contents);
    engine.setState("model=dropped&size=32x32");
    engine.build();
    const draws = engine.describe().draws.map((draw) => {
        const floats = ([name, { at, components }]) =>
            [name, [...new Float32Array(engine.memory.buffer, at, draw.vertices * components)]];
        return {
            ...draw,
            ...Object.fromEntries(Object.entries(draw.attributes).map(floats)),
            elements: [...new Uint32Array(engine.memory.buffer, draw.indices.at, draw.indices.count)],
        };
    });
    engine.draw(0, 32);
    return Object.assign(draws, { about: model.about, engine });
}

async function refuses(contents, words) {
    await assert.rejects(read(...contents), (error) => {
        assert.equal(error.message, words);
        return true;
    });
}

// ---- Formats ----

// A part's triangles as corners of three coordinates.
const corners = ({ position, elements }) => elements.map((i) => position.slice(3 * i, 3 * i + 3));

test("an OBJ: polygons, corners, colours of its material, points and lines", async () => {
    const draws = await drawsOf(
        ["m.obj", "mtllib m.mtl\n" + square + "vn 0 0 1\nusemtl red\nf 1//1 2//1 3//1 4//1\nl 1 3\np 2\n"],
        ["m.mtl", "newmtl red\nKd 1 0 0.25\nKs 0.5 0.25 1\nNs 12\n"]
    );
    assert.deepEqual(draws.about.warnings, []);
    const of = (topology) => draws.find((draw) => draw.topology === topology);
    assert.equal(draws.length, 3);
    // Two triangles with the area and the sense of rotation of the square.
    const triangles = corners(of("triangles"));
    let area = 0;
    for (let i = 0; i < triangles.length; i += 3) {
        const [a, b, c] = triangles.slice(i, i + 3);
        area += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    }
    assert.equal(triangles.length, 6);
    assert.equal(area, 1);
    assert.deepEqual(of("triangles").color.slice(0, 4), [1, 0, 0.25, 1]);
    assert.deepEqual(of("triangles").normal.slice(0, 3), [0, 0, 1]);
    assert.deepEqual(of("triangles").specular, [0.5, 0.25, 1]);
    assert.equal(of("triangles").exponent, 12);
    assert.deepEqual(corners(of("lines")), [[0, 0, 0], [1, 1, 0]]);
    assert.deepEqual(corners(of("points")), [[1, 0, 0]]);
    assert.equal(of("points").shader, "unlit", "what has no normals is not lit");
});

test("a PLY with colours of vertices", async () => {
    const [draw] = await drawsOf(["m.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" +
        "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n" +
        "property list uchar int vertex_indices\nend_header\n" +
        "0 0 0.1 255 0 0\n1 0 0.1 0 255 0\n0 1 0.1 0 0 51\n3 0 1 2\n"]);
    assert.deepEqual(draw.position, [0, 0, 0.1, 1, 0, 0.1, 0, 1, 0.1].map(Math.fround));
    assert.deepEqual(draw.color, [1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 0.2, 1].map(Math.fround));
    assert.deepEqual(draw.elements, [0, 1, 2]);
});

test("a binary STL", async () => {
    const bytes = new Uint8Array(84 + 50);
    const view = new DataView(bytes.buffer);
    view.setUint32(80, 1, true);
    [0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 2, 0].forEach((n, i) => view.setFloat32(84 + 4 * i, n, true));
    const [draw] = await drawsOf(["m.STL", bytes]);
    assert.deepEqual(corners(draw), [[0, 0, 0], [2, 0, 0], [0, 2, 0]]);
    assert.deepEqual(draw.normal, [0, 0, 1, 0, 0, 1, 0, 0, 1]);
});

// A triangle with texture coordinates; the buffer is `uri`, or the binary chunk of a GLB.
const numbers = new Uint8Array(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1]).buffer);
const gltf = (uri, more = {}) => ({
    asset: { version: "2.0" },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, TEXCOORD_0: 1 }, material: 0 }] }],
    materials: [{}],
    accessors: [
        { bufferView: 0, componentType: 5126, count: 3, type: "VEC3", min: [0, 0, 0], max: [1, 1, 0] },
        { bufferView: 1, componentType: 5126, count: 3, type: "VEC2" },
    ],
    bufferViews: [{ buffer: 0, byteLength: 36 }, { buffer: 0, byteOffset: 36, byteLength: 24 }],
    buffers: [{ byteLength: 60, ...(uri && { uri }) }],
    ...more,
});

function glb(json, binary) {
    const pad = (bytes, by) => Buffer.concat([bytes, Buffer.alloc(-bytes.length & 3, by)]);
    const chunk = (type, bytes) => {
        const head = Buffer.alloc(8);
        head.writeUInt32LE(bytes.length);
        head.write(type, 4, "latin1");
        return Buffer.concat([head, bytes]);
    };
    const chunks = [chunk("JSON", pad(Buffer.from(JSON.stringify(json)), 0x20)), chunk("BIN\0", pad(Buffer.from(binary), 0))];
    const head = Buffer.from("glTF\x02\0\0\0\0\0\0\0", "latin1");
    head.writeUInt32LE(12 + chunks[0].length + chunks[1].length, 8);
    return Buffer.concat([head, ...chunks]);
}

test("a glTF with a buffer beside it, and a GLB", async () => {
    for (const files of [
        [["t.gltf", JSON.stringify(gltf("my%20data.bin"))], ["My Data.bin", numbers]],
        [["t.glb", glb(gltf(), numbers)]],
    ]) {
        const draws = await drawsOf(...files);
        assert.deepEqual(draws.about.warnings, []);
        assert.deepEqual(corners(draws[0]), [[0, 0, 0], [1, 0, 0], [0, 1, 0]]);
        // glTF's texture coordinates grow downward.
        assert.deepEqual(draws[0].texcoord, [0, 1, 1, 1, 0, 0]);
        assert.equal(draws[0].cull, "back", "materials have one side");
    }
});

test("glTF's samplers, cut-off and blending", async () => {
    const material = (more) => [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } }, doubleSided: true, ...more }];
    const files = (more) => [
        ["t.gltf", JSON.stringify(gltf("t.bin", {
            materials: material(more),
            textures: [{ source: 0, sampler: 0 }],
            samplers: [{ wrapS: 33071, wrapT: 33648, minFilter: 9985, magFilter: 9728 }],
            images: [{ uri: "t.tga" }],
        }))],
        ["t.bin", numbers],
        ["t.tga", tga([10, 20, 30, 40])],
    ];
    const [mask] = await drawsOf(...files({ alphaMode: "MASK", alphaCutoff: 0.25 }));
    assert.deepEqual(mask.sampler, { wrapS: "clamp-to-edge", wrapT: "mirrored-repeat", minify: "linear-mipmap-nearest", magnify: "nearest" });
    assert.deepEqual([mask.blend, mask.depthWrite, mask.alphaCutoff, mask.cull], ["cut", true, 0.25, "none"]);
    const [mix] = await drawsOf(...files({ alphaMode: "BLEND" }));
    assert.deepEqual([mix.blend, mix.depthWrite, mix.alphaCutoff], ["mix", false, 0]);
    const draws = await drawsOf(...files({}));
    assert.deepEqual([draws[0].blend, draws[0].depthWrite], ["none", true]);
    const texel = (draw) => [...draws.engine.bytes(draw.maps.diffuse.at, 4)];
    assert.deepEqual(texel(draws[0]), [10, 20, 30, 255], "opaque materials have no alpha");
});

// ---- Images ----

// A TGA of one texel with alpha.
const tga = ([r, g, b, a]) =>
    new Uint8Array([0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 32, 8, b, g, r, a]);

test("maps are found, decoded and drawn; what is missing is warned of", async () => {
    const draws = await drawsOf(
        ["m.obj", "mtllib m.mtl\n" + square + "vt 0 0\nusemtl a\nf 1/1 2/1 3/1\n"],
        ["m.mtl", "newmtl a\nKd 1 1 1\nmap_Kd -clamp on textures\\Wood.TGA\nmap_Ks no.png\n"],
        ["wood.tga", tga([1, 2, 3, 255])]
    );
    assert.deepEqual(draws.about.images, ["wood.tga"]);
    assert.deepEqual(draws.about.warnings, [
        "m.obj: its specular map 'no.png' cannot be read: it was not dropped with the model; it is left out",
    ]);
    assert.deepEqual([...draws.engine.bytes(draws[0].maps.diffuse.at, 4)], [1, 2, 3, 255]);
    assert.equal(draws[0].sampler.wrapS, "clamp-to-border");
    assert.deepEqual(Object.keys(draws[0].maps), ["diffuse"]);
});

test("an image that cannot be decoded is named", async () => {
    const obj = "mtllib m.mtl\n" + square + "vt 0 0\nusemtl a\nf 1/1 2/1 3/1\n";
    await assert.rejects(
        read(["m.obj", obj], ["m.mtl", "newmtl a\nmap_Kd w.tga\n"], ["w.tga", new Uint8Array([0, 0, 2])]),
        /^\w*Error: w\.tga: /
    );
});

// ---- Faults and warnings ----

test("what is wrong is said with file and place", async () => {
    await refuses([["m.obj", square + "f 1 2 5\n"]], "m.obj: line 5: f names v 5, but there are only 4");
    await refuses([["m.obj", "v 0 zero 0\n"]], 'm.obj: line 1: "zero" behind v is not a number');
    await refuses([["m.ply", ""]], "m.ply: it is empty");
    await refuses([["m.glb", "glTF"]], "m.glb: the file ends within its header of 12 bytes");
    await refuses([["a.txt", "x"]], "a.txt: there is no model among these files: .obj, .ply, .stl, .gltf or .glb");
    await refuses([["a.obj", square], ["b.glb", ""]], "a.obj, b.glb: drop one model at a time");
    await refuses([], "nothing: there is no model among these files: .obj, .ply, .stl, .gltf or .glb");
    await assert.rejects(read(["t.gltf", JSON.stringify(gltf("t.bin"))]), /^\w*Error: t\.gltf: \/buffers\/0.*t\.bin/);
});

test("what is not drawn is warned of, once for each kind", async () => {
    const { model } = await read(["m.obj", square + "parm u 0\nparm u 1\nf 1 2 3\nusemtl none\nf 1 2 4\n"]);
    assert.equal(model.about.warnings.length, 2);
    assert.match(model.about.warnings[0], /^m\.obj: line 5: parm .*\(2 times\)$/);
    assert.match(model.about.warnings[1], /^m\.obj: line 8: .*material/);
});

// Every file, cut short anywhere, is read or refused with a message; a module never ends in a trap.
test("files that are cut short are read or refused", async () => {
    const whole = [
        ["m.obj", Buffer.from(square + "f 1 2 3 4\n")],
        ["t.glb", glb(gltf(), numbers)],
        ["t.gltf", Buffer.from(JSON.stringify(gltf(`data:;base64,${Buffer.from(numbers).toString("base64")}`)))],
    ];
    const engine = await Engine.create(modules[0]);
    for (const [name, bytes] of whole) {
        for (let size = 0; size < bytes.length; size += 7) {
            try {
                engine.readModel([{ name, bytes: bytes.subarray(0, size) }]);
            } catch (error) {
                assert.ok(error.message.startsWith(`${name}: `), error.message);
            }
        }
    }
});

test("a lack of memory is a message", async () => {
    const engine = await Engine.create(modules[0]);
    engine.c.page_model_begin();
    const add = () => engine.withTexts(["big.ply"], (name) => engine.c.page_model_file(name, 2 ** 30));
    let count = 0;
    while (add() !== 0)
        assert.ok(++count < 4, "a module has less than 4 GiB");
    assert.equal(engine.message(), "there is not enough memory for the model");
    await readModel(engine, filesOf([["m.obj", square + "f 1 2 3\n"]]));
});

// ---- Modules ----

test("both modules draw the same of a model", async () => {
    const contents = [
        ["m.obj", "mtllib m.mtl\n" + square + "vt 0 0\nvt 1 0\nvt 1 1\nusemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 3/3 4/2\nl 1 4\np 2\n"],
        ["m.mtl", "newmtl a\nKd 1 0.5 0.2\nmap_Kd w.tga\nnewmtl b\nd 0.5\nKd 0 0.3 1\n"],
        ["w.tga", tga([200, 100, 50, 255])],
    ];
    const { model } = await read(...contents);
    const pictures = [];
    for (const module of modules) {
        const engine = await Engine.create(module);
        engine.loadModel(model);
        for (const state of ["", "&shadows=on&samples=4", "&shader=toon&polygons=line"]) {
            engine.setState(`model=dropped&size=64x48${state}`);
            engine.build();
            pictures.push(Buffer.from(engine.draw(0, 48)).toString("base64"));
        }
    }
    assert.deepEqual(pictures.slice(0, 3), pictures.slice(3));
    assert.equal(new Set(pictures.slice(0, 3)).size, 3);
});

test("the modules import nothing, and have the conversions that the readers print with", async () => {
    for (const module of modules)
        assert.deepEqual(WebAssembly.Module.imports(module), []);
    // tools/web/less/snprintf.c has no others.
    const known = /^%(\.(\d+|\*))?(l|ll|z)?[cdgsu]$|^%%$/;
    const folder = new URL("../../tools/models/", import.meta.url);
    for (const file of (await readdir(folder)).filter((name) => name.endsWith(".c"))) {
        const text = await readFile(new URL(file, folder), "utf8");
        for (const [literal] of text.matchAll(/"(?:[^"\\\n]|\\.)*"/g))
            for (const [conversion] of literal.matchAll(/%[-+ #0-9.*]*[hlzjt]*[A-Za-z%]/g))
                assert.match(conversion, known, `${file}: ${literal}`);
    }
});

await run();
