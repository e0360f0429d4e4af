/* Compresses rows of a PNG in independent segments. */
#include "png_segments.h"

#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum { FILTER_COUNT = 5, CHUNK_OVERHEAD = 12, DEFLATE_MEMORY = 8 };

static size_t pixel_size(png_kind kind)
{
    return kind == PNG_RGBA8 ? 4 : kind == PNG_RGB8 ? 3 : 2;
}

static uint8_t *put_number(uint8_t *to, uint32_t number)
{
    for (int shift = 24; shift >= 0; shift -= 8)
        *to++ = (uint8_t)(number >> shift);
    return to;
}

/* Completes a chunk whose data stands 8 bytes behind its beginning. Returns its size. */
static size_t end_chunk(uint8_t *chunk, const char type[4], size_t size)
{
    put_number(chunk, (uint32_t)size);
    memcpy(chunk + 4, type, 4);
    put_number(chunk + 8 + size, (uint32_t)crc32_z(crc32(0, NULL, 0), chunk + 4, size + 4));
    return size + CHUNK_OVERHEAD;
}

size_t png_segments_head(png_kind kind, uint32_t width, uint32_t height,
                         uint8_t head[PNG_EDGE_SIZE])
{
    static const uint8_t signature[8] = {137, 'P', 'N', 'G', '\r', '\n', 26, '\n'};
    static const uint8_t color_types[] = {2, 6, 0};
    uint8_t *const chunk = head + sizeof signature;
    uint8_t *data = chunk + 8;
    memcpy(head, signature, sizeof signature);
    data = put_number(put_number(data, width), height);
    *data++ = kind == PNG_GREY16 ? 16 : 8;
    *data++ = color_types[kind];
    memset(data, 0, 3); /* deflate, the five filters, not interlaced */
    uint8_t *const stream = chunk + end_chunk(chunk, "IHDR", 13);
    /* The header of a zlib stream: deflate, a window of 32 KiB, the default level. */
    stream[8] = 0x78;
    stream[9] = 0x9c;
    return (size_t)(stream - head) + end_chunk(stream, "IDAT", 2);
}

size_t png_segments_tail(uint32_t adler, uint8_t tail[PNG_EDGE_SIZE])
{
    /* The last block of the stream: empty, with fixed codes. */
    tail[8] = 0x03;
    tail[9] = 0x00;
    put_number(tail + 10, adler);
    const size_t size = end_chunk(tail, "IDAT", 6);
    return size + end_chunk(tail + size, "IEND", 0);
}

uint32_t png_adler_of_nothing(void)
{
    return (uint32_t)adler32(0, NULL, 0);
}

uint32_t png_adler_join(uint32_t first, uint32_t second, uint64_t second_length)
{
    return (uint32_t)adler32_combine(first, second, (z_off_t)second_length);
}

/* Paeth's predictor (section 9.4). */
static int paeth(int left, int above, int corner)
{
    const int estimate = left + above - corner;
    const int to_left = abs(estimate - left), to_above = abs(estimate - above);
    const int to_corner = abs(estimate - corner);
    if (to_left <= to_above && to_left <= to_corner)
        return left;
    return to_above <= to_corner ? above : corner;
}

/* Filters a row of `size` bytes. Returns the sum of the results as distances from zero. */
static uint64_t filter_row(int filter, const uint8_t *row, const uint8_t *above, size_t size,
                           size_t pixel, uint8_t *result)
{
    uint64_t sum = 0;
    result[0] = (uint8_t)filter;
    for (size_t i = 0; i < size; ++i) {
        const int left = i >= pixel ? row[i - pixel] : 0;
        const int up = filter > 1 ? above[i] : 0;
        const int corner = filter == 4 && i >= pixel ? above[i - pixel] : 0;
        int predicted = 0;
        switch (filter) {
        case 1:
            predicted = left;
            break;
        case 2:
            predicted = up;
            break;
        case 3:
            predicted = (left + up) / 2;
            break;
        case 4:
            predicted = paeth(left, up, corner);
            break;
        default:
            break;
        }
        const uint8_t value = (uint8_t)(row[i] - predicted);
        result[i + 1] = value;
        sum += value < 128 ? value : 256u - value;
    }
    return sum;
}

/* Memory for a segment. */
typedef struct work {
    uint8_t *rows[2];
    uint8_t *filtered; /* all rows */
    uint8_t *tried;    /* one row */
    z_stream stream;
} work;

