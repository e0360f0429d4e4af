/* The gnomon command with bad input: exit status, one clear line, nothing left behind. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include <gnomon/backend.h>

TEST(help_is_printed)
{
    good_shell("set -e; for c in render compare demo spin view diff info explain transform; do "
               "gnomon $c --help >asked; gnomon help $c | cmp - asked; gnomon --help $c | cmp - "
               "asked; gnomon -h $c | cmp - asked; done; gnomon --help >asked; gnomon help | cmp - "
               "asked; grep -q 'gnomon render MODEL... -o OUT' asked; grep -q '^2: wrong' asked");
    run r = shell("gnomon render --help >/dev/full");
    assert_int_equal(r.status, 1);
    assert_non_null(strstr(r.error, "standard output"));
}

/* Values that are none of their option's kind, one or two of each kind. */
static const refusal no_values[] = {
    {"--rotate 90", "--rotate '90': not AXIS,DEGREES"},
    {"--rotate w,90", "--rotate 'w,90': not AXIS,DEGREES"},
    {"--rotate x,1e99", "--rotate 'x,1e99': not AXIS,DEGREES"},
    {"--scale 1,2", "--scale '1,2': not a number, or three numbers"},
    {"--translate 1", "--translate '1': not three numbers"},
    {"--near here", "--near 'here': not a distance"},
    {"--far inf", "--far 'inf': not finite in 32 bits; it takes a distance"},
    {"--fov wide", "--fov 'wide': not a number of degrees"},
    {"--orthographic 2m", "--orthographic '2m': not a height"},
    {"--cull left", "--cull 'left': not none, back or front"},
    {"--filter cubic", "--filter 'cubic': not mipmap, linear or nearest"},
    {"--sort middle", "--sort 'middle': not first or last"},
    {"--points=big", "--points 'big': not a size in pixels, above 0"},
    {"--size 100", "--size '100': not WIDTHxHEIGHT"},
    {"--size 100x", "--size '100x': not WIDTHxHEIGHT"},
    {"--size 5x5x5", "--size '5x5x5': not WIDTHxHEIGHT"},
    {"--eye 1,2", "--eye '1,2': not three numbers X,Y,Z"},
    {"--eye 1,2,3,4", "--eye '1,2,3,4': not three numbers X,Y,Z"},
    {"--target 1,nan,3", "--target '1,nan,3': not finite in 32 bits; it takes three numbers X,Y,Z"},
    {"--up 1,2,1e99", "--up '1,2,1e99': not finite in 32 bits; it takes three numbers X,Y,Z"},
    {"--eye 0,1e39", "--eye '0,1e39': not finite in 32 bits; it takes three numbers X,Y,Z"},
    {"--light here", "--light 'here': not three numbers X,Y,Z"},
    {"--shader velvet", "--shader 'velvet': not vertex-color, unlit, flat, gouraud"},
    {"--backend mmx", "--backend 'mmx': not auto, portable, sse41"},
    {"--backend ''", "--backend '': not auto, portable, sse41"},
    {"--background red", "--background 'red': not #rrggbb or #rrggbbaa"},
    {"--background 12345", "--background '12345': not #rrggbb or #rrggbbaa"},
    {"--texture ''", "--texture '': not a file name, or none"},
    {"--depth ''", "--depth '': not a file name"},
    {"--normal-map a.png", "--normal-map 'a.png': not any, tangent, world, none, tangent:FILE"},
    {"--normal-map world:", "--normal-map 'world:': not any"},
    {"--normal-map none:a.png", "--normal-map 'none:a.png': not any"},
    {"--normal-map any:a.png", "--normal-map 'any:a.png': not any"},
    {"--exponent 2.5", "--exponent '2.5': not a whole number from 1 to 1024"},
    {"--bands -", "--bands '-': not a whole number from 2 to 256"},
    {"--bands ''", "--bands '': not a whole number from 2 to 256"},
    {"--import-memory much", "--import-memory 'much': not a whole number of MiB from 1 to"},
    {"--samples 4x", "--samples '4x': not 1 or 4"},
};

