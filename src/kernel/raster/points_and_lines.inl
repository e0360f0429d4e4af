/* Points and lines as boxes of pixels. A point is its whole box; a line is the part of its box
 * between its two long edges (reference/RULES.md). The line's other two edges, its ends, are
 * vertical or horizontal, so they are sides of the box. */
#ifndef GN_KERNEL_RASTER_POINTS_AND_LINES_INL
#define GN_KERNEL_RASTER_POINTS_AND_LINES_INL

#include "raster.h"

#include "../geometry/assemble.h"
#include "../../lanes/lanes.h"
#include "../../scalars/bits.h"

/* Values that are constant over a draw. */
typedef struct box_state {
    bool program_point_size;
    bool upside_down;   /* the viewport's height is negative */
    int32_t point_size; /* in 1/256 pixel */
    int32_t half_width; /* half the width of lines, in 1/256 pixel */
    float width;        /* width of lines on multisampled targets, which is not rounded */
    int32_t reach; /* greatest distance of a sample from its pixel's centre, in 1/256 pixel; 0: not
                      multisampled */
} box_state;

static inline bool is_multisampled(const box_state *state)
{
    return DRAWS_SAMPLES && state->reach != 0;
}

/* Returns a size or width in 1/256 pixel. NaN counts as 1. */
static inline int32_t snap_size(float size, float greatest)
{
    const float limited = size > greatest ? greatest : size;

    return limited > 1.0f ? round_to_even(limited * 256.0f) : 256;
}

static inline box_state box_state_of(const gn_pipeline *p)
{
    const float width =
        p->raster.line_width < GN_MAX_LINE_WIDTH ? p->raster.line_width : GN_MAX_LINE_WIDTH;
    box_state s;

    s.program_point_size = p->program.vertex_writes_point_size;
    s.upside_down = p->raster.viewport.enabled && p->raster.viewport.height < 0.0f;
    s.point_size = snap_size(p->raster.point_size, GN_MAX_POINT_SIZE);
    s.half_width = width > 1.0f ? round_to_even(width) * 128 : 128;
    s.width = width > 1.0f ? width : 1.0f;
    s.reach = 0;
    return s;
}

/* Returns whether a window coordinate can be snapped; false for NaN. */
static inline bool can_snap(float v)
{
    return v < SNAPPED_LIMIT / 256 && v > -SNAPPED_LIMIT / 256;
}

/* Finds the pixels of the region in half-open ranges of snapped coordinates. The lower end belongs
 * to a range; the upper end does in y with upside_down. Returns false if there are none. */
static inline bool pixels_of_box(const pixel_rectangle *region, const int32_t low[2],
                                 const int32_t high[2], bool upside_down, pixel_rectangle *box)
{
    const int32_t up = upside_down ? 256 : 255;
    const int32_t min_x = (low[0] + 255) >> 8;
    const int32_t min_y = (low[1] + up) >> 8;
    const int32_t max_x = ((high[0] + 255) >> 8) - 1;
    const int32_t max_y = ((high[1] + up) >> 8) - 1;

    box->min_x = min_x > region->min_x ? min_x : region->min_x;
    box->min_y = min_y > region->min_y ? min_y : region->min_y;
    box->max_x = max_x < region->max_x ? max_x : region->max_x;
    box->max_y = max_y < region->max_y ? max_y : region->max_y;
    return box->min_x <= box->max_x && box->min_y <= box->max_y;
}

/* Returns the size of a point in 1/256 pixel. */
static inline int32_t size_of_point(const box_state *state, const stored_vertex *v)
{
    return state->program_point_size ? snap_size(v->point_size, GN_MAX_POINT_SIZE)
                                     : state->point_size;
}

/* Snaps a window coordinate: returns its distance from the centre of pixel 0, in 1/256 pixel. On
 * multisampled targets the reference rounds the distance from the pixel's corner. */
static inline int32_t snap_end(const box_state *state, float v)
{
    return is_multisampled(state) ? round_to_even(v * 256.0f) - 128
                                  : round_to_even((v - 0.5f) * 256.0f);
}

