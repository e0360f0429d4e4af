/* Properties of the general inverses: matrices of every kind, condition and scale, against inverses
 * in long double. Bounds are those of mat.h. */
#include <float.h>
#include <math.h>
#include <string.h>

#include <gnomon.h>

#include "random_inputs.h"
#include "wide.h"

/* Matrices with known singular values: left * diagonal * right, with orthogonal left and right,
 * computed in double, rounded to float. */

struct made_matrix {
    int large;  /* singular values that are 1, if the others are 1 / condition; 0: they fall evenly
                 */
    int tenths; /* log10 of the condition, in tenths */
    int exponent; /* exponent of the scale, a power of two */
    gn_mat4 m;
};

/* Reflections at random planes; zero bits make no reflection. */
static void turn(struct theft *t, double m[4][4], bool columns, int size)
{
    for (int i = 0; i < size; ++i) {
        double v[4] = {0.0}, square = 0.0;
        for (int k = 0; k < size; ++k) {
            v[k] = (double)theft_random_bits(t, 20) * 0x1p-20 - (k == i ? 0.0 : 0.5);
            square += v[k] * v[k];
        }
        for (int row = 0; row < size && square > 0.0; ++row) {
            double dot = 0.0;
            for (int k = 0; k < size; ++k)
                dot += v[k] * (columns ? m[row][k] : m[k][row]);
            for (int k = 0; k < size; ++k)
                *(columns ? &m[row][k] : &m[k][row]) -= 2.0 * dot / square * v[k];
        }
    }
}

/* For a size of 3 the last row and column stay those of the identity. */
static void make_spectral(struct theft *t, struct made_matrix *made, int size, int most_tenths)
{
    double m[4][4] = {{0.0}};
    made->large = (int)(theft_random_bits(t, 8) % (unsigned)size);
    made->tenths = (int)(theft_random_bits(t, 8) % (unsigned)(most_tenths + 1));
    /* 2^-66 to 2^66: 1e-20 to 1e20 */
    made->exponent = (int)(theft_random_bits(t, 8) % 67);
    made->exponent *= theft_random_bits(t, 1) ? -1 : 1;
    const double condition = pow(10.0, 0.1 * made->tenths);
    for (int i = 0; i < size; ++i)
        m[i][i] = made->large == 0  ? pow(condition, -(double)i / (size - 1))
                  : i < made->large ? 1.0
                                    : 1.0 / condition;
    turn(t, m, false, size);
    turn(t, m, true, size);
    gn_mat4_identity(&made->m);
    for (int i = 0; i < size * size; ++i)
        made->m.m[i / size][i % size] = (float)(m[i / size][i % size] * ldexp(1.0, made->exponent));
}

static enum theft_alloc_res alloc_matrix(struct theft *t, void *env, void **output)
{
    const int *parameters = env; /* size, log10 of the largest condition in tenths */
    struct made_matrix *made = *output = allocated(sizeof *made);
    make_spectral(t, made, parameters[0], parameters[1]);
    return THEFT_ALLOC_OK;
}

static void print_matrix(FILE *f, const void *instance, void *env)
{
    const struct made_matrix *made = instance;
    (void)env;
    fprintf(f, "%d large, condition 10^%.1f, scale 2^%d, columns\n", made->large,
            0.1 * made->tenths, made->exponent);
    for (int i = 0; i < 16; ++i)
        fprintf(f, "%a%c", (double)made->m.m[i / 4][i % 4], i % 4 == 3 ? '\n' : ' ');
}

/* Inverses of the leading part in long double. */

typedef struct wide_matrix {
    wide m[4][4];
} wide_matrix;

/* Gauss and Jordan's elimination with the largest entry of a column as pivot; false if a column has
 * none. */
static bool invert_wide(wide_matrix a, int size, wide_matrix *inverse)
{
    for (int i = 0; i < 16; ++i)
        inverse->m[i / 4][i % 4] = i % 5 == 0 ? 1.0L : 0.0L;
    for (int step = 0; step < size; ++step) {
        int p = step;
        for (int i = step; i < size; ++i)
            if (fabsl(a.m[i][step]) > fabsl(a.m[p][step]))
                p = i;
        const wide pivot = a.m[p][step];
        if (pivot == 0.0L)
            return false;
        for (int k = 0; k < size; ++k) {
            const wide x = a.m[p][k], y = inverse->m[p][k];
            a.m[p][k] = a.m[step][k];
            inverse->m[p][k] = inverse->m[step][k];
            a.m[step][k] = x / pivot;
            inverse->m[step][k] = y / pivot;
        }
        for (int i = 0; i < size; ++i) {
            const wide factor = i == step ? 0.0L : a.m[i][step];
            for (int k = 0; k < size; ++k) {
                a.m[i][k] -= factor * a.m[step][k];
                inverse->m[i][k] -= factor * inverse->m[step][k];
            }
        }
    }
    return true;
}

