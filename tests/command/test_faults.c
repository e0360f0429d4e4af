/* The gnomon command with bad input: exit status, one clear line, nothing left behind. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <gnomon/backend.h>

static bool ends_with_newline(const char *text)
{
    size_t length = strlen(text);
    return length > 0 && text[length - 1] == '\n';
}

/* What fits a screen. */
enum { SCREEN_LINES = 45 };

TEST(help_is_printed)
{
    static const char commands[][24] = {
        "--help",          "render --help",     "compare --help",
        "demo --help",     "render --help-all", "compare --help-all",
        "transform --help"};
    static const char must_have[][3][24] = {{"render", "compare", "demo"},
                                            {"--depth", "--orthographic", "--backend NAME"},
                                            {"_compared.png", "--backend NAME", "--eye"},
                                            {"--shader NAME", "--picture", "--tessellation"},
                                            {"--format NAME", "--near", "--rotate AXIS"},
                                            {"_compared.png", "--far", "--import-memory"},
                                            {"--matrices", "convention", "Exit status"}};
    for (int i = 0; i < 7; ++i) {
        run r = gnomon("%s", commands[i]);
        assert_int_equal(r.status, 0);
        assert_string_equal(r.error, "");
        assert_true(lines(r.out) > 10);
        if (strstr(commands[i], "all") == NULL && lines(r.out) > SCREEN_LINES)
            fail_msg("gnomon %s has %d lines", commands[i], lines(r.out));
        for (int k = 0; k < 3; ++k)
            assert_non_null(strstr(r.out, must_have[i][k]));
        for (char *line = strtok(r.out, "\n"); line != NULL; line = strtok(NULL, "\n"))
            assert_true(strlen(line) <= 90);
    }
    run r = shell("set -e; for c in render compare demo spin view diff info explain transform; do "
                  "\"$GNOMON\" $c --help >asked; \"$GNOMON\" help $c | cmp - asked; \"$GNOMON\" "
                  "--help $c | cmp - asked; \"$GNOMON\" -h $c | cmp - asked; done; "
                  "\"$GNOMON\" --help >asked; \"$GNOMON\" help | cmp - asked");
    assert_int_equal(r.status, 0);
    assert_string_equal(r.error, "");
    r = shell("\"$GNOMON\" render --help >/dev/full");
    assert_int_equal(r.status, 1);
    assert_non_null(strstr(r.error, "standard output"));
}

