/* Reads the orientation from the Exif data of a JPEG or PNG. */
#include "image_exif.h"

#include <stdbool.h>
#include <string.h>

#include "image_file.h"

/* JPEG (ITU-T T.81), table B.1. */
enum { MARKER_SCAN = 0xda, MARKER_APP1 = 0xe1 };

/* PNG, sections 5.2 and 5.3: the length, type and check value around the content of a chunk. */
enum { PNG_MARK_SIZE = 8, PNG_CHUNK_OVERHEAD = 12 };

/* TIFF 6.0, section 2. */
enum { TIFF_HEADER = 8, TIFF_ENTRY = 12, TIFF_SHORT = 3, TAG_ORIENTATION = 0x0112 };

static const uint8_t exif_mark[6] = {'E', 'x', 'i', 'f', 0, 0};

static uint32_t read_16(const uint8_t *b, bool is_big_endian)
{
    return is_big_endian ? (uint32_t)b[0] << 8 | b[1] : (uint32_t)b[1] << 8 | b[0];
}

static uint32_t read_32(const uint8_t *b, bool is_big_endian)
{
    const uint32_t first = read_16(b, is_big_endian), second = read_16(b + 2, is_big_endian);
    return is_big_endian ? first << 16 | second : second << 16 | first;
}

/* Returns the orientation that the first directory of a TIFF file has; 1 if it has none. */
static uint32_t tiff_orientation(const uint8_t *tiff, size_t size)
{
    if (size < TIFF_HEADER || (memcmp(tiff, "II*\0", 4) != 0 && memcmp(tiff, "MM\0*", 4) != 0))
        return 1;
    const bool big = tiff[0] == 'M';
    const size_t at = read_32(tiff + 4, big);
    if (at > size || size - at < 2)
        return 1;
    const uint32_t count = read_16(tiff + at, big);
    const uint8_t *entry = tiff + at + 2;
    for (uint32_t i = 0; i < count && size - (size_t)(entry - tiff) >= TIFF_ENTRY; ++i) {
        const uint32_t value = read_16(entry + 8, big);
        if (read_16(entry, big) == TAG_ORIENTATION)
            return read_16(entry + 2, big) == TIFF_SHORT && value >= 1 && value <= 8 ? value : 1;
        entry += TIFF_ENTRY;
    }
    return 1;
}

/* Returns the orientation that the chunk eXIf of a PNG has; 1 if there is none. */
static uint32_t png_orientation(const uint8_t *bytes, size_t size)
{
    size_t at = PNG_MARK_SIZE;
    while (size - at >= PNG_CHUNK_OVERHEAD) {
        const size_t length = read_32(bytes + at, true);
        if (length > size - at - PNG_CHUNK_OVERHEAD)
            return 1;
        if (memcmp(bytes + at + 4, "eXIf", 4) == 0)
            return tiff_orientation(bytes + at + 8, length);
        at += PNG_CHUNK_OVERHEAD + length;
    }
    return 1;
}

/* Returns the orientation that the first Exif segment of a JPEG has; 1 if there is none. */
static uint32_t jpeg_orientation(const uint8_t *bytes, size_t size)
{
    size_t at = 2;
    /* Segments follow until the first scan: a marker of two bytes, and a length that counts its
     * own two bytes. A marker may have more bytes 0xff before it. */
    while (size - at >= 4 && bytes[at] == 0xff && bytes[at + 1] != MARKER_SCAN) {
        if (bytes[at + 1] == 0xff) {
            ++at;
            continue;
        }
        const size_t length = read_16(bytes + at + 2, true), left = size - at - 2;
        const uint8_t *content = bytes + at + 4;
        if (length < 2 || length > left)
            return 1;
        if (bytes[at + 1] == MARKER_APP1 && length >= 2 + sizeof exif_mark &&
            memcmp(content, exif_mark, sizeof exif_mark) == 0)
            return tiff_orientation(content + sizeof exif_mark, length - 2 - sizeof exif_mark);
        at += 2 + length;
    }
    return 1;
}

uint32_t image_exif_orientation(const uint8_t *bytes, size_t size)
{
    const image_kind kind = image_kind_of(bytes, size);
    return kind == IMAGE_JPEG && size >= 2              ? jpeg_orientation(bytes, size)
           : kind == IMAGE_PNG && size >= PNG_MARK_SIZE ? png_orientation(bytes, size)
                                                        : 1;
}
