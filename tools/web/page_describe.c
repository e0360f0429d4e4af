/* Describes the scene to another renderer, as JSON. */
#include "page_parts.h"
#include "page_text.h"

static text json;

/* Begins a member of an object. */
static void add_name(const char *name)
{
    if (text_of(&json)[json.length - 1] != '{')
        text_add(&json, ", ");
    text_add(&json, "\"");
    text_add(&json, name);
    text_add(&json, "\": ");
}

static void add_whole(const char *name, uint64_t value)
{
    add_name(name);
    text_add_whole(&json, value);
}

static void add_address(const char *name, const void *address)
{
    add_whole(name, (uint64_t)(uintptr_t)address);
}

static void add_float(const char *name, float value)
{
    add_name(name);
    text_add_float(&json, value);
}

static void add_floats(const char *name, const float *values, size_t count)
{
    add_name(name);
    for (size_t i = 0; i < count; ++i) {
        text_add(&json, i == 0 ? "[" : ",");
        text_add_float(&json, values[i]);
    }
    text_add(&json, "]");
}

static void add_vector(const char *name, gn_vec3 v)
{
    const float values[3] = {v.x, v.y, v.z};
    add_floats(name, values, 3);
}

static void add_word(const char *name, const char *word)
{
    add_name(name);
    text_add(&json, "\"");
    text_add(&json, word);
    text_add(&json, "\"");
}

static void add_truth(const char *name, bool value)
{
    add_name(name);
    text_add(&json, value ? "true" : "false");
}

static void begin_object(const char *name)
{
    add_name(name);
    text_add(&json, "{");
}

static void end_object(void)
{
    text_add(&json, "}");
}

static const char *shader_name(scene_shader shader)
{
    switch (shader) {
    case SCENE_VERTEX_COLOR:
        return "vertex-color";
    case SCENE_UNLIT:
        return "unlit";
    case SCENE_FACES:
        return "flat";
    case SCENE_TOON:
        return "toon";
    case SCENE_MAPPED_PHONG:
        return "phong";
    case SCENE_BLINN_PHONG:
        return "blinn-phong";
    case SCENE_NORMAL_COLOR:
        return "normals";
    case SCENE_DEPTH_COLOR:
        return "depth";
    default:
        return "gouraud";
    }
}

static void add_state(const scene_draw *d)
{
    static const char polygons[3][8] = {"fill", "line", "point"};
    static const char cull[3][8] = {"none", "back", "front"};
    add_word("shader", shader_name(d->shader));
    add_word("polygons", polygons[d->state.raster.polygon_mode_front]);
    add_word("cull", cull[d->state.raster.cull]);
    add_truth("frontClockwise", d->state.raster.front_face == GN_FRONT_CLOCKWISE);
    add_truth("depthTest", d->state.depth.test);
}

static void add_uniforms(const scene_draw *d)
{
    const scene_light *const light = &d->uniforms.light;
    const scene_surface *const surface = &d->surface;
    const bool is_default = surface->black == surface->white;
    add_floats("clipFromModel", &light->clip_from_model.m[0][0], 16);
    add_floats("worldFromModel", &surface->world_from_model.m[0][0], 16);
    add_floats("normalMatrix", &light->normal_matrix.m[0][0], 9);
    add_vector("eye", surface->eye);
    add_vector("lightDirection", light->light_direction);
    add_vector("specular", d->specular);
    add_whole("exponent", surface->exponent);
    add_whole("bands", surface->bands != 0 ? surface->bands : 4);
    add_truth("normalsOfTangents", surface->normal_space == GN_NORMAL_OF_TANGENTS);
    add_float("black", is_default ? 0.0f : surface->black);
    add_float("white", is_default ? 1.0f : surface->white);
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
    add_whole("vertices", mesh->vertex_count);
    begin_object("attributes");
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i) {
        const gn_attribute *const a = mesh->attribute + rows[i].attribute;
        if (a->data == NULL)
            continue;
        begin_object(rows[i].name);
        add_address("at", a->data);
        add_whole("components", a->components);
        end_object();
    }
    end_object();
    begin_object("indices");
    add_address("at", mesh->indices);
    add_whole("count", mesh->count);
    end_object();
}

static void add_map(const char *name, const gn_texture *map)
{
    begin_object(name);
    add_address("at", map->level[0].texels);
    add_whole("width", map->width);
    add_whole("height", map->height);
    add_whole("levels", scene_level_count(map));
    end_object();
}

static void add_maps(const scene_draw *d)
{
    static const char names[SCENE_MAP_COUNT][12] = {"normal", "specular", "glow", "shadow"};
    begin_object("maps");
    if (scene_draw_has_texture(d))
        add_map("diffuse", &d->uniforms.texture);
    for (int m = 0; m < SCENE_MAP_COUNT; ++m)
        if (scene_draw_has_map(d, (scene_map)m))
            add_map(names[m], &d->surface.map[m]);
    end_object();
}

static void add_draw(const scene_draw *d)
{
    static const char filters[3][8] = {"mipmap", "linear", "nearest"};
    text_add(&json, "{");
    add_state(d);
    add_uniforms(d);
    add_mesh(&d->mesh);
    add_maps(d);
    add_floats("shadowFromWorld", &d->surface.shadow_from_world.m[0][0], 16);
    add_word("filter", filters[page_settings_now()->options.filter]);
    text_add(&json, "}");
}

static void add_light(const scene_draw *d)
{
    begin_object("light");
    add_vector("direction", page_light());
    add_vector("ambient", d->uniforms.light.ambient);
    add_vector("diffuse", d->uniforms.light.diffuse);
    end_object();
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
    add_whole("contents", page_contents_version());
    add_whole("width", s->width);
    add_whole("height", s->height);
    add_whole("samples", s->samples);
    add_floats("clear", s->clear_color, 4);
    add_truth("zeroToOne", page_camera()->zero_to_one);
    add_truth("topDown", page_camera()->y_down);
    add_light(s->draws);
    add_name("draws");
    text_add(&json, "[");
    for (size_t i = 0; i < s->draw_count; ++i) {
        text_add(&json, i == 0 ? "\n" : ",\n");
        add_draw(s->draws + i);
    }
    text_add(&json, "]}");
    if (json.failed)
        page_fail("there is not enough memory", (const char *)NULL);
    return json.failed ? "" : text_of(&json);
}
