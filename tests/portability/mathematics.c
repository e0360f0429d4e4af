/* Calls every function of the mathematics with random and special inputs, and hashes what each
 * returns and writes, by value. cross.sh checks that every public function is called here. */
#include "mathematics.h"

#include <gnomon.h>

#include "inputs.h"

#define MOST_RESULTS 320
#define BULK 37 /* more than two registers of any back end hold, and a rest */

/* A function's hash, over all inputs. */
typedef struct result {
    const char *function;
    hash hash;
} result;

/* The functions in the order of the calls, which is the same for every input. */
typedef struct results {
    result of[MOST_RESULTS];
    int count, at;
} results;

/* The hash of the next function. */
static hash *next_result(results *r, const char *function)
{
    result *const next = &r->of[r->at++];

    if (!next->function) {
        next->function = function;
        next->hash = HASH_EMPTY;
        ++r->count;
    }
    return &next->hash;
}

static void add_text(hash *h, const char *text)
{
    for (; text && *text; ++text)
        add_byte(h, (unsigned char)*text);
    add_byte(h, 0);
}

/* Arguments. */
#define F(n) (in->f[n])
#define V2(n) (in->v2[n])
#define V3(n) (in->v3[n])
#define V4(n) (in->v4[n])
#define Q(n) (in->q[n])
#define M3(n) (&in->m3[n])
#define M4(n) (&in->m4[n])
#define T(n) (&in->t[n])
#define BOX (&in->box)
#define RAY (&in->ray)

/* Hash bytes of floats that a function has written. */
#define ADD(function, floats, bytes) add_floats(next_result(r, #function), floats, bytes)

/* Call a function that returns floats, or a number. */
#define VALUE(type, function, ...)                                                                 \
    do {                                                                                           \
        const type value = function(__VA_ARGS__);                                                  \
        ADD(function, &value, sizeof value);                                                       \
    } while (0)
#define NUMBER(function, ...) add_word(next_result(r, #function), (uint32_t)function(__VA_ARGS__))

/* Call a function whose last argument points to its result. What it leaves unwritten is zero. */
#define WRITES(type, ...) WRITES_(type, __VA_ARGS__, &value)
#define WRITES_(type, function, ...)                                                               \
    do {                                                                                           \
        type value;                                                                                \
        function(__VA_ARGS__);                                                                     \
        ADD(function, &value, sizeof value);                                                       \
    } while (0)
#define STATUS(type, ...) STATUS_(type, 1, __VA_ARGS__, value)
#define STATUS_OF_ARRAY(type, count, ...) STATUS_(type, count, __VA_ARGS__, value)
#define STATUS_(type, count, function, ...)                                                        \
    do {                                                                                           \
        type value[count];                                                                         \
        hash *const h = next_result(r, #function);                                                 \
        memset(value, 0, sizeof value);                                                            \
        add_word(h, (uint32_t)function(__VA_ARGS__));                                              \
        add_floats(h, value, sizeof value);                                                        \
    } while (0)

/* Call an inverse that also writes its condition. */
#define INVERSE(type, function, m)                                                                 \
    do {                                                                                           \
        type value;                                                                                \
        float condition = 0.0f;                                                                    \
        hash *const h = next_result(r, #function);                                                 \
        memset(&value, 0, sizeof value);                                                           \
        add_word(h, (uint32_t)function(m, &value, &condition));                                    \
        add_floats(h, &value, sizeof value);                                                       \
        add_floats(h, &condition, sizeof condition);                                               \
    } while (0)

static void add_parts(results *r, const inputs *in)
{
    gn_vec3 part[2] = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}};
    gn_mat3 rotation;
    hash *const h = next_result(r, "gn_mat4_decompose_trs");

    memset(&rotation, 0, sizeof rotation);
    add_word(h, (uint32_t)gn_mat4_decompose_trs(M4(0), &part[0], &rotation, &part[1]));
    add_floats(h, part, sizeof part);
    add_floats(h, &rotation, sizeof rotation);
}

