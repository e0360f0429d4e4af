/* Pairwise coverage: each state is a row of a table that says which of its values a draw has.
 * Every value of every state must occur together with every value of every other in some draw,
 * but for the pairs listed as impossible, each with its reason. To add a state, add its row. */
#include "pairs.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare.h"
#include "generate.h"

/* Where a draw is, and what compares it. */
typedef struct place {
    const scene *scene;
    const scene_draw *draw;
    const gn_pipeline *state;
    size_t position; /* in the sequence */
    uint64_t number; /* the scene's, which chooses threads and workspaces (compare.c) */
} place;

/* The value a draw has, from 0 to `values` - 1; -1 where the state means nothing to it. */
typedef struct state_row {
    const char *name;
    int values;
    int (*value)(const place *p);
} state_row;

#define VALUE(name, expression)                                                                    \
    static int name(const place *p)                                                                \
    {                                                                                              \
        return (int)(expression);                                                                  \
    }

/* The value where the condition holds. */
#define VALUE_WHERE(name, condition, expression) VALUE(name, (condition) ? (int)(expression) : -1)

static bool is_fill(const place *p)
{
    return p->state->raster.topology <= GN_TRIANGLE_FAN;
}

static bool is_line(const place *p)
{
    return p->state->raster.topology >= GN_LINES;
}

static bool is_indexed(const place *p)
{
    return p->draw->mesh.index_format != GN_INDEX_NONE;
}

static bool is_textured(const place *p)
{
    return scene_shader_is_textured(p->draw->shader);
}

static bool has_instances(const place *p)
{
    return p->draw->mesh.instance_count > 1;
}

static bool is_shader(const place *p, scene_shader shader)
{
    return p->draw->shader == shader;
}

/* How an interpolation of several numbers is told: all alike, or mixed. */
static int interpolations(const place *p)
{
    const gn_interpolation *i = p->state->program.interpolation;
    const bool alike = i[0] == i[1] && i[0] == i[2] && i[0] == i[3];
    return !is_shader(p, SCENE_VERTEX_COLOR) ? -1 : alike ? (int)i[0] : 3;
}

/* A comparison's number among eight. */
static int comparison_number(gn_compare c, gn_compare default_comparison)
{
    return (int)((c == GN_COMPARE_DEFAULT ? default_comparison : c) - GN_NEVER);
}

static int depth_range(const place *p)
{
    const gn_depth_range *d = &p->state->depth.range;
    return !d->set ? 0 : d->z_near < d->z_far ? 1 : d->z_near > d->z_far ? 2 : 3;
}

static int polygon_offset(const place *p)
{
    const gn_polygon_offset *o = &p->state->raster.polygon_offset;
    return !o->set ? 0 : o->clamp == 0.0f ? 1 : o->clamp > 0.0f ? 2 : 3;
}

static int point_size(const place *p)
{
    const float size = p->state->raster.point_size;
    if (p->state->raster.topology != GN_POINTS)
        return -1;
    if (p->state->program.vertex_writes_point_size && is_shader(p, SCENE_VERTEX_COLOR))
        return 0;
    return size <= 1.0f ? 1 : size <= 4.0f ? 2 : 3;
}

static int clip_distances(const place *p)
{
    const uint32_t count = p->state->program.clip_distance_count;
    return count < 2 ? (int)count : count < 4 ? 2 : 3;
}

/* Surfaces after the first. */
static int attachments(const place *p)
{
    int count = 0;
    for (int a = 1; a < GN_MAX_COLORS; a++)
        count += scene_color_format(p->scene, a) != GN_FORMAT_NONE;
    return count < 4 ? (count > 0) : 2;
}

/* Whether one of them that the shader writes has a blending of its own, or a mask. */
static int more_blends(const place *p)
{
    bool blends = false;
    for (uint32_t a = 1; a < p->state->program.color_count; a++)
        blends |= p->state->color.blend[a].enabled &&
                  scene_color_format(p->scene, (int)a) != GN_FORMAT_NONE;
    return is_shader(p, SCENE_OUTPUTS) && attachments(p) ? blends : -1;
}

