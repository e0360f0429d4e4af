/* Names of what the stages read: attributes, varyings, uniforms, texels. */
#ifndef EXPLAIN_NAMES_H
#define EXPLAIN_NAMES_H

#include <gnomon.h>

#include "graph.h"

/* Learns the uniforms and maps of a draw with a ready-made shader; of other shaders nothing is
 * known. Tells them as a stage of the report. */
void names_of_draw(const gn_pipeline *pipeline);

/* Tells the matrix to world coordinates, unless names_of_draw has, and that to view coordinates. */
void names_add_world(const gn_mat4 *world_from_model, const gn_mat4 *view_from_world);

/* Returns the name of attribute a, component c: "position.x". */
const char *names_attribute(uint32_t a, uint32_t c);

/* Returns the name of varying n: "red". */
const char *names_varying(uint32_t n);

/* Returns the name of a matrix of the uniforms by its address, "" if it is none. */
const char *names_matrix(const void *matrix);

/* Returns the name of a vector or colour of the uniforms by its bits, "" if it is none. */
const char *names_vector(gn_vec3 v);

/* Returns the name of a map, "texture" if it is not known. */
const char *names_map(const gn_texture *map);

/* Returns the name of the texel at an address, "texel (x, y) of level n of the diffuse map"; "" if
 * the address is in no map. `is_float` receives whether it is a float. */
const char *names_texel(const void *address, bool *is_float);

#endif
