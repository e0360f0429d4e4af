// Tests the web page in headless Chromium: node tests/web/browser.mjs FOLDER SCREENSHOTS [NAME ...]
// FOLDER is what `make web` makes. A NAME is a part of the names of the tests to run. In the environment:
//   GNOMON      the command to compare with; build/gnomon if it is not set
//   SLOWER=10   makes the page's thread ten times slower, which shows tests that do not wait for what they test
import { close } from "./browser_page.mjs";
import "./browser_pictures.mjs";
import "./browser_models.mjs";
import "./browser_use.mjs";
import { run } from "./results.mjs";

await run();
await close();
