/* Writes one picture file by all ranks. */
#include "rows_file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "png_segments.h"
#include "report.h"

enum { KIND_OF_BYTES = 100 };

/* What a rank sends at a time. */
#define PIECE ((uint64_t)1 << 20)

#define TGA_MAX_SIZE 65535
#define PNG_MAX_SIZE 0x7fffffff

const char *rows_file_refusal(picture_format format, uint32_t width, uint32_t height)
{
    const uint32_t size = width > height ? width : height;
    if (format == PICTURE_TGA && size > TGA_MAX_SIZE)
        return "a TGA file has at most 65535x65535 pixels";
    if (format == PICTURE_PNG && size > PNG_MAX_SIZE)
        return "a PNG file has at most 2147483647x2147483647 pixels";
    return NULL;
}

static int fail(const rows_file *f, const char *reason)
{
    return report_fault(f->path, "cannot be written: %s", reason);
}

static int write_stream(const rows_file *f, const void *bytes, size_t size)
{
    errno = 0;
    return fwrite(bytes, 1, size, f->output.file) == size ? 0 : fail(f, strerror(errno));
}

/* Writes bytes of this rank at an offset of the file that all ranks have open. */
static int write_at(const rows_file *f, uint64_t offset, const void *bytes, uint64_t size)
{
    char reason[256];
    return ranks_file_write(f->file, offset, bytes, size, reason) ? 0 : fail(f, reason);
}

/* Rank 0 writes the bytes of all ranks, in order, and goes on receiving after a fault. */
static int write_in_order(const rows_file *f, const uint8_t *bytes, uint64_t size)
{
    uint64_t *sizes = calloc(ranks_count(), sizeof *sizes);
    uint8_t *piece = malloc(PIECE);
    int fault = sizes == NULL || piece == NULL ? fail(f, "not enough memory") : 0;
    if (ranks_agree(fault) != 0) {
        free(sizes);
        free(piece);
        return EXIT_FAULT;
    }
    ranks_collect(size, sizes);
    if (ranks_number() == 0 && size > 0)
        fault = write_stream(f, bytes, (size_t)size);
    for (uint32_t from = 1; from < ranks_count(); ++from) {
        for (uint64_t at = 0; at < sizes[from]; at += PIECE) {
            const uint64_t left = sizes[from] - at, now = left < PIECE ? left : PIECE;
            if (ranks_number() == from)
                ranks_send(0, KIND_OF_BYTES, bytes + at, now);
            if (ranks_number() != 0)
                continue;
            ranks_receive(from, KIND_OF_BYTES, piece, now);
            if (fault == 0)
                fault = write_stream(f, piece, (size_t)now);
        }
    }
    free(sizes);
    free(piece);
    return fault;
}

/* Rank 0 writes the file's head or tail. */
static int write_edge(const rows_file *f, uint64_t offset, const uint8_t *bytes, size_t size)
{
    if (ranks_number() != 0 || size == 0)
        return 0;
    return f->file != NULL ? write_at(f, offset, bytes, size) : write_stream(f, bytes, size);
}

static size_t head_of(const rows_file *f, uint8_t head[PICTURE_EDGE_SIZE])
{
    return f->format == PICTURE_PNG
               ? png_segments_head(f->kind, f->width, f->height, head)
               : picture_plain_head(f->format, f->kind, f->width, f->height, head);
}

/* Opens, at all ranks, the file that rank 0 has made. */
static int open_at_all(rows_file *f)
{
    char reason[256];
    uint64_t length = f->output.temporary != NULL ? strlen(f->output.temporary) + 1 : 0;
    ranks_share(0, &length, sizeof length);
    if (length == 0)
        return 0;
    char *name = malloc((size_t)length);
    if (ranks_agree(name == NULL ? fail(f, "not enough memory") : 0) != 0) {
        free(name);
        return EXIT_FAULT;
    }
    if (ranks_number() == 0)
        memcpy(name, f->output.temporary, (size_t)length);
    ranks_share(0, name, length);
    f->file = ranks_file_open(name, reason);
    int fault = f->file == NULL;
    if (reason[0] != '\0')
        fault = fail(f, reason);
    free(name);
    return ranks_agree(fault);
}

int rows_file_begin(rows_file *f, const char *path, picture_format format, png_kind kind,
                    uint32_t width, uint32_t height)
{
    uint8_t head[PICTURE_EDGE_SIZE];
    memset(f, 0, sizeof *f);
    f->path = path;
    f->format = format;
    f->kind = kind;
    f->width = width;
    f->height = height;
    f->adler = png_adler_of_nothing();
    int fault = ranks_agree(ranks_number() == 0 ? output_open(&f->output, path) : 0);
    if (fault == 0)
        fault = open_at_all(f);
    if (fault == 0) {
        const size_t size = head_of(f, head);
        f->end = size;
        fault = ranks_agree(write_edge(f, 0, head, size));
    }
    if (fault != 0)
        rows_file_abandon(f);
    return fault;
}

