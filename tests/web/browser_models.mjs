// Tests of the page in a browser: dropped models, states and addresses, moving the camera.
import assert from "node:assert/strict";
import { join } from "node:path";
import { alerts, contract, drop, hashOf, open, otherHash, pixelAt, png, press, screenshots, settle, stateOf } from "./browser_page.mjs";
import { test } from "./results.mjs";

// ---- Models ----

const quad = "mtllib quad.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n" +
    "usemtl checked\nf 1/1 2/2 3/3 4/4\n";

test("an OBJ is dropped with its MTL and map", async () => {
    await open({}, async (page) => {
        const before = await hashOf(page);
        const map = await png(page, [["#f00", "#0f0"], ["#00f", "#fff"]]);
        await drop(page, [
            ["quad.obj", quad],
            ["quad.mtl", "newmtl checked\nKd 1 1 1\nmap_Kd textures\\Map.PNG\nmap_Ks missing.png\n"],
            ["map.png", "", map],
        ]);
        assert.deepEqual(await alerts(page), []);
        assert.match(await page.textContent("#model-report"), /quad\.obj: 2 triangles, 4 vertices, 1 part, map\.png/);
        assert.match(await page.textContent("#model-report"), /quad\.obj: its specular map 'missing\.png' cannot be read: it was not dropped/);
        assert.notEqual(await hashOf(page), before);
        await page.selectOption("[name=shader]", "unlit");
        await page.selectOption("[name=filter]", "nearest");
        await settle(page);
        assert.match(await stateOf(page), /^model=dropped&/);

        // Texture coordinates grow upward: the picture's upper row is the map's.
        const [x, y] = [320, 240];
        assert.deepEqual(await pixelAt(page, x - 60, y + 60), [255, 0, 0, 255]);
        assert.deepEqual(await pixelAt(page, x + 60, y + 60), [0, 255, 0, 255]);
        assert.deepEqual(await pixelAt(page, x - 60, y - 60), [0, 0, 255, 255]);
        assert.deepEqual(await pixelAt(page, x + 60, y - 60), [255, 255, 255, 255]);

        // Every worker has the model, with and without SIMD.
        const hash = await hashOf(page);
        for (const [name, value] of [["threads", "3"], ["simd", "off"], ["threads", "1"], ["simd", "on"]]) {
            await page.selectOption(`[name=${name}]`, value);
            await settle(page);
            assert.deepEqual(await alerts(page), []);
            if (name === "threads")
                assert.equal(await page.evaluate(() => gnomon.page.pool.hands.length), Number(value));
            else
                assert.equal((await page.textContent("#ours-name")).includes("simd"), value === "on");
            assert.equal(await hashOf(page), hash, `${name}=${value}`);
        }
        await page.screenshot({ path: join(screenshots, "dropped.png"), fullPage: true });
    });
});

test("a JPEG or PNG is not turned by its Exif orientation", async () => {
    await open({}, async (page) => {
        const colors = [["#f00", "#0f0", "#00f"]];
        const tiff = Buffer.from("MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0", "latin1");
        const exif = {
            jpeg: Buffer.concat([Buffer.from("\xff\xe1\0\x22Exif\0\0", "latin1"), tiff]),
            // The last four bytes are the check value of PNG, section 5.5.
            png: Buffer.concat([Buffer.from("\0\0\0\x1aeXIf"), tiff, Buffer.from("d6674b69", "hex")]),
        };
        for (const [kind, place] of [["jpeg", 2], ["png", 33]]) {
            const plain = Buffer.from(await png(page, colors, `image/${kind}`), "base64");
            const turned = Buffer.concat([plain.subarray(0, place), exif[kind], plain.subarray(place)]);
            const hashes = [];
            for (const map of [plain, turned]) {
                await drop(page, [
                    ["quad.obj", quad],
                    ["quad.mtl", `newmtl checked\nKd 1 1 1\nmap_Kd map.${kind}\n`],
                    [`map.${kind}`, "", map.toString("base64")],
                ]);
                assert.deepEqual(await alerts(page), []);
                hashes.push(await hashOf(page));
                const isNamed = (await page.textContent("#model-report"))
                    .includes(`map.${kind}: its Exif orientation 6 is not applied`);
                assert.equal(isNamed, map === turned);
            }
            assert.equal(hashes[1], hashes[0], kind);
        }
    });
});

