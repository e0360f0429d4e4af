/* What the benchmarks draw, as tables of rows. A row is a shape, whose state is plain, and the text
 * that makes it different. Shapes have colour RGBA8, depth D24 with the test LESS, a perspective of
 * 90 degrees, near 0.5, far 200; every frame clears both.
 *
 * A row's text has keywords of scenes (reference/scene/scene_text.h), and these:
 *
 *   shader NAME               the shader of every draw, as in the text of scenes
 *   alpha                     colours with alpha, from 0.25 to 1
 *   noise TARGET FORMAT N D L a texture of N texels a side, D layers or slices and L levels, with
 *                             bytes without a pattern; levels are made from the first
 *   map NAME FORMAT           a map, such as `normal-map rgba8`, of 256x256 texels
 *   plain                     no texture
 *   stretch                   texture coordinates that grow four times as fast along x
 *   sizes                     points' sizes, from 4 to 12, for a shader that writes them
 *   tangents                  tangents for maps of tangents
 *   shadow                    a shadow map seen along the z axis, compared
 *   point-light               a point light
 *   front-to-back             screens in the opposite order
 *   again                     a second draw of the same after the first, with the test EQUAL
 *   shift X Y Z               moves the model before the projection
 *   index FORMAT              indices of that format; none: no indices
 *
 * Sizes of states. Most targets have 512x512 pixels, and shapes are so large that a frame of
 * llvmpipe takes 3 to 15 ms. A frame of llvmpipe's in which next to nothing is drawn takes 0.002 to
 * 0.008 ms (the rows of GROUP_FIXED), so what a frame costs in itself is at most 0.3 % and flatters
 * nobody. Frames that are short whatever they do, such as clears and blits, have larger targets.
 * Textures have 256x256 texels, so that four repeats give S2's two texels a pixel. */
#ifndef BENCH_ROWS_H
#define BENCH_ROWS_H

#include "scene.h"

typedef enum row_shape {
    SHAPE_NOTHING,   /* clears only */
    SHAPE_SCREENS,   /* `detail` full screens back to front, at most 64, the top 1.25 times further
                        than the bottom: w is the same along every row of pixels, which is drawn
                        faster; four colours interpolated */
    SHAPE_ROLLED,    /* the same under a rolled camera: w differs along rows of pixels */
    SHAPE_TEXTURED,  /* screens with a repeating bilinear texture, coordinates 0 to 4, by the
                        ready-made Gouraud shader */
    SHAPE_SAMPLED,   /* the same with any texture, by a user's shader (reference/scene/sampled.h) */
    SHAPE_SPHERE,    /* `detail` squares along an edge of the sphere's cube, lit per vertex, back
                        faces culled */
    SHAPE_PHONG,     /* the same, textured and lit per pixel by the ready-made shader */
    SHAPE_USER,      /* the same with a user's shader (reference/scene/phong.h) */
    SHAPE_STRIPS,    /* SHAPE_SPHERE as strips, with a restart between strips */
    SHAPE_ONE_STRIP, /* SHAPE_SPHERE as one strip, with triangles without area between rows */
    SHAPE_FANS,      /* SHAPE_SPHERE as fans of eight triangles, with restarts */
    SHAPE_LINES,     /* the edges of SHAPE_SPHERE, as lines */
    SHAPE_LINE_STRIPS,
    SHAPE_LINE_LOOPS,
    SHAPE_POINTS, /* a grid of `detail` x `detail` points, vertex colours */
    SHAPE_CUBES   /* `detail` cubes of 12 triangles each, a draw for each, vertex colours */
} row_shape;

/* What is timed. Everything but a draw works on a frame that was drawn before. */
typedef enum row_work {
    WORK_DRAW,        /* clears and draws a frame */
    WORK_DRAW_AUTO,   /* the same with GN_BACKEND_AUTO, whatever back end is measured */
    WORK_BLIT,        /* blits the first colour, or depth and stencil, to a surface */
    WORK_BLIT_LINEAR, /* the same with the linear filter */
    WORK_RESOLVE,     /* resolves the samples of the first colour, or of depth and stencil */
    WORK_LEVELS       /* makes the levels of the draw's texture from the first level */
} row_work;

typedef struct bench_row {
    const char *group, *name;
    row_shape shape;
    uint32_t side; /* of the target, in pixels */
    uint32_t detail;
    const char *text;
    row_work work;
    const char *to; /* keywords of the surface that is blitted or resolved to: its size and format;
                       without keywords there is one of the target's size and colour format */
    float across;   /* width of a sphere's outline, as a part of the side; 0: 0.8 */
} bench_row;

typedef enum row_table {
    TABLE_SCENES, /* of `make bench` */
    TABLE_SCALE,  /* of `make bench-scale`, one thing varied: "triangles/N" are spheres of N
                     triangles, "fill/N" four screens and "sphere/N" a sphere, N pixels a side */
    TABLE_STATES  /* of `make bench-states`: those of states.c, then random pairs of them */
} row_table;

/* Returns all rows of a table. */
const bench_row *rows_of(row_table table, size_t *count);

/* Whether a table has a row of that name. */
bool rows_have(row_table table, const char *name);

/* The group of rows that show what a frame costs in which next to nothing is drawn. They count for
 * no mean. */
#define GROUP_FIXED "fixed"

static inline bool row_draws(const bench_row *row)
{
    return row->work == WORK_DRAW || row->work == WORK_DRAW_AUTO;
}

/* Returns the scene of a row, which the caller frees with scene_free; null with the reason in error
 * if the row's text is wrong. */
scene *row_scene(const bench_row *row, char *error, size_t error_size);

/* Returns a scene without draws whose frame holds the result of a row, which was drawn as scene s:
 * the surface that is blitted or resolved to; for levels a frame of their format that is large
 * enough for all levels but the first, packed, and otherwise zero. Returns as row_scene does. Must
 * not be called for a row that draws, whose result is the frame of s. */
scene *row_destination(const bench_row *row, const scene *s, char *error, size_t error_size);

/* For the files of this folder. */

/* The rows of states.c. */
extern const bench_row single_states[];
extern const size_t single_state_count;

/* Returns those and their pairs (pairs.c). */
const bench_row *state_rows(size_t *count);

/* Replaces a sphere's triangles by the primitives of a shape. */
void row_set_primitives(scene_draw *d, row_shape shape, uint32_t squares);

/* Spreads the bits of a number over all others (the finalizer of MurmurHash3). */
static inline uint32_t row_spread(uint32_t h)
{
    h = (h ^ h >> 16) * UINT32_C(0x85ebca6b);
    h = (h ^ h >> 13) * UINT32_C(0xc2b2ae35);
    return h ^ h >> 16;
}

#endif
