/* Writes PNG files. */
#include "png_write.h"

#include <errno.h>
#include <png.h>
#include <setjmp.h>
#include <stdlib.h>
#include <string.h>

#include "report.h"

/* libpng reports errors through this function, which must not return. */
static void on_error(png_structp png, png_const_charp message)
{
    const char *path = png_get_error_ptr(png);
    if (errno != 0)
        report_fault(path, "cannot be written: %s", strerror(errno));
    else
        report_fault(path, "cannot be written: %s", message);
    longjmp(png_jmpbuf(png), 1);
}

static void on_warning(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message;
}

int png_write(output *o, png_kind kind, uint32_t width, uint32_t height, png_row *row,
              const void *context)
{
    static const int color_types[] = {PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGB_ALPHA,
                                      PNG_COLOR_TYPE_GRAY};
    /* Assigned only before setjmp, so that they keep their values after longjmp. */
    uint8_t *bytes = malloc((size_t)width * 4);
    png_structp png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, (png_voidp)o->path, on_error, on_warning);
    png_infop info = png != NULL ? png_create_info_struct(png) : NULL;
    if (bytes == NULL || info == NULL) {
        png_destroy_write_struct(&png, &info);
        free(bytes);
        return report_fault(o->path, "cannot be written: not enough memory");
    }

    errno = 0;
    if (setjmp(png_jmpbuf(png)) != 0) {
        png_destroy_write_struct(&png, &info);
        free(bytes);
        return EXIT_FAULT;
    }
    png_init_io(png, o->file);
    png_set_IHDR(png, info, width, height, kind == PNG_GREY16 ? 16 : 8, color_types[kind],
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (uint32_t y = 0; y < height; ++y) {
        row(context, y, bytes);
        png_write_row(png, bytes);
    }
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    free(bytes);
    return 0;
}
