/* Scenes of other classes with several samples a pixel. */
#include "generate.h"

#include <math.h>
#include <string.h>

#include "generate_parts.h"

/* The size of the reference's tiles. At their lower left sides the reference loses lines
 * (reference/RULES.md). */
#define TILE 64.0

/* Computes the window coordinates of a line's ends; false if the line is clipped, or nearly. */
static bool line_in_window(const scene *s, const scene_draw *d, const float *const end[2],
                           double at[2][2])
{
    const gn_viewport whole = {true, 0.0f, 0.0f, (float)s->width, (float)s->height};
    const gn_viewport v = d->state.raster.viewport.enabled ? d->state.raster.viewport : whole;
    for (int i = 0; i < 2; ++i) {
        const double w = (double)end[i][3];
        for (int c = 0; c < 3; ++c)
            if (!(fabs((double)end[i][c]) < 0.999 * w))
                return false;
        if (d->state.depth.clip_depth == GN_ZERO_TO_ONE && !((double)end[i][2] > 0.001 * w))
            return false;
        at[i][0] = (double)v.x + 0.5 * (double)v.width * (1.0 + (double)end[i][0] / w);
        at[i][1] = (double)v.y + 0.5 * (double)v.height * (1.0 + (double)end[i][1] / w);
    }
    return true;
}

/* Whether the reference draws the whole line. The reference takes the pixels of a line to begin
 * with the first whole pixel. So it loses a part that reaches just beyond a tile, and lines less
 * than a pixel wide or high. */
static bool line_is_safe(const scene *s, const scene_draw *d, const float *const end[2])
{
    const double size[2] = {(double)s->width, (double)s->height};
    const double width =
        d->state.raster.line_width > 1.0f ? (double)d->state.raster.line_width : 1.0;
    double at[2][2];
    if (!line_in_window(s, d, end, at))
        return false;
    const double length = hypot(at[0][0] - at[1][0], at[0][1] - at[1][1]);
    for (int c = 0; c < 2; ++c) {
        const double half = 0.5 * width * fabs(at[0][!c] - at[1][!c]) / length;
        const double low = fmin(at[0][c], at[1][c]) - half, high = fmax(at[0][c], at[1][c]) + half;
        const double in_tile = low - TILE * floor(low / TILE);
        if (!(high - low > 1.02) || low > size[c] - 1.02 ||
            (low > 0.0 && (in_tile > TILE - 1.02 || in_tile < 0.02)))
            return false;
    }
    return true;
}

/* Moves the ends of lines that the reference does not draw whole. Returns false if that does not
 * help. */
static bool move_lines(random_source *r, scene *s, scene_draw *d)
{
    const gn_attribute *const position = &d->mesh.attribute[GN_ATTRIBUTE_POSITION];
    const gn_mesh *const mesh = &d->mesh;
    const uint32_t step = d->state.raster.topology == GN_LINES ? 2 : 1;
    gn_mat4 identity;
    gn_mat4_identity(&identity);
    if (memcmp(&identity, &d->uniforms.light.clip_from_model, sizeof identity) != 0 ||
        position->components != 4 || mesh->restart != GN_RESTART_NONE || mesh->base_vertex != 0)
        return false;
    float *const p = (float *)position->data;
    const float least = d->state.depth.clip_depth == GN_ZERO_TO_ONE ? 0.01f : -0.99f;
    bool moved = true;
    for (int attempt = 0; moved && attempt < 100; ++attempt) {
        moved = false;
        for (uint32_t i = 0; i + 1 < mesh->count + (d->state.raster.topology == GN_LINE_LOOP);
             i += step) {
            float *const end[2] = {
                p + (size_t)4 * scene_vertex_of(mesh, mesh->first + i),
                p + (size_t)4 * scene_vertex_of(mesh, mesh->first + (i + 1) % mesh->count)};
            const float *const ends[2] = {end[0], end[1]};
            if (line_is_safe(s, d, ends))
                continue;
            moved = true;
            for (int e = 0; e < 2; ++e) {
                end[e][3] = random_chance(r, 50) ? 1.0f : random_float(r, 0.25f, 4.0f);
                for (int c = 0; c < 3; ++c)
                    end[e][c] = end[e][3] * random_float(r, c == 2 ? least : -0.99f, 0.99f);
            }
        }
    }
    return !moved;
}

