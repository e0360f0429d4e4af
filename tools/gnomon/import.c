/* Imports models in a confined process. */
#define _POSIX_C_SOURCE 200809L
#include "import.h"

#include <stdlib.h>
#include <string.h>

#include "confined.h"
#include "model_read.h"
#include "report.h"

/* What a model is imported for. */
typedef struct request {
    const options *o;
    unsigned int wanted;
} request;

static int read_maps(const options *o, unsigned int wanted, uint64_t bytes, imported *result)
{
    image_budget budget = {o->limits.megapixels, bytes};
    result->maps = calloc(result->model.part_count, sizeof *result->maps);
    if (result->maps == NULL)
        return report_fault(o->model, IMPORT_NO_MEMORY);
    for (size_t i = 0; i < result->model.part_count; ++i) {
        int fault =
            maps_read(o, &result->model, i, wanted, &budget, result->maps + i, &result->told);
        if (fault != 0)
            return fault;
    }
    return 0;
}

static int read_all(const options *o, unsigned int wanted, imported *result)
{
    const uint64_t most = (uint64_t)o->limits.output << 20;
    uint64_t size = 0;
    int fault = model_read(o->model, (uint64_t)o->limits.memory << 20, (double)o->crease_degrees,
                           &result->model);
    for (size_t i = 0; fault == 0 && i < result->model.part_count; ++i)
        size += handover_size(result->model.parts + i);
    if (fault == 0 && size > most)
        fault = report_fault(o->model,
                             "takes %llu MiB when it is imported, more than --import-output %u "
                             "allows",
                             (unsigned long long)(size >> 20) + 1, (unsigned)o->limits.output);
    return fault != 0 ? fault : read_maps(o, wanted, most - size, result);
}

/* The child's work. Nothing is freed, since the process ends. */
static bool send_import(int descriptor, const void *context)
{
    const request *r = context;
    imported what;
    memset(&what, 0, sizeof what);
    return read_all(r->o, r->wanted, &what) == 0
               ? handover_send_model(descriptor, &what)
               : handover_send_text(descriptor, HANDOVER_FAULT, "");
}

static bool receive_import(handover *h, const char *text, void *result)
{
    imported *to = result;
    to->told.text = text[0] != '\0' ? strdup(text) : NULL;
    to->opened = h->opened;
    h->opened = (files_list){NULL, 0};
    return handover_receive_model(h, to);
}

int import_model(const options *o, unsigned int wanted, imported *result)
{
    const request r = {o, wanted};
    memset(result, 0, sizeof *result);
    int fault = confined_run(o->model, &o->limits, send_import, &r, receive_import, result);
    if (fault != 0)
        import_free(result);
    return fault;
}

/* Moves the parts and maps of a model to the end of others, and adds its files to theirs. Returns
 * false if there is not enough memory; `from` must be freed either way. */
static bool append(imported *to, imported *from)
{
    const size_t count = to->model.part_count, added = from->model.part_count;
    model_part *parts = realloc(to->model.parts, (count + added) * sizeof *parts);
    if (parts == NULL)
        return false;
    to->model.parts = parts;
    part_maps *maps = realloc(to->maps, (count + added) * sizeof *maps);
    if (maps == NULL)
        return false;
    to->maps = maps;
    const uint32_t lit = to->model.light_count, lights = from->model.light_count;
    model_light *all = realloc(to->model.lights, (lit + lights + 1) * sizeof *all);
    if (all == NULL)
        return false;
    to->model.lights = all;
    memcpy(all + lit, from->model.lights, lights * sizeof *all);
    to->model.light_count += lights;
    memcpy(parts + count, from->model.parts, added * sizeof *parts);
    memcpy(maps + count, from->maps, added * sizeof *maps);
    to->model.part_count += added;
    from->model.part_count = 0;
    for (size_t i = 0; i < from->opened.count; ++i)
        if (!files_list_add(&to->opened, from->opened.paths[i]))
            return false;
    return maps_told_append(&to->told, &from->told);
}

static void place_light(model_light *l, const gn_transform *world_from_model,
                        const double origin[3])
{
    const float(*w)[4] = world_from_model->matrix.m;
    const double p[3] = {l->position[0], l->position[1], l->position[2]};
    const gn_vec3 d = {l->direction[0], l->direction[1], l->direction[2]};
    gn_vec3 turned = gn_mat4_transform_direction(&world_from_model->matrix, d);
    for (int c = 0; c < 3; ++c)
        l->position[c] = (double)w[0][c] * p[0] + (double)w[1][c] * p[1] + (double)w[2][c] * p[2] +
                         (double)w[3][c] - origin[c];
    if (gn_vec3_normalize(turned, &turned) != GN_OK)
        return;
    l->direction[0] = turned.x;
    l->direction[1] = turned.y;
    l->direction[2] = turned.z;
}

/* Places the parts of a model. The first model whose place is far from the world's origin decides
 * from where all are measured, so that the places are exact sums of doubles and become floats only
 * then. */
static int place(model *m, const gn_transform *world_from_model, bool is_first, model *all)
{
    const float(*w)[4] = world_from_model->matrix.m;
    double at[3];
    bool is_far = false;
    gn_transform moved, turned = *world_from_model, placed = *world_from_model;
    for (int c = 0; c < 3; ++c) {
        at[c] = (double)w[0][c] * m->origin[0] + (double)w[1][c] * m->origin[1] +
                (double)w[2][c] * m->origin[2] + (double)w[3][c];
        is_far = is_far || m->origin[c] != 0.0 || (!is_first && all->origin[c] != 0.0);
    }
    if (is_far) {
        if (is_first)
            memcpy(all->origin, at, sizeof at);
        const gn_vec3 shift = {(float)(at[0] - all->origin[0]), (float)(at[1] - all->origin[1]),
                               (float)(at[2] - all->origin[2])};
        /* An affine matrix without its translation has an inverse without one. */
        for (int c = 0; c < 3; ++c)
            turned.matrix.m[3][c] = turned.inverse.m[3][c] = 0.0f;
        if (gn_translate(shift, &moved) != GN_OK ||
            gn_transform_compose(&moved, &turned, &placed) != GN_OK)
            return report_fault("model", "cannot be placed: it is too far from the first model");
    }
    for (size_t p = 0; p < m->part_count; ++p)
        m->parts[p].world_from_model = placed;
    for (uint32_t i = 0; i < m->light_count; ++i)
        place_light(m->lights + i, world_from_model, all->origin);
    return 0;
}

int import_models(const options *o, unsigned int wanted, imported *result)
{
    options one = *o;
    int fault = 0;
    memset(result, 0, sizeof *result);
    for (size_t i = 0; i < o->model_count && fault == 0; ++i) {
        imported next;
        one.model = o->models[i].path;
        fault = import_model(&one, wanted, &next);
        if (fault != 0)
            break;
        fault = place(&next.model, &o->models[i].world_from_model, i == 0, &result->model);
        if (fault != 0) {
            import_free(&next);
            break;
        }
        if (!append(result, &next))
            fault = report_fault(one.model, "not enough memory");
        import_free(&next);
    }
    if (fault != 0)
        import_free(result);
    return fault;
}

void import_free(imported *i)
{
    for (size_t p = 0; i->maps != NULL && p < i->model.part_count; ++p)
        maps_free(i->maps + p);
    free(i->maps);
    i->maps = NULL;
    model_free(&i->model);
    maps_told_free(&i->told);
    files_list_free(&i->opened);
}
