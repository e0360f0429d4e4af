/* Properties of vectors of two, three and four floats: each component for any bits of the operands,
 * sums of products, lengths and directions within the bounds of vec.h. */
#include <math.h>
#include <string.h>

#include <gnomon.h>

#include "double_matrix.h"
#include "random_inputs.h"

/* A vector of any size; unused components are of no interest. */
typedef union vector {
    gn_vec2 two;
    gn_vec3 three;
    gn_vec4 four;
    float c[4];
} vector;

/* One function of two vectors in its three sizes. */
typedef struct binary {
    gn_vec2 (*two)(gn_vec2, gn_vec2);
    gn_vec3 (*three)(gn_vec3, gn_vec3);
    gn_vec4 (*four)(gn_vec4, gn_vec4);
} binary;

/* Whether the vectors of two, three and four components are the beginning of the expected one. */
static bool each_is(const vector got[3], const float *expected)
{
    return same_floats(got[0].c, expected, 2) && same_floats(got[1].c, expected, 3) &&
           same_floats(got[2].c, expected, 4);
}

/* The lesser of two numbers, or the one that is a number. */
static float lesser(float a, float b)
{
    return isnan(a) || a >= b ? b : a;
}

/* Sum, difference and product of two floats are rounded once: a double holds the product exactly,
 * and the sum in enough bits that rounding it again changes nothing (53 >= 2 * 24 + 2). Negating
 * changes the sign bit. Selections return one of the operands' numbers. */
static enum theft_trial_res components_are_exact(struct theft *t, void *arg)
{
    static const binary functions[5] = {{gn_vec2_add, gn_vec3_add, gn_vec4_add},
                                        {gn_vec2_subtract, gn_vec3_subtract, gn_vec4_subtract},
                                        {gn_vec2_multiply, gn_vec3_multiply, gn_vec4_multiply},
                                        {gn_vec2_minimum, gn_vec3_minimum, gn_vec4_minimum},
                                        {gn_vec2_maximum, gn_vec3_maximum, gn_vec4_maximum}};
    const float *const a = arg, *const b = a + 4;
    const float factor = a[8], low = lesser(a[8], a[9]), high = -lesser(-a[8], -a[9]);
    float expected[8][4];
    (void)t;
    for (int i = 0; i < 4; ++i) {
        expected[0][i] = (float)((double)a[i] + (double)b[i]);
        expected[1][i] = (float)((double)a[i] - (double)b[i]);
        expected[2][i] = (float)((double)a[i] * (double)b[i]);
        expected[3][i] = lesser(a[i], b[i]);
        expected[4][i] = -lesser(-a[i], -b[i]);
        expected[5][i] = (float)((double)a[i] * (double)factor);
        expected[6][i] = copysignf(a[i], signbit(a[i]) ? 1.0f : -1.0f);
        expected[7][i] = lesser(-lesser(-a[i], -low), high);
    }
    for (int k = 0; k < 5; ++k) {
        const binary *const f = &functions[k];
        const vector got[3] = {{.two = f->two(vec2_of(a), vec2_of(b))},
                               {.three = f->three(vec3_of(a), vec3_of(b))},
                               {.four = f->four(vec4_of(a), vec4_of(b))}};
        if (!each_is(got, expected[k]))
            return THEFT_TRIAL_FAIL;
    }
    const vector scaled[3] = {{.two = gn_vec2_scale(vec2_of(a), factor)},
                              {.three = gn_vec3_scale(vec3_of(a), factor)},
                              {.four = gn_vec4_scale(vec4_of(a), factor)}};
    const vector negative[3] = {{.two = gn_vec2_negate(vec2_of(a))},
                                {.three = gn_vec3_negate(vec3_of(a))},
                                {.four = gn_vec4_negate(vec4_of(a))}};
    const vector clamped[3] = {{.two = gn_vec2_clamp(vec2_of(a), low, high)},
                               {.three = gn_vec3_clamp(vec3_of(a), low, high)},
                               {.four = gn_vec4_clamp(vec4_of(a), low, high)}};
    return verdict(each_is(scaled, expected[5]) && each_is(negative, expected[6]) &&
                   each_is(clamped, expected[7]));
}

/* The difference of two products, each rounded. */
static bool minor_is(float got, float a, float b, float c, float d)
{
    const double first = (double)a * (double)b, second = (double)c * (double)d;
    return fabs((double)got - (first - second)) <= 2.0 * U * (fabs(first) + fabs(second)) * SLACK;
}

