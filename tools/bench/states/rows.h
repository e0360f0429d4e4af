/* The state matrix: what `make bench-states` draws. A row is a shape, whose state is plain, and the
 * text that makes one thing different. To add a state, add a row to rows.c.
 *
 * Sizes. Most targets have 512x512 pixels, and shapes are so large that a frame of llvmpipe takes 3
 * to 15 ms. A frame of llvmpipe's in which next to nothing is drawn takes 0.002 to 0.008 ms (the
 * rows of STATE_FIXED), so what a frame costs in itself is at most 0.3 % and flatters nobody.
 * Frames that are short whatever they do, such as clears and blits, have larger targets. Textures
 * have 256x256 texels, so that four repeats give S2's two texels a pixel. */
#ifndef STATES_ROWS_H
#define STATES_ROWS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum state_shape {
    SHAPE_NOTHING,   /* clears only */
    SHAPE_SCREENS,   /* S1: `detail` full screens back to front, vertex colours */
    SHAPE_ROLLED,    /* S1 under a rolled camera */
    SHAPE_TEXTURED,  /* S2: screens with a bilinear texture, by the ready-made Gouraud shader */
    SHAPE_SAMPLED,   /* screens with any texture, by a user's shader (reference/scene/sampled.h) */
    SHAPE_SPHERE,    /* S3: `detail` squares along an edge of the sphere's cube, lit per vertex */
    SHAPE_PHONG,     /* S4: the same, textured and lit per pixel by the ready-made shader */
    SHAPE_USER,      /* S4 with a user's shader */
    SHAPE_STRIPS,    /* SHAPE_SPHERE as strips, with a restart between strips */
    SHAPE_ONE_STRIP, /* SHAPE_SPHERE as one strip, with triangles without area between rows */
    SHAPE_FANS,      /* SHAPE_SPHERE as fans of eight triangles, with restarts */
    SHAPE_LINES,     /* the edges of SHAPE_SPHERE, as lines */
    SHAPE_LINE_STRIPS,
    SHAPE_LINE_LOOPS,
    SHAPE_POINTS, /* a grid of `detail` x `detail` points, vertex colours */
    SHAPE_CUBES   /* `detail` cubes of 12 triangles each, a draw for each, vertex colours */
} state_shape;

/* What is timed. Everything but a draw works on a frame that was drawn before. */
typedef enum state_work {
    WORK_DRAW,        /* clears and draws a frame */
    WORK_DRAW_AUTO,   /* the same with GN_BACKEND_AUTO, whatever back end is measured */
    WORK_BLIT,        /* blits the first colour, or depth and stencil, to a surface */
    WORK_BLIT_LINEAR, /* the same with the linear filter */
    WORK_RESOLVE,     /* resolves the samples of the first colour, or of depth and stencil */
    WORK_LEVELS       /* makes the levels of the draw's texture from the first level */
} state_work;

typedef struct state_row {
    const char *group, *name;
    state_shape shape;
    uint32_t side; /* of the target, in pixels */
    uint32_t detail;

    /* Keywords of a scene and of its draws with their values, as in the text of scenes
     * (reference/scene/scene_text.h), and those of shapes.h. */
    const char *text;
    state_work work;
    const char *to; /* keywords of the surface that is blitted or resolved to: its size and format;
                       without keywords there is one of the target's size and colour format */
} state_row;

/* The group of rows that show what a frame costs in which next to nothing is drawn. They count for
 * no mean. */
#define STATE_FIXED "fixed"

static inline bool state_draws(const state_row *row)
{
    return row->work == WORK_DRAW || row->work == WORK_DRAW_AUTO;
}

/* Returns all rows: those of rows.c, then STATE_PAIRS random combinations of two (pairs.c). */
#define STATE_PAIRS 64
const state_row *state_rows(size_t *count);

/* The rows of rows.c. */
extern const state_row state_single_rows[];
extern const size_t state_single_row_count;

#endif
