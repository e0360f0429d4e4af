/* Writes animated PNG files with zlib. */
#include "apng_write.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "report.h"

/* Bytes of compressed data in a chunk. */
#define CHUNK_DATA 65536

enum { CHANNELS = 4, COLOR_TYPE_RGBA = 6, FILTER_SUB = 1, FILTER_UP = 2 };

struct apng {
    output *out;
    uint32_t width, height, frames, rate;
    uint32_t frames_written, sequence; /* fcTL and fdAT share a sequence of numbers */
    uint8_t *rows[2];                  /* this row and the one above it */
    uint8_t *filtered[2];              /* the row filtered in two ways, each after its number */
    uint8_t *chunk;                    /* 4 bytes for the sequence number, then data */
    z_stream stream;
    bool has_stream;
};

static void put_32(uint8_t *to, uint32_t value)
{
    for (int i = 0; i < 4; ++i)
        to[i] = (uint8_t)(value >> (24 - 8 * i));
}

static bool write_chunk(const apng *a, const char type[4], const uint8_t *data, uint32_t size)
{
    uint8_t length[4], sum[4];
    FILE *file = a->out->file;
    uLong crc = crc32(0, (const Bytef *)type, 4);
    if (size > 0)
        crc = crc32(crc, data, size);
    put_32(length, size);
    put_32(sum, (uint32_t)crc);
    return fwrite(length, 1, 4, file) == 4 && fwrite(type, 1, 4, file) == 4 &&
           (size == 0 || fwrite(data, 1, size, file) == size) && fwrite(sum, 1, 4, file) == 4;
}

static bool write_start(const apng *a)
{
    static const uint8_t mark[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    uint8_t header[13] = {0}, animation[8] = {0};
    put_32(header, a->width);
    put_32(header + 4, a->height);
    header[8] = 8;
    header[9] = COLOR_TYPE_RGBA;
    put_32(animation, a->frames);
    return fwrite(mark, 1, sizeof mark, a->out->file) == sizeof mark &&
           write_chunk(a, "IHDR", header, sizeof header) &&
           write_chunk(a, "acTL", animation, sizeof animation);
}

/* The whole picture, shown for one part in `rate` of a second; it replaces what was there. */
static bool write_frame_control(apng *a)
{
    uint8_t control[26] = {0};
    put_32(control, a->sequence++);
    put_32(control + 4, a->width);
    put_32(control + 8, a->height);
    control[21] = 1;
    control[22] = (uint8_t)(a->rate >> 8);
    control[23] = (uint8_t)a->rate;
    return write_chunk(a, "fcTL", control, sizeof control);
}

/* Writes the compressed data that is waiting. The first frame's chunks are those of a plain PNG. */
static bool write_data(apng *a)
{
    const uint32_t size = CHUNK_DATA - a->stream.avail_out;
    bool good = true;
    if (size > 0 && a->frames_written == 0) {
        good = write_chunk(a, "IDAT", a->chunk + 4, size);
    } else if (size > 0) {
        put_32(a->chunk, a->sequence++);
        good = write_chunk(a, "fdAT", a->chunk, size + 4);
    }
    a->stream.next_out = a->chunk + 4;
    a->stream.avail_out = CHUNK_DATA;
    return good;
}

/* Filters a row in both ways. Returns the one whose bytes, as signed numbers, have the smaller sum
 * of magnitudes (PNG, section 12.7). */
static uint8_t *filter(apng *a, const uint8_t *row, const uint8_t *above)
{
    const size_t size = (size_t)CHANNELS * a->width;
    uint64_t sums[2] = {0, 0};
    for (size_t i = 0; i < size; ++i) {
        const uint8_t left = i < CHANNELS ? 0 : row[i - CHANNELS];
        const uint8_t differences[2] = {(uint8_t)(row[i] - left), (uint8_t)(row[i] - above[i])};
        for (int k = 0; k < 2; ++k) {
            a->filtered[k][i + 1] = differences[k];
            sums[k] += differences[k] < 128 ? differences[k] : 256u - differences[k];
        }
    }
    return a->filtered[sums[1] < sums[0]];
}

/* Compresses bytes; with Z_FINISH, up to the end of the stream. */
static bool compress_bytes(apng *a, uint8_t *bytes, size_t size, int flush)
{
    a->stream.next_in = bytes;
    a->stream.avail_in = (uInt)size;
    for (;;) {
        const int state = deflate(&a->stream, flush);
        if (state == Z_STREAM_END)
            return write_data(a);
        if (state != Z_OK && state != Z_BUF_ERROR)
            return false;
        if (a->stream.avail_out == 0) {
            if (!write_data(a))
                return false;
        } else if (flush != Z_FINISH) {
            return true;
        }
    }
}

apng *apng_begin(output *o, uint32_t width, uint32_t height, uint32_t frames, uint32_t rate)
{
    const size_t size = (size_t)CHANNELS * width;
    apng *a = calloc(1, sizeof *a);
    bool good = a != NULL;
    for (int k = 0; k < 2 && good; ++k) {
        a->rows[k] = malloc(size);
        a->filtered[k] = malloc(size + 1);
        good = a->rows[k] != NULL && a->filtered[k] != NULL;
    }
    if (good) {
        a->chunk = malloc(CHUNK_DATA + 4);
        a->has_stream = a->chunk != NULL && deflateInit(&a->stream, Z_DEFAULT_COMPRESSION) == Z_OK;
        good = a->has_stream;
    }
    if (!good) {
        apng_free(a);
        report_fault(o->path, "cannot be written: not enough memory");
        return NULL;
    }
    a->filtered[0][0] = FILTER_SUB;
    a->filtered[1][0] = FILTER_UP;
    a->out = o;
    a->width = width;
    a->height = height;
    a->frames = frames;
    a->rate = rate;
    errno = 0;
    if (write_start(a))
        return a;
    report_fault(o->path, "cannot be written: %s", strerror(errno));
    apng_free(a);
    return NULL;
}

int apng_add(apng *a, png_row *row, const void *context)
{
    const size_t size = (size_t)CHANNELS * a->width;
    errno = 0;
    bool good = write_frame_control(a) && deflateReset(&a->stream) == Z_OK;
    a->stream.next_out = a->chunk + 4;
    a->stream.avail_out = CHUNK_DATA;
    memset(a->rows[1], 0, size); /* above the first row */
    for (uint32_t y = 0; y < a->height && good; ++y) {
        uint8_t *current = a->rows[y % 2], *above = a->rows[1 - y % 2];
        row(context, y, current);
        good = compress_bytes(a, filter(a, current, above), size + 1, Z_NO_FLUSH);
    }
    good = good && compress_bytes(a, NULL, 0, Z_FINISH);
    if (++a->frames_written == a->frames && good)
        good = write_chunk(a, "IEND", NULL, 0);
    return good ? 0 : report_fault(a->out->path, "cannot be written: %s", strerror(errno));
}

void apng_free(apng *a)
{
    if (a == NULL)
        return;
    if (a->has_stream)
        deflateEnd(&a->stream);
    for (int k = 0; k < 2; ++k) {
        free(a->rows[k]);
        free(a->filtered[k]);
    }
    free(a->chunk);
    free(a);
}
