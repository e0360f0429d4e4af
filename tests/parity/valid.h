/* Whether the library takes what generators make. */
#ifndef PARITY_VALID_H
#define PARITY_VALID_H

#include <stdbool.h>
#include <stdint.h>

/* Generates so many scenes, shared evenly by the classes, without drawing them, and asks the
 * library's checks of meshes, textures and samplers. Prints the first refused scene of each class;
 * at the end "N passed, N failed", the classes being the tests. True where none is refused. */
bool valid_check(uint64_t seed, uint64_t scenes);

#endif
