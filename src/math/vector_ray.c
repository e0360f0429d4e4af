/* Rays at a surface. */
#include <gnomon/scalar.h>
#include <gnomon/vec.h>

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
