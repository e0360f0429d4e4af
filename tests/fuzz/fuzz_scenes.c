/* The parity suite's scenes, of which every random number comes from the input: every back end,
 * workspace and order of tasks draws the same pixels and counts, and the text of a scene restores
 * it. */
#include <stdlib.h>
#include <string.h>

#include "scene_input.h"

/* Compares two frames of a scene bit for bit. */
static void require_equal(const scene_frame *a, const scene_frame *b)
{
    const size_t pixels = (size_t)a->width * a->height * a->images;

    for (int i = 0; i < GN_MAX_COLORS; ++i)
        if (scene_frame_color(a, i))
            FUZZ_REQUIRE(!memcmp(scene_frame_color(a, i), scene_frame_color(b, i),
                                 pixels * gn_format_size(scene_frame_format(a, i))));
    if (a->depth)
        FUZZ_REQUIRE(!memcmp(a->depth, b->depth, pixels * gn_format_size(a->depth_format)));
    FUZZ_REQUIRE(a->samples_passed == b->samples_passed);
    FUZZ_REQUIRE(!memcmp(&a->statistics, &b->statistics, sizeof a->statistics));
}

static void draw(const scene *s, gn_workspace *w, size_t size, scene_frame *frame)
{
    w->size = size;
    w->memory = fuzz_memory(size);
    FUZZ_REQUIRE(scene_frame_allocate(frame, s));
    FUZZ_REQUIRE(scene_draw_in_workspace(s, frame, w) == GN_OK);
    free(w->memory);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    fuzz_input in = fuzz_begin(bytes, size);
    const uint8_t kind = fuzz_byte(&in);
    scene *const s = scene_make(&in);
    uint32_t order = kind;
    scene_frame expected, frame;

    if (!s)
        return -1;
    const uint32_t varyings = scene_varyings(s);
    const size_t least = gn_workspace_size(0, varyings);
    gn_workspace w = {.backend = GN_BACKEND_PORTABLE};

    draw(s, &w, scene_workspace_size(s), &expected);
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b) {
        if (!gn_backend_available((gn_backend)b))
            continue;
        const uint32_t turn = (uint32_t)b + kind;

        w.backend = (gn_backend)b;
        w.parallel = turn & 1 ? fuzz_run_tasks : NULL;
        w.user = &order;
        w.threads = turn >> 2 & 3;
        draw(s, &w,
             turn & 2   ? least + (kind >> 4) * 777u
             : turn & 1 ? gn_workspace_size_parallel(0, 0, varyings) + kind * 997u
                        : scene_workspace_size(s),
             &frame);
        require_equal(&expected, &frame);
        scene_frame_free(&frame);
    }
    scene_frame_free(&expected);
    scene_free(s);
    return 0;
}
