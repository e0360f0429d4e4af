// Opens the lessons' pages in headless Chromium. The picture is the native lesson's, pixel by pixel; keys
// move a slider and change it; the sliders' lines are found in the source; nothing is asked of another
// server; nothing is wider than a phone; what goes wrong is shown. Pages are answered from disk.
// usage: node lessons_browser.mjs BUILD-DIRECTORY [SCREENSHOTS]   playwright-core is found along NODE_PATH
import assert from "node:assert/strict";
import * as fs from "node:fs";
import { createRequire } from "node:module";
import * as path from "node:path";

const { chromium } = createRequire(import.meta.url)("playwright-core");
const [build, screenshots] = process.argv.slice(2);
const pages = path.join(build, "web/lessons");
const natives = path.join(build, "web-lessons/native"); // from lessons.mjs
const origin = "http://lessons.test";
const names = fs.readdirSync(pages).filter((name) => /^\d\d_.*\.html$/.test(name)).map((name) => name.slice(0, -5));
const patience = 180000; // milliseconds to wait for anything: ends what would hang, never what is slow
let passed = 0, failed = 0;

const browser = await chromium.launch({
    timeout: patience,
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
        "--disable-component-update", "--disable-sync"],
});

// Opens a page, waits until the lesson has run or has failed, and calls body(page). `answers` takes the place
// of files: path -> what route.fulfill takes.
async function test(what, name, body, { answers = {}, before = null, ...options } = {}) {
    const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
    context.setDefaultTimeout(patience);
    const wrong = [];
    await context.route("**/*", (route) => {
        const url = new URL(route.request().url());
        const file = path.join(build, "web", url.pathname);
        if (url.origin !== origin)
            wrong.push(`request to ${url}`);
        if (url.pathname in answers)
            return route.fulfill(answers[url.pathname]);
        if (url.origin !== origin || !fs.existsSync(file)) {
            wrong.push(`no file for ${url}`);
            return route.fulfill({ status: 404, body: "" });
        }
        return route.fulfill({ path: file });
    });
    const page = await context.newPage();
    page.on("pageerror", (error) => wrong.push(error.message));
    page.on("console", (message) => {
        if (message.type() === "error" && !Object.keys(answers).length)
            wrong.push(message.text());
    });
    try {
        if (before)
            await page.addInitScript(before);
        await page.goto(`${origin}/lessons/${name}.html`);
        if (/^\d\d_/.test(name) && options.javaScriptEnabled !== false)
            await page.waitForFunction(() => document.getElementById("state").hidden);
        await body(page);
        assert.deepEqual(wrong, []);
        ++passed;
    } catch (error) {
        ++failed;
        console.log(`FAILED: ${what}: ${String(error.stack).split("\n").slice(0, 6).join("\n    ")}`);
    } finally {
        await context.close();
    }
}

// The canvas's bytes, red, green, blue, from the top row on.
async function canvasBytes(page) {
    const [width, height, text] = await page.evaluate(() => {
        const canvas = document.getElementById("picture");
        const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
        let text = "";
        for (let i = 0; i < data.length; i += 4)
            text += String.fromCharCode(data[i], data[i + 1], data[i + 2]);
        return [canvas.width, canvas.height, btoa(text)];
    });
    return { width, height, rgb: Buffer.from(text, "base64") };
}

// The same of a TGA as lessons write it.
function tgaBytes(file) {
    const tga = fs.readFileSync(file);
    const width = tga.readUInt16LE(12), height = tga.readUInt16LE(14);
    const rgb = Buffer.alloc(3 * width * height);
    for (let y = 0; y < height; ++y)
        for (let x = 0; x < width; ++x)
            for (let c = 0; c < 3; ++c)
                rgb[3 * (y * width + x) + c] = tga[18 + 3 * ((height - 1 - y) * width + x) + 2 - c];
    return { width, height, rgb };
}

const text = (page, selector) => page.locator(selector).textContent();
// The browser answers a key when the page has handled it; the lesson runs again in the next frame.
const frames = (page) => page.evaluate(() =>
    new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(resolve, 0)))));
const seen = async (page) => await page.locator("#picture").count() ?
    (await canvasBytes(page)).rgb.toString("latin1") + await text(page, "#printed") : text(page, "#printed");
