/* Primitives of a glTF's meshes (section 3.7.2): attributes, indices and topology. */
#include <stdio.h>
#include <string.h>

#include "gltf.h"

/* What the components of an attribute are. */
typedef enum attribute_values {
    VALUES_ANY,       /* floats or integers */
    VALUES_FRACTIONS, /* floats, or integers that are normalized even if the accessor is silent */
    VALUES_NUMBERS    /* unsigned integers of 8 or 16 bits */
} attribute_values;

typedef struct attribute_rule {
    const char *name;
    uint32_t least, most; /* components */
    attribute_values values;
} attribute_rule;

/* Section 3.7.2.1; KHR_mesh_quantization allows more types of components. */
static const attribute_rule position_rule = {"POSITION", 3, 3, VALUES_ANY};
static const attribute_rule normal_rule = {"NORMAL", 3, 3, VALUES_FRACTIONS};
static const attribute_rule tangent_rule = {"TANGENT", 4, 4, VALUES_FRACTIONS};
static const attribute_rule color_rule = {"COLOR_0", 3, 4, VALUES_FRACTIONS};

/* Reads an attribute that is there; its count must be that of POSITION, unless that is 0. */
static bool read_attribute(gltf *g, uint32_t attributes, const attribute_rule *rule,
                           uint32_t vertices, gltf_accessor *a)
{
    const uint32_t token = json_member(&g->j, attributes, rule->name);
    uint32_t index;
    if (token == JSON_NONE)
        return true;
    if (!gltf_index_of(g, token, GLTF_ACCESSORS, &index) || !gltf_read_accessor(g, index, a))
        return false;
    const bool is_number = a->component_type == GLTF_U8 || a->component_type == GLTF_U16;
    if (a->components < rule->least || a->components > rule->most ||
        a->component_type == GLTF_U32 || (rule->values == VALUES_NUMBERS && !is_number))
        return reader_fail_at(g->r, gltf_path(g, token),
                              "its accessor is of a type that the attribute cannot have");
    if (vertices != 0 && a->count != vertices)
        return reader_fail_at(g->r, gltf_path(g, token), "has %u elements, but POSITION has %u",
                              (unsigned)a->count, (unsigned)vertices);
    if (rule->values != VALUES_ANY)
        a->is_normalized = rule->values == VALUES_FRACTIONS && a->component_type != GLTF_F32;
    return true;
}

/* Reads an attribute of which there are several, "TEXCOORD_1". */
static bool read_numbered(gltf *g, uint32_t attributes, const char *name, uint32_t number,
                          uint32_t components, attribute_values values, uint32_t vertices,
                          gltf_accessor *a)
{
    char text[32];
    snprintf(text, sizeof text, "%s_%u", name, (unsigned)number);
    const attribute_rule rule = {text, components, components, values};
    return read_attribute(g, attributes, &rule, vertices, a);
}

static bool begins_with(const char *text, const char *beginning)
{
    return strncmp(text, beginning, strlen(beginning)) == 0;
}

/* Warns of attributes that are not drawn. Those whose names begin with _ are for other programs;
 * texture coordinates are chosen by materials. */
static void warn_of_attributes(gltf *g, uint32_t attributes)
{
    static const char *const read[] = {"POSITION", "NORMAL",   "TANGENT",   "COLOR_0",
                                       "JOINTS_0", "JOINTS_1", "WEIGHTS_0", "WEIGHTS_1"};
    for (uint32_t e = json_first(&g->j, attributes); e != JSON_NONE; e = json_after(&g->j, e)) {
        char name[64];
        json_copy(&g->j, json_name(&g->j, e), name, sizeof name);
        bool is_read = name[0] == '_' || begins_with(name, "TEXCOORD_");
        for (size_t i = 0; i < sizeof read / sizeof read[0]; ++i)
            is_read = is_read || strcmp(name, read[i]) == 0;
        if (!is_read)
            reader_warn(g->r, gltf_path(g, attributes), "%s is not drawn", name);
    }
}

