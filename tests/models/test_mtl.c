/* MTL: materials, maps with their options, and material files. */
#include "model_test.h"

#include <math.h>

#include "obj_test.h"

#define SQUARE "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
#define FACE "f 1/1 2/2 3/3 4/4\n"

/* Reads a square with the material m of this text. */
static const model_part *read_material(const char *mtl)
{
    const test_file files[] = {{"a.mtl", mtl, 0}, {NULL, NULL, 0}};
    assert_true(read_obj_text("mtllib a.mtl\n" SQUARE "usemtl m\n" FACE, files));
    assert_int_equal(read_model.part_count, 1);
    return read_model.parts;
}

/* Reads it and expects exactly one warning. */
static const model_part *read_with_warning(const char *mtl, const char *expected)
{
    const model_part *const part = read_material(mtl);
    if (read_messages.warning_count != 1 || !has_warning(expected))
        print_messages();
    assert_int_equal(read_messages.warning_count, 1);
    assert_true(has_warning(expected));
    return part;
}

static const model_part *read_in_silence(const char *mtl)
{
    const model_part *const part = read_material(mtl);
    if (read_messages.warning_count != 0)
        print_messages();
    assert_int_equal(read_messages.warning_count, 0);
    return part;
}

static void expect_specular(const model_part *part, float red, float green, float blue)
{
    assert_float_equal(part->surface.shine.specular[0], red, 0.0f);
    assert_float_equal(part->surface.shine.specular[1], green, 0.0f);
    assert_float_equal(part->surface.shine.specular[2], blue, 0.0f);
}

static void test_colors(void **state)
{
    (void)state;
    const model_part *part = read_in_silence("newmtl m\n");
    expect_color(part, 0, 0.6f, 0.6f, 0.6f, 1.0f);
    expect_specular(part, 0.0f, 0.0f, 0.0f);
    assert_int_equal(part->surface.shine.exponent, 32);
    assert_int_equal(read_model.material_count, 1);
    part = read_in_silence("newmtl m\n\tKd 1 .5 0 # orange\n KS 0.25\nns 12.6\nillum 2\n"
                           "Ka 1 1 1\nNi 1.45\nKe 0 0 0\nTf 1 1 1\n");
    expect_color(part, 0, 1.0f, 0.5f, 0.0f, 1.0f);
    expect_specular(part, 0.25f, 0.25f, 0.25f);
    assert_int_equal(part->surface.shine.exponent, 13);
    part = read_in_silence("newmtl m\nKd 0.8\nNs 0\nKs 1 0 0\nillum 1\n");
    expect_color(part, 0, 0.8f, 0.8f, 0.8f, 1.0f);
    assert_int_equal(part->surface.shine.exponent, 1);
    expect_specular(part, 0.0f, 0.0f, 0.0f);
    assert_false(part->surface.is_unlit);
    part = read_in_silence("newmtl m\nillum 0\n");
    assert_true(part->surface.is_unlit);
}

