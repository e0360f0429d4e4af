/* gnomon spin: a model, or a plain triangle, turns once about an axis. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gnomon.h>

#include "bounds.h"
#include "apng_write.h"
#include "command.h"
#include "frames.h"
#include "help.h"
#include "numbering.h"
#include "picture_write.h"
#include "ranks.h"
#include "report.h"
#include "rotation.h"
#include "share_model.h"
#include "together.h"

/* Corners in red, green and blue. */
static int make_triangle(const options *o, contents *c)
{
    static const float positions[9] = {-1, -1, 0, 1, -1, 0, 0, 1, 0};
    static const float colors[12] = {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1};
    static const float normals[9] = {0, 0, 1, 0, 0, 1, 0, 0, 1};
    static const uint32_t indices[3] = {0, 1, 2};
    memset(c, 0, sizeof *c);
    c->from.maps = calloc(1, sizeof *c->from.maps);
    if (!model_allocate(&c->from.model, false, 3, 3) || c->from.maps == NULL)
        return report_fault("triangle", "not enough memory");
    model_part *part = c->from.model.parts;
    part->has_vertex_colors = part->has_normals = true;
    part->surface.shine.exponent = 32;
    memcpy(part->positions, positions, sizeof positions);
    memcpy(part->colors, colors, sizeof colors);
    memcpy(part->normals, normals, sizeof normals);
    memcpy(part->indices, indices, sizeof indices);
    part->world_from_model = o->world_from_all;
    c->bounds = model_bounds(&c->from.model);
    return 0;
}

/* The turn of a frame, about the middle of the contents. */
static int find_turn(const options *o, const contents *c, uint32_t frame, gn_transform *turn)
{
    const double *center = c->bounds.center;
    const gn_vec3 middle = {(float)center[0], (float)center[1], (float)center[2]};
    const float degrees = (float)(360.0 * frame / o->frames);
    gn_transform there, back;
    gn_status status = rotation_about(o->axis, degrees, turn);
    if (status != GN_OK)
        return report_fault("--axis", "impossible axis: %s", gn_status_text(status));
    gn_translate(gn_vec3_scale(middle, -1.0f), &back);
    status = gn_translate(middle, &there);
    if (status == GN_OK)
        status = gn_transform_compose(turn, &back, turn);
    if (status == GN_OK)
        status = gn_transform_compose(&there, turn, turn);
    return status == GN_OK ? 0 : report_fault("model", "%s", gn_status_text(status));
}

static int check_output(const options *o)
{
    /* Rank 0 looks at all names, the others whether the directory is there for them too. */
    const uint32_t checked = ranks_number() == 0 ? o->frames : 1;
    int fault = 0;
    if (!numbering_is_pattern(o->output)) {
        if (!picture_is_gif(o->output) && options_format(o) != PICTURE_PNG)
            return report_usage("spin",
                                "'%s': an animation is a PNG; for frames of other formats, "
                                "number them, as in frame_%%04d.tga",
                                o->output);
        return ranks_number() == 0 ? picture_check_output(o, o->output, PICTURE_PNG) : 0;
    }
    if (!numbering_is_valid(o->output))
        return report_usage("spin", "'%s': a pattern has one %%d, or one such as %%04d", o->output);
    for (uint32_t i = 0; i < checked && fault == 0; ++i) {
        char *name = numbering_name(o->output, i);
        fault = name != NULL ? picture_check_output(o, name, PICTURE_ANY)
                             : report_fault(o->output, "not enough memory");
        free(name);
    }
    return fault;
}

/* Rank 0, which has read the models, looks at all names. */
static int check_opened(const options *o, const contents *c)
{
    const uint32_t checked = ranks_number() == 0 && numbering_is_pattern(o->output) ? o->frames : 0;
    int fault = 0;
    for (uint32_t i = 0; i < checked && c->from.opened.count > 0 && fault == 0; ++i) {
        char *name = numbering_name(o->output, i);
        fault = name != NULL ? picture_check_opened(c, name)
                             : report_fault(o->output, "not enough memory");
        free(name);
    }
    return together_as_first(fault);
}

/* The frames of a turn, and where they go: to one animated file, which rank 0 writes, or to files
 * of their own. */
typedef struct turn {
    const options *o;
    frames f;
    output file;
    apng *animation; /* null at other ranks, and for numbered files */
    bool is_drawn;   /* a frame of this rank has something */
} turn;

/* Frames count what passes the depth test until one has something; counting takes time. */
static void set_counted(const scene *s, bool counted)
{
    for (size_t i = 0; i < s->draw_count; ++i)
        s->draws[i].counted = counted;
}

