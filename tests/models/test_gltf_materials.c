/* glTF: materials, textures and images. Sections are those of the glTF 2.0 specification. */
#include "gltf_test.h"

/* A triangle with texture coordinates 0 (0, 0), (1, 0), (0, 1) and 1 (0.25, 0.5), ... */
static const float second_texcoords[6] = {0.25f, 0.5f, 0.5f, 0.5f, 0.25f, 0.75f};
static const float first_texcoords[6] = {0, 0, 1, 0, 0, 1};

static void begin(void)
{
    gltf_begin_triangle();
    GLTF_ARRAY("VEC2", T_F32, 3, first_texcoords);
    GLTF_ARRAY("VEC2", T_F32, 3, second_texcoords);
}

#define MESH                                                                                       \
    GLTF_MESH("'material':0,'attributes':{'POSITION':0,'NORMAL':1,'TEXCOORD_0':2,'TEXCOORD_1':3}")

#define TEXTURES(textures) "'images':[{'uri':'a.png'},{'uri':'c.png'}],'textures':[" textures "],"
#define TWO_TEXTURES TEXTURES("{'source':0},{'source':1}")

/* Reads a file with a material of these members, which gives this warning; null: none. */
static const model_part *material(const char *members, const char *rest, const char *warning)
{
    static char text[4096];
    snprintf(text, sizeof text, "'materials':[{%s}],%s" MESH, members, rest);
    expect_read(gltf_read(text), warning);
    return read_model.parts;
}

static void test_metallic_roughness(void **state)
{
    const float color[4] = {0.25f, 0.5f, 0.75f, 1}; /* opaque: alpha has no meaning */
    const float emissive[3] = {2, 1, 4};
    begin();
    const model_part *p =
        material("'pbrMetallicRoughness':{'baseColorFactor':[0.25,0.5,0.75,0.5],"
                 "'metallicFactor':0.25,'roughnessFactor':0.5},'emissiveFactor':[0.5,0.25,1],"
                 "'extensions':{'KHR_materials_emissive_strength':{'emissiveStrength':4}},"
                 "'doubleSided':true",
                 "", NULL);
    expect_floats(p->colors, color, 4);
    expect_floats(p->surface.emissive, emissive, 3);
    assert_true(p->surface.is_metallic_roughness && p->surface.is_double_sided);
    assert_true(p->surface.metallic == 0.25f && p->surface.roughness == 0.5f);
    /* For Blinn and Phong: 2 / 0.5^4 - 2, and a quarter times 1 - 0.5. */
    assert_int_equal(p->surface.shine.exponent, 30);
    assert_float_equal(p->surface.shine.specular[1], 0.125f, 1e-6f);
    assert_int_equal(p->surface.alpha, MODEL_OPAQUE);
    assert_int_equal(read_model.material_count, 1);
    assert_true(p->has_texcoords && p->has_tangents);
    p = material("'pbrMetallicRoughness':{'roughnessFactor':0}", "", NULL);
    assert_int_equal(p->surface.shine.exponent, MODEL_MAX_EXPONENT);
    p = material("", "", NULL);
    assert_int_equal(p->surface.shine.exponent, 1);
    assert_false(p->surface.is_unlit || p->surface.is_double_sided);
}

/* Section 3.7.2.1: COLOR_0 is multiplied; without a fourth component alpha is 1. */
static void test_vertex_colors(void **state)
{
    static const float three[9] = {1, 0.5f, 0, 1, 0.5f, 0, 1, 0.5f, 0};
    static const float four[12] = {1, 0.5f, 0, 0.5f, 1, 0.5f, 0, 0.5f, 1, 0.5f, 0, 0.5f};
    const float opaque[4] = {0.5f, 0.25f, 0, 0.5f}, clear[4] = {0.5f, 0.25f, 0, 0.25f};
    begin();
    GLTF_ARRAY("VEC3", T_F32, 3, three);
    GLTF_ARRAY("VEC4", T_F32, 3, four);
    for (int i = 4; i < 6; ++i) {
        char text[512];
        snprintf(text, sizeof text,
                 "'materials':[{'alphaMode':'BLEND','pbrMetallicRoughness':{'baseColorFactor':"
                 "[0.5,0.5,0.5,0.5]}}]," GLTF_MESH(
                     "'material':0,'attributes':{'POSITION':0,'COLOR_0':%d}"),
                 i);
        const model_part *const p = gltf_part(text);
        expect_floats(p->colors, i == 4 ? opaque : clear, 4);
        assert_true(p->has_vertex_colors);
        assert_int_equal(p->surface.alpha, MODEL_BLEND);
    }
    assert_true(gltf_part(GLTF_ATTRIBUTES(",'COLOR_0':5"))->colors[3] == 1.0f);
}

