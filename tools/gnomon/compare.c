/* gnomon compare: the library and OSMesa draw models. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "comparison.h"
#include "counts.h"
#include "help.h"
#include "output.h"
#include "picture.h"
#include "report.h"

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

int compare_picture(const options *o, const char *name, picture *p)
{
    FILE *words = output_words(o->output, o->picture_output);
    comparison c;
    picture_print_summary(words, name, p);
    int fault = comparison_make(p->scene, &p->shadow, o->backend, words, &c);
    if (fault == 0)
        fault = comparison_write_triptych(&c, o->output);
    if (fault == 0)
        comparison_name_triptych(words, o->output);
    if (fault == 0 && o->picture_output != NULL)
        fault = comparison_write_picture(&c, o->picture_output);
    if (fault == 0)
        fault = counts_report(words, o->output, o->statistics, p, o->backend, &c.ours);
    if (fault == 0 && c.difference.pixels + c.samples.pixels + c.shadow_texels > 0)
        fault = EXIT_FAULT;
    comparison_free(&c);
    picture_free(p);
    return finish_output(fault);
}

static int compare(const options *o)
{
    picture p;
    int fault = picture_check_output(o, o->output, PICTURE_ANY);
    if (fault == 0)
        fault = picture_describe(o, &p);
    return fault == 0 ? compare_picture(o, o->model, &p) : fault;
}

int command_compare(int argc, char **argv)
{
    options o;
    int status;
    options_result result = options_parse(COMMAND_COMPARE, argc, argv, &o, &status);
    if (result == OPTIONS_HELP || result == OPTIONS_HELP_ALL)
        return help_print(COMMAND_COMPARE, result == OPTIONS_HELP_ALL);
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
