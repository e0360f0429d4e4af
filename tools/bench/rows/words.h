/* Applies the text of a row to a scene: keywords of scenes, and those of rows.h. */
#ifndef BENCH_WORDS_H
#define BENCH_WORDS_H

#include "scene.h"

/* Returns false with the reason in error if a word is wrong. What a word changes in the first draw,
 * it changes in all. */
bool words_apply(scene *s, const char *text, char *error, size_t error_size);

/* Sets a texture of bytes without a pattern. The scene's draw must have one already; with
 * SCENE_SAMPLED its coordinates become those of the target. */
void word_noise(scene_draw *d, gn_texture_target target, gn_format format, uint32_t side,
                uint32_t depth, uint32_t levels);

#endif
