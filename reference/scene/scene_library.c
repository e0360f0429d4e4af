/* Draws a scene with the library. */
#include "scene.h"

#include <stdlib.h>
#include <string.h>

#include "derivatives.h"
#include "inputs.h"
#include "outputs.h"
#include "phong.h"
#include "sampled.h"
#include "scene_memory.h"

typedef char scene_varyings_are_as_stated[PHONG_VARYINGS <= SCENE_VARYINGS ? 1 : -1];

static phong_uniforms phong_uniforms_of(const scene_draw *d)
{
    const scene_light *light = &d->uniforms.light;
    const phong_uniforms u = {
        light->clip_from_model, d->view_from_model, light->normal_matrix, light->light_direction,
        light->ambient,         light->diffuse,     d->specular,          d->uniforms.texture,
        d->uniforms.sampler};

    return u;
}

static const gn_texture *map_of(const scene_draw *d, scene_map map)
{
    return scene_draw_has_map(d, map) ? &d->surface.map[map] : NULL;
}

static gn_light light_of(const scene_draw *d)
{
    const scene_light *light = &d->uniforms.light;
    const scene_surface *surface = &d->surface;
    gn_light l;

    memset(&l, 0, sizeof l);
    l.direction = light->light_direction;
    l.ambient = light->ambient;
    l.diffuse = light->diffuse;
    l.kind = scene_light_kind(surface);
    l.position = surface->light_position;
    l.constant = surface->attenuation[0];
    l.linear = surface->attenuation[1];
    l.quadratic = surface->attenuation[2];
    l.range = surface->light_range;
    l.inner_cosine = surface->cone[0];
    l.outer_cosine = surface->cone[1];
    return l;
}

static gn_shadow shadow_of(const scene_draw *d)
{
    gn_shadow shadow;

    memset(&shadow, 0, sizeof shadow);
    shadow.map = map_of(d, SCENE_SHADOW_MAP);
    shadow.sampler = d->surface.shadow_sampler;
    shadow.clip_from_world = d->surface.shadow_from_world;
    return shadow;
}

static gn_map own_map_of(const scene_draw *d, scene_map map)
{
    return (gn_map){map_of(d, map), *scene_map_sampler(d, map)};
}

static gn_metallic_roughness_uniforms metallic_uniforms_of(const scene_draw *d)
{
    const scene_surface *surface = &d->surface;
    gn_metallic_roughness_uniforms u;

    memset(&u, 0, sizeof u);
    u.clip_from_model = d->uniforms.light.clip_from_model;
    u.normal_matrix = d->uniforms.light.normal_matrix;
    u.world_from_model = surface->world_from_model;
    u.eye = surface->eye;
    u.light = light_of(d);
    u.shadow = shadow_of(d);
    u.more_lights = surface->more_lights;
    u.more_light_count = surface->more_light_count;
    if (scene_draw_has_texture(d))
        u.material.base_color_map.texture = &d->uniforms.texture;
    u.material.base_color_map.sampler = d->uniforms.sampler;
    u.material.metallic_roughness_map = own_map_of(d, SCENE_METALLIC_ROUGHNESS_MAP);
    u.material.normal_map = own_map_of(d, SCENE_NORMAL_MAP);
    u.material.occlusion_map = own_map_of(d, SCENE_OCCLUSION_MAP);
    u.material.emissive_map = own_map_of(d, SCENE_GLOW_MAP);
    u.material.metallic = surface->metallic;
    u.material.roughness = surface->roughness;
    u.material.normal_scale = surface->normal_scale;
    u.material.occlusion_strength = surface->occlusion_strength;
    u.material.emissive = surface->emissive;
    u.material.alpha_cutoff = surface->alpha_cutoff;
    u.material.double_sided = surface->double_sided;
    return u;
}

