/* Inverses and decomposition of any matrices, as bits and as properties: a status that the contract
 * names, or finite numbers within the contract's bound; nothing is written after a fault, and the
 * result may be the operand. */
#include <math.h>
#include <string.h>

#include "property_input.h"

#include "../property/double_matrix.h"

#define MARK 7.0f

static void mark(float *numbers, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        numbers[i] = MARK;
}

static bool is_marked(const float *numbers, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        if (numbers[i] != MARK)
            return false;
    return true;
}

static bool are_finite(const float *numbers, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        if (!isfinite(numbers[i]))
            return false;
    return true;
}

/* Whether products of these numbers are far from the least numbers, where bounds do not hold. */
static bool is_normal(const gn_mat4 *m)
{
    for (int i = 0; i < 16; ++i) {
        const float x = fabsf(m->m[i / 4][i % 4]);

        if (x != 0.0f && (x < 0x1p-30f || x > 0x1p30f))
            return false;
    }
    return true;
}

/* Whether the status is one of a set of 1 << status. */
static bool is_one_of(gn_status status, uint32_t set)
{
    return status >= GN_OK && status < GN_STATUS_COUNT && set >> status & 1;
}

#define STATUS(name) (1u << GN_##name)

/* A kind of inverse, and what it may return. */
typedef struct kind {
    gn_status (*invert)(const gn_mat4 *m, gn_mat4 *result);
    uint32_t statuses;
} kind;

static gn_status invert_any(const gn_mat4 *m, gn_mat4 *result)
{
    return gn_mat4_invert(m, result, NULL);
}

static void try_kind(const kind *k, const gn_mat4 *m)
{
    gn_mat4 result, same = *m;

    mark(&result.m[0][0], 16);
    const gn_status status = k->invert(m, &result);

    FUZZ_REQUIRE(is_one_of(status, k->statuses));
    FUZZ_REQUIRE(k->invert(&same, &same) == status);
    if (status != GN_OK) {
        FUZZ_REQUIRE(is_marked(&result.m[0][0], 16) && !memcmp(&same, m, sizeof same));
        return;
    }
    FUZZ_REQUIRE(are_finite(&result.m[0][0], 16) && !memcmp(&same, &result, sizeof same));
    FUZZ_REQUIRE(k->invert(NULL, &result) == GN_NULL_POINTER);
    FUZZ_REQUIRE(k->invert(m, NULL) == GN_NULL_POINTER);
}

/* Forces a matrix to be of a kind: the entries that the kind fixes. */
static gn_mat4 affine_of(const gn_mat4 *m)
{
    gn_mat4 a = *m;

    a.m[0][3] = a.m[1][3] = a.m[2][3] = 0.0f;
    a.m[3][3] = 1.0f;
    return a;
}

/* The permanent of |L| over the magnitude of L's determinant. */
static double permanent_ratio(const gn_mat4 *m)
{
    long double permanent = 0.0L, determinant = 0.0L;

    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const long double x = (long double)m->m[0][i];
        const long double p = (long double)m->m[1][j] * (long double)m->m[2][k];
        const long double q = (long double)m->m[1][k] * (long double)m->m[2][j];

        determinant += x * (p - q);
        permanent += fabsl(x) * (fabsl(p) + fabsl(q));
    }
    return (double)(permanent / fabsl(determinant));
}

/* m * result: |E| <= v |L||L^-1|, and (v + 3 u) |L||L^-1||t| in the translation. */
static void try_affine(const gn_mat4 *m)
{
    const gn_mat4 a = affine_of(m);
    gn_mat4 inverse;

    if (!is_normal(&a) || gn_mat4_invert_affine(&a, &inverse) != GN_OK || !is_normal(&inverse))
        return;

    matrix linear = magnitudes(widened(&a)), back = magnitudes(widened(&inverse));
    const matrix lack = sum(product(widened(&a), widened(&inverse)), -1.0, identity());
    const double v = (U + 0x1p-50 * permanent_ratio(&a)) * 1.001;
    const double t[4] = {linear.m[3][0], linear.m[3][1], linear.m[3][2], 0.0};

    for (int row = 0; row < 3; ++row)
        linear.m[3][row] = back.m[3][row] = 0.0;
    const matrix most = product(linear, back);

    for (int row = 0; row < 3; ++row) {
        double moved = 0.0;

        for (int column = 0; column < 3; ++column) {
            FUZZ_REQUIRE(fabs(lack.m[column][row]) <= v * most.m[column][row]);
            moved += most.m[column][row] * t[column];
        }
        FUZZ_REQUIRE(fabs(lack.m[3][row]) <= (v + 3.0 * U * SLACK) * moved);
    }
}

