/* Textures. For all floats as coordinates (infinities and NaN too), every wrap and every size, no
 * conversion of a float overflows where texels are numbered. For every format, and all numbers of
 * texels in a level of 5 x 3 texels and two layers, positive and negative strides, every texel and
 * its right neighbour are read inside the level's memory, which ends with its last texel.
 *
 * Eva does not show that wrapped numbers lie in the level: it does not relate a select's mask to
 * its operands, nor a coordinate to its floor. axioms.smt2 proves that a coordinate minus its floor
 * is 0 to 1.
 * @sources: texture/texel_layout.c formats/decode_table.c formats/srgb.c
 * @options: -eva-precision 2 -eva-interprocedural-splits
 * @options: -kernel-warn-key parser:decimal-float=inactive
 * @reaches: wrap_nearest wrap_linear wrap_linear_any wrap_gathered second_texel clamped_texels
 * @reaches: minus_even fraction_of nearest_integer gni_lay_out_texels fetch_texels load_one_by_one
 * @reaches: load_by_index load_neighbours load_any_neighbours load_three_byte_neighbours
 * @reaches: decode_colors */
#include "eva.h"

#include "formats/properties.h"
#include "kernel/texture/texel.inl"
#include "kernel/texture/wrap.inl"

#define WIDTH 5
#define HEIGHT 3
#define LAYERS 2
#define MOST (16 * WIDTH * HEIGHT * LAYERS)

static unsigned char memory[MOST];

static lanes_f any_coordinates(void)
{
    lanes_f a;

    for (int l = 0; l < GN_LANES; ++l)
        a.v[l] = any_float;
    return a;
}

static lanes_i any_numbers(int32_t below)
{
    lanes_i a;

    for (int l = 0; l < GN_LANES; ++l)
        a.v[l] = int32_from(0, below - 1);
    return a;
}

static void wrap_any(void)
{
    const gn_wrap wrap = (gn_wrap)uint32_from(0, GN_WRAP_MIRROR_CLAMP_TO_EDGE);
    const uint32_t size = uint32_from(1, GN_MAX_SIZE);
    const bool masked = repeats_by_mask(wrap, size);
    lanes_i texel[2];

    texel[0] = wrap_nearest(wrap, masked, any_coordinates(), size);
    wrap_linear_any(wrap, masked, any_coordinates(), size, texel);
    wrap_gathered(wrap, masked, any_coordinates(), size, texel);
}

/* Reads texels of a level. With `down` its rows and layers lie in the other order. Then all lanes
 * read one row: Eva takes a sum that wraps around for any number if it does not know its sign. */
static void fetch_any_texels(gn_format format, bool down, int32_t y, int32_t z)
{
    const ptrdiff_t row = WIDTH * (ptrdiff_t)format_size(format);
    const ptrdiff_t layer = HEIGHT * row;
    const lanes_i column = any_numbers(WIDTH), first = any_numbers(WIDTH - 1);
    const lanes_i line = down ? lanes_i_splat(y) : any_numbers(HEIGHT);
    const lanes_i number = down ? lanes_i_splat(z) : any_numbers(LAYERS);
    gn_texture texture = {0};
    texel_layout layout;
    lanes_i left[4], right[4], index;
    lanes_f texel[4];

    texture.target = GN_TEXTURE_2D_ARRAY;
    texture.format = format;
    texture.width = WIDTH;
    texture.height = HEIGHT;
    texture.depth = LAYERS;
    texture.level[0].texels = memory + MOST - LAYERS * layer + (down ? LAYERS * layer - row : 0);
    texture.level[0].row_stride = down ? -row : row;
    texture.level[0].layer_stride = down ? -layer : layer;
    gni_lay_out_texels(&texture, 0, &layout);
    fetch_texels(&layout, &column, &line, &number, texel);
    if (layout.indexed != LAYOUT_NONE && format_size(format) != 3) {
        index = lanes_i_add(in_units(&layout, 0, first), in_units(&layout, 1, line));
        index = lanes_i_add(index, in_units(&layout, 2, number));
        load_any_neighbours(&layout, &index, left, right);
    }
    /* Whether eight bytes are loaded depends on all lanes: one number in all lanes at a time. */
    if (layout.indexed == LAYOUT_THREE_BYTES) {
        /*@ loop unroll 24; */
        for (int32_t n = 0; n < (WIDTH - 1) * HEIGHT * LAYERS; ++n) {
            const int32_t along = n % (WIDTH - 1) * layout.unit[0];
            const int32_t across = n / (WIDTH - 1) % HEIGHT * layout.unit[1];
            const int32_t deep = n / (WIDTH - 1) / HEIGHT * layout.unit[2];

            index = lanes_i_splat(along + across + deep);
            load_any_neighbours(&layout, &index, left, right);
        }
    }
}

int main(void)
{
    wrap_any();
    /*@ loop unroll 64; */
    for (int format = GN_FORMAT_NONE + 1; format_size((gn_format)format) > 0; ++format) {
        if (!(format_is_color((gn_format)format) || format_has_depth((gn_format)format)))
            continue;
        fetch_any_texels((gn_format)format, false, 0, 0);
        /*@ loop unroll 6; */
        for (int32_t n = 0; n < HEIGHT * LAYERS; ++n)
            fetch_any_texels((gn_format)format, true, n % HEIGHT, n / HEIGHT);
    }
    return 0;
}