static int more_masks(const place *p)
{
    bool masks = false;
    for (uint32_t a = 1; a < p->state->program.color_count; a++)
        masks |= p->state->color.write_disabled[a] &&
                 scene_color_format(p->scene, (int)a) != GN_FORMAT_NONE;
    return is_shader(p, SCENE_OUTPUTS) && attachments(p) ? masks : -1;
}

static int line_width(const place *p)
{
    const float width = p->state->raster.line_width;
    return !is_line(p) ? -1 : width < 1.5f ? 0 : width < 4.5f ? 1 : 2;
}

/* Floats, fractions, sRGB, depths. */
static int kind_of_texels(const gn_texture *t)
{
    const bool floats = scene_is_color_format(t->format) && scene_is_float_format(t->format);
    return floats                             ? 0
           : t->format == GN_FORMAT_SRGB8_A8  ? 1
           : scene_is_color_format(t->format) ? 2
                                              : 3;
}

static int clear_before(const place *p)
{
    return p->draw->clear.color + 2 * p->draw->clear.depth;
}

static int position(const place *p)
{
    return p->position == 0 ? 0 : p->position < 6 ? 1 : 2;
}

/* Formats in the order of surface.h, colours apart from depths. */
static int color_format(const place *p)
{
    int value = 0;
    for (int f = 0; f < (int)p->scene->color_format; f++)
        value += scene_is_color_format((gn_format)f);
    return value;
}

static int depth_format(const place *p)
{
    int value = 0;
    for (int f = 0; f < (int)p->scene->depth_format; f++)
        value += !scene_is_color_format((gn_format)f);
    return value;
}

/* The default is the value it stands for. */
static int factor(gn_blend_factor f, gn_blend_factor otherwise)
{
    return (int)(f == GN_FACTOR_DEFAULT ? otherwise : f) - (int)GN_FACTOR_ZERO;
}

static int equation(gn_blend_equation e, gn_blend_equation otherwise)
{
    return (int)(e == GN_EQUATION_DEFAULT ? otherwise : e) - (int)GN_EQUATION_ADD;
}

#define BLEND (p->state->color.blend[0])
#define COLOR_EQUATION ((gn_blend_equation)(equation(BLEND.equation, GN_EQUATION_ADD) + 1))
#define COLOR_SOURCE ((gn_blend_factor)(factor(BLEND.source, GN_FACTOR_ONE) + 1))
#define COLOR_DESTINATION ((gn_blend_factor)(factor(BLEND.destination, GN_FACTOR_ZERO) + 1))

VALUE(topology, p->state->raster.topology)
VALUE(provoking_vertex, p->state->raster.provoking_vertex)
VALUE(index_format, p->draw->mesh.index_format)
VALUE_WHERE(restart, is_indexed(p), p->draw->mesh.restart)
VALUE_WHERE(base_vertex, is_indexed(p), p->draw->mesh.base_vertex != 0)
VALUE(first_element, p->draw->mesh.first > 0)
VALUE(instances, has_instances(p))
VALUE_WHERE(divisor, has_instances(p), p->draw->mesh.attribute[GN_ATTRIBUTE_COLOR].divisor > 0)
VALUE(shader, p->draw->shader)
VALUE(alpha_given, p->draw->mesh.attribute[GN_ATTRIBUTE_COLOR].components == 4)
VALUE_WHERE(cull, is_fill(p), p->state->raster.cull)
VALUE_WHERE(front_face, is_fill(p), p->state->raster.front_face)
VALUE(viewport, p->state->raster.viewport.set)
VALUE(scissor, p->state->raster.scissor.set)
VALUE(clip_depth, p->state->depth.clip_depth)
VALUE(depth_clamp, p->state->depth.clamp)
VALUE(depth_test,
      p->state->depth.test ? 1 + comparison_number(p->state->depth.function, GN_LESS) : 0)