static bool read_attributes(gltf *g, uint32_t attributes, gltf_primitive *p)
{
    const gltf_material *material;
    if (!gltf_read_material(g, p->material, &material) ||
        !read_attribute(g, attributes, &position_rule, 0, &p->position))
        return false;
    const uint32_t vertices = p->position.count;
    if (!gltf_has_bytes(g, json_member(&g->j, attributes, "POSITION"), &p->position) ||
        !read_attribute(g, attributes, &normal_rule, vertices, &p->normal) ||
        !read_attribute(g, attributes, &tangent_rule, vertices, &p->tangent) ||
        !read_attribute(g, attributes, &color_rule, vertices, &p->color) ||
        !read_numbered(g, attributes, "TEXCOORD", material->texcoord, 2, VALUES_ANY, vertices,
                       &p->texcoord))
        return false;
    for (uint32_t s = 0; s < GLTF_JOINT_SETS; ++s)
        if (!read_numbered(g, attributes, "JOINTS", s, 4, VALUES_NUMBERS, vertices,
                           &p->joints[s]) ||
            !read_numbered(g, attributes, "WEIGHTS", s, 4, VALUES_FRACTIONS, vertices,
                           &p->weights[s]))
            return false;
    if (material->has_maps && p->texcoord.count == 0)
        reader_warn(g->r, gltf_path(g, attributes),
                    "there is no TEXCOORD_%u, so that the maps of the material are not drawn",
                    (unsigned)material->texcoord);
    warn_of_attributes(g, attributes);
    return true;
}

uint32_t gltf_source_count(const gltf_primitive *p)
{
    return p->is_indexed ? p->indices.count : p->position.count;
}

uint32_t *gltf_source_indices(gltf *g, const gltf_primitive *p)
{
    const uint32_t count = gltf_source_count(p);
    uint32_t *const source = reader_allocate(g->r, count, sizeof *source);
    if (source == NULL)
        return NULL;
    if (p->is_indexed)
        gltf_integers(&p->indices, 0, count, source);
    else
        for (uint32_t i = 0; i < count; ++i)
            source[i] = i;
    return source;
}

typedef struct index_list {
    uint32_t *indices; /* null: only counted */
    uint64_t count;
    uint32_t first;
} index_list;

static void add_index(index_list *list, uint32_t index)
{
    if (list->indices != NULL)
        list->indices[list->count] = index - list->first;
    ++list->count;
}

static void add_line(index_list *list, uint32_t a, uint32_t b)
{
    add_index(list, a);
    add_index(list, b);
}

static void add_triangle(index_list *list, uint32_t a, uint32_t b, uint32_t c, bool is_turned)
{
    add_index(list, a);
    add_index(list, is_turned ? c : b);
    add_index(list, is_turned ? b : c);
}

static void expand_lines(const gltf_primitive *p, const uint32_t *source, uint32_t count,
                         index_list *list)
{
    const uint32_t step = p->mode == 1 ? 2 : 1;
    for (uint32_t i = 0; count >= 2 && i < count - 1; i += step)
        add_line(list, source[i], source[i + 1]);
    if (p->mode == 2 && count >= 2)
        add_line(list, source[count - 1], source[0]);
}

static void expand_triangles(const gltf_primitive *p, const uint32_t *source, uint32_t count,
                             bool is_turned, index_list *list)
{
    const uint32_t step = p->mode == 4 ? 3 : 1;
    for (uint32_t i = 0; count >= 3 && i < count - 2; i += step) {
        const uint32_t *const v = source + i;
        if (p->mode == 6)
            add_triangle(list, v[1], v[2], source[0], is_turned);
        else if (p->mode == 4)
            add_triangle(list, v[0], v[1], v[2], is_turned);
        /* Strips are joined by triangles without area, which are not drawn. */
        else if (v[0] != v[1] && v[1] != v[2] && v[2] != v[0])
            add_triangle(list, v[0], v[1 + i % 2], v[2 - i % 2], is_turned);
    }
}