TEST(usage_errors_are_status_2)
{
    write_text("square.obj", square_obj);
    expect(2, "", "no command", "--help");
    expect(2, "paint", "'paint'", "no such command");
    expect(2, "help paint", "'paint'", "no such command");
    expect(2, "--version paint", "'paint'", "stands alone");
    expect(2, "--help paint", "'paint'", "no such command");
    expect(2, "help render square.obj", "'square.obj'", "one command");
    expect(2, "render", "no model", "render --help");
    expect(2, "render square.obj", "no output", "-o OUT.png");
    expect(2, "render square.obj -o a.png --rotate 90", "--rotate '90'", "AXIS,DEGREES");
    expect(2, "render square.obj -o a.png --rotate w,90", "--rotate 'w,90'", "AXIS,DEGREES");
    expect(2, "render square.obj -o a.png --rotate x", "--rotate", "AXIS,DEGREES");
    expect(2, "render square.obj -o a.png --rotate x,1e99", "--rotate", "AXIS,DEGREES");
    expect(2, "render square.obj -o a.png --scale 1,2", "--scale '1,2'", "three numbers");
    expect(2, "render square.obj -o a.png --translate 1", "--translate '1'", "three numbers");
    expect(2, "render square.obj -o a.png --near here", "--near 'here'", "a distance");
    expect(2, "render square.obj -o a.png --far inf", "--far 'inf'", "finite");
    expect(2, "render square.obj -o a.png --cull left", "--cull 'left'", "none, back or front");
    expect(2, "render square.obj -o a.png --no-depth-test=no", "--no-depth-test", "no value");
    expect(2, "render --help=3", "'--help=3'", "no value allowed");
    expect(2, "render square.obj -o a.png --ba 5", "'--ba'",
           "ambiguous: --bands, --background, --backend");
    expect(2, "render square.obj -o a.png --t=a.png", "'--t=a.png'",
           "ambiguous: --target, --translate, --texture");
    expect(2, "render square.obj -o a.png --points=big", "--points 'big'", "above 0");
    expect(2, "render square.obj -o a.png --points --wireframe", "--points", "together");
    expect(2, "render square.obj --points 5 -o a.png", "'5'", "--points=5");
    expect(2, "render --points 2.5 square.obj -o a.png", "'2.5'", "--points=2.5");
    expect(1, "render --points nothing.obj -o a.png", "nothing.obj", "No such file");
    expect(1, "render --points=3 5 -o a.png", "5", "No such file");
    expect(2, "render '' -o a.png", "''", "an empty file name");
    expect(2, "render square.obj -o a.png -- ''", "''", "an empty file name");
    expect(2, "diff '' ''", "''", "an empty file name");
    expect(2, "compare ''", "''", "an empty file name");
    expect(2, "spin ''", "''", "an empty file name");
    expect(2, "view ''", "''", "an empty file name");
    expect(2, "explain '' --pixel 1,1", "''", "an empty file name");
    expect(2, "render square.obj -o - --format jpg", "--format 'jpg'", "png, tga, ppm or raw");
    expect(2, "render square.obj -o a.tga --format tga", "--format", "'a.tga' has one");
    expect(2, "compare square.obj --format tga", "'--format'", "unknown option");
    expect(2, "demo --rotate x,90", "'--rotate'", "unknown option");
    expect(2, "render square.obj -o a.png --nonsense", "'--nonsense'", "unknown option");
    expect(2, "render square.obj -o a.png -q", "'-q'", "unknown option");
    expect(2, "render square.obj -o a.png --picture b.png", "'--picture'", "unknown option");
    expect(2, "render square.obj -o", "'-o'", "no value");
    expect(2, "render square.obj -o a.png --eye", "'--eye'", "no value");
    expect(2, "render square.obj -o ''", "-o", "a file name");
    expect(2, "render square.obj -o a.png --size 100", "--size '100'", "WIDTHxHEIGHT");
    expect(2, "render square.obj -o a.png --size 100x", "--size", "WIDTHxHEIGHT");
    expect(2, "render square.obj -o a.png --size 5x5x5", "--size", "WIDTHxHEIGHT");
    expect(2, "render square.obj -o a.png --eye 1,2", "--eye '1,2'", "X,Y,Z");
    expect(2, "render square.obj -o a.png --eye 1,2,3,4", "--eye", "X,Y,Z");
    expect(2, "render square.obj -o a.png --target 1,nan,3", "--target", "X,Y,Z");
    expect(2, "render square.obj -o a.png --up 1,2,1e99", "--up", "X,Y,Z");
    expect(2, "render square.obj -o a.png --light here", "--light 'here'", "X,Y,Z");
    expect(2, "render square.obj -o a.png --fov wide", "--fov 'wide'", "degrees");
    expect(2, "render square.obj -o a.png --orthographic 2m", "--orthographic", "height");
    expect(2, "render square.obj -o a.png --shader velvet", "--shader 'velvet'", "gouraud");
    expect(2, "render square.obj -o a.png --background red", "--background", "#rrggbb");
    expect(2, "render square.obj -o a.png --background 12345", "--background", "#rrggbb");
    expect(2, "render square.obj -o a.png --fov 40 --orthographic 2", "--fov", "together");
    expect(2, "render square.obj -o a.png --texture a.png --shader normals", "--texture",
           "--shader normals");
    expect(2, "render square.obj -o a.png --glow-map a.png --shader toon", "--glow-map",
           "--shader toon");
    expect(2, "render square.obj -o a.png --shadows --shader gouraud", "--shadows",
           "--shader gouraud");
    expect(2, "render square.obj -o a.png --texture ''", "--texture", "a file name, or none");
    expect(2, "render square.obj -o a.png --normal-map a.png", "--normal-map 'a.png'",
           "world:FILE");
    expect(2, "render square.obj -o a.png --normal-map world:", "--normal-map", "world:FILE");
    expect(2, "render square.obj -o a.png --normal-map none:a.png", "--normal-map", "world:FILE");
    expect(2, "render square.obj -o a.png --normal-map any:a.png", "--normal-map", "world:FILE");
    expect(2, "render square.obj -o a.png --filter cubic", "--filter 'cubic'", "nearest");
    expect(2, "render square.obj -o a.png --exponent 2.5", "--exponent", "whole number");
    expect(2, "render square.obj -o a.png --bands few", "--bands 'few'", "from 2 to 256");
    expect(2, "demo --shader velvet", "--shader 'velvet'", "blinn-phong");
    expect(2, "demo --normal-map world:a.png", "--normal-map", "no file");
    expect(2, "demo --texture a.png", "'--texture'", "unknown option");
    expect(2, "render square.obj -o a.png --backend mmx", "--backend 'mmx'", "portable, sse2");
    expect(2, "compare square.obj --backend ''", "--backend ''", "portable, sse2");
    expect(2, "compare square.obj --backend unknown", "--backend", "portable, sse2");
    expect(2, "demo --backend auto", "'--backend'", "unknown option");
    expect(2, "render square.obj -o a.png --samples 4x", "--samples '4x'", "1 or 4");
    expect(2, "demo --samples ''", "--samples", "1 or 4");
    expect(2, "compare square.obj --samples 4 --wireframe", "--wireframe", "OSMesa");
    expect(2, "compare", "no model", "compare --help");
    expect(2, "compare square.obj --depth d.png", "'--depth'", "unknown option");
    expect(2, "demo square.obj", "'square.obj'", "no model");
    expect(2, "demo --tessellation many", "--tessellation 'many'", "whole number from 1 to 128");
    expect(2, "demo --tessellation 1.5", "--tessellation '1.5'", "whole number from 1 to 128");
    expect(2, "demo --tessellation -", "--tessellation '-'", "whole number from 1 to 128");
    expect(2, "spin --frames ''", "--frames ''", "whole number from 1 to 100000");
}