static void add_scalars(results *r, const inputs *in)
{
    float out[2];

    VALUE(float, gn_sqrt, F(0));
    VALUE(float, gn_rsqrt, F(0));
    VALUE(float, gn_sin, F(0));
    VALUE(float, gn_cos, F(0));
    gn_sincos(F(0), &out[0], &out[1]);
    ADD(gn_sincos, out, 2 * sizeof out[0]);
    VALUE(float, gn_tan, F(0));
    VALUE(float, gn_asin, F(0));
    VALUE(float, gn_acos, F(0));
    VALUE(float, gn_atan, F(0));
    VALUE(float, gn_atan2, F(0), F(1));
    VALUE(float, gn_floor, F(0));
    VALUE(float, gn_ceil, F(0));
    VALUE(float, gn_round, F(0));
    VALUE(float, gn_fract, F(0));
    VALUE(float, gn_clamp, F(0), F(1), F(2));
    VALUE(float, gn_mix, F(0), F(1), F(2));
    VALUE(float, gn_degrees, F(0));
    VALUE(float, gn_radians, F(0));
    VALUE(float, gn_exp2, F(0));
    VALUE(float, gn_exp, F(0));
    VALUE(float, gn_log2, F(0));
    VALUE(float, gn_log, F(0));
    VALUE(float, gn_pow, F(0), F(1));
}

static void add_vectors(results *r, const inputs *in)
{
    VALUE(gn_vec2, gn_vec2_add, V2(0), V2(1));
    VALUE(gn_vec3, gn_vec3_add, V3(0), V3(1));
    VALUE(gn_vec4, gn_vec4_add, V4(0), V4(1));
    VALUE(gn_vec2, gn_vec2_subtract, V2(0), V2(1));
    VALUE(gn_vec3, gn_vec3_subtract, V3(0), V3(1));
    VALUE(gn_vec4, gn_vec4_subtract, V4(0), V4(1));
    VALUE(gn_vec2, gn_vec2_multiply, V2(0), V2(1));
    VALUE(gn_vec3, gn_vec3_multiply, V3(0), V3(1));
    VALUE(gn_vec4, gn_vec4_multiply, V4(0), V4(1));
    VALUE(gn_vec2, gn_vec2_negate, V2(0));
    VALUE(gn_vec3, gn_vec3_negate, V3(0));
    VALUE(gn_vec4, gn_vec4_negate, V4(0));
    VALUE(gn_vec2, gn_vec2_scale, V2(0), F(0));
    VALUE(gn_vec3, gn_vec3_scale, V3(0), F(0));
    VALUE(gn_vec4, gn_vec4_scale, V4(0), F(0));
    VALUE(gn_vec2, gn_vec2_minimum, V2(0), V2(1));
    VALUE(gn_vec3, gn_vec3_minimum, V3(0), V3(1));
    VALUE(gn_vec4, gn_vec4_minimum, V4(0), V4(1));
    VALUE(gn_vec2, gn_vec2_maximum, V2(0), V2(1));
    VALUE(gn_vec3, gn_vec3_maximum, V3(0), V3(1));
    VALUE(gn_vec4, gn_vec4_maximum, V4(0), V4(1));
    VALUE(gn_vec2, gn_vec2_clamp, V2(0), F(0), F(1));
    VALUE(gn_vec3, gn_vec3_clamp, V3(0), F(0), F(1));
    VALUE(gn_vec4, gn_vec4_clamp, V4(0), F(0), F(1));
    VALUE(float, gn_vec2_dot, V2(0), V2(1));
    VALUE(float, gn_vec3_dot, V3(0), V3(1));
    VALUE(float, gn_vec4_dot, V4(0), V4(1));
    VALUE(float, gn_vec2_cross, V2(0), V2(1));
    VALUE(gn_vec3, gn_vec3_cross, V3(0), V3(1));
    VALUE(float, gn_vec2_length, V2(0));
    VALUE(float, gn_vec3_length, V3(0));
    VALUE(float, gn_vec4_length, V4(0));
    VALUE(float, gn_vec2_distance, V2(0), V2(1));
    VALUE(float, gn_vec3_distance, V3(0), V3(1));
    VALUE(float, gn_vec4_distance, V4(0), V4(1));
    STATUS(gn_vec2, gn_vec2_normalize, V2(0));
    STATUS(gn_vec3, gn_vec3_normalize, V3(0));
    STATUS(gn_vec4, gn_vec4_normalize, V4(0));
    STATUS(float, gn_vec3_angle, V3(0), V3(1));
    VALUE(gn_vec2, gn_vec2_mix, V2(0), V2(1), F(0));
    VALUE(gn_vec3, gn_vec3_mix, V3(0), V3(1), F(0));
    VALUE(gn_vec4, gn_vec4_mix, V4(0), V4(1), F(0));
    VALUE(gn_vec2, gn_vec2_reflect, V2(0), V2(1));
    VALUE(gn_vec3, gn_vec3_reflect, V3(0), V3(1));
    VALUE(gn_vec4, gn_vec4_reflect, V4(0), V4(1));
    VALUE(gn_vec2, gn_vec2_refract, V2(0), V2(1), F(0));
    VALUE(gn_vec3, gn_vec3_refract, V3(0), V3(1), F(0));
    VALUE(gn_vec4, gn_vec4_refract, V4(0), V4(1), F(0));
}

