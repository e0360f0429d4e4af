/* Lanes of packed vectors: GN_LANES vectors of three or four floats each, one after the
 * other in memory, to a register set per component and back. Which lane a vector comes to
 * is the form's own; storing puts it where loading found it. Loads and stores touch these
 * vectors alone. */
#ifndef GN_LANES_PACKED_H
#define GN_LANES_PACKED_H

#include "lanes.h"

#if defined(GN_LANES_AVX2)

static inline lanes_f lanes_quad(const float p[4])
{
    LANES_EACH_REGISTER(lanes_f, _mm256_broadcast_ps((const __m128 *)(const void *)p));
}

static inline void lanes_spread(lanes_f a, lanes_f spread[4])
{
    for (int n = 0; n < 2; ++n) {
        spread[0].q[n] = _mm256_permute_ps(a.q[n], _MM_SHUFFLE(0, 0, 0, 0));
        spread[1].q[n] = _mm256_permute_ps(a.q[n], _MM_SHUFFLE(1, 1, 1, 1));
        spread[2].q[n] = _mm256_permute_ps(a.q[n], _MM_SHUFFLE(2, 2, 2, 2));
        spread[3].q[n] = _mm256_permute_ps(a.q[n], _MM_SHUFFLE(3, 3, 3, 3));
    }
}

/* Four floats at p and four that lie four vectors further on. */
static inline __m256 load_halves(const float *p)
{
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(p)), _mm_loadu_ps(p + 12), 1);
}

static inline void store_halves(float *p, __m256 a)
{
    _mm_storeu_ps(p, _mm256_castps256_ps128(a));
    _mm_storeu_ps(p + 12, _mm256_extractf128_ps(a, 1));
}

static inline void lanes_load_vec3(const float *p, lanes_f v[3])
{
    for (int n = 0; n < 2; ++n) {
        const __m256 a = load_halves(p + 24 * n);                           /* x0 y0 z0 x1 */
        const __m256 b = load_halves(p + 24 * n + 4);                       /* y1 z1 x2 y2 */
        const __m256 c = load_halves(p + 24 * n + 8);                       /* z2 x3 y3 z3 */
        const __m256 yz = _mm256_shuffle_ps(a, b, _MM_SHUFFLE(1, 0, 2, 1)); /* y0 z0 y1 z1 */
        const __m256 xy = _mm256_shuffle_ps(b, c, _MM_SHUFFLE(2, 1, 3, 2)); /* x2 y2 x3 y3 */

        v[0].q[n] = _mm256_shuffle_ps(a, xy, _MM_SHUFFLE(2, 0, 3, 0));
        v[1].q[n] = _mm256_shuffle_ps(yz, xy, _MM_SHUFFLE(3, 1, 2, 0));
        v[2].q[n] = _mm256_shuffle_ps(yz, c, _MM_SHUFFLE(3, 0, 3, 1));
    }
}

static inline void lanes_store_vec3(float *p, lanes_f v[3])
{
    for (int n = 0; n < 2; ++n) {
        const __m256 x = v[0].q[n], y = v[1].q[n], z = v[2].q[n];
        const __m256 xy = _mm256_shuffle_ps(x, y, _MM_SHUFFLE(2, 0, 2, 0)); /* x0 x2 y0 y2 */
        const __m256 yz = _mm256_shuffle_ps(y, z, _MM_SHUFFLE(3, 1, 3, 1)); /* y1 y3 z1 z3 */
        const __m256 zx = _mm256_shuffle_ps(z, x, _MM_SHUFFLE(3, 1, 2, 0)); /* z0 z2 x1 x3 */

        store_halves(p + 24 * n, _mm256_shuffle_ps(xy, zx, _MM_SHUFFLE(2, 0, 2, 0)));
        store_halves(p + 24 * n + 4, _mm256_shuffle_ps(yz, xy, _MM_SHUFFLE(3, 1, 2, 0)));
        store_halves(p + 24 * n + 8, _mm256_shuffle_ps(zx, yz, _MM_SHUFFLE(3, 1, 3, 1)));
    }
}

#elif defined(__SSE2__) && !defined(GN_LANES_PORTABLE)

