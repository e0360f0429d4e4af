/* gnomon view: a script plays the part of the user, and what is saved is what gnomon render draws
 * with the camera that the window prints. The tests run with SDL's driver that shows nothing, and
 * once under Xvfb, where the screen is looked at. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char tetra_obj[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

#define VIEW "SDL_VIDEODRIVER=dummy timeout 60 gnomon view "

static void need_sdl(void)
{
    static bool is_there;
    write_text("tetra.obj", tetra_obj);
    write_text("end.txt", "key q\n");
    is_there = is_there || strstr(shell(VIEW "tetra.obj --script end.txt").error, "SDL2") == NULL;
    if (!is_there)
        skip();
}

/* Plays a script, which must succeed, with these options. */
static run play(const char *script, const char *options)
{
    need_sdl();
    write_text("script.txt", script);
    return good_shell(VIEW "--script script.txt %s", options);
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
    remove_file("view.png");
    run r = play(script, options);
    assert_string_equal(r.error, "");
    good_shell("gnomon render %s %s -o render.png && gnomon diff view.png render.png", options,
               last_options(&r));
}

TEST(saved_pictures_are_those_of_render)
{
    static const char *const cases[][2] = {
        {"key s\n", ""},
        {"drag 40 -25\nkey s\n", ""},
        {"drag 10 2000\nkey s\n", ""},
        {"pan 30 20\nwheel 4\nkey s\n", "--up 0,0,1"},
        {"pan 9 -9\nwheel -2\nkey s\n", "--size 90x120 --orthographic 3"},
        {"key 7\nkey h\nkey m\nkey s\n", ""},
        {"key h\nkey 4\nkey s\n", ""},
        {"key w\nkey s\n", ""},
        {"key p\nkey s\n", ""},
        {"key c\nkey s\n", "--points=4"},
        {"key +\nkey -\nkey +\nkey c\nkey c\nkey s\n", ""},
        {"resize 77 55\nresize 77 56\nkey s\n", ""}};
    for (size_t i = 0; i < COUNT(cases); ++i) {
        char options[64];
        snprintf(options, sizeof options, "tetra.obj --size 90x60 %s", cases[i][1]);
        expect_same(cases[i][0], options);
    }
}

/* The shaders of all keys, with files of all maps and with a space of normals: what is printed fits
 * behind these options. */
TEST(maps_that_a_shader_lacks_are_left_out)
{
    static const char *const given[] = {
        "--texture map.ppm --specular-map map.ppm --glow-map map.ppm",
        "--normal-map tangent:map.ppm --specular-map map.ppm", "--shader flat --normal-map tangent",
        ""};
    char script[64], options[256];
    write_text("uv.mtl", "newmtl red\nKd 1 0 0\nmap_Kd map.ppm\n");
    write_square("uv.obj", "mtllib uv.mtl\nusemtl red\n");
    write_text("map.ppm", "P6 2 1 255\n\x10\x90\x30\xf0\x20\x80");
    good_shell("gnomon render uv.obj --texture none --size 8x8 -o uv_nm_tangent.tga");
    for (size_t i = 0; i < COUNT(given); ++i) {
        snprintf(options, sizeof options, "uv.obj --size 32x32 %s", given[i]);
        for (int key = 0; key <= 9; ++key) {
            snprintf(script, sizeof script, "key %d\nkey s\n", key);
            expect_same(script, options);
        }
    }
    expect_same("key s\n", "uv.obj --size 32x32 --shader vertex-color");

    /* Maps are named only if the shader takes them. */
    run r = play("key s\n", "uv.obj --size 32x32 --shader vertex-color");
    assert_null(strstr(r.out, "maps:"));
    r = play("key 5\nkey s\n", "uv.obj --size 32x32");
    expect_printed(&r, "\nmaps: diffuse map.ppm\n");
    r = play("key 8\nkey s\n", "uv.obj --size 32x32");
    assert_null(strstr(r.out, "diffuse"));
    expect_printed(&r, "\nmaps: tangent-space normals uv_nm_tangent.tga\n");
    r = play("key 6\nkey s\n", "uv.obj --size 32x32");
    expect_printed(&r, "\nmaps: diffuse map.ppm, tangent-space normals uv_nm_tangent.tga\n");
}

