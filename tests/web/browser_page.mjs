// What the tests of the web page in a browser share: headless Chromium, servers of the page, and hands on
// an open page. The first argument of the command is the folder that `make web` has made, the second where
// screenshots go; both are taken off the arguments.
import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { setTimeout as pause } from "node:timers/promises";
import { chromium } from "playwright-core";
import { join } from "node:path";
import { serve } from "./server.mjs";

export const [folder, screenshots] = process.argv.splice(2, 2);

// Milliseconds to wait for anything at most. It ends tests that would wait for ever; it is far more than a
// slow and busy machine needs.
export const PATIENCE = 180000;

mkdirSync(screenshots, { recursive: true });

export const contract = new Map(
    readFileSync(join(folder, "pictures.txt"), "utf8")
        .split("\n")
        .filter((line) => /^[0-9a-f]{16}( |$)/.test(line))
        .map((line) => [line.slice(17), line.slice(0, 16)])
);

const browser = await chromium.launch({
    timeout: PATIENCE,
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: [
        "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
        "--disable-component-update", "--disable-sync", "--use-gl=angle", "--use-angle=swiftshader",
        "--enable-unsafe-swiftshader",
    ],
});
export const plain = await serve(folder);
export const isolated = await serve(folder, { isolated: true });

// A context of the browser that waits for as long as a slow machine needs.
export async function newContext(options) {
    const context = await browser.newContext(options);
    context.setDefaultTimeout(PATIENCE);
    return context;
}

// The address of a state. Without anything behind "#" the page begins with a picture that suits the window; state null
// is that.
const hashFor = (state) => (state === null ? "" : `#${state || "shader=phong"}`);

// Opens the page with a state, calls use(page), and checks that nothing was asked of other servers
// and that no program failed in silence.
export async function open({ state = "", server = isolated, before = null, options = {} }, use) {
    const context = await newContext({
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
    if (process.env.SLOWER)
        await (await context.newCDPSession(page)).send("Emulation.setCPUThrottlingRate", { rate: Number(process.env.SLOWER) });
    page.on("pageerror", (error) => broken.push(error.message));
    try {
        if (before)
            await page.addInitScript(before);
        await page.goto(`${server.origin}/${hashFor(state)}`);
        await ready(page);
        await use(page, context);
        assert.deepEqual(foreign, [], "requests to other servers");
        assert.deepEqual(broken, [], "errors that the page does not show");
    } finally {
        await context.close();
    }
}

export async function ready(page) {
    await page.waitForFunction(() => document.documentElement.dataset.ready === "yes");
    await settle(page);
}

export const hashOf = (page) => page.textContent("#hash");
export const stateOf = (page) => page.evaluate(() => gnomon.page.engine.state());
export const alerts = (page) => page.$$eval(".fault", (all) => all.map((one) => one.lastChild.textContent));

// Waits until the page has drawn what it was asked for, with the engine, the workers and the model that were
// asked for.
export const settle = (page) => page.evaluate(() => gnomon.idle());

// Waits until an asynchronous condition holds: for what page.waitForFunction cannot wait for, since a promise
// is true for it.
export async function until(what, condition) {
    const end = Date.now() + PATIENCE;
    while (!(await condition())) {
        assert.ok(Date.now() < end, `${what} after ${PATIENCE} ms`);
        await pause(50);
    }
}

// Waits until our picture's hash is none of these, and returns it.
export async function otherHash(page, hashes) {
    const found = await page.waitForFunction((known) => {
        const hash = document.getElementById("hash").textContent;
        return known.includes(hash) ? "" : hash;
    }, hashes);
    return found.jsonValue();
}

// Presses a key. The browser answers when the page has handled it; what the page draws then is waited for.
export async function press(page, key, times = 1) {
    for (let i = 0; i < times; ++i)
        await page.keyboard.press(key);
    await settle(page);
}

// Drops files, given as [name, text or base64 of an image], as a hand would.
export async function drop(page, files) {
    await page.evaluate(async (given) => {
        const data = new DataTransfer();
        for (const [name, text, base64] of given) {
            const bytes = base64 ? Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)) : text;
            data.items.add(new File([bytes], name));
        }
        document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
    }, files);
    await settle(page);
}

// A picture that is encoded by the browser, as base64. `colors` are rows of CSS colours.
export function png(page, colors, type = "image/png") {
    return page.evaluate(([rows, as]) => {
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
        return canvas.toDataURL(as).split(",")[1];
    }, [colors, type]);
}

// The bytes of our picture at a place, y from the bottom.
export const pixelAt = (page, x, y) =>
    page.evaluate(([px, py]) => {
        const { ours, width } = gnomon.page.last;
        return [...ours.pixels.slice(4 * (py * width + px), 4 * (py * width + px) + 4)];
    }, [x, y]);

export async function close() {
    await browser.close();
    await plain.close();
    await isolated.close();
}
