// Runs every lesson in the modules of the lessons' pages, with SIMD and without. With its sliders as the
// text has them a lesson's picture and text equal, byte for byte, those of the native program. Each
// slider changes something. With every slider at either end, or where the reader could not put it, the lesson
// ends as it should, in time.
// usage: node lessons.mjs BUILD-DIRECTORY   (from the root of the project; `make lessons web-lessons` first); leaves the
// native pictures in BUILD-DIRECTORY/web-lessons/native
import {spawnSync} from "node:child_process";
import * as fs from "node:fs";
import * as os from "node:os";
import * as path from "node:path";
import {gzipSync} from "node:zlib";

import {runLesson} from "../../tools/web-lessons/lesson_run.js";

const build = path.resolve(process.argv[2]);
const pages = path.join(build, "web/lessons");
const models = path.join(pages, "models");
const names = fs.readdirSync("tools/examples").filter((name) => /^\d\d_.*\.c$/.test(name)).map((name) => name.slice(0, -2)).sort();
const files = new Map(fs.readdirSync(models).map((name) =>
    [`build/examples/${name}`, fs.readFileSync(path.join(models, name))]));
const longest = 300000; // milliseconds of one run: ends what goes on and on, never what is slow
const largest = 275000; // bytes of a compressed module: what a page may cost before it runs
let passed = 0, failed = 0;

function result(what, holds, detail = "") {
    if (holds) {
        ++passed;
    } else {
        ++failed;
        console.log(`FAILED: ${what} ${detail}`);
    }
}

const equal = (a, b) => a !== null && b !== null && Buffer.compare(Buffer.from(a), Buffer.from(b)) === 0;
const outputs = (run) => `${run.printed}\n${run.tga ? Buffer.from(run.tga).toString('latin1') : ''}`;

// Runs a native lesson in a directory of its own; returns its text and its picture.
function runNative(name, input = "") {
    const work = fs.mkdtempSync(path.join(os.tmpdir(), "lessons-"));
    try {
        fs.mkdirSync(path.join(work, "build/examples"), {recursive: true});
        for (const [file, bytes] of files)
            fs.writeFileSync(path.join(work, file), bytes);
        const run = spawnSync(path.join(build, "examples", name), {cwd: work, input, encoding: "utf8"});
        const picture = path.join(work, `build/examples/${name}.tga`);
        return {status: run.status, printed: run.stdout, errors: run.stderr,
            tga: fs.existsSync(picture) ? fs.readFileSync(picture) : null};
    } finally {
        fs.rmSync(work, {recursive: true});
    }
}

// Runs a lesson, and says so if it traps, fails or takes too long.
function run(what, module, number, options) {
    const began = performance.now();
    try {
        const lesson = runLesson(module, number, {files, ...options});
        const time = performance.now() - began;
        result(`${what}: ends well`, lesson.status === 0 && lesson.errors === "", `status ${lesson.status}: ${lesson.errors}`);
        result(`${what}: in time`, time < longest, `${time} ms`);
        return lesson;
    } catch (error) {
        result(`${what}: ends well`, false, error.message);
        return null;
    }
}

