/* Random parity scenes, drawn whole by every rank and divided among all ranks by the functions that
 * `gnomon render` uses. Every byte of every attachment and sample must be equal.
 *
 * usage: mpirun -n N scenes-over-ranks SEED SCENES [CLASS]      SCENES of each class, or of one */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../command_line.h"
#include "bands.h"
#include "generate.h"
#include "merge.h"
#include "ranks.h"
#include "tiles.h"
#include "triangle_parts.h"

enum { REASON_COUNT = 32 };

/* The largest tile, in pixels. */
#define TILE 44

/* One scene drawn in one way, as this rank has found it. Results are put together at the end, since
 * ranks that share a processor take long for every question that they answer together. */
typedef struct result {
    const char *what;
    scene_class class;
    uint64_t number;
    bool equal, is_merged, has_drawn;
} result;

typedef struct tally {
    result *results;
    size_t count;
    uint64_t tied;  /* pixels at which several ranks had the least depth */
    uint64_t tiled; /* scenes drawn in tiles */
    /* Their pixels by class, and those that only one of the tiles and the whole picture has. */
    uint64_t drawn[CLASS_COUNT], astray[CLASS_COUNT];
    uint64_t refused[REASON_COUNT];
    const char *reason[REASON_COUNT];
} tally;

/* What all ranks have found. */
typedef struct sums {
    uint64_t passed, failed;
    uint64_t merged; /* scenes drawn in parts of triangles */
    uint64_t mixed;  /* of these, scenes in which several ranks have drawn something */
} sums;

static void *need(void *memory)
{
    if (memory == NULL) {
        fputs("scenes-over-ranks: not enough memory\n", stderr);
        ranks_abort(1);
    }
    return memory;
}

static gn_workspace make_workspace(const scene *s)
{
    gn_workspace workspace;
    memset(&workspace, 0, sizeof workspace);
    workspace.size = scene_workspace_size(s);
    workspace.memory = need(malloc(workspace.size));
    return workspace;
}

/* Where rows of an image of an attachment begin; the attachment after the last colour is depth. */
static size_t rows_of(const scene_frame *frame, int attachment, uint32_t image, row_range rows,
                      const uint8_t **bytes)
{
    const bool is_depth = attachment == GN_MAX_COLORS;
    const void *memory = is_depth ? frame->depth : scene_frame_color(frame, attachment);
    const gn_format format = is_depth ? frame->depth_format : scene_frame_format(frame, attachment);
    const size_t row = frame->width * gn_format_size(format);
    const size_t lowest = frame->height - rows.first - rows.count;
    *bytes = memory;
    if (memory == NULL)
        return 0;
    *bytes += ((size_t)image * frame->height + lowest) * row;
    return rows.count * row;
}

/* Whether rows of two frames are equal: all images, or those of the samples. */
static bool equal_rows(const scene_frame *a, const scene_frame *b, row_range rows)
{
    for (int i = 0; i <= GN_MAX_COLORS; ++i) {
        for (uint32_t image = 0; image < a->images; ++image) {
            const uint8_t *x, *y;
            const size_t size = rows_of(a, i, image, rows, &x);
            rows_of(b, i, image, rows, &y);
            if (size > 0 && memcmp(x, y, size) != 0)
                return false;
        }
    }
    return true;
}

/* Counts the pixels of this rank's band at which it had drawn the depth that the merged frame has,
 * but another rank's colour is there. */
static uint64_t count_ties(const scene *s, const scene_frame *own, const scene_frame *merged,
                           row_range rows)
{
    const size_t color = gn_format_size(s->color_format), depth = gn_format_size(s->depth_format);
    const uint8_t *c[2], *d[2];
    uint64_t count = 0;
    if (color == 0 || rows_of(own, 0, 0, rows, &c[0]) == 0)
        return 0;
    rows_of(merged, 0, 0, rows, &c[1]);
    rows_of(own, GN_MAX_COLORS, 0, rows, &d[0]);
    rows_of(merged, GN_MAX_COLORS, 0, rows, &d[1]);
    for (size_t i = 0; i < (size_t)rows.count * s->width; ++i)
        count += memcmp(d[0] + i * depth, d[1] + i * depth, depth) == 0 &&
                 memcmp(c[0] + i * color, c[1] + i * color, color) != 0;
    return count;
}