static enum theft_trial_res products(struct theft *t, void *arg)
{
    const float *a = arg, *b = a + 4;
    const gn_vec2 a2 = vec2_of(a), b2 = vec2_of(b);
    const gn_vec3 across = gn_vec3_cross(vec3_of(a), vec3_of(b));
    const gn_vec3 back = gn_vec3_cross(vec3_of(b), vec3_of(a));
    (void)t;
    return verdict(dot_is(gn_vec2_dot(a2, b2), a, 1, b, 2) &&
                   dot_is(gn_vec3_dot(vec3_of(a), vec3_of(b)), a, 1, b, 3) &&
                   dot_is(gn_vec4_dot(vec4_of(a), vec4_of(b)), a, 1, b, 4) &&
                   minor_is(gn_vec2_cross(a2, b2), a[0], b[1], a[1], b[0]) &&
                   minor_is(across.x, a[1], b[2], a[2], b[1]) &&
                   minor_is(across.y, a[2], b[0], a[0], b[2]) &&
                   minor_is(across.z, a[0], b[1], a[1], b[0]) &&
                   gn_vec2_cross(a2, b2) == -gn_vec2_cross(b2, a2) && across.x == -back.x &&
                   across.y == -back.y && across.z == -back.z);
}

/* a * (1 - t) + b * t: 1 - t, the products and the sum are rounded, but not at t = 0 and t = 1. */
static enum theft_trial_res interpolation(struct theft *t, void *arg)
{
    const float *a = arg, *b = a + 4;
    const float weights[3] = {0.0f, 1.0f, a[8]};
    (void)t;
    for (int k = 0; k < 12; ++k) {
        const float weight = weights[k % 3];
        const int i = k / 3;
        const vector got[3] = {{.two = gn_vec2_mix(vec2_of(a), vec2_of(b), weight)},
                               {.three = gn_vec3_mix(vec3_of(a), vec3_of(b), weight)},
                               {.four = gn_vec4_mix(vec4_of(a), vec4_of(b), weight)}};
        const double from = (double)a[i] * (1.0 - (double)weight);
        const double to = (double)b[i] * (double)weight;
        const double bound = 3.0 * U * (fabs(from) + fabs(to));
        for (int size = 0; size < 3; ++size)
            if (i < size + 2 && (!(fabs((double)got[size].c[i] - (from + to)) <= bound * SLACK) ||
                                 got[size].c[i] != gn_mix(a[i], b[i], weight) ||
                                 (weight == 0.0f && got[size].c[i] != a[i]) ||
                                 (weight == 1.0f && got[size].c[i] != b[i])))
                return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

static double length_of(const float *v, int count)
{
    double square = 0.0;
    for (int i = 0; i < count; ++i)
        square += (double)v[i] * (double)v[i];
    return sqrt(square);
}

/* If the length is a normal float; a length beyond the largest float is infinite. */
static bool length_is(float got, const float *v, int count)
{
    const double length = length_of(v, count);
    if (length < 0x1p-126)
        return true;
    return length >= 0x1p128 ? isinf(got)
                             : fabs((double)got - length) <= 3.5 * U * length ||
                                   (isinf(got) && length > 0x1.fffff0p127);
}

/* The length of v, and each component of v / |v|, however different their exponents are. */
static bool direction_is(const float *got, const float *v, int count)
{
    const double bound = (count / 2.0 + 2.0) * U;
    for (int k = 0; k < count; ++k) {
        const double exact = (double)v[k] / length_of(v, count);
        if (!(fabs((double)got[k] - exact) <= fmax(bound * fabs(exact), 0x1p-148)))
            return false;
    }
    return fabs(length_of(got, count) - 1.0) <= bound;
}

/* The directions of the first two, three and four floats. */
static bool normalize(const float *f, vector result[3])
{
    return gn_vec2_normalize(vec2_of(f), &result[0].two) == GN_OK &&
           gn_vec3_normalize(vec3_of(f), &result[1].three) == GN_OK &&
           gn_vec4_normalize(vec4_of(f), &result[2].four) == GN_OK;
}

static enum theft_trial_res lengths_and_directions(struct theft *t, void *arg)
{
    const float *f = arg;
    vector unit[3];
    (void)t;
    if (!all_finite(f, 4))
        return THEFT_TRIAL_SKIP;
    if (!length_is(gn_vec2_length(vec2_of(f)), f, 2) ||
        !length_is(gn_vec3_length(vec3_of(f)), f, 3) ||
        !length_is(gn_vec4_length(vec4_of(f)), f, 4))
        return THEFT_TRIAL_FAIL;
    if (f[0] == 0.0f)
        return THEFT_TRIAL_SKIP;
    return verdict(normalize(f, unit) && direction_is(unit[0].c, f, 2) &&
                   direction_is(unit[1].c, f, 3) && direction_is(unit[2].c, f, 4));
}

static enum theft_trial_res distances_and_angles(struct theft *t, void *arg)
{
    const float *a = arg, *b = a + 4;
    const float got[3] = {gn_vec2_distance(vec2_of(a), vec2_of(b)),
                          gn_vec3_distance(vec3_of(a), vec3_of(b)),
                          gn_vec4_distance(vec4_of(a), vec4_of(b))};
    double square = 0.0, less = 0.0, more = 0.0;
    float angle;
    (void)t;
    for (int i = 0; i < 4; ++i) {
        const double apart = (double)b[i] - (double)a[i];
        square += apart * apart;
        if (i > 0 && !(fabs((double)got[i - 1] - sqrt(square)) <= 4.5 * U * sqrt(square) * SLACK))
            return THEFT_TRIAL_FAIL;
    }
    for (int i = 0; i < 3; ++i) {
        const double x = (double)a[i] / length_of(a, 3), y = (double)b[i] / length_of(b, 3);
        less += (x - y) * (x - y);
        more += (x + y) * (x + y);
    }
    return verdict(gn_vec3_angle(vec3_of(a), vec3_of(b), &angle) == GN_OK &&
                   fabs((double)angle - 2.0 * atan2(sqrt(less), sqrt(more))) <= 10.0 * U);
}

/* Reflection and refraction of the direction v at a surface with the normal n, both of length one
 * but for rounding. */
static bool bends(const float *v, const float *n, const float *back, const float *through,
                  double eta, int count)
{
    double d = 0.0, reflected = 0.0, refracted = 0.0;
    for (int c = 0; c < count; ++c)
        d += (double)n[c] * (double)v[c];
    const double k = 1.0 - eta * eta * (1.0 - d * d), doubt = (10.0 * eta * eta + 1.0) * U;
    for (int c = 0; c < count; ++c) {
        const double vc = (double)v[c], nc = (double)n[c];
        const double exact = eta * vc - (eta * d + sqrt(fmax(k, 0.0))) * nc;
        reflected += pow((double)back[c] - (vc - 2.0 * d * nc), 2.0);
        refracted += pow((double)through[c] - exact, 2.0);
    }
    if (!(sqrt(reflected) <= (2.0 * count + 4.0) * U * SLACK))
        return false;
    if (k < -doubt)
        return length_of(through, count) == 0.0;
    return k < 2.0 * doubt ||
           sqrt(refracted) <= ((8.0 * eta + 4.0) + (6.0 * eta * eta + 1.0) / sqrt(k)) * U;
}

static enum theft_trial_res rays_follow_the_laws(struct theft *t, void *arg)
{
    const float *f = arg, eta = fabsf(f[8]);
    vector v[3], n[3];
    (void)t;
    if (!normalize(f, v) || !normalize(f + 4, n))
        return THEFT_TRIAL_FAIL;
    const vector back[3] = {{.two = gn_vec2_reflect(v[0].two, n[0].two)},
                            {.three = gn_vec3_reflect(v[1].three, n[1].three)},
                            {.four = gn_vec4_reflect(v[2].four, n[2].four)}};
    const vector through[3] = {{.two = gn_vec2_refract(v[0].two, n[0].two, eta)},
                               {.three = gn_vec3_refract(v[1].three, n[1].three, eta)},
                               {.four = gn_vec4_refract(v[2].four, n[2].four, eta)}};
    for (int i = 0; i < 3; ++i)
        if (!bends(v[i].c, n[i].c, back[i].c, through[i].c, (double)eta, i + 2))
            return THEFT_TRIAL_FAIL;
    return THEFT_TRIAL_PASS;
}

static const property vectors[] = {
    PROPERTY1("vectors: components", components_are_exact, ANY_FLOATS),
    PROPERTY1("vectors: components, moderate numbers", components_are_exact, FLOATS_WITHIN(20)),
    PROPERTY1("vectors: dot and cross", products, FLOATS_WITHIN(20)),
    PROPERTY1("vectors: mix", interpolation, FLOATS_WITHIN(20)),
    PROPERTY1("vectors: length and direction", lengths_and_directions, ANY_FLOATS),
    PROPERTY1("vectors: distance, angle", distances_and_angles, FLOATS_WITHIN(8)),
    PROPERTY1("vectors: reflect, refract", rays_follow_the_laws, FLOATS_WITHIN(2)),
    PROPERTY1("vectors: reflect, refract, more scales", rays_follow_the_laws, FLOATS_WITHIN(20)),
};

SUITE(properties_vectors, vectors);
