/* Lanes of packed vectors.
 *
 *   quad                    four floats, in each group of four lanes
 *   spread                  each lane of a group in all of the group: spread[i] holds lane i
 *   load_vec3 store_vec3    GN_LANES vectors of three floats, one after the other in memory,
 *                           to and from one lanes_f per component; no other memory is read
 *                           or written */
#ifndef GN_LANES_PACKED_H
#define GN_LANES_PACKED_H

#include "lanes.h"

#if defined(GN_LANES_AVX512)

static inline lanes_f lanes_quad(const float p[4])
{
    return lanes_avx512_f(_mm512_broadcast_f32x4(_mm_loadu_ps(p)));
}

static inline void lanes_spread(lanes_f a, lanes_f spread[4])
{
    spread[0].q = _mm512_shuffle_ps(a.q, a.q, 0x00);
    spread[1].q = _mm512_shuffle_ps(a.q, a.q, 0x55);
    spread[2].q = _mm512_shuffle_ps(a.q, a.q, 0xAA);
    spread[3].q = _mm512_shuffle_ps(a.q, a.q, 0xFF);
}

/* INDEX(l, i) in lane l. */
#define PACKED_INDICES(INDEX, i)                                                                   \
    _mm512_setr_epi32(INDEX(0, i), INDEX(1, i), INDEX(2, i), INDEX(3, i), INDEX(4, i),             \
                      INDEX(5, i), INDEX(6, i), INDEX(7, i), INDEX(8, i), INDEX(9, i),             \
                      INDEX(10, i), INDEX(11, i), INDEX(12, i), INDEX(13, i), INDEX(14, i),        \
                      INDEX(15, i))

/* Loading: component i of vector l is number 3 * l + i of three registers. An instruction indexes
 * two operands as 0 to 15 and 16 to 31. So the component first comes from the first two registers
 * if it is there; a second instruction keeps it or takes it from the third. */
#define PACKED_FROM_TWO(l, i) (3 * (l) + (i) < 32 ? 3 * (l) + (i) : 0)
#define PACKED_FROM_THIRD(l, i) (3 * (l) + (i) < 32 ? (l) : 3 * (l) + (i)-16)

static inline void lanes_load_vec3(const float *p, lanes_f v[3])
{
    const __m512 a = _mm512_loadu_ps(p), b = _mm512_loadu_ps(p + 16), c = _mm512_loadu_ps(p + 32);
    const __m512 x = _mm512_permutex2var_ps(a, PACKED_INDICES(PACKED_FROM_TWO, 0), b);
    const __m512 y = _mm512_permutex2var_ps(a, PACKED_INDICES(PACKED_FROM_TWO, 1), b);
    const __m512 z = _mm512_permutex2var_ps(a, PACKED_INDICES(PACKED_FROM_TWO, 2), b);

    v[0].q = _mm512_permutex2var_ps(x, PACKED_INDICES(PACKED_FROM_THIRD, 0), c);
    v[1].q = _mm512_permutex2var_ps(y, PACKED_INDICES(PACKED_FROM_THIRD, 1), c);
    v[2].q = _mm512_permutex2var_ps(z, PACKED_INDICES(PACKED_FROM_THIRD, 2), c);
}

/* Storing: lane l of register r is component (16 * r + l) % 3. The first instruction takes x and y,
 * the second z. */
#define PACKED_FROM_XY(l, r) ((16 * (r) + (l)) / 3 + ((16 * (r) + (l)) % 3 == 1 ? 16 : 0))
#define PACKED_FROM_Z(l, r) ((16 * (r) + (l)) % 3 == 2 ? (16 * (r) + (l)) / 3 + 16 : (l))

static inline void lanes_store_vec3(float *p, lanes_f v[3])
{
    const __m512 x = v[0].q, y = v[1].q, z = v[2].q;
    const __m512 a = _mm512_permutex2var_ps(x, PACKED_INDICES(PACKED_FROM_XY, 0), y);
    const __m512 b = _mm512_permutex2var_ps(x, PACKED_INDICES(PACKED_FROM_XY, 1), y);
    const __m512 c = _mm512_permutex2var_ps(x, PACKED_INDICES(PACKED_FROM_XY, 2), y);

    _mm512_storeu_ps(p, _mm512_permutex2var_ps(a, PACKED_INDICES(PACKED_FROM_Z, 0), z));
    _mm512_storeu_ps(p + 16, _mm512_permutex2var_ps(b, PACKED_INDICES(PACKED_FROM_Z, 1), z));
    _mm512_storeu_ps(p + 32, _mm512_permutex2var_ps(c, PACKED_INDICES(PACKED_FROM_Z, 2), z));
}

#elif defined(GN_LANES_AVX2)

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

/* Loads four floats at p and four floats that lie four vectors further on. */
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

#elif defined(GN_LANES_NEON)

static inline lanes_f lanes_quad(const float p[4])
{
    LANES_EACH_REGISTER(lanes_f, vld1q_f32(p));
}

