/* Creases in computed normals: a cube, angles, what a file says of smoothing, and random triangles
 * against the definition, corner by corner. */
#include "model_test.h"

#include "../unit/noise.h"

#define CUBE_VERTICES "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
#define CUBE_FACES "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
#define CUBE CUBE_VERTICES CUBE_FACES

static void read_creased(const char *text, double crease)
{
    read_crease = crease;
    expect_read(read_obj_text(text, NULL), NULL);
    read_crease = MODEL_CREASE_DEGREES;
}

/* A cube keeps its edges: each face has four vertices, whose normals are the face's. */
static void test_cube(void **state)
{
    read_creased(CUBE, 40.0);
    const model_part *const p = read_model.parts;
    expect_sizes(p, MODEL_TRIANGLES, 24, 36);
    for (size_t i = 0; i < 36; ++i) {
        /* Two triangles a face; faces 0 to 5 are z, z, y, x, y, x. */
        static const int axis[6] = {2, 2, 1, 0, 1, 0};
        static const float sign[6] = {-1, 1, -1, 1, 1, -1};
        float expected[3] = {0, 0, 0};
        expected[axis[i / 6]] = sign[i / 6];
        expect_floats(p->normals + 3 * p->indices[i], expected, 3);
    }
    read_creased(CUBE, 90.5);
    expect_sizes(read_model.parts, MODEL_TRIANGLES, 8, 36);
    read_creased(CUBE, 180.0);
    expect_sizes(read_model.parts, MODEL_TRIANGLES, 8, 36);
    expect_floats(read_model.parts->normals,
                  (const float[]){-0.57735027f, -0.57735027f, -0.57735027f}, 3);
}

/* Two triangles that turn by an angle at their common edge. */
static void test_angles(void **state)
{
    for (int degrees = 1; degrees < 180; ++degrees) {
        const double radians = degrees * (3.14159265358979323846 / 180.0);
        char text[256];
        snprintf(text, sizeof text,
                 "v 0 0 0\nv 0 1 0\nv -1 0 0\nv %.17g 0 %.17g\nf 1 2 3\nf 2 1 4\n", cos(radians),
                 sin(radians));
        read_creased(text, degrees + 0.01);
        expect_sizes(read_model.parts, MODEL_TRIANGLES, 4, 6);
        read_creased(text, degrees - 0.01);
        expect_sizes(read_model.parts, MODEL_TRIANGLES, 6, 6);
    }
}

/* What the file says of normals and smoothing stays as it is. */
static void test_files_own(void **state)
{
    read_creased(CUBE_VERTICES "s 1\n" CUBE_FACES, 40.0);
    expect_sizes(read_model.parts, MODEL_TRIANGLES, 8, 36);
    read_creased("vn 0 0 1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                 "f 1//1 2//1 3//1\nf 2//1 1//1 4//1\n",
                 40.0);
    expect_sizes(read_model.parts, MODEL_TRIANGLES, 4, 6);
}

/* A seam of the texture is no crease: the vertices on both sides have one normal. Colours and
 * texture coordinates go with the corners. */
static void test_seams(void **state)
{
    read_creased("v 0 0 0 1 0 0\nv 0 1 0 0 1 0\nv -1 0 0 0 0 1\nv 1 0 0.1 1 1 1\nv 0 0.5 -1 0 0 0\n"
                 "vt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\n"
                 "f 1/1 2/2 3/3\nf 2/3 1/4 4/1\nf 1/2 2/1 5/4\n",
                 40.0);
    static const float texcoords[9][2] = {{0, 0}, {1, 0}, {0, 1}, {0, 1}, {1, 1},
                                          {0, 0}, {1, 0}, {0, 0}, {1, 1}};
    static const float colors[9][4] = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1},
                                       {0, 1, 0, 1}, {1, 0, 0, 1}, {1, 1, 1, 1},
                                       {1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 0, 1}};
    const model_part *const p = read_model.parts;
    assert_int_equal(p->index_count, 9);
    for (size_t i = 0; i < 9; ++i) {
        expect_floats(p->texcoords + 2 * p->indices[i], texcoords[i], 2);
        expect_floats(p->colors + 4 * p->indices[i], colors[i], 4);
    }
    expect_floats(p->normals + 3 * p->indices[0], p->normals + 3 * p->indices[4], 3);
    expect_floats(p->normals + 3 * p->indices[1], p->normals + 3 * p->indices[3], 3);
    assert_true(p->normals[3 * p->indices[0] + 2] > 0.9f);
    assert_true(fabsf(p->normals[3 * p->indices[6]]) > 0.9f);
}

