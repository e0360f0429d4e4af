/* The functions that coverage calls. A state is drawn in steps (batch.inl); frequent states have
 * all steps in one loop (fused.inl). */
#ifndef GN_KERNEL_FRAGMENT_STEPS_INL
#define GN_KERNEL_FRAGMENT_STEPS_INL

#include "fused.inl"
#include "source.inl"

/* Returns how many fragments of a batch are covered. */
GN_OUT_OF_LINE uint32_t count_batch(const fragment_batch *b)
{
    uint32_t count = 0;

    for (uint32_t n = 0; n < b->count; ++n)
        count += count_lanes(b->coverage[n]);
    return count;
}

/* Removes blocks of which nothing passed. If a shader is called for rows, which it receives as
 * squares, either all rows stay or none. `blocks` are those of halves. */
static inline void compact_batch(const fragment_state *state, covered_block *blocks,
                                 fragment_batch *b)
{
    const bool are_rows = is_of_rows(b);
    uint32_t kept = 0;

    for (uint32_t n = 0; are_rows && n < b->count; ++n)
        kept += b->coverage[n] != 0;
    if (are_rows && (kept == b->count || (kept > 0 && calls_shader(state))))
        return;
    kept = 0;
    for (uint32_t n = 0; n < b->count; ++n) {
        if (are_rows) {
            b->column[kept] = b->column[n];
            b->row[kept] = b->row[n];
        } else {
            blocks[kept] = blocks[n];
        }
        b->coverage[kept] = b->coverage[n];
        kept += b->coverage[n] != 0;
    }
    b->count = kept;
}

static inline const gn_surface *surface_of(const fragment_state *state, uint32_t a)
{
    return a > 0 ? &state->more[a - 1].surface : &state->color;
}

static inline const color_state *combine_of(const fragment_state *state, uint32_t a)
{
    return a > 0 ? &state->more[a - 1].combine : &state->combine;
}

/* Whether write_squares writes the shader's colours of a batch to attachment `a`. */
static inline bool writes_squares(const fragment_state *state, uint32_t a, const fragment_batch *b)
{
    return is_of_rows(b) && state->source == SOURCE_SHADER &&
           surface_of(state, a)->format == GN_FORMAT_RGBA8 &&
           combine_of(state, a)->use == COLOR_REPLACES;
}

/* Encodes the shader's colours for attachment `a` of `count`; inlined colours are encoded already.
 * Returns false if the attachment is absent. */
static inline bool encode_color(const fragment_state *state, uint32_t a, uint32_t count,
                                fragment_batch *b)
{
    const gn_format format = surface_of(state, a)->format;
    const uint32_t read = GN_HAVE_COMBINING ? combine_of(state, a)->read : GN_CHANNEL_ALL;

    if (format == GN_FORMAT_NONE)
        return false;
    if (read == 0 || (GN_STATES_SPECIALISED && state->source != SOURCE_SHADER))
        return true;
    encode_batch(format, read, a, count, b);
    return true;
}

/* Writes a batch's colours to all attachments. */
static inline void output_colors(const fragment_state *state, fragment_batch *b)
{
    const uint32_t count = shader_colors(state);

    for (uint32_t a = 0; a < count; ++a)
        if (writes_squares(state, a, b))
            write_squares(surface_of(state, a), a, count, b);
        else if (encode_color(state, a, count, b))
            output_batch(state, combine_of(state, a), surface_of(state, a), b);
}

/* Takes a batch through the steps. `blocks` are those of a batch of halves; null for rows. */
GN_OUT_OF_LINE void take_steps(const fragment_context *c, covered_block *blocks, fragment_batch *b)
{
    const fragment_state *const state = c->state;

    if (GN_HAVE_STATISTICS && c->counts)
        c->counts->covered += count_batch(b);
    if (state->is_late)
        source_batch(state, b);
    if (state->depth.format != GN_FORMAT_NONE)
        test_batch(state, &state->test, b);
    if (c->counts)
        c->counts->passed += count_batch(b);
    if (!state->is_late) {
        compact_batch(state, blocks, b);
        if (b->count == 0 || !has_colors(state))
            return;
        if (GN_STATES_SPECIALISED && state->replaces_rgba8) {
            write_source_batch(state, b);
            return;
        }
        source_batch(state, b);
    }
    if (has_colors(state))
        output_colors(state, b);
}

