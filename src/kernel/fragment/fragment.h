/* The fragment stages: from blocks of covered fragments to the surfaces.
 *
 *   steps.inl        the functions that coverage calls: a state's steps over batches and spans
 *   loops.inl        test, colour and store of a block, and the loops over blocks
 *   fused.inl        frequent states, which are instances of these loops
 *   batch.inl        the blocks of a step, and what steps hand to each other
 *   test.inl         the step that tests depth and stencil
 *   source.inl       the step that computes colours
 *   output.inl       the steps that encode, load and store colours
 *   combine.inl      the step that combines colours with stored ones; logical operations
 *   planes.inl       attributes at fragments
 *   depth.inl        depth test and depth write
 *   stencil.inl      stencil test, and the depth test after it
 *   shader.inl       a call of the fragment shader, at centres, centroids or samples
 *   squares_of_rows.inl  rows as the squares that a shader receives
 *   blend.inl        blending
 *   pixels.inl       where the pixels of fragments lie on a surface
 *   samples.inl      multisampled targets
 *
 * State is resolved once per draw (resolve_state.inl). */
#ifndef GN_KERNEL_FRAGMENT_FRAGMENT_H
#define GN_KERNEL_FRAGMENT_FRAGMENT_H

#include "../../formats/properties.h"
#include "../../formats/surface_memory.h"
#include "../../lanes/lanes.h"
#include "../raster/raster.h"
#include "../shaders/shading.h"
#include "../texture/lookup_one_level.inl"

/* How an incoming depth or a stencil reference is compared with what is stored. Both order as
 * integers, so these four and `inverted`, which negates the result, make all eight functions. */
typedef enum compared_relation {
    RELATION_ALWAYS,
    RELATION_EQUAL,
    RELATION_LESS,
    RELATION_GREATER
} compared_relation;

typedef struct comparison {
    compared_relation relation;
    bool inverted;
    bool write; /* depths that pass are written; false for stencil */
} comparison;

/* How red, green and blue, or alpha, are blended. No member is GN_.._DEFAULT. */
typedef struct blend_rule {
    gn_blend_equation equation;
    gn_blend_factor source, destination;
} blend_rule;

/* Which term has the factor w, if a format has one channel and the two factors are w and 1 - w.
 * Such terms are mixed: other + w * (term - other). */
typedef enum mixing { MIXES_NOTHING, MIXES_BY_SOURCE, MIXES_BY_DESTINATION } mixing;

/* How a fragment's colour is written. */
typedef enum color_use {
    COLOR_REPLACES,  /* it replaces all channels */
    COLOR_IS_MASKED, /* it replaces some channels */
    COLOR_BLENDS,    /* blending combines it with what is stored */
    COLOR_IS_LOGICAL /* a logical operation does */
} color_use;

/* The kind of value that the factors of all channels of a pixel are. */
typedef enum factor_kind {
    FACTORS_ARE_CONSTANT,
    FACTORS_ARE_SOURCE,
    FACTORS_ARE_DESTINATION,
    FACTORS_ARE_SOURCE_ALPHA,
    FACTORS_ARE_DESTINATION_ALPHA,
    FACTORS_DIFFER, /* fixed_factors select the values */
    FACTORS_ARE_ZERO,
    FACTORS_ARE_ONE
} factor_kind;

/* Values that factors select; saturate is min(source alpha, 1 - destination alpha). */
enum {
    SELECTS_SOURCE = 1,
    SELECTS_DESTINATION = 2,
    SELECTS_SOURCE_ALPHA = 4,
    SELECTS_DESTINATION_ALPHA = 8,
    SELECTS_SATURATE = 16
};

/* The factors of a pixel's channels, as bytes in a word or shorts in two: the selected values,
 * combined with `constant` by exclusive or, since one minus a value is its complement. Small, since
 * each attachment has two of these for each sample. */
typedef struct fixed_factors {
    uint8_t kind;         /* a factor_kind */
    uint8_t color, alpha; /* bits of SELECTS_: the values of red, green and blue, and of alpha */
    uint32_t constant[2];
} fixed_factors;

typedef struct color_state {
    color_use use;
    uint32_t written;        /* bits of channels: GN_CHANNEL_RED and so on */
    uint32_t read;           /* bits of the source's channels that the result depends on */
    int32_t written_bits[4]; /* masks of the words of a pixel (formats/pixel_layout.h) */
    blend_rule color, alpha;
    mixing mixes; /* for formats of one channel */
    /* For floats: (source + destination) * factor; a term is left out, since its factor is 0. */
    bool factors_last, drops_source, drops_destination;
    float constant[4];
    fixed_factors source_factors, destination_factors;
    int32_t logic[4]; /* masks of the terms 1, destination, source and both (combine.inl) */
} color_state;

/* The most colours that a draw writes. */
#define COLOR_LIMIT (GN_HAVE_ATTACHMENTS ? GN_MAX_COLORS : 1)

/* An attachment: its surface (GN_FORMAT_NONE if absent) and how colours are written to it. */
typedef struct color_output {
    gn_surface surface;
    color_state combine;
} color_output;

/* How a stencil value is updated: `increment` and `decrement` change (stencil & mask) ^ toggled
 * with saturation; then `step` is added modulo 256. All numbers stand at the stencil bits of a
 * pixel's word. */