function testLesson(form, module, name, native) {
    const number = parseInt(name, 10);
    const plain = run(`${form} ${name}`, module, number, {});
    if (!plain)
        return;
    result(`${form} ${name}: prints what the native lesson prints`, plain.printed === native.printed);
    result(`${form} ${name}: draws what the native lesson draws`,
        native.tga ? equal(plain.tga, native.tga) : plain.tga === null && plain.printed !== "");
    result(`${form} ${name}: two or three sliders`, plain.sliders.length === 2 || plain.sliders.length === 3);

    const asked = fs.readFileSync(`tools/examples/${name}.c`, "utf8").match(/lesson_slider(_int)?\("/g) || [];
    result(`${form} ${name}: each slider stands in one line of the source`, asked.length === plain.sliders.length);
    const page = fs.readFileSync(path.join(pages, `${name}.html`), "utf8");
    result(`${form} ${name}: its page marks these lines`,
        (page.match(/<span class="line slider"/g) || []).length === plain.sliders.length);

    const ends = {least: new Map(), most: new Map()};
    for (const slider of plain.sliders) {
        const what = `${form} ${name}, ${slider.name}`;
        result(`${what}: begins within its range`, slider.least <= slider.first && slider.first <= slider.most &&
            slider.least < slider.most && slider.value === slider.first);
        const seen = new Set([outputs(plain)]);
        for (const end of ["least", "most"]) {
            ends[end].set(slider.name, slider[end]);
            if (form !== "simd") // the slower module is spared what does not depend on it
                continue;
            const moved = run(`${what} at ${slider[end]}`, module, number, {moved: new Map([[slider.name, slider[end]]])});
            if (moved)
                seen.add(outputs(moved));
        }
        if (form === "simd")
            result(`${what}: changes what is seen`, seen.size > 1);
    }
    for (const end of ["least", "most"])
        run(`${form} ${name}, all sliders at their ${end}`, module, number, {moved: ends[end]});
    for (const value of [NaN, -Infinity, 1e30])
        run(`${form} ${name}, all sliders at ${value}`, module, number,
            {moved: new Map(plain.sliders.map((slider) => [slider.name, value]))});
}

function throws(act) {
    try {
        act();
        return false;
    } catch {
        return true;
    }
}

// What the page must be able to tell the reader.
function testFaults(form, module) {
    const none = runLesson(module, 2);
    result(`${form}: a model that is absent`, none.status === 1 && none.tga === null &&
        none.errors === "build/examples/teapot.obj: cannot be opened\n", none.errors);
    const broken = runLesson(module, 2, {files: new Map([["build/examples/teapot.obj", Buffer.from("v 0 0 0\nf 1 2 3\n")]])});
    result(`${form}: a model that is broken`, broken.status === 1 && /not there, line 2\n$/.test(broken.errors), broken.errors);
    result(`${form}: no such lesson`, runLesson(module, 99).status === 2);
    const setup = "screen 800 600\nrotate 0 1 0 30\nposition 0 1 3\npoint 1 0 0\n";
    const way = runLesson(module, 20, {input: setup}), native = runNative("20_point", setup);
    result(`${form}: 20_point reads its input`, way.printed === native.printed && way.printed.includes("pixel"));
    const wrong = runLesson(module, 20, {input: "walk 1 2 3\n"});
    result(`${form}: 20_point with a wrong word`, wrong.status === 2 && /line 1/.test(wrong.errors));
    result(`${form}: a file too many is no silence`, throws(() =>
        runLesson(module, 2, {files: new Map(Array.from({length: 9}, (_, i) => [`file ${i}`, Buffer.from("x")]))})));
}

// lessons_browser.mjs compares with these pictures.
const pictures = path.join(build, "web-lessons/native");
fs.rmSync(pictures, {recursive: true, force: true});
fs.mkdirSync(pictures, {recursive: true});
const native = new Map();
for (const name of names) {
    const run = runNative(name);
    result(`native ${name}: ends well`, run.status === 0, run.errors);
    native.set(name, run);
    if (run.tga)
        fs.writeFileSync(path.join(pictures, `${name}.tga`), run.tga);
}

for (const [form, file] of [["plain", "lessons.wasm"], ["simd", "lessons-simd.wasm"]]) {
    const code = fs.readFileSync(path.join(pages, file));
    const module = new WebAssembly.Module(code);
    result(`${file}: no imports`, WebAssembly.Module.imports(module).length === 0);
    const size = gzipSync(code, {level: 9}).length;
    result(`${file}: at most ${largest} bytes compressed`, size <= largest, `${size}`);
    console.log(`${file}: ${code.length} bytes, ${size} compressed`);
    for (const name of names)
        testLesson(form, module, name, native.get(name));
    testFaults(form, module);
}
result("lessons: 21", names.length === 21);
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed > 0 ? 1 : 0);
