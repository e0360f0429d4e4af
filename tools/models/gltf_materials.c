/* Materials, textures and images of a glTF (sections 3.8 and 3.9). */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "gltf.h"

/* The exponent of Blinn and Phong whose highlight is as wide as that of the microfacets' GGX
 * distribution: 2 / a^2 - 2, where a is the square of the roughness (Karis, "Specular BRDF
 * Reference", 2013). */
static uint32_t exponent_of(double roughness)
{
    const double a = roughness * roughness;
    const double exponent = a > 0.0 ? 2.0 / (a * a) - 2.0 : MODEL_MAX_EXPONENT;
    if (!(exponent > 1.0))
        return 1;
    return exponent < MODEL_MAX_EXPONENT ? (uint32_t)(exponent + 0.5) : MODEL_MAX_EXPONENT;
}

static double clamp(double value)
{
    return value > 0.0 ? value < 1.0 ? value : 1.0 : 0.0;
}

/* Section 3.8.4: the numbers are those of OpenGL. */
static bool read_wrap(gltf *g, uint32_t sampler, const char *name, gn_wrap *wrap)
{
    uint64_t value = 10497;
    if (!gltf_integer(g, sampler, name, UINT32_MAX, &value))
        return false;
    if (value == 33071)
        *wrap = GN_WRAP_CLAMP_TO_EDGE;
    else if (value == 33648)
        *wrap = GN_WRAP_MIRRORED_REPEAT;
    else if (value != 10497)
        reader_warn(g->r, gltf_path(g, sampler), "%s is %llu, which is none; it repeats", name,
                    (unsigned long long)value);
    return true;
}

static bool read_sampler(gltf *g, uint32_t sampler, model_map *map)
{
    static const struct {
        uint32_t value;
        gn_minify minify;
    } filters[] = {{9728, GN_MINIFY_NEAREST},
                   {9729, GN_MINIFY_LINEAR},
                   {9984, GN_MINIFY_NEAREST_MIPMAP_NEAREST},
                   {9985, GN_MINIFY_LINEAR_MIPMAP_NEAREST},
                   {9986, GN_MINIFY_NEAREST_MIPMAP_LINEAR},
                   {9987, GN_MINIFY_LINEAR_MIPMAP_LINEAR}};
    uint64_t minify = 0, magnify = 0;
    if (!read_wrap(g, sampler, "wrapS", &map->wrap_s) ||
        !read_wrap(g, sampler, "wrapT", &map->wrap_t) ||
        !gltf_integer(g, sampler, "minFilter", UINT32_MAX, &minify) ||
        !gltf_integer(g, sampler, "magFilter", UINT32_MAX, &magnify))
        return false;
    /* If the file names one filter only, the other one is of its kind. */
    map->has_filters = minify != 0 || magnify != 0;
    map->magnify = magnify == 9728 || (magnify == 0 && (minify == 9728 || minify == 9984))
                       ? GN_MAGNIFY_NEAREST
                       : GN_MAGNIFY_LINEAR;
    map->minify = magnify == 9728 ? GN_MINIFY_NEAREST : GN_MINIFY_LINEAR_MIPMAP_LINEAR;
    for (size_t i = 0; i < sizeof filters / sizeof filters[0]; ++i)
        if (filters[i].value == minify)
            map->minify = filters[i].minify;
    return true;
}

/* What an image inside the model is called. */
static const char *image_name(gltf *g, uint32_t index, char *buffer, size_t size)
{
    const uint32_t name = json_member(&g->j, gltf_element(g, GLTF_IMAGES, index), "name");
    if (json_kind_of(&g->j, name) == JSON_STRING && !json_is(&g->j, name, ""))
        return json_copy(&g->j, name, buffer, size);
    snprintf(buffer, size, "image %u", (unsigned)index);
    return buffer;
}

