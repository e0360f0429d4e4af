/* Draws models from a list of cameras. */
#include "render_views.h"

#include <stdlib.h>
#include <string.h>

#include "counts.h"
#include "frames.h"
#include "numbering.h"
#include "ranks.h"
#include "report.h"
#include "share_model.h"
#include "together.h"
#include "views.h"

/* Pictures that are drawn, and their cameras. */
typedef struct album {
    const options *o;
    options one; /* of the picture that is drawn */
    views v;
    frames f;
} album;

/* Collective. Rank 0 reads the views and shares them. */
static int share_views(const options *o, views *v)
{
    memset(v, 0, sizeof *v);
    int fault = together_as_first(ranks_number() == 0 ? views_read(o->views, &o->camera, v) : 0);
    if (fault != 0)
        return fault;
    ranks_share(0, &v->count, sizeof v->count);
    if (ranks_number() > 0) {
        v->list = malloc(v->count * sizeof *v->list);
        if (v->list == NULL)
            fault = report_fault(o->views, "not enough memory");
    }
    fault = ranks_agree(fault);
    if (fault == 0)
        ranks_share(0, v->list, v->count * sizeof *v->list);
    return fault;
}

/* Checks a name that must be a pattern. */
static int check_pattern(const char *option, const char *name)
{
    if (!numbering_is_pattern(name))
        return report_usage("render", "with --views, %s is a pattern such as view_%%04d.png: '%s'",
                            option, name);
    if (!numbering_is_valid(name))
        return report_usage("render", "'%s': a pattern has one %%d, or one such as %%04d", name);
    return 0;
}

static int check_options(const options *o)
{
    int fault = check_pattern("-o", o->output);
    if (fault == 0 && o->depth_output != NULL)
        fault = check_pattern("--depth", o->depth_output);
    if (fault == 0 && o->statistics)
        fault = report_usage("render", "--views and --statistics cannot be used together");
    return fault;
}

/* The names of a picture. Null: not enough memory, or no depth. */
typedef struct names {
    char *color, *depth;
} names;

static int make_names(const options *o, uint32_t number, names *n)
{
    n->color = numbering_name(o->output, number);
    n->depth = o->depth_output != NULL ? numbering_name(o->depth_output, number) : NULL;
    return n->color != NULL && (o->depth_output == NULL || n->depth != NULL)
               ? 0
               : report_fault(o->output, "not enough memory");
}

static void free_names(names *n)
{
    free(n->color);
    free(n->depth);
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

/* Checks that no depth has the name of another view's picture. */
static int check_distinct(const options *o, uint32_t count)
{
    char **all = calloc(2 * (size_t)count, sizeof *all);
    int fault = all != NULL ? 0 : report_fault(o->output, "not enough memory");
    for (uint32_t i = 0; i < count && fault == 0; ++i) {
        names n;
        fault = make_names(o, i, &n);
        all[2 * i] = n.color;
        all[2 * i + 1] = n.depth;
    }
    if (fault == 0)
        qsort(all, 2 * (size_t)count, sizeof *all, compare_names);
    for (size_t i = 1; i < 2 * (size_t)count && fault == 0; ++i)
        if (strcmp(all[i - 1], all[i]) == 0)
            fault = report_fault(all[i], "cannot be both a picture and a depth");
    for (size_t i = 0; all != NULL && i < 2 * (size_t)count; ++i)
        free(all[i]);
    free(all);
    return fault;
}

/* Rank 0 looks at all names, the others whether the directory is there for them too. */
static int check_names(const options *o, uint32_t count)
{
    const uint32_t checked = ranks_number() == 0 ? count : 1;
    int fault = 0;
    for (uint32_t i = 0; i < checked && fault == 0; ++i) {
        names n;
        fault = make_names(o, i, &n);
        if (fault == 0)
            fault = picture_check_output(o, n.color, PICTURE_ANY_OR_RAW);
        if (fault == 0)
            fault = picture_check_output(o, n.depth, PICTURE_PNG);
        if (fault == 0 && n.depth != NULL && output_same_file(n.color, n.depth))
            fault = report_fault(n.color, "cannot be both the picture and the depth");
        if (fault == 0 && (output_same_file(n.color, o->views) ||
                           (n.depth != NULL && output_same_file(n.depth, o->views))))
            fault = report_fault(o->views, "would be overwritten by the picture");
        free_names(&n);
    }
    return fault == 0 && o->depth_output != NULL && ranks_number() == 0 ? check_distinct(o, count)
                                                                        : fault;
}

/* Rank 0, which has read the models, looks at all names. */
static int check_opened(const options *o, const contents *c, uint32_t count)
{
    int fault = 0;
    for (uint32_t i = 0; ranks_number() == 0 && i < count && fault == 0; ++i) {
        names n;
        fault = make_names(o, i, &n);
        if (fault == 0)
            fault = picture_check_opened(c, n.color);
        if (fault == 0)
            fault = picture_check_opened(c, n.depth);
        free_names(&n);
    }
    return together_as_first(fault);
}

static int do_view(void *context, tasks *t, uint32_t number, task_result *result)
{
    album *a = context;
    const frames_rows from = {&a->f.d.frame, t};
    const picture_rows rows = {frames_color_row, frames_depth_row, &from};
    gn_transform still;
    names n;
    (void)result;
    gn_transform_identity(&still);
    a->one.camera = a->v.list[number].camera;
    int fault = make_names(a->o, number, &n);
    if (fault == 0)
        fault = frames_draw(&a->f, &a->one, &still);
    if (fault == 0)
        fault = picture_files_write(a->o, n.color, n.depth, &rows);
    if (fault == 0)
        fault = frames_warn(n.color, a->o, &a->f);
    free_names(&n);
    return fault;
}

static int draw_all(album *a, uint32_t *here)
{
    const tasks_job job = {a->v.count, a, do_view, NULL};
    a->one = *a->o;
    a->one.camera = a->v.list[0].camera;
    int fault = share_import(a->o, &a->f.c);
    if (fault == 0)
        fault = check_opened(a->o, &a->f.c, a->v.count);
    if (fault != 0)
        return fault;
    together_begin();
    fault =
        together_end(views_check(a->o->views, &a->v, &a->f.c.bounds, a->o->width, a->o->height));
    if (fault == 0)
        fault = frames_begin(&a->one, &a->f);
    return fault == 0 ? tasks_run(&job, here) : fault;
}

int render_views(const options *o)
{
    static album a;
    uint32_t here = 0;
    memset(&a, 0, sizeof a);
    a.o = o;
    int fault = check_options(o);
    if (fault == 0)
        fault = share_views(o, &a.v);
    if (fault == 0) {
        together_begin();
        fault = together_end(check_names(o, a.v.count));
    }
    if (fault == 0)
        fault = draw_all(&a, &here);
    if (fault == 0) {
        if (ranks_number() == 0)
            picture_print_summary(stdout, o->output, &a.f.p);
        frames_print(ranks_number() == 0 ? stdout : NULL, &a.f, "view", a.v.count, here);
    }
    frames_free(&a.f);
    views_free(&a.v);
    return fault;
}