/* Returns the most blocks that a batch has room for, with all of their colours. */
static inline uint32_t most_together(const fragment_state *state)
{
    const uint32_t most = STEP_COLORS / shader_colors(state);

    return most < STEP_BLOCKS ? most : STEP_BLOCKS;
}

/* Returns how many of `count` blocks may take the steps together. If colours depend on stored ones,
 * blocks of different triangles may not: a pixel of both must be stored before it is loaded. */
static inline uint32_t blocks_together(const fragment_state *state, const covered_block *blocks,
                                       uint32_t count)
{
    const uint32_t most = most_together(state);
    uint32_t together = 1;

    while (together < count && together < most &&
           (!state->combines || blocks[together].lane == blocks->lane))
        ++together;
    return together;
}

/* Shades the first blocks, as many of `count` as may take the steps together, and returns their
 * number. `b` is memory for a batch. */
static inline uint32_t step_together(const fragment_context *c, covered_block *blocks,
                                     uint32_t count, fragment_batch *b)
{
    const uint32_t together = blocks_together(c->state, blocks, count);

    b->shape = SHAPE_HALVES;
    b->count = together;
    b->blocks = blocks;
    b->primitive = primitive_in(c->setup, 0);
    for (uint32_t n = 0; n < together; ++n)
        b->coverage[n] = covered_lanes(&blocks[n]);
    take_steps(c, blocks, b);
    return together;
}

/* Shades blocks of any state: a blocks_function. */
static void step_blocks(const void *context, covered_block *blocks, uint32_t count)
{
    const fragment_context *const c = (const fragment_context *)context;
    fragment_batch b;

    for (uint32_t done = 0; done < count;)
        done += step_together(c, blocks + done, count - done, &b);
}

/* Shades the squares of a span that fill no row of 16 pixels. */
static inline void shade_rest(const void *context, blocks_function *shade, uint32_t lane, int32_t x,
                              int32_t y, uint32_t count)
{
    covered_block block[SQUARES_IN_ROW];

    for (uint32_t i = 0; i < count; ++i) {
        block[i].lane = lane;
        block[i].at = square_block(x + (int32_t)i * SQUARE_SIZE, y);
        block[i].covered[0] = HALF_COVERED;
        block[i].covered[1] = HALF_COVERED;
    }
    if (count)
        shade(context, block, count);
}

/* Sets the terms of a batch of rows for the attributes from `first` up to, but not including,
 * `end`. `inside` says where in their pixels the attributes are needed. */
static inline void set_terms(fragment_batch *b, uint32_t first, uint32_t end, const float inside[2])
{
    for (uint32_t n = first; n < end; ++n)
        set_row_terms(&b->shared.terms.rows, &b->shared.terms.columns[0], n, b->primitive, b->y,
                      inside[1]);
    for (uint32_t c = 0; c < b->columns; ++c) {
        const lanes_f places = column_places(b->x + (int32_t)(c * LANES), inside[0]);

        for (uint32_t n = first; n < end; ++n)
            set_column_terms(&b->shared.terms.columns[c], n, b->primitive, places);
    }
}

/* Computes w once for each row, if it is the same in every column, as without perspective. */
static inline void set_w_per_row(fragment_batch *b, const float inside[2])
{
    const attribute_plane plane = primitive_plane(b->primitive, ONE_OVER_W_PLANE);
    const float column = plane.per_x * ((float)b->x + inside[0]) + plane.origin;

    b->w_per_row = plane.per_x == 0.0f;
    for (uint32_t row = 0; b->w_per_row && row < SQUARE_SIZE; ++row)
        b->shared.terms.w[row] =
            1.0f / (b->shared.terms.rows.value[row][ONE_OVER_W_PLANE] + column);
}

/* Lists all rows of a batch's columns. */
static inline void name_rows(fragment_batch *b)
{
    b->count = 0;
    for (uint32_t row = 0; row < SQUARE_SIZE; ++row) {
        for (uint32_t c = 0; c < b->columns; ++c) {
            b->column[b->count] = (uint8_t)c;
            b->row[b->count] = (uint8_t)row;
            ++b->count;
        }
    }
}

