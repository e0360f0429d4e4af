/* PNG files that several ranks write: rows are compressed in segments that depend on nothing before
 * them, each an IDAT chunk of its own. Segments have a fixed number of rows, so the file's bytes do
 * not depend on who compresses which segment (PNG specification, third edition; RFC 1950, 1951). */
#ifndef PNG_SEGMENTS_H
#define PNG_SEGMENTS_H

#include <stdbool.h>

#include "bands.h"
#include "png_write.h"

/* Rows of a segment, which is a unit of band_of_rank. For a segment's first row no filter looks at
 * the row above. */
#define PNG_SEGMENT_ROWS 16

/* The largest head and tail, in bytes. */
#define PNG_EDGE_SIZE 64

/* Consecutive segments as bytes of the file, and the checksum of what they hold. */
typedef struct png_segments {
    uint8_t *bytes; /* from malloc */
    size_t size, capacity;
    uint32_t adler;  /* Adler-32 */
    uint64_t length; /* of the data before compression */
} png_segments;

/* Compresses rows of a picture of this height, which begin at a segment's first. Returns false if
 * there is not enough memory; free with png_segments_free either way. */
bool png_segments_make(png_kind kind, uint32_t width, uint32_t height, row_range rows, png_row *row,
                       const void *context, png_segments *result);
void png_segments_free(png_segments *segments);

/* What stands before the first segment; returns its size. */
size_t png_segments_head(png_kind kind, uint32_t width, uint32_t height,
                         uint8_t head[PNG_EDGE_SIZE]);

/* What stands after the last segment; `adler` is the checksum of all segments. */
size_t png_segments_tail(uint32_t adler, uint8_t tail[PNG_EDGE_SIZE]);

/* The checksum of an empty file, and that of two consecutive pieces. */
uint32_t png_adler_of_nothing(void);
uint32_t png_adler_join(uint32_t first, uint32_t second, uint64_t second_length);

#endif
