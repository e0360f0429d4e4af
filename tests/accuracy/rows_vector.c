/* Vectors beside cglm's. Bounds count roundings, u each: n of a dot product of n components
 * (vec.h), so n/2 + 1 of its root, and 1 more of a division by it (ours, and cglm's vec4) or 2
 * of the product with a reciprocal. */
#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>

#include "rows.h"
#include "wide.h"

OWN(add)
{
    return put_vec3(gn_vec3_add(vec3_of(in), vec3_of(in + 3)), out);
}
OTHER(add)
{
    glm_vec3_add(in, in + 3, out);
}
EXACT(add)
{
    for (int i = 0; i < 3; ++i)
        relative(exact, i, (wide)in[i] + (wide)in[3 + i]);
}

OWN(subtract)
{
    return put_vec3(gn_vec3_subtract(vec3_of(in), vec3_of(in + 3)), out);
}
OTHER(subtract)
{
    glm_vec3_sub(in, in + 3, out);
}
EXACT(subtract)
{
    for (int i = 0; i < 3; ++i)
        relative(exact, i, (wide)in[i] - (wide)in[3 + i]);
}

OWN(scale)
{
    return put_vec3(gn_vec3_scale(vec3_of(in), in[3]), out);
}
OTHER(scale)
{
    glm_vec3_scale(in, in[3], out);
}
EXACT(scale)
{
    for (int i = 0; i < 3; ++i)
        relative(exact, i, (wide)in[i] * (wide)in[3]);
}

/* Products of n components. */
OWN(dot2)
{
    return put(gn_vec2_dot(vec2_of(in), vec2_of(in + 2)), out);
}
OTHER(dot2)
{
    *out = glm_vec2_dot(in, in + 2);
}
EXACT(dot2)
{
    exact->value[0] = sum_of_products(in, 1, in + 2, 1, 2, exact->scale);
}

OWN(dot3)
{
    return put(gn_vec3_dot(vec3_of(in), vec3_of(in + 3)), out);
}
OTHER(dot3)
{
    *out = glm_vec3_dot(in, in + 3);
}
EXACT(dot3)
{
    exact->value[0] = sum_of_products(in, 1, in + 3, 1, 3, exact->scale);
}

OWN(dot4)
{
    return put(gn_vec4_dot(vec4_of(in), vec4_of(in + 4)), out);
}
OTHER(dot4)
{
    *out = glm_vec4_dot(in, in + 4);
}
EXACT(dot4)
{
    exact->value[0] = sum_of_products(in, 1, in + 4, 1, 4, exact->scale);
}

OWN(cross2)
{
    return put(gn_vec2_cross(vec2_of(in), vec2_of(in + 2)), out);
}
OTHER(cross2)
{
    *out = glm_vec2_cross(in, in + 2);
}
EXACT(cross2)
{
    const wide first = (wide)in[0] * (wide)in[3], second = (wide)in[1] * (wide)in[2];
    absolute(exact, 0, first - second, fabsl(first) + fabsl(second));
}

OWN(cross3)
{
    return put_vec3(gn_vec3_cross(vec3_of(in), vec3_of(in + 3)), out);
}
OTHER(cross3)
{
    glm_vec3_cross(in, in + 3, out);
}
EXACT(cross3)
{
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const wide first = (wide)in[j] * (wide)in[3 + k], second = (wide)in[k] * (wide)in[3 + j];
        absolute(exact, i, first - second, fabsl(first) + fabsl(second));
    }
}

OWN(length2)
{
    return put(gn_vec2_length(vec2_of(in)), out);
}
OTHER(length2)
{
    *out = glm_vec2_norm(in);
}
EXACT(length2)
{
    relative(exact, 0, wide_length(in, 2));
}

OWN(length3)
{
    return put(gn_vec3_length(vec3_of(in)), out);
}
OTHER(length3)
{
    *out = glm_vec3_norm(in);
}
EXACT(length3)
{
    relative(exact, 0, wide_length(in, 3));
}

OWN(length4)
{
    return put(gn_vec4_length(vec4_of(in)), out);
}
OTHER(length4)
{
    *out = glm_vec4_norm(in);
}
EXACT(length4)
{
    relative(exact, 0, wide_length(in, 4));
}