static wide_matrix wide_of(const float *columns, int size)
{
    wide_matrix w = {{{0.0L}}};
    for (int i = 0; i < size * size; ++i)
        w.m[i / size][i % size] = (wide)columns[i];
    return w;
}

static wide frobenius(const wide_matrix *a, const wide_matrix *less, int size)
{
    wide squares = 0.0L;
    for (int i = 0; i < size * size; ++i) {
        wide x = a->m[i / size][i % size] - (less ? less->m[i / size][i % size] : 0.0L);
        squares += x * x;
    }
    return sqrtl(squares);
}

static wide infinity_norm(const wide_matrix *a, int size)
{
    wide most = 0.0L;
    for (int row = 0; row < size; ++row) {
        wide sum = 0.0L;
        for (int column = 0; column < size; ++column)
            sum += fabsl(a->m[column][row]);
        most = fmaxl(most, sum);
    }
    return most;
}

static gn_status invert(const float *columns, int size, float *result, float *condition)
{
    return size == 3 ? gn_mat3_invert((const gn_mat3 *)(const void *)columns,
                                      (gn_mat3 *)(void *)result, condition)
                     : gn_mat4_invert((const gn_mat4 *)(const void *)columns,
                                      (gn_mat4 *)(void *)result, condition);
}

/* The rounded matrix has other singular values, so the ratio of the extremes comes from the
 * inverse: the product of the Frobenius norms is no less than the ratio, and at most `size` times
 * as much. */
static enum theft_trial_res inverse_is_exact(const gn_mat4 *columns, int size)
{
    float m[16], got[16], condition;
    wide_matrix exact, result;
    for (int i = 0; i < size * size; ++i)
        m[i] = columns->m[i / size][i % size];
    const wide_matrix before = wide_of(m, size);
    if (!invert_wide(before, size, &exact))
        return THEFT_TRIAL_SKIP;
    const wide ratio = frobenius(&before, NULL, size) * frobenius(&exact, NULL, size);
    if (ratio > 1e10L)
        return THEFT_TRIAL_SKIP;
    if (invert(m, size, got, &condition) != GN_OK)
        return THEFT_TRIAL_FAIL;
    result = wide_of(got, size);
    const wide error = frobenius(&result, &exact, size) / frobenius(&exact, NULL, size);
    const wide bound = 0x1p-23L + 0x1p-48L * ratio;
    const wide expected = infinity_norm(&before, size) * infinity_norm(&exact, size);
    for (int i = 0; i < size * size; ++i)
        if (got[i] == 0.0f && signbit(got[i]))
            return THEFT_TRIAL_FAIL;
    return verdict(error <= bound && condition >= 1.0f &&
                   fabsl((wide)condition - expected) <= 2.0L * size * bound * expected);
}

static enum theft_trial_res inverse4_is_exact(struct theft *t, void *arg)
{
    (void)t;
    return inverse_is_exact(&((struct made_matrix *)arg)->m, 4);
}

static enum theft_trial_res inverse3_is_exact(struct theft *t, void *arg)
{
    (void)t;
    return inverse_is_exact(&((struct made_matrix *)arg)->m, 3);
}

static enum theft_trial_res inverse_of_transform_is_exact(struct theft *t, void *arg)
{
    (void)t;
    return inverse_is_exact(&((struct made *)arg)->transform.matrix, 4);
}

/* Whether 2^exponent m has a number that is no normal float, and so has lost bits. */
static bool underflows(const gn_mat4 *m, int exponent)
{
    for (int i = 0; i < 16; ++i) {
        const float x = fabsf(m->m[i / 4][i % 4]);
        if (x != 0.0f && ldexpf(x, exponent) < FLT_MIN)
            return true;
    }
    return false;
}

/* The inverse of 2^k m is 2^-k times the inverse of m, to the bit, and the condition is equal. */
static enum theft_trial_res inverse_knows_no_scale(struct theft *t, void *arg)
{
    struct made_matrix scaled_up = *(struct made_matrix *)arg;
    gn_mat4 inverse, other;
    float condition, same;
    const int exponent = (int)theft_random_bits(t, 5) - 16;
    if (gn_mat4_invert(&scaled_up.m, &inverse, &condition) != GN_OK)
        return THEFT_TRIAL_FAIL;
    if (underflows(&scaled_up.m, 0) || underflows(&scaled_up.m, exponent))
        return THEFT_TRIAL_SKIP;
    for (int i = 0; i < 16; ++i)
        scaled_up.m.m[i / 4][i % 4] = ldexpf(scaled_up.m.m[i / 4][i % 4], exponent);
    if (gn_mat4_invert(&scaled_up.m, &other, &same) != GN_OK)
        return THEFT_TRIAL_FAIL;
    if (underflows(&inverse, 0) || underflows(&inverse, -exponent) || underflows(&other, 0))
        return THEFT_TRIAL_SKIP;
    for (int i = 0; i < 16; ++i)
        inverse.m[i / 4][i % 4] = ldexpf(inverse.m[i / 4][i % 4], -exponent);
    return verdict(memcmp(&inverse, &other, sizeof other) == 0 && condition == same);
}