test("a broken OBJ is refused in clear words, and the picture stays", async () => {
    await open({}, async (page) => {
        const before = await hashOf(page);
        const refuse = async (files, words) => {
            await drop(page, files);
            assert.match((await alerts(page)).join("\n"), words);
            assert.equal(await hashOf(page), before);
        };
        await refuse([["broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"]], /broken\.obj: line 4: f names v 4, but there are only 3/);
        await refuse([["broken.obj", "v 0 x 0\n"]], /broken\.obj: line 1: "x" behind v is not a number/);
        await refuse([["empty.obj", ""]], /empty\.obj: it is empty/);
        await refuse([["a.txt", "hello"]], /a\.txt: there is no model among these files/);
        await refuse(
            [["quad.obj", quad], ["quad.mtl", "newmtl checked\nmap_Kd map.png\n"], ["map.png", "not an image"]],
            /map\.png: it is not an image/
        );
        // Where files are chosen.
        assert.equal(await page.locator("fieldset:has(#files) #fault-model[role=alert]").count(), 1);
        await page.screenshot({ path: join(screenshots, "refused.png") });

        await drop(page, [["good.obj", quad]]);
        assert.deepEqual(await alerts(page), []);
        const good = await hashOf(page);
        await drop(page, [["broken.obj", "v 0 0\n"]]);
        assert.match((await alerts(page)).join(), /broken\.obj: line 1/);
        await page.selectOption("[name=shader]", "flat");
        await page.selectOption("[name=shader]", "phong");
        await settle(page);
        assert.equal(await hashOf(page), good, "the model before the broken one");
    });
});

// A GLB with three quads of the same map, which is inside it: one opaque, one cut out, one of glass. The quads
// stand behind each other.
function glassGlb(image) {
    const floats = new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, 0, 1, 1, 1, 1, 0, 0, 0]);
    const indices = new Uint16Array([0, 1, 2, 0, 2, 3]);
    const binary = Buffer.concat([Buffer.from(floats.buffer), Buffer.from(indices.buffer), image, Buffer.alloc(-image.length & 3)]);
    const material = (alphaMode, alpha) => ({
        alphaMode, doubleSided: true, pbrMetallicRoughness: { baseColorFactor: [1, 1, 1, alpha], baseColorTexture: { index: 0 } },
    });
    const json = Buffer.from(JSON.stringify({
        asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [0, 1, 2] }],
        nodes: [0, 1, 2].map((mesh) => ({ mesh, translation: [0.3 * mesh, 0.2 * mesh, 0.5 * mesh] })),
        meshes: [0, 1, 2].map((material) => ({ primitives: [{ attributes: { POSITION: 0, TEXCOORD_0: 1 }, indices: 2, material }] })),
        materials: [material("OPAQUE", 1), material("MASK", 1), material("BLEND", 0.5)],
        textures: [{ source: 0, sampler: 0 }], samplers: [{ magFilter: 9728, minFilter: 9728, wrapS: 33071, wrapT: 33071 }],
        images: [{ bufferView: 3, mimeType: "image/png", name: "cloth" }],
        accessors: [
            { bufferView: 0, componentType: 5126, count: 4, type: "VEC3", min: [-1, -1, 0], max: [1, 1, 0] },
            { bufferView: 1, componentType: 5126, count: 4, type: "VEC2" },
            { bufferView: 2, componentType: 5123, count: 6, type: "SCALAR" },
        ],
        bufferViews: [[0, 48], [48, 32], [80, 12], [92, image.length]].map(([byteOffset, byteLength]) => ({ buffer: 0, byteOffset, byteLength })),
        buffers: [{ byteLength: binary.length }],
    }));
    const text = Buffer.concat([json, Buffer.alloc(-json.length & 3, " ")]);
    const head = new Uint32Array([0x46546c67, 2, 28 + text.length + binary.length, text.length, 0x4e4f534a]);
    const second = new Uint32Array([binary.length, 0x004e4942]);
    return Buffer.concat([Buffer.from(head.buffer), text, Buffer.from(second.buffer), binary]);
}