/* Options that nothing on the command line can undo are named. */
TEST(options_to_leave_out_are_named)
{
    static const char *const cases[][3] = {
        {"key h\nkey s\n", "--shader phong --shadows", "--shadows"},
        {"key 4\nkey s\n", "--shadows", "--shadows"},
        {"key w\nkey s\n", "--wireframe", "--wireframe"},
        {"key w\nkey s\n", "--points=3", "--points"},
        {"key p\nkey s\n", "--wireframe", "--wireframe"},
        {"key 1\nkey p\nkey s\n", "--shadows --points=3", "--shadows, --points"},
    };
    for (size_t i = 0; i < COUNT(cases); ++i) {
        char line[128], words[64];
        snprintf(line, sizeof line, "tetra.obj --size 40x30 %s", cases[i][1]);
        snprintf(words, sizeof words, "\nwithout %s\n", cases[i][2]);
        run r = play(cases[i][0], line);
        expect_printed(&r, words);
        good_shell("gnomon render tetra.obj %s -o render.png && gnomon diff view.png render.png",
                   last_options(&r));
    }
    run r = play("key s\n", "tetra.obj --size 40x30 --shader phong --shadows --points");
    expect_printed(&r, "--shadows");
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
    play("key w\nkey s\n", "tetra.obj --size 40x30 -o plain.png");
    for (size_t i = 0; i < COUNT(scripts); ++i) {
        remove_file("view.png");
        run r = play(scripts[i], "tetra.obj --size 40x30");
        assert_string_equal(r.error, "");
        expect_same_files("view.png", "plain.png");
    }
}

TEST(wrong_lines_of_scripts_are_named)
{
    static const char *const wrong[] = {"key",       "key #x",         "key # x",    "key q#",
                                        "key q q",   "drag 1",         "drag 1 2 3", "wheel 1.5",
                                        "wheel # 1", "resize 0 5",     "wait -1",    "keys q",
                                        "key sssss", "drag 99999999 1"};
    static const char zero[] = "key w\nkey q\0x\n";
    need_sdl();
    for (size_t i = 0; i < COUNT(wrong); ++i) {
        char text[64];
        snprintf(text, sizeof text, "\n%s\nkey q\n", wrong[i]);
        write_text("script.txt", text);
        expect(2, "view tetra.obj --script script.txt", "gnomon: script.txt:2: not an event: ");
    }
    write_bytes("zero.txt", zero, sizeof zero - 1);
    expect(2, "view tetra.obj --script zero.txt", "zero.txt:2 ... zero byte");
}

/* What happens must change the picture that the window begins with, or not. */
static void expect_change(bool changes, const char *script, const char *more)
{
    char text[64];
    snprintf(text, sizeof text, "%s%skey s\n", script, more);
    play(text, "tetra.obj --size 120x90");
    run r = shell("cmp -s view.png first.png");
    if (r.status != changes)
        fail_msg("%s: status %d", text, r.status);
}

TEST(events_change_the_picture)
{
    static const char *const cameras[] = {"drag 40 0\n", "drag 0 40\n", "pan 20 0\n",
                                          "pan 0 20\n",  "wheel 1\n",   "key +\n"};
    static const char *const keys[][2] = {{"key w\n", "key w\n"},
                                          {"key p\n", "key p\n"},
                                          {"key 9\n", "key 0\n"},
                                          {"key c\nkey c\n", "key c\n"}};
    good("render tetra.obj --size 120x90 -o first.png");
    expect_change(false, "drag 0 0\nwait 10\n# nothing\n\n", "");
    for (size_t i = 0; i < COUNT(cameras); ++i) {
        expect_change(true, cameras[i], "");
        expect_change(false, cameras[i], "key r\n"); /* the first view comes back */
    }
    for (size_t i = 0; i < COUNT(keys); ++i) {
        expect_change(true, keys[i][0], "");
        expect_change(false, keys[i][0], keys[i][1]);
    }
}

/* 225 pixels of 0.4 degrees are a quarter turn: from +z to -x. */
TEST(drags_turn_around_the_target)
{
    static const struct {
        const char *script, *options;
        float eye[3];
    } cases[] = {{"drag 225 0\nkey s\n", "", {-5, 0, 0}},
                 /* 5 sin 40 degrees, 5 cos 40 degrees */
                 {"drag 0 100\nkey s\n", "", {0, 3.2139381f, 3.8302222f}},
                 {"wheel 2\nkey s\n", "", {0, 0, 4.05f}},
                 /* At an angle of 90 degrees and distance 5, 30 pixels are 10 units. */
                 {"pan 30 -15\nkey s\n", "--fov 90", {-10, -5, 5}}};
    for (size_t i = 0; i < COUNT(cases); ++i) {
        char line[128];
        float eye[3];
        snprintf(line, sizeof line, "tetra.obj --eye 0,0,5 --target 0,0,0 --size 40x30 %s",
                 cases[i].options);
        run r = play(cases[i].script, line);
        assert_int_equal(sscanf(last_options(&r), "--eye %f,%f,%f", eye, eye + 1, eye + 2), 3);
        for (int c = 0; c < 3; ++c)
            if (!(fabsf(eye[c] - cases[i].eye[c]) < 1e-4f))
                fail_msg("%s: %d is %.9g", cases[i].script, c, (double)eye[c]);
    }
}

