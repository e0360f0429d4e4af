/* Shrinks meshes: to separate triangles instead of strips, fans and indices, to fewer triangles,
 * and to fewer attributes. */
#include <stdlib.h>
#include <string.h>

#include "shrink_parts.h"

static void *allocated(size_t count, size_t size)
{
    void *memory = malloc(count > 0 ? count * size : 1);
    if (!memory) {
        fprintf(stderr, "shrink: out of memory\n");
        exit(EXIT_FAILURE);
    }
    return memory;
}

mesh_selection mesh_select_all(const gn_mesh *mesh)
{
    const mesh_selection all = {NULL,        mesh->vertex_count, true,
                                mesh->first, mesh->count,        (1u << GN_MAX_ATTRIBUTES) - 1};
    return all;
}

static void copy_attribute(const gn_mesh *from, int attribute, const mesh_selection *selection,
                           scene_draw *to)
{
    const gn_attribute *a = &from->attribute[attribute];
    if (!a->data || !(selection->attributes >> attribute & 1))
        return;
    const size_t stride = a->stride ? a->stride : a->components * sizeof(float);
    float *data = allocated((size_t)selection->vertex_count * a->components, sizeof *data);
    for (uint32_t i = 0; i < selection->vertex_count; ++i) {
        const size_t vertex = selection->vertices ? selection->vertices[i] : i;
        memcpy(data + (size_t)i * a->components, (const char *)a->data + vertex * stride,
               a->components * sizeof *data);
    }
    scene_set_attribute(to, (gn_shader_attribute)attribute, data, a->components,
                        selection->vertex_count);
    free(data);
}

static void copy_draw(scene *to, const scene_draw *from, const mesh_selection *selection)
{
    scene_draw *d = scene_add_draw(to);
    *d = *from;
    d->index_count = 0;
    memset(&d->mesh, 0, sizeof d->mesh);
    memset(&d->uniforms.texture, 0, sizeof d->uniforms.texture);
    memset(d->surface.map, 0, sizeof d->surface.map);
    for (int a = 0; a < GN_MAX_ATTRIBUTES; ++a)
        copy_attribute(&from->mesh, a, selection, d);
    if (selection->keep_indices && from->mesh.index_format != GN_INDEX_NONE) {
        uint32_t *indices = allocated(from->index_count, sizeof *indices);
        for (uint32_t i = 0; i < from->index_count; ++i)
            indices[i] = scene_vertex_of(&from->mesh, i);
        scene_set_indices(d, indices, from->index_count, from->mesh.index_format);
        free(indices);
    }
    for (int a = 0; a < GN_MAX_ATTRIBUTES; ++a)
        if (d->mesh.attribute[a].data)
            d->mesh.attribute[a].divisor = from->mesh.attribute[a].divisor;
    /* An array has an element for each vertex, and must have an element for each instance. */
    d->mesh.instance_count = from->mesh.instance_count < selection->vertex_count
                                 ? from->mesh.instance_count
                                 : selection->vertex_count;
    if (selection->keep_indices) {
        d->mesh.restart = from->mesh.restart;
        d->mesh.restart_index = from->mesh.restart_index;
        d->mesh.base_vertex = from->mesh.base_vertex;
    }
    d->mesh.vertex_count = selection->vertex_count;
    d->mesh.first = selection->first;
    d->mesh.count = selection->count;
    if (scene_draw_has_texture(from))
        scene_set_levels(d, &from->uniforms.texture);
    for (int m = 0; m < SCENE_MAP_COUNT; ++m)
        if (scene_draw_has_map(from, (scene_map)m))
            scene_set_map(d, (scene_map)m, &from->surface.map[m]);
}

scene *copy_with_selection(const scene *s, size_t draw, const mesh_selection *selection)
{
    scene *copy = scene_create(s->width, s->height, s->color_format, s->depth_format);
    *copy = *s;
    copy->draws = NULL;
    copy->draw_count = 0;
    for (size_t i = 0; i < s->draw_count; ++i) {
        const mesh_selection all = mesh_select_all(&s->draws[i].mesh);
        copy_draw(copy, &s->draws[i], i == draw ? selection : &all);
    }
    return copy;
}

static bool is_restart(const gn_mesh *mesh, uint32_t i)
{
    const uint32_t largest = mesh->index_format == GN_INDEX_UINT8    ? UINT8_MAX
                             : mesh->index_format == GN_INDEX_UINT16 ? UINT16_MAX
                                                                     : UINT32_MAX;
    return scene_vertex_of(mesh, mesh->first + i) ==
           (mesh->restart == GN_RESTART_INDEX ? mesh->restart_index : largest);
}

