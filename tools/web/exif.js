// The orientation that a camera writes into a JPEG or PNG (Exif 2.32, section 4.6.4). The page does
// not apply it, as the command does not: tools/gnomon/image_exif.h says why.

const MARKER_SCAN = 0xda;
const MARKER_APP1 = 0xe1;
const EXIF_MARK = "Exif\0\0";
const TAG_ORIENTATION = 0x0112;
const TYPE_SHORT = 3;

const PNG_MARK = "\x89PNG\r\n\x1a\n";
const PNG_CHUNK_OVERHEAD = 12;

const textAt = (bytes, at, length) => String.fromCharCode(...bytes.subarray(at, at + length));

// Returns the orientation, 1 to 8, that a TIFF file has in its first directory (TIFF 6.0, section 2);
// 1, as stored, if it has none.
function orientationIn(tiff) {
    const order = textAt(tiff, 0, 4);
    if (tiff.length < 8 || (order !== "II*\0" && order !== "MM\0*"))
        return 1;
    const view = new DataView(tiff.buffer, tiff.byteOffset, tiff.length);
    const isLittleEndian = order[0] === "I";
    const directory = view.getUint32(4, isLittleEndian);
    if (directory + 2 > tiff.length)
        return 1;
    const count = view.getUint16(directory, isLittleEndian);
    for (let i = 0; i < count && directory + 2 + 12 * (i + 1) <= tiff.length; ++i) {
        const entry = directory + 2 + 12 * i;
        if (view.getUint16(entry, isLittleEndian) !== TAG_ORIENTATION)
            continue;
        const value = view.getUint16(entry + 8, isLittleEndian);
        return view.getUint16(entry + 2, isLittleEndian) === TYPE_SHORT && value >= 1 && value <= 8 ? value : 1;
    }
    return 1;
}

// Returns where the first Exif data of a JPEG is; null if there is none. Segments follow until the
// first scan: a marker of two bytes, and a length that counts its own two bytes. A marker may have
// more bytes 0xff before it.
function exifOfJpeg(bytes) {
    for (let at = 2; at + 4 <= bytes.length && bytes[at] === 0xff && bytes[at + 1] !== MARKER_SCAN;) {
        if (bytes[at + 1] === 0xff) {
            ++at;
            continue;
        }
        const length = bytes[at + 2] << 8 | bytes[at + 3];
        const end = at + 2 + length;
        if (length < 2 || end > bytes.length)
            return null;
        if (bytes[at + 1] === MARKER_APP1 && length >= 8 && textAt(bytes, at + 4, 6) === EXIF_MARK)
            return { at, end, tiff: bytes.subarray(at + 10, end) };
        at = end;
    }
    return null;
}

// The same for the chunk eXIf of a PNG.
function exifOfPng(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    for (let at = PNG_MARK.length; at + PNG_CHUNK_OVERHEAD <= bytes.length;) {
        const length = view.getUint32(at);
        const end = at + PNG_CHUNK_OVERHEAD + length;
        if (end > bytes.length)
            return null;
        if (textAt(bytes, at + 4, 4) === "eXIf")
            return { at, end, tiff: bytes.subarray(at + 8, at + 8 + length) };
        at = end;
    }
    return null;
}

// Returns the orientation of a JPEG or PNG, 1 to 8, and the file without the Exif data that holds it.
// The orientation is 1, as stored, if the file names none or is of another kind.
export function withoutOrientation(bytes) {
    const found = textAt(bytes, 0, 3) === "\xff\xd8\xff" ? exifOfJpeg(bytes)
        : textAt(bytes, 0, 8) === PNG_MARK ? exifOfPng(bytes)
            : null;
    const orientation = found ? orientationIn(found.tiff) : 1;
    if (orientation === 1)
        return { orientation, bytes };
    const rest = new Uint8Array(bytes.length - (found.end - found.at));
    rest.set(bytes.subarray(0, found.at));
    rest.set(bytes.subarray(found.end), found.at);
    return { orientation, bytes: rest };
}
