/* Clipping: new vertices and their places in the window, for all floats as coordinates, varyings,
 * clip distances, viewports and ranges of depth, with infinities and NaN, and for all counts of new
 * vertices up to the greatest. No access is out of bounds and no conversion of a float overflows.
 * Which vertices of polygons are read and written: wp_clip.c.
 * @options: -eva-precision 2
 * @reaches: plane_distance window_parameter interpolate_vertex place_new_vertices clip_line
 * @reaches: place_vertices outcodes_of viewport_transform_of lanes_round */
#include "eva.h"

#include "kernel/geometry/clip_line.inl"

#define VARYINGS 3
#define STRIDE 96 /* bytes of a vertex with three varyings and all clip distances */
#define FIRST_NEW 3

static union {
    float alignment;
    unsigned char bytes[(FIRST_NEW + 2 * CLIP_ROOM) * STRIDE];
} memory;

static void any_vertex(uint32_t n)
{
    stored_vertex *const v = vertex_at(memory.bytes, n * STRIDE);

    for (int i = 0; i < 4; ++i) {
        v->window[i] = any_float;
        v->clip[i] = any_float;
    }
    v->snapped[0] = any_int32;
    v->snapped[1] = any_int32;
    v->outcode = any_uint32;
    v->point_size = any_float;
    for (int i = 0; i < VARYINGS + GN_MAX_CLIP_DISTANCES; ++i)
        v->varying[i] = any_float;
}

static void any_state(gn_pipeline *p)
{
    p->program.varying_count = VARYINGS;
    p->program.clip_distance_count = GN_MAX_CLIP_DISTANCES;
    for (int i = 0; i < VARYINGS; ++i)
        p->program.interpolation[i] = (gn_interpolation)uint32_from(0, 2);
    p->raster.viewport.enabled = any_bool;
    p->raster.viewport.x = any_float;
    p->raster.viewport.y = any_float;
    p->raster.viewport.width = any_float;
    p->raster.viewport.height = any_float;
    p->depth.range.enabled = any_bool;
    p->depth.range.z_near = any_float;
    p->depth.range.z_far = any_float;
    p->depth.clamp_enabled = any_bool;
    p->depth.clip_depth = (gn_clip_depth)uint32_from(0, 1);
}

int main(void)
{
    static gn_pipeline pipeline;
    static clipper c;
    viewport_transform viewport;
    uint32_t line[2] = {0, STRIDE};

    any_state(&pipeline);
    for (uint32_t n = 0; n < FIRST_NEW; ++n)
        any_vertex(n);
    viewport =
        viewport_transform_of(&pipeline, uint32_from(1, GN_MAX_SIZE), uint32_from(1, GN_MAX_SIZE));
    viewport.snaps_from_corner = any_bool;
    c.pipeline = &pipeline;
    c.viewport = &viewport;
    c.memory = memory.bytes;
    c.scratch = FIRST_NEW * STRIDE;

    clip_line(&c, line);
    c.used = uint32_from(0, CLIP_MAX_VERTICES - 1);
    interpolate_vertex(&c, 0, STRIDE, any_float);
    c.used = uint32_from(0, CLIP_MAX_VERTICES);
    place_new_vertices(&c);
    return 0;
}
