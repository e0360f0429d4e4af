/* gnomon view: a window in which a model is looked at from all sides. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <gnomon.h>

#include "command.h"
#include "command_table.h"
#include "drawing.h"
#include "help.h"
#include "orbit.h"
#include "output.h"
#include "picture.h"
#include "picture_write.h"
#include "report.h"
#include "view_script.h"
#include "window.h"

/* What is shown. */
typedef struct viewer {
    options o;     /* as the keys have changed them */
    options begin; /* as they were at the beginning, with the camera placed */
    contents c;
    picture p;
    drawing d;
    uint8_t *rgba; /* the frame, top row first */
    bool shadows;  /* asked for, whether or not the shader takes them */
} viewer;

/* Builds the picture anew, as a change of the state needs. */
static int rebuild(viewer *v)
{
    drawing_free(&v->d);
    picture_free(&v->p);
    free(v->rgba);
    v->o.shadows = v->shadows && shading_traits_of(v->o.shading)->takes_shadows;
    v->rgba = malloc((size_t)v->o.width * v->o.height * 4);
    if (v->rgba == NULL)
        return report_fault("--size", "not enough memory");
    int fault = picture_build(&v->o, &v->c, true, &v->p);
    return fault == 0 ? drawing_allocate(v->p.scene, v->o.backend, &v->d) : fault;
}

static int show(viewer *v)
{
    for (uint32_t y = 0; y < v->o.height; ++y)
        drawing_color_row(&v->d.frame, y, v->rgba + (size_t)4 * v->o.width * y);
    return window_show(v->rgba, v->o.width, v->o.height);
}

static int redraw(viewer *v)
{
    gn_transform none;
    gn_transform_identity(&none);
    int fault = picture_place(&v->p, &v->o, &v->c, &none);
    if (fault == 0)
        fault = drawing_draw(v->p.scene, &v->d);
    return fault == 0 ? show(v) : fault;
}

/* Takes back what the command line says about maps that the shader lacks, which render refuses. */
static void print_unused_maps(FILE *words, const viewer *v)
{
    static const char names[OPTIONS_MAP_COUNT][16] = {"texture", "normal-map", "specular-map",
                                                      "glow-map"};
    const options *o = &v->o;
    for (int i = 0; i < OPTIONS_MAP_COUNT; ++i) {
        const bool is_given =
            o->maps[i].file != NULL || (i == MAP_NORMAL && o->normals != NORMALS_ANY);
        if (is_given && (shading_traits_of(v->p.shading)->maps >> i & 1) == 0)
            fprintf(words, " --%s none", names[i]);
    }
}

/* Names the options at the beginning that no other option takes back. */
static void print_left_out(FILE *words, const viewer *v)
{
    const struct {
        char name[12];
        bool given, holds;
    } flags[] = {{"--shadows", v->begin.shadows, v->o.shadows},
                 {"--wireframe", v->begin.wireframe, v->o.wireframe},
                 {"--edges", v->begin.edges, v->o.edges},
                 {"--grid", v->begin.grid, v->o.grid},
                 {"--points", v->begin.points, v->o.points}};
    int count = 0;
    for (size_t i = 0; i < sizeof flags / sizeof flags[0]; ++i)
        if (flags[i].given && !flags[i].holds)
            fprintf(words, "%s%s", count++ == 0 ? "without " : ", ", flags[i].name);
    if (count > 0)
        fputc('\n', words);
}

/* Nine digits restore a float, seventeen a double. */
static void print_place(FILE *words, gn_vec3 place, const double rest[3])
{
    const double sum[3] = {(double)place.x + rest[0], (double)place.y + rest[1],
                           (double)place.z + rest[2]};
    const bool is_float = rest[0] == 0.0 && rest[1] == 0.0 && rest[2] == 0.0;
    const int digits = is_float ? 9 : 17;
    fprintf(words, "%.*g,%.*g,%.*g", digits, sum[0], digits, sum[1], digits, sum[2]);
}

/* The options with which, behind those of the command line, gnomon render draws the same picture,
 * and those of the command line that must go. */
