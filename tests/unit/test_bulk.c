/* Many vectors and matrices: every function against the one for a single product, at all lengths
 * around a block and all alignments, on every back end, in place and not. Nothing else is written.
 * Every status. */
#include <stdio.h>
#include <string.h>

#include "unit.h"

#define LENGTHS 68
#define ALIGNMENTS 8
#define MARGIN 16
#define ROOM (4 * LENGTHS + ALIGNMENTS + 2 * MARGIN)

static const gn_mat4 m4 = {{{0.3f, -1.7f, 2.9f, 0.11f},
                            {1.3f, 0.7f, -0.2f, 5.1f},
                            {-3.1f, 1e-3f, 0.9f, 7.7f},
                            {10.1f, -20.3f, 30.7f, 1.9f}}};
static const gn_mat3 m3 = {{{0.7f, -0.1f, 2.3f}, {1e-2f, 3.3f, -1.9f}, {0.6f, 0.4f, 0.2f}}};

enum function { VEC4, POINT, DIRECTION, VEC3, FUNCTIONS };

static int components_of(enum function function)
{
    return function == VEC4 ? 4 : 3;
}

/* Returns the result of the function for one vector. */
static void one(enum function function, const float v[4], float result[4])
{
    const gn_vec3 v3 = {v[0], v[1], v[2]};
    const gn_vec4 v4 = {v[0], v[1], v[2], v[3]};
    const gn_vec4 r4 = gn_mat4_multiply_vec4(&m4, v4);
    const gn_vec3 r3 = function == POINT       ? gn_mat4_transform_point(&m4, v3)
                       : function == DIRECTION ? gn_mat4_transform_direction(&m4, v3)
                                               : gn_mat3_multiply_vec3(&m3, v3);
    const float of_four[4] = {r4.x, r4.y, r4.z, r4.w}, of_three[4] = {r3.x, r3.y, r3.z, 0.0f};

    memcpy(result, function == VEC4 ? of_four : of_three, 4 * sizeof *result);
}

static gn_status packed(enum function function, const void *m, const float *v, float *result,
                        size_t count, gn_backend backend)
{
    const gn_vec3 *const v3 = (const gn_vec3 *)v;
    gn_vec3 *const r3 = (gn_vec3 *)result;

    return function == VEC4 ? gn_mat4_multiply_vec4_packed(m, (const gn_vec4 *)v, (gn_vec4 *)result,
                                                           count, backend)
           : function == POINT     ? gn_mat4_transform_point_packed(m, v3, r3, count, backend)
           : function == DIRECTION ? gn_mat4_transform_direction_packed(m, v3, r3, count, backend)
                                   : gn_mat3_multiply_vec3_packed(m, v3, r3, count, backend);
}

static gn_status arrays(enum function function, const void *m, const float *const *v,
                        float *const *result, size_t count, gn_backend backend)
{
    return function == VEC4    ? gn_mat4_multiply_vec4_arrays(m, v, result, count, backend)
           : function == POINT ? gn_mat4_transform_point_arrays(m, v, result, count, backend)
           : function == DIRECTION
               ? gn_mat4_transform_direction_arrays(m, v, result, count, backend)
               : gn_mat3_multiply_vec3_arrays(m, v, result, count, backend);
}

static const void *matrix_of(enum function function)
{
    return function == VEC3 ? (const void *)&m3 : (const void *)&m4;
}

static void fill(float *memory, size_t count, float first)
{
    for (size_t i = 0; i < count; ++i)
        memory[i] = first + (float)(i * 37 % 101) * 0.13f;
}

/* The place in floats of component i of vector k of `count`. The arrays of a structure are one
 * after the other. */
static size_t place(bool is_packed, int components, size_t count, size_t k, int i)
{
    return is_packed ? k * (size_t)components + (size_t)i : (size_t)i * count + k;
}