/* Options that are wrong, or wrong together. */
static const refusal no_options[] = {
    {"--no-depth-test=no", "no value allowed in '--no-depth-test=no'"},
    {"--ba 5", "'--ba' is ambiguous: --bands, --background, --backend"},
    {"--t=a.png", "'--t=a.png' is ambiguous: --target, --translate, --texture"},
    {"--nonsense", "unknown option '--nonsense'"},
    {"-q", "unknown option '-q'"},
    {"--sampels=4", "unknown option '--sampels=4'; did you mean '--samples'? (see"},
    {"--backgroud red", "unknown option '--backgroud'; did you mean '--background'?"},
    {"--picture b.png", "unknown option '--picture'"},
    {"--primitive 0,0", "unknown option '--primitive'"},
    {"--eye", "no value after '--eye'"},
    {"-o ''", "-o '': not a file name"},
    {"-- ''", "'': an empty file name"},
    {"--points 5", "'5': no such file; a size of points is written --points=5"},
    {"--points --wireframe", "--wireframe and --points cannot be used together"},
    {"--fov 40 --orthographic 2", "--fov and --orthographic cannot be used together"},
    {"--texture a.png --shader normals", "--texture cannot be used with --shader normals"},
    {"--glow-map a.png --shader toon", "--glow-map cannot be used with --shader toon"},
    {"--shadows --shader gouraud", "--shadows cannot be used with --shader gouraud"},
    {"--format tga", "--format is for names without a suffix, such as -, and 'a.png' has one"},
    {"-o - --format jpg", "--format 'jpg': not png, tga, ppm or raw"},
    {"-o a.tga --size 65536x5", "--size 65536x5 ... 65535x65535"},
    {"--size 16385x5 --statistics", "--statistics ... 16384"},
    {"--size 16385x5 --sort last", "--sort last ... 16384"},
    {"--sort last --no-depth-test", "--sort last ... --no-depth-test"},
    {"--views v --sort last", "--sort and --views cannot be used together"},
};

static const refusal no_commands[] = {
    {"", "gnomon: no command (see gnomon --help)"},
    {"paint", "'paint': no such command (see"},
    {"rendr square.obj", "'rendr': no such command; did you mean 'render'? (see gnomon --help)"},
    {"help hinfo", "'hinfo': no such command; did you mean 'info'?"},
    {"help paint", "'paint': no such command"},
    {"--help paint", "'paint': no such command"},
    {"square.obj",
     "'square.obj': no such command; to draw a file: gnomon render square.obj -o OUT"},
    {"--version paint", "'paint': --version stands alone"},
    {"help render square.obj", "'square.obj': help is about one command"},
    {"render --help=3", "no value allowed in '--help=3' (see gnomon render --help)"},
    {"render", "no model file"},
    {"render '' -o a.png", "'': an empty file name"},
    {"render square.obj", "no output file; give one with -o OUT.png"},
    {"render square.obj -o", "no value after '-o'"},
    {"compare", "no model file (see gnomon compare --help)"},
    {"compare square.obj --samples 4 --wireframe", "--wireframe and --samples ... OSMesa"},
    {"compare square.obj --format tga", "unknown option '--format'"},
    {"compare square.obj --depth d.png", "unknown option '--depth'"},
    {"spin -o a --format raw", "--format 'raw': not png, tga or ppm"},
    {"spin --frames ''", "--frames '': not a whole number from 1 to 100000"},
    {"demo square.obj", "'square.obj': demo takes no model"},
    {"demo --rotate x,90", "unknown option '--rotate'"},
    {"demo --texture a.png", "unknown option '--texture'"},
    {"demo --map-pixels 1", "unknown option '--map-pixels'"},
    {"demo --normal-map world:a.png", "--normal-map takes no file here"},
    {"demo --tessellation 1.5", "--tessellation '1.5': not a whole number from 1 to 128"},
};

TEST(usage_errors_are_status_2)
{
    EXPECT_EACH(2, "", no_commands);
    EXPECT_EACH(2, "render square.obj -o a.png", no_values);
    EXPECT_EACH(2, "render square.obj -o a.png", no_options);
    expect(1, "render --points nothing.obj -o a.png", "nothing.obj ... No such file");
    expect(1, "render --points=3 5 -o a.png", "gnomon: 5: ... No such file");
}

