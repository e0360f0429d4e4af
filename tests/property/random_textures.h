/* Random textures without their texels, and samplers, for the properties of lookups. */
#ifndef RANDOM_TEXTURES_H
#define RANDOM_TEXTURES_H

#include <gnomon.h>

#include "random.h"

/* Any target and format that have texels, sides of up to `most`, all possible levels or fewer. */
gn_texture random_texture_shape(random_source *r, uint32_t most);

/* A colour format, those of every day more often. */
gn_format random_target_format(random_source *r);

/* Any state without fault; border colours are 0.25 to 0.5. */
gn_sampler random_sampler_state(random_source *r);

/* Numbers with which arithmetic goes wrong, and ordinary ones. */
float random_hostile_number(random_source *r);

#endif
