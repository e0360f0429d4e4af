/* The properties of drawing. */
#include "properties_draw.h"

int properties_draw(uint64_t seed, size_t trials)
{
    return properties_edges(seed, trials) + properties_memory(seed, trials) +
           properties_hostile(seed, trials) + properties_scenes(seed, trials) +
           properties_textures(seed, trials) + properties_sampling(seed, trials) +
           properties_members(seed, trials) + properties_indices(seed, trials);
}