static const refusal impossible[] = {
    {"--size 0x5", "--size: impossible size ... 1048576"},
    {"--size 5x0", "--size: impossible size ... 1048576"},
    {"--size -5x5", "--size: impossible size ... 1048576"},
    {"--size 1048577x5", "--size: impossible size ... 1048576"},
    {"--size 5x99999999999999999999", "--size: impossible size ... 1048576"},
    {"--views v --size 16385x5", "--size: impossible size ... 16384"},
    {"--eye 1,2,3 --target 1,2,3", "--eye: ... target"},
    {"--eye 0,0,0", "--eye: ... target"},
    {"--eye 0,0,5 --up 0,0,1", "--up: ... parallel"},
    {"--eye 0,0,5 --up 0,0,-3", "--up: ... parallel"},
    {"--up 0,0,0", "--up: ... zero"},
    {"--fov 0", "--fov: ... 180"},
    {"--fov -10", "--fov: ... 180"},
    {"--fov 180", "--fov: ... 180"},
    {"--orthographic 0", "--orthographic: ... above 0"},
    {"--light 0,0,0", "--light: ... zero"},
    {"--near 0", "--near: ... above 0"},
    {"--far -1", "--far: ... above 0"},
    {"--near 2 --far 2", "--far: ... beyond --near"},
    {"--rotate 0,0,0,90", "--rotate: impossible transformation '0,0,0,90'"},
    {"--scale 1,0,1", "--scale: impossible transformation ... singular"},
    {"--translate 3e38,0,0 --translate 3e38,0,0", "--translate: ... range"},
    {"--eye 3e38,3e38,3e38 --target -3e38,0,0", "--eye: impossible"},
    {"--fov 1e-30", "--fov: impossible"},
    {"--orthographic 1e-45", "--orthographic: impossible"},
    {"--near 1e-45", "--near: impossible"},
    /* The option without which there would be a camera. */
    {"--eye 0,0,3 --near 1e-44", "--near: impossible"},
    {"--eye 0,0,3 --far 1e-44", "--far: impossible"},
    {"--eye 0,0,3 --fov 1e-40", "--fov: impossible"},
    {"--target 0,0,1 --orthographic 1e-44", "--orthographic: impossible"},
    {"--fov 50 --near 1e-44", "--near: impossible"},
    {"--fov 50 --eye 0,0,3e38", "--eye: impossible"},
    {"--near 1 --target 0,0,3e38", "--target: impossible"},
    {"--target 1e9,1e9,1e9", "--target: ... where the target"},
    {"--exponent 0", "--exponent: impossible value '0': not a whole number from 1 to 1024"},
    {"--exponent 1025", "--exponent: impossible value '1025': not a whole number from 1 to 1024"},
    {"--bands 1", "--bands: impossible value '1': not a whole number from 2 to 256"},
    {"--bands -3", "--bands: impossible value '-3': not a whole number"},
    {"--bands 4294967298", "--bands: impossible value '4294967298': not a whole number"},
    {"--import-seconds 86401", "--import-seconds: ... from 1 to 86400"},
    {"--import-output -1", "--import-output: ... MiB from 1 to 1048576"},
    {"--map-pixels 257", "--map-pixels: ... from 1 to 256"},
    {"--points=0", "--points: ... above 0"},
    {"--points=-2", "--points: ... above 0"},
    {"--samples 2", "--samples: ... 1 or 4"},
};

TEST(impossible_values_are_status_1)
{
    EXPECT_EACH(1, "render square.obj -o a%d.png", impossible);
    expect(1, "spin square.obj --size 16385x5", "--size ... 16384");
    expect(1, "compare square.obj --size 0x0", "--size ... 16384");
    expect(1, "demo --size 0x0", "--size ... 16384");
    expect(1, "demo --tessellation 129", "--tessellation: ... from 1 to 128");
    expect(1, "spin --frames 0", "--frames: ... from 1 to 100000");
    expect(1, "spin --rate 1001", "--rate: ... from 1 to 1000");
    expect(1, "info square.obj --import-memory 0", "--import-memory: ... MiB from 1 to 1048576");
    write_text("huge.obj", "v 3e38 0 0\nv -3e38 0 0\nv 0 3e38 0\nf 1 2 3\n");
    expect(1, "render huge.obj -o a.png", "models ... too large");
    expect(1, "render huge.obj -o a.png --fov 50 --near 1", "models ... too large");
}

TEST(bad_models_are_named)
{
    static const struct {
        const char *name, *text, *message;
    } models[] = {
        {"empty.obj", "", "empty.obj: ... empty"},
        {"noise.xyzzy", "this is no model of any kind\n", "noise.xyzzy: ... OBJ, PLY, STL"},
        {"noise.ply", "ply\nformat ascii 1.0\nelement vertex 3\n", "noise.ply: ... header"},
        {"vertices.obj", "vn 0 0 1\nvt 0 0\n", "vertices.obj: ... no triangles, lines or points"},
        {"infinite.obj", "v 0 0 0\nv 1 0 0\nv 0 inf 0\nf 1 2 3\n", "infinite.obj: ... finite"},
        {"line\nbreak.obj", "", "line\\x0abreak.obj: ... empty"},
    };
    for (size_t i = 0; i < COUNT(models); ++i) {
        char line[64];
        write_text(models[i].name, models[i].text);
        snprintf(line, sizeof line, "render '%s' -o a.png", models[i].name);
        expect(1, line, "%s", models[i].message);
    }
    mkdir(path_of("folder.obj"), 0777);
    expect(1, "render folder.obj -o a.png", "folder.obj ... directory");
    expect(1, "render nothing.obj -o a.png", "nothing.obj ... No such file");
    expect(1, "compare nothing.obj -o a.png", "nothing.obj ... No such file");
}