/* Whether a frame is not as it is when it is cleared. */
static bool has_drawn(const scene *s, const scene_frame *frame)
{
    const row_range all = {0, s->height};
    scene empty = *s;
    scene_frame cleared;
    gn_workspace none;
    memset(&none, 0, sizeof none);
    empty.draw_count = 0;
    if (!band_frame_reserve(&cleared, s) || band_draw(&empty, all, &cleared, &none) != GN_OK)
        need(NULL);
    const bool differs = !equal_rows(&cleared, frame, all);
    band_frame_release(&cleared);
    return differs;
}

/* Adds a result, in whose other members nothing was merged. */
static result *add(tally *t, const char *what, scene_class class, uint64_t number, bool equal)
{
    /* The capacity is a power of two, or 0. */
    if ((t->count & (t->count - 1)) == 0)
        t->results =
            need(realloc(t->results, (t->count > 0 ? 2 * t->count : 1) * sizeof *t->results));
    t->results[t->count] = (result){what, class, number, equal, false, false};
    return t->results + t->count++;
}

/* Draws the scene by rows. Counted samples of all ranks make those of the whole. */
static bool equal_by_rows(const scene *s, const scene_frame *whole, uint32_t unit)
{
    const uint32_t number = ranks_number(), count = ranks_count();
    const row_range rows = band_of_rank(s->height, unit, number, count);
    gn_workspace workspace = make_workspace(s);
    scene_frame frame;
    uint64_t passed = 0;
    if (!band_frame_reserve(&frame, s))
        need(NULL);
    workspace.samples_passed = &passed;
    gn_status status = band_draw(s, rows, &frame, &workspace);
    if (status == GN_OK)
        status = band_resolve(s, rows, &frame);
    const bool equal = status == GN_OK && equal_rows(whole, &frame, rows);
    band_frame_release(&frame);
    free(workspace.memory);
    bool counted = false;
    for (size_t i = 0; i < s->draw_count; ++i)
        counted = counted || s->draws[i].counted;
    const bool same = !counted || ranks_sum(passed) == whole->samples_passed;
    return equal && same;
}

/* Draws the scene by triangles and merges. Returns whether this rank's rows are equal, and sets
 * whether it has drawn anything. */
static bool equal_by_triangles(const scene *s, const scene_frame *whole, uint32_t unit, tally *t,
                               bool *drawn)
{
    const row_range all = {0, s->height};
    const uint32_t number = ranks_number(), count = ranks_count();
    const row_range rows = band_of_rank(s->height, unit, number, count);
    gn_workspace workspace = make_workspace(s);
    scene_frame frame, own;
    scene part;
    if (!parts_scene(s, number, count, &part) || !band_frame_reserve(&frame, s) ||
        !band_frame_reserve(&own, s))
        need(NULL);
    gn_status status = band_draw(&part, all, &frame, &workspace);
    if (status == GN_OK)
        status = band_draw(&part, all, &own, &workspace);
    if (merge_bands(s, unit, &frame) != 0)
        need(NULL);
    *drawn = has_drawn(s, &own);
    t->tied += count_ties(s, &own, &frame, rows);
    if (status == GN_OK)
        status = band_resolve(s, rows, &frame);
    const bool equal = status == GN_OK && equal_rows(whole, &frame, rows);
    band_frame_release(&own);
    band_frame_release(&frame);
    parts_scene_free(&part);
    free(workspace.memory);
    return equal;
}

static void count_refusal(tally *t, const char *why)
{
    int i = 0;
    while (t->reason[i] != NULL && strcmp(t->reason[i], why) != 0)
        ++i;
    t->reason[i] = why;
    ++t->refused[i];
}

/* Takes out of a scene what merging refuses and can be left out. */
static void make_opaque(scene *s)
{
    for (size_t i = 0; i < s->draw_count; ++i) {
        gn_pipeline *p = &s->draws[i].state;
        p->depth.test = true;
        p->depth.write_disabled = false;
        if (p->depth.function != GN_GREATER || s->draws[0].state.depth.function != GN_GREATER)
            p->depth.function = GN_LESS;
        memset(&p->stencil, 0, sizeof p->stencil);
        memset(&p->color, 0, sizeof p->color);
        memset(&s->draws[i].clear, 0, sizeof s->draws[i].clear);
        p->program.fragment_reads_primitive = false;
        /* A draw of a single segment would be one part. */
        if (s->draws[i].mesh.count <= 3 * INDEXED_SEGMENT_TRIANGLES)
            p->raster.cull = GN_CULL_NONE;
    }
}

/* Rows of the units that bands are made of. */
static uint32_t unit_of(uint64_t number)
{
    return 2 + 2 * (uint32_t)(number % 3);
}

