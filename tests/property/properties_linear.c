/* Properties of vectors and matrices: products and transposes, selection, rays at a surface,
 * distances and angles. Bounds are those of the public headers. */
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include <gnomon.h>

#include "double_matrix.h"
#include "properties.h"
#include "random_inputs.h"

static enum theft_trial_res verdict(bool holds)
{
    return holds ? THEFT_TRIAL_PASS : THEFT_TRIAL_FAIL;
}

/* Products, transposes, traces. */

static enum theft_trial_res products_are_associative(struct theft *t, void *arg1, void *arg2)
{
    const float *f = arg1, *g = arg2;
    gn_mat4 a, b, c, left, right, transposed;
    gn_mat3 a3, b3, c3, left3, right3;
    (void)t;
    memcpy(&a, f, sizeof a);
    memcpy(&b, f + 16, sizeof b);
    memcpy(&c, g, sizeof c);
    const matrix wide =
        product(product(magnitudes(widened(&a)), magnitudes(widened(&b))), magnitudes(widened(&c)));
    gn_mat4_multiply(&a, &b, &left);
    gn_mat4_multiply(&left, &c, &left);
    gn_mat4_multiply(&b, &c, &right);
    gn_mat4_multiply(&a, &right, &right);
    if (!within(sum(widened(&left), -1.0, widened(&right)), scaled(16.0 * U, wide)))
        return THEFT_TRIAL_FAIL;

    gn_mat4_upper_left(&a, &a3);
    gn_mat4_upper_left(&b, &b3);
    gn_mat4_upper_left(&c, &c3);
    gn_mat4_from_mat3(&a3, &a);
    gn_mat4_from_mat3(&b3, &b);
    gn_mat4_from_mat3(&c3, &c);
    const matrix wide3 =
        product(product(magnitudes(widened(&a)), magnitudes(widened(&b))), magnitudes(widened(&c)));
    gn_mat3_multiply(&a3, &b3, &left3);
    gn_mat3_multiply(&left3, &c3, &left3);
    gn_mat3_multiply(&b3, &c3, &right3);
    gn_mat3_multiply(&a3, &right3, &right3);
    gn_mat4_from_mat3(&left3, &left);
    gn_mat4_from_mat3(&right3, &right);
    if (!within(sum(widened(&left), -1.0, widened(&right)), scaled(12.0 * U, wide3)))
        return THEFT_TRIAL_FAIL;

    /* (a b)^T = b^T a^T: equal products in equal order. */
    gn_mat4_multiply(&a, &b, &left);
    gn_mat4_transpose(&left, &left);
    gn_mat4_transpose(&a, &transposed);
    gn_mat4_transpose(&b, &right);
    gn_mat4_multiply(&right, &transposed, &right);
    return verdict(memcmp(&left, &right, sizeof left) == 0);
}

static enum theft_trial_res rows_and_traces(struct theft *t, void *arg)
{
    const float *f = arg;
    gn_mat4 m4, transposed4;
    gn_mat3 m3, transposed3;
    float rows[16];
    (void)t;
    gn_mat4_from_rows(f, &m4);
    gn_mat4_transpose(&m4, &transposed4);
    gn_mat4_to_rows(&m4, rows);
    if (memcmp(rows, f, sizeof rows) != 0 || memcmp(&transposed4, f, sizeof transposed4) != 0)
        return THEFT_TRIAL_FAIL;
    gn_mat3_from_rows(f, &m3);
    gn_mat3_transpose(&m3, &transposed3);
    gn_mat3_to_rows(&m3, rows);
    if (memcmp(rows, f, sizeof m3) != 0 || memcmp(&transposed3, f, sizeof transposed3) != 0)
        return THEFT_TRIAL_FAIL;
    double trace3 = 0.0, terms3 = 0.0, trace4 = 0.0, terms4 = 0.0;
    for (int i = 0; i < 4; ++i) {
        trace4 += (double)f[5 * i];
        terms4 += fabs((double)f[5 * i]);
        if (i < 3) {
            trace3 += (double)f[4 * i];
            terms3 += fabs((double)f[4 * i]);
        }
    }
    return verdict(fabs((double)gn_mat3_trace(&m3) - trace3) <= 2.0 * U * terms3 * SLACK &&
                   fabs((double)gn_mat4_trace(&m4) - trace4) <= 2.0 * U * terms4 * SLACK);
}

/* Vectors as arrays of components, so that one loop serves three sizes. */

static bool selects(float got, float a, float b, bool least)
{
    if (isnan(a) || isnan(b))
        return isnan(a) && isnan(b) ? isnan(got) : got == (isnan(a) ? b : a);
    return got == (least ? fminf(a, b) : fmaxf(a, b));
}

static enum theft_trial_res selections_select(struct theft *t, void *arg)
{
    const float *f = arg;
    const gn_vec4 a = {f[0], f[1], f[2], f[3]}, b = {f[4], f[5], f[6], f[7]};
    const gn_vec3 a3 = {f[0], f[1], f[2]}, b3 = {f[4], f[5], f[6]};
    const gn_vec2 a2 = {f[0], f[1]}, b2 = {f[4], f[5]};
    const gn_vec4 least = gn_vec4_minimum(a, b), most = gn_vec4_maximum(a, b);
    const gn_vec3 least3 = gn_vec3_minimum(a3, b3), most3 = gn_vec3_maximum(a3, b3);
    const gn_vec2 least2 = gn_vec2_minimum(a2, b2), most2 = gn_vec2_maximum(a2, b2);
    const float low = fminf(f[8], f[9]), high = fmaxf(f[8], f[9]);
    const gn_vec4 between = gn_vec4_clamp(a, low, high);
    const float got[3][4] = {{least.x, least.y, least.z, least.w},
                             {most.x, most.y, most.z, most.w},
                             {between.x, between.y, between.z, between.w}};
    (void)t;
    for (int i = 0; i < 4; ++i) {
        if (!selects(got[0][i], f[i], f[4 + i], true) || !selects(got[1][i], f[i], f[4 + i], false))
            return THEFT_TRIAL_FAIL;
        const float expected = !(f[i] > low) ? low : f[i] < high ? f[i] : high;
        if (!isnan(low) && !isnan(high) && got[2][i] != expected)
            return THEFT_TRIAL_FAIL;
    }
    return verdict(
        memcmp(&least3, &least, sizeof least3) == 0 && memcmp(&most3, &most, sizeof most3) == 0 &&
        memcmp(&least2, &least, sizeof least2) == 0 && memcmp(&most2, &most, sizeof most2) == 0);
}

