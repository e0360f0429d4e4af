/* Pairwise coverage. Each state is a row that says which of its values a draw has. Every value of
 * every state must occur together with every value of every other state in some draw, except for
 * the pairs listed as impossible, each with its reason. Every switch and enumeration of gn_pipeline
 * that is not an array is a state by itself; other states have rows here. */
#include "pairs.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare.h"
#include "generate.h"
#include "scene_members.h"

/* A draw, where it is, and which scene's number chooses how it is compared. */
typedef struct place {
    const scene *scene;
    const scene_draw *draw;
    const gn_pipeline *state;
    size_t position; /* of the draw in its scene */
    uint64_t number; /* of the scene; it chooses threads and workspaces (compare.c) */
} place;

/* A state. `value` returns the value that a draw has, from 0 to `values` - 1. */
typedef struct state_row {
    const char *name; /* the member's name, if the state is a member */
    int values;
    int (*value)(const place *p); /* null: the member's own value */
    const scene_member *member;
} state_row;

#define VALUE(name, expression)                                                                    \
    static int name(const place *p)                                                                \
    {                                                                                              \
        return (int)(expression);                                                                  \
    }

/* Returns one number for the interpolations of several varyings: the one that all have, or 3 if
 * they are mixed. */
static int interpolations(const place *p)
{
    const gn_interpolation *i = p->state->program.interpolation;
    const bool alike = i[0] == i[1] && i[0] == i[2] && i[0] == i[3];
    return alike ? (int)i[0] : 3;
}

/* Does the same for locations. */
static int locations(const place *p)
{
    const gn_interpolation_point *l = p->state->program.interpolated_at;
    const bool alike = l[0] == l[1] && l[0] == l[2] && l[0] == l[3];
    return alike ? (int)l[0] : 3;
}

/* Returns a comparison's number, 0 to 7. */
static int comparison_number(gn_compare c, gn_compare default_comparison)
{
    return (int)((c == GN_COMPARE_DEFAULT ? default_comparison : c) - GN_NEVER);
}

static int depth_range(const place *p)
{
    const gn_depth_range *d = &p->state->depth.range;
    return !d->enabled ? 0 : d->z_near < d->z_far ? 1 : d->z_near > d->z_far ? 2 : 3;
}

static int polygon_offset(const place *p)
{
    const gn_polygon_offset *o = &p->state->raster.polygon_offset;
    return !o->enabled ? 0 : o->clamp == 0.0f ? 1 : o->clamp > 0.0f ? 2 : 3;
}

static int point_size(const place *p)
{
    const float size = p->state->raster.point_size;
    if (p->state->program.vertex_writes_point_size && p->draw->shader == SCENE_VERTEX_COLOR)
        return 0;
    return size <= 1.0f ? 1 : size <= 4.0f ? 2 : 3;
}

static int clip_distances(const place *p)
{
    const uint32_t count = p->state->program.clip_distance_count;
    return count < 2 ? (int)count : count < 4 ? 2 : 3;
}

/* Returns 0 for one colour surface, 1 for two to four, 2 for more. */
static int attachments(const place *p)
{
    int count = 0;
    for (int a = 1; a < GN_MAX_COLORS; ++a)
        count += scene_color_format(p->scene, a) != GN_FORMAT_NONE;
    return count < 4 ? (count > 0) : 2;
}

/* Whether an attachment after the first, which the target has and the shader writes, is blended.
 * more_masks: whether one has a write mask. */
static int more_blends(const place *p)
{
    bool blends = false;
    for (uint32_t a = 1; a < p->state->program.color_count; ++a)
        blends |= p->state->color.blend[a].enabled &&
                  scene_color_format(p->scene, (int)a) != GN_FORMAT_NONE;
    return blends;
}

