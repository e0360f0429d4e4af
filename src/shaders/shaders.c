/* The ready-made shaders as functions, and the functions that select them for a pipeline. */
#include "../config/features.h"
#include "../formats/properties.h"
#include "../scalars/bits.h"

#include "../kernel/shaders/metallic_roughness.inl"
#include "../kernel/shaders/unlit.inl"

/* In the form of the back end that every processor of the target has. A single vertex or fragment
 * is shaded over one lane, if the library has that form. */
#define VERTEX_SHADER(name)                                                                        \
    void gni_##name(const void *uniforms, const gn_vertex_input *input, gn_vertex_output *output)  \
    {                                                                                              \
        if (GN_HAVE_ONE_LANE && input->count == 1)                                                 \
            gni_one_lane_##name(uniforms, input, output);                                          \
        else                                                                                       \
            name(uniforms, input, output);                                                         \
    }

#define FRAGMENT_SHADER(name)                                                                      \
    void gni_##name(const void *uniforms, const gn_fragment_input *input,                          \
                    gn_fragment_output *output)                                                    \
    {                                                                                              \
        if (GN_HAVE_ONE_LANE && input->count == 1)                                                 \
            gni_one_lane_##name(uniforms, input, output);                                          \
        else                                                                                       \
            name(uniforms, input, output);                                                         \
    }

GN_VERTEX_SHADERS(VERTEX_SHADER)
GN_FRAGMENT_SHADERS(FRAGMENT_SHADER)

/* Returns the number of varyings of shaders whose colour is followed by texture coordinates if
 * there is a map. */
static uint32_t mapped_varyings(const gn_texture *map)
{
    return map ? MAPPED_VARYINGS : COLOR_VARYINGS;
}

/* Returns the number of varyings of shaders that light fragments. */
static uint32_t surface_varyings(const gn_material *material)
{
    return has_tangents(material) ? TANGENT_VARYINGS : SURFACE_VARYINGS;
}

/* Returns the number of varyings of gn_use_metallic_roughness. */
static uint32_t metallic_varyings(const gn_metallic_roughness *material)
{
    return material->normal_map.texture ? TANGENT_VARYINGS : SURFACE_VARYINGS;
}

static bool map_needs_quads(const gn_texture *map, const gn_sampler *sampler)
{
    return map && gn_lookup_needs_quads(map, sampler);
}

/* Each of these functions is the gn_needs_quads of some ready-made programs. */
static bool color_needs_quads(const gn_program *p)
{
    return p->vertex_shader != gni_shade_vertex_color || p->fragment_shader != gni_shade_color;
}

static bool depth_needs_quads(const gn_program *p)
{
    return p->vertex_shader != gni_shade_vertex_position || p->fragment_shader != 0;
}

static bool depth_color_needs_quads(const gn_program *p)
{
    return p->vertex_shader != gni_shade_vertex_position ||
           p->fragment_shader != gni_shade_depth_color;
}

static bool unlit_needs_quads(const gn_program *p)
{
    const gn_unlit_uniforms *const u = (const gn_unlit_uniforms *)p->uniforms;

    return p->vertex_shader != gni_shade_vertex_unlit ||
           p->fragment_shader != gni_shade_unlit_texture || map_needs_quads(u->map, &u->sampler);
}

static bool gouraud_needs_quads(const gn_program *p)
{
    const gn_material *const m = &((const gn_lit_uniforms *)p->uniforms)->material;

    return p->vertex_shader != gni_shade_vertex_lit ||
           p->fragment_shader != gni_shade_lit_texture ||
           map_needs_quads(m->diffuse_map, &m->sampler);
}

/* Returns whether maps of a surface or its shadow need neighbours, or the vertex shader is none of
 * a surface. */
static bool surface_needs_quads(const gn_program *p)
{
    const gn_lit_uniforms *const u = (const gn_lit_uniforms *)p->uniforms;
    const gn_material *const m = &u->material;

    return p->vertex_shader != gni_shade_vertex_surface ||
           map_needs_quads(m->diffuse_map, &m->sampler) ||
           map_needs_quads(m->normal_map, &m->sampler) ||
           map_needs_quads(m->specular_map, &m->sampler) ||
           map_needs_quads(m->glow_map, &m->sampler) ||
           map_needs_quads(u->shadow.map, &u->shadow.sampler);
}

static bool toon_needs_quads(const gn_program *p)
{
    return p->fragment_shader != gni_shade_toon || surface_needs_quads(p);
}

static bool phong_needs_quads(const gn_program *p)
{
    return p->fragment_shader != gni_shade_phong || surface_needs_quads(p);
}

static bool blinn_phong_needs_quads(const gn_program *p)
{
    return p->fragment_shader != gni_shade_blinn_phong || surface_needs_quads(p);
}