static inline lanes_f lanes_quad(const float p[4])
{
    LANES_EACH_REGISTER(lanes_f, _mm_loadu_ps(p));
}

static inline void lanes_spread(lanes_f a, lanes_f spread[4])
{
    for (int n = 0; n < 4; ++n) {
        spread[0].q[n] = _mm_shuffle_ps(a.q[n], a.q[n], _MM_SHUFFLE(0, 0, 0, 0));
        spread[1].q[n] = _mm_shuffle_ps(a.q[n], a.q[n], _MM_SHUFFLE(1, 1, 1, 1));
        spread[2].q[n] = _mm_shuffle_ps(a.q[n], a.q[n], _MM_SHUFFLE(2, 2, 2, 2));
        spread[3].q[n] = _mm_shuffle_ps(a.q[n], a.q[n], _MM_SHUFFLE(3, 3, 3, 3));
    }
}

static inline void lanes_load_vec3(const float *p, lanes_f v[3])
{
    for (int n = 0; n < 4; ++n) {
        const __m128 a = _mm_loadu_ps(p + 12 * n);                       /* x0 y0 z0 x1 */
        const __m128 b = _mm_loadu_ps(p + 12 * n + 4);                   /* y1 z1 x2 y2 */
        const __m128 c = _mm_loadu_ps(p + 12 * n + 8);                   /* z2 x3 y3 z3 */
        const __m128 yz = _mm_shuffle_ps(a, b, _MM_SHUFFLE(1, 0, 2, 1)); /* y0 z0 y1 z1 */
        const __m128 xy = _mm_shuffle_ps(b, c, _MM_SHUFFLE(2, 1, 3, 2)); /* x2 y2 x3 y3 */

        v[0].q[n] = _mm_shuffle_ps(a, xy, _MM_SHUFFLE(2, 0, 3, 0));
        v[1].q[n] = _mm_shuffle_ps(yz, xy, _MM_SHUFFLE(3, 1, 2, 0));
        v[2].q[n] = _mm_shuffle_ps(yz, c, _MM_SHUFFLE(3, 0, 3, 1));
    }
}

static inline void lanes_store_vec3(float *p, lanes_f v[3])
{
    for (int n = 0; n < 4; ++n) {
        const __m128 x = v[0].q[n], y = v[1].q[n], z = v[2].q[n];
        const __m128 xy = _mm_shuffle_ps(x, y, _MM_SHUFFLE(2, 0, 2, 0)); /* x0 x2 y0 y2 */
        const __m128 yz = _mm_shuffle_ps(y, z, _MM_SHUFFLE(3, 1, 3, 1)); /* y1 y3 z1 z3 */
        const __m128 zx = _mm_shuffle_ps(z, x, _MM_SHUFFLE(3, 1, 2, 0)); /* z0 z2 x1 x3 */

        _mm_storeu_ps(p + 12 * n, _mm_shuffle_ps(xy, zx, _MM_SHUFFLE(2, 0, 2, 0)));
        _mm_storeu_ps(p + 12 * n + 4, _mm_shuffle_ps(yz, xy, _MM_SHUFFLE(3, 1, 2, 0)));
        _mm_storeu_ps(p + 12 * n + 8, _mm_shuffle_ps(zx, yz, _MM_SHUFFLE(3, 1, 3, 1)));
    }
}

#else

static inline lanes_f lanes_quad(const float p[4])
{
    lanes_f r;
    GN_EACH_LANE (l)
        r.v[l] = p[l % 4];
    return r;
}

static inline void lanes_spread(lanes_f a, lanes_f spread[4])
{
    for (int i = 0; i < 4; ++i)
        GN_EACH_LANE (l)
            spread[i].v[l] = a.v[l - l % 4 + i];
}

static inline void lanes_load_vec3(const float *p, lanes_f v[3])
{
    GN_EACH_LANE (l)
        for (int i = 0; i < 3; ++i)
            v[i].v[l] = p[3 * l + i];
}

static inline void lanes_store_vec3(float *p, lanes_f v[3])
{
    GN_EACH_LANE (l)
        for (int i = 0; i < 3; ++i)
            p[3 * l + i] = v[i].v[l];
}

#endif

#endif