static void test_alpha_and_unlit(void **state)
{
    const float red[4] = {1, 0, 0, 1};
    begin();
    const model_part *p = material("'alphaMode':'MASK'", "", NULL);
    assert_int_equal(p->surface.alpha, MODEL_MASK);
    assert_true(p->surface.alpha_cutoff == 0.5f);
    p = material("'alphaMode':'MASK','alphaCutoff':0.25,'pbrMetallicRoughness':{"
                 "'baseColorFactor':[1,1,1,0.125]}",
                 "", NULL);
    assert_true(p->surface.alpha_cutoff == 0.25f && p->colors[3] == 0.125f);
    p = material("'pbrMetallicRoughness':{'baseColorFactor':[1,0,0,1]},"
                 "'extensions':{'KHR_materials_unlit':{}}",
                 "'extensionsUsed':['KHR_materials_unlit'],", NULL);
    expect_floats(p->colors, red, 4);
    assert_true(p->surface.is_unlit);
}

static void test_specular_glossiness(void **state)
{
    const float red[4] = {1, 0, 0, 1}, specular[3] = {0.5f, 0.25f, 0};
    begin();
    const model_part *const p = material(
        "'pbrMetallicRoughness':{'baseColorFactor':[0,0,1,1]},'extensions':{"
        "'KHR_materials_pbrSpecularGlossiness':{'diffuseFactor':[1,0,0,1],'specularFactor':[0.5,"
        "0.25,0],'glossinessFactor':0.5,'diffuseTexture':{'index':0},"
        "'specularGlossinessTexture':{'index':1}}}",
        TWO_TEXTURES,
        "a.gltf: /materials/0/extensions/KHR_materials_pbrSpecularGlossiness: the glossiness in "
        "the alpha of specularGlossinessTexture is not drawn (1)");
    expect_floats(p->colors, red, 4);
    expect_floats(p->surface.shine.specular, specular, 3);
    assert_int_equal(p->surface.shine.exponent, 30);
    assert_false(p->surface.is_metallic_roughness);
    assert_int_equal(p->maps[MAP_DIFFUSE].image, 0);
    assert_int_equal(p->maps[MAP_SPECULAR].image, 1);
    assert_int_equal(p->maps[MAP_ROUGHNESS].image, MODEL_NO_IMAGE);
    assert_string_equal(read_model.images[0].name, "a.png");
    assert_string_equal(read_model.images[1].name, "c.png");
}

static void test_maps(void **state)
{
    static const uint32_t images[MAP_COUNT] = {[MAP_DIFFUSE] = 0,
                                               [MAP_GLOW] = 0,
                                               [MAP_ROUGHNESS] = 1,
                                               [MAP_NORMAL] = 1,
                                               [MAP_OCCLUSION] = 1,
                                               [MAP_OPACITY] = MODEL_NO_IMAGE,
                                               [MAP_SPECULAR] = MODEL_NO_IMAGE};
    const float texcoords[6] = {0, 1, 1, 1, 0, 0}; /* v grows downward, t upward */
    const float tangent[4] = {1, 0, 0, -1};        /* x, and the bitangent is -y = -(z cross x) */
    begin();
    const model_part *const p =
        material("'pbrMetallicRoughness':{'baseColorTexture':{'index':0},"
                 "'metallicRoughnessTexture':{'index':1}},"
                 "'normalTexture':{'index':1,'scale':0.5},"
                 "'occlusionTexture':{'index':1,'strength':0.25},'emissiveTexture':{'index':0}",
                 TWO_TEXTURES, NULL);
    assert_int_equal(read_model.image_count, 2);
    for (int i = 0; i < MAP_COUNT; ++i)
        assert_int_equal(p->maps[i].image, images[i]);
    assert_true(p->maps[MAP_NORMAL].strength == 0.5f);
    assert_true(p->maps[MAP_OCCLUSION].strength == 0.25f);
    expect_floats(p->texcoords, texcoords, 6);
    expect_floats(p->tangents, tangent, 4);
}

/* The emission's map under a sampler of these members. */
static const model_map *sampled(const char *sampler, const char *warning)
{
    char text[512];
    snprintf(text, sizeof text, TEXTURES("{'source':0,'sampler':0}") "'samplers':[{%s}],", sampler);
    return material("'emissiveTexture':{'index':0}", text, warning)->maps + MAP_GLOW;
}

