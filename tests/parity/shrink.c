/* Shrinking: repeats passes over a scene until none of them finds anything to remove. */
#include "shrink.h"

#include <stdlib.h>

#include "shrink_parts.h"

bool shrink_try(shrinking *s, scene *candidate)
{
    if (s->attempts > 0) {
        --s->attempts;
        if (s->fails(candidate, s->context)) {
            scene_free(s->best);
            s->best = candidate;
            return true;
        }
    }
    scene_free(candidate);
    return false;
}

/* Removes draws: half of them, a quarter, and so on down to single draws. */
bool shrink_draws(shrinking *s)
{
    bool progress = false;
    for (size_t chunk = s->best->draw_count; chunk > 0; chunk /= 2) {
        size_t first = 0;
        while (first < s->best->draw_count && s->attempts > 0) {
            scene *candidate = scene_copy(s->best);
            for (size_t i = 0; i < chunk && first < candidate->draw_count; ++i)
                scene_remove_draw(candidate, first);
            if (shrink_try(s, candidate))
                progress = true;
            else
                first += chunk;
        }
    }
    return progress;
}

scene *shrink_scene(const scene *original, shrink_predicate *fails, void *context,
                    unsigned attempts)
{
    shrinking s = {scene_copy(original), fails, context, attempts};
    bool progress = true;
    while (progress && s.attempts > 0) {
        progress = shrink_draws(&s);
        progress = shrink_meshes(&s) || progress;
        progress = shrink_state(&s) || progress;
        progress = shrink_target(&s) || progress;
        progress = shrink_numbers(&s) || progress;
    }
    return s.best;
}
