/* Random textures, short of their texels, and samplers for the properties of sampling. */
#ifndef RANDOM_TEXTURES_H
#define RANDOM_TEXTURES_H

#include <gnomon.h>

#include "random.h"

/* Any target and format that have texels; sides of up to `most`, levels as many as there may be or
 * fewer. */
gn_texture random_texture_shape(random_source *r, uint32_t most);

/* Any state without fault, border colours from 0.25 to 0.5. */
gn_sampler random_sampler_state(random_source *r);

/* Numbers that arithmetic goes wrong on, and ordinary ones. */
float random_hostile_number(random_source *r);

#endif