uint64_t gltf_expand(const gltf_primitive *p, const uint32_t *source, bool is_turned,
                     uint32_t *indices)
{
    const uint32_t count = gltf_source_count(p);
    index_list list = {indices, 0, p->first_vertex};
    if (p->kind == MODEL_POINTS)
        for (uint32_t i = 0; i < count; ++i)
            add_index(&list, source[i]);
    else if (p->kind == MODEL_LINES)
        expand_lines(p, source, count, &list);
    else
        expand_triangles(p, source, count, is_turned, &list);
    return list.count;
}

static bool check_index_type(gltf *g, uint32_t token, const gltf_accessor *a)
{
    if (a->components != 1 || (a->component_type != GLTF_U8 && a->component_type != GLTF_U16 &&
                               a->component_type != GLTF_U32))
        return reader_fail_at(g->r, gltf_path(g, token),
                              "its accessor has no single unsigned integers");
    return true;
}

/* Finds the vertices that the indices name. */
static bool find_range(gltf *g, uint32_t place, const uint32_t *source, gltf_primitive *p)
{
    const uint32_t count = gltf_source_count(p);
    const uint32_t restart = p->indices.component_type == GLTF_U8    ? 0xff
                             : p->indices.component_type == GLTF_U16 ? 0xffff
                                                                     : 0xffffffff;
    uint32_t least = UINT32_MAX, most = 0;
    for (uint32_t i = 0; i < count; ++i) {
        least = source[i] < least ? source[i] : least;
        most = source[i] > most ? source[i] : most;
    }
    if (p->is_indexed && most == restart)
        return reader_fail_at(g->r, gltf_path(g, place),
                              "an index is %u, the value that restarts primitives elsewhere and "
                              "is not allowed",
                              (unsigned)most);
    if (most >= p->position.count)
        return reader_fail_at(g->r, gltf_path(g, place),
                              "an index is %u, but POSITION has %u vertices", (unsigned)most,
                              (unsigned)p->position.count);
    p->first_vertex = least;
    p->vertex_count = most - least + 1;
    return true;
}

/* Warns if the last indices are no whole primitive. */
static void warn_of_rest(gltf *g, const gltf_primitive *p)
{
    const uint32_t count = gltf_source_count(p), corners = model_corners(p->kind);
    const uint32_t rest = p->mode == 1 || p->mode == 4 ? count % corners : 0;
    if (count < corners || rest != 0)
        reader_warn(g->r, gltf_path(g, p->token),
                    "the last indices are no whole primitive; they are left out");
}

static bool read_indices(gltf *g, gltf_primitive *p)
{
    const uint32_t token = json_member(&g->j, p->token, "indices");
    if (token != JSON_NONE) {
        uint32_t index;
        if (!gltf_index_of(g, token, GLTF_ACCESSORS, &index) ||
            !gltf_read_accessor(g, index, &p->indices) || !check_index_type(g, token, &p->indices))
            return false;
        p->is_indexed = true;
    }
    uint32_t *const source = gltf_source_indices(g, p);
    if (source == NULL)
        return false;
    const bool good = find_range(g, token != JSON_NONE ? token : p->token, source, p);
    if (good)
        p->index_count = gltf_expand(p, source, false, NULL);
    reader_release(g->r, source, gltf_source_count(p), sizeof *source);
    warn_of_rest(g, p);
    return good;
}

/* Morph targets move what the base has (section 3.7.2.2). */
static void warn_of_targets(gltf *g, const gltf_primitive *p)
{
    for (uint32_t t = json_first(&g->j, p->targets); t != JSON_NONE; t = json_after(&g->j, t))
        for (uint32_t e = json_first(&g->j, t); e != JSON_NONE; e = json_after(&g->j, e)) {
            const uint32_t name = json_name(&g->j, e);
            char text[64];
            if (!json_is(&g->j, name, "POSITION") && !json_is(&g->j, name, "NORMAL") &&
                !json_is(&g->j, name, "TANGENT"))
                reader_warn(g->r, gltf_path(g, t), "morph targets of %s are not drawn",
                            json_copy(&g->j, name, text, sizeof text));
        }
}