static void try_decompose(const gn_mat4 *m)
{
    const gn_mat4 a = affine_of(m);
    gn_vec3 translation, scale;
    gn_mat3 rotation;
    gn_transform again;

    mark(&translation.x, 3);
    mark(&rotation.m[0][0], 9);
    mark(&scale.x, 3);
    const gn_status status = gn_mat4_decompose_trs(&a, &translation, &rotation, &scale);

    FUZZ_REQUIRE(is_one_of(status, STATUS(OK) | STATUS(NOT_FINITE) | STATUS(SINGULAR) |
                                       STATUS(OUT_OF_RANGE)));
    if (status != GN_OK) {
        FUZZ_REQUIRE(is_marked(&translation.x, 3) && is_marked(&rotation.m[0][0], 9) &&
                     is_marked(&scale.x, 3));
        return;
    }
    FUZZ_REQUIRE(scale.y > 0.0f && scale.z > 0.0f && scale.x != 0.0f);
    FUZZ_REQUIRE(translation.x == a.m[3][0] && translation.y == a.m[3][1] &&
                 translation.z == a.m[3][2]);
    FUZZ_REQUIRE(gn_mat3_determinant(&rotation) > 0.99f);

    /* gn_trs accepts the three parts, unless its inverse overflows, and makes the matrix again
     * within 2 u, barring underflow: of a quotient, whose error the length multiplies, and of a
     * product. */
    const double length[4] = {fabs((double)scale.x), (double)scale.y, (double)scale.z, 0.0};
    const gn_status composed = gn_trs(translation, &rotation, scale, &again);

    FUZZ_REQUIRE(composed == GN_OK || composed == GN_OUT_OF_RANGE);
    for (int i = 0; i < 12 && composed == GN_OK; ++i) {
        const double x = (double)a.m[i / 4][i % 4], y = (double)again.matrix.m[i / 4][i % 4];

        FUZZ_REQUIRE(fabs(x - y) <= 2.0 * U * fabs(x) + 0x1p-148 * (length[i / 4] + 1.0));
    }
}

static void try_bits(fuzz_input *in)
{
    static const kind kinds[] = {
        {invert_any, STATUS(OK) | STATUS(NOT_FINITE) | STATUS(SINGULAR) | STATUS(OUT_OF_RANGE)},
        {gn_mat4_invert_affine,
         STATUS(OK) | STATUS(NOT_FINITE) | STATUS(SINGULAR) | STATUS(OUT_OF_RANGE)},
        {gn_mat4_invert_trs,
         STATUS(OK) | STATUS(NOT_FINITE) | STATUS(SINGULAR) | STATUS(OUT_OF_RANGE)},
        {gn_mat4_invert_orthographic,
         STATUS(OK) | STATUS(NOT_FINITE) | STATUS(SINGULAR) | STATUS(OUT_OF_RANGE)},
        {gn_mat4_invert_perspective,
         STATUS(OK) | STATUS(NOT_FINITE) | STATUS(SINGULAR) | STATUS(OUT_OF_RANGE)}};
    const bool plain = fuzz_byte(in) & 1;
    gn_mat4 m;
    gn_mat3 normal, linear, inverse;
    float condition = MARK;

    for (int i = 0; i < 16; ++i)
        m.m[i / 4][i % 4] = plain ? fuzz_tame(in) : fuzz_float(in);
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; ++i)
        try_kind(&kinds[i], &m);
    try_affine(&m);
    try_decompose(&m);

    gn_mat4_upper_left(&m, &linear);
    mark(&inverse.m[0][0], 9);
    const gn_status status = gn_mat3_invert(&linear, &inverse, &condition);

    if (status == GN_OK)
        FUZZ_REQUIRE(are_finite(&inverse.m[0][0], 9) && condition >= 1.0f);
    else
        FUZZ_REQUIRE(is_marked(&inverse.m[0][0], 9) && condition == MARK);

    /* The normal matrix is the transposed inverse of the affine part. */
    const gn_mat4 a = affine_of(&m);
    gn_mat4 affine;
    const gn_status expected = gn_mat4_invert_affine(&a, &affine);

    mark(&normal.m[0][0], 9);
    const gn_status got = gn_mat4_normal_matrix(&a, &normal);

    if (got != GN_OK)
        FUZZ_REQUIRE(is_marked(&normal.m[0][0], 9) && expected != GN_OK);
    for (int i = 0; i < 9 && got == GN_OK && expected == GN_OK; ++i)
        FUZZ_REQUIRE(normal.m[i / 3][i % 3] == affine.m[i % 3][i / 3]);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static const suite *const suites[] = {&properties_inverse, &properties_models};
    fuzz_input in = fuzz_begin(bytes, size);

    if (fuzz_byte(&in) & 1)
        property_run_input(&in, suites, sizeof suites / sizeof suites[0]);
    else
        try_bits(&in);
    return 0;
}