static void print_options(FILE *words, const viewer *v)
{
    const options *o = &v->o;
    const camera_options *c = &o->camera;
    fputs("as with --eye ", words);
    print_place(words, c->eye, c->eye_rest);
    fputs(" --target ", words);
    print_place(words, c->target, c->target_rest);
    fprintf(words, " --up %.9g,%.9g,%.9g", (double)c->up.x, (double)c->up.y, (double)c->up.z);
    if (c->orthographic)
        fprintf(words, " --orthographic %.9g", (double)c->orthographic_height);
    else
        fprintf(words, " --fov %.9g", (double)c->fov_degrees);
    fprintf(words, " --size %ux%u --samples %u --shader %s%s%s%s", (unsigned)o->width,
            (unsigned)o->height, (unsigned)o->samples, shading_traits_of(v->p.shading)->name,
            o->shadows ? " --shadows" : "", o->wireframe ? " --wireframe" : "",
            o->grid ? " --grid" : "");
    if (o->edges && !v->begin.edges)
        fputs(" --edges", words);
    if (o->points)
        fprintf(words, " --points=%.9g", (double)o->point_size);
    fprintf(words, " --cull %s",
            o->cull == GN_CULL_BACK    ? "back"
            : o->cull == GN_CULL_FRONT ? "front"
                                       : "none");
    print_unused_maps(words, v);
    fputc('\n', words);
    print_left_out(words, v);
}

/* A picture that cannot be saved does not end the viewer. */
static void save(viewer *v)
{
    const options *o = &v->o;
    FILE *words = output_words(o->output, NULL);
    if (picture_write_file(o->output, options_format(o), PNG_RGBA8, o->width, o->height,
                           drawing_color_row, &v->d.frame) != 0)
        return;
    picture_print_summary(words, o->output, &v->p);
    print_options(words, v);
    if (words == stdout)
        flush_output();
}

/* Changes the state. Returns whether the key means a change. */
static bool change_state(viewer *v, int key)
{
    options *o = &v->o;
    switch (key) {
    case 'w':
        o->wireframe = !o->wireframe;
        o->points = o->edges = false;
        return true;
    case 'p':
        o->points = !o->points;
        o->point_size = o->point_size > 0.0f ? o->point_size : 1.0f;
        o->wireframe = o->edges = false;
        return true;
    case 'e':
        o->edges = !o->edges;
        o->wireframe = o->points = false;
        return true;
    case 'g':
        o->grid = !o->grid;
        return true;
    case 'c':
        o->cull = o->cull == GN_CULL_NONE   ? GN_CULL_BACK
                  : o->cull == GN_CULL_BACK ? GN_CULL_FRONT
                                            : GN_CULL_NONE;
        return true;
    case 'h':
        v->shadows = !v->shadows;
        return true;
    case 'm':
        o->samples = o->samples == 1 ? GN_SAMPLES : 1;
        return true;
    default:
        if (key < '0' || key > '9')
            return false;
        o->shading = (shading)(SHADING_AUTOMATIC + (key - '0'));
        o->shading_given = key != '0';
        return true;
    }
}

/* Moves the camera. Returns whether the event means a move. */
static bool move_camera(viewer *v, const window_event *e)
{
    enum { ARROW = 12 }; /* pixels */
    camera_options *c = &v->o.camera;
    if (e->action == WINDOW_DRAG)
        orbit_turn(c, e->x, e->y);
    else if (e->action == WINDOW_DRAG_PAN)
        orbit_pan(c, e->x, e->y, v->o.height);
    else if (e->action == WINDOW_WHEEL)
        orbit_zoom(c, e->y);
    else if (e->action != WINDOW_KEY)
        return false;
    else if (e->key == KEY_LEFT || e->key == KEY_RIGHT)
        orbit_turn(c, e->key == KEY_LEFT ? -ARROW : ARROW, 0);
    else if (e->key == KEY_UP || e->key == KEY_DOWN)
        orbit_turn(c, 0, e->key == KEY_UP ? -ARROW : ARROW);
    else if (e->key == '+' || e->key == '=' || e->key == '-')
        orbit_zoom(c, e->key == '-' ? -1 : 1);
    else if (e->key == 'r')
        *c = v->begin.camera;
    else
        return false;
    return true;
}

/* Whether the event ends the viewer. */
static bool is_end(const window_event *e)
{
    return e->action == WINDOW_QUIT ||
           (e->action == WINDOW_KEY && (e->key == 'q' || e->key == KEY_ESCAPE));
}