static void test_warnings(void **state)
{
    static const char *const not_drawn[] = {"Pr",      "Pm",      "Ps",     "Pc",      "Pcr",
                                            "aniso",   "anisor",  "map_Pr", "map_Pm",  "map_Ps",
                                            "map_RMA", "map_ORM", "disp",   "decal",   "refl",
                                            "map_aat", "map_Ns",  "map_Tr", "anything"};
    const model_part *part;
    char text[256], expected[256];
    (void)state;
    for (size_t i = 0; i < sizeof not_drawn / sizeof not_drawn[0]; ++i) {
        snprintf(text, sizeof text, "newmtl m\nKd 1 0 0\n%s 0.5\n%s -s 2 x.png\n", not_drawn[i],
                 not_drawn[i]);
        snprintf(expected, sizeof expected, "a.mtl: line 3: %s is not drawn (2)", not_drawn[i]);
        part = read_with_warning(text, expected);
        expect_color(part, 0, 1.0f, 0.0f, 0.0f, 1.0f);
    }
    read_with_warning("newmtl m\nTf 0.5\n", "a.mtl: line 2: Tf is not drawn (1)");
    read_with_warning("newmtl m\nKe 1 0 0\n", "a.mtl: line 2: Ke without map_Ke is not drawn (1)");
    read_with_warning("newmtl m\nKa 0.5 0 0\n", "a.mtl: line 2: Ka is not drawn: Kd is used for "
                                                "light from everywhere too (1)");
    read_with_warning("newmtl m\nillum 7\n", "a.mtl: line 2: illum 7 is drawn as illum 2, without "
                                             "reflection and refraction (1)");
    part = read_with_warning("newmtl m\nNs 5000\n",
                             "a.mtl: line 2: Ns above 1024 is drawn as 1024 (1)");
    assert_int_equal(part->surface.shine.exponent, 1024);
    part = read_with_warning("Kd 1 0 0\nnewmtl m\n",
                             "a.mtl: line 1: Kd stands before the first newmtl (1)");
    expect_color(part, 0, 0.6f, 0.6f, 0.6f, 1.0f);
    part = read_with_warning("newmtl m\nKd spectral x.rfl\n", "a.mtl: line 2: Kd spectral: this is "
                                                              "not drawn; the default is used (1)");
    expect_color(part, 0, 0.6f, 0.6f, 0.6f, 1.0f);
    read_with_warning("newmtl m\nKs xyz 1 1 1\n",
                      "a.mtl: line 2: Ks xyz: this is not drawn; the default is used (1)");
    part = read_with_warning("newmtl m\nKd 1 zero 0\n", "a.mtl: line 2: Kd zero: this is not a "
                                                        "number; the default is used (1)");
    expect_color(part, 0, 0.6f, 0.6f, 0.6f, 1.0f);
    read_with_warning("newmtl m\nNs 1e99\n",
                      "a.mtl: line 2: Ns 1e99: this is not a number; the default is used (1)");
    read_with_warning("newmtl m\nKd 1 1\n",
                      "a.mtl: line 2: Kd lacks its number; the default is used (1)");
    read_with_warning("newmtl m\nmap_Kd\n", "a.mtl: line 2: map_Kd names no file (1)");
    read_with_warning("newmtl m\nmap_Ka b.png\nmap_Kd a.png\n",
                      "a.mtl: line 2: map_Ka is not drawn (1)");
    read_in_silence("newmtl m\nmap_Ka a.png\nmap_Kd a.png\n");
    part =
        read_with_warning("newmtl m\nKd 1 0 0\nnewmtl m\nKd 0 1 0\n",
                          "a.mtl: line 3: the material 'm' is defined twice; the first definition "
                          "is used (1)");
    expect_color(part, 0, 1.0f, 0.0f, 0.0f, 1.0f);
}

