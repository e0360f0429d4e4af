/* The fragment stages: from blocks of covered fragments to the surfaces.
 *
 *   runs.h     the functions that coverage calls: one for each common state, one for all others
 *   block.h    a block: tests, interpolation, fragment shader, colour
 *   planes.h   attributes at fragments
 *   depth.h    depth test and depth write
 *   stencil.h  stencil and depth together
 *   color.h    conversion to the common colour formats, and write
 *   combine.h  colours combined with those of the surface
 *   blend.h    blending
 *   logic.h    logical operations
 *   pixels.h   blocks of pixels of the less common formats
 *   samples.h  multisampled targets
 *
 * State is resolved once per draw (state.h), into the run_function (raster/types.h) that coverage
 * calls. */
#ifndef GN_FRAGMENT_TYPES_H
#define GN_FRAGMENT_TYPES_H

#include "../formats/properties.h"
#include "../formats/surface_memory.h"
#include "../lanes/lanes.h"
#include "../raster/types.h"
#include "../shaders/shading.h"

/* How incoming and stored depth are compared; `inverted` negates the result. Stored forms order as
 * integers, so these make all eight functions. */
typedef enum depth_question { DEPTH_ALWAYS, DEPTH_EQUAL, DEPTH_LESS, DEPTH_GREATER } depth_question;

typedef struct depth_state {
    depth_question question;
    bool inverted;
    bool write;
} depth_state;

/* How one group of channels is blended. No member is GN_.._DEFAULT. */
typedef struct blend_rule {
    gn_blend_equation equation;
    gn_blend_factor source, destination;
} blend_rule;

/* Which term the factor w belongs to if a format has one channel and its two factors are w and 1 -
 * w. Such terms are mixed instead of multiplied and added. */
typedef enum mixing { MIXES_NOTHING, MIXES_BY_SOURCE, MIXES_BY_DESTINATION } mixing;

/* How a fragment's colour is written. */
typedef enum color_use {
    COLOR_REPLACES, /* it replaces all channels */
    COLOR_OVER,     /* blended in all channels by its alpha and one minus its alpha */
    COLOR_COMBINES  /* as the other members of color_state say */
} color_use;

typedef struct color_state {
    color_use use;
    uint32_t written;        /* bits of channels: GN_CHANNEL_RED and so on */
    int32_t written_bits[2]; /* masks of the words of a pixel (formats/pixel_memory.h) */
    bool blends, is_logical; /* at most one */
    blend_rule color, alpha;
    mixing mixes; /* for formats of one channel */
    /* For floats: (source + destination) * factor; and terms that are left out, since their factor
     * is zero. */
    bool factors_last, drops_source, drops_destination;
    float constant[4];
    int32_t constant_fixed[4]; /* 0 to 255, or to 65535 */
    int32_t logic[4];          /* all ones or zeros: the result of bits 0 0, 0 1, 1 0 and 1 1 */
} color_state;
/* Colours that a draw writes at most. */
#define COLOR_LIMIT (GN_HAVE_ATTACHMENTS ? GN_MAX_COLORS : 1)

/* An attachment: its surface (GN_FORMAT_NONE if absent) and how colours are written to it. */
typedef struct color_output {
    gn_surface surface;
    color_state combine;
} color_output;

/* A new stencil value: stencil * factor + offset, clamped to low..high. */
typedef struct stencil_update {
    int32_t factor, offset, low, high;
} stencil_update;

typedef struct stencil_state {
    depth_state compare; /* reference compared with stored stencil */
    int32_t reference;   /* in the compared bits */
    int32_t compared, written;
    stencil_update fail, depth_fail, pass;
} stencil_state;

/* Fragments' depths are clamped to these; low <= high. */
typedef struct depth_limits {
    float low, high;
} depth_limits;

typedef struct fragment_state {
    const gn_pipeline *pipeline;
    const shading_functions *shading; /* how the pipeline's fragment shader runs */
    bool is_smooth;                   /* all of its varyings are */
    bool asks_inputs;          /* asks for inputs other than varyings, or writes a sample mask */
    bool has_ready_color;      /* the shader's colour is its first varyings ... */
    const gn_texture *texture; /* ... times this texture, if not null; not with GN_SMALL */
    const gn_sampler *sampler;
    gn_surface color; /* GN_FORMAT_NONE: no colour */
    gn_surface depth; /* GN_FORMAT_NONE: no test */
    depth_state test;
    bool moves_depth; /* polygon offset */
    color_state combine;
    bool tests_depth, tests_stencil;
    stencil_state stencil[2]; /* for front faces, for back faces */
    depth_limits limits;
    bool clamps_depth; /* the limits are not 0 and 1 */

    /* The attachments after the first. Only the first has special functions. */
    color_output more[GN_HAVE_ATTACHMENTS ? GN_MAX_COLORS - 1 : 1];
    uint32_t more_count; /* the last one is not absent */
} fragment_state;