/* The inline functions of shaders, compiled as a user compiles them. */
static void add_shader_vectors(results *r, const inputs *in)
{
    VALUE(gn_vec2, gn_make2, F(0), F(1));
    VALUE(gn_vec3, gn_make3, F(0), F(1), F(2));
    VALUE(gn_vec4, gn_make4, F(0), F(1), F(2), F(3));
    VALUE(gn_vec4, gn_extend3, V3(0), F(0));
    VALUE(gn_vec2, gn_xy4, V4(0));
    VALUE(gn_vec3, gn_xyz4, V4(0));
    VALUE(gn_vec2, gn_add2, V2(0), V2(1));
    VALUE(gn_vec3, gn_add3, V3(0), V3(1));
    VALUE(gn_vec4, gn_add4, V4(0), V4(1));
    VALUE(gn_vec2, gn_subtract2, V2(0), V2(1));
    VALUE(gn_vec3, gn_subtract3, V3(0), V3(1));
    VALUE(gn_vec4, gn_subtract4, V4(0), V4(1));
    VALUE(gn_vec2, gn_multiply2, V2(0), V2(1));
    VALUE(gn_vec3, gn_multiply3, V3(0), V3(1));
    VALUE(gn_vec4, gn_multiply4, V4(0), V4(1));
    VALUE(gn_vec2, gn_negate2, V2(0));
    VALUE(gn_vec3, gn_negate3, V3(0));
    VALUE(gn_vec4, gn_negate4, V4(0));
    VALUE(gn_vec2, gn_scale2, V2(0), F(0));
    VALUE(gn_vec3, gn_scale3, V3(0), F(0));
    VALUE(gn_vec4, gn_scale4, V4(0), F(0));
    VALUE(float, gn_from_bits1, gn_to_bits1(F(0)));
    VALUE(float, gn_select1, F(0) < F(1), F(0), F(1));
    VALUE(gn_vec2, gn_select2, F(0) < F(1), V2(0), V2(1));
    VALUE(gn_vec3, gn_select3, F(0) < F(1), V3(0), V3(1));
    VALUE(gn_vec4, gn_select4, F(0) < F(1), V4(0), V4(1));
    VALUE(float, gn_minimum1, F(0), F(1));
    VALUE(float, gn_maximum1, F(0), F(1));
    VALUE(gn_vec2, gn_minimum2, V2(0), V2(1));
    VALUE(gn_vec3, gn_minimum3, V3(0), V3(1));
    VALUE(gn_vec4, gn_minimum4, V4(0), V4(1));
    VALUE(gn_vec2, gn_maximum2, V2(0), V2(1));
    VALUE(gn_vec3, gn_maximum3, V3(0), V3(1));
    VALUE(gn_vec4, gn_maximum4, V4(0), V4(1));
    VALUE(float, gn_clamp1, F(0), F(1), F(2));
    VALUE(gn_vec2, gn_clamp2, V2(0), F(0), F(1));
    VALUE(gn_vec3, gn_clamp3, V3(0), F(0), F(1));
    VALUE(gn_vec4, gn_clamp4, V4(0), F(0), F(1));
    VALUE(float, gn_saturate1, F(0));
    VALUE(gn_vec2, gn_saturate2, V2(0));
    VALUE(gn_vec3, gn_saturate3, V3(0));
    VALUE(gn_vec4, gn_saturate4, V4(0));
    VALUE(float, gn_mix1, F(0), F(1), F(2));
    VALUE(gn_vec2, gn_mix2, V2(0), V2(1), F(0));
    VALUE(gn_vec3, gn_mix3, V3(0), V3(1), F(0));
    VALUE(gn_vec4, gn_mix4, V4(0), V4(1), F(0));
    VALUE(float, gn_dot2, V2(0), V2(1));
    VALUE(float, gn_dot3, V3(0), V3(1));
    VALUE(float, gn_dot4, V4(0), V4(1));
    VALUE(gn_vec3, gn_cross3, V3(0), V3(1));
    VALUE(float, gn_sqrt1, F(0));
    VALUE(float, gn_length2, V2(0));
    VALUE(float, gn_length3, V3(0));
    VALUE(float, gn_length4, V4(0));
    VALUE(gn_vec2, gn_normalize2, V2(0));
    VALUE(gn_vec3, gn_normalize3, V3(0));
    VALUE(gn_vec4, gn_normalize4, V4(0));
    VALUE(gn_vec2, gn_reflect2, V2(0), V2(1));
    VALUE(gn_vec3, gn_reflect3, V3(0), V3(1));
    VALUE(gn_vec4, gn_reflect4, V4(0), V4(1));
    VALUE(gn_vec3, gn_multiply_mat3, M3(0), V3(0));
    VALUE(gn_vec4, gn_multiply_mat4, M4(0), V4(0));
    VALUE(float, gn_power1, F(0), in->number & 127);
}