VALUE_WHERE(depth_write, p->state->depth.test, !p->state->depth.write_disabled)
VALUE(stencil_front, p->state->stencil.test
                         ? 1 + comparison_number(p->state->stencil.front.function, GN_ALWAYS)
                         : 0)
VALUE_WHERE(stencil_back, p->state->stencil.test,
            comparison_number(p->state->stencil.back.function, GN_ALWAYS))
VALUE_WHERE(front_fail, p->state->stencil.test, p->state->stencil.front.fail)
VALUE_WHERE(front_depth_fail, p->state->stencil.test, p->state->stencil.front.depth_fail)
VALUE_WHERE(front_pass, p->state->stencil.test, p->state->stencil.front.pass)
VALUE_WHERE(back_fail, p->state->stencil.test, p->state->stencil.back.fail)
VALUE_WHERE(back_depth_fail, p->state->stencil.test, p->state->stencil.back.depth_fail)
VALUE_WHERE(back_pass, p->state->stencil.test, p->state->stencil.back.pass)
VALUE_WHERE(stencil_mask, p->state->stencil.test, p->state->stencil.front.compare_disabled != 0)
VALUE_WHERE(stencil_write_mask, p->state->stencil.test, p->state->stencil.front.write_disabled != 0)
VALUE(color_mask, p->state->color.write_disabled[0])
VALUE(blend, BLEND.enabled ? 1 + equation(BLEND.equation, GN_EQUATION_ADD) : 0)
VALUE_WHERE(blend_source, BLEND.enabled, factor(BLEND.source, GN_FACTOR_ONE))
VALUE_WHERE(blend_destination, BLEND.enabled, factor(BLEND.destination, GN_FACTOR_ZERO))
VALUE_WHERE(alpha_equation, BLEND.enabled, equation(BLEND.alpha_equation, COLOR_EQUATION))
VALUE_WHERE(alpha_source, BLEND.enabled, factor(BLEND.alpha_source, COLOR_SOURCE))
VALUE_WHERE(alpha_destination, BLEND.enabled, factor(BLEND.alpha_destination, COLOR_DESTINATION))
VALUE(logic, p->state->color.logic ? 1 + (int)p->state->color.logic_operation : 0)
VALUE_WHERE(reads_position, is_shader(p, SCENE_INPUTS), p->state->program.fragment_reads_position)
VALUE_WHERE(reads_primitive, is_shader(p, SCENE_INPUTS), p->state->program.fragment_reads_primitive)
VALUE_WHERE(discards, is_shader(p, SCENE_INPUTS), p->state->program.fragment_discards)
VALUE_WHERE(writes_depth, is_shader(p, SCENE_INPUTS), p->state->program.fragment_writes_depth)
VALUE_WHERE(reads_point_coordinate, is_shader(p, SCENE_INPUTS),
            p->state->program.fragment_reads_point_coordinate)
VALUE_WHERE(point_origin, reads_point_coordinate(p) == 1, p->state->raster.point_origin)
VALUE_WHERE(reads_sample_mask, is_shader(p, SCENE_INPUTS),
            p->state->program.fragment_reads_sample_mask)
VALUE_WHERE(writes_sample_mask, is_shader(p, SCENE_INPUTS),
            p->state->program.fragment_writes_sample_mask)