static int more_masks(const place *p)
{
    bool masks = false;
    for (uint32_t a = 1; a < p->state->program.color_count; ++a)
        masks |= p->state->color.write_disabled[a] &&
                 scene_color_format(p->scene, (int)a) != GN_FORMAT_NONE;
    return masks;
}

static int line_width(const place *p)
{
    const float width = p->state->raster.line_width;
    return width < 1.5f ? 0 : width < 4.5f ? 1 : 2;
}

/* Returns 0 for floats, 1 for sRGB, 2 for other fractions, 3 for depths. */
static int kind_of_texels(const gn_texture *t)
{
    const bool floats = scene_is_color_format(t->format) && scene_is_float_format(t->format);
    return floats                             ? 0
           : t->format == GN_FORMAT_SRGB8_A8  ? 1
           : scene_is_color_format(t->format) ? 2
                                              : 3;
}

/* Returns 0 if nothing asks for the shading of samples, 1 if one sample is asked for, 2 for more.
 */
static int sample_shading(const place *p)
{
    return p->state->samples.shading_enabled ? 1 + scene_shades_samples(p->state) : 0;
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
    for (int f = 0; f < (int)p->scene->color_format; ++f)
        value += scene_is_color_format((gn_format)f);
    return value;
}

static int depth_format(const place *p)
{
    int value = 0;
    for (int f = 0; f < (int)p->scene->depth_format; ++f)
        value += !scene_is_color_format((gn_format)f);
    return value;
}

/* The default counts as the value that it stands for. */
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

VALUE(shader, p->draw->shader)
VALUE(index_format, p->draw->mesh.index_format)
VALUE(base_vertex, p->draw->mesh.base_vertex != 0)
VALUE(first_element, p->draw->mesh.first > 0)
VALUE(instances, p->draw->mesh.instance_count > 1)
VALUE(divisor, p->draw->mesh.attribute[GN_ATTRIBUTE_COLOR].divisor > 0)
VALUE(alpha_given, p->draw->mesh.attribute[GN_ATTRIBUTE_COLOR].components == 4)
VALUE(depth_function, comparison_number(p->state->depth.function, GN_LESS))
VALUE(front_function, comparison_number(p->state->stencil.front.function, GN_ALWAYS))
VALUE(back_function, comparison_number(p->state->stencil.back.function, GN_ALWAYS))
VALUE(stencil_mask, p->state->stencil.front.compare_disabled != 0)
VALUE(stencil_write_mask, p->state->stencil.front.write_disabled != 0)
VALUE(color_mask, p->state->color.write_disabled[0])
VALUE(blend, BLEND.enabled)
VALUE(blend_equation, equation(BLEND.equation, GN_EQUATION_ADD))
VALUE(blend_source, factor(BLEND.source, GN_FACTOR_ONE))
VALUE(blend_destination, factor(BLEND.destination, GN_FACTOR_ZERO))
VALUE(alpha_equation, equation(BLEND.alpha_equation, COLOR_EQUATION))
VALUE(alpha_source, factor(BLEND.alpha_source, COLOR_SOURCE))
VALUE(alpha_destination, factor(BLEND.alpha_destination, COLOR_DESTINATION))
VALUE(samples, scene_is_sampled(p->scene))
VALUE(sample_mask, p->state->samples.write_disabled != 0)
VALUE(outputs, p->state->program.color_count > 4)
VALUE(lod_bias, p->draw->uniforms.sampler.lod_bias != 0.0f)
VALUE(texture_target, p->draw->uniforms.texture.target)
VALUE(texels, kind_of_texels(&p->draw->uniforms.texture))
VALUE(threads, p->number % COMPARE_POOLS)
VALUE(workspace, p->number % 3)

#define OF_MEMBER 0, NULL, NULL

/* States that are no members of gn_pipeline, and states that stand for the member of the same name
 * with fewer or more values. OF_MEMBER: the values of a member outside gn_pipeline. */
