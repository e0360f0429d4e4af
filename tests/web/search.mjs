// Tests the search of the documentation's site in headless Chromium, from disk: node tests/web/search.mjs FOLDER
// FOLDER is what `make docs` makes.
import assert from "node:assert/strict";
import { resolve } from "node:path";
import { chromium } from "playwright-core";
import { run, test } from "./results.mjs";

const [folder] = process.argv.splice(2, 1);
const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-background-networking"],
});
const page = await browser.newPage({ viewport: { width: 1200, height: 800 } });

const open = (name) => page.goto(`file://${resolve(folder)}/${name}`);

// The texts and addresses of the links that a query finds, by list.
async function find(query) {
    await page.fill("#search input", query);
    await page.waitForFunction(() => globalThis.searchIndex);
    return page.$$eval("#found ul", (lists) =>
        lists.map((list) => [...list.querySelectorAll("a")].map((link) => [link.textContent, link.getAttribute("href")])));
}

test("the guide, the lessons and names are found by words anywhere in them", async () => {
    await open("index.html");
    const [byHeading] = await find("z-buffer");
    assert.ok(byHeading.slice(0, 4).some(([text]) => text.startsWith("6. The z-buffer")), byHeading.join("\n"));
    const [byText] = await find("guard band dithers");
    assert.ok(byText.length > 0);
    const [pages, names] = await find("scissor");
    assert.ok(pages.some(([, address]) => address.startsWith("tools_guide_")));
    assert.ok(names.some(([text]) => text === "gn_scissor"));
    // Not from the first letter of the name alone.
    const [, within] = await find("look_at");
    assert.ok(within.some(([text]) => text === "gn_look_at_rh"), within.join("\n"));
    for (const hostile of ["(", "[a", "\\", "*+?", "<b>"])
        await find(hostile);
    assert.deepEqual(await find("zzzqqq"), []);
    assert.match(await page.textContent("#found"), /Nothing has this word/);
    assert.deepEqual(await find(""), []);
});

test("Enter opens the best result, / begins a search, Escape ends it", async () => {
    await open("tools_guide_threads.html");
    assert.equal(await page.textContent("#menu [aria-current]"), "Threads");
    await page.keyboard.press("/");
    await page.keyboard.type("gn_resolve");
    await page.waitForSelector("#found a");
    await page.keyboard.press("Escape");
    assert.equal(await page.locator("#found a").count(), 0);
    assert.ok(await page.isVisible("#menu .home"));
    await page.keyboard.type("memory");
    await page.waitForSelector("#found a");
    assert.ok(!(await page.isVisible("#menu .home")));
    const first = await page.getAttribute("#found a", "href");
    await Promise.all([page.waitForURL(`**/${first}`), page.keyboard.press("Enter")]);
    assert.match(await page.title(), /Memory/);
});

test("the current page is in view in the menu", async () => {
    await open("CHANGELOG.html");
    const [link, menu] = await page.evaluate(() =>
        ["#menu [aria-current]", "#menu"].map((name) => document.querySelector(name).getBoundingClientRect().toJSON()));
    assert.ok(link.top >= menu.top && link.bottom <= menu.bottom, JSON.stringify([link, menu]));
});

await run();
await browser.close();
