/* Building one scene: the state of the draw in the making, its vertices and
 * indices, and the random source all of it comes from. */
#ifndef PARITY_BUILDER_H
#define PARITY_BUILDER_H

#include "random.h"
#include "scene.h"

typedef struct vertex {
    float position[4];
    float color[4];
    float normal[3];
    float texcoord[4];
    float tangent[4];
} vertex;

/* Stands for the index that restarts. */
#define BUILDER_RESTART UINT32_MAX

typedef struct builder {
    random_source random;
    scene *scene;

    /* Of the next draw; builder_draw resets all but the state. */
    gn_pipeline state;
    scene_shader shader;
    bool counted;
    scene_uniforms uniforms; /* of the texture's levels the first's texels, packed, alone */
    scene_surface surface;   /* as uniforms */
    bool has_tangents;
    gn_mat4 view_from_model;
    gn_vec3 specular;
    float clip_plane[GN_MAX_CLIP_DISTANCES][4];
    gn_index_format index_format; /* GN_INDEX_NONE: vertices are repeated as indices say */
    uint32_t color_components;    /* 0: the attribute is absent */
    uint32_t position_components;
    uint32_t texcoord_components;
    gn_restart restart; /* BUILDER_RESTART among the indices */
    uint32_t restart_index;
    int32_t base_vertex; /* not above the least index: indices are stored without it */
    uint32_t instance_count;
    uint32_t color_divisor;
    uint32_t lead;  /* elements before the first drawn one */
    uint32_t trail; /* elements after the last */

    vertex *vertices;
    uint32_t vertex_count, vertex_capacity;
    uint32_t *indices; /* none: the vertices in order */
    uint32_t index_count, index_capacity;
} builder;

/* Starts a scene; its target comes with one of the two calls below. */
void builder_begin(builder *b, uint64_t seed);

/* The finished scene. */
scene *builder_end(builder *b);

/* A target of the given size with random clear values. */
void builder_target(builder *b, uint32_t width, uint32_t height, gn_format color, gn_format depth);

/* A target of 16 to 128 pixels a side, RGBA8, any depth format or none; half of the
 * time its sides are powers of two, on which every placement is exact. */
void builder_common_target(builder *b);

/* Resets the state of the next draw; tests depth, mostly, where there is depth. */
void builder_common_state(builder *b);

/* The viewport the next draw will have. */
gn_viewport builder_viewport(const builder *b);

/* A new vertex with random colour, normal and texture coordinates, its position
 * (0, 0, 0, 1). The pointer is good until the next one. */
vertex *builder_vertex(builder *b);

void builder_index(builder *b, uint32_t index);

/* Sets the position that the viewport maps to window coordinates x, y, exactly where
 * half of its size and w are powers of two, and within 1e-5 of it otherwise; z is
 * the normalised device depth. */
void builder_place(const builder *b, vertex *v, float x, float y, float z, float w);

/* Adds the draw of the collected vertices and indices, and forgets them. */
void builder_draw(builder *b);

/* 1 to 200 triangles, about 40 in the mean. */
uint32_t builder_triangle_count(builder *b);

/* A random rotation, uniform over all orientations. */
gn_mat3 builder_rotation(builder *b);

#endif