static void compare(enum function function, bool is_packed, size_t count, size_t alignment,
                    bool in_place, gn_backend backend)
{
    const int components = components_of(function);
    const size_t floats = count * (size_t)components;
    float source[ROOM], operand[ROOM], target[ROOM], expected[ROOM];
    gn_status status;

    fill(source, ROOM, -7.0f);
    fill(target, ROOM, 100.0f);
    memcpy(operand, source, sizeof operand);
    float *v = operand + MARGIN + alignment;
    float *result = in_place ? v : target + MARGIN + (alignment * 3) % ALIGNMENTS;
    float *const whole = in_place ? operand : target;
    memcpy(expected, whole, sizeof expected);
    for (size_t k = 0; k < count; ++k) {
        float from[4] = {0}, to[4];

        for (int i = 0; i < components; ++i)
            from[i] = v[place(is_packed, components, count, k, i)];
        one(function, from, to);
        for (int i = 0; i < components; ++i)
            expected[(size_t)(result - whole) + place(is_packed, components, count, k, i)] = to[i];
    }

    if (is_packed) {
        status = packed(function, matrix_of(function), v, result, count, backend);
    } else {
        const float *from[4] = {v, v + count, v + 2 * count, v + 3 * count};
        float *to[4] = {result, result + count, result + 2 * count, result + 3 * count};

        status = arrays(function, matrix_of(function), from, to, count, backend);
    }
    assert_int_equal(status, GN_OK);
    assert_true(floats + 2 * MARGIN <= ROOM);
    if (memcmp(whole, expected, sizeof expected) != 0)
        fail_msg("function %d, %s, %zu vectors, alignment %zu%s, back end %s", (int)function,
                 is_packed ? "packed" : "arrays", count, alignment, in_place ? ", in place" : "",
                 gn_backend_name(backend));
    if (!in_place)
        assert_memory_equal(operand, source, sizeof operand);
}

static void bits_of_the_single_functions(void **state)
{
    for (gn_backend b = GN_BACKEND_AUTO; b < GN_BACKEND_COUNT; b = next_backend(b)) {
        for (int which = 0; which < 4 * FUNCTIONS; ++which)
            for (size_t count = 0; count < LENGTHS; ++count)
                for (size_t alignment = 0; alignment < ALIGNMENTS; ++alignment)
                    compare((enum function)(which / 4), which & 1, count, alignment, which & 2, b);
    }
}

enum { MATRICES = 9 };

/* At every alignment, into a third array, over the left operands and over the right operands. */
static void many_matrices(void **state)
{
    for (gn_backend b = GN_BACKEND_AUTO; b < GN_BACKEND_COUNT; b = next_backend(b)) {
        for (int which = 0; which < 3 * ALIGNMENTS * (MATRICES + 1); ++which) {
            const int target = which % 3, alignment = which / 3 % ALIGNMENTS;
            const size_t count = (size_t)(which / 3 / ALIGNMENTS);
            float memory[3][16 * MATRICES + ALIGNMENTS], expected[3][16 * MATRICES + ALIGNMENTS];
            gn_mat4 *matrices[3], product;

            fill(memory[0], 3 * (16 * MATRICES + ALIGNMENTS), 1.0f);
            memcpy(expected, memory, sizeof expected);
            for (int i = 0; i < 3; ++i)
                matrices[i] = (gn_mat4 *)(memory[i] + alignment);
            for (size_t i = 0; i < count; ++i) {
                gn_mat4_multiply(&matrices[0][i], &matrices[1][i], &product);
                memcpy(expected[target] + alignment + 16 * i, &product, sizeof product);
            }
            assert_int_equal(
                gn_mat4_multiply_packed(matrices[0], matrices[1], matrices[target], count, b),
                GN_OK);
            assert_memory_equal(memory, expected, sizeof memory);
        }
    }
}

/* The result arrays are the operand's arrays in another order; the matrix is in the memory of the
 * results. */
static void results_over_operands(void **state)
{
    for (gn_backend b = GN_BACKEND_AUTO; b < GN_BACKEND_COUNT; b = next_backend(b)) {
        float memory[4][LENGTHS], before[4][LENGTHS], vectors[LENGTHS][4], results[LENGTHS][4];
        const float *v[4] = {memory[0], memory[1], memory[2], memory[3]};
        float *result[4] = {memory[2], memory[0], memory[3], memory[1]};

        fill(memory[0], 4 * LENGTHS, 1.0f);
        memcpy(before, memory, sizeof before);
        assert_int_equal(gn_mat4_multiply_vec4_arrays(&m4, v, result, LENGTHS, b), GN_OK);
        fill(vectors[0], 4 * LENGTHS, 1.0f);
        memcpy(results, &m4, sizeof m4);
        assert_int_equal(packed(VEC4, results, vectors[0], results[0], LENGTHS, b), GN_OK);
        for (int k = 0; k < LENGTHS; ++k) {
            const float from[4] = {before[0][k], before[1][k], before[2][k], before[3][k]};
            float to[4];

            one(VEC4, from, to);
            for (int i = 0; i < 4; ++i)
                assert_true(result[i][k] == to[i]);
            one(VEC4, vectors[k], to);
            assert_memory_equal(results[k], to, sizeof to);
        }
    }
}