/* Keeps the elements of the first primitive. */
static uint32_t least_elements(gn_topology topology)
{
    return topology == GN_POINTS ? 1 : topology >= GN_LINES ? 2 : 3;
}

/* Keeps one of the runs of elements between restarts, without the restarts. */
static bool separate_runs(shrinking *s, size_t draw)
{
    const gn_mesh *mesh = &s->best->draws[draw].mesh;
    const uint32_t least = least_elements(s->best->draws[draw].state.raster.topology);
    for (uint32_t start = 0, end; start < mesh->count; start = end + 1) {
        for (end = start; end < mesh->count && !is_restart(mesh, end);)
            ++end;
        if (end - start < least)
            continue;
        mesh_selection selection = mesh_select_all(mesh);
        selection.first = mesh->first + start;
        selection.count = end - start;
        scene *copy = copy_with_selection(s->best, draw, &selection);
        copy->draws[draw].mesh.restart = GN_RESTART_NONE;
        if (shrink_try(s, copy))
            return true;
    }
    return false;
}

/* Writes out the drawn elements of a mesh, without indices. */
static bool remove_indices(shrinking *s, size_t draw)
{
    const gn_mesh *mesh = &s->best->draws[draw].mesh;
    if (mesh->index_format == GN_INDEX_NONE && mesh->first == 0 &&
        mesh->count == mesh->vertex_count)
        return false;
    if (mesh->index_format != GN_INDEX_NONE && mesh->restart != GN_RESTART_NONE)
        return separate_runs(s, draw);
    uint32_t *vertices = allocated(mesh->count, sizeof *vertices);
    bool inside = true; /* a failing scene may have indices beyond the vertices */
    for (uint32_t i = 0; i < mesh->count; ++i) {
        vertices[i] = scene_vertex_of(mesh, mesh->first + i) + (uint32_t)mesh->base_vertex;
        inside = inside && vertices[i] < mesh->vertex_count;
    }
    mesh_selection selection = {vertices, mesh->count, false, 0, mesh->count, ~0u};
    const bool kept = inside && shrink_try(s, copy_with_selection(s->best, draw, &selection));
    free(vertices);
    return kept;
}

/* Turns a mesh into separate triangles with the same provoking vertices; needs no indices. */
static bool separate_triangles(shrinking *s, size_t draw)
{
    const scene_draw *d = &s->best->draws[draw];
    if ((d->state.raster.topology != GN_TRIANGLE_STRIP &&
         d->state.raster.topology != GN_TRIANGLE_FAN) ||
        d->mesh.index_format != GN_INDEX_NONE || d->mesh.count < 3)
        return false;
    const bool first_provokes = d->state.raster.provoking_vertex == GN_PROVOKING_FIRST;
    const uint32_t count = 3 * (d->mesh.count - 2);
    uint32_t *vertices = allocated(count, sizeof *vertices);
    for (uint32_t i = 0; i < d->mesh.count - 2; ++i) {
        const uint32_t e = d->mesh.first + i;
        uint32_t corner[3] = {e, e + 1, e + 2};
        if (d->state.raster.topology == GN_TRIANGLE_FAN) {
            /* In a fan whose first vertex provokes, the provoking vertex is the second of the
             * three. */
            corner[0] = first_provokes ? e + 1 : d->mesh.first;
            corner[1] = first_provokes ? e + 2 : e + 1;
            corner[2] = first_provokes ? d->mesh.first : e + 2;
        } else if (i & 1) {
            corner[0] = first_provokes ? e : e + 1;
            corner[1] = first_provokes ? e + 2 : e;
            corner[2] = first_provokes ? e + 1 : e + 2;
        }
        memcpy(vertices + 3 * i, corner, sizeof corner);
    }
    mesh_selection selection = {vertices, count, false, 0, count, ~0u};
    scene *candidate = copy_with_selection(s->best, draw, &selection);
    candidate->draws[draw].state.raster.topology = GN_TRIANGLES;
    free(vertices);
    return shrink_try(s, candidate);
}