static gn_lit_uniforms lit_uniforms_of(const scene_draw *d)
{
    const scene_light *light = &d->uniforms.light;
    const scene_surface *surface = &d->surface;
    gn_lit_uniforms u;

    memset(&u, 0, sizeof u);
    u.clip_from_model = light->clip_from_model;
    u.normal_matrix = light->normal_matrix;
    u.light = light_of(d);
    if (scene_draw_has_texture(d))
        u.material.diffuse_map = &d->uniforms.texture;
    u.material.sampler = d->uniforms.sampler;
    u.more_lights = surface->more_lights;
    u.more_light_count = surface->more_light_count;
    u.world_from_model = surface->world_from_model;
    u.eye = surface->eye;
    u.material.specular = d->specular;
    u.material.exponent = surface->exponent;
    u.material.bands = surface->bands;
    u.material.alpha_cutoff = surface->alpha_cutoff;
    u.material.normal_space = surface->normal_space;
    u.material.normal_map = map_of(d, SCENE_NORMAL_MAP);
    u.material.specular_map = map_of(d, SCENE_SPECULAR_MAP);
    u.material.glow_map = map_of(d, SCENE_GLOW_MAP);
    u.shadow = shadow_of(d);
    return u;
}

/* Uniforms that a scene stores in another form than the library: those of one shader. */
typedef struct other_uniforms {
    union {
        gn_color_uniforms color;
        gn_unlit_uniforms unlit;
        gn_depth_color_uniforms depth;
        gn_lit_uniforms lit;
        gn_metallic_roughness_uniforms metallic;
        phong_uniforms phong;
    };
    gn_vertex_shader *color_shader; /* with `color` */
} other_uniforms;

/* A vertex shader of colours whose points take their sizes from the texture coordinates. */
static void shade_sized_points(const void *uniforms, const gn_vertex_input *input,
                               gn_vertex_output *output)
{
    const other_uniforms *other = uniforms;

    other->color_shader(&other->color, input, output);
    memcpy(output->point_size, input->attribute[GN_ATTRIBUTE_TEXCOORD][0],
           GN_LANES * sizeof *output->point_size);
}

/* Makes a shader of vertex colours write point sizes, if the pipeline asks for them. */
static void use_sizes(gn_pipeline *pipeline, other_uniforms *other)
{
    if (pipeline->program.vertex_writes_point_size) {
        other->color_shader = pipeline->program.vertex_shader;
        pipeline->program.vertex_shader = shade_sized_points;
        pipeline->program.uniforms = other;
    }
}

/* A shader's uniforms, and the clip distances behind them. A pointer to this struct is also one to
 * the uniforms. */
typedef struct clipped_uniforms {
    union {
        other_uniforms other;
        gn_color_uniforms color;
        gn_unlit_uniforms unlit;
        gn_depth_color_uniforms depth;
        gn_lit_uniforms lit;
        gn_metallic_roughness_uniforms metallic;
        scene_uniforms sampled;
        phong_uniforms phong;
    } shader;
    gn_vertex_shader *shade;
    const scene_draw *draw;
} clipped_uniforms;

/* Runs the shader's vertex function and adds clip distances. */
static void shade_clipped(const void *uniforms, const gn_vertex_input *input,
                          gn_vertex_output *output)
{
    const clipped_uniforms *u = uniforms;
    const float(*position)[GN_LANES] = input->attribute[GN_ATTRIBUTE_POSITION];

    u->shade(&u->shader, input, output);
    for (uint32_t i = 0; i < u->draw->state.program.clip_distance_count; ++i) {
        const float *plane = u->draw->clip_plane[i];

        for (int l = 0; l < GN_LANES; ++l) {
            output->clip_distance[i][l] = ((plane[0] * position[0][l] + plane[1] * position[1][l]) +
                                           plane[2] * position[2][l]) +
                                          plane[3] * position[3][l];
        }
    }
}