TEST(bad_textures_are_named)
{
    /* 8x8 texels of 24 bits are announced, one is there. */
    static const uint8_t short_tga[21] = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 8, 0, 8, 0, 24, 0};
    static const refusal textures[] = {
        {"square.obj --texture none.png", "none.png: ... No such file"},
        {"square.obj --texture noise.png", "noise.png: ... texture"},
        {"square.obj --texture .", ".: ... directory"},
        {"square.obj --texture short.tga", "short.tga: ... cut short"},
        {"bare.obj --texture noise.png", "bare.obj: ... coordinates"},
        {"bare.obj --normal-map world", "bare.obj: ... coordinates"},
        {"square.obj --specular-map none.tga", "none.tga: ... No such file"},
        {"square.obj --glow-map noise.png", "noise.png: ... --glow-map none"},
        {"square.obj --normal-map world:none.png", "none.png: ... --normal-map none"},
        {"square.obj --normal-map tangent:noise.png", "noise.png: ... texture"},
        {"square.obj --normal-map tangent", "_nm_tangent ... tangent:FILE"},
        {"square.obj --normal-map world", "_nm.tga ... world:FILE"},
        {"named.obj", "named.obj: ... gone.png ... No such file ... --texture none"},
        {"bad.obj", "bad.obj: ... noise.png"},
    };
    static const char *const found[][2] = {{"diffuse", "texture"},
                                           {"nm", "normal-map"},
                                           {"nm_tangent", "normal-map"},
                                           {"spec", "specular-map"},
                                           {"glow", "glow-map"}};
    write_text("noise.png", "this is no image");
    write_bytes("short.tga", short_tga, sizeof short_tga);
    write_text("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write_text("named.mtl", "newmtl skin\nmap_Kd gone.png\nnewmtl bad\nmap_Kd noise.png\n");
    write_square("named.obj", "mtllib named.mtl\nusemtl skin\n");
    write_square("bad.obj", "mtllib named.mtl\nusemtl bad\n");
    EXPECT_EACH(1, "render -o a.png", textures);
    expect(1, "compare named.obj -o a.png", "named.obj ... gone.png");
    good("render named.obj -o b.png --texture none --size 8x8");

    /* Beside the model. */
    write_text("head.obj", square_obj);
    for (size_t i = 0; i < COUNT(found); ++i) {
        char name[64];
        snprintf(name, sizeof name, "head_%s.jpg", found[i][0]);
        write_text(name, "this is no image");
        expect(1, "render head.obj -o a.png --shader phong", "%s: ... texture ... --%s none", name,
               found[i][1]);
        good("render head.obj -o b.png --size 8x8 --%s none", found[i][1]);
        remove_file(name);
    }
}

