/* The hierarchy of nodes of a glTF (section 3.5.3): where meshes, joints and lights are. */
#include <math.h>
#include <string.h>

#include "gltf.h"

gltf_matrix gltf_identity(void)
{
    gltf_matrix m;
    memset(&m, 0, sizeof m);
    for (int i = 0; i < 3; ++i)
        m.m[i][i] = 1.0;
    return m;
}

gltf_matrix gltf_multiply(const gltf_matrix *a, const gltf_matrix *b)
{
    gltf_matrix m;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) {
            double sum = column == 3 ? a->m[3][row] : 0.0;
            for (int k = 0; k < 3; ++k)
                sum += a->m[k][row] * b->m[column][k];
            m.m[column][row] = sum;
        }
    return m;
}

double gltf_determinant(const gltf_matrix *m)
{
    const double *const a = m->m[0], *const b = m->m[1], *const c = m->m[2];
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/* Translation times rotation times scale; the rotation is a quaternion x, y, z, w of any length
 * but 0. */
static gltf_matrix compose(const double t[3], const double r[4], const double s[3])
{
    gltf_matrix m = gltf_identity();
    const double square = r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3];
    const double two = square > 0.0 ? 2.0 / square : 0.0;
    const double x = r[0], y = r[1], z = r[2], w = r[3];
    m.m[0][0] = 1.0 - two * (y * y + z * z);
    m.m[0][1] = two * (x * y + w * z);
    m.m[0][2] = two * (x * z - w * y);
    m.m[1][0] = two * (x * y - w * z);
    m.m[1][1] = 1.0 - two * (x * x + z * z);
    m.m[1][2] = two * (y * z + w * x);
    m.m[2][0] = two * (x * z + w * y);
    m.m[2][1] = two * (y * z - w * x);
    m.m[2][2] = 1.0 - two * (x * x + y * y);
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            m.m[column][row] *= s[column];
    memcpy(m.m[3], t, sizeof m.m[3]);
    return m;
}

static gltf_matrix of_columns(const double values[16])
{
    gltf_matrix m;
    for (int column = 0; column < 4; ++column)
        memcpy(m.m[column], values + 4 * (size_t)column, sizeof m.m[column]);
    return m;
}

static bool read_local(gltf *g, uint32_t token, gltf_matrix *local)
{
    double values[16], t[3] = {0.0, 0.0, 0.0}, r[4] = {0.0, 0.0, 0.0, 1.0}, s[3] = {1.0, 1.0, 1.0};
    if (json_member(&g->j, token, "matrix") != JSON_NONE) {
        if (!gltf_numbers(g, token, "matrix", 16, values))
            return false;
        if (values[3] != 0.0 || values[7] != 0.0 || values[11] != 0.0 || values[15] != 1.0)
            reader_warn(g->r, gltf_path(g, token),
                        "the last row of its matrix is not 0 0 0 1, but is taken for it");
        *local = of_columns(values);
        return true;
    }
    if (!gltf_numbers(g, token, "translation", 3, t) || !gltf_numbers(g, token, "rotation", 4, r) ||
        !gltf_numbers(g, token, "scale", 3, s))
        return false;
    *local = compose(t, r, s);
    return true;
}

static bool find_children(gltf *g, uint32_t node, uint32_t *list)
{
    return gltf_container(g, gltf_element(g, GLTF_NODES, node), "children", JSON_ARRAY, list);
}

/* Sets the parent of every node that is a child. */
static bool read_parents(gltf *g)
{
    const uint32_t count = g->tables[GLTF_NODES].count;
    for (uint32_t i = 0; i < count; ++i)
        g->parents[i] = GLTF_NONE;
    for (uint32_t i = 0; i < count; ++i) {
        uint32_t list;
        if (!find_children(g, i, &list))
            return false;
        for (uint32_t e = json_first(&g->j, list); e != JSON_NONE; e = json_after(&g->j, e)) {
            uint32_t child;
            if (!gltf_index_of(g, e, GLTF_NODES, &child))
                return false;
            if (g->parents[child] != GLTF_NONE)
                return reader_fail_at(g->r, gltf_path(g, gltf_element(g, GLTF_NODES, child)),
                                      "the node is a child of two nodes, or twice of one");
            g->parents[child] = i;
        }
    }
    return true;
}

