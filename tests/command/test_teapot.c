/* The teapot's shape, against facts known without our own pictures. */
#include "suite.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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

static const float *position(size_t vertex)
{
    return teapot.parts->positions + 3 * vertex;
}

static const float *normal(size_t vertex)
{
    return teapot.parts->normals + 3 * vertex;
}

static bool is_revolved(size_t vertex)
{
    size_t patch = vertex / PATCH_VERTICES;
    return patch < HANDLE || patch >= LID;
}

/* Whether some vertex has this position and normal. */
static bool is_there(const float p[3], const float n[3])
{
    for (size_t v = 0; v < PATCHES * PATCH_VERTICES; ++v) {
        float worst = 0.0f;
        for (size_t c = 0; c < 3; ++c) {
            worst = fmaxf(worst, fabsf(position(v)[c] - p[c]));
            worst = fmaxf(worst, fabsf(normal(v)[c] - n[c]));
        }
        if (worst < 1e-5f)
            return true;
    }
    return false;
}

TEST(it_is_as_large_as_published)
{
    float low[3] = {9.0f, 9.0f, 9.0f};
    float high[3] = {-9.0f, -9.0f, -9.0f};
    assert_int_equal(teapot.part_count, 1);
    assert_int_equal(teapot.parts->vertex_count, PATCHES * PATCH_VERTICES);
    /* Two triangles per cell, one where the cell touches a pole: in 8 patches. */
    assert_int_equal(model_triangle_count(&teapot), PATCHES * LEVEL * LEVEL * 2 - 8 * LEVEL);
    for (size_t v = 0; v < teapot.parts->vertex_count; ++v) {
        for (size_t c = 0; c < 3; ++c) {
            low[c] = fminf(low[c], position(v)[c]);
            high[c] = fmaxf(high[c], position(v)[c]);
        }
        assert_memory_equal(teapot.parts->colors + 4 * v, color, sizeof color);
    }
    /* The top of the lid; the table; the body's half width of 2 at its widest; the handle at -3;
     * the spout at 3.5. */
    assert_true(low[1] == 0.0f && high[1] == 3.15f);
    assert_true(fabsf(high[2] - 2.0f) < 0.01f && fabsf(low[2] + 2.0f) < 0.01f);
    assert_true(low[0] < -2.9f && low[0] >= -3.0f);
    assert_true(high[0] > 3.4f && high[0] < 3.525f);
}

TEST(it_is_symmetric)
{
    for (size_t v = 0; v < teapot.parts->vertex_count; ++v) {
        const float *p = position(v);
        const float *n = normal(v);
        float mirrored_p[3] = {p[0], p[1], -p[2]};
        float mirrored_n[3] = {n[0], n[1], -n[2]};
        assert_true(is_there(mirrored_p, mirrored_n));
        if (!is_revolved(v))
            continue;
        float turned_p[3] = {p[2], p[1], -p[0]};
        float turned_n[3] = {n[2], n[1], -n[0]};
        assert_true(is_there(turned_p, turned_n));
    }
}

/* Newell's quarter arcs are close to circles, so normals of the parts that are surfaces of
 * revolution lie nearly in the plane through the axis. */
TEST(normals_are_unit_and_radial)
{
    for (size_t v = 0; v < teapot.parts->vertex_count; ++v) {
        const float *p = position(v);
        const float *n = normal(v);
        assert_true(fabsf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] - 1.0f) < 1e-5f);
        float radius = hypotf(p[0], p[2]);
        if (!is_revolved(v))
            continue;
        if (radius > 1e-3f)
            assert_true(fabsf(n[0] * p[2] - n[2] * p[0]) / radius < 0.05f);
        else
            assert_true(fabsf(n[1]) > 0.9999f);
    }
}

TEST(poles_point_up_and_down)
{
    int top = 0;
    int bottom = 0;
    for (size_t v = 0; v < teapot.parts->vertex_count; ++v) {
        const float *p = position(v);
        if (p[0] != 0.0f || p[2] != 0.0f)
            continue;
        if (p[1] == 3.15f) {
            ++top;
            assert_true(normal(v)[1] > 0.9999f);
        }
        if (p[1] == 0.0f) {
            ++bottom;
            assert_true(normal(v)[1] < -0.9999f);
        }
    }
    assert_int_equal(top, 4 * (LEVEL + 1));
    assert_int_equal(bottom, 4 * (LEVEL + 1));
}

/* No triangle is degenerate, and each triangle's own normal is on the side of its vertices'
 * normals. */
