/* Draws runs of squares: in rows of 16 pixels as far as they go, square by square elsewhere. Each
 * common state has a function of its own, and one function draws all other states.
 * block_functions_of chooses the function for a state. */
#ifndef GN_FRAGMENT_RUNS_H
#define GN_FRAGMENT_RUNS_H

#include "block.h"

/* Returns one of the surfaces, which have one size. */
GN_INLINE const gn_surface *surface_of(const fragment_state *state, fragment_kind kind)
{
    return kind.color_format != GN_FORMAT_NONE ? &state->color : &state->depth;
}

/* Shades neighbouring squares. A square that hangs over the surfaces' edge is left to the function
 * for all states, so that the code for all other squares has no calls. */
GN_INLINE void shade_squares(const fragment_state *state, fragment_kind kind,
                             raster_triangle triangle, int32_t x, int32_t y, uint32_t count,
                             uint32_t coverage)
{
    block_places places;
    fragment_place at;

    set_rows_of_block(&places, (float)y);
    set_block(&at, SHAPE_INNER_BLOCK, &places);
    at.y = y;
    for (uint32_t i = 0; i < count; ++i) {
        at.x = x + (int32_t)i * SQUARE_SIZE;
        if (!surface_holds_square(surface_of(state, kind), at.x, y)) {
            shade_whole_squares(state, triangle, at.x, y, 1, coverage);
            continue;
        }
        set_columns_of_block(&places, (float)at.x);
        at.color = square_memory(&state->color, kind.color_format, at.x, y);
        at.depth = square_memory(&state->depth, kind.depth_format, at.x, y);

        const pixel_block block = square_block(at.x, y);
        shade_fragments(state, kind, &at, &block, triangle, coverage);
    }
}

/* Prefetches the depths that a block's fragments are tested against and the colours that they are
 * written over. */
GN_INLINE void prefetch_block(const fragment_state *state, fragment_kind kind,
                              const pixel_block *block)
{
    if (kind.color_format != GN_FORMAT_NONE)
        prefetch_words(block_memory(&state->color, kind.color_format, block),
                       state->color.row_stride);
    if (kind.depth_format != GN_FORMAT_NONE)
        prefetch_words(block_memory(&state->depth, kind.depth_format, block),
                       state->depth.row_stride);
}

/* Shades the halves of a block that hangs over the surfaces' edge. Each half is shaded in its own
 * square, at a multiple of four rows: the rows of another square may belong to another thread. */
GN_INLINE void shade_halves(const fragment_state *state, raster_triangle triangle,
                            const packed_block *b)
{
    for (int half = 0; half < 2; ++half) {
        const int32_t y = b->at.y[half];
        const bool is_upper = y & (SQUARE_SIZE / 2);

        if (b->covered[half])
            shade_whole_squares(state, triangle, b->at.x[half], y & ~(SQUARE_SIZE - 1), 1,
                                b->covered[half] << (is_upper ? HALF_LANES : 0));
    }
}

/* Shades packed blocks; prefetches the next block while one is shaded. */
GN_INLINE void shade_packed(const fragment_state *state, fragment_kind kind,
                            raster_triangle triangle, const packed_block *blocks, uint32_t count)
{
    const gn_surface *const surface = surface_of(state, kind);
    bool is_next_inside = surface_holds_block(surface, &blocks->at);
    block_places places;
    fragment_place at;

    set_block(&at, SHAPE_INNER_BLOCK, &places);
    if (is_next_inside)
        prefetch_block(state, kind, &blocks->at);
    for (uint32_t i = 0; i < count; ++i) {
        const packed_block *const b = &blocks[i];
        const bool inside = is_next_inside;

        is_next_inside = i + 1 < count && surface_holds_block(surface, &b[1].at);
        if (is_next_inside)
            prefetch_block(state, kind, &b[1].at);
        if (!inside) {
            shade_halves(state, triangle, b);
            continue;
        }
        set_places(&places, &b->at);
        at.color = block_memory(&state->color, kind.color_format, &b->at);
        at.depth = block_memory(&state->depth, kind.depth_format, &b->at);
        shade_fragments(state, kind, &at, &b->at, triangle,
                        b->covered[0] | b->covered[1] << HALF_LANES);
    }
}