static void test_samplers(void **state)
{
    static const struct {
        int code;
        gn_minify minify;
    } cases[] = {{9728, GN_MINIFY_NEAREST},
                 {9729, GN_MINIFY_LINEAR},
                 {9984, GN_MINIFY_NEAREST_MIPMAP_NEAREST},
                 {9985, GN_MINIFY_LINEAR_MIPMAP_NEAREST},
                 {9986, GN_MINIFY_NEAREST_MIPMAP_LINEAR},
                 {9987, GN_MINIFY_LINEAR_MIPMAP_LINEAR}};
    begin();
    for (int i = 0; i < 12; ++i) {
        char text[64];
        snprintf(text, sizeof text, "'wrapS':10497,'minFilter':%d,'magFilter':%d",
                 cases[i / 2].code, 9728 + i % 2);
        const model_map *const map = sampled(text, NULL);
        assert_true(map->wrap_s == GN_WRAP_REPEAT && map->wrap_t == GN_WRAP_REPEAT);
        assert_true(map->has_filters);
        assert_int_equal(map->minify, cases[i / 2].minify);
        assert_int_equal(map->magnify, i % 2 ? GN_MAGNIFY_LINEAR : GN_MAGNIFY_NEAREST);
    }
    const model_map *map = sampled("'wrapS':33071,'wrapT':33648", NULL);
    assert_true(map->wrap_s == GN_WRAP_CLAMP_TO_EDGE && map->wrap_t == GN_WRAP_MIRRORED_REPEAT);
    assert_false(map->has_filters);
    map = sampled("'wrapT':1", "a.gltf: /samplers/0: wrapT is 1, which is none; it repeats (1)");
    assert_true(map->wrap_s == GN_WRAP_REPEAT && map->wrap_t == GN_WRAP_REPEAT);
}

/* KHR_texture_transform: u' = T R S u. The results are u and 1 - v. */
static void test_texture_transform(void **state)
{
    static const struct {
        const char *transform;
        float texcoords[6];
    } cases[] = {
        {"'offset':[0.5,0.25]", {0.5f, 0.75f, 1.5f, 0.75f, 0.5f, -0.25f}},
        {"'scale':[2,0.5]", {0, 1, 2, 1, 0, 0.5f}},
        /* The extension's example: the lower left quarter of the image, so u in 0 to 0.5 and v in
         * 0.5 to 1. */
        {"'offset':[0,1],'rotation':1.57079632679489662,'scale':[0.5,0.5]",
         {0, 0, 0, 0.5f, 0.5f, 0}},
        /* First scaled, then turned: (1, 0) to (2, 0) to (0, -2); (0, 1) to (0, 3) to (3, 0). */
        {"'rotation':1.57079632679489662,'scale':[2,3]", {0, 1, 0, 3, 3, 1}},
        {"'texCoord':1", {0.25f, 0.5f, 0.5f, 0.5f, 0.25f, 0.25f}}};
    begin();
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        char text[512];
        snprintf(text, sizeof text,
                 "'pbrMetallicRoughness':{'baseColorTexture':{'index':0,'extensions':{"
                 "'KHR_texture_transform':{%s}}}}",
                 cases[i].transform);
        expect_floats(material(text, TEXTURES("{'source':0}"), NULL)->texcoords, cases[i].texcoords,
                      6);
    }
}

/* One set of texture coordinates is kept: that of the first map. */
static void test_sets_of_texcoords(void **state)
{
    static const float expected[6] = {0.25f, 0.5f, 0.5f, 0.5f, 0.25f, 0.25f};
    static const char warning[] =
        "a.gltf: /materials/0/normalTexture: normalTexture has texture coordinates other than the "
        "material's first map; it is not drawn (1)";
    begin();
    const model_part *p =
        material("'pbrMetallicRoughness':{'baseColorTexture':{'index':0,'texCoord':1}},"
                 "'normalTexture':{'index':1},'emissiveTexture':{'index':0,'texCoord':1}",
                 TWO_TEXTURES, warning);
    expect_floats(p->texcoords, expected, 6);
    assert_int_equal(p->maps[MAP_DIFFUSE].image, 0);
    assert_int_equal(p->maps[MAP_GLOW].image, 0);
    assert_int_equal(p->maps[MAP_NORMAL].image, MODEL_NO_IMAGE);
    /* The same set, but transformed. */
    p = material("'pbrMetallicRoughness':{'baseColorTexture':{'index':0}},'normalTexture':{'index':"
                 "1,'extensions':{'KHR_texture_transform':{'scale':[2,2]}}}",
                 TWO_TEXTURES, warning);
    assert_int_equal(p->maps[MAP_NORMAL].image, MODEL_NO_IMAGE);
    p = material("'pbrMetallicRoughness':{'baseColorTexture':{'index':0,'texCoord':2}}",
                 TEXTURES("{'source':0}"),
                 "a.gltf: /meshes/0/primitives/0/attributes: there is no TEXCOORD_2, so that the "
                 "maps of the material are not drawn (1)");
    assert_false(p->has_texcoords);
    assert_int_equal(p->maps[MAP_DIFFUSE].image, MODEL_NO_IMAGE);
}

