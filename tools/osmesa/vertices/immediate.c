/* Collects the vertices between glBegin and glEnd, and draws them. */
#include "immediate.h"

#include <gl_registry.h>
#include <stdlib.h>
#include <string.h>

#include "../draw/draw_mesh.h"
#include "../context/gl_errors.h"

enum { FIRST_CAPACITY = 64, MOST_KEPT_LAYOUT = 8, WHOLE_LOOP = 2 };

static bool grow(context *gl)
{
    immediate_state *const im = &gl->immediate;
    const uint32_t capacity = im->capacity ? 2 * im->capacity : FIRST_CAPACITY;
    void *const memory =
        capacity < im->capacity ? NULL : realloc(im->vertex, (size_t)capacity * sizeof *im->vertex);

    if (!memory) {
        gl_error(gl, GL_OUT_OF_MEMORY, "glVertex");
        return false;
    }
    im->vertex = memory;
    im->capacity = capacity;
    return true;
}

static bool has_attribute(const immediate_state *im, int a)
{
    return im->size[a] || (a == SECONDARY_AND_FOG && im->size[FOG_COORDINATE_ATTRIBUTE]);
}

/* Draws all primitives, and forgets the vertices but not what attributes they have. */
static void draw_primitives(context *gl)
{
    immediate_state *const im = &gl->immediate;

    for (uint32_t i = 0; i < im->primitives; ++i) {
        const pending_primitive *const p = &im->primitive[i];
        gn_mesh mesh;

        if (p->count == 0)
            continue;
        memset(&mesh, 0, sizeof mesh);
        for (int a = 0; a < ATTRIBUTES; ++a) {
            if (has_attribute(im, a)) {
                mesh.attribute[a].data = im->vertex[p->first][a];
                mesh.attribute[a].components = 4;
                mesh.attribute[a].stride = sizeof *im->vertex;
            }
        }
        mesh.vertex_count = mesh.count = p->count;
        gl->edge_flags = (edge_flags){.vertex = &im->vertex[p->first][NORMAL][3],
                                      .step = sizeof *im->vertex / sizeof(GLfloat)};
        if (im->store)
            im->store(gl, p->mode, &mesh);
        else
            draw_mesh(gl, p->mode, &mesh, "glEnd");
        gl->edge_flags = (edge_flags){0};
    }
    im->primitives = 0;
    im->count = 0;
}

static void draw_pending(context *gl)
{
    immediate_state *const im = &gl->immediate;

    if (im->primitives)
        draw_primitives(gl);
    memset(im->size, 0, sizeof im->size);
}

/* Vertices that a primitive needs again: its first one, and `count` from `from` on. */
typedef struct needed_vertices {
    bool first;
    uint32_t from, count;
} needed_vertices;

static needed_vertices last_ones(uint32_t count, uint32_t needed)
{
    return (needed_vertices){false, count - needed, needed};
}

/* Returns the vertices that a primitive of `count` vertices goes on with, after those that make
 * whole primitives have been drawn: `*drawn`. */
static needed_vertices vertices_needed(GLenum mode, uint32_t count, uint32_t *drawn)
{
    *drawn = count;
    switch (mode) {
    case GL_POINTS:
        return last_ones(count, 0);
    case GL_LINES:
        *drawn = count - count % 2;
        return last_ones(count, count % 2);
    case GL_TRIANGLES:
        *drawn = count - count % 3;
        return last_ones(count, count % 3);
    case GL_QUADS:
        *drawn = count - count % 4;
        return last_ones(count, count % 4);
    case GL_LINE_STRIP:
        return last_ones(count, count ? 1 : 0);
    case GL_LINE_LOOP:
    case GL_TRIANGLE_FAN:
    case GL_POLYGON: {
        needed_vertices needed = last_ones(count, count ? 1 : 0);

        needed.first = count > 1;
        return needed;
    }
    default:
        *drawn = count - count % 2; /* strips go on with an even triangle */
        return last_ones(count, count < 2 ? count : 2 + count % 2);
    }
}

/* Makes a part of a loop a strip, and returns the vertices that the loop goes on with. Two faults
 * of the reference show in pixels, though not in lists: a loop of two vertices is drawn as a line
 * if other primitives wait, and begins again with both; and a third part begins with the vertex
 * before the last one of the second. */
static needed_vertices divide_loop(immediate_state *im, pending_primitive *p, uint32_t count)
{
    const bool goes_on = im->continues_loop, is_recorded = im->store != NULL;
    uint32_t drawn;
    const needed_vertices needed =
        vertices_needed(GL_LINE_LOOP, goes_on && !is_recorded ? count - 1 : count, &drawn);

    p->mode = GL_LINE_STRIP;
    p->count = count;
    if (goes_on) {
        ++p->first;
        --p->count;
    } else if (count <= WHOLE_LOOP) {
        if (is_recorded || p->first == 0)
            p->count = 0;
        return needed;
    }
    im->continues_loop = true;
    return needed;
}

/* Draws what the vertices of a primitive make so far, and begins it again with those that are
 * needed. */
