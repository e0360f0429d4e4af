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
    "Draws the models as gnomon render does with the same options, and prints every value on\n"
    "the way to one pixel, with its bits and the expression that made it: the vertices of each\n"
    "triangle that covers the pixel at every stage, clipping, edge functions, barycentric\n"
    "coordinates, depth and its test, what is interpolated, texels, shader, the stored word.\n"
    "\n"
    "  --pixel X,Y                   the pixel, from the left and from the top, from 0 on\n"
    "  --primitive DRAW,PRIMITIVE    also tells why this one has no fragment there; from 0 on\n"
    "  --json                        prints JSON instead of text, with rows from the bottom\n"
    "  --state STATE                 instead of models: the picture of a state of the web page,\n"
    "                                which is what its address has behind #; only --pixel,\n"
    "                                --primitive, --json and --backend go with it\n"
    "  --size WxH                    size in pixels, up to 16384x16384; default: 1024x1024\n";

static const char ending[] =
    HELP_ENDING("gnomon explain") "Exit status: 0: explained; 1: a model or an impossible value "
                                  "is at fault, or a\ncheck failed; 2: wrong usage.\n";

/* Returns 0 if a picture of this size has the pixel. */
static int check_pixel(const options *o, uint32_t width, uint32_t height)
{
    if (o->pixel_x < width && o->pixel_y < height)
        return 0;
    return report_fault("--pixel", "%s lies outside the picture, which is %ux%u", o->pixel,
                        (unsigned)width, (unsigned)height);
}

/* Returns 0 if the scene has the primitive, or if none is asked for. */
static int check_primitive(const options *o, const scene *s)
{
    if (o->primitive == NULL)
        return 0;
    if (o->primitive_draw >= s->draw_count)
        return report_fault("--primitive", "%s: there is no such draw, only draws 0 to %u",
                            o->primitive, (unsigned)(s->draw_count - 1));
    const uint32_t count = explain_primitives(&s->draws[o->primitive_draw]);
    if (o->primitive_number < count)
        return 0;
    if (count == 0)
        return report_fault("--primitive", "%s: draw %u has none", o->primitive,
                            (unsigned)o->primitive_draw);
    return report_fault("--primitive", "%s: draw %u has primitives 0 to %u only", o->primitive,
                        (unsigned)o->primitive_draw, (unsigned)(count - 1));
}

/* Explains the pixel, which the scene has, and prints it. Returns 0 or the exit status with the
 * reason printed. */
static int explain(const scene *s, const explain_view *view, const options *o)
{
    const explain_primitive asked = {o->primitive_draw, o->primitive_number};
    explained e;
    prose words = {0};

    const int wrong = check_primitive(o, s);
    if (wrong != 0)
        return wrong;
    const char *const fault = explain_pixel(s, o->pixel_x, s->height - 1 - o->pixel_y, view,
                                            o->primitive != NULL ? &asked : NULL, &e);
    if (fault != NULL)
        return report_fault("--pixel", "%s", fault);
    (o->json ? explain_json : explain_text)(&e, &words);
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

/* What the command's own files say is wrong with a state, as "far: why": its camera is placed by
 * them. */
static char fault_of_state[512];

static void keep_fault(const char *line)
{
    const char *const what = strstr(line, ": ");

    if (what != NULL)
        snprintf(fault_of_state, sizeof fault_of_state, "%s",
                 what + (strncmp(what, ": --", 4) == 0 ? 4 : 2));
}

/* Explains the picture of a state of the web page. */
static int explain_state(const options *o)
{
    page_use_backend(o->backend != GN_BACKEND_AUTO ? o->backend : gn_backend_best());
    report_to(keep_fault);
    const bool is_built = page_set_state(o->state) == 0 && page_build() == 0;
    report_to(NULL);
    if (!is_built)
        return report_fault("--state", "%s",
                            *page_message() != '\0' ? page_message() : fault_of_state);
    const scene *const s = page_scene();
    const explain_view view = view_of(page_camera());
    const int fault = check_pixel(o, s->width, s->height);

    return fault == 0 ? explain(s, &view, o) : fault;
}

static int explain_models(const options *o)
{
    picture p;

    memset(&p, 0, sizeof p);
    int fault = check_pixel(o, o->width, o->height);
    if (fault == 0)
        fault = picture_describe(o, &p);
    if (fault == 0) {
        const explain_view view = view_of(&p.look.view);

        fault = explain(p.scene, &view, o);
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
