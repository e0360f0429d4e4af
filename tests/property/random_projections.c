/* Implements random_projections.h. */
#include "random_projections.h"

#include <math.h>
#include <stdlib.h>

#include "random_inputs.h"

typedef gn_status six_planes(float, float, float, float, float, float, gn_transform *);
typedef gn_status five_planes(float, float, float, float, float, gn_transform *);
typedef gn_status symmetric(float, float, float, float, gn_transform *);
typedef gn_status symmetric_infinite(float, float, float, gn_transform *);

/* By handedness, depth range and order of depth. */
static six_planes *const boxes[2][2][2] = {
    {{gn_orthographic_rh_no, gn_orthographic_rh_no_reversed},
     {gn_orthographic_rh_zo, gn_orthographic_rh_zo_reversed}},
    {{gn_orthographic_lh_no, gn_orthographic_lh_no_reversed},
     {gn_orthographic_lh_zo, gn_orthographic_lh_zo_reversed}}};
static six_planes *const pyramids[2][2][2] = {
    {{gn_frustum_rh_no, gn_frustum_rh_no_reversed}, {gn_frustum_rh_zo, gn_frustum_rh_zo_reversed}},
    {{gn_frustum_lh_no, gn_frustum_lh_no_reversed}, {gn_frustum_lh_zo, gn_frustum_lh_zo_reversed}}};
static five_planes *const endless_pyramids[2][2][2] = {
    {{gn_frustum_rh_no_infinite, gn_frustum_rh_no_infinite_reversed},
     {gn_frustum_rh_zo_infinite, gn_frustum_rh_zo_infinite_reversed}},
    {{gn_frustum_lh_no_infinite, gn_frustum_lh_no_infinite_reversed},
     {gn_frustum_lh_zo_infinite, gn_frustum_lh_zo_infinite_reversed}}};
static symmetric *const symmetrics[2][2][2] = {
    {{gn_perspective_rh_no, gn_perspective_rh_no_reversed},
     {gn_perspective_rh_zo, gn_perspective_rh_zo_reversed}},
    {{gn_perspective_lh_no, gn_perspective_lh_no_reversed},
     {gn_perspective_lh_zo, gn_perspective_lh_zo_reversed}}};
static symmetric_infinite *const endless_symmetrics[2][2][2] = {
    {{gn_perspective_rh_no_infinite, gn_perspective_rh_no_infinite_reversed},
     {gn_perspective_rh_zo_infinite, gn_perspective_rh_zo_infinite_reversed}},
    {{gn_perspective_lh_no_infinite, gn_perspective_lh_no_infinite_reversed},
     {gn_perspective_lh_zo_infinite, gn_perspective_lh_zo_infinite_reversed}}};

gn_status project_in(const struct projection *projection, struct convention c, gn_transform *result)
{
    const float *n = projection->numbers;
    const int h = c.left_handed, z = c.zero_to_one, r = c.reversed;
    if (projection->volume == BOX)
        return boxes[h][z][r](n[0], n[1], n[2], n[3], n[4], n[5], result);
    if (projection->volume == PYRAMID)
        return c.infinite ? endless_pyramids[h][z][r](n[0], n[1], n[2], n[3], n[4], result)
                          : pyramids[h][z][r](n[0], n[1], n[2], n[3], n[4], n[5], result);
    return c.infinite ? endless_symmetrics[h][z][r](n[0], n[1], n[2], result)
                      : symmetrics[h][z][r](n[0], n[1], n[2], n[3], result);
}

void planes_of(const struct projection *projection, double planes[6])
{
    const float *n = projection->numbers;
    const bool is_symmetric = projection->volume == SYMMETRIC;
    const double z_near = (double)n[is_symmetric ? 2 : 4], z_far = (double)n[is_symmetric ? 3 : 5];
    for (int i = 0; i < 4; ++i)
        planes[i] = (double)n[i];
    if (is_symmetric) {
        planes[3] = z_near * tan(0.5 * (double)n[0]);
        planes[2] = -planes[3];
        planes[1] = planes[3] * (double)n[1];
        planes[0] = -planes[1];
    }
    planes[4] = z_near;
    planes[5] = projection->convention.infinite ? INFINITY : z_far;
}

/* Signs and ranges are those that the constructor accepts; now and then planes are so near to each
 * other that their differences cancel. */
static void constrain(struct theft *t, const struct projection_choice *choice, struct projection *p)
{
    float *n = p->numbers;
    float *const distances = p->volume == SYMMETRIC ? n + 2 : n + 4;
    const bool close = !choice->ordinary && theft_random_bits(t, 2) == 3;
    const float step = ldexpf(1.0f, -(int)theft_random_bits(t, 4) - 3);
    for (int i = 0; i < 6; i += 2) {
        if (close)
            n[i + 1] = n[i] + n[i] * step;
        if (choice->ordinary && i < 4)
            n[i + 1] = n[i] + fabsf(n[i + 1]) + fabsf(n[i]);
    }
    if (p->volume == SYMMETRIC) {
        n[0] = (float)(theft_random_bits(t, 24) ^ 0x800000u) * 0x1p-24f * GN_PI;
        n[1] = fabsf(n[1]);
    }
    if (p->volume != BOX || choice->ordinary) {
        distances[0] = fabsf(distances[0]);
        distances[1] = fabsf(distances[1]);
    }
    if (choice->ordinary) {
        if (p->volume == SYMMETRIC)
            n[0] = 0.25f + 0.5f * n[0];
        distances[1] = 1.5f * distances[0] + distances[1];
    }
}

enum theft_alloc_res make_projection(struct theft *t, void *env, void **output)
{
    const struct projection_choice *choice = env;
    struct projection *p = *output = allocated(sizeof *p);
    p->volume = (enum volume)(theft_random_bits(t, 8) % VOLUMES);
    p->convention.left_handed = theft_random_bits(t, 1) != 0;
    p->convention.zero_to_one = theft_random_bits(t, 1) != 0;
    p->convention.reversed = theft_random_bits(t, 1) != 0;
    p->convention.infinite = theft_random_bits(t, 1) != 0 && p->volume != BOX;
    for (int i = 0; i < 6; ++i)
        p->numbers[i] = random_number(t, choice->exponents);
    constrain(t, choice, p);
    const float *n = p->numbers;
    if (n[0] == 0.0f || n[0] == n[1] || n[2] == n[3] || n[4] == n[5]) {
        free(p);
        return THEFT_ALLOC_SKIP;
    }
    project_in(p, p->convention, &p->transform); /* if it fails, no property of the zeros holds */
    return THEFT_ALLOC_OK;
}

void print_projection(FILE *f, const void *instance, void *env)
{
    static const char *const names[VOLUMES] = {"orthographic", "frustum", "perspective"};
    const struct projection *p = instance;
    (void)env;
    fprintf(f, "%s %s %s%s%s", names[p->volume], p->convention.left_handed ? "lh" : "rh",
            p->convention.zero_to_one ? "zo" : "no", p->convention.infinite ? " infinite" : "",
            p->convention.reversed ? " reversed" : "");
    for (int i = 0; i < 6; ++i)
        fprintf(f, " %a", (double)p->numbers[i]);
    fprintf(f, "\n");
}