static void add_matrices(results *r, const inputs *in)
{
    float out[16];

    WRITES(gn_mat3, gn_mat3_identity);
    WRITES(gn_mat4, gn_mat4_identity);
    WRITES(gn_mat3, gn_mat3_multiply, M3(0), M3(1));
    WRITES(gn_mat4, gn_mat4_multiply, M4(0), M4(1));
    VALUE(gn_vec3, gn_mat3_multiply_vec3, M3(0), V3(0));
    VALUE(gn_vec4, gn_mat4_multiply_vec4, M4(0), V4(0));
    VALUE(gn_vec3, gn_mat4_transform_point, M4(0), V3(0));
    VALUE(gn_vec3, gn_mat4_transform_direction, M4(0), V3(0));
    WRITES(gn_mat3, gn_mat3_from_rows, in->raw);
    WRITES(gn_mat4, gn_mat4_from_rows, in->raw);
    gn_mat3_to_rows(M3(0), out);
    ADD(gn_mat3_to_rows, out, 9 * sizeof out[0]);
    gn_mat4_to_rows(M4(0), out);
    ADD(gn_mat4_to_rows, out, 16 * sizeof out[0]);
    WRITES(gn_mat4, gn_mat4_from_mat3, M3(0));
    WRITES(gn_mat3, gn_mat3_transpose, M3(0));
    WRITES(gn_mat4, gn_mat4_transpose, M4(0));
    VALUE(float, gn_mat3_trace, M3(0));
    VALUE(float, gn_mat4_trace, M4(0));
    VALUE(float, gn_mat3_determinant, M3(0));
    VALUE(float, gn_mat4_determinant, M4(0));
    INVERSE(gn_mat3, gn_mat3_invert, M3(0));
    INVERSE(gn_mat4, gn_mat4_invert, M4(0));
    WRITES(gn_mat4, gn_mat4_invert_rigid, M4(0));
    WRITES(gn_mat3, gn_mat4_upper_left, M4(0));
    STATUS(gn_mat4, gn_mat4_invert_trs, M4(0));
    STATUS(gn_mat4, gn_mat4_invert_affine, M4(0));
    STATUS(gn_mat4, gn_mat4_invert_orthographic, M4(0));
    STATUS(gn_mat4, gn_mat4_invert_perspective, M4(0));
    STATUS(gn_mat3, gn_mat4_normal_matrix, M4(0));
    add_parts(r, in);
}

