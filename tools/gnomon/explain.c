/* gnomon explain: takes a pixel of a picture apart. */
#include <stdio.h>
#include <string.h>

#include "command.h"
#include "explain.h"
#include "options.h"
#include "output.h"
#include "page.h"
#include "picture.h"
#include "report.h"

static const char usage[] =
    "gnomon explain MODEL... --pixel X,Y [OPTION...]: take a pixel apart.\n"
    "\n"
    "  gnomon explain head.obj --pixel 512,400 --shader phong\n"
    "  gnomon explain part.stl --pixel 10,20 --size 64x48 --json > pixel.json\n"
    "\n";

static const char brief[] =
    "Draws the models as gnomon render does with the same options, and prints every value on the\n"
    "way to one pixel, with its bits and the expression that made it: the vertices of each\n"
    "triangle that covers the pixel at every stage, clipping, edge functions, barycentric\n"
    "coordinates, depth and its test, what is interpolated, texels, shader, and the stored word.\n"
    "\n"
    "  --pixel X,Y                   the pixel, from the left and from the top, from 0 on\n"
    "  --json                        prints JSON instead of text\n"
    "  --state STATE                 instead of models: the picture of a state of the web page,\n"
    "                                which is what its address has behind #\n"
    "  --size WxH                    size in pixels, up to 16384x16384; default: 1024x1024\n";

static const char ending[] =
    HELP_ENDING("gnomon explain") "Exit status: 0: explained; 1: a model or an impossible value "
                                  "is at fault, or a\ncheck failed; 2: wrong usage.\n";

/* Explains the pixel and prints it. Returns 0 or the exit status with the reason printed. */
static int explain(const scene *s, const explain_view *view, uint32_t x, uint32_t y, bool json)
{
    explained e;
    prose words = {0};

    if (x >= s->width || y >= s->height)
        return report_fault("--pixel", "%u,%u lies outside the picture, which is %ux%u",
                            (unsigned)x, (unsigned)y, (unsigned)s->width, (unsigned)s->height);
    const char *const fault = explain_pixel(s, x, s->height - 1 - y, view, &e);
    if (fault != NULL)
        return report_fault("--pixel", "%s", fault);
    (json ? explain_json : explain_text)(&e, &words);
    fputs(prose_of(&words), stdout);
    const bool failed = words.failed;
    prose_free(&words);
    explain_free();
    if (failed)
        return report_fault("--pixel", "not enough memory");
    return e.faults == 0 ? 0 : report_fault("--pixel", "a check failed; see the last lines");
}

static explain_view view_of(const camera *c)
{
    const explain_view view = {true, c->y_down, c->view_from_world};

    return view;
}

/* Explains the picture of a state of the web page. */
static int explain_state(const options *o)
{
    page_use_backend(o->backend != GN_BACKEND_AUTO ? o->backend : gn_backend_best());
    if (page_set_state(o->state) != 0 || page_build() != 0)
        return report_fault("--state", "%s", page_message());
    const explain_view view = view_of(page_camera());

    return explain(page_scene(), &view, o->pixel_x, o->pixel_y, o->json);
}

static int explain_models(const options *o)
{
    picture p;

    memset(&p, 0, sizeof p);
    int fault = picture_describe(o, &p);
    if (fault == 0) {
        const explain_view view = view_of(&p.look.view);

        fault = explain(p.scene, &view, o->pixel_x, o->pixel_y, o->json);
    }
    picture_free(&p);
    return fault;
}

int command_explain(int argc, char **argv)
{
    options o;
    int status;
    const options_result result = options_parse(COMMAND_EXPLAIN, argc, argv, &o, &status);

    if (result == OPTIONS_HELP || result == OPTIONS_HELP_ALL) {
        const bool all = result == OPTIONS_HELP_ALL;
        fputs(usage, stdout);
        fputs(brief, stdout);
        print_picture_help(all, false);
        fputs(all ? "" : ending, stdout);
        return finish_output(0);
    }
    if (result == OPTIONS_WRONG)
        return status;
    const int fault = o.state != NULL ? explain_state(&o) : explain_models(&o);
    return fault == 0 ? finish_output(0) : fault;
}