TEST(triangles_face_outwards)
{
    for (size_t i = 0; i < teapot.parts->index_count; i += 3) {
        const uint32_t *t = teapot.parts->indices + i;
        float a[3];
        float b[3];
        float cross[3];
        float length = 0.0f;
        for (int c = 0; c < 3; ++c) {
            a[c] = position(t[1])[c] - position(t[0])[c];
            b[c] = position(t[2])[c] - position(t[0])[c];
        }
        for (int c = 0; c < 3; ++c) {
            cross[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
            length += cross[c] * cross[c];
        }
        length = sqrtf(length);
        assert_true(length > 1e-6f);
        for (int k = 0; k < 3; ++k) {
            float cosine = 0.0f;
            for (int c = 0; c < 3; ++c)
                cosine += cross[c] / length * normal(t[k])[c];
            assert_true(cosine > 0.1f);
        }
    }
    /* The bottom faces down, which shows that the whole teapot faces outward. */
    for (size_t v = BOTTOM * PATCH_VERTICES; v < PATCHES * PATCH_VERTICES; ++v)
        assert_true(normal(v)[1] < 0.1f);
}

static float dot(const float a[3], const float b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const float a[3], const float b[3], float result[3])
{
    for (int c = 0; c < 3; ++c)
        result[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
}

/* Over each triangle tangents point where positions go as s grows, and bitangents where they go as
 * t grows. */
TEST(tangents_follow_the_texture)
{
    for (size_t i = 0; i < teapot.parts->index_count; i += 3) {
        const uint32_t *t = teapot.parts->indices + i;
        const float *texcoord[3];
        float along[2][3] = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}};
        for (int k = 0; k < 3; ++k)
            texcoord[k] = teapot.parts->texcoords + 2 * (size_t)t[k];
        float s1 = texcoord[1][0] - texcoord[0][0];
        float t1 = texcoord[1][1] - texcoord[0][1];
        float s2 = texcoord[2][0] - texcoord[0][0];
        float t2 = texcoord[2][1] - texcoord[0][1];
        float area = s1 * t2 - s2 * t1;
        assert_true(fabsf(area) > 1e-7f);
        for (int c = 0; c < 3; ++c) {
            float p1 = position(t[1])[c] - position(t[0])[c];
            float p2 = position(t[2])[c] - position(t[0])[c];
            along[0][c] = (p1 * t2 - p2 * t1) / area;
            along[1][c] = (p2 * s1 - p1 * s2) / area;
        }
        for (int k = 0; k < 3; ++k) {
            const float *tangent = teapot.parts->tangents + 4 * (size_t)t[k];
            float bitangent[3];
            cross(normal(t[k]), tangent, bitangent);
            assert_true(fabsf(dot(tangent, tangent) - 1.0f) < 1e-5f);
            assert_true(fabsf(dot(tangent, normal(t[k]))) < 1e-5f);
            assert_true(dot(tangent, along[0]) > 0.0f);
            assert_true(dot(bitangent, along[1]) * tangent[3] > 0.0f);
        }
    }
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

static void unpack(uint32_t texel, float result[3])
{
    for (int c = 0; c < 3; ++c)
        result[c] = (float)(texel >> (8 * c) & 255) / 127.5f - 1.0f;
}

/* Both normal maps describe equal normals, none of which points into the teapot. */
TEST(maps_of_normals_agree)
{
    enum { CELL = 32 };
    image of_tangents;
    image of_model;
    int tilted = 0;
    assert_true(teapot_map_create(MAP_NORMAL, true, CELL, &of_tangents));
    assert_true(teapot_map_create(MAP_NORMAL, false, CELL, &of_model));
    assert_int_equal(of_model.width, CELL * TEAPOT_COLUMNS);
    assert_int_equal(of_model.height, CELL * TEAPOT_ROWS);
    for (uint32_t y = 0; y < of_model.height; ++y) {
        for (uint32_t x = 0; x < of_model.width; ++x) {
            double p[3];
            double n[3];
            double t[3];
            double u = ((x % CELL + 0.5) / CELL - TEAPOT_MARGIN) / (1.0 - 2.0 * TEAPOT_MARGIN);
            double v = ((y % CELL + 0.5) / CELL - TEAPOT_MARGIN) / (1.0 - 2.0 * TEAPOT_MARGIN);
            if (u < 0.0 || u > 1.0 || v < 0.0 || v > 1.0)
                continue;
            teapot_point((int)(y / CELL * TEAPOT_COLUMNS + x / CELL), u, v, p, n, t);
            float packed[3];
            float stated[3];
            float turned[3];
            float frame[3][3];
            unpack(of_tangents.texels[y * of_model.width + x], packed);
            unpack(of_model.texels[y * of_model.width + x], stated);
            for (int c = 0; c < 3; ++c) {
                frame[0][c] = (float)t[c];
                frame[2][c] = (float)n[c];
            }
            cross(frame[0], frame[2], frame[1]);
            for (int c = 0; c < 3; ++c)
                turned[c] =
                    packed[0] * frame[0][c] + packed[1] * frame[1][c] + packed[2] * frame[2][c];
            for (int c = 0; c < 3; ++c)
                assert_true(fabsf(turned[c] - stated[c]) < 0.012f);
            assert_true(packed[2] > 0.8f);
            tilted += packed[2] < 0.99f;
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
    for (int i = 0; i < MAP_COUNT; ++i)
        assert_true(teapot_map_create((map_kind)i, true, 16, maps + i));
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
            ends[0][c] = position(from)[c] + 0.0f; /* +0 replaces -0 */
            ends[1][c] = position(to)[c] + 0.0f;
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