static void divide_primitive(context *gl)
{
    immediate_state *const im = &gl->immediate;
    pending_primitive *const p = &im->primitive[im->primitives - 1];
    const uint32_t begin = p->first, count = im->count - begin;
    const GLenum mode = p->mode;
    const needed_vertices needed =
        mode == GL_LINE_LOOP ? divide_loop(im, p, count) : vertices_needed(mode, count, &p->count);

    draw_primitives(gl);
    if (needed.first)
        memmove(im->vertex[im->count++], im->vertex[begin], sizeof *im->vertex);
    for (uint32_t i = 0; i < needed.count; ++i)
        memmove(im->vertex[im->count++], im->vertex[begin + needed.from + i], sizeof *im->vertex);
    im->primitive[0] = (pending_primitive){mode, 0, 0};
    im->primitives = 1;
}

void draw_vertices_so_far(context *gl)
{
    immediate_state *const im = &gl->immediate;

    if (!im->is_inside) {
        if (im->primitives)
            draw_primitives(gl);
    } else if (im->count > im->primitive[im->primitives - 1].first) {
        divide_primitive(gl);
    } else if (im->count) {
        const GLenum mode = im->primitive[--im->primitives].mode;

        draw_primitives(gl);
        im->primitive[im->primitives++] = (pending_primitive){mode, 0, 0};
    }
}

void grow_layout(context *gl, int attribute, int size)
{
    immediate_state *const im = &gl->immediate;
    const uint32_t waiting = im->count;

    draw_vertices_so_far(gl);
    if (!im->is_inside && waiting > MOST_KEPT_LAYOUT && !im->size[attribute])
        memset(im->size, 0, sizeof im->size);
    im->size[attribute] = (unsigned char)size;
}

void complete_vertices(context *gl, enum attribute_name name, int first, int count)
{
    immediate_state *const im = &gl->immediate;

    for (uint32_t v = 0; v < im->count; ++v)
        memcpy(&im->vertex[v][name][first], &gl->current.attribute[name][first],
               (size_t)count * sizeof(GLfloat));
}

void add_vertex(int size, GLfloat x, GLfloat y, GLfloat z, GLfloat w)
{
    context *const gl = current_context();
    immediate_state *const im = gl ? &gl->immediate : NULL;

    if (!im || !im->is_inside)
        return;
    if (size > im->size[POSITION])
        grow_layout(gl, POSITION, size);
    if (im->count == im->capacity && !grow(gl))
        return;
    GLfloat(*const vertex)[4] = im->vertex[im->count++];
    memcpy(vertex, gl->current.attribute, sizeof gl->current.attribute);
    vertex[POSITION][0] = x;
    vertex[POSITION][1] = y;
    vertex[POSITION][2] = z;
    vertex[POSITION][3] = w;
    vertex[NORMAL][3] = gl->current.edge_flag ? 1.0f : 0.0f; /* normals have three components */
}

void glBegin(GLenum mode)
{
    context *const gl = current_context();
    immediate_state *const im = gl ? &gl->immediate : NULL;

    if (!gl || im->is_inside || mode > GL_POLYGON) {
        if (gl)
            gl_error(gl, im->is_inside ? GL_INVALID_OPERATION : GL_INVALID_ENUM, __func__);
        return;
    }
    /* Attributes that were set before any vertex are the current ones. */
    if (!im->size[POSITION])
        memset(im->size, 0, sizeof im->size);
    if (im->primitives == PENDING_PRIMITIVES)
        draw_pending(gl);
    im->draw = draw_pending;
    im->is_inside = true;
    im->keeps_current = false;
    im->primitive[im->primitives++] = (pending_primitive){mode, im->count, 0};
}

/* Returns how many vertices each primitive of a mode has, 0 where primitives share vertices. */
static uint32_t vertices_of_each(GLenum mode)
{
    return mode == GL_POINTS      ? 1
           : mode == GL_LINES     ? 2
           : mode == GL_TRIANGLES ? 3
           : mode == GL_QUADS     ? 4
                                  : 0;
}

void glEnd(void)
{
    context *const gl = current_context();
    immediate_state *const im = gl ? &gl->immediate : NULL;
    pending_primitive *p;
    uint32_t each;

    if (!gl)
        return;
    if (!im->is_inside) {
        gl_error(gl, GL_INVALID_OPERATION, __func__);
        return;
    }
    im->is_inside = false;
    p = &im->primitive[im->primitives - 1];
    p->count = im->count - p->first;
    if (im->continues_loop && p->count && (im->count < im->capacity || grow(gl))) {
        memcpy(im->vertex[im->count++], im->vertex[p->first], sizeof *im->vertex);
        p->mode = GL_LINE_STRIP;
        ++p->first;
    }
    im->continues_loop = false;
    each = vertices_of_each(p->mode);
    if (im->primitives > 1 && each && p[-1].mode == p->mode && p[-1].count % each == 0 &&
        p[-1].first + p[-1].count == p->first) {
        p[-1].count += p->count;
        --im->primitives;
    }
}