/* Directions: the error of every component is relative to the component, so no component may be too
 * small. 2^-45 to 2^45 give results above 2^-91, and are not scaled down in between (length.c). */
static void exact_direction(const float *in, int count, struct exact *exact)
{
    for (int i = 0; i < count; ++i)
        relative(exact, i, (wide)in[i] / wide_length(in, count));
}

OWN(normalize2)
{
    gn_vec2 r;
    if (gn_vec2_normalize(vec2_of(in), &r) != GN_OK)
        return false;
    out[0] = r.x;
    out[1] = r.y;
    return true;
}
OTHER(normalize2)
{
    lengthen(in, 2);
    glm_vec2_normalize_to(in, out);
}
EXACT(normalize2)
{
    exact_direction(in, 2, exact);
}

OWN(normalize3)
{
    gn_vec3 r;
    return gn_vec3_normalize(vec3_of(in), &r) == GN_OK && put_vec3(r, out);
}
OTHER(normalize3)
{
    lengthen(in, 3);
    glm_vec3_normalize_to(in, out);
}
EXACT(normalize3)
{
    exact_direction(in, 3, exact);
}

OWN(normalize4)
{
    gn_vec4 r;
    return gn_vec4_normalize(vec4_of(in), &r) == GN_OK && put_vec4(r, out);
}
OTHER(normalize4)
{
    lengthen(in, 4);
    glm_vec4_normalize_to(in, out);
}
EXACT(normalize4)
{
    exact_direction(in, 4, exact);
}

/* a * (1 - t) + b * t: 1 - t, the products and the sum are rounded once each. cglm's a + (b - a) *
 * t rounds the change b - a two more times, and the sum once. */
OWN(mix)
{
    return put_vec3(gn_vec3_mix(vec3_of(in), vec3_of(in + 3), in[6]), out);
}
OTHER(mix)
{
    glm_vec3_lerp(in, in + 3, in[6], out);
}
EXACT(mix)
{
    for (int i = 0; i < 3; ++i) {
        const wide change = ((wide)in[3 + i] - (wide)in[i]) * (wide)in[6];
        absolute(exact, i, (wide)in[i] + change,
                 fabsl((wide)in[i] * (1.0L - (wide)in[6])) + fabsl((wide)in[3 + i] * (wide)in[6]));
        exact->other_scale[i] = fabsl((wide)in[i]) + fabsl(change);
    }
}

static const struct row rows[] = {
    ROW(add, "vec3 add", 6, 3, 60, NULL, 1, 1),
    ROW(subtract, "vec3 subtract", 6, 3, 60, NULL, 1, 1),
    ROW(scale, "vec3 scale", 4, 3, 60, NULL, 1, 1),
    ROW(dot2, "vec2 dot", 4, 1, 60, NULL, 2, 2, .fixed = "the order of operations is GLSL's"),
    ROW(dot3, "vec3 dot", 6, 1, 60, NULL, 3, 3, .fixed = "the order of operations is GLSL's"),
    ROW(dot4, "vec4 dot", 8, 1, 60, NULL, 4, 4, .fixed = "the order of operations is GLSL's"),
    ROW(cross2, "vec2 cross", 4, 1, 60, NULL, 2, 2),
    ROW(cross3, "vec3 cross", 6, 3, 60, NULL, 2, 2),
    ROW(length2, "vec2 length", 2, 1, 60, NULL, 2, 2),
    ROW(length3, "vec3 length", 3, 1, 60, NULL, 2.5, 2.5),
    ROW(length4, "vec4 length", 4, 1, 60, NULL, 3, 3),
    ROW(normalize2, "vec2 normalize", 2, 2, 45, NULL, 3, 4),
    ROW(normalize3, "vec3 normalize", 3, 3, 45, NULL, 3.5, 4.5),
    ROW(normalize4, "vec4 normalize", 4, 4, 45, NULL, 4, 4),
    ROW(mix, "vec3 mix", 7, 3, 30, NULL, 3, 3),
};

const struct table vector_rows = {rows, sizeof rows / sizeof rows[0]};