static void add_quaternions(results *r, const inputs *in)
{
    const gn_quat identity = gn_quat_identity();

    ADD(gn_quat_identity, &identity, sizeof identity);
    STATUS(gn_quat, gn_quat_from_axis_angle, V3(0), F(0));
    STATUS(gn_quat, gn_quat_from_mat3, M3(0));
    STATUS(gn_quat, gn_quat_from_directions, V3(0), V3(1));
    STATUS(gn_quat, gn_quat_look_rh, V3(0), V3(1));
    STATUS(gn_mat3, gn_quat_to_mat3, Q(0));
    STATUS(gn_mat4, gn_quat_to_mat4, Q(0));
    VALUE(gn_vec3, gn_quat_rotate, Q(0), V3(0));
    VALUE(gn_quat, gn_quat_multiply, Q(0), Q(1));
    VALUE(gn_quat, gn_quat_conjugate, Q(0));
    STATUS(gn_quat, gn_quat_invert, Q(0));
    VALUE(float, gn_quat_dot, Q(0), Q(1));
    STATUS(gn_quat, gn_quat_normalize, Q(0));
    STATUS(gn_quat, gn_quat_slerp, Q(0), Q(1), F(0));
    STATUS(gn_quat, gn_quat_nlerp, Q(0), Q(1), F(0));
}

static void add_transforms(results *r, const inputs *in)
{
    STATUS(gn_transform, gn_transform_identity);
    STATUS(gn_transform, gn_translate, V3(0));
    STATUS(gn_transform, gn_scale, V3(0));
    STATUS(gn_transform, gn_rotate_x, F(0));
    STATUS(gn_transform, gn_rotate_y, F(0));
    STATUS(gn_transform, gn_rotate_z, F(0));
    STATUS(gn_transform, gn_rotate_axis, V3(0), F(0));
    STATUS(gn_transform, gn_frame_orthonormal, V3(0), V3(1), V3(2), V3(3));
    STATUS(gn_transform, gn_frame_general, V3(0), V3(1), V3(2), V3(3));
    STATUS(gn_transform, gn_affine, M3(0), V3(0));
    STATUS(gn_transform, gn_trs, V3(0), M3(0), V3(1));
    STATUS(gn_transform, gn_look_at_rh, V3(0), V3(1), V3(2));
    STATUS(gn_transform, gn_look_at_lh, V3(0), V3(1), V3(2));
    STATUS(gn_transform, gn_look_to_rh, V3(0), V3(1), V3(2));
    STATUS(gn_transform, gn_look_to_lh, V3(0), V3(1), V3(2));
    STATUS(gn_transform, gn_transform_compose, T(0), T(1));
    STATUS(gn_transform, gn_transform_invert, T(0));
    STATUS(gn_mat3, gn_transform_normal_matrix, T(0));
    STATUS(gn_transform, gn_clip_no_to_zo);
    STATUS(gn_transform, gn_clip_zo_to_no);
    STATUS(gn_transform, gn_clip_reverse_zo);
    STATUS(gn_transform, gn_flip_y);
    STATUS(gn_transform, gn_flip_z);
    STATUS(gn_vec3, gn_clip_to_ndc, V4(0));
    STATUS(gn_vec3, gn_project, T(0), T(1), V3(0));
    STATUS(gn_vec3, gn_unproject, T(0), T(1), V3(0));
}

