/* The texels of fragments, over lanes: coordinates divided by q, GL_CLAMP, cubes with seams, and
 * what becomes of depths. The order of operations is the reference's. */
#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "fixed_texture.h"
#include "lane_function.h"

static float clamped(float x)
{
    return x > 0.0f ? x < 1.0f ? x : 1.0f : 0.0f;
}

/* Writes the differences of a coordinate within quads, from the lower left fragment. */
static void write_quad_gradients(const float coordinate[GN_LANES], float along_x[GN_LANES],
                                 float along_y[GN_LANES])
{
    for (int l = 0; l < GN_LANES; ++l) {
        const int first = l & ~5;

        along_x[l] = coordinate[first + 1] - coordinate[first];
        along_y[l] = coordinate[first + 4] - coordinate[first];
    }
}

/* Writes s, t and r, divided by q. */
static void find_place(const unit_derived *unit, const gn_fragment_input *input,
                       texture_place *place)
{
    float inverse[GN_LANES];

    place->has_gradients = false;
    if (unit->varying < 0) {
        for (int i = 0; i < 3; ++i)
            for (int l = 0; l < GN_LANES; ++l)
                place->coordinate[i][l] = unit->coordinate[i] * (1.0f / unit->coordinate[3]);
    } else {
        const float(*const from)[GN_LANES] = input->varying + unit->varying;

        for (int l = 0; l < GN_LANES; ++l)
            inverse[l] = 1.0f / from[3][l];
        for (int i = 0; i < 3; ++i)
            for (int l = 0; l < GN_LANES; ++l)
                place->coordinate[i][l] = from[i][l] * inverse[l];
    }
    for (int l = 0; l < GN_LANES && unit->is_compared; ++l) {
        const float r = place->coordinate[2][l];

        place->reference[l] = unit->clamps_reference ? clamped(r) : r;
    }
}

/* With GL_CLAMP and linear filters, places are clamped to 0..1, but the level of detail is that of
 * the places before. */
static void clamp_place(const unit_derived *unit, texture_place *place)
{
    place->has_gradients = unit->clamps[0] || unit->clamps[1] || unit->clamps[2];
    for (int i = 0; i < 3 && place->has_gradients; ++i) {
        write_quad_gradients(place->coordinate[i], place->along_x[i], place->along_y[i]);
        for (int l = 0; l < GN_LANES && unit->clamps[i]; ++l)
            place->coordinate[i][l] = fminf(clamped(place->coordinate[i][l]), unit->most);
    }
}

static bool has_levels(const unit_derived *unit)
{
    return unit->texture.level_count > 1 && unit->sampler.minify != GN_MINIFY_NEAREST &&
           unit->sampler.minify != GN_MINIFY_LINEAR;
}

/* Writes the channels that a depth becomes (OpenGL 2.1 section 3.8.14). */
static void spread_depth(GLenum mode, float texel[4][GN_LANES])
{
    for (int l = 0; l < GN_LANES; ++l) {
        const float depth = texel[0][l];

        texel[0][l] = mode == GL_ALPHA ? 0.0f : depth;
        texel[1][l] = texel[2][l] = mode == GL_ALPHA || mode == GL_RED ? 0.0f : depth;
        texel[3][l] = mode == GL_ALPHA || mode == GL_INTENSITY ? depth : 1.0f;
    }
}

LANE_FUNCTION
void look_up_texture(const unit_derived *unit, const gn_fragment_input *input,
                     float texel[4][GN_LANES])
{
    texture_place place;
    gn_lookup lookup;

    find_place(unit, input, &place);
    if (unit->has_separate_faces)
        place_on_faces(&place, !has_levels(unit));
    else
        clamp_place(unit, &place);
    if (unit->texture.target == GN_TEXTURE_2D && !place.has_gradients && !unit->is_compared) {
        gn_fragment_lookup_2d(input, &unit->texture, &unit->sampler, place.coordinate[0],
                              place.coordinate[1], texel);
    } else {
        memset(&lookup, 0, sizeof lookup);
        for (int i = 0; i < 3; ++i) {
            lookup.coordinate[i] = place.coordinate[i];
            lookup.gradient_x[i] = place.along_x[i];
            lookup.gradient_y[i] = place.along_y[i];
        }
        lookup.reference = unit->is_compared ? place.reference : NULL;
        lookup.lod_source = place.has_gradients ? GN_LOD_GRADIENTS : GN_LOD_IMPLICIT;
        gn_fragment_lookup(input, &unit->texture, &unit->sampler, &lookup, texel);
    }
    if (unit->depth_mode)
        spread_depth(unit->depth_mode, texel);
}

LANE_FUNCTION
const float (*unit_texel(texture_colors *colors, int u))[GN_LANES]
{
    float(*const texel)[GN_LANES] = colors->texel[u];

    if (!(colors->known >> u & 1u)) {
        if (colors->units[u].enabled)
            look_up_texture(&colors->units[u], colors->input, texel);
        else
            memset(texel, 0, sizeof colors->texel[u]);
        colors->known |= 1u << u;
    }
    return (const float(*)[GN_LANES])texel;
}
