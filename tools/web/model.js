// Turns files that were dropped or chosen into a model: an OBJ, and the materials and maps that it
// names, found among the same files by name.
import { MAP_KINDS } from "./engine.js";
import { decodeMap } from "./maps.js";
import { materialOf, ModelError, readMtl, readObj } from "./obj.js";

// gnomon render finds maps that no material names by these endings of file names.
const SUFFIXES = { diffuse: "_diffuse", normal: "_nm_tangent", specular: "_spec", glow: "_glow" };
const ENDINGS = [".tga", ".png", ".jpg"];

const MAX_BYTES = 256 * 1024 * 1024;

// Folders are left out, backslashes are those of some exporters, and case differs between systems.
function plainName(path) {
    return path.replaceAll("\\", "/").split("/").pop().toLowerCase();
}

function find(files, name) {
    return files.find((file) => plainName(file.name) === plainName(name));
}

async function textOf(file) {
    if (file.size > MAX_BYTES)
        throw new ModelError(`${file.name}: ${file.size} bytes are too many for this page`);
    return file.text();
}

// Reads a model from File objects. Returns { name, parts, warnings, triangles }; throws ModelError.
export async function readModel(files) {
    const objs = files.filter((file) => plainName(file.name).endsWith(".obj"));
    if (objs.length === 0) {
        const names = files.map((file) => file.name).join(", ");
        throw new ModelError(`${names || "nothing"}: there is no OBJ file among these`);
    }
    if (objs.length > 1)
        throw new ModelError(`${objs.map((file) => file.name).join(", ")}: drop one OBJ file at a time`);

    const [obj] = objs;
    const read = readObj(obj.name, await textOf(obj));
    const warnings = read.warnings;
    const materials = new Map();
    for (const library of read.libraries)
        await readLibrary(obj, library, files, materials, warnings);

    const decoded = new Map();
    const parts = [];
    for (const part of read.parts) {
        if (part.material !== "" && !materials.has(part.material))
            warnings.push(`${obj.name}:${part.line}: no material file has the material "${part.material}"`);
        const material = materialOf(part, materials);
        parts.push({
            ...part,
            color: material.color,
            specular: material.specular,
            exponent: material.exponent,
            maps: part.texcoords ? await mapsOf(obj, material, files, decoded, warnings) : {},
        });
    }
    const triangles = parts.reduce((sum, part) => sum + part.indices.length / 3, 0);
    return { name: obj.name, parts, warnings: [...new Set(warnings)], triangles };
}

// A mtllib line names one file, with spaces in it or not, or several files.
async function readLibrary(obj, library, files, materials, warnings) {
    const names = find(files, library.name) ? [library.name] : library.name.split(/\s+/);
    for (const name of names) {
        const file = find(files, name);
        if (file)
            readMtl(file.name, await textOf(file), materials);
        else
            warnings.push(`${obj.name}:${library.line}: the file "${name}" was not dropped with it; its materials are missing`);
    }
}

async function mapsOf(obj, material, files, decoded, warnings) {
    const maps = {};
    for (const kind of MAP_KINDS) {
        const named = material.maps[kind];
        const file = named ? find(files, named.name) : conventional(obj, kind, files);
        if (named && !file) {
            warnings.push(`${named.from}:${named.line}: the map "${named.name}" was not dropped with it; drawn without`);
            continue;
        }
        if (!file)
            continue;
        if (!decoded.has(file))
            decoded.set(file, await decodeMap(file));
        const map = decoded.get(file);
        if (map.orientation !== 1)
            warnings.push(`${file.name}: its Exif orientation ${map.orientation} is not applied`);
        if (kind === "normal" && isGrey(map)) {
            warnings.push(`${file.name}: it holds heights, not normals, and is not used`);
            continue;
        }
        maps[kind] = map;
    }
    return maps;
}

function conventional(obj, kind, files) {
    const stem = plainName(obj.name).replace(/\.obj$/, "");
    for (const ending of ENDINGS) {
        const file = find(files, stem + SUFFIXES[kind] + ending);
        if (file)
            return file;
    }
    return null;
}

function isGrey({ texels }) {
    for (let i = 0; i < texels.length; i += 4)
        if (texels[i] !== texels[i + 1] || texels[i] !== texels[i + 2])
            return false;
    return true;
}

// Returns what is said of a model: a sentence, and a list of warnings if there are any.
export function describeModel(model) {
    const vertices = model.parts.reduce((sum, part) => sum + part.positions.length / 3, 0);
    const count = (n, word) => `${n.toLocaleString("en")} ${word}${n === 1 ? "" : "s"}`;
    const maps = new Set(model.parts.flatMap((part) => Object.values(part.maps).map((map) => map.name)));
    const text =
        `${model.name}: ${count(model.triangles, "triangle")}, ${vertices.toLocaleString("en")} vertices, ` +
        `${count(model.parts.length, "part")}, ${maps.size > 0 ? [...maps].join(", ") : "no maps"}.`;
    const list = document.createElement("ul");
    for (const warning of model.warnings)
        list.append(Object.assign(document.createElement("li"), { textContent: warning }));
    return model.warnings.length > 0 ? [text, list] : [text];
}
