/* MTL: materials, maps with their options, and material files. */
#include "model_test.h"

#define SQUARE "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
#define FACE "f 1/1 2/2 3/3 4/4\n"

/* Reads a square with the material m of these statements, the first of which is line 2. Expects
 * this warning, once; null: none. */
static const model_part *material(const char *statements, const char *warning)
{
    char mtl[512], expected[256];
    const test_file files[] = {{"a.mtl", mtl, 0}, {NULL, NULL, 0}};
    snprintf(mtl, sizeof mtl, "newmtl m\n%s", statements);
    snprintf(expected, sizeof expected, "a.mtl: %s (1)", warning != NULL ? warning : "");
    expect_read(read_obj_text("mtllib a.mtl\n" SQUARE "usemtl m\n" FACE, files),
                warning != NULL ? expected : NULL);
    assert_int_equal(read_model.part_count, 1);
    return read_model.parts;
}

static void expect_material_color(const char *statements, const char *warning, float r, float g,
                                  float b, float alpha)
{
    expect_color(material(statements, warning), 0, r, g, b, alpha);
}

static void expect_specular(const model_part *part, float red, float green, float blue)
{
    assert_float_equal(part->surface.shine.specular[0], red, 0.0f);
    assert_float_equal(part->surface.shine.specular[1], green, 0.0f);
    assert_float_equal(part->surface.shine.specular[2], blue, 0.0f);
}

static void test_colors(void **state)
{
    const model_part *part = material("", NULL);
    expect_color(part, 0, 0.6f, 0.6f, 0.6f, 1.0f);
    expect_specular(part, 0.0f, 0.0f, 0.0f);
    assert_int_equal(part->surface.shine.exponent, 32);
    assert_int_equal(read_model.material_count, 1);
    part = material("\tKd 1 .5 0 # orange\n KS 0.25\nns 12.6\nillum 2\n"
                    "Ka 1 1 1\nNi 1.45\nKe 0 0 0\nTf 1 1 1\n",
                    NULL);
    expect_color(part, 0, 1.0f, 0.5f, 0.0f, 1.0f);
    expect_specular(part, 0.25f, 0.25f, 0.25f);
    assert_int_equal(part->surface.shine.exponent, 13);
    part = material("Kd 0.8\nNs 0\nKs 1 0 0\nillum 1\n", NULL);
    expect_color(part, 0, 0.8f, 0.8f, 0.8f, 1.0f);
    assert_int_equal(part->surface.shine.exponent, 1);
    expect_specular(part, 0.0f, 0.0f, 0.0f);
    assert_false(part->surface.is_unlit);
    assert_true(material("illum 0\n", NULL)->surface.is_unlit);
}

/* What is wrong leaves the default, which is grey. */
static void test_warnings(void **state)
{
    static const char *const not_drawn[] = {"Pr",      "Pm",      "Ps",     "Pc",      "Pcr",
                                            "aniso",   "anisor",  "map_Pr", "map_Pm",  "map_Ps",
                                            "map_RMA", "map_ORM", "disp",   "decal",   "refl",
                                            "map_aat", "map_Ns",  "map_Tr", "anything"};
    static const struct {
        const char *statements, *warning;
    } cases[] = {
        {"Tf 0.5\n", "line 2: Tf is not drawn"},
        {"Ke 1 0 0\n", "line 2: Ke without map_Ke is not drawn"},
        {"Ka 0.5 0 0\n", "line 2: Ka is not drawn: Kd is used for light from everywhere too"},
        {"illum 7\n", "line 2: illum 7 is drawn as illum 2, without reflection and refraction"},
        {"Kd spectral x.rfl\n", "line 2: Kd spectral: this is not drawn; the default is used"},
        {"Ks xyz 1 1 1\n", "line 2: Ks xyz: this is not drawn; the default is used"},
        {"Kd 1 zero 0\n", "line 2: Kd zero: this is not a number; the default is used"},
        {"Ns 1e99\n", "line 2: Ns 1e99: this is not a number; the default is used"},
        {"Kd 1 1\n", "line 2: Kd lacks its number; the default is used"},
        {"map_Kd\n", "line 2: map_Kd names no file"},
        {"Tr 1\n", "line 2: the opacity is 0: the material cannot be seen"},
        {"d 1.5\n", "line 2: d 1.5: this lies outside 0 to 1"},
        {"Tr -1\n", "line 2: Tr -1: this lies outside 0 to 1"}};
    char text[256], expected[256];
    for (size_t i = 0; i < sizeof not_drawn / sizeof not_drawn[0]; ++i) {
        const test_file files[] = {{"a.mtl", text, 0}, {NULL, NULL, 0}};
        snprintf(text, sizeof text, "newmtl m\nKd 1 0 0\n%s 0.5\n%s -s 2 x.png\n", not_drawn[i],
                 not_drawn[i]);
        snprintf(expected, sizeof expected, "a.mtl: line 3: %s is not drawn (2)", not_drawn[i]);
        expect_read(read_obj_text("mtllib a.mtl\n" SQUARE "usemtl m\n" FACE, files), expected);
        expect_color(read_model.parts, 0, 1.0f, 0.0f, 0.0f, 1.0f);
    }
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        const model_part *const part = material(cases[i].statements, cases[i].warning);
        assert_float_equal(part->colors[0], 0.6f, 1e-7f);
    }
    assert_int_equal(
        material("Ns 5000\n", "line 2: Ns above 1024 is drawn as 1024")->surface.shine.exponent,
        1024);
    material("map_Ka b.png\nmap_Kd a.png\n", "line 2: map_Ka is not drawn");
    material("map_Ka a.png\nmap_Kd a.png\n", NULL);
    expect_material_color("Kd 1 0 0\nnewmtl m\nKd 0 1 0\n",
                          "line 3: the material 'm' is defined twice; the first definition is used",
                          1.0f, 0.0f, 0.0f, 1.0f);
}

