/* Reads glTF 2.0: the container, the version and the extensions; then the stages of gltf.h. */
#include "gltf.h"

#include <string.h>

#include "read.h"

/* Extensions that are drawn. */
static const char *const drawn[] = {"KHR_texture_transform",
                                    "KHR_materials_unlit",
                                    "KHR_mesh_quantization",
                                    "KHR_materials_emissive_strength",
                                    "KHR_materials_pbrSpecularGlossiness",
                                    "KHR_lights_punctual",
                                    "EXT_mesh_gpu_instancing"};

/* Extensions that change nothing of what is drawn. */
static const char *const without_effect[] = {"FB_ngon_encoding", "KHR_xmp", "KHR_xmp_json_ld"};

static bool is_one_of(const gltf *g, uint32_t name, const char *const *names, size_t count)
{
    bool found = false;
    for (size_t i = 0; i < count; ++i)
        found = found || json_is(&g->j, name, names[i]);
    return found;
}

static bool is_drawn(const gltf *g, uint32_t name)
{
    return is_one_of(g, name, drawn, sizeof drawn / sizeof drawn[0]) ||
           is_one_of(g, name, without_effect, sizeof without_effect / sizeof without_effect[0]);
}

/* Section 3.12: a file whose required extensions are not known must not be drawn. */
static bool check_extensions(gltf *g)
{
    uint32_t required, used;
    char name[128];
    if (!gltf_container(g, JSON_ROOT, "extensionsRequired", JSON_ARRAY, &required) ||
        !gltf_container(g, JSON_ROOT, "extensionsUsed", JSON_ARRAY, &used))
        return false;
    for (uint32_t e = json_first(&g->j, required); e != JSON_NONE; e = json_after(&g->j, e))
        if (!is_drawn(g, e))
            return reader_fail_at(g->r, gltf_path(g, e),
                                  "the file requires the extension %s, which is not read",
                                  json_copy(&g->j, e, name, sizeof name));
    for (uint32_t e = json_first(&g->j, used); e != JSON_NONE; e = json_after(&g->j, e))
        if (!is_drawn(g, e))
            reader_warn(g->r, gltf_path(g, e), "the extension %s is not drawn",
                        json_copy(&g->j, e, name, sizeof name));
    return true;
}

/* Section 3.2: minVersion, if it is there, decides instead of version. */
static bool check_version(gltf *g)
{
    const uint32_t asset = json_member(&g->j, JSON_ROOT, "asset");
    const uint32_t least = json_member(&g->j, asset, "minVersion");
    const uint32_t version = json_member(&g->j, asset, "version");
    const uint32_t decides = least != JSON_NONE ? least : version;
    char text[32];
    if (json_kind_of(&g->j, version) != JSON_STRING)
        return reader_fail_at(g->r, "/asset/version", "there is none, so that this is no glTF 2.0");
    json_copy(&g->j, decides, text, sizeof text);
    if (strncmp(text, "2.", 2) != 0 || (least != JSON_NONE && strcmp(text, "2.0") != 0))
        return reader_fail_at(g->r, gltf_path(g, decides),
                              "this is glTF %s, but only glTF 2.0 is read", text);
    return true;
}

static void warn_of_rest(gltf *g)
{
    const uint32_t animations = json_member(&g->j, JSON_ROOT, "animations");
    const uint32_t cameras = json_member(&g->j, JSON_ROOT, "cameras");
    if (json_first(&g->j, animations) != JSON_NONE)
        reader_warn(g->r, gltf_path(g, animations), "animations are not drawn: the rest pose is");
    if (json_first(&g->j, cameras) != JSON_NONE)
        reader_warn(g->r, gltf_path(g, cameras), "cameras are not used");
}

static bool is_container(const model_reader *r)
{
    return r->size >= 4 && memcmp(r->bytes, "glTF", 4) == 0;
}

static bool check_header(model_reader *r, size_t *end)
{
    if (r->size < 12)
        return reader_fail(r, "the file ends within its header of 12 bytes");
    const uint32_t version = reader_word(r->bytes + 4), length = reader_word(r->bytes + 8);
    if (version != 2)
        return reader_fail(r, "this is binary glTF of version %u, but only version 2 is read",
                           (unsigned)version);
    if (length > r->size || length < 12)
        return reader_fail(r,
                           "it is cut short: the header says that it has %u bytes, but it has %llu",
                           (unsigned)length, (unsigned long long)r->size);
    if (length < r->size)
        reader_warn(r, NULL, "bytes behind the end that the header names are left out");
    *end = length;
    return true;
}

