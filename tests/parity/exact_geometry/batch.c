/* Random triangles on the grid of snapping: as many ties and odd shapes as possible. */
#include "batch.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Coordinates in 1/256 pixel. */
enum { PIXEL = 256, HALF = 128 };

/* Where corners may lie: [axis]. */
typedef struct place_range {
    int32_t low[2], high[2];
} place_range;

static int32_t multiple_between(random_source *r, int32_t low, int32_t high, int32_t grain)
{
    const int32_t first = (int32_t)ceil((double)low / grain);
    const int32_t last = (int32_t)floor((double)high / grain);

    return first > last ? low : random_between(r, first, last) * grain;
}

static void place_corner(random_source *r, const place_range *range, int32_t grain, int64_t p[2])
{
    for (int axis = 0; axis < 2; ++axis)
        p[axis] = multiple_between(r, range->low[axis], range->high[axis], grain);
}

/* Returns the part of a range that is within `reach` of a place. */
static place_range range_around(const place_range *range, const int64_t p[2], int32_t reach)
{
    place_range near = *range;

    for (int axis = 0; axis < 2; ++axis) {
        const int32_t at = (int32_t)p[axis];

        near.low[axis] = at - reach > near.low[axis] ? at - reach : near.low[axis];
        near.high[axis] = at + reach < near.high[axis] ? at + reach : near.high[axis];
    }
    return near;
}

/* Multiples of half a pixel have the most ties with one sample, multiples of 1/8 with several. */
static int32_t random_grain(random_source *r)
{
    static const int32_t grain[] = {PIXEL, HALF, HALF, HALF, 64, 32, 32, 16, 1, 1};

    return grain[random_below(r, sizeof grain / sizeof *grain)];
}

/* A place of a sample in the target. */
static void place_on_sample(random_source *r, const batch *b, int64_t p[2])
{
    const uint32_t sample = random_below(r, 4);
    const uint32_t column = random_below(r, b->width);
    const uint32_t row = random_below(r, b->height);

    p[0] = PIXEL * (int64_t)column + exact_sample_place(b->samples, sample, 0);
    p[1] = PIXEL * (int64_t)row + exact_sample_place(b->samples, sample, 1);
}

static bool is_in_range(const place_range *range, const int64_t p[2])
{
    return p[0] >= range->low[0] && p[0] <= range->high[0] && p[1] >= range->low[1] &&
           p[1] <= range->high[1];
}

/* Places `q` opposite `p` as seen from `s`, k times as far, or nearer if it leaves the range.
 * Precondition: `s` is in the range. */
static void place_opposite(const place_range *range, const int64_t p[2], const int64_t s[2],
                           int32_t k, int64_t q[2])
{
    for (; k >= 0; --k) {
        for (int axis = 0; axis < 2; ++axis)
            q[axis] = s[axis] + k * (s[axis] - p[axis]);
        if (is_in_range(range, q))
            return;
    }
}

typedef enum shape {
    SHAPE_ANY,     /* around the target */
    SHAPE_NEAR,    /* up to 9 steps of the grain from corner to corner */
    SHAPE_TINY,    /* less than two pixels */
    SHAPE_SLIVER,  /* the third corner near the line through the others */
    SHAPE_THROUGH, /* an edge goes through a sample, however long it is */
    SHAPE_HUGE,    /* anywhere in the viewport */
    SHAPE_RIGHT,   /* two sides along the axes */
    SHAPE_FLAT,    /* without area */
    SHAPE_OUTSIDE, /* beyond the target, or touching its side */
    SHAPE_COUNT
} shape;

static void shape_sliver(random_source *r, const place_range *range, const place_range *all,
                         int32_t grain, int64_t p[3][2])
{
    const bool is_long = random_chance(r, 30);
    const int32_t part = random_between(r, 0, 256);

    place_corner(r, is_long ? all : range, grain, p[0]);
    place_corner(r, range, grain, p[1]);
    for (int axis = 0; axis < 2; ++axis) {
        const int32_t off = random_between(r, -3, 3);

        p[2][axis] = p[0][axis] + (p[1][axis] - p[0][axis]) * part / 256 + off;
    }
    if (!is_in_range(all, p[2]))
        place_corner(r, range, grain, p[2]);
}

