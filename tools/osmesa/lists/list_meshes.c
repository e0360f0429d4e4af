/* Primitives of display lists become meshes when they are compiled. Consecutive primitives with
 * nothing but vertices in them are replayed once into an immediate state of the compiler, whose
 * vertices are stored instead of drawn. An attribute that is set only after the first vertices of a
 * primitive counts for those that the primitive goes on with too, if the list does not know its
 * value; so it is in the reference. */
#include <gl_registry.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "display_lists.h"
#include "shared_vertices.h"
#include "../draw/draw_mesh.h"
#include "../context/gl_errors.h"
#include "../vertices/immediate.h"

/* A primitive whose vertices are in one place, each with the attributes that it has. */
typedef struct stored_mesh {
    GLenum mode;
    uint32_t count;
    const GLfloat *vertex;
    unsigned char components[ATTRIBUTES]; /* 0: the current value at the draw */
    uint32_t stride;                      /* floats */
    const uint32_t *index;                /* of triangles that quads have become; null: none */
    uint32_t indices;
} stored_mesh;

/* The current values that primitives leave: those of the last vertex. As in the reference, what is
 * set between it and glEnd does not count. */
typedef struct stored_current {
    uint32_t set; /* bits of attributes, the fog coordinate last */
    current_state current;
} stored_current;

/* In current_state, what no call of a list has set. */
enum { UNSET_FLAG = 255 };

typedef struct captured_mesh {
    struct captured_mesh *next;
    stored_mesh mesh;
    GLfloat vertex[];
} captured_mesh;

struct list_compiler {
    immediate_state immediate;
    current_state current;
    list_call *seen;   /* the last call whose attributes are known; null: none */
    bool has_group;    /* there are primitives that are not meshes yet */
    bool is_inside;    /* the last one is not ended */
    list_call *before; /* the call before them; null: none */
    list_block *block; /* the list's memory before them */
    size_t used;
    captured_mesh *first_captured, **last_captured;
    bool lacks_memory;
};

static uint32_t floats_of(const stored_mesh *mesh)
{
    uint32_t floats = 0;

    for (int a = 0; a < ATTRIBUTES; ++a)
        floats += mesh->components[a];
    return floats;
}

static void store_primitive(context *gl, GLenum mode, const gn_mesh *mesh)
{
    list_compiler *const c = gl->list.compiler;
    const immediate_state *const im = &gl->immediate;
    stored_mesh stored = {mode, mesh->count, NULL, {0}, 0, NULL, 0};
    captured_mesh *captured;
    GLfloat *to;

    for (int a = 0; a < ATTRIBUTES; ++a)
        if (mesh->attribute[a].data)
            stored.components[a] = a == SECONDARY_AND_FOG ? 4 : im->size[a];
    stored.stride = floats_of(&stored);
    captured = malloc(sizeof *captured + (size_t)stored.count * stored.stride * sizeof *to);
    if (!captured) {
        c->lacks_memory = true;
        return;
    }
    captured->next = NULL;
    captured->mesh = stored;
    *c->last_captured = captured;
    c->last_captured = &captured->next;
    to = captured->vertex;
    for (uint32_t v = 0; v < stored.count; ++v)
        for (int a = 0; a < ATTRIBUTES; ++a) {
            const char *const from = (const char *)mesh->attribute[a].data;

            if (stored.components[a])
                memcpy(to, from + (size_t)v * mesh->attribute[a].stride,
                       stored.components[a] * sizeof *to);
            to += stored.components[a];
        }
}

list_compiler *create_compiler(void)
{
    list_compiler *const c = calloc(1, sizeof *c);

    if (!c)
        return NULL;
    c->immediate.store = store_primitive;
    c->immediate.unknown = UINT32_MAX;
    c->last_captured = &c->first_captured;
    return c;
}

void destroy_compiler(list_compiler *c)
{
    free(c->immediate.vertex);
    free(c);
}

/* Exchanges the context's vertices and current values with the compiler's. */
static void swap_immediate(context *gl)
{
    list_compiler *const c = gl->list.compiler;
    const immediate_state immediate = gl->immediate;
    const current_state current = gl->current;

    gl->immediate = c->immediate;
    gl->current = c->current;
    c->immediate = immediate;
    c->current = current;
}

/* Notes which attributes have been set, and forgets the layout of vertices. */
static void note_attributes(immediate_state *im)
{
    for (int a = 0; a <= ATTRIBUTES; ++a)
        if (im->size[a])
            im->unknown &= ~(1u << a);
    memset(im->size, 0, sizeof im->size);
}

