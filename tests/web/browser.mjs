// Tests the web page in headless Chromium: node tests/web/browser.mjs FOLDER SCREENSHOTS [NAME ...]
// FOLDER is what `make web` makes.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync } from "node:fs";
import { chromium } from "playwright-core";
import { join } from "node:path";
import { run, test } from "./results.mjs";
import { serve } from "./server.mjs";


const [folder, screenshots] = process.argv.splice(2, 2);

mkdirSync(screenshots, { recursive: true });

const contract = new Map(
    readFileSync(join(folder, "pictures.txt"), "utf8")
        .split("\n")
        .filter((line) => /^[0-9a-f]{16}( |$)/.test(line))
        .map((line) => [line.slice(17), line.slice(0, 16)])
);

const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: [
        "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
        "--disable-component-update", "--disable-sync", "--use-gl=angle", "--use-angle=swiftshader",
        "--enable-unsafe-swiftshader",
    ],
});
const plain = await serve(folder);
const isolated = await serve(folder, { isolated: true });

// Opens the page with a state, calls use(page), and checks that nothing was asked of other servers
// and that no program failed in silence.
async function open({ state = "", server = isolated, before = null, options = {} }, use) {
    const context = await browser.newContext({
        viewport: { width: 1280, height: 900 },
        serviceWorkers: "block",
        ...options,
    });
    const foreign = [];
    const broken = [];
    context.on("request", (request) => {
        const url = request.url();
        if (!url.startsWith(server.origin) && !url.startsWith("data:") && !url.startsWith("blob:"))
            foreign.push(url);
    });
    const page = await context.newPage();
    page.on("pageerror", (error) => broken.push(error.message));
    try {
        if (before)
            await page.addInitScript(before);
        await page.goto(`${server.origin}/${state === "" ? "" : `#${state}`}`);
        await ready(page);
        await use(page, context);
        assert.deepEqual(foreign, [], "requests to other servers");
        assert.deepEqual(broken, [], "errors that the page does not show");
    } finally {
        await context.close();
    }
}

async function ready(page) {
    await page.waitForFunction(() => document.documentElement.dataset.ready === "yes", null, { timeout: 20000 });
    await page.evaluate(() => gnomon.idle());
}

const hashOf = (page) => page.textContent("#hash");
const stateOf = (page) => page.evaluate(() => gnomon.page.engine.state());
const alerts = (page) => page.$$eval("#alert .fault", (all) => all.map((one) => one.lastChild.textContent));
const settle = (page) => page.evaluate(() => gnomon.idle());

async function press(page, key, times = 1) {
    for (let i = 0; i < times; ++i)
        await page.keyboard.press(key);
    await settle(page);
}

// Drops files, given as [name, text or base64 of an image], as a hand would.
async function drop(page, files) {
    await page.evaluate(async (given) => {
        const data = new DataTransfer();
        for (const [name, text, base64] of given) {
            const bytes = base64 ? Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)) : text;
            data.items.add(new File([bytes], name));
        }
        document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
    }, files);
    await page.waitForFunction(
        () => !document.getElementById("model-report").textContent.startsWith("Reading"),
        null,
        { timeout: 20000 }
    );
    await settle(page);
}

// A picture that is encoded by the browser, as base64. `colors` are rows of CSS colours.
function png(page, colors) {
    return page.evaluate((rows) => {
        const canvas = document.createElement("canvas");
        canvas.width = rows[0].length;
        canvas.height = rows.length;
        const context = canvas.getContext("2d");
        rows.forEach((row, y) =>
            row.forEach((color, x) => {
                context.fillStyle = color;
                context.fillRect(x, y, 1, 1);
            })
        );
        return canvas.toDataURL("image/png").split(",")[1];
    }, colors);
}

// The bytes of our picture at a place, y from the bottom.
const pixelAt = (page, x, y) =>
    page.evaluate(([px, py]) => {
        const { ours, width } = gnomon.page.last;
        return [...ours.pixels.slice(4 * (py * width + px), 4 * (py * width + px) + 4)];
    }, [x, y]);

