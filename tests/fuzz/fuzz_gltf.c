/* glTF and binary glTF: any bytes are a model whose parts are sound, or a fault. What stands behind
 * the first byte 0x1e of a text is the contents of every file that it names. */
#include <math.h>
#include <string.h>

#include "../../tools/models/read.h"
#include "fuzz.h"

#define BUDGET ((uint64_t)4 << 20)

static unsigned open_files;

static bool open_rest(void *user, const char *name, model_file *file, const char **reason)
{
    *reason = "there is none";
    *file = *(const model_file *)user;
    FUZZ_REQUIRE(name[0] != '\0');
    open_files += file->bytes != NULL;
    return file->bytes != NULL;
}

static void close_rest(void *user, model_file *file)
{
    (void)user;
    (void)file;
    --open_files;
}

static void require_finite(const float *values, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        FUZZ_REQUIRE(isfinite(values[i]));
}

static void require_sound(const model *m, const model_part *part)
{
    const size_t vertices = part->vertex_count;
    FUZZ_REQUIRE(part->index_count % model_corners(part->kind) == 0);
    for (size_t i = 0; i < part->index_count; ++i)
        FUZZ_REQUIRE(part->indices[i] < part->vertex_count);
    require_finite(part->positions, 3 * vertices);
    require_finite(part->normals, 3 * vertices);
    require_finite(part->colors, 4 * vertices);
    FUZZ_REQUIRE(part->has_texcoords == (part->texcoords != NULL));
    FUZZ_REQUIRE(part->has_tangents == (part->tangents != NULL));
    require_finite(part->texcoords, part->has_texcoords ? 2 * vertices : 0);
    require_finite(part->tangents, part->has_tangents ? 4 * vertices : 0);
    for (size_t v = 0; v < vertices; ++v) {
        const float *const n = part->normals + 3 * v;
        FUZZ_REQUIRE(n[0] != 0.0f || n[1] != 0.0f || n[2] != 0.0f);
        FUZZ_REQUIRE(!part->has_tangents || part->tangents[4 * v + 3] != 0.0f);
    }
    require_finite(part->surface.emissive, 3);
    require_finite(part->surface.shine.specular, 3);
    FUZZ_REQUIRE(part->surface.metallic >= 0.0f && part->surface.metallic <= 1.0f);
    FUZZ_REQUIRE(part->surface.roughness >= 0.0f && part->surface.roughness <= 1.0f);
    FUZZ_REQUIRE(part->surface.shine.exponent >= 1 &&
                 part->surface.shine.exponent <= MODEL_MAX_EXPONENT);
    for (int i = 0; i < MAP_COUNT; ++i)
        FUZZ_REQUIRE(part->maps[i].image == MODEL_NO_IMAGE || part->maps[i].image < m->image_count);
}

static void require_sound_light(const model_light *light)
{
    require_finite(light->color, 3);
    require_finite(light->direction, 3);
    for (int c = 0; c < 3; ++c)
        FUZZ_REQUIRE(isfinite(light->position[c]));
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    const bool is_binary = size >= 4 && memcmp(bytes, "glTF", 4) == 0;
    const uint8_t *const end = !is_binary && size > 0 ? memchr(bytes, 0x1e, size) : NULL;
    const size_t length = end != NULL ? (size_t)(end - bytes) : size;
    model_file rest = {NULL, 0, NULL};
    model m;
    model_messages messages;
    if (end != NULL)
        rest = (model_file){end + 1, size - length - 1, NULL};
    const model_files files = {&rest, open_rest, close_rest};

    const bool good = model_read_bytes("x.gltf", is_binary ? MODEL_GLB : MODEL_GLTF, bytes, length,
                                       &files, BUDGET, &m, &messages);

    FUZZ_REQUIRE(open_files == 0);
    FUZZ_REQUIRE(good == (messages.fault_file[0] == '\0'));
    FUZZ_REQUIRE(good || (m.part_count == 0 && messages.fault[0] != '\0'));
    for (size_t i = 0; i < m.part_count; ++i)
        require_sound(&m, m.parts + i);
    for (uint32_t i = 0; i < m.light_count; ++i)
        require_sound_light(m.lights + i);
    for (int c = 0; c < 3; ++c)
        FUZZ_REQUIRE(isfinite(m.origin[c]));
    model_free(&m);
    model_messages_free(&messages);
    return 0;
}
