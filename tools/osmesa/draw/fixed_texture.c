/* Texture coordinates and environments, over lanes. The order of operations is the reference's. */
#include "fixed_texture.h"

#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "lane_function.h"

static void write_product(const float plane[4], const float (*place)[GN_LANES], float to[GN_LANES])
{
    for (int l = 0; l < GN_LANES; ++l)
        to[l] = ((place[3][l] * plane[3] + place[2][l] * plane[2]) + place[1][l] * plane[1]) +
                place[0][l] * plane[0];
}

/* The direction from the eye, reflected, and in [3] the sphere map's 1 / (2 m). `has_depth`: z is a
 * coordinate itself; then it is computed before 1 is added. */
static void write_reflection(lit_vertices *v, bool has_depth, float to[4][GN_LANES])
{
    const float(*const n)[GN_LANES] = used_normal(v);
    const float(*const u)[GN_LANES] = eye_direction(v);

    for (int l = 0; l < GN_LANES; ++l) {
        const float cosine = dot_3(n[0][l], n[1][l], n[2][l], u[0][l], u[1][l], u[2][l]);
        const float twice = -(cosine + cosine);
        const float x = twice * n[0][l] + u[0][l], y = twice * n[1][l] + u[1][l];
        const float z = twice * n[2][l] + u[2][l];
        const float lifted = has_depth ? z + 1.0f : (twice * n[2][l] + 1.0f) + u[2][l];

        to[0][l] = x;
        to[1][l] = y;
        to[2][l] = z;
        to[3][l] = 1.0f / sqrtf(dot_3(x, y, lifted, x, y, lifted)) * 0.5f;
    }
}

static void generate(const unit_derived *unit, lit_vertices *v, float (*to)[GN_LANES])
{
    for (int i = 0; i < 4; ++i) {
        const texture_generation *const generation = &unit->generation[i];
        float reflection[4][GN_LANES];

        if (!generation->enabled)
            continue;
        switch (generation->mode) {
        case GL_OBJECT_LINEAR:
            write_product(generation->object_plane, v->position, to[i]);
            break;
        case GL_EYE_LINEAR:
            write_product(generation->eye_plane, eye_place(v), to[i]);
            break;
        case GL_NORMAL_MAP:
            memcpy(to[i], used_normal(v)[i], sizeof to[i]);
            break;
        default:
            write_reflection(v, unit->has_reflected_depth, reflection);
            for (int l = 0; l < GN_LANES; ++l)
                to[i][l] = generation->mode == GL_REFLECTION_MAP
                               ? reflection[i][l]
                               : reflection[i][l] * reflection[3][l] + 0.5f;
        }
    }
}

LANE_FUNCTION
void write_texture_coordinates(const unit_derived *unit, lit_vertices *v,
                               const float (*own)[GN_LANES], float (*to)[GN_LANES])
{
    const float *const m = unit->matrix;
    float from[4][GN_LANES];

    memcpy(from, own, sizeof from);
    if (unit->generates)
        generate(unit, v, from);
    if (!unit->has_matrix) {
        memcpy(to, from, sizeof from);
        return;
    }
    for (int row = 0; row < 4; ++row)
        for (int l = 0; l < GN_LANES; ++l)
            to[row][l] =
                ((from[0][l] * m[row] + from[1][l] * m[4 + row]) + from[2][l] * m[8 + row]) +
                from[3][l] * m[12 + row];
}

/* Fragments */

static float clamped(float x)
{
    return x > 0.0f ? x < 1.0f ? x : 1.0f : 0.0f;
}

/* Returns the mixture of two colours and an addend, which is added first to a product. */
static float mix(float before, float other, float weight, float addend, bool is_product)
{
    const float change = weight * (other - before);

    return is_product ? (before + addend) + change : (change + before) + addend;
}

/* Applies an operation to one channel; `weight` is the texels' alpha, `addend` 0 or a secondary
 * colour. */
static void apply(const unit_derived *unit, int channel, const float texel[GN_LANES],
                  const float weight[GN_LANES], const float addend[GN_LANES], float color[GN_LANES])
{
    switch (channel < 3 ? unit->color_operation : unit->alpha_operation) {
    case TEXTURE_REPLACES:
        for (int l = 0; l < GN_LANES; ++l)
            color[l] = texel[l] + addend[l];
        break;
    case TEXTURE_MODULATES:
        for (int l = 0; l < GN_LANES; ++l)
            color[l] = texel[l] * color[l] + addend[l];
        break;
    case TEXTURE_ADDS:
        for (int l = 0; l < GN_LANES; ++l)
            color[l] = clamped(texel[l] + color[l]) + addend[l];
        break;
    case TEXTURE_DECALS:
        for (int l = 0; l < GN_LANES; ++l)
            color[l] = mix(color[l], texel[l], weight[l], addend[l], unit->follows_product);
        break;
    case TEXTURE_BLENDS:
        for (int l = 0; l < GN_LANES; ++l)
            color[l] =
                mix(color[l], unit->color[channel], texel[l], addend[l], unit->follows_product);
        break;
    default:
        for (int l = 0; l < GN_LANES; ++l)
            color[l] += addend[l];
    }
}

LANE_FUNCTION
void apply_texture(texture_colors *colors, int u, float (*color)[GN_LANES],
                   const float (*secondary)[GN_LANES])
{
    static const float nothing[GN_LANES];
    const unit_derived *const unit = &colors->units[u];
    const float(*texel)[GN_LANES];

    if (unit->combines) {
        apply_combine(colors, u, color);
        for (int c = 0; c < 3 && secondary; ++c)
            for (int l = 0; l < GN_LANES; ++l)
                color[c][l] += secondary[c][l];
        return;
    }
    texel = unit_texel(colors, u);
    for (int c = 0; c < 4; ++c)
        apply(unit, c, texel[c], texel[3], secondary && c < 3 ? secondary[c] : nothing, color[c]);
}
