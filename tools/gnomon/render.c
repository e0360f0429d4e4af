/* gnomon render: draws models to a picture. */
#include <stdio.h>
#include <string.h>

#include "command.h"
#include "counts.h"
#include "drawing.h"
#include "output.h"
#include "picture.h"
#include "picture_files.h"
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
    "\n";

static const char brief[] =
    "  -o, --output OUT              .png, .tga or .ppm (without alpha); - is standard output\n"
    "  --format NAME                 png, tga or ppm, for an OUT without a suffix; default: png\n"
    "  --depth OUT.png               writes the depth too, as 16-bit grey\n"
    "  --size WxH                    size in pixels, up to 16384x16384; default: 1024x1024\n"
    "  --views FILE                  one picture for each line of camera options; OUT has %04d\n";

static const char ending[] =
    HELP_ENDING("gnomon render") "Exit status: 0: drawn; 1: a model or an output is at fault; 2: "
                                 "the command line is.\n";

static const char in_full[] =
    "  -o, --output OUT        the picture, by its suffix: .png, .tga (uncompressed) or .ppm,\n"
    "                          which has no alpha. - is standard output; messages then go to\n"
    "                          standard error\n"
    "  --format NAME           png, tga or ppm, for an OUT without a suffix, such as -;\n"
    "                          default: png\n"
    "  --depth OUT.png         writes the depth too, as 16-bit grey: 0 at the near plane, 65535\n"
    "                          at the far plane\n"
    "  --size WxH              size in pixels, up to 16384x16384; default: 1024x1024\n"
    "  --views FILE            draws one picture for each line of FILE. A line has options of\n"
    "                          the camera, as in --eye 0,1,5 --fov 30; those that it lacks are\n"
    "                          as on the command line. # begins a comment. OUT, and that of\n"
    "                          --depth, is a pattern such as view_%04d.png, numbered from 0 on.\n"
    "                          If the command is built with MPI, mpirun -n 8 gnomon render ...\n"
    "                          divides the pictures among 8 processes; the files are the same\n"
    "\n";

static int check_names(const options *o)
{
    int fault = picture_check_output(o, o->output, PICTURE_ANY);
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

    picture p;
    drawing d;
    memset(&p, 0, sizeof p);
    memset(&d, 0, sizeof d);
    FILE *words = output_words(o.output, o.depth_output);
    int fault = check_names(&o);
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