TEST(outputs_are_whole_or_absent)
{
    static const char old[] = "what was there before";
    static const refusal outputs[] = {
        {"render nothing.obj -o kept.png", "nothing.obj"},
        {"render square.obj -o nowhere/a.png", "nowhere/a.png: ... No such file"},
        {"render square.obj -o folder.png", "folder.png: ... directory"},
        {"render square.obj -o ./square.obj", "square.obj: ... overwritten"},
        {"compare square.obj -o ./square.obj", "square.obj: ... overwritten"},
        {"render square.obj -o a.png --depth a.png", "a.png: cannot be both"},
        {"demo -o a.png --picture a.png", "a.png: cannot be both"},
        {"compare square.obj --texture square_compared.png",
         "square_compared.png: ... overwritten"},
        {"render square.obj --glow-map ./kept.png -o kept.png", "kept.png: ... overwritten"},
        {"render square.obj --normal-map world:kept.png --depth kept.png -o a.png",
         "kept.png: ... overwritten"},
        {"render square.obj -o kept.png --depth nowhere/d.png", "nowhere/d.png: ... No such file"},
        {"render square.obj -o /dev/full", "/dev/full: ... No space"},
        /* The pictures are so small that the full disk shows only when the file is closed. */
        {"render square.obj -o /dev/full --depth d.png --size 8x8", "/dev/full: ... No space"},
        {"render square.obj -o a.png --depth /dev/full --size 8x8", "/dev/full: ... No space"},
        {"render square.obj -o kept.png --depth /dev/full --size 8x8", "/dev/full: ... No space"},
    };
    /* A limit on the file's size, in blocks of 512 bytes. Its signal is ignored, so that writing
     * fails. */
    static const char *const limited[] = {
        "render square.obj -o kept.png --size 2000x2000 --orthographic 3",
        "render square.obj -o kept.tga --size 200x200",
        "render square.obj -o - --size 2000x2000 --orthographic 3 >kept.tga",
        "render square.obj -o - --format ppm --size 200x200 >kept.tga",
        "render square.obj -o /dev/null --depth kept.png --size 2000x2000 --rotate x,20",
        "spin square.obj -o kept.png --size 200x200 --frames 9"};
    write_text("kept.png", old);
    mkdir(path_of("folder.png"), 0777);
    EXPECT_EACH(1, "", outputs);
    for (size_t i = 0; i < COUNT(limited); ++i) {
        const bool is_standard = strchr(limited[i], '>') != NULL;
        write_text("kept.tga", old);
        runner_mark();
        run r = shell("(ulimit -f 1; exec gnomon %s)", limited[i]);
        if (r.status != 1 || lines(r.error) != 1 ||
            strstr(r.error, is_standard ? "gnomon: -: " : "gnomon: kept.") == NULL ||
            strstr(r.error, "cannot be written: File too large") == NULL)
            fail_run(&r);
        assert_int_equal(new_files(), 0);
    }
    char text[64] = "";
    read_file("kept.png", text, sizeof text - 1);
    assert_string_equal(text, old);
}

TEST(one_file_has_many_names)
{
    /* None of the pictures exists yet. */
    static const refusal same[] = {
        {"render square.obj -o same.png --depth ./same.png", "same.png: cannot be both"},
        {"render square.obj -o same.png --depth below/../same.png", "same.png: cannot be both"},
        {"render square.obj -o here/same.png --depth \"$PWD/same.png\"",
         "same.png: cannot be both"},
        {"demo --picture ./gnomon-demo.png", "gnomon-demo.png: cannot be both"},
        {"render square.obj -o other.obj", "square.obj: ... overwritten"},
    };
    good_shell("mkdir below; ln -sfn . here; ln -sf square.obj other.obj");
    EXPECT_EACH(1, "", same);
    /* One name in two directories is two files, and two names in one directory are two files. */
    good_shell("set -e; draw() { gnomon render square.obj --size 4x4 -o $1 --depth $2; test -f $1; "
               "test -f $2; }; draw two.png below/two.png; draw below/four.png four.png; "
               "draw one.png ./three.png; draw two.png below/two.png");
    expect(1, "render square.obj -o two.png --depth ./two.png", "two.png ... both");
}

/* A back end may be missing here, but then the command says so. */
TEST(every_backend_gives_the_same_picture)
{
    good("render square.obj -o auto.png --size 61x47");
    for (int i = 0; i < GN_BACKEND_COUNT; ++i) {
        const char *const name = gn_backend_name((gn_backend)i);
        char line[160];
        snprintf(line, sizeof line, "render square.obj -o named.png --size 61x47 --backend %s",
                 name);
        if (!gn_backend_available((gn_backend)i)) {
            expect(1, line, "--backend: %s is not available ... processor", name);
            continue;
        }
        good("%s", line);
        expect_same_files("auto.png", "named.png");
        good("compare square.obj -o named.png --size 61x47 --backend %s", name);
        remove_file("named.png");
    }
}

/* A TGA picture of one grey value, in run-length packets. */
static void write_grey_tga(const char *name, int size)
{
    uint8_t header[18] = {0};
    header[2] = 11; /* grey, run-length encoded */
    header[12] = header[14] = (uint8_t)(size & 255);
    header[13] = header[15] = (uint8_t)(size >> 8);
    header[16] = 8;
    FILE *file = fopen(path_of(name), "wb");
    assert_non_null(file);
    fwrite(header, 1, sizeof header, file);
    for (int i = 0; i < size * (size / 128); ++i)
        fputs("\xff\x80", file);
    assert_int_equal(fclose(file), 0);
}