static inline void lanes_spread(lanes_f a, lanes_f spread[4])
{
    for (int n = 0; n < 4; ++n) {
        spread[0].q[n] = vdupq_n_f32(vgetq_lane_f32(a.q[n], 0));
        spread[1].q[n] = vdupq_n_f32(vgetq_lane_f32(a.q[n], 1));
        spread[2].q[n] = vdupq_n_f32(vgetq_lane_f32(a.q[n], 2));
        spread[3].q[n] = vdupq_n_f32(vgetq_lane_f32(a.q[n], 3));
    }
}

static inline void lanes_load_vec3(const float *p, lanes_f v[3])
{
    for (int n = 0; n < 4; ++n) {
        const float32x4x3_t xyz = vld3q_f32(p + 12 * n);

        for (int i = 0; i < 3; ++i)
            v[i].q[n] = xyz.val[i];
    }
}

static inline void lanes_store_vec3(float *p, lanes_f v[3])
{
    for (int n = 0; n < 4; ++n) {
        float32x4x3_t xyz;

        for (int i = 0; i < 3; ++i)
            xyz.val[i] = v[i].q[n];
        vst3q_f32(p + 12 * n, xyz);
    }
}

#elif defined(GN_LANES_SSE2)

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

#elif defined(GN_LANES_VECTORS)

static inline lanes_f lanes_quad(const float p[4])
{
    LANES_EACH_REGISTER(lanes_f, lanes_vector_f_load(p));
}

static inline void lanes_spread(lanes_f a, lanes_f spread[4])
{
    GN_UNROLLED
    for (int n = 0; n < 4; ++n) {
        spread[0].q[n] = LANES_SHUFFLE(a.q[n], a.q[n], 0, 0, 0, 0);
        spread[1].q[n] = LANES_SHUFFLE(a.q[n], a.q[n], 1, 1, 1, 1);
        spread[2].q[n] = LANES_SHUFFLE(a.q[n], a.q[n], 2, 2, 2, 2);
        spread[3].q[n] = LANES_SHUFFLE(a.q[n], a.q[n], 3, 3, 3, 3);
    }
}

static inline void lanes_load_vec3(const float *p, lanes_f v[3])
{
    GN_UNROLLED
    for (int n = 0; n < 4; ++n) {
        const vector_f a = lanes_vector_f_load(p + 12 * n);     /* x0 y0 z0 x1 */
        const vector_f b = lanes_vector_f_load(p + 12 * n + 4); /* y1 z1 x2 y2 */
        const vector_f c = lanes_vector_f_load(p + 12 * n + 8); /* z2 x3 y3 z3 */
        const vector_f yz = LANES_SHUFFLE(a, b, 1, 2, 4, 5);    /* y0 z0 y1 z1 */
        const vector_f xy = LANES_SHUFFLE(b, c, 2, 3, 5, 6);    /* x2 y2 x3 y3 */

        v[0].q[n] = LANES_SHUFFLE(a, xy, 0, 3, 4, 6);
        v[1].q[n] = LANES_SHUFFLE(yz, xy, 0, 2, 5, 7);
        v[2].q[n] = LANES_SHUFFLE(yz, c, 1, 3, 4, 7);
    }
}

static inline void lanes_store_vec3(float *p, lanes_f v[3])
{
    GN_UNROLLED
    for (int n = 0; n < 4; ++n) {
        const vector_f x = v[0].q[n], y = v[1].q[n], z = v[2].q[n];
        const vector_f xy = LANES_SHUFFLE(x, y, 0, 2, 4, 6); /* x0 x2 y0 y2 */
        const vector_f yz = LANES_SHUFFLE(y, z, 1, 3, 5, 7); /* y1 y3 z1 z3 */
        const vector_f zx = LANES_SHUFFLE(z, x, 0, 2, 5, 7); /* z0 z2 x1 x3 */

        lanes_vector_f_store(p + 12 * n, LANES_SHUFFLE(xy, zx, 0, 2, 4, 6));
        lanes_vector_f_store(p + 12 * n + 4, LANES_SHUFFLE(yz, xy, 0, 2, 5, 7));
        lanes_vector_f_store(p + 12 * n + 8, LANES_SHUFFLE(zx, yz, 1, 3, 5, 7));
    }
}

#else

/* Through memory, for any form of lanes. */

static inline lanes_f lanes_quad(const float p[4])
{
    float quads[GN_LANES];

    GN_EACH_LANE (l)
        quads[l] = p[l % 4];
    return lanes_load(quads);
}

static inline void lanes_spread(lanes_f a, lanes_f spread[4])
{
    float lanes[GN_LANES], spread_lanes[GN_LANES];

    lanes_store(lanes, a);
    for (int i = 0; i < 4; ++i) {
        GN_EACH_LANE (l)
            spread_lanes[l] = lanes[l - l % 4 + i];
        spread[i] = lanes_load(spread_lanes);
    }
}

static inline void lanes_load_vec3(const float *p, lanes_f v[3])
{
    float component[GN_LANES];

    for (int i = 0; i < 3; ++i) {
        GN_EACH_LANE (l)
            component[l] = p[3 * l + i];
        v[i] = lanes_load(component);
    }
}

static inline void lanes_store_vec3(float *p, lanes_f v[3])
{
    float component[GN_LANES];

    for (int i = 0; i < 3; ++i) {
        lanes_store(component, v[i]);
        GN_EACH_LANE (l)
            p[3 * l + i] = component[l];
    }
}

#endif

#endif