static void test_opacity(void **state)
{
    const test_file files[] = {{"a.mtl", "newmtl m\nKd 0.5 1 1\nd 0.5\n", 0}, {NULL, NULL, 0}};
    expect_material_color("Kd 1 0 0\nd 0.5\n", NULL, 1.0f, 0.0f, 0.0f, 0.5f);
    assert_int_equal(read_model.parts->surface.alpha, MODEL_BLEND);
    expect_material_color("Kd 1 0 0\nTr 0.25\n", NULL, 1.0f, 0.0f, 0.0f, 0.75f);
    expect_material_color("Kd 1 0 0\nd 0.25\nTr 0.75\n", NULL, 1.0f, 0.0f, 0.0f, 0.25f);
    expect_material_color("Kd 1 0 0\nd 1\nTr 0.75\n",
                          "line 4: d and Tr disagree; the last one is used", 1.0f, 0.0f, 0.0f,
                          0.25f);
    assert_int_equal(material("d 1\nTr 0\n", NULL)->surface.alpha, MODEL_OPAQUE);
    expect_material_color("Kd 1 0 0\nd -halo 0.5\n",
                          "line 3: d -halo: this is not drawn; the opacity is the same everywhere",
                          1.0f, 0.0f, 0.0f, 0.5f);
    const model_part *const part = material("map_d holes.png\n", NULL);
    assert_int_equal(part->surface.alpha, MODEL_BLEND);
    assert_int_equal(part->maps[MAP_OPACITY].image, 0);
    /* The vertices' alpha and the material's are multiplied, colours too. */
    expect_read(read_obj_text("mtllib a.mtl\nusemtl m\nv 0 0 0 1 0.5 0 0.5\nv 1 0 0\nv 0 1 0\n"
                              "f 1 2 3\n",
                              files),
                NULL);
    expect_color(read_model.parts, 0, 0.5f, 0.5f, 0.0f, 0.25f);
    expect_color(read_model.parts, 1, 0.5f, 1.0f, 1.0f, 0.5f);
}

/* Expects one map of this kind with this file. */
static const model_map *expect_map(const char *statements, const char *warning, map_kind kind,
                                   const char *name)
{
    const model_part *const part = material(statements, warning);
    for (int i = 0; i < MAP_COUNT; ++i)
        assert_true((part->maps[i].image != MODEL_NO_IMAGE) == (i == (int)kind));
    assert_int_equal(read_model.image_count, 1);
    assert_string_equal(read_model.images[0].name, name);
    return part->maps + kind;
}

