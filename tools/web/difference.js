// Compares two pictures of one size, and makes a picture of the difference.

// Colours of the difference, as red, green, blue.
export const SAME = [0, 0, 0];
export const COVERAGE = [255, 64, 160];

function word(rgb) {
    return (255 << 24 | rgb[2] << 16 | rgb[1] << 8 | rgb[0]) >>> 0;
}

// Compares pictures of RGBA8. `clear` is the background's four bytes. Returns the counts
//   differing  pixels whose bytes differ
//   coverage   those of them that are background in one picture alone
//   largest    the largest difference of a channel, in steps of a byte, not counting coverage
//   steps      how many pixels, not counting coverage, differ by so many steps in the channel that differs most
// and `pixels`, the difference as a picture: channels' steps times `factor`.
export function compare(ours, theirs, clear, factor) {
    const a = new Uint32Array(ours.buffer, ours.byteOffset, ours.length / 4);
    const b = new Uint32Array(theirs.buffer, theirs.byteOffset, theirs.length / 4);
    const background = new Uint32Array(new Uint8Array(clear).buffer)[0];
    const shown = new Uint32Array(a.length).fill(word(SAME));
    const result = { differing: 0, coverage: 0, largest: 0, steps: new Uint32Array(256) };

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
                color |= Math.min(255, steps * factor) << (8 * c);
        }
        result.largest = Math.max(result.largest, largest);
        ++result.steps[largest];
        shown[i] = color;
    }
    return { ...result, pixels: new Uint8Array(shown.buffer) };
}
