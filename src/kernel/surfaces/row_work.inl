/* Work on rows (row_work.h) over a form of lanes. A few sets of GN_LANES pixels take each step
 * together, so that what depends on the format is chosen once for them. The file that includes this
 * first defines the form and GN_ROWS, the function's name. */
#include "row_work.h"

#include "../../lanes/target_begin.inl"

#include "../../formats/decode.h"
#include "../../formats/numbers.h"
#include "../../formats/pixel_rows.h"

/* The sets of pixels that take a step together. */
#define ROW_SETS (GN_SPECIALISED ? 8 : 1)

/* Begins a loop over sets. Compilers that know how many there are at most would repeat it as often.
 */
#if defined(__GNUC__) && __GNUC__ >= 8 && !defined(__clang__)
#define EACH_SET(n, sets) _Pragma("GCC unroll 1") for (uint32_t n = 0; n < (sets); ++n)
#else
#define EACH_SET(n, sets) for (uint32_t n = 0; n < (sets); ++n)
#endif

/* The words of sets of pixels. */
typedef lanes_i set_words[4];

/* The channels of sets of pixels: channel c of set n is [c * ROW_SETS + n]. Steps are functions of
 * their own that take addresses, so that compilers make loops of them. */
typedef lanes_f row_channels[4 * ROW_SETS];

static inline uint32_t sets_of(uint32_t count)
{
    return (count + GN_LANES - 1) / GN_LANES;
}

/* Memory of a function's own for the last pixels of a row, if they are no whole set. */
typedef union last_pixels {
    int32_t word[4 * GN_LANES];
    unsigned char byte[LAYOUT_MOST_BYTES * GN_LANES];
} last_pixels;

/* Prefetches `size` bytes. Without it, rows of several samples wait for memory. */
GN_INLINE void prefetch_row(const unsigned char *memory, uint32_t size)
{
#if defined(__GNUC__)
    for (uint32_t i = 0; i < size; i += 64)
        __builtin_prefetch(memory + i);
#else
    (void)memory;
    (void)size;
#endif
}

/* Loads sets of pixels that lie side by side. */
GN_OUT_OF_LINE void load_sets(pixel_layout layout, const unsigned char *pixels, uint32_t sets,
                              set_words *words)
{
    const uint32_t ahead = ROW_SETS * GN_LANES; /* pixels */

#define LOAD(constant)                                                                             \
    EACH_SET (n, sets) {                                                                           \
        const lane_pixels m = row_pixels(pixels + n * GN_LANES * layout_bytes(constant));          \
                                                                                                   \
        prefetch_row(m.half[0] + ahead * layout_bytes(constant),                                   \
                     GN_LANES * layout_bytes(constant));                                           \
        load_pixels(constant, &m, GN_ALL_LANES, words[n]);                                         \
    }
    GN_EACH_COLOR_LAYOUT(layout, LOAD)
#undef LOAD
}

GN_OUT_OF_LINE void store_sets(pixel_layout layout, unsigned char *pixels, uint32_t sets,
                               const number_lanes *words)
{
    lanes_i word[4];

#define STORE(constant)                                                                            \
    EACH_SET (n, sets) {                                                                           \
        const lane_pixels m = row_pixels(pixels + n * GN_LANES * layout_bytes(constant));          \
                                                                                                   \
        load_number_words(constant, words + n, ROW_SETS, word);                                    \
        store_pixels(constant, &m, GN_ALL_LANES, word);                                            \
    }
    GN_EACH_COLOR_LAYOUT(layout, STORE)
#undef STORE
}

/* Decodes sets of pixels. Channel c of set n is channels[c * stride + n]. */
GN_OUT_OF_LINE void decode_sets(gn_format format, const set_words *words, uint32_t sets,
                                lanes_f *channels, uint32_t stride)
{
    const format_decoding *const f = &gni_decodings[format];

    for (int c = 0; c < 4; ++c, channels += stride) {
        const channel_decoding *const channel = &f->channel[c];

        if (c >= f->channels)
            EACH_SET (n, sets)
                channels[n] = lanes_splat(c == 3 ? 1.0f : 0.0f);
        else if (channel->kind == CHANNEL_FRACTION && !channel->is_high)
            EACH_SET (n, sets)
                channels[n] = masked_fraction(channel, words[n][channel->word]);
        else
            decode_channel(channel, words, (int)sets, channels);
    }
}

