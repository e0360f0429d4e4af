/* Properties over the random scenes of the parity gate, without a reference: a picture depends only
 * on the scene, not on memory, workspace or rows; scenes survive being written; failing scenes
 * shrink. */
#include <stdlib.h>
#include <string.h>

#include "generate.h"
#include "random.h"
#include "random_inputs.h"
#include "shrink.h"

typedef struct instance {
    scene_class class;
    uint64_t number;
    uint64_t choice; /* what a property needs besides the scene */
} instance;

static enum theft_alloc_res make_instance(struct theft *t, void *env, void **output)
{
    instance *const i = *output = allocated(sizeof *i);
    (void)env;
    i->class = (scene_class)theft_random_choice(t, CLASS_COUNT);
    i->number = theft_random_bits(t, 20);
    i->choice = theft_random_bits(t, 16);
    return THEFT_ALLOC_OK;
}

static void print_instance(FILE *f, const void *argument, void *env)
{
    const instance *i = argument;
    (void)env;
    fprintf(f, "%s scene %" PRIu64 " of seed 0, choice %" PRIu64 "\n", scene_class_name(i->class),
            i->number, i->choice);
}

static scene *scene_of(const instance *i)
{
    return generate_scene(0, i->class, i->number);
}

static scene_frame frame_of(const scene *s)
{
    scene_frame frame;
    if (!scene_frame_allocate(&frame, s)) {
        fprintf(stderr, "properties: out of memory\n");
        exit(EXIT_FAILURE);
    }
    return frame;
}

/* Draws both scenes, each in its workspace, and compares the bits. */
static bool same_picture(const scene *a, size_t workspace_a, const scene *b, size_t workspace_b)
{
    scene_frame frame_a = frame_of(a), frame_b = frame_of(b);
    const bool same = scene_draw_library(a, &frame_a, workspace_a, GN_BACKEND_AUTO) == GN_OK &&
                      scene_draw_library(b, &frame_b, workspace_b, GN_BACKEND_AUTO) == GN_OK &&
                      scene_compare(a, &frame_a, &frame_b).pixels == 0;
    scene_frame_free(&frame_a);
    scene_frame_free(&frame_b);
    return same;
}

static enum theft_trial_res any_workspace(struct theft *t, void *argument)
{
    const instance *i = argument;
    scene *s = scene_of(i);
    (void)t;
    const size_t least = gn_workspace_size(0, scene_varyings(s));
    const bool same = same_picture(s, 0, s, least + (i->choice & 3 ? i->choice : 0));
    scene_free(s);
    return verdict(same);
}

static enum theft_trial_res survives_text(struct theft *t, void *argument)
{
    char error[256];
    scene *s = scene_of(argument), *back = NULL;
    FILE *text = tmpfile();
    (void)t;
    if (text && scene_write(s, text)) {
        rewind(text);
        back = scene_read(text, error, sizeof error);
    }
    if (text)
        fclose(text);
    const bool same = back && scene_triangle_count(s) == scene_triangle_count(back) &&
                      same_picture(s, 0, back, 0);
    scene_free(s);
    scene_free(back);
    return verdict(same);
}

static gn_surface top_down(const scene *s, void *memory, gn_format format)
{
    const gn_surface image = gn_surface_top_down(memory, format, s->width, s->height);
    return scene_is_sampled(s) ? gn_surface_multisampled(&image) : image;
}

/* A scene drawn into surfaces whose first row in memory is the top row. */
static bool draw_top_down(const scene *s, scene_frame *frame)
{
    gn_target target;
    memset(&target, 0, sizeof target);
    for (int a = 0; a < GN_MAX_COLORS; ++a)
        if (scene_color_format(s, a) != GN_FORMAT_NONE)
            target.color[a] = top_down(s, scene_frame_color(frame, a), scene_color_format(s, a));
    if (s->depth_format != GN_FORMAT_NONE)
        target.depth = top_down(s, frame->depth, s->depth_format);
    const size_t size = scene_workspace_size(s);
    gn_workspace workspace = {.memory = malloc(size), .size = size};
    const bool good = workspace.memory && scene_draw_to_target(s, &target, &workspace) == GN_OK;
    free(workspace.memory);
    return good;
}

