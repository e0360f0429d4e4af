/* Drawing a scene with OpenGL: upload, state, draw calls, read back. */
#include "gl.h"

#include <stdlib.h>
#include <string.h>

#define ATTRIBUTES 5

/* Mesa does not draw these three triangles if the third has no height (reference/RULES.md).
 * With an index buffer it draws them. */
static bool is_nine_vertices(const scene_draw *d)
{
    return d->mesh.index_format == GN_INDEX_NONE && d->state.raster.topology == GN_TRIANGLES &&
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

static GLenum stencil_operation(gn_stencil_operation o)
{
    static const GLenum operations[] = {GL_KEEP, GL_ZERO,   GL_REPLACE,   GL_INCR,
                                        GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP};

    return operations[o];
}

static void set_stencil(GLenum face, const gn_stencil_face *f)
{
    glStencilFuncSeparate(face, gl_comparison(f->function, GL_ALWAYS), f->reference,
                          255u & ~(GLuint)f->compare_disabled);
    glStencilMaskSeparate(face, 255u & ~(GLuint)f->write_disabled);
    glStencilOpSeparate(face, stencil_operation(f->fail), stencil_operation(f->depth_fail),
                        stencil_operation(f->pass));
}

static GLenum polygon_mode(gn_polygon_mode m)
{
    return m == GN_POLYGON_LINE ? GL_LINE : m == GN_POLYGON_POINT ? GL_POINT : GL_FILL;
}

static void switch_capability(GLenum capability, bool on)
{
    if (on)
        glEnable(capability);
    else
        glDisable(capability);
}

/* ---- Upload ---- */

static size_t attribute_stride(const gn_attribute *a)
{
    return a->stride ? a->stride : a->components * sizeof(float);
}

/* Bytes from the first vertex's first component to the last vertex's last component. */
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
        if (d->counted)
            glGenQueries(2, draws[i].queries);
        if (scene_draw_has_texture(d))
            draws[i].texture = reference_upload_texture(&d->uniforms.texture, &d->uniforms.sampler);
        reference_upload_maps(d, draws[i].maps);
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
        glDeleteVertexArrays(1, &draws[i].array);
        glDeleteTextures(1, &draws[i].texture);
        glDeleteTextures(SCENE_MAP_COUNT, draws[i].maps);
        glDeleteQueries(2, draws[i].queries);
    }
    free(draws);
}

/* ---- State and draw call ---- */

void reference_clear(const scene *s)
{
    GLbitfield mask = 0;

    glDisable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    framebuffer_choose_colors(s, GN_MAX_COLORS);
    glClearColor(s->clear_color[0], s->clear_color[1], s->clear_color[2], s->clear_color[3]);
    mask |= GL_COLOR_BUFFER_BIT;
    if (s->depth_format != GN_FORMAT_NONE) {
        glClearDepthf(s->clear_depth);
        mask |= GL_DEPTH_BUFFER_BIT;
        glStencilMask(255);
        glClearStencil(s->clear_stencil);
        mask |= GL_STENCIL_BUFFER_BIT; /* an attachment that does not exist is not cleared */
    }
    glClear(mask);
}

/* OpenGL's sizes are signed, and Mesa computes with numbers that overflow: a scissor whose end is
 * beyond 32 bits is empty, and an origin of 65536 counts as 0. So sets a scissor that has the same
 * pixels of the largest target. */
static void set_scissor(const gn_scissor *s)
{
    const int64_t most = GN_MAX_SIZE;
    int64_t first[2] = {s->x, s->y}, end[2];

    end[0] = first[0] + s->width;
    end[1] = first[1] + s->height;
    for (int n = 0; n < 2; ++n) {
        first[n] = first[n] < 0 ? 0 : first[n] > most ? most : first[n];
        end[n] = end[n] < first[n] ? first[n] : end[n] > most ? most : end[n];
    }
    glScissor((GLint)first[0], (GLint)first[1], (GLsizei)(end[0] - first[0]),
              (GLsizei)(end[1] - first[1]));
}

