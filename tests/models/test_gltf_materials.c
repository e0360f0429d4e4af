/* glTF: materials, textures and images. Sections are those of the glTF 2.0 specification. */
#include "gltf_test.h"

#include <math.h>

#define IMAGES "'images':[{'uri':'a.png'},{'uri':'c.png'}],"

/* A triangle with texture coordinates 0 (0, 0), (1, 0), (0, 1) and 1 (0.25, 0.5), ... */
static const float second_texcoords[6] = {0.25f, 0.5f, 0.5f, 0.5f, 0.25f, 0.75f};
static const float first_texcoords[6] = {0, 0, 1, 0, 0, 1};

static void begin(void)
{
    gltf_begin_triangle();
    gltf_array("VEC2", T_F32, 3, first_texcoords, sizeof first_texcoords);
    gltf_array("VEC2", T_F32, 3, second_texcoords, sizeof second_texcoords);
}

#define MESH                                                                                       \
    GLTF_MESH("'material':0,'attributes':{'POSITION':0,'NORMAL':1,'TEXCOORD_0':2,'TEXCOORD_1':3}")

/* Reads a file with a material of these members. */
static const model_part *material(const char *members, const char *rest)
{
    static char text[4096];
    snprintf(text, sizeof text, "'materials':[{%s}],%s" MESH, members, rest);
    return gltf_part(text);
}

static void assert_material_fault(const char *members, const char *rest, const char *fault)
{
    static char text[4096];
    snprintf(text, sizeof text, "'materials':[{%s}],%s" MESH, members, rest);
    assert_false(gltf_read(text));
    gltf_assert_fault(fault);
}

static void test_metallic_roughness(void **state)
{
    (void)state;
    begin();
    const model_part *p =
        material("'pbrMetallicRoughness':{'baseColorFactor':[0.25,0.5,0.75,0.5],"
                 "'metallicFactor':0.25,'roughnessFactor':0.5},'emissiveFactor':[0.5,0.25,1],"
                 "'extensions':{'KHR_materials_emissive_strength':{'emissiveStrength':4}},"
                 "'doubleSided':true",
                 "");
    const float color[4] = {0.25f, 0.5f, 0.75f, 1}; /* opaque: alpha has no meaning */
    const float emissive[3] = {2, 1, 4};
    gltf_assert_floats(p->colors, color, 4);
    gltf_assert_floats(p->surface.emissive, emissive, 3);
    assert_true(p->surface.is_metallic_roughness && p->surface.is_double_sided);
    assert_true(p->surface.metallic == 0.25f && p->surface.roughness == 0.5f);
    /* For Blinn and Phong: 2 / 0.5^4 - 2, and a quarter times 1 - 0.5. */
    assert_int_equal(p->surface.shine.exponent, 30);
    assert_float_equal(p->surface.shine.specular[1], 0.125f, 1e-6f);
    assert_int_equal(p->surface.alpha, MODEL_OPAQUE);
    assert_int_equal(read_model.material_count, 1);
    assert_true(p->has_texcoords && p->has_tangents);
    p = material("'pbrMetallicRoughness':{'roughnessFactor':0}", "");
    assert_int_equal(p->surface.shine.exponent, MODEL_MAX_EXPONENT);
    p = material("", "");
    assert_int_equal(p->surface.shine.exponent, 1);
    assert_false(p->surface.is_unlit || p->surface.is_double_sided);
}

/* Section 3.7.2.1: COLOR_0 is multiplied; without a fourth component alpha is 1. */
static void test_vertex_colors(void **state)
{
    static const float three[9] = {1, 0.5f, 0, 1, 0.5f, 0, 1, 0.5f, 0};
    static const float four[12] = {1, 0.5f, 0, 0.5f, 1, 0.5f, 0, 0.5f, 1, 0.5f, 0, 0.5f};
    static const char blended[] =
        "'materials':[{'alphaMode':'BLEND','pbrMetallicRoughness':{'baseColorFactor':[0.5,0.5,0.5,"
        "0.5]}}],";
    char text[1024];
    (void)state;
    begin();
    gltf_array("VEC3", T_F32, 3, three, sizeof three);
    gltf_array("VEC4", T_F32, 3, four, sizeof four);
    snprintf(text, sizeof text, "%s%s", blended,
             GLTF_MESH("'material':0,'attributes':{'POSITION':0,'COLOR_0':4}"));
    const model_part *p = gltf_part(text);
    const float opaque[4] = {0.5f, 0.25f, 0, 0.5f}, clear[4] = {0.5f, 0.25f, 0, 0.25f};
    gltf_assert_floats(p->colors, opaque, 4);
    assert_true(p->has_vertex_colors);
    snprintf(text, sizeof text, "%s%s", blended,
             GLTF_MESH("'material':0,'attributes':{'POSITION':0,'COLOR_0':5}"));
    p = gltf_part(text);
    gltf_assert_floats(p->colors, clear, 4);
    assert_int_equal(p->surface.alpha, MODEL_BLEND);
    p = gltf_part(GLTF_MESH("'attributes':{'POSITION':0,'COLOR_0':5}"));
    assert_true(p->colors[3] == 1.0f);
}

