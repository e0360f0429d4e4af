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

/* The largest tile, in pixels. */
#define TILE 44

/* What this rank has found. */
typedef struct tally {
    uint64_t passed, failed;
    uint64_t merged;  /* scenes drawn in parts of triangles */
    uint64_t tied;    /* pixels at which several ranks had the least depth */
    uint64_t refused; /* scenes that cannot be drawn in parts as they are */
    uint64_t tiled;   /* scenes drawn in tiles */
    /* Pixels of this class, and those that only one of the tiles and the whole picture has. */
    uint64_t drawn, astray;
} tally;

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

static void judge(tally *t, bool equal, const char *what, scene_class class, uint64_t number)
{
    t->passed += equal;
    t->failed += !equal;
    if (!equal)
        printf("FAILED: %s, rank %u: class %s, scene %" PRIu64 "\n", what, (unsigned)ranks_number(),
               scene_class_name(class), number);
}

static bool is_counted(const scene *s)
{
    for (size_t i = 0; i < s->draw_count; ++i)
        if (s->draws[i].counted)
            return true;
    return false;
}

/* Divides the scene by rows or by triangles. Returns whether this rank's rows are those of the
 * whole, and whether by rows the counted samples of all ranks are. */
static bool is_equal(const scene *s, const scene_frame *whole, uint32_t unit, bool by_triangles,
                     tally *t)
{
    const uint32_t number = ranks_number(), count = ranks_count();
    const row_range rows = band_of_rank(s->height, unit, number, count), all = {0, s->height};
    gn_workspace workspace = make_workspace(s);
    scene_frame frame, own;
    scene part;
    uint64_t passed = 0;
    if (!parts_scene(s, by_triangles ? number : 0, by_triangles ? count : 1, &part) ||
        !band_frame_reserve(&frame, s) || !band_frame_reserve(&own, s))
        need(NULL);
    workspace.samples_passed = &passed;
    gn_status status = band_draw(&part, by_triangles ? all : rows, &frame, &workspace);
    if (by_triangles) {
        band_draw(&part, all, &own, &workspace);
        if (merge_bands(s, unit, &frame) != 0)
            need(NULL);
        ++t->merged;
        t->tied += count_ties(s, &own, &frame, rows);
    }
    if (status == GN_OK)
        status = band_resolve(s, rows, &frame);
    bool equal = status == GN_OK && equal_rows(whole, &frame, rows);
    if (!by_triangles && is_counted(s))
        equal = ranks_sum(passed) == whole->samples_passed && equal;
    band_frame_release(&own);
    band_frame_release(&frame);
    parts_scene_free(&part);
    free(workspace.memory);
    return equal;
}

/* Takes out of a scene what merging refuses and can be left out. */
static void make_opaque(scene *s)
{
    for (size_t i = 0; i < s->draw_count; ++i) {
        gn_pipeline *p = &s->draws[i].state;
        p->depth.test_enabled = true;
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
        if (p->raster.viewport.enabled || p->raster.scissor.enabled || !p->depth.test_enabled ||
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
                         tally *t)
{
    const size_t pixels = (size_t)s->width * s->height;
    const float *a = (const float *)whole->depth + (whole->images - 1) * pixels;
    const float *b = tiled->depth;
    for (size_t i = 0; i < pixels; ++i) {
        t->drawn += a[i] != s->clear_depth;
        t->astray += (a[i] != s->clear_depth) != (b[i] != s->clear_depth);
    }
}

static void try_tiles(const scene *s, const scene_frame *whole, tally *t)
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
    count_astray(s, whole, &frame, t);
    band_frame_release(&frame);
    free(workspace.memory);
}

static void try_scene(uint64_t seed, scene_class class, uint64_t number, tally *t)
{
    const uint32_t unit = 2 + 2 * (uint32_t)(number % 3); /* rows */
    scene *s = generate_scene(seed, class, number);
    scene_frame whole;
    draw_whole(s, &whole);
    judge(t, is_equal(s, &whole, unit, false, t), "by rows", class, number);
    if (ranks_number() == 0)
        try_tiles(s, &whole, t);
    if (merge_refusal(s) != NULL) {
        ++t->refused;
        make_opaque(s);
        scene_frame_free(&whole);
        draw_whole(s, &whole);
    }
    if (merge_refusal(s) == NULL)
        judge(t, is_equal(s, &whole, unit, true, t), "by triangles", class, number);
    scene_frame_free(&whole);
    scene_free(s);
}

/* Tiles round coordinates in another way, which moves a pixel at an edge now and then. More than
 * about one in 30 of a class, as of slivers, is a failure. */
static void judge_tiles(tally *t, scene_class class)
{
    if (t->astray * 30 > t->drawn + 300) {
        ++t->failed;
        printf("FAILED: in tiles: class %s: %" PRIu64 " of %" PRIu64 " pixels are astray\n",
               scene_class_name(class), t->astray, t->drawn);
    }
    t->drawn = t->astray = 0;
}

/* Adds up and prints what all ranks have found. Returns the status. Too few scenes in which tiles,
 * or merging, decide anything are a failure. */
static int print(tally *t, uint64_t scenes, bool is_all)
{
    const uint64_t tied = ranks_sum(t->tied), passed = ranks_sum(t->passed);
    if (ranks_number() == 0 && is_all)
        t->failed += t->tiled < scenes / 20;
    if (ranks_count() > 1 && is_all)
        t->failed += tied < scenes || t->refused > scenes - scenes / 8;
    const uint64_t failed = ranks_sum(t->failed);
    if (ranks_number() == 0) {
        printf("%u ranks: %" PRIu64 " scenes by rows, %" PRIu64 " in tiles; %" PRIu64
               " by triangles, with %" PRIu64 " pixels of equal depths; %" PRIu64
               " refused as they are\n",
               (unsigned)ranks_count(), scenes, t->tiled, t->merged, tied, t->refused);
        printf("%" PRIu64 " passed, %" PRIu64 " failed\n", passed, failed);
    }
    return failed > 0;
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
    for (int class = first; class < end; ++class) {
        for (uint64_t number = 0; number < each; ++number)
            try_scene(seed, (scene_class) class, number, &t);
        judge_tiles(&t, (scene_class) class);
    }
    return ranks_end(print(&t, each * (uint64_t)(end - first), argc == 3));
}
