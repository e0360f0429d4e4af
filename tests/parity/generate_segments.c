/* Draws about as long as the reference's segments. Most of their triangles are slivers that are
 * culled only if their segment has a vertex outside the view volume. Slivers and such vertices lie
 * around the boundaries of segments. */
#include "generate_parts.h"

#include <math.h>

/* A pixel in steps of snapping. */
#define STEPS 256

/* Draws that repeat slivers have at most this many: few enough for indices of 8 bits. */
#define MAX_POOL 60

/* A place in the window; (0, 0) is the first pixel's centre. */
typedef struct place {
    int32_t x, y;
} place;

/* The draw that is being generated. */
typedef struct segments {
    builder *b;
    bool clockwise; /* the winding of slivers after snapping */
    bool turned;    /* before snapping slivers have the other winding */
    place hub;      /* common to all slivers of a fan */
    uint32_t rest;  /* the vertex of triangles without area; for a fan, its hub */
    uint32_t pool[MAX_POOL][3];
    uint32_t pool_size; /* 0: every sliver has vertices of its own */
} segments;

/* Lengths of segments in elements, from the first element of a run. */
static const uint32_t lengths[] = {1022, 1023, 1024, 4094, 4095, 4096};

static uint32_t random_length(builder *b)
{
    return lengths[random_below(&b->random, 6)];
}

/* Adds a vertex beside a place. If it is less than half a step away, it snaps to the place. */
static uint32_t add_vertex(builder *b, place p, float off_x, float off_y)
{
    const uint32_t index = b->vertex_count;
    vertex *v = builder_vertex(b);
    const float z = random_float(&b->random, -0.9f, 0.9f);
    builder_place(b, v, ((float)p.x + off_x) / STEPS + 0.5f, ((float)p.y + off_y) / STEPS + 0.5f, z,
                  1.0f);
    return index;
}

/* Returns a pixel's centre, about the middle of the target. */
static place random_hub(builder *b)
{
    random_source *r = &b->random;
    place p;
    p.x = (int32_t)(b->scene->width / 4 + random_below(r, b->scene->width / 2)) * STEPS;
    p.y = (int32_t)(b->scene->height / 4 + random_below(r, b->scene->height / 2)) * STEPS;
    return p;
}

/* Finds the point of the lattice on the left of the line through (0, 0) and `way` that is nearest
 * to the line. Returns false if the line has lattice points between those two. */
static bool find_aside(place way, place *aside)
{
    for (aside->x = -7; aside->x <= 7; ++aside->x)
        for (aside->y = -7; aside->y <= 7; ++aside->y)
            if (way.x * aside->y - way.y * aside->x == 1)
                return true;
    return false;
}

/* Adds a sliver from a hub to a little beyond the centre of another pixel. The sliver covers that
 * centre once it is snapped: its far corners are then on either side of the line through both
 * centres, 1 / length of a step away from the line. Before snapping they may be 0.4 steps
 * elsewhere. */
static void add_sliver(segments *s, uint32_t sliver[3])
{
    random_source *r = &s->b->random;
    const place hub = s->b->state.raster.topology == GN_TRIANGLE_FAN ? s->hub : random_hub(s->b);
    place way, aside;
    do {
        way.x = random_between(r, -7, 7);
        way.y = random_between(r, -7, 7);
    } while (way.x * way.x + way.y * way.y < 9 || !find_aside(way, &aside));

    const float length = sqrtf((float)(way.x * way.x + way.y * way.y));
    /* Beyond the centre, starting from the lattice point `aside`. */
    const int32_t right = STEPS + random_between(r, 4, 40);
    const int32_t left = STEPS + random_between(r, 4, 40);
    const place end[2] = {{hub.x + right * way.x - aside.x, hub.y + right * way.y - aside.y},
                          {hub.x + left * way.x + aside.x, hub.y + left * way.y + aside.y}};

    sliver[0] =
        s->b->state.raster.topology == GN_TRIANGLE_FAN ? s->rest : add_vertex(s->b, hub, 0, 0);
    for (int i = 0; i < 2; ++i) {
        const float across = (i == 0 ? 0.42f : -0.42f) / length;
        float off_x = across * (float)-way.y, off_y = across * (float)way.x;
        if (!s->turned) {
            off_x = random_float(r, -0.4f, 0.4f);
            off_y = random_float(r, -0.4f, 0.4f);
        }
        sliver[s->clockwise ? 2 - i : 1 + i] = add_vertex(s->b, end[i], off_x, off_y);
    }
}

static void choose_sliver(segments *s, uint32_t sliver[3])
{
    if (s->pool_size == 0) {
        add_sliver(s, sliver);
        return;
    }
    const uint32_t n = random_below(&s->b->random, s->pool_size);
    for (int i = 0; i < 3; ++i)
        sliver[i] = s->pool[n][i];
}

