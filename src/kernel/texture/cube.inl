/* Cube maps over lanes: which face a direction meets and where, how far the place moves from
 * fragment to fragment, and the texels and weights of the linear filter, which reaches across edges
 * and corners (OpenGL 4.5 sections 8.13 and 8.14), in the order of operations of the reference
 * rasterizer. */
#ifndef GN_KERNEL_TEXTURE_CUBE_INL
#define GN_KERNEL_TEXTURE_CUBE_INL

#include <gnomon/lookup.h>

#include "../../lanes/derivative.h"

/* The component of a direction that is the largest: z wins ties, then y. NaN in y or z counts as
 * larger than numbers. */
typedef struct cube_axis {
    lanes_m is_x; /* unless is_z */
    lanes_m is_z;
    lanes_f sign; /* 1 or -1: the component's sign; -1 for NaN, whose sign processors differ in */
} cube_axis;

typedef struct cube_place {
    cube_axis axis;
    lanes_i face;     /* 0 to 5 */
    lanes_f inverse;  /* 1 / the largest component */
    lanes_f minor[2]; /* the other two, along s and t of the face */
    lanes_f s, t;     /* 0 to 1, or NaN */
} cube_place;

static inline lanes_f cube_major(const cube_axis *axis, const lanes_f v[3])
{
    return lanes_select(axis->is_z, v[2], lanes_select(axis->is_x, v[0], v[1]));
}

static inline void cube_choose_axis(const lanes_f direction[3], cube_axis *axis)
{
    const lanes_f x = lanes_magnitude(direction[0]);
    const lanes_f y = lanes_magnitude(direction[1]);
    const lanes_f z = lanes_magnitude(direction[2]);

    axis->is_x = lanes_not(lanes_less_equal(x, y));
    axis->is_z = lanes_not(lanes_greater(lanes_max(x, y), z));

    /* A NaN without a sign bit makes the difference negative. */
    const lanes_i major = lanes_as_int(cube_major(axis, direction));
    const lanes_i negative = lanes_i_or(major, lanes_i_sub(lanes_i_splat(0x7F800000), major));
    axis->sign = lanes_select(lanes_i_greater(lanes_i_splat(0), negative), lanes_splat(-1.0f),
                              lanes_splat(1.0f));
}

/* Writes the components of a vector along s and t of a face (OpenGL 4.5 table 8.19). */
GN_FRAMED void cube_minors(const cube_axis *axis, const lanes_f v[3], lanes_f minor[2])
{
    const lanes_f minus = lanes_splat(-1.0f);
    const lanes_f x_or_y =
        lanes_select(axis->is_x, lanes_mul(axis->sign, lanes_mul(minus, v[2])), v[0]);
    const lanes_m up = lanes_and(lanes_not(axis->is_x), lanes_not(axis->is_z));

    minor[0] = lanes_select(axis->is_z, lanes_mul(axis->sign, v[0]), x_or_y);
    minor[1] = lanes_select(up, lanes_mul(axis->sign, v[2]), lanes_mul(minus, v[1]));
}

/* Projects directions on faces. The zero vector meets +z or -z, by the sign of its z. Without
 * gradients it meets the face's centre; with gradients s and t become NaN, for which the filters
 * take the first texel. */
GN_FRAMED void cube_project(const lanes_f direction[3], bool has_gradients, cube_place *place)
{
    const lanes_f half = lanes_splat(0.5f);

    cube_choose_axis(direction, &place->axis);
    cube_minors(&place->axis, direction, place->minor);

    const lanes_f major = cube_major(&place->axis, direction);
    place->inverse = lanes_div(lanes_splat(1.0f), major);

    lanes_f scale = lanes_magnitude(lanes_mul(half, place->inverse));
    if (!has_gradients)
        scale = lanes_select(lanes_less_equal(lanes_magnitude(major), lanes_splat(0.0f)),
                             lanes_splat(0.0f), scale);
    place->s = lanes_add(lanes_mul(place->minor[0], scale), half);
    place->t = lanes_add(lanes_mul(place->minor[1], scale), half);
    place->face = lanes_i_add(
        lanes_i_select(place->axis.is_z, lanes_i_splat(4),
                       lanes_i_select(place->axis.is_x, lanes_i_splat(0), lanes_i_splat(2))),
        lanes_i_select(lanes_greater(lanes_splat(0.0f), place->axis.sign), lanes_i_splat(1),
                       lanes_i_splat(0)));
}

/* Writes how s and t change when the direction changes by a gradient: the derivative of (minor /
 * major + 1) / 2, for each lane on its own face. */
GN_FRAMED void cube_gradient(const cube_place *place, const lanes_f gradient[3], lanes_f out[2])
{
    const lanes_f half_inverse = lanes_mul(lanes_splat(0.5f), place->inverse);
    const lanes_f major = lanes_mul(cube_major(&place->axis, gradient), place->inverse);
    lanes_f minor[2];

    cube_minors(&place->axis, gradient, minor);
    for (int i = 0; i < 2; ++i)
        out[i] = lanes_mul(lanes_sub(minor[i], lanes_mul(major, place->minor[i])), half_inverse);
}

