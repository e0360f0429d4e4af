// Shows a pixel taken apart: a sentence that says why it differs, a magnified grid of pixels with the edges of
// triangles, and, folded, the values of every stage as tables and all of it as text.

const AROUND = 4; // pixels shown on each side of the chosen one
const UNITS = 256; // snapped coordinates in a pixel
const SHORT = 14; // rows of a stage that is open from the beginning
const SVG = "http://www.w3.org/2000/svg";
const COLORS = ["#ffb000", "#33c1ff", "#ff6f91", "#7bd65a", "#c79bff", "#ffffff"];

function element(name, attributes = {}, ...children) {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes))
        made.setAttribute(key, value);
    made.append(...children);
    return made;
}

function drawn(name, attributes) {
    const made = document.createElementNS(SVG, name);
    for (const [key, value] of Object.entries(attributes))
        made.setAttribute(key, value);
    return made;
}

// A pixel's four bytes; null outside the picture.
function bytesAt(pixels, { width, height }, x, y) {
    if (x < 0 || y < 0 || x >= width || y >= height)
        return null;
    const at = 4 * (y * width + x);
    return pixels.subarray(at, at + 4);
}

function colorAt(pixels, size, x, y) {
    const bytes = bytesAt(pixels, size, x, y);
    return bytes ? `rgb(${bytes[0]} ${bytes[1]} ${bytes[2]})` : "#555";
}

// A stored pixel as a word: alpha, blue, green, red.
function wordAt(pixels, size, x, y) {
    return [...bytesAt(pixels, size, x, y)].reverse().map((byte) => byte.toString(16).padStart(2, "0")).join("");
}

// The grid around a pixel. The unit is a pixel, (0, 0) the centre of the first; SVG's y points down.
function gridOf(explained, whose, pixels, size) {
    const [px, py] = explained.pixel;
    const side = 2 * AROUND + 1;
    const svg = drawn("svg", {
        viewBox: `${px - AROUND - 0.5} ${-py - AROUND - 0.5} ${side} ${side}`,
        role: "img",
        "aria-label":
            `${whose}: the pixels around ${px}, ${py} with their centres, and the snapped edges of ` +
            `${explained.fragments.length} primitives`,
    });
    for (let y = py - AROUND; y <= py + AROUND; ++y) {
        for (let x = px - AROUND; x <= px + AROUND; ++x) {
            const isChosen = x === px && y === py;
            svg.append(
                drawn("rect", {
                    x: x - 0.5,
                    y: -y - 0.5,
                    width: 1,
                    height: 1,
                    fill: colorAt(pixels, size, x, y),
                    stroke: "#888",
                    "stroke-width": 0.02,
                }),
                drawn("circle", { cx: x, cy: -y, r: isChosen ? 0.09 : 0.05, fill: "#fff", stroke: "#000", "stroke-width": 0.03 })
            );
        }
    }
    explained.fragments.forEach((fragment, i) => {
        const points = (fragment.corners ?? []).map(([x, y]) => `${x / UNITS},${-y / UNITS}`).join(" ");
        if (points === "")
            return;
        for (const [color, width] of [["#000", 3], [COLORS[i % COLORS.length], 1.5]])
            svg.append(
                drawn("polygon", {
                    points,
                    fill: "none",
                    stroke: color,
                    "stroke-width": width,
                    "vector-effect": "non-scaling-stroke",
                })
            );
    });
    svg.append(
        drawn("rect", {
            x: px - 0.5,
            y: -py - 0.5,
            width: 1,
            height: 1,
            fill: "none",
            stroke: "#fff",
            "stroke-width": 2,
            "vector-effect": "non-scaling-stroke",
        })
    );
    return svg;
}

function stageOf(stage, isOpen) {
    const rows = stage.values.map((value) =>
        element(
            "tr",
            {},
            element("th", { scope: "row" }, value.name),
            element("td", {}, value.value),
            element("td", { class: "bits" }, value.bits ?? ""),
            element("td", { class: "expression" }, value.expression ?? "")
        )
    );
    const head = ["Name", "Value", "Bits", "Expression"].map((name) => element("th", { scope: "col" }, name));
    const table = element(
        "table",
        { "aria-label": stage.name },
        element("thead", {}, element("tr", {}, ...head)),
        element("tbody", {}, ...rows)
    );
    // A table may be wider than a phone. Then it scrolls, and the keyboard must reach it to do so.
    const scroll = element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": stage.name }, table);
    const details = element("details", {}, element("summary", {}, stage.name), scroll);
    details.open = isOpen;
    return details;
}

// A fragment is open if it is the last one that was written, and in it the short stages are.
function fragmentOf(fragment, isOpen, color) {
    const mark = element("span", { "aria-hidden": "true" }, "■ ");
    mark.style.color = color;
    const title = `Draw ${fragment.draw}, ${fragment.kind} ${fragment.primitive}: ${fragment.result}`;
    const details = element(
        "details",
        { class: "fragment" },
        element("summary", {}, element("h3", {}, mark, title)),
        ...fragment.stages.map((stage) => stageOf(stage, stage.values.length <= SHORT))
    );
    details.open = isOpen;
    return details;
}

function gridFigure(explained, whose, drawn, size) {
    return element("figure", {}, element("figcaption", {}, whose), gridOf(explained, whose, drawn.pixels, size));
}

// Shows what the module has said of a pixel, and what WebGL has drawn there. `why` is the sentence; `last` is what
// was drawn last: ours, theirs (or null), width and height; copy(text) puts text on the clipboard.
export function showExplained(place, explained, why, last, copy) {
    const [x, y] = explained.pixel;
    const { ours, theirs } = last;
    const written = explained.fragments.findLastIndex((fragment) => fragment.result === "written");
    const button = element("button", { type: "button" }, "Copy the text");
    const text = element("pre", { tabindex: "0", "aria-label": "The same as text" }, explained.text ?? "");
    button.addEventListener("click", () => copy(explained.text ?? ""));

    const stored = wordAt(ours.pixels, last, x, y);
    const count = explained.fragments.length;
    const summary = element(
        "p",
        { class: "stored" },
        `Pixel ${x}, ${y}: Gnomon has stored `,
        element("code", {}, stored),
        ...(theirs ? [", WebGL ", element("code", {}, wordAt(theirs.pixels, last, x, y))] : []),
        ` (alpha, blue, green, red). ${count} ${count === 1 ? "fragment" : "fragments"}.`
    );
    const grids = element("div", { class: "grids" }, gridFigure(explained, "Gnomon", ours, last));
    if (theirs)
        grids.append(gridFigure(explained, "WebGL", theirs, last));
    const fragments = explained.fragments.map((fragment, i) =>
        fragmentOf(fragment, i === written, COLORS[i % COLORS.length])
    );
    // The explanation comes from another build of the library, so its result is checked.
    const doubt = element("p", { class: "fault" }, `The explanation ends in ${explained.color}, which is not what Gnomon has stored.`);
    place.replaceChildren(
        element("p", { class: "why" }, why),
        ...(explained.color === stored ? [] : [doubt]),
        summary,
        element("div", { class: "apart" }, grids, element(
            "div",
            {},
            element("details", { class: "values" }, element("summary", {}, "Every value on the way to this pixel"), ...fragments),
            element("details", {}, element("summary", {}, "The same as text"), text, button)
        ))
    );
}