TEST(impossible_values_are_status_1)
{
    write_text("square.obj", square_obj);
    expect(1, "render square.obj -o a.png --size 0x5", "--size", "1048576");
    expect(1, "render square.obj -o a.png --size 5x0", "--size", "1048576");
    expect(1, "render square.obj -o a.png --size 1048577x5", "--size", "1048576");
    expect(1, "render square.obj -o a.png --size 5x99999999999999999999", "--size", "1048576");
    expect(1, "spin square.obj --size 16385x5", "--size", "16384");
    expect(2, "render square.obj -o a.tga --size 65536x5", "--size 65536x5", "65535x65535");
    expect(2, "render square.obj -o a.png --size 16385x5 --statistics", "--statistics", "16384");
    expect(2, "render square.obj -o a.png --size 16385x5 --sort last", "--sort last", "16384");
    expect(2, "render square.obj -o a.png --sort last --no-depth-test", "--sort last",
           "--no-depth-test");
    expect(2, "render square.obj -o a%d.png --views v --sort last", "--sort", "--views");
    expect(1, "render square.obj -o a%d.png --views v --size 16385x5", "--size", "16384");
    expect(2, "render square.obj -o a.png --sort middle", "--sort 'middle'", "first or last");
    expect(2, "spin square.obj -o a --format raw", "--format 'raw'", "png, tga or ppm");
    expect(1, "render square.obj -o a.png --eye 1,2,3 --target 1,2,3", "--eye", "target");
    expect(1, "render square.obj -o a.png --eye 0,0,0", "--eye", "target");
    expect(1, "render square.obj -o a.png --eye 0,0,5 --up 0,0,1", "--up", "parallel");
    expect(1, "render square.obj -o a.png --eye 0,0,5 --up 0,0,-3", "--up", "parallel");
    expect(1, "render square.obj -o a.png --up 0,0,0", "--up", "zero");
    expect(1, "render square.obj -o a.png --fov 0", "--fov", "180");
    expect(1, "render square.obj -o a.png --fov -10", "--fov", "180");
    expect(1, "render square.obj -o a.png --fov 180", "--fov", "180");
    expect(1, "render square.obj -o a.png --orthographic 0", "--orthographic", "above 0");
    expect(1, "render square.obj -o a.png --light 0,0,0", "--light", "zero");
    expect(1, "render square.obj -o a.png --near 0", "--near", "above 0");
    expect(1, "render square.obj -o a.png --far -1", "--far", "above 0");
    expect(1, "render square.obj -o a.png --near 2 --far 2", "--far", "beyond --near");
    expect(1, "render square.obj -o a.png --rotate 0,0,0,90", "--rotate", "'0,0,0,90'");
    expect(1, "render square.obj -o a.png --scale 1,0,1", "--scale", "singular");
    expect(1, "render square.obj -o a.png --translate 3e38,0,0 --translate 3e38,0,0", "--translate",
           "range");
    expect(1, "render square.obj -o a.png --eye 3e38,3e38,3e38 --target -3e38,0,0", "--eye",
           "impossible");
    expect(1, "render square.obj -o a.png --fov 1e-30", "--fov", "impossible");
    expect(1, "render square.obj -o a.png --orthographic 1e-45", "--orthographic", "impossible");
    expect(1, "render square.obj -o a.png --near 1e-45", "--near", "impossible");
    /* The option without which there would be a camera. */
    expect(1, "render square.obj -o a.png --eye 0,0,3 --near 1e-44", "--near: ", "impossible");
    expect(1, "render square.obj -o a.png --eye 0,0,3 --far 1e-44", "--far: ", "impossible");
    expect(1, "render square.obj -o a.png --eye 0,0,3 --fov 1e-40", "--fov: ", "impossible");
    expect(1, "render square.obj -o a.png --target 0,0,1 --orthographic 1e-44",
           "--orthographic: ", "impossible");
    expect(1, "render square.obj -o a.png --fov 50 --near 1e-44", "--near: ", "impossible");
    expect(1, "render square.obj -o a.png --fov 50 --eye 0,0,3e38", "--eye: ", "impossible");
    expect(1, "render square.obj -o a.png --near 1 --target 0,0,3e38", "--target: ", "impossible");
    expect(1, "render square.obj -o a.png --target 1e9,1e9,1e9", "--target: ", "where the target");
    write_text("huge.obj", "v 3e38 0 0\nv -3e38 0 0\nv 0 3e38 0\nf 1 2 3\n");
    expect(1, "render huge.obj -o a.png", "models", "too large");
    expect(1, "render huge.obj -o a.png --fov 50 --near 1", "models", "too large");
    expect(1, "compare square.obj --size 0x0", "--size", "16384");
    expect(1, "demo --size 0x0", "--size", "16384");
    expect(1, "render square.obj -o a.png --size -5x5", "--size", "1048576");
    expect(1, "demo --tessellation 0", "--tessellation", "'0': not a whole number from 1 to 128");
    expect(1, "demo --tessellation 1000", "--tessellation", "128");
    expect(1, "demo --tessellation -3", "--tessellation", "'-3': not a whole number from 1 to 128");
    expect(1, "demo --tessellation 4294967297", "--tessellation", "128");
    expect(1, "render square.obj -o a.png --exponent 0", "--exponent", "'0': not a whole number");
    expect(1, "render square.obj -o a.png --exponent 1025", "--exponent", "from 1 to 1024");
    expect(1, "render square.obj -o a.png --bands 1", "--bands", "from 2 to 256");
    expect(1, "render square.obj -o a.png --points=0", "--points", "above 0");
    expect(1, "render square.obj -o a.png --points=-2", "--points", "above 0");
    expect(1, "render square.obj -o a.png --samples 2", "--samples", "1 or 4");
    expect(1, "spin --frames 0", "--frames", "from 1 to 100000");
    expect(1, "spin --rate 1001", "--rate", "from 1 to 1000");
    expect(1, "info square.obj --import-seconds 86401", "--import-seconds", "from 1 to 86400");
    expect(1, "info square.obj --import-memory 0", "--import-memory", "MiB from 1 to 1048576");
}

