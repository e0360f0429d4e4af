/* Counts of what became of random primitives: against a recount in plain C, against the same
 * primitives drawn in other ways, and one by one. */
#include <math.h>

#include "counted_draw.h"
#include "noise.h"

static uint32_t seed;

static float random_between(float low, float high)
{
    return low + (high - low) * noise(&seed);
}

static uint32_t random_below(uint32_t limit)
{
    return (uint32_t)(noise(&seed) * (float)limit);
}

/* What a recount of a triangle finds. */
typedef enum fate { NOT_FINITE, OUTSIDE, WITHOUT_AREA, CULLED, MISSED, DRAWN, UNCERTAIN } fate;

typedef struct recounted {
    fate fate;
    bool is_behind, is_clipped;
} recounted;

typedef struct point {
    double x, y, w;
} point;

/* The recount clips to the sides of the view volume alone: z is always inside. */
static double side_distance(const point *p, int side)
{
    const double c = side < 2 ? p->x : p->y;

    return side % 2 ? p->w + c : p->w - c;
}

static int clip_polygon(point *polygon, int count)
{
    for (int side = 0; side < 4; ++side) {
        point out[16];
        int n = 0;

        for (int i = 0; i < count; ++i) {
            const point *a = &polygon[i], *b = &polygon[(i + 1) % count];
            const double p = side_distance(a, side), q = side_distance(b, side);

            if (p >= 0)
                out[n++] = *a;
            if ((p < 0) != (q < 0)) {
                const double t = p / (p - q);
                out[n++] = (point){a->x + t * (b->x - a->x), a->y + t * (b->y - a->y),
                                   a->w + t * (b->w - a->w)};
            }
        }
        memcpy(polygon, out, sizeof *out * (size_t)n);
        count = n;
    }
    return count;
}

static bool is_dropped(bool clockwise)
{
    const bool front = clockwise == (pipeline.raster.front_face == GN_FRONT_CLOCKWISE);

    return pipeline.raster.cull == GN_CULL_FRONT_AND_BACK ||
           pipeline.raster.cull == (front ? GN_CULL_FRONT : GN_CULL_BACK);
}

/* The pixels that may be drawn on: the target or the scissor. */
static void drawable(double low[2], double high[2])
{
    const gn_scissor *s = &pipeline.raster.scissor;

    low[0] = s->enabled ? s->x : 0;
    low[1] = s->enabled ? s->y : 0;
    high[0] = s->enabled ? s->x + (double)s->width : WIDTH;
    high[1] = s->enabled ? s->y + (double)s->height : HEIGHT;
}

/* Returns whether a centre of a drawable pixel, or anything up to `reach` around it, lies in a
 * rectangle. */
static bool has_centre(double x0, double y0, double x1, double y1, double reach)
{
    double low[2], high[2];

    drawable(low, high);
    return fmax(ceil(x0 - reach - 0.5), low[0]) <= fmin(floor(x1 + reach - 0.5), high[0] - 1) &&
           fmax(ceil(y0 - reach - 0.5), low[1]) <= fmin(floor(y1 + reach - 0.5), high[1] - 1);
}

/* Returns whether a drawable pixel's centre lies well inside a convex polygon. */
static bool holds_centre(const point *window, int count, double sign)
{
    double low[2], high[2];

    drawable(low, high);
    for (double y = low[1] + 0.5; y < high[1]; ++y) {
        for (double x = low[0] + 0.5; x < high[0]; ++x) {
            bool inside = true;

            for (int i = 0; i < count; ++i) {
                const point *a = &window[i], *b = &window[(i + 1) % count];
                const double ex = b->x - a->x, ey = b->y - a->y;

                inside = inside && sign * (ex * (y - a->y) - ey * (x - a->x)) >=
                                       0.05 * sqrt(ex * ex + ey * ey);
            }
            if (inside)
                return true;
        }
    }
    return false;
}