static void draw_whole(const scene *s, scene_frame *frame)
{
    if (!scene_frame_allocate(frame, s))
        need(NULL);
    if (scene_draw_library(s, frame, 0, GN_BACKEND_AUTO) != GN_OK) {
        fputs("scenes-over-ranks: a scene cannot be drawn\n", stderr);
        ranks_abort(1);
    }
}

/* Whether tiles can show the scene: nothing in it is bound to pixels of the target, or
 * too wide for tiles of this size. */
static bool fits_tiles(const scene *s)
{
    for (size_t i = 0; i < s->draw_count; ++i) {
        const gn_pipeline *p = &s->draws[i].state;
        if (s->draws[i].shader == SCENE_INPUTS) /* may read the fragment's place */
            return false;
        if (p->raster.viewport.set || p->raster.scissor.set || !p->depth.test ||
            p->depth.write_disabled || p->program.vertex_writes_point_size ||
            p->raster.point_size > TILE / 4 || p->raster.line_width > TILE / 4 ||
            s->draws[i].clear.color || s->draws[i].clear.depth)
            return false;
    }
    return s->color_format != GN_FORMAT_NONE && s->depth_format == GN_FORMAT_D32F;
}

/* Counts the pixels that are drawn in the whole picture, and those that are drawn either there or
 * in tiles only. Values may differ in their last bits. */
static void count_astray(const scene *s, const scene_frame *whole, const scene_frame *tiled,
                         uint64_t *drawn, uint64_t *astray)
{
    const size_t pixels = (size_t)s->width * s->height;
    const float *a = (const float *)whole->depth + (whole->images - 1) * pixels;
    const float *b = tiled->depth;
    for (size_t i = 0; i < pixels; ++i) {
        *drawn += a[i] != s->clear_depth;
        *astray += (a[i] != s->clear_depth) != (b[i] != s->clear_depth);
    }
}

static void try_tiles(const scene *s, const scene_frame *whole, scene_class class, tally *t)
{
    scene kept = *s;
    scene_frame frame;
    bool memory;
    kept.samples = 1;
    if (!fits_tiles(s))
        return;
    const tiling tiles = tiles_divide(s, 2, TILE);
    gn_workspace workspace = make_workspace(s);
    if (!band_frame_reserve(&frame, &kept))
        need(NULL);
    for (uint32_t i = 0; tiles_strip(s, &tiles, i).count > 0; ++i)
        if (tiles_draw(s, &tiles, tiles_strip(s, &tiles, i), &frame, &workspace, &memory) != GN_OK)
            need(NULL);
    ++t->tiled;
    count_astray(s, whole, &frame, t->drawn + class, t->astray + class);
    band_frame_release(&frame);
    free(workspace.memory);
}

static void try_triangles(const scene *s, const scene_frame *whole, const char *what,
                          scene_class class, uint64_t number, tally *t)
{
    bool drawn;
    const bool equal = equal_by_triangles(s, whole, unit_of(number), t, &drawn);
    result *const added = add(t, what, class, number, equal);
    added->is_merged = true;
    added->has_drawn = drawn;
}

static void try_scene(uint64_t seed, scene_class class, uint64_t number, tally *t)
{
    scene *s = generate_scene(seed, class, number);
    scene_frame whole;
    draw_whole(s, &whole);
    add(t, "by rows", class, number, equal_by_rows(s, &whole, unit_of(number)));
    if (ranks_number() == 0)
        try_tiles(s, &whole, class, t);
    const char *why = merge_refusal(s);
    if (why == NULL)
        try_triangles(s, &whole, "by triangles", class, number, t);
    else
        count_refusal(t, why);
    scene_frame_free(&whole);
    make_opaque(s);
    if (why != NULL && merge_refusal(s) == NULL) {
        draw_whole(s, &whole);
        try_triangles(s, &whole, "by triangles, made opaque", class, number, t);
        scene_frame_free(&whole);
    }
    scene_free(s);
}

/* The least of all ranks' numbers, for each result. `number_of` gives this rank's. */
static float *least_of_all(const tally *t, float (*number_of)(const result *r))
{
    float *const values = need(calloc(t->count + 1, sizeof *values));
    for (size_t i = 0; i < t->count; ++i)
        values[i] = number_of(t->results + i);
    ranks_least(values, t->count);
    return values;
}

static float equality(const result *r)
{
    return r->equal ? 1.0f : 0.0f;
}

