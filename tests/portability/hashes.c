/* Hashes the parity suite's scenes and their pictures, by class: one hash of everything that
 * scene_write writes of the scenes, and one of each back end's frames. Hashes are equal on every
 * machine, because values are hashed, not bytes of memory. Needs neither OpenGL nor files. */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "generate.h"
#include "scene.h"
#include "scene_pixel.h"

#define DEFAULT_SCENES 440
#define DEFAULT_SEED 1

/* FNV-1a with 64 bits. */
typedef uint64_t hash;

#define HASH_EMPTY UINT64_C(0xCBF29CE484222325)

static void add_byte(hash *h, uint32_t byte)
{
    *h = (*h ^ byte) * UINT64_C(0x100000001B3);
}

static void add_word(hash *h, uint32_t word)
{
    for (int i = 0; i < 4; ++i)
        add_byte(h, word >> 8 * i & 255);
}

/* Hashes words in the order of memory, each by its value. */
static void add_words(hash *h, const void *memory, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        uint32_t word;
        memcpy(&word, (const char *)memory + 4 * i, sizeof word);
        add_word(h, word);
    }
}

static void add_pixels(hash *h, const void *pixels, gn_format format, size_t count)
{
    switch (format) {
    case GN_FORMAT_NONE:
        break;
    case GN_FORMAT_RGBA8:
    case GN_FORMAT_RGBA32F:
    case GN_FORMAT_R32F:
    case GN_FORMAT_D24:
    case GN_FORMAT_D32F:
    case GN_FORMAT_D24S8:
    case GN_FORMAT_D32FS8:
        add_words(h, pixels, count * gn_format_size(format) / 4);
        break;
    case GN_FORMAT_D16:
        for (size_t i = 0; i < count; ++i)
            add_word(h, ((const uint16_t *)pixels)[i]);
        break;
    case GN_FORMAT_S8:
        for (size_t i = 0; i < count; ++i)
            add_word(h, ((const uint8_t *)pixels)[i]);
        break;
    default:
        for (size_t i = 0; i < count; ++i) {
            uint32_t channel[4];
            const int channels = scene_pixel_channels(pixels, format, i, channel);
            for (int c = 0; c < channels; ++c)
                add_word(h, channel[c]);
        }
        break;
    }
}

/* The text that replays a scene. */
static bool add_scene(hash *h, const scene *s)
{
    char *text = NULL;
    size_t size = 0;
    FILE *const out = open_memstream(&text, &size);
    bool written = out && scene_write(s, out);
    written = out && fclose(out) == 0 && written;
    for (size_t i = 0; written && i < size; ++i)
        add_byte(h, (unsigned char)text[i]);
    free(text);
    if (!written)
        fprintf(stderr, "hashes: no memory\n");
    return written;
}

/* Whether the library may refuse scenes for want of features. */
#if defined(GN_BASIC)
#define IS_BASIC 1
#else
#define IS_BASIC 0
#endif

/* Adds the scene's pixels to *h, and with GN_BASIC the status. Adds to *drawn whether the library
 * drew all of the scene. Returns false, after a message, if it failed. */
static bool draw_scene(const scene *s, gn_backend backend, hash *h, uint64_t *drawn)
{
    scene_frame frame;
    if (!scene_frame_allocate(&frame, s)) {
        fprintf(stderr, "hashes: no memory\n");
        return false;
    }
    const gn_status status = scene_draw_library(s, &frame, 0, backend);
    if (IS_BASIC)
        add_word(h, (uint32_t)status);
    else if (status != GN_OK)
        fprintf(stderr, "hashes: the library says: %s\n", gn_status_text(status));
    const size_t pixels = (size_t)s->width * s->height * frame.images;
    for (int a = 0; a < GN_MAX_COLORS; ++a)
        add_pixels(h, scene_frame_color(&frame, a), scene_frame_format(&frame, a), pixels);
    add_pixels(h, frame.depth, frame.depth_format, pixels);
    scene_frame_free(&frame);
    *drawn += status == GN_OK;
    return IS_BASIC || status == GN_OK;
}

/* For a library with GN_BASIC: leaves out of a scene what such a library lacks, so that most scenes
 * are drawn, and makes the filters of samplers the same, since a library of one lane refuses
 * samplers whose filters differ. Shaders that ask the library for derivatives, or for look-ups that
 * it lacks, become others. The library refuses what is left, as point lights. */
