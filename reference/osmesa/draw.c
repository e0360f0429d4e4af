/* Drawing a scene with OpenGL: upload, state, draw calls, read back. */
#include "gl.h"

#include <stdlib.h>
#include <string.h>

#define ATTRIBUTES 4

/* Draws that Mesa 22.3 loses where the third triangle has no height (reference/RULES.md);
 * through an index buffer it draws them. */
static bool is_nine_vertices(const scene_draw *d)
{
    return d->mesh.index_format == GN_INDEX_NONE && d->state.topology == GN_TRIANGLES &&
           d->mesh.count / 3 == 3;
}

static GLenum index_type(gn_index_format format)
{
    switch (format) {
    case GN_INDEX_UINT8:
        return GL_UNSIGNED_BYTE;
    case GN_INDEX_UINT16:
        return GL_UNSIGNED_SHORT;
    default:
        return GL_UNSIGNED_INT;
    }
}

static GLenum topology(gn_topology t)
{
    switch (t) {
    case GN_TRIANGLE_STRIP:
        return GL_TRIANGLE_STRIP;
    case GN_TRIANGLE_FAN:
        return GL_TRIANGLE_FAN;
    case GN_POINTS:
        return GL_POINTS;
    case GN_LINES:
        return GL_LINES;
    case GN_LINE_STRIP:
        return GL_LINE_STRIP;
    case GN_LINE_LOOP:
        return GL_LINE_LOOP;
    case GN_TRIANGLES:
        break;
    }
    return GL_TRIANGLES;
}

static GLenum depth_function(gn_compare c)
{
    switch (c) {
    case GN_NEVER:
        return GL_NEVER;
    case GN_EQUAL:
        return GL_EQUAL;
    case GN_LESS_OR_EQUAL:
        return GL_LEQUAL;
    case GN_GREATER:
        return GL_GREATER;
    case GN_NOT_EQUAL:
        return GL_NOTEQUAL;
    case GN_GREATER_OR_EQUAL:
        return GL_GEQUAL;
    case GN_ALWAYS:
        return GL_ALWAYS;
    case GN_LESS:
        break;
    }
    return GL_LESS;
}

static GLenum polygon_mode(gn_polygon_mode m)
{
    return m == GN_POLYGON_LINE ? GL_LINE : m == GN_POLYGON_POINT ? GL_POINT : GL_FILL;
}

static void switch_capability(GLenum capability, bool on)
{
    if (on) {
        glEnable(capability);
    } else {
        glDisable(capability);
    }
}

/* ---- Upload ---- */

static size_t attribute_stride(const gn_attribute *a)
{
    return a->stride ? a->stride : a->components * sizeof(float);
}

/* Bytes from the first vertex's first component to the last one's last. */
static size_t attribute_size(const gn_attribute *a, uint32_t vertex_count)
{
    return a->data && vertex_count
               ? attribute_stride(a) * (vertex_count - 1) + a->components * sizeof(float)
               : 0;
}

static void upload_vertices(const scene_draw *d, uploaded_draw *u)
{
    const gn_mesh *mesh = &d->mesh;

    size_t size = 0;

    for (int a = 0; a < ATTRIBUTES; ++a) {
        u->offset[a] = size;
        size += attribute_size(&mesh->attribute[a], mesh->vertex_count);
    }
    glGenBuffers(1, &u->vertices);
    glBindBuffer(GL_ARRAY_BUFFER, u->vertices);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)size, NULL, GL_STATIC_DRAW);
    for (int a = 0; a < ATTRIBUTES; ++a) {
        const size_t bytes = attribute_size(&mesh->attribute[a], mesh->vertex_count);

        if (bytes) {
            glBufferSubData(GL_ARRAY_BUFFER, (GLintptr)u->offset[a], (GLsizeiptr)bytes,
                            mesh->attribute[a].data);
        }
    }
    if (is_nine_vertices(d)) {
        uint32_t indices[11];

        for (uint32_t i = 0; i < mesh->count; ++i)
            indices[i] = mesh->first + i;
        glGenBuffers(1, &u->indices);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, u->indices);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(mesh->count * sizeof *indices), indices,
                     GL_STATIC_DRAW);
    } else if (mesh->index_format != GN_INDEX_NONE) {
        const size_t bytes =
            ((size_t)mesh->first + mesh->count) * scene_index_size(mesh->index_format);

        glGenBuffers(1, &u->indices);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, u->indices);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)bytes, mesh->indices, GL_STATIC_DRAW);
    }
}

static GLint wrap(gn_wrap w)
{
    return w == GN_WRAP_CLAMP_TO_EDGE ? GL_CLAMP_TO_EDGE : GL_REPEAT;
}