// ---- Pictures ----

// The time is printed, not tested; what makes it short is.
test("the first picture waits for nothing that it does not need", async () => {
    await open({ server: plain }, async (page) => {
        const [time, loaded] = await page.evaluate(() => {
            const first = Number(document.documentElement.dataset.firstPicture);
            const resources = performance.getEntriesByType("resource");
            return [first, resources.filter(({ startTime }) => startTime < first).map(({ name }) => name.replace(/.*\//, ""))];
        });
        console.log(`first picture after ${time} ms`);
        assert.ok(time > 0);
        assert.ok(loaded.includes("gnomon-simd.wasm"), loaded.join());
        for (const later of ["gnomon.wasm", "worker.js", "pictures.txt", "explain.js", "model.js", "obj.js", "report.html"])
            assert.ok(!loaded.includes(later), `${later} was loaded before`);
    });
});

for (const [words, server, own] of [
    ["SIMD and three workers with shared memory", isolated, "threads=3&simd=on"],
    ["SIMD and one worker with copies", plain, "threads=1&simd=on"],
    ["two workers with shared memory, without SIMD", isolated, "threads=2&simd=off"],
    ["four workers with copies, without SIMD", plain, "threads=4&simd=off"],
]) {
    test(`pictures are the contract's: ${words}`, async () => {
        await open({ server, state: own }, async (page) => {
            const shared = await page.evaluate(() => typeof gnomon.page.pool.shared);
            assert.equal(await page.evaluate(() => crossOriginIsolated), server === isolated);
            assert.equal(await page.evaluate(() => gnomon.page.pool.hands.length), Number(own[8]));
            assert.equal(await page.evaluate(() => gnomon.page.pool.shared !== null), server === isolated, shared);
            const backend = await page.textContent("#ours-name");
            assert.equal(backend.includes("simd"), own.endsWith("on"), backend);
            assert.ok(contract.size >= 200, "pictures.txt has few states");
            // The modules draw all of them in Node (modules.mjs).
            const states = [...contract.keys()].filter((_, i) => i % 4 === 0);
            const wrong = await page.evaluate(async ([list, machine]) => {
                const said = [];
                // Without the time that WebGL takes.
                gnomon.page.webgl = null;
                for (const [state, hash] of list) {
                    gnomon.restore([state, machine].filter(Boolean).join("&"));
                    await gnomon.idle();
                    const { verdict } = document.getElementById("contract").dataset;
                    const shown = document.getElementById("hash").textContent;
                    if (gnomon.page.last.state !== state || shown !== hash || verdict !== "same")
                        said.push(`${state}: ${shown}, ${verdict}, not ${hash}`);
                }
                return said;
            }, [states.map((state) => [state, contract.get(state)]), own]);
            assert.deepEqual(wrong, []);
            assert.deepEqual(await alerts(page), []);
        });
    });
}

test("every lesson to choose is in the contract", async () => {
    await open({}, async (page) => {
        const presets = await page.$$eval("#preset option", (all) => all.map((one) => one.value).filter(Boolean));
        assert.ok(presets.length >= 10);
        for (const state of presets) {
            await page.selectOption("#preset", state);
            await settle(page);
            assert.equal(await page.getAttribute("#contract", "data-verdict"), "same", state);
        }
    });
});

test("a state that the contract does not have is called so, a wrong hash raises an alarm", async () => {
    await open({ state: "fov=41" }, async (page) => {
        assert.equal(await page.getAttribute("#contract", "data-verdict"), "unlisted");
    });
    const before = () => {
        const real = globalThis.fetch;
        globalThis.fetch = async (url) => {
            const response = await real(url);
            if (!String(url).endsWith("pictures.txt"))
                return response;
            return new Response((await response.text()).replace(/^[0-9a-f]{16}/gm, "0123456789abcdef"));
        };
    };
    await open({ before }, async (page) => {
        assert.equal(await page.getAttribute("#contract", "data-verdict"), "different");
        assert.match((await alerts(page)).join(), /It should be 0123456789abcdef/);
    });
});

test("without workers the page itself draws, without WebGL it says so; the picture is the same", async () => {
    const before = () => {
        globalThis.Worker = class {
            constructor() {
                throw new Error("no workers here");
            }
        };
        HTMLCanvasElement.prototype.getContext = new Proxy(HTMLCanvasElement.prototype.getContext, {
            apply: (get, canvas, [kind, ...rest]) =>
                kind === "webgl2" ? null : Reflect.apply(get, canvas, [kind, ...rest]),
        });
    };
    await open({ before }, async (page) => {
        assert.equal(await hashOf(page), contract.get(""));
        const said = (await alerts(page)).join("\n");
        assert.match(said, /Workers cannot be used.*no workers here/);
        assert.match(said, /no WebGL2/);
        assert.equal(await page.textContent("#differing"), "–");
    });
});

test("WebGL comes back when the browser has taken it away", async () => {
    await open({}, async (page) => {
        const before = await page.textContent("#differing");
        await page.evaluate(() => gnomon.page.webgl.gl.getExtension("WEBGL_lose_context").loseContext());
        await page.selectOption("[name=shader]", "flat");
        await page.selectOption("[name=shader]", "phong");
        await settle(page);
        assert.equal(await page.textContent("#differing"), before);
        assert.deepEqual(await alerts(page), []);
    });
});

// Counts again what the page has counted, from the same bytes, and pixels that differ by many steps.
const countAgain = (page) =>
    page.evaluate(() => {
        const { ours, theirs, clear, counts } = gnomon.page.last;
        const background = clear.map((c) => Math.round(255 * c)).join();
        const again = { differing: 0, coverage: 0, largest: 0 };
        let far = 0;
        for (let i = 0; i < ours.pixels.length; i += 4) {
            const a = [...ours.pixels.subarray(i, i + 4)];
            const b = [...theirs.pixels.subarray(i, i + 4)];
            if (a.join() === b.join())
                continue;
            again.differing += 1;
            far += a.some((v, c) => Math.abs(v - b[c]) > 16);
            if (a.join() === background || b.join() === background)
                again.coverage += 1;
            else
                again.largest = Math.max(again.largest, ...a.map((v, c) => Math.abs(v - b[c])));
        }
        const { differing, coverage, largest } = counts;
        return { again, far, counts: { differing, coverage, largest } };
    });

test("WebGL's difference is counted", async () => {
    for (const state of ["", "shader=phong&shadows=on", "polygons=line&shader=gouraud", "samples=4&shader=flat"]) {
        await open({ state }, async (page) => {
            assert.match(await page.textContent("#theirs-name"), /SwiftShader/);
            const { again, counts } = await countAgain(page);
            const pixels = await page.evaluate(() => gnomon.page.last.width * gnomon.page.last.height);
            if (process.env.VERBOSE)
                console.log(`${state || "default"}: ${JSON.stringify(counts)} of ${pixels}`);
            assert.deepEqual(counts, again, state);
            assert.ok(counts.differing < pixels / 4, `${state}: WebGL draws something else`);
            const shown = Number((await page.textContent("#differing")).split(" ")[0].replaceAll(",", ""));
            assert.equal(shown, counts.differing, state);
        });
    }
});

test("WebGL draws every shader, convention and kind of polygon nearly as Gnomon does", async () => {
    await open({}, async (page) => {
        const states = [];
        for (const shader of ["vertex-color", "unlit", "flat", "gouraud", "toon", "phong", "blinn-phong", "normals", "depth"])
            states.push(`shader=${shader}`);
        for (const model of ["triangle", "square", "cube"])
            states.push(`model=${model}`);
        for (const convention of ["direct3d", "vulkan"])
            for (const cull of ["none", "back", "front"])
                for (const polygons of ["fill", "line"])
                    states.push(`shader=gouraud&polygons=${polygons}&cull=${cull}&convention=${convention}`);
        for (const convention of ["direct3d", "vulkan"])
            states.push(`shader=flat&convention=${convention}`, `shader=phong&shadows=on&samples=4&convention=${convention}`);
        states.push("filter=nearest", "filter=linear", "maps=off", "polygons=point");
        for (const state of states) {
            await page.evaluate((text) => gnomon.restore(text), state);
            await settle(page);
            const { counts, far } = await countAgain(page);
            const pixels = await page.evaluate(() => gnomon.page.last.width * gnomon.page.last.height);
            const limit = state.includes("polygons") && !state.includes("fill") ? pixels / 50 : pixels / 200;
            const words = `${state}: ${JSON.stringify(counts)}, by many steps ${far}`;
            if (process.env.VERBOSE)
                console.log(words);
            assert.deepEqual(await alerts(page), [], state);
            assert.ok(counts.differing < pixels / 4, words);
            assert.ok(far < limit, words);
        }
    });
});

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
        assert.match(await page.textContent("#model-report"), /quad\.mtl:4: the map "missing\.png" was not dropped with it/);
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
            await page.waitForTimeout(300);
            await settle(page);
            assert.deepEqual(await alerts(page), []);
            assert.equal(await hashOf(page), hash, `${name}=${value}`);
        }
        await page.screenshot({ path: join(screenshots, "dropped.png"), fullPage: true });
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
        await refuse([["broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"]], /broken\.obj:4: f names v 4, but there are only 3/);
        await refuse([["broken.obj", "v 0 x 0\n"]], /broken\.obj:1: "x" after v is not a finite number/);
        await refuse([["empty.obj", ""]], /empty\.obj: there are no triangles/);
        await refuse([["a.txt", "hello"]], /a\.txt: there is no OBJ file/);
        await refuse(
            [["quad.obj", quad], ["quad.mtl", "newmtl checked\nmap_Kd map.png\n"], ["map.png", "not an image"]],
            /map\.png: it is not an image/
        );
        assert.match(await page.getAttribute("#alert", "role"), /alert/);
        await page.screenshot({ path: join(screenshots, "refused.png") });

        await drop(page, [["good.obj", quad]]);
        assert.deepEqual(await alerts(page), []);
        const good = await hashOf(page);
        await drop(page, [["broken.obj", "v 0 0\n"]]);
        assert.match((await alerts(page)).join(), /broken\.obj:1/);
        await page.selectOption("[name=shader]", "flat");
        await page.selectOption("[name=shader]", "phong");
        await settle(page);
        assert.equal(await hashOf(page), good, "the model before the broken one");
    });
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
        await page.waitForTimeout(500);
        address = await page.evaluate(() => location.hash.slice(1));
        hash = await hashOf(page);
        assert.match(address, /shader=toon/);
        assert.match(address, /eye=/);
        assert.match(address, /magnify=16/);
        assert.equal(await page.evaluate(() => gnomon.link()), await page.evaluate(() => location.href));
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
        assert.match((await alerts(page)).join(), /fov/);
        assert.equal(await hashOf(page), contract.get(""));
        await page.fill("[name=fov]", "");
        await page.keyboard.press("Tab");
        await settle(page);
        assert.deepEqual(await alerts(page), []);
    });
});