static void make_basic(scene *s)
{
    s->samples = 1;
    if (s->color_format != GN_FORMAT_RGBA32F)
        s->color_format = GN_FORMAT_RGBA8;
    if (s->depth_format == GN_FORMAT_D24S8 || s->depth_format == GN_FORMAT_S8)
        s->depth_format = GN_FORMAT_D24;
    if (s->depth_format == GN_FORMAT_D32FS8)
        s->depth_format = GN_FORMAT_D16;
    for (size_t i = 0; i < s->draw_count; ++i) {
        scene_draw *const d = &s->draws[i];
        const gn_color none = {0};

        d->state.color = none;
        d->state.stencil.test = false;
        d->state.raster.polygon_mode_front = d->state.raster.polygon_mode_back = GN_POLYGON_FILL;
        d->state.raster.polygon_offset.set = false;
        d->state.depth.clamp = false;
        d->state.program.clip_distance_count = 0;
        d->counted = false;
        if (d->shader == SCENE_DERIVATIVES || d->shader == SCENE_SAMPLED)
            d->shader = SCENE_VERTEX_COLOR;
        if (d->shader == SCENE_FACES)
            d->shader = SCENE_GOURAUD;
        d->surface.has_point_light = false;
        d->mesh.instance_count = 1;
        d->uniforms.sampler.minify =
            d->uniforms.sampler.magnify == GN_MAGNIFY_LINEAR ? GN_MINIFY_LINEAR : GN_MINIFY_NEAREST;
    }
}

/* The hashes of a class. */
typedef struct class_hashes {
    hash made, drawn[GN_BACKEND_COUNT];
    uint64_t scenes_drawn;
} class_hashes;

static bool add_class(class_hashes *h, uint64_t seed, scene_class c, uint64_t scenes)
{
    h->made = HASH_EMPTY;
    h->scenes_drawn = 0;
    for (int b = 0; b < GN_BACKEND_COUNT; ++b)
        h->drawn[b] = HASH_EMPTY;
    for (uint64_t i = 0; i < scenes; ++i) {
        scene *s = generate_scene(seed, c, i);
        if (IS_BASIC)
            make_basic(s);
        bool good = add_scene(&h->made, s);
        for (int b = GN_BACKEND_PORTABLE; good && b < GN_BACKEND_COUNT; ++b)
            good = !gn_backend_available((gn_backend)b) ||
                   draw_scene(s, (gn_backend)b, &h->drawn[b], &h->scenes_drawn);
        scene_free(s);
        if (!good) {
            fprintf(stderr, "hashes: %s scene %" PRIu64 " of seed %" PRIu64 "\n",
                    scene_class_name(c), i, seed);
            return false;
        }
    }
    return true;
}

/* Whether the generator itself draws with features that a GN_BASIC library
 * lacks, as shadow maps, or is about such features. */
static bool needs_all_features(scene_class c)
{
    return c == CLASS_SHADOWED || c == CLASS_SAMPLES || c == CLASS_MASKS ||
           c == CLASS_SAMPLE_SHADING || c == CLASS_MIXED || c == CLASS_SEQUENCES ||
           c == CLASS_BATCHES || c == CLASS_BATCH_ENDS;
}

static int run(uint64_t seed, uint64_t scenes)
{
    for (uint64_t c = 0; c < CLASS_COUNT; ++c) {
        const char *const name = scene_class_name((scene_class)c);
        const uint64_t count = scenes / CLASS_COUNT + (c < scenes % CLASS_COUNT);
        class_hashes h;
        if (count == 0 || (IS_BASIC && needs_all_features((scene_class)c)))
            continue;
        if (!add_class(&h, seed, (scene_class)c, count))
            return 1;
        printf("%s scenes %016" PRIx64 "\n", name, h.made);
        for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
            if (gn_backend_available((gn_backend)b))
                printf("%s %s %016" PRIx64 "\n", name, gn_backend_name((gn_backend)b), h.drawn[b]);
        if (IS_BASIC)
            printf("%s drawn %" PRIu64 " of %" PRIu64 "\n", name, h.scenes_drawn, count);
    }
    return 0;
}

int main(int argc, char **argv)
{
    uint64_t scenes = DEFAULT_SCENES, seed = DEFAULT_SEED;
    for (int i = 1; i < argc; ++i) {
        uint64_t *number = strcmp(argv[i], "--scenes") == 0 ? &scenes
                           : strcmp(argv[i], "--seed") == 0 ? &seed
                                                            : NULL;
        if (strcmp(argv[i], "--help") == 0) {
            printf("usage: hashes [--scenes N] [--seed S]\n"
                   "Draws the first N (%d) of the parity suite's scenes of seed S (%d), shared\n"
                   "evenly by the classes. Prints a hash of each class's scenes and a hash of\n"
                   "each back end's frames: CLASS scenes HASH, CLASS BACK-END HASH.\n",
                   DEFAULT_SCENES, DEFAULT_SEED);
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