/* Makes a batch of the rows of `columns` columns from (x, y) on, all of them covered. The batch has
 * been one of rows before, or its count and columns are 0. */
static inline void set_rows(const fragment_state *state, fragment_batch *b, int32_t x, int32_t y,
                            uint32_t columns)
{
    b->x = x;
    b->y = y;
    if (b->columns != columns || b->count != columns * SQUARE_SIZE) {
        b->columns = columns;
        name_rows(b);
    }
    if (state->depth.format != GN_FORMAT_NONE)
        set_terms(b, DEPTH_PLANE, ONE_OVER_W_PLANE, state->test_at);
    if (state->row_varyings > 0) {
        set_terms(b, ONE_OVER_W_PLANE, VARYING_PLANES + state->row_varyings, state->shade_at);
        set_w_per_row(b, state->shade_at);
    }
    for (uint32_t n = 0; n < b->count; ++n)
        b->coverage[n] = GN_ALL_LANES;
}

/* Returns the most columns that a batch of rows has room for, with all of their colours. */
static inline uint32_t most_columns(const fragment_state *state)
{
    const uint32_t most = STEP_COLORS / (SQUARES_IN_ROW * shader_colors(state));

    return !calls_shader(state) || most > STEP_COLUMNS ? STEP_COLUMNS : most;
}

/* Shades the columns of a span that are 16 pixels wide. Out of line, so that the batch's memory is
 * free when the rest of the span is shaded. */
GN_OUT_OF_LINE void step_columns(const fragment_context *c, uint32_t lane, int32_t x, int32_t y,
                                 uint32_t columns)
{
    const uint32_t most = most_columns(c->state);
    fragment_batch b;

    b.shape = SHAPE_ROW;
    b.blocks = 0;
    b.count = b.columns = 0;
    b.primitive = primitive_in(c->setup, lane);
    for (uint32_t together; columns > 0; columns -= together) {
        together = columns < most ? columns : most;
        set_rows(c->state, &b, x, y, together);
        take_steps(c, 0, &b);
        x += (int32_t)(together * LANES);
    }
}

/* Shades a span in rows of 16 pixels as far as they go: a span_function. */
static void step_rows(const void *context, uint32_t lane, int32_t x, int32_t y, uint32_t count)
{
    const uint32_t columns = count / SQUARES_IN_ROW;

    step_columns((const fragment_context *)context, lane, x, y, columns);
    shade_rest(context, step_blocks, lane, x + (int32_t)(columns * LANES), y,
               count % SQUARES_IN_ROW);
}

/* Defines the functions of a fused state. Spans have a function of their own, so that the one for
 * blocks, which are most of what small triangles cover, keeps a short prologue. With SOURCE_SHADER
 * only one lane has spans. */
#define GN_FUSED_FUNCTIONS(blocks_name, span_name, depth_format, source, output)                   \
    GN_OUT_OF_LINE void blocks_name(const void *context, covered_block *blocks, uint32_t count)    \
    {                                                                                              \
        const fragment_constants k = {depth_format, source, output, true,                          \
                                      false,        false,  false,  false};                        \
                                                                                                   \
        shade_blocks(context, k, blocks, count, step_blocks);                                      \
    }                                                                                              \
    GN_OUT_OF_LINE void span_name(const void *context, uint32_t lane, int32_t x, int32_t y,        \
                                  uint32_t count)                                                  \
    {                                                                                              \
        const fragment_constants k = {depth_format, source, output, true,                          \
                                      false,        false,  false,  false};                        \
        const fragment_context *const c = (const fragment_context *)context;                       \
        const raster_primitive primitive = primitive_in(c->setup, lane);                           \
        const uint32_t rest = count % SQUARES_IN_ROW;                                              \
                                                                                                   \
        shade_span(c->state, c->color, k, primitive, x, y, count - rest);                          \
        if (SQUARES_IN_ROW > 1)                                                                    \
            shade_rest(context, blocks_name, lane, x + (int32_t)(count - rest) * SQUARE_SIZE, y,   \
                       rest);                                                                      \
    }

GN_FUSED_STATES(GN_FUSED_FUNCTIONS)

