/* The teapot's shape, against facts known without our own pictures. */
#include "suite.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gnomon.h>

#include "bounds.h"
#include "teapot.h"
#include "teapot_maps.h"

#define LEVEL 6u
#define PATCH_VERTICES ((LEVEL + 1) * (LEVEL + 1))
#define PATCHES 32u

/* In the order of the patches: 12 of rim and body, 4 of the handle, 4 of the spout, 12 of lid and
 * bottom. */
#define HANDLE 12u
#define LID 20u
#define BOTTOM 28u

static const float color[4] = {0.1f, 0.2f, 0.3f, 0.4f};
static model teapot;

void suite_begin(int argc, char **argv)
{
    (void)argc;
    (void)argv;
    if (!teapot_create(LEVEL, color, &teapot))
        exit(1);
}

void suite_end(void)
{
    model_free(&teapot);
}

static gn_vec3 vec(const float v[3])
{
    return (gn_vec3){v[0], v[1], v[2]};
}

static gn_vec3 position(size_t vertex)
{
    return vec(teapot.parts->positions + 3 * vertex);
}

static gn_vec3 normal(size_t vertex)
{
    return vec(teapot.parts->normals + 3 * vertex);
}

static bool is_revolved(size_t vertex)
{
    size_t patch = vertex / PATCH_VERTICES;
    return patch < HANDLE || patch >= LID;
}

/* Whether some vertex has this position and normal. */
static bool is_there(gn_vec3 p, gn_vec3 n)
{
    for (size_t v = 0; v < PATCHES * PATCH_VERTICES; ++v)
        if (gn_vec3_distance(position(v), p) < 1e-5f && gn_vec3_distance(normal(v), n) < 1e-5f)
            return true;
    return false;
}

TEST(it_is_as_large_as_published)
{
    double low[3], high[3];
    assert_int_equal(teapot.part_count, 1);
    assert_int_equal(teapot.parts->vertex_count, PATCHES * PATCH_VERTICES);
    /* Two triangles per cell, one where the cell touches a pole: in 8 patches. */
    assert_int_equal(model_triangle_count(&teapot), PATCHES * LEVEL * LEVEL * 2 - 8 * LEVEL);
    for (size_t v = 0; v < teapot.parts->vertex_count; ++v)
        assert_memory_equal(teapot.parts->colors + 4 * v, color, sizeof color);
    /* The top of the lid; the table; the body's half width of 2 at its widest; the handle at -3;
     * the spout at 3.5. */
    model_box(&teapot, low, high);
    assert_true(low[1] == 0.0 && (float)high[1] == 3.15f);
    assert_true(fabs(high[2] - 2.0) < 0.01 && fabs(low[2] + 2.0) < 0.01);
    assert_true(low[0] < -2.9 && low[0] >= -3.0 && high[0] > 3.4 && high[0] < 3.525);
}

TEST(it_is_symmetric)
{
    for (size_t v = 0; v < teapot.parts->vertex_count; ++v) {
        const gn_vec3 p = position(v), n = normal(v);
        assert_true(is_there((gn_vec3){p.x, p.y, -p.z}, (gn_vec3){n.x, n.y, -n.z}));
        assert_true(!is_revolved(v) ||
                    is_there((gn_vec3){p.z, p.y, -p.x}, (gn_vec3){n.z, n.y, -n.x}));
    }
}

/* Newell's quarter arcs are close to circles, so normals of the parts that are surfaces of
 * revolution lie nearly in the plane through the axis. At the poles they point up and down. */
TEST(normals_are_unit_and_radial)
{
    unsigned int top = 0, bottom = 0;
    for (size_t v = 0; v < teapot.parts->vertex_count; ++v) {
        const gn_vec3 p = position(v), n = normal(v);
        const float radius = hypotf(p.x, p.z);
        assert_true(fabsf(gn_vec3_dot(n, n) - 1.0f) < 1e-5f);
        if (is_revolved(v) && radius > 1e-3f)
            assert_true(fabsf(n.x * p.z - n.z * p.x) / radius < 0.05f);
        else if (is_revolved(v))
            assert_true(fabsf(n.y) > 0.9999f);
        if (radius == 0.0f && p.y == 3.15f && n.y > 0.0f)
            ++top;
        if (radius == 0.0f && p.y == 0.0f && n.y < 0.0f)
            ++bottom;
    }
    assert_true(top == 4 * (LEVEL + 1) && bottom == 4 * (LEVEL + 1));
}