static void test_alpha(void **state)
{
    (void)state;
    begin();
    const model_part *p = material("'alphaMode':'MASK'", "");
    assert_int_equal(p->surface.alpha, MODEL_MASK);
    assert_true(p->surface.alpha_cutoff == 0.5f);
    p = material("'alphaMode':'MASK','alphaCutoff':0.25,'pbrMetallicRoughness':{"
                 "'baseColorFactor':[1,1,1,0.125]}",
                 "");
    assert_true(p->surface.alpha_cutoff == 0.25f && p->colors[3] == 0.125f);
    assert_material_fault("'alphaMode':'FOO'", "",
                          "/materials/0/alphaMode: is none of OPAQUE, MASK and BLEND");
}

static void test_unlit(void **state)
{
    (void)state;
    begin();
    const model_part *const p = material("'pbrMetallicRoughness':{'baseColorFactor':[1,0,0,1]},"
                                         "'extensions':{'KHR_materials_unlit':{}}",
                                         "'extensionsUsed':['KHR_materials_unlit'],");
    const float red[4] = {1, 0, 0, 1};
    gltf_assert_floats(p->colors, red, 4);
    assert_true(p->surface.is_unlit);
    assert_int_equal(read_messages.warning_count, 0);
}

static void test_specular_glossiness(void **state)
{
    (void)state;
    begin();
    const model_part *const p = material(
        "'pbrMetallicRoughness':{'baseColorFactor':[0,0,1,1]},'extensions':{"
        "'KHR_materials_pbrSpecularGlossiness':{'diffuseFactor':[1,0,0,1],'specularFactor':[0.5,"
        "0.25,0],'glossinessFactor':0.5,'diffuseTexture':{'index':0},"
        "'specularGlossinessTexture':{'index':1}}}",
        IMAGES "'textures':[{'source':0},{'source':1}],");
    const float red[4] = {1, 0, 0, 1}, specular[3] = {0.5f, 0.25f, 0};
    gltf_assert_floats(p->colors, red, 4);
    gltf_assert_floats(p->surface.shine.specular, specular, 3);
    assert_int_equal(p->surface.shine.exponent, 30);
    assert_false(p->surface.is_metallic_roughness);
    assert_int_equal(p->maps[MAP_DIFFUSE].image, 0);
    assert_int_equal(p->maps[MAP_SPECULAR].image, 1);
    assert_int_equal(p->maps[MAP_ROUGHNESS].image, MODEL_NO_IMAGE);
    assert_string_equal(read_model.images[0].name, "a.png");
    assert_string_equal(read_model.images[1].name, "c.png");
    assert_true(has_warning("a.gltf: /materials/0/extensions/KHR_materials_pbrSpecularGlossiness: "
                            "the glossiness in the alpha of specularGlossinessTexture is not drawn "
                            "(1)"));
}

