/* Describes the scene to another renderer, as JSON. */
#include "page_json.h"
#include "page_parts.h"
#include "shading.h"

static text json;

static void add_vector(const char *name, gn_vec3 v)
{
    const float values[3] = {v.x, v.y, v.z};
    page_json_floats(&json, name, values, 3);
}

static const char *shader_name(scene_shader shader)
{
    for (int i = SHADING_AUTOMATIC + 1; i < SHADING_COUNT; ++i)
        if (shading_traits_of((shading)i)->shader == shader)
            return shading_traits_of((shading)i)->name;
    return "gouraud"; /* with a texture */
}

static const char *topology_name(gn_topology topology)
{
    return topology == GN_POINTS ? "points" : topology == GN_LINES ? "lines" : "triangles";
}

static const char *blend_name(const gn_blend *blend)
{
    return !blend->enabled ? "none" : blend->source == GN_FACTOR_SOURCE_ALPHA ? "mix" : "cut";
}

static void add_state(const scene_draw *d)
{
    static const char polygons[3][8] = {"fill", "line", "point"};
    static const char cull[3][8] = {"none", "back", "front"};
    page_json_string(&json, "shader", shader_name(d->shader));
    page_json_string(&json, "topology", topology_name(d->state.raster.topology));
    page_json_string(&json, "polygons", polygons[d->state.raster.polygon_mode_front]);
    page_json_string(&json, "cull", cull[d->state.raster.cull]);
    page_json_truth(&json, "frontClockwise", d->state.raster.front_face == GN_FRONT_CLOCKWISE);
    page_json_truth(&json, "depthTest", d->state.depth.test_enabled);
    page_json_truth(&json, "depthWrite", !d->state.depth.write_disabled);
    page_json_string(&json, "blend", blend_name(d->state.color.blend));
    page_json_float(&json, "alphaCutoff",
                    scene_draw_has_cutoff(d) ? d->surface.alpha_cutoff : 0.0f);
}

static void add_uniforms(const scene_draw *d)
{
    const scene_light *const light = &d->uniforms.light;
    const scene_surface *const surface = &d->surface;
    const bool is_default = surface->black == surface->white;
    page_json_floats(&json, "clipFromModel", &light->clip_from_model.m[0][0], 16);
    page_json_floats(&json, "worldFromModel", &surface->world_from_model.m[0][0], 16);
    page_json_floats(&json, "normalMatrix", &light->normal_matrix.m[0][0], 9);
    add_vector("eye", surface->eye);
    add_vector("lightDirection", light->light_direction);
    add_vector("specular", d->specular);
    page_json_whole(&json, "exponent", surface->exponent);
    page_json_whole(&json, "bands", surface->bands != 0 ? surface->bands : 4);
    page_json_truth(&json, "normalsOfTangents", surface->normal_space == GN_NORMAL_OF_TANGENTS);
    page_json_float(&json, "black", is_default ? 0.0f : surface->black);
    page_json_float(&json, "white", is_default ? 1.0f : surface->white);
}

static void add_mesh(const gn_mesh *mesh)
{
    static const struct {
        gn_shader_attribute attribute;
        char name[12];
    } rows[] = {{GN_ATTRIBUTE_POSITION, "position"},
                {GN_ATTRIBUTE_NORMAL, "normal"},
                {GN_ATTRIBUTE_COLOR, "color"},
                {GN_ATTRIBUTE_TEXCOORD, "texcoord"},
                {GN_ATTRIBUTE_TANGENT, "tangent"}};
    page_json_whole(&json, "vertices", mesh->vertex_count);
    page_json_begin(&json, "attributes");
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i) {
        const gn_attribute *const a = mesh->attribute + rows[i].attribute;
        if (a->data == NULL)
            continue;
        page_json_begin(&json, rows[i].name);
        page_json_address(&json, "at", a->data);
        page_json_whole(&json, "components", a->components);
        page_json_end(&json);
    }
    page_json_end(&json);
    page_json_begin(&json, "indices");
    page_json_address(&json, "at", mesh->indices);
    page_json_whole(&json, "count", mesh->count);
    page_json_end(&json);
}

