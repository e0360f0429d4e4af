#include "stippled_lines.h"

#include <gl_registry.h>
#include <math.h>

#include "smooth_primitives.h"

enum { PATTERN_BITS = 16 };

/* No line in a viewport is longer. */
#define MOST_LENGTH (4.0f * (float)GN_MAX_SIZE)

/* As in the reference, everything is linear in the window here. */
static void set_on_line(const shaded_vertex *a, const shaded_vertex *b, GLfloat t, shaded_vertex *v)
{
    for (int i = 0; i < 4; ++i)
        v->window[i] = a->window[i] + t * (b->window[i] - a->window[i]);
    for (int i = 0; i < GN_MAX_VARYINGS; ++i)
        v->varying[i] = a->varying[i] + t * (b->varying[i] - a->varying[i]);
}

static void add_piece(window_primitives *p, const placement *place, const shaded_vertex *a,
                      const shaded_vertex *b, GLfloat begin, GLfloat end)
{
    shaded_vertex piece[2] = {*a, *b};

    if (begin > 0.0f)
        set_on_line(a, b, begin, &piece[0]);
    if (end < 1.0f)
        set_on_line(a, b, end, &piece[1]);
    add_window_line(p, place, &piece[0], &piece[1]);
}

static bool has_bit(const raster_state *r, int place)
{
    return r->stipple_pattern >> (place / r->stipple_factor % PATTERN_BITS) & 1;
}

/* Returns a line's length in pixels of the pattern: those along its longer axis, or along the line
 * itself where it is smooth or has several samples. */
static GLfloat pattern_length(const window_primitives *p, const shaded_vertex *a,
                              const shaded_vertex *b)
{
    const GLfloat x = fabsf(b->window[0] - a->window[0]), y = fabsf(b->window[1] - a->window[1]);

    return p->is_multisampled || p->gl->raster.line_smooth ? sqrtf(x * x + y * y) : x > y ? x : y;
}

void stipple_line(window_primitives *p, const placement *place, const shaded_vertex *a,
                  const shaded_vertex *b, bool begins_pattern)
{
    GLint *const counter = &p->gl->stipple_counter;
    const raster_state *const r = &p->gl->raster;
    const GLfloat length = pattern_length(p, a, b);
    GLfloat begin = 0.0f;
    bool is_on = false;

    if (begins_pattern)
        *counter = 0;
    if (!(length <= MOST_LENGTH))
        return;
    const int pixels = (int)ceilf(length);
    for (int i = 0; i < pixels; ++i) {
        const bool bit = has_bit(r, *counter + i);

        if (bit == is_on)
            continue;
        if (is_on)
            add_piece(p, place, a, b, begin / length, (GLfloat)i / length);
        else
            begin = (GLfloat)i;
        is_on = bit;
    }
    if (is_on && begin < length)
        add_piece(p, place, a, b, begin / length, 1.0f);
    *counter += pixels;
    /* Before it overflows, whole patterns are left out: a later line may have another factor. */
    if (*counter > INT32_MAX / 2)
        *counter %= r->stipple_factor * PATTERN_BITS;
}
