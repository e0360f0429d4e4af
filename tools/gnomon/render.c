/* gnomon render: draws models to a picture. */
#include <stdio.h>
#include <string.h>

#include "command.h"
#include "counts.h"
#include "drawing.h"
#include "help.h"
#include "one_picture.h"
#include "output.h"
#include "picture.h"
#include "picture_files.h"
#include "ranks.h"
#include "render_views.h"
#include "report.h"
#include "together.h"

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
    if (result == OPTIONS_HELP || result == OPTIONS_HELP_ALL)
        return help_print(COMMAND_RENDER, result == OPTIONS_HELP_ALL);
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
        fault = counts_report(words, o.output, o.statistics, &p, o.backend, &d.frame);
    drawing_free(&d);
    picture_free(&p);
    return fault == 0 ? finish_output(0) : fault;
}