/* The last column is a sum of whole multiples of the others, or zero. */
static enum theft_trial_res singular_matrices_are_named(struct theft *t, void *arg)
{
    (void)arg;
    for (int size = 3; size <= 4; ++size) {
        float m[16], result[16], marked[16], condition = 5.0f;
        const int exponent = (int)theft_random_bits(t, 7) - 64;
        const int which = (int)(theft_random_bits(t, 8) % (unsigned)size);
        for (int i = 0; i < 16; ++i) {
            m[i] = (float)theft_random_bits(t, 10) - 512.0f;
            result[i] = marked[i] = 7.0f;
        }
        for (int row = 0; row < size; ++row)
            m[which * size + row] = 0.0f;
        for (int column = 0; column < size; ++column) {
            const float factor = (float)theft_random_bits(t, 5) - 16.0f;
            for (int row = 0; row < size && column != which; ++row)
                m[which * size + row] += factor * m[column * size + row];
        }
        for (int i = 0; i < 16; ++i)
            m[i] = ldexpf(m[i], exponent);
        if (invert(m, size, result, &condition) != GN_SINGULAR || condition != 5.0f ||
            memcmp(result, marked, sizeof result) != 0)
            return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

/* Two columns that differ by a power of two, of numbers whose products of products do not fit a
 * double: only rounding is left of the sums. */
static enum theft_trial_res parallel_columns_are_named(struct theft *t, void *arg)
{
    const float *floats = arg;
    for (int size = 3; size <= 4; ++size) {
        float m[16], result[16], condition;
        const int from = (int)(theft_random_bits(t, 8) % (unsigned)size);
        const int to = (from + 1 + (int)(theft_random_bits(t, 8) % (unsigned)(size - 1))) % size;
        const float factor = ldexpf(1.0f, (int)theft_random_bits(t, 4) - 8);
        memcpy(m, floats, sizeof m);
        for (int row = 0; row < size; ++row)
            m[to * size + row] = factor * m[from * size + row];
        if (invert(m, size, result, &condition) != GN_SINGULAR)
            return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

/* For any bits there is a status; with GN_OK the results are finite numbers. */
static enum theft_trial_res any_bits_have_an_answer(struct theft *t, void *arg)
{
    const float *floats = arg;
    (void)t;
    for (int size = 3; size <= 4; ++size) {
        float result[16], marked[16], condition = 5.0f;
        bool finite = true, written = false;
        for (int i = 0; i < 16; ++i)
            result[i] = marked[i] = 7.0f;
        for (int i = 0; i < size * size; ++i)
            finite = finite && isfinite(floats[i]);
        const gn_status status = invert(floats, size, result, &condition);
        written = memcmp(result, marked, sizeof result) != 0 || condition != 5.0f;
        if ((status == GN_NOT_FINITE) == finite || (status == GN_OK) != written)
            return THEFT_TRIAL_FAIL;
        for (int i = 0; i < size * size; ++i)
            if (!isfinite(result[i]))
                return THEFT_TRIAL_FAIL;
        if (status == GN_OK && !(condition >= 1.0f))
            return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

/* Matrices of a size, and the largest condition as log10 in tenths. */
#define MATRICES(size, tenths) INSTANCES(alloc_matrix, print_matrix, ((int[]){size, tenths}))

static const property inverses[] = {
    PROPERTY1("mat4 inverse: exact within bound", inverse4_is_exact, MATRICES(4, 70)),
    PROPERTY1("mat3 inverse: exact within bound", inverse3_is_exact, MATRICES(3, 70)),
    PROPERTY1("mat4 inverse of transforms: exact within bound", inverse_of_transform_is_exact,
              TRANSFORMS(0, KINDS, 8)),
    PROPERTY1("mat4 inverse: any scale, the same bits", inverse_knows_no_scale, MATRICES(4, 50)),
    PROPERTY1("inverse: singular matrices", singular_matrices_are_named, FLOATS_WITHIN(2)),
    PROPERTY1("inverse: parallel columns", parallel_columns_are_named, FLOATS_WITHIN(8)),
    PROPERTY1("inverse: any bits", any_bits_have_an_answer, ANY_FLOATS),
};

SUITE(properties_inverse, inverses);
