// Makes a lesson's page live: loads the module and the files that the lesson reads, runs it, shows
// what it drew and printed, and runs it again whenever a slider moves.

import {runLesson} from "./lesson_run.js";

const stage = document.querySelector(".stage");
const canvas = document.getElementById("picture");
const form = document.getElementById("sliders");
const printed = document.getElementById("printed");
const input = document.getElementById("input");
const number = Number(stage.dataset.number);
const lines = JSON.parse(stage.dataset.lines); // slider -> its line in the source
const moved = new Map();

let module, files;

function showError(text) {
    const error = document.getElementById("error");
    if (error.textContent !== text)
        error.textContent = text;
}

// A module that only a browser with SIMD accepts: one function, which returns a vector of zeros.
function hasSimd() {
    const header = [0, 0x61, 0x73, 0x6d, 1, 0, 0, 0];
    const type = [1, 5, 1, 0x60, 0, 1, 0x7b];
    const functions = [3, 2, 1, 0];
    const body = [0, 0xfd, 0x0c, ...new Array(16).fill(0), 0x0b];
    const code = [10, body.length + 2, 1, body.length, ...body];
    return WebAssembly.validate(Uint8Array.from([...header, ...type, ...functions, ...code]));
}

async function load(name) {
    let response;
    try {
        response = await fetch(name);
    } catch (cause) {
        throw new Error(`${name} could not be loaded: ${cause.message}`, {cause});
    }
    if (!response.ok)
        throw new Error(`${name} could not be loaded: the server answered ${response.status}.`);
    return new Uint8Array(await response.arrayBuffer());
}

async function loadAll() {
    if (typeof WebAssembly !== "object")
        throw new Error("This browser has no WebAssembly, which the lessons need.");
    const names = stage.dataset.files.split(" ").filter(Boolean);
    const [code, ...contents] = await Promise.all([
        load(hasSimd() ? "lessons-simd.wasm" : "lessons.wasm"), ...names.map((name) => load(`models/${name}`))]);
    module = await WebAssembly.compile(code);
    files = new Map(names.map((name, i) => [`build/examples/${name}`, contents[i]]));
}

function run() {
    const result = runLesson(module, number, {files, moved, input: input ? input.value : ""});
    if (canvas && result.picture) {
        const {width, height, rgba} = result.picture;
        canvas.width = width;
        canvas.height = height;
        canvas.getContext("2d").putImageData(new ImageData(rgba, width, height), 0, 0);
    }
    if (printed.textContent !== result.printed)
        printed.textContent = result.printed;
    printed.hidden = result.printed === "";
    showError(result.status ? result.errors || `The program ended with status ${result.status}.` : "");
    return result;
}

// However fast a slider moves, the lesson runs at most once between two frames of the screen.
let isAsked = false;
function runSoon() {
    if (isAsked)
        return;
    isAsked = true;
    requestAnimationFrame(() => {
        isAsked = false;
        try {
            run();
        } catch (error) {
            showError(error.message);
        }
    });
}

// The smallest of the steps 1, 2 and 5 times a power of ten that leaves at most 200 steps, or a
// smaller one if the first value would lie between two steps.
function stepOf({first, least, most, isInt}) {
    const tidy = (x) => Number(x.toPrecision(6));
    for (let power = Math.ceil(Math.log10(most - least)); power >= (isInt ? 0 : -6); --power)
        for (const digit of [5, 2, 1]) {
            const step = digit * 10 ** power;
            const before = tidy(first - least) / step, after = tidy(most - first) / step;
            const isEven = Math.abs(before - Math.round(before)) < 1e-4 && Math.abs(after - Math.round(after)) < 1e-4;
            if (isEven && tidy(most - least) / step >= 50)
                return tidy(step);
        }
    return isInt ? 1 : "any";
}

function slide(name, value, shown) {
    shown.textContent = value;
    moved.set(name, Number(value));
    runSoon();
}

// The address holds the sliders that were moved, so that a picture can be sent.
function keepInAddress() {
    const query = new URLSearchParams([...moved]).toString();
    history.replaceState(null, "", `${location.pathname}${query && `?${query}`}${location.hash}`);
}

function takeFromAddress() {
    for (const [name, value] of new URLSearchParams(location.search))
        if (name in lines && value.trim() !== "" && Number.isFinite(Number(value)))
            moved.set(name, Number(value));
}

// The sliders are those that the lesson asked for in its first run.
function makeSliders(sliders) {
    const tidy = (x) => Number(x.toPrecision(6));
    sliders.forEach((slider, i) => {
        const row = document.createElement("div");
        row.className = "slider";
        const label = document.createElement("label");
        label.htmlFor = `slider-${i}`;
        label.textContent = slider.name;
        const range = document.createElement("input");
        Object.assign(range, {type: "range", id: `slider-${i}`, min: tidy(slider.least), max: tidy(slider.most), step: stepOf(slider)});
        range.value = tidy(slider.value);
        const shown = document.createElement("span");
        shown.className = "value";
        shown.setAttribute("aria-hidden", "true"); // the range says its value itself
        shown.textContent = range.value;
        range.addEventListener("input", () => slide(slider.name, range.value, shown));
        range.addEventListener("change", keepInAddress);
        row.append(label, shown, range);

        const line = document.getElementById(`L${lines[slider.name]}`);
        if (line) {
            const link = document.createElement("a");
            link.className = "to-line";
            link.href = `#${line.id}`;
            link.textContent = `line ${lines[slider.name]}`;
            link.setAttribute("aria-label", `line ${lines[slider.name]} of the source: ${slider.name}`);
            row.append(link);
            range.addEventListener("focus", () => {
                line.classList.add("current");
                const box = line.closest("pre");
                box.scrollTop += line.getBoundingClientRect().top - box.getBoundingClientRect().top - box.clientHeight / 3;
            });
            range.addEventListener("blur", () => line.classList.remove("current"));
        }
        form.append(row);
    });

    const reset = document.createElement("button");
    reset.type = "button";
    reset.textContent = "As in the text";
    reset.addEventListener("click", () => {
        moved.clear();
        form.querySelectorAll("input").forEach((range, i) => {
            range.value = tidy(sliders[i].first);
            range.parentElement.querySelector(".value").textContent = range.value;
        });
        keepInAddress();
        runSoon();
    });
    form.append(reset);
}

try {
    await loadAll();
    takeFromAddress();
    makeSliders(run().sliders);
    if (input)
        input.addEventListener("input", runSoon);
    form.addEventListener("submit", (event) => event.preventDefault());
    document.getElementById("state").hidden = true;
} catch (error) {
    showError(error.message);
    document.getElementById("state").hidden = true;
}