/* No triangle is degenerate, and each triangle's own normal is on the side of its vertices'
 * normals. Over each triangle tangents point where positions go as s grows, and bitangents where
 * they go as t grows. */
TEST(triangles_face_outwards_and_follow_the_texture)
{
    for (size_t i = 0; i < teapot.parts->index_count; i += 3) {
        const uint32_t *t = teapot.parts->indices + i;
        const gn_vec3 a = gn_vec3_subtract(position(t[1]), position(t[0])),
                      b = gn_vec3_subtract(position(t[2]), position(t[0]));
        const gn_vec3 across = gn_vec3_cross(a, b);
        const float *texcoord[3];
        for (int k = 0; k < 3; ++k)
            texcoord[k] = teapot.parts->texcoords + 2 * (size_t)t[k];
        const float s1 = texcoord[1][0] - texcoord[0][0], t1 = texcoord[1][1] - texcoord[0][1];
        const float s2 = texcoord[2][0] - texcoord[0][0], t2 = texcoord[2][1] - texcoord[0][1];
        const float area = s1 * t2 - s2 * t1, length = gn_vec3_length(across);
        assert_true(length > 1e-6f && fabsf(area) > 1e-7f);
        const gn_vec3 along_s =
            gn_vec3_subtract(gn_vec3_scale(a, t2 / area), gn_vec3_scale(b, t1 / area));
        const gn_vec3 along_t =
            gn_vec3_subtract(gn_vec3_scale(b, s1 / area), gn_vec3_scale(a, s2 / area));
        for (int k = 0; k < 3; ++k) {
            const float *stored = teapot.parts->tangents + 4 * (size_t)t[k];
            const gn_vec3 n = normal(t[k]), tangent = vec(stored);
            assert_true(gn_vec3_dot(across, n) > 0.1f * length);
            assert_true(fabsf(gn_vec3_dot(tangent, tangent) - 1.0f) < 1e-5f);
            assert_true(fabsf(gn_vec3_dot(tangent, n)) < 1e-5f);
            assert_true(gn_vec3_dot(tangent, along_s) > 0.0f);
            assert_true(gn_vec3_dot(gn_vec3_cross(n, tangent), along_t) * stored[3] > 0.0f);
        }
    }
    /* The bottom faces down, which shows that the whole teapot faces outward. */
    for (size_t v = BOTTOM * PATCH_VERTICES; v < PATCHES * PATCH_VERTICES; ++v)
        assert_true(normal(v).y < 0.1f);
}

/* The cells of different patches do not touch. */
TEST(texture_coordinates_stay_in_their_cell)
{
    for (size_t v = 0; v < teapot.parts->vertex_count; ++v) {
        const float *texcoord = teapot.parts->texcoords + 2 * v;
        size_t patch = v / PATCH_VERTICES;
        float s = texcoord[0] * TEAPOT_COLUMNS - (float)(patch % TEAPOT_COLUMNS);
        float t = texcoord[1] * TEAPOT_ROWS - (float)(patch / TEAPOT_COLUMNS);
        assert_true(s > 0.06f && s < 0.94f && t > 0.06f && t < 0.94f);
    }
}

static gn_vec3 unpacked(uint32_t texel)
{
    return (gn_vec3){(float)(texel & 255) / 127.5f - 1.0f,
                     (float)(texel >> 8 & 255) / 127.5f - 1.0f,
                     (float)(texel >> 16 & 255) / 127.5f - 1.0f};
}