static void test_maps(void **state)
{
    (void)state;
    begin();
    const model_part *const p =
        material("'pbrMetallicRoughness':{'baseColorTexture':{'index':0},"
                 "'metallicRoughnessTexture':{'index':1}},"
                 "'normalTexture':{'index':1,'scale':0.5},"
                 "'occlusionTexture':{'index':1,'strength':0.25},'emissiveTexture':{'index':0}",
                 IMAGES "'textures':[{'source':0},{'source':1}],");
    assert_int_equal(read_messages.warning_count, 0);
    assert_int_equal(read_model.image_count, 2);
    assert_int_equal(p->maps[MAP_DIFFUSE].image, 0);
    assert_int_equal(p->maps[MAP_GLOW].image, 0);
    assert_int_equal(p->maps[MAP_ROUGHNESS].image, 1);
    assert_int_equal(p->maps[MAP_NORMAL].image, 1);
    assert_true(p->maps[MAP_NORMAL].strength == 0.5f);
    assert_int_equal(p->maps[MAP_OCCLUSION].image, 1);
    assert_true(p->maps[MAP_OCCLUSION].strength == 0.25f);
    assert_int_equal(p->maps[MAP_OPACITY].image, MODEL_NO_IMAGE);
    assert_false(p->maps[MAP_DIFFUSE].has_filters);
    assert_int_equal(p->maps[MAP_DIFFUSE].wrap_s, GN_WRAP_REPEAT);
    /* v grows downward, t upward. */
    const float texcoords[6] = {0, 1, 1, 1, 0, 0};
    gltf_assert_floats(p->texcoords, texcoords, 6);
    /* t grows against y: the tangent is x, and the bitangent -y = -(z cross x). */
    const float tangent[4] = {1, 0, 0, -1};
    gltf_assert_floats(p->tangents, tangent, 4);
}

static void test_samplers(void **state)
{
    static const struct {
        const char *sampler;
        gn_wrap wrap_s, wrap_t;
        bool has_filters;
        gn_minify minify;
        gn_magnify magnify;
    } cases[] = {{"{}", GN_WRAP_REPEAT, GN_WRAP_REPEAT, false, GN_MINIFY_LINEAR_MIPMAP_LINEAR,
                  GN_MAGNIFY_LINEAR},
                 {"{'wrapS':33071,'wrapT':33648}", GN_WRAP_CLAMP_TO_EDGE, GN_WRAP_MIRRORED_REPEAT,
                  false, GN_MINIFY_LINEAR_MIPMAP_LINEAR, GN_MAGNIFY_LINEAR},
                 {"{'wrapS':10497,'minFilter':9728,'magFilter':9729}", GN_WRAP_REPEAT,
                  GN_WRAP_REPEAT, true, GN_MINIFY_NEAREST, GN_MAGNIFY_LINEAR},
                 {"{'minFilter':9729,'magFilter':9728}", GN_WRAP_REPEAT, GN_WRAP_REPEAT, true,
                  GN_MINIFY_LINEAR, GN_MAGNIFY_NEAREST},
                 {"{'minFilter':9984,'magFilter':9728}", GN_WRAP_REPEAT, GN_WRAP_REPEAT, true,
                  GN_MINIFY_NEAREST_MIPMAP_NEAREST, GN_MAGNIFY_NEAREST},
                 {"{'minFilter':9985,'magFilter':9728}", GN_WRAP_REPEAT, GN_WRAP_REPEAT, true,
                  GN_MINIFY_LINEAR_MIPMAP_NEAREST, GN_MAGNIFY_NEAREST},
                 {"{'minFilter':9986,'magFilter':9728}", GN_WRAP_REPEAT, GN_WRAP_REPEAT, true,
                  GN_MINIFY_NEAREST_MIPMAP_LINEAR, GN_MAGNIFY_NEAREST},
                 {"{'minFilter':9987,'magFilter':9728}", GN_WRAP_REPEAT, GN_WRAP_REPEAT, true,
                  GN_MINIFY_LINEAR_MIPMAP_LINEAR, GN_MAGNIFY_NEAREST}};
    (void)state;
    begin();
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        char text[512];
        snprintf(text, sizeof text, IMAGES "'textures':[{'source':0,'sampler':0}],'samplers':[%s],",
                 cases[i].sampler);
        const model_map *const map =
            material("'emissiveTexture':{'index':0}", text)->maps + MAP_GLOW;
        assert_int_equal(map->wrap_s, cases[i].wrap_s);
        assert_int_equal(map->wrap_t, cases[i].wrap_t);
        assert_int_equal(map->has_filters, cases[i].has_filters);
        if (map->has_filters) {
            assert_int_equal(map->minify, cases[i].minify);
            assert_int_equal(map->magnify, cases[i].magnify);
        }
    }
    material("'emissiveTexture':{'index':0}",
             IMAGES "'textures':[{'source':0,'sampler':0}],'samplers':[{'wrapT':1}],");
    assert_true(has_warning("a.gltf: /samplers/0: wrapT is 1, which is none; it repeats (1)"));
}

