// The page: Gnomon's picture, WebGL's, and their difference. This file holds them together: the
// state, the loop that draws, and what is said about it.
import { attach } from "./camera.js";
import { judge, loadContract } from "./contract.js";
import { Controls } from "./controls.js";
import { compare, show } from "./difference.js";
import { Drawers } from "./drawers.js";
import { hasSimd } from "./engine.js";
import { copy, fault, say, words } from "./messages.js";
import { Pixels } from "./pixels.js";
import { canShare, Pool } from "./pool.js";
import { PRESETS } from "./presets.js";
import { joinHash, OWN_DEFAULTS, pairsOf, splitHash } from "./state.js";
import { WebGLRenderer } from "./webgl.js";

const MODULES = { simd: "gnomon-simd.wasm", plain: "gnomon.wasm", explain: "gnomon.wasm" };
const MAX_AUTOMATIC_THREADS = 8;
const URL_DELAY = 300; // milliseconds without a change until the address is changed
const SPEAK_DELAY = 1500; // until screen readers are told
const TURN_SPEED = 60; // pixels of the picture in a second

const $ = (id) => document.getElementById(id);

const page = {
    engine: null,
    pool: null,
    webgl: null,
    contract: null,
    model: null, // the dropped one
    own: { ...OWN_DEFAULTS },
    turning: false,
    isDirty: false,
    isDrawing: false,
    drawing: Promise.resolve(), // the picture that is being drawn
    last: null, // what was drawn last
    cursor: null, // the pixel cursor, [x, y]
};

const drawers = new Drawers(page, drawn, tellIdle);
const pixels = new Pixels(page, { module: MODULES.explain, drawn, chosen: writeUrl });

// ---- The state ----

function stateMap() {
    return new Map(pairsOf(page.engine.state()));
}

let urlTimer = 0;
function writeUrl() {
    clearTimeout(urlTimer);
    urlTimer = setTimeout(() => {
        const hash = joinHash(page.engine.state(), page.own);
        history.replaceState(null, "", hash === "" ? location.pathname + location.search : `#${hash}`);
    }, URL_DELAY);
}

