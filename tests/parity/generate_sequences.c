/* Draws whose states are all chosen independently, so that every pair of values meets
 * (tests/parity/pairs.c checks which do), and long sequences of such draws into one target. */
#include "generate_parts.h"

#include <stdlib.h>
#include <string.h>

#define TEXTURE_SIDE 8

static gn_stencil_face any_face(random_source *r, uint8_t near)
{
    gn_stencil_face f;
    f.function = random_comparison(r);
    f.reference = (uint8_t)(near + random_below(r, 5) - 2);
    f.compare_disabled = random_chance(r, 70) ? 0 : (uint8_t)random_below(r, 256);
    f.write_disabled = random_chance(r, 70) ? 0 : (uint8_t)random_below(r, 256);
    f.fail = (gn_stencil_operation)random_below(r, 8);
    f.depth_fail = (gn_stencil_operation)random_below(r, 8);
    f.pass = (gn_stencil_operation)random_below(r, 8);
    return f;
}

static gn_blend any_blend(random_source *r)
{
    gn_blend b;
    b.enabled = true;
    b.equation = (gn_blend_equation)random_below(r, 6);
    b.source = (gn_blend_factor)random_below(r, 16);
    b.destination = (gn_blend_factor)random_below(r, 16);
    b.alpha_equation = (gn_blend_equation)random_below(r, 6);
    b.alpha_source = (gn_blend_factor)random_below(r, 16);
    b.alpha_destination = (gn_blend_factor)random_below(r, 16);
    return b;
}

/* The reference compiles a function for every offset, so there are only a few offsets. */
static gn_polygon_offset known_offset(builder *b)
{
    const random_source own = b->random;
    b->random = random_seed(random_below(&b->random, 64));
    const gn_polygon_offset offset = random_polygon_offset(b);
    b->random = own;
    random_bits(&b->random);
    return offset;
}

static void any_tests(builder *b)
{
    random_source *r = &b->random;
    b->state.depth.test_enabled = random_chance(r, 80);
    b->state.depth.function = random_comparison(r);
    b->state.depth.write_disabled = random_chance(r, 30);
    b->state.stencil.test_enabled = random_chance(r, 40);
    if (b->state.stencil.test_enabled) {
        b->state.stencil.front = any_face(r, b->scene->clear_stencil);
        b->state.stencil.back = any_face(r, b->scene->clear_stencil);
    }
    if (random_chance(r, 30))
        b->state.depth.range = random_depth_range(b);
    if (random_chance(r, 40))
        b->state.raster.polygon_offset = known_offset(b);
    b->state.depth.clamp_enabled = random_chance(r, 30);
    b->state.depth.clip_depth = (gn_clip_depth)random_below(r, 2);
}

static void any_window(builder *b)
{
    random_source *r = &b->random;
    if (random_chance(r, 30)) {
        b->state.raster.viewport = random_viewport(b);
        if (!(b->state.raster.viewport.width >= 1.0f && b->state.raster.viewport.height >= 1.0f))
            b->state.raster.viewport.width = b->state.raster.viewport.height = 1.0f;
    }
    if (random_chance(r, 30))
        b->state.raster.scissor = random_scissor(b);
    b->state.raster.cull = (gn_cull)(random_chance(r, 60) ? 0 : 1 + random_below(r, 3));
    b->state.raster.front_face = (gn_front_face)random_below(r, 2);
    b->state.raster.provoking_vertex = (gn_provoking_vertex)random_below(r, 2);
}

/* Mostly allows writing everything. */
static void any_color_state(builder *b, bool may_blend)
{
    random_source *r = &b->random;
    if (random_chance(r, 50))
        b->state.color.write_disabled[0] = random_below(r, 16);
    if (random_chance(r, 50) && may_blend)
        b->state.color.blend[0] = any_blend(r);
    for (int c = 0; c < 4; ++c)
        b->state.color.blend_constant[c] = random_unit(r);
    mix_attachments(b, false);
    b->state.color.logic_enabled = random_chance(r, b->state.color.blend[0].enabled ? 50 : 30);
    if (b->state.color.logic_enabled)
        b->state.color.logic_operation = (gn_logic_operation)random_below(r, 16);
}

