/* Coverage, depth and colour by the library and by the reference against oracle B. */
#include "exact.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "classes.h"
#include "errors.h"
#include "scene_memory.h"

/* The target, and its tiles: one triangle each, in a viewport inside the tile. */
enum { SIDE = 512, TILE = 64, TILES = SIDE / TILE };

/* The clear colour, which no triangle has. */
#define CLEAR (-1.0e30f)

/* Steps of a depth of 24 bits, and of a colour of 8 bits, between 0 and 1. */
#define DEPTH_STEPS 16777215.0
#define COLOR_STEPS 255.0

/* The part of an error that is laid to the rounding of the result, not to a wrong place: one step
 * of D24, or a unit in the last place of a colour near 1. */
#define ROUNDING 0x1p-23

/* Whose picture. */
enum { LIBRARY, REFERENCE, PICTURES };

/* What errors are of. */
typedef enum quantity { DEPTH_24, DEPTH_FLOAT, SMOOTH, NOPERSPECTIVE, QUANTITIES } quantity;

typedef struct class_result {
    uint64_t triangles;
    uint64_t pixels;   /* whose centres are inside */
    uint64_t on_edges; /* whose centres are exactly on an edge; these are not compared */
    uint64_t different[PICTURES];
    double distance[PICTURES]; /* the largest of differing centres */
    uint64_t beyond[PICTURES];
    errors of[QUANTITIES][PICTURES];
    errors moved[QUANTITIES][PICTURES]; /* the errors as distances in the window */
} class_result;

/* A triangle of a scene and where it is drawn. */
typedef struct tile {
    clip_vertex vertex[3];
    gn_viewport viewport;
    int32_t x, y, side; /* in pixels */
} tile;

static gn_viewport tile_viewport(random_source *r, const tile *t)
{
    gn_viewport v = {.enabled = true};

    v.width = (float)t->side;
    v.height = (float)t->side;
    v.x = (float)t->x;
    v.y = (float)t->y;
    if (t->side == TILE) {
        v.x += 0.125f * (float)random_below(r, 65);
        v.y += 0.125f * (float)random_below(r, 65);
        v.width = 0.25f * (float)random_between(r, 96, 208);
        v.height = 0.25f * (float)random_between(r, 96, 208);
    }
    return v;
}

static scene *make_scene(random_source *r, triangle_class c, gn_format depth, tile *tiles,
                         uint32_t count)
{
    scene *const s = scene_create(SIDE, SIDE, GN_FORMAT_RGBA32F, depth);

    for (int channel = 0; channel < 4; ++channel)
        s->clear_color[channel] = CLEAR;
    s->clear_depth = 1.0f;
    for (uint32_t i = 0; i < count; ++i) {
        tile *const t = &tiles[i];
        float position[3][4], color[3][4];

        t->side = count > 1 ? TILE : SIDE;
        t->x = (int32_t)(i % TILES) * TILE;
        t->y = (int32_t)(i / TILES) * TILE;
        t->viewport = tile_viewport(r, t);
        random_clip_triangle(r, c, &t->viewport, t->vertex);
        for (int k = 0; k < 3; ++k) {
            memcpy(position[k], t->vertex[k].position, sizeof position[k]);
            memcpy(color[k], t->vertex[k].attribute, sizeof color[k]);
        }
        scene_draw *const d = scene_add_draw(s);

        d->shader = SCENE_VERTEX_COLOR;
        d->state.raster.viewport = t->viewport;
        d->state.depth.test_enabled = true;
        d->state.depth.function = GN_ALWAYS;
        d->state.program.interpolation[2] = GN_NOPERSPECTIVE;
        d->state.program.interpolation[3] = GN_NOPERSPECTIVE;
        scene_set_attribute(d, GN_ATTRIBUTE_POSITION, position[0], 4, 3);
        scene_set_attribute(d, GN_ATTRIBUTE_COLOR, color[0], 4, 3);
    }
    return s;
}

static bool is_drawn(const scene_frame *f, size_t pixel)
{
    const float *const color = (const float *)f->color + 4 * pixel;

    return color[0] != CLEAR || color[1] != CLEAR || color[2] != CLEAR || color[3] != CLEAR;
}

static double drawn_depth(const scene_frame *f, size_t pixel)
{
    return f->depth_format == GN_FORMAT_D24 ? ((const uint32_t *)f->depth)[pixel] / 16777215.0
                                            : (double)((const float *)f->depth)[pixel];
}

/* An error of a value that is exactly `value`, in steps of 1 / `steps`. */
static void add_value(class_result *result, quantity q, int whose, double drawn, double value,
                      double slope, double steps, double rounding)
{
    const double error = fabs(drawn - value);
    const double left = error - rounding;

    add_error(&result->of[q][whose], error * steps);
    add_error(&result->moved[q][whose], left <= 0.0 ? 0.0 : left / slope);
}

