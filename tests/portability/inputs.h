/* Arguments for the functions of the mathematics: random, special and proper ones. */
#ifndef PORTABILITY_INPUTS_H
#define PORTABILITY_INPUTS_H

#include <gnomon.h>

#include "hash.h"
#include "random.h"

/* The arguments of one round of calls. */
typedef struct inputs {
    float f[8];
    gn_vec2 v2[4];
    gn_vec3 v3[4];
    gn_vec4 v4[2];
    gn_quat q[2];
    gn_mat3 m3[2];
    gn_mat4 m4[2];
    gn_transform t[3]; /* projection, view, viewport */
    gn_box box;
    gn_ray ray;
    gn_plane plane[GN_PLANE_COUNT];
    float raw[16];
    uint32_t number;
} inputs;

/* What the numbers of a round are. The last four kinds begin as MODERATE ones. */
typedef enum kind {
    MODERATE,     /* of magnitudes about 1 */
    ANY_BITS,     /* every float alike, also NaN and denormals */
    SPECIAL,      /* zeros, infinities, NaN, limits */
    WHOLE,        /* small whole numbers: sums cancel, arguments are equal */
    PLACED,       /* matrices T R S, unit quaternions, cameras */
    AFFINE,       /* affine matrices */
    ORTHOGRAPHIC, /* orthographic projections */
    PERSPECTIVE,  /* perspective projections, frusta */
    KINDS
} kind;

static const uint32_t special[] = {
    0x00000000, 0x80000000, 0x3F800000, 0xBF800000, 0x7F800000, 0xFF800000, 0x7FC00000, 0xFFC00001,
    0x00000001, 0x80000001, 0x007FFFFF, 0x00800000, 0x7F7FFFFF, 0xFF7FFFFF, 0x3F000000, 0xBF000000,
    0x3F7FFFFF, 0x3F800001, 0x40490FDB, 0x3FC90FDB, 0xC0490FDB, 0x4B000000, 0x4B7FFFFF, 0xCB800000,
    0x4F000000, 0x5F000000, 0x5F800000, 0x20000000, 0x42B17218, 0xC2CFF1B5, 0x43000000, 0xC3160000};

static float number(random_source *r, kind k)
{
    if (k == WHOLE)
        return (float)random_between(r, -4, 4);
    if (k == ANY_BITS || k == SPECIAL) {
        const uint32_t bits = k == ANY_BITS
                                  ? (uint32_t)random_bits(r)
                                  : special[random_below(r, sizeof special / sizeof special[0])];
        float f;
        memcpy(&f, &bits, sizeof f);
        return f;
    }
    return random_signed_octave(r, -3, 3);
}

static void fill(random_source *r, kind k, void *floats, size_t bytes, hash *made)
{
    for (size_t i = 0; i < bytes / sizeof(float); ++i) {
        const float f = number(r, k);
        memcpy((char *)floats + i * sizeof f, &f, sizeof f);
    }
    add_words(made, floats, bytes / sizeof(float));
}

/* Makes arguments that constructors return, so that functions for such arguments succeed. */
static void make_proper(inputs *in, kind k)
{
    gn_quat turn = in->q[0];
    const float *const f = in->f;

    for (int i = 0; i < 2; ++i)
        gn_quat_normalize(in->q[i], &in->q[i]);
    gn_quat_normalize(turn, &turn);
    gn_quat_to_mat3(turn, &in->m3[0]);
    gn_trs(in->v3[0], &in->m3[0], in->v3[1], &in->t[1]);
    in->m4[0] = in->t[1].matrix;
    if (k == AFFINE) {
        gn_affine(&in->m3[1], in->v3[2], &in->t[1]);
        in->m4[0] = in->t[1].matrix;
    }
    gn_viewport_no(f[0], f[1], 64.0f, 48.0f, 0.0f, 1.0f, &in->t[2]);
    if (k == ORTHOGRAPHIC)
        gn_orthographic_rh_no(f[0], f[1], f[2], f[3], f[4], f[5], &in->t[0]);
    else
        gn_perspective_rh_zo(1.0f, 1.5f, 0.25f, 100.0f, &in->t[0]);
    if (k == ORTHOGRAPHIC || k == PERSPECTIVE)
        in->m4[0] = in->t[0].matrix;
    gn_frustum_planes_zo(&in->t[0].matrix, in->plane);
    for (int i = 0; i < 2; ++i)
        in->f[i] = i == 0 ? 0.75f + 0.125f * (float)(in->number & 7) : 1.25f;
    in->f[2] = 0.5f;
    in->f[3] = 8.0f;
}

/* Makes the arguments of a round and hashes them, without those that functions make. */
static void make_inputs(random_source *r, kind k, inputs *in, hash *made)
{
    memset(in, 0, sizeof *in);
    in->number = (uint32_t)random_bits(r);
    add_word(made, in->number);
    fill(r, k, in->f, sizeof in->f, made);
    fill(r, k, in->v2, sizeof in->v2, made);
    fill(r, k, in->v3, sizeof in->v3, made);
    fill(r, k, in->v4, sizeof in->v4, made);
    fill(r, k, in->q, sizeof in->q, made);
    fill(r, k, in->m3, sizeof in->m3, made);
    fill(r, k, in->m4, sizeof in->m4, made);
    fill(r, k, in->t, sizeof in->t, made);
    fill(r, k, &in->box, sizeof in->box, made);
    fill(r, k, &in->ray, sizeof in->ray, made);
    fill(r, k, in->plane, sizeof in->plane, made);
    fill(r, k, in->raw, sizeof in->raw, made);
    if (k >= PLACED)
        make_proper(in, k);
}

#endif