static void use_clipped(gn_pipeline *pipeline, const scene_draw *d, clipped_uniforms *clipped)
{
    switch (d->shader) {
    case SCENE_VERTEX_COLOR:
    case SCENE_INPUTS:
    case SCENE_DERIVATIVES:
        if (pipeline->program.vertex_writes_point_size)
            clipped->shader.other = *(const other_uniforms *)pipeline->program.uniforms;
        else
            clipped->shader.color = *(const gn_color_uniforms *)pipeline->program.uniforms;
        break;
    case SCENE_SAMPLED:
        clipped->shader.sampled = *(const scene_uniforms *)pipeline->program.uniforms;
        break;
    case SCENE_UNLIT:
        clipped->shader.unlit = *(const gn_unlit_uniforms *)pipeline->program.uniforms;
        break;
    case SCENE_DEPTH_ONLY:
    case SCENE_OUTPUTS:
        clipped->shader.color = *(const gn_color_uniforms *)pipeline->program.uniforms;
        break;
    case SCENE_DEPTH_COLOR:
        clipped->shader.depth = *(const gn_depth_color_uniforms *)pipeline->program.uniforms;
        break;
    case SCENE_METALLIC_ROUGHNESS:
        clipped->shader.metallic =
            *(const gn_metallic_roughness_uniforms *)pipeline->program.uniforms;
        break;
    case SCENE_PHONG:
        clipped->shader.phong = *(const phong_uniforms *)pipeline->program.uniforms;
        break;
    default:
        clipped->shader.lit = *(const gn_lit_uniforms *)pipeline->program.uniforms;
        break;
    }
    clipped->shade = pipeline->program.vertex_shader;
    clipped->draw = d;
    pipeline->program.vertex_shader = shade_clipped;
    pipeline->program.uniforms = clipped;
}

/* The ready-made shaders that light or show a surface. */
static gn_status (*const use_lit[SCENE_SHADER_COUNT])(gn_pipeline *, const gn_lit_uniforms *) = {
    [SCENE_FLAT] = gn_use_gouraud,
    [SCENE_GOURAUD] = gn_use_gouraud,
    [SCENE_TEXTURED_GOURAUD] = gn_use_gouraud,
    [SCENE_FACES] = gn_use_flat,
    [SCENE_TOON] = gn_use_toon,
    [SCENE_MAPPED_PHONG] = gn_use_phong,
    [SCENE_BLINN_PHONG] = gn_use_blinn_phong,
    [SCENE_NORMAL_COLOR] = gn_use_normal_color,
};

/* Sets how the four channels of vertex colours are interpolated. */
static void interpolate_colors(gn_pipeline *pipeline, const scene_draw *d)
{
    for (int c = 0; c < 4; ++c) {
        pipeline->program.interpolation[c] = d->state.program.interpolation[c];
        pipeline->program.interpolated_at[c] = d->state.program.interpolated_at[c];
    }
}

/* Sets the draw's shader; the uniforms must outlive the draw call. */
static gn_status use_shader(gn_pipeline *pipeline, const scene_draw *d, gn_backend backend,
                            other_uniforms *other)
{
    gn_status status = GN_INVALID_ENUM;

    switch (d->shader) {
    case SCENE_VERTEX_COLOR:
        other->color.clip_from_model = d->uniforms.light.clip_from_model;
        status = gn_use_vertex_color(pipeline, &other->color);
        interpolate_colors(pipeline, d);
        use_sizes(pipeline, other);
        break;
    case SCENE_UNLIT:
        other->unlit.clip_from_model = d->uniforms.light.clip_from_model;
        other->unlit.map = scene_draw_has_texture(d) ? &d->uniforms.texture : NULL;
        other->unlit.sampler = d->uniforms.sampler;
        other->unlit.alpha_cutoff = d->surface.alpha_cutoff;
        status = gn_use_unlit(pipeline, &other->unlit);
        break;
    case SCENE_DEPTH_COLOR:
        other->depth.clip_from_model = d->uniforms.light.clip_from_model;
        other->depth.black = d->surface.black;
        other->depth.white = d->surface.white;
        status = gn_use_depth_color(pipeline, &other->depth);
        break;
    case SCENE_DEPTH_ONLY:
        other->color.clip_from_model = d->uniforms.light.clip_from_model;
        status = gn_use_depth_only(pipeline, &other->color);
        break;
    case SCENE_METALLIC_ROUGHNESS:
        other->metallic = metallic_uniforms_of(d);
        status = gn_use_metallic_roughness(pipeline, &other->metallic);
        break;
    case SCENE_PHONG:
        other->phong = phong_uniforms_of(d);
        status = d->phong_functions ? phong_use_functions(pipeline, &other->phong, backend)
                                    : phong_use(pipeline, &other->phong, backend);
        break;
    case SCENE_INPUTS:
        other->color.clip_from_model = d->uniforms.light.clip_from_model;
        status = inputs_use(pipeline, &other->color, backend);
        for (int c = 0; c < 4; ++c)
            pipeline->program.interpolated_at[c] = d->state.program.interpolated_at[0];
        use_sizes(pipeline, other);
        break;
    case SCENE_DERIVATIVES:
        other->color.clip_from_model = d->uniforms.light.clip_from_model;
        status = derivatives_use(pipeline, &other->color, backend);
        interpolate_colors(pipeline, d);
        use_sizes(pipeline, other);
        break;
    case SCENE_OUTPUTS:
        other->color.clip_from_model = d->uniforms.light.clip_from_model;
        status = outputs_use(pipeline, &other->color, backend);
        break;
    case SCENE_SAMPLED:
        status = sampled_use(pipeline, &d->uniforms, backend);
        break;
    default:
        other->lit = lit_uniforms_of(d);
        if (use_lit[d->shader])
            status = use_lit[d->shader](pipeline, &other->lit);
        for (int c = 0; d->shader == SCENE_FLAT && c < 4; ++c)
            pipeline->program.interpolation[c] = GN_FLAT;
        break;
    }
    return status;
}