/* KHR_texture_transform: u' = T R S u. */
static void assert_transform(const char *transform, const float *texcoords)
{
    char text[512];
    begin();
    snprintf(text, sizeof text,
             "'pbrMetallicRoughness':{'baseColorTexture':{'index':0,'extensions':{"
             "'KHR_texture_transform':{%s}}}}",
             transform);
    gltf_assert_floats(material(text, IMAGES "'textures':[{'source':0}],")->texcoords, texcoords,
                       6);
    assert_int_equal(read_messages.warning_count, 0);
}

static void test_texture_transform(void **state)
{
    /* The results are u and 1 - v. */
    static const float offset[6] = {0.5f, 0.75f, 1.5f, 0.75f, 0.5f, -0.25f};
    static const float scale[6] = {0, 1, 2, 1, 0, 0.5f};
    /* The extension's example: the lower left quarter of the image, so u in 0 to 0.5 and v in 0.5
     * to 1. */
    static const float example[6] = {0, 0, 0, 0.5f, 0.5f, 0};
    /* First scaled, then turned: (1, 0) to (2, 0) to (0, -2); (0, 1) to (0, 3) to (3, 0). */
    static const float order[6] = {0, 1, 0, 3, 3, 1};
    static const float other[6] = {0.25f, 0.5f, 0.5f, 0.5f, 0.25f, 0.25f};
    (void)state;
    assert_transform("'offset':[0.5,0.25]", offset);
    assert_transform("'scale':[2,0.5]", scale);
    assert_transform("'offset':[0,1],'rotation':1.57079632679489662,'scale':[0.5,0.5]", example);
    assert_transform("'rotation':1.57079632679489662,'scale':[2,3]", order);
    assert_transform("'texCoord':1", other);
}

/* One set of texture coordinates is kept: that of the first map. */
static void test_sets_of_texcoords(void **state)
{
    static const float expected[6] = {0.25f, 0.5f, 0.5f, 0.5f, 0.25f, 0.25f};
    (void)state;
    begin();
    const model_part *p =
        material("'pbrMetallicRoughness':{'baseColorTexture':{'index':0,'texCoord':1}},"
                 "'normalTexture':{'index':1},'emissiveTexture':{'index':0,'texCoord':1}",
                 IMAGES "'textures':[{'source':0},{'source':1}],");
    gltf_assert_floats(p->texcoords, expected, 6);
    assert_int_equal(p->maps[MAP_DIFFUSE].image, 0);
    assert_int_equal(p->maps[MAP_GLOW].image, 0);
    assert_int_equal(p->maps[MAP_NORMAL].image, MODEL_NO_IMAGE);
    assert_int_equal(read_messages.warning_count, 1);
    assert_true(
        has_warning("a.gltf: /materials/0/normalTexture: normalTexture has texture "
                    "coordinates other than the material's first map; it is not drawn (1)"));
    /* The same set, but transformed. */
    p = material("'pbrMetallicRoughness':{'baseColorTexture':{'index':0}},'normalTexture':{'index':"
                 "1,'extensions':{'KHR_texture_transform':{'scale':[2,2]}}}",
                 IMAGES "'textures':[{'source':0},{'source':1}],");
    assert_int_equal(p->maps[MAP_NORMAL].image, MODEL_NO_IMAGE);
    assert_int_equal(read_messages.warning_count, 1);
    p = material("'pbrMetallicRoughness':{'baseColorTexture':{'index':0,'texCoord':2}}",
                 IMAGES "'textures':[{'source':0}],");
    assert_false(p->has_texcoords);
    assert_int_equal(p->maps[MAP_DIFFUSE].image, MODEL_NO_IMAGE);
    assert_true(has_warning("a.gltf: /meshes/0/primitives/0/attributes: there is no TEXCOORD_2, so "
                            "that the maps of the material are not drawn (1)"));
}