static void test_opacity(void **state)
{
    (void)state;
    const model_part *part = read_in_silence("newmtl m\nKd 1 0 0\nd 0.5\n");
    expect_color(part, 0, 1.0f, 0.0f, 0.0f, 0.5f);
    assert_int_equal(part->surface.alpha, MODEL_BLEND);
    part = read_in_silence("newmtl m\nKd 1 0 0\nTr 0.25\n");
    expect_color(part, 0, 1.0f, 0.0f, 0.0f, 0.75f);
    part = read_in_silence("newmtl m\nKd 1 0 0\nd 0.25\nTr 0.75\n");
    expect_color(part, 0, 1.0f, 0.0f, 0.0f, 0.25f);
    part = read_with_warning("newmtl m\nKd 1 0 0\nd 1\nTr 0.75\n",
                             "a.mtl: line 4: d and Tr disagree; the last one is used (1)");
    expect_color(part, 0, 1.0f, 0.0f, 0.0f, 0.25f);
    part = read_in_silence("newmtl m\nd 1\nTr 0\n");
    assert_int_equal(part->surface.alpha, MODEL_OPAQUE);
    part = read_with_warning("newmtl m\nKd 1 0 0\nd -halo 0.5\n",
                             "a.mtl: line 3: d -halo: this is not drawn; the opacity is the same "
                             "everywhere (1)");
    expect_color(part, 0, 1.0f, 0.0f, 0.0f, 0.5f);
    read_with_warning("newmtl m\nTr 1\n",
                      "a.mtl: line 2: the opacity is 0: the material cannot be seen (1)");
    read_with_warning("newmtl m\nd 1.5\n", "a.mtl: line 2: d 1.5: this lies outside 0 to 1 (1)");
    read_with_warning("newmtl m\nTr -1\n", "a.mtl: line 2: Tr -1: this lies outside 0 to 1 (1)");
    part = read_in_silence("newmtl m\nmap_d holes.png\n");
    assert_int_equal(part->surface.alpha, MODEL_BLEND);
    assert_int_equal(part->maps[MAP_OPACITY].image, 0);
    /* The vertices' alpha and the material's are multiplied, colours too. */
    const test_file files[] = {{"a.mtl", "newmtl m\nKd 0.5 1 1\nd 0.5\n", 0}, {NULL, NULL, 0}};
    assert_true(read_obj_text("mtllib a.mtl\nusemtl m\nv 0 0 0 1 0.5 0 0.5\nv 1 0 0\nv 0 1 0\n"
                              "f 1 2 3\n",
                              files));
    expect_color(read_model.parts, 0, 0.5f, 0.5f, 0.0f, 0.25f);
    expect_color(read_model.parts, 1, 0.5f, 1.0f, 1.0f, 0.5f);
}

/* Expects one map of this kind with this file. */
static const model_map *expect_map(const model_part *part, map_kind kind, const char *name)
{
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
    char text[256];
    (void)state;
    for (size_t i = 0; i < sizeof maps / sizeof maps[0]; ++i)
        for (size_t k = 0; k < sizeof names / sizeof names[0]; ++k) {
            /* Blanks behind a name are not part of it. */
            snprintf(text, sizeof text, "newmtl m\n%s %s \t\r\n", maps[i].keyword, names[k]);
            expect_map(read_in_silence(text), maps[i].kind, names[k]);
        }
    expect_map(read_in_silence("newmtl m\nmap_Kd \"a b.png\"\n"), MAP_DIFFUSE, "a b.png");
    /* A map shows its own colours: those that Kd has or lacks. */
    expect_color(read_in_silence("newmtl m\nmap_Kd a.png\n"), 0, 1.0f, 1.0f, 1.0f, 1.0f);
    expect_color(read_in_silence("newmtl m\nKd 1 0.5 0\nmap_Kd a.png\n"), 0, 1.0f, 0.5f, 0.0f,
                 1.0f);
    expect_color(read_with_warning("newmtl m\nKd 0 0 0\nmap_Kd a.png\n",
                                   "a.mtl: line 2: Kd 0 0 0 would hide its map_Kd; 1 1 1 is used "
                                   "(1)"),
                 0, 1.0f, 1.0f, 1.0f, 1.0f);
    expect_map(read_with_warning("newmtl m\nnorm n.png\nbump h.png\n",
                                 "a.mtl: line 3: bump is not drawn where the material has a map of "
                                 "normals (1)"),
               MAP_NORMAL, "n.png");
    expect_map(read_with_warning("newmtl m\nbump h.png\nnorm n.png\n",
                                 "a.mtl: line 3: bump is not drawn where the material has a map of "
                                 "normals (1)"),
               MAP_NORMAL, "n.png");
}

/* Texture coordinates become scale times themselves plus offset. */
static void expect_transform(const model_part *part, float su, float sv, float ou, float ov)
{
    for (uint32_t v = 0; v < part->vertex_count; ++v) {
        const float u = part->positions[3 * v] > 0.0f, w = part->positions[3 * v + 1] > 0.0f;
        assert_float_equal(part->texcoords[2 * v], su * u + ou, 1e-6f);
        assert_float_equal(part->texcoords[2 * v + 1], sv * w + ov, 1e-6f);
    }
}