static inline bool has_colors(const fragment_state *state)
{
    return state->color.format != GN_FORMAT_NONE || (GN_HAVE_ATTACHMENTS && state->more_count > 0);
}

/* Fragments, or samples, that are covered, and those of them that pass. */
typedef struct sample_counts {
    uint64_t covered, passed;
} sample_counts;

/* The context of fragments that are counted. Each task has counts of its own. */
typedef struct counted_state {
    const fragment_state *state;
    sample_counts *counts;
} counted_state;

/* The pixel of lane l. Rows save most of the work if nothing depends on neighbouring rows. Shaders
 * receive blocks, for their derivatives. */
typedef enum fragment_shape {
    SHAPE_SQUARE,      /* (x + l % 4, y + l / 4) */
    SHAPE_INNER_BLOCK, /* as a pixel_block says; wholly on the surfaces, whose formats have 32
                          bits */
    SHAPE_ROW          /* (x + l, y); wholly on the surfaces, whose formats have 32 bits */
} fragment_shape;

/* Returns whether all of the square at (x, y) lies on a surface, so that it may be loaded and
 * stored whole. Squares hang over the right and the top edge of odd sizes. */
static inline bool surface_holds_square(const gn_surface *surface, int32_t x, int32_t y)
{
    return (uint32_t)x + SQUARE_SIZE <= surface->width &&
           (uint32_t)y + SQUARE_SIZE <= surface->height;
}

static inline bool surface_holds_block(const gn_surface *surface, const pixel_block *block)
{
    const int32_t x = block->x[0] > block->x[1] ? block->x[0] : block->x[1];
    const int32_t y = block->y[0] > block->y[1] ? block->y[0] : block->y[1];

    return (uint32_t)x + SQUARE_SIZE <= surface->width &&
           (uint32_t)y + SQUARE_SIZE / 2 <= surface->height;
}

/* Returns the memory of a pixel on a surface of the given format; null without one. */
GN_INLINE unsigned char *pixel_memory(const gn_surface *surface, gn_format format, int32_t x,
                                      int32_t y)
{
    return format == GN_FORMAT_NONE
               ? 0
               : surface_row(surface, (uint32_t)y) + x * (int32_t)format_size(format);
}

/* The memory of the first pixel of each half of a block, or of a row; the second is null for a row.
 * Both are null without a surface. */
typedef struct surface_place {
    unsigned char *half[2];
} surface_place;

GN_INLINE surface_place row_memory(const gn_surface *surface, gn_format format, int32_t x,
                                   int32_t y)
{
    const surface_place place = {{pixel_memory(surface, format, x, y), 0}};

    return place;
}

GN_INLINE surface_place square_memory(const gn_surface *surface, gn_format format, int32_t x,
                                      int32_t y)
{
    surface_place place = row_memory(surface, format, x, y);

    if (format != GN_FORMAT_NONE)
        place.half[1] = place.half[0] + SQUARE_SIZE / 2 * surface->row_stride;
    return place;
}

GN_INLINE surface_place block_memory(const gn_surface *surface, gn_format format,
                                     const pixel_block *block)
{
    const surface_place place = {{pixel_memory(surface, format, block->x[0], block->y[0]),
                                  pixel_memory(surface, format, block->x[1], block->y[1])}};

    return place;
}

/* Loads the 32-bit values of the lanes; rows are `stride` bytes apart. */
GN_INLINE lanes_i load_words(fragment_shape shape, const surface_place *at, ptrdiff_t stride)
{
    return shape == SHAPE_ROW ? lanes_i_load((const stored_word *)(const void *)at->half[0])
                              : lanes_i_load_block(at->half[0], at->half[1], stride);
}

GN_INLINE void store_words(fragment_shape shape, const surface_place *at, ptrdiff_t stride,
                           lanes_i a)
{
    if (shape == SHAPE_ROW)
        lanes_i_store((stored_word *)(void *)at->half[0], a);
    else
        lanes_i_store_block(at->half[0], at->half[1], stride, a);
}

/* Prefetches a block's memory, which is loaded after other work. */
GN_INLINE void prefetch_words(surface_place at, ptrdiff_t stride)
{
#if defined(__GNUC__)
    for (int half = 0; half < 2; ++half) {
        __builtin_prefetch(at.half[half], 1);
        __builtin_prefetch(at.half[half] + stride, 1);
    }
#else
    (void)at;
    (void)stride;
#endif
}

#endif