/* The target of a shader that writes no colour. */
static gn_target depth_of(const gn_target *target)
{
    gn_target depth;

    memset(&depth, 0, sizeof depth);
    depth.depth = target->depth;
    return depth;
}

static gn_status draw_one(const gn_target *target, const scene_draw *d, gn_workspace *workspace)
{
    const gn_target depth = depth_of(target);
    uint64_t *const counter = workspace->samples_passed;
    gn_draw_statistics *const statistics = workspace->statistics;
    other_uniforms other;
    clipped_uniforms clipped;
    gn_pipeline pipeline = d->state;

    pipeline.program.vertex_writes_point_size &= scene_shader_has_sizes(d->shader);
    pipeline.program.color_count = d->shader == SCENE_OUTPUTS ? pipeline.program.color_count : 1;
    gn_status status = use_shader(&pipeline, d, workspace->backend, &other);

    if (status == GN_OK && pipeline.program.clip_distance_count > 0)
        use_clipped(&pipeline, d, &clipped);
    if (status == GN_OK) {
        workspace->samples_passed = d->counted ? counter : NULL;
        workspace->statistics = d->counted ? statistics : NULL;
        status = gn_draw(d->shader == SCENE_DEPTH_ONLY ? &depth : target, &pipeline, &d->mesh,
                         workspace);
        workspace->samples_passed = counter;
        workspace->statistics = statistics;
    }
    return status;
}

uint32_t scene_varyings(const scene *s)
{
    uint32_t distances = 0;

    for (size_t i = 0; i < s->draw_count; ++i) {
        const uint32_t count = s->draws[i].state.program.clip_distance_count;

        distances = count > distances ? count : distances;
    }
    return SCENE_VARYINGS + distances;
}

size_t scene_workspace_size(const scene *s)
{
    uint32_t vertices = 0;
    uint32_t triangles = 0;

    for (size_t i = 0; i < s->draw_count; ++i) {
        const gn_mesh *mesh = &s->draws[i].mesh;

        if (mesh->vertex_count > vertices)
            vertices = mesh->vertex_count;
        if (mesh->count > triangles)
            triangles = mesh->count; /* at most, for a strip */
    }
    return gn_workspace_size_parallel(vertices, triangles, scene_varyings(s));
}

/* The number of bands of rows that threads share a clear in. */
#define CLEAR_BANDS 32

typedef struct clear {
    const scene *scene;
    const gn_target *target;
    gn_status status[CLEAR_BANDS];
} clear;

static gn_status clear_rows(const clear *c, uint32_t first, uint32_t count)
{
    const scene *s = c->scene;
    const gn_surface depth = gn_surface_rows(&c->target->depth, first, count);
    gn_status status = GN_OK;

    for (int a = 0; status == GN_OK && a < GN_MAX_COLORS; ++a) {
        const gn_surface color = gn_surface_rows(&c->target->color[a], first, count);

        if (scene_color_format(s, a) != GN_FORMAT_NONE) {
            status = gn_clear_color(&color, s->clear_color[0], s->clear_color[1], s->clear_color[2],
                                    s->clear_color[3]);
        }
    }
    if (status == GN_OK && s->depth_format != GN_FORMAT_NONE)
        status = gn_clear_depth_stencil(&depth, s->clear_depth, s->clear_stencil);
    return status;
}