/* The chunks of a container (section 4.4.3): the first is the JSON, the second may be a buffer. */
static bool read_chunks(gltf *g, const uint8_t **text, size_t *size)
{
    model_reader *const r = g->r;
    size_t end = 0, at = 12;
    if (!check_header(r, &end))
        return false;
    for (unsigned chunk = 0; at < end; ++chunk) {
        if (end - at < 8)
            return reader_fail(r, "the file ends within the header of chunk %u", chunk);
        const uint32_t length = reader_word(r->bytes + at);
        const uint8_t *const type = r->bytes + at + 4;
        at += 8;
        if (length > end - at)
            return reader_fail(r, "chunk %u has %u bytes, but only %llu follow", chunk,
                               (unsigned)length, (unsigned long long)(end - at));
        if (chunk == 0) {
            if (memcmp(type, "JSON", 4) != 0)
                return reader_fail(r, "the first chunk is not the JSON");
            *text = r->bytes + at;
            *size = length;
            /* Some writers pad the JSON by zeros instead of blanks. */
            while (*size > 0 && (*text)[*size - 1] == '\0')
                --*size;
        } else if (chunk == 1 && memcmp(type, "BIN", 4) == 0) {
            g->binary = r->bytes + at;
            g->binary_size = length;
        } else {
            reader_warn(r, NULL, "a chunk that is neither JSON nor BIN is left out");
        }
        at += length;
    }
    return *text != NULL || reader_fail(r, "the file has no chunks");
}

/* Allocates what has one entry for each element of a table. */
static bool allocate(gltf *g)
{
    const gltf_elements *const t = g->tables;
    g->buffers = reader_allocate(g->r, t[GLTF_BUFFERS].count, sizeof *g->buffers);
    g->images = reader_allocate(g->r, t[GLTF_IMAGES].count, sizeof *g->images);
    g->materials = reader_allocate(g->r, (size_t)t[GLTF_MATERIALS].count + 1, sizeof *g->materials);
    g->skins = reader_allocate(g->r, t[GLTF_SKINS].count, sizeof *g->skins);
    g->meshes = reader_allocate(g->r, t[GLTF_MESHES].count, sizeof *g->meshes);
    g->is_mesh_read = reader_allocate(g->r, t[GLTF_MESHES].count, sizeof *g->is_mesh_read);
    for (uint32_t i = 0; g->images != NULL && i < t[GLTF_IMAGES].count; ++i)
        g->images[i] = GLTF_NONE;
    return g->buffers != NULL && g->images != NULL && g->materials != NULL && g->skins != NULL &&
           g->meshes != NULL && g->is_mesh_read != NULL;
}

static void free_all(gltf *g)
{
    const gltf_elements *const t = g->tables;
    gltf_free_buffers(g);
    for (uint32_t i = 0; g->skins != NULL && i < t[GLTF_SKINS].count; ++i)
        reader_release(g->r, g->skins[i].joints, g->skins[i].joint_count, sizeof(gltf_matrix));
    reader_release(g->r, g->images, t[GLTF_IMAGES].count, sizeof *g->images);
    reader_release(g->r, g->materials, (size_t)t[GLTF_MATERIALS].count + 1, sizeof *g->materials);
    reader_release(g->r, g->skins, t[GLTF_SKINS].count, sizeof *g->skins);
    reader_release(g->r, g->meshes, t[GLTF_MESHES].count, sizeof *g->meshes);
    reader_release(g->r, g->is_mesh_read, t[GLTF_MESHES].count, sizeof *g->is_mesh_read);
    reader_release(g->r, g->parents, t[GLTF_NODES].count, sizeof *g->parents);
    reader_release(g->r, g->world, t[GLTF_NODES].count, sizeof *g->world);
    reader_release(g->r, g->primitives, g->primitive_capacity, sizeof *g->primitives);
    reader_release(g->r, g->groups, g->group_capacity, sizeof *g->groups);
    reader_release(g->r, g->placements, g->placement_capacity, sizeof *g->placements);
    gltf_free_tables(g);
    json_free(g->r, &g->j);
}

/* Whether a text begins as an object does, behind a byte-order mark and blanks. */
static bool begins_with_brace(const uint8_t *text, size_t size)
{
    size_t at = size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    while (at < size &&
           (text[at] == ' ' || text[at] == '\t' || text[at] == '\r' || text[at] == '\n'))
        ++at;
    return at < size && text[at] == '{';
}

bool read_gltf(model_reader *r, bool is_binary)
{
    gltf g;
    const uint8_t *text = NULL;
    size_t size = 0;
    memset(&g, 0, sizeof g);
    g.r = r;
    if (is_container(r)) {
        if (!read_chunks(&g, &text, &size))
            return false;
    } else if (is_binary) {
        return reader_fail(r, "this is no binary glTF: it does not begin with 'glTF'");
    } else {
        text = r->bytes;
        size = r->size;
    }
    if (!begins_with_brace(text, size))
        return reader_fail(r, "is not a glTF file: it does not begin with {");
    bool good = json_parse(r, text, size, &g.j);
    good = good && check_version(&g) && check_extensions(&g) && gltf_read_tables(&g) &&
           allocate(&g) && gltf_read_nodes(&g) && gltf_make_parts(&g);
    if (good)
        warn_of_rest(&g);
    free_all(&g);
    return good;
}
