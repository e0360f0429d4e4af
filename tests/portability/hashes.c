/* The pictures of the parity suite's scenes as numbers: one for the scenes themselves and one
 * for each back end's frames. They are the same on every machine: values are hashed, not
 * bytes of memory, and all NaN are one. Needs neither OpenGL nor files. */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "generate.h"
#include "scene.h"
#include "scene_pixel.h"

#define DEFAULT_SCENES 440
#define DEFAULT_SEED 1

/* FNV-1a with 64 bits, over 32-bit words. */
typedef uint64_t hash;

#define HASH_EMPTY UINT64_C(0xCBF29CE484222325)

static void add_word(hash *h, uint32_t word)
{
    for (int i = 0; i < 4; i++)
        *h = (*h ^ (word >> 8 * i & 255)) * UINT64_C(0x100000001B3);
}

static void add_float(hash *h, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    add_word(h, value != value ? UINT32_C(0x7FC00000) : bits);
}

static void add_floats(hash *h, const float *values, size_t count)
{
    for (size_t i = 0; i < count; i++)
        add_float(h, values[i]);
}

static void add_pixels(hash *h, const void *pixels, gn_format format, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        switch (format) {
        case GN_FORMAT_RGBA8:
        case GN_FORMAT_D24:
            add_word(h, ((const uint32_t *)pixels)[i]);
            break;
        case GN_FORMAT_D16:
            add_word(h, ((const uint16_t *)pixels)[i]);
            break;
        case GN_FORMAT_D32F:
            add_float(h, ((const float *)pixels)[i]);
            break;
        case GN_FORMAT_RGBA32F:
            add_floats(h, (const float *)pixels + 4 * i, 4);
            break;
        case GN_FORMAT_D24S8:
            add_word(h, ((const uint32_t *)pixels)[i]);
            break;
        case GN_FORMAT_D32FS8:
            add_float(h, ((const float *)pixels)[2 * i]);
            add_word(h, ((const uint32_t *)pixels)[2 * i + 1]);
            break;
        case GN_FORMAT_S8:
            add_word(h, ((const uint8_t *)pixels)[i]);
            break;
        case GN_FORMAT_R32F:
            add_float(h, ((const float *)pixels)[i]);
            break;
        case GN_FORMAT_NONE:
            break;
        default: {
            uint32_t channel[4];
            const int channels = scene_pixel_channels(pixels, format, i, channel);
            for (int c = 0; c < channels; c++)
                add_word(h, channel[c]);
            break;
        }
        }
    }
}

/* What a scene is drawn from, as far as generators could make it differently. */
static void add_scene(hash *h, const scene *s)
{
    add_word(h, s->width);
    add_word(h, s->height);
    add_floats(h, s->clear_color, 4);
    add_float(h, s->clear_depth);
    for (size_t n = 0; n < s->draw_count; n++) {
        const scene_draw *d = &s->draws[n];
        const gn_texture *t = &d->uniforms.texture;
        add_word(h, (uint32_t)d->shader);
        add_word(h, (uint32_t)d->state.topology);
        add_word(h, (uint32_t)d->state.depth_function);
        for (int a = 0; a < GN_MAX_ATTRIBUTES; a++) {
            const gn_attribute *in = &d->mesh.attribute[a];
            if (in->data)
                add_floats(h, in->data, (size_t)in->components * d->mesh.vertex_count);
        }
        for (uint32_t i = 0; i < d->index_count; i++)
            add_word(h, scene_vertex_of(&d->mesh, i));
        for (uint32_t level = 0; t->level[0].texels && level < scene_level_count(t); level++) {
            const scene_extent e = scene_level_extent(t, level);
            add_pixels(h, t->level[level].texels, t->format, (size_t)e.width * e.height * e.layers);
        }
    }
}

static bool draw_scene(const scene *s, gn_backend backend, hash *h)
{
    scene_frame frame;
    if (!scene_frame_allocate(&frame, s)) {
        fprintf(stderr, "hashes: no memory\n");
        return false;
    }
    const gn_status status = scene_draw_library(s, &frame, 0, backend);
    if (status != GN_OK)
        fprintf(stderr, "hashes: the library says: %s\n", gn_status_text(status));
    const size_t pixels = (size_t)s->width * s->height * frame.images;
    for (int a = 0; a < GN_MAX_COLORS; a++)
        add_pixels(h, scene_frame_color(&frame, a), scene_frame_format(&frame, a), pixels);
    add_pixels(h, frame.depth, frame.depth_format, pixels);
    scene_frame_free(&frame);
    return status == GN_OK;
}

static int run(uint64_t seed, uint64_t scenes)
{
    hash made = HASH_EMPTY, drawn[GN_BACKEND_COUNT];
    for (int b = 0; b < GN_BACKEND_COUNT; b++)
        drawn[b] = HASH_EMPTY;
    for (uint64_t i = 0; i < scenes; i++) {
        scene *s = generate_scene(seed, (scene_class)(i % CLASS_COUNT), i / CLASS_COUNT);
        add_scene(&made, s);
        for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; b++)
            if (gn_backend_available((gn_backend)b) && !draw_scene(s, (gn_backend)b, &drawn[b]))
                return 1;
        scene_free(s);
    }
    printf("scenes %016" PRIx64 "\n", made);
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; b++)
        if (gn_backend_available((gn_backend)b))
            printf("%s %016" PRIx64 "\n", gn_backend_name((gn_backend)b), drawn[b]);
    return 0;
}

int main(int argc, char **argv)
{
    uint64_t scenes = DEFAULT_SCENES, seed = DEFAULT_SEED;
    for (int i = 1; i < argc; i++) {
        uint64_t *number = strcmp(argv[i], "--scenes") == 0 ? &scenes
                           : strcmp(argv[i], "--seed") == 0 ? &seed
                                                            : NULL;
        if (strcmp(argv[i], "--help") == 0) {
            printf("usage: hashes [--scenes N] [--seed S]\n"
                   "Draws the first N (%d) of the parity suite's scenes, of all classes in turn,\n"
                   "and prints a hash of the scenes and of each back end's frames.\n",
                   DEFAULT_SCENES);
            return 0;
        }
        char *end = NULL;
        if (number && ++i < argc) {
            errno = 0;
            *number = strtoull(argv[i], &end, 0);
        }
        if (!end || end == argv[i] || *end || errno || *argv[i] == '-') {
            fprintf(stderr, "hashes: wrong arguments (--help says more)\n");
            return 2;
        }
    }
    return run(seed, scenes);
}