static void test_maps(void **state)
{
    static const struct {
        const char *keyword;
        map_kind kind;
    } maps[] = {{"map_Kd", MAP_DIFFUSE}, {"map_Ks", MAP_SPECULAR}, {"map_Ke", MAP_GLOW},
                {"map_d", MAP_OPACITY},  {"map_bump", MAP_NORMAL}, {"map_Bump", MAP_NORMAL},
                {"bump", MAP_NORMAL},    {"norm", MAP_NORMAL},     {"map_Kn", MAP_NORMAL}};
    static const char *const names[] = {"a.png",      "2.png",      "2",      "a b  c.png",
                                        "sub\\a.png", "/x/y z.png", "-s.png", "a -s b.png",
                                        "a.png -s",   "-bm"};
    static const char twice[] = "line 3: bump is not drawn where the material has a map of normals";
    char text[256];
    for (size_t i = 0; i < sizeof maps / sizeof maps[0]; ++i)
        for (size_t k = 0; k < sizeof names / sizeof names[0]; ++k) {
            /* Blanks behind a name are not part of it. */
            snprintf(text, sizeof text, "%s %s \t\r\n", maps[i].keyword, names[k]);
            expect_map(text, NULL, maps[i].kind, names[k]);
        }
    expect_map("map_Kd \"a b.png\"\n", NULL, MAP_DIFFUSE, "a b.png");
    expect_map("norm n.png\nbump h.png\n", twice, MAP_NORMAL, "n.png");
    expect_map("bump h.png\nnorm n.png\n", twice, MAP_NORMAL, "n.png");
    /* A map shows its own colours: those that Kd has or lacks. */
    expect_material_color("map_Kd a.png\n", NULL, 1.0f, 1.0f, 1.0f, 1.0f);
    expect_material_color("Kd 1 0.5 0\nmap_Kd a.png\n", NULL, 1.0f, 0.5f, 0.0f, 1.0f);
    expect_material_color("Kd 0 0 0\nmap_Kd a.png\n",
                          "line 2: Kd 0 0 0 would hide its map_Kd; 1 1 1 is used", 1.0f, 1.0f, 1.0f,
                          1.0f);
}

/* Texture coordinates become scale times themselves plus offset. */
static void expect_transform(float su, float sv, float ou, float ov)
{
    const model_part *const part = read_model.parts;
    for (uint32_t v = 0; v < part->vertex_count; ++v) {
        const float u = part->positions[3 * v] > 0.0f, w = part->positions[3 * v + 1] > 0.0f;
        assert_float_equal(part->texcoords[2 * v], su * u + ou, 1e-6f);
        assert_float_equal(part->texcoords[2 * v + 1], sv * w + ov, 1e-6f);
    }
}

/* Options stand before or behind the name. Those of the second half are not drawn, with a warning
 * that begins with their first word. */
static void test_options(void **state)
{
    enum { DRAWN = 12, OPTIONS = 22 };
    static const char *const options[OPTIONS] = {
        "-blendu on",   "-blendv on",      "-cc off",     "-clamp off",  "-mm 0 1",
        "-mm 0",        "-t 0 0 0",        "-boost 0",    "-s 1 1 1",    "-o 0",
        "-BLENDU ON",   "-bm 1",           "-blendu off", "-blendv off", "-boost 2.5",
        "-cc on",       "-mm 0.1 1",       "-mm 0 2",     "-t 1",        "-texres 256",
        "-type sphere", "-colorspace sRGB"};
    for (int i = 0; i < 2 * OPTIONS; ++i) {
        const char *const option = options[i / 2];
        char text[256], expected[256];
        snprintf(text, sizeof text, i % 2 ? "map_Kd %s a.png\n" : "map_Kd a.png %s\n", option);
        snprintf(expected, sizeof expected, "line 2: %.*s of map_Kd is not drawn",
                 (int)strcspn(option, " "), option);
        expect_map(text, i / 2 < DRAWN ? NULL : expected, MAP_DIFFUSE, "a.png");
        expect_transform(1.0f, 1.0f, 0.0f, 0.0f);
    }
    const model_map *map = expect_map("bump -bm 1.5 -imfchan r n.png\n", NULL, MAP_NORMAL, "n.png");
    assert_float_equal(map->strength, 1.5f, 0.0f);
    assert_int_equal(map->channel, 'r');
    map = expect_map("bump n.png -bm 1.5 -clamp on\n", NULL, MAP_NORMAL, "n.png");
    assert_float_equal(map->strength, 1.5f, 0.0f);
    assert_int_equal(map->wrap_s, GN_WRAP_CLAMP_TO_BORDER);
    assert_int_equal(map->wrap_t, GN_WRAP_CLAMP_TO_BORDER);
    expect_map("map_Kd -imfchan q a.png\n", "line 2: -imfchan q is not known", MAP_DIFFUSE,
               "a.png");
    expect_map("map_Kd -clamp a.png\n", "line 2: -clamp of map_Kd lacks its value", MAP_DIFFUSE,
               "a.png");
}

