/* The ready-made vertex shaders over lanes, and the order of their varyings. Compiled for each back
 * end, and once for the functions that a pipeline points to (src/shaders/shaders.c). */
#ifndef GN_KERNEL_SHADERS_VERTEX_INL
#define GN_KERNEL_SHADERS_VERTEX_INL

#include <gnomon/shaders.h>

#include "lighting.inl"
#include "ready_made.h"

/* The order of varyings, which gnomon/shaders.h documents. */
enum {
    VARYING_RED,
    VARYING_ALPHA = 3,
    VARYING_S,
    VARYING_T,
    VARYING_NORMAL, /* in world space, as are the following ones */
    VARYING_PLACE = VARYING_NORMAL + 3,
    VARYING_TANGENT = VARYING_PLACE + 3,
    VARYING_HANDEDNESS = VARYING_TANGENT + 3
};

/* How many of them a shader uses: of a colour, with a map, of a lit surface, with tangents. */
enum {
    COLOR_VARYINGS = VARYING_S,
    MAPPED_VARYINGS = VARYING_NORMAL,
    SURFACE_VARYINGS = VARYING_TANGENT,
    TANGENT_VARYINGS = VARYING_HANDEDNESS + 1
};

typedef char shader_varyings_are_as_stated[TANGENT_VARYINGS == GN_SHADER_VARYINGS ? 1 : -1];

static inline bool has_tangents(const gn_material *material)
{
    return material->normal_map && material->normal_space == GN_NORMAL_OF_TANGENTS;
}

static inline void load_position(const gn_vertex_input *input, lanes_f position[4])
{
    GN_UNROLLED
    for (int c = 0; c < 4; ++c)
        position[c] = lanes_load(input->attribute[GN_ATTRIBUTE_POSITION][c]);
}

static inline void write_clip_position(const gn_mat4 *clip_from_model, const gn_vertex_input *input,
                                       gn_vertex_output *output)
{
    lanes_f position[4], clip[4];

    load_position(input, position);
    transform(clip_from_model, position, 4, clip);
    GN_UNROLLED
    for (int c = 0; c < 4; ++c)
        lanes_store(output->position[c], clip[c]);
}

/* Loads the vertex colours; white if the mesh has none. */
static inline void load_color(const gn_vertex_input *input, lanes_f color[4])
{
    GN_UNROLLED
    for (int c = 0; c < 4; ++c)
        color[c] = input->present >> GN_ATTRIBUTE_COLOR & 1
                       ? lanes_load(input->attribute[GN_ATTRIBUTE_COLOR][c])
                       : lanes_splat(1.0f);
}

static inline void store_color(const lanes_f color[4], gn_vertex_output *output)
{
    GN_UNROLLED
    for (int c = 0; c < 4; ++c)
        lanes_store(output->varying[VARYING_RED + c], color[c]);
}

static inline void copy_texcoord(const gn_vertex_input *input, gn_vertex_output *output)
{
    lanes_store(output->varying[VARYING_S], lanes_load(input->attribute[GN_ATTRIBUTE_TEXCOORD][0]));
    lanes_store(output->varying[VARYING_T], lanes_load(input->attribute[GN_ATTRIBUTE_TEXCOORD][1]));
}

static inline void shade_vertex_position(const void *uniforms, const gn_vertex_input *input,
                                         gn_vertex_output *output)
{
    const gn_color_uniforms *u = (const gn_color_uniforms *)uniforms;

    write_clip_position(&u->clip_from_model, input, output);
}

/* The vertex shader without a light. Texture coordinates are written only if `map` is not null. */
static inline void shade_plain(const gn_mat4 *clip_from_model, const gn_texture *map,
                               const gn_vertex_input *input, gn_vertex_output *output)
{
    lanes_f color[4];

    write_clip_position(clip_from_model, input, output);
    load_color(input, color);
    store_color(color, output);
    if (map)
        copy_texcoord(input, output);
}

static inline void shade_vertex_color(const void *uniforms, const gn_vertex_input *input,
                                      gn_vertex_output *output)
{
    const gn_color_uniforms *u = (const gn_color_uniforms *)uniforms;

    shade_plain(&u->clip_from_model, 0, input, output);
}

static inline void shade_vertex_unlit(const void *uniforms, const gn_vertex_input *input,
                                      gn_vertex_output *output)
{
    const gn_unlit_uniforms *u = (const gn_unlit_uniforms *)uniforms;

    shade_plain(&u->clip_from_model, u->map, input, output);
}