// Colours that are blended or mixed may differ by a step or two. A few pixels on edges, whose places are rounded,
// may differ by more.
const ON_EDGES = 60;
const farPixels = (page) => page.evaluate(() => {
    const { ours, theirs } = gnomon.page.last;
    let count = 0;
    for (let i = 0; i < ours.pixels.length; i += 4)
        count += [0, 1, 2, 3].some((c) => Math.abs(ours.pixels[i + c] - theirs.pixels[i + c]) > 3);
    return count;
});

test("a GLB with an image inside it: cut-offs and blending, as WebGL draws them", async () => {
    await open({}, async (page) => {
        const image = Buffer.from(await png(page, [["rgba(255,0,0,1)", "rgba(0,255,0,0.2)"], ["rgba(0,0,255,1)", "rgba(255,255,255,1)"]]), "base64");
        await drop(page, [["glass.glb", "", glassGlb(image).toString("base64")]]);
        assert.deepEqual(await alerts(page), []);
        assert.match(await page.textContent("#model-report"), /glass\.glb: 6 triangles, 18 vertices, 3 parts, glass\.glb: cloth/);
        const hashes = [];
        for (const eye of ["0.5,0.4,6", "0.5,0.4,-6", "4,3,4"]) {
            await page.evaluate((at) => gnomon.restore(`model=dropped&target=0.3,0.2,0.5&eye=${at}`), eye);
            await settle(page);
            hashes.push(await hashOf(page));
            const far = await farPixels(page);
            assert.ok(far <= ON_EDGES, `${eye}: ${far} pixels differ`);
        }
        assert.equal(new Set(hashes).size, 3);
        await page.screenshot({ path: join(screenshots, "glass.png") });
    });
});

test("maps with a border, as WebGL draws them", async () => {
    await open({}, async (page) => {
        const map = await png(page, [["#f00", "#0f0"], ["#00f", "#fff"]]);
        await drop(page, [
            ["quad.obj", quad.replaceAll("vt 1", "vt 1.5")],
            ["quad.mtl", "newmtl checked\nKd 1 1 1\nmap_Kd -clamp on map.png\n"],
            ["map.png", "", map],
        ]);
        assert.deepEqual(await alerts(page), []);
        for (const filter of ["nearest", "linear"]) {
            await page.selectOption("[name=filter]", filter);
            await settle(page);
            const far = await farPixels(page);
            assert.ok(far <= ON_EDGES, `${filter}: ${far} pixels differ`);
        }
    });
});

test("points and lines, as WebGL draws them", async () => {
    await open({}, async (page) => {
        await drop(page, [["few.obj", "v -1 -1 0\nv 1 -1 0.3\nv 1 1 0\nv -1 0.5 0\nl 1 2 3\nl 2 4\np 1 2 3 4\n"]]);
        assert.deepEqual(await alerts(page), []);
        assert.match(await page.textContent("#model-report"), /few\.obj: 3 lines, 4 points/);
        const { coverage } = await page.evaluate(() => gnomon.page.last.counts);
        const drawn = await page.evaluate(() => {
            const { theirs, clear } = gnomon.page.last;
            let count = 0;
            for (let i = 0; i < theirs.pixels.length; i += 4)
                count += [0, 1, 2].some((c) => Math.abs(theirs.pixels[i + c] - clear[c] * 255) > 1);
            return count;
        });
        assert.ok(drawn > 500, `${drawn} pixels`);
        // OpenGL lets the pixels of a line lie one beside those of the diamond rule.
        assert.ok(coverage < drawn / 5, `${coverage} of ${drawn} pixels`);
    });
});