/* What is left of a triangle that crosses the view volume. Where rounding may decide, UNCERTAIN. */
static fate fate_of_clipped(const uint32_t v[3], double reach)
{
    point polygon[16];
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY}, area = 0;

    for (int i = 0; i < 3; ++i)
        polygon[i] = (point){(double)position[v[i]][0], (double)position[v[i]][1],
                             (double)position[v[i]][3]};
    const int count = clip_polygon(polygon, 3);
    if (count == 0)
        return OUTSIDE;
    for (int i = 0; i < count; ++i) {
        point *p = &polygon[i];

        if (p->w < 1e-3)
            return UNCERTAIN;
        p->x = (p->x / p->w + 1) * 0.5 * WIDTH;
        p->y = (p->y / p->w + 1) * 0.5 * HEIGHT;
        low[0] = fmin(low[0], p->x);
        low[1] = fmin(low[1], p->y);
        high[0] = fmax(high[0], p->x);
        high[1] = fmax(high[1], p->y);
    }
    for (int i = 0; i < count; ++i)
        area +=
            polygon[i].x * polygon[(i + 1) % count].y - polygon[i].y * polygon[(i + 1) % count].x;
    if (fabs(area) < 0.5)
        return UNCERTAIN;
    if (is_dropped(area < 0))
        return CULLED;
    if (!has_centre(low[0] - 0.05, low[1] - 0.05, high[0] + 0.05, high[1] + 0.05, reach))
        return MISSED;
    return holds_centre(polygon, count, area < 0 ? -1 : 1) ? DRAWN : UNCERTAIN;
}

/* Recounts a triangle from its clip coordinates. `reach` is that of samples, in pixels. */
static recounted recount(const uint32_t v[3], double reach)
{
    recounted r = {DRAWN, true, false};
    int32_t snapped[3][2];
    float window[3][2];
    uint32_t all = ~0u, any = 0;
    bool has_place = true;

    for (int i = 0; i < 3; ++i) {
        const float *const p = position[v[i]];
        uint32_t outcode = 0;

        if (!isfinite(p[0]) || !isfinite(p[1]) || !isfinite(p[2]) || isnan(p[3])) {
            r.fate = NOT_FINITE;
            return r;
        }
        for (int c = 0; c < 3; ++c) {
            outcode |= (p[c] <= p[3] ? 0u : 1u) << 2 * c;
            outcode |= (0 <= p[c] + p[3] ? 0u : 2u) << 2 * c;
        }
        all &= outcode;
        any |= outcode;
        has_place = has_place && p[3] != 0.0f;
        r.is_behind = r.is_behind && p[3] <= 0;
        for (int c = 0; c < 2; ++c) {
            const float half = 0.5f * (c ? HEIGHT : WIDTH);
            const float corner = reach > 0 ? 0.0f : 0.5f;

            window[i][c] = p[c] * (1.0f / p[3]) * half + half;
            snapped[i][c] = 0;
            if (!any && has_place)
                snapped[i][c] = (int32_t)lrintf((window[i][c] - corner) * 256.0f);
            if (reach > 0)
                snapped[i][c] -= 128;
        }
    }
    r.is_clipped = any != 0;
    if (all) {
        r.fate = OUTSIDE;
        return r;
    }
    r.is_behind = false;
    if (any || !has_place) {
        r.fate = any ? fate_of_clipped(v, reach) : NOT_FINITE;
        return r;
    }
    const int64_t area =
        (int64_t)(snapped[1][0] - snapped[0][0]) * (snapped[2][1] - snapped[0][1]) -
        (int64_t)(snapped[1][1] - snapped[0][1]) * (snapped[2][0] - snapped[0][0]);
    const float unsnapped = (window[0][0] - window[2][0]) * (window[1][1] - window[2][1]) -
                            (window[0][1] - window[2][1]) * (window[1][0] - window[2][0]);
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};

    for (int i = 0; i < 3; ++i) {
        for (int c = 0; c < 2; ++c) {
            low[c] = fmin(low[c], snapped[i][c] / 256.0 + 0.5);
            high[c] = fmax(high[c], snapped[i][c] / 256.0 + 0.5);
        }
    }
    if (area == 0)
        r.fate = WITHOUT_AREA;
    else if ((area < 0) != (unsnapped < 0) || unsnapped == 0)
        r.fate = UNCERTAIN; /* two ways to cull disagree, of which segments choose one */
    else if (is_dropped(area < 0))
        r.fate = CULLED;
    else if (!has_centre(low[0], low[1], high[0], high[1], reach))
        r.fate = MISSED;
    return r;
}