static GLint minify(gn_minify m)
{
    switch (m) {
    case GN_MINIFY_NEAREST:
        return GL_NEAREST;
    case GN_MINIFY_LINEAR:
        return GL_LINEAR;
    case GN_MINIFY_NEAREST_MIPMAP_LINEAR:
        break;
    }
    return GL_NEAREST_MIPMAP_LINEAR;
}

static void upload_texture(const gn_texture *t, const gn_sampler *sampler, uploaded_draw *u)
{
    const bool bytes = t->format == GN_FORMAT_RGBA8;

    glGenTextures(1, &u->texture);
    glBindTexture(GL_TEXTURE_2D, u->texture);
    glTexStorage2D(GL_TEXTURE_2D, 1, bytes ? GL_RGBA8 : GL_RGBA32F, (GLsizei)t->width,
                   (GLsizei)t->height);
    for (uint32_t y = 0; y < t->height; ++y) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, (GLint)y, (GLsizei)t->width, 1, GL_RGBA,
                        bytes ? GL_UNSIGNED_INT_8_8_8_8_REV : GL_FLOAT,
                        (const char *)t->texels + (ptrdiff_t)y * t->row_stride);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap(sampler->wrap_s));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap(sampler->wrap_t));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER,
                    sampler->magnify == GN_MAGNIFY_NEAREST ? GL_NEAREST : GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minify(sampler->minify));
}

uploaded_draw *reference_upload(reference *r, const scene *s, char *error, size_t error_size)
{
    uploaded_draw *draws = calloc(s->draw_count + 1, sizeof *draws);

    if (!draws) {
        reference_fail(error, error_size, "out of memory");
        return NULL;
    }
    for (size_t i = 0; i < s->draw_count; ++i) {
        const scene_draw *d = &s->draws[i];

        draws[i].program = reference_program(r, d, error, error_size);
        if (!draws[i].program) {
            reference_discard(draws, s->draw_count);
            return NULL;
        }
        upload_vertices(d, &draws[i]);
        if (scene_shader_is_textured(d->shader)) {
            upload_texture(&d->uniforms.texture, &d->uniforms.sampler, &draws[i]);
        }
    }
    if (!reference_check("uploading a scene", error, error_size)) {
        reference_discard(draws, s->draw_count);
        return NULL;
    }
    return draws;
}

void reference_discard(uploaded_draw *draws, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        glDeleteBuffers(1, &draws[i].vertices);
        glDeleteBuffers(1, &draws[i].indices);
        glDeleteTextures(1, &draws[i].texture);
    }
    free(draws);
}

/* ---- State and draw call ---- */

void reference_clear(const scene *s)
{
    GLbitfield mask = 0;

    glDepthMask(GL_TRUE);
    if (s->color_format != GN_FORMAT_NONE) {
        glClearColor(s->clear_color[0], s->clear_color[1], s->clear_color[2], s->clear_color[3]);
        mask |= GL_COLOR_BUFFER_BIT;
    }
    if (s->depth_format != GN_FORMAT_NONE) {
        glClearDepthf(s->clear_depth);
        mask |= GL_DEPTH_BUFFER_BIT;
    }
    glClear(mask);
}

static void set_state(const scene *s, const gn_pipeline *p)
{
    const gn_viewport *v = &p->viewport;

    glProvokingVertex(p->provoking_vertex == GN_PROVOKING_FIRST ? GL_FIRST_VERTEX_CONVENTION
                                                                : GL_LAST_VERTEX_CONVENTION);
    switch_capability(GL_CULL_FACE, p->cull != GN_CULL_NONE);
    glCullFace(p->cull == GN_CULL_FRONT            ? GL_FRONT
               : p->cull == GN_CULL_FRONT_AND_BACK ? GL_FRONT_AND_BACK
                                                   : GL_BACK);
    glFrontFace(p->front_face == GN_FRONT_CLOCKWISE ? GL_CW : GL_CCW);
    if (v->set) {
        glViewportIndexedf(0, v->x, v->y, v->width, v->height);
    } else {
        glViewportIndexedf(0, 0.0f, 0.0f, (float)s->width, (float)s->height);
    }
    if (p->depth_range.set) {
        glDepthRangeIndexed(0, (double)p->depth_range.z_near, (double)p->depth_range.z_far);
    } else {
        glDepthRangeIndexed(0, 0.0, 1.0);
    }
    switch_capability(GL_DEPTH_TEST, p->depth_test);
    glDepthFunc(depth_function(p->depth_function));
    glDepthMask(!p->depth_write_disabled);
    glPointSize(p->point_size == 0.0f ? 1.0f : p->point_size);
    glLineWidth(p->line_width == 0.0f ? 1.0f : p->line_width);
    if (p->polygon_mode_front == p->polygon_mode_back) {
        glPolygonMode(GL_FRONT_AND_BACK, polygon_mode(p->polygon_mode_front));
    } else {
        glPolygonMode(GL_FRONT, polygon_mode(p->polygon_mode_front));
        glPolygonMode(GL_BACK, polygon_mode(p->polygon_mode_back));
    }
}

