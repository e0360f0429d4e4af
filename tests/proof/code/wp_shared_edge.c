/* Who owns a sample on an edge that two triangles share. The functions here only call the library's
 * set-up and evaluation of edges (src/kernel/raster/cover_large.inl); their contracts say the tie
 * rule.
 * @functions: first_is_not_negative is_inside_edge count_owners */
#include "kernel/raster/cover_large.inl"

/*@ requires edges_ok(edge) && is_pixel(px) && is_pixel(py);
    assigns \nothing;
    ensures \result != 0 <==> edge->constant - edge->per_x * px + edge->per_y * py >= 0;
*/
static bool first_is_not_negative(const large_edge edge[3], int32_t px, int32_t py)
{
    return values_at(edge, px, py).v[0] >= 0;
}

/* Returns whether a pixel is inside the edge through (x, y). The exact edge function at its centre,
 * per_x * (x - 256 * px) - per_y * (y - 256 * py), is positive there, or it is zero and the edge
 * owns its ties. */
/*@ requires is_difference(per_x) && is_difference(per_y) && is_snapped(x) && is_snapped(y);
    requires is_pixel(px) && is_pixel(py);
    assigns \nothing;
    ensures \result != 0 <==>
        per_x * (x - 256 * px) - per_y * (y - 256 * py) + owns(per_x, per_y, upside_down) > 0;
*/
static bool is_inside_edge(int32_t per_x, int32_t per_y, int32_t x, int32_t y, int32_t px,
                           int32_t py, bool upside_down)
{
    large_edge edge[3];

    /*@ loop pragma UNROLL "completely", 4; */
    for (int i = 0; i < 3; ++i)
        set_edge_through(&edge[i], per_x, per_y, x, y, upside_down);
    return first_is_not_negative(edge, px, py);
}

/* Returns how many of two triangles own a pixel, which lie on either side of an edge and have it in
 * opposite directions. */
/*@ requires is_snapped(x0) && is_snapped(y0) && is_snapped(x1) && is_snapped(y1);
    requires x0 != x1 || y0 != y1;
    requires is_pixel(px) && is_pixel(py);
    assigns \nothing;
    ensures \result == 1;
*/
static int32_t count_owners(int32_t x0, int32_t y0, int32_t x1, int32_t y1, int32_t px, int32_t py,
                            bool upside_down)
{
    const bool one = is_inside_edge(y0 - y1, x0 - x1, x0, y0, px, py, upside_down);
    const bool other = is_inside_edge(y1 - y0, x1 - x0, x1, y1, px, py, upside_down);

    return one + other;
}