test("the picture turns, and pauses", async () => {
    await open({}, async (page) => {
        await page.click("#turn");
        const hashes = new Set();
        for (let i = 0; i < 10; ++i) {
            await page.waitForTimeout(100);
            hashes.add(await hashOf(page));
        }
        assert.ok(hashes.size >= 3, `${hashes.size} pictures`);
        // The engine and the workers can be exchanged meanwhile.
        await page.selectOption("[name=simd]", "off");
        await page.selectOption("[name=threads]", "2");
        await page.waitForTimeout(500);
        const before = await hashOf(page);
        await page.waitForTimeout(500);
        assert.notEqual(await hashOf(page), before);
        await page.click("#turn");
        await settle(page);
        const still = await hashOf(page);
        await page.waitForTimeout(300);
        assert.equal(await hashOf(page), still);
        assert.deepEqual(await alerts(page), []);
        await page.click("#reset");
        await settle(page);
        assert.equal(await hashOf(page), contract.get(""));
    });
});

test("mouse and touch move the camera", async () => {
    await open({}, async (page) => {
        const box = await page.locator("#theirs").boundingBox();
        const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
        const states = [await stateOf(page)];
        const drag = async () => {
            await page.mouse.move(x, y);
            await page.mouse.down();
            await page.mouse.move(x + 30, y + 10, { steps: 4 });
            await page.mouse.up();
            await settle(page);
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
        await page.mouse.wheel(0, -300);
        await page.waitForTimeout(100);
        states.push(await stateOf(page));
        assert.equal(new Set(states).size, 5, states.join("\n"));
    });
    await open({ options: { hasTouch: true, viewport: { width: 390, height: 800 } } }, async (page, context) => {
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
        await settle(page);
        const turned = await stateOf(page);
        assert.notEqual(turned, before);
        await touch("touchStart", [100, 100], [150, 100]);
        await touch("touchMove", [80, 100], [200, 100]);
        await touch("touchMove", [60, 100], [260, 100]);
        await touch("touchEnd");
        await settle(page);
        assert.notEqual(await stateOf(page), turned);
    });
});

// ---- Keyboard ----

test("the keyboard alone reaches and operates every control", async () => {
    await open({}, async (page) => {
        const wanted = await page.$$eval("canvas, select, input, button, a, summary", (all) =>
            all.filter((one) => one.checkVisibility()).map((one) => one.id || one.name || one.textContent)
        );
        const focused = () =>
            page.evaluate(() => {
                const { id, name, textContent } = document.activeElement;
                return id || name || textContent;
            });
        const reached = new Set();
        for (let i = 0; i < wanted.length + 10; ++i) {
            await page.keyboard.press("Tab");
            reached.add(await focused());
        }
        assert.deepEqual(wanted.filter((name) => !reached.has(name)), []);

        // Everything that is focused has a name, and the focus is seen.
        const unnamed = await page.$$eval("canvas, select, input", (all) =>
            all.filter((one) => !one.getAttribute("aria-label") && !one.labels?.length).map((one) => one.outerHTML)
        );
        assert.deepEqual(unnamed, []);

        for (const name of ["model", "size", "shader", "maps", "filter", "shadows", "samples", "polygons", "cull", "convention"]) {
            const before = await stateOf(page);
            await page.locator(`[name=${name}]`).focus();
            const value = await page.inputValue(`[name=${name}]`);
            await press(page, "ArrowDown");
            if ((await page.inputValue(`[name=${name}]`)) === value)
                await press(page, "ArrowUp");
            assert.notEqual(await stateOf(page), before, name);
        }
        for (const [name, value] of [["bands", "5"], ["exponent", "20"], ["fov", "60"], ["near", "0.5"], ["far", "90"]]) {
            await page.locator(`[name=${name}]`).focus();
            await page.keyboard.type(value);
            await press(page, "Enter");
            assert.ok((await stateOf(page)).includes(`${name}=${value}`), `${name}: ${await stateOf(page)}`);
        }
        for (const name of ["magnify", "threads", "simd"]) {
            await page.locator(`[name=${name}]`).focus();
            await press(page, "ArrowDown");
            await page.waitForTimeout(300);
            const own = await page.evaluate((key) => gnomon.page.own[key], name);
            assert.equal(own, await page.inputValue(`[name=${name}]`));
            assert.notEqual(own, { magnify: "64", threads: "auto", simd: "auto" }[name]);
        }
        await page.locator("#preset").focus();
        await press(page, "ArrowDown");
        assert.match(await stateOf(page), /polygons=line/);
        await page.locator("#turn").focus();
        await press(page, "Space", 2);
        await page.locator("#reset").focus();
        await press(page, "Enter");
        assert.equal(await stateOf(page), "");

        for (const key of ["ArrowRight", "Shift+ArrowUp", "+", "-"]) {
            const before = await stateOf(page);
            await page.locator("#ours").focus();
            await press(page, key);
            assert.notEqual(await stateOf(page), before, key);
        }
        await press(page, "x");
        await press(page, "ArrowRight", 2);
        await press(page, "Shift+ArrowUp");
        assert.deepEqual(await page.evaluate(() => gnomon.page.cursor), [322, 250]);
        await press(page, "Escape");
        assert.equal(await page.locator(".cursor").count(), 0);
    });
});

// ---- Pixels ----

const sample = {
    pixel: [320, 240],
    size: [640, 480],
    color: "ff204060",
    text: "pixel 320,240",
    fragments: [
        {
            draw: 0,
            primitive: 11,
            kind: "triangle",
            result: "written",
            corners: [[81000, 61000], [83000, 61200], [82000, 62500]],
            stages: [
                { name: "Vertex 1 of 3", values: [{ name: "clip x", value: "0.25", bits: "3e800000", expression: "m[0] * x" }] },
                { name: "Depth", values: [{ name: "z", value: "0.5", bits: "3f000000", expression: "a + b" }] },
            ],
        },
        { draw: 0, primitive: 12, kind: "triangle", result: "failed the depth test", corners: [], stages: [] },
    ],
};

test("what a module says of a pixel is shown as tables, a grid and text", async () => {
    await open({}, async (page) => {
        await page.evaluate(async (explained) => {
            const { showExplained } = await import("./explain.js");
            showExplained(document.getElementById("pixel"), explained, gnomon.page.last, () => {});
        }, sample);
        assert.equal(await page.locator("#pixel svg").count(), 2);
        assert.equal(await page.locator("#pixel svg rect").count(), 2 * 82);
        assert.equal(await page.locator("#pixel svg polygon").count(), 2 * 2);
        const theirs = await page.evaluate(() => {
            const { theirs, width } = gnomon.page.last;
            return new DataView(theirs.pixels.buffer).getUint32(4 * (240 * width + 320), true).toString(16);
        });
        assert.match(await page.textContent("#pixel"), new RegExp(`Gnomon has stored ff[0-9a-f]{6}, WebGL ${theirs} `));
        assert.match(await page.textContent("#pixel .fault"), /ff204060, which is not what Gnomon has stored/);
        assert.deepEqual(await page.$$eval("#pixel details[open] summary", (all) => all.map((one) => one.textContent)),
            ["■ Draw 0, triangle 11: written", "Vertex 1 of 3", "Depth"]);
        assert.deepEqual(await page.$$eval("#pixel tbody tr:first-child", ([row]) => [...row.cells].map((cell) => cell.textContent)),
            ["clip x", "0.25", "3e800000", "m[0] * x"]);
        assert.equal(await page.textContent("#pixel pre"), sample.text);
    });
});

test("a pixel that cannot be taken apart says why", async () => {
    const before = () => {
        const real = globalThis.fetch;
        globalThis.fetch = (url) =>
            String(url).endsWith("gnomon.wasm") ? Promise.resolve(new Response("", { status: 404, statusText: "Not Found" })) : real(url);
    };
    await open({ before }, async (page) => {
        await page.click("#ours");
        await page.waitForSelector("#fault-explain");
        assert.match((await alerts(page)).join(), /gnomon\.wasm cannot be loaded: 404 Not Found/);
    });
});

const gnomon = process.env.GNOMON;

test("a pixel is clicked and its values are those of `gnomon explain`", async () => {
    for (const state of ["", "shader=flat&convention=vulkan&samples=4"]) {
        await open({ state }, async (page) => {
            const box = await page.locator("#ours").boundingBox();
            await page.mouse.click(box.x + box.width * 0.45, box.y + box.height * 0.6);
            await page.waitForSelector("#pixel pre", { state: "attached", timeout: 20000 });
            const x = await page.inputValue("#pixel-x");
            const y = await page.inputValue("#pixel-y");
            const text = await page.evaluate(() => document.querySelector("#pixel pre").textContent);
            assert.ok(text.length > 200);
            assert.ok((await page.locator("#pixel table").count()) > 0);
            assert.equal(await page.locator("#pixel .fault").count(), 0);
            const cells = await page.$$eval("#pixel tbody tr", (rows) => rows.map((row) => [...row.cells].map((cell) => cell.textContent)));
            assert.ok(cells.length > 100);
            for (const [name, value, bits] of cells) {
                assert.ok(text.includes(name) && text.includes(value) && text.includes(bits), `${name} ${value} ${bits}`);
            }
            if (gnomon) {
                // The command counts rows from the top.
                const row = 479 - Number(y);
                const said = execFileSync(gnomon, ["explain", "--state", state, "--pixel", `${x},${row}`], { encoding: "utf8" });
                // Behind this word stands how each program has checked itself.
                const values = (all) => all.split("\nChecked:")[0];
                assert.equal(values(text), values(said));
                assert.ok(values(text).length < text.length);
            }
            await page.screenshot({ path: join(screenshots, `pixel${state === "" ? "" : "-vulkan"}.png`), fullPage: true });
        });
    }
});

test("the keyboard takes a pixel apart, and the address keeps it", async () => {
    let address = "";
    await open({}, async (page) => {
        await page.locator("#ours").focus();
        await press(page, "x");
        await press(page, "ArrowLeft", 3);
        await press(page, "Enter");
        await page.waitForSelector("#pixel pre", { state: "attached" });
        await page.waitForTimeout(500);
        address = await page.evaluate(() => location.hash.slice(1));
        assert.match(address, /pixel=317,240/);
    });
    await open({ state: address }, async (page) => {
        await page.waitForSelector("#pixel pre", { state: "attached" });
        assert.match(await page.textContent("#pixel"), /Pixel 317, 240/);
    });
});

// ---- The page as a whole ----

test("nothing is wider than a phone, and screenshots are kept", async () => {
    for (const [name, options] of [
        ["light", {}],
        ["dark", { colorScheme: "dark" }],
        ["phone", { viewport: { width: 360, height: 740 }, deviceScaleFactor: 2, hasTouch: true, isMobile: true }],
        ["phone-dark", { viewport: { width: 360, height: 740 }, deviceScaleFactor: 2, isMobile: true, colorScheme: "dark" }],
        ["tablet", { viewport: { width: 768, height: 1024 } }],
    ]) {
        await open({ options, state: "pixel=290,200" }, async (page) => {
            await page.waitForSelector("#pixel pre", { state: "attached", timeout: 20000 });
            // A phone's browser widens innerWidth with what is too wide.
            const wide = await page.evaluate(() => document.documentElement.scrollWidth);
            const room = page.viewportSize().width;
            assert.ok(wide <= room, `${name}: ${wide} > ${room}`);
            await page.screenshot({ path: join(screenshots, `${name}.png`), fullPage: true });
        });
    }
});

test("a service worker isolates the page, and serves it without a network", async () => {
    const server = await serve(folder);
    const context = await browser.newContext({ serviceWorkers: "allow" });
    try {
        const page = await context.newPage();
        await page.goto(server.origin + "/");
        await ready(page);
        assert.equal(await page.evaluate(() => crossOriginIsolated), false);
        await Promise.all([page.waitForNavigation(), page.click("#isolate")]);
        await ready(page);
        assert.equal(await page.evaluate(() => crossOriginIsolated), true);
        assert.equal(await hashOf(page), contract.get(""));
        await page.waitForTimeout(1000);
        await server.close();
        await page.reload();
        await ready(page);
        assert.equal(await hashOf(page), contract.get(""));
        assert.equal(await page.getAttribute("#contract", "data-verdict"), "same");
    } finally {
        await context.close();
        await server.close().catch(() => {});
    }
});

await run();
await browser.close();
await plain.close();
await isolated.close();