static void add_projections(results *r, const inputs *in)
{
    STATUS(gn_transform, gn_orthographic_rh_no, F(0), F(1), F(2), F(3), F(4), F(5));
    STATUS(gn_transform, gn_orthographic_rh_zo, F(0), F(1), F(2), F(3), F(4), F(5));
    STATUS(gn_transform, gn_orthographic_lh_no, F(0), F(1), F(2), F(3), F(4), F(5));
    STATUS(gn_transform, gn_orthographic_lh_zo, F(0), F(1), F(2), F(3), F(4), F(5));
    STATUS(gn_transform, gn_orthographic_rh_no_reversed, F(0), F(1), F(2), F(3), F(4), F(5));
    STATUS(gn_transform, gn_orthographic_rh_zo_reversed, F(0), F(1), F(2), F(3), F(4), F(5));
    STATUS(gn_transform, gn_orthographic_lh_no_reversed, F(0), F(1), F(2), F(3), F(4), F(5));
    STATUS(gn_transform, gn_orthographic_lh_zo_reversed, F(0), F(1), F(2), F(3), F(4), F(5));
    STATUS(gn_transform, gn_viewport_no, F(0), F(1), F(2), F(3), F(4), F(5));
    STATUS(gn_transform, gn_viewport_zo, F(0), F(1), F(2), F(3), F(4), F(5));
    STATUS(gn_transform, gn_viewport_no_y_down, F(0), F(1), F(2), F(3), F(4), F(5));
    STATUS(gn_transform, gn_viewport_zo_y_down, F(0), F(1), F(2), F(3), F(4), F(5));
}

static void add_frusta(results *r, const inputs *in)
{
    STATUS(gn_transform, gn_frustum_rh_no, F(0), F(1), F(2), F(3), F(4), F(5));
    STATUS(gn_transform, gn_frustum_rh_zo, F(0), F(1), F(2), F(3), F(4), F(5));
    STATUS(gn_transform, gn_frustum_lh_no, F(0), F(1), F(2), F(3), F(4), F(5));
    STATUS(gn_transform, gn_frustum_lh_zo, F(0), F(1), F(2), F(3), F(4), F(5));
    STATUS(gn_transform, gn_frustum_rh_no_reversed, F(0), F(1), F(2), F(3), F(4), F(5));
    STATUS(gn_transform, gn_frustum_rh_zo_reversed, F(0), F(1), F(2), F(3), F(4), F(5));
    STATUS(gn_transform, gn_frustum_lh_no_reversed, F(0), F(1), F(2), F(3), F(4), F(5));
    STATUS(gn_transform, gn_frustum_lh_zo_reversed, F(0), F(1), F(2), F(3), F(4), F(5));
    STATUS(gn_transform, gn_frustum_rh_no_infinite, F(0), F(1), F(2), F(3), F(4));
    STATUS(gn_transform, gn_frustum_rh_zo_infinite, F(0), F(1), F(2), F(3), F(4));
    STATUS(gn_transform, gn_frustum_lh_no_infinite, F(0), F(1), F(2), F(3), F(4));
    STATUS(gn_transform, gn_frustum_lh_zo_infinite, F(0), F(1), F(2), F(3), F(4));
    STATUS(gn_transform, gn_frustum_rh_no_infinite_reversed, F(0), F(1), F(2), F(3), F(4));
    STATUS(gn_transform, gn_frustum_rh_zo_infinite_reversed, F(0), F(1), F(2), F(3), F(4));
    STATUS(gn_transform, gn_frustum_lh_no_infinite_reversed, F(0), F(1), F(2), F(3), F(4));
    STATUS(gn_transform, gn_frustum_lh_zo_infinite_reversed, F(0), F(1), F(2), F(3), F(4));
}

