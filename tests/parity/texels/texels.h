/* Compares texels and levels of the library with the reference's; shared by the parts of the
 * program. */
#ifndef TEXELS_TEXELS_H
#define TEXELS_TEXELS_H

#include <gnomon.h>

#include "gl.h"
#include "random.h"
#include "scene_text.h"

/* Counts of comparisons; `differ` are failures, `steps` are those of the `encoded` texels of sRGB
 * that are a step off. */
typedef struct tally {
    uint64_t cases, failed, texels, differ, encoded, steps;
} tally;

/* Random texels that OpenGL stores unchanged: depths are from 0 to 1; floats are never denormal,
 * and NaN or infinite only if asked for. */
void fill_texels(random_source *r, gn_format format, bool with_specials, void *texels,
                 size_t count);

/* Uploads a level, tightly packed, into the texture bound to the target. */
void upload_level(gn_texture_target target, gn_format format, uint32_t level,
                  const uint32_t size[3], const void *texels);

/* Compares texelFetch of every value of every format, on every back end. Returns false if the
 * reference fails, with the reason in error. */
bool compare_fetches(uint64_t seed, tally *t, char *error, size_t error_size);

/* Compares glGenerateMipmap for textures of every target, colour format and some random sizes. */
bool compare_levels(uint64_t seed, uint64_t textures, tally *t, char *error, size_t error_size);

#endif