static void set_polygon_offset(const gn_polygon_offset *p)
{
    switch_capability(GL_POLYGON_OFFSET_FILL, p->enabled);
    switch_capability(GL_POLYGON_OFFSET_LINE, p->enabled);
    switch_capability(GL_POLYGON_OFFSET_POINT, p->enabled);
    if (p->enabled)
        glPolygonOffsetClampEXT(p->factor, p->units, p->clamp);
}

/* OpenGL has no viewport of negative height, but another origin of clip space, which does not
 * change what faces the viewer. */
static bool is_upside_down(const gn_pipeline *p)
{
    return p->raster.viewport.enabled && p->raster.viewport.height < 0.0f;
}

static void set_viewport(const scene *s, const gn_viewport *v)
{
    if (v->enabled && v->height < 0.0f)
        glViewportIndexedf(0, v->x, v->y + v->height, v->width, -v->height);
    else if (v->enabled)
        glViewportIndexedf(0, v->x, v->y, v->width, v->height);
    else
        glViewportIndexedf(0, 0.0f, 0.0f, (float)s->width, (float)s->height);
}

static void set_state(const scene *s, const gn_pipeline *p)
{
    const bool front_is_clockwise = p->raster.front_face == GN_FRONT_CLOCKWISE;

    glProvokingVertex(p->raster.provoking_vertex == GN_PROVOKING_FIRST ? GL_FIRST_VERTEX_CONVENTION
                                                                       : GL_LAST_VERTEX_CONVENTION);
    switch_capability(GL_CULL_FACE, p->raster.cull != GN_CULL_NONE);
    glCullFace(p->raster.cull == GN_CULL_FRONT            ? GL_FRONT
               : p->raster.cull == GN_CULL_FRONT_AND_BACK ? GL_FRONT_AND_BACK
                                                          : GL_BACK);
    glFrontFace(front_is_clockwise != is_upside_down(p) ? GL_CW : GL_CCW);
    set_viewport(s, &p->raster.viewport);
    glClipControl(is_upside_down(p) ? GL_UPPER_LEFT : GL_LOWER_LEFT,
                  p->depth.clip_depth == GN_ZERO_TO_ONE ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
    if (p->depth.range.enabled)
        glDepthRangeIndexed(0, (double)p->depth.range.z_near, (double)p->depth.range.z_far);
    else
        glDepthRangeIndexed(0, 0.0, 1.0);
    switch_capability(GL_SCISSOR_TEST, p->raster.scissor.enabled);
    if (p->raster.scissor.enabled)
        set_scissor(&p->raster.scissor);
    set_polygon_offset(&p->raster.polygon_offset);
    for (uint32_t i = 0; i < GN_MAX_CLIP_DISTANCES; ++i)
        switch_capability(GL_CLIP_DISTANCE0 + i, i < p->program.clip_distance_count);
    switch_capability(GL_DEPTH_CLAMP, p->depth.clamp_enabled);
    switch_capability(GL_DEPTH_TEST, p->depth.test_enabled);
    glDepthFunc(gl_comparison(p->depth.function, GL_LESS));
    glDepthMask(!p->depth.write_disabled);
    reference_set_color_state(p);
    switch_capability(GL_STENCIL_TEST, p->stencil.test_enabled);
    set_stencil(GL_FRONT, &p->stencil.front);
    set_stencil(GL_BACK, &p->stencil.back);
    glPointSize(p->raster.point_size == 0.0f ? 1.0f : p->raster.point_size);
    glLineWidth(p->raster.line_width == 0.0f ? 1.0f : p->raster.line_width);
    reference_set_sample_state(p);
    glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, p->raster.point_origin == GN_POINT_LOWER_LEFT
                                                        ? GL_LOWER_LEFT
                                                        : GL_UPPER_LEFT);
    if (p->raster.polygon_mode_front == p->raster.polygon_mode_back) {
        glPolygonMode(GL_FRONT_AND_BACK, polygon_mode(p->raster.polygon_mode_front));
    } else {
        glPolygonMode(GL_FRONT, polygon_mode(p->raster.polygon_mode_front));
        glPolygonMode(GL_BACK, polygon_mode(p->raster.polygon_mode_back));
    }
}

