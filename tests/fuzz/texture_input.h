/* Textures and samplers out of a fuzzer's input, right and wrong ones. */
#ifndef FUZZ_TEXTURE_INPUT_H
#define FUZZ_TEXTURE_INPUT_H

#include "fuzz.h"

typedef struct texture_input {
    gn_texture texture;
    gn_sampler sampler;
    unsigned char *memory[GN_MAX_LEVELS]; /* of exactly the bytes that a level's strides span */
} texture_input;

/* Makes a texture of at most `most` texels a side and a sampler, unless the input spoils one of
 * their members. Returns false, with nothing to free, if the texture would take more memory than
 * fuzzing has. */
bool texture_make(fuzz_input *in, uint32_t most, texture_input *result);
void texture_free(texture_input *t);

#endif
