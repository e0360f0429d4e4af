// Why a pixel differs between Gnomon and WebGL, as one sentence. The facts come from the explained pixel
// (page_explain) and from experiments with WebGL (webgl_probe.js).

const CHANNELS = ["red", "green", "blue", "alpha"];

// A number of pixels or steps with two digits that say something.
export function short(number) {
    if (Math.abs(number) >= 100)
        return Math.round(number).toString();
    return Number(number.toPrecision(2)).toString();
}

export function stepsOf(ours, theirs) {
    return ours.map((value, c) => theirs[c] - value);
}

function joined(words) {
    return words.length < 2 ? words.join("") : `${words.slice(0, -1).join(", ")} and ${words.at(-1)}`;
}

function plural(count, word) {
    return `${count === 1 ? "one" : count} ${word}${count === 1 ? "" : "s"}`;
}

// "blue differs by one step of 255", "red differs by 13, green by 9 and blue by 2 steps of 255"
function differing(ours, theirs) {
    const steps = stepsOf(ours, theirs).map(Math.abs);
    const sizes = [...new Set(steps.filter((step) => step > 0))];
    const named = sizes.map((size) => ({ size, names: CHANNELS.filter((_, c) => steps[c] === size) }));
    if (named.length === 0)
        return "nothing differs";
    const verb = named[0].names.length > 1 ? "differ" : "differs";
    const parts = named.map(({ size, names }, i) => `${joined(names)}${i === 0 ? ` ${verb}` : ""} by ${size === 1 ? "one" : size}`);
    return `${joined(parts)} step${sizes.at(-1) === 1 ? "" : "s"} of 255`;
}

// ---- Coverage ----

