/* Rays at a surface. */
#include <gnomon/scalar.h>
#include <gnomon/vec.h>

gn_vec2 gn_vec2_reflect(gn_vec2 v, gn_vec2 normal)
{
    gn_vec2 along = gn_vec2_scale(normal, gn_vec2_dot(normal, v));
    return gn_vec2_subtract(v, gn_vec2_scale(along, 2.0f));
}

gn_vec3 gn_vec3_reflect(gn_vec3 v, gn_vec3 normal)
{
    gn_vec3 along = gn_vec3_scale(normal, gn_vec3_dot(normal, v));
    return gn_vec3_subtract(v, gn_vec3_scale(along, 2.0f));
}

gn_vec4 gn_vec4_reflect(gn_vec4 v, gn_vec4 normal)
{
    gn_vec4 along = gn_vec4_scale(normal, gn_vec4_dot(normal, v));
    return gn_vec4_subtract(v, gn_vec4_scale(along, 2.0f));
}

/* What is left of 1 in the square of the refracted direction across the surface. */
static float rest(float eta, float d)
{
    return 1.0f - eta * (eta * (1.0f - d * d));
}

gn_vec2 gn_vec2_refract(gn_vec2 v, gn_vec2 normal, float eta)
{
    const gn_vec2 none = {0.0f, 0.0f};
    float d = gn_vec2_dot(normal, v), k = rest(eta, d);
    if (k < 0.0f) {
        return none;
    }
    return gn_vec2_subtract(gn_vec2_scale(v, eta), gn_vec2_scale(normal, eta * d + gn_sqrt(k)));
}

gn_vec3 gn_vec3_refract(gn_vec3 v, gn_vec3 normal, float eta)
{
    const gn_vec3 none = {0.0f, 0.0f, 0.0f};
    float d = gn_vec3_dot(normal, v), k = rest(eta, d);
    if (k < 0.0f) {
        return none;
    }
    return gn_vec3_subtract(gn_vec3_scale(v, eta), gn_vec3_scale(normal, eta * d + gn_sqrt(k)));
}

gn_vec4 gn_vec4_refract(gn_vec4 v, gn_vec4 normal, float eta)
{
    const gn_vec4 none = {0.0f, 0.0f, 0.0f, 0.0f};
    float d = gn_vec4_dot(normal, v), k = rest(eta, d);
    if (k < 0.0f) {
        return none;
    }
    return gn_vec4_subtract(gn_vec4_scale(v, eta), gn_vec4_scale(normal, eta * d + gn_sqrt(k)));
}