/* Long enough for the automatic choice to ask the processor. */
static void long_arrays(void **state)
{
    static gn_vec3 v[GN_BULK_ASK + 5], result[GN_BULK_ASK + 5];

    fill(&v[0].x, 3 * (GN_BULK_ASK + 5), -3.0f);
    assert_int_equal(
        gn_mat4_transform_point_packed(&m4, v, result, GN_BULK_ASK + 5, GN_BACKEND_AUTO), GN_OK);
    for (size_t i = 0; i < GN_BULK_ASK + 5; ++i) {
        const gn_vec3 expected = gn_mat4_transform_point(&m4, v[i]);

        assert_memory_equal(&result[i], &expected, sizeof expected);
    }
}

static void faults(void **state)
{
    const gn_backend none = GN_BACKEND_COUNT, any = GN_BACKEND_AUTO;
    float x[12], untouched[12];
    gn_mat4 a = m4, b = m4;

    fill(x, 12, 1.0f);
    fill(untouched, 12, 1.0f);
    for (enum function f = VEC4; f < FUNCTIONS; ++f) {
        const void *const m = matrix_of(f);
        const float *v[4] = {x, x, x, x};
        float *result[4] = {x, x, x, x};

        assert_int_equal(packed(f, NULL, x, x, 1, any), GN_NULL_POINTER);
        assert_int_equal(packed(f, m, NULL, x, 1, any), GN_NULL_POINTER);
        assert_int_equal(packed(f, m, x, NULL, 1, any), GN_NULL_POINTER);
        assert_int_equal(packed(f, m, x, x, 1, none), GN_BACKEND_UNAVAILABLE);
        assert_int_equal(packed(f, m, NULL, NULL, 0, any), GN_OK);
        assert_int_equal(packed(f, m, NULL, NULL, 0, none), GN_BACKEND_UNAVAILABLE);
        assert_int_equal(arrays(f, NULL, v, result, 3, any), GN_NULL_POINTER);
        assert_int_equal(arrays(f, m, NULL, result, 3, any), GN_NULL_POINTER);
        assert_int_equal(arrays(f, m, v, NULL, 3, any), GN_NULL_POINTER);
        assert_int_equal(arrays(f, m, v, result, 3, none), GN_BACKEND_UNAVAILABLE);
        assert_int_equal(arrays(f, m, NULL, NULL, 0, any), GN_OK);
        for (int i = 0; i < components_of(f); ++i) {
            v[i] = NULL;
            assert_int_equal(arrays(f, m, v, result, 3, any), GN_NULL_POINTER);
            v[i] = x;
            result[i] = NULL;
            assert_int_equal(arrays(f, m, v, result, 3, any), GN_NULL_POINTER);
            result[i] = x;
        }
    }
    assert_int_equal(gn_mat4_multiply_packed(NULL, &b, &a, 1, any), GN_NULL_POINTER);
    assert_int_equal(gn_mat4_multiply_packed(&a, NULL, &a, 1, any), GN_NULL_POINTER);
    assert_int_equal(gn_mat4_multiply_packed(&a, &b, NULL, 1, any), GN_NULL_POINTER);
    assert_int_equal(gn_mat4_multiply_packed(&a, &b, &a, 1, none), GN_BACKEND_UNAVAILABLE);
    assert_int_equal(gn_mat4_multiply_packed(NULL, NULL, NULL, 0, any), GN_OK);
    assert_memory_equal(&a, &m4, sizeof a);
    assert_memory_equal(x, untouched, sizeof x);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bits_of_the_single_functions),
        cmocka_unit_test(many_matrices),
        cmocka_unit_test(results_over_operands),
        cmocka_unit_test(long_arrays),
        cmocka_unit_test(faults),
    };
    return cmocka_run_group_tests_name("bulk", tests, NULL, NULL);
}