/* Sets one random vertex: inside the target, around it, far away or behind the eye. */
static void set_vertex(uint32_t n)
{
    const uint32_t kind = random_below(10);
    const float reach = kind < 6 ? 0.0f : kind < 9 ? 10.0f : 60.0f;
    const float distance = random_between(0.5f, 4.0f);
    const float w = random_below(20) == 0 ? -distance : distance;
    const float x = random_between(-reach, WIDTH + reach);
    const float y = random_between(-reach, HEIGHT + reach);
    const uint32_t odd = random_below(400);

    place(n, x, y);
    multiply(n, w);
    position[n][2] = 0.0f;
    position[n][3] = w;
    if (odd < 6)
        position[n][odd / 2] = odd % 2 ? NAN : INFINITY;
    if (odd == 6)
        position[n][3] = NAN;
    if (odd == 7)
        memset(position[n], 0, sizeof position[n]);
}

static void set_triangle(uint32_t first)
{
    const uint32_t kind = random_below(6);

    for (uint32_t i = 0; i < 3; ++i)
        set_vertex(first + i);
    for (uint32_t i = 1; kind < 2 && i < 3; ++i) { /* a small one */
        memcpy(position[first + i], position[first], sizeof position[first]);
        for (int c = 0; c < 2; ++c)
            position[first + i][c] += random_between(-0.1f, 0.1f) * position[first][3];
    }
    if (kind == 2) { /* without area */
        const uint32_t from = first + random_below(3);
        const uint32_t to = first + random_below(3);

        memmove(position[to], position[from], sizeof position[to]);
    }
}

static void add_fate(gn_draw_statistics *n, const recounted *r)
{
    ++n->primitives;
    n->not_finite += r->fate == NOT_FINITE;
    n->outside += r->fate == OUTSIDE;
    n->behind += r->fate == OUTSIDE && r->is_behind;
    n->without_area += r->fate == WITHOUT_AREA;
    n->culled += r->fate == CULLED;
    n->missed += r->fate == MISSED;
    n->drawn += r->fate == DRAWN;
    n->clipped += r->fate == DRAWN && r->is_clipped;
}

static void set_random_state(void)
{
    gn_scissor scissor;

    pipeline.raster.cull = (gn_cull)random_below(4);
    pipeline.raster.front_face = (gn_front_face)random_below(2);
    pipeline.depth.test_enabled = random_below(2) != 0;
    scissor.enabled = random_below(2) != 0;
    scissor.x = (int32_t)random_below(WIDTH / 2);
    scissor.y = (int32_t)random_below(HEIGHT / 2);
    scissor.width = 1 + random_below(WIDTH / 2);
    scissor.height = 1 + random_below(HEIGHT / 2);
    pipeline.raster.scissor = scissor;
}

/* Random triangles, of several segments in some scenes, against the recount. A triangle on which
 * rounding decides is replaced. */
static void random_triangles_are_recounted(void **state)
{
    uint64_t least[6] = {0};

    memset(extra, 0, sizeof extra);
    seed = 1;
    for (int scene = 0; scene < 40; ++scene) {
        const uint32_t count = scene % 8 == 0 ? MOST / 3 : 1 + random_below(200);
        const uint32_t samples = scene % 3 == 2 ? GN_SAMPLES : 1;
        gn_draw_statistics expected = {0};

        reset(GN_TRIANGLES, 3 * count, samples);
        set_random_state();
        for (uint32_t t = 0; t < count; ++t) {
            const uint32_t v[3] = {3 * t, 3 * t + 1, 3 * t + 2};
            recounted r;

            do {
                set_triangle(3 * t);
                r = recount(v, samples > 1 ? 0.375 : 0.0);
            } while (r.fate == UNCERTAIN);
            add_fate(&expected, &r);
            ++least[r.fate];
        }
        const gn_draw_statistics counts = count_draw();
        expected.samples_covered = counts.samples_covered;
        expected.samples_passed = counts.samples_passed;
        expect_equal(&counts, &expected, __LINE__, "recount");
    }
    for (int f = 0; f < 6; ++f)
        assert_true(least[f] > 100);
}