/* Both normal maps describe equal normals, none of which points into the teapot. */
TEST(maps_of_normals_agree)
{
    enum { CELL = 32 };
    image of_tangents_maps[MAP_COUNT] = {{0}}, of_model_maps[MAP_COUNT] = {{0}};
    int tilted = 0;
    assert_true(teapot_maps_create(1 << MAP_NORMAL, true, CELL, of_tangents_maps));
    assert_true(teapot_maps_create(1 << MAP_NORMAL, false, CELL, of_model_maps));
    image of_tangents = of_tangents_maps[MAP_NORMAL], of_model = of_model_maps[MAP_NORMAL];
    for (int i = 0; i < MAP_COUNT; ++i)
        assert_true((of_model_maps[i].texels != NULL) == (i == MAP_NORMAL));
    assert_int_equal(of_model.width, CELL * TEAPOT_COLUMNS);
    assert_int_equal(of_model.height, CELL * TEAPOT_ROWS);
    for (uint32_t y = 0; y < of_model.height; ++y) {
        for (uint32_t x = 0; x < of_model.width; ++x) {
            double p[3], n[3], t[3];
            const double u =
                ((x % CELL + 0.5) / CELL - TEAPOT_MARGIN) / (1.0 - 2.0 * TEAPOT_MARGIN);
            const double v =
                ((y % CELL + 0.5) / CELL - TEAPOT_MARGIN) / (1.0 - 2.0 * TEAPOT_MARGIN);
            if (u < 0.0 || u > 1.0 || v < 0.0 || v > 1.0)
                continue;
            teapot_point((int)(y / CELL * TEAPOT_COLUMNS + x / CELL), u, v, p, n, t);
            const gn_vec3 packed = unpacked(of_tangents.texels[y * of_model.width + x]);
            const gn_vec3 stated = unpacked(of_model.texels[y * of_model.width + x]);
            const gn_vec3 tangent = {(float)t[0], (float)t[1], (float)t[2]},
                          up = {(float)n[0], (float)n[1], (float)n[2]};
            const gn_vec3 turned =
                gn_vec3_add(gn_vec3_add(gn_vec3_scale(tangent, packed.x),
                                        gn_vec3_scale(gn_vec3_cross(tangent, up), packed.y)),
                            gn_vec3_scale(up, packed.z));
            assert_true(fabsf(turned.x - stated.x) < 0.012f &&
                        fabsf(turned.y - stated.y) < 0.012f && fabsf(turned.z - stated.z) < 0.012f);
            assert_true(packed.z > 0.8f);
            tilted += packed.z < 0.99f;
        }
    }
    assert_true(tilted > 1000);
    image_free(&of_tangents);
    image_free(&of_model);
}

TEST(dark_chequers_glow_and_light_ones_shine)
{
    image maps[MAP_COUNT];
    int count[2] = {0, 0};
    assert_true(teapot_maps_create((1 << MAP_COUNT) - 1, true, 16, maps));
    for (size_t i = 0; i < (size_t)maps[0].width * maps[0].height; ++i) {
        bool is_light = (maps[MAP_DIFFUSE].texels[i] & 255) > 200;
        bool glows = (maps[MAP_GLOW].texels[i] & 0xffffff) != 0;
        assert_true(((maps[MAP_SPECULAR].texels[i] & 255) == 255) == is_light);
        assert_false(is_light && glows);
        count[0] += is_light;
        count[1] += glows;
    }
    assert_true(count[0] > 3000 && count[0] < 5000); /* of 8192 */
    assert_true(count[1] > 200);
    for (int i = 0; i < MAP_COUNT; ++i)
        image_free(maps + i);
}

static int compare_edges(const void *a, const void *b)
{
    return memcmp(a, b, 6 * sizeof(float));
}

/* Rim, body and bottom are one sheet: every edge except the rim's inner one belongs to two
 * triangles, with equal bits of the positions. */
TEST(seams_are_closed)
{
    size_t count = 0;
    float(*edges)[6] = calloc(teapot.parts->index_count, sizeof *edges);
    assert_non_null(edges);
    for (size_t i = 0; i < teapot.parts->index_count; ++i) {
        uint32_t from = teapot.parts->indices[i];
        uint32_t to = teapot.parts->indices[i / 3 * 3 + (i + 1) % 3];
        size_t patch = from / PATCH_VERTICES;
        if (patch >= HANDLE && patch < BOTTOM)
            continue;
        float ends[2][3];
        for (int c = 0; c < 3; ++c) {
            ends[0][c] = teapot.parts->positions[3 * from + c] + 0.0f; /* +0 replaces -0 */
            ends[1][c] = teapot.parts->positions[3 * to + c] + 0.0f;
        }
        bool swapped = memcmp(ends[0], ends[1], sizeof ends[0]) > 0;
        memcpy(edges[count], ends[swapped], sizeof ends[0]);
        memcpy(edges[count] + 3, ends[!swapped], sizeof ends[0]);
        ++count;
    }
    qsort(edges, count, sizeof *edges, compare_edges);
    size_t open = 0;
    for (size_t first = 0, last; first < count; first = last) {
        for (last = first + 1; last < count; ++last)
            if (compare_edges(edges[first], edges[last]) != 0)
                break;
        assert_true(last - first <= 2);
        open += last - first == 1;
    }
    free(edges);
    assert_int_equal(open, 4 * LEVEL);
}