/* Learns the current values that the calls up to `last` leave. */
static void see_calls(context *gl, const list_call *last)
{
    list_compiler *const c = gl->list.compiler;

    while (c->seen != last) {
        list_call *const call = c->seen ? c->seen->next : gl->list.compiled->first;

        if (call->kind == CALL_OF_LIST)
            gl->immediate.unknown = UINT32_MAX;
        else if (call->kind == CALL_VERTEX)
            call->replay(arguments_of(call));
        note_attributes(&gl->immediate);
        c->seen = call;
    }
}

/* Whether calls are whole primitives of vertices and nothing else. Arguments of glBegin are its
 * mode. */
static bool is_vertices_only(const list_call *call)
{
    bool is_inside = false;

    for (; call; call = call->next) {
        if (call->kind == (is_inside ? CALL_END : CALL_BEGIN)) {
            if (!is_inside && *(const GLenum *)(const void *)(call + 1) > GL_POLYGON)
                return false;
            is_inside = !is_inside;
        } else if (!is_inside || call->kind != CALL_VERTEX) {
            return false;
        }
    }
    return !is_inside;
}

static void replay_mesh(void *arguments)
{
    const stored_mesh *const stored = arguments;
    context *const gl = current_context();
    const GLfloat *from = stored->vertex;
    gn_mesh mesh;

    if (gl->immediate.is_inside) {
        gl_error(gl, GL_INVALID_OPERATION, "glCallList");
        return;
    }
    flush_vertices(gl);
    memset(&mesh, 0, sizeof mesh);
    for (int a = 0; a < ATTRIBUTES; ++a) {
        if (!stored->components[a])
            continue;
        mesh.attribute[a].data = from;
        mesh.attribute[a].components = stored->components[a];
        mesh.attribute[a].stride = stored->stride * (uint32_t)sizeof *from;
        from += stored->components[a];
    }
    mesh.vertex_count = mesh.count = stored->count;
    if (stored->index) {
        mesh.indices = stored->index;
        mesh.index_format = GN_INDEX_UINT32;
        mesh.count = stored->indices;
    }
    draw_mesh(gl, stored->mode, &mesh, "glCallList");
}