TEST(bad_models_are_named)
{
    expect(1, "render nothing.obj -o a.png", "nothing.obj", "No such file");
    mkdir(path_of("folder.obj"), 0777);
    expect(1, "render folder.obj -o a.png", "folder.obj", "directory");
    write_text("empty.obj", "");
    expect(1, "render empty.obj -o a.png", "empty.obj", "empty");
    write_text("noise.xyzzy", "this is no model of any kind\n");
    expect(1, "render noise.xyzzy -o a.png", "noise.xyzzy", "OBJ, PLY, STL");
    write_text("noise.ply", "ply\nformat ascii 1.0\nelement vertex 3\n");
    expect(1, "render noise.ply -o a.png", "noise.ply", "header");
    write_text("vertices.obj", "vn 0 0 1\nvt 0 0\n");
    expect(1, "render vertices.obj -o a.png", "vertices.obj", "no triangles, lines or points");
    write_text("infinite.obj", "v 0 0 0\nv 1 0 0\nv 0 inf 0\nf 1 2 3\n");
    expect(1, "render infinite.obj -o a.png", "infinite.obj", "finite");
    expect(1, "compare nothing.obj -o a.png", "nothing.obj", "No such file");
    write_text("line\nbreak.obj", "");
    expect(1, "render 'line\nbreak.obj' -o a.png", "line\\x0abreak.obj", "empty");
}