static void test_images_inside(void **state)
{
    char text[512];
    (void)state;
    begin();
    snprintf(text, sizeof text,
             "'images':[{'bufferView':%u,'mimeType':'image/png','name':'wood'},"
             "{'uri':'data:image/png;base64,AQID'}],'textures':[{'source':0},{'source':1}],",
             gltf_view("PNG!", 4));
    const model_part *const p =
        material("'normalTexture':{'index':0},'emissiveTexture':{'index':1}", text);
    const model_image *const normal = read_model.images + p->maps[MAP_NORMAL].image;
    const model_image *const glow = read_model.images + p->maps[MAP_GLOW].image;
    assert_int_equal(read_model.image_count, 2);
    assert_string_equal(normal->name, "wood");
    assert_int_equal(normal->size, 4);
    assert_memory_equal(normal->bytes, "PNG!", 4);
    assert_string_equal(glow->name, "image 1");
    assert_int_equal(glow->size, 3);
    assert_memory_equal(glow->bytes, "\1\2\3", 3);
}

static void test_other_images(void **state)
{
    (void)state;
    begin();
    /* The fallback of EXT_texture_webp is an ordinary image. */
    const model_part *p = material("'emissiveTexture':{'index':0}", IMAGES
                                   "'extensionsUsed':['EXT_texture_webp'],'textures':[{'source':0,"
                                   "'extensions':{'EXT_texture_webp':{'source':1}}}],");
    assert_int_equal(p->maps[MAP_GLOW].image, 0);
    assert_string_equal(read_model.images[0].name, "a.png");
    assert_int_equal(read_messages.warning_count, 1);
    assert_true(
        has_warning("a.gltf: /extensionsUsed/0: the extension EXT_texture_webp is not drawn (1)"));
    p = material("'emissiveTexture':{'index':0}",
                 IMAGES "'textures':[{'extensions':{'KHR_texture_basisu':{'source':1}}}],");
    assert_int_equal(p->maps[MAP_GLOW].image, MODEL_NO_IMAGE);
    assert_true(has_warning("a.gltf: /textures/0: its image is only in KHR_texture_basisu, which "
                            "is not read (1)"));
    material("'emissiveTexture':{'index':0}", IMAGES "'textures':[{}],");
    assert_true(has_warning("a.gltf: /textures/0: the texture has no image (1)"));
}

static void test_material_faults(void **state)
{
    (void)state;
    begin();
    assert_material_fault("'pbrMetallicRoughness':{'baseColorFactor':[1,1,1]}", "",
                          "/materials/0/pbrMetallicRoughness/baseColorFactor: is no array of 4 "
                          "numbers");
    assert_material_fault("'pbrMetallicRoughness':{'metallicFactor':'1'}", "",
                          "/materials/0/pbrMetallicRoughness/metallicFactor: is no number that "
                          "fits");
    assert_material_fault("'pbrMetallicRoughness':[]", "",
                          "/materials/0/pbrMetallicRoughness: is no object");
    assert_material_fault("'doubleSided':1", "",
                          "/materials/0/doubleSided: is neither true nor false");
    assert_material_fault("'emissiveFactor':[1e39,0,0]", "",
                          "/materials/0/emissiveFactor/0: is no number that fits");
    assert_material_fault("'normalTexture':{'index':3}", "",
                          "/materials/0/normalTexture/index: is 3, but there are 0 textures");
    assert_material_fault("'normalTexture':{}", "", "/materials/0/normalTexture: names no texture");
    assert_material_fault("'normalTexture':{'index':0}", "'images':[{}],'textures':[{'source':0}],",
                          "/images/0: has neither uri nor bufferView");
    assert_material_fault("'normalTexture':{'index':0}",
                          "'images':[{'bufferView':99}],'textures':[{'source':0}],",
                          "/images/0/bufferView: is 99, but there are 4 bufferViews");
    begin();
    assert_false(gltf_read(GLTF_MESH("'material':0,'attributes':{'POSITION':0}")));
    gltf_assert_fault("/meshes/0/primitives/0/material: is 0, but there are 0 materials");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_metallic_roughness),
        cmocka_unit_test(test_vertex_colors),
        cmocka_unit_test(test_alpha),
        cmocka_unit_test(test_unlit),
        cmocka_unit_test(test_specular_glossiness),
        cmocka_unit_test(test_maps),
        cmocka_unit_test(test_samplers),
        cmocka_unit_test(test_texture_transform),
        cmocka_unit_test(test_sets_of_texcoords),
        cmocka_unit_test(test_images_inside),
        cmocka_unit_test(test_other_images),
        cmocka_unit_test(test_material_faults),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    forget_model();
    return failed;
}