static bool normal_color_needs_quads(const gn_program *p)
{
    return p->fragment_shader != gni_shade_normal_color || surface_needs_quads(p);
}

static bool metallic_needs_quads(const gn_program *p)
{
    const gn_metallic_roughness_uniforms *const u =
        (const gn_metallic_roughness_uniforms *)p->uniforms;
    const gn_metallic_roughness *const m = &u->material;
    const gn_map *const map[5] = {&m->base_color_map, &m->metallic_roughness_map, &m->normal_map,
                                  &m->occlusion_map, &m->emissive_map};
    bool needs = p->vertex_shader != gni_shade_vertex_metallic ||
                 p->fragment_shader != gni_shade_metallic_roughness ||
                 map_needs_quads(u->shadow.map, &u->shadow.sampler);

    for (int i = 0; i < 5; ++i)
        needs = needs || map_needs_quads(map[i]->texture, &map[i]->sampler);
    return needs;
}

/* Sets a pipeline's shaders. `cutoff` is the alpha below which the fragment shader discards. */
static gn_status use(gn_pipeline *pipeline, const void *uniforms, gn_vertex_shader *vertex,
                     gn_fragment_shader *fragment, gn_needs_quads *needs_quads,
                     uint32_t varying_count, float cutoff)
{
    if (!pipeline || !uniforms)
        return GN_NULL_POINTER;
    pipeline->program.vertex_shader = vertex;
    pipeline->program.fragment_shader = fragment;
    pipeline->program.uniforms = uniforms;
    pipeline->program.needs_quads = GN_HAVE_ONE_LANE ? needs_quads : 0;
    pipeline->program.varying_count = varying_count;
    pipeline->program.fragment_discards = cutoff > 0.0f;
    for (uint32_t n = 0; n < varying_count; ++n) {
        pipeline->program.interpolation[n] = GN_SMOOTH;
        pipeline->program.interpolated_at[n] = GN_AT_CENTER;
    }
    return GN_OK;
}

gn_status gn_use_vertex_color(gn_pipeline *pipeline, const gn_color_uniforms *uniforms)
{
    return use(pipeline, uniforms, gni_shade_vertex_color, gni_shade_color, color_needs_quads,
               COLOR_VARYINGS, 0.0f);
}

gn_status gn_use_depth_only(gn_pipeline *pipeline, const gn_color_uniforms *uniforms)
{
    return use(pipeline, uniforms, gni_shade_vertex_position, 0, depth_needs_quads, 0, 0.0f);
}

/* Returns the first fault of a map. Precondition: the map is not null. */
static gn_status check_map(const gn_texture *map)
{
    const gn_status status = gn_texture_check(map);

    return status || map->target == GN_TEXTURE_2D ? status : GN_INVALID_ENUM;
}

static gn_status check_cutoff(float cutoff)
{
    if (!is_finite(cutoff))
        return GN_NOT_FINITE;
    return cutoff < 0.0f ? GN_OUT_OF_RANGE : GN_OK;
}

gn_status gn_use_unlit(gn_pipeline *pipeline, const gn_unlit_uniforms *uniforms)
{
    gn_status status = GN_OK;

    if (!pipeline || !uniforms)
        return GN_NULL_POINTER;
    if (uniforms->map) {
        status = check_map(uniforms->map);
        if (!status)
            status = gn_sampler_check(&uniforms->sampler);
    }
    if (!status)
        status = check_cutoff(uniforms->alpha_cutoff);
    if (status)
        return status;
    return use(pipeline, uniforms, gni_shade_vertex_unlit, gni_shade_unlit_texture,
               unlit_needs_quads, mapped_varyings(uniforms->map), uniforms->alpha_cutoff);
}

static gn_status check_material(const gn_material *material)
{
    const gn_texture *const map[4] = {material->diffuse_map, material->normal_map,
                                      material->specular_map, material->glow_map};
    gn_status status = GN_OK;
    bool any = false;

    for (int i = 0; i < 4 && !status; ++i) {
        any = any || map[i];
        if (map[i])
            status = check_map(map[i]);
    }
    if (any && !status)
        status = gn_sampler_check(&material->sampler);
    if (status)
        return status;
    if ((unsigned)material->normal_space > GN_NORMAL_OF_TANGENTS)
        return GN_INVALID_ENUM;
    if (material->bands == 1 || material->bands > 256)
        return GN_OUT_OF_RANGE;
    return check_cutoff(material->alpha_cutoff);
}