static const state_row own_rows[] = {
    {"shader", SCENE_SHADER_COUNT, shader, NULL},
    {"interpolations", 4, interpolations, NULL},
    {"locations", 4, locations, NULL},
    {"samples.shading", 3, sample_shading, NULL},
    {"index_format", 4, index_format, NULL},
    {"base_vertex", 2, base_vertex, NULL},
    {"first_element", 2, first_element, NULL},
    {"instances", 2, instances, NULL},
    {"divisor", 2, divisor, NULL},
    {"alpha_given", 2, alpha_given, NULL},
    {"program.vertex_writes_point_size", 4, point_size, NULL},
    {"line_width", 3, line_width, NULL},
    {"raster.polygon_offset.set", 4, polygon_offset, NULL},
    {"depth.range.set", 4, depth_range, NULL},
    {"depth.function", 8, depth_function, NULL},
    {"stencil.front.function", 8, front_function, NULL},
    {"stencil.back.function", 8, back_function, NULL},
    {"stencil_mask", 2, stencil_mask, NULL},
    {"stencil_write_mask", 2, stencil_write_mask, NULL},
    {"color_mask", 16, color_mask, NULL},
    {"blend", 2, blend, NULL},
    {"blend_equation", 5, blend_equation, NULL},
    {"blend_source", 15, blend_source, NULL},
    {"blend_destination", 15, blend_destination, NULL},
    {"blend_alpha_equation", 5, alpha_equation, NULL},
    {"blend_alpha_source", 15, alpha_source, NULL},
    {"blend_alpha_destination", 15, alpha_destination, NULL},
    {"color_format", SCENE_COLOR_FORMATS, color_format, NULL},
    {"depth_format", 1 + SCENE_DEPTH_FORMATS, depth_format, NULL},
    {"samples", 2, samples, NULL},
    {"sample_mask", 2, sample_mask, NULL},
    {"clip_distances", 4, clip_distances, NULL},
    {"attachments", 3, attachments, NULL},
    {"outputs", 2, outputs, NULL},
    {"more_blends", 2, more_blends, NULL},
    {"more_masks", 2, more_masks, NULL},
    {"lod_bias", 2, lod_bias, NULL},
    {"texture_target", 5, texture_target, NULL},
    {"texels", 4, texels, NULL},
    {"clear_before", 4, clear_before, NULL},
    {"position", 3, position, NULL},
    {"threads", COMPARE_POOLS, threads, NULL},
    {"workspace", 3, workspace, NULL},
    {"counted", OF_MEMBER},
    {"mesh.restart", OF_MEMBER},
    {"uniforms.sampler.wrap_s", OF_MEMBER},
    {"uniforms.sampler.wrap_t", OF_MEMBER},
    {"uniforms.sampler.wrap_r", OF_MEMBER},
    {"uniforms.sampler.magnify", OF_MEMBER},
    {"uniforms.sampler.minify", OF_MEMBER},
    {"uniforms.sampler.lod_clamped", OF_MEMBER},
};

#define OWN_ROWS (sizeof own_rows / sizeof *own_rows)

/* A pair of states and values of them that no draw has together: bit v of a mask is value v. If the
 * first name ends in a star, it means every state whose name begins so. */
typedef struct exclusion {
    const char *a, *b;
    uint32_t values_a, values_b;
    const char *reason;
    bool means_nothing; /* the first state means nothing if the other state has those values or
                           means nothing */
} exclusion;

#define ANY UINT32_MAX
#define BIT(v) (UINT32_C(1) << (v))
#define NOT(v) (~BIT(v))

/* State a means something only if state b has one of these values. */
#define ONLY_WHERE(a, b, values_b, reason)                                                         \
    {                                                                                              \
        a, b, ANY, ~(uint32_t)(values_b), reason, true                                             \
    }

#define EXCLUDED(a, values_a, b, values_b, reason)                                                 \
    {                                                                                              \
        a, b, values_a, values_b, reason, false                                                    \
    }