/* Writes the normal in world space; 0 if the mesh has none. */
static inline void load_normal(const gn_mat3 *normal_matrix, const gn_vertex_input *input,
                               lanes_f normal[3])
{
    lanes_f of_model[3];

    load_vector(input->attribute[GN_ATTRIBUTE_NORMAL], of_model);
    turn_by_mat3(normal_matrix, of_model, normal);
}

/* Returns the number of lights after the first. */
static inline uint32_t more_lights(const gn_lit_uniforms *u)
{
    return GN_HAVE_POINT_LIGHTS ? u->more_light_count : 0;
}

/* Adds what a vertex receives from the lights after the first. */
GN_OUT_OF_LINE void receive_more_lights(const gn_lit_uniforms *u, const gn_vertex_input *input,
                                        const lanes_f normal[3], lanes_f received[3])
{
    lanes_f position[4], place[4], to_light[3], remaining;

    load_position(input, position);
    transform(&u->world_from_model, position, 3, place);
    for (uint32_t i = 0; i < more_lights(u); ++i) {
        light_at(&u->more_lights[i], place, to_light, &remaining);
        receive_more(&u->more_lights[i], lanes_mul(above_zero(dot(normal, to_light)), remaining),
                     received);
    }
}

/* The vertex shader of gn_use_gouraud. */
static inline void shade_vertex_lit(const void *uniforms, const gn_vertex_input *input,
                                    gn_vertex_output *output)
{
    const gn_lit_uniforms *u = (const gn_lit_uniforms *)uniforms;
    lanes_f normal[3], to_light[3], color[4], received[3], remaining;
    lanes_f position[4], place[4];

    write_clip_position(&u->clip_from_model, input, output);
    load_normal(&u->normal_matrix, input, normal);
    normalize(normal);
    if (has_position(&u->light)) {
        load_position(input, position);
        transform(&u->world_from_model, position, 3, place);
    }
    light_at(&u->light, place, to_light, &remaining);
    receive_light(&u->light, lanes_mul(above_zero(dot(normal, to_light)), remaining), received);
    if (more_lights(u) > 0) {
        /* Copies, so that the originals stay in registers. */
        lanes_f turned[3], sum[3];

        copy_vector(normal, turned);
        copy_vector(received, sum);
        receive_more_lights(u, input, turned, sum);
        copy_vector(sum, received);
    }
    load_color(input, color);
    multiply_color(color, received);
    store_color(color, output);
    if (u->material.diffuse_map)
        copy_texcoord(input, output);
}

/* Writes all varyings of a surface. Normals and tangents get length one, so that interpolation
 * weighs all vertices alike. */
static inline void place_surface(const gn_mat4 *clip_from_model, const gn_mat4 *world_from_model,
                                 const gn_mat3 *normal_matrix, bool tangents,
                                 const gn_vertex_input *input, gn_vertex_output *output)
{
    lanes_f position[4], place[4], color[4], vector[3], turned[3];

    write_clip_position(clip_from_model, input, output);
    load_color(input, color);
    store_color(color, output);
    copy_texcoord(input, output);
    load_normal(normal_matrix, input, vector);
    normalize_or_zero(vector);
    store_vector(vector, &output->varying[VARYING_NORMAL]);
    load_position(input, position);
    transform(world_from_model, position, 3, place);
    store_vector(place, &output->varying[VARYING_PLACE]);
    if (!tangents)
        return;
    load_vector(input->attribute[GN_ATTRIBUTE_TANGENT], vector);
    turn_by_mat4(world_from_model, vector, turned);
    normalize_or_zero(turned);
    store_vector(turned, &output->varying[VARYING_TANGENT]);
    lanes_store(output->varying[VARYING_HANDEDNESS],
                lanes_load(input->attribute[GN_ATTRIBUTE_TANGENT][3]));
}

/* The vertex shader of the lit shaders that light fragments. */
static inline void shade_vertex_surface(const void *uniforms, const gn_vertex_input *input,
                                        gn_vertex_output *output)
{
    const gn_lit_uniforms *u = (const gn_lit_uniforms *)uniforms;

    place_surface(&u->clip_from_model, &u->world_from_model, &u->normal_matrix,
                  has_tangents(&u->material), input, output);
}

/* The vertex shader of gn_use_metallic_roughness. */
static inline void shade_vertex_metallic(const void *uniforms, const gn_vertex_input *input,
                                         gn_vertex_output *output)
{
    const gn_metallic_roughness_uniforms *u = (const gn_metallic_roughness_uniforms *)uniforms;

    place_surface(&u->clip_from_model, &u->world_from_model, &u->normal_matrix,
                  u->material.normal_map.texture != 0, input, output);
}

#endif
