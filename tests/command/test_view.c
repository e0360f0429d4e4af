/* gnomon view: a script plays the part of the user, and what is saved is what gnomon render draws
 * with the camera that the window prints. The tests run with SDL's driver that shows nothing, and
 * once under Xvfb, where the screen is looked at. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char tetra_obj[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

#define VIEW "SDL_VIDEODRIVER=dummy timeout 60 \"$GNOMON\" view "

static void need_sdl(void)
{
    static bool is_there;
    write_text("tetra.obj", tetra_obj);
    write_text("end.txt", "key q\n");
    is_there = is_there || strstr(shell(VIEW "tetra.obj --script end.txt").error, "SDL2") == NULL;
    if (!is_there)
        skip();
}

static run play(const char *script, const char *options)
{
    char line[1024];
    need_sdl();
    write_text("tetra.obj", tetra_obj);
    write_text("script.txt", script);
    snprintf(line, sizeof line, VIEW "--script script.txt %s", options);
    return shell(line);
}

/* The options of the last "as with" line. */
static const char *last_options(run *r)
{
    static const char words[] = "as with ";
    char *found = NULL;
    for (char *at = r->out; (at = strstr(at, words)) != NULL; ++at)
        found = at + strlen(words);
    if (found == NULL)
        fail_msg("nothing was saved: %s%s", r->out, r->error);
    found[strcspn(found, "\n")] = '\0';
    return found;
}

/* Plays the script, whose last event saves, and draws the same picture with render. */
static void expect_same(const char *script, const char *options)
{
    char line[2048];
    remove_file("view.png");
    run r = play(script, options);
    if (r.status != 0 || r.error[0] != '\0')
        fail_msg("%s: status %d, %s%s", script, r.status, r.out, r.error);
    snprintf(line, sizeof line,
             "\"$GNOMON\" render %s %s -o render.png && \"$GNOMON\" diff view.png render.png",
             options, last_options(&r));
    r = shell(line);
    if (r.status != 0)
        fail_msg("%s\n%s\n%s%s", script, line, r.out, r.error);
}

TEST(saved_pictures_are_those_of_render)
{
    expect_same("key s\n", "tetra.obj --size 120x90");
    expect_same("drag 40 -25\nkey s\n", "tetra.obj --size 120x90");
    expect_same("drag 10 2000\nkey s\n", "tetra.obj --size 120x90");
    expect_same("pan 30 20\nwheel 4\nkey s\n", "tetra.obj --size 120x90 --up 0,0,1");
    expect_same("pan 9 -9\nwheel -2\nkey s\n", "tetra.obj --size 90x120 --orthographic 3");
    expect_same("key 7\nkey h\nkey m\nkey s\n", "tetra.obj --size 90x60");
    expect_same("key h\nkey 4\nkey s\n", "tetra.obj --size 90x60");
    expect_same("key w\nkey s\n", "tetra.obj --size 90x60");
    expect_same("key p\nkey s\n", "tetra.obj --size 90x60");
    expect_same("key c\nkey s\n", "tetra.obj --size 90x60 --points=4");
    expect_same("key +\nkey -\nkey +\nkey c\nkey c\nkey s\n", "tetra.obj --size 90x60");
    expect_same("resize 77 55\nresize 77 56\nkey s\n", "tetra.obj --size 90x60");
}

/* The shaders of all keys, with files of all maps and with a space of normals: what is printed fits
 * behind these options. */
TEST(maps_that_a_shader_lacks_are_left_out)
{
    static const char *const given[] = {
        "--texture map.ppm --specular-map map.ppm --glow-map map.ppm",
        "--normal-map tangent:map.ppm --specular-map map.ppm", "--normal-map tangent", ""};
    char script[64], options[256];
    write_text("uv.mtl", "newmtl red\nKd 1 0 0\nmap_Kd map.ppm\n");
    snprintf(options, sizeof options, "mtllib uv.mtl\nusemtl red\n%s", square_obj);
    write_text("uv.obj", options);
    write_text("map.ppm", "P6 2 1 255\n\x10\x90\x30\xf0\x20\x80");
    run r = shell("\"$GNOMON\" render uv.obj --texture none --size 8x8 -o uv_nm_tangent.tga");
    assert_int_equal(r.status, 0);
    for (size_t i = 0; i < COUNT(given); ++i) {
        snprintf(options, sizeof options, "uv.obj --size 32x32 %s", given[i]);
        for (int key = 0; key <= 9; ++key) {
            snprintf(script, sizeof script, "key %d\nkey s\n", key);
            expect_same(script, options);
        }
    }
    expect_same("key s\n", "uv.obj --size 32x32 --shader vertex-color");

    /* Maps are named only if the shader takes them. */
    r = play("key s\n", "uv.obj --size 32x32 --shader vertex-color");
    assert_null(strstr(r.out, "maps:"));
    r = play("key 5\nkey s\n", "uv.obj --size 32x32");
    assert_non_null(strstr(r.out, "\nmaps: diffuse map.ppm\n"));
    r = play("key 8\nkey s\n", "uv.obj --size 32x32");
    assert_null(strstr(r.out, "diffuse"));
    assert_non_null(strstr(r.out, "\nmaps: tangent-space normals uv_nm_tangent.tga\n"));
    r = play("key 6\nkey s\n", "uv.obj --size 32x32");
    assert_non_null(
        strstr(r.out, "\nmaps: diffuse map.ppm, tangent-space normals uv_nm_tangent.tga\n"));
}

