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
    const gn_viewport v = d->state.raster.viewport.set ? d->state.raster.viewport : whole;
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
    if (scissor->set && scissor->x > 0) {
        scissor->width += (uint32_t)scissor->x;
        scissor->x = 0;
    }
    if (scissor->set && scissor->y > 0) {
        scissor->height += (uint32_t)scissor->y;
        scissor->y = 0;
    }
    if (d->state.raster.polygon_mode_front == GN_POLYGON_LINE ||
        d->state.raster.polygon_mode_back == GN_POLYGON_LINE) {
        d->state.raster.polygon_mode_front = d->state.raster.polygon_mode_back = GN_POLYGON_FILL;
        smooth_all(d);
    }
    if (d->state.raster.topology > GN_POINTS) {
        scissor->set = false;
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

static void random_sample_state(random_source *r, gn_pipeline *p)
{
    p->samples.write_disabled = random_chance(r, 30) ? random_below(r, 1u << GN_SAMPLES) : 0;
    p->samples.alpha_to_coverage = random_chance(r, 20);
    /* The reference ignores alpha to one if a shader writes depth or a mask. */
    p->samples.alpha_to_one = random_chance(r, 25) && !p->program.fragment_writes_depth &&
                              !p->program.fragment_writes_sample_mask;
}

void make_sampled(random_source *r, scene *s)
{
    s->samples = GN_SAMPLES;
    for (size_t i = 0; i < s->draw_count; ++i) {
        avoid_defects(r, s, &s->draws[i]);
        if (random_chance(r, 50))
            random_sample_state(r, &s->draws[i].state);
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