/* Strips, fans, lines, with restarts and instances: as their primitives drawn one by one. */
static void topologies_count_as_their_primitives(void **state)
{
    static float pool[64][4];
    static const gn_topology lists[] = {GN_TRIANGLES, GN_TRIANGLES, GN_LINES, GN_LINES};
    static const gn_topology joined[] = {GN_TRIANGLE_STRIP, GN_TRIANGLE_FAN, GN_LINE_STRIP,
                                         GN_LINE_LOOP};

    memset(extra, 0, sizeof extra);
    seed = 2;
    for (int scene = 0; scene < 60; ++scene) {
        const gn_topology topology = joined[scene % 4];
        const uint32_t corners = scene % 4 < 2 ? 3 : 2;
        const uint32_t instances = 1 + random_below(3);
        const uint32_t runs = 1 + random_below(4);
        uint16_t list[1024];
        uint32_t elements = 0, listed = 0;

        for (uint32_t v = 0; v < 64; ++v)
            set_vertex(v);
        memcpy(pool, position, sizeof pool);
        for (uint32_t run = 0; run < runs; ++run) {
            const uint32_t count = corners + random_below(20);
            uint16_t *const own = &indices[elements];

            for (uint32_t i = 0; i < count; ++i)
                own[i] = (uint16_t)random_below(64);
            for (uint32_t i = 0; i + corners <= count + (topology == GN_LINE_LOOP); ++i) {
                const bool fan = topology == GN_TRIANGLE_FAN;
                const bool odd = topology == GN_TRIANGLE_STRIP && i % 2;

                list[listed++] = fan ? own[0] : own[i + odd];
                list[listed++] = own[(i + 1 - odd) % count];
                if (corners == 3)
                    list[listed++] = own[i + 2];
            }
            elements += count;
            indices[elements++] = UINT16_MAX;
        }
        reset(topology, 64, scene % 5 == 4 ? GN_SAMPLES : 1);
        set_random_state();
        pipeline.raster.polygon_mode_front = (gn_polygon_mode)random_below(3);
        pipeline.raster.line_width = 3.0f;
        mesh.indices = indices;
        mesh.index_format = GN_INDEX_UINT16;
        mesh.restart = GN_RESTART_FIXED_INDEX;
        mesh.count = elements;
        mesh.instance_count = instances;
        gn_draw_statistics counts = count_draw();
        counts.samples_passed = 0;

        mesh.restart = GN_RESTART_NONE;
        mesh.indices = list;
        mesh.count = listed;
        pipeline.raster.topology = lists[scene % 4];
        mesh.instance_count = 1;
        gn_draw_statistics expected = count_draw();
        uint64_t *const count = (uint64_t *)(void *)&expected;

        for (size_t n = 0; n < sizeof expected / sizeof *count; ++n)
            count[n] *= instances;
        expected.samples_passed = 0;
        expect_equal(&counts, &expected, __LINE__, "list");
        assert_int_equal(counts.primitives, (uint64_t)instances * listed / corners);
    }
}

/* The samples of the primitives drawn one by one, on a clear target each. */
static void covered_samples_are_those_of_each_primitive(void **state)
{
    static const gn_topology topologies[] = {GN_TRIANGLES, GN_LINES, GN_POINTS};
    static unsigned char memory[GN_WORKSPACE_SIZE(3, 0)];

    seed = 3;
    for (int scene = 0; scene < 30; ++scene) {
        const uint32_t samples = scene % 2 ? GN_SAMPLES : 1;
        const uint32_t corners = 3 - (uint32_t)(scene % 3);
        const uint32_t count = 1 + random_below(40);
        uint64_t covered = 0;

        reset(topologies[scene % 3], corners * count, samples);
        set_random_state();
        pipeline.raster.cull = GN_CULL_NONE;
        pipeline.raster.line_width = 2.0f;
        pipeline.program.vertex_writes_point_size = true;
        for (uint32_t v = 0; v < corners * count; ++v) {
            set_vertex(v);
            extra[v][1] = random_between(0.0f, 9.0f);
        }
        const gn_draw_statistics counts = count_draw();
        mesh.count = corners;
        for (uint32_t i = 0; i < count; ++i, mesh.first += corners) {
            gn_workspace workspace = {.memory = memory, .size = sizeof memory};

            clear();
            assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
            for (uint32_t p = 0; p < samples * WIDTH * HEIGHT; ++p)
                covered += color[p] != 0;
        }
        assert_int_equal(counts.samples_covered, covered);
        if (!pipeline.depth.test_enabled)
            assert_int_equal(counts.samples_passed, covered);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_triangles_are_recounted),
        cmocka_unit_test(topologies_count_as_their_primitives),
        cmocka_unit_test(covered_samples_are_those_of_each_primitive),
    };

    return cmocka_run_group_tests_name("random statistics", tests, NULL, NULL);
}
