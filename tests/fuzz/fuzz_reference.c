/* The library against the reference, OSMesa, bit for bit: scenes whose random numbers come from the
 * input. With another Mesa than the contract's nothing is tested. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "osmesa.h"
#include "scene_input.h"

static reference *start(void)
{
    static reference *r;
    char error[512] = "";

    if (!r) {
        r = reference_create(REFERENCE_PINNED, error, sizeof error);
        if (!r) {
            fprintf(stderr, "fuzz: no reference: %s\n", error);
            exit(EXIT_FAILURE);
        }
    }
    return r;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    fuzz_input in = fuzz_begin(bytes, size);
    reference *const r = start();
    char error[512] = "";
    scene_frame ours, theirs;
    scene *const s = scene_make(&in);

    if (!s)
        return -1;
    FUZZ_REQUIRE(scene_frame_allocate(&ours, s) && scene_frame_allocate(&theirs, s));
    FUZZ_REQUIRE(scene_draw_library(s, &ours, 0, GN_BACKEND_AUTO) == GN_OK);
    const bool drawn = reference_draw(r, s, &theirs, error, sizeof error);

    if (!drawn)
        fprintf(stderr, "fuzz: the reference: %s\n", error);
    FUZZ_REQUIRE(drawn);

    const scene_difference d = scene_compare(s, &ours, &theirs);

    if (d.pixels > 0) {
        FILE *const out = fopen("fuzz-difference.scene", "w");

        fprintf(stderr, "fuzz: %llu pixels differ; the scene is in fuzz-difference.scene\n",
                (unsigned long long)d.pixels);
        if (out) {
            scene_write(s, out);
            fclose(out);
        }
    }
    FUZZ_REQUIRE(d.pixels == 0);
    scene_frame_free(&ours);
    scene_frame_free(&theirs);
    scene_free(s);
    return 0;
}