static bool read_image_uri(gltf *g, uint32_t index, uint32_t uri)
{
    char name[128];
    size_t size = 0;
    if (gltf_is_data_uri(g, uri)) {
        uint8_t *const bytes = gltf_data_uri(g, uri, &size);
        if (bytes == NULL)
            return false;
        g->images[index] =
            reader_image_inside(g->r, image_name(g, index, name, sizeof name), bytes, size);
        reader_release(g->r, bytes, size, 1);
    } else {
        char *const file = gltf_file_name(g, uri, &size);
        if (file == NULL)
            return false;
        g->images[index] = reader_image(g->r, file);
        reader_release(g->r, file, size, 1);
    }
    return g->images[index] != MODEL_NO_IMAGE;
}

/* Section 3.8.3: an image has a URI, or it is in a view of a buffer. */
static bool read_image(gltf *g, uint32_t index, uint32_t *image)
{
    const uint32_t token = gltf_element(g, GLTF_IMAGES, index);
    const uint32_t uri = json_member(&g->j, token, "uri");
    uint32_t view = GLTF_NONE;
    if (g->images[index] != GLTF_NONE) {
        *image = g->images[index];
        return true;
    }
    if (uri != JSON_NONE) {
        if (!read_image_uri(g, index, uri))
            return false;
    } else {
        char name[128];
        const uint8_t *bytes;
        size_t size, stride;
        if (!gltf_index(g, token, "bufferView", GLTF_BUFFER_VIEWS, &view))
            return false;
        if (view == GLTF_NONE)
            return reader_fail_at(g->r, gltf_path(g, token), "has neither uri nor bufferView");
        if (!gltf_view(g, view, &bytes, &size, &stride))
            return false;
        g->images[index] =
            reader_image_inside(g->r, image_name(g, index, name, sizeof name), bytes, size);
    }
    *image = g->images[index];
    return *image != MODEL_NO_IMAGE;
}

/* The transform of texture coordinates of KHR_texture_transform: u' = T R S u about the origin. A
 * positive angle turns counter-clockwise where v grows downward, as the extension's example needs:
 * offset (0, 1), a quarter turn and scale 0.5 show the lower left quarter of the image. */
static bool read_transform(gltf *g, uint32_t info, uint64_t *set, double transform[6])
{
    const uint32_t extension = gltf_extension(g, info, "KHR_texture_transform");
    double offset[2] = {0.0, 0.0}, scale[2] = {1.0, 1.0}, rotation = 0.0;
    if (!gltf_integer(g, info, "texCoord", UINT32_MAX, set) ||
        !gltf_integer(g, extension, "texCoord", UINT32_MAX, set) ||
        !gltf_numbers(g, extension, "offset", 2, offset) ||
        !gltf_numbers(g, extension, "scale", 2, scale) ||
        !gltf_number(g, extension, "rotation", &rotation))
        return false;
    const double c = cos(rotation), s = sin(rotation);
    transform[0] = c * scale[0];
    transform[1] = s * scale[1];
    transform[2] = offset[0];
    transform[3] = -s * scale[0];
    transform[4] = c * scale[1];
    transform[5] = offset[1];
    return true;
}

/* The map of a texture. It stays empty if no image of the texture can be read. */
static bool read_texture(gltf *g, uint32_t index, model_map *map)
{
    const uint32_t token = gltf_element(g, GLTF_TEXTURES, index);
    uint32_t sampler = GLTF_NONE, image = GLTF_NONE;
    if (!gltf_index(g, token, "sampler", GLTF_SAMPLERS, &sampler) ||
        !gltf_index(g, token, "source", GLTF_IMAGES, &image))
        return false;
    if (image == GLTF_NONE) {
        const uint32_t other = json_first(&g->j, json_member(&g->j, token, "extensions"));
        char name[64];
        if (other != JSON_NONE)
            reader_warn(g->r, gltf_path(g, token), "its image is only in %s, which is not read",
                        json_copy(&g->j, json_name(&g->j, other), name, sizeof name));
        else
            reader_warn(g->r, gltf_path(g, token), "the texture has no image");
        return true;
    }
    return read_image(g, image, &map->image) &&
           (sampler == GLTF_NONE || read_sampler(g, gltf_element(g, GLTF_SAMPLERS, sampler), map));
}

