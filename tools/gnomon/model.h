/* Models: triangles in plain arrays, whatever file they come from. */
#ifndef MODEL_H
#define MODEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <gnomon.h>

#include "camera.h"
#include "shading.h"

/* A map that a material names: a file beside the model, or an image inside it. */
typedef struct model_texture {
    char *name;     /* as the material names it; null: no map */
    uint8_t *bytes; /* the contents of an image file inside the model; otherwise null */
    size_t size;
    bool bare; /* the model holds texels that are not an image file */
} model_texture;

/* Highlights, unless a map overrides them. */
#define MODEL_MAX_EXPONENT 1024
typedef struct model_shine {
    float specular[3];
    uint32_t exponent; /* 1 to MODEL_MAX_EXPONENT */
} model_shine;

/* A part is drawn in one draw: the triangles that share maps and highlights. */
typedef struct model_part {
    uint32_t vertex_count;
    float *positions; /* x, y, z */
    bool has_normals; /* in the file; otherwise they are computed */
    float *normals;   /* x, y, z, of any length except 0 */
    float *colors;    /* red, green, blue, alpha: the vertex's, the material's, or light grey */
    bool has_vertex_colors; /* the first of these colours */
    bool has_texcoords;
    float *texcoords; /* s, t; null if the file has none */
    bool has_tangents;
    float *tangents; /* x, y, z, and 1 or -1: the bitangent is that number times normal x tangent.
                        Null if the file has no texture coordinates or no normals */
    uint32_t index_count;
    uint32_t *indices; /* three per triangle */
    model_shine shine;
    model_texture maps[MAP_COUNT]; /* the normals are in tangent space */
    gn_transform world_from_model; /* where the part is drawn */
} model_part;

typedef struct model {
    size_t part_count;
    model_part *parts;
    uint32_t material_count; /* of the file, used by triangles */
} model;

/* Allocates a part's arrays and places it where its model is; texture coordinates and tangents only
 * if has_texcoords and has_tangents ask for them. Returns false if there is not enough memory;
 * model_free frees what was allocated. */
bool model_part_allocate(model_part *part, uint32_t vertex_count, uint32_t index_count);

void model_free(model *m);

/* Gives a normal to every vertex whose normal is zero or not finite: the sum of the normals of the
 * triangles around its position, weighted by their angles there (Thürmer and Wüthrich, "Computing
 * Vertex Normals from Polygonal Facets", 1998), over all parts. Vertices with equal positions count
 * as one. Returns false if there is not enough memory. */
bool model_complete_normals(model *m);

uint64_t model_triangle_count(const model *m);

/* The bounding box of all vertices that triangles use, in the world. */
void model_box(const model *m, double low[3], double high[3]);

/* Returns a sphere around all vertices that triangles use, in the world; its centre is the centre
 * of their bounding box. */
bounding_sphere model_bounds(const model *m);

#endif
