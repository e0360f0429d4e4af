/* Whether the library accepts what generators make. */
#ifndef PARITY_VALID_H
#define PARITY_VALID_H

#include <stdbool.h>
#include <stdint.h>

/* Generates this many scenes, shared evenly by the classes, without drawing them, and runs the
 * library's checks of meshes, textures and samplers. Prints the first refused scene of each class;
 * at the end "N passed, N failed", with one test per class. Returns true if none is refused. */
bool valid_check(uint64_t seed, uint64_t scenes);

#endif