VALUE(samples, scene_is_sampled(p->scene))
VALUE_WHERE(sample_mask, scene_is_sampled(p->scene), p->state->samples.write_disabled != 0)
VALUE_WHERE(alpha_to_coverage, scene_is_sampled(p->scene), p->state->samples.alpha_to_coverage)
VALUE_WHERE(alpha_to_one, scene_is_sampled(p->scene), p->state->samples.alpha_to_one)
VALUE_WHERE(polygon_mode_front, is_fill(p), p->state->raster.polygon_mode_front)
VALUE_WHERE(polygon_mode_back, is_fill(p), p->state->raster.polygon_mode_back)
VALUE_WHERE(outputs, is_shader(p, SCENE_OUTPUTS), p->state->program.color_count > 4)
VALUE(counted, p->draw->counted)
VALUE_WHERE(wrap_s, is_textured(p), p->draw->uniforms.sampler.wrap_s)
VALUE_WHERE(wrap_t, is_textured(p), p->draw->uniforms.sampler.wrap_t)
VALUE_WHERE(magnify, is_textured(p), p->draw->uniforms.sampler.magnify)
VALUE_WHERE(minify, is_textured(p), p->draw->uniforms.sampler.minify)
VALUE_WHERE(wrap_r, is_shader(p, SCENE_SAMPLED), p->draw->uniforms.sampler.wrap_r)
VALUE_WHERE(lod_bias, is_shader(p, SCENE_SAMPLED), p->draw->uniforms.sampler.lod_bias != 0.0f)
VALUE_WHERE(lod_clamped, is_shader(p, SCENE_SAMPLED), p->draw->uniforms.sampler.lod_clamped)
VALUE_WHERE(texture_target, is_shader(p, SCENE_SAMPLED), p->draw->uniforms.texture.target)
VALUE_WHERE(texels, is_shader(p, SCENE_SAMPLED), kind_of_texels(&p->draw->uniforms.texture))
VALUE(threads, p->number % COMPARE_POOLS)
VALUE(workspace, p->number % 3)

/* The states, by what the list of the impossible calls them. */
#define STATES(ROW)                                                                                \
    ROW(topology, 7)                                                                               \
    ROW(provoking_vertex, 2)                                                                       \
    ROW(index_format, 4)                                                                           \
    ROW(restart, 3)                                                                                \
    ROW(base_vertex, 2)                                                                            \
    ROW(first_element, 2)                                                                          \
    ROW(instances, 2)                                                                              \
    ROW(divisor, 2)                                                                                \
    ROW(shader, SCENE_SHADER_COUNT)                                                                \
    ROW(alpha_given, 2)                                                                            \
    ROW(interpolations, 4)                                                                         \
    ROW(cull, 4)                                                                                   \
    ROW(front_face, 2)                                                                             \
    ROW(viewport, 2)                                                                               \
    ROW(scissor, 2)                                                                                \
    ROW(depth_range, 4)                                                                            \
    ROW(clip_depth, 2)                                                                             \
    ROW(depth_clamp, 2)                                                                            \
    ROW(polygon_offset, 4)                                                                         \
    ROW(depth_test, 9)                                                                             \
    ROW(depth_write, 2)                                                                            \
    ROW(stencil_front, 9)                                                                          \
    ROW(stencil_back, 8)                                                                           \
    ROW(front_fail, 8)                                                                             \
    ROW(front_depth_fail, 8)                                                                       \
    ROW(front_pass, 8)                                                                             \
    ROW(back_fail, 8)                                                                              \
    ROW(back_depth_fail, 8)                                                                        \
    ROW(back_pass, 8)                                                                              \
    ROW(stencil_mask, 2)                                                                           \
    ROW(stencil_write_mask, 2)                                                                     \
    ROW(color_mask, 16)                                                                            \
    ROW(blend, 6)                                                                                  \
    ROW(blend_source, 15)                                                                          \
    ROW(blend_destination, 15)                                                                     \
    ROW(alpha_equation, 5)                                                                         \
    ROW(alpha_source, 15)                                                                          \
    ROW(alpha_destination, 15)                                                                     \
    ROW(logic, 17)                                                                                 \
    ROW(color_format, SCENE_COLOR_FORMATS)                                                         \
    ROW(depth_format, 1 + SCENE_DEPTH_FORMATS)                                                     \
    ROW(point_size, 4)                                                                             \
    ROW(line_width, 3)                                                                             \
    ROW(reads_position, 2)                                                                         \
    ROW(reads_primitive, 2)                                                                        \
    ROW(discards, 2)                                                                               \
    ROW(writes_depth, 2)                                                                           \
    ROW(reads_point_coordinate, 2)                                                                 \
    ROW(point_origin, 2)                                                                           \
    ROW(reads_sample_mask, 2)                                                                      \
    ROW(writes_sample_mask, 2)                                                                     \
    ROW(samples, 2)                                                                                \
    ROW(sample_mask, 2)                                                                            \
    ROW(alpha_to_coverage, 2)                                                                      \
    ROW(alpha_to_one, 2)                                                                           \
    ROW(polygon_mode_front, 3)                                                                     \
    ROW(polygon_mode_back, 3)                                                                      \
    ROW(clip_distances, 4)                                                                         \
    ROW(attachments, 3)                                                                            \
    ROW(outputs, 2)                                                                                \
    ROW(more_blends, 2)                                                                            \
    ROW(more_masks, 2)                                                                             \
    ROW(counted, 2)                                                                                \
    ROW(wrap_s, 5)                                                                                 \
    ROW(wrap_t, 5)                                                                                 \
    ROW(magnify, 2)                                                                                \
    ROW(minify, 6)                                                                                 \
    ROW(wrap_r, 5)                                                                                 \
    ROW(lod_bias, 2)                                                                               \
    ROW(lod_clamped, 2)                                                                            \
    ROW(texture_target, 5)                                                                         \
    ROW(texels, 4)                                                                                 \
    ROW(clear_before, 4)                                                                           \
    ROW(position, 3)                                                                               \
    ROW(threads, COMPARE_POOLS)                                                                    \
    ROW(workspace, 3)

