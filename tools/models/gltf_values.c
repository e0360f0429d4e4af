/* Values of a glTF's JSON: each is checked where it is read. */
#include <float.h>
#include <math.h>

#include "gltf.h"

static const char table_names[GLTF_TABLES][12] = {
    "accessors", "bufferViews", "buffers", "images", "materials", "meshes",
    "nodes",     "samplers",    "scenes",  "skins",  "textures",  "lights"};

const char *gltf_path(gltf *g, uint32_t token)
{
    return json_path(&g->j, token, g->path, sizeof g->path);
}

uint32_t gltf_element(const gltf *g, gltf_table table, uint32_t index)
{
    return g->tables[table].tokens[index];
}

/* Reads an integer from 0 to `most`. */
static bool integer_of(gltf *g, uint32_t token, uint64_t most, uint64_t *value)
{
    double number;
    if (!json_number(&g->j, token, &number) || !(number >= 0.0) || number > (double)most ||
        number != floor(number))
        return reader_fail_at(g->r, gltf_path(g, token), "is no integer from 0 to %llu",
                              (unsigned long long)most);
    *value = (uint64_t)number;
    return true;
}

bool gltf_integer(gltf *g, uint32_t object, const char *name, uint64_t most, uint64_t *value)
{
    const uint32_t token = json_member(&g->j, object, name);
    return token == JSON_NONE || integer_of(g, token, most, value);
}

/* Reads a number that fits a float. */
static bool number_of(gltf *g, uint32_t token, double *value)
{
    return (json_number(&g->j, token, value) && fabs(*value) <= (double)FLT_MAX) ||
           reader_fail_at(g->r, gltf_path(g, token), "is no number that fits");
}

bool gltf_number(gltf *g, uint32_t object, const char *name, double *value)
{
    const uint32_t token = json_member(&g->j, object, name);
    return token == JSON_NONE || number_of(g, token, value);
}

bool gltf_numbers(gltf *g, uint32_t object, const char *name, uint32_t count, double *values)
{
    const uint32_t token = json_member(&g->j, object, name);
    if (token == JSON_NONE)
        return true;
    if (json_kind_of(&g->j, token) != JSON_ARRAY || json_count(&g->j, token) != count)
        return reader_fail_at(g->r, gltf_path(g, token), "is no array of %u numbers",
                              (unsigned)count);
    bool good = true;
    for (uint32_t e = json_first(&g->j, token); e != JSON_NONE && good; e = json_after(&g->j, e))
        good = number_of(g, e, values++);
    return good;
}

bool gltf_boolean(gltf *g, uint32_t object, const char *name, bool *value)
{
    const uint32_t token = json_member(&g->j, object, name);
    if (token == JSON_NONE)
        return true;
    const json_kind kind = json_kind_of(&g->j, token);
    *value = kind == JSON_TRUE;
    return kind == JSON_TRUE || kind == JSON_FALSE ||
           reader_fail_at(g->r, gltf_path(g, token), "is neither true nor false");
}

bool gltf_container(gltf *g, uint32_t object, const char *name, json_kind kind, uint32_t *token)
{
    *token = json_member(&g->j, object, name);
    return *token == JSON_NONE || json_kind_of(&g->j, *token) == kind ||
           reader_fail_at(g->r, gltf_path(g, *token), "is no %s",
                          kind == JSON_ARRAY ? "array" : "object");
}

bool gltf_index_of(gltf *g, uint32_t token, gltf_table table, uint32_t *value)
{
    uint64_t number = 0;
    if (!integer_of(g, token, UINT32_MAX - 1, &number))
        return false;
    *value = (uint32_t)number;
    return number < g->tables[table].count ||
           reader_fail_at(g->r, gltf_path(g, token), "is %llu, but there are %u %s",
                          (unsigned long long)number, (unsigned)g->tables[table].count,
                          table_names[table]);
}

bool gltf_index(gltf *g, uint32_t object, const char *name, gltf_table table, uint32_t *value)
{
    const uint32_t token = json_member(&g->j, object, name);
    return token == JSON_NONE || gltf_index_of(g, token, table, value);
}

uint32_t gltf_extension(const gltf *g, uint32_t object, const char *name)
{
    return json_member(&g->j, json_member(&g->j, object, "extensions"), name);
}

bool gltf_read_tables(gltf *g)
{
    const json *const j = &g->j;
    for (int t = 0; t < GLTF_TABLES; ++t) {
        const uint32_t object =
            t == GLTF_LIGHTS ? gltf_extension(g, JSON_ROOT, "KHR_lights_punctual") : JSON_ROOT;
        uint32_t array;
        if (!gltf_container(g, object, table_names[t], JSON_ARRAY, &array))
            return false;
        if (array == JSON_NONE)
            continue;
        gltf_elements *const e = g->tables + t;
        const uint32_t count = json_count(j, array);
        e->tokens = reader_allocate(g->r, count, sizeof *e->tokens);
        if (e->tokens == NULL)
            return false;
        for (uint32_t i = json_first(j, array); i != JSON_NONE; i = json_after(j, i)) {
            if (json_kind_of(j, i) != JSON_OBJECT)
                return reader_fail_at(g->r, gltf_path(g, i), "is no object");
            e->tokens[e->count++] = i;
        }
    }
    return true;
}

void gltf_free_tables(gltf *g)
{
    for (int t = 0; t < GLTF_TABLES; ++t)
        reader_release(g->r, g->tables[t].tokens, g->tables[t].count, sizeof(uint32_t));
}
