/* gnomon render: draws models to a picture. */
#include <stdio.h>
#include <string.h>

#include "command.h"
#include "counts.h"
#include "drawing.h"
#include "one_picture.h"
#include "output.h"
#include "picture.h"
#include "picture_write.h"
#include "ranks.h"
#include "report.h"

static const char usage[] =
    "gnomon render MODEL... -o OUT [OPTION...]: draw models.\n"
    "\n"
    "  gnomon render head.obj -o head.png --size 1920x1080 --eye 0,0.5,3 --fov 35\n"
    "  gnomon render part.stl -o part.tga --up 0,0,1 --orthographic 120 --shader flat\n"
    "  gnomon render car.glb tree.obj --scale 2 --translate 3,0,0 -o both.png\n"
    "  mpirun -n 4 gnomon render city.ply -o city.png --size 40000x30000\n"
    "\n";

static const char brief[] =
    "  -o, --output OUT              .png, .tga, .ppm (no alpha) or .raw; - is standard output\n"
    "  --format NAME                 png, tga, ppm or raw, for an OUT without a suffix\n"
    "  --depth OUT.png               writes the depth too, as 16-bit grey\n"
    "  --size WxH                    size in pixels; above 16384x16384 drawn in tiles; default:\n"
    "                                1024x1024\n"
    "  --sort NAME                   how ranks divide the picture: first, by rows (default), or\n"
    "                                last, by triangles\n";

static const char ending[] =
    HELP_ENDING("gnomon render") "Exit status: 0: drawn; 1: a model or an output is at fault; 2: "
                                 "the command line is.\n";

static const char in_full[] =
    "  -o, --output OUT        the picture, by its suffix: .png, .tga (uncompressed), .ppm,\n"
    "                          which has no alpha, or .raw: red, green, blue and alpha of 8\n"
    "                          bits each, top row first, and nothing else. - is standard\n"
    "                          output; messages then go to standard error\n"
    "  --format NAME           png, tga, ppm or raw, for an OUT without a suffix, such as -;\n"
    "                          default: png\n"
    "  --depth OUT.png         writes the depth too, as 16-bit grey: 0 at the near plane, 65535\n"
    "                          at the far plane\n"
    "  --size WxH              size in pixels; default: 1024x1024. Pictures above 16384x16384,\n"
    "                          up to 1048576x1048576, are drawn in tiles, each with its part of\n"
    "                          the projection. Their pixels are not bit-equal to those of one\n"
    "                          large target: edges and colours may differ in their last bits\n"
    "  --sort NAME             how several ranks, which mpirun or srun has started, divide the\n"
    "                          picture; it has the same pixels in both ways.\n"
    "                          first (default), by rows: a rank has the memory of its rows and\n"
    "                          the whole model; for large pictures.\n"
    "                          last, by triangles: a rank has its part of the model and memory\n"
    "                          for the whole picture; for large models. What depends on the\n"
    "                          order of triangles is refused, such as --no-depth-test\n"
    "\n"
    "Over ranks the model is read once, by rank 0, and all ranks write the file, which must be\n"
    "on a disk that they share. TGA, PPM and raw files have the bytes of one process. A PNG has\n"
    "its pixels, and bytes that do not depend on the number of ranks; those that one process\n"
    "without mpirun writes may be others. `make mpi` builds the command for ranks.\n"
    "\n";

/* Writes both files or neither: neither gets its name before both are complete on disk. An output
 * that is not a regular file has no such moment and cannot be undone. */
static int write_files(const options *o, const scene_frame *frame)
{
    output color;
    output depth = {NULL, NULL, NULL, NULL};
    int fault = output_open(&color, o->output);
    if (fault != 0)
        return fault;
    fault = picture_write(&color, options_format(o), PNG_RGBA8, o->width, o->height,
                          drawing_color_row, frame);
    if (fault == 0 && o->depth_output != NULL) {
        fault = output_open(&depth, o->depth_output);
        if (fault == 0)
            fault = png_write(&depth, PNG_GREY16, o->width, o->height, drawing_depth_row, frame);
    }
    if (fault == 0)
        fault = output_finish(&color);
    if (fault == 0 && o->depth_output != NULL)
        fault = output_finish(&depth);
    if (fault == 0)
        fault = output_rename(&color);
    if (fault == 0 && o->depth_output != NULL)
        fault = output_rename(&depth);
    output_abandon(&depth);
    output_abandon(&color);
    return fault;
}

static int check_names(const options *o)
{
    int fault = picture_check_output(o, o->output, PICTURE_ANY_OR_RAW);
    if (fault == 0)
        fault = picture_check_output(o, o->depth_output, PICTURE_PNG);
    if (fault != 0)
        return fault;
    if (o->depth_output != NULL && output_same_file(o->output, o->depth_output))
        return report_fault(o->output, "cannot be both the picture and the depth");
    return 0;
}

int command_render(int argc, char **argv)
{
    options o;
    int status;
    options_result result = options_parse(COMMAND_RENDER, argc, argv, &o, &status);
    if (result == OPTIONS_HELP || result == OPTIONS_HELP_ALL) {
        const bool all = result == OPTIONS_HELP_ALL;
        fputs(usage, stdout);
        fputs(all ? in_full : brief, stdout);
        print_picture_help(all, true);
        fputs(all ? "" : ending, stdout);
        return finish_output(0);
    }
    if (result == OPTIONS_WRONG)
        return status;

    /* Rank 0 alone looks at the outputs. */
    int fault = ranks_number() == 0 ? check_names(&o) : 0;
    if (one_picture_is_divided(&o)) {
        fault = one_picture(&o, fault);
        return fault == 0 ? finish_output(0) : fault;
    }
    picture p;
    drawing d;
    memset(&p, 0, sizeof p);
    memset(&d, 0, sizeof d);
    FILE *words = output_words(o.output, o.depth_output);
    if (fault == 0)
        fault = picture_describe(&o, &p);
    if (fault == 0)
        fault = drawing_allocate(p.scene, o.backend, &d);
    if (fault == 0)
        fault = drawing_draw(p.scene, &d);
    if (fault == 0)
        fault = write_files(&o, &d.frame);
    if (fault == 0)
        picture_print_summary(words, o.output, &p);
    if (fault == 0)
        fault = counts_report(words, o.output, o.statistics, p.scene, o.backend, &d.frame);
    drawing_free(&d);
    picture_free(&p);
    return fault == 0 ? finish_output(0) : fault;
}