static void add_perspectives(results *r, const inputs *in)
{
    STATUS(gn_transform, gn_perspective_rh_no, F(0), F(1), F(2), F(3));
    STATUS(gn_transform, gn_perspective_rh_zo, F(0), F(1), F(2), F(3));
    STATUS(gn_transform, gn_perspective_lh_no, F(0), F(1), F(2), F(3));
    STATUS(gn_transform, gn_perspective_lh_zo, F(0), F(1), F(2), F(3));
    STATUS(gn_transform, gn_perspective_rh_no_reversed, F(0), F(1), F(2), F(3));
    STATUS(gn_transform, gn_perspective_rh_zo_reversed, F(0), F(1), F(2), F(3));
    STATUS(gn_transform, gn_perspective_lh_no_reversed, F(0), F(1), F(2), F(3));
    STATUS(gn_transform, gn_perspective_lh_zo_reversed, F(0), F(1), F(2), F(3));
    STATUS(gn_transform, gn_perspective_rh_no_infinite, F(0), F(1), F(2));
    STATUS(gn_transform, gn_perspective_rh_zo_infinite, F(0), F(1), F(2));
    STATUS(gn_transform, gn_perspective_lh_no_infinite, F(0), F(1), F(2));
    STATUS(gn_transform, gn_perspective_lh_zo_infinite, F(0), F(1), F(2));
    STATUS(gn_transform, gn_perspective_rh_no_infinite_reversed, F(0), F(1), F(2));
    STATUS(gn_transform, gn_perspective_rh_zo_infinite_reversed, F(0), F(1), F(2));
    STATUS(gn_transform, gn_perspective_lh_no_infinite_reversed, F(0), F(1), F(2));
    STATUS(gn_transform, gn_perspective_lh_zo_infinite_reversed, F(0), F(1), F(2));
    add_text(next_result(r, "gn_perspective_fault"), gn_perspective_fault(F(0), F(1), F(2), F(3)));
}

static void add_geometry(results *r, const inputs *in)
{
    STATUS_OF_ARRAY(gn_plane, GN_PLANE_COUNT, gn_frustum_planes_no, M4(0));
    STATUS_OF_ARRAY(gn_plane, GN_PLANE_COUNT, gn_frustum_planes_zo, M4(0));
    NUMBER(gn_cull_box, in->plane, BOX);
    NUMBER(gn_cull_sphere, in->plane, V3(0), F(0));
    STATUS(gn_box, gn_mat4_transform_box, M4(0), BOX);
    STATUS(gn_ray, gn_ray_through_pixel_no, T(0), T(1), T(2), F(0), F(1));
    STATUS(gn_ray, gn_ray_through_pixel_zo, T(0), T(1), T(2), F(0), F(1));
    STATUS(gn_ray, gn_ray_through_pixel_reversed, T(0), T(1), T(2), F(0), F(1));
    STATUS(gn_ray_hit, gn_ray_hits_triangle, RAY, V3(0), V3(1), V3(2));
    STATUS(gn_ray_hit, gn_ray_hits_triangle_front, RAY, V3(0), V3(1), V3(2));
    STATUS(gn_ray_span, gn_ray_hits_box, RAY, BOX);
    STATUS(gn_vec3, gn_barycentric_2d, V2(0), V2(1), V2(2), V2(3));
    STATUS(gn_vec3, gn_barycentric_3d, V3(0), V3(1), V3(2), V3(3));
}

/* Vectors and matrices of a round for the functions that take many, packed and in arrays. */
typedef struct bulk {
    gn_vec3 v3[BULK];
    gn_vec4 v4[BULK];
    gn_mat4 a[BULK], b[BULK];
    float component[4][BULK];
    gn_vec3 r3[BULK];
    gn_vec4 r4[BULK];
    gn_mat4 product[BULK];
    float written[4][BULK];
} bulk;