TEST(wrong_use_is_named)
{
    static const refusal faults[] = {
        {"tetra.obj --script nothing.txt", "nothing.txt: ... No such file"},
        {"nothing.obj", "nothing.obj: ... No such file"},
        {"tetra.obj -o a.jpg", "a.jpg: ... .png, .tga or .ppm"},
        {"tetra.obj -o tetra.obj", "tetra.obj: ... overwritten"},
        {"tetra.obj --script events -o events", "events: ... overwritten by the picture"},
        {"tetra.obj --script ./events -o events", "./events: ... overwritten"},
    };
    need_sdl();
    write_text("events", "key s\n");
    EXPECT_EACH(1, "view", faults);
    expect(2, "view", "no model file (see gnomon view --help)");
    expect(2, "view tetra.obj --depth d.png", "unknown option '--depth'");
    expect_shell(1, "unset DISPLAY WAYLAND_DISPLAY SDL_VIDEODRIVER; gnomon view tetra.obj",
                 "gnomon: view: no window can be opened");
    expect_shell(1, "SDL_VIDEODRIVER=none gnomon view tetra.obj", "no window can be opened");
    /* The window goes on if a picture cannot be saved. */
    run r = play("key s\nkey ?\n", "tetra.obj -o /dev/full");
    assert_non_null(strstr(r.error, "/dev/full: cannot be written: No space"));
    char *keys = strstr(r.out, "left button");
    assert_non_null(keys);
    assert_null(strstr(keys + 1, "left button"));
}

/* A copy of the command that asks for a library which is not there. */
TEST(without_sdl_the_reason_is_said)
{
    need_sdl();
    expect_shell(1,
                 "LC_ALL=C sed 's/libSDL2-2.0.so.0/libSDL2-9.9.so.9/g' \"$GNOMON\" >other && "
                 "chmod +x other && ./other view tetra.obj",
                 "gnomon: view: there is no window without SDL2, and libSDL2-9.9.so.9 is not "
                 "installed\n");
    good_shell("./other render tetra.obj -o a.png --size 8x8");
}

/* A screen as Xvfb writes it to a file: X's window dump, version 7, of 32 bits a pixel. */
typedef struct screen {
    const uint8_t *pixels;
    uint32_t width, height, stride;
} screen;

static screen screen_read(const char *name)
{
    static uint8_t bytes[16 << 20];
    uint32_t header[20];
    const size_t size = read_file(name, bytes, sizeof bytes);
    assert_true(size > 100);
    for (size_t i = 0; i < COUNT(header); ++i)
        header[i] = (uint32_t)bytes[4 * i] << 24 | (uint32_t)bytes[4 * i + 1] << 16 |
                    (uint32_t)bytes[4 * i + 2] << 8 | bytes[4 * i + 3];
    assert_int_equal(header[11], 32);
    const size_t start = header[0] + 12 * (size_t)header[19];
    assert_true(start + (size_t)header[12] * header[5] <= size);
    return (screen){bytes + start, header[4], header[5], header[12]};
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
    if (!has_program("Xvfb", "the window"))
        return;
    remove_file("view.png");
    write_text("script.txt", "drag 50 30\nkey 7\nkey s\nwait 60000\n");
    run r =
        shell("exec 3>display; Xvfb -displayfd 3 -screen 0 640x480x24 -nolisten tcp -fbdir . & "
              "server=$!; i=0; until test -s display || test $i = 100; do sleep 0.2; i=$((i+1)); "
              "done; DISPLAY=:$(cat display) SDL_VIDEODRIVER=x11 gnomon view tetra.obj "
              "--size 200x150 --script script.txt >said & viewer=$!; i=0; until test -s said || "
              "test $i = 100; do sleep 0.2; i=$((i+1)); done; sleep 1; cp Xvfb_screen0 screen.xwd; "
              "kill $viewer; wait $viewer; status=$?; kill $server; wait $server; exit $status");
    if (r.status != 128 + 15)
        fail_run(&r);
    screen s = screen_read("screen.xwd");
    picture p = picture_read("view.png");
    assert_int_equal(p.width, 200);
    assert_true(shows(&s, &p));
    /* A picture that differs in one pixel is not found. */
    p.rgba[4 * (75 * 200 + 100)] ^= 1;
    assert_false(shows(&s, &p));
    picture_free(&p);
}
