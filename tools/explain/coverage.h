/* What is told about coverage: corners and edge functions of the primitive, at the pixel's samples.
 * The library computes edges in steps; here they are computed anew and compared.
 * Not alone: around_fragments.h includes it. */
#ifndef EXPLAIN_COVERAGE_H
#define EXPLAIN_COVERAGE_H

/* An edge function at a place in 1/256 pixel. Snapped coordinates are below 2^24, so everything
 * fits 64 bits. */
typedef struct edge_here {
    int64_t dx, dy, value;
    bool owns_ties;
} edge_here;

static edge_here edge_at(const stored_vertex *a, const stored_vertex *b, int64_t x, int64_t y)
{
    edge_here e;

    e.dx = (int64_t)a->snapped[1] - b->snapped[1];
    e.dy = (int64_t)a->snapped[0] - b->snapped[0];
    e.value = e.dx * (a->snapped[0] - x) - e.dy * (a->snapped[1] - y);
    e.owns_ties = e.dx < 0 || (e.dx == 0 && (traced_setup->upside_down ? e.dy < 0 : e.dy > 0));
    return e;
}

/* Which horizontal edges own their ties. */
static const char *owning_side(void)
{
    return traced_setup->upside_down ? "top" : "bottom";
}

static bool holds_place(const edge_here *e)
{
    return e->value > 0 || (e->value == 0 && e->owns_ties);
}

static void put_product(prose *t, int64_t a, int64_t b)
{
    const int64_t factor[2] = {a, b};

    for (int i = 0; i < 2; ++i) {
        prose_put(t, i ? " * " : "");
        prose_put(t, factor[i] < 0 ? "(" : "");
        prose_integer(t, factor[i]);
        prose_put(t, factor[i] < 0 ? ")" : "");
    }
}

static void tell_edge(int i, uint32_t lane, int64_t x, int64_t y)
{
    const stored_vertex *const a = corner_of((uint32_t)i, lane);
    const stored_vertex *const b = corner_of((uint32_t)(i + 1) % 3, lane);
    const edge_here e = edge_at(a, b, x, y);
    const char *const name = joined(joined("edge.", label_of(a), "_"), label_of(b), "");
    prose words = {0};

    put_product(&words, e.dx, a->snapped[0] - x);
    prose_put(&words, " - ");
    put_product(&words, e.dy, a->snapped[1] - y);
    prose_put(&words, e.value > 0   ? "; above 0: inside"
                      : e.value < 0 ? "; below 0: outside"
                      : e.owns_ties ? "; a tie, and the edge is a left or a horizontal "
                                    : "; a tie, and the edge is neither a left nor a horizontal ");
    if (e.value == 0) {
        prose_put(&words, owning_side());
        prose_put(&words, e.owns_ties ? " edge: inside" : " edge: outside");
    }
    report_integer(name, e.value, prose_of(&words));
    prose_free(&words);
}

/* Tells the edge functions of a triangle at a place. */
static void tell_edges(uint32_t lane, int64_t x, int64_t y)
{
    int64_t value[3], area = 0;
    bool inside = true;

    for (int i = 0; i < 3; ++i) {
        const edge_here e =
            edge_at(corner_of((uint32_t)i, lane), corner_of((uint32_t)(i + 1) % 3, lane), x, y);

        tell_edge(i, lane, x, y);
        value[i] = e.value;
        area += e.value;
        inside = inside && holds_place(&e);
    }
    report_integer("twice_the_area", area, "the sum of the three, whatever the place");
    for (int i = 0; i < 3 && inside && area > 0; ++i) {
        const int opposite = (i + 2) % 3;
        prose number = {0}, words = {0};

        prose_fraction(&number, value[i], area, 6);
        prose_integer(&words, value[i]);
        prose_put(&words, " / ");
        prose_integer(&words, area);
        prose_put(&words, ": the edge opposite the vertex, over twice the area");
        report_tell(joined("barycentric.", label_of(corner_of((uint32_t)opposite, lane)), ""),
                    prose_of(&number), "", prose_of(&words));
        prose_free(&number);
        prose_free(&words);
    }
}

static uint32_t traced_corners(void)
{
    return traced_kind == KIND_TRIANGLE ? 3 : traced_kind == KIND_LINE ? 2 : 1;
}

static void begin_coverage(void)
{
    report_begin(
        traced_kind == KIND_TRIANGLE
            ? "Edges: is the pixel's centre inside? Coordinates are integers, in 1/256 pixel"
            : "The primitive");
}

