// Tests of the page in a browser: the keyboard, pixels taken apart, the page as a whole.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { alerts, contract, folder, hashOf, newContext, open, press, ready, screenshots, stateOf, until } from "./browser_page.mjs";
import { skip, test } from "./results.mjs";
import { serve } from "./server.mjs";

// ---- Keyboard ----

test("the keyboard alone reaches and operates every control", async () => {
    await open({}, async (page) => {
        const wanted = await page.$$eval("canvas, select, input, button, a, summary", (all) =>
            all.filter((one) => one.checkVisibility() && !one.disabled).map((one) => one.id || one.name || one.textContent)
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
        assert.equal(await stateOf(page), "size=384x288&samples=4");

        for (const key of ["ArrowRight", "Shift+ArrowUp", "+", "-"]) {
            const before = await stateOf(page);
            await page.locator("#ours").focus();
            await press(page, key);
            assert.notEqual(await stateOf(page), before, key);
        }
        await press(page, "x");
        await press(page, "ArrowRight", 2);
        await press(page, "Shift+ArrowUp");
        assert.deepEqual(await page.evaluate(() => gnomon.page.cursor), [194, 154]);
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
            showExplained(document.getElementById("pixel"), explained, "The reason.", gnomon.page.last, () => {});
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
        // The sentence is first, the values are folded.
        assert.equal(await page.textContent("#pixel > :first-child"), "The reason.");
        assert.equal(await page.locator("#pixel table").first().isVisible(), false);
        await page.click("#pixel .values > summary");
        assert.deepEqual(await page.$$eval("#pixel .values details[open] summary", (all) => all.map((one) => one.textContent)),
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

// The command, for comparison.
const gnomon = process.env.GNOMON ?? "build/gnomon";

test("a pixel is clicked and its values are those of `gnomon explain`", async () => {
    for (const state of ["", "shader=flat&convention=vulkan&samples=4"]) {
        await open({ state }, async (page) => {
            const box = await page.locator("#ours").boundingBox();
            await page.mouse.click(box.x + box.width * 0.45, box.y + box.height * 0.6);
            await page.waitForSelector("#pixel pre", { state: "attached" });
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
            if (!existsSync(gnomon)) {
                skip(`the page's values of a pixel compared with those of 'gnomon explain': ${gnomon} is absent ('make ${gnomon}')`);
            } else {
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
        await page.waitForFunction(() => location.href === gnomon.link());
        address = await page.evaluate(() => location.hash.slice(1));
        assert.match(address, /pixel=317,240/);
    });
    await open({ state: address }, async (page) => {
        await page.waitForSelector("#pixel pre", { state: "attached" });
        assert.match(await page.textContent("#pixel"), /Pixel 317, 240/);
    });
});

// ---- Why a pixel differs ----

// Differing pixels of the picture by kind: coverage where one side alone has the background, far ones with more than
// 30 steps, the others.
const differingPixels = (page) => page.evaluate(() => {
    const { ours, theirs, width, clear } = gnomon.page.last;
    const background = clear.map((c) => Math.round(255 * c)).join();
    const found = { coverage: [], far: [], near: [] };
    for (let i = 0; i < ours.pixels.length; i += 4) {
        const [a, b] = [ours, theirs].map(({ pixels }) => [...pixels.subarray(i, i + 4)]);
        const steps = Math.max(...a.map((value, c) => Math.abs(value - b[c])));
        if (steps === 0)
            continue;
        const kind = steps > 30 ? ((a.join() === background) !== (b.join() === background) ? "coverage" : "far") : "near";
        found[kind].push([(i / 4) % width, Math.floor(i / 4 / width)]);
    }
    return found;
});

async function whyOf(page, [x, y]) {
    await page.evaluate(() => document.getElementById("pixel").replaceChildren());
    await page.fill("#pixel-x", String(x));
    await page.fill("#pixel-y", String(y));
    await page.click("#pixel-form button");
    await page.waitForSelector("#pixel .why");
    return page.textContent("#pixel .why");
}

const spread = (list, count) => Array.from({ length: Math.min(count, list.length) }, (_, i) => list[Math.floor((i * list.length) / Math.min(count, list.length))]);

test("a pixel that one side alone draws: the distances from an edge say why", async () => {
    // The reason is checked with what the sentence says: which side of the edge for whom, and who has drawn.
    const sides = /^WebGL puts the pixel’s centre (exactly on|[0-9.e-]+ pixel (inside|outside)) the edge between corners [123] and [123] of triangle [0-9]+ of draw [0-9]+; Gnomon puts it ([0-9.e-]+) pixel (inside|outside)\. Gnomon rounds corners to 1\/256 pixel, this WebGL to 1\/[0-9]+\.$/;
    for (const state of ["model=cube&shader=flat", "model=cube&shader=flat&convention=vulkan"]) {
        await open({ state }, async (page) => {
            const { coverage } = await differingPixels(page);
            assert.ok(coverage.length >= 4, state);
            let count = 0;
            for (const pixel of spread(coverage, 5)) {
                const why = await whyOf(page, pixel);
                const [, , theirs, distance, ours] = sides.exec(why) ?? assert.fail(why);
                const isOurs = await page.evaluate(([x, y]) => {
                    const { ours: { pixels }, width, clear } = gnomon.page.last;
                    return clear.some((c, i) => Math.round(c * 255) !== pixels[4 * (y * width + x) + i]);
                }, pixel);
                assert.equal(ours, isOurs ? "inside" : "outside", why);
                assert.ok(Number(distance) < 0.1, why);
                count += theirs === (isOurs ? "outside" : "inside");
            }
            assert.ok(count >= 3, `${state}: ${count}`);
        });
    }
});

test("a pixel of the same fragment: the numbers before rounding say why", async () => {
    await open({ state: "shader=unlit" }, async (page) => {
        const { near } = await differingPixels(page);
        for (const [x, y] of spread(near, 5)) {
            const why = await whyOf(page, [x, y]);
            const found = /^The same fragment; (.*) by (one|\d+) .*before rounding Gnomon has ([0-9.]+) for (red|green|blue) and WebGL ([0-9.]+)/.exec(why);
            if (!found) {
                assert.match(why, /^WebGL (puts|shows)/);
                continue;
            }
            const [, , , ours, channel, theirs] = found;
            const stored = await page.evaluate(([px, py, c]) => ["ours", "theirs"].map((side) =>
                gnomon.page.last[side].pixels[4 * (py * gnomon.page.last.width + px) + c]), [x, y, ["red", "green", "blue"].indexOf(channel)]);
            assert.equal(stored[0], Math.min(255, Math.round(Number(ours))), why);
            assert.ok(Math.abs(stored[1] - Number(theirs)) <= 0.6, why);
        }
    });
    // An equal pixel, and samples.
    await open({ state: "samples=4&size=320x240" }, async (page) => {
        assert.match(await whyOf(page, [0, 0]), /^Nothing differs/);
        const { far } = await differingPixels(page);
        for (const pixel of spread(far, 3))
            assert.match(await whyOf(page, pixel), /^An edge (crosses the pixel, and its four samples have|passes by)/);
    });
});

test("a clicked pixel's reason is in view, also on a phone", async () => {
    for (const options of [{}, { viewport: { width: 360, height: 740 }, deviceScaleFactor: 2, isMobile: true }]) {
        await open({ state: null, options }, async (page) => {
            const box = await page.locator("#ours").boundingBox();
            await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
            await page.waitForSelector("#pixel .why");
            await page.waitForFunction(() => {
                const { top, bottom } = document.querySelector("#pixel .why").getBoundingClientRect();
                return top >= 0 && bottom <= innerHeight;
            });
        });
    }
});

// ---- Magnification ----

test("the wheel scrolls the page; with Ctrl it magnifies down to one pixel, which is taken apart", async () => {
    await open({ state: "size=320x240" }, async (page) => {
        const state = await stateOf(page);
        const box = await page.locator("#theirs").boundingBox();
        const [x, y] = [150, 100];
        await page.mouse.move(box.x + x + 0.5, box.y + y + 0.5);
        await page.mouse.wheel(0, 200);
        await page.waitForFunction(() => scrollY > 100);
        assert.equal(await page.textContent("#scale"), "1×");
        await page.evaluate(() => scrollTo(0, 0));
        await page.keyboard.down("Control");
        const scales = [];
        for (let i = 0; i < 13; ++i) {
            await page.mouse.wheel(0, -100);
            await page.waitForFunction((before) => gnomon.page.view.scale > before, scales.at(-1) ?? 1);
            scales.push(await page.evaluate(() => gnomon.page.view.scale));
        }
        await page.keyboard.up("Control");
        // Without jumps.
        assert.ok(scales.every((scale, i) => scale / (scales[i - 1] ?? 1) < 1.5), scales.join());
        await page.waitForSelector("#pixel .why");
        const chosen = [x, 239 - y];
        assert.deepEqual([await page.inputValue("#pixel-x"), await page.inputValue("#pixel-y")].map(Number), chosen);
        assert.equal(await stateOf(page), state, "the camera stays");
        // All three show the pixel at the same place, in its colour.
        const [wanted, seen] = await page.evaluate(([px, py]) => {
            const { view, last } = gnomon.page;
            const at = 4 * (py * last.width + px);
            const share = view.shareOf(px, py);
            const seen = ["ours", "theirs"].map((id) => {
                const { canvas } = document.getElementById(id).getContext("2d");
                const [left, top] = [share[0] * canvas.width - 8, share[1] * canvas.height - 8].map(Math.round);
                return [...canvas.getContext("2d").getImageData(left, top, 1, 1).data];
            });
            return [[last.ours, last.theirs].map(({ pixels }) => [...pixels.subarray(at, at + 4)]), seen];
        }, chosen);
        assert.deepEqual(seen, wanted);
        // A drag moves what is seen, not the camera.
        const corner = await page.evaluate(() => gnomon.page.view.corner);
        await page.mouse.move(box.x + 100, box.y + 100);
        await page.mouse.down();
        await page.mouse.move(box.x + 160, box.y + 100, { steps: 3 });
        await page.mouse.up();
        const moved = await page.evaluate(() => gnomon.page.view.corner);
        assert.ok(moved[0] < corner[0] && moved[1] === corner[1], `${corner} ${moved}`);
        assert.equal(await stateOf(page), state);
        await page.locator("#ours").focus();
        await press(page, "Shift+Z", 6);
        assert.equal(await page.textContent("#scale"), "1×");
        await page.click("#magnify");
        assert.equal(await page.textContent("#scale"), "2×");
        await page.screenshot({ path: join(screenshots, "magnified.png") });
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
            await page.waitForSelector("#pixel pre", { state: "attached" });
            // A phone's browser widens innerWidth with what is too wide.
            const wide = await page.evaluate(() => document.documentElement.scrollWidth);
            const room = page.viewportSize().width;
            assert.ok(wide <= room, `${name}: ${wide} > ${room}`);
            await page.screenshot({ path: join(screenshots, `${name}.png`), fullPage: true });
        });
    }
});

test("a link to the page has a preview", async () => {
    await open({}, async (page) => {
        const metas = await page.$$eval("meta[property^='og:']", (all) => Object.fromEntries(all.map((one) => [one.getAttribute("property"), one.content])));
        for (const name of ["og:title", "og:description", "og:image"])
            assert.ok(metas[name], name);
        const type = await page.evaluate(async (picture) => (await fetch(picture)).headers.get("content-type"), metas["og:image"]);
        assert.equal(type, "image/png");
    });
});

test("nothing moves while the page loads, nor when something is said", async () => {
    const before = () => {
        globalThis.shifts = [];
        new PerformanceObserver((list) => globalThis.shifts.push(...list.getEntries().map(({ value, sources }) =>
            `${value.toFixed(4)} ${sources.map(({ node }) => node?.id || node?.className || node?.nodeName).join()}`))).observe({ type: "layout-shift", buffered: true });
    };
    await open({ state: null, before }, async (page) => {
        assert.deepEqual(await page.evaluate(() => globalThis.shifts), []);
        const place = () => page.evaluate(() => document.getElementById("controls").getBoundingClientRect().top + scrollY);
        const was = await place();
        await page.evaluate(() => gnomon.restore("shader=velvet"));
        assert.match((await alerts(page)).join(), /velvet/);
        await page.selectOption("[name=size]", "384x288");
        await page.evaluate(() => gnomon.idle());
        assert.equal(await place(), was);
    });
});

// The files that sw.js keeps for use without a network.
function filesOfServiceWorker() {
    const [, list] = /const FILES = (\[[^\]]*\]);/.exec(readFileSync(join(folder, "sw.js"), "utf8"));
    return JSON.parse(list.replace(/,\s*\]$/, "]"));
}

test("a service worker isolates the page, and serves it without a network", async () => {
    const server = await serve(folder);
    const context = await newContext({ serviceWorkers: "allow" });
    try {
        const page = await context.newPage();
        await page.goto(server.origin + "/");
        await ready(page);
        assert.equal(await page.evaluate(() => crossOriginIsolated), false);
        await Promise.all([page.waitForNavigation(), page.click("#isolate")]);
        await ready(page);
        assert.equal(await page.evaluate(() => crossOriginIsolated), true);
        assert.equal(await hashOf(page), contract.get(await stateOf(page)));
        // The service worker keeps files one by one. This also fails if it names one that does not exist.
        const files = filesOfServiceWorker();
        const isKept = (wanted) => page.evaluate(async (all) => {
            const kept = await Promise.all(all.map((file) => caches.match(file)));
            return kept.every(Boolean);
        }, wanted);
        assert.equal(await isKept(["no such file"]), false);
        await until("the files of sw.js are not kept", () => isKept(files));
        await server.close();
        await page.reload();
        await ready(page);
        assert.equal(await hashOf(page), contract.get(await stateOf(page)));
        assert.equal(await page.getAttribute("#contract", "data-verdict"), "same");
    } finally {
        await context.close();
        await server.close().catch(() => {});
    }
});
