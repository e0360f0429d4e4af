/* Builds one scene. A builder holds the state, the vertices and the indices of the next draw, and
 * the random source of them all. */
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

/* Stands for the restart index among a builder's indices. */
#define BUILDER_RESTART UINT32_MAX

typedef struct builder {
    random_source random;
    scene *scene;
    bool metallic; /* half of the varied draws have SCENE_METALLIC_ROUGHNESS */

    /* The members below belong to the next draw; builder_draw resets all but the state. */
    gn_pipeline state;
    scene_shader shader;
    bool counted;
    scene_uniforms
        uniforms; /* only the texture's level[0].texels is set; all levels are packed there */
    scene_surface surface; /* maps as uniforms.texture */
    bool has_tangents;
    gn_mat4 view_from_model;
    gn_vec3 specular;
    float clip_plane[GN_MAX_CLIP_DISTANCES][4];
    gn_index_format
        index_format; /* GN_INDEX_NONE: vertices are written out as the indices name them */
    uint32_t color_components; /* 0: the attribute is absent */
    uint32_t position_components;
    uint32_t texcoord_components;
    gn_restart restart; /* how BUILDER_RESTART among the indices is stored */
    uint32_t restart_index;
    int32_t base_vertex; /* at most the least index: it is subtracted from stored indices */
    uint32_t instance_count;
    uint32_t color_divisor;
    uint32_t lead;  /* elements before the first drawn one */
    uint32_t trail; /* elements after the last drawn one */

    vertex *vertices;
    uint32_t vertex_count, vertex_capacity;
    uint32_t *indices; /* without indices: the vertices in order */
    uint32_t index_count, index_capacity;
} builder;

/* Starts a scene. One of the two calls below adds its target. */
void builder_begin(builder *b, uint64_t seed);

/* Returns the finished scene. */
scene *builder_end(builder *b);

/* Adds a target of this size, with random clear values. */
void builder_target(builder *b, uint32_t width, uint32_t height, gn_format color, gn_format depth);

/* Adds a target of 16 to 128 pixels a side, RGBA8, with any depth format or none. Half of the time
 * its sides are powers of two, for which every placement is exact. */
void builder_common_target(builder *b);

/* Resets the state of the next draw. If there is depth, the depth test is mostly on. */
void builder_common_state(builder *b);

/* Returns the viewport of the next draw. */
gn_viewport builder_viewport(const builder *b);

/* Returns a new vertex with random colour, normal and texture coordinates, at position (0, 0, 0,
 * 1). The pointer is valid until the next call. */
vertex *builder_vertex(builder *b);

void builder_index(builder *b, uint32_t index);

/* Sets the position that the viewport maps to window coordinates x, y: exactly, if half of the
 * viewport's size and w are powers of two, otherwise within 1e-5. z is the normalised device
 * depth. */
void builder_place(const builder *b, vertex *v, float x, float y, float z, float w);

/* Adds the draw of the collected vertices and indices, and clears them. Without vertices nothing is
 * added, and the state stays for the next draw, but for textures and maps. */
void builder_draw(builder *b);

/* Returns 1 to 200 triangles, about 40 on average. */
uint32_t builder_triangle_count(builder *b);

/* Returns a random rotation, uniform over all orientations. */
gn_mat3 builder_rotation(builder *b);

#endif
