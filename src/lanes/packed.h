/* Lanes of packed vectors.
 *
 *   splat_vec4              four floats, repeated in each group of four lanes
 *   spread                  spread[i] holds lane i of each group of four in all its lanes
 *   load_vec3 store_vec3    LANES vectors of three floats, one after the other in memory,
 *                           to and from one lanes_f per component; no other memory is read
 *                           or written */
#ifndef GN_LANES_PACKED_H
#define GN_LANES_PACKED_H

#include "lanes.h"

#if defined(LANES_REGISTERS)

static inline lanes_f lanes_splat_vec4(const float p[4])
{
    LANES_EACH_REGISTER(lanes_f, register_splat_vec4(p));
}

static inline void lanes_spread(lanes_f a, lanes_f spread[4])
{
    GN_UNROLLED
    for (int n = 0; n < LANES_REGISTERS; ++n) {
        spread[0].q[n] = register_spread(a.q[n], 0);
        spread[1].q[n] = register_spread(a.q[n], 1);
        spread[2].q[n] = register_spread(a.q[n], 2);
        spread[3].q[n] = register_spread(a.q[n], 3);
    }
}

#if !defined(register_load_vec3)
#define register_load_vec3(p, v) load_by_shuffle(p, v)
#define register_store_vec3(p, v) store_by_shuffle(p, v)

/* Row r holds four vectors: twelve floats, loaded four at a time. */
#define PACKED_FIRST(r) (p + 12 * (r))
#define PACKED_SECOND(r) (p + 12 * (r) + 4)
#define PACKED_THIRD(r) (p + 12 * (r) + 8)

static inline void load_by_shuffle(const float *p, register_f v[3])
{
    const register_f a = register_as_float(register_i_load_rows(PACKED_FIRST));  /* x0 y0 z0 x1 */
    const register_f b = register_as_float(register_i_load_rows(PACKED_SECOND)); /* y1 z1 x2 y2 */
    const register_f c = register_as_float(register_i_load_rows(PACKED_THIRD));  /* z2 x3 y3 z3 */
    const register_f yz = register_shuffle(a, b, 1, 2, 0, 1);                    /* y0 z0 y1 z1 */
    const register_f xy = register_shuffle(b, c, 2, 3, 1, 2);                    /* x2 y2 x3 y3 */

    v[0] = register_shuffle(a, xy, 0, 3, 0, 2);
    v[1] = register_shuffle(yz, xy, 0, 2, 1, 3);
    v[2] = register_shuffle(yz, c, 1, 3, 0, 3);
}

static inline void store_by_shuffle(float *p, const register_f v[3])
{
    const register_f xy = register_even(v[0], v[1]);                /* x0 x2 y0 y2 */
    const register_f yz = register_odd(v[1], v[2]);                 /* y1 y3 z1 z3 */
    const register_f zx = register_shuffle(v[2], v[0], 0, 2, 1, 3); /* z0 z2 x1 x3 */

    register_i_store_rows(PACKED_FIRST, register_as_int(register_even(xy, zx)));
    register_i_store_rows(PACKED_SECOND, register_as_int(register_shuffle(yz, xy, 0, 2, 1, 3)));
    register_i_store_rows(PACKED_THIRD, register_as_int(register_odd(zx, yz)));
}

#endif

static inline void lanes_load_vec3(const float *p, lanes_f v[3])
{
    GN_UNROLLED
    for (int n = 0; n < LANES_REGISTERS; ++n) {
        register_f xyz[3];

        register_load_vec3(p + 3 * REGISTER_LANES * n, xyz);
        GN_UNROLLED
        for (int i = 0; i < 3; ++i)
            v[i].q[n] = xyz[i];
    }
}

static inline void lanes_store_vec3(float *p, lanes_f v[3])
{
    GN_UNROLLED
    for (int n = 0; n < LANES_REGISTERS; ++n) {
        const register_f xyz[3] = {v[0].q[n], v[1].q[n], v[2].q[n]};

        register_store_vec3(p + 3 * REGISTER_LANES * n, xyz);
    }
}

#else

static inline lanes_f lanes_splat_vec4(const float p[4])
{
    float repeated[LANES];

    GN_EACH_LANE (l)
        repeated[l] = p[l % 4];
    return lanes_load(repeated);
}

static inline void lanes_spread(lanes_f a, lanes_f spread[4])
{
    float lanes[LANES], spread_lanes[LANES];

    lanes_store(lanes, a);
    for (int i = 0; i < 4; ++i) {
        GN_EACH_LANE (l)
            spread_lanes[l] = lanes[l - l % 4 + i];
        spread[i] = lanes_load(spread_lanes);
    }
}

static inline void lanes_load_vec3(const float *p, lanes_f v[3])
{
    float component[LANES];

    for (int i = 0; i < 3; ++i) {
        GN_EACH_LANE (l)
            component[l] = p[3 * l + i];
        v[i] = lanes_load(component);
    }
}

static inline void lanes_store_vec3(float *p, lanes_f v[3])
{
    float component[LANES];

    for (int i = 0; i < 3; ++i) {
        lanes_store(component, v[i]);
        GN_EACH_LANE (l)
            p[3 * l + i] = component[l];
    }
}

#endif

#endif