/* Draws a frame, and writes or compresses it. */
static int do_frame(void *context, tasks *t, uint32_t number, task_result *result)
{
    turn *w = context;
    const options *o = w->o;
    const frames_rows rows = {&w->f.d.frame, t};
    gn_transform there;
    int fault = find_turn(o, &w->f.c, number, &there);
    if (fault == 0)
        fault = frames_draw(&w->f, o, &there);
    if (fault != 0)
        return fault;
    if (!w->is_drawn && w->f.d.frame.samples_passed > 0) {
        w->is_drawn = true;
        set_counted(w->f.p.scene, false);
    }
    if (!numbering_is_pattern(o->output))
        return apng_compress(o->output, o->width, o->height, frames_color_row, &rows,
                             &result->bytes, &result->size);
    char *name = numbering_name(o->output, number);
    if (name == NULL)
        return report_fault(o->output, "not enough memory");
    fault = picture_write_file(name, options_format(o), PNG_RGBA8, o->width, o->height,
                               frames_color_row, &rows);
    free(name);
    return fault;
}

static int add_frame(void *context, uint32_t number, const task_result *result)
{
    const turn *w = context;
    (void)number; /* they come in order */
    return apng_add(w->animation, result->bytes, result->size);
}

static int begin_animation(const options *o, turn *w)
{
    int fault = output_open(&w->file, o->output);
    if (fault != 0)
        return fault;
    w->animation = apng_begin(&w->file, o->width, o->height, o->frames, o->rate);
    return w->animation != NULL ? 0 : EXIT_FAULT;
}

static int end_animation(turn *w, int fault)
{
    if (fault == 0 && w->animation != NULL) {
        fault = output_finish(&w->file);
        if (fault == 0)
            fault = output_rename(&w->file);
    }
    apng_free(w->animation);
    output_abandon(&w->file);
    return together_as_first(fault);
}

/* Draws and writes all frames. */
static int draw_frames(const options *o, turn *w, uint32_t *here)
{
    const bool animated = !numbering_is_pattern(o->output);
    const tasks_job job = {o->frames, w, do_frame, animated ? add_frame : NULL};
    int fault = 0;
    set_counted(w->f.p.scene, true);
    if (animated && ranks_number() == 0)
        fault = begin_animation(o, w);
    fault = together_as_first(fault);
    if (fault == 0)
        fault = tasks_run(&job, here);
    return end_animation(w, fault);
}

/* Collective. Warns if no rank has drawn anything, and says why the first frame is empty. */
static int warn(const options *o, turn *w)
{
    gn_transform still;
    int fault = 0;
    if (ranks_largest(w->is_drawn) == 0 && ranks_number() == 0) {
        fault = find_turn(o, &w->f.c, 0, &still);
        if (fault == 0)
            fault = frames_draw(&w->f, o, &still);
        if (fault == 0)
            fault = frames_warn(o->output, o, &w->f);
    }
    return fault;
}

static int spin(options *o)
{
    static turn w;
    FILE *words = output_words(o->output, NULL);
    uint32_t here = 0;
    memset(&w, 0, sizeof w);
    w.o = o;
    if (o->model_count == 0 && o->shading == SHADING_AUTOMATIC && !o->shadows)
        o->shading = SHADING_VERTEX_COLOR;
    together_begin();
    int fault = check_output(o);
    if (fault == 0 && o->model_count == 0)
        fault = make_triangle(o, &w.f.c);
    fault = together_end(fault);
    if (fault == 0 && o->model_count > 0)
        fault = share_import(o, &w.f.c);
    if (fault == 0)
        fault = check_opened(o, &w.f.c);
    if (fault == 0)
        fault = frames_begin(o, &w.f);
    if (fault == 0)
        fault = draw_frames(o, &w, &here);
    if (fault == 0) {
        if (ranks_number() == 0)
            picture_print_summary(words, o->output, &w.f.p);
        frames_print(ranks_number() == 0 ? words : NULL, &w.f, "frame", o->frames, here);
        fault = warn(o, &w);
    }
    frames_free(&w.f);
    return fault;
}

int command_spin(int argc, char **argv)
{
    options o;
    int status;
    together_begin();
    options_result result = options_parse(COMMAND_SPIN, argc, argv, &o, &status);
    const int wrong = together_end(result == OPTIONS_WRONG ? status : 0);
    if (result == OPTIONS_HELP || result == OPTIONS_HELP_ALL)
        return help_print(COMMAND_SPIN, result == OPTIONS_HELP_ALL);
    if (wrong != 0)
        return wrong;
    if (o.output == NULL)
        o.output = "spin.png";
    int fault = spin(&o);
    return fault == 0 ? finish_output(0) : fault;
}