/* The ends of lines have the normal of the first triangles there. */
static void test_lines(void **state)
{
    read_creased(CUBE "l 1 7\n", 40.0);
    assert_int_equal(read_model.part_count, 2);
    const model_part *const p = read_model.parts + 1;
    expect_sizes(p, MODEL_LINES, 2, 2);
    expect_floats(p->normals + 3 * p->indices[0], (const float[]){0, 0, -1}, 3);
    expect_floats(p->normals + 3 * p->indices[1], (const float[]){0, 0, 1}, 3);
}

/* A place with very many triangles, all of them divided from each other, takes no long time. */
static void test_hub(void **state)
{
    enum { TRIANGLES = 100000 };
    model m;
    uint64_t memory = UINT64_MAX;
    assert_true(model_allocate(&m, false, 1 + 2 * TRIANGLES, 3 * TRIANGLES));
    for (uint32_t i = 0; i < TRIANGLES; ++i) {
        float *const p = m.parts->positions + 3 * (1 + 2 * (size_t)i);
        p[0] = p[3] = 1.0f + (float)i;
        p[4] = i % 2 != 0 ? 1.0f : 0.0f;
        p[5] = i % 2 != 0 ? 0.0f : 1.0f;
        for (uint32_t k = 0; k < 3; ++k)
            m.parts->indices[3 * i + k] = k == 0 ? 0 : 2 * i + k;
    }
    assert_true(model_complete_normals(&m, 40.0, &memory));
    assert_int_equal(m.parts->vertex_count, 3 * TRIANGLES);
    model_free(&m);
}

/* Random triangles. */
#define RANDOM_PARTS 2
#define RANDOM_VERTICES 24
#define RANDOM_TRIANGLES 20
#define RANDOM_CORNERS (3 * RANDOM_PARTS * RANDOM_TRIANGLES)

/* A corner as it was before normals were computed. */
typedef struct test_corner {
    float place[3], normal[3]; /* normal: of its triangle; 0 without area */
    double angle;
    float own[3]; /* the vertex's own normal */
    float texcoord[2];
    uint32_t smoothing;
    bool divides;
    int group;
} test_corner;

static test_corner random_corners[RANDOM_CORNERS];

/* Vertices on the corners of few cells, so that many are at one place. */
static void make_random(model *m, uint64_t *seed)
{
    memset(m, 0, sizeof *m);
    m->parts = calloc(RANDOM_PARTS, sizeof *m->parts);
    assert_non_null(m->parts);
    for (m->part_count = 0; m->part_count < RANDOM_PARTS;) {
        model_part *const part = m->parts + m->part_count++;
        part->has_texcoords = true;
        assert_true(model_part_allocate(part, RANDOM_VERTICES, 3 * RANDOM_TRIANGLES));
        part->smoothing = calloc(RANDOM_VERTICES, sizeof *part->smoothing);
        assert_non_null(part->smoothing);
        for (size_t v = 0; v < RANDOM_VERTICES; ++v) {
            for (size_t c = 0; c < 3; ++c)
                part->positions[3 * v + c] = (float)(random_bits(seed) % (c < 2 ? 3 : 2));
            part->normals[3 * v] = random_bits(seed) % 8 == 0 ? 1.0f : 0.0f;
            part->smoothing[v] = random_bits(seed) % 8 == 0;
            part->texcoords[2 * v] = (float)v;
            part->texcoords[2 * v + 1] = (float)m->part_count;
        }
        for (size_t i = 0; i < part->index_count; ++i)
            part->indices[i] = random_bits(seed) % RANDOM_VERTICES;
    }
}