// The distance of a place from the nearest edge of a triangle in pixels, above 0 inside; and the two corners of
// that edge, counted from 1. Corners are places in the window.
export function edgeOf(corners, place) {
    const cross = (a, b, p) => (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    const sign = Math.sign(cross(...corners)) || 1;
    const edges = [[0, 1], [1, 2], [2, 0]].map(([i, k]) => {
        const [a, b] = [corners[i], corners[k]];
        const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
        return { distance: length === 0 ? -Infinity : (sign * cross(a, b, place)) / length, corners: [i + 1, k + 1] };
    });
    return edges.reduce((least, edge) => (edge.distance < least.distance ? edge : least));
}

// Rounds corners to 2 ** -bits pixel, as rasterizers do before they compare anything with edges.
export function snapped(corners, bits) {
    const scale = 2 ** bits;
    return corners.map((corner) => corner.map((at) => Math.round(at * scale) / scale));
}

function sideOf(distance) {
    if (distance === 0)
        return "exactly on";
    return `${short(Math.abs(distance))} pixel ${distance > 0 ? "inside" : "outside"}`;
}

// coverage: { draw, primitive, corners in the window, place, bits of WebGL }. isOurs: Gnomon alone has the triangle here.
function coverageSentence({ draw, primitive, corners, place, bits }, isOurs) {
    const [ours, theirs] = [8, bits].map((count) => edgeOf(snapped(corners, count), place));
    const [a, b] = (isOurs ? theirs : ours).corners;
    const edge = `the edge between corners ${a} and ${b} of triangle ${primitive} of draw ${draw}`;
    const mine = edgeOf(snapped(corners, 8), place).distance;
    const rounding = `Gnomon rounds corners to 1/256 pixel, this WebGL to 1/${2 ** bits}.`;
    // A centre on an edge belongs to one of the two triangles there, by a rule that each side has.
    if (theirs.distance !== 0 && theirs.distance > 0 === isOurs)
        return `${isOurs ? "Gnomon" : "WebGL"} alone covers the pixel’s centre, which lies ${sideOf(mine)} ${edge} for Gnomon; ` +
            `rounded as WebGL says that it rounds, ${sideOf(theirs.distance)} it.`;
    return `WebGL puts the pixel’s centre ${sideOf(theirs.distance)} ${edge}; Gnomon puts it ${sideOf(mine)}. ${rounding}`;
}

// ---- Samples ----

// How many of four samples must have which of the colours, so that their mean is nearest to a colour.
function mixtureOf(colors, wanted) {
    let best = { error: Infinity };
    const search = (counts, left) => {
        if (counts.length === colors.length - 1) {
            const all = [...counts, left];
            const mean = wanted.map((_, c) => all.reduce((sum, n, i) => sum + n * colors[i][c], 0) / 4);
            const error = Math.max(...mean.map((value, c) => Math.abs(value - wanted[c])));
            if (error < best.error)
                best = { error, counts: all };
            return;
        }
        for (let n = 0; n <= left; ++n)
            search([...counts, n], left - n);
    };
    search([], 4);
    return best;
}

function samplesSentence({ samples, clear, ours, theirs }) {
    const colors = [...new Map([...samples, clear].map((color) => [color.join(), color])).values()];
    const have = colors.map((color) => samples.filter((sample) => sample.join() === color.join()).length);
    const seen = mixtureOf(colors, theirs);
    const moved = seen.counts.reduce((sum, count, i) => sum + Math.abs(count - have[i]), 0) / 2;
    const head = `An edge crosses the pixel, and its four samples have ${plural(new Set(samples.map(String)).size, "colour")}`;
    const most = Math.max(...stepsOf(ours, theirs).map(Math.abs));
    // Colours beside an edge differ by a step or two on their own.
    if (moved === 0 || most <= 3)
        return `${head}; in their mean, ${differing(ours, theirs)}, since the colours themselves differ a little.`;
    if (seen.error > 3)
        return `${head}; in their mean, ${differing(ours, theirs)}. No share of these colours makes WebGL’s: another triangle has ` +
            "some of its samples, or its colours were computed at other places.";
    return `${head}: WebGL’s colour is what ${plural(moved, "sample")} on the other side of the edge would make.`;
}

// ---- Colours ----

function inputNamed(name) {
    const [first, component] = name.split(".");
    if (first === "s" || first === "t")
        return `the texture coordinate ${first}`;
    if (component === undefined)
        return `the vertices’ ${first}`;
    return `${component} of the ${first === "place" ? "place in the world" : first}`;
}

// The value on the way to the colour that explains a difference of so many steps of 255: texels if they differ by
// about as much, otherwise what is interpolated. Names are those of the explained pixel.
function firstDifference({ values, probe, shader }, steps) {
    if (shader === "toon" && steps > 2)
        return "The brightness lies where one band of the toon shader ends and the next begins.";
    const texels = [...probe].filter(([name]) => /_map\./.test(name) && values.has(name))
        .map(([name, value]) => ({ name, steps: 255 * Math.abs(value - values.get(name)) }))
        .sort((a, b) => b.steps - a.steps);
    if (texels.length > 0 && texels[0].steps >= Math.max(0.02, steps / 20)) {
        const [map, channel] = texels[0].name.split(".");
        return `The texels of the ${map.replace("_map", "")} map are ${short(texels[0].steps)} steps of ${channel} apart: ` +
            "OpenGL leaves to a GPU with how many bits it weighs texels and chooses levels.";
    }
    const inputs = [...probe].filter(([name]) => !/_map\.|^shaded\./.test(name) && values.has(name))
        .map(([name, value]) => ({ name, apart: Math.abs(value - values.get(name)), ours: values.get(name), value }))
        .filter(({ apart, ours }) => apart > 1e-6 * Math.max(1, Math.abs(ours)))
        .sort((a, b) => b.apart - a.apart);
    if (inputs.length > 0)
        return `Interpolation already differs: ${inputNamed(inputs[0].name)} is ${inputs[0].value.toPrecision(7)}, not ${inputs[0].ours.toPrecision(7)}.`;
    return "What goes into the shader is nearly the same; its operations are rounded in another way.";
}

function colorSentence(facts) {
    const { ours, theirs, values, probe } = facts;
    const steps = stepsOf(ours, theirs).map(Math.abs);
    const most = steps.indexOf(Math.max(...steps));
    const head = `The same fragment; ${differing(ours, theirs)}`;
    const name = `shaded.${CHANNELS[most]}`;
    if (!probe || !values.has(name) || !probe.has(name))
        return `${head}.`;
    const [mine, other] = [values.get(name), probe.get(name)].map((value) => 255 * value);
    const digits = Math.min(6, Math.max(1, 1 - Math.floor(Math.log10(Math.abs(mine - other) || 1))));
    const between = Math.min(ours[most], theirs[most]) + 0.5;
    const limit = steps[most] === 1 && Math.min(mine, other) <= between && between <= Math.max(mine, other)
        ? `, and what is rounded up begins at ${between}` : "";
    return `${head}: before rounding Gnomon has ${mine.toFixed(digits)} for ${CHANNELS[most]} and WebGL ` +
        `${other.toFixed(digits)}${limit}. ${firstDifference(facts, Math.abs(mine - other))}`;
}

// facts: what is known.
//   ours, theirs   the stored pixels as [red, green, blue, alpha], 0 to 255; theirs null without WebGL
//   clear          the background
//   samples        null, or the pixels of Gnomon's four samples
//   coverage       null, or the triangle that one side alone has here (coverageSentence)
//   isOurs         whether that side is Gnomon
//   shown          null, or what Gnomon shows instead of that triangle: { draw, primitive }
//   other          null, or the fragment of Gnomon, { draw, primitive, result }, whose colour WebGL shows
//   shader         the name of the fragment's shader
//   values, probe  Maps of names to numbers on the way to the colour, Gnomon's and WebGL's; probe may be null
//   isSampled      whether there are four samples
//   isSame         whether WebGL's colour of the fragment is nearly what WebGL has stored
//   isAlone        whether one side alone draws here
export function sentenceOf(facts) {
    const { ours, theirs, samples, coverage, isOurs, shown, isAlone, other } = facts;
    if (!theirs)
        return "There is no picture of WebGL to compare this pixel with.";
    if (ours.join() === theirs.join())
        return "Nothing differs: both have stored the same colour.";
    if (samples && new Set([...samples].map(String)).size > 1)
        return samplesSentence(facts);
    if (facts.isSampled && Math.max(...stepsOf(ours, theirs).map(Math.abs)) > 3 && !facts.isSame)
        return `An edge passes by: in Gnomon all four samples of the pixel lie on one side of it, in WebGL’s colour is a share of the ` +
            "other side.";
    if (coverage) {
        const sentence = coverageSentence(coverage, isOurs);
        return shown ? `${sentence} Gnomon shows triangle ${shown.primitive} of draw ${shown.draw} there.` : sentence;
    }
    if (isAlone)
        return `${isOurs ? "Gnomon" : "WebGL"} alone draws here; which triangle it is could not be found out.`;
    if (other)
        return `WebGL shows another fragment: triangle ${other.primitive} of draw ${other.draw}, which in Gnomon ${other.result}.`;
    return colorSentence(facts);
}
