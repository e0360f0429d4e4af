/* Vertices after the vertex shader of the fixed function, and how they are cut to the view volume
 * (OpenGL 2.1 sections 2.11 and 2.12). Places and varyings have the bits of those that are drawn.
 */
#ifndef OSMESA_SHADED_VERTICES_H
#define OSMESA_SHADED_VERTICES_H

#include "../draw/fixed_function.h"

typedef struct shaded_vertex {
    GLfloat clip[4];
    GLfloat window[4]; /* x, y in rows of the target, z, 1 / w */
    GLfloat varying[GN_MAX_VARYINGS];
    GLfloat point_size; /* not rounded */
    uint32_t outside;   /* bits of the planes that cut it off: six of the volume, the program's */
} shaded_vertex;

enum { VOLUME_PLANES = 6 };

/* What places vertices and cuts them. */
typedef struct placement {
    const fixed_function *fixed;
    const gn_program *program;
    GLfloat scale[3], translation[3]; /* to the window */
    bool is_zero_to_one;              /* clip depths */
    int coordinate_varying;           /* the first of the texture coordinates of unit 0 */
    bool copies_coordinate;           /* which are the vertices' own */
} placement;

/* Derives the placement of a draw. Adds varyings for the texture coordinates of unit 0 to the
 * program, if it has none. */
void set_placement(const context *gl, const fixed_function *fixed, gn_program *program,
                   placement *place);

/* Runs the vertex shader over all vertices of a mesh, 1 or more. Returns them in the context's
 * scratch; null if memory is short. */
shaded_vertex *shade_vertices(context *gl, const placement *place, const gn_mesh *mesh,
                              const char *function);

/* Returns the signed distance from a plane, a number as in the bits of `outside`. */
GLfloat plane_distance(const placement *place, const shaded_vertex *v, uint32_t plane);

/* Sets a vertex between `from` and `to`, a fraction of the way. Flat varyings are left alone. */
void set_vertex_between(const placement *place, const shaded_vertex *from, const shaded_vertex *to,
                        GLfloat fraction, shaded_vertex *v);

/* Copies the flat varyings of a vertex. */
void copy_flat_varyings(const placement *place, const shaded_vertex *from, shaded_vertex *to);

#endif
