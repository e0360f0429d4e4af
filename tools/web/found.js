// What the page says below the pictures: how many pixels differ and by how much, whether Gnomon's picture is the
// contract's, how long both took.
import { judge } from "./contract.js";
import { compare } from "./difference.js";
import { showBars, summaryOf } from "./histogram.js";
import { fault, say } from "./messages.js";

const SPEAK_DELAY = 1500; // milliseconds until screen readers are told

const $ = (id) => document.getElementById(id);
const number = (n) => n.toLocaleString("en");

function timeWords({ milliseconds }) {
    const rate = 1000 / Math.max(milliseconds, 0.1);
    return `${milliseconds.toFixed(1)} ms, ${rate >= 10 ? Math.round(rate) : rate.toFixed(1)} frames a second`;
}

export function showTimes({ ours, theirs }) {
    $("ours-time").textContent = timeWords(ours);
    $("theirs-time").textContent = theirs ? timeWords(theirs) : "not drawn";
}

// Counts and shows in what the pictures of `last` differ; sets last.counts. Returns the picture of the difference, or
// null if there is nothing to compare with.
export function showDifference(last, factor, speaks) {
    const { width, height, ours, theirs } = last;
    if (!theirs) {
        for (const id of ["differing", "coverage", "largest"])
            $(id).textContent = "–";
        last.counts = null;
        showBars($("steps"), null);
        return null;
    }
    const clear = last.clear.map((c) => Math.round(c * 255));
    last.counts = compare(ours.pixels, theirs.pixels, clear, factor);
    const { differing, coverage, largest } = last.counts;
    const share = document.createElement("small");
    share.textContent = ` of ${number(width * height)}`;
    $("differing").replaceChildren(number(differing), share);
    $("coverage").textContent = number(coverage);
    $("largest").textContent = number(largest);
    $("summary").textContent = summaryOf(last.counts);
    showBars($("steps"), last.counts);
    if (speaks)
        say(
            differing === 0
                ? "No pixel differs."
                : `${number(differing)} pixels differ; ${number(coverage)} are drawn by one alone; the largest step is ${largest}.`,
            SPEAK_DELAY
        );
    return last.counts.pixels;
}

export function showVerdict(contract, { state, hash }) {
    const { verdict, text } = judge(contract, state, hash);
    $("hash").textContent = hash;
    if ($("contract").dataset.verdict !== verdict || $("contract").textContent !== text) {
        $("contract").dataset.verdict = verdict;
        $("contract").textContent = text;
    }
    fault("contract", verdict === "different" ? text : "");
}
