// Reads the texts of OBJ and MTL files. Everything that is wrong is said with file and line.
//
// What a file means is what it means to `gnomon render`: polygons become fans of triangles, texture
// coordinates grow upward, colours of vertices are not read, parts are the triangles of a material.

export class ModelError extends Error {}

// What gnomon render takes where a file says nothing: the surface without a material, and the
// material that lacks a statement.
const NO_MATERIAL = { color: [0.8, 0.8, 0.8], specular: [0.25, 0.25, 0.25], exponent: 32 };
const BARE_MATERIAL = { color: [0.6, 0.6, 0.6], specular: [0, 0, 0], exponent: 32 };
const MAX_EXPONENT = 1024;

const MAX_VERTICES = 10000000;

// Calls `each` with the line number and the words of every statement. A backslash at the end of a
// line continues it.
function eachStatement(name, text, each) {
    if (text.includes("\0"))
        throw new ModelError(`${name}: it has a NUL byte, so it is not a text`);
    let line = 0;
    let first = 1;
    let pending = "";
    for (const raw of text.split(/\r\n|\n|\r/)) {
        ++line;
        const bare = raw.replace(/(^|\s)#.*$/, "$1");
        if (bare.endsWith("\\")) {
            first = pending === "" ? line : first;
            pending += bare.slice(0, -1) + " ";
            continue;
        }
        const statement = (pending + bare).trim();
        const at = pending === "" ? line : first;
        pending = "";
        if (statement !== "")
            each(at, statement.split(/\s+/), statement);
    }
}

function numberOf(name, line, keyword, word) {
    const value = Math.fround(/^[-+]?(\d|\.\d)/.test(word) ? Number(word) : NaN);
    if (!Number.isFinite(value))
        throw new ModelError(`${name}:${line}: "${word}" after ${keyword} is not a finite number`);
    return value;
}

// Reads the numbers of v, vt or vn. The first `keep` are kept.
function readNumbers(name, line, words, keep, counts, meaning, to) {
    const count = words.length - 1;
    if (!counts.includes(count))
        throw new ModelError(`${name}:${line}: ${words[0]} takes ${meaning}, not ${count}`);
    const numbers = words.slice(1).map((word) => numberOf(name, line, words[0], word));
    if (words[0] === "v" && count === 4 && numbers[3] !== 1) {
        if (numbers[3] === 0)
            throw new ModelError(`${name}:${line}: the fourth number of v is 0`);
        for (let i = 0; i < 3; ++i)
            numbers[i] = Math.fround(numbers[i] / numbers[3]);
    }
    for (let i = 0; i < keep; ++i)
        to.push(numbers[i] ?? 0);
}

// The corner of a face, "v", "v/vt", "v//vn" or "v/vt/vn", as three numbers from 0; -1: none.
function readCorner(name, line, word, counts) {
    const keywords = ["v", "vt", "vn"];
    const fields = word.split("/");
    if (fields.length > 3 || fields[0] === "")
        throw new ModelError(`${name}:${line}: "${word}" is not a corner of a face (v, v/vt, v//vn, v/vt/vn)`);
    return [0, 1, 2].map((i) => {
        const field = fields[i] ?? "";
        if (field === "")
            return -1;
        const number = /^[-+]?\d+$/.test(field) ? Number(field) : 0;
        if (number === 0)
            throw new ModelError(`${name}:${line}: "${word}": "${field}" is not the number of a ${keywords[i]}`);
        const index = number > 0 ? number - 1 : counts[i] + number;
        if (index < 0 || index >= counts[i])
            throw new ModelError(
                `${name}:${line}: f names ${keywords[i]} ${number}, but there are only ${counts[i]} before it`
            );
        return index;
    });
}

// Reads an OBJ file. Returns its parts, the names of its material files with their lines, and
// warnings. A part has `material`, a name or "", and `line`, where the name stands; positions,
// normals and texcoords (or null) are Float32Arrays, indices a Uint32Array.
export function readObj(name, text) {
    const v = [];
    const vt = [];
    const vn = [];
    const parts = new Map();
    const libraries = [];
    const unknown = new Map();
    const faces = [];
    let material = "";
    let materialLine = 0;

    // Indices may be greater than what has been read so far, so faces are joined afterwards. A
    // negative index counts from the face's place.
    const statements = {
        v: (line, words) =>
            readNumbers(name, line, words, 3, [3, 4, 6, 7], "three numbers, and colours or w after them", v),
        vt: (line, words) => readNumbers(name, line, words, 2, [1, 2, 3], "one to three numbers", vt),
        vn: (line, words) => readNumbers(name, line, words, 3, [3], "three numbers", vn),
        f: (line, words) => {
            if (words.length < 4)
                throw new ModelError(`${name}:${line}: f takes at least three corners, not ${words.length - 1}`);
            const counts = [v.length / 3, vt.length / 2, vn.length / 3];
            faces.push({ line, words, counts, material, materialLine });
        },
        usemtl: (line, words, statement) => {
            material = statement.slice(6).trim();
            materialLine = line;
        },
        mtllib: (line, words, statement) => libraries.push({ line, name: statement.slice(6).trim() }),
        g: () => {},
        o: () => {},
        s: () => {},
    };
    eachStatement(name, text, (line, words, statement) => {
        if (Object.hasOwn(statements, words[0]))
            statements[words[0]](line, words, statement);
        else if (unknown.has(words[0]))
            ++unknown.get(words[0]).count;
        else
            unknown.set(words[0], { line, count: 1 });
    });
    if (faces.length === 0)
        throw new ModelError(`${name}: there are no triangles in it: no line has a face, f`);

    const total = [v.length / 3, vt.length / 2, vn.length / 3];
    for (const face of faces)
        addFace(name, face, total, { v, vt, vn }, parts);
    const warnings = [...unknown].map(
        ([keyword, { line, count }]) =>
            `${name}:${line}: "${keyword}" is not read` + (count > 1 ? ` (${count} lines)` : "")
    );
    return { parts: [...parts.values()].map(finishPart), libraries, warnings };
}

function addFace(name, face, total, numbers, parts) {
    const { line, words } = face;
    const corners = words.slice(1).map((word) =>
        readCorner(name, line, word, word.includes("-") ? face.counts : total)
    );
    const form = (corner) => corner.map((index) => index >= 0).join();
    if (corners.some((corner) => form(corner) !== form(corners[0])))
        throw new ModelError(`${name}:${line}: the corners of the face do not have the same form`);

    const hasTexcoords = corners[0][1] >= 0;
    const key = `${hasTexcoords} ${face.material}`;
    if (!parts.has(key)) {
        parts.set(key, {
            material: face.material,
            line: face.materialLine,
            positions: [],
            normals: [],
            texcoords: hasTexcoords ? [] : null,
            indices: [],
            known: new Map(),
        });
    }
    const part = parts.get(key);
    const indices = corners.map((corner) => vertexOf(name, line, part, corner, numbers));
    for (let i = 2; i < indices.length; ++i)
        part.indices.push(indices[0], indices[i - 1], indices[i]);
}

// The vertex of a part for a corner; corners with the same three indices share one.
function vertexOf(name, line, part, corner, { v, vt, vn }) {
    const key = corner.join();
    const known = part.known.get(key);
    if (known !== undefined)
        return known;
    const index = part.positions.length / 3;
    if (index >= MAX_VERTICES)
        throw new ModelError(`${name}:${line}: more than ${MAX_VERTICES} vertices are too many for this page`);
    part.known.set(key, index);
    part.positions.push(...v.slice(3 * corner[0], 3 * corner[0] + 3));
    // A normal of zeros is computed from the triangles.
    part.normals.push(...(corner[2] < 0 ? [0, 0, 0] : vn.slice(3 * corner[2], 3 * corner[2] + 3)));
    if (part.texcoords)
        part.texcoords.push(...vt.slice(2 * corner[1], 2 * corner[1] + 2));
    return index;
}

function finishPart(part) {
    return {
        material: part.material,
        line: part.line,
        positions: new Float32Array(part.positions),
        normals: new Float32Array(part.normals),
        texcoords: part.texcoords && new Float32Array(part.texcoords),
        indices: new Uint32Array(part.indices),
    };
}

// How many numbers each option of a map's statement takes; "mm" and others of no effect here.
const MAP_OPTIONS = { bm: 1, blendu: 1, blendv: 1, boost: 1, cc: 1, clamp: 1, imfchan: 1, mm: 2, texres: 1, type: 1, o: 3, s: 3, t: 3 };

// The file name of a map's statement, which may contain spaces, behind its options.
function mapName(words) {
    let at = 1;
    while (at < words.length - 1 && words[at].startsWith("-") && Object.hasOwn(MAP_OPTIONS, words[at].slice(1))) {
        const isVector = ["o", "s", "t"].includes(words[at].slice(1));
        let count = MAP_OPTIONS[words[at].slice(1)];
        // Vectors may have one to three numbers.
        if (isVector)
            for (count = 0; count < 3 && Number.isFinite(Number(words[at + 1 + count])); ++count);
        at += 1 + count;
    }
    return words.slice(at).join(" ");
}

const MAP_STATEMENTS = {
    map_kd: "diffuse",
    norm: "normal",
    map_kn: "normal",
    bump: "normal",
    map_bump: "normal",
    map_ks: "specular",
    map_ke: "glow",
};

// Reads an MTL file into `materials`, by name: color, specular, exponent, and maps with the names
// and lines of their files.
export function readMtl(name, text, materials) {
    let current = null;
    const color = (line, words) => {
        if (["spectral", "xyz"].includes(words[1]))
            throw new ModelError(`${name}:${line}: ${words[0]} ${words[1]} is not read; give red, green and blue`);
        if (words.length !== 2 && words.length !== 4)
            throw new ModelError(`${name}:${line}: ${words[0]} takes one or three numbers, not ${words.length - 1}`);
        const numbers = words.slice(1).map((word) => numberOf(name, line, words[0], word));
        return numbers.length === 1 ? [numbers[0], numbers[0], numbers[0]] : numbers;
    };
    eachStatement(name, text, (line, words, statement) => {
        const keyword = words[0].toLowerCase();
        if (keyword === "newmtl") {
            const title = statement.slice(6).trim();
            current = { name: title, ...structuredClone(BARE_MATERIAL), maps: {} };
            materials.set(title, current);
            return;
        }
        const isRead = ["kd", "ks", "ns"].includes(keyword) || Object.hasOwn(MAP_STATEMENTS, keyword);
        if (!isRead)
            return;
        if (!current)
            throw new ModelError(`${name}:${line}: ${words[0]} stands before the first newmtl`);
        if (keyword === "kd") {
            current.color = color(line, words);
        } else if (keyword === "ks") {
            current.specular = color(line, words);
        } else if (keyword === "ns") {
            if (words.length !== 2)
                throw new ModelError(`${name}:${line}: Ns takes one number, not ${words.length - 1}`);
            const exponent = numberOf(name, line, "Ns", words[1]);
            if (exponent >= 1)
                current.exponent = roundToEven(Math.min(exponent, MAX_EXPONENT));
        } else {
            const file = mapName(words);
            if (file === "")
                throw new ModelError(`${name}:${line}: ${words[0]} has no file name`);
            current.maps[MAP_STATEMENTS[keyword]] = { name: file, line, from: name };
        }
    });
}

function roundToEven(value) {
    const low = Math.floor(value);
    if (value - low !== 0.5)
        return Math.round(value);
    return low % 2 === 0 ? low : low + 1;
}

export function materialOf(part, materials) {
    const found = materials.get(part.material);
    if (found)
        return found;
    const bare = part.material === "" ? NO_MATERIAL : BARE_MATERIAL;
    return { name: part.material, ...structuredClone(bare), maps: {} };
}