/* The first and the last rank that has drawn, the second one negated. */
static float first_drawing(const result *r)
{
    return (float)(r->has_drawn ? ranks_number() : ranks_count());
}

static float last_drawing(const result *r)
{
    return r->has_drawn ? -(float)ranks_number() : 0.0f;
}

static sums add_up(tally *t)
{
    sums all = {0, 0, 0, 0};
    float *equal = least_of_all(t, equality);
    float *first = least_of_all(t, first_drawing), *last = least_of_all(t, last_drawing);
    for (size_t i = 0; i < t->count; ++i) {
        const result *r = t->results + i;
        all.passed += equal[i] > 0.5f;
        all.failed += equal[i] < 0.5f;
        all.merged += r->is_merged;
        all.mixed += r->is_merged && first[i] < -last[i];
        if (equal[i] < 0.5f && ranks_number() == 0)
            printf("FAILED: %s: class %s, scene %" PRIu64 "\n", r->what, scene_class_name(r->class),
                   r->number);
    }
    free(equal);
    free(first);
    free(last);
    t->tied = ranks_sum(t->tied);
    return all;
}

/* Tiles round coordinates in another way, which moves a pixel at an edge now and then. Returns the
 * number of classes in which more than about one in 30 is astray, as of slivers. */
static uint64_t faults_of_tiles(const tally *t)
{
    uint64_t faults = 0, drawn = 0, astray = 0;
    for (int c = 0; c < CLASS_COUNT; ++c) {
        drawn += t->drawn[c];
        astray += t->astray[c];
        if (t->astray[c] * 30 <= t->drawn[c] + 300)
            continue;
        ++faults;
        printf("FAILED: in tiles: class %s: %" PRIu64 " of %" PRIu64 " pixels are astray\n",
               scene_class_name((scene_class)c), t->astray[c], t->drawn[c]);
    }
    printf("%" PRIu64 " scenes in tiles: %" PRIu64 " of %" PRIu64 " pixels are astray\n", t->tiled,
           astray, drawn);
    return faults;
}

/* Prints what was found. Returns the status. Too few scenes in which merging decides anything are a
 * failure. */
static int print(tally *t, uint64_t scenes, bool is_all)
{
    sums all = add_up(t);
    uint64_t refused = 0;
    for (int i = 0; t->reason[i] != NULL; ++i)
        refused += t->refused[i];
    if (ranks_count() > 1 && is_all) {
        all.failed += all.mixed < scenes / 4;
        all.failed += t->tied < scenes;
        all.failed += refused > scenes - scenes / 8;
    }
    if (ranks_number() == 0) {
        all.failed += faults_of_tiles(t) + (is_all && t->tiled < scenes / 20);
        printf("%u ranks: %" PRIu64 " scenes by rows; %" PRIu64 " by triangles, in %" PRIu64
               " of which several ranks have drawn, with %" PRIu64
               " pixels of equal depths; %" PRIu64 " refused as they are\n",
               (unsigned)ranks_count(), scenes, all.merged, all.mixed, t->tied, refused);
        for (int i = 0; t->reason[i] != NULL; ++i)
            printf("  refused: %6" PRIu64 " %s\n", t->refused[i], t->reason[i]);
        printf("%" PRIu64 " passed, %" PRIu64 " failed\n", all.passed, all.failed);
    }
    return ranks_largest(all.failed) > 0;
}

int main(int argc, char **argv)
{
    static tally t;
    int status = ranks_begin(&argc, &argv);
    if (status != 0)
        return status;
    if (argc < 3 || (argc > 3 && scene_class_of(argv[3]) == CLASS_COUNT)) {
        if (ranks_number() == 0)
            fputs("usage: mpirun -n N scenes-over-ranks SEED SCENES [CLASS]\n", stderr);
        return ranks_end(2);
    }
    uint64_t seed, each;
    if (!option_number("scenes-over-ranks", "SEED", argv[1], 0, UINT64_MAX, &seed) ||
        !option_number("scenes-over-ranks", "SCENES", argv[2], 1, UINT64_MAX, &each))
        return ranks_end(2);
    const int first = argc > 3 ? (int)scene_class_of(argv[3]) : 0;
    const int end = argc > 3 ? first + 1 : CLASS_COUNT;
    for (int class = first; class < end; ++class)
        for (uint64_t number = 0; number < each; ++number)
            try_scene(seed, (scene_class) class, number, &t);
    status = print(&t, each * (uint64_t)(end - first), argc == 3);
    free(t.results);
    return ranks_end(status);
}
