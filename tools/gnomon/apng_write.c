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
#define CHUNK_DATA 65536u

enum { CHANNELS = 4, COLOR_TYPE_RGBA = 6, FILTER_SUB = 1, FILTER_UP = 2 };

struct apng {
    output *out;
    uint32_t width, height, frames, rate;
    uint32_t frames_written, sequence; /* fcTL and fdAT share a sequence of numbers */
};

static void put_32(uint8_t *to, uint32_t value)
{
    for (int i = 0; i < 4; ++i)
        to[i] = (uint8_t)(value >> (24 - 8 * i));
}

/* Writes a chunk whose data begins with a sequence number, null if it has none. */
static bool write_chunk(const apng *a, const char type[4], const uint8_t sequence[4],
                        const uint8_t *data, uint32_t size)
{
    uint8_t length[4], sum[4];
    FILE *file = a->out->file;
    const uint32_t before = sequence != NULL ? 4 : 0;
    uLong crc = crc32(0, (const Bytef *)type, 4);
    if (before > 0)
        crc = crc32(crc, sequence, before);
    if (size > 0)
        crc = crc32(crc, data, size);
    put_32(length, before + size);
    put_32(sum, (uint32_t)crc);
    return fwrite(length, 1, 4, file) == 4 && fwrite(type, 1, 4, file) == 4 &&
           (before == 0 || fwrite(sequence, 1, before, file) == before) &&
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
           write_chunk(a, "IHDR", NULL, header, sizeof header) &&
           write_chunk(a, "acTL", NULL, animation, sizeof animation);
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
    return write_chunk(a, "fcTL", NULL, control, sizeof control);
}

/* Writes compressed data. The first frame's chunks are those of a plain PNG. */
static bool write_data(apng *a, const uint8_t *data, uint32_t size)
{
    uint8_t sequence[4];
    if (a->frames_written == 0)
        return write_chunk(a, "IDAT", NULL, data, size);
    put_32(sequence, a->sequence++);
    return write_chunk(a, "fdAT", sequence, data, size);
}

apng *apng_begin(output *o, uint32_t width, uint32_t height, uint32_t frames, uint32_t rate)
{
    apng *a = calloc(1, sizeof *a);
    if (a == NULL) {
        report_fault(o->path, "cannot be written: not enough memory");
        return NULL;
    }
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

int apng_add(apng *a, const uint8_t *bytes, uint64_t size)
{
    errno = 0;
    bool good = write_frame_control(a);
    while (size > 0 && good) {
        const uint32_t piece = size < CHUNK_DATA ? (uint32_t)size : CHUNK_DATA;
        good = write_data(a, bytes, piece);
        bytes += piece;
        size -= piece;
    }
    if (++a->frames_written == a->frames && good)
        good = write_chunk(a, "IEND", NULL, NULL, 0);
    return good ? 0 : report_fault(a->out->path, "cannot be written: %s", strerror(errno));
}

void apng_free(apng *a)
{
    free(a);
}

/* A frame while it is compressed. */
typedef struct packer {
    size_t row_size;
    uint8_t *rows[2];     /* this row and the one above it */
    uint8_t *filtered[2]; /* the row filtered in two ways, each after its number */
    uint8_t *bytes;
    size_t size, capacity;
    z_stream stream;
    bool has_stream;
} packer;

/* Filters a row in both ways. Returns the one whose bytes, as signed numbers, have the smaller sum
 * of magnitudes (PNG, section 12.7). */
static uint8_t *filter(packer *p, const uint8_t *row, const uint8_t *above)
{
    uint64_t sums[2] = {0, 0};
    for (size_t i = 0; i < p->row_size; ++i) {
        const uint8_t left = i < CHANNELS ? 0 : row[i - CHANNELS];
        const uint8_t differences[2] = {(uint8_t)(row[i] - left), (uint8_t)(row[i] - above[i])};
        for (int k = 0; k < 2; ++k) {
            p->filtered[k][i + 1] = differences[k];
            sums[k] += differences[k] < 128 ? differences[k] : 256u - differences[k];
        }
    }
    return p->filtered[sums[1] < sums[0]];
}

static bool grow(packer *p)
{
    const size_t capacity = p->capacity > 0 ? p->capacity + p->capacity / 2 : CHUNK_DATA;
    uint8_t *bytes = realloc(p->bytes, capacity);
    if (bytes == NULL)
        return false;
    p->bytes = bytes;
    p->capacity = capacity;
    return true;
}

/* Compresses bytes; with Z_FINISH, up to the end of the stream. */
static bool compress_bytes(packer *p, uint8_t *bytes, size_t size, int flush)
{
    z_stream *s = &p->stream;
    s->next_in = bytes;
    s->avail_in = (uInt)size;
    for (;;) {
        if (p->size == p->capacity && !grow(p))
            return false;
        const size_t room = p->capacity - p->size;
        s->next_out = p->bytes + p->size;
        s->avail_out = room < CHUNK_DATA ? (uInt)room : CHUNK_DATA;
        const uInt offered = s->avail_out;
        const int state = deflate(s, flush);
        p->size += offered - s->avail_out;
        if (state == Z_STREAM_END)
            return true;
        if (state != Z_OK && state != Z_BUF_ERROR)
            return false;
        if (s->avail_out > 0 && flush != Z_FINISH)
            return true;
    }
}

static bool begin_packing(packer *p, uint32_t width)
{
    memset(p, 0, sizeof *p);
    p->row_size = (size_t)CHANNELS * width;
    for (int k = 0; k < 2; ++k) {
        p->rows[k] = calloc(1, p->row_size);
        p->filtered[k] = malloc(p->row_size + 1);
        if (p->rows[k] == NULL || p->filtered[k] == NULL)
            return false;
    }
    p->filtered[0][0] = FILTER_SUB;
    p->filtered[1][0] = FILTER_UP;
    p->has_stream = deflateInit(&p->stream, Z_DEFAULT_COMPRESSION) == Z_OK;
    return p->has_stream;
}

int apng_compress(const char *path, uint32_t width, uint32_t height, png_row *row,
                  const void *context, uint8_t **bytes, uint64_t *size)
{
    packer p;
    bool good = begin_packing(&p, width);
    for (uint32_t y = 0; y < height && good; ++y) {
        /* The rows begin as zeros, which are above the first one. */
        uint8_t *current = p.rows[y % 2], *above = p.rows[1 - y % 2];
        row(context, y, current);
        good = compress_bytes(&p, filter(&p, current, above), p.row_size + 1, Z_NO_FLUSH);
    }
    good = good && compress_bytes(&p, NULL, 0, Z_FINISH);
    if (p.has_stream)
        deflateEnd(&p.stream);
    for (int k = 0; k < 2; ++k) {
        free(p.rows[k]);
        free(p.filtered[k]);
    }
    *bytes = good ? p.bytes : NULL;
    *size = good ? p.size : 0;
    if (!good)
        free(p.bytes);
    return good ? 0 : report_fault(path, "cannot be written: not enough memory");
}