/* Whether the last line is the command's own. */
static bool ends_with_own_line(const char *text)
{
    const char *last = text;
    for (const char *at = text; (at = strchr(at, '\n')) != NULL && at[1] != '\0';)
        last = ++at;
    return strncmp(last, "gnomon: ", 8) == 0 && strchr(last, '\n') != NULL;
}

/* Runs with more and more address space, from `least` MiB on. Every run succeeds or ends with the
 * command's own line about memory. Returns the number of runs that did not succeed. */
static int count_failures(const char *arguments, int least)
{
    int failures = 0;
    for (int extra = 0; extra <= 96; extra += 4) {
        run r = shell("ulimit -v %d; exec gnomon %s", 1024 * (least + extra), arguments);
        failures += r.status != 0;
        if (r.status != 0 &&
            (r.status != 1 || strstr(r.error, "memory") == NULL || !ends_with_own_line(r.error)))
            fail_run(&r);
    }
    return failures;
}

TEST(short_memory_is_said)
{
    int least = 16;
    if (!little_memory_works())
        return;
    while (least < 4096 && shell("ulimit -v %d; exec gnomon --help", 1024 * least).status != 0)
        least += 16;
    write_grid("grid.obj", 700);
    write_grey_tga("grey.tga", 2048);
    runner_mark();
    assert_true(count_failures("render grid.obj -o /dev/null --size 64x64", least) > 0);
    assert_true(count_failures("render square.obj --texture grey.tga -o /dev/null --size 64x64",
                               least) > 4);
    assert_int_equal(new_files(), 0);
}

/* Aborts as a library would that cannot end otherwise. The pipe opens when the command reads it. */
TEST(abort_is_explained)
{
    run r = shell("mkfifo pipe.txt; gnomon transform pipe.txt & "
                  "exec 3>pipe.txt; kill -ABRT $!; wait $!");
    assert_int_equal(r.status, 1);
    assert_int_equal(lines(r.error), 1);
    assert_true(ends_with_own_line(r.error));
    remove_file("pipe.txt");
}

TEST(outputs_replace_what_was_there)
{
    good_shell("set -e; draw() { gnomon render square.obj --size 4x4 -o $1; }; "
               "mode() { test $(stat -c %%a $1) = 640; }; echo old >old.png; chmod 640 old.png; "
               "ln -sf old.png link.png; draw link.png; test -L link.png; mode old.png; "
               "umask 027; draw fresh.png; mode fresh.png; draw /dev/null; test -c /dev/null");
    picture p = picture_read("old.png");
    assert_int_equal(p.width, 4);
    picture_free(&p);
}

TEST(files_are_at_most_64)
{
    char words[256] = "";
    for (int i = 0; i < 64; ++i)
        strcat(words, " a");
    run r = gnomon("info%s", words);
    assert_int_equal(r.status, 1);
    assert_int_equal(lines(r.error), 64);
    r = gnomon("info%s a", words);
    assert_int_equal(r.status, 2);
    assert_non_null(strstr(r.error, "more than 64 files"));
}

/* A terminal is made by `script`. */
TEST(errors_are_coloured_on_terminals)
{
    static const char red[] = "\033[1;31mgnomon: nothing.obj: cannot be read: No such file or "
                              "directory\033[0m";
    static const struct {
        const char *environment, *arguments, *wanted; /* null: no colour */
    } cases[] = {{"TERM=xterm", "render nothing.obj -o a.png", red},
                 {"TERM=xterm", "paint", "\033[1;31m"},
                 {"TERM=xterm", "render square.obj -o a.png --size 8x8 --near 99",
                  "\033[1;35mgnomon: a.png: warning: "},
                 {"NO_COLOR=1 TERM=xterm", "render nothing.obj -o a.png", NULL},
                 {"TERM=dumb", "render nothing.obj -o a.png", NULL},
                 {"TERM=xterm", "render nothing.obj -o a.png 2>kept; cat kept", NULL}};
    if (!has_program("script", "colours"))
        return;
    for (size_t i = 0; i < COUNT(cases); ++i) {
        run r =
            shell("%s script -qec 'gnomon %s' /dev/null", cases[i].environment, cases[i].arguments);
        const char *wanted = cases[i].wanted != NULL ? cases[i].wanted : "gnomon: nothing.obj";
        const bool is_coloured = strchr(r.out, '\033') != NULL;
        if (strstr(r.out, wanted) == NULL || is_coloured != (cases[i].wanted != NULL))
            fail_run(&r);
    }
}