#define INDEX_OF(name, values) INDEX_##name,
#define ROW_OF(name, values) {#name, values, name},

enum { STATES(INDEX_OF) STATE_COUNT };

static const state_row rows[] = {STATES(ROW_OF)};

/* Values of two states that no draw has together: bit v of the masks is value v. */
typedef struct exclusion {
    int a, b; /* states, in the order of the rows */
    uint32_t values_a, values_b;
    const char *reason;
} exclusion;

#define ANY UINT32_MAX
#define BIT(v) (UINT32_C(1) << (v))
#define NOT(v) (~BIT(v))

/* That the values of a state mean something only where another has some of its values. */
#define ONLY_WHERE(a, b, values_b, reason)                                                         \
    {                                                                                              \
        INDEX_##a, INDEX_##b, ANY, ~(uint32_t)(values_b), reason                                   \
    }

#define FILLS (BIT(GN_TRIANGLES) | BIT(GN_TRIANGLE_STRIP) | BIT(GN_TRIANGLE_FAN))
#define ALL_LINES (BIT(GN_LINES) | BIT(GN_LINE_STRIP) | BIT(GN_LINE_LOOP))
/* In the order of the rows' values: SRGB8_A8; none and S8. */
#define SRGB BIT(13)
#define WITHOUT_DEPTH (BIT(0) | BIT(6))
#define TEXTURED (BIT(SCENE_TEXTURED_GOURAUD) | BIT(SCENE_PHONG) | BIT(SCENE_SAMPLED))

