/* Measures the stack of a draw: draws the parity suite's scenes with each back end in a thread
 * whose stack is filled with a pattern, and counts the bytes that are overwritten. What an idle
 * thread overwrites is subtracted; what the scenes' shaders use is included. Fails if a draw takes
 * more than the guide says (tools/guide/memory.md). */
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gnomon/backend.h>
#include "../command_line.h"
#include "basic.h"
#include "generate.h"
#include "scene.h"

/* What the guide says that a draw needs at most. */
#if defined(GN_BASIC) && defined(GN_SMALL) && GN_LANES + 0 == 1
#define LIMIT 12288
#else
#define LIMIT 98304
#endif

enum {
    STACK_SIZE = 524288, /* of the thread that draws */
    PATTERN = 0xa5,
    DEFAULT_SCENES = 550
};

typedef struct draw {
    const scene *s; /* NULL: nothing is drawn */
    scene_frame *frame;
    gn_backend backend;
    gn_status status;
} draw;

static void *draw_scene(void *data)
{
    draw *const d = data;
    if (d->s)
        d->status = scene_draw_library(d->s, d->frame, 0, d->backend);
    return NULL;
}

/* The bytes of stack that a thread overwrites. 0, after a message, if it cannot draw. */
static size_t stack_of(draw *d, unsigned char *stack)
{
    pthread_attr_t attributes;
    pthread_t thread;

    memset(stack, PATTERN, STACK_SIZE);
    if (pthread_attr_init(&attributes) || pthread_attr_setstack(&attributes, stack, STACK_SIZE) ||
        pthread_create(&thread, &attributes, draw_scene, d) || pthread_join(thread, NULL)) {
        fprintf(stderr, "stack: no thread\n");
        return 0;
    }
    pthread_attr_destroy(&attributes);
    if (d->status != GN_OK) {
        fprintf(stderr, "stack: the library says: %s\n", gn_status_text(d->status));
        return 0;
    }
    size_t untouched = 0;
    while (untouched < STACK_SIZE && stack[untouched] == PATTERN)
        ++untouched;
    return STACK_SIZE - untouched;
}

/* The deepest draw of a back end. */
typedef struct deepest {
    size_t bytes;
    scene_class class;
    uint64_t scene;
} deepest;

/* Draws a scene with every back end. `idle` is what an idle thread overwrites of its stack. */
static bool measure(uint64_t seed, scene_class c, uint64_t number, unsigned char *stack,
                    size_t idle, deepest *of_backend)
{
    bool good = true;
#if defined(GN_BASIC)
    if (!class_is_basic(c))
        return true;
#endif
    scene *const s = generate_scene(seed, c, number);
#if defined(GN_BASIC)
    if (!make_basic(s)) {
        scene_free(s);
        return true;
    }
#endif

    for (int b = GN_BACKEND_PORTABLE; good && b < GN_BACKEND_COUNT; ++b) {
        scene_frame frame;
        draw d = {s, &frame, (gn_backend)b, GN_OK};
        if (!gn_backend_available(d.backend))
            continue;
        if (!scene_frame_allocate(&frame, s)) {
            fprintf(stderr, "stack: no memory\n");
            good = false;
            break;
        }
        const size_t bytes = stack_of(&d, stack);
        scene_frame_free(&frame);
        good = bytes > idle;
        if (good && bytes - idle > of_backend[b].bytes)
            of_backend[b] = (deepest){bytes - idle, c, number};
    }
    scene_free(s);
    return good;
}

int main(int argc, char **argv)
{
    uint64_t scenes = DEFAULT_SCENES, seed = 1;
    const command_option known[] = {
        {"--scenes", .number = &scenes, .least = 1}, {"--seed", .number = &seed}, {NULL}};
    if (command_line_asks_help(argc, argv)) {
        printf(
            "usage: stack [--scenes N] [--seed S]\n"
            "The stack of a draw, with each back end: the deepest of N (%d) of the parity suite's\n"
            "scenes, which the classes share evenly. A draw of more than %d bytes fails.\n",
            DEFAULT_SCENES, LIMIT);
        return 0;
    }
    if (!command_line_read("stack", argc, argv, known, NULL))
        return 2;

    unsigned char *const stack = aligned_alloc(4096, STACK_SIZE);
    deepest of_backend[GN_BACKEND_COUNT] = {{0, 0, 0}};
    draw nothing = {NULL, NULL, GN_BACKEND_PORTABLE, GN_OK};
    if (!stack) {
        fprintf(stderr, "stack: no memory\n");
        return 1;
    }
    const size_t idle = stack_of(&nothing, stack);
    if (idle == 0) {
        free(stack);
        return 1;
    }
    for (uint64_t c = 0; c < CLASS_COUNT; ++c) {
        const uint64_t count = scenes / CLASS_COUNT + (c < scenes % CLASS_COUNT);
        for (uint64_t i = 0; i < count; ++i)
            if (!measure(seed, (scene_class)c, i, stack, idle, of_backend)) {
                fprintf(stderr, "stack: %s scene %lu of seed %lu\n",
                        scene_class_name((scene_class)c), (unsigned long)i, (unsigned long)seed);
                free(stack);
                return 1;
            }
    }
    free(stack);

    int passed = 0, failed = 0;
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b) {
        const deepest *const d = &of_backend[b];
        if (!gn_backend_available((gn_backend)b))
            continue;
        const bool good = d->bytes > 0 && d->bytes <= LIMIT;
        printf("%-10s %7lu bytes of stack: %s, scene %lu%s\n", gn_backend_name((gn_backend)b),
               (unsigned long)d->bytes, scene_class_name(d->class), (unsigned long)d->scene,
               good            ? ""
               : d->bytes == 0 ? "  FAILED: nothing drawn"
                               : "  FAILED: too much");
        passed += good;
        failed += !good;
    }
    printf("%d passed, %d failed\n", passed, failed);
    return failed > 0;
}
