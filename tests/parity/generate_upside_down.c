/* Scenes of other classes under viewports of negative height. */
#include "generate.h"

#include <math.h>

#include "generate_parts.h"

/* Whether a number has so few digits that sums of such numbers are exact. */
static bool is_coarse(float x)
{
    return fabsf(x) < 4096.0f && x * 256.0f == floorf(x * 256.0f);
}

/* Whether points are drawn at a side that cuts them. In the reference they have a row beyond it
 * then, in the picture if the side is a scissor's, in counts of samples if it is the target's. */
static bool cuts_points(const scene_draw *d)
{
    const gn_raster *const raster = &d->state.raster;

    return (raster->topology == GN_POINTS || raster->polygon_mode_front == GN_POLYGON_POINT ||
            raster->polygon_mode_back == GN_POLYGON_POINT) &&
           (raster->scissor.enabled || d->counted);
}

/* The reference computes the middle of a viewport from its lower side, the library from y, which is
 * the upper side then; so only viewports are turned in which both sums are exact. The reference
 * cuts off points of the vertex shader's size at a viewport's sides (reference/RULES.md). */
static void turn_upside_down(const scene *s, scene_draw *d)
{
    gn_viewport *const v = &d->state.raster.viewport;

    if (d->state.program.vertex_writes_point_size || cuts_points(d))
        return;
    if (!v->enabled)
        *v = (gn_viewport){true, 0.0f, 0.0f, (float)s->width, (float)s->height};
    if (is_coarse(v->y) && is_coarse(v->height)) {
        v->y += v->height;
        v->height = -v->height;
    }
}

scene *generate_upside_down(uint64_t seed)
{
    random_source r = random_seed(seed);
    /* Ties and mixed scenes more often. */
    const uint32_t chosen = random_below(&r, CLASS_MATERIALS + 13);
    const scene_class c = chosen <= CLASS_MATERIALS       ? (scene_class)chosen
                          : chosen <= CLASS_MATERIALS + 8 ? CLASS_TIES
                                                          : CLASS_MIXED;
    const uint64_t number = random_bits(&r);
    const uint64_t inner_seed = random_bits(&r);
    scene *const s = generate_scene(inner_seed, c, number);

    for (size_t i = 0; i < s->draw_count; ++i)
        if (random_chance(&r, 80))
            turn_upside_down(s, &s->draws[i]);
    return s;
}
