/* gnomon render: draws models to a picture. */
#include <stdio.h>
#include <string.h>

#include "command.h"
#include "counts.h"
#include "drawing.h"
#include "one_picture.h"
#include "output.h"
#include "picture.h"
#include "picture_files.h"
#include "ranks.h"
#include "render_views.h"
#include "report.h"
#include "together.h"

static const char usage[] =
    "gnomon render MODEL... -o OUT [OPTION...]: draw models.\n"
    "\n"
    "  gnomon render head.obj -o head.png --size 1920x1080 --eye 0,0.5,3 --fov 35\n"
    "  gnomon render part.stl -o part.tga --up 0,0,1 --orthographic 120 --shader flat\n"
    "  gnomon render car.glb tree.obj --scale 2 --translate 3,0,0 -o both.png\n"
    "  gnomon render head.obj --views around.txt -o head_%04d.png\n"
    "  mpirun -n 4 gnomon render city.ply -o city.png --size 40000x30000\n"
    "\n";

static const char brief[] =
    "  -o, --output OUT              .png, .tga, .ppm (no alpha) or .raw; - is standard output\n"
    "  --format NAME                 png, tga, ppm or raw, for an OUT without a suffix\n"
    "  --depth OUT.png               writes the depth too, as 16-bit grey\n"
    "  --size WxH                    size in pixels; above 16384x16384 drawn in tiles; default:\n"
    "                                1024x1024\n"
    "  --sort NAME                   how ranks divide the picture: first, by rows (default), or\n"
    "                                last, by triangles\n"
    "  --views FILE                  one picture for each line of camera options; OUT has %04d\n";

static const char ending[] =
    HELP_ENDING("gnomon render") "Exit status: 0: drawn; 1: a model, an output or an impossible "
                                 "value is at fault;\n2: wrong usage.\n";

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
    "                          last, by triangles: a rank has its part of the model, rank 0\n"
    "                          while it reads all of it, and memory for the whole picture; for\n"
    "                          large models. What depends on the order of triangles is refused,\n"
    "                          such as --no-depth-test\n"
    "  --views FILE            draws one picture for each line of FILE. A line has options of\n"
    "                          the camera, as in --eye 0,1,5 --fov 30; those that it lacks are\n"
    "                          as on the command line. --fov of a line replaces --orthographic\n"
    "                          of the command line, and the other way round. # begins a\n"
    "                          comment. OUT, and that of --depth, is a pattern such as\n"
    "                          view_%04d.png, numbered from 0 on.\n"
    "                          If the command is built with MPI, mpirun -n 8 gnomon render ...\n"
    "                          divides the pictures among 8 processes; the files are the same\n"
    "\n"
    "Over ranks the model is read once, by rank 0, and all ranks write the file, which must be\n"
    "on a disk that they share. TGA, PPM and raw files have the bytes of one process. A PNG has\n"
    "its pixels, and bytes that do not depend on the number of ranks; those that one process\n"
    "without mpirun writes may be others. `make mpi` builds the command for ranks.\n"
    "\n"
    "--statistics is refused with --views, --sort last, several ranks and sizes above\n"
    "16384x16384.\n"
    "\n";

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
    together_begin();
    options_result result = options_parse(COMMAND_RENDER, argc, argv, &o, &status);
    const int wrong = together_end(result == OPTIONS_WRONG ? status : 0);
    if (result == OPTIONS_HELP || result == OPTIONS_HELP_ALL) {
        const bool all = result == OPTIONS_HELP_ALL;
        fputs(usage, stdout);
        fputs(all ? in_full : brief, stdout);
        print_picture_help(all, true);
        fputs(all ? "" : ending, stdout);
        return finish_output(0);
    }
    if (wrong != 0)
        return wrong;
    if (o.views != NULL) {
        status = render_views(&o);
        return status == 0 ? finish_output(0) : status;
    }

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
    const picture_rows rows = {drawing_color_row, drawing_depth_row, &d.frame};
    if (fault == 0)
        fault = picture_files_write(&o, o.output, o.depth_output, &rows);
    if (fault == 0)
        picture_print_summary(words, o.output, &p);
    if (fault == 0)
        fault = counts_report(words, o.output, o.statistics, p.scene, o.backend, &d.frame);
    drawing_free(&d);
    picture_free(&p);
    return fault == 0 ? finish_output(0) : fault;
}