/* The diffuse map's transform is used for all maps, or else the first one's. */
static void test_transforms(void **state)
{
    static const struct {
        const char *statements;
        float su, sv, ou, ov;
        const char *name;
    } rows[] = {{"map_Kd -s 2 2 1 a.png\n", 2, 2, 0, 0, "a.png"},
                {"map_Kd -s 2 3 a.png\n", 2, 3, 0, 0, "a.png"},
                {"map_Kd -s 2 a.png\n", 2, 1, 0, 0, "a.png"},
                {"map_Kd -o .5 a.png\n", 1, 1, 0.5f, 0, "a.png"},
                {"map_Kd -o 0.5 0.25 0 -s 2 4 1 a.png\n", 2, 4, 0.5f, 0.25f, "a.png"},
                {"map_Kd a.png -s 2 2 2\n", 2, 2, 0, 0, "a.png"},
                {"map_Kd -s 2 2 2.png\n", 2, 2, 0, 0, "2.png"},
                {"map_Kd -s 2 2 2\n", 2, 2, 0, 0, "2"},
                {"map_Kd -s 2 2 my map.png -o 1 1\n", 2, 2, 1, 1, "my map.png"},
                {"bump -s 3 3 n.png\n", 3, 3, 0, 0, "n.png"},
                {"map_Ks -s 2 2 n.png\nmap_Kd -s 2 2 a.png\n", 2, 2, 0, 0, "a.png"}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; ++i) {
        material(rows[i].statements, NULL);
        assert_string_equal(read_model.images[0].name, rows[i].name);
        expect_transform(rows[i].su, rows[i].sv, rows[i].ou, rows[i].ov);
    }
    material("bump -s 3 3 n.png\nmap_Kd -s 2 2 a.png\n",
             "line 1: the maps of a material have different -s and -o; the first map's are used "
             "for all");
    expect_transform(2.0f, 2.0f, 0.0f, 0.0f);
}

#define NO_FILE(name)                                                                              \
    "x.obj: line 1: the material file '" name "' cannot be read: No such file or directory (1)"

#define TWICE(name)                                                                                \
    name ": line 1: the material 'm' is defined twice; the first definition is used (1)"

/* Names may have blanks. Several files: the first that has the material (appendix B1, mtllib). The
 * file may be named behind the faces. Faces before usemtl, or behind one without a name, have no
 * material and are grey. */
