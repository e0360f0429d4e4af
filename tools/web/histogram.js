// By how many steps of 255 the differing pixels differ, as bars.

// The last number of steps of each bar.
const BARS = [1, 2, 3, 4, 8, 16, 64, 255];

// Returns the bars of a comparison (difference.js): { name, count, share }, the last one for coverage. Shares are of
// all differing pixels.
export function barsOf({ steps, coverage, differing }) {
    const bars = BARS.map((last, i) => {
        const first = i === 0 ? 1 : BARS[i - 1] + 1;
        const count = steps.slice(first, last + 1).reduce((sum, n) => sum + n, 0);
        return { name: first === last ? `${first}` : `${first} to ${last}`, count };
    });
    bars.push({ name: "coverage", count: coverage });
    return bars.map((bar) => ({ ...bar, share: differing === 0 ? 0 : bar.count / differing }));
}

// A share in words: no difference is rounded to nothing, and not all but one to all.
export function percent(share) {
    const value = 100 * share;
    if (value > 0 && value < 0.1)
        return "< 0.1 %";
    if (value > 99.9 && value < 100)
        return "> 99.9 %";
    return `${value.toFixed(value >= 10 || value === 0 ? 0 : 1)} %`;
}

// The sentence that begins the explanation.
export function summaryOf({ steps, differing, coverage }) {
    if (differing === 0)
        return "No pixel differs in this picture.";
    const number = (n) => n.toLocaleString("en");
    const one = percent(steps[1] / differing);
    const edges = coverage === 0 ? "none is drawn by one side alone" : `${percent(coverage / differing)} are drawn by one side alone`;
    return `Of ${number(differing)} differing pixels ${one} differ by one step of 255, the least there is; ${edges}.`;
}

// Shows the bars in a table's body: every row is there from the beginning, so that nothing moves.
export function showBars(body, result) {
    const bars = barsOf(result ?? { steps: new Uint32Array(256), coverage: 0, differing: 0 });
    while (body.rows.length < bars.length) {
        const row = body.insertRow();
        row.append(document.createElement("th"));
        row.insertCell();
        row.insertCell().append(document.createElement("i"));
        row.cells[0].scope = "row";
    }
    bars.forEach(({ name, count, share }, i) => {
        const [title, value, bar] = body.rows[i].cells;
        title.textContent = name;
        value.textContent = result ? `${count.toLocaleString("en")} (${percent(share)})` : "–";
        bar.firstChild.style.width = `${100 * share}%`;
        bar.firstChild.className = name === "coverage" ? "bar coverage" : "bar";
    });
}