/* For the image of every sample. */
static bool rows_reversed(const scene *s, const void *a, const void *b, gn_format format)
{
    const size_t row = s->width * gn_format_size(format);
    const uint32_t images = scene_is_sampled(s) ? GN_SAMPLES : 1;
    for (uint32_t y = 0; y < images * s->height && row > 0; ++y) {
        const uint32_t image = y / s->height * s->height;
        const uint32_t mirrored = image + s->height - 1 - y % s->height;
        if (memcmp((const char *)a + row * y, (const char *)b + row * mirrored, row) != 0)
            return false;
    }
    return true;
}

static bool colors_reversed(const scene *s, const scene_frame *up, const scene_frame *down)
{
    bool reversed = true;
    for (int a = 0; a < GN_MAX_COLORS; ++a)
        reversed = reversed && rows_reversed(s, scene_frame_color(up, a),
                                             scene_frame_color(down, a), scene_color_format(s, a));
    return reversed;
}

static enum theft_trial_res rows_either_way(struct theft *t, void *argument)
{
    scene *s = scene_of(argument);
    scene_frame up = frame_of(s), down = frame_of(s);
    (void)t;
    const bool same = scene_draw_library(s, &up, 0, GN_BACKEND_AUTO) == GN_OK &&
                      draw_top_down(s, &down) && colors_reversed(s, &up, &down) &&
                      rows_reversed(s, up.depth, down.depth, s->depth_format);
    scene_frame_free(&up);
    scene_frame_free(&down);
    scene_free(s);
    return verdict(same);
}

typedef struct pixel_place {
    uint32_t x, y;
} pixel_place;

static bool same_pixel(const void *a, const void *b, gn_format format, size_t at)
{
    const size_t size = gn_format_size(format);
    return size == 0 || memcmp((const char *)a + at * size, (const char *)b + at * size, size) == 0;
}

/* The planted fault: a pixel differs from what clears alone leave there. */
static bool covers_pixel(const scene *s, void *context)
{
    const pixel_place *p = context;
    if (p->x >= s->width || p->y >= s->height)
        return false;
    scene *empty = scene_copy(s);
    for (size_t i = 0; i < empty->draw_count; ++i)
        empty->draws[i].mesh.count = 0;
    scene_frame drawn = frame_of(s), cleared = frame_of(s);
    const size_t at = (size_t)p->y * s->width + p->x;
    const bool covered = scene_draw_library(s, &drawn, 0, GN_BACKEND_AUTO) == GN_OK &&
                         scene_draw_library(empty, &cleared, 0, GN_BACKEND_AUTO) == GN_OK &&
                         (!same_pixel(drawn.color, cleared.color, s->color_format, at) ||
                          !same_pixel(drawn.depth, cleared.depth, s->depth_format, at));
    scene_frame_free(&drawn);
    scene_frame_free(&cleared);
    scene_free(empty);
    return covered;
}

static enum theft_trial_res failing_scene_shrinks(struct theft *t, void *argument)
{
    const instance *i = argument;
    scene *s = scene_of(i);
    random_source r = random_seed(i->choice);
    pixel_place p = {0, 0};
    (void)t;
    bool found = false;
    for (int attempt = 0; attempt < 40 && !found; ++attempt) {
        p.x = random_below(&r, s->width);
        p.y = random_below(&r, s->height);
        found = covers_pixel(s, &p);
    }
    if (!found) {
        scene_free(s);
        return THEFT_TRIAL_SKIP;
    }
    scene *small = shrink_scene(s, covers_pixel, &p, 5000);
    const bool good = covers_pixel(small, &p) && small->draw_count == 1 &&
                      scene_triangle_count(small) == 1 && !small->draws[0].state.depth.test &&
                      small->draws[0].mesh.index_format == GN_INDEX_NONE;
    scene_free(small);
    scene_free(s);
    return verdict(good);
}

#define INSTANCE INSTANCES(make_instance, print_instance, NULL)

static const property scenes[] = {
    DRAWING("any workspace gives the same picture", any_workspace, INSTANCE, 10),
    DRAWING("top-down surfaces hold the same picture", rows_either_way, INSTANCE, 10),
    DRAWING("a scene survives being written", survives_text, INSTANCE, 10),
    DRAWING("a failing scene shrinks to one triangle", failing_scene_shrinks, INSTANCE, 1),
};

SUITE(properties_scenes, scenes);
