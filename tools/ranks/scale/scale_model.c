/* The teapot, drawn by the command's own functions. */
#include "bounds.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scale_model.h"
#include "output.h"
#include "rotation.h"
#include "teapot.h"

static bool fail(const char *why)
{
    fprintf(stderr, "scale: %s\n", why);
    return false;
}

/* The options of `gnomon render`. They point to no memory of this function. */
static bool choose(uint32_t side, options *o)
{
    static char render[] = "render", teapot[] = "teapot", to[] = "-o", standard[] = "-";
    static char size_option[] = "--size";
    char size[32];
    char *words[] = {render, teapot, to, standard, size_option, size, NULL};
    int status;
    snprintf(size, sizeof size, "%ux%u", (unsigned)side, (unsigned)side);
    return options_parse(COMMAND_RENDER, 6, words, o, &status) == OPTIONS_READY;
}

/* Leaves out texture coordinates and tangents, which the file has not. `divided` gives every
 * triangle vertices of its own. */
static bool simplify(bool divided, model *m)
{
    const model_part *from = m->parts;
    model plain = {.part_count = 1, .parts = calloc(1, sizeof *plain.parts)};
    const uint32_t count = divided ? from->index_count : from->vertex_count;
    if (plain.parts == NULL)
        return false;
    model_part *to = plain.parts;
    to->has_normals = true;
    to->surface.shine = from->surface.shine;
    if (!model_part_allocate(to, count, from->index_count)) {
        model_free(&plain);
        return false;
    }
    to->world_from_model = from->world_from_model;
    for (uint32_t i = 0; i < count; ++i) {
        const size_t v = divided ? from->indices[i] : i;
        memcpy(to->positions + 3 * (size_t)i, from->positions + 3 * v, 3 * sizeof(float));
        memcpy(to->normals + 3 * (size_t)i, from->normals + 3 * v, 3 * sizeof(float));
        memcpy(to->colors + 4 * (size_t)i, from->colors + 4 * v, 4 * sizeof(float));
    }
    for (uint32_t i = 0; i < from->index_count; ++i)
        to->indices[i] = divided ? i : from->indices[i];
    model_free(m);
    *m = plain;
    return true;
}

bool scale_model_make(uint32_t level, uint32_t side, bool divided, scale_model *result)
{
    static const float grey[4] = {0.8f, 0.8f, 0.8f, 1.0f};
    memset(result, 0, sizeof *result);
    contents *c = &result->c;
    if (!choose(side, &result->o))
        return fail("the options of gnomon render have changed");
    if (!teapot_create(level, grey, &c->from.model) || !simplify(divided, &c->from.model))
        return fail("not enough memory");
    c->from.maps = calloc(c->from.model.part_count, sizeof *c->from.maps);
    if (c->from.maps == NULL)
        return fail("not enough memory");
    c->bounds = model_bounds(&c->from.model);
    return picture_build(&result->o, c, true, &result->p) == 0 &&
           drawing_allocate(result->p.scene, result->o.backend, &result->d) == 0;
}

bool scale_model_turn(scale_model *m, uint32_t frame, uint32_t frames)
{
    static const gn_vec3 axis = {1, 1, 0};
    const double *center = m->c.bounds.center;
    const gn_vec3 middle = {(float)center[0], (float)center[1], (float)center[2]};
    gn_transform turn, there, back;
    if (rotation_about(axis, (float)(360.0 * frame / frames), &turn) != GN_OK ||
        gn_translate(gn_vec3_scale(middle, -1.0f), &back) != GN_OK ||
        gn_translate(middle, &there) != GN_OK ||
        gn_transform_compose(&turn, &back, &turn) != GN_OK ||
        gn_transform_compose(&there, &turn, &turn) != GN_OK)
        return fail("the model cannot be turned");
    return picture_place(&m->p, &m->o, &m->c, &turn) == 0;
}

void scale_model_free(scale_model *m)
{
    drawing_free(&m->d);
    if (m->p.scene != NULL)
        picture_free(&m->p);
    model_free(&m->c.from.model);
    free(m->c.from.maps);
    memset(m, 0, sizeof *m);
}

static void write_lines(FILE *file, const model_part *part)
{
    for (size_t i = 0; i < part->vertex_count; ++i) {
        const float *p = part->positions + 3 * i;
        fprintf(file, "v %.9g %.9g %.9g\n", (double)p[0], (double)p[1], (double)p[2]);
    }
    for (size_t i = 0; i < part->vertex_count; ++i) {
        const float *n = part->normals + 3 * i;
        fprintf(file, "vn %.6g %.6g %.6g\n", (double)n[0], (double)n[1], (double)n[2]);
    }
    for (size_t i = 0; i < part->index_count; i += 3) {
        const uint32_t *v = part->indices + i;
        fprintf(file, "f %u//%u %u//%u %u//%u\n", v[0] + 1, v[0] + 1, v[1] + 1, v[1] + 1, v[2] + 1,
                v[2] + 1);
    }
}

bool scale_model_write(const scale_model *m, const char *path)
{
    output out;
    if (output_open(&out, path) != 0)
        return false;
    write_lines(out.file, m->c.from.model.parts);
    const bool good = output_finish(&out) == 0 && output_rename(&out) == 0;
    output_abandon(&out);
    return good;
}
