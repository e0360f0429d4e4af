/* Attributes at fragments: a triangle's planes, evaluated over lanes. */
#ifndef GN_KERNEL_FRAGMENT_PLANES_INL
#define GN_KERNEL_FRAGMENT_PLANES_INL

#include "fragment.h"

/* The coordinates at which a block's planes are evaluated: for a square those of its lower left
 * pixel, `left` and `lower`; for two halves those of every lane, `x` and `y`. */
typedef struct block_places {
    bool is_square;
    float left, lower;
    lanes_f x, y;
} block_places;

/* Where lane l lies in its half. */
#define COLUMN_IN_HALF(l) (l) % SQUARE_SIZE
#define ROW_IN_HALF(l) (l) / SQUARE_SIZE % 2

/* Sets places in a block's pixels, each `inside` from its pixel's lower left corner, or from its
 * centre if a target is not multisampled. Null means (0, 0). */
GN_INLINE void set_places(block_places *at, const pixel_block *block, const float inside[2])
{
    static const int32_t column[LANES] = GN_NUMBERS(COLUMN_IN_HALF);
    static const int32_t row[LANES] = GN_NUMBERS(ROW_IN_HALF);

    at->is_square = false;
    at->left = at->lower = 0.0f; /* not read, but compilers do not see that */
    at->x = lanes_to_float(
        lanes_i_add(lanes_i_splat_two(block->x[0], block->x[1]), lanes_i_load(column)));
    at->y =
        lanes_to_float(lanes_i_add(lanes_i_splat_two(block->y[0], block->y[1]), lanes_i_load(row)));
    if (DRAWS_SAMPLES && inside) {
        at->x = lanes_add(at->x, lanes_splat(inside[0]));
        at->y = lanes_add(at->y, lanes_splat(inside[1]));
    }
}

/* Sets places in the pixels of a square, whose lower left one is at (x, y). */
GN_INLINE void set_square_places(block_places *at, int32_t x, int32_t y, const float inside[2])
{
    at->is_square = true;
    at->left = (float)x + inside[0];
    at->lower = (float)y + inside[1];
}

/* Copies places. Copying the whole structure would call memcpy on some targets. */
GN_INLINE void copy_places(block_places *to, const block_places *from)
{
    to->is_square = from->is_square;
    if (from->is_square) {
        to->left = from->left;
        to->lower = from->lower;
    } else {
        to->x = from->x;
        to->y = from->y;
    }
}

/* Returns the plane's value in every lane: per_y * y + (per_x * x + origin), in this order. */
GN_INLINE lanes_f plane_at(attribute_plane plane, const block_places *at)
{
    if (GN_STATES_SPECIALISED && at->is_square)
        return lanes_add(lanes_rows(plane.per_y, at->lower),
                         lanes_columns(plane.per_x, at->left, plane.origin));
    return lanes_add(
        lanes_mul(lanes_splat(plane.per_y), at->y),
        lanes_add(lanes_mul(lanes_splat(plane.per_x), at->x), lanes_splat(plane.origin)));
}

/* The attributes that the library interpolates itself over long spans: depth, 1/w, and as varyings
 * a colour and two texture coordinates. */
#define SPAN_ATTRIBUTES (VARYING_PLANES + 6)

/* The two terms of a value: per_y * y for the rows of a span, and per_x * x + origin for 16 of its
 * columns. A pixel then takes only their sum. */
typedef struct row_terms {
    float value[SQUARE_SIZE][SPAN_ATTRIBUTES];
} row_terms;

/* One lane has the planes instead: a pixel that fails the test needs only the term of depth. */
typedef struct column_terms {
#if LANES == 1
    lanes_f x;
    attribute_plane plane[SPAN_ATTRIBUTES];
#else
    lanes_f value[SPAN_ATTRIBUTES];
#endif
} column_terms;

/* Sets the terms of the rows of squares at y. With one lane the columns receive the plane. `inside`
 * is as for set_places. */
GN_INLINE void set_row_terms(row_terms *rows, column_terms *columns, uint32_t attribute,
                             raster_primitive primitive, int32_t y, float inside)
{
    const attribute_plane plane = primitive_plane(primitive, attribute);

    for (int32_t row = 0; row < SQUARE_SIZE; ++row)
        rows->value[row][attribute] =
            plane.per_y * (inside == 0.0f ? (float)(y + row) : (float)(y + row) + inside);
#if LANES == 1
    columns->plane[attribute] = plane;
#else
    (void)columns;
#endif
}

/* Returns the x at which the columns from x on need attributes. Sums of pixels and 1/256 pixels are
 * exact. */
GN_INLINE lanes_f column_places(int32_t x, float inside)
{
#define LANE_NUMBER(l) l
    static const float number[LANES] = GN_NUMBERS(LANE_NUMBER);
    const lanes_f first = lanes_splat(inside == 0.0f ? (float)x : (float)x + inside);

    return LANES > 1 ? lanes_add(first, lanes_load(number)) : first;
}

/* Sets the terms of an attribute in the columns at `places`. */
GN_INLINE void set_column_terms(column_terms *terms, uint32_t attribute, raster_primitive primitive,
                                lanes_f places)
{
#if LANES == 1
    (void)attribute, (void)primitive;
    terms->x = places;
#else
    const attribute_plane plane = primitive_plane(primitive, attribute);

    terms->value[attribute] =
        lanes_add(lanes_mul(lanes_splat(plane.per_x), places), lanes_splat(plane.origin));
#endif
}

GN_INLINE lanes_f column_term(const column_terms *terms, uint32_t attribute)
{
#if LANES == 1
    const attribute_plane plane = terms->plane[attribute];

    return lanes_add(lanes_mul(lanes_splat(plane.per_x), terms->x), lanes_splat(plane.origin));
#else
    return terms->value[attribute];
#endif
}

/* Where a block is: sixteen fragments, one a lane. */
typedef struct fragment_place {
    fragment_shape shape;
    bool in_surface;     /* all of it lies on the surfaces; true for a row */
    pixel_block block;   /* a row has only x[0] and y[0], its first pixel */
    block_places places; /* for a block */

    /* For a row. */
    const column_terms *columns;
    const float *row; /* row_terms of y */
    const lanes_f *w; /* w at y, if it is the same in every column */
} fragment_place;

/* Sets the place of a block of two halves. */
GN_INLINE void set_block(fragment_place *at, const pixel_block *block, bool in_surface)
{
    at->shape = SHAPE_HALVES;
    at->in_surface = in_surface;
    at->block = *block;
    set_places(&at->places, block, 0);
    at->columns = 0;
    at->row = 0;
    at->w = 0;
}

GN_INLINE lanes_f interpolate(const fragment_place *at, raster_primitive primitive,
                              uint32_t attribute)
{
    if (at->shape == SHAPE_ROW)
        return lanes_add(lanes_splat(at->row[attribute]), column_term(at->columns, attribute));
    return plane_at(primitive_plane(primitive, attribute), &at->places);
}

#endif
