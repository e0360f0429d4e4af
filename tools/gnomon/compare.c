/* gnomon compare: the library and OSMesa draw models. */
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
    "gnomon compare MODEL... [-o OUT] [OPTION...]: draw models with Gnomon and with OSMesa,\n"
    "Mesa's software OpenGL, and count the pixels that differ in any bit of colour or depth.\n"
    "\n"
    "  gnomon compare bunny.obj\n"
    "  gnomon compare head.obj -o head_compared.png --eye 0,0.5,3 --size 512x512\n"
    "\n";

static const char brief[] =
    "  -o, --output OUT              both pictures and the difference; default:\n"
    "                                bunny_compared.png for models/bunny.obj\n"
    "  --size WxH                    size in pixels, up to 16384x16384; default: 1024x1024\n";

static const char ending[] =
    HELP_ENDING("gnomon compare") "Exit status: 0: no pixel differs; 1: some do, or a file or an "
                                  "impossible value\nis at fault; 2: wrong usage.\n";

static const char in_full[] =
    "Exit status 0: no pixel differs, 1: some do. If OSMesa is not installed, or the\n"
    "environment has REFERENCE=egl, the same Mesa draws through EGL.\n"
    "\n"
    "  -o, --output OUT        one picture (.png, .tga or .ppm), three times as wide: Gnomon's,\n"
    "                          OSMesa's and the difference. The difference is black where both\n"
    "                          are equal, amplified elsewhere, magenta where only alpha or\n"
    "                          depth differ. Default: the first model's name and _compared.png\n"
    "                          in the current directory. - is standard output; messages then\n"
    "                          go to standard error\n"
    "  --size WxH              size in pixels, up to 16384x16384; default: 1024x1024\n"
    "\n";

/* Returns "bunny_compared.png" for "models/bunny.obj", allocated; null if there is not enough
 * memory. */
static char *default_output(const char *model_path)
{
    static const char suffix[] = "_compared.png";
    const char *slash = strrchr(model_path, '/');
    const char *name = slash != NULL ? slash + 1 : model_path;
    size_t length = maps_stem_length(model_path) - (size_t)(name - model_path);
    char *path = malloc(length + sizeof suffix);
    if (path == NULL)
        return NULL;
    memcpy(path, name, length);
    strcpy(path + length, suffix);
    return path;
}

static int compare(const options *o)
{
    const char *output_path = o->output;
    FILE *words = output_words(output_path, NULL);
    picture p;
    int fault = picture_check_output(o, output_path, PICTURE_ANY);
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
    if (o.output != NULL)
        return compare(&o);
    char *path = default_output(o.model);
    o.output = path;
    int fault = path != NULL ? compare(&o) : report_fault(o.model, "not enough memory");
    free(path);
    return fault;
}