static bool is_near_boundary(uint32_t element)
{
    for (int i = 0; i < 6; ++i)
        if ((element + 12) % lengths[i] < 24)
            return true;
    return false;
}

/* Adds the elements of a triangle to a run: a sliver or a triangle without area; the triangles of a
 * strip between two slivers have no area either. The third triangle of a segment without indices is
 * a sliver: if it had no height and were the last, the reference would lose it and the two before
 * it (reference/RULES.md). */
static void add_triangles(segments *s, uint32_t begin)
{
    builder *b = s->b;
    random_source *r = &b->random;
    const uint32_t n = b->index_count - begin;
    uint32_t sliver[3] = {s->rest, s->rest, s->rest};
    const bool is_third = b->state.raster.topology == GN_TRIANGLES && n % 4095 == 6;
    if (random_chance(r, is_near_boundary(n) ? 90 : 4) || is_third)
        choose_sliver(s, sliver);
    switch (b->state.raster.topology) {
    case GN_TRIANGLE_STRIP: {
        const uint32_t odd = (n + 1) & 1; /* its first two vertices are exchanged */
        builder_index(b, sliver[odd]);
        builder_index(b, sliver[odd]);
        builder_index(b, sliver[1 - odd]);
        builder_index(b, sliver[2]);
        builder_index(b, sliver[2]);
        break;
    }
    case GN_TRIANGLE_FAN:
        if (n == 0)
            builder_index(b, s->rest);
        if (random_chance(r, 10))
            builder_index(b, s->rest);
        builder_index(b, sliver[1]);
        builder_index(b, sliver[2]);
        builder_index(b, s->rest);
        break;
    default:
        for (int i = 0; i < 3; ++i)
            builder_index(b, sliver[i]);
        break;
    }
}

/* Adds a vertex of points or lines, near the previous one. */
static void add_step(segments *s)
{
    random_source *r = &s->b->random;
    uint32_t sliver[3];
    if (s->pool_size > 0) {
        choose_sliver(s, sliver);
        builder_index(s->b, sliver[random_below(r, 3)]);
        return;
    }
    const place hub = random_hub(s->b);
    const bool jumps = random_chance(r, 5);
    s->hub.x = jumps ? hub.x : s->hub.x + random_between(r, -3, 3) * STEPS;
    s->hub.y = jumps ? hub.y : s->hub.y + random_between(r, -3, 3) * STEPS;
    const float off_x = random_float(r, -128, 128), off_y = random_float(r, -128, 128);
    builder_index(s->b, add_vertex(s->b, s->hub, off_x, off_y));
}

static void add_run(segments *s, uint32_t count)
{
    builder *b = s->b;
    const uint32_t begin = b->index_count;
    while (b->index_count < begin + count)
        if (b->state.raster.topology <= GN_TRIANGLE_FAN)
            add_triangles(s, begin);
        else
            add_step(s);
    b->index_count = begin + count;
}

/* Returns an element beside a boundary of the segments that begin at element `begin`. */
static uint32_t random_boundary(builder *b, uint32_t begin)
{
    random_source *r = &b->random;
    const uint32_t count = b->index_count;
    const uint32_t length = random_length(b);
    const uint32_t boundary = begin + random_below(r, count / length + 1) * length;
    const uint32_t element = boundary + random_below(r, 9);
    const uint32_t last = count - 1;
    if (random_chance(r, 10))
        return random_below(r, count);
    return element < 4 ? 0 : element - 4 < last ? element - 4 : last;
}

/* Makes an element name a vertex outside the view volume. */
static void put_outside(builder *b, uint32_t element)
{
    random_source *r = &b->random;
    if (b->indices[element] == BUILDER_RESTART)
        return;
    const vertex from = b->vertices[b->indices[element]];
    const uint32_t kind = random_below(r, 10);
    b->indices[element] = b->vertex_count;
    vertex *v = builder_vertex(b);
    *v = from;
    if (kind == 0)
        v->position[0] = 3.0f;
    else if (kind == 1)
        v->position[3] = -1.0f;
    else
        v->position[2] = kind % 2 ? 2.0f : -1.5f;
}

/* Adds vertices that no element names, some of them outside the view volume. */
static void add_unnamed(builder *b, uint32_t count)
{
    for (uint32_t n = 0; n < count; ++n) {
        const float z = random_chance(&b->random, 40) ? 2.0f : 0.0f;
        builder_vertex(b)->position[2] = z;
    }
}