/* The texels that a linear filter mixes, in the order of lookup_one_level.inl's CORNER_00, 10,
 * 01, 11. */
enum { CUBE_TEXELS = 4 };

typedef struct cube_texels {
    lanes_i left, below; /* column and row of the first; -1 beyond an edge */
    lanes_f weight_s, weight_t;
    bool are_within;               /* all texels of all lanes are on the lane's face */
    uint32_t missing[CUBE_TEXELS]; /* lanes where three faces meet: the texel does not exist */
    uint32_t weighted;             /* lanes of quads in which a lane has a missing texel */
} cube_texels;

/* Where a texel beyond the edge of a face lies: on the neighbouring face, at a column and a row
 * that are each the first, the last, or the position along the edge, counted from one end (ALONG)
 * or from the other (BACK). The edges of a face are s < 0, s > 1, t < 0, t > 1, in this order. The
 * table follows from projecting a point slightly beyond the edge: its largest component is the one
 * that was minor before. */
#define CUBE_FIRST 0
#define CUBE_ALONG 1
#define CUBE_LAST 2
#define CUBE_BACK 3
#define CUBE_EDGE(face, column, row) ((face) | CUBE_##column << 4 | CUBE_##row << 8)

static const stored_word cube_edges[6 * 4] = {
    CUBE_EDGE(4, LAST, ALONG),  CUBE_EDGE(5, FIRST, ALONG), /* +x */
    CUBE_EDGE(2, LAST, BACK),   CUBE_EDGE(3, LAST, ALONG),
    CUBE_EDGE(5, LAST, ALONG),  CUBE_EDGE(4, FIRST, ALONG), /* -x */
    CUBE_EDGE(2, FIRST, ALONG), CUBE_EDGE(3, FIRST, BACK),
    CUBE_EDGE(1, ALONG, FIRST), CUBE_EDGE(0, BACK, FIRST),  /* +y */
    CUBE_EDGE(5, BACK, FIRST),  CUBE_EDGE(4, ALONG, FIRST), /**/
    CUBE_EDGE(1, BACK, LAST),   CUBE_EDGE(0, ALONG, LAST),  /* -y */
    CUBE_EDGE(4, ALONG, LAST),  CUBE_EDGE(5, BACK, LAST),
    CUBE_EDGE(1, LAST, ALONG),  CUBE_EDGE(0, FIRST, ALONG), /* +z */
    CUBE_EDGE(2, ALONG, LAST),  CUBE_EDGE(3, ALONG, FIRST), /**/
    CUBE_EDGE(0, LAST, ALONG),  CUBE_EDGE(1, FIRST, ALONG), /* -z */
    CUBE_EDGE(2, BACK, FIRST),  CUBE_EDGE(3, BACK, LAST)};

/* Returns a column or row of the neighbour. Bit 0 of kind selects `along` instead of 0, bit 1
 * counts from the last. */
static inline lanes_i cube_beyond(lanes_i kind, lanes_i along, lanes_i last)
{
    const lanes_i one = lanes_i_splat(1), two = lanes_i_splat(2);
    const lanes_i count =
        lanes_i_select(lanes_i_equal(lanes_i_and(kind, one), one), along, lanes_i_splat(0));

    return lanes_i_select(lanes_i_equal(lanes_i_and(kind, two), two), lanes_i_sub(last, count),
                          count);
}

/* Moves texels with a column or row of -1 or last + 1 to the face where they are. A texel that is
 * beyond in both is missing; it moves to an arbitrary texel. */
GN_FRAMED void cube_move(lanes_i last, lanes_i *column, lanes_i *row, lanes_i *face)
{
    const lanes_i zero = lanes_i_splat(0);
    const lanes_i right = lanes_m_as_int(lanes_i_greater(*column, last));
    const lanes_i beyond_s = lanes_i_or(right, lanes_m_as_int(lanes_i_greater(zero, *column)));
    const lanes_i above = lanes_m_as_int(lanes_i_greater(*row, last));
    const lanes_i beyond =
        lanes_i_or(beyond_s, lanes_i_or(above, lanes_m_as_int(lanes_i_greater(zero, *row))));
    const lanes_m is_beyond_s = lanes_i_greater(zero, beyond_s);
    const lanes_m is_beyond = lanes_i_greater(zero, beyond);
    /* A set lane of a mask is -1 as an integer. */
    const lanes_i edge =
        lanes_i_select(is_beyond_s, lanes_i_sub(zero, right), lanes_i_sub(lanes_i_splat(2), above));
    const lanes_i word =
        lanes_i_gather(cube_edges, lanes_i_add(lanes_i_shift_left(*face, 2), edge));
    const lanes_i along = lanes_i_clamp(lanes_i_select(is_beyond_s, *row, *column), zero, last);

    *face = lanes_i_select(is_beyond, lanes_i_and(word, lanes_i_splat(15)), *face);
    *column =
        lanes_i_select(is_beyond, cube_beyond(lanes_i_shift_right(word, 4), along, last), *column);
    *row = lanes_i_select(is_beyond, cube_beyond(lanes_i_shift_right(word, 8), along, last), *row);
}

