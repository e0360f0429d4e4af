/* Libraries in C++, compared where they are installed: a file each, compiled where its headers
 * are found (Makefile). A peer without a file is a null pointer. */
#ifndef PEERS_H
#define PEERS_H

#include <stddef.h>

/* A row of the tables in rows.h, by its name, as a library computes it. */
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
