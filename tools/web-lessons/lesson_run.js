// Runs one lesson in the module of all lessons, without a page: for lessons.js and for the tests.
// lesson_page.h says what the module's functions do.

const decoder = new TextDecoder();
const encoder = new TextEncoder();

// Returns the text that ends with a zero at an address.
function textAt(memory, address) {
    const bytes = new Uint8Array(memory.buffer, address);
    return decoder.decode(bytes.subarray(0, bytes.indexOf(0)));
}

function writeName(lesson, name) {
    const bytes = encoder.encode(name);
    const address = lesson.lesson_name();
    new Uint8Array(lesson.memory.buffer).set(bytes, address);
    new Uint8Array(lesson.memory.buffer)[address + bytes.length] = 0;
    return address;
}

function addFile(lesson, name, bytes) {
    const address = lesson.lesson_add_file(writeName(lesson, name), bytes.length);
    if (!address)
        throw new Error(`There is no room for the file ${name}.`);
    new Uint8Array(lesson.memory.buffer).set(bytes, address);
}

// Reads a TGA as tga_write writes it: 24 bits, the bottom row first. Returns rows from the top, RGBA.
function readPicture(tga) {
    const width = tga[12] | tga[13] << 8, height = tga[14] | tga[15] << 8;
    if (tga[2] !== 2 || tga[16] !== 24 || tga.length !== 18 + 3 * width * height)
        throw new Error("The lesson wrote a picture that this page cannot read.");
    const rgba = new Uint8ClampedArray(4 * width * height);
    for (let y = 0; y < height; ++y) {
        let from = 18 + 3 * width * (height - 1 - y);
        let to = 4 * width * y;
        for (let x = 0; x < width; ++x, from += 3, to += 4) {
            rgba[to] = tga[from + 2];
            rgba[to + 1] = tga[from + 1];
            rgba[to + 2] = tga[from];
            rgba[to + 3] = 255;
        }
    }
    return {width, height, rgba};
}

function readSliders(lesson) {
    const sliders = [];
    for (let i = 0; i < lesson.lesson_slider_count(); ++i)
        sliders.push({
            name: textAt(lesson.memory, lesson.lesson_slider_name(i)),
            value: lesson.lesson_slider_value(i),
            first: lesson.lesson_slider_first(i),
            least: lesson.lesson_slider_least(i),
            most: lesson.lesson_slider_most(i),
            isInt: lesson.lesson_slider_is_int(i) !== 0,
        });
    return sliders;
}

// Runs lesson `number` of a compiled WebAssembly.Module.
//   files   names as the lesson opens them, with their bytes (Map)
//   moved   names of the sliders that were moved, with their values (Map)
//   input   text for stdin
// Returns status, printed and errors (texts), tga (bytes, or null), picture (see above, or null) and
// sliders. Throws an error if the lesson ends in another way than by returning or calling exit.
export function runLesson(module, number, {files = new Map(), moved = new Map(), input = ""} = {}) {
    const lesson = new WebAssembly.Instance(module).exports;

    for (const [name, bytes] of files)
        addFile(lesson, name, bytes);
    addFile(lesson, "stdin", encoder.encode(input));
    for (const [name, value] of moved)
        if (lesson.lesson_move_slider(writeName(lesson, name), value))
            throw new Error(`There are too many sliders for ${name}.`);

    let status;
    try {
        status = lesson.lesson_run(number);
    } catch (trap) {
        status = lesson.lesson_exit_status();
        if (!(trap instanceof WebAssembly.RuntimeError) || status < 0)
            throw new Error(`The lesson stopped: ${trap.message}.`, {cause: trap});
    }
    const bytes = (address, size) => new Uint8Array(lesson.memory.buffer).slice(address, address + size);
    const printed = (errors) =>
        decoder.decode(bytes(lesson.lesson_printed(errors), lesson.lesson_printed_size(errors)));
    const size = lesson.lesson_picture_size();
    const tga = size ? bytes(lesson.lesson_picture(), size) : null;
    return {
        status, printed: printed(0), errors: printed(1), tga,
        picture: tga && readPicture(tga), sliders: readSliders(lesson),
    };
}
