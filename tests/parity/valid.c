/* Generates and checks many more scenes than a gate can draw, to find faults of generators that one
 * scene in tens of thousands shows. */
#include "valid.h"

#include <inttypes.h>
#include <stdio.h>

#include "generate.h"

static gn_status texture_status(const gn_texture *t, const gn_sampler *sampler)
{
    const gn_status status = gn_texture_check(t);
    return status != GN_OK ? status : gn_sampler_check(sampler);
}

static gn_status draw_status(const scene_draw *d)
{
    gn_status status = gn_mesh_check(&d->mesh);
    if (status == GN_OK && scene_draw_has_texture(d))
        status = texture_status(&d->uniforms.texture, &d->uniforms.sampler);
    for (int m = 0; m < SCENE_MAP_COUNT && status == GN_OK; ++m)
        if (scene_draw_has_map(d, (scene_map)m))
            status = texture_status(&d->surface.map[m], scene_map_sampler(d, (scene_map)m));
    return status;
}

/* Prints the first refused scene and ends the class. */
static bool class_is_valid(uint64_t seed, scene_class c, uint64_t scenes)
{
    gn_status status = GN_OK;
    for (uint64_t i = 0; i < scenes && status == GN_OK; ++i) {
        scene *const s = generate_scene(seed, c, i);
        for (size_t n = 0; n < s->draw_count && status == GN_OK; ++n)
            status = draw_status(&s->draws[n]);
        if (status != GN_OK)
            printf("FAILED: %s scene %" PRIu64 " of seed %" PRIu64 ": refused: %s\n",
                   scene_class_name(c), i, seed, gn_status_text(status));
        scene_free(s);
    }
    return status == GN_OK;
}

bool valid_check(uint64_t seed, uint64_t scenes)
{
    int failed = 0;
    for (uint64_t c = 0; c < CLASS_COUNT; ++c) {
        const uint64_t count = scenes / CLASS_COUNT + (c < scenes % CLASS_COUNT);
        failed += !class_is_valid(seed, (scene_class)c, count);
    }
    printf("valid: %" PRIu64 " scenes of seed %" PRIu64 ": %d passed, %d failed\n", scenes, seed,
           CLASS_COUNT - failed, failed);
    return failed == 0;
}