static gn_status check_shadow(const gn_shadow *shadow)
{
    gn_status status;

    if (!shadow->map)
        return GN_OK;
    if (!GN_HAVE_TEXTURES)
        return GN_NOT_COMPILED;
    status = check_map(shadow->map);
    if (!status && !format_has_depth(shadow->map->format))
        status = GN_INVALID_FORMAT;
    if (!status)
        status = gn_sampler_check(&shadow->sampler);
    if (!status && shadow->sampler.compare == GN_COMPARE_DEFAULT)
        status = GN_INVALID_ENUM;
    return status;
}

static gn_status check_lights(const gn_light *light, const gn_light *more, uint32_t more_count)
{
    if (!GN_HAVE_POINT_LIGHTS)
        return light->kind != GN_LIGHT_DIRECTIONAL || more_count > 0 ? GN_NOT_COMPILED : GN_OK;
    if (more_count > GN_MAX_LIGHTS - 1)
        return GN_OUT_OF_RANGE;
    if (more_count > 0 && !more)
        return GN_NULL_POINTER;
    if ((unsigned)light->kind > GN_LIGHT_SPOT)
        return GN_INVALID_ENUM;
    for (uint32_t i = 0; i < more_count; ++i)
        if ((unsigned)more[i].kind > GN_LIGHT_SPOT)
            return GN_INVALID_ENUM;
    return GN_OK;
}

gn_status gn_lit_uniforms_check(const gn_lit_uniforms *uniforms)
{
    gn_status status;

    if (!uniforms)
        return GN_NULL_POINTER;
    status = check_lights(&uniforms->light, uniforms->more_lights, uniforms->more_light_count);
    if (!status)
        status = check_material(&uniforms->material);
    return status ? status : check_shadow(&uniforms->shadow);
}

static gn_status use_lit(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms,
                         gn_vertex_shader *vertex, gn_fragment_shader *fragment,
                         gn_needs_quads *needs_quads, uint32_t varying_count)
{
    const gn_status status = pipeline ? gn_lit_uniforms_check(uniforms) : GN_NULL_POINTER;

    if (status)
        return status;
    return use(pipeline, uniforms, vertex, fragment, needs_quads, varying_count,
               fragment == gni_shade_normal_color ? 0.0f : uniforms->material.alpha_cutoff);
}

gn_status gn_use_gouraud(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms)
{
    return use_lit(pipeline, uniforms, gni_shade_vertex_lit, gni_shade_lit_texture,
                   gouraud_needs_quads,
                   uniforms ? mapped_varyings(uniforms->material.diffuse_map) : 0);
}

/* Selects a shader that lights fragments. */
static gn_status use_surface(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms,
                             gn_fragment_shader *fragment, gn_needs_quads *needs_quads)
{
    return use_lit(pipeline, uniforms, gni_shade_vertex_surface, fragment, needs_quads,
                   uniforms ? surface_varyings(&uniforms->material) : 0);
}

gn_status gn_use_flat(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms)
{
    if (GN_LANES == 1) { /* no derivatives */
        const gn_status status = pipeline ? gn_lit_uniforms_check(uniforms) : GN_NULL_POINTER;

        return status ? status : GN_NOT_COMPILED;
    }
    return use_surface(pipeline, uniforms, gni_shade_flat, 0);
}

gn_status gn_use_toon(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms)
{
    return use_surface(pipeline, uniforms, gni_shade_toon, toon_needs_quads);
}

gn_status gn_use_phong(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms)
{
    return use_surface(pipeline, uniforms, gni_shade_phong, phong_needs_quads);
}

gn_status gn_use_blinn_phong(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms)
{
    return use_surface(pipeline, uniforms, gni_shade_blinn_phong, blinn_phong_needs_quads);
}

/* Checks a factor, which must be from 0 to 1. */
static gn_status check_factor(float factor)
{
    if (!is_finite(factor))
        return GN_NOT_FINITE;
    return factor < 0.0f || factor > 1.0f ? GN_OUT_OF_RANGE : GN_OK;
}

static gn_status check_metallic_roughness(const gn_metallic_roughness *material)
{
    const gn_map *const map[5] = {&material->base_color_map, &material->metallic_roughness_map,
                                  &material->normal_map, &material->occlusion_map,
                                  &material->emissive_map};
    const float factor[3] = {material->metallic, material->roughness, material->occlusion_strength};
    gn_status status = GN_OK;

    for (int i = 0; i < 5 && !status; ++i) {
        if (map[i]->texture)
            status = check_map(map[i]->texture);
        if (map[i]->texture && !status)
            status = gn_sampler_check(&map[i]->sampler);
    }
    for (int i = 0; i < 3 && !status; ++i)
        status = check_factor(factor[i]);
    if (!status)
        status = check_cutoff(material->alpha_cutoff);
    if (status)
        return status;
    return is_finite(material->normal_scale) && is_finite(material->emissive.x) &&
                   is_finite(material->emissive.y) && is_finite(material->emissive.z)
               ? GN_OK
               : GN_NOT_FINITE;
}