const keep = async (page, name) => {
    if (screenshots)
        await page.screenshot({ path: path.join(screenshots, `${name}.png`) });
};

if (screenshots)
    fs.mkdirSync(screenshots, { recursive: true });

for (const name of names) {
    await test(`${name}: picture and sliders`, name, async (page) => {
        const tga = path.join(natives, `${name}.tga`);
        if (await page.locator("#picture").count()) {
            const drawn = await canvasBytes(page), native = tgaBytes(tga);
            assert.equal(`${drawn.width}x${drawn.height}`, `${native.width}x${native.height}`);
            assert.ok(drawn.rgb.equals(native.rgb), "the picture is not the native lesson's");
        } else {
            const shown = /```text\n([^]*?)```/.exec(fs.readFileSync(`tools/examples/${name}.md`, "utf8"))[1];
            assert.equal(await text(page, "#printed"), shown);
        }
        assert.equal(await text(page, "#error"), "");
        const first = await seen(page);
        const sliders = page.locator("#sliders input");
        const count = await sliders.count();
        assert.ok(count === 2 || count === 3, `${count} sliders`);
        for (let i = 0; i < count; ++i) {
            const slider = sliders.nth(i);
            const label = await text(page, `label[for=slider-${i}]`);
            await slider.focus();
            assert.match(await page.locator(".line.current").textContent(), new RegExp(`"${label}"`));
            const value = await slider.inputValue();
            // Some steps up; down if the slider is at its upper end.
            await page.keyboard.press("PageUp");
            if (await slider.inputValue() === value)
                await page.keyboard.press("PageDown");
            await frames(page);
            assert.notEqual(await slider.inputValue(), value);
            assert.equal(await text(page, `.slider:nth-child(${i + 1}) .value`), await slider.inputValue());
        }
        assert.notEqual(await seen(page), first, "the sliders change nothing");
        await keep(page, `lesson-${name}`);
        await page.locator("#sliders button").focus();
        await page.keyboard.press("Enter");
        await frames(page);
        assert.equal(await seen(page), first, "the first values do not bring the first picture back");
    });
    await test(`${name}: at the width of a phone, in the dark`, name, async (page) => {
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "wider than the phone");
        const [paper, ink] = await page.evaluate(() => {
            const style = getComputedStyle(document.documentElement);
            return [style.backgroundColor, style.color].map((color) => Number(/\d+/.exec(color)[0]));
        });
        assert.ok(paper < 60 && ink > 180, `paper ${paper}, ink ${ink}`);
        await keep(page, `lesson-phone-${name}`);
    }, { viewport: { width: 360, height: 740 }, colorScheme: "dark" });
}

await test("list of lessons", "index", async (page) => {
    const links = await page.locator(".lessons a").evaluateAll((all) => all.map((a) => a.getAttribute("href")));
    assert.deepEqual(links, names.map((name) => `${name}.html`));
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    await keep(page, "lessons");
}, { viewport: { width: 360, height: 740 } });

await test("links lead to pages, or to places in them", "index", async (page) => {
    for (const file of fs.readdirSync(pages).filter((name) => name.endsWith(".html"))) {
        await page.goto(`${origin}/lessons/${file}`);
        const dead = await page.evaluate(() => [...document.querySelectorAll("a[href^='#']")]
            .map((a) => a.getAttribute("href")).filter((href) => !document.getElementById(href.slice(1))));
        const others = await page.locator("a:not([href^='#'])").evaluateAll((all) => all.map((a) => a.getAttribute("href")));
        // The page above is another target's.
        dead.push(...others.filter((href) => href !== "../index.html" && !fs.existsSync(path.join(pages, href))));
        assert.deepEqual(dead, [], file);
    }
});

await test("everything is reached by the Tab key", "20_point", async (page) => {
    const reached = new Set();
    for (let i = 0; i < 60; ++i) {
        await page.keyboard.press("Tab");
        reached.add(await page.evaluate(() => {
            const e = document.activeElement;
            return e.id || e.getAttribute("aria-label") || e.textContent.trim();
        }));
    }
    for (const what of ["To the lesson", "Gnomon", "slider-0", "slider-1", "slider-2", "As in the text", "input", "printed",
        "C source, 161 lines", "21. A microcontroller →"])
        assert.ok([...reached].some((name) => name === what || /^C source/.test(what) && /^C source, \d+ lines$/.test(name)),
            `${what} is not reached: ${[...reached].join(", ")}`);
});

