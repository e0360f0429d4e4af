// Compares two pictures of one size, and makes a picture of the difference.

// Colours of the difference, as red, green, blue.
export const SAME = [0, 0, 0];
export const COVERAGE = [255, 64, 160];

// Differing pixels are at least this bright, so that the eye finds one step.
const LEAST = 48;

function word(rgb) {
    return (255 << 24 | rgb[2] << 16 | rgb[1] << 8 | rgb[0]) >>> 0;
}

// Compares pictures of RGBA8. `clear` is the background's four bytes. Returns the counts
//   differing  pixels whose bytes differ
//   coverage   those of them that are background in one picture alone
//   largest    the largest difference of a channel, in steps of a byte, not counting coverage
// and `pixels`, the difference as a picture: channels' steps times `factor`.
export function compare(ours, theirs, clear, factor) {
    const a = new Uint32Array(ours.buffer, ours.byteOffset, ours.length / 4);
    const b = new Uint32Array(theirs.buffer, theirs.byteOffset, theirs.length / 4);
    const background = new Uint32Array(new Uint8Array(clear).buffer)[0];
    const shown = new Uint32Array(a.length).fill(word(SAME));
    const result = { differing: 0, coverage: 0, largest: 0 };

    for (let i = 0; i < a.length; ++i) {
        if (a[i] === b[i])
            continue;
        ++result.differing;
        if (a[i] === background || b[i] === background) {
            ++result.coverage;
            shown[i] = word(COVERAGE);
            continue;
        }
        let largest = 0;
        let color = 0xff000000;
        for (let c = 0; c < 4; ++c) {
            const steps = Math.abs(ours[4 * i + c] - theirs[4 * i + c]);
            largest = Math.max(largest, steps);
            if (c < 3)
                color |= Math.max(LEAST, Math.min(255, steps * factor)) << (8 * c);
        }
        result.largest = Math.max(result.largest, largest);
        shown[i] = color;
    }
    return { ...result, pixels: new Uint8Array(shown.buffer) };
}

// Shows a picture whose bottom row is first. Alpha is not shown: a canvas would mix the page in.
export function show(canvas, pixels, width, height) {
    if (canvas.width !== width || canvas.height !== height) {
        canvas.width = width;
        canvas.height = height;
    }
    const from = new Uint32Array(pixels.buffer, pixels.byteOffset, width * height);
    const image = new ImageData(width, height);
    const to = new Uint32Array(image.data.buffer);
    for (let y = 0; y < height; ++y) {
        const row = (height - 1 - y) * width;
        for (let x = 0; x < width; ++x)
            to[y * width + x] = from[row + x] | 0xff000000;
    }
    canvas.getContext("2d").putImageData(image, 0, 0);
}