#define FILLS (BIT(GN_TRIANGLES) | BIT(GN_TRIANGLE_STRIP) | BIT(GN_TRIANGLE_FAN))
#define ALL_LINES (BIT(GN_LINES) | BIT(GN_LINE_STRIP) | BIT(GN_LINE_LOOP))
/* Bits in the order of the rows' values: for SRGB8_A8; for no depth format and S8. */
#define SRGB BIT(13)
#define WITHOUT_DEPTH (BIT(0) | BIT(6))
#define TEXTURED (BIT(SCENE_TEXTURED_GOURAUD) | BIT(SCENE_PHONG) | BIT(SCENE_SAMPLED))

/* Rows apply in order: a row that decides whether a state means something stands before the rows
 * of the states that depend on it. */
static const exclusion exclusions[] = {
    ONLY_WHERE("mesh.restart", "index_format", NOT(GN_INDEX_NONE),
               "there is nothing to restart at"),
    ONLY_WHERE("base_vertex", "index_format", NOT(GN_INDEX_NONE), "it is added to indices"),
    ONLY_WHERE("divisor", "instances", BIT(1), "it divides instances"),
    ONLY_WHERE("raster.cull", "raster.topology", FILLS, "points and lines have no faces"),
    ONLY_WHERE("raster.front_face", "raster.topology", FILLS, "points and lines have no faces"),
    ONLY_WHERE("program.vertex_writes_point_size", "raster.topology", BIT(GN_POINTS), "of points"),
    ONLY_WHERE("line_width", "raster.topology", ALL_LINES, "of lines"),
    ONLY_WHERE("interpolations", "shader", BIT(SCENE_VERTEX_COLOR), "others bring their own"),
    ONLY_WHERE("locations", "shader",
               BIT(SCENE_VERTEX_COLOR) | BIT(SCENE_INPUTS) | BIT(SCENE_DERIVATIVES),
               "others have theirs at centres"),
    ONLY_WHERE("program.fragment_*", "shader", BIT(SCENE_INPUTS), "others do not"),
    ONLY_WHERE("raster.point_origin", "shader", BIT(SCENE_INPUTS),
               "others do not read the coordinates"),
    ONLY_WHERE("raster.point_origin", "program.fragment_reads_point_coordinate", BIT(1),
               "nobody reads them"),
    ONLY_WHERE("sample_mask", "samples", BIT(1), "there is one sample"),
    ONLY_WHERE("samples.alpha_to_coverage", "samples", BIT(1), "there is one sample"),
    ONLY_WHERE("samples.alpha_to_one", "samples", BIT(1), "there is one sample"),
    ONLY_WHERE("samples.shading", "samples", BIT(1), "there is one sample"),
    ONLY_WHERE("raster.polygon_mode_*", "raster.topology", FILLS, "points and lines have no faces"),
    ONLY_WHERE("outputs", "shader", BIT(SCENE_OUTPUTS), "others write one colour"),
    ONLY_WHERE("more_*", "shader", BIT(SCENE_OUTPUTS), "others write one colour"),
    ONLY_WHERE("more_*", "attachments", NOT(0), "there is one attachment"),
    ONLY_WHERE("uniforms.sampler.*", "shader", TEXTURED, "others have no texture"),
    ONLY_WHERE("uniforms.sampler.wrap_r", "shader", BIT(SCENE_SAMPLED), "others have 2D textures"),
    ONLY_WHERE("lod_bias", "shader", BIT(SCENE_SAMPLED), "others have one level"),
    ONLY_WHERE("uniforms.sampler.lod_clamped", "shader", BIT(SCENE_SAMPLED),
               "others have one level"),
    ONLY_WHERE("texture_target", "shader", BIT(SCENE_SAMPLED), "others have 2D textures"),
    ONLY_WHERE("texels", "shader", BIT(SCENE_SAMPLED), "others have RGBA8"),
    EXCLUDED("texels", BIT(3), "texture_target", BIT(GN_TEXTURE_3D),
             "OpenGL has no 3D textures of depths"),
    ONLY_WHERE("depth.function", "depth.test", NOT(0), "there is no test"),
    ONLY_WHERE("depth.write_disabled", "depth.test", NOT(0), "nothing is written without the test"),
    ONLY_WHERE("stencil.front.*", "stencil.test", NOT(0), "there is no test"),
    ONLY_WHERE("stencil.back.*", "stencil.test", NOT(0), "there is no test"),
    ONLY_WHERE("stencil_*", "stencil.test", NOT(0), "there is no test"),
    ONLY_WHERE("color.logic_operation", "color.logic", NOT(0), "nothing asks for it"),
    ONLY_WHERE("blend_*", "blend", NOT(0), "nothing is blended"),

    EXCLUDED("blend", NOT(0), "color_format", SRGB,
             "a second layer would multiply the step that is allowed (class blend has one)"),
    EXCLUDED("raster.polygon_offset.set", NOT(0), "depth_format", WITHOUT_DEPTH,
             "OpenGL's step is that of a depth buffer (reference/RULES.md)"),
    EXCLUDED("program.vertex_writes_point_size", BIT(0), "raster.viewport.set", BIT(1),
             "the reference cuts such points off at the viewport (reference/RULES.md)"),
    EXCLUDED("program.vertex_writes_point_size", BIT(0), "shader", NOT(SCENE_VERTEX_COLOR),
             "the shader of vertex colours alone has sizes (reference/scene/scene.h)"),
    EXCLUDED("program.fragment_reads_point_coordinate", BIT(1), "raster.topology", ALL_LINES,
             "in lines they are zeros of a sign that is left out (reference/RULES.md)"),
    EXCLUDED("raster.point_origin", ANY, "raster.topology", ALL_LINES,
             "their points have no coordinates"),
    EXCLUDED("raster.polygon_mode_*", NOT(GN_POLYGON_POINT),
             "program.fragment_reads_point_coordinate", BIT(1),
             "in lines and filled triangles they are zeros of a sign that is left out"),
    EXCLUDED("raster.polygon_mode_*", NOT(GN_POLYGON_POINT), "raster.point_origin", ANY,
             "only where all are points the coordinates are read"),
    EXCLUDED("samples.alpha_to_one", BIT(1), "program.fragment_writes_depth", BIT(1),
             "the reference keeps such alphas (reference/RULES.md)"),
    EXCLUDED("samples.alpha_to_one", BIT(1), "program.fragment_writes_sample_mask", BIT(1),
             "the reference keeps such alphas (reference/RULES.md)"),
    EXCLUDED("locations", BIT(3), "shader", BIT(SCENE_INPUTS), "it has one varying"),
    EXCLUDED("samples.alpha_to_coverage", BIT(1), "locations", BIT(2) | BIT(3),
             "the alpha of a sample decides on others in the reference (reference/RULES.md)"),
    EXCLUDED("samples.alpha_to_coverage", BIT(1), "program.fragment_reads_sample", BIT(1),
             "the alpha of a sample decides on others in the reference (reference/RULES.md)"),
    EXCLUDED("samples.alpha_to_coverage", BIT(1), "samples.shading", BIT(2),
             "the alpha of a sample decides on others in the reference (reference/RULES.md)"),
    EXCLUDED("raster.polygon_mode_*", BIT(GN_POLYGON_LINE), "samples", BIT(1),
             "the reference loses pixels of sampled lines (reference/RULES.md)"),
    EXCLUDED("depth_format", BIT(0), "shader", BIT(SCENE_DEPTH_ONLY), "it needs a depth buffer"),
    EXCLUDED("alpha_given", BIT(0), "shader", BIT(SCENE_INPUTS), "alpha decides what it discards"),
    EXCLUDED("clear_before", NOT(0), "position", BIT(0), "the scene's own clears come first"),
};