GN_OUT_OF_LINE void encode_sets(color_arithmetic arithmetic, const lanes_f *channels, uint32_t sets,
                                number_lanes *numbers)
{
    EACH_SET (n, sets) {
        lanes_f color[4];

        for (uint32_t c = 0; c < 4; ++c)
            color[c] = channels[c * ROW_SETS + n];
        encode_numbers(arithmetic, color, numbers + n, ROW_SETS);
    }
}

/* Loads colours that lie side by side. Beyond `count` they are decoded zeros. */
static void load_row(gn_format format, const unsigned char *pixels, uint32_t count,
                     lanes_f *channels)
{
    const pixel_layout layout = format_layout(format);
    const uint32_t whole = count / GN_LANES, rest = count % GN_LANES * layout_bytes(layout);
    set_words words[ROW_SETS];
    last_pixels last;

    load_sets(layout, pixels, whole, words);
    if (rest > 0) {
        for (int i = 0; i < 4 * GN_LANES; ++i)
            last.word[i] = 0;
        for (uint32_t i = 0; i < rest; ++i)
            last.byte[i] = pixels[whole * GN_LANES * layout_bytes(layout) + i];
        load_sets(layout, last.byte, 1, words + whole);
    }
    decode_sets(format, (const set_words *)words, sets_of(count), channels, ROW_SETS);
}

/* Stores colours side by side. */
static void store_row(gn_format format, unsigned char *pixels, uint32_t count,
                      const lanes_f *channels)
{
    const pixel_layout layout = format_layout(format);
    const uint32_t whole = count / GN_LANES, rest = count % GN_LANES * layout_bytes(layout);
    number_lanes numbers[4 * ROW_SETS];
    last_pixels last;

    encode_sets(arithmetic_of(format), channels, sets_of(count), numbers);
    const number_lanes *const words =
        words_of_numbers(format, sets_of(count), (const number_lanes *)numbers, numbers, ROW_SETS);
    store_sets(layout, pixels, whole, words);
    if (rest > 0) {
        store_sets(layout, last.byte, 1, words + whole);
        for (uint32_t i = 0; i < rest; ++i)
            pixels[whole * GN_LANES * layout_bytes(layout) + i] = last.byte[i];
    }
}

/* Gathers a set of pixels (gather_pixels). */
GN_OUT_OF_LINE void gather_set(pixel_layout layout, const unsigned char *pixels,
                               const ptrdiff_t row[GN_LANES], const int32_t column[GN_LANES],
                               lanes_i word[4])
{
#define GATHER(constant) gather_pixels(constant, pixels, row, column, word)
    GN_EACH_COLOR_LAYOUT(layout, GATHER)
#undef GATHER
}

/* Gathers the texels of `sets` sets of columns from column `first` on, in the first row. */
static void gather_row(const row_work *w, uint32_t first, uint32_t sets, lanes_f *channels)
{
    set_words words[ROW_SETS];

    EACH_SET (n, sets)
        gather_set(format_layout(w->read), w->from, w->rows->offset[0],
                   w->columns->offset[0] + first + n * GN_LANES, words[n]);
    decode_sets(w->read, (const set_words *)words, sets, channels, ROW_SETS);
}

/* Loads the two texels of each column in a row: first those on the left, then those on the right.
 */
static void load_both(const row_work *w, const unsigned char *from, int row, uint32_t first,
                      uint32_t sets, set_words *words)
{
    const pixel_layout layout = format_layout(w->read);
    const ptrdiff_t *const offset = w->rows->offset[row];

    EACH_SET (n, sets) {
        const uint32_t x = first + n * GN_LANES;

        if (layout_has_pairs(layout) && w->rows->is_one && x + GN_LANES <= w->columns->side_by_side)
            load_pixel_pairs(layout, from + offset[0] + w->columns->offset[0][x], words[n],
                             words[sets + n]);
        else
            for (uint32_t i = 0; i < 2; ++i)
                gather_set(layout, from, offset, w->columns->offset[i] + x, words[i * sets + n]);
    }
}

static inline lanes_f mix_texels(lanes_f weight, lanes_f a, lanes_f b)
{
    return lanes_add(a, lanes_mul(weight, lanes_sub(b, a)));
}

