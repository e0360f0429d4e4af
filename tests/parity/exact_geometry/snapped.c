/* Coverage by the library and by the reference against oracle A. */
#include "batch.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gnomon.h>

#include "scene_memory.h"

/* The reference, which takes longer, draws one batch of so many. */
#define REFERENCE_INTERVAL 32

#define REPORTED 5
#define CHANNELS 4

/* What covers one place, by the oracle: bit i % 24 of word i / 24 for triangle i. */
typedef struct cover {
    uint32_t word[CHANNELS];
} cover;

static void copy_position(const void *uniforms, const gn_vertex_input *in, gn_vertex_output *out)
{
    (void)uniforms;
    memcpy(out->position, in->attribute[GN_ATTRIBUTE_POSITION], 4 * sizeof *out->position);
    memcpy(out->varying, in->attribute[GN_ATTRIBUTE_COLOR], 4 * sizeof *out->varying);
}

static void copy_color(const void *uniforms, const gn_fragment_input *in, gn_fragment_output *out)
{
    (void)uniforms;
    memcpy(out->color, in->varying, 4 * sizeof *out->color);
}

/* The state of a batch, without shaders. */
static gn_pipeline state_of(const batch *b)
{
    gn_pipeline p;

    memset(&p, 0, sizeof p);
    p.raster.viewport = b->viewport;
    p.raster.cull = b->cull;
    p.raster.front_face = b->front_face;
    p.depth.test_enabled = true;
    p.depth.function = GN_ALWAYS;
    for (int c = 0; c < 4 && b->mode != MODE_LAST; ++c)
        p.program.interpolation[c] = GN_FLAT;
    if (b->mode == MODE_SUM) {
        p.color.blend[0].enabled = true;
        p.color.blend[0].source = GN_FACTOR_ONE;
        p.color.blend[0].destination = GN_FACTOR_ONE;
    }
    return p;
}

static void set_shaders(const batch *b, const gn_color_uniforms *uniforms, gn_pipeline *p)
{
    if (b->mode == MODE_SHADER) {
        p->program.vertex_shader = copy_position;
        p->program.fragment_shader = copy_color;
        p->program.varying_count = 4;
        return;
    }
    gn_interpolation interpolation[4];

    memcpy(interpolation, p->program.interpolation, sizeof interpolation);
    gn_use_vertex_color(p, uniforms);
    memcpy(p->program.interpolation, interpolation, sizeof interpolation);
}

/* Draws a batch with a back end, into images of its samples. */
static gn_status draw_batch(const batch *b, gn_backend backend, void *color, void *depth)
{
    static unsigned char memory[GN_WORKSPACE_SIZE(3 * BATCH_TRIANGLES, 4)];
    static const gn_color_uniforms uniforms = {
        {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}};
    const gn_surface images[2] = {
        gn_surface_bottom_up(color, batch_color_format(b), b->width, b->height),
        gn_surface_bottom_up(depth, b->depth, b->width, b->height)};
    const bool sampled = b->samples > 1;
    gn_workspace workspace = {.memory = memory, .size = sizeof memory, .backend = backend};
    gn_pipeline pipeline = state_of(b);
    gn_target target;
    gn_mesh mesh;

    memset(&target, 0, sizeof target);
    target.color[0] = sampled ? gn_surface_multisampled(&images[0]) : images[0];
    if (b->depth != GN_FORMAT_NONE)
        target.depth = sampled ? gn_surface_multisampled(&images[1]) : images[1];
    memset(&mesh, 0, sizeof mesh);
    mesh.attribute[GN_ATTRIBUTE_POSITION] = (gn_attribute){.data = b->position[0], .components = 4};
    mesh.attribute[GN_ATTRIBUTE_COLOR] = (gn_attribute){.data = b->color[0], .components = 4};
    mesh.vertex_count = mesh.count = 3 * b->count;
    set_shaders(b, &uniforms, &pipeline);
    memset(color, 0,
           (size_t)b->samples * b->width * b->height * gn_format_size(batch_color_format(b)));
    return gn_draw(&target, &pipeline, &mesh, &workspace);
}

/* Draws a batch with the reference, into a frame. */
static bool draw_reference(reference *r, const batch *b, scene_frame *frame)
{
    scene *const s = scene_create(b->width, b->height, batch_color_format(b), b->depth);
    scene_draw *const d = scene_add_draw(s);
    char error[512];

    s->samples = b->samples;
    d->state = state_of(b);
    d->shader = SCENE_VERTEX_COLOR;
    scene_set_attribute(d, GN_ATTRIBUTE_POSITION, b->position[0], 4, 3 * b->count);
    scene_set_attribute(d, GN_ATTRIBUTE_COLOR, b->color[0], 4, 3 * b->count);
    bool drawn = scene_frame_allocate(frame, s);

    if (drawn && !reference_draw(r, s, frame, error, sizeof error)) {
        fprintf(stderr, "exact-geometry: the reference: %s\n", error);
        scene_frame_free(frame);
        drawn = false;
    }
    scene_free(s);
    return drawn;
}

/* Whether the state culls a triangle of this winding. */
static bool is_culled(const batch *b, int winding)
{
    const bool is_front = (winding > 0) == (b->front_face == GN_FRONT_COUNTER_CLOCKWISE);

    return b->cull == GN_CULL_FRONT_AND_BACK ||
           b->cull == (is_front ? GN_CULL_FRONT : GN_CULL_BACK);
}