#define EXCLUSIONS (sizeof exclusions / sizeof *exclusions)

/* An exclusion of two states by their numbers. */
typedef struct excluded_states {
    int a, b;
    const exclusion *values;
} excluded_states;

#define MOST_STATES 256
#define MOST_EXCLUDED 512

/* The states, what they exclude, and how often their values meet. Values are numbered through all
 * states. */
typedef struct counts {
    state_row rows[MOST_STATES];
    int states;
    excluded_states excluded[MOST_EXCLUDED];
    int exclusions;
    int first[MOST_STATES + 1];
    uint64_t without[MOST_STATES]; /* draws to which the state means nothing */
    uint32_t *pairs;               /* how often: [value][value], in one array */
} counts;

static void fail(const char *what, const char *name)
{
    fprintf(stderr, "pairs: %s %s\n", what, name);
    exit(EXIT_FAILURE);
}

/* Adds a row. Without a function it has the values of the member it names. */
static void add_row(counts *c, state_row row)
{
    size_t line;
    if (!row.value) {
        row.member = scene_member_named(row.name, &line);
        if (!row.member)
            fail("there is no member", row.name);
        row.values = row.member->type == MEMBER_NAMED ? text_name_count(row.member->names) : 2;
    }
    if (c->states == MOST_STATES)
        fail("no room for", row.name);
    c->rows[c->states] = row;
    c->first[c->states + 1] = c->first[c->states] + row.values;
    ++c->states;
}