static gn_vec3 unit_of(const float *f)
{
    const gn_vec3 v = {f[0], f[1], f[2]};
    gn_vec3 unit = {1.0f, 0.0f, 0.0f};
    gn_vec3_normalize(v, &unit);
    return unit;
}

static enum theft_trial_res rays_follow_the_laws(struct theft *t, void *arg)
{
    const float *f = arg;
    const gn_vec3 normal = unit_of(f), v = unit_of(f + 3);
    const float eta = fabsf(f[6]);
    const double n[3] = {(double)normal.x, (double)normal.y, (double)normal.z};
    const double i[3] = {(double)v.x, (double)v.y, (double)v.z}, e = (double)eta;
    const double d = n[0] * i[0] + n[1] * i[1] + n[2] * i[2];
    const double k = 1.0 - e * e * (1.0 - d * d), doubt = (10.0 * e * e + 1.0) * U;
    const gn_vec3 back = gn_vec3_reflect(v, normal), through = gn_vec3_refract(v, normal, eta);
    const double got[2][3] = {{(double)back.x, (double)back.y, (double)back.z},
                              {(double)through.x, (double)through.y, (double)through.z}};
    double reflected = 0.0, refracted = 0.0, length = 0.0;
    (void)t;
    for (int c = 0; c < 3; ++c) {
        const double exact = e * i[c] - (e * d + sqrt(fmax(k, 0.0))) * n[c];
        reflected += pow(got[0][c] - (i[c] - 2.0 * d * n[c]), 2.0);
        refracted += pow(got[1][c] - exact, 2.0);
        length += fabs(got[1][c]);
    }
    if (!(sqrt(reflected) <= 10.0 * U * SLACK))
        return THEFT_TRIAL_FAIL;
    if (k < -doubt)
        return verdict(length == 0.0);
    return verdict(k < 2.0 * doubt ||
                   sqrt(refracted) <= ((8.0 * e + 4.0) + (6.0 * e * e + 1.0) / sqrt(k)) * U);
}

/* Vectors with fewer or more components, and distances and angles in double. */
static enum theft_trial_res distances_and_angles(struct theft *t, void *arg)
{
    const float *f = arg;
    const gn_vec4 a = {f[0], f[1], f[2], f[3]}, b = {f[4], f[5], f[6], f[7]};
    const gn_vec3 a3 = {f[0], f[1], f[2]}, b3 = {f[4], f[5], f[6]};
    const gn_vec2 a2 = {f[0], f[1]}, b2 = {f[4], f[5]};
    const float got[3] = {gn_vec2_distance(a2, b2), gn_vec3_distance(a3, b3),
                          gn_vec4_distance(a, b)};
    double square = 0.0, squares[2] = {0.0}, less = 0.0, more = 0.0;
    float angle;
    (void)t;
    for (int i = 0; i < 4; ++i) {
        const double apart = (double)f[4 + i] - (double)f[i];
        square += apart * apart;
        if (i > 0 && !(fabs((double)got[i - 1] - sqrt(square)) <= 4.5 * U * sqrt(square) * SLACK))
            return THEFT_TRIAL_FAIL;
        if (i < 3) {
            squares[0] += (double)f[i] * (double)f[i];
            squares[1] += (double)f[4 + i] * (double)f[4 + i];
        }
    }
    for (int i = 0; i < 3; ++i) {
        const double x = (double)f[i] / sqrt(squares[0]), y = (double)f[4 + i] / sqrt(squares[1]);
        less += (x - y) * (x - y);
        more += (x + y) * (x + y);
    }
    return verdict(gn_vec3_angle(a3, b3, &angle) == GN_OK &&
                   fabs((double)angle - 2.0 * atan2(sqrt(less), sqrt(more))) <= 10.0 * U);
}

int properties_linear(uint64_t seed, size_t trials)
{
    struct choice moderate = {.exponents = 8}, near_one = {.exponents = 2};
    const struct theft_type_info moderate_info = random_floats(&moderate);
    const struct theft_type_info near_one_info = random_floats(&near_one);
    const struct theft_type_info float_info = random_floats(NULL);
    const struct theft_run_config properties[] = {
        {.name = "matrices: associative, transposed",
         .prop2 = products_are_associative,
         .type_info = {&moderate_info, &moderate_info}},
        {.name = "matrices: rows, trace", .prop1 = rows_and_traces, .type_info = {&moderate_info}},
        {.name = "vectors: minimum, maximum, clamp",
         .prop1 = selections_select,
         .type_info = {&float_info}},
        {.name = "vectors: reflect, refract",
         .prop1 = rays_follow_the_laws,
         .type_info = {&near_one_info}},
        {.name = "vectors: distance, angle",
         .prop1 = distances_and_angles,
         .type_info = {&moderate_info}},
    };
    int failed = 0;
    for (size_t i = 0; i < sizeof properties / sizeof properties[0]; ++i)
        failed += property_run(properties[i], seed, trials);
    return failed;
}
