/* Shrinking: repeats passes over a scene until none of them finds anything to remove. */
#include "shrink.h"

#include <stdlib.h>

#include "shrink_parts.h"

bool shrink_try(shrinking *s, scene *candidate)
{
    if (s->attempts > 0) {
        s->attempts--;
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
            for (size_t i = 0; i < chunk && first < candidate->draw_count; i++)
                scene_remove_draw(candidate, first);
            if (shrink_try(s, candidate))
                progress = true;
            else
                first += chunk;
        }
    }
    return progress;
}

/* Removes clears between draws. */
static bool shrink_clears(shrinking *s)
{
    bool progress = false;
    for (size_t i = 0; i < s->best->draw_count; i++)
        for (int what = 0; what < 2; what++) {
            const scene_clear *c = &s->best->draws[i].clear;
            if (!(what ? c->depth : c->color))
                continue;
            scene *candidate = scene_copy(s->best);
            *(what ? &candidate->draws[i].clear.depth : &candidate->draws[i].clear.color) = false;
            progress = shrink_try(s, candidate) || progress;
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
        progress = shrink_clears(&s) || progress;
        progress = shrink_meshes(&s) || progress;
        progress = shrink_state(&s) || progress;
        progress = shrink_target(&s) || progress;
        progress = shrink_numbers(&s) || progress;
    }
    return s.best;
}
