/* Writes pictures: TGA and PPM here, PNG with libpng. */
#include "picture_write.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "report.h"

/* Truevision TGA File Format Specification 2.0: true colour without compression, top row first,
 * with 8 bits of alpha. The footer says which version it is. */
enum { TGA_TRUE_COLOR = 2, TGA_TOP_FIRST = 0x20, TGA_HEADER_SIZE = 18, TGA_FOOTER_SIZE = 26 };

static bool write_tga_header(FILE *file, size_t channels, uint32_t width, uint32_t height)
{
    uint8_t header[TGA_HEADER_SIZE] = {0};
    header[2] = TGA_TRUE_COLOR;
    header[12] = (uint8_t)width;
    header[13] = (uint8_t)(width >> 8);
    header[14] = (uint8_t)height;
    header[15] = (uint8_t)(height >> 8);
    header[16] = (uint8_t)(8 * channels);
    header[17] = (uint8_t)(TGA_TOP_FIRST | (channels == 4 ? 8 : 0));
    return fwrite(header, 1, sizeof header, file) == sizeof header;
}

static bool write_tga_footer(FILE *file)
{
    uint8_t footer[TGA_FOOTER_SIZE] = {0};
    memcpy(footer + 8, "TRUEVISION-XFILE.", 18);
    return fwrite(footer, 1, sizeof footer, file) == sizeof footer;
}

/* Converts red, green, blue and perhaps alpha to what the format has, in place. Returns the
 * bytes. */
static size_t convert_row(picture_format format, size_t channels, uint32_t width, uint8_t *row)
{
    if (format == PICTURE_TGA) {
        for (size_t x = 0; x < width; ++x) {
            uint8_t *pixel = row + channels * x;
            const uint8_t red = pixel[0];
            pixel[0] = pixel[2];
            pixel[2] = red;
        }
        return channels * width;
    }
    for (size_t x = 0; x < width; ++x)
        memmove(row + 3 * x, row + channels * x, 3);
    return 3 * (size_t)width;
}

static int write_plain(output *o, picture_format format, png_kind kind, uint32_t width,
                       uint32_t height, png_row *row, const void *context)
{
    const size_t channels = kind == PNG_RGBA8 ? 4 : 3;
    uint8_t *bytes = malloc(channels * width);
    if (bytes == NULL)
        return report_fault(o->path, "cannot be written: not enough memory");
    errno = 0;
    bool good = format == PICTURE_TGA
                    ? write_tga_header(o->file, channels, width, height)
                    : fprintf(o->file, "P6\n%u %u\n255\n", (unsigned)width, (unsigned)height) > 0;
    for (uint32_t y = 0; y < height && good; ++y) {
        row(context, y, bytes);
        size_t size = convert_row(format, channels, width, bytes);
        good = fwrite(bytes, 1, size, o->file) == size;
    }
    if (good && format == PICTURE_TGA)
        good = write_tga_footer(o->file);
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
