/* Models: triangles in plain arrays, whatever file they came from. */
#ifndef MODEL_H
#define MODEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "camera.h"
#include "shading.h"

/* A map that a material names: a file beside the model, or an image inside it. */
typedef struct model_texture {
    char *name;     /* as the material has it; null: none */
    uint8_t *bytes; /* an image file's contents, where the model carries it; else null */
    size_t size;
    bool bare; /* the model carries texels that are no image file */
} model_texture;

/* Highlights, where no map says otherwise. */
#define MODEL_MAX_EXPONENT 1024
typedef struct model_shine {
    float specular[3];
    uint32_t exponent; /* 1 to MODEL_MAX_EXPONENT */
} model_shine;

/* What is drawn in one go: the triangles that share their maps and highlights. */
typedef struct model_part {
    uint32_t vertex_count;
    float *positions; /* x, y, z */
    float *normals;   /* x, y, z, of any length but 0 */
    float *colors;    /* red, green, blue, alpha: the vertex's, the material's, or light grey */
    bool has_vertex_colors; /* the first of these */
    bool has_texcoords;
    float *texcoords; /* s, t; null where the file has none */
    bool has_tangents;
    float *tangents; /* x, y, z, and 1 or -1: the bitangent is that times normal x tangent. Null
                        where the file has no texture coordinates or no normals */
    uint32_t index_count;
    uint32_t *indices; /* three a triangle */
    model_shine shine;
    model_texture maps[MAP_COUNT]; /* the normals are in tangent space */
} model_part;

typedef struct model {
    size_t part_count;
    model_part *parts;
} model;

/* Allocates a part's arrays, texture coordinates and tangents where it is said to have them. False
 * where there is no memory; model_free frees what is there. */
bool model_part_allocate(model_part *part, uint32_t vertex_count, uint32_t index_count);

void model_free(model *m);

/* Gives a normal to every vertex whose normal is zero or not finite: the sum of the normals of
 * the triangles around its position, weighted by their angle there (Thürmer and Wüthrich,
 * "Computing Vertex Normals from Polygonal Facets", 1998), over all parts. Vertices count as
 * one where their positions are equal. False where there is no memory. */
bool model_complete_normals(model *m);

uint64_t model_triangle_count(const model *m);

/* A sphere around all vertices that triangles use: the centre is their bounding box's. */
bounding_sphere model_bounds(const model *m);

#endif
