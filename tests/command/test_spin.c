/* gnomon spin: every frame of an animated PNG is the picture that gnomon render draws, and what is
 * interrupted leaves nothing behind. */
#define _XOPEN_SOURCE 700
#include "runner.h"

#include <stdio.h>
#include <string.h>
#include <zlib.h>

#define CAMERA "--size 40x30 --eye 1,2,6 --target 0,0,0 --near 1 --far 9"

static uint32_t big_endian(const uint8_t *b)
{
    return (uint32_t)b[0] << 24 | (uint32_t)b[1] << 16 | (uint32_t)b[2] << 8 | b[3];
}

static void put_big_endian(uint8_t *b, uint32_t value)
{
    for (int i = 0; i < 4; ++i)
        b[i] = (uint8_t)(value >> (24 - 8 * i));
}

/* Appends a chunk to a file. */
static void add_chunk(FILE *file, const char *type, const uint8_t *data, uint32_t size)
{
    uint8_t number[4];
    put_big_endian(number, size);
    fwrite(number, 1, 4, file);
    fwrite(type, 1, 4, file);
    fwrite(data, 1, size, file);
    put_big_endian(number, (uint32_t)crc32(crc32(0, (const Bytef *)type, 4), data, size));
    fwrite(number, 1, 4, file);
}

/* Writes frame `wanted` of an animation as a PNG of its own, and checks the order of chunks, their
 * sums and sequence numbers, and that there are 8 frames, 60 a second. */
static void extract(const char *name, uint32_t wanted, const char *result)
{
    static uint8_t bytes[1 << 20];
    const size_t size = read_file(name, bytes, sizeof bytes);
    FILE *file = fopen(path_of(result), "wb");
    uint32_t frames = 0, sequence = 0;
    bool ended = false;
    fwrite(bytes, 1, 8, file);
    for (size_t at = 8; at < size;) {
        const uint32_t length = big_endian(bytes + at);
        const uint8_t *type = bytes + at + 4, *data = type + 4;
        assert_true(length < size - at && !ended);
        assert_int_equal(crc32(crc32(0, NULL, 0), type, length + 4), big_endian(data + length));
        if (memcmp(type, "IHDR", 4) == 0) {
            add_chunk(file, "IHDR", data, length);
        } else if (memcmp(type, "acTL", 4) == 0) {
            assert_true(big_endian(data) == 8 && big_endian(data + 4) == 0);
        } else if (memcmp(type, "fcTL", 4) == 0) {
            assert_int_equal(big_endian(data), sequence++);
            assert_int_equal(length, 26);
            assert_true(big_endian(data + 4) == 40 && big_endian(data + 8) == 30);
            assert_true((data[20] << 8 | data[21]) == 1 && (data[22] << 8 | data[23]) == 60);
            ++frames;
        } else if (memcmp(type, "IDAT", 4) == 0) {
            assert_int_equal(frames, 1);
            if (wanted == 0)
                add_chunk(file, "IDAT", data, length);
        } else if (memcmp(type, "fdAT", 4) == 0) {
            assert_true(frames > 1);
            assert_int_equal(big_endian(data), sequence++);
            if (wanted + 1 == frames)
                add_chunk(file, "IDAT", data + 4, length - 4);
        }
        ended = memcmp(type, "IEND", 4) == 0;
        at += 12 + length;
    }
    assert_true(ended && frames == 8);
    add_chunk(file, "IEND", (const uint8_t *)"", 0);
    fclose(file);
}

/* Frames of the animation, numbered frames and pictures of render are one. */
TEST(frames_are_pictures)
{
    run r =
        good_shell("set -e; gnomon spin square.obj --axis 0,2,0 --frames 8 --rate 60 " CAMERA
                   " --shader phong --shadows; gnomon spin square.obj --axis y --frames 8 " CAMERA
                   " --shader phong --shadows -o 'f_%%03d.png'");
    expect_printed(&r, "spin.png: 40x30, 2 triangles, Phong\n8 frames, ");
    assert_string_equal(r.error, "");
    assert_false(exists("f_008.png"));
    for (uint32_t i = 0; i < 8; ++i) {
        extract("spin.png", i, "one.png");
        good_shell("set -e; gnomon diff one.png f_%03u.png; gnomon render square.obj "
                   "--rotate y,%u " CAMERA " --shader phong --shadows -o r.png; gnomon diff "
                   "r.png f_%03u.png",
                   (unsigned)i, 45 * (unsigned)i, (unsigned)i);
    }
    expect_shell(1, "gnomon diff f_000.png f_001.png", "");
}

/* The turn is about the middle of the models, wherever that is. */
TEST(models_turn_about_their_middle)
{
    good_shell("set -e; spin() { gnomon spin square.obj --frames 4 --size 32x32 \"$@\"; }; "
               "spin -o 'a%%d.tga'; spin --translate 64,-32,16 -o 'b%%d.tga'; for i in 0 1 2 3; do "
               "cmp a$i.tga b$i.tga; done; ! cmp -s a0.tga a1.tga");
}

/* Seen from +z, with its corners on the edges of the picture; turned by half a turn about y, the
 * red corner is on the right. */