#if LANES == 1
/* Draws a span to a surface of a constant layout with format_is_565, by a function that draws to
 * words of GN_FORMAT_RGBA8. The pixels are widened to words, and narrowed again: those that fail
 * the test keep their bits. */
GN_INLINE void pack_span(pixel_layout layout, span_function *draw, const fragment_context *c,
                         uint32_t lane, int32_t x, int32_t y, uint32_t count)
{
    const format_fields fields = format_fields_of(GN_FORMAT_RGB565);
    enum { MOST = 32 };
    int32_t words[MOST], word[4];
    gn_surface row = *c->color;
    fragment_context to_row = *c;

    row.row_stride = 0;
    to_row.color = &row;
    while (count > 0) {
        const uint32_t n = count < MOST ? count : MOST;
        unsigned char *const pixels = pixel_memory(c->color, layout, x, y);

        row.pixels = address_of(words, (uint32_t)x, -4); /* column x is the first word */
        for (uint32_t i = 0; i < n; ++i) {
            load_pixel(pixels, (int32_t)i, layout, word);
            lanes_i_store(&words[i], bytes_of_fields(fields, lanes_i_load(word)));
        }
        draw(&to_row, lane, x, y, n);
        for (uint32_t i = 0; i < n; ++i) {
            lanes_i_store(word, fields_of_bytes(fields, lanes_i_load(&words[i])));
            store_pixel(pixels, (int32_t)i, layout, word);
        }
        x += (int32_t)n;
        count -= n;
    }
}

/* Does the same for either layout. */
GN_OUT_OF_LINE void draw_565(span_function *draw, const void *context, uint32_t lane, int32_t x,
                             int32_t y, uint32_t count)
{
    const fragment_context *const c = (const fragment_context *)context;

    if (c->color->format == GN_FORMAT_RGB565)
        pack_span(LAYOUT_SHORT, draw, c, lane, x, y, count);
    else
        pack_span(LAYOUT_SHORT_HIGH_FIRST, draw, c, lane, x, y, count);
}

#define GN_565_FUNCTIONS(blocks_name, span_name, depth_format, source, output)                     \
    static void span_name##_565(const void *context, uint32_t lane, int32_t x, int32_t y,          \
                                uint32_t count)                                                    \
    {                                                                                              \
        draw_565(span_name, context, lane, x, y, count);                                           \
    }

GN_FUSED_STATES(GN_565_FUNCTIONS)
#define GN_SPAN_OF(state, span_name, span_name_565)                                                \
    (format_is_565((state)->color.format) ? span_name_565 : span_name)
#else
#define GN_SPAN_OF(state, span_name, span_name_565) span_name
#endif

/* Whether a state may be drawn in rows: nothing needs derivatives, or the shader receives squares,
 * whose colours a batch has room for. */
static inline bool has_rows(const fragment_state *state)
{
    if (!GN_STATES_SPECIALISED)
        return false;
    if (state->source == SOURCE_TEXTURE)
        return has_one_filter(state->sampler);
    return most_columns(state) > 0;
}

/* Returns the functions that draw a state. By comparisons, since a table of functions would need
 * relocation. */
static inline fragment_functions fragment_functions_of(const fragment_state *state, bool counts)
{
    const bool has_color = state->color.format != GN_FORMAT_NONE;
    const fragment_source source = has_color ? state->source : SOURCE_COLOR;
    const bool rows = has_rows(state);
    fragment_functions f = {step_blocks, rows ? step_rows : 0,
                            has_color && source == SOURCE_SHADER};

    if (!GN_HAVE_ROWS || counts || !may_be_fused(state))
        return f;
#define GN_SELECT_FUSED(blocks_name, span_name, fused_depth_format, fused_source, output)          \
    if (state->depth.format == fused_depth_format && source == fused_source &&                     \
        has_color == (output != OUTPUT_NOTHING)) {                                                 \
        if (LANES > 1)                                                                             \
            f.blocks = blocks_name;                                                                \
        if (LANES == 1 || (rows && fused_source != SOURCE_SHADER))                                 \
            f.spans = GN_SPAN_OF(state, span_name, span_name##_565);                               \
    }
    GN_FUSED_STATES(GN_SELECT_FUSED)
#undef GN_SELECT_FUSED
    return f;
}

#endif