static const exclusion exclusions[] = {
    ONLY_WHERE(restart, index_format, NOT(GN_INDEX_NONE), "there is nothing to restart at"),
    ONLY_WHERE(base_vertex, index_format, NOT(GN_INDEX_NONE), "it is added to indices"),
    ONLY_WHERE(divisor, instances, BIT(1), "it divides instances"),
    ONLY_WHERE(cull, topology, FILLS, "points and lines have no faces"),
    ONLY_WHERE(front_face, topology, FILLS, "points and lines have no faces"),
    ONLY_WHERE(point_size, topology, BIT(GN_POINTS), "of points"),
    ONLY_WHERE(line_width, topology, ALL_LINES, "of lines"),
    ONLY_WHERE(interpolations, shader, BIT(SCENE_VERTEX_COLOR), "others bring their own"),
    ONLY_WHERE(reads_position, shader, BIT(SCENE_INPUTS), "others do not"),
    ONLY_WHERE(reads_primitive, shader, BIT(SCENE_INPUTS), "others do not"),
    ONLY_WHERE(discards, shader, BIT(SCENE_INPUTS), "others do not"),
    ONLY_WHERE(writes_depth, shader, BIT(SCENE_INPUTS), "others do not"),
    ONLY_WHERE(reads_point_coordinate, shader, BIT(SCENE_INPUTS), "others do not"),
    ONLY_WHERE(point_origin, shader, BIT(SCENE_INPUTS), "others do not read the coordinates"),
    ONLY_WHERE(point_origin, reads_point_coordinate, BIT(1), "nobody reads them"),
    ONLY_WHERE(reads_sample_mask, shader, BIT(SCENE_INPUTS), "others do not"),
    ONLY_WHERE(writes_sample_mask, shader, BIT(SCENE_INPUTS), "others do not"),
    ONLY_WHERE(sample_mask, samples, BIT(1), "there is one sample"),
    ONLY_WHERE(alpha_to_coverage, samples, BIT(1), "there is one sample"),
    ONLY_WHERE(alpha_to_one, samples, BIT(1), "there is one sample"),
    ONLY_WHERE(polygon_mode_front, topology, FILLS, "points and lines have no faces"),
    ONLY_WHERE(polygon_mode_back, topology, FILLS, "points and lines have no faces"),
    ONLY_WHERE(outputs, shader, BIT(SCENE_OUTPUTS), "others write one colour"),
    ONLY_WHERE(more_blends, shader, BIT(SCENE_OUTPUTS), "others write one colour"),
    ONLY_WHERE(more_masks, shader, BIT(SCENE_OUTPUTS), "others write one colour"),
    ONLY_WHERE(more_blends, attachments, NOT(0), "there is one attachment"),
    ONLY_WHERE(more_masks, attachments, NOT(0), "there is one attachment"),
    ONLY_WHERE(wrap_s, shader, TEXTURED, "others have no texture"),
    ONLY_WHERE(wrap_t, shader, TEXTURED, "others have no texture"),
    ONLY_WHERE(magnify, shader, TEXTURED, "others have no texture"),
    ONLY_WHERE(minify, shader, TEXTURED, "others have no texture"),
    ONLY_WHERE(wrap_r, shader, BIT(SCENE_SAMPLED), "others have 2D textures"),
    ONLY_WHERE(lod_bias, shader, BIT(SCENE_SAMPLED), "others have one level"),
    ONLY_WHERE(lod_clamped, shader, BIT(SCENE_SAMPLED), "others have one level"),
    ONLY_WHERE(texture_target, shader, BIT(SCENE_SAMPLED), "others have 2D textures"),
    ONLY_WHERE(texels, shader, BIT(SCENE_SAMPLED), "others have RGBA8"),
    {INDEX_texels, INDEX_texture_target, BIT(3), BIT(GN_TEXTURE_3D),
     "OpenGL has no 3D textures of depths"},
    ONLY_WHERE(depth_write, depth_test, NOT(0), "nothing is written without the test"),
    ONLY_WHERE(stencil_back, stencil_front, NOT(0), "there is no test"),
    ONLY_WHERE(front_fail, stencil_front, NOT(0), "there is no test"),
    ONLY_WHERE(front_depth_fail, stencil_front, NOT(0), "there is no test"),
    ONLY_WHERE(front_pass, stencil_front, NOT(0), "there is no test"),
    ONLY_WHERE(back_fail, stencil_front, NOT(0), "there is no test"),
    ONLY_WHERE(back_depth_fail, stencil_front, NOT(0), "there is no test"),
    ONLY_WHERE(back_pass, stencil_front, NOT(0), "there is no test"),
    ONLY_WHERE(stencil_mask, stencil_front, NOT(0), "there is no test"),
    ONLY_WHERE(stencil_write_mask, stencil_front, NOT(0), "there is no test"),
    ONLY_WHERE(blend_source, blend, NOT(0), "nothing is blended"),
    ONLY_WHERE(blend_destination, blend, NOT(0), "nothing is blended"),
    ONLY_WHERE(alpha_equation, blend, NOT(0), "nothing is blended"),
    ONLY_WHERE(alpha_source, blend, NOT(0), "nothing is blended"),
    ONLY_WHERE(alpha_destination, blend, NOT(0), "nothing is blended"),

    {INDEX_blend, INDEX_color_format, NOT(0), SRGB,
     "a second layer would multiply the step that is allowed (class blend has one)"},
    {INDEX_polygon_offset, INDEX_depth_format, NOT(0), WITHOUT_DEPTH,
     "OpenGL's step is that of a depth buffer (reference/RULES.md)"},
    {INDEX_point_size, INDEX_viewport, BIT(0), BIT(1),
     "the reference cuts such points off at the viewport (reference/RULES.md)"},
    {INDEX_point_size, INDEX_shader, BIT(0), NOT(SCENE_VERTEX_COLOR),
     "the shader of vertex colours alone has sizes (reference/scene/scene.h)"},
    {INDEX_reads_point_coordinate, INDEX_topology, BIT(1), ALL_LINES,
     "in lines they are zeros of a sign that is left out (reference/RULES.md)"},
    {INDEX_point_origin, INDEX_topology, ANY, ALL_LINES, "their points have no coordinates"},
    {INDEX_reads_point_coordinate, INDEX_polygon_mode_front, BIT(1), NOT(GN_POLYGON_POINT),
     "in lines and filled triangles they are zeros of a sign that is left out"},
    {INDEX_reads_point_coordinate, INDEX_polygon_mode_back, BIT(1), NOT(GN_POLYGON_POINT),
     "in lines and filled triangles they are zeros of a sign that is left out"},
    {INDEX_point_origin, INDEX_polygon_mode_front, ANY, NOT(GN_POLYGON_POINT),
     "only where all are points the coordinates are read"},
    {INDEX_point_origin, INDEX_polygon_mode_back, ANY, NOT(GN_POLYGON_POINT),
     "only where all are points the coordinates are read"},
    {INDEX_alpha_to_one, INDEX_writes_depth, BIT(1), BIT(1),
     "the reference keeps such alphas (reference/RULES.md)"},
    {INDEX_alpha_to_one, INDEX_writes_sample_mask, BIT(1), BIT(1),
     "the reference keeps such alphas (reference/RULES.md)"},
    {INDEX_polygon_mode_front, INDEX_samples, BIT(GN_POLYGON_LINE), BIT(1),
     "the reference loses pixels of sampled lines (reference/RULES.md)"},
    {INDEX_polygon_mode_back, INDEX_samples, BIT(GN_POLYGON_LINE), BIT(1),
     "the reference loses pixels of sampled lines (reference/RULES.md)"},
    {INDEX_depth_format, INDEX_shader, BIT(0), BIT(SCENE_DEPTH_ONLY), "it needs a depth buffer"},
    {INDEX_alpha_given, INDEX_shader, BIT(0), BIT(SCENE_INPUTS), "alpha decides what it discards"},
    {INDEX_clear_before, INDEX_position, NOT(0), BIT(0), "the scene's own clears come first"},
};