/* The attributes that the library interpolates for a kind of fragments: from first_attribute up to,
 * but not including, end_attribute. */
GN_INLINE uint32_t first_attribute(fragment_kind kind)
{
    return kind.depth_format != GN_FORMAT_NONE ? DEPTH_PLANE : ONE_OVER_W_PLANE;
}

GN_INLINE uint32_t end_attribute(fragment_kind kind)
{
    if (kind.color_format == GN_FORMAT_NONE)
        return ONE_OVER_W_PLANE;
    return VARYING_PLANES + (kind.source == SOURCE_TEXTURE ? VARYING_END : VARYING_S);
}

/* Shades covered squares in rows of 16 pixels; `count` is a multiple of SQUARES_IN_ROW. */
GN_INLINE void shade_rows(const fragment_state *state, fragment_kind kind, raster_triangle triangle,
                          int32_t x, int32_t y, uint32_t count)
{
    const int32_t end = x + (int32_t)count * SQUARE_SIZE;
    column_terms columns;
    row_terms rows;
    lanes_f w[SQUARE_SIZE];
    fragment_place at;

    for (uint32_t n = first_attribute(kind); n < end_attribute(kind); ++n)
        set_row_terms(&rows, n, triangle_plane(triangle, n), y);
    at.shape = SHAPE_ROW;
    at.places = 0;
    at.columns = &columns;
    if (kind.level) {
        columns.value[ONE_OVER_W_PLANE] =
            columns_from(triangle_plane(triangle, ONE_OVER_W_PLANE), x);
        for (int32_t row = 0; row < SQUARE_SIZE; ++row) {
            at.row = rows.value[row];
            w[row] = w_at(&at, triangle);
        }
    }
    for (at.x = x; at.x < end; at.x += GN_LANES) {
        for (uint32_t n = first_attribute(kind); n < end_attribute(kind); ++n)
            columns.value[n] = columns_from(triangle_plane(triangle, n), at.x);
        at.color = row_memory(&state->color, kind.color_format, at.x, y);
        at.depth = row_memory(&state->depth, kind.depth_format, at.x, y);
        for (int32_t row = 0; row < SQUARE_SIZE; ++row) {
            at.y = y + row;
            at.row = rows.value[row];
            at.w = &w[row];
            shade_fragments(state, kind, &at, 0, triangle, GN_ALL_LANES);
            if (kind.color_format != GN_FORMAT_NONE)
                at.color.half[0] += state->color.row_stride;
            if (kind.depth_format != GN_FORMAT_NONE)
                at.depth.half[0] += state->depth.row_stride;
        }
    }
}

/* The squares across a row of 16 pixels. */
#define SQUARES_IN_ROW (GN_LANES / SQUARE_SIZE)

/* Shades covered squares, in rows as far as whole rows go. */
GN_INLINE void shade_run(const fragment_state *state, fragment_kind kind, raster_triangle triangle,
                         int32_t x, int32_t y, uint32_t count)
{
    const bool in_rows = kind.source != SOURCE_TEXTURE || has_one_filter(state->sampler);
    const uint32_t whole = in_rows ? count - count % SQUARES_IN_ROW : 0;
    const bool usual_test = kind.use == COLOR_REPLACES && (kind.depth_format == GN_FORMAT_NONE ||
                                                           is_usual_depth_test(&state->test));
    const bool level = kind.color_format != GN_FORMAT_NONE &&
                       triangle_plane(triangle, ONE_OVER_W_PLANE).per_x == 0.0f;
    fragment_kind known = kind;

    /* Each branch compiles the rows once more, with constants. Draws that blend take the first two
     * only, since the time of blending would hide what the others save. */
    if (!kind.solid) {
        shade_rows(state, known, triangle, x, y, whole);
    } else if (!usual_test) {
        known.solid = true;
        shade_rows(state, known, triangle, x, y, whole);
    } else if (!level) {
        known.solid = true;
        known.usual_test = true;
        shade_rows(state, known, triangle, x, y, whole);
    } else {
        known.solid = true;
        known.usual_test = true;
        known.level = true;
        shade_rows(state, known, triangle, x, y, whole);
    }
    shade_squares(state, kind, triangle, x + (int32_t)whole * SQUARE_SIZE, y, count - whole,
                  GN_ALL_LANES);
}