TEST(the_triangle_needs_no_model)
{
    run r = good("spin --axis y --frames 2 -o 't%%d.png' --size 64x64 " FRONT);
    expect_printed(&r, "1 triangle, vertex colours\n2 frames");
    for (uint32_t i = 0; i < 2; ++i) {
        picture p = picture_read(i == 0 ? "t0.png" : "t1.png");
        const uint32_t corner = pixel(&p, i == 0 ? 1 : 62, 62);
        assert_true(corner >> 24 > 200 && (corner >> 16 & 255) < 50 && (corner >> 8 & 255) < 50);
        assert_int_equal(pixel(&p, 1, 1), 0xedeeefff);
        picture_free(&p);
    }
    r = good_shell(
        "set -e; gnomon spin --frames 5 --size 40x30; gnomon spin --frames 5 --size "
        "40x30 -o - | cmp - spin.png; gnomon spin --frames 3 --size 9x9 -o 'p%%%%_%%02d' "
        "--format ppm; head -c 2 p%%_02; test ! -e p%%_03");
    expect_printed(&r, "P6");
}

TEST(wrong_use_is_refused)
{
    static const refusal usage[] = {
        {"nothing.obj -o a.tga", "a.tga ... frame_%04d.tga"},
        {"-o - --format ppm", "'-': an animation is a PNG"},
        {"nothing.obj -o a%s.png", "'a%s.png' ... %04d"},
        {"nothing.obj -o a%d%d.png", "'a%d%d.png' ... %04d"},
        {"nothing.obj -o a%04x.png", "'a%04x.png' ... %04d"},
        {"nothing.obj -o a%99d.png", "'a%99d.png' ... %04d"},
        {"nothing.obj -o a%", "'a%' ... %04d"},
        {"--axis w", "--axis 'w': not x, y, z, or three numbers X,Y,Z"},
        {"--depth d.png", "unknown option '--depth'"},
        /* The triangle has no texture coordinates. */
        {"--shader phong --texture nope.png", "--texture ... without a model"},
        {"--glow-map nope.png", "--glow-map ... without a model"},
        {"--normal-map tangent", "--normal-map ... without a model"},
        {"--shader normals --normal-map world:a.png", "--normal-map ... without a model"},
    };
    static const refusal faults[] = {
        {"--axis 0,0,0", "--axis: impossible axis"},
        {"-o a%d.jpg", "a0.jpg: ... must end in .png, .tga or .ppm"},
        {"-o nowhere/a%d.png", "nowhere/a0.png: ... No such file"},
        {"f1.obj --texture f1.png -o f%d.png", "f1.png: ... overwritten"},
        {"nothing.obj", "nothing.obj: ... No such file"},
        {"-o /dev/full --size 400x400", "/dev/full: ... No space"},
    };
    write_text("f1.obj", square_obj);
    EXPECT_EACH(2, "spin", usage);
    EXPECT_EACH(1, "spin", faults);
    good("spin --frames 1 --size 8x8 --texture none --normal-map none");
}

static void expect_warning(const char *options, const char *warning)
{
    run r = good("spin %s --frames 4 --size 16x16", options);
    if (strcmp(r.error, warning) != 0)
        fail_run(&r);
}

/* The square faces the viewer in frame 0, is seen from its edge in frames 1 and 3, and turns its
 * back in frame 2. */
TEST(empty_turns_are_named_once)
{
    expect_warning("square.obj -o 'q%d.png' --axis y --eye 0,0,3 --far 0.01",
                   "gnomon: q%d.png: warning: nothing was drawn: all 2 triangles lie outside the "
                   "view volume\n");
    expect_warning("--far 0.01", "gnomon: spin.png: warning: nothing was drawn: the only triangle "
                                 "lies outside the view volume\n");
    expect_warning("square.obj --no-depth-test --eye 0,0,3 --target 0,0,9",
                   "gnomon: spin.png: warning: nothing was drawn: all 2 triangles lie behind the "
                   "camera\n");
    expect_warning("square.obj --axis y " FRONT, "");
    expect_warning("square.obj --axis y --cull front " FRONT, "");
    expect_warning("square.obj --axis y --cull front --no-depth-test --samples 4 " FRONT, "");
    expect_warning("square.obj --axis y --shader unlit --background cccccc " FRONT, "");
}

/* An interrupt in the middle: the animation has not appeared, and numbered frames are whole. */
TEST(interrupts_leave_no_half)
{
    runner_mark();
    run r =
        shell("gnomon spin --frames 100000 --size 300x300 -o i.png & n=0; until test -s "
              "i.png.* || test $n = 100; do sleep 0.1; n=$((n+1)); done; kill -TERM $!; wait $!; "
              "status=$?; test $n != 100 || exit 9; exit $status");
    assert_int_equal(r.status, 128 + 15);
    assert_int_equal(new_files(), 0);
    r = shell(
        "mkdir frames; gnomon spin --frames 100000 --size 300x300 -o 'frames/i%%d.ppm' & "
        "n=0; until test -e frames/i50.ppm || test $n = 100; do sleep 0.1; n=$((n+1)); done; "
        "kill -TERM $!; wait $!; test -e frames/i50.ppm || exit 9; for f in frames/*; do test "
        "$(wc -c <$f) = 270015 || exit 8; done; rm -r frames; exit 5");
    assert_int_equal(r.status, 5);
}

/* Standard error is a terminal only in the second run. */
TEST(progress_is_for_terminals)
{
    run r = good("spin --frames 30 --size 600x600");
    assert_string_equal(r.error, "");
    if (!has_program("script", "the progress bar"))
        return;
    r = good_shell("script -qec 'gnomon spin --frames 60 --size 600x600' /dev/null");
    expect_printed(&r, " of 60, ");
    expect_printed(&r, " s left");
    expect_printed(&r, "frames a second");
}