static void choose_state(builder *b)
{
    static const gn_topology lines[] = {GN_POINTS, GN_LINES, GN_LINE_STRIP, GN_LINE_LOOP};
    static const gn_topology triangles[] = {GN_TRIANGLES, GN_TRIANGLE_STRIP, GN_TRIANGLE_FAN,
                                            GN_TRIANGLE_FAN};
    random_source *r = &b->random;
    builder_common_target(b);
    builder_common_state(b);
    b->state.raster.topology = triangles[random_below(r, 4)];
    if (random_chance(r, 12)) {
        b->state.raster.topology = lines[random_below(r, 4)];
        b->state.raster.line_width = random_chance(r, 70) ? 0.0f : 2.0f;
        b->state.raster.point_size = random_float(r, 1.0f, 3.0f);
    }
    b->state.raster.cull = (gn_cull)(1 + random_below(r, 2));
    if (random_chance(r, 8))
        b->state.raster.cull = GN_CULL_NONE;
    b->state.raster.front_face = (gn_front_face)random_below(r, 2);
    b->state.raster.provoking_vertex = (gn_provoking_vertex)random_below(r, 2);
    b->state.depth.test_enabled = false;
    for (int i = 0; i < 4 && random_chance(r, 20); ++i)
        b->state.program.interpolation[i] = GN_FLAT;
    if (random_chance(r, 8)) {
        b->state.raster.polygon_mode_front = (gn_polygon_mode)random_below(r, 3);
        b->state.raster.polygon_mode_back = (gn_polygon_mode)random_below(r, 3);
    }
}

/* Elements of a draw: a number of whole segments, one element more, one less, about as many, or any
 * number. */
static uint32_t choose_count(builder *b)
{
    random_source *r = &b->random;
    const bool indexed = b->index_format != GN_INDEX_NONE;
    uint32_t count = random_chance(r, indexed ? 10 : 70) ? 4096 : 0;
    for (uint32_t n = random_below(r, 3) + (count == 0); n > 0; --n)
        count += lengths[random_below(r, 3)];
    if (random_chance(r, 10))
        count += 4096;
    switch (random_below(r, 8)) {
    case 0:
        return count + random_below(r, 1024);
    case 1:
    case 2:
        return count - 4 + random_below(r, 18);
    default:
        return count - 1 + random_below(r, 3);
    }
}

void generate_segments(builder *b)
{
    static const gn_index_format formats[] = {GN_INDEX_UINT8, GN_INDEX_UINT16, GN_INDEX_UINT32};
    random_source *r = &b->random;
    segments s = {.b = b};

    choose_state(b);
    s.clockwise = (b->state.raster.cull == GN_CULL_FRONT) ==
                  (b->state.raster.front_face != GN_FRONT_CLOCKWISE);
    if (random_chance(r, 5))
        s.clockwise = !s.clockwise;
    s.turned = random_chance(r, 90);
    s.hub = random_hub(b);
    if (random_chance(r, 60))
        b->index_format = formats[random_below(r, 3)];
    /* The reference draws longer loops with indices wrongly (reference/RULES.md). */
    if (b->state.raster.topology == GN_LINE_LOOP)
        b->index_format = GN_INDEX_NONE;
    add_unnamed(b, random_below(r, 10));
    const int32_t least = (int32_t)b->vertex_count;
    s.rest = add_vertex(b, s.hub, 0, 0);
    add_unnamed(b, random_below(r, 2));
    const uint32_t pool = 1 + random_below(r, MAX_POOL);
    if (b->index_format == GN_INDEX_UINT8 || random_chance(r, 20)) {
        for (uint32_t n = 0; n < pool; ++n)
            add_sliver(&s, s.pool[n]);
        s.pool_size = pool;
    }

    const uint32_t count = choose_count(b);
    uint32_t begin = 0;
    if (b->index_format != GN_INDEX_NONE && random_chance(r, 35)) {
        b->restart = random_chance(r, 50) ? GN_RESTART_FIXED_INDEX : GN_RESTART_INDEX;
        b->restart_index = b->index_format == GN_INDEX_UINT8 ? 250 : 60000;
        for (uint32_t n = 1 + random_below(r, 3); n > 0; --n) {
            const uint32_t most = random_chance(r, 70) ? 8 : 1100;
            add_run(&s, random_below(r, most));
            builder_index(b, BUILDER_RESTART);
        }
        begin = b->index_count;
    }
    add_run(&s, count);
    const uint32_t outside[] = {0, 1, 1, 1, 2};
    for (uint32_t n = outside[random_below(r, 5)]; n > 0; --n)
        put_outside(b, random_boundary(b, begin));

    if (b->index_format != GN_INDEX_NONE && random_chance(r, 30))
        b->base_vertex = random_between(r, -20, least);
    if (random_chance(r, 20))
        b->lead = random_below(r, 9);
    if (random_chance(r, 20))
        b->trail = random_below(r, 9);
    b->instance_count = random_chance(r, 10) ? 2 : 0;
    b->counted = random_chance(r, 40);
    if (random_chance(r, 10))
        random_inputs(b);
    builder_draw(b);
}
