// Tests the web page in headless Chromium: node tests/web/browser.mjs FOLDER SCREENSHOTS [NAME ...]
// FOLDER is what `make web` makes. A NAME is a part of the names of the tests to run. With SLOWER=10
// in the environment the page's thread is ten times slower, which shows tests that do not wait for what they test.
import { close } from "./browser_page.mjs";
import "./browser_pictures.mjs";
import "./browser_models.mjs";
import "./browser_use.mjs";
import { run } from "./results.mjs";

await run();
await close();