static void note_corners(const model *m)
{
    test_corner *to = random_corners;
    for (size_t p = 0; p < m->part_count; ++p) {
        const model_part *const part = m->parts + p;
        for (size_t i = 0; i < part->index_count; ++i, ++to) {
            const size_t v = part->indices[i];
            memcpy(to->place, part->positions + 3 * v, sizeof to->place);
            memcpy(to->texcoord, part->texcoords + 2 * v, sizeof to->texcoord);
            to->smoothing = part->smoothing[v];
            memcpy(to->own, part->normals + 3 * v, sizeof to->own);
            to->divides = to->own[0] == 0.0f && to->smoothing == 0;
        }
    }
    for (int t = 0; t < RANDOM_CORNERS; ++t) {
        test_corner *const c = random_corners + t;
        const float *const next = random_corners[t - t % 3 + (t + 1) % 3].place;
        const float *const last = random_corners[t - t % 3 + (t + 2) % 3].place;
        float a[3], b[3];
        for (int i = 0; i < 3; ++i) {
            a[i] = next[i] - c->place[i];
            b[i] = last[i] - c->place[i];
        }
        const float n[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                            a[0] * b[1] - a[1] * b[0]};
        const float length = sqrtf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        c->angle = length > 0.0f
                       ? atan2((double)length, (double)(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]))
                       : 0.0;
        c->group = t;
        c->divides = c->divides && length > 0.0f;
        for (int i = 0; i < 3; ++i)
            c->normal[i] = length > 0.0f ? n[i] / length : 0.0f;
    }
}

static bool is_at(const test_corner *a, const test_corner *b)
{
    return memcmp(a->place, b->place, sizeof a->place) == 0 && a->smoothing == b->smoothing;
}

/* Whether a triangle has an edge from a corner to the place of another corner. */
static bool has_edge_to(int corner, const test_corner *other)
{
    const int first = corner - corner % 3;
    return is_at(random_corners + first + (corner + 1) % 3, other) ||
           is_at(random_corners + first + (corner + 2) % 3, other);
}

/* The definition: at each edge, a corner is joined to the one before it at the same place. */
static void join_random(double cosine)
{
    for (int a = 0; a < RANDOM_CORNERS; ++a)
        for (int k = 1; k < 3 && random_corners[a].divides; ++k) {
            const test_corner *const own = random_corners + a;
            const test_corner *const end = random_corners + a - a % 3 + (a + k) % 3;
            int b = a - 1;
            while (b >= 0 && !(random_corners[b].divides && is_at(own, random_corners + b) &&
                               has_edge_to(b, end)))
                --b;
            const float *const m = own->normal, *const n = random_corners[b < 0 ? a : b].normal;
            const float dot = m[0] * n[0] + m[1] * n[1] + m[2] * n[2];
            const int from = own->group, to = random_corners[b < 0 ? a : b].group;
            for (int i = 0; i < RANDOM_CORNERS && (double)dot >= cosine; ++i)
                if (random_corners[i].group == from)
                    random_corners[i].group = to;
        }
}

/* The sum of the normals at a corner's place, of the triangles of its group or of all. Returns its
 * length. */
static double sum_at(const test_corner *own, bool of_group, double sum[3])
{
    memset(sum, 0, 3 * sizeof *sum);
    for (const test_corner *c = random_corners; c < random_corners + RANDOM_CORNERS; ++c)
        for (int i = 0; i < 3; ++i)
            if (is_at(own, c) && (!of_group || (c->divides && c->group == own->group)))
                sum[i] += c->angle * (double)c->normal[i];
    return sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
}

