/* Hashes the parity suite's scenes and their pictures, by class: one hash of everything that
 * scene_write writes of the scenes, and one of each back end's frames. Hashes also what the
 * functions of the mathematics return (mathematics.h). Hashes are equal on every machine, because
 * values are hashed, not bytes of memory. Needs no OpenGL. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../command_line.h"
#include "basic.h"
#include "generate.h"
#include "hash.h"
#include "mathematics.h"
#include "scene.h"
#include "scene_pixel.h"

#if defined(__arm__) && !defined(__linux__)
#define BOARD_HAS_NEWLIB
#include "../microcontrollers/board.h"
#endif

#define DEFAULT_SEED 1

/* A GN_BASIC library refuses what it lacks; of such a library only basic.h's scenes are asked. */
#if defined(GN_BASIC)
#define DEFAULT_SCENES 0
#define DEFAULT_BASIC 440
#else
#define DEFAULT_SCENES 440
#define DEFAULT_BASIC 0
#endif

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

/* Where the system has no streams in memory, a file stands in for one. */
#if defined(_WIN32)
static FILE *open_text(char **text, size_t *size)
{
    (void)text;
    (void)size;
    return tmpfile();
}

static bool close_text(FILE *file, char **text, size_t *size)
{
    const long length = ftell(file);
    bool good = length >= 0 && (*text = malloc((size_t)length + 1)) != NULL;

    *size = (size_t)length;
    rewind(file);
    good = good && fread(*text, 1, *size, file) == *size;
    return fclose(file) == 0 && good;
}
#else
#define open_text open_memstream

static bool close_text(FILE *file, char **text, size_t *size)
{
    (void)text;
    (void)size;
    return fclose(file) == 0;
}
#endif

/* The text that replays a scene. */
static bool add_scene(hash *h, const scene *s)
{
    char *text = NULL;
    size_t size = 0;
    FILE *const out = open_text(&text, &size);
    bool written = out && scene_write(s, out);
    written = out && close_text(out, &text, &size) && written;
    for (size_t i = 0; written && i < size; ++i)
        add_byte(h, (unsigned char)text[i]);
    free(text);
    if (!written)
        fprintf(stderr, "hashes: no memory\n");
    return written;
}

/* Adds the scene's pixels to *h. Returns false, after a message, if the library refuses it. */
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
    for (int a = 0; a < GN_MAX_COLORS; ++a)
        add_pixels(h, scene_frame_color(&frame, a), scene_frame_format(&frame, a), pixels);
    add_pixels(h, frame.depth, frame.depth_format, pixels);
    scene_frame_free(&frame);
    return status == GN_OK;
}

/* The hashes of a class, and how many of its scenes were drawn. */
typedef struct class_hashes {
    hash made, drawn[GN_BACKEND_COUNT];
    uint64_t scenes_drawn;
} class_hashes;

static bool add_class(class_hashes *h, uint64_t seed, scene_class c, bool basic, uint64_t scenes)
{
    h->made = HASH_EMPTY;
    h->scenes_drawn = 0;
    for (int b = 0; b < GN_BACKEND_COUNT; ++b)
        h->drawn[b] = HASH_EMPTY;
    for (uint64_t i = 0; i < scenes; ++i) {
        scene *s = generate_scene(seed, c, i);
        const bool drawn = !basic || make_basic(s);
        bool good = add_scene(&h->made, s);
        h->scenes_drawn += drawn;
        for (int b = GN_BACKEND_PORTABLE; good && drawn && b < GN_BACKEND_COUNT; ++b)
            good =
                !gn_backend_available((gn_backend)b) || draw_scene(s, (gn_backend)b, &h->drawn[b]);
        scene_free(s);
        if (!good) {
            fprintf(stderr, "hashes: %s%s scene %lu of seed %lu\n", basic ? "basic " : "",
                    scene_class_name(c), (unsigned long)i, (unsigned long)seed);
            return false;
        }
    }
    return true;
}

/* Prints the hashes of the classes, which share the scenes evenly. */
static bool print_pictures(uint64_t seed, bool basic, uint64_t scenes)
{
    const char *const prefix = basic ? "basic-" : "";
    uint64_t drawn = 0, all = 0;

    for (uint64_t c = 0; c < CLASS_COUNT; ++c) {
        const char *const name = scene_class_name((scene_class)c);
        const uint64_t count = scenes / CLASS_COUNT + (c < scenes % CLASS_COUNT);
        class_hashes h;
        if (count == 0 || (basic && !class_is_basic((scene_class)c)))
            continue;
        if (!add_class(&h, seed, (scene_class)c, basic, count))
            return false;
        print_hash(prefix, name, "scenes", h.made);
        for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
            if (gn_backend_available((gn_backend)b))
                print_hash(prefix, name, gn_backend_name((gn_backend)b), h.drawn[b]);
        drawn += h.scenes_drawn;
        all += count;
    }
    if (basic && all > 0)
        printf("basic drawn %lu of %lu\n", (unsigned long)drawn, (unsigned long)all);
    return true;
}

static void print_help(void)
{
    printf("usage: hashes [--scenes N] [--basic N] [--mathematics N] [--seed S]\n"
           "  --scenes N       draws the first N (%d) of the parity suite's scenes, shared evenly\n"
           "                   by the classes; prints a hash of each class's scenes and one of\n"
           "                   each back end's frames: CLASS scenes HASH, CLASS BACK-END HASH\n"
           "  --basic N        the same scenes (%d) without what a GN_BASIC library lacks:\n"
           "                   basic-CLASS scenes HASH, basic-CLASS BACK-END HASH\n"
           "  --mathematics N  calls every function of the mathematics N (0) times; prints a hash\n"
           "                   of the arguments, and of each function's results\n"
           "  --seed S         of the scenes and the arguments (%d)\n",
           DEFAULT_SCENES, DEFAULT_BASIC, DEFAULT_SEED);
}

int main(int argc, char **argv)
{
    uint64_t scenes = DEFAULT_SCENES, basic = DEFAULT_BASIC, rounds = 0, seed = DEFAULT_SEED;
    const command_option known[] = {
        {"--scenes", .number = &scenes},
        {"--basic", .number = &basic},
        {"--mathematics", .number = &rounds},
        {"--seed", .number = &seed},
        {.name = NULL},
    };
    if (command_line_asks_help(argc, argv)) {
        print_help();
        return 0;
    }
    if (!command_line_read("hashes", argc, argv, known, NULL))
        return 2;
    if (scenes > DEFAULT_SCENES && DEFAULT_SCENES == 0) {
        fprintf(stderr, "hashes: a GN_BASIC library draws no scenes but those of --basic\n");
        return 2;
    }
    print_mathematics(seed, rounds);
    return print_pictures(seed, false, scenes) && print_pictures(seed, true, basic) ? 0 : 1;
}