static bool is_listed(int a, int value_a, int b, int value_b)
{
    for (size_t i = 0; i < sizeof exclusions / sizeof *exclusions; i++) {
        const exclusion *m = &exclusions[i];
        if ((m->a == a && m->b == b && m->values_a >> value_a & 1 && m->values_b >> value_b & 1) ||
            (m->a == b && m->b == a && m->values_a >> value_b & 1 && m->values_b >> value_a & 1))
            return true;
    }
    return false;
}

/* Values are numbered through all states. */
typedef struct counts {
    int first[STATE_COUNT + 1];
    uint64_t without[STATE_COUNT]; /* draws to which the state means nothing */
    uint32_t *pairs;               /* [value][value] */
} counts;

/* Listed, or following from the list: no value of a third state, of which every draw has one, is
 * possible with both. */
static bool is_impossible(const counts *c, int a, int value_a, int b, int value_b)
{
    bool impossible = is_listed(a, value_a, b, value_b);
    for (int s = 0; s < STATE_COUNT && !impossible; s++) {
        impossible = c->without[s] == 0;
        for (int v = 0; v < rows[s].values && impossible; v++)
            impossible = is_listed(a, value_a, s, v) || is_listed(b, value_b, s, v);
    }
    return impossible;
}

static void count_draw(counts *c, const place *p)
{
    int value[STATE_COUNT];
    for (int s = 0; s < STATE_COUNT; s++) {
        value[s] = rows[s].value(p);
        c->without[s] += value[s] < 0;
        if (value[s] >= rows[s].values) {
            fprintf(stderr, "pairs: %s has no value %d\n", rows[s].name, value[s]);
            exit(EXIT_FAILURE);
        }
    }
    for (int a = 0; a < STATE_COUNT; a++)
        for (int b = 0; b < a; b++)
            if (value[a] >= 0 && value[b] >= 0)
                ++c->pairs[(c->first[a] + value[a]) * c->first[STATE_COUNT] + c->first[b] +
                           value[b]];
}

