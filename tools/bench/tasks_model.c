/* Makes a scene of a model with the command's importer, camera and light. */
#include "bounds.h"

#include <stdio.h>
#include <string.h>

#include "tasks_model.h"
#include "look.h"
#include "picture.h"
#include "teapot.h"

/* 32 patches of 40x40 squares: 102,400 triangles. */
#define TEAPOT_LEVEL 40

/* The options of `gnomon render`; `path` is any name for the teapot. */
static bool choose(const char *path, uint32_t side, options *o)
{
    char size[32];
    char *words[] = {"render", (char *)path, "-o", "-", "--size", size, NULL};
    int status;

    snprintf(size, sizeof size, "%ux%u", (unsigned)side, (unsigned)side);
    return options_parse(COMMAND_RENDER, 6, words, o, &status) == OPTIONS_READY;
}

static scene *draw_teapot(const options *o)
{
    static const float grey[4] = {0.8f, 0.8f, 0.8f, 1.0f};
    static const part_maps none;
    model teapot;
    camera view;
    look l;
    scene *s = NULL;

    if (!teapot_create(TEAPOT_LEVEL, grey, &teapot)) {
        fprintf(stderr, "bench: out of memory\n");
        return NULL;
    }
    const bounding_sphere bounds = model_bounds(&teapot);
    if (camera_place(&o->camera, &bounds, o->width, o->height, &view) == 0 &&
        look_choose(o, &view, SHADING_GOURAUD, &l) == 0) {
        s = scene_create(o->width, o->height, GN_FORMAT_RGBA8, GN_FORMAT_D32F);
        s->clear_depth = 1.0f;
        look_add_part(s, &l, teapot.parts, &none);
    }
    model_free(&teapot);
    return s;
}

scene *tasks_model(const char *path, uint32_t side)
{
    options o;
    picture p;

    if (!choose(path ? path : "teapot", side, &o))
        return NULL;
    if (!path)
        return draw_teapot(&o);
    if (picture_describe(&o, &p) != 0)
        return NULL;
    scene *s = p.scene;
    p.scene = NULL;
    picture_free(&p);
    return s;
}
