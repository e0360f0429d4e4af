/* Work on rows (row_work.h) over a form of lanes. The file that includes this first defines the
 * form and GN_ROWS, the function's name. */
#include "row_work.h"

#include "../../lanes/target_begin.inl"

#include "../../formats/load_colors.h"
#include "../../formats/store_colors.h"

static inline lanes_f mix_texels(lanes_f weight, lanes_f a, lanes_f b)
{
    return lanes_add(a, lanes_mul(weight, lanes_sub(b, a)));
}

/* Mixes the texels of two columns and, in more than one dimension, of two rows, for the span from
 * column `first` on. */
static void mix_source(const row_work *w, const unsigned char *from, uint32_t first,
                       lanes_f color[4])
{
    const texel_columns *const columns = w->columns;
    const texel_rows *const rows = w->rows;
    const bool pairs = rows->is_one && first + GN_LANES <= columns->side_by_side &&
                       layout_has_pairs(format_layout(w->read));
    const lanes_f along_x = lanes_load(columns->weight + first);
    const lanes_f along_y = lanes_load(rows->weight);
    lanes_f left[4], right[4];

    for (int above = 0; above < (w->dimensions > 1 ? 2 : 1); ++above) {
        if (pairs) {
            load_color_pairs(w->read, from + rows->offset[above][0] + columns->offset[0][first],
                             left, right);
        } else {
            gather_colors(w->read, from, rows->offset[above], columns->offset[0] + first, left);
            gather_colors(w->read, from, rows->offset[above], columns->offset[1] + first, right);
        }
        for (int c = 0; c < 4; ++c) {
            const lanes_f mixed = mix_texels(along_x, left[c], right[c]);

            color[c] = above ? mix_texels(along_y, color[c], mixed) : mixed;
        }
    }
}

static void mix_sources(const row_work *w, uint32_t first, lanes_f color[4])
{
    lanes_f second[4];

    mix_source(w, w->from, first, color);
    if (w->dimensions == 3) {
        mix_source(w, w->next, first, second);
        for (int c = 0; c < 4; ++c)
            color[c] = mix_texels(lanes_splat(w->between), color[c], second[c]);
    }
}

/* Loads the means of four samples of `count` pixels. */
static void average(const row_work *w, const unsigned char *from, uint32_t count, lanes_f color[4])
{
    lanes_f one[4];

    load_colors(w->read, from, count, color);
    for (int s = 1; s < GN_SAMPLES; ++s) {
        load_colors(w->read, from + s * w->sample_stride, count, one);
        for (int c = 0; c < 4; ++c)
            color[c] = lanes_add(color[c], one[c]);
    }
    for (int c = 0; c < 4; ++c)
        color[c] = lanes_mul(color[c], lanes_splat(0.25f));
}

void GN_ROWS(const row_work *w)
{
    const uint32_t read_size = format_size(w->read);
    const uint32_t written_size = format_size(w->written);
    lanes_f color[4];

    for (uint32_t x = 0; x < w->count; x += GN_LANES) {
        const uint32_t count = w->count - x < GN_LANES ? w->count - x : GN_LANES;

        if (w->kind == ROW_CONVERTS)
            load_colors(w->read, w->from + x * read_size, count, color);
        else if (w->kind == ROW_AVERAGES)
            average(w, w->from + x * read_size, count, color);
        else if (w->kind == ROW_MIXES)
            mix_sources(w, w->first + x, color);
        else
            gather_colors(w->read, w->from, w->rows->offset[0],
                          w->columns->offset[0] + w->first + x, color);
        store_colors(w->written, w->to + x * written_size, count, color);
    }
}

#include "../../lanes/target_end.inl"
