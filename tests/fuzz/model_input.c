/* Reads a model and requires that it is sound. */
#include "model_input.h"

#include <math.h>
#include <string.h>

#include "fuzz.h"

#define BUDGET ((uint64_t)4 << 20)

static unsigned open_files;

static bool open_rest(void *user, const char *name, model_file *file, const char **reason)
{
    *reason = "there is none";
    *file = *(const model_file *)user;
    FUZZ_REQUIRE(name != NULL);
    open_files += file->bytes != NULL;
    return file->bytes != NULL;
}

static void close_rest(void *user, model_file *file)
{
    (void)user;
    FUZZ_REQUIRE(file->bytes != NULL);
    --open_files;
}

static void require_finite(const float *values, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        FUZZ_REQUIRE(isfinite(values[i]));
}

static void require_sound_surface(const model_surface *s)
{
    require_finite(s->shine.specular, 3);
    require_finite(s->emissive, 3);
    FUZZ_REQUIRE(s->shine.exponent >= 1 && s->shine.exponent <= MODEL_MAX_EXPONENT);
    FUZZ_REQUIRE(s->metallic >= 0.0f && s->metallic <= 1.0f);
    FUZZ_REQUIRE(s->roughness >= 0.0f && s->roughness <= 1.0f);
    FUZZ_REQUIRE((unsigned)s->alpha <= MODEL_BLEND && s->alpha_cutoff >= 0.0f);
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
    FUZZ_REQUIRE(p->has_texcoords == (p->texcoords != NULL));
    FUZZ_REQUIRE(p->has_tangents == (p->tangents != NULL));
    require_finite(p->texcoords, p->has_texcoords ? 2 * vertices : 0);
    require_finite(p->tangents, p->has_tangents ? 4 * vertices : 0);
    for (size_t v = 0; v < vertices; ++v) {
        const float *const n = p->normals + 3 * v;

        FUZZ_REQUIRE(n[0] != 0.0f || n[1] != 0.0f || n[2] != 0.0f);
        FUZZ_REQUIRE(!p->has_tangents || fabsf(p->tangents[4 * v + 3]) == 1.0f);
    }
    require_sound_surface(&p->surface);
    for (int i = 0; i < MAP_COUNT; ++i)
        FUZZ_REQUIRE(p->maps[i].image == MODEL_NO_IMAGE || p->maps[i].image < m->image_count);
}

static void require_sound_light(const model_light *light)
{
    require_finite(light->color, 3);
    require_finite(light->direction, 3);
    for (int c = 0; c < 3; ++c)
        FUZZ_REQUIRE(isfinite(light->position[c]));
}

void fuzz_read_model(model_format format, const uint8_t *bytes, size_t size)
{
    const bool is_text = format == MODEL_OBJ || format == MODEL_GLTF;
    const uint8_t *const end = is_text && size > 0 ? memchr(bytes, 0x1e, size) : NULL;
    const size_t length = end != NULL ? (size_t)(end - bytes) : size;
    model_file rest = {NULL, 0, NULL};
    model m;
    model_messages messages;

    if (end != NULL)
        rest = (model_file){end + 1, size - length - 1, NULL};
    const model_files files = {&rest, open_rest, close_rest};
    const bool good = model_read_bytes("model", format, bytes, length, &files, BUDGET,
                                       MODEL_CREASE_DEGREES, &m, &messages);

    FUZZ_REQUIRE(open_files == 0);
    FUZZ_REQUIRE(good == (messages.fault_file[0] == '\0'));
    FUZZ_REQUIRE(good || (m.part_count == 0 && messages.fault[0] != '\0'));
    for (size_t p = 0; p < m.part_count; ++p)
        require_sound(&m, &m.parts[p]);
    for (uint32_t i = 0; i < m.light_count; ++i)
        require_sound_light(&m.lights[i]);
    for (int c = 0; c < 3; ++c)
        FUZZ_REQUIRE(isfinite(m.origin[c]));
    model_free(&m);
    model_messages_free(&messages);
}