gn_status gn_use_metallic_roughness(gn_pipeline *pipeline,
                                    const gn_metallic_roughness_uniforms *uniforms)
{
    gn_status status;

    if (!pipeline || !uniforms)
        return GN_NULL_POINTER;
    status = check_lights(&uniforms->light, uniforms->more_lights, uniforms->more_light_count);
    if (!status)
        status = check_metallic_roughness(&uniforms->material);
    if (!status)
        status = check_shadow(&uniforms->shadow);
    if (status)
        return status;
    return use(pipeline, uniforms, gni_shade_vertex_metallic, gni_shade_metallic_roughness,
               metallic_needs_quads, metallic_varyings(&uniforms->material),
               uniforms->material.alpha_cutoff);
}

gn_status gn_use_normal_color(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms)
{
    return use_surface(pipeline, uniforms, gni_shade_normal_color, normal_color_needs_quads);
}

gn_status gn_use_depth_color(gn_pipeline *pipeline, const gn_depth_color_uniforms *uniforms)
{
    if (!pipeline || !uniforms)
        return GN_NULL_POINTER;
    if (!is_finite(uniforms->black) || !is_finite(uniforms->white))
        return GN_NOT_FINITE;
    if (uniforms->black == uniforms->white && uniforms->black != 0.0f)
        return GN_OUT_OF_RANGE;
    pipeline->program.fragment_reads_position = true;
    return use(pipeline, uniforms, gni_shade_vertex_position, gni_shade_depth_color,
               depth_color_needs_quads, 0, 0.0f);
}

static bool lights_fragments(gn_fragment_shader *shader)
{
    return shader == gni_shade_flat || shader == gni_shade_toon || shader == gni_shade_phong ||
           shader == gni_shade_blinn_phong || shader == gni_shade_normal_color;
}

static uint32_t greater_count(uint32_t a, uint32_t b)
{
    return a > b ? a : b;
}

/* Returns how many varyings ready-made shaders of the pipeline write and read; 0 for others. */
static uint32_t needed_varyings(const gn_program *p)
{
    const gn_lit_uniforms *const lit = (const gn_lit_uniforms *)p->uniforms;
    uint32_t count = 0;

    if (p->vertex_shader == gni_shade_vertex_color || p->fragment_shader == gni_shade_color)
        count = COLOR_VARYINGS;
    if (p->vertex_shader == gni_shade_vertex_unlit || p->fragment_shader == gni_shade_unlit_texture)
        count =
            greater_count(count, mapped_varyings(((const gn_unlit_uniforms *)p->uniforms)->map));
    if (p->vertex_shader == gni_shade_vertex_lit || p->fragment_shader == gni_shade_lit_texture)
        count = greater_count(count, mapped_varyings(lit->material.diffuse_map));
    if (p->vertex_shader == gni_shade_vertex_surface || lights_fragments(p->fragment_shader))
        count = greater_count(count, surface_varyings(&lit->material));
    if (p->vertex_shader == gni_shade_vertex_metallic ||
        p->fragment_shader == gni_shade_metallic_roughness)
        count = greater_count(
            count,
            metallic_varyings(&((const gn_metallic_roughness_uniforms *)p->uniforms)->material));
    return count;
}

/* Returns whether a shader of the pipeline is a ready-made one that reads uniforms. */
static bool reads_uniforms(const gn_pipeline *p)
{
    return p->program.vertex_shader == gni_shade_vertex_position ||
           p->program.vertex_shader == gni_shade_vertex_color ||
           p->program.vertex_shader == gni_shade_vertex_unlit ||
           p->program.vertex_shader == gni_shade_vertex_lit ||
           p->program.vertex_shader == gni_shade_vertex_surface ||
           p->program.vertex_shader == gni_shade_vertex_metallic ||
           p->program.fragment_shader == gni_shade_metallic_roughness ||
           p->program.fragment_shader == gni_shade_unlit_texture ||
           p->program.fragment_shader == gni_shade_lit_texture ||
           p->program.fragment_shader == gni_shade_depth_color ||
           lights_fragments(p->program.fragment_shader);
}

ready_made_fault gni_find_ready_made_fault(const gn_pipeline *pipeline)
{
    if (!pipeline->program.uniforms && reads_uniforms(pipeline))
        return GN_READY_MADE_NO_UNIFORMS;
    if (pipeline->program.fragment_shader == gni_shade_depth_color &&
        !pipeline->program.fragment_reads_position)
        return GN_READY_MADE_NO_POSITION;
    if (pipeline->program.varying_count < needed_varyings(&pipeline->program))
        return GN_READY_MADE_FEW_VARYINGS;
    return GN_READY_MADE_OK;
}