/* The ready-made vertex shaders use white if the mesh has no colours. */
static void set_attributes(const gn_mesh *mesh, const uploaded_draw *u, bool whitens)
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
            glVertexAttribDivisor(a, attribute->divisor);
        } else {
            glDisableVertexAttribArray(a);
            const GLfloat absent = whitens && a == GN_ATTRIBUTE_COLOR ? 1.0f : 0.0f;

            glVertexAttrib4f(a, absent, absent, absent, 1.0f);
        }
    }
}

/* Setting a uniform that the program does not use is an error, so shaders without light get only
 * the matrix. */
static void set_uniforms(const scene_draw *d, GLuint program)
{
    const scene_light *light = &d->uniforms.light;

    if (d->state.program.clip_distance_count > 0)
        glUniform4fv(8, GN_MAX_CLIP_DISTANCES, &d->clip_plane[0][0]);
    if (reference_has_twin(d)) {
        reference_set_twin_uniforms(d, program);
        return;
    }
    glUniformMatrix4fv(0, 1, GL_FALSE, &light->clip_from_model.m[0][0]);
    if (scene_shader_is_lit(d->shader)) {
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

/* Mesa keeps the limits of depth clamp when the clip depth changes and the viewport's
 * transform does not (reference/RULES.md). Drawing nothing under another viewport makes it compute
 * them again. */
static void renew_viewport(const scene_draw *d)
{
    if (d->state.depth.clamp_enabled && d->mesh.vertex_count > 0) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, 0, 0);
        glViewportIndexedf(0, 1.0f, 2.0f, 3.0f, 5.0f);
        glDepthRangeIndexed(0, 0.25, 0.375);
        glDrawArrays(GL_POINTS, 0, 1);
    }
}

static void draw_elements(const scene_draw *d)
{
    const gn_mesh *mesh = &d->mesh;
    const GLsizei count = (GLsizei)mesh->count;
    const GLsizei instances = mesh->instance_count ? (GLsizei)mesh->instance_count : 1;
    const size_t skipped = mesh->first * scene_index_size(mesh->index_format);

    switch_capability(GL_PRIMITIVE_RESTART, mesh->restart == GN_RESTART_INDEX);
    switch_capability(GL_PRIMITIVE_RESTART_FIXED_INDEX, mesh->restart == GN_RESTART_FIXED_INDEX);
    glPrimitiveRestartIndex(mesh->restart_index);
    if (is_nine_vertices(d)) {
        glDisable(GL_PRIMITIVE_RESTART);
        glDisable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
        glDrawElementsInstanced(GL_TRIANGLES, count, GL_UNSIGNED_INT, NULL, instances);
    } else if (mesh->index_format == GN_INDEX_NONE) {
        glDrawArraysInstanced(topology(d->state.raster.topology), (GLint)mesh->first, count,
                              instances);
    } else {
        glDrawElementsInstancedBaseVertex(
            topology(d->state.raster.topology), count, index_type(mesh->index_format),
            (const void *)(uintptr_t)skipped, instances, mesh->base_vertex);
    }
}

static int drawn_colors(const scene_draw *d)
{
    if (d->shader == SCENE_DEPTH_ONLY)
        return 0;
    return d->shader == SCENE_OUTPUTS && d->state.program.color_count
               ? (int)d->state.program.color_count
               : 1;
}