typedef struct stencil_update {
    bool keeps; /* stencil stays as it is */
    uint32_t mask, toggled, increment, decrement, step;
} stencil_update;

typedef struct stencil_state {
    comparison compare; /* reference compared with stored stencil */
    int32_t reference;  /* in the compared bits */
    int32_t compared;   /* the bits that are compared */
    uint32_t written;   /* the bits that may be written, at the stencil bits of a word */
    stencil_update fail, depth_fail, pass;
} stencil_state;

/* Fragments' depths are clamped to these; low <= high. */
typedef struct depth_limits {
    float low, high;
} depth_limits;

/* What computes a fragment's colour. */
typedef enum fragment_source {
    SOURCE_SHADER, /* the pipeline's fragment shader */
    SOURCE_COLOR,  /* varyings 0 to 3: gni_shade_color, inlined */
    SOURCE_TEXTURE /* varyings 0 to 5: gni_shade_lit_texture, gni_shade_unlit_texture, inlined */
} fragment_source;

typedef struct fragment_state {
    const gn_pipeline *pipeline;
    uint32_t width, height; /* of the surfaces */

    /* Where in a pixel fragments are tested and shaded: on a multisampled target measured from its
     * lower left corner, otherwise (0, 0), which stands for its centre. */
    float test_at[2], shade_at[2];
    bool is_ready_made;       /* the back end runs its own form of the fragment shader */
    bool is_smooth;           /* all varyings are GN_SMOOTH */
    bool reads_centers;       /* the shader reads gl_FragCoord, at the pixels' centres */
    bool has_optional_inputs; /* calls need set_optional_inputs */
    bool is_late;             /* the shader runs before the tests */

    /* All false unless the target is multisampled. */
    bool runs_per_sample; /* the shader runs for each sample */
    bool is_located;     /* a varying is interpolated elsewhere than at centres, and the shader does
                            not run for each sample */
    bool covers_late;    /* the shader's sample mask or alpha removes samples before the tests */
    bool previews_tests; /* centroids depend on the tests even if the shader runs first */

    uint32_t sample;           /* the sample whose state this is */
    fragment_source source;    /* SOURCE_SHADER with GN_SMALL, unless there is one lane */
    const gn_texture *texture; /* with SOURCE_TEXTURE */
    const gn_sampler *sampler;
    uint32_t row_varyings; /* how many varyings batches of rows interpolate: those of an inlined
                              shader, in the order of kernel/shaders/vertex.inl */
    bool replaces_rgba8;   /* ready-made colours replace those of a GN_FORMAT_RGBA8 surface */
    masked_words nearest;  /* of `texture`, if it is not null and there is one lane */
    bool combines;         /* an attachment's colours depend on what it stores */
    gn_surface color;      /* GN_FORMAT_NONE: no colour */
    gn_surface depth;      /* GN_FORMAT_NONE: no test */
    comparison test;
    bool moves_depth; /* polygon offset */
    color_state combine;
    bool tests_depth, tests_stencil;
    stencil_state stencil[2]; /* for front faces, for back faces */
    depth_limits limits;
    bool clamps_depth; /* the limits are not 0 and 1 */

    /* The attachments after the first. Only the first has inlined colours and fused states. */
    color_output more[GN_HAVE_ATTACHMENTS ? GN_MAX_COLORS - 1 : 1];
    uint32_t more_count; /* up to the last one that is not absent */
} fragment_state;

/* Whether there are attachments after the first. */
static inline bool has_more_colors(const fragment_state *state)
{
    return GN_HAVE_ATTACHMENTS && state->more_count > 0;
}

static inline bool has_colors(const fragment_state *state)
{
    return state->color.format != GN_FORMAT_NONE || has_more_colors(state);
}

/* Whether fragments are shaded by calls of a shader. */
static inline bool calls_shader(const fragment_state *state)
{
    return state->source == SOURCE_SHADER &&
           (state->is_late || state->covers_late || has_colors(state));
}

/* How many fragments, or samples of multisampled targets, are covered and how many of them pass. */
typedef struct sample_counts {
    uint64_t covered, passed;
} sample_counts;

/* The context of a list's fragments: the draw's state, with one state for each sample if the target
 * is multisampled; the list's set-up; the task's counts, or null if nobody counts; and where fused
 * states of one lane write colours. */
typedef struct fragment_context {
    const fragment_state *state;
    const primitive_setup *setup;
    sample_counts *counts;
    const gn_surface *color;
} fragment_context;

/* The pixel of lane l. Rows save most of the work if nothing depends on neighbouring rows. Shaders
 * do not receive rows, since their derivatives need quads. */
typedef enum fragment_shape {
    SHAPE_HALVES, /* as a pixel_block says */
    SHAPE_ROW     /* (x + l, y); wholly on the surfaces */
} fragment_shape;

/* Returns whether all of a block lies on a surface, so that it may be loaded and stored whole.
 * Blocks begin at even coordinates, so they may hang over the right and the top edge. */
static inline bool surfaces_hold_block(const fragment_state *state, const pixel_block *block)
{
    const int32_t x = block->x[0] > block->x[1] ? block->x[0] : block->x[1];
    const int32_t y = block->y[0] > block->y[1] ? block->y[0] : block->y[1];

    return (uint32_t)x + SQUARE_SIZE <= state->width &&
           (uint32_t)y + SQUARE_SIZE / 2 <= state->height;
}

#endif
