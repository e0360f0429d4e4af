/* Selection, component by component. */
#include <gnomon/vec.h>

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
