/* Tests the comparison with pictures that differ: the library draws both, and a stand-in for OSMesa
 * changes chosen pixels. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <stdio.h>
#include <string.h>

#include "comparison.h"
#include "osmesa.h"
#include "output.h"

/* The change made to the second picture. */
static bool change_color, change_alpha, change_depth, refuse;

static const shadow_pass no_shadow;

struct reference {
    int unused;
};

#define UNUSED __attribute__((unused))

reference *reference_create(reference_profile profile UNUSED, char *error UNUSED,
                            size_t size UNUSED)
{
    static reference only;
    return &only;
}

void reference_destroy(reference *r UNUSED)
{
}

const char *reference_driver_name(const reference *r UNUSED)
{
    return "no Mesa";
}

const char *reference_mesa_version(const reference *r UNUSED)
{
    return "0.0";
}

const char *reference_renderer(const reference *r UNUSED)
{
    return "stand-in";
}

bool reference_draw(reference *r UNUSED, const scene *s, scene_frame *frame, char *error,
                    size_t error_size)
{
    if (refuse) {
        snprintf(error, error_size, "it refuses");
        return false;
    }
    if (scene_draw_library(s, frame, 0, GN_BACKEND_AUTO) != GN_OK)
        return false;
    uint32_t *color = frame->color;
    float *depth = frame->depth;
    if (change_color)
        color[2 * frame->width + 3] += 5 << 8; /* green, x 3, y 2 from below */
    if (change_alpha)
        color[4] -= 7u << 24;
    if (change_depth)
        depth[5] = 0.25f;
    return true;
}

static scene *empty_scene(void)
{
    scene *s = scene_create(10, 6, GN_FORMAT_RGBA8, GN_FORMAT_D32F);
    for (int i = 0; i < 4; ++i)
        s->clear_color[i] = i == 3 ? 1.0f : 0.2f;
    s->clear_depth = 1.0f;
    return s;
}

/* Compares, with these changes, and returns what is printed. */
static const char *compared(const scene *s, const shadow_pass *shadow, bool color, bool alpha,
                            bool depth, comparison *c)
{
    static char text[2048];
    FILE *file = tmpfile();
    assert_non_null(file);
    change_color = color;
    change_alpha = alpha;
    change_depth = depth;
    assert_int_equal(comparison_make(s, shadow, GN_BACKEND_AUTO, file, c), refuse ? 1 : 0);
    rewind(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    return text;
}

TEST(differences_are_counted_and_shown)
{
    scene *s = empty_scene();
    comparison c;
    const char *text = compared(s, &no_shadow, true, true, true, &c);
    assert_non_null(strstr(text, "colour: 2 of 60 pixels differ, by at most 7/255\n"));
    assert_non_null(strstr(text, "depth:  1 of 60 pixels differ, by at most 0.75\n"));
    assert_non_null(strstr(text, "x 4, y 0"));
    assert_non_null(strstr(text, "; 3 pixels are drawn by one side only\n"));
    assert_int_equal(c.difference.pixels, 3);
    assert_int_equal(comparison_write_triptych(&c, path_of("t.png")), 0);
    assert_int_equal(comparison_write_picture(&c, path_of("p.png")), 0);
    comparison_free(&c);
    scene_free(s);

    picture p = picture_read("t.png");
    assert_true(p.width == 30 && p.height == 6);
    for (uint32_t y = 0; y < 6; ++y) {
        for (uint32_t x = 0; x < 10; ++x) {
            const bool green = x == 3 && y == 3, magenta = y == 5 && (x == 4 || x == 5);
            const uint32_t shown = pixel(&p, 20 + x, y);
            assert_int_equal(pixel(&p, x, y), 0x333333ff);
            assert_int_equal(pixel(&p, 10 + x, y), green ? 0x333833ff : 0x333333ff);
            if (green)
                assert_true((shown & 0xff00ffff) == 0xff && (shown >> 16 & 255) > 64);
            else
                assert_int_equal(shown, magenta ? 0xff00ffff : 0x000000ff);
        }
    }
    picture_free(&p);
    p = picture_read("p.png");
    assert_int_equal(p.width, 10);
    expect_inside(&p, RECTANGLE(0, 0, 10, 6), 0x333333ff, 0);
    picture_free(&p);
}

/* Only samples are changed; the first ones are at the places that differ in a plain picture. */
TEST(samples_are_counted_apart)
{
    scene *s = empty_scene();
    comparison c;
    s->samples = GN_SAMPLES;
    const char *text = compared(s, &no_shadow, true, false, true, &c);
    assert_non_null(strstr(text, "colour: 0 of 60 pixels differ\n"));
    assert_non_null(strstr(text, "depth:  0 of 60 pixels differ\n"));
    assert_non_null(strstr(text, "samples: 2 of 240 differ, colours of 1 by at most 5/255, "
                                 "depths of 1 by at most 0.75\n"));
    assert_int_equal(c.difference.pixels, 0);
    assert_int_equal(c.samples.pixels, 2);
    comparison_free(&c);
    scene_free(s);
}

/* The change is only in the reference's own map. */
TEST(shadow_maps_are_compared)
{
    shadow_pass shadow;
    comparison c;
    scene *s = empty_scene();
    memset(&shadow, 0, sizeof shadow);
    shadow.scene = scene_create(8, 8, GN_FORMAT_NONE, GN_FORMAT_D32F);
    shadow.scene->clear_depth = 1.0f;
    assert_true(scene_frame_allocate(&shadow.frame, shadow.scene));
    assert_int_equal(scene_draw_library(shadow.scene, &shadow.frame, 0, GN_BACKEND_AUTO), GN_OK);
    const char *text = compared(s, &shadow, false, false, false, &c);
    assert_non_null(strstr(text, "shadow map: 0 of 64 texels differ\n"));
    assert_int_equal(c.shadow_texels, 0);
    comparison_free(&c);
    text = compared(s, &shadow, false, false, true, &c);
    assert_non_null(strstr(text, "shadow map: 1 of 64 texels differ\n"));
    assert_int_equal(c.shadow_texels, 1);
    comparison_free(&c);
    scene_frame_free(&shadow.frame);
    scene_free(shadow.scene);
    scene_free(s);
}

TEST(one_pixel_is_singular)
{
    scene *s = empty_scene();
    comparison c;
    const char *text = compared(s, &no_shadow, true, false, false, &c);
    assert_non_null(strstr(text, "; 1 pixel is drawn by one side only\n"));
    comparison_free(&c);
    scene_free(s);
}

/* A finished file has no name yet, so that several can appear together. */
TEST(finished_outputs_appear_when_renamed)
{
    char path[512];
    output o;
    snprintf(path, sizeof path, "%s", path_of("finished"));
    for (int abandoned = 0; abandoned < 2; ++abandoned) {
        runner_mark();
        assert_int_equal(output_open(&o, path), 0);
        assert_true(fputs("all of it", o.file) >= 0);
        assert_int_equal(output_finish(&o), 0);
        assert_null(o.file);
        assert_false(exists("finished"));
        if (!abandoned) {
            assert_int_equal(output_rename(&o), 0);
            assert_true(exists("finished"));
            remove_file("finished");
        }
        output_abandon(&o);
        assert_int_equal(new_files(), 0);
    }
}

TEST(a_failing_reference_is_an_error)
{
    scene *s = empty_scene();
    comparison c;
    refuse = true;
    assert_string_equal(compared(s, &no_shadow, false, false, false, &c), "");
    refuse = false;
    comparison_free(&c);
    scene_free(s);
}
