/* Writes pictures: TGA, PPM and raw here, PNG with libpng. */
#include "picture_write.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "report.h"

/* Truevision TGA File Format Specification 2.0: true colour without compression, top row first,
 * with 8 bits of alpha. The footer says which version it is. */
enum { TGA_TRUE_COLOR = 2, TGA_TOP_FIRST = 0x20, TGA_HEADER_SIZE = 18, TGA_FOOTER_SIZE = 26 };

static size_t make_tga_head(size_t channels, uint32_t width, uint32_t height,
                            uint8_t head[PICTURE_EDGE_SIZE])
{
    memset(head, 0, TGA_HEADER_SIZE);
    head[2] = TGA_TRUE_COLOR;
    head[12] = (uint8_t)width;
    head[13] = (uint8_t)(width >> 8);
    head[14] = (uint8_t)height;
    head[15] = (uint8_t)(height >> 8);
    head[16] = (uint8_t)(8 * channels);
    head[17] = (uint8_t)(TGA_TOP_FIRST | (channels == 4 ? 8 : 0));
    return TGA_HEADER_SIZE;
}

static size_t channels_of(png_kind kind)
{
    return kind == PNG_RGBA8 ? 4 : 3;
}

size_t picture_plain_head(picture_format format, png_kind kind, uint32_t width, uint32_t height,
                          uint8_t head[PICTURE_EDGE_SIZE])
{
    if (format == PICTURE_TGA)
        return make_tga_head(channels_of(kind), width, height, head);
    if (format == PICTURE_PPM)
        return (size_t)snprintf((char *)head, PICTURE_EDGE_SIZE, "P6\n%u %u\n255\n",
                                (unsigned)width, (unsigned)height);
    return 0;
}

size_t picture_plain_tail(picture_format format, uint8_t tail[PICTURE_EDGE_SIZE])
{
    if (format != PICTURE_TGA)
        return 0;
    memset(tail, 0, TGA_FOOTER_SIZE);
    memcpy(tail + 8, "TRUEVISION-XFILE.", 18);
    return TGA_FOOTER_SIZE;
}

size_t picture_plain_row(picture_format format, png_kind kind, uint32_t width, uint8_t *row)
{
    const size_t channels = channels_of(kind);
    for (size_t x = 0; format == PICTURE_TGA && x < width; ++x) {
        uint8_t *pixel = row + channels * x;
        const uint8_t red = pixel[0];
        pixel[0] = pixel[2];
        pixel[2] = red;
    }
    for (size_t x = 0; format == PICTURE_PPM && x < width; ++x)
        memmove(row + 3 * x, row + channels * x, 3);
    return (format == PICTURE_PPM ? 3 : channels) * width;
}

static int write_plain(output *o, picture_format format, png_kind kind, uint32_t width,
                       uint32_t height, png_row *row, const void *context)
{
    uint8_t edge[PICTURE_EDGE_SIZE];
    uint8_t *bytes = malloc(channels_of(kind) * width);
    if (bytes == NULL)
        return report_fault(o->path, "cannot be written: not enough memory");
    errno = 0;
    size_t size = picture_plain_head(format, kind, width, height, edge);
    bool good = fwrite(edge, 1, size, o->file) == size;
    for (uint32_t y = 0; y < height && good; ++y) {
        row(context, y, bytes);
        size = picture_plain_row(format, kind, width, bytes);
        good = fwrite(bytes, 1, size, o->file) == size;
    }
    size = picture_plain_tail(format, edge);
    good = good && fwrite(edge, 1, size, o->file) == size;
    free(bytes);
    return good ? 0 : report_fault(o->path, "cannot be written: %s", strerror(errno));
}

int picture_write(output *o, picture_format format, png_kind kind, uint32_t width, uint32_t height,
                  png_row *row, const void *context)
{
    return format == PICTURE_PNG ? png_write(o, kind, width, height, row, context)
                                 : write_plain(o, format, kind, width, height, row, context);
}

int picture_write_file(const char *path, picture_format format, png_kind kind, uint32_t width,
                       uint32_t height, png_row *row, const void *context)
{
    output file;
    int fault = output_open(&file, path);
    if (fault != 0)
        return fault;
    fault = picture_write(&file, format, kind, width, height, row, context);
    if (fault == 0)
        fault = output_finish(&file);
    if (fault == 0)
        fault = output_rename(&file);
    output_abandon(&file);
    return fault;
}
