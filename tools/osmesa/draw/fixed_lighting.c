/* Lighting, over lanes. The order of operations is the reference's. */
#include "fixed_lighting.h"

#include <math.h>
#include <string.h>

#include "lane_function.h"
#include "short_exponential.h"

LANE_FUNCTION
const float (*eye_place(lit_vertices *v))[GN_LANES]
{
    const float *const m = v->eye->modelview;

    for (int row = 0; row < 4 && !v->has_place; ++row)
        for (int l = 0; l < GN_LANES; ++l)
            v->place[row][l] = ((m[row] * v->position[0][l] + m[4 + row] * v->position[1][l]) +
                                m[8 + row] * v->position[2][l]) +
                               m[12 + row] * v->position[3][l];
    v->has_place = true;
    return (const float(*)[GN_LANES])v->place;
}

/* Scales vectors to length 1. */
static void normalize(float v[3][GN_LANES])
{
    for (int l = 0; l < GN_LANES; ++l) {
        const float square = dot_3(v[0][l], v[1][l], v[2][l], v[0][l], v[1][l], v[2][l]);
        const float scale = 1.0f / sqrtf(square);

        for (int c = 0; c < 3; ++c)
            v[c][l] *= scale;
    }
}

LANE_FUNCTION
const float (*eye_direction(lit_vertices *v))[GN_LANES]
{
    if (!v->has_direction) {
        memcpy(v->direction, eye_place(v), sizeof v->direction);
        normalize(v->direction);
        v->has_direction = true;
    }
    return (const float(*)[GN_LANES])v->direction;
}

LANE_FUNCTION
const float (*used_normal(lit_vertices *v))[GN_LANES]
{
    const float(*const n)[GN_LANES] = v->object_normal;
    const float *const m = v->eye->inverse;

    if (v->has_normal)
        return (const float(*)[GN_LANES])v->normal;
    memcpy(v->normal, n, sizeof v->normal);
    for (int c = 0; c < 3 && v->eye->is_used; ++c)
        for (int l = 0; l < GN_LANES; ++l)
            v->normal[c][l] =
                dot_3(n[0][l], n[1][l], n[2][l], m[4 * c], m[4 * c + 1], m[4 * c + 2]);
    if (v->eye->normalizes)
        normalize(v->normal);
    for (int c = 0; c < 3 && v->eye->rescales; ++c)
        for (int l = 0; l < GN_LANES; ++l)
            v->normal[c][l] *= v->eye->normal_scale;
    v->has_normal = true;
    return (const float(*)[GN_LANES])v->normal;
}

/* The geometry of a light at vertices: cosines of its angles to the normal, and how much reaches
 * them. */
typedef struct light_geometry {
    float to_light[3][GN_LANES];
    float square[GN_LANES];  /* of the distance */
    float facing[GN_LANES];  /* the normal times the direction to the light */
    float shining[GN_LANES]; /* the normal times the half vector */
    float reach[GN_LANES];
    bool is_weakened; /* `reach` counts */
} light_geometry;

static void set_direction(const light_derived *light, lit_vertices *v, light_geometry *g)
{
    const float(*place)[GN_LANES];

    if (light->is_directional) {
        for (int c = 0; c < 3; ++c)
            for (int l = 0; l < GN_LANES; ++l)
                g->to_light[c][l] = light->place[c];
        return;
    }
    place = eye_place(v);
    for (int c = 0; c < 3; ++c)
        for (int l = 0; l < GN_LANES; ++l)
            g->to_light[c][l] = light->place[c] - place[c][l];
    for (int l = 0; l < GN_LANES; ++l)
        g->square[l] = dot_3(g->to_light[0][l], g->to_light[1][l], g->to_light[2][l],
                             g->to_light[0][l], g->to_light[1][l], g->to_light[2][l]);
    normalize(g->to_light);
}

static void set_reach(const light_derived *light, light_geometry *g)
{
    const float *const spot = light->spot_direction;
    const float *const a = light->attenuation;

    g->is_weakened = light->is_spot || light->is_attenuated;
    if (light->is_spot) {
        for (int l = 0; l < GN_LANES; ++l) {
            const float cosine = dot_3(-g->to_light[0][l], -g->to_light[1][l], -g->to_light[2][l],
                                       spot[0], spot[1], spot[2]);
            const float power = short_power(cosine, light->spot_exponent);

            g->reach[l] = light->spot_cosine < cosine ? power : 0.0f;
        }
    }
    if (light->is_attenuated) {
        for (int l = 0; l < GN_LANES; ++l) {
            const float distance = sqrtf(g->square[l]);
            const float weakness = (g->square[l] * a[2] + a[0]) + distance * a[1];

            g->reach[l] = light->is_spot ? 1.0f / weakness * g->reach[l] : 1.0f / weakness;
        }
    }
}

/* The half vector between the directions to the light and to the viewer, times the normal. */
static void set_shining(const lighting_derived *lighting, const light_derived *light,
                        lit_vertices *v, light_geometry *g)
{
    const float(*const n)[GN_LANES] = used_normal(v);
    float half[3][GN_LANES];

    memcpy(half, g->to_light, sizeof half);
    if (lighting->has_local_viewer) {
        const float(*const direction)[GN_LANES] = eye_direction(v);

        for (int c = 0; c < 3; ++c)
            for (int l = 0; l < GN_LANES; ++l)
                half[c][l] -= direction[c][l];
        normalize(half);
    } else if (light->is_directional) {
        for (int c = 0; c < 3; ++c)
            for (int l = 0; l < GN_LANES; ++l)
                half[c][l] = light->half_vector[c];
    } else {
        for (int l = 0; l < GN_LANES; ++l)
            half[2][l] += 1.0f;
        normalize(half);
    }
    for (int l = 0; l < GN_LANES; ++l)
        g->shining[l] = dot_3(n[0][l], n[1][l], n[2][l], half[0][l], half[1][l], half[2][l]);
}