TEST(bad_textures_are_named)
{
    write_text("square.obj", square_obj);
    write_text("noise.png", "this is no image");
    write_text("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expect(1, "render square.obj -o a.png --texture none.png", "none.png", "No such file");
    expect(1, "render square.obj -o a.png --texture noise.png", "noise.png", "texture");
    expect(1, "render square.obj -o a.png --texture .", ".", "directory");
    /* 8x8 texels of 24 bits are announced, one is there. */
    static const uint8_t short_tga[21] = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 8, 0, 8, 0, 24, 0};
    write_bytes("short.tga", short_tga, sizeof short_tga);
    expect(1, "render square.obj -o a.png --texture short.tga", "short.tga", "cut short");
    expect(1, "render bare.obj -o a.png --texture noise.png", "bare.obj", "coordinates");
    expect(1, "render bare.obj -o a.png --normal-map world", "bare.obj", "coordinates");
    expect(1, "render square.obj -o a.png --specular-map none.tga", "none.tga", "No such file");
    expect(1, "render square.obj -o a.png --glow-map noise.png", "noise.png", "--glow-map none");
    expect(1, "render square.obj -o a.png --normal-map world:none.png", "none.png",
           "--normal-map none");
    expect(1, "render square.obj -o a.png --normal-map tangent:noise.png", "noise.png", "texture");
    expect(1, "render square.obj -o a.png --normal-map tangent", "_nm_tangent", "tangent:FILE");
    expect(1, "render square.obj -o a.png --normal-map world", "_nm.tga", "world:FILE");
    write_text("named.mtl", "newmtl skin\nKd 1 0 0\nmap_Kd gone.png\n");
    char named[1024] = "mtllib named.mtl\nusemtl skin\n";
    strcat(named, square_obj);
    write_text("named.obj", named);
    expect(1, "render named.obj -o a.png", "named.obj", "gone.png");
    expect(1, "render named.obj -o a.png", "No such file", "--texture none");
    expect(1, "compare named.obj -o a.png", "named.obj", "gone.png");
    write_text("gone.png", "this is no image either");
    expect(1, "render named.obj -o a.png", "named.obj", "gone.png");
    remove_file("gone.png");
    run r = gnomon("render named.obj -o a.png --texture none --size 8x8");
    assert_int_equal(r.status, 0);
    assert_true(exists("a.png"));
    remove_file("a.png");

    write_text("head.obj", square_obj);
    write_text("head_diffuse.png", "this is no image");
    expect(1, "render head.obj -o a.png", "head_diffuse.png", "texture");
    remove_file("head_diffuse.png");
    static const char suffixes[][24] = {"_nm", "_nm_tangent", "_spec", "_glow"};
    static const char options[][24] = {"--normal-map none", "--normal-map none",
                                       "--specular-map none", "--glow-map none"};
    for (int i = 0; i < 4; ++i) {
        char name[128];
        snprintf(name, sizeof name, "head%s.jpg", suffixes[i]);
        write_text(name, "this is no image");
        expect(1, "render head.obj -o a.png --shader phong", name, options[i]);
        char line[160];
        snprintf(line, sizeof line, "render head.obj -o a.png --size 8x8 %s", options[i]);
        r = gnomon("%s", line);
        assert_int_equal(r.status, 0);
        remove_file(name);
        remove_file("a.png");
    }
}