static bool has_own_row(const char *name)
{
    for (size_t i = 0; i < OWN_ROWS; ++i)
        if (strcmp(own_rows[i].name, name) == 0)
            return true;
    return false;
}

static void add_rows(counts *c)
{
    for (size_t i = 0; i < OWN_ROWS; ++i)
        add_row(c, own_rows[i]);
    for (size_t i = 0; i < scene_member_count; ++i) {
        const scene_member *m = &scene_members[i];
        if (scene_member_is_state(m) && !m->lines && !has_own_row(m->name) &&
            (m->type == MEMBER_SWITCH || m->type == MEMBER_NAMED))
            add_row(c, (state_row){m->name, OF_MEMBER});
    }
}

static bool is_called(const state_row *row, const char *name)
{
    const size_t length = strcspn(name, "*");
    return strncmp(row->name, name, length) == 0 && (name[length] || !row->name[length]);
}

static void add_exclusion(counts *c, const exclusion *e)
{
    const int before = c->exclusions;
    for (int a = 0; a < c->states; ++a)
        for (int b = 0; b < c->states; ++b)
            if (is_called(&c->rows[a], e->a) && is_called(&c->rows[b], e->b)) {
                if (c->exclusions == MOST_EXCLUDED)
                    fail("no room for", e->a);
                c->excluded[c->exclusions++] = (excluded_states){a, b, e};
            }
    if (c->exclusions == before)
        fail("no states are called as an exclusion says:", e->a);
}

static bool is_listed(const counts *c, int a, int value_a, int b, int value_b)
{
    for (int i = 0; i < c->exclusions; ++i) {
        const excluded_states *m = &c->excluded[i];
        const uint32_t values_a = m->values->values_a, values_b = m->values->values_b;
        if ((m->a == a && m->b == b && values_a >> value_a & 1 && values_b >> value_b & 1) ||
            (m->a == b && m->b == a && values_a >> value_b & 1 && values_b >> value_a & 1))
            return true;
    }
    return false;
}

/* Whether a pair is listed, or follows from the list: it does if every draw has a value of some
 * third state and no value of that state is possible with both. */
static bool is_impossible(const counts *c, int a, int value_a, int b, int value_b)
{
    bool impossible = is_listed(c, a, value_a, b, value_b);
    for (int s = 0; s < c->states && !impossible; ++s) {
        impossible = c->without[s] == 0;
        for (int v = 0; v < c->rows[s].values && impossible; ++v)
            impossible = is_listed(c, a, value_a, s, v) || is_listed(c, b, value_b, s, v);
    }
    return impossible;
}

