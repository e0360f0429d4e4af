/* Libraries in C++, compared if they are installed: one file for each, compiled if its headers are
 * found (tests/programs.mk). A peer without a file is a null pointer. */
#ifndef PEERS_H
#define PEERS_H

#include <stddef.h>

/* A row of the tables in rows.h, found by its name, computed by a library. */
struct peer_function {
    const char *row;
    void (*call)(float *in, float *out);
};

struct peer {
    const char *name, *version;
    const struct peer_function *functions;
    size_t count;
};

#ifdef __cplusplus
extern "C" {
#endif
extern const struct peer glm_peer __attribute__((weak));
extern const struct peer eigen_peer __attribute__((weak));
#ifdef __cplusplus
}
#endif

#endif