/* Appends the nodes that an array names to a list in which some are already. */
static bool append_nodes(gltf *g, uint32_t array, uint32_t *list, bool *is_there, uint32_t *length)
{
    for (uint32_t e = json_first(&g->j, array); e != JSON_NONE; e = json_after(&g->j, e)) {
        uint32_t node;
        if (!gltf_index_of(g, e, GLTF_NODES, &node))
            return false;
        if (!is_there[node])
            list[(*length)++] = node;
        is_there[node] = true;
    }
    return true;
}

/* Appends the children of all nodes of a list, also of those that are appended. */
static bool append_children(gltf *g, uint32_t *list, bool *is_there, uint32_t *length)
{
    for (uint32_t at = 0; at < *length; ++at) {
        uint32_t array;
        if (!find_children(g, list[at], &array) || !append_nodes(g, array, list, is_there, length))
            return false;
    }
    return true;
}

/* Lists all nodes, parents first, and computes their matrices. */
static bool compute_world(gltf *g, uint32_t *list, bool *is_there)
{
    const uint32_t count = g->tables[GLTF_NODES].count;
    uint32_t length = 0;
    for (uint32_t i = 0; i < count; ++i) {
        is_there[i] = g->parents[i] == GLTF_NONE;
        if (is_there[i])
            list[length++] = i;
    }
    if (!append_children(g, list, is_there, &length))
        return false;
    for (uint32_t i = 0; i < count; ++i)
        if (!is_there[i])
            return reader_fail_at(g->r, gltf_path(g, gltf_element(g, GLTF_NODES, i)),
                                  "the node is its own descendant, or a descendant of such a node");
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t node = list[i], parent = g->parents[node];
        gltf_matrix local;
        if (!read_local(g, gltf_element(g, GLTF_NODES, node), &local))
            return false;
        g->world[node] = parent != GLTF_NONE ? gltf_multiply(g->world + parent, &local) : local;
    }
    return true;
}

/* Lists the nodes of the scene; without a scene all are drawn. */
static bool list_scene(gltf *g, uint32_t *list, bool *is_there, uint32_t *length)
{
    const uint32_t count = g->tables[GLTF_NODES].count;
    uint32_t scene = 0;
    *length = 0;
    for (uint32_t i = 0; i < count; ++i)
        is_there[i] = false;
    if (!gltf_index(g, JSON_ROOT, "scene", GLTF_SCENES, &scene))
        return false;
    if (g->tables[GLTF_SCENES].count == 0) {
        for (; *length < count; ++*length)
            list[*length] = *length;
        return true;
    }
    uint32_t nodes;
    return gltf_container(g, gltf_element(g, GLTF_SCENES, scene), "nodes", JSON_ARRAY, &nodes) &&
           append_nodes(g, nodes, list, is_there, length) &&
           append_children(g, list, is_there, length);
}

static bool place(gltf *g, uint32_t node, uint32_t mesh, const gltf_matrix *world)
{
    if (!reader_grow(g->r, &g->placements, &g->placement_capacity, g->placement_count + 1,
                     sizeof *g->placements))
        return false;
    g->placements[g->placement_count++] = (gltf_placement){node, mesh, *world};
    return true;
}

/* Reads an attribute of EXT_mesh_gpu_instancing. All have one count. */
static bool read_instances(gltf *g, uint32_t attributes, const char *name, uint32_t components,
                           gltf_accessor *a, uint32_t *count)
{
    uint32_t index = GLTF_NONE;
    if (!gltf_index(g, attributes, name, GLTF_ACCESSORS, &index))
        return false;
    if (index == GLTF_NONE)
        return true;
    if (!gltf_read_accessor(g, index, a))
        return false;
    if (a->components != components || a->component_type == GLTF_U32)
        return reader_fail_at(g->r, gltf_path(g, json_member(&g->j, attributes, name)),
                              "its accessor is of a type that the attribute cannot have");
    if (!gltf_has_bytes(g, json_member(&g->j, attributes, name), a))
        return false;
    if (*count != 0 && *count != a->count)
        return reader_fail_at(g->r, gltf_path(g, attributes),
                              "its attributes have different counts: %u and %u", (unsigned)*count,
                              (unsigned)a->count);
    *count = a->count;
    return true;
}

static void instance_values(const gltf_accessor *a, uint32_t instance, double *values)
{
    float floats[4];
    if (a->count == 0)
        return;
    gltf_floats(a, NULL, instance, 1, floats);
    for (uint32_t c = 0; c < a->components; ++c)
        values[c] = (double)floats[c];
}