/* Filters a row as the filter does whose results are closest to zero (section 12.7), into `to`. */
static void choose_filter(work *w, int current, bool has_above, size_t size, size_t pixel,
                          uint8_t *to)
{
    const int count = has_above ? FILTER_COUNT : 2;
    uint64_t least = UINT64_MAX;
    for (int filter = 0; filter < count; ++filter) {
        const uint64_t sum =
            filter_row(filter, w->rows[current], w->rows[!current], size, pixel, w->tried);
        if (sum < least) {
            least = sum;
            memcpy(to, w->tried, size + 1);
        }
    }
}

static bool make_room(png_segments *s, size_t size)
{
    if (s->capacity - s->size >= size)
        return true;
    const size_t capacity = 2 * s->capacity + size;
    uint8_t *const bytes = realloc(s->bytes, capacity);
    if (bytes == NULL)
        return false;
    s->bytes = bytes;
    s->capacity = capacity;
    return true;
}

/* Compresses what was filtered and adds it as a chunk. */
static bool add_chunk(work *w, size_t size, png_segments *s)
{
    /* A flush adds an empty block of 5 bytes. */
    const size_t most = deflateBound(&w->stream, (uLong)size) + 16;
    if (deflateReset(&w->stream) != Z_OK || !make_room(s, most + CHUNK_OVERHEAD))
        return false;
    uint8_t *const chunk = s->bytes + s->size;
    w->stream.next_in = w->filtered;
    w->stream.avail_in = (uInt)size;
    w->stream.next_out = chunk + 8;
    w->stream.avail_out = (uInt)most;
    if (deflate(&w->stream, Z_FULL_FLUSH) != Z_OK || w->stream.avail_in != 0 ||
        w->stream.avail_out == 0)
        return false;
    s->size += end_chunk(chunk, "IDAT", most - w->stream.avail_out);
    s->adler = (uint32_t)adler32_z(s->adler, w->filtered, size);
    s->length += size;
    return true;
}

/* Rows from this one to the end of its segment. */
static uint32_t rows_of_segment(uint32_t height, uint32_t row)
{
    return PNG_SEGMENT_ROWS - (row + band_shift(height)) % PNG_SEGMENT_ROWS;
}

/* Filters and compresses one segment. */
static bool make(work *w, png_kind kind, uint32_t width, row_range rows, png_row *row,
                 const void *context, png_segments *s)
{
    const size_t pixel = pixel_size(kind), size = pixel * width;
    for (uint32_t y = 0; y < rows.count; ++y) {
        const int current = (int)(y & 1);
        row(context, rows.first + y, w->rows[current]);
        choose_filter(w, current, y > 0, size, pixel, w->filtered + y * (size + 1));
    }
    return add_chunk(w, rows.count * (size + 1), s);
}

static bool make_all(work *w, png_kind kind, uint32_t width, uint32_t height, row_range rows,
                     png_row *row, const void *context, png_segments *s)
{
    const uint32_t end = rows.first + rows.count;
    bool good = true;
    for (uint32_t y = rows.first; good && y < end;) {
        const uint32_t whole = rows_of_segment(height, y);
        const row_range now = {y, whole < end - y ? whole : end - y};
        good = make(w, kind, width, now, row, context, s);
        y += now.count;
    }
    return good;
}

bool png_segments_make(png_kind kind, uint32_t width, uint32_t height, row_range rows, png_row *row,
                       const void *context, png_segments *result)
{
    const size_t size = 4 * (size_t)width + 1; /* as rows may have 4 bytes a pixel (png_write.h) */
    work w;
    memset(result, 0, sizeof *result);
    result->adler = png_adler_of_nothing();
    memset(&w, 0, sizeof w);
    for (int i = 0; i < 2; ++i)
        w.rows[i] = malloc(size);
    w.filtered = malloc(size * PNG_SEGMENT_ROWS);
    w.tried = malloc(size);
    bool good = w.rows[0] != NULL && w.rows[1] != NULL && w.filtered != NULL && w.tried != NULL;
    if (good && deflateInit2(&w.stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, -MAX_WBITS,
                             DEFLATE_MEMORY, Z_FILTERED) == Z_OK) {
        good = make_all(&w, kind, width, height, rows, row, context, result);
        deflateEnd(&w.stream);
    } else {
        good = false;
    }
    free(w.rows[0]);
    free(w.rows[1]);
    free(w.filtered);
    free(w.tried);
    return good;
}

void png_segments_free(png_segments *segments)
{
    free(segments->bytes);
    memset(segments, 0, sizeof *segments);
}