/* Whether a triangle that may be divided faces away from the mean by more than half of the angle,
 * and there are several groups. */
static bool is_divided(const test_corner *own, double degrees)
{
    const double cosine = cos(0.5 * degrees * (3.14159265358979323846 / 180.0));
    double sum[3];
    const double length = sum_at(own, false, sum);
    bool far = false, several = false;
    for (const test_corner *c = random_corners; c < random_corners + RANDOM_CORNERS; ++c) {
        if (!c->divides || !is_at(own, c))
            continue;
        double dot = 0.0;
        for (int i = 0; i < 3; ++i)
            dot += sum[i] * (double)c->normal[i];
        far = far || !(dot >= cosine * length) || length == 0.0;
        several = several || c->group != own->group;
    }
    return far && several;
}

/* Every corner keeps what its vertex had, and has the normal of its group, or of its place if that
 * is not divided. */
static void expect_corner(const test_corner *c, const model_part *part, size_t v, double degrees)
{
    double sum[3];
    assert_true(v < part->vertex_count);
    assert_memory_equal(part->positions + 3 * v, c->place, 12);
    assert_memory_equal(part->texcoords + 2 * v, c->texcoord, 8);
    assert_int_equal(part->smoothing[v], c->smoothing);
    if (c->own[0] != 0.0f) {
        assert_memory_equal(part->normals + 3 * v, c->own, 12);
        return;
    }
    const double length = sum_at(c, c->divides && is_divided(c, degrees), sum);
    for (int i = 0; i < 3 && c->divides && length > 1e-3; ++i)
        assert_true(fabs((double)part->normals[3 * v + i] - sum[i] / length) < 1e-5);
}

/* The vertices that are needed: one for each of the file, and one for each further group of its
 * corners. */
static size_t count_needed(double degrees)
{
    size_t needed = RANDOM_PARTS * RANDOM_VERTICES;
    for (int a = 0; a < RANDOM_CORNERS; ++a) {
        const test_corner *const c = random_corners + a;
        bool is_first = true, is_first_of_group = true;
        for (const test_corner *b = random_corners; b < c; ++b) {
            const bool is_own = b->divides && memcmp(b->texcoord, c->texcoord, 8) == 0;
            is_first = is_first && !is_own;
            is_first_of_group = is_first_of_group && !(is_own && b->group == c->group);
        }
        needed += c->divides && is_divided(c, degrees) && is_first_of_group && !is_first;
    }
    return needed;
}

static void expect_random(const model *m, double degrees)
{
    size_t corner = 0, vertices = 0;
    for (size_t p = 0; p < m->part_count; ++p) {
        const model_part *const part = m->parts + p;
        vertices += part->vertex_count;
        for (size_t i = 0; i < part->index_count; ++i)
            expect_corner(random_corners + corner++, part, part->indices[i], degrees);
    }
    assert_int_equal(vertices, count_needed(degrees));
}

static void test_random(void **state)
{
    uint64_t seed = 1;
    for (int i = 0; i < 300; ++i) {
        static const double angles[] = {0.5, 31.0, 50.0, 100.0, 179.5};
        const double degrees = angles[i % 5];
        uint64_t memory = UINT64_MAX;
        model m;
        make_random(&m, &seed);
        note_corners(&m);
        join_random(cos(degrees * (3.14159265358979323846 / 180.0)));
        assert_true(model_complete_normals(&m, degrees, &memory));
        expect_random(&m, degrees);
        model_free(&m);
    }
}

static void test_memory(void **state)
{
    require_within_budget(MODEL_OBJ, "x.obj", CUBE, NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_cube),      cmocka_unit_test(test_angles),
        cmocka_unit_test(test_files_own), cmocka_unit_test(test_seams),
        cmocka_unit_test(test_lines),     cmocka_unit_test(test_hub),
        cmocka_unit_test(test_random),    cmocka_unit_test(test_memory),
    };
    return cmocka_run_group_tests(tests, NULL, forget_last_model);
}
