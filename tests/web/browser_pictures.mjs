// Tests of the page in a browser: its pictures are the contract's, and WebGL's beside them.
import assert from "node:assert/strict";
import { alerts, contract, hashOf, isolated, open, plain, settle, stateOf } from "./browser_page.mjs";
import { test } from "./results.mjs";

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
        for (const later of ["gnomon.wasm", "worker.js", "pictures.txt", "explain.js", "why.js", "files.js", "model.js"])
            assert.ok(!loaded.includes(later), `${later} was loaded before`);
    });
});

for (const [part, [words, server, own]] of [
    ["SIMD and three workers with shared memory", isolated, "threads=3&simd=on"],
    ["SIMD and one worker with copies", plain, "threads=1&simd=on"],
    ["two workers with shared memory, without SIMD", isolated, "threads=2&simd=off"],
    ["four workers with copies, without SIMD", plain, "threads=4&simd=off"],
].entries()) {
    test(`pictures are the contract's: ${words}`, async () => {
        await open({ server, state: own }, async (page) => {
            const shared = await page.evaluate(() => typeof gnomon.page.pool.shared);
            assert.equal(await page.evaluate(() => crossOriginIsolated), server === isolated);
            assert.equal(await page.evaluate(() => gnomon.page.pool.hands.length), Number(own[8]));
            assert.equal(await page.evaluate(() => gnomon.page.pool.shared !== null), server === isolated, shared);
            const backend = await page.textContent("#ours-name");
            assert.equal(backend.includes("simd"), own.endsWith("on"), backend);
            assert.ok(contract.size >= 200, "pictures.txt has few states");
            // Each of these tests draws another eighth. The modules draw all of them in Node (modules.mjs).
            const states = [...contract.keys()].filter((_, i) => i % 8 === 2 * part);
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
    await open({ state: null }, async (page) => {
        const presets = await page.$$eval("#preset option", (all) => all.map((one) => one.value).filter(Boolean));
        assert.ok(presets.length >= 10);
        for (const state of presets) {
            await page.selectOption("#preset", state);
            await settle(page);
            assert.equal(await page.getAttribute("#contract", "data-verdict"), "same", state);
            const { width, height } = await page.evaluate(() => gnomon.page.last);
            assert.deepEqual([width, height], [384, 288], `${state}: the size stays`);
        }
    });
});

test("the page begins with four samples, in a size that fits the window and is in the contract", async () => {
    for (const [options, size] of [
        [{}, "384x288"],
        [{ viewport: { width: 1920, height: 1000 } }, "512x384"],
        [{ viewport: { width: 1280, height: 900 }, deviceScaleFactor: 2 }, "384x288"],
        [{ viewport: { width: 360, height: 740 }, deviceScaleFactor: 2, isMobile: true }, ""],
        [{ viewport: { width: 360, height: 740 } }, "320x240"],
    ]) {
        await open({ state: null, options }, async (page) => {
            assert.equal(await stateOf(page), [size && `size=${size}`, "samples=4"].filter(Boolean).join("&"));
            assert.equal(await page.getAttribute("#contract", "data-verdict"), "same");
            assert.equal(await page.evaluate(() => location.hash), "", "an address without a state stays so");
            // Its address names the state, so that it is the same picture in another window.
            assert.match(await page.evaluate(() => gnomon.link()), /#.*samples=4$/);
            // Three pictures side by side, or one below the other.
            const tops = await page.$$eval(".pictures canvas", (all) => all.map((one) => one.getBoundingClientRect().top));
            assert.equal(new Set(tops).size, page.viewportSize().width > 800 ? 1 : 3);
        });
    }
});

test("each pixel of a picture is a whole number of pixels of the screen", async () => {
    for (const [size, ratio, factor] of [["640x480", 1, 1], ["384x288", 2, 2], ["64x48", 1, 6], ["1920x1080", 1, 1]]) {
        await open({ state: `size=${size}`, options: { deviceScaleFactor: ratio } }, async (page) => {
            const [width, height] = size.split("x").map(Number);
            for (const id of ["ours", "theirs", "difference"]) {
                const box = await page.locator(`#${id}`).boundingBox();
                assert.deepEqual([box.width * ratio, box.height * ratio], [width * factor, height * factor], `${id} ${size}`);
            }
            const wide = await page.evaluate(() => document.documentElement.scrollWidth);
            assert.ok(wide <= 1280, `${size}: the page is ${wide} wide`);
        });
    }
});

test("a state that the contract does not have is called so, a wrong hash raises an alarm", async () => {
    await open({ state: "fov=41" }, async (page) => {
        assert.equal(await page.getAttribute("#contract", "data-verdict"), "unlisted");
        // That is no alarm.
        const [said, plain] = await page.evaluate(() => ["contract", "keys"].map((id) => getComputedStyle(document.getElementById(id)).color));
        assert.equal(said, plain);
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

test("WebGL draws again after a framebuffer that it does not have", async () => {
    await open({}, async (page) => {
        const before = await page.textContent("#differing");
        await page.evaluate(() => (gnomon.page.webgl.gl.checkFramebufferStatus = () => 0));
        await page.selectOption("[name=size]", "320x240");
        await settle(page);
        assert.match((await alerts(page)).join(), /WebGL has no framebuffer of 320x240, 1 samples/);
        await page.evaluate(() => delete gnomon.page.webgl.gl.checkFramebufferStatus);
        await page.selectOption("[name=size]", "640x480");
        await settle(page);
        assert.deepEqual(await alerts(page), []);
        assert.equal(await page.textContent("#differing"), before);
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

test("the histogram has every differing pixel, and 1x shows a step as one step", async () => {
    await open({ state: "shader=toon&magnify=1&threads=1" }, async (page) => {
        const { far, bars, counts, summary } = await page.evaluate(() => {
            const { ours, theirs, clear, counts } = gnomon.page.last;
            const background = clear.map((c) => Math.round(255 * c)).join();
            let far = 0;
            const shown = new Uint8Array(counts.pixels.buffer);
            for (let i = 0; i < ours.pixels.length; i += 4) {
                const [a, b] = [ours, theirs].map(({ pixels }) => pixels.subarray(i, i + 4));
                if (a.join() === background || b.join() === background)
                    continue;
                far += [0, 1, 2].some((c) => shown[i + c] !== Math.abs(a[c] - b[c]));
            }
            const bars = [...document.querySelectorAll("#steps tr")].map((row) => [...row.cells].map((cell) => cell.textContent));
            return { far, bars, counts: { ...counts, pixels: null, steps: [...counts.steps] }, summary: document.getElementById("summary").textContent };
        });
        assert.equal(far, 0, "pixels whose shown difference is not their difference");
        const numbers = bars.map(([, text]) => Number(text.split(" ")[0].replaceAll(",", "")));
        assert.equal(numbers.reduce((sum, n) => sum + n, 0), counts.differing);
        assert.equal(numbers[0], counts.steps[1]);
        assert.equal(numbers.at(-1), counts.coverage);
        assert.ok(counts.steps[1] > counts.differing / 2);
        const share = /([0-9]+) % differ by one step/.exec(summary);
        assert.equal(Number(share[1]), Math.round((100 * counts.steps[1]) / counts.differing), summary);
    });
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
