/* OBJ files with their material file: any text is a model whose parts are sound, or a fault. What
 * stands behind the first byte 0x1e is the material file, whatever name it has. */
#include <math.h>
#include <string.h>

#include "../../tools/models/read.h"
#include "fuzz.h"

#define BUDGET ((uint64_t)4 << 20)

static bool open_material(void *user, const char *name, model_file *file, const char **reason)
{
    const model_file *const material = user;
    *reason = "there is none";
    *file = *material;
    return material->bytes != NULL && name[0] != '!';
}

static void close_material(void *user, model_file *file)
{
    (void)user;
    FUZZ_REQUIRE(file->size <= BUDGET);
}

static bool are_finite(const float *values, size_t count)
{
    bool good = true;
    for (size_t i = 0; i < count; ++i)
        good = good && isfinite(values[i]);
    return good;
}

static void look_at_part(const model *m, const model_part *part)
{
    const size_t vertices = part->vertex_count;
    FUZZ_REQUIRE(part->index_count % model_corners(part->kind) == 0);
    for (size_t i = 0; i < part->index_count; ++i)
        FUZZ_REQUIRE(part->indices[i] < part->vertex_count);
    FUZZ_REQUIRE(are_finite(part->positions, 3 * vertices));
    FUZZ_REQUIRE(are_finite(part->normals, 3 * vertices));
    FUZZ_REQUIRE(are_finite(part->colors, 4 * vertices));
    FUZZ_REQUIRE(part->has_texcoords == (part->texcoords != NULL));
    FUZZ_REQUIRE(!part->has_texcoords || are_finite(part->texcoords, 2 * vertices));
    FUZZ_REQUIRE(!part->has_tangents || are_finite(part->tangents, 4 * vertices));
    for (size_t v = 0; v < vertices; ++v) {
        const float *const n = part->normals + 3 * v;
        FUZZ_REQUIRE(n[0] != 0.0f || n[1] != 0.0f || n[2] != 0.0f);
    }
    FUZZ_REQUIRE(part->surface.shine.exponent >= 1 &&
                 part->surface.shine.exponent <= MODEL_MAX_EXPONENT);
    for (int i = 0; i < MAP_COUNT; ++i)
        FUZZ_REQUIRE(part->maps[i].image == MODEL_NO_IMAGE || part->maps[i].image < m->image_count);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    const uint8_t *const end = size > 0 ? memchr(bytes, 0x1e, size) : NULL;
    const size_t length = end != NULL ? (size_t)(end - bytes) : size;
    model_file material = {NULL, 0, NULL};
    model m;
    model_messages messages;
    if (end != NULL)
        material = (model_file){end + 1, size - length - 1, NULL};
    const model_files files = {&material, open_material, close_material};

    const bool good =
        model_read_bytes("x.obj", MODEL_OBJ, bytes, length, &files, BUDGET, &m, &messages);

    FUZZ_REQUIRE(good == (messages.fault_file[0] == '\0'));
    FUZZ_REQUIRE(good || (m.part_count == 0 && messages.fault[0] != '\0'));
    for (size_t i = 0; i < m.part_count; ++i)
        look_at_part(&m, m.parts + i);
    model_free(&m);
    model_messages_free(&messages);
    return 0;
}