/* Options that nothing on the command line can undo are named. */
TEST(options_to_leave_out_are_named)
{
    static const struct {
        const char *script, *left_out, *words;
    } cases[] = {
        {"key h\nkey s\n", "--shader phong --shadows", "without --shadows\n"},
        {"key 4\nkey s\n", "--shadows", "without --shadows\n"},
        {"key w\nkey s\n", "--wireframe", "without --wireframe\n"},
        {"key w\nkey s\n", "--points=3", "without --points\n"},
        {"key p\nkey s\n", "--wireframe", "without --wireframe\n"},
        {"key 1\nkey p\nkey s\n", "--shadows --points=3", "without --shadows, --points\n"},
    };
    char line[2048];
    for (size_t i = 0; i < COUNT(cases); ++i) {
        snprintf(line, sizeof line, "tetra.obj --size 40x30 %s", cases[i].left_out);
        run r = play(cases[i].script, line);
        assert_int_equal(r.status, 0);
        const char *words = strstr(r.out, "\nwithout ");
        if (words == NULL || strcmp(words + 1, cases[i].words) != 0)
            fail_msg("%s: %s", cases[i].script, r.out);
        snprintf(line, sizeof line,
                 "\"$GNOMON\" render tetra.obj %s -o render.png && \"$GNOMON\" diff view.png "
                 "render.png",
                 last_options(&r));
        r = shell(line);
        if (r.status != 0)
            fail_msg("%s\n%s%s", line, r.out, r.error);
    }
    run r = play("key s\n", "tetra.obj --size 40x30 --shader phong --shadows --points");
    assert_non_null(strstr(r.out, "--shadows"));
    assert_null(strstr(r.out, "without"));
}

/* Blanks, comments, ends of lines and a byte-order mark are as in files of views. */
TEST(scripts_are_texts)
{
    static const char *const scripts[] = {
        "key w # edges\nkey s # end\n",
        "  key w\n\tkey s\n",
        "key w\r\nkey s\r\n",
        "\xef\xbb\xbfkey w\nkey s",
        "\xef\xbb\xbf# edges\n \t# and\n\nkey\tw\t#e\nkey s \n",
        "# A comment that is longer than a line of a terminal, which is eighty characters wide.\n"
        "key w # and behind an event a comment that is longer than a line of a terminal too.\n"
        "key s\n",
        "key #\nkey # # the key, which has no meaning\n#key w\nkey w\nkey s\n",
    };
    run r = play("key w\nkey s\n", "tetra.obj --size 40x30 -o plain.png");
    assert_int_equal(r.status, 0);
    for (size_t i = 0; i < COUNT(scripts); ++i) {
        remove_file("view.png");
        r = play(scripts[i], "tetra.obj --size 40x30");
        if (r.status != 0 || r.error[0] != '\0')
            fail_msg("%s: status %d, %s", scripts[i], r.status, r.error);
        r = shell("cmp view.png plain.png");
        if (r.status != 0)
            fail_msg("%s: another picture", scripts[i]);
    }
}

TEST(wrong_lines_of_scripts_are_named)
{
    static const char *const lines_of_scripts[] = {
        "key",        "key #x",    "key # x",   "key q#",     "key q q", "drag 1",
        "drag 1 2 3", "wheel 1.5", "wheel # 1", "resize 0 5", "wait -1", "keys q"};
    static const char zero[] = "key w\nkey q\0x\n";
    char text[64];
    for (size_t i = 0; i < COUNT(lines_of_scripts); ++i) {
        snprintf(text, sizeof text, "\n%s\nkey q\n", lines_of_scripts[i]);
        run r = play(text, "tetra.obj");
        if (r.status != 2 || lines(r.error) != 1 ||
            strstr(r.error, "gnomon: script.txt:2: not an event: ") != r.error)
            fail_msg("%s: status %d, %s", text, r.status, r.error);
    }
    write_bytes("zero.txt", zero, sizeof zero - 1);
    expect(2, "view tetra.obj --script zero.txt", "zero.txt:2", "zero byte");
}