TEST(outputs_are_whole_or_absent)
{
    static const char old[] = "what was there before";
    write_text("square.obj", square_obj);
    write_text("kept.png", old);
    expect(1, "render nothing.obj -o kept.png", "nothing.obj", "");
    expect(1, "render square.obj -o nowhere/a.png", "nowhere/a.png", "No such file");
    mkdir(path_of("folder.png"), 0777);
    expect(1, "render square.obj -o folder.png", "folder.png", "directory");
    expect(1, "render square.obj -o square.obj", "square.obj", "overwritten");
    expect(1, "render square.obj -o ./square.obj", "square.obj", "overwritten");
    expect(1, "compare square.obj -o ./square.obj", "square.obj", "overwritten");
    expect(1, "render square.obj -o a.png --depth a.png", "a.png", "both");
    expect(1, "demo -o a.png --picture a.png", "a.png", "both");
    expect(1, "compare square.obj --texture square_compared.png", "square_compared.png",
           "overwritten");
    expect(1, "render square.obj --glow-map ./kept.png -o kept.png", "kept.png", "overwritten");
    expect(1, "render square.obj --normal-map world:kept.png --depth kept.png -o a.png", "kept.png",
           "overwritten");
    expect(1, "render square.obj -o a.png --depth nowhere/d.png", "nowhere/d.png", "No such file");
    expect(1, "render square.obj -o kept.png --depth nowhere/d.png", "nowhere/d.png",
           "No such file");
    expect(1, "render square.obj -o /dev/full", "/dev/full", "No space");
    /* The pictures are so small that the full disk shows only when the file is closed. */
    expect(1, "render square.obj -o /dev/full --depth d.png --size 8x8", "/dev/full", "No space");
    expect(1, "render square.obj -o a.png --depth /dev/full --size 8x8", "/dev/full", "No space");
    expect(1, "render square.obj -o kept.png --depth /dev/full --size 8x8", "/dev/full",
           "No space");

    /* A limit on the file's size, in blocks of 512 bytes. Its signal is ignored, so that writing
     * fails. */
    static const char *const limited[] = {
        "render square.obj -o kept.png --size 2000x2000 --orthographic 3",
        "render square.obj -o kept.tga --size 200x200",
        "render square.obj -o - --size 2000x2000 --orthographic 3 >kept.tga",
        "render square.obj -o - --format ppm --size 200x200 >kept.tga",
        "render square.obj -o /dev/null --depth kept.png --size 2000x2000 --rotate x,20",
        "spin square.obj -o kept.png --size 200x200 --frames 9"};
    for (size_t i = 0; i < COUNT(limited); ++i) {
        char line[256];
        const bool is_standard = strchr(limited[i], '>') != NULL;
        write_text("kept.tga", old);
        runner_mark();
        snprintf(line, sizeof line, "(ulimit -f 1; exec \"$GNOMON\" %s)", limited[i]);
        run r = shell(line);
        if (r.status != 1 || lines(r.error) != 1 ||
            strstr(r.error, is_standard ? "gnomon: -: " : "gnomon: kept.") == NULL ||
            strstr(r.error, "cannot be written: File too large") == NULL)
            fail_msg("%s: status %d, %s", line, r.status, r.error);
        assert_int_equal(new_files(), 0);
    }

    char text[64] = "";
    FILE *file = fopen(path_of("kept.png"), "rb");
    assert_non_null(file);
    assert_non_null(fgets(text, sizeof text, file));
    fclose(file);
    assert_string_equal(text, old);
}

