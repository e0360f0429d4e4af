/* Primitives that have been taken through the stages of primitives
 * (render_mode/primitive_stages.h), so that their vertices are in the window: they wait, and are
 * drawn together. */
#ifndef OSMESA_WINDOW_PRIMITIVES_H
#define OSMESA_WINDOW_PRIMITIVES_H

#include "../render_mode/shaded_vertices.h"

/* What alpha is multiplied by: nothing, or how much of a fragment a smooth line or point covers.
 * Its four varyings, COVERAGE_VARYINGS, come after the program's. */
typedef enum coverage_kind { WHOLE_COVERAGE, LINE_COVERAGE, POINT_COVERAGE } coverage_kind;

enum { COVERAGE_VARYINGS = 4 };

typedef struct window_primitives {
    context *gl;
    const char *function; /* of OpenGL, for its errors */
    gn_topology topology; /* of those that wait: GN_POINTS, GN_LINES or GN_TRIANGLES */
    coverage_kind coverage;
    bool is_multisampled;
    shaded_vertex *vertex;
    uint32_t count;

    /* Once a triangle comes, the pattern of polygons (glPolygonStipple) applies to the lines and
     * points of the draw, too, as in the reference. */
    bool has_triangle;
} window_primitives;

/* Returns false, with an error, if memory is short. */
bool begin_window_primitives(window_primitives *p, context *gl, const char *function);

/* Returns the place of the vertices of the next primitive: one for each corner. */
shaded_vertex *add_window_primitive(window_primitives *p, const placement *place,
                                    gn_topology topology, coverage_kind coverage);

/* Draws the primitives that wait; none is left. */
void draw_waiting(window_primitives *p, const placement *place);

#endif
