/* The functions that name, bind and delete textures. A texture that is deleted leaves the units and
 * the framebuffers that it is bound in. */
#include <gl_registry.h>
#include <stdlib.h>

#include "../framebuffer/framebuffer_objects.h"
#include "../context/gl_errors.h"
#include "../context/name_calls.h"
#include "../context/object_names.h"

void glGenTextures(GLsizei count, GLuint *names)
{
    context *const gl = enter(__func__);

    if (gl)
        generate_names(gl, gl->shared->textures, count, names, __func__);
}

void glDeleteTextures(GLsizei count, const GLuint *names)
{
    context *const gl = enter(__func__);

    if (!gl || !is_count(gl, count, __func__))
        return;
    for (GLsizei n = 0; n < count && names; ++n) {
        texture_object *const texture = remove_name(gl->shared->textures, names[n]);

        for (int unit = 0; texture && unit < TEXTURE_UNITS; ++unit)
            for (int i = 0; i < TEXTURE_TARGETS; ++i)
                if (gl->unit[unit].bound[i] == texture)
                    refer_to_texture(&gl->unit[unit].bound[i], gl->shared->default_texture[i]);
        if (texture)
            detach_texture(gl, texture);
        release_texture(texture);
    }
}

void glBindTexture(GLenum target, GLuint name)
{
    context *const gl = enter(__func__);
    const int index = texture_index(target);
    texture_object *texture;

    if (!gl)
        return;
    if (index < 0) {
        gl_error(gl, GL_INVALID_ENUM, __func__);
        return;
    }
    texture = name ? find_object(gl->shared->textures, name) : gl->shared->default_texture[index];
    if (texture && texture->target != target) {
        gl_error(gl, GL_INVALID_OPERATION, __func__);
        return;
    }
    if (!texture) {
        texture = create_texture(name, target);
        if (!texture || !set_object(gl->shared->textures, name, texture)) {
            free(texture);
            gl_error(gl, GL_OUT_OF_MEMORY, __func__);
            return;
        }
    }
    refer_to_texture(&gl->unit[gl->active_texture].bound[index], texture);
}

GLboolean glIsTexture(GLuint name)
{
    context *const gl = enter(__func__);

    return gl && find_object(gl->shared->textures, name) != NULL;
}

/* Priorities are kept and change nothing: all textures are in memory. */
void glPrioritizeTextures(GLsizei count, const GLuint *names, const GLfloat *priorities)
{
    context *const gl = enter(__func__);

    if (!gl || !is_count(gl, count, __func__))
        return;
    for (GLsizei n = 0; n < count && names && priorities; ++n) {
        texture_object *const texture =
            names[n] ? find_object(gl->shared->textures, names[n]) : NULL;
        const GLfloat priority = priorities[n];

        if (texture)
            texture->priority = priority > 0.0f ? (priority < 1.0f ? priority : 1.0f) : 0.0f;
    }
}

GLboolean glAreTexturesResident(GLsizei count, const GLuint *names, GLboolean *residences)
{
    context *const gl = enter(__func__);

    if (!gl)
        return GL_FALSE;
    if (count < 0) {
        gl_error(gl, GL_INVALID_VALUE, __func__);
        return GL_FALSE;
    }
    if (!names || !residences)
        return GL_FALSE;
    for (GLsizei n = 0; n < count; ++n) {
        if (!names[n] || !find_object(gl->shared->textures, names[n])) {
            gl_error(gl, GL_INVALID_VALUE, __func__);
            return GL_FALSE;
        }
    }
    return GL_TRUE;
}