/* Mixes the texels of two columns and of one row or two: those of each column on the left, those on
 * the right, then those of the second row. */
GN_OUT_OF_LINE void mix_sets(const float *along_x, const float *along_y, int rows,
                             const lanes_f *texels, uint32_t sets, lanes_f *channels)
{
    const lanes_f t = lanes_load(along_y);

    EACH_SET (n, sets) {
        const lanes_f s = lanes_load(along_x + n * GN_LANES);

        for (uint32_t c = 0; c < 4; ++c) {
            const lanes_f *const texel = texels + c * 4 * ROW_SETS + n;
            lanes_f mixed = mix_texels(s, texel[0], texel[sets]);

            if (rows == 2)
                mixed = mix_texels(t, mixed, mix_texels(s, texel[2 * sets], texel[3 * sets]));
            channels[c * ROW_SETS + n] = mixed;
        }
    }
}

/* Mixes the texels of two columns and, in more than one dimension, of two rows, for the columns
 * from `first` on. */
static void mix_source(const row_work *w, const unsigned char *from, uint32_t first, uint32_t sets,
                       lanes_f *channels)
{
    const int rows = w->dimensions > 1 ? 2 : 1;
    set_words words[4 * ROW_SETS];
    lanes_f texels[4 * 4 * ROW_SETS];

    for (int row = 0; row < rows; ++row)
        load_both(w, from, row, first, sets, words + 2 * (uint32_t)row * sets);
    decode_sets(w->read, (const set_words *)words, 2 * (uint32_t)rows * sets, texels, 4 * ROW_SETS);
    mix_sets(w->columns->weight + first, w->rows->weight, rows, texels, sets, channels);
}

static void mix_sources(const row_work *w, uint32_t first, uint32_t sets, lanes_f *channels)
{
    row_channels second;

    mix_source(w, w->from, first, sets, channels);
    if (w->dimensions == 3) {
        mix_source(w, w->next, first, sets, second);
        for (uint32_t c = 0; c < 4 * ROW_SETS; c += ROW_SETS)
            for (uint32_t n = c; n < c + sets; ++n)
                channels[n] = mix_texels(lanes_splat(w->next_weight), channels[n], second[n]);
    }
}

/* Adds other colours to colours. */
GN_OUT_OF_LINE void add_sets(const lanes_f *other, uint32_t sets, lanes_f *channels)
{
    for (uint32_t c = 0; c < 4 * ROW_SETS; c += ROW_SETS)
        for (uint32_t n = c; n < c + sets; ++n)
            channels[n] = lanes_add(channels[n], other[n]);
}

GN_OUT_OF_LINE void scale_sets(float factor, uint32_t sets, lanes_f *channels)
{
    for (uint32_t c = 0; c < 4 * ROW_SETS; c += ROW_SETS)
        for (uint32_t n = c; n < c + sets; ++n)
            channels[n] = lanes_mul(channels[n], lanes_splat(factor));
}

/* Loads the means of four samples. */
static void average(const row_work *w, const unsigned char *from, uint32_t count, lanes_f *channels)
{
    row_channels one;

    load_row(w->read, from, count, channels);
    for (int s = 1; s < GN_SAMPLES; ++s) {
        load_row(w->read, from + s * w->sample_stride, count, one);
        add_sets(one, sets_of(count), channels);
    }
    scale_sets(0.25f, sets_of(count), channels);
}

void GN_ROWS(const row_work *w)
{
    const uint32_t read_size = format_size(w->read);
    const uint32_t written_size = format_size(w->written);
    row_channels channels;

    for (uint32_t x = 0; x < w->count; x += ROW_SETS * GN_LANES) {
        const uint32_t most = ROW_SETS * GN_LANES;
        const uint32_t count = w->count - x < most ? w->count - x : most;

        if (w->kind == ROW_CONVERTS)
            load_row(w->read, w->from + x * read_size, count, channels);
        else if (w->kind == ROW_AVERAGES)
            average(w, w->from + x * read_size, count, channels);
        else if (w->kind == ROW_MIXES)
            mix_sources(w, w->first + x, sets_of(count), channels);
        else
            gather_row(w, w->first + x, sets_of(count), channels);
        store_row(w->written, w->to + x * written_size, count, channels);
    }
}

#include "../../lanes/target_end.inl"