/* Whether a varying is noperspective. */
static bool any_shader(builder *b)
{
    random_source *r = &b->random;
    bool noperspective = false;
    const uint32_t which = random_below(r, 100); /* shaders with states of their own, more often */
    const uint32_t any = random_below(r, SCENE_METALLIC_ROUGHNESS); /* class materials has it */
    b->shader = which < 21   ? SCENE_VERTEX_COLOR
                : which < 33 ? SCENE_INPUTS
                : which < 42 ? SCENE_OUTPUTS
                : which < 58 ? SCENE_SAMPLED
                             : (scene_shader)any;
    if (b->metallic && random_chance(r, 50))
        b->shader = SCENE_METALLIC_ROUGHNESS;
    if (b->shader == SCENE_DEPTH_ONLY && b->scene->depth_format == GN_FORMAT_NONE)
        b->shader = SCENE_DEPTH_COLOR;
    if (b->shader == SCENE_OUTPUTS)
        random_outputs(b);
    b->uniforms.light.light_direction.z = 1.0f;
    b->uniforms.light.ambient = (gn_vec3){0.25f, 0.25f, 0.5f};
    b->uniforms.light.diffuse = (gn_vec3){0.75f, 0.5f, 0.5f};
    b->specular = (gn_vec3){0.5f, 0.25f, 0.75f};
    gn_mat4_identity(&b->view_from_model);
    if (b->shader == SCENE_VERTEX_COLOR) {
        const bool one = random_chance(r, 80);
        const gn_interpolation all = (gn_interpolation)random_below(r, 3);
        for (int i = 0; i < 4; ++i) {
            b->state.program.interpolation[i] = one ? all : (gn_interpolation)random_below(r, 3);
            noperspective = noperspective || b->state.program.interpolation[i] == GN_NOPERSPECTIVE;
        }
    }
    return noperspective;
}

/* No byte is 0: a denormal may be added to a texel, and shows only if the texel is 0. */
static void any_texture(builder *b, uint32_t *texels)
{
    random_source *r = &b->random;
    gn_texture *t = &b->uniforms.texture;
    t->width = random_chance(r, 50) ? TEXTURE_SIDE : 5;
    t->height = random_chance(r, 50) ? TEXTURE_SIDE : 3;
    t->format = GN_FORMAT_RGBA8;
    t->level[0].texels = texels;
    for (uint32_t i = 0; i < TEXTURE_SIDE * TEXTURE_SIDE; ++i)
        texels[i] = (uint32_t)(random_bits(r) >> 32) | 0x01010101u;
    b->uniforms.sampler.wrap_s = (gn_wrap)random_below(r, 5);
    b->uniforms.sampler.wrap_t = (gn_wrap)random_below(r, 5);
    for (int c = 0; c < 4; ++c) /* not 0, like the texels */
        b->uniforms.sampler.border[c] = random_float(r, 0.25f, 1.0f);
    b->uniforms.sampler.magnify = (gn_magnify)random_below(r, 2);
    b->uniforms.sampler.minify = (gn_minify)random_below(r, 6);
    for (uint32_t i = 0; i < b->vertex_count; ++i)
        for (int c = 0; c < 2; ++c)
            b->vertices[i].texcoord[c] = random_float(r, -1.0f, 2.0f);
}

/* A mesh of any topology. Noperspective varyings need triangles within the sides of the viewport
 * (reference/RULES.md). */
static void any_mesh(builder *b, uint32_t count, bool noperspective)
{
    random_source *r = &b->random;
    const uint32_t which = random_below(r, 8);
    const gn_topology topology = which < 7 ? (gn_topology)which : GN_POINTS;
    if (topology == GN_POINTS) {
        shape_points(b, count);
        /* Often on, since few draws may have it. */
        if (b->shader == SCENE_VERTEX_COLOR && !b->state.raster.viewport.enabled &&
            random_chance(r, 50))
            b->state.program.vertex_writes_point_size = true;
    } else if (topology >= GN_LINES) {
        shape_lines(b, count);
    } else if (topology == GN_TRIANGLES && !noperspective && random_chance(r, 70)) {
        shape_separate(b, count);
    } else {
        const placement p = noperspective ? PLACE_INSIDE : (placement)random_below(r, PLACE_COUNT);
        for (uint32_t i = 0; i < count + 2 || i < 3; ++i)
            shape_place(b, builder_vertex(b), p);
    }
    b->state.raster.topology = topology;
    b->index_format = (gn_index_format)random_below(r, 4);
    if (b->vertex_count > 256 && b->index_format == GN_INDEX_UINT8)
        b->index_format = GN_INDEX_UINT16;
    if (b->index_format != GN_INDEX_NONE && b->index_count == 0 && random_chance(r, 50) &&
        (topology != GN_TRIANGLES || noperspective))
        for (uint32_t i = 0, elements = b->vertex_count; i < elements; ++i)
            builder_index(b, random_below(r, b->vertex_count));
    if (topology != GN_POINTS)
        b->state.raster.point_size = (float)random_below(r, 4);
    if (topology < GN_LINES)
        b->state.raster.line_width = (float)random_below(r, 4);
    b->lead = random_chance(r, 20) ? random_below(r, 9) : 0;
    b->trail = random_chance(r, 10) ? random_below(r, 9) : 0;
}

