/* Models: triangles in plain arrays, whatever file they came from. */
#ifndef MODEL_H
#define MODEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "camera.h"

/* The texture a material names: a file beside the model, or an image inside it. */
typedef struct model_texture {
    char *name;     /* as the material has it; null: none */
    uint8_t *bytes; /* an image file's contents, where the model carries it; else null */
    size_t size;
} model_texture;

/* What is drawn in one go: the triangles that share a texture. */
typedef struct model_part {
    uint32_t vertex_count;
    float *positions; /* x, y, z */
    float *normals;   /* x, y, z, of any length but 0 */
    float *colors;    /* red, green, blue, alpha: the vertex's, the material's, or light grey */
    bool has_vertex_colors; /* the first of these */
    bool has_texcoords;
    float *texcoords; /* s, t; null where the file has none */
    uint32_t index_count;
    uint32_t *indices; /* three a triangle */
    model_texture texture;
} model_part;

typedef struct model {
    size_t part_count;
    model_part *parts;
} model;

/* Reads a file with Assimp: node transforms applied, polygons made triangles, points and
 * lines left out, missing normals computed. 0, or EXIT_FAULT with the reason printed. */
int model_read(const char *path, model *result);

/* Allocates a part's arrays. False where there is no memory; model_free frees what is there. */
bool model_part_allocate(model_part *part, uint32_t vertex_count, uint32_t index_count,
                         bool with_texcoords);

void model_free(model *m);

/* Gives a normal to every vertex whose normal is zero or not finite: the sum of the normals of
 * the triangles around its position, weighted by their angle there (Thürmer and Wüthrich,
 * "Computing Vertex Normals from Polygonal Facets", 1998), over all parts. Vertices count as
 * one where their positions are equal. False where there is no memory. */
bool model_complete_normals(model *m);

/* Gives every triangle vertices of its own with the triangle's normal, on the side the old
 * normals are on. False where there is no memory; the model is then unchanged. */
bool model_facet(model *m);

uint64_t model_triangle_count(const model *m);

/* A sphere around all vertices that triangles use: the centre is their bounding box's. */
bounding_sphere model_bounds(const model *m);

#endif
