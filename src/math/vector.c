/* Vectors, component by component: arithmetic, products, selection, and directions reflected and
 * refracted at a surface. */
#include "vector.h"

#include <gnomon/scalar.h>

#include "../scalars/bits.h"

bool gni_vec3_is_finite(gn_vec3 v)
{
    return is_finite(v.x) && is_finite(v.y) && is_finite(v.z);
}

bool gni_has_reciprocal(float x)
{
    float magnitude = magnitude_of(x);
    return magnitude >= 0x1p-126f && magnitude <= 0x1p126f;
}

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

/* x != x means that x is NaN. */
static float lesser(float a, float b)
{
    return a < b || b != b ? a : b;
}

static float greater(float a, float b)
{
    return a > b || b != b ? a : b;
}

static float clamped(float x, float low, float high)
{
    return lesser(greater(x, low), high);
}

gn_vec2 gn_vec2_minimum(gn_vec2 a, gn_vec2 b)
{
    gn_vec2 least = {lesser(a.x, b.x), lesser(a.y, b.y)};
    return least;
}

gn_vec3 gn_vec3_minimum(gn_vec3 a, gn_vec3 b)
{
    gn_vec3 least = {lesser(a.x, b.x), lesser(a.y, b.y), lesser(a.z, b.z)};
    return least;
}

gn_vec4 gn_vec4_minimum(gn_vec4 a, gn_vec4 b)
{
    gn_vec4 least = {lesser(a.x, b.x), lesser(a.y, b.y), lesser(a.z, b.z), lesser(a.w, b.w)};
    return least;
}

gn_vec2 gn_vec2_maximum(gn_vec2 a, gn_vec2 b)
{
    gn_vec2 most = {greater(a.x, b.x), greater(a.y, b.y)};
    return most;
}

gn_vec3 gn_vec3_maximum(gn_vec3 a, gn_vec3 b)
{
    gn_vec3 most = {greater(a.x, b.x), greater(a.y, b.y), greater(a.z, b.z)};
    return most;
}

gn_vec4 gn_vec4_maximum(gn_vec4 a, gn_vec4 b)
{
    gn_vec4 most = {greater(a.x, b.x), greater(a.y, b.y), greater(a.z, b.z), greater(a.w, b.w)};
    return most;
}

gn_vec2 gn_vec2_clamp(gn_vec2 v, float low, float high)
{
    gn_vec2 between = {clamped(v.x, low, high), clamped(v.y, low, high)};
    return between;
}

gn_vec3 gn_vec3_clamp(gn_vec3 v, float low, float high)
{
    gn_vec3 between = {clamped(v.x, low, high), clamped(v.y, low, high), clamped(v.z, low, high)};
    return between;
}

gn_vec4 gn_vec4_clamp(gn_vec4 v, float low, float high)
{
    gn_vec4 between = {clamped(v.x, low, high), clamped(v.y, low, high), clamped(v.z, low, high),
                       clamped(v.w, low, high)};
    return between;
}

gn_vec2 gn_vec2_reflect(gn_vec2 v, gn_vec2 normal)
{
    return gn_vec2_subtract(v, gn_vec2_scale(normal, 2.0f * gn_vec2_dot(normal, v)));
}

gn_vec3 gn_vec3_reflect(gn_vec3 v, gn_vec3 normal)
{
    return gn_vec3_subtract(v, gn_vec3_scale(normal, 2.0f * gn_vec3_dot(normal, v)));
}

gn_vec4 gn_vec4_reflect(gn_vec4 v, gn_vec4 normal)
{
    return gn_vec4_subtract(v, gn_vec4_scale(normal, 2.0f * gn_vec4_dot(normal, v)));
}

/* Returns the square of the part of the refracted direction along the normal; negative if no
 * direction is refracted. */
static float square_along(float eta, float d)
{
    return 1.0f - eta * (eta * (1.0f - d * d));
}

static float refracted(float v, float normal, float eta, float along, float square)
{
    return square < 0.0f ? 0.0f : eta * v - along * normal;
}

gn_vec2 gn_vec2_refract(gn_vec2 v, gn_vec2 normal, float eta)
{
    float d = gn_vec2_dot(normal, v), square = square_along(eta, d);
    float along = eta * d + gn_sqrt(square);
    gn_vec2 direction = {refracted(v.x, normal.x, eta, along, square),
                         refracted(v.y, normal.y, eta, along, square)};
    return direction;
}

gn_vec3 gn_vec3_refract(gn_vec3 v, gn_vec3 normal, float eta)
{
    float d = gn_vec3_dot(normal, v), square = square_along(eta, d);
    float along = eta * d + gn_sqrt(square);
    gn_vec3 direction = {refracted(v.x, normal.x, eta, along, square),
                         refracted(v.y, normal.y, eta, along, square),
                         refracted(v.z, normal.z, eta, along, square)};
    return direction;
}

gn_vec4 gn_vec4_refract(gn_vec4 v, gn_vec4 normal, float eta)
{
    float d = gn_vec4_dot(normal, v), square = square_along(eta, d);
    float along = eta * d + gn_sqrt(square);
    gn_vec4 direction = {
        refracted(v.x, normal.x, eta, along, square), refracted(v.y, normal.y, eta, along, square),
        refracted(v.z, normal.z, eta, along, square), refracted(v.w, normal.w, eta, along, square)};
    return direction;
}
