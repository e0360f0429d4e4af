/* Data that a child sends is refused, with the state that says why, if it is not a model that can
 * be drawn, exceeds the allowed bytes, or comes late. */
#define _POSIX_C_SOURCE 200809L
#include "suite.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "handover.h"

static float floats[12];
static uint32_t indices[4], texels[1];
static model_part part;
static part_maps maps;

/* A triangle with a map of one texel, which fits the memory of a pipe. */
static imported good_model(void)
{
    imported what;

    memset(&what, 0, sizeof what);
    what.model.part_count = what.model.material_count = 1;
    what.model.parts = &part;
    what.maps = &maps;
    memset(&part, 0, sizeof part);
    memset(&maps, 0, sizeof maps);
    for (uint32_t i = 0; i < 3; ++i)
        indices[i] = i;
    part.vertex_count = 3;
    part.positions = part.normals = part.colors = floats;
    part.index_count = 3;
    part.indices = indices;
    part.surface.shine.exponent = 1;
    maps.images[0] = (image){1, 1, texels, 1};
    return what;
}

/* Returns the state after the model was sent and received, with this many bytes allowed and this
 * many seconds. */
static handover_state state_after(const imported *what, uint64_t bytes, int seconds)
{
    static char text[HANDOVER_TEXT_SIZE];
    handover h = {-1, {0, 0}, bytes, HANDOVER_GOING, {NULL, 0}};
    handover_record kind;
    imported result;
    int ends[2];

    memset(&result, 0, sizeof result);
    assert_int_equal(pipe(ends), 0);
    assert_true(handover_send_model(ends[1], what));
    close(ends[1]);
    h.descriptor = ends[0];
    clock_gettime(CLOCK_MONOTONIC, &h.deadline);
    h.deadline.tv_sec += seconds;
    if (handover_receive(&h, &kind, text))
        handover_receive_model(&h, &result);
    for (size_t p = 0; result.maps && p < result.model.part_count; ++p)
        for (int i = 0; i < MAP_COUNT; ++i)
            free(result.maps[p].images[i].texels);
    free(result.maps);
    model_free(&result.model);
    close(ends[0]);
    return h.state;
}

TEST(good_models_arrive)
{
    const imported what = good_model();
    assert_int_equal(state_after(&what, 1 << 20, 600), HANDOVER_GOING);
    assert_int_equal(state_after(&what, 100, 600), HANDOVER_TOO_MUCH);
    assert_int_equal(state_after(&what, 1 << 20, -1), HANDOVER_LATE);
}

/* What is wrong with a model. */
enum { INDEX, COUNT_OF_INDICES, EXPONENT, LINES, KIND, ALPHA, ORIGIN, HEIGHT, PARTS, FAULTS };

TEST(wrong_models_are_refused)
{
    for (int fault = 0; fault < FAULTS; ++fault) {
        imported what = good_model();
        indices[2] = fault == INDEX ? 3 : 2; /* there are vertices 0 to 2 */
        part.index_count = fault == COUNT_OF_INDICES ? 4 : 3;
        part.surface.shine.exponent = fault == EXPONENT ? 0 : 1;
        part.kind = fault == LINES  ? MODEL_LINES /* of two vertices each */
                    : fault == KIND ? MODEL_POINTS + 1
                                    : MODEL_TRIANGLES;
        part.surface.alpha = fault == ALPHA ? MODEL_BLEND + 1 : MODEL_OPAQUE;
        what.model.origin[1] = fault == ORIGIN ? HUGE_VAL : 0.0;
        maps.images[0].height = fault == HEIGHT ? 0 : 1;
        what.model.part_count = fault == PARTS ? 0 : 1;
        if (state_after(&what, 1 << 20, 600) != HANDOVER_WRONG)
            fail_msg("fault %d", fault);
    }
}