/* Turns a mesh into separate lines; needs no indices. */
static bool separate_lines(shrinking *s, size_t draw)
{
    const scene_draw *d = &s->best->draws[draw];
    const bool loop = d->state.raster.topology == GN_LINE_LOOP;
    if ((d->state.raster.topology != GN_LINE_STRIP && !loop) ||
        d->mesh.index_format != GN_INDEX_NONE || d->mesh.count < 2)
        return false;
    const uint32_t lines = loop ? d->mesh.count : d->mesh.count - 1;
    uint32_t *vertices = allocated(2 * (size_t)lines, sizeof *vertices);
    for (uint32_t i = 0; i < lines; ++i) {
        vertices[2 * i] = d->mesh.first + i;
        vertices[2 * i + 1] = d->mesh.first + (i + 1) % d->mesh.count;
    }
    const mesh_selection selection = {vertices, 2 * lines, false, 0, 2 * lines, ~0u};
    scene *candidate = copy_with_selection(s->best, draw, &selection);
    candidate->draws[draw].state.raster.topology = GN_LINES;
    free(vertices);
    return shrink_try(s, candidate);
}

/* Returns the best scene without `length` drawn elements of a draw, from `start` on. With indices,
 * only elements at the two ends can be removed. */
static scene *without_elements(const scene *s, size_t draw, uint32_t start, uint32_t length)
{
    const gn_mesh *mesh = &s->draws[draw].mesh;
    const uint32_t left = mesh->count - length;
    if (mesh->index_format != GN_INDEX_NONE) {
        mesh_selection selection = mesh_select_all(mesh);
        selection.first = start == 0 ? mesh->first + length : mesh->first;
        selection.count = left;
        return copy_with_selection(s, draw, &selection);
    }
    uint32_t *vertices = allocated(left, sizeof *vertices);
    for (uint32_t i = 0; i < left; ++i)
        vertices[i] = mesh->first + (i < start ? i : i + length);
    const mesh_selection selection = {vertices, left, false, 0, left, ~0u};
    scene *copy = copy_with_selection(s, draw, &selection);
    free(vertices);
    return copy;
}

/* Removes triangles: half of them, a quarter, and so on down to single ones. Strips lose an even
 * number of vertices, so that the windings stay. */
static bool remove_triangles(shrinking *s, size_t draw)
{
    bool progress = false;
    const gn_mesh *mesh = &s->best->draws[draw].mesh;
    const gn_topology topology = s->best->draws[draw].state.raster.topology;
    const uint32_t unit = topology == GN_TRIANGLES                                ? 3
                          : topology == GN_TRIANGLE_STRIP || topology == GN_LINES ? 2
                                                                                  : 1;
    const uint32_t least = least_elements(topology);
    for (uint32_t chunk = mesh->count / unit; chunk > 0; chunk /= 2) {
        uint32_t start = 0;
        mesh = &s->best->draws[draw].mesh;
        while (start < mesh->count && s->attempts > 0) {
            uint32_t length = chunk * unit;
            if (length > mesh->count - start)
                length = mesh->count - start;
            const bool end = start == 0 || start + length == mesh->count;
            /* Fewer elements are no primitive; the pass over draws removes the whole draw. */
            if (mesh->count - length < least || (mesh->index_format != GN_INDEX_NONE && !end)) {
                start += length;
                continue;
            }
            if (shrink_try(s, without_elements(s->best, draw, start, length)))
                progress = true;
            else
                start += length;
            mesh = &s->best->draws[draw].mesh;
        }
    }
    return progress;
}

static bool remove_attributes(shrinking *s, size_t draw)
{
    bool progress = false;
    for (int a = 0; a < GN_MAX_ATTRIBUTES; ++a) {
        const gn_mesh *mesh = &s->best->draws[draw].mesh;
        if (!mesh->attribute[a].data || a == GN_ATTRIBUTE_POSITION)
            continue;
        mesh_selection selection = mesh_select_all(mesh);
        selection.attributes &= ~(1u << a);
        if (shrink_try(s, copy_with_selection(s->best, draw, &selection)))
            progress = true;
    }
    return progress;
}

bool shrink_meshes(shrinking *s)
{
    bool progress = false;
    for (size_t i = 0; i < s->best->draw_count; ++i) {
        progress = remove_triangles(s, i) || progress;
        progress = remove_indices(s, i) || progress;
        progress = separate_triangles(s, i) || progress;
        progress = separate_lines(s, i) || progress;
        progress = remove_triangles(s, i) || progress;
        progress = remove_attributes(s, i) || progress;
    }
    return progress;
}