function link() {
    const hash = joinHash(page.engine.state(), page.own);
    return location.href.replace(/#.*/, "") + (hash === "" ? "" : `#${hash}`);
}

function changed() {
    page.controls.show(stateMap(), page.own);
    if (!page.turning)
        writeUrl();
    redraw();
}

// Does something with the engine that changes the picture. Returns what is wrong, or "".
function change(action) {
    let text = "";
    try {
        action();
    } catch (error) {
        text = words(error);
    }
    fault("state", text);
    if (text === "")
        changed();
    return text;
}

function changeKey(key, value) {
    if (!Object.hasOwn(page.own, key))
        return change(() => page.engine.set(key, value));
    page.own[key] = value;
    if (key === "simd")
        startEngine().catch((error) => fault("engine", words(error)));
    else if (key === "threads")
        startPool();
    changed();
    return "";
}

// A state without its model, and without the camera that was chosen for it.
function withoutModel(picture) {
    const rest = pairsOf(picture).filter(([key]) => !["model", "eye", "target", "near", "far"].includes(key));
    return rest.map(([key, value]) => `${key}=${value}`).join("&");
}

// Takes the state of an address. Whatever is wrong with it is said, and the rest is used.
function readAddress(hash) {
    const { picture, own, faults } = splitHash(hash);
    Object.assign(page.own, own);
    try {
        const isAbsent = !page.model && pairsOf(picture).some(([, value]) => value === "dropped");
        if (isAbsent)
            faults.push("The address is of a model that was dropped on the page; drop it here, too.");
        page.engine.setState(isAbsent ? withoutModel(picture) : picture);
    } catch (error) {
        faults.push(`The address has a state that cannot be drawn: ${words(error)}.`);
    }
    fault("address", faults.join(" "));
}

// Shows the picture of an address.
async function restore(hash) {
    const { simd, threads } = page.own;
    readAddress(hash);
    changed();
    if (simd !== page.own.simd)
        await startEngine();
    else if (threads !== page.own.threads)
        await startPool();
    showPixelOfAddress();
}

// ---- Engines ----

function wantsSimd() {
    return page.own.simd === "on" || (page.own.simd === "auto" && hasSimd());
}

function wantedThreads() {
    if (page.own.threads !== "auto")
        return Number(page.own.threads);
    return canShare() ? Math.min(navigator.hardwareConcurrency || 1, MAX_AUTOMATIC_THREADS) : 1;
}

// Loads the module with or without SIMD, with the same state and model as before, and then its workers.
// If it is called again before its turn comes, the last call counts.
let enginesAsked = 0;
function startEngine() {
    const number = ++enginesAsked;
    return drawers.exchange(async () => {
        if (number !== enginesAsked)
            return;
        await drawers.useModule(MODULES[wantsSimd() ? "simd" : "plain"]);
        $("ours-name").textContent = `${page.engine.backend()}`;
        $("version").textContent = `Gnomon ${page.engine.version()}`;
        // The first picture does not wait for workers.
        if (!page.last)
            return;
        await exchangePool();
        redraw();
    });
}

// Starts the workers. The page's thread draws until they are ready, and if there are none. If it is called
// again before its turn comes, the last call counts.
let poolsAsked = 0;
function startPool() {
    const number = ++poolsAsked;
    return drawers.exchange(async () => {
        if (number === poolsAsked)
            await exchangePool();
    });
}

async function exchangePool() {
    const threads = wantedThreads();
    try {
        await drawers.useWorkers(threads);
        fault("workers", "");
        redraw();
    } catch (error) {
        fault("workers", `Workers cannot be used, so the page itself draws: ${words(error)}`);
    }
    tellThreads(threads);
}

function tellThreads(threads) {
    const count = page.pool instanceof Pool ? threads : 0;
    const plural = count === 1 ? "One worker draws." : `${count} workers draw`;
    $("isolate-row").hidden = canShare() || !("serviceWorker" in navigator);
    if (count === 0)
        $("threads-help").textContent = "The page’s own thread draws.";
    else if (canShare())
        $("threads-help").textContent = count === 1 ? plural : `${plural} bands of one picture in shared memory.`;
    else
        $("threads-help").textContent =
            (count === 1 ? plural : `${plural} bands of copies.`) +
            " This server does not send the headers (COOP, COEP) that shared memory needs.";
}

// ---- Drawing ----

const waiting = [];

function isIdle() {
    return !page.isDirty && !page.isDrawing && drawers.isIdle();
}

// Resolves when everything asked for has been drawn, by the engine, the workers and the model asked for.
function idle() {
    return isIdle() ? Promise.resolve() : new Promise((resolve) => waiting.push(resolve));
}

function tellIdle() {
    if (isIdle())
        waiting.splice(0).forEach((resolve) => resolve());
}

// Resolves when the picture that is being drawn is done; no other is begun before the next frame.
function drawn() {
    return page.drawing.catch(() => {});
}

function redraw() {
    page.isDirty = true;
    if (!page.isDrawing)
        drawAll();
}

// Draws as long as something has changed since.
async function drawAll() {
    page.isDrawing = true;
    while (page.isDirty) {
        page.isDirty = false;
        try {
            page.drawing = drawOnce();
            await page.drawing;
            fault("drawing", "");
        } catch (error) {
            page.turning = false;
            showTurning();
            fault("drawing", `Gnomon cannot draw this: ${words(error)}`);
        }
        if (page.turning || page.isDirty)
            await new Promise(requestAnimationFrame);
        if (page.turning)
            turnOn();
    }
    page.isDrawing = false;
    tellIdle();
}

function drawByWebGL(description) {
    if (!page.webgl)
        return null;
    try {
        // The browser may take a context away, for example while the machine sleeps.
        if (page.webgl.isLost())
            page.webgl = new WebGLRenderer();
        const drawn = page.webgl.draw(description, page.engine.memory);
        fault("webgl", "");
        return drawn;
    } catch (error) {
        fault("webgl", `WebGL cannot draw this: ${words(error)}`);
        return null;
    }
}

async function drawOnce() {
    const { engine, pool } = page;
    engine.build();
    const description = engine.describe();
    const state = engine.state();
    const { width, height } = description;

    // WebGL first: it reads the engine's memory, which may change while workers draw.
    const theirs = drawByWebGL(description);
    const ours = await pool.draw(state, width, height);

    page.last = { state, width, height, clear: description.clear, ours, theirs, hash: "" };
    page.last.hash = engine.hash(ours.pixels, width, height);
    show($("ours"), ours.pixels, width, height);
    if (theirs)
        show($("theirs"), theirs.pixels, width, height);
    showDifference();
    showVerdict();
    showTimes();
    pixels.showCursor();
    pixels.noteStale();
}

function showDifference() {
    const { last } = page;
    const { width, height, ours, theirs } = last;
    if (!theirs) {
        for (const id of ["differing", "coverage", "largest"])
            $(id).textContent = "–";
        last.counts = null;
        return;
    }
    const clear = last.clear.map((c) => Math.round(c * 255));
    last.counts = compare(ours.pixels, theirs.pixels, clear, Number(page.own.magnify));
    show($("difference"), last.counts.pixels, width, height);

    const { differing, coverage, largest } = last.counts;
    const number = (n) => n.toLocaleString("en");
    const share = document.createElement("small");
    share.textContent = ` of ${number(width * height)}`;
    $("differing").replaceChildren(number(differing), share);
    $("coverage").textContent = number(coverage);
    $("largest").textContent = number(largest);
    if (!page.turning)
        say(
            differing === 0
                ? "No pixel differs."
                : `${number(differing)} pixels differ; ${number(coverage)} are drawn by one alone; the largest step is ${largest}.`,
            SPEAK_DELAY
        );
}

function showVerdict() {
    const { verdict, text } = judge(page.contract, page.last.state, page.last.hash);
    $("hash").textContent = page.last.hash;
    if ($("contract").dataset.verdict !== verdict || $("contract").textContent !== text) {
        $("contract").dataset.verdict = verdict;
        $("contract").textContent = text;
    }
    fault("contract", verdict === "different" ? text : "");
}

function timeWords({ milliseconds }) {
    const rate = 1000 / Math.max(milliseconds, 0.1);
    return `${milliseconds.toFixed(1)} ms, ${rate >= 10 ? Math.round(rate) : rate.toFixed(1)} frames a second`;
}

function showTimes() {
    const { ours, theirs } = page.last;
    $("ours-time").textContent = timeWords(ours);
    $("theirs-time").textContent = theirs ? timeWords(theirs) : "not drawn";
}

// ---- Turning ----

let turnedAt = 0;
let turnRest = 0;

function turnOn() {
    const now = performance.now();
    turnRest += (Math.min(now - turnedAt, 100) * TURN_SPEED) / 1000;
    turnedAt = now;
    const steps = Math.trunc(turnRest);
    turnRest -= steps;
    if (steps > 0)
        page.engine.turn(steps, 0);
    page.isDirty = true;
}

function showTurning() {
    $("turn").setAttribute("aria-pressed", String(page.turning));
    $("turn").textContent = page.turning ? "Pause" : "Turn";
}

function toggleTurning() {
    page.turning = !page.turning;
    turnedAt = performance.now();
    showTurning();
    if (!page.turning)
        writeUrl();
    redraw();
}

// ---- The hand on the pictures ----

const hand = {
    turn: (right, down) => change(() => page.engine.turn(right, down)),
    pan: (right, down) => change(() => page.engine.pan(right, down)),
    zoom: (steps) => change(() => page.engine.zoom(steps)),
    choose: (x, y) => pixels.explain(x, y),
    hasCursor: () => pixels.cursorIsOn,
    toggleCursor: () => pixels.toggleCursor(),
    cursor: (arrow, isFast) => pixels.moveCursor(arrow, isFast),
};

// ---- Models ----

function takeFiles(files) {
    return drawers.exchange(() => useFiles(files));
}

async function useFiles(files) {
    if (files.length === 0)
        return;
    const report = $("model-report");
    report.textContent = `Reading ${files.map((file) => file.name).join(", ")} …`;
    try {
        const { describeModel, readModel } = await import("./model.js");
        const engine = await drawers.createEngine();
        const model = await readModel(engine, files);
        await drawers.useModel(model, engine);
        page.controls.nameDropped(model.about.name);
        report.replaceChildren(...describeModel(model));
        fault("model", "");
        change(() => {
            page.engine.set("model", "dropped");
            for (const key of ["eye", "target", "near", "far"])
                page.engine.set(key, "");
        });
    } catch (error) {
        report.replaceChildren();
        fault("model", `The model cannot be used. ${words(error)}`);
        redraw();
    }
}

// ---- The beginning ----

function listen() {
    for (const id of ["ours", "theirs", "difference"])
        attach($(id), hand);
    for (const { name, state } of PRESETS)
        $("preset").add(new Option(name, state));
    $("preset").onchange = ({ target }) => {
        if (target.value !== "")
            change(() => page.engine.setState(target.value));
        target.value = "";
    };
    $("turn").onclick = toggleTurning;
    $("reset").onclick = () => {
        page.turning = false;
        showTurning();
        page.own.pixel = "";
        page.cursor = null;
        change(() => page.engine.setState(""));
    };
    $("copy-link").onclick = async ({ target }) => {
        if (await copy(link(), "The link")) {
            target.textContent = "Copied";
            setTimeout(() => (target.textContent = "Copy link"), 1500);
        }
    };
    $("isolate").onclick = isolate;
    $("files").onchange = ({ target }) => takeFiles([...target.files]);
    $("pixel-form").onsubmit = (event) => {
        event.preventDefault();
        pixels.explain($("pixel-x").valueAsNumber || 0, $("pixel-y").valueAsNumber || 0);
    };
    addEventListener("dragover", (event) => {
        event.preventDefault();
        document.body.classList.add("dropping");
    });
    addEventListener("dragleave", (event) => {
        if (event.relatedTarget === null)
            document.body.classList.remove("dropping");
    });
    addEventListener("drop", (event) => {
        event.preventDefault();
        document.body.classList.remove("dropping");
        takeFiles([...event.dataTransfer.files]);
    });
    // location.hash may be another one again: the address of the state before is written with a delay.
    addEventListener("hashchange", ({ newURL }) => restore(new URL(newURL).hash));
}

// Pages that a service worker serves have the headers that shared memory needs.
async function isolate() {
    try {
        await navigator.serviceWorker.register("sw.js");
        await navigator.serviceWorker.ready;
        location.reload();
    } catch (error) {
        fault("workers", `The service worker cannot be installed: ${words(error)}`);
    }
}

function showPixelOfAddress() {
    if (page.own.pixel !== "")
        pixels.explain(...page.own.pixel.split(",").map(Number));
}

function startWebGL() {
    try {
        page.webgl = new WebGLRenderer();
        $("theirs-name").textContent = page.webgl.name();
        $("theirs-name").title = page.webgl.name();
    } catch (error) {
        $("theirs-name").textContent = "not available";
        fault("webgl", `There is nothing to compare with: ${words(error)}.`);
    }
}

async function begin() {
    page.controls = new Controls($("controls"), changeKey);
    page.own = splitHash(location.hash).own;
    await startEngine();
    readAddress(location.hash);
    page.controls.show(stateMap(), page.own);
    listen();
    // The first picture, by this thread: WebGL, workers and whatever else is loaded come later.
    redraw();
    await idle();
    document.documentElement.dataset.firstPicture = performance.now().toFixed(0);
    await new Promise(requestAnimationFrame);
    startWebGL();
    redraw();
    await idle();

    const contract = loadContract("pictures.txt")
        .then((hashes) => {
            page.contract = hashes;
            if (page.last)
                showVerdict();
        })
        .catch((error) => fault("contract-file", `The contract cannot be read: ${words(error)}`));
    await Promise.all([contract, startPool()]);
    await idle();
    document.documentElement.dataset.ready = "yes";
    showPixelOfAddress();
    // For the next visit, also without a network.
    if ("serviceWorker" in navigator && isSecureContext)
        navigator.serviceWorker.register("sw.js").catch(() => console.info("no service worker: offline use is not prepared"));
}

// For tests, and for the browser's console.
globalThis.gnomon = { page, idle, link, restore, takeFiles };

begin().catch((error) => fault("begin", `The page cannot begin: ${words(error)}`));
