/* Draws random scenes with the reference's libOSMesa and with this project's, by the same calls,
 * and compares colours, depths and stencil by bits, in the window itself. usage: osmesa-scenes
 * LIBRARY [--seed N] [--scenes N] [--class NAME] [--replay SEED] */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

enum { MAX_SIDE = 128, PIXELS = MAX_SIDE * MAX_SIDE, CHANNELS = 4 };

/* What a scene leaves. */
typedef struct result {
    float color[PIXELS][CHANNELS]; /* bytes use the first quarter */
    GLuint depth[PIXELS];
    GLubyte stencil[PIXELS];
    GLuint samples; /* that passed */
    GLenum error;
} result;

typedef struct window {
    int width, height;
    GLenum type;
    bool has_depth;
} window;

static window choose_window(random_source *r)
{
    window w;

    w.width = 16 + (int)random_below(r, MAX_SIDE - 16);
    w.height = 16 + (int)random_below(r, MAX_SIDE - 16);
    w.type = random_below(r, 2) ? GL_FLOAT : GL_UNSIGNED_BYTE;
    w.has_depth = true;
    return w;
}

static bool draw(library *gl, const scene_class *class, uint64_t seed, result *to, window *w)
{
    random_source r = random_seed(seed);

    memset(to, 0, sizeof *to);
    *w = choose_window(&r);
    gl->context = gl->OSMesaCreateContextExt(OSMESA_RGBA, w->has_depth ? 24 : 0,
                                             w->has_depth ? 8 : 0, 16, NULL);
    if (!gl->context ||
        !gl->OSMesaMakeCurrent(gl->context, to->color, w->type, w->width, w->height)) {
        fprintf(stderr, "%s has no context of this kind\n", gl->name);
        return false;
    }
    gl->BeginQuery(GL_SAMPLES_PASSED, 1);
    class->draw(gl, &r, w->width, w->height);
    gl->EndQuery(GL_SAMPLES_PASSED);
    gl->Finish();
    gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
    to->error = gl->GetError();
    gl->GetQueryObjectuiv(1, GL_QUERY_RESULT, &to->samples);
    gl->ReadPixels(0, 0, w->width, w->height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, to->depth);
    gl->ReadPixels(0, 0, w->width, w->height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, to->stencil);
    gl->OSMesaDestroyContext(gl->context);
    return true;
}

/* Counts pixels that differ, and prints the first. */
static unsigned compare(const result *a, const result *b, const window *w, bool prints)
{
    const size_t size = w->type == GL_FLOAT ? sizeof(float[CHANNELS]) : CHANNELS;
    unsigned differing = 0;

    for (int i = 0; i < w->width * w->height; ++i) {
        const unsigned char *const x = (const unsigned char *)a->color + (size_t)i * size;
        const unsigned char *const y = (const unsigned char *)b->color + (size_t)i * size;

        if (memcmp(x, y, size) == 0 && a->depth[i] == b->depth[i] && a->stencil[i] == b->stencil[i])
            continue;
        if (prints && differing < 6) {
            printf("  pixel %d, %d:", i % w->width, i / w->width);
            for (int side = 0; side < 2; ++side) {
                for (int c = 0; c < CHANNELS; ++c)
                    if (w->type == GL_FLOAT)
                        printf(" %.9g", (double)(side ? b : a)->color[i][c]);
                    else
                        printf(" %d", (side ? y : x)[c]);
                printf(", depth %08X, stencil %d%s", (side ? b : a)->depth[i],
                       (side ? b : a)->stencil[i], side ? "\n" : " beside");
            }
        }
        ++differing;
    }
    return differing;
}

typedef struct options {
    const char *path, *class;
    uint64_t seed, replay;
    unsigned scenes;
} options;

static bool read_options(int count, char **argument, options *o)
{
    *o = (options){count > 1 ? argument[1] : NULL, NULL, 1, 0, 100};
    for (int i = 2; i + 1 < count; i += 2)
        if (strcmp(argument[i], "--seed") == 0)
            o->seed = strtoull(argument[i + 1], NULL, 10);
        else if (strcmp(argument[i], "--scenes") == 0)
            o->scenes = (unsigned)strtoul(argument[i + 1], NULL, 10);
        else if (strcmp(argument[i], "--class") == 0)
            o->class = argument[i + 1];
        else if (strcmp(argument[i], "--replay") == 0)
            o->replay = strtoull(argument[i + 1], NULL, 10);
        else
            return false;
    return o->path && count % 2 == 0;
}

static result results[LIBRARIES];

int main(int count, char **argument)
{
    library libraries[LIBRARIES];
    options o;
    unsigned passed = 0, failed = 0;

    if (!read_options(count, argument, &o)) {
        fprintf(stderr, "usage: osmesa-scenes LIBRARY [--seed N] [--scenes N] [--class NAME] "
                        "[--replay SEED]\n");
        return 2;
    }
    if (!load_libraries(o.path, libraries))
        return 1;
    for (unsigned c = 0; c < scene_class_count; ++c) {
        const scene_class *const class = &scene_classes[c];
        unsigned long differing = 0, pixels = 0, scenes = 0, bad = 0;
        uint64_t first = 0;

        if (o.class && strcmp(o.class, class->name) != 0)
            continue;
        for (unsigned i = 0; i < o.scenes; ++i) {
            const uint64_t seed = o.replay ? o.replay : o.seed * 1000000u + i;
            unsigned different;
            window w;

            for (int l = 0; l < LIBRARIES; ++l)
                if (!draw(&libraries[l], class, seed, &results[l], &w))
                    return 1;
            different =
                compare(&results[0], &results[1], &w, o.replay || (!bad && getenv("VERBOSE")));
            if (results[0].error != results[1].error) {
                printf("  errors %#x beside %#x\n", results[0].error, results[1].error);
                ++different;
            }
            if (results[0].samples != results[1].samples) {
                printf("  samples %u beside %u\n", results[0].samples, results[1].samples);
                ++different;
            }
            if (different && bad++ == 0)
                first = seed;
            differing += different;
            pixels += (unsigned long)(w.width * w.height);
            ++scenes;
            if (o.replay)
                break;
        }
        printf("%s: %lu scenes, %lu of %lu pixels differ", class->name, scenes, differing, pixels);
        if (bad)
            printf(", in %lu scenes, first --class %s --replay %llu", bad, class->name,
                   (unsigned long long)first);
        printf("\n");
        passed += differing <= class->most_differing;
        failed += differing > class->most_differing;
    }
    printf("osmesa: %u passed, %u failed\n", passed, failed);
    return failed != 0;
}
