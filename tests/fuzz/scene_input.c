/* Scenes of the parity suite's generators, with random numbers out of a fuzzer's input. */
#include "scene_input.h"

#include "generate.h"

#define MOST_TRIANGLES 300
#define MOST_PIXELS (80 * 80)

scene *scene_make(fuzz_input *in)
{
    const scene_class c = (scene_class)fuzz_below(in, CLASS_COUNT);

    fuzz_feed_random(in);
    scene *const s = generate_scene(0, c, 0);

    if (scene_triangle_count(s) <= MOST_TRIANGLES && s->width * s->height <= MOST_PIXELS)
        return s;
    scene_free(s);
    return NULL;
}