/* Draws any state that has no function of its own. */
static void run_any(const void *context, raster_triangle triangle, int32_t x, int32_t y,
                    uint32_t count, uint32_t coverage)
{
    shade_whole_squares((const fragment_state *)context, triangle, x, y, count, coverage);
}

/* run_any for a counted_state: also counts the fragments that pass. */
static void run_counted(const void *context, raster_triangle triangle, int32_t x, int32_t y,
                        uint32_t count, uint32_t coverage)
{
    const counted_state *counted = (const counted_state *)context;

    if (GN_HAVE_STATISTICS)
        counted->counts->covered += count * count_lanes(coverage);
    counted->counts->passed += shade_whole_squares(counted->state, triangle, x, y, count, coverage);
}

/* Defines a run_function for one state, called `name`, and its pack_function, called `packed`. The
 * context is a fragment_state. */
#define GN_SQUARES_FUNCTIONS(name, packed, depth_format, color_format, source, use)                \
    static void name(const void *context, raster_triangle triangle, int32_t x, int32_t y,          \
                     uint32_t count, uint32_t coverage)                                            \
    {                                                                                              \
        const fragment_state *state = (const fragment_state *)context;                             \
        const fragment_kind kind = {depth_format, color_format, source, use, false, false, false}; \
                                                                                                   \
        shade_squares(state, kind, triangle, x, y, count, coverage);                               \
    }                                                                                              \
    static void packed(const void *context, raster_triangle triangle, const packed_block *blocks,  \
                       uint32_t count)                                                             \
    {                                                                                              \
        const fragment_state *state = (const fragment_state *)context;                             \
        const fragment_kind kind = {depth_format, color_format, source, use, false, false, false}; \
                                                                                                   \
        shade_packed(state, kind, triangle, blocks, count);                                        \
    }

/* Defines a run_function for one state, called `name`, which draws in rows where it can. The rows
 * are out of line, in a function called `long_runs`, so that single squares, which are most of what
 * small triangles cover, keep a short prologue. */
#define GN_ROWS_FUNCTION(name, long_runs, depth_format, color_format, source, use)                 \
    GN_OUT_OF_LINE void long_runs(const fragment_state *state, raster_triangle triangle,           \
                                  int32_t x, int32_t y, uint32_t count)                            \
    {                                                                                              \
        const fragment_kind kind = {                                                               \
            depth_format, color_format, source, use, triangle_is_solid(triangle), false, false};   \
                                                                                                   \
        shade_run(state, kind, triangle, x, y, count);                                             \
    }                                                                                              \
    static void name(const void *context, raster_triangle triangle, int32_t x, int32_t y,          \
                     uint32_t count, uint32_t coverage)                                            \
    {                                                                                              \
        const fragment_state *state = (const fragment_state *)context;                             \
        const fragment_kind kind = {                                                               \
            depth_format, color_format, source, use, triangle_is_solid(triangle), false, false};   \
                                                                                                   \
        if (count > 1)                                                                             \
            long_runs(state, triangle, x, y, count);                                               \
        else                                                                                       \
            shade_squares(state, kind, triangle, x, y, 1, coverage);                               \
    }

