/* The functions of queries. The workspace of the context counts for the query that is active. */
#include "occlusion_queries.h"

#include <gl_registry.h>
#include <stdlib.h>

#include "../context/gl_errors.h"
#include "../context/name_calls.h"
#include "../context/object_names.h"

static bool is_target(context *gl, GLenum target, const char *function)
{
    if (target == GL_SAMPLES_PASSED || target == GL_ANY_SAMPLES_PASSED ||
        target == GL_ANY_SAMPLES_PASSED_CONSERVATIVE)
        return true;
    gl_error(gl, GL_INVALID_ENUM, function);
    return false;
}

/* Returns a new query; null, with an error, if memory is short. */
static occlusion_query *create_query(context *gl, GLuint name, const char *function)
{
    occlusion_query *const query = calloc(1, sizeof *query);

    if (!query || !set_object(gl->queries, name, query)) {
        free(query);
        gl_error(gl, GL_OUT_OF_MEMORY, function);
        return NULL;
    }
    query->name = name;
    return query;
}

void glGenQueries(GLsizei count, GLuint *names)
{
    context *const gl = enter(__func__);

    if (gl)
        generate_names(gl, gl->queries, count, names, __func__);
}

static void set_active(context *gl, occlusion_query *query)
{
    gl->query = query;
    gl->workspace.samples_passed = query ? &query->samples : NULL;
}

void glDeleteQueries(GLsizei count, const GLuint *names)
{
    context *const gl = enter(__func__);

    if (!gl || !is_count(gl, count, __func__))
        return;
    for (GLsizei n = 0; n < count && names; ++n) {
        occlusion_query *const query = remove_name(gl->queries, names[n]);

        if (query && query == gl->query)
            set_active(gl, NULL);
        free(query);
    }
}

GLboolean glIsQuery(GLuint name)
{
    context *const gl = enter(__func__);

    return gl && find_object(gl->queries, name) != NULL;
}

void glBeginQuery(GLenum target, GLuint name)
{
    context *const gl = enter(__func__);
    occlusion_query *query;

    if (!gl || !is_target(gl, target, __func__))
        return;
    query = find_object(gl->queries, name);
    if (gl->query || !name || (query && query->target != target)) {
        gl_error(gl, GL_INVALID_OPERATION, __func__);
        return;
    }
    if (!query)
        query = create_query(gl, name, __func__);
    if (!query)
        return;
    query->target = target;
    query->samples = 0;
    set_active(gl, query);
}

void glEndQuery(GLenum target)
{
    context *const gl = enter(__func__);

    if (!gl || !is_target(gl, target, __func__))
        return;
    if (gl->query && gl->query->target == target)
        set_active(gl, NULL);
    else
        gl_error(gl, GL_INVALID_OPERATION, __func__);
}

void glGetQueryiv(GLenum target, GLenum name, GLint *value)
{
    context *const gl = enter(__func__);

    if (!gl || !is_target(gl, target, __func__))
        return;
    if (name == GL_QUERY_COUNTER_BITS)
        *value = target == GL_SAMPLES_PASSED ? 64 : 1;
    else if (name == GL_CURRENT_QUERY)
        *value = gl->query && gl->query->target == target ? (GLint)gl->query->name : 0;
    else
        gl_error(gl, GL_INVALID_ENUM, __func__);
}

/* Returns in `value` what is asked of a query that has ended; false, with an error, if there is no
 * such query or name. */
static bool query_value(GLuint query_name, GLenum name, uint64_t *value, const char *function)
{
    context *const gl = enter(function);
    const occlusion_query *const query = gl ? find_object(gl->queries, query_name) : NULL;

    if (!gl)
        return false;
    if (!query || query == gl->query) {
        gl_error(gl, GL_INVALID_OPERATION, function);
        return false;
    }
    switch (name) {
    case GL_QUERY_RESULT:
        *value = query->target == GL_SAMPLES_PASSED ? query->samples : query->samples > 0;
        return true;
    case GL_QUERY_RESULT_AVAILABLE:
        *value = GL_TRUE;
        return true;
    default:
        gl_error(gl, GL_INVALID_ENUM, function);
        return false;
    }
}

void glGetQueryObjectiv(GLuint query, GLenum name, GLint *value)
{
    uint64_t wide;

    if (query_value(query, name, &wide, __func__))
        *value = wide < INT32_MAX ? (GLint)wide : INT32_MAX;
}

void glGetQueryObjectuiv(GLuint query, GLenum name, GLuint *value)
{
    uint64_t wide;

    if (query_value(query, name, &wide, __func__))
        *value = wide < UINT32_MAX ? (GLuint)wide : UINT32_MAX;
}
