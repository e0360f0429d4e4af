/* Saves and restores groups of state. */
#include "attribute_stacks.h"

#include <gl_registry.h>
#include <stdlib.h>
#include <string.h>

#include "gl_errors.h"
#include "object_names.h"
#include "state_table.h"
#include "../lighting/color_material.h"
#include "../textures/texture_objects.h"
#include "../vertices/buffer_objects.h"

/* A member of the context, and the groups that save it (OpenGL 2.1 table 6.5 and following). What
 * glEnable sets belongs to GL_ENABLE_BIT, too: state_table.c lists it. */
typedef struct saved_member {
    GLbitfield groups;
    size_t offset, size;
} saved_member;

#define MEMBER(groups, member)                                                                     \
    {                                                                                              \
        groups, offsetof(context, member), sizeof((context *)NULL)->member                         \
    }

static const saved_member members[] = {
    MEMBER(GL_CURRENT_BIT, current),
    MEMBER(GL_CURRENT_BIT, raster_position),

    MEMBER(GL_POINT_BIT, raster.point_size),
    MEMBER(GL_POINT_BIT, raster.point_size_min),
    MEMBER(GL_POINT_BIT, raster.point_size_max),
    MEMBER(GL_POINT_BIT, raster.point_fade_threshold),
    MEMBER(GL_POINT_BIT, raster.point_attenuation),
    MEMBER(GL_POINT_BIT, raster.point_smooth),

    MEMBER(GL_LINE_BIT, raster.line_width),
    MEMBER(GL_LINE_BIT, raster.stipple_factor),
    MEMBER(GL_LINE_BIT, raster.stipple_pattern),
    MEMBER(GL_LINE_BIT, raster.line_smooth),
    MEMBER(GL_LINE_BIT, raster.line_stipple),

    MEMBER(GL_POLYGON_BIT, raster.polygon_smooth),
    MEMBER(GL_POLYGON_BIT, raster.polygon_stipple),
    MEMBER(GL_POLYGON_BIT, raster.cull),
    MEMBER(GL_POLYGON_BIT, raster.cull_face),
    MEMBER(GL_POLYGON_BIT, raster.front_face),
    MEMBER(GL_POLYGON_BIT, raster.polygon_mode),
    MEMBER(GL_POLYGON_BIT, raster.offset_fill),
    MEMBER(GL_POLYGON_BIT, raster.offset_line),
    MEMBER(GL_POLYGON_BIT, raster.offset_point),
    MEMBER(GL_POLYGON_BIT, raster.offset_factor),
    MEMBER(GL_POLYGON_BIT, raster.offset_units),

    MEMBER(GL_POLYGON_STIPPLE_BIT, polygon_pattern),

    MEMBER(GL_PIXEL_MODE_BIT, fragment.read_buffer),
    MEMBER(GL_PIXEL_MODE_BIT, pixel_zoom),
    MEMBER(GL_PIXEL_MODE_BIT, transfer),

    MEMBER(GL_LIGHTING_BIT, lighting.enabled),
    MEMBER(GL_LIGHTING_BIT, lighting.color_material),
    MEMBER(GL_LIGHTING_BIT, lighting.local_viewer),
    MEMBER(GL_LIGHTING_BIT, lighting.two_side),
    MEMBER(GL_LIGHTING_BIT, lighting.color_material_face),
    MEMBER(GL_LIGHTING_BIT, lighting.color_material_mode),
    MEMBER(GL_LIGHTING_BIT, lighting.color_control),
    MEMBER(GL_LIGHTING_BIT, lighting.shade_model),
    MEMBER(GL_LIGHTING_BIT, lighting.ambient),
    MEMBER(GL_LIGHTING_BIT, lighting.light),
    MEMBER(GL_LIGHTING_BIT, lighting.material),
    MEMBER(GL_LIGHTING_BIT, clamp_vertex_color),
    MEMBER(GL_LIGHTING_BIT, provoking_vertex),

    MEMBER(GL_FOG_BIT, fog),

    MEMBER(GL_DEPTH_BUFFER_BIT, fragment.depth_test),
    MEMBER(GL_DEPTH_BUFFER_BIT, fragment.depth_function),
    MEMBER(GL_DEPTH_BUFFER_BIT, fragment.depth_mask),
    MEMBER(GL_DEPTH_BUFFER_BIT, fragment.clear_depth),

    MEMBER(GL_ACCUM_BUFFER_BIT, fragment.clear_accumulation),

    MEMBER(GL_STENCIL_BUFFER_BIT, fragment.stencil_test),
    MEMBER(GL_STENCIL_BUFFER_BIT, fragment.stencil),
    MEMBER(GL_STENCIL_BUFFER_BIT, fragment.clear_stencil),

    MEMBER(GL_VIEWPORT_BIT, transform.viewport),
    MEMBER(GL_VIEWPORT_BIT, transform.depth_range),

    MEMBER(GL_TRANSFORM_BIT, transform.mode),
    MEMBER(GL_TRANSFORM_BIT, transform.clip_origin),
    MEMBER(GL_TRANSFORM_BIT, transform.clip_depth),
    MEMBER(GL_TRANSFORM_BIT, transform.clip_plane_enabled),
    MEMBER(GL_TRANSFORM_BIT, transform.clip_plane),
    MEMBER(GL_TRANSFORM_BIT, transform.normalize),
    MEMBER(GL_TRANSFORM_BIT, transform.rescale_normal),

    MEMBER(GL_COLOR_BUFFER_BIT, fragment.alpha_test),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.alpha_function),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.alpha_reference),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.blend),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.blend_source),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.blend_destination),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.blend_alpha_source),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.blend_alpha_destination),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.blend_equation),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.blend_alpha_equation),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.blend_color),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.dither),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.logic_operation),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.index_logic_operation),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.logic_function),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.framebuffer_srgb),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.color_mask),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.index_mask),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.clear_color),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.clear_index),
    MEMBER(GL_COLOR_BUFFER_BIT, fragment.draw_buffer),
    MEMBER(GL_COLOR_BUFFER_BIT, clamp_fragment_color),
    MEMBER(GL_COLOR_BUFFER_BIT, clamp_read_color),

    MEMBER(GL_EVAL_BIT, evaluator),
    MEMBER(GL_HINT_BIT, hint),
    MEMBER(GL_LIST_BIT, list.base),

    MEMBER(GL_SCISSOR_BIT, fragment.scissor),
    MEMBER(GL_SCISSOR_BIT, fragment.scissor_box),

    MEMBER(GL_TEXTURE_BIT, active_texture),

    MEMBER(GL_MULTISAMPLE_BIT, fragment.multisample),
    MEMBER(GL_MULTISAMPLE_BIT, fragment.alpha_to_coverage),
    MEMBER(GL_MULTISAMPLE_BIT, fragment.alpha_to_one),
    MEMBER(GL_MULTISAMPLE_BIT, fragment.sample_coverage),
    MEMBER(GL_MULTISAMPLE_BIT, fragment.sample_coverage_value),
    MEMBER(GL_MULTISAMPLE_BIT, fragment.sample_coverage_invert),
};