static void make_bulk(random_source *r, kind k, bulk *b, hash *made)
{
    fill(r, k, b->v3, sizeof b->v3, made);
    fill(r, k, b->v4, sizeof b->v4, made);
    fill(r, k, b->a, sizeof b->a, made);
    fill(r, k, b->b, sizeof b->b, made);
    fill(r, k, b->component, sizeof b->component, made);
}

#define PACKED(function, m, vectors, out)                                                          \
    do {                                                                                           \
        hash *const h = next_result(r, #function);                                                 \
        add_word(h, (uint32_t)function(m, vectors, out, BULK, backend));                           \
        add_floats(h, out, sizeof out);                                                            \
    } while (0)
#define ARRAYS(function, m)                                                                        \
    do {                                                                                           \
        hash *const h = next_result(r, #function);                                                 \
        add_word(h, (uint32_t)function(m, from, to, BULK, backend));                               \
        add_floats(h, b->written, sizeof b->written);                                              \
    } while (0)

static void add_bulk(results *r, const inputs *in, bulk *b, gn_backend backend)
{
    const float *const from[4] = {b->component[0], b->component[1], b->component[2],
                                  b->component[3]};
    float *const to[4] = {b->written[0], b->written[1], b->written[2], b->written[3]};

    memset(b->written, 0, sizeof b->written);
    PACKED(gn_mat4_multiply_vec4_packed, M4(0), b->v4, b->r4);
    ARRAYS(gn_mat4_multiply_vec4_arrays, M4(0));
    PACKED(gn_mat4_multiply_packed, b->a, b->b, b->product);
    PACKED(gn_mat4_transform_point_packed, M4(0), b->v3, b->r3);
    ARRAYS(gn_mat4_transform_point_arrays, M4(0));
    PACKED(gn_mat4_transform_direction_packed, M4(0), b->v3, b->r3);
    ARRAYS(gn_mat4_transform_direction_arrays, M4(0));
    PACKED(gn_mat3_multiply_vec3_packed, M3(0), b->v3, b->r3);
    ARRAYS(gn_mat3_multiply_vec3_arrays, M3(0));
}

static void print_results(const results *r, const char *backend)
{
    for (int i = 0; i < r->count; ++i)
        print_hash("", r->of[i].function, backend, r->of[i].hash);
}

void print_mathematics(uint64_t seed, uint64_t rounds)
{
    static results all, of_bulk[GN_BACKEND_COUNT];
    static inputs in;
    static bulk b;
    random_source source = random_seed(seed);
    hash made = HASH_EMPTY;

    for (uint64_t i = 0; i < rounds; ++i) {
        const kind k = (kind)(i % KINDS);

        make_inputs(&source, k, &in, &made);
        all.at = 0;
        add_scalars(&all, &in);
        add_vectors(&all, &in);
        add_shader_vectors(&all, &in);
        add_matrices(&all, &in);
        add_quaternions(&all, &in);
        add_transforms(&all, &in);
        add_projections(&all, &in);
        add_frusta(&all, &in);
        add_perspectives(&all, &in);
        add_geometry(&all, &in);
        make_bulk(&source, k, &b, &made);
        for (int n = GN_BACKEND_PORTABLE; n < GN_BACKEND_COUNT; ++n) {
            of_bulk[n].at = 0;
            if (gn_backend_available((gn_backend)n))
                add_bulk(&of_bulk[n], &in, &b, (gn_backend)n);
        }
    }
    if (rounds > 0)
        print_hash("", "arguments", "inputs", made);
    print_results(&all, "portable");
    for (int n = GN_BACKEND_PORTABLE; n < GN_BACKEND_COUNT; ++n)
        print_results(&of_bulk[n], gn_backend_name((gn_backend)n));
}