static bool is_same(const double a[6], const double b[6])
{
    bool same = true;
    for (int i = 0; i < 6; ++i)
        same = same && a[i] == b[i];
    return same;
}

/* Reads the texture that a member of an object names. All maps of a material have the texture
 * coordinates of the first one that is read; others are left out. */
static bool read_map(gltf *g, uint32_t object, const char *name, map_kind kind, gltf_material *m)
{
    uint32_t info, texture = GLTF_NONE;
    uint64_t set = 0;
    double transform[6], strength = 1.0;
    model_map map = model_map_of(MODEL_NO_IMAGE);
    if (!gltf_container(g, object, name, JSON_OBJECT, &info))
        return false;
    if (info == JSON_NONE)
        return true;
    if (!gltf_index(g, info, "index", GLTF_TEXTURES, &texture) ||
        !read_transform(g, info, &set, transform) ||
        (kind == MAP_NORMAL && !gltf_number(g, info, "scale", &strength)) ||
        (kind == MAP_OCCLUSION && !gltf_number(g, info, "strength", &strength)))
        return false;
    if (texture == GLTF_NONE)
        return reader_fail_at(g->r, gltf_path(g, info), "names no texture");
    if (m->has_maps && (set != m->texcoord || !is_same(transform, m->transform))) {
        reader_warn(g->r, gltf_path(g, info),
                    "%s has texture coordinates other than the material's first map; it is not "
                    "drawn",
                    name);
        return true;
    }
    map.strength = (float)strength;
    map.has_opacity = kind == MAP_DIFFUSE;
    if (!read_texture(g, texture, &map))
        return false;
    if (map.image == MODEL_NO_IMAGE)
        return true;
    m->maps[kind] = map;
    m->has_maps = true;
    m->texcoord = (uint32_t)set;
    memcpy(m->transform, transform, sizeof transform);
    return true;
}

static bool read_color(gltf *g, uint32_t object, const char *name, uint32_t count, float *color)
{
    double values[4];
    for (uint32_t c = 0; c < count; ++c)
        values[c] = (double)color[c];
    if (!gltf_numbers(g, object, name, count, values))
        return false;
    for (uint32_t c = 0; c < count; ++c)
        color[c] = (float)values[c];
    return true;
}

/* Section 3.9.2. The highlights are for shaders that know nothing of microfacets: weaker the
 * rougher the surface is, from the strength of the highlights of a model without materials. */
static bool read_metallic_roughness(gltf *g, uint32_t token, gltf_material *m)
{
    uint32_t pbr;
    double metallic = 1.0, roughness = 1.0;
    if (!gltf_container(g, token, "pbrMetallicRoughness", JSON_OBJECT, &pbr) ||
        !read_color(g, pbr, "baseColorFactor", 4, m->color) ||
        !gltf_number(g, pbr, "metallicFactor", &metallic) ||
        !gltf_number(g, pbr, "roughnessFactor", &roughness) ||
        !read_map(g, pbr, "baseColorTexture", MAP_DIFFUSE, m) ||
        !read_map(g, pbr, "metallicRoughnessTexture", MAP_ROUGHNESS, m))
        return false;
    roughness = clamp(roughness);
    m->surface.is_metallic_roughness = 1;
    m->surface.metallic = (float)clamp(metallic);
    m->surface.roughness = (float)roughness;
    m->surface.shine.exponent = exponent_of(roughness);
    for (int c = 0; c < 3; ++c)
        m->surface.shine.specular[c] = (float)(0.25 * (1.0 - roughness));
    return true;
}