bool gltf_read_target(gltf *g, const gltf_primitive *p, uint32_t target, const char *name,
                      gltf_accessor *a)
{
    const attribute_rule rule = {name, 3, 3, name[0] == 'P' ? VALUES_ANY : VALUES_FRACTIONS};
    memset(a, 0, sizeof *a);
    return read_attribute(g, target, &rule, p->position.count, a);
}

/* The group of a primitive: that of others with equal material, kind and attributes, or a new one.
 */
static bool find_group(gltf *g, gltf_primitive *p)
{
    gltf_material *const m = g->materials + p->material;
    const bool has_normals = p->normal.count != 0, has_texcoords = p->texcoord.count != 0;
    const bool has_colors = p->color.count != 0;
    for (p->group = m->first_group; p->group != GLTF_NONE; p->group = g->groups[p->group].next) {
        const gltf_group *const group = g->groups + p->group;
        if (group->kind == p->kind && group->has_normals == has_normals &&
            group->has_texcoords == has_texcoords && group->has_colors == has_colors)
            return true;
    }
    if (!reader_grow(g->r, &g->groups, &g->group_capacity, g->group_count + 1, sizeof *g->groups))
        return false;
    p->group = (uint32_t)g->group_count++;
    g->groups[p->group] = (gltf_group){
        p->kind, has_normals, has_texcoords, has_colors, p->material, m->first_group, 0, 0, 0, 0,
        0};
    m->first_group = p->group;
    return true;
}

/* Reads a primitive; its vertex_count is 0 if it cannot be drawn. */
static bool read_primitive(gltf *g, uint32_t token, gltf_primitive *p)
{
    uint32_t attributes;
    uint64_t mode = 4;
    memset(p, 0, sizeof *p);
    p->token = token;
    p->material = g->tables[GLTF_MATERIALS].count;
    p->next = GLTF_NONE;
    if (!gltf_container(g, token, "attributes", JSON_OBJECT, &attributes) ||
        !gltf_container(g, token, "targets", JSON_ARRAY, &p->targets) ||
        !gltf_integer(g, token, "mode", 6, &mode) ||
        !gltf_index(g, token, "material", GLTF_MATERIALS, &p->material))
        return false;
    p->mode = (uint32_t)mode;
    p->kind = mode == 0 ? MODEL_POINTS : mode <= 3 ? MODEL_LINES : MODEL_TRIANGLES;
    if (json_member(&g->j, attributes, "POSITION") == JSON_NONE) {
        reader_warn(g->r, gltf_path(g, token), "has no POSITION and is not drawn");
        return true;
    }
    if (!read_attributes(g, attributes, p) || !read_indices(g, p) || !find_group(g, p))
        return false;
    warn_of_targets(g, p);
    return true;
}

bool gltf_read_mesh(gltf *g, uint32_t mesh)
{
    uint32_t list, last = GLTF_NONE;
    if (g->is_mesh_read[mesh])
        return true;
    if (!gltf_container(g, gltf_element(g, GLTF_MESHES, mesh), "primitives", JSON_ARRAY, &list))
        return false;
    g->is_mesh_read[mesh] = true;
    g->meshes[mesh] = GLTF_NONE;
    for (uint32_t e = json_first(&g->j, list); e != JSON_NONE; e = json_after(&g->j, e)) {
        if (!reader_grow(g->r, &g->primitives, &g->primitive_capacity, g->primitive_count + 1,
                         sizeof *g->primitives))
            return false;
        if (!read_primitive(g, e, g->primitives + g->primitive_count))
            return false;
        if (g->primitives[g->primitive_count].index_count == 0)
            continue;
        *(last == GLTF_NONE ? g->meshes + mesh : &g->primitives[last].next) =
            (uint32_t)g->primitive_count;
        last = (uint32_t)g->primitive_count++;
    }
    return true;
}
