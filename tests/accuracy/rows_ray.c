/* Rays beside cglm's, which returns only t. */
#include <string.h>

#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>

#include "rows.h"
#include "wide.h"

/* The determinant of three vectors, and of their magnitudes with every term positive. */
static wide determinant(const wide *a, const wide *b, const wide *c, wide *permanent)
{
    wide sum = 0.0L;
    *permanent = 0.0L;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        sum += a[i] * (b[j] * c[k] - b[k] * c[j]);
        *permanent += fabsl(a[i] * b[j] * c[k]) + fabsl(a[i] * b[k] * c[j]);
    }
    return sum;
}

/* t, u and v as in ray.h and their errors by the contract, in u. Returns false if the determinant
 * is less than 2^-8 of its terms, or so small that cglm and GLM may find no hit, because they
 * compare it with 2^-20 and 2^-23 whatever the triangle's size. */
static bool intersect(const float *in, wide *result, wide *errors)
{
    wide b[3], c[3], from[3], d[3], permanent[4], sum[4];
    for (int i = 0; i < 3; ++i) {
        b[i] = (wide)in[3 + i] - (wide)in[i];
        c[i] = (wide)in[6 + i] - (wide)in[i];
        from[i] = (wide)in[9 + i] - (wide)in[i];
        d[i] = (wide)in[12 + i];
    }
    sum[0] = determinant(c, from, b, &permanent[0]);
    sum[1] = determinant(from, d, c, &permanent[1]);
    sum[2] = determinant(d, from, b, &permanent[2]);
    sum[3] = determinant(b, d, c, &permanent[3]);
    const wide least = fabsl(sum[3]) - 7.5L * 0x1p-24L * permanent[3];
    for (int i = 0; i < 3; ++i) {
        const wide quotient = fabsl(sum[i] / sum[3]);
        result[i] = sum[i] / sum[3];
        errors[i] = 7.5L * (permanent[i] + quotient * permanent[3]) / least + quotient;
    }
    return fabsl(sum[3]) > fmaxl(0x1p-8L * permanent[3], 0x1p-12L);
}

/* Turns corners, an origin, weights and the t of a point well inside into corners, origin and the
 * direction to that point. */
static void prepare_ray(float *in)
{
    const float replacement[12] = {0, 0, 0, 3, 1, -1, 0.5f, 4, 2, 1, 2, -5};
    wide unused[6];
    float copy[14];
    memcpy(copy, in, sizeof copy);
    for (int attempt = 0; attempt < 2; ++attempt) {
        const float u = 0.1f + 0.4f * fabsf(remainderf(copy[12], 2.0f));
        const float v = 0.1f + 0.3f * fabsf(remainderf(copy[13], 2.0f));
        for (int i = 0; i < 3; ++i)
            in[12 + i] = (1.0f - u - v) * in[i] + u * in[3 + i] + v * in[6 + i] - in[9 + i];
        if (intersect(in, unused, unused + 3))
            return;
        memcpy(in, replacement, sizeof replacement);
    }
}

static bool own_hit(const float *in, gn_ray_hit *hit)
{
    const gn_ray ray = {vec3_of(in + 9), vec3_of(in + 12)};
    return gn_ray_hits_triangle(&ray, vec3_of(in), vec3_of(in + 3), vec3_of(in + 6), hit);
}

/* An error of one unit is the contract's bound. */
OWN(distance)
{
    gn_ray_hit hit;
    return own_hit(in, &hit) && put(hit.t, out);
}
OTHER(distance)
{
    *out = NAN;
    glm_ray_triangle(in + 9, in + 12, in, in + 3, in + 6, out);
}
EXACT(distance)
{
    wide result[3], errors[3];
    intersect(in, result, errors);
    absolute(exact, 0, result[0], errors[0]);
}

OWN(weights)
{
    gn_ray_hit hit;
    return own_hit(in, &hit) && put(hit.u, out) && put(hit.v, out + 1);
}
EXACT(weights)
{
    wide result[3], errors[3];
    intersect(in, result, errors);
    absolute(exact, 0, result[1], errors[1]);
    absolute(exact, 1, result[2], errors[2]);
}

static const struct row rows[] = {
    ROW(distance, "ray meets triangle, t", 14, 1, 3, prepare_ray, 1, -1),
    OWN_ROW(weights, "ray meets triangle, u and v", 14, 2, 3, prepare_ray, 1, -1),
};

const struct table ray_rows = {rows, sizeof rows / sizeof rows[0]};
