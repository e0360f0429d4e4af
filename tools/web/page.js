// The page: Gnomon's picture, WebGL's, and their difference. This file holds them together: the
// state, the loop that draws, and what is said about it.
import { attach } from "./camera.js";
import { loadContract } from "./contract.js";
import { Controls } from "./controls.js";
import { Drawers } from "./drawers.js";
import { hasSimd } from "./engine.js";
import { showDifference, showTimes, showVerdict } from "./found.js";
import { copy, fault, say, words } from "./messages.js";
import { Pixels } from "./pixels.js";
import { canShare, Pool } from "./pool.js";
import { PRESETS } from "./presets.js";
import { joinHash, OWN_DEFAULTS, pairsOf, splitHash, withFrame } from "./state.js";
import { sizeFor, View } from "./view.js";
import { WebGLRenderer } from "./webgl.js";

const MODULES = { simd: "gnomon-simd.wasm", plain: "gnomon.wasm", explain: "gnomon.wasm" };
const MAX_AUTOMATIC_THREADS = 8;
const URL_DELAY = 300; // milliseconds without a change until the address is changed
const SINGLE_PIXEL = 32; // magnified so far, a picture shows what its pixel under the pointer is made of
const ARRIVE_DELAY = 400; // milliseconds without a change until it does
const TURN_SPEED = 60; // pixels of the picture in a second

const $ = (id) => document.getElementById(id);

const page = {
    engine: null,
    pool: null,
    webgl: null,
    contract: null,
    model: null, // the dropped one
    initial: "", // the state that it begins with
    view: null,
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
        history.replaceState(null, "", `#${joinHash(page.engine.state(), page.own)}`);
    }, URL_DELAY);
}

function link() {
    return `${location.href.replace(/#.*/, "")}#${joinHash(page.engine.state(), page.own)}`;
}

function changed() {
    page.controls.show(stateMap(), page.own);
    if (!page.turning)
        writeUrl();
    redraw();
}

// Does something with the engine that changes the picture. Returns what is wrong, or "".
function tryChange(action) {
    try {
        action();
    } catch (error) {
        return words(error);
    }
    changed();
    return "";
}

// The same, and says what is wrong.
function change(action) {
    page.controls.last = null;
    fault("state", tryChange(action));
}

// The control that was changed says what is wrong.
function changeKey(key, value) {
    fault("state", "");
    if (!Object.hasOwn(page.own, key))
        return tryChange(() => page.engine.set(key, value));
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
    if (hash.replace(/^#/, "") === "") {
        page.engine.setState(page.initial);
        fault("address", "");
        return;
    }
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
            // The control that was changed last has caused it.
            const cause = page.controls.last?.closest("label");
            fault("drawing", `Gnomon cannot draw this: ${words(error)}`, cause);
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

    page.last = { state, width, height, clear: description.clear, description, ours, theirs, hash: "" };
    page.last.hash = engine.hash(ours.pixels, width, height);
    page.view.show("ours", ours.pixels, width, height);
    if (theirs)
        page.view.show("theirs", theirs.pixels, width, height);
    const difference = showDifference(page.last, Number(page.own.magnify), !page.turning);
    if (difference)
        page.view.show("difference", difference, width, height);
    showVerdict(page.contract, page.last);
    showTimes(page.last);
    pixels.showCursor();
    pixels.noteStale();
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

let arriving = 0;

// Magnifies around a place of the picture; null: around the pixel cursor or the middle. Down at single pixels, the one
// there is taken apart.
function magnify(factor, place) {
    const { view, cursor, last } = page;
    if (!last)
        return;
    const [x, y] = place ?? (pixels.cursorIsOn ? [cursor[0] + 0.5, last.height - cursor[1] - 0.5] : view.middle());
    view.magnify(factor, [x, y]);
    clearTimeout(arriving);
    if (factor > 1 && view.scale >= SINGLE_PIXEL)
        arriving = setTimeout(() => pixels.explain(Math.floor(x), last.height - 1 - Math.floor(y), false), ARRIVE_DELAY);
}

function showMagnification() {
    $("scale").textContent = `${page.view.scale < 10 ? Number(page.view.scale.toPrecision(2)) : Math.round(page.view.scale)}×`;
    $("shrink").disabled = !page.view.isMagnified();
    pixels.showCursor();
}

function handOf(view) {
    return {
        view,
        turn: (right, down) => change(() => page.engine.turn(right, down)),
        pan: (right, down) => change(() => page.engine.pan(right, down)),
        zoom: (steps) => change(() => page.engine.zoom(steps)),
        choose: (x, y) => pixels.explain(x, y),
        magnify,
        scrolled: () => $("keys").classList.add("asked"),
        hasCursor: () => pixels.cursorIsOn,
        toggleCursor: () => pixels.toggleCursor(),
        cursor: (arrow, isFast) => pixels.moveCursor(arrow, isFast),
    };
}

// ---- Models ----

function takeFiles(files) {
    return drawers.exchange(async () => {
        const { useFiles } = await import("./files.js");
        await useFiles(files, { drawers, ready: showModel });
        redraw();
    });
}

function showModel(model) {
    page.controls.nameDropped(model.about.name);
    change(() => {
        page.engine.set("model", "dropped");
        for (const key of ["eye", "target", "near", "far"])
            page.engine.set(key, "");
    });
}

// ---- The beginning ----

function listen() {
    const hand = handOf(page.view);
    for (const canvas of Object.values(page.view.canvases))
        attach(canvas, hand);
    $("magnify").onclick = () => magnify(2, null);
    $("shrink").onclick = () => magnify(1 / 2, null);
    $("nearer").onclick = () => hand.zoom(1);
    $("farther").onclick = () => hand.zoom(-1);
    for (const { name, state } of PRESETS)
        $("preset").add(new Option(name, state));
    $("preset").onchange = ({ target }) => {
        if (target.value !== "")
            change(() => page.engine.setState(withFrame(target.value, page.engine.state())));
        target.value = "";
    };
    $("turn").onclick = toggleTurning;
    $("reset").onclick = () => {
        page.turning = false;
        showTurning();
        page.own.pixel = "";
        page.cursor = null;
        pixels.forget();
        page.view.whole();
        change(() => page.engine.setState(page.initial));
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
        pixels.explain(...page.own.pixel.split(",").map(Number), false);
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
    page.view = new View($("pictures"), { ours: $("ours"), theirs: $("theirs"), difference: $("difference") }, showMagnification);
    const size = sizeFor(page.view.room());
    page.initial = `size=${size}&samples=4`;
    page.view.fit(...size.split("x").map(Number));
    await startEngine();
    readAddress(location.hash);
    page.controls.show(stateMap(), page.own);
    listen();
    // The first picture, by this thread: WebGL, workers and whatever else is loaded come later.
    redraw();
    await idle();
    document.querySelectorAll(".loading").forEach((words) => words.remove());
    document.documentElement.dataset.firstPicture = performance.now().toFixed(0);
    await new Promise(requestAnimationFrame);
    startWebGL();
    redraw();
    await idle();

    const contract = loadContract("pictures.txt")
        .then((hashes) => {
            page.contract = hashes;
            if (page.last)
                showVerdict(page.contract, page.last);
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
