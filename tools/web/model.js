// Reads files that were dropped or chosen into a module: a model, and the images that it needs,
// found among the same files by name.
import { GnomonError } from "./engine.js";
import { decodeMap } from "./maps.js";

const MAX_BYTES = 256 * 1024 * 1024;
const TELL_EACH = 100; // milliseconds from one sentence about progress to the next
const IMAGE = /\.(tga|png|jpe?g|webp|bmp|gif|avif)$/i;

const megabytes = (bytes) => (bytes / 1e6).toFixed(bytes < 1e7 ? 1 : 0);

// The bytes of a file, in parts. told(count) is called with the bytes of each part; the promise that it returns is
// waited for.
async function bytesOf(file, told) {
    const bytes = new Uint8Array(file.size);
    const reader = file.stream().getReader();
    let at = 0;
    for (;;) {
        const { done, value } = await reader.read();
        if (done)
            return bytes.subarray(0, at);
        bytes.set(value, at);
        at += value.length;
        await told(value.length);
    }
}

// Reads files one after the other. A module needs of images only the names.
async function contentsOf(files, tell) {
    const isRead = (file) => !IMAGE.test(file.name);
    const total = files.filter(isRead).reduce((sum, file) => sum + file.size, 0);
    let read = 0;
    let toldAt = performance.now();
    const contents = [];
    for (const file of files) {
        if (isRead(file) && file.size > MAX_BYTES)
            throw new GnomonError(`${file.name}: ${file.size} bytes are too many for this page`);
        const told = async (count) => {
            read += count;
            if (performance.now() - toldAt < TELL_EACH)
                return;
            await tell(`Reading ${file.name}: ${megabytes(read)} of ${megabytes(total)} MB …`, read / total);
            toldAt = performance.now();
        };
        contents.push({ name: file.name, bytes: isRead(file) ? await bytesOf(file, told) : new Uint8Array(0) });
    }
    return contents;
}

// Reads a model from File objects with an engine, whose "dropped" it is then. tell(text, share) is called with what is
// being done, and waited for; a share goes from 0 to 1, or is null where it is not known. Returns what other
// engines load, { files, images }, with `about`: what page_model_describe says, all warnings, and the names of
// the images.
export async function readModel(engine, files, tell = async () => {}) {
    const contents = await contentsOf(files, tell);
    const size = contents.reduce((sum, { bytes }) => sum + bytes.length, 0);
    await tell(`Building the model from ${megabytes(size)} MB …`, null);
    const { name, images: wanted } = engine.readModel(contents);
    const warnings = [];
    const images = [];
    for (const { number, name: title, file, at, size } of wanted) {
        await tell(`Decoding the map ${images.length + 1} of ${wanted.length}: ${title} …`, images.length / wanted.length);
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