/* Parameters of a texture object lie together, before its images. */
enum {
    PARAMETERS = offsetof(texture_object, minify),
    PARAMETERS_SIZE = offsetof(texture_object, image) - PARAMETERS
};

/* What glPushAttrib saves. Textures that are bound have a reference more. */
struct saved_attributes {
    GLbitfield groups;
    GLboolean enabled[MOST_SWITCHES];
    texture_unit unit[TEXTURE_UNITS];
    unsigned char parameters[TEXTURE_UNITS][TEXTURE_TARGETS][PARAMETERS_SIZE];
    unsigned char values[]; /* of members, one after another */
};

/* What glPushClientAttrib saves. Buffers that are bound have a reference more. */
struct saved_client_attributes {
    GLbitfield groups;
    pixel_store pack, unpack;
    array_state arrays;
};

enum { MEMBERS = sizeof members / sizeof *members };

static size_t values_size(GLbitfield groups)
{
    size_t size = 0;

    for (int i = 0; i < MEMBERS; ++i)
        size += members[i].groups & groups ? members[i].size : 0;
    return size;
}

/* Textures */

static void save_textures(const context *gl, saved_attributes *saved)
{
    for (int u = 0; u < TEXTURE_UNITS; ++u) {
        saved->unit[u] = gl->unit[u];
        for (int t = 0; t < TEXTURE_TARGETS; ++t) {
            texture_object *const texture = saved->unit[u].bound[t];

            ++texture->references;
            memcpy(saved->parameters[u][t], (unsigned char *)texture + PARAMETERS, PARAMETERS_SIZE);
        }
    }
}