await test("the address brings a picture back", "13_phong", async (page) => {
    await page.locator("#slider-2").focus();
    await page.keyboard.press("PageUp");
    await frames(page);
    await page.waitForURL(/\?turn\+of\+the\+light=0\.6/, { waitUntil: "commit" });
    const sent = page.url(), picture = await seen(page);
    await page.goto("about:blank");
    await page.goto(sent);
    await page.waitForFunction(() => document.getElementById("state").hidden);
    assert.equal(await seen(page), picture);
    await page.goto(`${origin}/lessons/13_phong.html?turn+of+the+light=north&nothing=1&strength+of+the+highlight=1e99`);
    await page.waitForFunction(() => document.getElementById("state").hidden);
    assert.equal(await text(page, "#error"), "");
    assert.equal(await page.locator("#slider-1").inputValue(), "1");
});

await test("a hundred runs need no more memory than the browser has", "16_shadow_map", async (page) => {
    const slider = page.locator("#slider-2");
    await slider.focus();
    for (let i = 0; i < 100; ++i) {
        await slider.evaluate((range, i) => {
            range.value = Math.sin(i);
            range.dispatchEvent(new Event("input"));
        }, i);
        await frames(page);
        assert.equal(await text(page, "#error"), "");
    }
});

await test("20_point: its input, and an error in it", "20_point", async (page) => {
    await page.fill("#input", "screen 100 100\npoint 0 0 0\n");
    await frames(page);
    assert.match(await text(page, "#printed"), /pixel +50 +50 /);
    await page.fill("#input", "walk\n");
    await frames(page);
    assert.match(await text(page, "#error"), /line 1: no known word/);
    await page.fill("#input", "");
    await frames(page);
    assert.equal(await text(page, "#error"), "");
});

const missing = { status: 404, body: "" };
await test("a model that the server lacks is named", "02_wireframe", async (page) => {
    assert.equal(await text(page, "[role=alert]"), "models/teapot.obj could not be loaded: the server answered 404.");
    assert.ok(await page.locator("[role=alert]").isVisible());
}, { answers: { "/lessons/models/teapot.obj": missing } });
await test("a model that is broken is named", "02_wireframe", async (page) => {
    assert.match(await text(page, "[role=alert]"), /teapot\.obj: a face names a vertex that is not there, line 1/);
}, { answers: { "/lessons/models/teapot.obj": { body: "f 1 2 3\n" } } });
await test("a module that the server lacks is named", "02_wireframe", async (page) => {
    assert.match(await text(page, "[role=alert]"), /^lessons-simd\.wasm could not be loaded/);
}, { answers: { "/lessons/lessons-simd.wasm": missing } });
await test("a module that is none is an error that is shown", "02_wireframe", async (page) => {
    assert.match(await text(page, "[role=alert]"), /WebAssembly/);
}, { answers: { "/lessons/lessons-simd.wasm": { body: "no module" } } });
await test("a browser without WebAssembly is told so", "02_wireframe", async (page) => {
    assert.match(await text(page, "[role=alert]"), /no WebAssembly/);
}, { before: () => { delete globalThis.WebAssembly; } });
await test("a browser without SIMD gets the other module, and the same picture", "13_phong", async (page) => {
    assert.ok((await canvasBytes(page)).rgb.equals(tgaBytes(path.join(natives, "13_phong.tga")).rgb));
}, { before: () => { WebAssembly.validate = () => false; }, answers: { "/lessons/lessons-simd.wasm": missing } });
await test("a reader without JavaScript sees the text and a picture", "13_phong", async (page) => {
    assert.ok(await page.locator("noscript img, .stage img").first().isVisible());
    assert.match(await text(page, "#state"), /needs JavaScript/);
}, { javaScriptEnabled: false });

await browser.close();
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed > 0 || names.length !== 21 ? 1 : 0);
