/* Scenes that every library draws. */
#include "basic.h"

bool class_is_basic(scene_class c)
{
    return c != CLASS_SHADOWED && c != CLASS_SAMPLES && c != CLASS_MASKS &&
           c != CLASS_SAMPLE_SHADING && c != CLASS_MIXED && c != CLASS_SEQUENCES &&
           c != CLASS_BATCHES && c != CLASS_BATCH_ENDS && c != CLASS_MATERIALS &&
           c != CLASS_UPSIDE_DOWN;
}

/* Leaves what a GN_BASIC library reads of a sampler: it takes wraps that it lacks for others, and
 * ignores most other members. */
static void make_sampler_basic(gn_sampler *s)
{
    const gn_sampler none = {0};
    gn_sampler basic = none;

    basic.wrap_s = s->wrap_s == GN_WRAP_REPEAT ? GN_WRAP_REPEAT : GN_WRAP_CLAMP_TO_EDGE;
    basic.wrap_t = s->wrap_t == GN_WRAP_REPEAT ? GN_WRAP_REPEAT : GN_WRAP_CLAMP_TO_EDGE;
    basic.magnify = s->magnify;
    basic.minify = s->magnify == GN_MAGNIFY_LINEAR ? GN_MINIFY_LINEAR : GN_MINIFY_NEAREST;
    *s = basic;
}

static void make_draw_basic(scene_draw *d)
{
    const gn_color none = {0};

    d->state.color = none;
    d->state.stencil.test_enabled = false;
    d->state.raster.polygon_mode_front = d->state.raster.polygon_mode_back = GN_POLYGON_FILL;
    d->state.raster.polygon_offset.enabled = false;
    d->state.depth.clamp_enabled = false;
    d->state.program.clip_distance_count = 0;
    d->counted = false;
    if (d->shader == SCENE_DERIVATIVES || d->shader == SCENE_SAMPLED)
        d->shader = SCENE_VERTEX_COLOR;
    if (d->shader == SCENE_FACES)
        d->shader = SCENE_GOURAUD;
    d->surface.has_point_light = d->surface.has_spot_light = false;
    d->surface.more_light_count = 0;
    d->mesh.instance_count = 1;
    make_sampler_basic(&d->uniforms.sampler);
}

/* Formats of a GN_BASIC library. */
static bool format_is_basic(gn_format format)
{
    return format == GN_FORMAT_RGBA8 || format == GN_FORMAT_RGBA32F || format == GN_FORMAT_RGB565 ||
           format == GN_FORMAT_RGB565_SWAPPED;
}

static bool texture_is_basic(const gn_texture *t)
{
    return !t->level[0].texels ||
           (t->target == GN_TEXTURE_2D && scene_level_count(t) == 1 && format_is_basic(t->format));
}

/* Whether a GN_BASIC library draws a draw that make_draw_basic has changed. */
static bool draws_basic(const scene_draw *d)
{
    const gn_program *const p = &d->state.program;
    bool textures = !scene_draw_has_texture(d) || texture_is_basic(&d->uniforms.texture);

    for (int m = 0; m < SCENE_MAP_COUNT; ++m)
        textures = textures && (!scene_draw_has_map(d, (scene_map)m) ||
                                (m != SCENE_SHADOW_MAP && texture_is_basic(&d->surface.map[m])));
    return textures && d->state.raster.topology <= GN_TRIANGLE_FAN &&
           d->mesh.restart == GN_RESTART_NONE && !p->fragment_reads_point_coordinate &&
           !p->fragment_reads_sample_mask && !p->fragment_writes_sample_mask;
}

bool make_basic(scene *s)
{
    bool drawn = true;

    s->samples = 1;
    if (!format_is_basic(s->color_format))
        s->color_format = gn_format_size(s->color_format) == 2 ? GN_FORMAT_RGB565 : GN_FORMAT_RGBA8;
    if (s->depth_format == GN_FORMAT_D24S8 || s->depth_format == GN_FORMAT_S8)
        s->depth_format = GN_FORMAT_D24;
    if (s->depth_format == GN_FORMAT_D32FS8)
        s->depth_format = GN_FORMAT_D16;
    for (int a = 1; a < GN_MAX_COLORS; ++a)
        drawn = drawn && scene_color_format(s, a) == GN_FORMAT_NONE;
    for (size_t i = 0; i < s->draw_count; ++i) {
        make_draw_basic(&s->draws[i]);
        drawn = drawn && draws_basic(&s->draws[i]);
    }
    return drawn;
}
