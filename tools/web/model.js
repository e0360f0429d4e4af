// Reads files that were dropped or chosen into a module: a model, and the images that it needs,
// found among the same files by name.
import { GnomonError } from "./engine.js";
import { decodeMap } from "./maps.js";

const MAX_BYTES = 256 * 1024 * 1024;
const IMAGE = /\.(tga|png|jpe?g|webp|bmp|gif|avif)$/i;

// A module needs of images only the names.
async function contentsOf(file) {
    if (IMAGE.test(file.name))
        return { name: file.name, bytes: new Uint8Array(0) };
    if (file.size > MAX_BYTES)
        throw new GnomonError(`${file.name}: ${file.size} bytes are too many for this page`);
    return { name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) };
}

// Reads a model from File objects with an engine, whose "dropped" it is then. Returns what other
// engines load, { files, images }, with `about`: what page_model_describe says, all warnings, and
// the names of the images.
export async function readModel(engine, files) {
    const contents = await Promise.all(files.map(contentsOf));
    const { name, images: wanted } = engine.readModel(contents);
    const warnings = [];
    const images = [];
    for (const { number, name: title, file, at, size } of wanted) {
        const isInside = file === undefined;
        const source = isInside ? new File([engine.bytes(at, size).slice()], `${name}: ${title}`) : files[file];
        const image = await decodeMap(source);
        if (image.orientation !== 1)
            warnings.push(`${image.name}: its Exif orientation ${image.orientation} is not applied`);
        images.push({ number, ...image });
    }
    engine.completeModel(images);
    const about = engine.describeModel();
    about.warnings.push(...warnings);
    about.images = images.map((image) => image.name);
    return { files: contents, images, about };
}

// Returns what is said of a model: a sentence, and a list of warnings if there are any.
export function describeModel({ about }) {
    const count = (n, word, words = `${word}s`) => `${n.toLocaleString("en")} ${n === 1 ? word : words}`;
    const counts = ["triangle", "line", "point"].filter((word) => about[`${word}s`] > 0)
        .map((word) => count(about[`${word}s`], word));
    counts.push(count(about.vertices, "vertex", "vertices"), count(about.parts, "part"));
    const maps = [...new Set(about.images)].join(", ") || "no maps";
    const text = `${about.name}: ${counts.join(", ")}, ${maps}.`;
    const list = document.createElement("ul");
    for (const warning of about.warnings)
        list.append(Object.assign(document.createElement("li"), { textContent: warning }));
    return about.warnings.length > 0 ? [text, list] : [text];
}