/* Noperspective varyings are only for triangles within the sides of the viewport. */
static void smooth_all(scene_draw *d)
{
    for (int i = 0; i < GN_MAX_VARYINGS; ++i)
        if (d->state.program.interpolation[i] == GN_NOPERSPECTIVE)
            d->state.program.interpolation[i] = GN_SMOOTH;
}

/* Avoids what the reference draws otherwise than OpenGL with several samples
 * (reference/RULES.md). */
static void avoid_defects(random_source *r, scene *s, scene_draw *d)
{
    gn_scissor *const scissor = &d->state.raster.scissor;
    /* A scissor leaks to the left and downward, so its left and lower sides are outside the
     * target. */
    if (scissor->enabled && scissor->x > 0) {
        scissor->width += (uint32_t)scissor->x;
        scissor->x = 0;
    }
    if (scissor->enabled && scissor->y > 0) {
        scissor->height += (uint32_t)scissor->y;
        scissor->y = 0;
    }
    if (d->state.raster.polygon_mode_front == GN_POLYGON_LINE ||
        d->state.raster.polygon_mode_back == GN_POLYGON_LINE) {
        d->state.raster.polygon_mode_front = d->state.raster.polygon_mode_back = GN_POLYGON_FILL;
        smooth_all(d);
    }
    if (d->state.raster.topology > GN_POINTS) {
        scissor->enabled = false;
        d->state.program.clip_distance_count = 0; /* the ends of clipped lines are not known here */
        /* Now and then the reference loses a line at a tile's border for a reason that line_is_safe
         * does not test. */
        const bool one_tile = (double)s->width <= TILE && (double)s->height <= TILE;
        if (!one_tile || !move_lines(r, s, d)) {
            d->state.raster.topology = GN_TRIANGLES;
            smooth_all(d);
        }
    }
}

/* Whether the fragment shader runs for each sample. */
static bool runs_per_sample(const scene_draw *d)
{
    bool runs = d->shader == SCENE_INPUTS && d->state.program.fragment_reads_sample;
    for (int c = 0; c < 4; ++c)
        runs = runs || d->state.program.interpolated_at[c] == GN_AT_SAMPLE;
    return runs || scene_shades_samples(&d->state);
}

static void random_sample_state(random_source *r, scene_draw *d)
{
    gn_pipeline *const p = &d->state;
    p->samples.write_disabled = random_chance(r, 30) ? random_below(r, 1u << GN_SAMPLES) : 0;
    /* If the shader runs for each sample, the reference lets the alpha of each sample decide on
     * other samples. */
    p->samples.alpha_to_coverage_enabled = random_chance(r, 20) && !runs_per_sample(d);
    /* The reference ignores alpha to one if a shader writes depth or a mask. */
    p->samples.alpha_to_one_enabled = random_chance(r, 25) && !p->program.fragment_writes_depth &&
                                      !p->program.fragment_writes_sample_mask;
}

/* Whether the position has components in all of which clip space is linear, so that w is a
 * component of the data. */
static bool has_own_w(const scene_draw *d)
{
    const gn_mat4 *const m = &d->uniforms.light.clip_from_model;
    const gn_attribute *const position = &d->mesh.attribute[GN_ATTRIBUTE_POSITION];
    return position->components == 4 && (position->stride == 0 || position->stride == 16) &&
           m->m[0][3] == 0.0f && m->m[1][3] == 0.0f && m->m[2][3] == 0.0f && m->m[3][3] == 1.0f;
}

/* Whether all vertices are well inside the view volume. */
static bool is_unclipped(const scene_draw *d)
{
    const gn_mat4 *const m = &d->uniforms.light.clip_from_model;
    const gn_attribute *const a = &d->mesh.attribute[GN_ATTRIBUTE_POSITION];
    const uint32_t stride = a->stride ? a->stride / 4 : a->components;
    const double near = d->state.depth.clip_depth == GN_ZERO_TO_ONE ? 0.001 : -0.999;
    bool inside = a->data && d->state.program.clip_distance_count == 0;
    for (uint32_t v = 0; v < d->mesh.vertex_count && inside; ++v) {
        const float *const p = a->data + (size_t)v * stride;
        double clip[4];
        for (int c = 0; c < 4; ++c) {
            clip[c] = a->components < 4 ? (double)m->m[3][c] : 0.0;
            for (uint32_t i = 0; i < a->components; ++i)
                clip[c] += (double)m->m[i][c] * (double)p[i];
        }
        for (int c = 0; c < 3; ++c)
            inside = inside && fabs(clip[c]) < 0.999 * clip[3];
        inside = inside && clip[2] > near * clip[3];
    }
    return inside;
}