static int write_segments(rows_file *f, const png_segments *s)
{
    const uint32_t count = ranks_count();
    uint64_t *sizes = calloc(count, 3 * sizeof *sizes);
    const int fault = sizes == NULL ? fail(f, "not enough memory") : 0;
    if (ranks_agree(fault) != 0) {
        free(sizes);
        return EXIT_FAULT;
    }
    uint64_t *adlers = sizes + count, *lengths = adlers + count, offset = f->end;
    ranks_collect(s->size, sizes);
    ranks_collect(s->adler, adlers);
    ranks_collect(s->length, lengths);
    for (uint32_t r = 0; r < count; ++r) {
        offset += r < ranks_number() ? sizes[r] : 0;
        f->end += sizes[r];
        f->adler = png_adler_join(f->adler, (uint32_t)adlers[r], lengths[r]);
    }
    free(sizes);
    return f->file != NULL ? write_at(f, offset, s->bytes, s->size)
                           : write_in_order(f, s->bytes, s->size);
}

static int write_png(rows_file *f, row_range rows, png_row *row, const void *context)
{
    png_segments segments;
    int fault = png_segments_make(f->kind, f->width, f->height, rows, row, context, &segments)
                    ? 0
                    : fail(f, "not enough memory");
    fault = ranks_agree(fault);
    if (fault == 0)
        fault = ranks_agree(write_segments(f, &segments));
    png_segments_free(&segments);
    return fault;
}

/* Converts rows, of which each may need 4 bytes a pixel, one after the other. Returns the size. */
static uint64_t convert_rows(const rows_file *f, row_range rows, png_row *row, const void *context,
                             uint8_t *bytes)
{
    uint64_t size = 0;
    for (uint32_t y = 0; y < rows.count; ++y) {
        row(context, rows.first + y, bytes + size);
        size += picture_plain_row(f->format, f->kind, f->width, bytes + size);
    }
    return size;
}

/* Writes rows a few at a time into the file, or all at once in order. */
static int write_plain(rows_file *f, row_range rows, png_row *row, const void *context)
{
    uint8_t head[PICTURE_EDGE_SIZE];
    const uint32_t most =
        f->file != NULL && rows.count > PNG_SEGMENT_ROWS ? PNG_SEGMENT_ROWS : rows.count;
    uint8_t *const bytes = malloc(4 * (size_t)f->width * most + 1);
    int fault = ranks_agree(bytes == NULL ? fail(f, "not enough memory") : 0);
    if (fault == 0 && f->file == NULL)
        fault = write_in_order(f, bytes, convert_rows(f, rows, row, context, bytes));
    for (uint32_t y = 0; fault == 0 && f->file != NULL && y < rows.count; y += most) {
        const uint32_t left = rows.count - y;
        const row_range now = {rows.first + y, left < most ? left : most};
        const uint64_t size = convert_rows(f, now, row, context, bytes);
        fault = write_at(f, head_of(f, head) + size / now.count * now.first, bytes, size);
    }
    free(bytes);
    return ranks_agree(fault);
}

int rows_file_write(rows_file *f, row_range rows, png_row *row, const void *context)
{
    return f->format == PICTURE_PNG ? write_png(f, rows, row, context)
                                    : write_plain(f, rows, row, context);
}

/* The size of a TGA, PPM or raw file without its tail. */
static uint64_t plain_end(const rows_file *f)
{
    const uint64_t pixels = (uint64_t)f->width * f->height;
    return f->end + (f->format == PICTURE_PPM || f->kind == PNG_RGB8 ? 3 : 4) * pixels;
}

int rows_file_finish(rows_file *f)
{
    uint8_t tail[PICTURE_EDGE_SIZE];
    char reason[256];
    const bool is_png = f->format == PICTURE_PNG;
    const size_t size =
        is_png ? png_segments_tail(f->adler, tail) : picture_plain_tail(f->format, tail);
    int fault = ranks_agree(write_edge(f, is_png ? f->end : plain_end(f), tail, size));
    if (f->file != NULL && !ranks_file_close(f->file, reason) && fault == 0)
        fault = fail(f, reason);
    f->file = NULL;
    fault = ranks_agree(fault);
    if (fault == 0 && ranks_number() == 0)
        fault = output_finish(&f->output);
    fault = ranks_agree(fault);
    if (fault != 0)
        rows_file_abandon(f);
    return fault;
}

int rows_file_rename(rows_file *f)
{
    return ranks_agree(ranks_number() == 0 ? output_rename(&f->output) : 0);
}

void rows_file_abandon(rows_file *f)
{
    char reason[256];
    if (f->file != NULL)
        ranks_file_close(f->file, reason);
    f->file = NULL;
    if (ranks_number() == 0)
        output_abandon(&f->output);
}
