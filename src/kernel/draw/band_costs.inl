/* The work in the rows of the target, as estimated from a round's lists, and its division into
 * bands. */
#ifndef GN_KERNEL_DRAW_BAND_COSTS_INL
#define GN_KERNEL_DRAW_BAND_COSTS_INL

#include "../../lanes/lanes.h"
#include "workspace.h"

#define MAX_BANDS 64

/* So many halves are worth MAX_BANDS bands of TASK_COST each. A segment's sum fits 32 bits. */
#define MOST_HALVES (1 << 16)

/* Bisections of the limit in divide_bands. */
#define CUT_TRIES 6

/* The estimated cost of a round's lists by rows of squares: bin b holds 1 << bin_shift rows, from
 * row b << bin_shift on. The unit is half a square to shade, or one triangle to set up. */
#define COST_BINS 128

typedef struct row_costs {
    float bin[COST_BINS];
} row_costs;

/* Bands of whole squares: band i has rows row[i] to row[i + 1] - 1 of the target. */
typedef struct row_bands {
    uint32_t count;
    int32_t row[MAX_BANDS + 1];
} row_bands;

/* Returns the bin_shift of a target whose last row is `last`. */
static uint32_t bin_shift_of(int32_t last)
{
    uint32_t shift = 0;

    while ((uint32_t)last / SQUARE_SIZE >> shift >= COST_BINS)
        ++shift;
    return shift;
}

/* Returns how many cells of 1 << shift pixels the bounds of each lane reach into along one axis. */
static lanes_i cells_along(const primitive_list *list, int min, int max, int shift)
{
    const lanes_i first = lanes_i_shift_right(lanes_i_load(list->bounds[min]), shift);
    const lanes_i last = lanes_i_shift_right(lanes_i_load(list->bounds[max]), shift);

    return lanes_i_add(lanes_i_sub(last, first), lanes_i_splat(1));
}

/* Estimates how many halves a list's triangles reach into: (w * h + w + h) / 2 for bounds of w by h
 * halves, at most MOST_HALVES each. Lanes without a triangle repeat the first one. */
static uint32_t halves_of_list(const primitive_list *list)
{
    const lanes_i wide = cells_along(list, BOUNDS_MIN_X, BOUNDS_MAX_X, 2);
    const lanes_i high = cells_along(list, BOUNDS_MIN_Y, BOUNDS_MAX_Y, 1);
    const lanes_i twice = lanes_i_add(lanes_i_mul(wide, high), lanes_i_add(wide, high));
    int32_t lane[LANES];
    uint32_t sum = 0;

    lanes_i_store(lane, lanes_i_min(lanes_i_shift_right(twice, 1), lanes_i_splat(MOST_HALVES)));
    GN_EACH_LANE (l)
        sum += (uint32_t)lane[l];
    return sum * list->count / LANES;
}

/* Spreads a list's work evenly over its rows. */
static void add_cost(row_costs *costs, uint32_t shift, const primitive_list *list, uint32_t halves,
                     row_range rows)
{
    const uint32_t first = (uint32_t)rows.min / SQUARE_SIZE >> shift;
    const uint32_t last = (uint32_t)rows.max / SQUARE_SIZE >> shift;
    const float all = (float)list->count + (float)halves;
    const float share = all / (float)(last - first + 1);

    for (uint32_t b = first; b <= last; ++b)
        costs->bin[b] += share;
}

/* Cuts rows of squares `first` to `last` into at most `most` bands of one row, or of at most
 * `limit` work. Returns false if `most` bands are too few: the last one then has all rows that are
 * left. */
static bool cut_rows(row_bands *bands, const row_costs *costs, uint32_t shift, uint32_t first,
                     uint32_t last, float limit, uint32_t most)
{
    float sum = 0.0f;
    bool fits = true;

    bands->row[0] = (int32_t)first * SQUARE_SIZE;
    bands->count = 0;
    for (uint32_t row = first; row <= last && fits; ++row) {
        const float here = costs->bin[row >> shift];

        sum += here;
        if (sum > limit && row > first) {
            fits = bands->count + 1 < most;
            if (fits)
                bands->row[++bands->count] = (int32_t)row * SQUARE_SIZE;
            sum = here;
        }
    }
    bands->row[++bands->count] = (int32_t)(last + 1) * SQUARE_SIZE;
    return fits;
}

/* Divides rows of squares `first` to `last` into at most `most` bands. Bisects the limit of
 * cut_rows, so that the work of the largest band is nearly minimal. */
static void divide_bands(row_bands *bands, const row_costs *costs, uint32_t shift, uint32_t first,
                         uint32_t last, uint32_t most)
{
    float all = 0.0f;
    float largest = 0.0f;

    for (uint32_t row = first; row <= last; ++row) {
        const float here = costs->bin[row >> shift];

        all += here;
        largest = here > largest ? here : largest;
    }
    float low = all / (float)most;
    float high = low + largest;
    for (int i = 0; i < CUT_TRIES; ++i) {
        const float middle = 0.5f * (low + high);

        if (cut_rows(bands, costs, shift, first, last, middle, most))
            high = middle;
        else
            low = middle;
    }
    cut_rows(bands, costs, shift, first, last, high, most);
}

#endif
