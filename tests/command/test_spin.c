/* gnomon spin: every frame of an animated PNG is the picture that gnomon render draws, and what is
 * interrupted leaves nothing behind. */
#define _XOPEN_SOURCE 700
#include "runner.h"

#include <png.h>
#include <stdio.h>
#include <stdlib.h>
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
    uLong sum = crc32(0, (const Bytef *)type, 4);
    if (size > 0) {
        fwrite(data, 1, size, file);
        sum = crc32(sum, data, size);
    }
    put_big_endian(number, (uint32_t)sum);
    fwrite(number, 1, 4, file);
}

/* Writes frame `wanted` of an animation as a PNG of its own, and checks the order of chunks, their
 * sums and sequence numbers. Returns the number of frames. */
static uint32_t extract(const char *name, uint32_t wanted, const char *result, uint32_t *rate)
{
    static uint8_t bytes[1 << 20];
    FILE *file = fopen(path_of(name), "rb");
    assert_non_null(file);
    const size_t size = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    file = fopen(path_of(result), "wb");
    fwrite(bytes, 1, 8, file);
    uint32_t frames = 0, announced = 0, sequence = 0;
    bool ended = false;
    for (size_t at = 8; at < size;) {
        const uint32_t length = big_endian(bytes + at);
        const uint8_t *type = bytes + at + 4, *data = type + 4;
        assert_true(length < size - at);
        assert_int_equal(crc32(crc32(0, NULL, 0), type, length + 4), big_endian(data + length));
        assert_false(ended);
        if (memcmp(type, "IHDR", 4) == 0)
            add_chunk(file, "IHDR", data, length);
        if (memcmp(type, "acTL", 4) == 0) {
            announced = big_endian(data);
            assert_int_equal(big_endian(data + 4), 0);
        }
        if (memcmp(type, "fcTL", 4) == 0) {
            assert_int_equal(big_endian(data), sequence++);
            assert_int_equal(length, 26);
            assert_int_equal(big_endian(data + 4), 40);
            assert_int_equal(big_endian(data + 8), 30);
            assert_int_equal(data[20] << 8 | data[21], 1);
            *rate = (uint32_t)(data[22] << 8 | data[23]);
            ++frames;
        }
        if (memcmp(type, "IDAT", 4) == 0) {
            assert_int_equal(frames, 1);
            if (wanted == 0)
                add_chunk(file, "IDAT", data, length);
        }
        if (memcmp(type, "fdAT", 4) == 0) {
            assert_true(frames > 1);
            assert_int_equal(big_endian(data), sequence++);
            if (wanted + 1 == frames)
                add_chunk(file, "IDAT", data + 4, length - 4);
        }
        ended = memcmp(type, "IEND", 4) == 0;
        at += 12 + length;
    }
    assert_true(ended);
    assert_int_equal(announced, frames);
    add_chunk(file, "IEND", NULL, 0);
    fclose(file);
    return frames;
}

/* Frames of the animation, numbered frames and pictures of render are one. */
TEST(frames_are_pictures)
{
    uint32_t rate;
    write_text("square.obj", square_obj);
    run r =
        shell("set -e; \"$GNOMON\" spin square.obj --axis 0,2,0 --frames 8 --rate 60 " CAMERA
              " --shader phong --shadows; \"$GNOMON\" spin square.obj --axis y --frames 8 " CAMERA
              " --shader phong --shadows -o 'f_%03d.png'");
    assert_int_equal(r.status, 0);
    assert_non_null(strstr(r.out, "spin.png: 40x30, 2 triangles, Phong\n8 frames, "));
    assert_string_equal(r.error, "");
    assert_false(exists("f_008.png"));
    for (uint32_t i = 0; i < 8; ++i) {
        char line[512];
        assert_int_equal(extract("spin.png", i, "one.png", &rate), 8);
        assert_int_equal(rate, 60);
        snprintf(line, sizeof line,
                 "set -e; \"$GNOMON\" diff one.png f_%03u.png; \"$GNOMON\" render square.obj "
                 "--rotate y,%u " CAMERA " --shader phong --shadows -o r.png; \"$GNOMON\" diff "
                 "r.png f_%03u.png",
                 (unsigned)i, 45 * (unsigned)i, (unsigned)i);
        r = shell(line);
        if (r.status != 0)
            fail_msg("frame %u: %s%s", (unsigned)i, r.out, r.error);
    }
    r = shell("\"$GNOMON\" diff f_000.png f_001.png");
    assert_int_equal(r.status, 1);
}

/* The turn is about the middle of the models, wherever that is. */
TEST(models_turn_about_their_middle)
{
    write_text("square.obj", square_obj);
    run r =
        shell("set -e; spin() { \"$GNOMON\" spin square.obj --frames 4 --size 32x32 \"$@\"; }; "
              "spin -o 'a%d.tga'; spin --translate 64,-32,16 -o 'b%d.tga'; for i in 0 1 2 3; do "
              "cmp a$i.tga b$i.tga; done; ! cmp -s a0.tga a1.tga");
    if (r.status != 0)
        fail_msg("%s%s", r.out, r.error);
}

/* Seen from +z, with its corners on the edges of the picture; turned by half a turn about y, the
 * red corner is on the right. */