/* Makes all w 1, and divides by them those that are greater than 0. */
static void level_w(scene_draw *d)
{
    float *p = (float *)d->mesh.attribute[GN_ATTRIBUTE_POSITION].data;
    for (uint32_t v = 0; v < d->mesh.vertex_count; ++v, p += 4) {
        for (int c = 0; c < 3 && p[3] > 1e-6f; ++c)
            p[c] = p[c] / p[3];
        p[3] = 1.0f;
    }
}

/* Sees to it that the reference draws smooth varyings as OpenGL says (osmesa/locations.c): where it
 * must be asked in another way, nothing may be clipped; where it cannot be asked so, or something
 * is clipped, all w must be equal. */
static void make_w_harmless(scene_draw *d)
{
    const bool has_twin = d->shader == SCENE_VERTEX_COLOR || d->shader == SCENE_DERIVATIVES ||
                          d->shader == SCENE_INPUTS;
    if (!scene_draw_is_located(d) || scene_draw_has_one_w(d) || (has_twin && is_unclipped(d)))
        return;
    if (has_own_w(d)) {
        level_w(d);
        return;
    }
    d->state.samples.least_shading = 0.0f;
    for (int c = 0; c < 4; ++c)
        d->state.program.interpolated_at[c] = GN_AT_CENTER;
}

void make_sampled(random_source *r, scene *s)
{
    s->samples = GN_SAMPLES;
    for (size_t i = 0; i < s->draw_count; ++i) {
        avoid_defects(r, s, &s->draws[i]);
        make_w_harmless(&s->draws[i]); /* lines that were moved have other w */
        if (random_chance(r, 50))
            random_sample_state(r, &s->draws[i]);
    }
}

scene *generate_sampled(uint64_t seed)
{
    random_source r = random_seed(seed);
    /* Mixed more often. The number leaves out later classes, so that a new one changes no scene. */
    const scene_class c = (scene_class)random_below(&r, CLASS_SEQUENCES + 9);
    const uint64_t number = random_bits(&r);
    const uint64_t inner_seed = random_bits(&r);
    scene *const s = generate_scene(inner_seed, c < CLASS_SAMPLES ? c : CLASS_MIXED, number);
    make_sampled(&r, s);
    return s;
}

/* Replaces the shader of vertex colours by that of inputs.h. */
static void mask_samples(random_source *r, scene_draw *d)
{
    if (d->shader == SCENE_VERTEX_COLOR)
        d->shader = SCENE_INPUTS;
    d->state.program.fragment_reads_sample_mask = random_chance(r, 60);
    d->state.program.fragment_writes_sample_mask = random_chance(r, 60);
}

scene *generate_masks(uint64_t seed)
{
    static const scene_class classes[] = {
        CLASS_TINY,       CLASS_TIES,     CLASS_PILES,       CLASS_STRIPS,
        CLASS_INPUTS,     CLASS_INPUTS,   CLASS_DEPTH_STATE, CLASS_STENCIL,
        CLASS_COUNTING,   CLASS_COUNTING, CLASS_SCISSOR,     CLASS_OFFSET,
        CLASS_BLEND,      CLASS_POINTS,   CLASS_LINES,       CLASS_POINT_COORDINATES,
        CLASS_CLIP_DEPTH, CLASS_OUTLINES, CLASS_INSTANCES,   CLASS_CLIP_DISTANCE};
    random_source r = random_seed(seed);
    const scene_class c = classes[random_below(&r, sizeof classes / sizeof *classes)];
    const uint64_t number = random_bits(&r);
    const uint64_t inner_seed = random_bits(&r);
    scene *const s = generate_scene(inner_seed, c, number);
    for (size_t i = 0; i < s->draw_count; ++i)
        mask_samples(&r, &s->draws[i]);
    if (random_chance(&r, 85))
        make_sampled(&r, s);
    return s;
}