static void test_options(void **state)
{
    static const char *const silent[] = {
        "-blendu on", "-blendv on", "-cc off",  "-clamp off", "-mm 0 1",    "-mm 0",
        "-t 0 0 0",   "-boost 0",   "-s 1 1 1", "-o 0",       "-BLENDU ON", "-bm 1",
    };
    static const char *const not_drawn[][2] = {
        {"-blendu off", "-blendu"},
        {"-blendv off", "-blendv"},
        {"-boost 2.5", "-boost"},
        {"-cc on", "-cc"},
        {"-mm 0.1 1", "-mm"},
        {"-mm 0 2", "-mm"},
        {"-t 1", "-t"},
        {"-texres 256", "-texres"},
        {"-type sphere", "-type"},
        {"-colorspace sRGB", "-colorspace"},
    };
    char text[256], expected[256];
    (void)state;
    for (size_t i = 0; i < sizeof silent / sizeof silent[0]; ++i) {
        snprintf(text, sizeof text, "newmtl m\nmap_Kd %s a.png\n", silent[i]);
        const model_part *part = read_in_silence(text);
        expect_map(part, MAP_DIFFUSE, "a.png");
        expect_transform(part, 1.0f, 1.0f, 0.0f, 0.0f);
        snprintf(text, sizeof text, "newmtl m\nmap_Kd a.png %s\n", silent[i]);
        expect_map(read_in_silence(text), MAP_DIFFUSE, "a.png");
    }
    for (size_t i = 0; i < sizeof not_drawn / sizeof not_drawn[0]; ++i) {
        snprintf(expected, sizeof expected, "a.mtl: line 2: %s of map_Kd is not drawn (1)",
                 not_drawn[i][1]);
        snprintf(text, sizeof text, "newmtl m\nmap_Kd %s a.png\n", not_drawn[i][0]);
        expect_map(read_with_warning(text, expected), MAP_DIFFUSE, "a.png");
        snprintf(text, sizeof text, "newmtl m\nmap_Kd a.png %s\n", not_drawn[i][0]);
        expect_map(read_with_warning(text, expected), MAP_DIFFUSE, "a.png");
    }
    const model_map *map = expect_map(read_in_silence("newmtl m\nbump -bm 1.5 -imfchan r n.png\n"),
                                      MAP_NORMAL, "n.png");
    assert_float_equal(map->strength, 1.5f, 0.0f);
    assert_int_equal(map->channel, 'r');
    map = expect_map(read_in_silence("newmtl m\nbump n.png -bm 1.5 -clamp on\n"), MAP_NORMAL,
                     "n.png");
    assert_float_equal(map->strength, 1.5f, 0.0f);
    assert_int_equal(map->wrap_s, GN_WRAP_CLAMP_TO_BORDER);
    assert_int_equal(map->wrap_t, GN_WRAP_CLAMP_TO_BORDER);
    expect_map(read_with_warning("newmtl m\nmap_Kd -imfchan q a.png\n",
                                 "a.mtl: line 2: -imfchan q is not known (1)"),
               MAP_DIFFUSE, "a.png");
    expect_map(read_with_warning("newmtl m\nmap_Kd -clamp a.png\n",
                                 "a.mtl: line 2: -clamp of map_Kd lacks its value (1)"),
               MAP_DIFFUSE, "a.png");
}