/* Clamps to 0..1; NaN becomes 0. Coordinates are infinite only if the direction has a NaN. */
static inline lanes_f cube_clamp(lanes_f a)
{
    return lanes_min(lanes_max(a, lanes_splat(0.0f)), lanes_splat(1.0f));
}

/* Finds the texels of the linear filter in levels of size x size. */
GN_FRAMED void cube_linear(const cube_place *place, lanes_i size, cube_texels *out)
{
    const lanes_f n = lanes_to_float(size), half = lanes_splat(0.5f);
    const lanes_i last = lanes_i_sub(size, lanes_i_splat(1));
    const lanes_f s = lanes_sub(lanes_mul(cube_clamp(place->s), n), half);
    const lanes_f t = lanes_sub(lanes_mul(cube_clamp(place->t), n), half);
    const lanes_f whole_s = lanes_floor(s), whole_t = lanes_floor(t);
    const lanes_i left = lanes_truncate(whole_s), below = lanes_truncate(whole_t);
    const uint32_t off_left = lanes_i_sign_bits(left);
    const uint32_t off_right = lanes_bits(lanes_not(lanes_i_greater(last, left)));
    const uint32_t off_below = lanes_i_sign_bits(below);
    const uint32_t off_above = lanes_bits(lanes_not(lanes_i_greater(last, below)));

    out->left = left;
    out->below = below;
    out->weight_s = lanes_sub(s, whole_s);
    out->weight_t = lanes_sub(t, whole_t);
    out->are_within = (off_left | off_right | off_below | off_above) == 0;
    out->missing[0] = off_left & off_below;
    out->missing[1] = off_right & off_below;
    out->missing[2] = off_left & off_above;
    out->missing[3] = off_right & off_above;
    out->weighted = quads_of((off_left | off_right) & (off_below | off_above));
}

/* Finds the column, row and face of texel i. */
GN_FRAMED void cube_find_texel(const cube_place *place, lanes_i size, const cube_texels *texels,
                               int i, lanes_i *column, lanes_i *row, lanes_i *face)
{
    const lanes_i one = lanes_i_splat(1);

    *column = i & 1 ? lanes_i_add(texels->left, one) : texels->left;
    *row = i & 2 ? lanes_i_add(texels->below, one) : texels->below;
    *face = place->face;
    if (!texels->are_within)
        cube_move(lanes_i_sub(size, one), column, row, face);
}

/* Writes the weights of the four texels in quads at a corner: those of the bilinear filter, with
 * the weight of a missing texel divided equally among the other three. */
GN_FRAMED void cube_weights(const cube_texels *texels, lanes_f weight[CUBE_TEXELS])
{
    const lanes_f one = lanes_splat(1.0f), zero = lanes_splat(0.0f);
    const lanes_f rest_s = lanes_sub(one, texels->weight_s);
    const lanes_f rest_t = lanes_sub(one, texels->weight_t);
    lanes_f spread = zero;

    weight[0] = lanes_mul(rest_s, rest_t);
    weight[1] = lanes_mul(texels->weight_s, rest_t);
    weight[2] = lanes_mul(rest_s, texels->weight_t);
    weight[3] = lanes_mul(texels->weight_s, texels->weight_t);
    for (int i = 0; i < CUBE_TEXELS; ++i)
        spread = lanes_select(lanes_from_bits(texels->missing[i]), weight[i], spread);
    spread = lanes_mul(spread, lanes_splat(1.0f / 3.0f));
    for (int i = 0; i < CUBE_TEXELS; ++i)
        weight[i] =
            lanes_select(lanes_from_bits(texels->missing[i]), zero, lanes_add(weight[i], spread));
}

/* Returns the texels of one channel, mixed by these weights. */
static inline lanes_f cube_mix(const lanes_f weight[CUBE_TEXELS], const lanes_f texel[CUBE_TEXELS])
{
    lanes_f sum = lanes_mul(weight[0], texel[0]);

    for (int i = 1; i < CUBE_TEXELS; ++i)
        sum = lanes_add(lanes_mul(weight[i], texel[i]), sum);
    return sum;
}

/* Replaces a missing texel of a gather at a corner by the mean of the other three. */
GN_FRAMED void cube_fill_missing(const cube_texels *texels, lanes_f texel[CUBE_TEXELS])
{
    lanes_f kept[CUBE_TEXELS];

    for (int i = 0; i < CUBE_TEXELS; ++i)
        kept[i] = lanes_select(lanes_from_bits(texels->missing[i]), lanes_splat(0.0f), texel[i]);

    const lanes_f sum = lanes_add(lanes_add(kept[0], kept[1]), lanes_add(kept[2], kept[3]));
    const lanes_f mean = lanes_mul(lanes_splat(1.0f / 3.0f), sum);
    for (int i = 0; i < CUBE_TEXELS; ++i)
        texel[i] = lanes_select(lanes_from_bits(texels->missing[i]), mean, kept[i]);
}

#endif