void reference_issue(const scene *s, const scene_draw *d, const uploaded_draw *u)
{
    const gn_mesh *mesh = &d->mesh;

    if (d->clear.color || d->clear.depth) {
        const scene cleared = scene_of_clear(s, d);

        reference_clear(&cleared);
    }
    framebuffer_choose_colors(s, drawn_colors(d));
    set_state(s, &d->state);
    switch_capability(GL_PROGRAM_POINT_SIZE, d->state.program.vertex_writes_point_size &&
                                                 scene_shader_has_sizes(d->shader));
    set_attributes(mesh, u, d->shader != SCENE_SAMPLED);
    glUseProgram(u->program);
    set_uniforms(d, u->program);
    reference_bind_maps(u->maps);
    glActiveTexture(GL_TEXTURE0);
    if (u->texture)
        glBindTexture(reference_texture_target(d->uniforms.texture.target), u->texture);
    renew_viewport(d);
    set_state(s, &d->state);
    if (u->queries[0]) {
        glBeginQuery(GL_SAMPLES_PASSED, u->queries[0]);
        glBeginQuery(GL_PRIMITIVES_GENERATED, u->queries[1]);
    }
    draw_elements(d);
    if (u->queries[0]) {
        glEndQuery(GL_PRIMITIVES_GENERATED);
        glEndQuery(GL_SAMPLES_PASSED);
    }
}

void reference_prepare_attributes(const scene_draw *d, uploaded_draw *u)
{
    glGenVertexArrays(1, &u->array);
    glBindVertexArray(u->array);
    set_attributes(&d->mesh, u, d->shader != SCENE_SAMPLED);
}

/* Whether a draw has the state and the shader's outputs of the draw before it, and no clear has
 * changed the state between them. */
static bool keeps_state(const scene_draw *d, const scene_draw *before)
{
    return before && !d->clear.color && !d->clear.depth && d->shader == before->shader &&
           !memcmp(&d->state, &before->state, sizeof d->state);
}

static bool has_maps(const uploaded_draw *u)
{
    bool any = false;

    for (int m = 0; m < SCENE_MAP_COUNT; ++m)
        any = any || u->maps[m];
    return any;
}

void reference_issue_prepared(const scene *s, const scene_draw *d, const uploaded_draw *u,
                              const scene_draw *before, const uploaded_draw *before_u)
{
    if (d->clear.color || d->clear.depth) {
        const scene cleared = scene_of_clear(s, d);

        reference_clear(&cleared);
    }
    if (!keeps_state(d, before)) {
        framebuffer_choose_colors(s, drawn_colors(d));
        set_state(s, &d->state);
        switch_capability(GL_PROGRAM_POINT_SIZE, d->state.program.vertex_writes_point_size &&
                                                     scene_shader_has_sizes(d->shader));
    }
    glBindVertexArray(u->array);
    if (!before || u->program != before_u->program)
        glUseProgram(u->program);
    set_uniforms(d, u->program);
    if (u->texture || has_maps(u))
        reference_bind_maps(u->maps);
    if (u->texture) {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(reference_texture_target(d->uniforms.texture.target), u->texture);
    }
    draw_elements(d);
}

bool reference_draw(reference *r, const scene *s, scene_frame *frame, char *error,
                    size_t error_size)
{
    framebuffer *const target = reference_framebuffer(r, s, error, error_size);
    uploaded_draw *draws;

    if (!target)
        return false;
    draws = reference_upload(r, s, error, error_size);
    if (!draws)
        return false;
    reference_clear(s);
    for (size_t i = 0; i < s->draw_count; ++i)
        reference_issue(s, &s->draws[i], &draws[i]);
    glFinish();
    if (!target->is_sampled) {
        reference_read_image(s, 0, frame);
    } else if (!reference_read_samples(r, s, target, frame, error, error_size)) {
        reference_discard(draws, s->draw_count);
        return false;
    }
    frame->samples_passed = 0;
    memset(&frame->statistics, 0, sizeof frame->statistics);
    for (size_t i = 0; i < s->draw_count; ++i) {
        GLuint passed = 0, primitives = 0;

        if (draws[i].queries[0]) {
            glGetQueryObjectuiv(draws[i].queries[0], GL_QUERY_RESULT, &passed);
            glGetQueryObjectuiv(draws[i].queries[1], GL_QUERY_RESULT, &primitives);
        }
        frame->samples_passed += passed;
        frame->statistics.primitives += primitives;
    }
    reference_discard(draws, s->draw_count);
    return reference_check("drawing a scene", error, error_size);
}
