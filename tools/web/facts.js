// Collects what is known about a pixel that differs (why.js): from what the module has explained, and from
// experiments with WebGL.
import { WebGLProbe } from "./webgl_probe.js";

const TRIES = 12; // triangles that are drawn alone to find the one that WebGL shows

export function bytesAt({ pixels }, width, x, y) {
    const at = 4 * (y * width + x);
    return [...pixels.subarray(at, at + 4)];
}

const view = new DataView(new ArrayBuffer(4));

// The values of a fragment's stages as numbers, by name. The bits are exact; the decimal text is for readers. With
// samples, values of the shader are named after the sample that was tested last; it runs once for all.
function valuesOf(fragment) {
    const values = new Map();
    for (const { name, bits } of fragment.stages.flatMap((stage) => stage.values)) {
        if (!/^[0-9a-f]{8}$/.test(bits ?? ""))
            continue;
        view.setUint32(0, parseInt(bits, 16));
        values.set(name.replace(/\.sample\d$/, ""), view.getFloat32(0));
    }
    return values;
}

// The stored samples of a pixel, or null.
function samplesOf(explained) {
    const all = explained.fragments.flatMap((fragment) => fragment.stages).flatMap((stage) => stage.values);
    const samples = all.filter(({ name }) => /^stored\.sample[0-3]$/.test(name)).slice(-4);
    if (samples.length < 4)
        return null;
    return samples.map(({ bits }) => [6, 4, 2, 0].map((at) => parseInt(bits.slice(at, at + 2), 16)));
}

function shadedBytes(values) {
    return ["red", "green", "blue", "alpha"].map((name) => {
        const value = values.get(`shaded.${name}`) ?? 0;
        return Math.round(255 * Math.min(1, Math.max(0, value)));
    });
}

function isNear(a, b, steps) {
    return a.every((value, c) => Math.abs(value - b[c]) <= steps);
}

// The triangle that WebGL alone draws at a pixel, found by drawing triangles alone: [draw, primitive], or null.
function triangleOfWebGL(probe, place, x, y, theirs) {
    for (const [draw, primitive] of probe.trianglesNear(place, TRIES)) {
        const values = probe.values(draw, primitive, x, y);
        if (values && isNear(shadedBytes(values), theirs, 2))
            return [draw, primitive];
    }
    return null;
}

// The fragment of Gnomon, not the one on top, whose colour WebGL shows; or null.
function otherFragment(probe, explained, written, { x, y, theirs }) {
    return explained.fragments.find((fragment) => {
        const seen = fragment !== written && fragment.kind === "triangle" && probe.values(fragment.draw, fragment.primitive, x, y);
        return seen && isNear(shadedBytes(seen), theirs, 1);
    }) ?? null;
}

// Returns the facts that sentenceOf (why.js) takes. `renderer` is null without WebGL; it has drawn `last` last.
export function factsOf(explained, last, renderer) {
    const [x, y] = explained.pixel;
    const ours = bytesAt(last.ours, last.width, x, y);
    const clear = last.clear.map((c) => Math.round(c * 255));
    const facts = {
        ours, clear, theirs: null, samples: samplesOf(explained), coverage: null, isOurs: false, shown: null, isAlone: false,
        isSampled: last.description.samples > 1, isSame: false,
        other: null, shader: "", values: new Map(), probe: null,
    };
    if (!last.theirs)
        return facts;
    facts.theirs = bytesAt(last.theirs, last.width, x, y);
    if (facts.theirs.join() !== ours.join() && renderer && !renderer.isLost())
        addExperiments(facts, explained, last.description, renderer);
    return facts;
}

// Finds out what only WebGL can tell.
function addExperiments(facts, explained, description, renderer) {
    const [x, y] = explained.pixel;
    const { theirs } = facts;
    const probe = new WebGLProbe(renderer, description);
    const place = [x + 0.5, probe.row(y) + 0.5];
    const written = explained.fragments.findLast(({ result, kind }) => result === "written" && kind === "triangle");
    const cover = (triangle, isOurs) => {
        const corners = triangle && probe.corners(...triangle);
        facts.isOurs = isOurs;
        if (corners)
            facts.coverage = { draw: triangle[0], primitive: triangle[1], corners, place, bits: probe.subpixelBits() };
    };
    if (written) {
        facts.values = valuesOf(written);
        facts.shader = description.draws[written.draw].shader;
        facts.probe = probe.values(written.draw, written.primitive, x, y);
    }
    facts.isSame = facts.probe !== null && isNear(shadedBytes(facts.probe), theirs, 2);
    // Samples and translucent layers are mixed: no triangle has the colour alone.
    if (description.samples > 1 || (written && description.draws[written.draw].blend !== "none"))
        return;
    if (facts.isSame)
        return;
    facts.isAlone = !written || theirs.join() === facts.clear.join();
    if (written && facts.isAlone) {
        cover([written.draw, written.primitive], true);
        return;
    }
    facts.other = written ? otherFragment(probe, explained, written, { x, y, theirs }) : null;
    const found = facts.other ? null : triangleOfWebGL(probe, place, x, y, theirs);
    if (found && !(written && found[0] === written.draw && found[1] === written.primitive)) {
        cover(found, false);
        facts.shown = written ?? null;
    }
}