/* Sets where vertex colours are interpolated: in a few ways, since the reference compiles a program
 * for each. */
static void random_locations(random_source *r, scene_draw *d)
{
    static const gn_interpolation_point mixed[] = {GN_AT_CENTER, GN_AT_CENTROID, GN_AT_SAMPLE,
                                                   GN_AT_CENTROID};
    const uint32_t kind = random_below(r, 4);
    const bool differ = kind == 3 && d->shader != SCENE_INPUTS;
    for (int c = 0; c < 4; ++c)
        d->state.program.interpolated_at[c] =
            differ ? mixed[c] : (gn_interpolation_point)(kind == 3 ? GN_AT_CENTROID : kind);
}

/* Whether nothing is left of the varyings in the shader of inputs.h, so that their location does
 * not show in its twin. */
static bool hides_varyings(const gn_program *p)
{
    return p->fragment_reads_point_coordinate && p->fragment_reads_position &&
           !p->fragment_discards && !p->fragment_writes_depth;
}

void random_sample_shading(random_source *r, scene_draw *d)
{
    static const float fractions[] = {0.0f, 0.25f, 0.26f, 0.5f, 1.0f};
    gn_program *const program = &d->state.program;
    if (d->shader == SCENE_VERTEX_COLOR || d->shader == SCENE_DERIVATIVES ||
        d->shader == SCENE_INPUTS)
        random_locations(r, d);
    program->fragment_reads_sample = d->shader == SCENE_INPUTS && random_chance(r, 35);
    if (d->shader == SCENE_INPUTS && hides_varyings(program) && !program->fragment_reads_sample)
        for (int c = 0; c < 4; ++c)
            program->interpolated_at[c] = GN_AT_CENTER;
    d->state.samples.shading_enabled = random_chance(r, 35);
    if (d->state.samples.shading_enabled)
        d->state.samples.least_shading = fractions[random_below(r, 5)];
    make_w_harmless(d);
    if (runs_per_sample(d))
        d->state.samples.alpha_to_coverage_enabled = false;
}

scene *generate_sample_shading(uint64_t seed)
{
    static const scene_class classes[] = {CLASS_TINY,
                                          CLASS_SLIVERS,
                                          CLASS_TIES,
                                          CLASS_PILES,
                                          CLASS_MESHES,
                                          CLASS_INTERPOLATION,
                                          CLASS_INTERPOLATION,
                                          CLASS_INPUTS,
                                          CLASS_INPUTS,
                                          CLASS_DERIVATIVES,
                                          CLASS_STENCIL,
                                          CLASS_COUNTING,
                                          CLASS_DEPTH_STATE,
                                          CLASS_OFFSET,
                                          CLASS_BLEND,
                                          CLASS_FLOAT_COLOR,
                                          CLASS_POINTS,
                                          CLASS_LINES,
                                          CLASS_POINT_COORDINATES,
                                          CLASS_OUTLINES,
                                          CLASS_FILLS,
                                          CLASS_MIPMAPS,
                                          CLASS_SHADERS,
                                          CLASS_ATTACHMENTS,
                                          CLASS_BATCHES,
                                          CLASS_BATCH_ENDS,
                                          CLASS_CLIP_DISTANCE,
                                          CLASS_MASKS};
    random_source r = random_seed(seed);
    const scene_class c = classes[random_below(&r, sizeof classes / sizeof *classes)];
    const uint64_t number = random_bits(&r);
    const uint64_t inner_seed = random_bits(&r);
    scene *const s = generate_scene(inner_seed, c, number);
    if (!s->samples && random_chance(&r, 90))
        make_sampled(&r, s);
    for (size_t i = 0; i < s->draw_count; ++i) {
        scene_draw *const d = &s->draws[i];
        if (d->shader == SCENE_VERTEX_COLOR &&
            d->mesh.attribute[GN_ATTRIBUTE_COLOR].components == 4 && random_chance(&r, 30)) {
            d->shader = SCENE_INPUTS;
            d->state.program.fragment_discards = random_chance(&r, 30);
            d->state.program.fragment_reads_position = random_chance(&r, 40);
            d->state.program.fragment_writes_sample_mask =
                random_chance(&r, 30) && !d->state.samples.alpha_to_one_enabled;
        }
        random_sample_shading(&r, d);
    }
    return s;
}