static void add_map(const char *name, const gn_texture *map)
{
    page_json_begin(&json, name);
    page_json_address(&json, "at", map->level[0].texels);
    page_json_whole(&json, "width", map->width);
    page_json_whole(&json, "height", map->height);
    page_json_whole(&json, "levels", scene_level_count(map));
    page_json_end(&json);
}

static void add_maps(const scene_draw *d)
{
    static const char names[SCENE_MAP_COUNT][12] = {"normal", "specular", "glow", "shadow"};
    page_json_begin(&json, "maps");
    if (scene_draw_has_texture(d))
        add_map("diffuse", &d->uniforms.texture);
    for (int m = 0; m < SCENE_MAP_COUNT; ++m)
        if (scene_draw_has_map(d, (scene_map)m))
            add_map(names[m], &d->surface.map[m]);
    page_json_end(&json);
}

static void add_sampler(const gn_sampler *sampler)
{
    static const char wraps[5][24] = {"repeat", "clamp-to-edge", "mirrored-repeat",
                                      "clamp-to-border", "mirror-clamp-to-edge"};
    static const char minify[6][24] = {"nearest-mipmap-linear",
                                       "nearest",
                                       "linear",
                                       "nearest-mipmap-nearest",
                                       "linear-mipmap-nearest",
                                       "linear-mipmap-linear"};
    page_json_begin(&json, "sampler");
    page_json_string(&json, "wrapS", wraps[sampler->wrap_s]);
    page_json_string(&json, "wrapT", wraps[sampler->wrap_t]);
    page_json_string(&json, "minify", minify[sampler->minify]);
    page_json_string(&json, "magnify",
                     sampler->magnify == GN_MAGNIFY_NEAREST ? "nearest" : "linear");
    page_json_end(&json);
}

static void add_draw(const scene_draw *d, uint32_t number)
{
    text_add(&json, "{");
    page_json_whole(&json, "mesh", number);
    add_state(d);
    add_uniforms(d);
    add_mesh(&d->mesh);
    add_maps(d);
    page_json_floats(&json, "shadowFromWorld", &d->surface.shadow_from_world.m[0][0], 16);
    add_sampler(&d->uniforms.sampler);
    text_add(&json, "}");
}

static void add_light(const scene_draw *d)
{
    page_json_begin(&json, "light");
    add_vector("direction", page_light());
    add_vector("ambient", d->uniforms.light.ambient);
    add_vector("diffuse", d->uniforms.light.diffuse);
    page_json_end(&json);
}

const char *page_describe(void)
{
    const scene *const s = page_built();
    text_clear(&json);
    page_begin();
    if (s == NULL) {
        page_fail("there is no scene to describe: page_build comes first", (const char *)NULL);
        return "";
    }
    text_add(&json, "{");
    page_json_whole(&json, "contents", page_contents_version());
    page_json_whole(&json, "width", s->width);
    page_json_whole(&json, "height", s->height);
    page_json_whole(&json, "samples", s->samples);
    page_json_floats(&json, "clear", s->clear_color, 4);
    page_json_truth(&json, "zeroToOne", page_camera()->zero_to_one);
    page_json_truth(&json, "topDown", page_camera()->y_down);
    add_light(s->draws);
    page_json_name(&json, "draws");
    text_add(&json, "[");
    for (size_t i = 0; i < s->draw_count; ++i) {
        text_add(&json, i == 0 ? "\n" : ",\n");
        add_draw(s->draws + i, page_mesh_of_draw(i));
    }
    text_add(&json, "]}");
    if (json.failed)
        page_fail("there is not enough memory", (const char *)NULL);
    return json.failed ? "" : text_of(&json);
}