static void clear_band(void *context, uint32_t band)
{
    clear *c = context;
    const uint32_t height = c->scene->height;
    const uint32_t first = height * band / CLEAR_BANDS;

    c->status[band] = clear_rows(c, first, height * (band + 1) / CLEAR_BANDS - first);
}

static gn_status clear_target(const scene *s, const gn_target *target,
                              const gn_workspace *workspace)
{
    clear c = {s, target, {GN_OK}};

    if (!workspace->parallel || s->height < CLEAR_BANDS)
        return clear_rows(&c, 0, s->height);
    workspace->parallel(workspace->user, clear_band, &c, CLEAR_BANDS);
    for (int i = 1; i < CLEAR_BANDS && c.status[0] == GN_OK; ++i)
        c.status[0] = c.status[i];
    return c.status[0];
}

gn_status scene_draw_to_target(const scene *s, const gn_target *target, gn_workspace *workspace)
{
    gn_status status = clear_target(s, target, workspace);

    for (size_t i = 0; status == GN_OK && i < s->draw_count; ++i) {
        const scene cleared = scene_of_clear(s, &s->draws[i]);

        status = clear_target(&cleared, target, workspace);
        if (status == GN_OK)
            status = draw_one(target, &s->draws[i], workspace);
    }
    return status;
}

/* frame_image returns one image of a frame's memory, frame_surface the surface with all of the
 * scene's samples. */
static gn_surface frame_image(const scene *s, void *memory, gn_format format, uint32_t image)
{
    const size_t size = (size_t)s->width * s->height * gn_format_size(format);

    return gn_surface_bottom_up((char *)memory + size * image, format, s->width, s->height);
}

static gn_surface frame_surface(const scene *s, void *memory, gn_format format)
{
    const gn_surface first = frame_image(s, memory, format, 0);

    return scene_is_sampled(s) ? gn_surface_multisampled(&first) : first;
}

/* Resolves the drawn samples into the last image of the frame. */
static gn_status resolve_frame(const scene *s, const gn_target *target, const scene_frame *frame)
{
    gn_status status = GN_OK;

    for (int a = 0; status == GN_OK && a < GN_MAX_COLORS; ++a) {
        if (scene_color_format(s, a) != GN_FORMAT_NONE) {
            const gn_surface to =
                frame_image(s, scene_frame_color(frame, a), scene_color_format(s, a), GN_SAMPLES);

            status = gn_resolve(&to, &target->color[a]);
        }
    }
    if (frame->depth && status == GN_OK) {
        const gn_surface to = frame_image(s, frame->depth, s->depth_format, GN_SAMPLES);

        status = gn_resolve(&to, &target->depth);
    }
    return status;
}

gn_status scene_draw_in_workspace(const scene *s, scene_frame *frame, gn_workspace *workspace)
{
    uint64_t *const counter = workspace->samples_passed;
    gn_draw_statistics *const statistics = workspace->statistics;
    gn_target target;

    memset(&target, 0, sizeof target);
    frame->samples_passed = 0;
    memset(&frame->statistics, 0, sizeof frame->statistics);
    workspace->samples_passed = &frame->samples_passed;
    workspace->statistics = &frame->statistics;
    for (int a = 0; a < GN_MAX_COLORS; ++a) {
        if (scene_color_format(s, a) != GN_FORMAT_NONE) {
            target.color[a] =
                frame_surface(s, scene_frame_color(frame, a), scene_color_format(s, a));
        }
    }
    if (s->depth_format != GN_FORMAT_NONE)
        target.depth = frame_surface(s, frame->depth, s->depth_format);
    const gn_status status = scene_draw_to_target(s, &target, workspace);
    workspace->samples_passed = counter;
    workspace->statistics = statistics;
    return status == GN_OK && scene_is_sampled(s) ? resolve_frame(s, &target, frame) : status;
}

gn_status scene_draw_library(const scene *s, scene_frame *frame, size_t workspace_bytes,
                             gn_backend backend)
{
    gn_workspace workspace = {0};

    workspace.size = workspace_bytes ? workspace_bytes : scene_workspace_size(s);
    workspace.memory = scene_reallocate(NULL, workspace.size, 1);
    workspace.backend = backend;
    const gn_status status = scene_draw_in_workspace(s, frame, &workspace);
    free(workspace.memory);
    return status;
}