/* A place of the pixel, in 1/256 pixel: its centre, or of several samples one. */
static int64_t place_of_sample(uint32_t sample, uint32_t samples, int axis)
{
    return 256 * (int64_t)(axis ? pixel.y : pixel.x) +
           (samples > 1 ? sample_offset(sample, axis) : 0);
}

/* Returns which samples of the pixel a triangle covers, by its edge functions: bit s for sample s.
 */
static uint32_t covered_samples(uint32_t lane, uint32_t samples)
{
    uint32_t covered = 0;

    for (uint32_t s = 0; s < samples; ++s) {
        bool inside = true;

        for (uint32_t i = 0; i < 3; ++i) {
            const edge_here e =
                edge_at(corner_of(i, lane), corner_of((i + 1) % 3, lane),
                        place_of_sample(s, samples, 0), place_of_sample(s, samples, 1));

            inside = inside && holds_place(&e);
        }
        covered |= (uint32_t)inside << s;
    }
    return covered;
}

/* Tells the corners of a primitive, and the edge functions of a triangle at the pixel's samples. */
static void tell_coverage(uint32_t lane, uint32_t samples)
{
    const uint32_t corners = traced_corners();
    prose words = {0};

    for (uint32_t i = 0; i < corners; ++i) {
        prose_put(&words, i ? ", " : "");
        prose_put(&words, label_of(corner_of(i, lane)));
    }
    report_tell("corners", prose_of(&words), "",
                traced_kind == KIND_TRIANGLE
                    ? "in the order in which the three numbers below are above 0 inside"
                : traced_kind == KIND_LINE ? "the ends; pixels are covered by the diamond-exit rule"
                                           : "the square around it covers the pixel's centre");
    prose_free(&words);
    if (corners < 3)
        return;
    report_tell("edge.a_b", "", "",
                "(a.snapped.y - b.snapped.y) * (a.snapped.x - place.x) - (a.snapped.x - "
                "b.snapped.x) * (a.snapped.y - place.y)");
    report_tell(
        "inside", "", "",
        joined("all three are above 0; 0 counts too on a left edge and on a horizontal ",
               owning_side(),
               " edge, so that of two triangles with a common edge only one has the pixel"));
    const uint32_t covered = covered_samples(lane, samples);

    for (uint32_t s = 0; s < samples; ++s) {
        const int64_t x = place_of_sample(s, samples, 0), y = place_of_sample(s, samples, 1);

        if (samples > 1)
            report_begin(joined_number("Edges at sample ", s,
                                       covered >> s & 1u ? ": covered" : ": not covered"));
        report_integer("place.x", x,
                       samples > 1 ? "256 * pixel x + the sample's offset"
                                   : "256 * pixel x: snapped coordinates count from "
                                     "the centre of pixel (0, 0)");
        report_integer("place.y", y, "likewise");
        tell_edges(lane, x, y);
    }
}

static void tell_missing(void)
{
    const uint32_t samples = scene_is_sampled(pixel.scene) ? GN_SAMPLES : 1;
    const bool tells = trace.is_recording && traced_kind == KIND_TRIANGLE;

    for (uint32_t l = 0; l < traced_list->count && tells; ++l) {
        begin_coverage();
        tell_coverage(l, samples);
        pixel.edges_hold |= covered_samples(l, samples) != 0;
    }
    trace.is_recording = false;
}

/* Checks the numbers that the library set up for an edge against the exact ones: its value at the
 * lower left pixel of the squares, rounded down to whole pixels with the tie rule folded in. */
static void check_edge(int i, uint32_t lane)
{
    const int64_t x = 256 * (int64_t)traced_setup->origin[0][lane];
    const int64_t y = 256 * (int64_t)traced_setup->origin[1][lane];
    const edge_here e =
        edge_at(corner_of((uint32_t)i, lane), corner_of((uint32_t)(i + 1) % 3, lane), x, y);
    const int64_t c = e.value - 1 + e.owns_ties;
    const int64_t start = (c - ((c % 256) + 256) % 256) / 256;

    if (traced_setup->unpacked >> lane & 1u)
        return; /* it is computed in 64 bits elsewhere */
    if (traced_setup->edge[i].start[lane] != start || traced_setup->edge[i].per_x[lane] != e.dx ||
        traced_setup->edge[i].per_y[lane] != e.dy)
        told_fault("set-up of an edge: other numbers than the exact ones", "");
}

#endif