static void drop_textures(saved_attributes *saved)
{
    for (int u = 0; u < TEXTURE_UNITS; ++u)
        for (int t = 0; t < TEXTURE_TARGETS; ++t)
            refer_to_texture(&saved->unit[u].bound[t], NULL);
}

/* A texture whose name was deleted is not bound again. */
static void restore_textures(context *gl, saved_attributes *saved)
{
    for (int u = 0; u < TEXTURE_UNITS; ++u) {
        texture_object *bound[TEXTURE_TARGETS];

        memcpy(bound, gl->unit[u].bound, sizeof bound);
        for (int t = 0; t < TEXTURE_TARGETS; ++t) {
            texture_object *const texture = saved->unit[u].bound[t];

            if (texture->name && find_object(gl->shared->textures, texture->name) != texture)
                continue;
            memcpy((unsigned char *)texture + PARAMETERS, saved->parameters[u][t], PARAMETERS_SIZE);
            refer_to_texture(&bound[t], texture);
        }
        gl->unit[u] = saved->unit[u];
        memcpy(gl->unit[u].bound, bound, sizeof bound);
    }
}

/* Attributes */

static void save_attributes(context *gl, saved_attributes *saved)
{
    unsigned char *to = saved->values;
    GLboolean *places[MOST_SWITCHES];

    for (int i = 0; i < MEMBERS; ++i) {
        if (!(members[i].groups & saved->groups))
            continue;
        memcpy(to, (const unsigned char *)gl + members[i].offset, members[i].size);
        to += members[i].size;
    }
    if (saved->groups & GL_ENABLE_BIT) {
        const size_t count = switch_places(gl, places);

        for (size_t i = 0; i < count; ++i)
            saved->enabled[i] = *places[i];
    }
    if (saved->groups & GL_TEXTURE_BIT)
        save_textures(gl, saved);
}

static void restore_attributes(context *gl, saved_attributes *saved)
{
    const unsigned char *from = saved->values;
    GLboolean *places[MOST_SWITCHES];

    for (int i = 0; i < MEMBERS; ++i) {
        if (!(members[i].groups & saved->groups))
            continue;
        memcpy((unsigned char *)gl + members[i].offset, from, members[i].size);
        from += members[i].size;
    }
    if (saved->groups & GL_TEXTURE_BIT)
        restore_textures(gl, saved);
    if (saved->groups & GL_ENABLE_BIT) {
        const size_t count = switch_places(gl, places);

        for (size_t i = 0; i < count; ++i)
            *places[i] = saved->enabled[i];
    }
}

static void free_attributes(saved_attributes *saved)
{
    if (saved->groups & GL_TEXTURE_BIT)
        drop_textures(saved);
    free(saved);
}