/* Adds the errors of a pixel that both cover. */
static void add_errors(class_result *result, const scene_frame *frame, size_t pixel, int whose,
                       const exact_values *exact)
{
    const float *const color = (const float *)frame->color + 4 * pixel;
    const quantity depth = frame->depth_format == GN_FORMAT_D24 ? DEPTH_24 : DEPTH_FLOAT;

    add_value(result, depth, whose, drawn_depth(frame, pixel), exact->value[EXACT_DEPTH],
              exact->slope[EXACT_DEPTH], DEPTH_STEPS, ROUNDING);
    for (int a = 0; a < EXACT_ATTRIBUTES; ++a)
        add_value(result, a < EXACT_ATTRIBUTES / 2 ? SMOOTH : NOPERSPECTIVE, whose,
                  (double)color[a], exact->value[a], exact->slope[a], COLOR_STEPS, ROUNDING);
}

static void compare_pixel(class_result *result, const scene_frame *frames, size_t pixel,
                          double bound, clip_triangle *exact)
{
    const int covered = clip_triangle_covers(exact);
    exact_values values;

    result->pixels += covered > 0;
    result->on_edges += covered == 0;
    if (covered > 0)
        values = clip_triangle_values(exact);
    for (int whose = 0; whose < PICTURES && covered != 0; ++whose) {
        const bool drawn = is_drawn(&frames[whose], pixel);

        if (drawn && covered > 0)
            add_errors(result, &frames[whose], pixel, whose, &values);
        if (drawn == (covered > 0))
            continue;

        const double distance = clip_triangle_distance(exact);

        ++result->different[whose];
        if (!(distance <= result->distance[whose]))
            result->distance[whose] = distance;
        result->beyond[whose] += !(distance <= bound);
    }
}

/* The most that a centre that is covered differently may lie from an exact edge. Beyond 2^17 pixels
 * the rounding of clip coordinates alone moves corners by more than snapping does. */
static double distance_bound(triangle_class c, const clip_triangle *exact)
{
    return LARGEST_DISTANCE + (c == CLASS_VAST ? ldexp(clip_triangle_reach(exact), -23) : 0.0);
}

static void compare_tile(class_result *result, triangle_class c, const scene_frame *frames,
                         const tile *t, clip_triangle *exact)
{
    clip_triangle_set(exact, t->vertex, &t->viewport);

    const double bound = distance_bound(c, exact);

    for (int32_t y = t->y; y < t->y + t->side; ++y) {
        clip_triangle_go(exact, t->x, y);
        for (int32_t x = t->x; x < t->x + t->side; ++x) {
            compare_pixel(result, frames, (size_t)y * SIDE + (size_t)x, bound, exact);
            clip_triangle_step(exact);
        }
    }
    ++result->triangles;
}

/* Counts pixels that are not equal in two frames. Equal bytes are the rule. */
static uint64_t unequal_pixels(const scene *s, const scene_frame *a, const scene_frame *b)
{
    const size_t pixels = (size_t)SIDE * SIDE;
    const bool same =
        memcmp(a->color, b->color, pixels * 16) == 0 && memcmp(a->depth, b->depth, pixels * 4) == 0;

    return same ? 0 : scene_compare(s, a, b).pixels;
}

/* Draws the scene with the reference and with every back end, and counts pixels that are not equal.
 * frames[LIBRARY] is the portable back end's; `other` is scratch. */
static bool draw_all(reference *r, const scene *s, scene_frame frames[PICTURES], scene_frame *other,
                     clip_totals *totals)
{
    char error[512];

    if (!reference_draw(r, s, &frames[REFERENCE], error, sizeof error)) {
        fprintf(stderr, "exact-geometry: the reference: %s\n", error);
        return false;
    }
    for (int n = GN_BACKEND_PORTABLE; n < GN_BACKEND_COUNT; ++n) {
        const bool is_first = n == GN_BACKEND_PORTABLE;
        scene_frame *const frame = is_first ? &frames[LIBRARY] : other;

        if (!gn_backend_available((gn_backend)n))
            continue;

        const gn_status status = scene_draw_library(s, frame, 0, (gn_backend)n);

        if (status != GN_OK) {
            fprintf(stderr, "exact-geometry: gn_draw: %s\n", gn_status_text(status));
            return false;
        }
        totals->unequal_pixels += unequal_pixels(s, frame, &frames[is_first ? REFERENCE : LIBRARY]);
    }
    return true;
}

static void test_scene(reference *r, random_source *random, triangle_class c, gn_format depth,
                       uint32_t count, clip_triangle *exact, class_result *result,
                       clip_totals *totals)
{
    tile tiles[TILES * TILES];
    scene_frame frames[PICTURES], other;
    scene *const s = make_scene(random, c, depth, tiles, count);

    memset(frames, 0, sizeof frames);
    memset(&other, 0, sizeof other);
    totals->broken = !scene_frame_allocate(&frames[LIBRARY], s) ||
                     !scene_frame_allocate(&frames[REFERENCE], s) ||
                     !scene_frame_allocate(&other, s) || !draw_all(r, s, frames, &other, totals);
    for (uint32_t i = 0; i < count && !totals->broken; ++i)
        compare_tile(result, c, frames, &tiles[i], exact);
    scene_frame_free(&frames[LIBRARY]);
    scene_frame_free(&frames[REFERENCE]);
    scene_frame_free(&other);
    scene_free(s);
}