/* Asks the oracle about one sample of every pixel and triangle i. */
static void cover_sample(const batch *b, uint32_t i, uint32_t sample, cover *covers,
                         snapped_totals *totals)
{
    const snapped_triangle *const t = &b->triangle[i];
    const int winding = exact_winding(t);
    const bool is_drawn = !is_culled(b, winding);
    const int64_t x = exact_sample_place(b->samples, sample, 0);
    const int64_t y = exact_sample_place(b->samples, sample, 1);

    for (uint32_t row = 0; row < b->height; ++row) {
        for (uint32_t column = 0; column < b->width; ++column, ++covers) {
            const exact_place place =
                exact_place_in(t, winding, 256 * (int64_t)column + x, 256 * (int64_t)row + y);

            totals->ties += place == EXACT_TIE_LOST || place == EXACT_TIE_OWNED;
            if (is_drawn && exact_covers(place)) {
                covers->word[i / 24] |= 1u << i % 24;
                ++totals->covered;
            }
        }
    }
    totals->samples += (uint64_t)b->width * b->height;
}

static void cover_exactly(const batch *b, cover *covers, snapped_totals *totals)
{
    const size_t pixels = (size_t)b->width * b->height;

    memset(covers, 0, b->samples * pixels * sizeof *covers);
    for (uint32_t i = 0; i < b->count; ++i)
        for (uint32_t sample = 0; sample < b->samples; ++sample)
            cover_sample(b, i, sample, covers + sample * pixels, totals);
}

/* Whether the colour of sample n shows these covers: the sum of the triangles' powers of two, or
 * the number of the last triangle, 0 for none. */
static bool same_cover(const batch *b, const void *color, size_t n, const cover *covers)
{
    if (b->mode == MODE_SUM) {
        for (size_t c = 0; c < CHANNELS; ++c)
            if (((const float *)color)[CHANNELS * n + c] != (float)covers[n].word[c])
                return false;
        return true;
    }
    uint32_t last = b->count;

    while (last > 0 && !(covers[n].word[(last - 1) / 24] >> (last - 1) % 24 & 1u))
        --last;
    return ((const unsigned char *)color)[CHANNELS * n] == last;
}

static uint64_t count_differences(const batch *b, const void *color, const cover *covers,
                                  const char *who, uint64_t number)
{
    static const char *const modes[] = {"sum", "last", "shader"};
    static int reported;
    const uint32_t pixels = b->width * b->height;
    uint64_t different = 0;

    for (uint32_t n = 0; n < b->samples * pixels; ++n) {
        if (same_cover(b, color, n, covers))
            continue;
        if (different == 0 && reported < REPORTED) {
            ++reported;
            fprintf(stderr,
                    "exact-geometry: %s: batch %" PRIu64 " (%s, %" PRIu32 " triangles, %" PRIu32
                    "x%" PRIu32 "): pixel (%" PRIu32 ", %" PRIu32 "), sample %" PRIu32
                    " of %" PRIu32 " is not covered as the oracle says\n",
                    who, number, modes[b->mode], b->count, b->width, b->height,
                    n % pixels % b->width, n % pixels / b->width, n / pixels, b->samples);
        }
        ++different;
    }
    return different;
}

/* Memory for the largest frame. */
typedef struct buffers {
    void *color, *depth;
    cover *covers;
} buffers;

static void test_batch(reference *r, const batch *b, uint64_t number, const buffers *memory,
                       snapped_totals *totals)
{
    scene_frame frame;

    cover_exactly(b, memory->covers, totals);
    for (int n = GN_BACKEND_PORTABLE; n < GN_BACKEND_COUNT; ++n) {
        const gn_backend backend = (gn_backend)n;

        if (!gn_backend_available(backend))
            continue;

        const gn_status status = draw_batch(b, backend, memory->color, memory->depth);

        if (status != GN_OK) {
            fprintf(stderr, "exact-geometry: gn_draw: %s\n", gn_status_text(status));
            totals->broken = true;
            return;
        }
        totals->different +=
            count_differences(b, memory->color, memory->covers, gn_backend_name(backend), number);
        ++totals->frames;
    }
    if (number % REFERENCE_INTERVAL == 0) {
        if (!draw_reference(r, b, &frame)) {
            totals->broken = true;
            return;
        }
        totals->reference_different +=
            count_differences(b, frame.color, memory->covers, "the reference", number);
        ++totals->reference_frames;
        scene_frame_free(&frame);
    }
}

void test_snapped(reference *r, uint64_t seed, uint64_t triangles, snapped_totals *totals)
{
    const size_t samples = (size_t)GN_SAMPLES * 640 * 100;
    const buffers memory = {scene_allocate(samples, 16), scene_allocate(samples, 8),
                            scene_allocate(samples, sizeof(cover))};
    batch *const b = scene_allocate(1, sizeof *b);

    memset(totals, 0, sizeof *totals);
    while (totals->triangles < triangles && !totals->broken) {
        const uint64_t left = triangles - totals->triangles;
        random_source source = random_seed(seed + (totals->batches << 32));

        random_batch(&source, left < BATCH_TRIANGLES ? (uint32_t)left : BATCH_TRIANGLES, b);
        test_batch(r, b, totals->batches, &memory, totals);
        ++totals->batches;
        totals->triangles += b->count;
        show_progress("coverage after snapping", totals->triangles, triangles);
    }
    free(memory.color);
    free(memory.depth);
    free(memory.covers);
    free(b);
}