static void set_attributes(const gn_mesh *mesh, const uploaded_draw *u)
{
    glBindBuffer(GL_ARRAY_BUFFER, u->vertices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, u->indices);
    for (GLuint a = 0; a < ATTRIBUTES; ++a) {
        const gn_attribute *attribute = &mesh->attribute[a];

        if (attribute->data && mesh->vertex_count) {
            glVertexAttribPointer(a, (GLint)attribute->components, GL_FLOAT, GL_FALSE,
                                  (GLsizei)attribute_stride(attribute),
                                  (const void *)(uintptr_t)u->offset[a]);
            glEnableVertexAttribArray(a);
        } else {
            glDisableVertexAttribArray(a);
            glVertexAttrib4f(a, 0.0f, 0.0f, 0.0f, 1.0f);
        }
    }
}

/* To set a uniform the program does not use is an error: vertex colour has the matrix alone. */
static void set_uniforms(const scene_draw *d)
{
    const gn_light_uniforms *light = &d->uniforms.light;

    glUniformMatrix4fv(0, 1, GL_FALSE, &light->clip_from_model.m[0][0]);
    if (d->shader != SCENE_VERTEX_COLOR) {
        glUniformMatrix3fv(1, 1, GL_FALSE, &light->normal_matrix.m[0][0]);
        glUniform3f(2, light->light_direction.x, light->light_direction.y,
                    light->light_direction.z);
        glUniform3f(3, light->ambient.x, light->ambient.y, light->ambient.z);
        glUniform3f(4, light->diffuse.x, light->diffuse.y, light->diffuse.z);
    }
    if (d->shader == SCENE_PHONG) {
        glUniformMatrix4fv(5, 1, GL_FALSE, &d->view_from_model.m[0][0]);
        glUniform3f(6, d->specular.x, d->specular.y, d->specular.z);
    }
}

void reference_issue(const scene *s, const scene_draw *d, const uploaded_draw *u)
{
    const gn_mesh *mesh = &d->mesh;

    set_state(s, &d->state);
    switch_capability(GL_PROGRAM_POINT_SIZE,
                      d->state.program_point_size && d->shader == SCENE_VERTEX_COLOR);
    set_attributes(mesh, u);
    glUseProgram(u->program);
    set_uniforms(d);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, u->texture);
    if (is_nine_vertices(d)) {
        glDrawElements(GL_TRIANGLES, (GLsizei)mesh->count, GL_UNSIGNED_INT, NULL);
    } else if (mesh->index_format == GN_INDEX_NONE) {
        glDrawArrays(topology(d->state.topology), (GLint)mesh->first, (GLsizei)mesh->count);
    } else {
        glDrawElements(
            topology(d->state.topology), (GLsizei)mesh->count, index_type(mesh->index_format),
            (const void *)(uintptr_t)(mesh->first * scene_index_size(mesh->index_format)));
    }
}

/* ---- Read back ---- */

static void read_frame(const scene *s, scene_frame *frame)
{
    const GLsizei width = (GLsizei)s->width;
    const GLsizei height = (GLsizei)s->height;

    switch (s->color_format) {
    case GN_FORMAT_RGBA8:
        glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_INT_8_8_8_8_REV, frame->color);
        break;
    case GN_FORMAT_RGBA32F:
        glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, frame->color);
        break;
    default:
        break;
    }
    switch (s->depth_format) {
    case GN_FORMAT_D16:
        glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, frame->depth);
        break;
    case GN_FORMAT_D24:
        /* As 32 bits the value comes with its own upper bits repeated below it. */
        glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, frame->depth);
        for (size_t i = 0; i < (size_t)s->width * s->height; ++i) {
            ((uint32_t *)frame->depth)[i] >>= 8;
        }
        break;
    case GN_FORMAT_D32F:
        glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, frame->depth);
        break;
    default:
        break;
    }
}

bool reference_draw(reference *r, const scene *s, scene_frame *frame, char *error,
                    size_t error_size)
{
    uploaded_draw *draws;

    if (!reference_framebuffer(r, s, error, error_size)) {
        return false;
    }
    draws = reference_upload(r, s, error, error_size);
    if (!draws) {
        return false;
    }
    reference_clear(s);
    for (size_t i = 0; i < s->draw_count; ++i) {
        reference_issue(s, &s->draws[i], &draws[i]);
    }
    glFinish();
    read_frame(s, frame);
    reference_discard(draws, s->draw_count);
    return reference_check("drawing a scene", error, error_size);
}