/* Finds the half-open ranges of a point in snapped coordinates. Returns false if there are none. */
static inline bool point_range(const box_state *state, const stored_vertex *v, int32_t low[2],
                               int32_t high[2])
{
    const int32_t size = size_of_point(state, v);

    for (int c = 0; c < 2; ++c) {
        if (!can_snap(v->window[c]))
            return false;
        low[c] = snap_end(state, v->window[c]) - size / 2;
        high[c] = low[c] + size;
    }
    return true;
}

/* Finds the pixels of a point; on a multisampled target, those that it may have. Returns false if
 * there are none. */
static inline bool point_box(const box_state *state, const pixel_rectangle *region,
                             const stored_vertex *v, pixel_rectangle *box)
{
    int32_t low[2], high[2];

    if (!point_range(state, v, low, high))
        return false;
    for (int c = 0; DRAWS_SAMPLES && c < 2; ++c) {
        low[c] -= state->reach;
        high[c] += state->reach;
    }
    return pixels_of_box(region, low, high, state->upside_down, box);
}

/* The middle of a line as it is drawn: its ends in snapped coordinates, the lesser one along the
 * major axis first. */
typedef struct line_middle {
    int32_t end[2][2]; /* [end][axis] */
    int major;         /* axis */
} line_middle;

static inline float pixel_fraction(float v)
{
    const float truncated = (float)(int32_t)v;

    return v - (truncated > v ? truncated - 1.0f : truncated);
}

static inline bool is_not_negative(float v)
{
    return v >= 0.0f;
}

/* An end of a line in its pixel: its distance from the pixel's centre along the major and the minor
 * axis, and where the line crosses the middle of the pixel, measured from the pixel's lower or left
 * side. */
typedef struct line_end {
    float major, minor;
    float crossing;
} line_end;

static inline line_end end_in_pixel(const stored_vertex *v, int major, float slope)
{
    const float minor = pixel_fraction(v->window[!major]);
    line_end e;

    e.major = pixel_fraction(v->window[major]) - 0.5f;
    e.minor = minor - 0.5f;
    e.crossing = minor + e.major * slope;
    return e;
}

static inline bool in_diamond(const line_end *e)
{
    const float major = e->major < 0.0f ? -e->major : e->major;
    const float minor = e->minor < 0.0f ? -e->minor : e->minor;

    return major + minor < 0.5f;
}

/* Returns whether two rules disagree about the pixel of an end: the diamond-exit rule (OpenGL 4.5
 * section 14.5.1) with ties as the reference decides them, and the plain quadrilateral. `along` and
 * `across` are the first end minus the second, along and across the major axis. */
static inline bool end_differs(const box_state *state, line_end *e, bool is_first, bool x_major,
                               float along, float across)
{
    const bool is_beyond =
        state->upside_down && !x_major ? is_not_negative(e->major) : e->major > 0.0f;
    const bool plain = (is_beyond == (along > 0.0f)) == is_first;

    if (!is_first && e->minor == -0.5f && across < 0.0f)
        e->minor = 0.5f;
    const bool same_side = is_not_negative(x_major ? e->major : -e->major) ==
                           is_not_negative(x_major ? -along : along);
    const bool other_side = is_not_negative(x_major ? -e->minor : e->minor) !=
                            is_not_negative(x_major ? across : -across);
    const bool owns_low = !is_first && !x_major;
    const bool crosses =
        (owns_low ? e->crossing >= 0.0f : e->crossing > 0.0f) && e->crossing < 1.0f;
    const bool drawn = in_diamond(e)            ? is_first
                       : same_side == is_first  ? false
                       : other_side == is_first ? true
                                                : crosses;

    return drawn != plain;
}

/* Finds the middle of a line. Returns false if nothing is drawn. If the diamond-exit rule and the
 * plain quadrilateral disagree about the pixel of an end, that end moves along the line to a side
 * of the pixel. */