static void shape_outside(random_source *r, const batch *b, const place_range *all, int32_t grain,
                          int64_t p[3][2])
{
    const int axis = random_chance(r, 50);
    const int32_t end = PIXEL * (int32_t)(axis ? b->height : b->width);
    const bool is_above = random_chance(r, 50);
    const int32_t reach = random_chance(r, 50) ? HALF : 0;
    place_range range = *all;

    if (is_above)
        range.low[axis] = end - reach > range.high[axis] ? range.high[axis] : end - reach;
    else
        range.high[axis] = reach < range.low[axis] ? range.low[axis] : reach;
    for (int k = 0; k < 3; ++k)
        place_corner(r, &range, grain, p[k]);
}

static void random_corners(random_source *r, const batch *b, const place_range *all,
                           int64_t p[3][2])
{
    const shape s = (shape)random_below(r, SHAPE_COUNT);
    const int32_t grain = random_grain(r);
    const int32_t margin = PIXEL * random_between(r, 0, 8);
    place_range range = *all, near;
    int64_t through[2];

    for (int axis = 0; axis < 2; ++axis) {
        const int32_t end = PIXEL * (int32_t)(axis ? b->height : b->width);

        range.low[axis] = -margin > all->low[axis] ? -margin : all->low[axis];
        range.high[axis] = end + margin < all->high[axis] ? end + margin : all->high[axis];
    }
    for (int k = 0; k < 3; ++k)
        place_corner(r, s == SHAPE_HUGE ? all : &range, grain, p[k]);
    switch (s) {
    case SHAPE_NEAR:
    case SHAPE_TINY:
        near = range_around(all, p[0], s == SHAPE_NEAR ? 9 * grain : 400);
        place_corner(r, &near, grain, p[1]);
        place_corner(r, &near, grain, p[2]);
        break;
    case SHAPE_SLIVER:
        shape_sliver(r, &range, all, grain, p);
        break;
    case SHAPE_THROUGH:
        place_on_sample(r, b, through);
        if (random_chance(r, 50))
            place_corner(r, all, grain, p[0]);
        place_opposite(all, p[0], through, random_between(r, 1, 5), p[1]);
        break;
    case SHAPE_RIGHT:
        p[1][0] = p[0][0];
        p[2][1] = p[random_below(r, 2)][1];
        break;
    case SHAPE_FLAT:
        if (random_chance(r, 40))
            memcpy(p[2], p[random_below(r, 2)], sizeof p[2]);
        else
            place_opposite(all, p[0], p[1], random_between(r, 0, 3), p[2]);
        break;
    case SHAPE_OUTSIDE:
        shape_outside(r, b, all, grain, p);
        break;
    default:
        break;
    }
}

/* Returns a device coordinate times w as a float. The product must be a float, so that no rounding
 * moves a corner, and inside the view volume, so that nothing is clipped. */
static float clip_coordinate(double device, float w)
{
    const float f = (float)(device * (double)w);

    if ((double)f != device * (double)w || fabs(device) > 1.0) {
        fprintf(stderr, "exact-geometry: a corner is no float, or outside the viewport\n");
        abort();
    }
    return f;
}

/* Sets a vertex that the viewport maps to the place exactly: all factors are powers of two. */
static void place_vertex(const batch *b, const int64_t p[2], float w, float position[4])
{
    const double x = ((double)p[0] / PIXEL - (double)b->viewport.x) / (double)b->viewport.width;
    const double y = ((double)p[1] / PIXEL - (double)b->viewport.y) / (double)b->viewport.height;

    position[0] = clip_coordinate(2.0 * x - 1.0, w);
    position[1] = clip_coordinate(2.0 * y - 1.0, w);
    position[2] = 0.0f;
    position[3] = w;
}

/* Sets a vertex at random floats inside the view volume, and finds its place by the rules of the
 * viewport and of snapping. */
static void random_vertex(random_source *r, const batch *b, const place_range *range,
                          float position[4], int64_t p[2])
{
    const gn_viewport *const v = &b->viewport;
    const float size[2] = {v->width, v->height}, origin[2] = {v->x, v->y};
    const float w = random_octave(r, -3, 3);

    position[2] = 0.0f;
    position[3] = w;
    for (int axis = 0; axis < 2; ++axis) {
        const float low = ((float)range->low[axis] / PIXEL - origin[axis]) / size[axis];
        const float high = ((float)range->high[axis] / PIXEL - origin[axis]) / size[axis];
        const float device = random_float(r, 2.0f * low - 1.0f, 2.0f * high - 1.0f);
        const float scale = 0.5f * size[axis];

        position[axis] = 0.999f * device * w;

        const float window = position[axis] * (1.0f / w) * scale + (scale + origin[axis]);

        p[axis] = exact_snap(window, b->samples > 1);
    }
}