test("a PLY and an STL are dropped", async () => {
    await open({}, async (page) => {
        await drop(page, [["t.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" +
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"]]);
        assert.match(await page.textContent("#model-report"), /t\.ply: 1 triangle, 3 vertices, 1 part, no maps/);
        const ply = await hashOf(page);
        await drop(page, [["t.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n" +
            "endloop\nendfacet\nendsolid\n"]]);
        assert.match(await page.textContent("#model-report"), /t\.stl: 1 triangle/);
        assert.deepEqual(await alerts(page), []);
        assert.notEqual(ply, "");
    });
});

test("workers or an engine that are asked for while a model is handed over have the model", async () => {
    let hash = "";
    await open({}, async (page) => {
        await drop(page, [["quad.obj", quad]]);
        hash = await hashOf(page);
    });
    for (const [name, value] of [["threads", "2"], ["simd", "off"]]) {
        await open({}, async (page) => {
            // The pool asks for the change itself, and says late that it has the model.
            await page.evaluate(([key, wanted]) => {
                const { pool } = gnomon.page;
                const load = pool.loadModel.bind(pool);
                pool.loadModel = async (model) => {
                    const loaded = load(model);
                    const select = document.querySelector(`[name=${key}]`);
                    select.value = wanted;
                    select.dispatchEvent(new Event("change"));
                    await new Promise((resolve) => setTimeout(resolve, 500));
                    return loaded;
                };
            }, [name, value]);
            await drop(page, [["quad.obj", quad]]);
            assert.deepEqual(await alerts(page), [], name);
            assert.equal(await hashOf(page), hash, name);
            if (name === "threads")
                assert.equal(await page.evaluate(() => gnomon.page.pool.hands.length), 2);
            else
                assert.equal(await page.textContent("#ours-name"), "portable");
        });
    }
});

// ---- State ----

test("the address restores a picture, and a wrong one is said", async () => {
    let address = "";
    let hash = "";
    await open({}, async (page) => {
        await page.selectOption("[name=shader]", "toon");
        await page.selectOption("[name=convention]", "vulkan");
        await page.selectOption("[name=magnify]", "16");
        await page.fill("[name=fov]", "50");
        await page.locator("#ours").focus();
        await press(page, "ArrowLeft", 3);
        await press(page, "+");
        await page.waitForFunction(() => location.href === gnomon.link());
        address = await page.evaluate(() => location.hash.slice(1));
        hash = await hashOf(page);
        assert.match(address, /shader=toon/);
        assert.match(address, /eye=/);
        assert.match(address, /magnify=16/);
        assert.equal(await page.evaluate(() => history.length), 2, "the history is not flooded");
    });
    await open({ state: address }, async (page) => {
        assert.equal(await hashOf(page), hash);
        for (const [name, value] of [["shader", "toon"], ["convention", "vulkan"], ["magnify", "16"], ["fov", "50"]])
            assert.equal(await page.inputValue(`[name=${name}]`), value);
    });
    await open({}, async (page) => {
        await page.evaluate(() => (location.hash = "shader=flat&samples=4"));
        await page.waitForFunction(() => gnomon.page.last.state === "shader=flat&samples=4");
        assert.equal(await page.inputValue("[name=samples]"), "4");
        await page.evaluate(() => (location.hash = "simd=off&threads=2"));
        // The pool of the module before may have two hands too.
        await page.waitForFunction(() => document.getElementById("ours-name").textContent === "portable" &&
            gnomon.page.last.state === "" && gnomon.page.pool.hands?.length === 2);
        await settle(page);
        assert.equal(await hashOf(page), contract.get(""));
    });
    await open({}, async (page) => {
        // The page writes the address of the state before, late, between a new address and its event.
        await page.evaluate(() => {
            location.hash = "shader=toon";
            history.replaceState(null, "", "#shader=flat");
        });
        await page.waitForFunction(() => gnomon.page.last.state === "shader=toon");
    });
    await open({ state: "model=dropped&shader=flat&eye=1,2,3" }, async (page) => {
        assert.match((await alerts(page)).join(), /a model that was dropped/);
        assert.equal(await stateOf(page), "shader=flat");
    });
    await open({ state: "shader=velvet&threads=none" }, async (page) => {
        const said = (await alerts(page)).join("\n");
        assert.match(said, /velvet/);
        assert.match(said, /threads=none/);
        assert.equal(await hashOf(page), contract.get(""));
    });
});

test("a wrong value of a control is said and changes nothing", async () => {
    await open({}, async (page) => {
        await page.fill("[name=fov]", "400");
        await page.keyboard.press("Enter");
        await settle(page);
        assert.equal(await page.getAttribute("[name=fov]", "aria-invalid"), "true");
        // Right behind the control.
        const message = `#${await page.getAttribute("[name=fov]", "aria-errormessage")}`;
        assert.match(await page.textContent(`label:has([name=fov]) + ${message}`), /fov/);
        assert.equal(await page.locator("#alert .fault").count(), 0);
        assert.equal(await hashOf(page), contract.get(""));
        await page.fill("[name=fov]", "");
        await page.keyboard.press("Tab");
        await settle(page);
        assert.deepEqual(await alerts(page), []);
        // Values that are wrong only together.
        await page.fill("[name=near]", "5");
        await page.fill("[name=far]", "3");
        await page.keyboard.press("Enter");
        await settle(page);
        assert.match(await page.textContent("label:has([name=far]) + #fault-drawing"), /cannot draw this/);
        await page.fill("[name=far]", "30");
        await page.keyboard.press("Enter");
        await settle(page);
        assert.deepEqual(await alerts(page), []);
    });
});

test("a large file says how far it is", async () => {
    await open({}, async (page) => {
        const said = await page.evaluate(async () => {
            const said = [];
            const report = document.getElementById("model-report");
            const watch = new MutationObserver(() => said.push([report.textContent, report.querySelector("progress")?.getAttribute("value") ?? null]));
            watch.observe(report, { childList: true, subtree: true, characterData: true });
            // However fast the file is read, the page sees a second pass between two parts of it.
            const now = performance.now.bind(performance);
            let seconds = 0;
            performance.now = () => now() + 1000 * seconds++;
            const text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" + "# a long comment, as exporters write them\n".repeat(500000);
            await gnomon.takeFiles([new File([text], "large.obj")]);
            await gnomon.idle();
            watch.disconnect();
            return said;
        });
        const shares = said.filter(([text]) => /^Reading large\.obj: [0-9.]+ of 21 MB/.test(text)).map(([, share]) => Number(share));
        assert.ok(shares.length >= 2, JSON.stringify(said));
        assert.ok(shares.every((share, i) => share > (shares[i - 1] ?? 0) && share <= 1), shares.join());
        for (const words of [/^Building the model from 21 MB/, /^Handing the model to the workers/, /^large\.obj: 1 triangle/])
            assert.ok(said.some(([text]) => words.test(text)), `${words}: ${JSON.stringify(said)}`);
    });
});

test("what a model has and the page does not draw is said", async () => {
    await open({}, async (page) => {
        const map = await png(page, [["#fff"]]);
        await drop(page, [
            ["coloured.obj", "mtllib a.mtl\nv -1 -1 0 1 0 0\nv 1 -1 0 0 1 0\nv 1 1 0 0 0 1\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n"],
            ["a.mtl", "newmtl m\nKd 1 1 1\nd 0.5\nmap_Kd -s 2 2 1 -mm 0 2 a.png\n"],
            ["a.png", "", map],
        ]);
        const report = await page.textContent("#model-report");
        assert.match(report, /-mm/);
        // Colours of vertices and d are drawn: half of the background is seen through.
        const centre = await pixelAt(page, 340, 230);
        assert.ok(new Set(centre.slice(0, 3)).size > 1, centre.join());
        assert.equal(await page.evaluate(() => gnomon.page.last.description.draws.some(({ blend }) => blend === "mix")), true);
    });
});

test("the picture turns, and pauses", async () => {
    await open({}, async (page) => {
        // Each picture is another one than all before, in however many seconds it takes.
        const turns = async (times) => {
            const hashes = [await hashOf(page)];
            while (hashes.length <= times)
                hashes.push(await otherHash(page, hashes));
        };
        await page.click("#turn");
        await turns(3);
        // The engine and the workers can be exchanged meanwhile. One picture may still be the ones' before.
        await page.selectOption("[name=simd]", "off");
        await page.selectOption("[name=threads]", "2");
        await page.waitForFunction(() => document.getElementById("ours-name").textContent === "portable" &&
            gnomon.page.pool.hands?.length === 2);
        await turns(3);
        await page.click("#turn");
        await settle(page);
        const still = await hashOf(page);
        // Nothing can be waited for here: a page that went on turning would draw within this time.
        await page.waitForTimeout(1000);
        assert.equal(await hashOf(page), still);
        assert.deepEqual(await alerts(page), []);
        await page.click("#reset");
        await settle(page);
        assert.equal(await hashOf(page), contract.get("size=384x288&samples=4"));
    });
});

test("mouse and touch move the camera", async () => {
    // Counts pointers that were lifted: whatever they did before, the page has seen it then.
    const countLifted = (page) => page.evaluate(() => {
        globalThis.lifted = 0;
        addEventListener("pointerup", () => ++globalThis.lifted);
    });
    const untilLifted = async (page, count) => {
        await page.waitForFunction((wanted) => globalThis.lifted === wanted, count);
        await settle(page);
    };
    await open({ state: "size=320x240" }, async (page) => {
        await countLifted(page);
        const box = await page.locator("#theirs").boundingBox();
        const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
        const states = [await stateOf(page)];
        const drag = async () => {
            await page.mouse.move(x, y);
            await page.mouse.down();
            await page.mouse.move(x + 30, y + 10, { steps: 4 });
            await page.mouse.up();
            await untilLifted(page, states.length);
            states.push(await stateOf(page));
        };
        const target = (state) => /target=([^&]*)/.exec(state)[1];
        await drag();
        await page.keyboard.down("Shift");
        await drag();
        await page.keyboard.up("Shift");
        assert.notEqual(target(states[2]), target(states[1]));
        await drag();
        assert.equal(target(states[3]), target(states[2]));
        await page.click("#nearer");
        await page.waitForFunction((old) => gnomon.page.engine.state() !== old, states.at(-1));
        states.push(await stateOf(page));
        assert.equal(new Set(states).size, 5, states.join("\n"));
    });
    await open({ options: { hasTouch: true, viewport: { width: 390, height: 800 } } }, async (page, context) => {
        await countLifted(page);
        const box = await page.locator("#ours").boundingBox();
        const session = await context.newCDPSession(page);
        const touch = (type, ...points) =>
            session.send("Input.dispatchTouchEvent", {
                type,
                touchPoints: points.map(([x, y], id) => ({ x: box.x + x, y: box.y + y, id })),
            });
        const before = await stateOf(page);
        await touch("touchStart", [100, 100]);
        await touch("touchMove", [130, 110]);
        await touch("touchMove", [160, 120]);
        await touch("touchEnd");
        await untilLifted(page, 1);
        const turned = await stateOf(page);
        assert.notEqual(turned, before);
        await touch("touchStart", [100, 100], [150, 100]);
        await touch("touchMove", [80, 100], [200, 100]);
        await touch("touchMove", [60, 100], [260, 100]);
        await touch("touchEnd");
        await untilLifted(page, 3);
        assert.ok(await page.evaluate(() => gnomon.page.view.scale > 1.5), "two fingers magnify");
    });
});