static int react(viewer *v, const window_event *e, bool *moved)
{
    const bool is_key = e->action == WINDOW_KEY;
    if (move_camera(v, e)) {
        *moved = true;
        return 0;
    }
    if (is_key && change_state(v, e->key)) {
        *moved = true;
        return rebuild(v);
    }
    if (e->action == WINDOW_RESIZE &&
        ((uint32_t)e->x != v->o.width || (uint32_t)e->y != v->o.height) && e->x > 0 && e->y > 0 &&
        e->x <= GN_MAX_SIZE && e->y <= GN_MAX_SIZE) {
        v->o.width = (uint32_t)e->x;
        v->o.height = (uint32_t)e->y;
        *moved = true;
        return rebuild(v);
    }
    if (is_key && e->key == '?') {
        puts(command_row_of(COMMAND_VIEW)->text);
        flush_output();
    }
    *moved = *moved || e->action == WINDOW_UNCOVERED;
    return 0;
}

/* Takes all events that have come, and draws once after them. A picture is saved as it is then. */
static int take_events(viewer *v, bool wait, bool *ended)
{
    window_event e;
    bool moved = false, saves = false;
    int fault = 0;
    while (fault == 0 && !*ended && window_next(wait, &e)) {
        *ended = is_end(&e);
        saves = saves || (e.action == WINDOW_KEY && e.key == 's');
        fault = react(v, &e, &moved);
        wait = false;
    }
    if (fault == 0 && moved)
        fault = redraw(v);
    if (fault == 0 && saves)
        save(v);
    return fault;
}

static void sleep_milliseconds(int count)
{
    const struct timespec time = {count / 1000, count % 1000 * 1000000L};
    nanosleep(&time, NULL);
}

/* Plays a script, event by event, or leaves the window to the user. */
static int run(viewer *v, const view_script *script)
{
    bool ended = false;
    int fault = redraw(v);
    for (size_t i = 0; i < script->count && fault == 0 && !ended; ++i) {
        if (script->events[i].action == WINDOW_WAIT)
            sleep_milliseconds(script->events[i].x);
        else
            window_push(script->events + i);
        fault = take_events(v, false, &ended);
    }
    while (script->events == NULL && fault == 0 && !ended)
        fault = take_events(v, true, &ended);
    return fault;
}

/* Places the camera where the options say, and from then on where the user moves it. */
static int begin(viewer *v)
{
    camera placed;
    int fault = camera_place(&v->o.camera, &v->c.bounds, v->o.width, v->o.height, &placed);
    if (fault != 0)
        return fault;
    orbit_begin(&v->o.camera, &placed);
    memcpy(v->o.camera.eye_rest, v->c.bounds.origin, sizeof v->o.camera.eye_rest);
    memcpy(v->o.camera.target_rest, v->c.bounds.origin, sizeof v->o.camera.target_rest);
    v->begin = v->o;
    v->shadows = v->o.shadows;
    return rebuild(v);
}

/* All maps are imported, since a key may choose a shader that uses them. */
static int import_all(viewer *v)
{
    options all = v->o;
    all.shading = SHADING_AUTOMATIC;
    return picture_import(&all, &v->c);
}

static int view(viewer *v)
{
    view_script script;
    memset(&script, 0, sizeof script);
    int fault = picture_check_output(&v->o, v->o.output, PICTURE_ANY);
    if (fault == 0 && v->o.script != NULL && output_same_file(v->o.output, v->o.script))
        fault = report_fault(v->o.script, "would be overwritten by the picture");
    if (fault == 0 && v->o.script != NULL)
        fault = view_script_read(v->o.script, &script);
    if (fault == 0)
        fault = import_all(v);
    if (fault == 0) {
        fault = begin(v);
        if (fault == 0)
            fault = window_open("gnomon", v->o.width, v->o.height);
        if (fault == 0)
            fault = run(v, &script);
        window_close();
        import_free(&v->c.from);
    }
    view_script_free(&script);
    drawing_free(&v->d);
    picture_free(&v->p);
    free(v->rgba);
    return fault;
}

int command_view(int argc, char **argv)
{
    static viewer v;
    int status;
    options_result result = options_parse(COMMAND_VIEW, argc, argv, &v.o, &status);
    if (result == OPTIONS_HELP || result == OPTIONS_HELP_ALL)
        return help_print(COMMAND_VIEW, result == OPTIONS_HELP_ALL);
    if (result == OPTIONS_WRONG)
        return status;
    if (v.o.output == NULL)
        v.o.output = "view.png";
    int fault = view(&v);
    return fault == 0 ? finish_output(0) : fault;
}
