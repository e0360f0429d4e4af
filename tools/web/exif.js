// The orientation that a camera writes into a JPEG (Exif 2.32, section 4.6.4). The page does not
// apply it, as the command does not: tools/gnomon/image_exif.h says why.

const MARKER_SCAN = 0xda;
const MARKER_APP1 = 0xe1;
const EXIF_MARK = "Exif\0\0";
const TAG_ORIENTATION = 0x0112;
const TYPE_SHORT = 3;

const textAt = (bytes, at, length) => String.fromCharCode(...bytes.subarray(at, at + length));

// Returns where the two bytes of the orientation are, and in which order; null if there is none.
// `tiff` holds a TIFF file (TIFF 6.0, section 2).
function orientationIn(tiff) {
    const order = textAt(tiff, 0, 4);
    if (tiff.length < 8 || (order !== "II*\0" && order !== "MM\0*"))
        return null;
    const view = new DataView(tiff.buffer, tiff.byteOffset, tiff.length);
    const isLittleEndian = order[0] === "I";
    const directory = view.getUint32(4, isLittleEndian);
    if (directory + 2 > tiff.length)
        return null;
    const count = view.getUint16(directory, isLittleEndian);
    for (let i = 0; i < count && directory + 2 + 12 * (i + 1) <= tiff.length; ++i) {
        const entry = directory + 2 + 12 * i;
        if (view.getUint16(entry, isLittleEndian) === TAG_ORIENTATION)
            return view.getUint16(entry + 2, isLittleEndian) === TYPE_SHORT
                ? { view, at: entry + 8, isLittleEndian }
                : null;
    }
    return null;
}

// Returns the orientation of a JPEG, 1 to 8, and makes it 1, as stored, in `bytes`; 1 if the bytes
// are not a JPEG or name none.
export function resetOrientation(bytes) {
    if (bytes.length < 4 || bytes[0] !== 0xff || bytes[1] !== 0xd8)
        return 1;
    // Segments follow until the first scan: a marker of two bytes, and a length that counts its own
    // two bytes. A marker may have more bytes 0xff before it.
    for (let at = 2; at + 4 <= bytes.length && bytes[at] === 0xff && bytes[at + 1] !== MARKER_SCAN;) {
        if (bytes[at + 1] === 0xff) {
            ++at;
            continue;
        }
        const length = bytes[at + 2] << 8 | bytes[at + 3];
        const end = at + 2 + length;
        if (length < 2 || end > bytes.length)
            return 1;
        if (bytes[at + 1] === MARKER_APP1 && textAt(bytes, at + 4, 6) === EXIF_MARK && length >= 8) {
            const found = orientationIn(bytes.subarray(at + 10, end));
            const value = found ? found.view.getUint16(found.at, found.isLittleEndian) : 1;
            if (value < 1 || value > 8)
                return 1;
            found?.view.setUint16(found.at, 1, found.isLittleEndian);
            return value;
        }
        at = end;
    }
    return 1;
}