TEST(the_triangle_needs_no_model)
{
    run r = gnomon("spin --axis y --frames 2 -o 't%%d.png' --size 64x64 " FRONT);
    assert_int_equal(r.status, 0);
    assert_non_null(strstr(r.out, "1 triangle, vertex colours\n2 frames"));
    for (uint32_t i = 0; i < 2; ++i) {
        picture p = picture_read(i == 0 ? "t0.png" : "t1.png");
        const uint32_t corner = pixel(&p, i == 0 ? 1 : 62, 62);
        assert_true(corner >> 24 > 200 && (corner >> 16 & 255) < 50 && (corner >> 8 & 255) < 50);
        assert_int_equal(pixel(&p, 1, 1), 0xedeeefff);
        picture_free(&p);
    }
    r = shell(
        "set -e; \"$GNOMON\" spin --frames 5 --size 40x30; \"$GNOMON\" spin --frames 5 --size "
        "40x30 -o - | cmp - spin.png; \"$GNOMON\" spin --frames 3 --size 9x9 -o 'p%%_%02d' "
        "--format ppm; head -c 2 p%_02; test ! -e p%_03");
    assert_int_equal(r.status, 0);
    assert_non_null(strstr(r.out, "P6"));
}

TEST(wrong_outputs_are_refused)
{
    write_text("square.obj", square_obj);
    write_text("f1.obj", square_obj);
    expect(2, "spin nothing.obj -o a.tga", "a.tga", "frame_%04d.tga");
    expect(2, "spin -o - --format ppm", "-", "an animation is a PNG");
    expect(2, "spin nothing.obj -o a%s.png", "a%s.png", "%04d");
    expect(2, "spin nothing.obj -o a%d%d.png", "a%d%d.png", "%04d");
    expect(2, "spin nothing.obj -o a%04x.png", "a%04x.png", "%04d");
    expect(2, "spin nothing.obj -o a%99d.png", "a%99d.png", "%04d");
    expect(2, "spin nothing.obj -o a%", "a%", "%04d");
    expect(1, "spin --frames 0", "--frames", "1 to 100000");
    expect(2, "spin --rate many", "--rate 'many'", "1 to 1000");
    expect(2, "spin --axis w", "--axis 'w'", "X,Y,Z");
    expect(2, "spin --depth d.png", "--depth", "unknown option");
    expect(1, "spin --axis 0,0,0", "--axis", "impossible axis");
    expect(1, "spin -o a%d.jpg", "a0.jpg", "must end in .png, .tga or .ppm");
    expect(1, "spin -o nowhere/a%d.png", "nowhere/a0.png", "No such file");
    expect(1, "spin f1.obj --texture f1.png -o f%d.png", "f1.png", "overwritten");
    expect(1, "spin nothing.obj", "nothing.obj", "No such file");
    expect(1, "spin -o /dev/full --size 400x400", "/dev/full", "No space");
}

/* The triangle has no texture coordinates. */
TEST(the_triangle_takes_no_maps)
{
    expect(2, "spin --shader phong --texture nope.png", "--texture", "without a model");
    expect(2, "spin --specular-map nope.png", "--specular-map", "without a model");
    expect(2, "spin --glow-map nope.png", "--glow-map", "without a model");
    expect(2, "spin --normal-map tangent", "--normal-map", "without a model");
    expect(2, "spin --shader normals --normal-map world:a.png", "--normal-map", "without a model");
    run r = gnomon("spin --frames 1 --size 8x8 --texture none --normal-map none");
    assert_int_equal(r.status, 0);
}

static void expect_warning(const char *options, const char *warning)
{
    run r = gnomon("spin %s --frames 4 --size 16x16", options);
    if (r.status != 0 || strcmp(r.error, warning) != 0)
        fail_msg("gnomon spin %s: status %d, '%s'", options, r.status, r.error);
}

/* The square faces the viewer in frame 0, is seen from its edge in frames 1 and 3, and turns its
 * back in frame 2. */
TEST(empty_turns_are_named_once)
{
    write_text("square.obj", square_obj);
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
        shell("\"$GNOMON\" spin --frames 100000 --size 300x300 -o i.png & n=0; until test -s "
              "i.png.* || test $n = 100; do sleep 0.1; n=$((n+1)); done; kill -TERM $!; wait $!; "
              "status=$?; test $n != 100 || exit 9; exit $status");
    assert_int_equal(r.status, 128 + 15);
    assert_int_equal(new_files(), 0);
    r = shell(
        "mkdir frames; \"$GNOMON\" spin --frames 100000 --size 300x300 -o 'frames/i%d.ppm' & "
        "n=0; until test -e frames/i50.ppm || test $n = 100; do sleep 0.1; n=$((n+1)); done; "
        "kill -TERM $!; wait $!; test -e frames/i50.ppm || exit 9; for f in frames/*; do test "
        "$(wc -c <$f) = 270015 || exit 8; done; rm -r frames; exit 5");
    assert_int_equal(r.status, 5);
}

/* Standard error is a terminal only in the second run. */
TEST(progress_is_for_terminals)
{
    run r = gnomon("spin --frames 30 --size 600x600");
    assert_string_equal(r.error, "");
    r = shell("command -v script");
    if (r.status != 0) {
        print_message(
            "skipped: the progress bar is not looked at: 'script' of bsdutils is absent\n");
        return;
    }
    r = shell("script -qec '\"$GNOMON\" spin --frames 60 --size 600x600' /dev/null");
    assert_int_equal(r.status, 0);
    assert_non_null(strstr(r.out, " of 60, "));
    assert_non_null(strstr(r.out, " s left"));
    assert_non_null(strstr(r.out, "frames a second"));
}