/* The states that have functions of their own. A line names the functions, then the state: depth
 * format, colour format, source and use. SQUARES are drawn in squares, and packed where triangles
 * are small; ROWS are drawn in rows where they can be. To give a state functions of its own, add
 * its line: the functions and their selection come from it. */
#define GN_SPECIAL_STATES(SQUARES, ROWS)                                                           \
    SQUARES(run_rgba8, run_rgba8_packed, GN_FORMAT_NONE, GN_FORMAT_RGBA8, SOURCE_SHADER,           \
            COLOR_REPLACES)                                                                        \
    SQUARES(run_rgba8_d24, run_rgba8_d24_packed, GN_FORMAT_D24, GN_FORMAT_RGBA8, SOURCE_SHADER,    \
            COLOR_REPLACES)                                                                        \
    SQUARES(run_rgba8_d32f, run_rgba8_d32f_packed, GN_FORMAT_D32F, GN_FORMAT_RGBA8, SOURCE_SHADER, \
            COLOR_REPLACES)                                                                        \
    ROWS(run_color_rgba8, run_color_rgba8_long, GN_FORMAT_NONE, GN_FORMAT_RGBA8, SOURCE_COLOR,     \
         COLOR_REPLACES)                                                                           \
    ROWS(run_color_rgba8_d24, run_color_rgba8_d24_long, GN_FORMAT_D24, GN_FORMAT_RGBA8,            \
         SOURCE_COLOR, COLOR_REPLACES)                                                             \
    ROWS(run_color_rgba8_d32f, run_color_rgba8_d32f_long, GN_FORMAT_D32F, GN_FORMAT_RGBA8,         \
         SOURCE_COLOR, COLOR_REPLACES)                                                             \
    ROWS(run_texture_rgba8, run_texture_rgba8_long, GN_FORMAT_NONE, GN_FORMAT_RGBA8,               \
         SOURCE_TEXTURE, COLOR_REPLACES)                                                           \
    ROWS(run_texture_rgba8_d24, run_texture_rgba8_d24_long, GN_FORMAT_D24, GN_FORMAT_RGBA8,        \
         SOURCE_TEXTURE, COLOR_REPLACES)                                                           \
    ROWS(run_texture_rgba8_d32f, run_texture_rgba8_d32f_long, GN_FORMAT_D32F, GN_FORMAT_RGBA8,     \
         SOURCE_TEXTURE, COLOR_REPLACES)                                                           \
    ROWS(run_depth_d24, run_depth_d24_long, GN_FORMAT_D24, GN_FORMAT_NONE, SOURCE_SHADER,          \
         COLOR_REPLACES)                                                                           \
    ROWS(run_depth_d32f, run_depth_d32f_long, GN_FORMAT_D32F, GN_FORMAT_NONE, SOURCE_SHADER,       \
         COLOR_REPLACES)                                                                           \
    SQUARES(run_over, run_over_packed, GN_FORMAT_NONE, GN_FORMAT_RGBA8, SOURCE_SHADER, COLOR_OVER) \
    SQUARES(run_over_d24, run_over_d24_packed, GN_FORMAT_D24, GN_FORMAT_RGBA8, SOURCE_SHADER,      \
            COLOR_OVER)                                                                            \
    SQUARES(run_over_d32f, run_over_d32f_packed, GN_FORMAT_D32F, GN_FORMAT_RGBA8, SOURCE_SHADER,   \
            COLOR_OVER)                                                                            \
    ROWS(run_over_color, run_over_color_long, GN_FORMAT_NONE, GN_FORMAT_RGBA8, SOURCE_COLOR,       \
         COLOR_OVER)                                                                               \
    ROWS(run_over_color_d24, run_over_color_d24_long, GN_FORMAT_D24, GN_FORMAT_RGBA8,              \
         SOURCE_COLOR, COLOR_OVER)                                                                 \
    ROWS(run_over_color_d32f, run_over_color_d32f_long, GN_FORMAT_D32F, GN_FORMAT_RGBA8,           \
         SOURCE_COLOR, COLOR_OVER)                                                                 \
    ROWS(run_over_texture, run_over_texture_long, GN_FORMAT_NONE, GN_FORMAT_RGBA8, SOURCE_TEXTURE, \
         COLOR_OVER)                                                                               \
    ROWS(run_over_texture_d24, run_over_texture_d24_long, GN_FORMAT_D24, GN_FORMAT_RGBA8,          \
         SOURCE_TEXTURE, COLOR_OVER)                                                               \
    ROWS(run_over_texture_d32f, run_over_texture_d32f_long, GN_FORMAT_D32F, GN_FORMAT_RGBA8,       \
         SOURCE_TEXTURE, COLOR_OVER)