static void test_transforms(void **state)
{
    static const struct {
        const char *options;
        float su, sv, ou, ov;
        const char *name;
    } rows[] = {
        {"-s 2 2 1 a.png", 2, 2, 0, 0, "a.png"},
        {"-s 2 3 a.png", 2, 3, 0, 0, "a.png"},
        {"-s 2 a.png", 2, 1, 0, 0, "a.png"},
        {"-o .5 a.png", 1, 1, 0.5f, 0, "a.png"},
        {"-o 0.5 0.25 0 -s 2 4 1 a.png", 2, 4, 0.5f, 0.25f, "a.png"},
        {"a.png -s 2 2 2", 2, 2, 0, 0, "a.png"},
        {"-s 2 2 2.png", 2, 2, 0, 0, "2.png"},
        {"-s 2 2 2", 2, 2, 0, 0, "2"},
        {"-s 2 2 my map.png -o 1 1", 2, 2, 1, 1, "my map.png"},
    };
    char text[256];
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; ++i) {
        snprintf(text, sizeof text, "newmtl m\nmap_Kd %s\n", rows[i].options);
        const model_part *const part = read_in_silence(text);
        expect_map(part, MAP_DIFFUSE, rows[i].name);
        expect_transform(part, rows[i].su, rows[i].sv, rows[i].ou, rows[i].ov);
    }
    /* The diffuse map's transform is used for all maps, or else the first one's. */
    expect_transform(read_with_warning("newmtl m\nbump -s 3 3 n.png\nmap_Kd -s 2 2 a.png\n",
                                       "a.mtl: line 1: the maps of a material have different -s "
                                       "and -o; the first map's are used for all (1)"),
                     2.0f, 2.0f, 0.0f, 0.0f);
    expect_transform(read_in_silence("newmtl m\nbump -s 3 3 n.png\n"), 3.0f, 3.0f, 0.0f, 0.0f);
    expect_transform(read_in_silence("newmtl m\nmap_Ks -s 2 2 n.png\nmap_Kd -s 2 2 a.png\n"), 2.0f,
                     2.0f, 0.0f, 0.0f);
}