static void test_images(void **state)
{
    char text[512];
    begin();
    snprintf(text, sizeof text,
             "'images':[{'bufferView':%u,'mimeType':'image/png','name':'wood'},"
             "{'uri':'data:image/png;base64,AQID'}],'textures':[{'source':0},{'source':1}],",
             gltf_view("PNG!", 4));
    const model_part *p =
        material("'normalTexture':{'index':0},'emissiveTexture':{'index':1}", text, NULL);
    const model_image *const normal = read_model.images + p->maps[MAP_NORMAL].image;
    const model_image *const glow = read_model.images + p->maps[MAP_GLOW].image;
    assert_int_equal(read_model.image_count, 2);
    assert_string_equal(normal->name, "wood");
    assert_int_equal(normal->size, 4);
    assert_memory_equal(normal->bytes, "PNG!", 4);
    assert_string_equal(glow->name, "image 1");
    assert_int_equal(glow->size, 3);
    assert_memory_equal(glow->bytes, "\1\2\3", 3);
    /* The fallback of EXT_texture_webp is an ordinary image. */
    p = material("'emissiveTexture':{'index':0}",
                 "'extensionsUsed':['EXT_texture_webp']," TEXTURES(
                     "{'source':0,'extensions':{'EXT_texture_webp':{'source':1}}}"),
                 "a.gltf: /extensionsUsed/0: the extension EXT_texture_webp is not drawn (1)");
    assert_int_equal(p->maps[MAP_GLOW].image, 0);
    assert_string_equal(read_model.images[0].name, "a.png");
    p = material("'emissiveTexture':{'index':0}",
                 TEXTURES("{'extensions':{'KHR_texture_basisu':{'source':1}}}"),
                 "a.gltf: /textures/0: its image is only in KHR_texture_basisu, which is not read "
                 "(1)");
    assert_int_equal(p->maps[MAP_GLOW].image, MODEL_NO_IMAGE);
    material("'emissiveTexture':{'index':0}", TEXTURES("{}"),
             "a.gltf: /textures/0: the texture has no image (1)");
}

static void test_material_faults(void **state)
{
    static const struct {
        const char *members, *rest, *fault;
    } cases[] = {
        {"'alphaMode':'FOO'", "", "alphaMode: is none of OPAQUE, MASK and BLEND"},
        {"'pbrMetallicRoughness':{'baseColorFactor':[1,1,1]}", "",
         "pbrMetallicRoughness/baseColorFactor: is no array of 4 numbers"},
        {"'pbrMetallicRoughness':{'metallicFactor':'1'}", "",
         "pbrMetallicRoughness/metallicFactor: is no number that fits"},
        {"'pbrMetallicRoughness':[]", "", "pbrMetallicRoughness: is no object"},
        {"'doubleSided':1", "", "doubleSided: is neither true nor false"},
        {"'emissiveFactor':[1e39,0,0]", "", "emissiveFactor/0: is no number that fits"},
        {"'normalTexture':{'index':3}", "", "normalTexture/index: is 3, but there are 0 textures"},
        {"'normalTexture':{}", "", "normalTexture: names no texture"},
        {"'normalTexture':{'index':0}", "'images':[{}],'textures':[{'source':0}],",
         "/images/0: has neither uri nor bufferView"},
        {"'normalTexture':{'index':0}", "'images':[{'bufferView':99}],'textures':[{'source':0}],",
         "/images/0/bufferView: is 99, but there are 4 bufferViews"}};
    begin();
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        char text[1024], fault[256];
        snprintf(text, sizeof text, "'materials':[{%s}],%s" MESH, cases[i].members, cases[i].rest);
        snprintf(fault, sizeof fault, "%s%s", cases[i].fault[0] == '/' ? "" : "/materials/0/",
                 cases[i].fault);
        gltf_refuse(text, fault);
    }
    gltf_refuse(GLTF_MESH("'material':0,'attributes':{'POSITION':0}"),
                "/meshes/0/primitives/0/material: is 0, but there are 0 materials");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_metallic_roughness),
        cmocka_unit_test(test_vertex_colors),
        cmocka_unit_test(test_alpha_and_unlit),
        cmocka_unit_test(test_specular_glossiness),
        cmocka_unit_test(test_maps),
        cmocka_unit_test(test_samplers),
        cmocka_unit_test(test_texture_transform),
        cmocka_unit_test(test_sets_of_texcoords),
        cmocka_unit_test(test_images),
        cmocka_unit_test(test_material_faults),
    };
    return cmocka_run_group_tests(tests, NULL, forget_last_model);
}