/* KHR_materials_pbrSpecularGlossiness: glossiness is 1 - roughness. */
static bool read_specular_glossiness(gltf *g, uint32_t extension, gltf_material *m)
{
    double glossiness = 1.0;
    for (int c = 0; c < 3; ++c)
        m->surface.shine.specular[c] = 1.0f;
    if (!read_color(g, extension, "diffuseFactor", 4, m->color) ||
        !read_color(g, extension, "specularFactor", 3, m->surface.shine.specular) ||
        !gltf_number(g, extension, "glossinessFactor", &glossiness) ||
        !read_map(g, extension, "diffuseTexture", MAP_DIFFUSE, m) ||
        !read_map(g, extension, "specularGlossinessTexture", MAP_SPECULAR, m))
        return false;
    if (m->maps[MAP_SPECULAR].image != MODEL_NO_IMAGE)
        reader_warn(g->r, gltf_path(g, extension),
                    "the glossiness in the alpha of specularGlossinessTexture is not drawn");
    m->surface.shine.exponent = exponent_of(1.0 - clamp(glossiness));
    return true;
}

static bool read_alpha(gltf *g, uint32_t token, model_surface *s)
{
    const uint32_t mode = json_member(&g->j, token, "alphaMode");
    double cutoff = 0.5;
    if (json_is(&g->j, mode, "MASK"))
        s->alpha = MODEL_MASK;
    else if (json_is(&g->j, mode, "BLEND"))
        s->alpha = MODEL_BLEND;
    else if (mode != JSON_NONE && !json_is(&g->j, mode, "OPAQUE"))
        return reader_fail_at(g->r, gltf_path(g, mode), "is none of OPAQUE, MASK and BLEND");
    if (!gltf_number(g, token, "alphaCutoff", &cutoff))
        return false;
    s->alpha_cutoff = (float)cutoff;
    return true;
}

/* emissiveFactor (section 3.9.3) times the strength of KHR_materials_emissive_strength. */
static bool read_emissive(gltf *g, uint32_t token, model_surface *s)
{
    double strength = 1.0;
    if (!read_color(g, token, "emissiveFactor", 3, s->emissive) ||
        !gltf_number(g, gltf_extension(g, token, "KHR_materials_emissive_strength"),
                     "emissiveStrength", &strength))
        return false;
    for (int c = 0; c < 3; ++c) {
        const double product = (double)s->emissive[c] * strength;
        s->emissive[c] = product < (double)FLT_MAX ? (float)product : FLT_MAX;
    }
    return true;
}

static bool read_members(gltf *g, uint32_t token, gltf_material *m)
{
    const uint32_t classic = gltf_extension(g, token, "KHR_materials_pbrSpecularGlossiness");
    bool is_double_sided = false;
    m->surface.is_unlit = gltf_extension(g, token, "KHR_materials_unlit") != JSON_NONE;
    if (classic != JSON_NONE ? !read_specular_glossiness(g, classic, m)
                             : !read_metallic_roughness(g, token, m))
        return false;
    if (!read_alpha(g, token, &m->surface) || !read_emissive(g, token, &m->surface) ||
        !gltf_boolean(g, token, "doubleSided", &is_double_sided))
        return false;
    m->surface.is_double_sided = is_double_sided;
    m->surface.culls_back = !is_double_sided;
    return read_map(g, token, "normalTexture", MAP_NORMAL, m) &&
           read_map(g, token, "emissiveTexture", MAP_GLOW, m) &&
           read_map(g, token, "occlusionTexture", MAP_OCCLUSION, m);
}

bool gltf_read_material(gltf *g, uint32_t index, const gltf_material **material)
{
    static const double no_transform[6] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0};
    gltf_material *const m = g->materials + index;
    const bool is_default = index >= g->tables[GLTF_MATERIALS].count;
    *material = m;
    if (m->is_read)
        return true;
    m->is_read = true;
    m->surface = model_surface_default();
    m->surface.has_linear_colors = 1;
    m->surface.culls_back = 1;
    m->first_group = GLTF_NONE;
    memcpy(m->transform, no_transform, sizeof no_transform);
    for (int c = 0; c < 4; ++c)
        m->color[c] = 1.0f;
    for (int i = 0; i < MAP_COUNT; ++i)
        m->maps[i] = model_map_of(MODEL_NO_IMAGE);
    g->r->result->material_count += !is_default;
    return read_members(g, is_default ? JSON_NONE : gltf_element(g, GLTF_MATERIALS, index), m);
}