static void any_polygon_modes(builder *b)
{
    random_source *r = &b->random;
    b->state.raster.point_origin = (gn_point_origin)random_below(r, 2);
    if (random_chance(r, 35)) {
        b->state.raster.polygon_mode_front = (gn_polygon_mode)random_below(r, 3);
        b->state.raster.polygon_mode_back = random_chance(r, 50)
                                                ? b->state.raster.polygon_mode_front
                                                : (gn_polygon_mode)random_below(r, 3);
    }
}

static void any_clip_planes(builder *b)
{
    random_source *r = &b->random;
    if (random_chance(r, 30))
        random_clip_planes(b, random_chance(r, 60) ? 1 + random_below(r, 2)
                                                   : 1 + random_below(r, GN_MAX_CLIP_DISTANCES));
}

void varied_draw(builder *b, bool may_blend)
{
    random_source *r = &b->random;
    uint32_t texels[TEXTURE_SIDE * TEXTURE_SIDE];
    shading_memory shading = {{NULL}};
    void *sampled = NULL;
    const gn_format format = b->scene->color_format;
    const bool floats = format == GN_FORMAT_RGBA32F || format == GN_FORMAT_R32F;
    builder_common_state(b);
    any_tests(b);
    any_window(b);
    any_color_state(b, may_blend);
    const bool noperspective = any_shader(b);
    any_mesh(b, 1 + random_below(r, floats ? 3 : 16), noperspective);
    if (b->shader == SCENE_SAMPLED)
        sampled = random_any_sampling(b);
    else if (b->shader >= SCENE_UNLIT)
        random_shading(b, &shading);
    else if (scene_shader_is_textured(b->shader))
        any_texture(b, texels);
    if (b->shader == SCENE_METALLIC_ROUGHNESS)
        random_metallic(b, &shading);
    any_polygon_modes(b);
    any_clip_planes(b);
    if (b->shader == SCENE_INPUTS)
        random_inputs(b);
    fit_outlines(b);
    b->counted = random_chance(r, 30);
    if (random_chance(r, 60))
        shape_elements(b);
    builder_draw(b);
    free(sampled);
    free_shading(&shading);
}

/* Products of many layers of floats become denormals, which the reference flushes. If the reference
 * is a step off in sRGB, a second layer would multiply that step. */
bool may_blend_after(const builder *b, uint32_t draws)
{
    const gn_format format = b->scene->color_format;
    const bool floats = format == GN_FORMAT_RGBA32F || format == GN_FORMAT_R32F;
    return format != GN_FORMAT_SRGB8_A8 && (!floats || draws < 2);
}

gn_format random_depth_format(builder *b)
{
    static const gn_format formats[] = {GN_FORMAT_NONE,  GN_FORMAT_D16,    GN_FORMAT_D24,
                                        GN_FORMAT_D32F,  GN_FORMAT_D24S8,  GN_FORMAT_D32FS8,
                                        GN_FORMAT_D24S8, GN_FORMAT_D32FS8, GN_FORMAT_S8};
    return formats[random_below(&b->random, 9)];
}

/* Clears colour, depth with stencil, or both. */
static void random_clear(builder *b, scene_clear *clear)
{
    random_source *r = &b->random;
    const uint32_t which = 1 + random_below(r, 3);
    clear->color = which & 1;
    clear->depth = which >> 1;
    for (int c = 0; c < 4; ++c)
        clear->color_value[c] = random_unit(r);
    clear->depth_value = random_chance(r, 50) ? 1.0f : random_unit(r);
    clear->stencil_value = (uint8_t)random_below(r, 256);
}

void generate_sequences(builder *b)
{
    random_source *r = &b->random;
    const uint32_t width = 8 + random_below(r, 57), height = 8 + random_below(r, 57);
    const uint32_t kind = random_below(r, 10);
    builder_target(b, width, height, GN_FORMAT_RGBA8, random_depth_format(b));
    if (kind < 2)
        b->scene->color_format = GN_FORMAT_RGBA32F;
    else if (kind < 5)
        b->scene->color_format = random_color_format(b);
    if (random_chance(r, 25))
        add_attachments(b);
    const uint32_t draws = 7 + random_below(r, 14);
    for (uint32_t since = 0; b->scene->draw_count < draws; ++since) {
        scene_clear clear = {0};
        if (since > 0 && random_chance(r, 15))
            random_clear(b, &clear);
        since = clear.color ? 0 : since;
        const size_t before = b->scene->draw_count;
        varied_draw(b, may_blend_after(b, since));
        if (b->scene->draw_count > before)
            b->scene->draws[before].clear = clear;
    }
}