void glPushAttrib(GLbitfield groups)
{
    context *const gl = enter(__func__);
    saved_attributes *saved;

    if (!gl)
        return;
    if (gl->stacks.depth == ATTRIBUTE_DEPTH) {
        gl_error(gl, GL_STACK_OVERFLOW, __func__);
        return;
    }
    saved = malloc(sizeof *saved + values_size(groups));
    if (!saved) {
        gl_error(gl, GL_OUT_OF_MEMORY, __func__);
        return;
    }
    follow_current_color(gl);
    saved->groups = groups;
    save_attributes(gl, saved);
    gl->stacks.saved[gl->stacks.depth++] = saved;
}

void glPopAttrib(void)
{
    context *const gl = enter(__func__);
    saved_attributes *saved;

    if (!gl)
        return;
    if (gl->stacks.depth == 0) {
        gl_error(gl, GL_STACK_UNDERFLOW, __func__);
        return;
    }
    follow_current_color(gl);
    saved = gl->stacks.saved[--gl->stacks.depth];
    restore_attributes(gl, saved);
    free_attributes(saved);
}

/* Client attributes */

/* Copies bindings of buffers: those of pixels, or of arrays. */
static void copy_bindings(array_state *to, const array_state *from, GLbitfield groups)
{
    if (groups & GL_CLIENT_PIXEL_STORE_BIT) {
        refer_to_buffer(&to->pack_buffer, &to->pack_buffer_name, from->pack_buffer);
        refer_to_buffer(&to->unpack_buffer, &to->unpack_buffer_name, from->unpack_buffer);
    }
    if (!(groups & GL_CLIENT_VERTEX_ARRAY_BIT))
        return;
    refer_to_buffer(&to->array_buffer, &to->array_buffer_name, from->array_buffer);
    refer_to_buffer(&to->element_buffer, &to->element_buffer_name, from->element_buffer);
    to->client_texture = from->client_texture;
    for (int i = 0; i < ARRAYS; ++i) {
        vertex_array array = from->array[i];

        array.buffer = to->array[i].buffer;
        array.buffer_name = to->array[i].buffer_name;
        refer_to_buffer(&array.buffer, &array.buffer_name, from->array[i].buffer);
        to->array[i] = array;
    }
}

static void free_client_attributes(saved_client_attributes *saved)
{
    static const array_state none;

    copy_bindings(&saved->arrays, &none, saved->groups);
    free(saved);
}

void glPushClientAttrib(GLbitfield groups)
{
    context *const gl = enter(__func__);
    saved_client_attributes *saved;

    if (!gl)
        return;
    if (gl->stacks.client_depth == ATTRIBUTE_DEPTH) {
        gl_error(gl, GL_STACK_OVERFLOW, __func__);
        return;
    }
    saved = calloc(1, sizeof *saved);
    if (!saved) {
        gl_error(gl, GL_OUT_OF_MEMORY, __func__);
        return;
    }
    saved->groups = groups;
    saved->pack = gl->pack;
    saved->unpack = gl->unpack;
    copy_bindings(&saved->arrays, &gl->arrays, groups);
    gl->stacks.client_saved[gl->stacks.client_depth++] = saved;
}

void glPopClientAttrib(void)
{
    context *const gl = enter(__func__);
    saved_client_attributes *saved;

    if (!gl)
        return;
    if (gl->stacks.client_depth == 0) {
        gl_error(gl, GL_STACK_UNDERFLOW, __func__);
        return;
    }
    saved = gl->stacks.client_saved[--gl->stacks.client_depth];
    if (saved->groups & GL_CLIENT_PIXEL_STORE_BIT) {
        gl->pack = saved->pack;
        gl->unpack = saved->unpack;
    }
    copy_bindings(&gl->arrays, &saved->arrays, saved->groups);
    free_client_attributes(saved);
}

void free_attribute_stacks(context *gl)
{
    while (gl->stacks.depth > 0)
        free_attributes(gl->stacks.saved[--gl->stacks.depth]);
    while (gl->stacks.client_depth > 0)
        free_client_attributes(gl->stacks.client_saved[--gl->stacks.client_depth]);
}