GN_SPECIAL_STATES(GN_SQUARES_FUNCTIONS, GN_ROWS_FUNCTION)

/* Whether the special functions can draw the state: the shader runs after the tests, and the state
 * needs nothing of depth, stencil or colours that the special functions leave out. */
static inline bool is_plain(const fragment_state *state)
{
    const gn_pipeline *p = state->pipeline;

    return !p->program.fragment_discards && !p->program.fragment_writes_depth &&
           !state->moves_depth && !state->clamps_depth && p->program.color_count <= 1 &&
           !format_has_stencil(state->depth.format) && state->combine.use != COLOR_COMBINES;
}

static inline fragment_source source_of(const fragment_state *state)
{
    const gn_pipeline *p = state->pipeline;
    const bool texture = state->texture;
    const uint32_t varyings = texture ? VARYING_END : VARYING_ALPHA + 1;

    if (!state->has_ready_color || p->program.varying_count < varyings)
        return SOURCE_SHADER;
    for (uint32_t n = 0; n < varyings; ++n)
        if (p->program.interpolation[n] != GN_SMOOTH)
            return SOURCE_SHADER;
    return texture ? SOURCE_TEXTURE : SOURCE_COLOR;
}

/* The fragments of a state, as GN_SPECIAL_STATES describes them. */
static inline fragment_kind fragment_kind_of(const fragment_state *state)
{
    const bool has_color = state->color.format != GN_FORMAT_NONE;
    const fragment_kind kind = {
        .depth_format = state->depth.format,
        .color_format = state->color.format,
        .source = has_color ? source_of(state) : SOURCE_SHADER,
        .use = has_color ? state->combine.use : COLOR_REPLACES,
    };

    return kind;
}

static inline bool is_kind(fragment_kind kind, gn_format depth_format, gn_format color_format,
                           fragment_source source, color_use use)
{
    return kind.depth_format == depth_format && kind.color_format == color_format &&
           kind.source == source && kind.use == use;
}

/* Returns the functions that draw the squares and blocks of a state. By comparisons, since a table
 * of functions would need relocation. With `counts` the context is a counted_state. */
static inline block_functions block_functions_of(const fragment_state *state, bool counts)
{
    block_functions f = {counts ? run_counted : run_any, 0};

    if (!GN_SPECIALISED || counts || !is_plain(state))
        return f;

    const fragment_kind kind = fragment_kind_of(state);
#define GN_SELECT_SQUARES(name, pack, depth_format, color_format, source, use)                     \
    if (is_kind(kind, depth_format, color_format, source, use)) {                                  \
        f.squares = name;                                                                          \
        f.packed = pack;                                                                           \
        return f;                                                                                  \
    }
#define GN_SELECT_ROWS(name, long_runs, depth_format, color_format, source, use)                   \
    if (is_kind(kind, depth_format, color_format, source, use)) {                                  \
        f.squares = name;                                                                          \
        return f;                                                                                  \
    }
    GN_SPECIAL_STATES(GN_SELECT_SQUARES, GN_SELECT_ROWS)
#undef GN_SELECT_SQUARES
#undef GN_SELECT_ROWS
    return f;
}

#endif
