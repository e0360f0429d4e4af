/* Plays random calls of this project's libOSMesa, for the sanitizers.
 * usage: osmesa-alone [SEED [ROUNDS]] */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "play.h"

int main(int count, char **argument)
{
    const uint64_t seed = count > 1 ? strtoull(argument[1], NULL, 10) : 1;
    const unsigned rounds = count > 2 ? (unsigned)strtoul(argument[2], NULL, 10) : 10;
    unsigned passed = 0, failed = 0;
    library gl;

    memset(&gl, 0, sizeof gl);
    set_own_functions(&gl);
    for (unsigned i = 0; i < rounds; ++i) {
        for (unsigned c = 0; c < scene_class_count; ++c) {
            const bool is_played = play(&gl, &scene_classes[c], (seed * 1000 + i) * 100 + c);

            passed += is_played;
            failed += !is_played;
        }
    }
    printf("osmesa-alone: %u passed, %u failed\n", passed, failed);
    return failed != 0;
}