GN_OUT_OF_LINE bool middle_of_line(const box_state *state, const stored_vertex *first,
                                   const stored_vertex *second, line_middle *m)
{
    const stored_vertex *const v[2] = {first, second};

    for (int c = 0; c < 2; ++c)
        if (!can_snap(first->window[c]) || !can_snap(second->window[c]))
            return false;
    const float dx = first->window[0] - second->window[0];
    const float dy = first->window[1] - second->window[1];
    if (dx == 0.0f && dy == 0.0f)
        return false;

    const bool x_major = (dx < 0.0f ? -dx : dx) >= (dy < 0.0f ? -dy : dy);
    const float along = x_major ? dx : dy;
    const float across = x_major ? dy : dx;
    const float slope = across / along;

    m->major = x_major ? 0 : 1;
    for (int i = 0; i < 2; ++i) {
        line_end e = end_in_pixel(v[i], m->major, slope);
        const float move = end_differs(state, &e, i == 0, x_major, along, across)
                               ? -e.major + (along > 0.0f ? 0.5f : -0.5f)
                               : 0.0f;
        int32_t *const end = m->end[along < 0.0f ? i : 1 - i];

        end[m->major] = round_to_even((v[i]->window[m->major] + move - 0.5f) * 256.0f);
        end[!m->major] = round_to_even((v[i]->window[!m->major] + move * slope - 0.5f) * 256.0f);
    }
    return true;
}

/* On a multisampled target a line is a rectangle, half its width to either side of its middle.
 * Finds the rectangle's corners in snapped coordinates, clockwise. Returns false if nothing is
 * drawn: a line so short that the square of its length is 0 has no direction. */
static inline bool line_corners(const box_state *state, const stored_vertex *first,
                                const stored_vertex *second, int32_t corner[4][2])
{
    const stored_vertex *const v[2] = {first, second};
    float length[LANES];
    int32_t across[2];

    for (int c = 0; c < 2; ++c)
        if (!can_snap(first->window[c]) || !can_snap(second->window[c]))
            return false;
    const float dx = first->window[0] - second->window[0];
    const float dy = first->window[1] - second->window[1];
    const float square = dx * dx + dy * dy;
    if (square == 0.0f)
        return false;
    lanes_store(length, lanes_sqrt(lanes_splat(square)));

    const float scale = state->width * 0.5f / length[0];
    across[0] = round_to_even(-dy * scale * 256.0f);
    across[1] = round_to_even(dx * scale * 256.0f);
    for (int i = 0; i < 2; ++i) {
        for (int c = 0; c < 2; ++c) {
            const int32_t middle = snap_end(state, v[i]->window[c]);

            corner[i][c] = middle - across[c];
            corner[3 - i][c] = middle + across[c];
        }
    }
    return true;
}

/* Finds the pixels of a multisampled target that a line may have. Returns false if there are none.
 */
static inline bool sampled_line_box(const box_state *state, const pixel_rectangle *region,
                                    const stored_vertex *first, const stored_vertex *second,
                                    pixel_rectangle *box)
{
    int32_t corner[4][2];
    int32_t low[2], high[2];

    if (!line_corners(state, first, second, corner))
        return false;
    for (int c = 0; c < 2; ++c) {
        low[c] = corner[0][c];
        high[c] = corner[0][c];
        for (int i = 1; i < 4; ++i) {
            low[c] = corner[i][c] < low[c] ? corner[i][c] : low[c];
            high[c] = corner[i][c] > high[c] ? corner[i][c] : high[c];
        }
        low[c] -= state->reach;
        high[c] += state->reach + 1;
    }
    return pixels_of_box(region, low, high, state->upside_down, box);
}

/* Finds the pixels that a line may have. Returns false if there are none. */
static inline bool line_box(const box_state *state, const pixel_rectangle *region,
                            const stored_vertex *first, const stored_vertex *second,
                            pixel_rectangle *box)
{
    line_middle m;
    int32_t low[2], high[2];

    if (is_multisampled(state))
        return sampled_line_box(state, region, first, second, box);
    if (!middle_of_line(state, first, second, &m))
        return false;
    low[m.major] = m.end[0][m.major];
    high[m.major] = m.end[1][m.major];
    const int32_t a = m.end[0][!m.major];
    const int32_t b = m.end[1][!m.major];
    low[!m.major] = (a < b ? a : b) - state->half_width;
    high[!m.major] = (a > b ? a : b) + state->half_width;
    return pixels_of_box(region, low, high, state->upside_down, box);
}

#endif