static void replay_current(void *arguments)
{
    const stored_current *const stored = arguments;
    context *const gl = current_context();

    flush_vertices(gl);
    for (int a = 0; a <= ATTRIBUTES; ++a) {
        const int name = a == FOG_COORDINATE_ATTRIBUTE ? SECONDARY_AND_FOG : a;
        const size_t first = a == FOG_COORDINATE_ATTRIBUTE ? 3 : 0;
        const size_t count = first ? 1 : a == SECONDARY_AND_FOG ? 3 : 4;

        if (stored->set >> a & 1u)
            memcpy(&gl->current.attribute[name][first], &stored->current.attribute[name][first],
                   count * sizeof(GLfloat));
    }
    if (stored->current.edge_flag != UNSET_FLAG)
        gl->current.edge_flag = stored->current.edge_flag;
    if (!isnan(stored->current.index))
        gl->current.index = stored->current.index;
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

/* Whether two primitives of consecutive vertices can be drawn as one. */
static bool can_join(const stored_mesh *a, const stored_mesh *b)
{
    return a->mode == b->mode && vertices_of_each(a->mode) &&
           memcmp(a->components, b->components, sizeof a->components) == 0;
}

/* Returns how many elements the triangles of `count` vertices have. In lists the reference always
 * divides quads between the second corner and the last one. */
static size_t elements_of(GLenum mode, uint32_t count)
{
    return mode == GL_QUADS ? (size_t)count / 4 * 6 : count;
}

static uint32_t element_of(GLenum mode, size_t i)
{
    static const uint32_t corners[6] = {0, 1, 3, 1, 2, 3};

    return mode == GL_QUADS ? (uint32_t)(i / 6 * 4) + corners[i % 6] : (uint32_t)i;
}

/* Makes an indexed mesh of triangles or quads, in which each vertex is stored once. `joined` has
 * their vertices. Returns false, and changes nothing, if memory is short. */
static bool store_triangles(display_list *list, GLfloat *joined, stored_mesh *mesh)
{
    const size_t indices = elements_of(mesh->mode, mesh->count);
    uint32_t *const number = malloc(mesh->count * sizeof *number);
    uint32_t *const index =
        indices > UINT32_MAX ? NULL : list_memory(list, indices * sizeof *index);
    const uint32_t kept =
        number && index ? share_vertices(joined, mesh->count, mesh->stride, number) : 0;
    const size_t bytes = (size_t)kept * mesh->stride * sizeof *joined;
    GLfloat *const vertex = kept ? list_memory(list, bytes) : NULL;

    if (vertex) {
        memcpy(vertex, joined, bytes);
        for (size_t i = 0; i < indices; ++i)
            index[i] = number[element_of(mesh->mode, i)];
        mesh->mode = GL_TRIANGLES;
        mesh->count = kept;
        mesh->vertex = vertex;
        mesh->index = index;
        mesh->indices = (uint32_t)indices;
    }
    free(number);
    return vertex != NULL;
}

/* Stores vertices as they are. */
static void store_vertices(display_list *list, const GLfloat *joined, stored_mesh *mesh)
{
    const size_t bytes = (size_t)mesh->count * mesh->stride * sizeof *joined;
    GLfloat *const vertex = list_memory(list, bytes);

    if (vertex)
        memcpy(vertex, joined, bytes);
    else
        mesh->count = 0;
    mesh->vertex = vertex;
}

/* Appends captured primitives that can be joined as one mesh; drops them from the compiler. */
static void append_joined(list_compiler *c, display_list *list)
{
    const stored_mesh first = c->first_captured->mesh;
    const uint32_t each = vertices_of_each(first.mode);
    stored_mesh *const at = append_call(list, replay_mesh, sizeof *at, CALL_OTHER);
    stored_mesh joined = first;
    size_t vertices = 0;
    GLfloat *vertex;

    for (const captured_mesh *m = c->first_captured; m; m = m->next) {
        if (m != c->first_captured && !can_join(&first, &m->mesh))
            break;
        vertices += m->mesh.count;
    }
    vertex = malloc(vertices * first.stride * sizeof *vertex + 1); /* never of size 0 */
    joined.count = 0;
    do {
        captured_mesh *const m = c->first_captured;
        const uint32_t count = each ? m->mesh.count / each * each : m->mesh.count;

        if (vertex) {
            memcpy(vertex + (size_t)joined.count * first.stride, m->vertex,
                   (size_t)count * first.stride * sizeof *vertex);
            joined.count += count;
        }
        c->first_captured = m->next;
        free(m);
    } while (c->first_captured && can_join(&first, &c->first_captured->mesh));
    c->lacks_memory |= !vertex;
    if (joined.count && !(each >= 3 && store_triangles(list, vertex, &joined)))
        store_vertices(list, vertex, &joined);
    free(vertex);
    if (at)
        *at = joined;
}

/* Replaces the calls of the group by its meshes. */
static void append_meshes(context *gl, const stored_current *current)
{
    list_compiler *const c = gl->list.compiler;
    display_list *const list = gl->list.compiled;

    while (list->blocks != c->block) {
        list_block *const block = list->blocks;

        list->blocks = *(list_block **)(void *)block;
        free(block);
    }
    list->used = c->used;
    list->last = c->before;
    if (c->before)
        c->before->next = NULL;
    else
        list->first = NULL;
    while (c->first_captured)
        append_joined(c, list);
    c->last_captured = &c->first_captured;
    if (current) {
        stored_current *const at = append_call(list, replay_current, sizeof *at, CALL_OTHER);

        if (at)
            *at = *current;
    }
    c->seen = list->last;
}

static void store_group(context *gl)
{
    list_compiler *const c = gl->list.compiler;
    const display_list *const list = gl->list.compiled;
    list_call *const first = c->before ? c->before->next : list->first;
    stored_current current;
    bool keeps_current;

    c->has_group = false;
    if (!is_vertices_only(first))
        return;
    swap_immediate(gl);
    see_calls(gl, c->before);
    gl->current.edge_flag = UNSET_FLAG;
    gl->current.index = NAN;
    for (list_call *call = first; call; call = call->next)
        call->replay(arguments_of(call));
    current.set = 0;
    for (int a = NORMAL; a <= ATTRIBUTES; ++a)
        current.set |= (uint32_t)(gl->immediate.size[a] != 0) << a;
    current.current = gl->current;
    if (gl->immediate.count)
        memcpy(current.current.attribute, gl->immediate.vertex[gl->immediate.count - 1],
               sizeof current.current.attribute);
    keeps_current = gl->immediate.keeps_current;
    if (!keeps_current)
        gl->immediate.unknown &= ~current.set;
    flush_vertices(gl);
    swap_immediate(gl);
    append_meshes(gl, keeps_current ? NULL : &current);
    if (c->lacks_memory)
        gl_error(gl, GL_OUT_OF_MEMORY, "glNewList");
    c->lacks_memory = false;
}

void before_call(context *gl, call_kind kind)
{
    list_compiler *const c = gl->list.compiler;
    const display_list *const list = gl->list.compiled;

    if (c->is_inside) {
        c->is_inside = kind != CALL_END;
        return;
    }
    if (kind != CALL_BEGIN) {
        if (c->has_group)
            store_group(gl);
        return;
    }
    if (!c->has_group) {
        c->before = list->last;
        c->block = list->blocks;
        c->used = list->used;
        c->has_group = true;
    }
    c->is_inside = true;
}
