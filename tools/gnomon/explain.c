/* gnomon explain: takes a pixel of a picture apart. */
#include <stdio.h>
#include <string.h>

#include "command.h"
#include "explain.h"
#include "help.h"
#include "options.h"
#include "output.h"
#include "page.h"
#include "picture.h"
#include "report.h"

/* Returns 0 if a picture of this size has the pixel. */
static int check_pixel(const options *o, uint32_t width, uint32_t height)
{
    if (o->pixel.x < width && o->pixel.y < height)
        return 0;
    return report_fault("--pixel", "%s lies outside the picture, which is %ux%u", o->pixel.typed,
                        (unsigned)width, (unsigned)height);
}

/* Returns 0 if the scene has the primitive, or if none is asked for. */
static int check_primitive(const options *o, const scene *s)
{
    if (o->primitive.typed == NULL)
        return 0;
    if (o->primitive.x >= s->draw_count)
        return report_fault("--primitive", "%s: there is no such draw, only draws 0 to %u",
                            o->primitive.typed, (unsigned)(s->draw_count - 1));
    const uint32_t count = explain_primitives(&s->draws[o->primitive.x]);
    if (o->primitive.y < count)
        return 0;
    if (count == 0)
        return report_fault("--primitive", "%s: draw %u has none", o->primitive.typed,
                            (unsigned)o->primitive.x);
    return report_fault("--primitive", "%s: draw %u has primitives 0 to %u only",
                        o->primitive.typed, (unsigned)o->primitive.x, (unsigned)(count - 1));
}

/* Explains the pixel, which the scene has, and prints it. Returns 0 or the exit status with the
 * reason printed. */
static int explain(const scene *s, const explain_view *view, const options *o)
{
    const explain_primitive asked = {o->primitive.x, o->primitive.y};
    explained e;
    prose words = {0};

    const int wrong = check_primitive(o, s);
    if (wrong != 0)
        return wrong;
    const char *const fault = explain_pixel(s, o->pixel.x, s->height - 1 - o->pixel.y, view,
                                            o->primitive.typed != NULL ? &asked : NULL, &e);
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

    if (result == OPTIONS_HELP || result == OPTIONS_HELP_ALL)
        return help_print(COMMAND_EXPLAIN, result == OPTIONS_HELP_ALL);
    if (result == OPTIONS_WRONG)
        return status;
    const int fault = o.state != NULL ? explain_state(&o) : explain_models(&o);
    return fault == 0 ? finish_output(0) : fault;
}