static void test_names(void **state)
{
    static const test_file files[] = {
        {"a.mtl", "newmtl m\nKd 1 0 0\nnewmtl two words \t\nKd 0 1 0\nnewmtl z\nKd 0 0 1\n", 0},
        {"my file.mtl", "newmtl m\nKd 0 1 0\n", 0},
        {"b.mtl", "newmtl m\nKd 0 0 1\nnewmtl b\nKd 0 0 1\n", 0},
        {"n.mtl",
         "newmtl Material #1\nKd 1 0 0\nnewmtl Material #2\nKd 0 1 0\n"
         "newmtl plain # a comment\nKd 0 0 1\n",
         0},
        {"sub\\w.mtl", "newmtl m\nKd 1 1 0\n", 0},
        {"nul.mtl", "newmtl m\0Kd 1 1 0\n", 18},
        {"early.mtl", "Kd 1 0 0\nnewmtl m\n", 0},
        {NULL, NULL, 0}};
    static const struct {
        const char *obj;
        float r, g, b;
        const char *warning;
    } cases[] = {
        {"mtllib a.mtl  \t\r\n" SQUARE "usemtl m  \r\n" FACE, 1, 0, 0, NULL},
        {"mtllib a.mtl\n" SQUARE "usemtl two words\n" FACE, 0, 1, 0, NULL},
        {"mtllib my file.mtl\n" SQUARE "usemtl m\n" FACE, 0, 1, 0, NULL},
        {"mtllib \"my file.mtl\"\n" SQUARE "usemtl m\n" FACE, 0, 1, 0, NULL},
        {"mtllib sub\\w.mtl\n" SQUARE "usemtl m\n" FACE, 1, 1, 0, NULL},
        {"mtllib a.mtl b.mtl\n" SQUARE "usemtl b\n" FACE, 0, 0, 1, TWICE("b.mtl")},
        {"mtllib b.mtl a.mtl\n" SQUARE "usemtl m\n" FACE, 0, 0, 1, TWICE("a.mtl")},
        {SQUARE "usemtl m\n" FACE "mtllib a.mtl\nmtllib a.mtl\n", 1, 0, 0, NULL},
        {"mtllib n.mtl\n" SQUARE "usemtl Material #2\n" FACE, 0, 1, 0, NULL},
        {"mtllib n.mtl\n" SQUARE "usemtl plain\n" FACE, 0, 0, 1, NULL},
        {"mtllib n.mtl\n" SQUARE "usemtl plain # here\n" FACE, 0, 0, 1, NULL},
        {"mtllib a.mtl\n" SQUARE "usemtl m\nusemtl\n" FACE, 0.8f, 0.8f, 0.8f, NULL},
        {"mtllib no.mtl\n" SQUARE FACE, 0.8f, 0.8f, 0.8f, NO_FILE("no.mtl")},
        {"mtllib no such file\n" SQUARE FACE, 0.8f, 0.8f, 0.8f, NO_FILE("no such file")},
        {"mtllib no.mtl a.mtl\n" SQUARE "usemtl m\n" FACE, 1, 0, 0, NO_FILE("no.mtl")},
        {"mtllib\n" SQUARE FACE, 0.8f, 0.8f, 0.8f, "x.obj: line 1: mtllib names no file (1)"},
        {"mtllib nul.mtl\n" SQUARE FACE, 0.8f, 0.8f, 0.8f,
         "nul.mtl: it has a NUL byte, so it is not a text, and is not read (1)"},
        {"mtllib a.mtl\n" SQUARE "usemtl q\nusemtl q\n" FACE, 0.8f, 0.8f, 0.8f,
         "x.obj: line 10: no material file has the material 'q'; it is drawn light grey (2)"},
        {"mtllib early.mtl\n" SQUARE "usemtl m\n" FACE, 0.6f, 0.6f, 0.6f,
         "early.mtl: line 1: Kd stands before the first newmtl (1)"},
        {"mtllib a.mtl\n" SQUARE FACE, 0.8f, 0.8f, 0.8f, NULL}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        expect_read(read_obj_text(cases[i].obj, files), cases[i].warning);
        assert_int_equal(read_model.part_count, 1);
        expect_color(read_model.parts, 0, cases[i].r, cases[i].g, cases[i].b, 1.0f);
    }
    assert_int_equal(read_model.material_count, 0);
    expect_specular(read_model.parts, 0.25f, 0.25f, 0.25f);
}

static void test_parts(void **state)
{
    static const test_file files[] = {
        {"a.mtl", "newmtl m\nKd 1 0 0\nmap_Kd a.png\nnewmtl n\nKd 0 1 0\nmap_Kd a.png\n", 0},
        {NULL, NULL, 0}};
    expect_read(read_obj_text("mtllib a.mtl\n" SQUARE "usemtl m\nf 1/1 2/2 3/3\nusemtl n\n"
                              "f 1/1 3/3 4/4\nusemtl m\nf 2/2 3/3 1/1\n",
                              files),
                NULL);
    assert_int_equal(read_model.part_count, 2);
    assert_int_equal(read_model.material_count, 2);
    assert_int_equal(read_model.image_count, 1);
    expect_sizes(read_model.parts, MODEL_TRIANGLES, 3, 6);
    /* Without texture coordinates no map can be shown. */
    expect_read(read_obj_text("mtllib a.mtl\n" SQUARE "usemtl m\nf 1 2 3\n", files),
                "x.obj: the material 'm' has maps, but faces with it have no texture coordinates "
                "(1)");
    assert_int_equal(read_model.parts[0].maps[MAP_DIFFUSE].image, MODEL_NO_IMAGE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_colors),  cmocka_unit_test(test_warnings),
        cmocka_unit_test(test_opacity), cmocka_unit_test(test_maps),
        cmocka_unit_test(test_options), cmocka_unit_test(test_transforms),
        cmocka_unit_test(test_names),   cmocka_unit_test(test_parts),
    };
    return cmocka_run_group_tests(tests, NULL, forget_last_model);
}