/* Whether the area of unsnapped coordinates is zero in binary32. The colours of such a triangle are
 * NaN (RULES.md, Interpolation) unless they are flat, so its number would not show. */
static bool rounds_to_no_area(const snapped_triangle *t)
{
    float p[3][2];

    for (int k = 0; k < 3; ++k)
        for (int axis = 0; axis < 2; ++axis)
            p[k][axis] = (float)t->corner[k][axis] / PIXEL;
    return (p[0][0] - p[1][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[0][1] - p[1][1]) ==
           0.0f;
}

static void random_triangle(random_source *r, batch *b, const place_range *all, uint32_t i)
{
    snapped_triangle *const t = &b->triangle[i];
    const float w = random_power(r, -3, 3);

    do {
        random_corners(r, b, all, t->corner);
    } while (b->mode == MODE_LAST && exact_winding(t) && rounds_to_no_area(t));
    for (int k = 0; k < 3; ++k) {
        /* With one w, the constant colours of MODE_LAST stay exact. */
        const float own = b->mode == MODE_LAST ? w : random_power(r, -3, 3);

        place_vertex(b, t->corner[k], own, b->position[3 * i + (uint32_t)k]);
    }
}

static void set_color(batch *b, uint32_t i)
{
    for (uint32_t k = 0; k < 3; ++k) {
        float *const color = b->color[3 * i + k];

        memset(color, 0, sizeof b->color[0]);
        if (b->mode == MODE_SUM)
            color[i / 24] = (float)(1u << i % 24);
        else
            color[0] = (float)(i + 1) / 255.0f;
    }
}

/* Makes the target, mostly small, and a viewport around it whose sides are a power of two. */
static void random_target(random_source *r, batch *b, place_range *all)
{
    const uint32_t kind = random_below(r, 100);
    const uint32_t most = kind < 60 ? 32 : kind < 98 ? 100 : 640;
    int32_t size = 1;

    b->width = 1 + random_below(r, most);
    b->height = 1 + random_below(r, most > 100 ? 100 : most);
    b->samples = random_chance(r, 30) ? GN_SAMPLES : 1;
    while ((uint32_t)size < b->width || (uint32_t)size < b->height)
        size *= 2;
    if (random_chance(r, 70)) {
        const int32_t more = random_between(r, 0, 14);

        for (int32_t n = 0; n < more && size < GN_MAX_SIZE; ++n)
            size *= 2;
    }
    b->viewport.enabled = true;
    b->viewport.width = b->viewport.height = (float)size;
    for (int axis = 0; axis < 2; ++axis) {
        const int32_t side = (int32_t)(axis ? b->height : b->width);
        const bool is_centred = random_chance(r, 30) && size >= 2 * side;
        const int32_t origin = is_centred ? -size / 2 : random_between(r, side - size, 0);

        *(axis ? &b->viewport.y : &b->viewport.x) = (float)origin;
        all->low[axis] = PIXEL * origin;
        all->high[axis] = PIXEL * (origin + size);
    }
}

void random_batch(random_source *r, uint32_t most, batch *b)
{
    static const gn_format depths[] = {GN_FORMAT_NONE, GN_FORMAT_D24, GN_FORMAT_D32F};
    place_range all, range;

    memset(b, 0, sizeof *b);
    random_target(r, b, &all);
    b->mode = (batch_mode)random_below(r, MODE_COUNT);
    b->depth = depths[random_below(r, 3)];
    b->cull = random_chance(r, 60) ? GN_CULL_NONE : (gn_cull)random_below(r, 4);
    b->front_face = (gn_front_face)random_below(r, 2);
    b->count = 1 + random_below(r, most < BATCH_TRIANGLES ? most : BATCH_TRIANGLES);

    /* In some batches corners are random floats, in the others they are on the grid. */
    const bool is_float = b->mode != MODE_LAST && random_chance(r, 25);
    const bool is_wide = random_chance(r, 30);

    range = all;
    for (int axis = 0; axis < 2 && !is_wide; ++axis) {
        const int32_t end = PIXEL * (int32_t)(axis ? b->height : b->width);

        range.low[axis] = all.low[axis] > -PIXEL ? all.low[axis] : -PIXEL;
        range.high[axis] = all.high[axis] < end + PIXEL ? all.high[axis] : end + PIXEL;
    }
    for (uint32_t i = 0; i < b->count; ++i) {
        if (is_float)
            for (uint32_t k = 0; k < 3; ++k)
                random_vertex(r, b, &range, b->position[3 * i + k], b->triangle[i].corner[k]);
        else
            random_triangle(r, b, &all, i);
        set_color(b, i);
    }
}