TEST(one_file_has_many_names)
{
    write_text("square.obj", square_obj);
    mkdir(path_of("below"), 0777);
    run r = shell("ln -sfn . here; ln -sf square.obj other.obj");
    assert_int_equal(r.status, 0);
    /* None of the pictures exists yet. */
    expect(1, "render square.obj -o same.png --depth ./same.png", "same.png", "both");
    expect(1, "render square.obj -o same.png --depth below/../same.png", "same.png", "both");
    expect(1, "render square.obj -o here/same.png --depth \"$PWD/same.png\"", "same.png", "both");
    expect(1, "demo --picture ./gnomon-demo.png", "gnomon-demo.png", "both");
    expect(1, "render square.obj -o other.obj", "square.obj", "overwritten");

    /* One name in two directories is two files, and two names in one directory are two files. */
    r = gnomon("render square.obj -o two.png --depth below/two.png --size 4x4");
    assert_int_equal(r.status, 0);
    assert_true(exists("two.png") && exists("below/two.png"));
    r = gnomon("render square.obj -o below/four.png --depth four.png --size 4x4");
    assert_int_equal(r.status, 0);
    assert_true(exists("four.png") && exists("below/four.png"));
    r = gnomon("render square.obj -o one.png --depth ./three.png --size 4x4");
    assert_int_equal(r.status, 0);
    assert_true(exists("one.png") && exists("three.png"));

    /* The pictures exist here. */
    expect(1, "render square.obj -o two.png --depth ./two.png", "two.png", "both");
    r = gnomon("render square.obj -o two.png --depth below/two.png --size 4x4");
    assert_int_equal(r.status, 0);
}

/* A back end may be missing here, but then the command says so. --help names each. */
TEST(every_backend_gives_the_same_picture)
{
    write_text("square.obj", square_obj);
    const run help = gnomon("render --help-all");
    run r = gnomon("render square.obj -o auto.png --size 61x47");
    assert_int_equal(r.status, 0);
    for (int i = 0; i < GN_BACKEND_COUNT; ++i) {
        const char *const name = gn_backend_name((gn_backend)i);
        char first[128];
        assert_non_null(strstr(help.out, name));
        remove_file("named.png");
        r = gnomon("render square.obj -o named.png --size 61x47 --backend %s", name);
        assert_int_equal(r.status == 0, gn_backend_available((gn_backend)i));
        if (r.status == 0) {
            r = shell("cmp auto.png named.png");
            assert_int_equal(r.status, 0);
            r = gnomon("compare square.obj -o named.png --size 61x47 --backend %s", name);
            assert_int_equal(r.status, 0);
            continue;
        }
        snprintf(first, sizeof first, "--backend: %s is not available", name);
        for (int k = 0; k < 2; ++k) {
            char line[160];
            snprintf(line, sizeof line, "%s square.obj -o named.png --backend %s",
                     k == 0 ? "render" : "compare", name);
            expect(1, line, first, "processor");
        }
    }
}