/* Returns how far from the centre 99 % of the values drawn may have been read, in pixels. Smooth
 * colours are a quotient, whose two parts may change much faster than the quotient.
 *
 * There is no bound, HUGE_VAL, for noperspective colours of clipped triangles. The reference finds
 * them at a new vertex by a ratio of differences of window coordinates. For an edge along a side of
 * the viewport, which clipping by two planes makes, this is 0 / 0 or close to it (RULES.md, What
 * the contract leaves out). */
static double bound_of(triangle_class c, quantity q)
{
    const bool is_clipped = c >= CLASS_CLIPPED && c <= CLASS_VAST;

    if (q == NOPERSPECTIVE && is_clipped)
        return HUGE_VAL;
    return (q == SMOOTH ? 0.005 : 0.0005) * (c == CLASS_VAST ? 1000.0 : 1.0);
}

/* Whether Gnomon's values of a class are beyond the bound. Few values are not judged. */
static bool is_beyond(const class_result *r, triangle_class c, quantity q)
{
    const errors *const moved = &r->moved[q][LIBRARY];

    return moved->count >= 300 && error_quantile(moved, 0.01) > bound_of(c, q);
}

static void print_coverage(const class_result *results)
{
    printf("Centres that are covered differently, and the farthest of them from an exact edge, in "
           "pixels:\n\n"
           "| class | triangles | centres inside | on an edge | Gnomon: different | farthest | "
           "OSMesa: different | farthest |\n|---|---|---|---|---|---|---|---|\n");
    for (int c = 0; c < TRIANGLE_CLASSES; ++c) {
        const class_result *const r = &results[c];

        printf("| %s | %" PRIu64 " | %" PRIu64 " | %" PRIu64 " |", class_name((triangle_class)c),
               r->triangles, r->pixels, r->on_edges);
        for (int whose = 0; whose < PICTURES; ++whose)
            printf(" %" PRIu64 " | %.5f |", r->different[whose], r->distance[whose]);
        printf("\n");
    }
}

static void print_errors(const class_result *results, quantity q, const char *title)
{
    printf(
        "\nErrors of %s:\n\n"
        "| class | Gnomon: mean | 99 %% below | largest | not finite | 99 %% moved | OSMesa: mean "
        "| 99 %% below | largest | not finite | 99 %% moved |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|\n",
        title);
    for (int c = 0; c < TRIANGLE_CLASSES; ++c) {
        printf("| %s |", class_name((triangle_class)c));
        for (int whose = 0; whose < PICTURES; ++whose) {
            const errors *const e = &results[c].of[q][whose];

            printf(" %.2g | %.2g | %.2g | %.2g %% | %.2g |", mean_error(e), error_quantile(e, 0.01),
                   e->largest, e->count ? 100.0 * (double)e->not_finite / (double)e->count : 0.0,
                   error_quantile(&results[c].moved[q][whose], 0.01));
        }
        printf("\n");
    }
}

void test_clip_space(reference *r, uint64_t seed, uint64_t triangles, clip_totals *totals)
{
    static const char *const titles[] = {
        "depths in D24, in its steps", "depths in D32F, in steps of D24",
        "smooth colours, in steps of 1/255", "noperspective colours, in steps of 1/255"};
    class_result *const results = scene_allocate(TRIANGLE_CLASSES, sizeof *results);
    clip_triangle *const exact = clip_triangle_create();
    uint64_t scenes = 0;

    memset(totals, 0, sizeof *totals);
    totals->broken = !exact;
    while (totals->triangles < triangles && !totals->broken) {
        const triangle_class c = (triangle_class)(scenes % TRIANGLE_CLASSES);
        const gn_format depth = scenes / TRIANGLE_CLASSES % 2 ? GN_FORMAT_D32F : GN_FORMAT_D24;
        const uint32_t count = c == CLASS_LARGE ? 1 : TILES * TILES;
        random_source random = random_seed(seed + (scenes << 32));

        test_scene(r, &random, c, depth, count, exact, &results[c], totals);
        totals->triangles += count;
        ++scenes;
        show_progress("clip space", totals->triangles, triangles);
    }
    for (int c = 0; c < TRIANGLE_CLASSES; ++c) {
        for (int q = 0; q < QUANTITIES; ++q)
            totals->errors_beyond += is_beyond(&results[c], (triangle_class)c, (quantity)q);
        totals->pixels += results[c].pixels;
        totals->different += results[c].different[LIBRARY];
        totals->beyond += results[c].beyond[LIBRARY];

        double *const largest = c == CLASS_VAST ? &totals->largest_of_vast : &totals->largest;

        if (!(results[c].distance[LIBRARY] <= *largest))
            *largest = results[c].distance[LIBRARY];
    }
    if (!totals->broken) {
        print_coverage(results);
        for (int q = 0; q < QUANTITIES; ++q)
            print_errors(results, (quantity)q, titles[q]);
        printf("\n");
    }
    clip_triangle_free(exact);
    free(results);
}