/* Draws with render as the window begins; what then happens must change the picture, or not. */
static void expect_change(const char *script, bool changes)
{
    char line[256];
    snprintf(line, sizeof line, "%skey s\n", script);
    run r = play(line, "tetra.obj --size 120x90");
    assert_int_equal(r.status, 0);
    r = shell(
        "\"$GNOMON\" render tetra.obj --size 120x90 -o first.png && cmp -s view.png first.png");
    if (r.status != changes)
        fail_msg("%s: status %d", script, r.status);
}

TEST(events_change_the_picture)
{
    static const char *const changes[] = {
        "drag 40 0\n", "drag 0 40\n", "pan 20 0\n", "pan 0 20\n", "wheel 1\n",
        "key +\n",     "key w\n",     "key p\n",    "key 9\n",    "key c\nkey c\n"};
    expect_change("", false);
    for (size_t i = 0; i < COUNT(changes); ++i) {
        char line[64];
        expect_change(changes[i], true);
        /* The first view comes back. */
        if (i < 6) {
            snprintf(line, sizeof line, "%skey r\n", changes[i]);
            expect_change(line, false);
        }
    }
    expect_change("key w\nkey w\n", false);
    expect_change("key p\nkey p\n", false);
    expect_change("key 9\nkey 0\n", false);
    expect_change("key c\nkey c\nkey c\n", false);
    expect_change("drag 0 0\nwait 10\n# nothing\n\n", false);
}

/* 225 pixels of 0.4 degrees are a quarter turn: from +z to -x. */
TEST(drags_turn_around_the_target)
{
    run r = play("drag 225 0\nkey s\n", "tetra.obj --eye 0,0,5 --target 0,0,0 --size 40x30");
    float x, y, z;
    assert_int_equal(sscanf(last_options(&r), "--eye %f,%f,%f", &x, &y, &z), 3);
    assert_true(x < -4.9999f && x > -5.0001f && y > -1e-5f && y < 1e-5f && z > -1e-5f && z < 1e-5f);
    r = play("drag 0 100\nkey s\n", "tetra.obj --eye 0,0,5 --target 0,0,0 --size 40x30");
    assert_int_equal(sscanf(last_options(&r), "--eye %f,%f,%f", &x, &y, &z), 3);
    assert_true(y > 3.2139f && y < 3.2140f); /* 5 sin 40 degrees */
    r = play("wheel 2\nkey s\n", "tetra.obj --eye 0,0,5 --target 0,0,0 --size 40x30");
    assert_int_equal(sscanf(last_options(&r), "--eye %f,%f,%f", &x, &y, &z), 3);
    assert_true(z > 4.0499f && z < 4.0501f);
    /* At an angle of 90 degrees and distance 5, 30 pixels are 10 units. */
    r = play("pan 30 -15\nkey s\n", "tetra.obj --eye 0,0,5 --target 0,0,0 --size 40x30 --fov 90");
    assert_int_equal(sscanf(last_options(&r), "--eye %f,%f,%f", &x, &y, &z), 3);
    assert_true(x < -9.999f && x > -10.001f && y < -4.999f && y > -5.001f && z > 4.9999f);
}

TEST(wrong_use_is_named)
{
    need_sdl();
    write_text("tetra.obj", tetra_obj);
    write_text("wrong.txt", "key s\njump 3\n");
    write_text("long.txt", "key sssss\n");
    write_text("far.txt", "drag 99999999 1\n");
    expect(2, "view", "no model", "view --help");
    expect(2, "view tetra.obj --depth d.png", "--depth", "unknown option");
    expect(2, "view tetra.obj --script wrong.txt", "wrong.txt:2", "not an event");
    expect(2, "view tetra.obj --script long.txt", "long.txt:1", "not an event");
    expect(2, "view tetra.obj --script far.txt", "far.txt:1", "not an event");
    expect(1, "view tetra.obj --script nothing.txt", "nothing.txt", "No such file");
    expect(1, "view nothing.obj", "nothing.obj", "No such file");
    expect(1, "view tetra.obj -o a.jpg", "a.jpg", ".png, .tga or .ppm");
    expect(1, "view tetra.obj -o tetra.obj", "tetra.obj", "overwritten");
    write_text("events", "key s\n");
    expect(1, "view tetra.obj --script events -o events", "events", "overwritten by the picture");
    expect(1, "view tetra.obj --script ./events -o events", "./events", "overwritten");
    run r = shell("unset DISPLAY WAYLAND_DISPLAY SDL_VIDEODRIVER; \"$GNOMON\" view tetra.obj");
    assert_int_equal(r.status, 1);
    assert_int_equal(lines(r.error), 1);
    assert_non_null(strstr(r.error, "gnomon: view: no window can be opened"));
    r = shell("SDL_VIDEODRIVER=none \"$GNOMON\" view tetra.obj");
    assert_int_equal(r.status, 1);
    assert_non_null(strstr(r.error, "no window can be opened"));
    /* The window goes on if a picture cannot be saved. */
    r = play("key s\nkey ?\n", "tetra.obj -o /dev/full");
    assert_int_equal(r.status, 0);
    assert_non_null(strstr(r.error, "/dev/full: cannot be written: No space"));
    char *keys = strstr(r.out, "left button");
    assert_non_null(keys);
    assert_null(strstr(keys + 1, "left button"));
}

