/* Matrices as arguments and results of rows. */
#ifndef MATRICES_H
#define MATRICES_H

#include <stdbool.h>
#include <string.h>

#include <gnomon.h>

static inline gn_mat3 mat3_of(const float *in)
{
    gn_mat3 m;
    memcpy(&m, in, sizeof m);
    return m;
}

static inline gn_mat4 mat4_of(const float *in)
{
    gn_mat4 m;
    memcpy(&m, in, sizeof m);
    return m;
}

static inline bool put_matrix(const void *m, float *out, size_t size)
{
    memcpy(out, m, size);
    return true;
}

#endif