static void count_class(counts *c, scene_class class, uint64_t seed, uint64_t scenes)
{
    for (uint64_t number = 0; number < scenes; number++) {
        scene *s = generate_scene(seed, class, number);
        for (size_t i = 0; i < s->draw_count; i++) {
            const place p = {s, &s->draws[i], &s->draws[i].state, i, number};
            count_draw(c, &p);
        }
        scene_free(s);
    }
}

/* The pairs of one state with those before it; how many are not as said. */
static uint64_t check_state(const counts *c, int a, uint64_t *seen, uint64_t *left_out)
{
    uint64_t wrong = 0;
    for (int b = 0; b < a; b++)
        for (int i = 0; i < rows[a].values; i++)
            for (int j = 0; j < rows[b].values; j++) {
                const bool occurs =
                    c->pairs[(c->first[a] + i) * c->first[STATE_COUNT] + c->first[b] + j] > 0;
                const bool possible = !is_impossible(c, a, i, b, j);
                *seen += occurs;
                *left_out += !possible;
                if (occurs != possible) {
                    wrong++;
                    printf("pairs: %s %d and %s %d %s\n", rows[a].name, i, rows[b].name, j,
                           occurs ? "occur, but are said to be impossible" : "never occur");
                }
            }
    return wrong;
}

bool pairs_check(uint64_t seed, uint64_t scenes)
{
    static const scene_class classes[] = {CLASS_MIXED, CLASS_SEQUENCES};
    counts c = {.pairs = NULL};
    uint64_t seen = 0, left_out = 0, failed = 0;
    for (int s = 0, first = 0; s <= STATE_COUNT; s++) {
        c.first[s] = first;
        first += s < STATE_COUNT ? rows[s].values : 0;
    }
    const size_t values = (size_t)c.first[STATE_COUNT];
    c.pairs = calloc(values * values, sizeof *c.pairs);
    if (!c.pairs)
        return false;
    for (size_t i = 0; i < sizeof classes / sizeof *classes; i++)
        count_class(&c, classes[i], seed, scenes);
    for (int s = 0; s < STATE_COUNT; s++)
        failed += check_state(&c, s, &seen, &left_out) > 0;
    printf("pairs: %" PRIu64 " of %zu values of %d states occur in %" PRIu64
           " scenes each of mixed and sequences, %" PRIu64 " are impossible\n",
           seen, values, STATE_COUNT, scenes, left_out);
    printf("%" PRIu64 " passed, %" PRIu64 " failed\n", STATE_COUNT - failed, failed);
    free(c.pairs);
    return failed == 0;
}
