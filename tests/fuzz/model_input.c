/* Reads a model and requires that it is sound. */
#include "model_input.h"

#include <math.h>

#include "fuzz.h"

static void require_finite(const float *values, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        FUZZ_REQUIRE(isfinite(values[i]));
}

static void require_sound(const model *m, const model_part *p)
{
    const size_t vertices = p->vertex_count;

    FUZZ_REQUIRE(p->index_count % model_corners(p->kind) == 0);
    for (size_t i = 0; i < p->index_count; ++i)
        FUZZ_REQUIRE(p->indices[i] < vertices);
    require_finite(p->positions, 3 * vertices);
    require_finite(p->normals, 3 * vertices);
    require_finite(p->colors, 4 * vertices);
    if (p->has_texcoords)
        require_finite(p->texcoords, 2 * vertices);
    if (p->has_tangents)
        require_finite(p->tangents, 4 * vertices);
    for (size_t v = 0; v < vertices; ++v)
        FUZZ_REQUIRE(p->normals[3 * v] != 0.0f || p->normals[3 * v + 1] != 0.0f ||
                     p->normals[3 * v + 2] != 0.0f);
    for (int i = 0; i < MAP_COUNT; ++i)
        FUZZ_REQUIRE(p->maps[i].image == MODEL_NO_IMAGE || p->maps[i].image < m->image_count);
}

void fuzz_read_model(model_format format, const uint8_t *bytes, size_t size)
{
    model m;
    model_messages messages;

    if (model_read_bytes("model", format, bytes, size, NULL, (uint64_t)4 << 20, &m, &messages)) {
        FUZZ_REQUIRE(messages.fault_file[0] == '\0');
        FUZZ_REQUIRE(isfinite(m.origin[0]) && isfinite(m.origin[1]) && isfinite(m.origin[2]));
        for (size_t p = 0; p < m.part_count; ++p)
            require_sound(&m, &m.parts[p]);
        model_free(&m);
    } else {
        FUZZ_REQUIRE(messages.fault_file[0] != '\0' && messages.fault[0] != '\0');
    }
    model_messages_free(&messages);
}
