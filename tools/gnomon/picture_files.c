/* Writes the files of a picture. */
#include "picture_files.h"

#include "output.h"
#include "picture_write.h"

int picture_files_write(const options *o, const char *color_name, const char *depth_name,
                        const picture_rows *rows)
{
    output color;
    output depth = {NULL, NULL, NULL, NULL};
    int fault = output_open(&color, color_name);
    if (fault != 0)
        return fault;
    fault = picture_write(&color, options_format(o), PNG_RGBA8, o->width, o->height, rows->color,
                          rows->context);
    if (fault == 0 && depth_name != NULL) {
        fault = output_open(&depth, depth_name);
        if (fault == 0)
            fault = png_write(&depth, PNG_GREY16, o->width, o->height, rows->depth, rows->context);
    }
    if (fault == 0)
        fault = output_finish(&color);
    if (fault == 0 && depth_name != NULL)
        fault = output_finish(&depth);
    if (fault == 0)
        fault = output_rename(&color);
    if (fault == 0 && depth_name != NULL)
        fault = output_rename(&depth);
    output_abandon(&depth);
    output_abandon(&color);
    return fault;
}