/* A copy of the command that asks for a library which is not there. */
TEST(without_sdl_the_reason_is_said)
{
    need_sdl();
    write_text("tetra.obj", tetra_obj);
    run r =
        shell("LC_ALL=C sed 's/libSDL2-2.0.so.0/libSDL2-9.9.so.9/g' \"$GNOMON\" >other && chmod +x "
              "other && ./other view tetra.obj");
    assert_int_equal(r.status, 1);
    assert_string_equal(r.error, "gnomon: view: there is no window without SDL2, and "
                                 "libSDL2-9.9.so.9 is not installed\n");
    r = shell("./other render tetra.obj -o a.png --size 8x8");
    assert_int_equal(r.status, 0);
}

/* A screen as Xvfb writes it to a file: X's window dump, version 7, of 32 bits a pixel. */
typedef struct screen {
    uint8_t *bytes, *pixels;
    uint32_t width, height, stride;
} screen;

static uint32_t header_word(const uint8_t *bytes, int index)
{
    const uint8_t *b = bytes + 4 * index;
    return (uint32_t)b[0] << 24 | (uint32_t)b[1] << 16 | (uint32_t)b[2] << 8 | b[3];
}

static screen screen_read(const char *name)
{
    screen s;
    FILE *file = fopen(path_of(name), "rb");
    assert_non_null(file);
    s.bytes = malloc(16 << 20);
    const size_t size = fread(s.bytes, 1, 16 << 20, file);
    fclose(file);
    assert_true(size > 100);
    s.width = header_word(s.bytes, 4);
    s.height = header_word(s.bytes, 5);
    s.stride = header_word(s.bytes, 12);
    assert_int_equal(header_word(s.bytes, 11), 32);
    const size_t start = header_word(s.bytes, 0) + 12 * (size_t)header_word(s.bytes, 19);
    assert_true(start + (size_t)s.stride * s.height <= size);
    s.pixels = s.bytes + start;
    return s;
}

static bool shows_at(const screen *s, const picture *p, uint32_t left, uint32_t top)
{
    for (uint32_t y = 0; y < p->height; ++y) {
        for (uint32_t x = 0; x < p->width; ++x) {
            const uint8_t *b = s->pixels + (size_t)s->stride * (top + y) + 4 * (size_t)(left + x);
            const uint32_t color = (uint32_t)b[2] << 16 | (uint32_t)b[1] << 8 | b[0];
            if (color != pixel(p, x, y) >> 8)
                return false;
        }
    }
    return true;
}

static bool shows(const screen *s, const picture *p)
{
    for (uint32_t top = 0; top + p->height <= s->height; ++top)
        for (uint32_t left = 0; left + p->width <= s->width; ++left)
            if (shows_at(s, p, left, top))
                return true;
    return false;
}

/* On a virtual screen, the window shows what it saves. */
TEST(the_window_shows_the_picture)
{
    need_sdl();
    run r = shell("command -v Xvfb");
    if (r.status != 0) {
        print_message(
            "skipped: the window is not looked at: Xvfb is absent: 'make setup' installs it\n");
        return;
    }
    remove_file("view.png");
    write_text("script.txt", "drag 50 30\nkey 7\nkey s\nwait 60000\n");
    r = shell("exec 3>display; Xvfb -displayfd 3 -screen 0 640x480x24 -nolisten tcp -fbdir . & "
              "server=$!; i=0; until test -s display || test $i = 100; do sleep 0.2; i=$((i+1)); "
              "done; DISPLAY=:$(cat display) SDL_VIDEODRIVER=x11 \"$GNOMON\" view tetra.obj "
              "--size 200x150 --script script.txt >said & viewer=$!; i=0; until test -s said || "
              "test $i = 100; do sleep 0.2; i=$((i+1)); done; sleep 1; cp Xvfb_screen0 screen.xwd; "
              "kill $viewer; wait $viewer; status=$?; kill $server; wait $server; exit $status");
    if (r.status != 128 + 15)
        fail_msg("status %d: %s%s", r.status, r.out, r.error);
    screen s = screen_read("screen.xwd");
    picture p = picture_read("view.png");
    assert_int_equal(p.width, 200);
    assert_true(shows(&s, &p));
    /* A picture that differs in one pixel is not found. */
    p.rgba[4 * (75 * 200 + 100)] ^= 1;
    assert_false(shows(&s, &p));
    free(s.bytes);
    picture_free(&p);
}
