/* Oracle A, in integers of 128 bits. */
#include "snapped_triangle.h"

#include <math.h>

__extension__ typedef __int128 wide;

static int sign_of(wide v)
{
    return (v > 0) - (v < 0);
}

/* Returns the side of the edge from a to b that (x, y) lies on: 1 left, -1 right, 0 on it. */
static int side_of(const int64_t a[2], const int64_t b[2], int64_t x, int64_t y)
{
    return sign_of((wide)(b[0] - a[0]) * (y - a[1]) - (wide)(b[1] - a[1]) * (x - a[0]));
}

/* Returns the side to which a place on the edge moves, which is never 0 for an edge with a length.
 */
static int side_of_moved(const int64_t a[2], const int64_t b[2])
{
    return b[1] != a[1] ? sign_of(a[1] - b[1]) : sign_of(b[0] - a[0]);
}

int exact_winding(const snapped_triangle *t)
{
    return side_of(t->corner[0], t->corner[1], t->corner[2][0], t->corner[2][1]);
}

exact_place exact_place_in(const snapped_triangle *t, int winding, int64_t x, int64_t y)
{
    exact_place place = EXACT_INSIDE;

    if (!winding)
        return EXACT_OUTSIDE;
    for (int i = 0; i < 3; ++i) {
        const int64_t *const a = t->corner[i], *const b = t->corner[(i + 1) % 3];
        const int side = side_of(a, b, x, y);

        if (side == -winding)
            return EXACT_OUTSIDE;
        if (side == 0 && place != EXACT_TIE_LOST)
            place = side_of_moved(a, b) == winding ? EXACT_TIE_OWNED : EXACT_TIE_LOST;
    }
    return place;
}

/* Returns v / 2^bits rounded to the nearest integer, halves to even. */
static wide round_shifted(wide v, int bits)
{
    const wide floor = v >> bits;
    const wide rest = v - floor * ((wide)1 << bits);
    const wide half = (wide)1 << (bits - 1);

    return floor + (rest > half || (rest == half && (floor & 1)));
}

/* Returns v rounded to 24 significant bits, halves to even, as binary32 has them. */
static wide round_to_binary32(wide v)
{
    const wide magnitude = v < 0 ? -v : v;
    int bits = 0;

    while (magnitude >> (bits + 24))
        ++bits;
    return bits ? round_shifted(v, bits) * ((wide)1 << bits) : v;
}

/* Numbers are integers in units of 2^-100. */
#define UNIT 100

int64_t exact_snap(float window, bool sampled)
{
    int exponent;
    const wide digits = (wide)ldexp(frexp((double)window, &exponent), 24);
    wide v = exponent >= 24 - UNIT ? digits * ((wide)1 << (exponent - 24 + UNIT)) : 0;

    if (!sampled)
        v = round_to_binary32(v - ((wide)1 << (UNIT - 1)));
    return (int64_t)round_shifted(v, UNIT - 8) + (sampled ? 0 : 128);
}

int64_t exact_sample_place(uint32_t samples, uint32_t sample, int axis)
{
    static const double place[4][2] = {
        {0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};

    return samples > 1 ? (int64_t)(256.0 * place[sample][axis]) : 128;
}
