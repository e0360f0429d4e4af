/* Compares the library's picture with OSMesa's. */
#include "comparison.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "osmesa.h"

#include "difference.h"
#include "picture_write.h"
#include "report.h"

static void print_difference(FILE *words, const scene_difference *d, uint64_t pixels)
{
    fprintf(words, "colour: %" PRIu64 " of %" PRIu64 " pixels differ", d->color_pixels, pixels);
    if (d->color_pixels > 0)
        fprintf(words, ", by at most %g/255", d->color_largest);
    fprintf(words, "\ndepth:  %" PRIu64 " of %" PRIu64 " pixels differ", d->depth_pixels, pixels);
    if (d->depth_pixels > 0)
        fprintf(words, ", by at most %g", d->depth_largest);
    fprintf(words, "\n");
    if (d->pixels > 0)
        fprintf(words,
                "first difference at x %u, y %u (from the lower left); %" PRIu64
                " pixel%s drawn by one side only\n",
                (unsigned)d->x, (unsigned)d->y, d->coverage_pixels,
                d->coverage_pixels == 1 ? " is" : "s are");
}

static void print_samples(FILE *words, const scene_difference *d, uint64_t samples)
{
    fprintf(words, "samples: %" PRIu64 " of %" PRIu64 " differ", d->pixels, samples);
    if (d->pixels > 0)
        fprintf(words,
                ", colours of %" PRIu64 " by at most %g/255, depths of %" PRIu64 " by at most %g",
                d->color_pixels, d->color_largest, d->depth_pixels, d->depth_largest);
    fprintf(words, "\n");
}

/* Some images of a frame, as a frame that owns nothing. */
static scene_frame part_of_frame(const scene_frame *frame, uint32_t first, uint32_t count)
{
    const size_t pixels = (size_t)first * frame->width * frame->height;
    scene_frame part = *frame;
    part.images = count;
    part.color = (uint32_t *)frame->color + pixels;
    part.depth = (float *)frame->depth + pixels;
    return part;
}

static scene_difference compare_images(const scene *s, const comparison *c, uint32_t first,
                                       uint32_t count)
{
    const scene_frame ours = part_of_frame(&c->ours, first, count);
    const scene_frame theirs = part_of_frame(&c->reference, first, count);
    return scene_compare(s, &ours, &theirs);
}

/* The library's shadow map is part of the scene, so the reference draws the map only for this
 * comparison. */
static bool compare_shadow(reference *mesa, const shadow_pass *shadow, FILE *words, comparison *c,
                           char *error, size_t error_size)
{
    scene_frame theirs;
    if (shadow->scene == NULL)
        return true;
    if (!scene_frame_allocate(&theirs, shadow->scene)) {
        snprintf(error, error_size, "not enough memory");
        return false;
    }
    bool drawn = reference_draw(mesa, shadow->scene, &theirs, error, error_size);
    if (drawn) {
        c->shadow_texels = scene_compare(shadow->scene, &shadow->frame, &theirs).pixels;
        fprintf(words, "shadow map: %" PRIu64 " of %" PRIu64 " texels differ\n", c->shadow_texels,
                (uint64_t)theirs.width * theirs.height);
    }
    scene_frame_free(&theirs);
    return drawn;
}

int comparison_make(const scene *s, const shadow_pass *shadow, gn_backend backend, FILE *words,
                    comparison *result)
{
    char error[512] = "";
    memset(result, 0, sizeof *result);
    if (!scene_frame_allocate(&result->ours, s) || !scene_frame_allocate(&result->reference, s))
        return report_fault("--size", "not enough memory for two pictures of %ux%u pixels",
                            (unsigned)s->width, (unsigned)s->height);
    gn_status status = scene_draw_library(s, &result->ours, 0, backend);
    if (status != GN_OK)
        return report_fault("drawing", "%s", gn_status_text(status));

    reference *mesa = reference_create(REFERENCE_PINNED, error, sizeof error);
    if (mesa == NULL)
        return report_fault("reference", "%s", error);
    bool drawn = reference_draw(mesa, s, &result->reference, error, sizeof error);
    if (drawn) {
        fprintf(words, "reference: %s %s, %s\n", reference_driver_name(mesa),
                reference_mesa_version(mesa), reference_renderer(mesa));
    }
    drawn = drawn && compare_shadow(mesa, shadow, words, result, error, sizeof error);
    reference_destroy(mesa);
    if (!drawn)
        return report_fault("reference", "%s", error);

    result->difference = compare_images(s, result, result->ours.images - 1, 1);
    print_difference(words, &result->difference, (uint64_t)s->width * s->height);
    if (scene_is_sampled(s)) {
        result->samples = compare_images(s, result, 0, GN_SAMPLES);
        print_samples(words, &result->samples, (uint64_t)s->width * s->height * GN_SAMPLES);
    }
    return 0;
}

/* The image that is shown; with several samples, the resolved image. */
static size_t shown_row(const scene_frame *frame, uint32_t y)
{
    return ((size_t)frame->images * frame->height - 1 - y) * frame->width;
}

static const uint32_t *color_row(const scene_frame *frame, uint32_t y)
{
    return (const uint32_t *)frame->color + shown_row(frame, y);
}

static uint8_t channel(uint32_t pixel, int index)
{
    return (uint8_t)(pixel >> (8 * index));
}

static void put_rgb(uint32_t pixel, uint8_t *bytes)
{
    for (int i = 0; i < 3; ++i)
        bytes[i] = channel(pixel, i);
}

static void triptych_row(const void *context, uint32_t y, uint8_t *row)
{
    const comparison *c = context;
    size_t width = c->ours.width;
    const uint32_t *ours = color_row(&c->ours, y);
    const uint32_t *theirs = color_row(&c->reference, y);
    size_t first = shown_row(&c->ours, y);
    const unsigned char *depth_a = (const unsigned char *)c->ours.depth + first * sizeof(float);
    const unsigned char *depth_b =
        (const unsigned char *)c->reference.depth + first * sizeof(float);
    for (size_t x = 0; x < width; ++x) {
        bool depth_differs =
            memcmp(depth_a + x * sizeof(float), depth_b + x * sizeof(float), sizeof(float)) != 0;
        uint8_t *const a = row + 3 * x, *const b = row + 3 * (width + x);
        put_rgb(ours[x], a);
        put_rgb(theirs[x], b);
        difference_shown(a, b, ours[x] != theirs[x] || depth_differs, row + 3 * (2 * width + x));
    }
}

static void picture_row(const void *context, uint32_t y, uint8_t *row)
{
    const comparison *c = context;
    const uint32_t *ours = color_row(&c->ours, y);
    for (size_t x = 0; x < c->ours.width; ++x)
        put_rgb(ours[x], row + 3 * x);
}

int comparison_write_triptych(const comparison *c, const char *path)
{
    picture_format format;
    picture_format_of(path, &format);
    return picture_write_file(path, format, PNG_RGB8, 3 * c->ours.width, c->ours.height,
                              triptych_row, c);
}

void comparison_name_triptych(FILE *words, const char *path)
{
    report_print(words, path);
    fputs(": Gnomon, OSMesa, difference\n", words);
}

int comparison_write_picture(const comparison *c, const char *path)
{
    picture_format format;
    picture_format_of(path, &format);
    return picture_write_file(path, format, PNG_RGB8, c->ours.width, c->ours.height, picture_row,
                              c);
}

void comparison_free(comparison *c)
{
    scene_frame_free(&c->ours);
    scene_frame_free(&c->reference);
}
