/* Scenes of the parity suite's generators, with random numbers out of a fuzzer's input. */
#ifndef FUZZ_SCENE_INPUT_H
#define FUZZ_SCENE_INPUT_H

#include "fuzz.h"
#include "scene.h"

/* Makes a scene of the class that the next byte chooses. Returns null if the scene is so large that
 * drawing it takes more time than fuzzing has. The caller frees the scene. */
scene *scene_make(fuzz_input *in);

#endif