/* What reaches the viewer of diffuse and specular light. Without shininess, specular light is all
 * or nothing, but under an attenuation the reference takes the cosine to its own power. */
static void set_parts(const lighting_derived *lighting, const light_geometry *g, float sign,
                      float shininess, float diffuse[GN_LANES], float specular[GN_LANES])
{
    const float low = shininess < 128.0f ? shininess : 128.0f;
    const float exponent = low > -128.0f ? low : -128.0f;

    if (!lighting->is_dull) {
        for (int l = 0; l < GN_LANES; ++l) {
            const float shining = sign * g->shining[l];

            specular[l] = short_power(shining > 0.0f ? shining : 0.0f, exponent);
        }
    } else if (g->is_weakened) {
        for (int l = 0; l < GN_LANES; ++l) {
            const float facing = sign * g->facing[l];

            specular[l] = short_power(facing > 0.0f ? facing : 0.0f, facing);
        }
    } else {
        for (int l = 0; l < GN_LANES; ++l)
            specular[l] = 1.0f;
    }
    for (int l = 0; l < GN_LANES; ++l) {
        const float facing = sign * g->facing[l];

        diffuse[l] = facing > 0.0f ? facing : 0.0f;
        specular[l] = facing > 0.0f ? specular[l] : 0.0f;
    }
}

/* A colour of the material: its own, or that of the vertices. */
static const float *material_channel(const side_derived *side, enum material_color name,
                                     const float (*vertex_color)[GN_LANES], int channel,
                                     float memory[GN_LANES])
{
    if (side->is_vertex_color[name])
        return vertex_color[channel];
    for (int l = 0; l < GN_LANES; ++l)
        memory[l] = side->material[name][channel];
    return memory;
}

/* Adds a light's colours on one side. */
static void add_light(const lighting_derived *lighting, const light_derived *light,
                      const light_geometry *g, int side_index,
                      const float (*vertex_color)[GN_LANES], lit_colors *colors)
{
    const side_derived *const side = &lighting->side[side_index];
    float part[3][GN_LANES];

    for (int l = 0; l < GN_LANES; ++l)
        part[0][l] = 1.0f;
    set_parts(lighting, g, side_index ? -1.0f : 1.0f, side->shininess, part[1], part[2]);
    for (int i = 0; i < 3 && g->is_weakened; ++i)
        for (int l = 0; l < GN_LANES; ++l)
            part[i][l] *= g->reach[l];
    for (int c = 0; c < 3; ++c) {
        for (int i = 0; i < 3; ++i) {
            float *const to = i == 2 && lighting->has_separate_specular
                                  ? colors->secondary[side_index][c]
                                  : colors->primary[side_index][c];

            if (side->is_vertex_color[i]) {
                for (int l = 0; l < GN_LANES; ++l)
                    to[l] = part[i][l] * (light->color[i][c] * vertex_color[c][l]) + to[l];
            } else {
                const float color = light->color[i][c] * side->material[i][c];

                for (int l = 0; l < GN_LANES; ++l)
                    to[l] = part[i][l] * color + to[l];
            }
        }
    }
}

/* The colour without lights. */
static void begin_color(const lighting_derived *lighting, int side_index,
                        const float (*vertex_color)[GN_LANES], lit_colors *colors)
{
    const side_derived *const side = &lighting->side[side_index];
    float memory[2][GN_LANES];

    for (int c = 0; c < 3; ++c) {
        const float *const ambient =
            material_channel(side, MATERIAL_AMBIENT, vertex_color, c, memory[0]);
        const float *const emission =
            material_channel(side, MATERIAL_EMISSION, vertex_color, c, memory[1]);

        for (int l = 0; l < GN_LANES; ++l)
            colors->primary[side_index][c][l] = lighting->ambient[c] * ambient[l] + emission[l];
    }
    memcpy(colors->primary[side_index][3],
           material_channel(side, MATERIAL_DIFFUSE, vertex_color, 3, memory[0]), sizeof memory[0]);
    memset(colors->secondary[side_index], 0, sizeof colors->secondary[side_index]);
}

LANE_FUNCTION
void light_vertices(const lighting_derived *lighting, lit_vertices *v,
                    const float (*vertex_color)[GN_LANES], lit_colors *colors)
{
    const int sides = lighting->two_side ? 2 : 1;

    for (int s = 0; s < sides; ++s)
        begin_color(lighting, s, vertex_color, colors);
    for (unsigned i = 0; i < lighting->lights; ++i) {
        const light_derived *const light = &lighting->light[i];
        const float(*const n)[GN_LANES] = used_normal(v);
        light_geometry g;

        set_direction(light, v, &g);
        set_reach(light, &g);
        for (int l = 0; l < GN_LANES; ++l)
            g.facing[l] = dot_3(n[0][l], n[1][l], n[2][l], g.to_light[0][l], g.to_light[1][l],
                                g.to_light[2][l]);
        if (!lighting->is_dull)
            set_shining(lighting, light, v, &g);
        for (int s = 0; s < sides; ++s)
            add_light(lighting, light, &g, s, vertex_color, colors);
    }
}