/* Reads a model of one part, and expects its colour. */
static void expect_first_color(const char *obj, const test_file *files, float r, float g, float b)
{
    assert_true(read_obj_text(obj, files));
    assert_int_equal(read_model.part_count, 1);
    expect_color(read_model.parts, 0, r, g, b, 1.0f);
}

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
        {NULL, NULL, 0}};
    (void)state;
    expect_first_color("mtllib a.mtl  \t\r\n" SQUARE "usemtl m  \r\n" FACE, files, 1, 0, 0);
    assert_int_equal(read_messages.warning_count, 0);
    expect_first_color("mtllib a.mtl\n" SQUARE "usemtl two words\n" FACE, files, 0, 1, 0);
    expect_first_color("mtllib my file.mtl\n" SQUARE "usemtl m\n" FACE, files, 0, 1, 0);
    assert_int_equal(read_messages.warning_count, 0);
    expect_first_color("mtllib \"my file.mtl\"\n" SQUARE "usemtl m\n" FACE, files, 0, 1, 0);
    assert_int_equal(read_messages.warning_count, 0);
    expect_first_color("mtllib sub\\w.mtl\n" SQUARE "usemtl m\n" FACE, files, 1, 1, 0);
    /* Several files: the first that has the material (appendix B1, mtllib). */
    expect_first_color("mtllib a.mtl b.mtl\n" SQUARE "usemtl b\n" FACE, files, 0, 0, 1);
    expect_first_color("mtllib b.mtl a.mtl\n" SQUARE "usemtl m\n" FACE, files, 0, 0, 1);
    /* The material file may be named behind the faces. */
    expect_first_color(SQUARE "usemtl m\n" FACE "mtllib a.mtl\nmtllib a.mtl\n", files, 1, 0, 0);
    assert_int_equal(read_messages.warning_count, 0);
    expect_first_color("mtllib n.mtl\n" SQUARE "usemtl Material #2\n" FACE, files, 0, 1, 0);
    assert_int_equal(read_messages.warning_count, 0);
    expect_first_color("mtllib n.mtl\n" SQUARE "usemtl plain\n" FACE, files, 0, 0, 1);
    expect_first_color("mtllib n.mtl\n" SQUARE "usemtl plain # here\n" FACE, files, 0, 0, 1);
    /* Faces before usemtl, or behind one without a name, have no material. */
    expect_first_color("mtllib a.mtl\n" SQUARE FACE, files, 0.8f, 0.8f, 0.8f);
    assert_int_equal(read_model.material_count, 0);
    expect_specular(read_model.parts, 0.25f, 0.25f, 0.25f);
    expect_first_color("mtllib a.mtl\n" SQUARE "usemtl m\nusemtl\n" FACE, files, 0.8f, 0.8f, 0.8f);
    assert_int_equal(read_messages.warning_count, 0);

    expect_first_color("mtllib no.mtl\n" SQUARE FACE, files, 0.8f, 0.8f, 0.8f);
    assert_int_equal(read_messages.warning_count, 1);
    assert_true(
        has_warning("x.obj: line 1: the material file 'no.mtl' cannot be read: No such file "
                    "or directory (1)"));
    expect_first_color("mtllib no such file\n" SQUARE FACE, files, 0.8f, 0.8f, 0.8f);
    assert_int_equal(read_messages.warning_count, 1);
    assert_true(
        has_warning("x.obj: line 1: the material file 'no such file' cannot be read: No such "
                    "file or directory (1)"));
    expect_first_color("mtllib no.mtl a.mtl\n" SQUARE "usemtl m\n" FACE, files, 1, 0, 0);
    assert_int_equal(read_messages.warning_count, 1);
    assert_true(
        has_warning("x.obj: line 1: the material file 'no.mtl' cannot be read: No such file "
                    "or directory (1)"));
    expect_first_color("mtllib\n" SQUARE FACE, files, 0.8f, 0.8f, 0.8f);
    assert_true(has_warning("x.obj: line 1: mtllib names no file (1)"));
    expect_first_color("mtllib nul.mtl\n" SQUARE FACE, files, 0.8f, 0.8f, 0.8f);
    assert_true(
        has_warning("nul.mtl: it has a NUL byte, so it is not a text, and is not read (1)"));
    expect_first_color("mtllib a.mtl\n" SQUARE "usemtl q\nusemtl q\n" FACE, files, 0.8f, 0.8f,
                       0.8f);
    assert_true(has_warning("x.obj: line 10: no material file has the material 'q'; it is drawn "
                            "light grey (2)"));
}

static void test_parts(void **state)
{
    static const test_file files[] = {
        {"a.mtl", "newmtl m\nKd 1 0 0\nmap_Kd a.png\nnewmtl n\nKd 0 1 0\nmap_Kd a.png\n", 0},
        {NULL, NULL, 0}};
    (void)state;
    assert_true(read_obj_text("mtllib a.mtl\n" SQUARE "usemtl m\nf 1/1 2/2 3/3\nusemtl n\n"
                              "f 1/1 3/3 4/4\nusemtl m\nf 3/3 2/2 1/1\n",
                              files));
    assert_int_equal(read_model.part_count, 2);
    assert_int_equal(read_model.material_count, 2);
    assert_int_equal(read_model.image_count, 1);
    assert_int_equal(read_model.parts[0].index_count, 6);
    assert_int_equal(read_model.parts[0].vertex_count, 3);
    /* Without texture coordinates no map can be shown. */
    assert_true(read_obj_text("mtllib a.mtl\n" SQUARE "usemtl m\nf 1 2 3\n", files));
    assert_int_equal(read_model.parts[0].maps[MAP_DIFFUSE].image, MODEL_NO_IMAGE);
    assert_true(has_warning("x.obj: the material 'm' has maps, but faces with it have no texture "
                            "coordinates (1)"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_colors),  cmocka_unit_test(test_warnings),
        cmocka_unit_test(test_opacity), cmocka_unit_test(test_maps),
        cmocka_unit_test(test_options), cmocka_unit_test(test_transforms),
        cmocka_unit_test(test_names),   cmocka_unit_test(test_parts),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    forget_model();
    return failed;
}