static void write_grid(const char *name, int size)
{
    FILE *file = fopen(path_of(name), "w");
    assert_non_null(file);
    for (int i = 0; i < size * size; ++i)
        fprintf(file, "v %d %d 0\n", i % size, i / size);
    for (int i = size + 1; i < size * size; ++i)
        if (i % size != 0)
            fprintf(file, "f %d %d %d %d\n", i - size, i - size + 1, i + 1, i);
    assert_int_equal(fclose(file), 0);
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
static bool ends_with_own_line(char *text)
{
    if (!ends_with_newline(text))
        return false;
    text[strlen(text) - 1] = '\0';
    char *last = strrchr(text, '\n');
    return strncmp(last != NULL ? last + 1 : text, "gnomon: ", 8) == 0;
}

/* Runs with more and more address space, from `least` MiB on. Every run succeeds or ends with the
 * command's own line about memory. Returns the number of runs that did not succeed. */
static int count_failures(const char *arguments, int least)
{
    int failures = 0;
    for (int extra = 0; extra <= 96; extra += 4) {
        char line[256];
        snprintf(line, sizeof line, "ulimit -v %d; exec \"$GNOMON\" %s", 1024 * (least + extra),
                 arguments);
        run r = shell(line);
        if (r.status == 0)
            continue;
        ++failures;
        if (r.status != 1 || strstr(r.error, "memory") == NULL || !ends_with_own_line(r.error))
            fail_msg("%s: status %d, %s", line, r.status, r.error);
    }
    return failures;
}

TEST(short_memory_is_said)
{
    int least = 16;
    if (!little_memory_works())
        return;
    for (; least < 4096; least += 16) {
        char line[160];
        snprintf(line, sizeof line, "ulimit -v %d; exec \"$GNOMON\" --help", 1024 * least);
        if (shell(line).status == 0)
            break;
    }
    write_text("square.obj", square_obj);
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
    run r = shell("mkfifo pipe.txt; \"$GNOMON\" transform pipe.txt & "
                  "exec 3>pipe.txt; kill -ABRT $!; wait $!");
    assert_int_equal(r.status, 1);
    assert_int_equal(lines(r.error), 1);
    assert_true(ends_with_own_line(r.error));
    remove_file("pipe.txt");
}

TEST(outputs_replace_what_was_there)
{
    struct stat status;
    write_text("square.obj", square_obj);
    write_text("old.png", "old");
    chmod(path_of("old.png"), 0640);
    run r = shell("ln -sf old.png link.png && \"$GNOMON\" render square.obj -o link.png "
                  "--size 4x4");
    assert_int_equal(r.status, 0);
    assert_int_equal(lstat(path_of("link.png"), &status), 0);
    assert_true(S_ISLNK(status.st_mode));
    picture p = picture_read("old.png");
    assert_int_equal(p.width, 4);
    picture_free(&p);
    assert_int_equal(stat(path_of("old.png"), &status), 0);
    assert_int_equal(status.st_mode & 0777, 0640);

    r = shell("umask 027; \"$GNOMON\" render square.obj -o fresh.png --size 4x4");
    assert_int_equal(r.status, 0);
    assert_int_equal(stat(path_of("fresh.png"), &status), 0);
    assert_int_equal(status.st_mode & 0777, 0640);

    r = gnomon("render square.obj -o /dev/null --size 4x4");
    assert_int_equal(r.status, 0);
    assert_int_equal(stat("/dev/null", &status), 0);
    assert_true(S_ISCHR(status.st_mode));
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
    write_text("square.obj", square_obj);
    for (size_t i = 0; i < COUNT(cases); ++i) {
        char line[256];
        snprintf(line, sizeof line, "%s script -qec '\"$GNOMON\" %s' /dev/null",
                 cases[i].environment, cases[i].arguments);
        run r = shell(line);
        const char *wanted = cases[i].wanted != NULL ? cases[i].wanted : "gnomon: nothing.obj";
        const bool is_coloured = strchr(r.out, '\033') != NULL;
        if (strstr(r.out, wanted) == NULL || is_coloured != (cases[i].wanted != NULL))
            fail_msg("%s: %s", line, r.out);
    }
}