/* EXT_mesh_gpu_instancing: the mesh is drawn at every instance instead of at the node. */
static bool place_instances(gltf *g, uint32_t node, uint32_t mesh, uint32_t extension)
{
    uint32_t attributes;
    gltf_accessor translation, rotation, scale;
    uint32_t count = 0;
    bool good = true;
    memset(&translation, 0, sizeof translation);
    rotation = scale = translation;
    if (!gltf_container(g, extension, "attributes", JSON_OBJECT, &attributes) ||
        !read_instances(g, attributes, "TRANSLATION", 3, &translation, &count) ||
        !read_instances(g, attributes, "ROTATION", 4, &rotation, &count) ||
        !read_instances(g, attributes, "SCALE", 3, &scale, &count))
        return false;
    if (count == 0)
        return reader_fail_at(g->r, gltf_path(g, extension),
                              "has no TRANSLATION, ROTATION or SCALE");
    for (uint32_t i = 0; i < count && good; ++i) {
        double t[3] = {0.0, 0.0, 0.0}, r[4] = {0.0, 0.0, 0.0, 1.0}, s[3] = {1.0, 1.0, 1.0};
        instance_values(&translation, i, t);
        instance_values(&rotation, i, r);
        instance_values(&scale, i, s);
        const gltf_matrix local = compose(t, r, s), world = gltf_multiply(g->world + node, &local);
        good = place(g, node, mesh, &world);
    }
    return good;
}

static bool read_mesh_of(gltf *g, uint32_t node)
{
    const uint32_t token = gltf_element(g, GLTF_NODES, node);
    const uint32_t instancing = gltf_extension(g, token, "EXT_mesh_gpu_instancing");
    uint32_t mesh = GLTF_NONE;
    if (!gltf_index(g, token, "mesh", GLTF_MESHES, &mesh))
        return false;
    if (mesh == GLTF_NONE)
        return true;
    const bool has_skin = json_member(&g->j, token, "skin") != JSON_NONE;
    if (instancing != JSON_NONE && has_skin)
        reader_warn(g->r, gltf_path(g, instancing),
                    "instances of a mesh with a skin are not drawn");
    if (instancing == JSON_NONE || has_skin)
        return place(g, node, mesh, g->world + node);
    return place_instances(g, node, mesh, instancing);
}

static bool read_light_values(gltf *g, uint32_t token, model_light *light)
{
    const uint32_t type = json_member(&g->j, token, "type");
    const uint32_t spot = json_member(&g->j, token, "spot");
    double color[3] = {1.0, 1.0, 1.0}, intensity = 1.0, range = 0.0;
    double inner = 0.0, outer = 0.78539816339744831; /* a quarter of pi */
    if (json_is(&g->j, type, "directional"))
        light->kind = GN_LIGHT_DIRECTIONAL;
    else if (json_is(&g->j, type, "point"))
        light->kind = GN_LIGHT_POINT;
    else if (json_is(&g->j, type, "spot"))
        light->kind = GN_LIGHT_SPOT;
    else
        return reader_fail_at(g->r, gltf_path(g, token),
                              "its type is none of directional, point and spot");
    if (!gltf_numbers(g, token, "color", 3, color) ||
        !gltf_number(g, token, "intensity", &intensity) ||
        !gltf_number(g, token, "range", &range) ||
        !gltf_number(g, spot, "innerConeAngle", &inner) ||
        !gltf_number(g, spot, "outerConeAngle", &outer))
        return false;
    for (int c = 0; c < 3; ++c)
        light->color[c] = (float)(color[c] * intensity);
    light->range = (float)range;
    light->inner = (float)inner;
    light->outer = (float)outer;
    return true;
}

/* KHR_lights_punctual: a light shines along -z of its node, whose scale does not matter. */
static bool read_light(gltf *g, uint32_t node)
{
    const uint32_t token = gltf_element(g, GLTF_NODES, node);
    const uint32_t extension = gltf_extension(g, token, "KHR_lights_punctual");
    model *const m = g->r->result;
    uint32_t index = GLTF_NONE;
    if (!gltf_index(g, extension, "light", GLTF_LIGHTS, &index))
        return false;
    if (index == GLTF_NONE)
        return true;
    model_light *const light = m->lights + m->light_count;
    if (!read_light_values(g, gltf_element(g, GLTF_LIGHTS, index), light))
        return false;
    const gltf_matrix *const world = g->world + node;
    const double *const z = world->m[2];
    const double length = sqrt(z[0] * z[0] + z[1] * z[1] + z[2] * z[2]);
    for (int c = 0; c < 3; ++c) {
        light->position[c] = world->m[3][c];
        light->direction[c] = length > 0.0 ? (float)(-z[c] / length) : c == 2 ? -1.0f : 0.0f;
    }
    ++m->light_count;
    return true;
}

