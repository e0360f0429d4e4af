/* gnomon compare: a model drawn by the library and by OSMesa. */
#include <stdio.h>

#include "command.h"
#include "comparison.h"
#include "output.h"
#include "picture.h"
#include "report.h"

static const char usage[] =
    "gnomon compare MODEL [-o OUT.png] [OPTION...]: draw a model with Gnomon and with OSMesa,\n"
    "Mesa's software OpenGL, and count the pixels that are not the same bit for bit, in colour\n"
    "and in depth (32-bit float). Exit status 0: none, 1: some.\n"
    "\n"
    "  gnomon compare bunny.obj\n"
    "  gnomon compare head.obj -o head_compared.png --eye 0,0.5,3 --size 512x512\n"
    "\n"
    "  -o, --output OUT.png    one picture, three times as wide: Gnomon's, OSMesa's, and the\n"
    "                          difference, black where all is equal, otherwise amplified,\n"
    "                          magenta where only alpha or depth differ\n"
    "  --size WxH              in pixels, up to 16384x16384; 1024x1024\n"
    "\n";

int command_compare(int argc, char **argv)
{
    options o;
    int status;
    options_result result = options_parse(COMMAND_COMPARE, argc, argv, &o, &status);
    if (result == OPTIONS_HELP) {
        fputs(usage, stdout);
        print_picture_help();
        return finish_output(0);
    }
    if (result == OPTIONS_WRONG)
        return status;
    if (o.output != NULL && output_same_file(o.output, o.model))
        return report_fault(o.model, "would be overwritten by the picture");
    if (o.output != NULL && o.texture != NULL && output_same_file(o.output, o.texture))
        return report_fault(o.texture, "would be overwritten by the picture");

    scene *s = NULL;
    int fault = picture_describe(&o, &s);
    if (fault != 0)
        return fault;
    comparison c;
    picture_print_summary(o.model, s);
    fault = comparison_make(s, &c);
    if (fault == 0 && o.output != NULL)
        fault = comparison_write_triptych(&c, o.output);
    if (fault == 0 && c.difference.pixels > 0)
        fault = EXIT_FAULT;
    comparison_free(&c);
    scene_free(s);
    return finish_output(fault);
}
