/* gnomon compare: the library and OSMesa draw a model. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "comparison.h"
#include "counts.h"
#include "output.h"
#include "picture.h"
#include "report.h"

static const char usage[] =
    "gnomon compare MODEL [-o OUT.png] [OPTION...]: draw a model with Gnomon and with OSMesa,\n"
    "Mesa's software OpenGL, and count the pixels that differ in any bit, in colour and in\n"
    "depth (32-bit float). Exit status 0: no pixel differs, 1: some do. If OSMesa is not\n"
    "installed, or the environment has REFERENCE=egl, the same Mesa draws through EGL.\n"
    "\n"
    "  gnomon compare bunny.obj\n"
    "  gnomon compare head.obj -o head_compared.png --eye 0,0.5,3 --size 512x512\n"
    "\n"
    "  -o, --output OUT.png    one picture, three times as wide: Gnomon's, OSMesa's and the\n"
    "                          difference. The difference is black where both are equal,\n"
    "                          amplified elsewhere, magenta where only alpha or depth differ.\n"
    "                          Default: the model's name and _compared.png in the current\n"
    "                          directory, so bunny_compared.png for models/bunny.obj. - is\n"
    "                          standard output; messages then go to standard error\n"
    "  --size WxH              size in pixels, up to 16384x16384; default: 1024x1024\n"
    "\n";

/* Returns "bunny_compared.png" for "models/bunny.obj", allocated; null if there is not enough
 * memory. */
static char *default_output(const char *model_path)
{
    static const char ending[] = "_compared.png";
    const char *slash = strrchr(model_path, '/');
    const char *name = slash != NULL ? slash + 1 : model_path;
    size_t length = maps_stem_length(model_path) - (size_t)(name - model_path);
    char *path = malloc(length + sizeof ending);
    if (path == NULL)
        return NULL;
    memcpy(path, name, length);
    strcpy(path + length, ending);
    return path;
}

static int compare(const options *o, const char *output_path)
{
    FILE *words = output_words(output_path, NULL);
    picture p;
    int fault = picture_check_output(o, output_path);
    if (fault == 0)
        fault = picture_describe(o, &p);
    if (fault != 0)
        return fault;
    comparison c;
    picture_print_summary(words, o->model, &p);
    fault = comparison_make(p.scene, &p.shadow, o->backend, words, &c);
    if (fault == 0)
        fault = comparison_write_triptych(&c, output_path);
    if (fault == 0)
        comparison_name_triptych(words, output_path);
    if (fault == 0)
        fault = counts_report(words, output_path, o->statistics, p.scene, o->backend, &c.ours);
    if (fault == 0 && c.difference.pixels + c.samples.pixels + c.shadow_texels > 0)
        fault = EXIT_FAULT;
    comparison_free(&c);
    picture_free(&p);
    return finish_output(fault);
}

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
    if (o.output != NULL)
        return compare(&o, o.output);
    char *path = default_output(o.model);
    int fault = path != NULL ? compare(&o, path) : report_fault(o.model, "not enough memory");
    free(path);
    return fault;
}