/* Reads what the nodes of the scene hold. */
static bool read_contents(gltf *g, const uint32_t *list, uint32_t length)
{
    uint32_t lights = 0;
    for (uint32_t i = 0; i < length; ++i)
        lights += gltf_extension(g, gltf_element(g, GLTF_NODES, list[i]), "KHR_lights_punctual") !=
                  JSON_NONE;
    if (lights > 0) {
        g->r->result->lights = reader_allocate(g->r, lights, sizeof(model_light));
        if (g->r->result->lights == NULL)
            return false;
    }
    for (uint32_t i = 0; i < length; ++i)
        if (!read_mesh_of(g, list[i]) || !read_light(g, list[i]))
            return false;
    return true;
}

bool gltf_read_nodes(gltf *g)
{
    const uint32_t count = g->tables[GLTF_NODES].count;
    uint32_t *const list = reader_allocate(g->r, count, sizeof *list);
    bool *const is_there = reader_allocate(g->r, count, sizeof *is_there);
    uint32_t length = 0;
    g->parents = reader_allocate(g->r, count, sizeof *g->parents);
    g->world = reader_allocate(g->r, count, sizeof *g->world);
    const bool good = list != NULL && is_there != NULL && g->parents != NULL && g->world != NULL &&
                      read_parents(g) && compute_world(g, list, is_there) &&
                      list_scene(g, list, is_there, &length) && read_contents(g, list, length);
    reader_release(g->r, list, count, sizeof *list);
    reader_release(g->r, is_there, count, sizeof *is_there);
    return good;
}

/* The inverse bind matrices of a skin, in place of which joints begin; identities without them. */
static bool read_inverse_bind(gltf *g, uint32_t token, gltf_skin *s)
{
    uint32_t index = GLTF_NONE;
    gltf_accessor a;
    for (uint32_t i = 0; i < s->joint_count; ++i)
        s->joints[i] = gltf_identity();
    if (!gltf_index(g, token, "inverseBindMatrices", GLTF_ACCESSORS, &index))
        return false;
    if (index == GLTF_NONE)
        return true;
    if (!gltf_read_accessor(g, index, &a))
        return false;
    if (a.components != 16 || a.component_type != GLTF_F32 || a.count < s->joint_count)
        return reader_fail_at(g->r, gltf_path(g, json_member(&g->j, token, "inverseBindMatrices")),
                              "its accessor has no matrix of floats for each of %u joints",
                              (unsigned)s->joint_count);
    for (uint32_t i = 0; i < s->joint_count; ++i) {
        float floats[16];
        double values[16];
        gltf_floats(&a, NULL, i, 1, floats);
        for (int k = 0; k < 16; ++k)
            values[k] = (double)floats[k];
        s->joints[i] = of_columns(values);
    }
    return true;
}

/* Section 3.7.3.3: a joint's matrix is its node's place times the inverse bind matrix. The place of
 * the node with the mesh has no influence. */
bool gltf_read_skin(gltf *g, uint32_t index, const gltf_skin **skin)
{
    gltf_skin *const s = g->skins + index;
    const uint32_t token = gltf_element(g, GLTF_SKINS, index);
    uint32_t joints;
    *skin = s;
    if (s->joints != NULL)
        return true;
    if (!gltf_container(g, token, "joints", JSON_ARRAY, &joints))
        return false;
    const uint32_t count = json_count(&g->j, joints);
    if (count == 0)
        return reader_fail_at(g->r, gltf_path(g, token), "has no joints");
    s->joints = reader_allocate(g->r, count, sizeof *s->joints);
    if (s->joints == NULL)
        return false;
    s->joint_count = count;
    if (!read_inverse_bind(g, token, s))
        return false;
    uint32_t i = 0;
    for (uint32_t e = json_first(&g->j, joints); e != JSON_NONE; e = json_after(&g->j, e), ++i) {
        uint32_t node;
        if (!gltf_index_of(g, e, GLTF_NODES, &node))
            return false;
        s->joints[i] = gltf_multiply(g->world + node, s->joints + i);
    }
    return true;
}