static int value_of(const state_row *row, const place *p)
{
    const int value =
        row->value ? row->value(p) : (int)scene_member_get(row->member, p->draw, 0, 0);
    if (value >= row->values)
        fail("a value is too great of", row->name);
    return value;
}

static void count_draw(counts *c, const place *p)
{
    int value[MOST_STATES]; /* -1: the state means nothing */
    for (int s = 0; s < c->states; ++s)
        value[s] = value_of(&c->rows[s], p);
    for (int i = 0; i < c->exclusions; ++i) {
        const excluded_states *m = &c->excluded[i];
        if (m->values->means_nothing && (value[m->b] < 0 || m->values->values_b >> value[m->b] & 1))
            value[m->a] = -1;
    }
    for (int a = 0; a < c->states; ++a) {
        c->without[a] += value[a] < 0;
        for (int b = 0; b < a; ++b)
            if (value[a] >= 0 && value[b] >= 0)
                ++c->pairs[(c->first[a] + value[a]) * c->first[c->states] + c->first[b] + value[b]];
    }
}

static void count_class(counts *c, scene_class class, uint64_t seed, uint64_t scenes)
{
    for (uint64_t number = 0; number < scenes; ++number) {
        scene *s = generate_scene(seed, class, number);
        for (size_t i = 0; i < s->draw_count; ++i) {
            const place p = {s, &s->draws[i], &s->draws[i].state, i, number};
            count_draw(c, &p);
        }
        scene_free(s);
    }
}

/* Counts the pairs of one state with the states before it. Returns how many are not as the list
 * says. */
static uint64_t check_state(const counts *c, int a, uint64_t *seen, uint64_t *left_out)
{
    uint64_t wrong = 0;
    for (int b = 0; b < a; ++b)
        for (int i = 0; i < c->rows[a].values; ++i)
            for (int j = 0; j < c->rows[b].values; ++j) {
                const bool occurs =
                    c->pairs[(c->first[a] + i) * c->first[c->states] + c->first[b] + j] > 0;
                const bool possible = !is_impossible(c, a, i, b, j);
                *seen += occurs;
                *left_out += !possible;
                if (occurs != possible) {
                    ++wrong;
                    printf("pairs: %s %d and %s %d %s\n", c->rows[a].name, i, c->rows[b].name, j,
                           occurs ? "occur, but are said to be impossible" : "never occur");
                }
            }
    return wrong;
}

bool pairs_check(uint64_t seed, uint64_t scenes)
{
    static const scene_class classes[] = {CLASS_MIXED, CLASS_SEQUENCES, CLASS_MATERIALS};
    counts c = {.pairs = NULL};
    uint64_t seen = 0, left_out = 0, failed = 0;
    add_rows(&c);
    for (size_t i = 0; i < EXCLUSIONS; ++i)
        add_exclusion(&c, &exclusions[i]);
    const size_t values = (size_t)c.first[c.states];
    c.pairs = calloc(values * values, sizeof *c.pairs);
    if (!c.pairs)
        return false;
    for (size_t i = 0; i < sizeof classes / sizeof *classes; ++i)
        count_class(&c, classes[i], seed, scenes);
    for (int s = 0; s < c.states; ++s)
        failed += check_state(&c, s, &seen, &left_out) > 0;
    printf("pairs: %" PRIu64 " pairs of the %zu values of %d states occur in %" PRIu64
           " scenes each of mixed, sequences and materials, %" PRIu64 " are impossible\n",
           seen, values, c.states, scenes, left_out);
    printf("%" PRIu64 " passed, %" PRIu64 " failed\n", c.states - failed, failed);
    free(c.pairs);
    return failed == 0;
}
