/* Vector arithmetic, component by component. */
#include <gnomon/vec.h>

gn_vec2 gn_vec2_add(gn_vec2 a, gn_vec2 b)
{
    gn_vec2 sum = {a.x + b.x, a.y + b.y};
    return sum;
}

gn_vec3 gn_vec3_add(gn_vec3 a, gn_vec3 b)
{
    gn_vec3 sum = {a.x + b.x, a.y + b.y, a.z + b.z};
    return sum;
}

gn_vec4 gn_vec4_add(gn_vec4 a, gn_vec4 b)
{
    gn_vec4 sum = {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
    return sum;
}

gn_vec2 gn_vec2_subtract(gn_vec2 a, gn_vec2 b)
{
    gn_vec2 difference = {a.x - b.x, a.y - b.y};
    return difference;
}

gn_vec3 gn_vec3_subtract(gn_vec3 a, gn_vec3 b)
{
    gn_vec3 difference = {a.x - b.x, a.y - b.y, a.z - b.z};
    return difference;
}

gn_vec4 gn_vec4_subtract(gn_vec4 a, gn_vec4 b)
{
    gn_vec4 difference = {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w};
    return difference;
}

gn_vec2 gn_vec2_multiply(gn_vec2 a, gn_vec2 b)
{
    gn_vec2 product = {a.x * b.x, a.y * b.y};
    return product;
}

gn_vec3 gn_vec3_multiply(gn_vec3 a, gn_vec3 b)
{
    gn_vec3 product = {a.x * b.x, a.y * b.y, a.z * b.z};
    return product;
}

gn_vec4 gn_vec4_multiply(gn_vec4 a, gn_vec4 b)
{
    gn_vec4 product = {a.x * b.x, a.y * b.y, a.z * b.z, a.w * b.w};
    return product;
}

gn_vec2 gn_vec2_negate(gn_vec2 v)
{
    gn_vec2 opposite = {-v.x, -v.y};
    return opposite;
}

gn_vec3 gn_vec3_negate(gn_vec3 v)
{
    gn_vec3 opposite = {-v.x, -v.y, -v.z};
    return opposite;
}

gn_vec4 gn_vec4_negate(gn_vec4 v)
{
    gn_vec4 opposite = {-v.x, -v.y, -v.z, -v.w};
    return opposite;
}

gn_vec2 gn_vec2_scale(gn_vec2 v, float factor)
{
    gn_vec2 product = {v.x * factor, v.y * factor};
    return product;
}

gn_vec3 gn_vec3_scale(gn_vec3 v, float factor)
{
    gn_vec3 product = {v.x * factor, v.y * factor, v.z * factor};
    return product;
}

gn_vec4 gn_vec4_scale(gn_vec4 v, float factor)
{
    gn_vec4 product = {v.x * factor, v.y * factor, v.z * factor, v.w * factor};
    return product;
}

float gn_vec2_dot(gn_vec2 a, gn_vec2 b)
{
    return a.y * b.y + a.x * b.x;
}

float gn_vec3_dot(gn_vec3 a, gn_vec3 b)
{
    /* Kernel: dot. */
    const float sum = (a.z * b.z + a.y * b.y) + a.x * b.x;
    /* End of kernel. */
    return sum;
}

float gn_vec4_dot(gn_vec4 a, gn_vec4 b)
{
    return ((a.w * b.w + a.z * b.z) + a.y * b.y) + a.x * b.x;
}

float gn_vec2_cross(gn_vec2 a, gn_vec2 b)
{
    return a.x * b.y - a.y * b.x;
}

gn_vec3 gn_vec3_cross(gn_vec3 a, gn_vec3 b)
{
    gn_vec3 product = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return product;
}

gn_vec2 gn_vec2_mix(gn_vec2 a, gn_vec2 b, float t)
{
    const float rest = 1.0f - t;
    gn_vec2 between = {a.x * rest + b.x * t, a.y * rest + b.y * t};
    return between;
}

gn_vec3 gn_vec3_mix(gn_vec3 a, gn_vec3 b, float t)
{
    const float rest = 1.0f - t;
    gn_vec3 between = {a.x * rest + b.x * t, a.y * rest + b.y * t, a.z * rest + b.z * t};
    return between;
}

gn_vec4 gn_vec4_mix(gn_vec4 a, gn_vec4 b, float t)
{
    const float rest = 1.0f - t;
    gn_vec4 between = {a.x * rest + b.x * t, a.y * rest + b.y * t, a.z * rest + b.z * t,
                       a.w * rest + b.w * t};
    return between;
}
