/* Chooses the reader of a file, and completes and checks what it has read. */
#include "read.h"

#include <math.h>
#include <string.h>

#include "text.h"

static const char extensions[MODEL_OTHER][8] = {".obj", ".ply", ".stl", ".gltf", ".glb"};

model_format model_format_of(const char *name)
{
    const size_t length = strlen(name);
    for (int f = 0; f < MODEL_OTHER; ++f) {
        const size_t end = strlen(extensions[f]);
        if (length >= end && text_is_any_case((text_word){name + length - end, end}, extensions[f]))
            return (model_format)f;
    }
    return MODEL_OTHER;
}

/* Zeroes numbers that are not finite. Returns how many vertices had one. */
static uint64_t zero_not_finite(float *values, uint32_t vertices, int components)
{
    uint64_t count = 0;
    for (size_t v = 0; values != NULL && v < vertices; ++v) {
        float *const value = values + v * (size_t)components;
        bool is_finite = true;
        for (int c = 0; c < components; ++c)
            is_finite = is_finite && isfinite(value[c]);
        for (int c = 0; c < components && !is_finite; ++c)
            value[c] = 0.0f;
        count += !is_finite;
    }
    return count;
}

static void warn_of(model_reader *r, uint64_t count, const char *one, const char *several)
{
    if (count > 0)
        reader_warn(r, NULL, "%llu %s", (unsigned long long)count, count == 1 ? one : several);
}

/* Checks the numbers of all parts, and warns of those that are replaced. */
static bool check_numbers(model_reader *r)
{
    const model *const m = r->result;
    uint64_t normals = 0, texcoords = 0, colors = 0, flat = 0;
    for (size_t p = 0; p < m->part_count; ++p) {
        const model_part *const part = m->parts + p;
        const uint32_t vertices = part->vertex_count;
        for (size_t i = 0; i < part->index_count; ++i) {
            if (part->indices[i] >= vertices)
                return reader_fail(r, "an index names a vertex that is not there");
            for (size_t c = 0; c < 3; ++c)
                if (!isfinite(part->positions[3 * (size_t)part->indices[i] + c]))
                    return reader_fail(r, "the position of a vertex is not a finite number");
        }
        /* Those that no primitive uses. */
        zero_not_finite(part->positions, vertices, 3);
        normals += zero_not_finite(part->normals, vertices, 3);
        texcoords += zero_not_finite(part->texcoords, vertices, 2);
        colors += zero_not_finite(part->colors, vertices, 4);
        for (size_t i = 0; part->kind == MODEL_TRIANGLES && i < part->index_count; i += 3)
            flat += model_is_flat(part, part->indices + i);
    }
    warn_of(r, normals, "vertex has a normal that is not finite; it is computed from the triangles",
            "vertices have normals that are not finite; they are computed from the triangles");
    warn_of(r, texcoords, "vertex has texture coordinates that are not finite; 0 is used",
            "vertices have texture coordinates that are not finite; 0 is used");
    warn_of(r, colors, "vertex has a colour that is not finite; 0 is used",
            "vertices have colours that are not finite; 0 is used");
    warn_of(r, flat, "triangle has no area and cannot be seen",
            "triangles have no area and cannot be seen");
    return true;
}

static bool complete(model_reader *r, double crease_degrees)
{
    model *const m = r->result;
    uint64_t primitives = 0;
    for (size_t p = 0; p < m->part_count; ++p)
        primitives += m->parts[p].index_count;
    if (primitives == 0)
        return reader_fail(r, "there are no triangles, lines or points in it");
    if (!check_numbers(r))
        return false;
    bool good = model_complete_normals(m, crease_degrees, &r->memory_left);
    for (size_t p = 0; p < m->part_count && good; ++p)
        good = model_tangents_size(m->parts + p) <= r->memory_left &&
               model_complete_tangents(m->parts + p);
    return good || reader_fail(r, "not enough memory");
}

bool model_read_bytes(const char *name, model_format format, const uint8_t *bytes, size_t size,
                      const model_files *files, uint64_t budget, double crease_degrees,
                      model *result, model_messages *messages)
{
    model_reader r = {name, bytes, size, files, budget, result, messages, ""};
    bool good = false;
    memset(result, 0, sizeof *result);
    memset(messages, 0, sizeof *messages);
    if (size == 0)
        return reader_fail(&r, "it is empty");
    switch (format) {
    case MODEL_OBJ:
        good = read_obj(&r);
        break;
    case MODEL_PLY:
        good = read_ply(&r);
        break;
    case MODEL_STL:
        good = read_stl(&r);
        break;
    case MODEL_GLTF:
    case MODEL_GLB:
        good = read_gltf(&r, format == MODEL_GLB);
        break;
    default:
        return reader_fail(&r, "its extension is not that of a model format");
    }
    if (good && complete(&r, crease_degrees))
        return true;
    model_free(result);
    return false;
}
