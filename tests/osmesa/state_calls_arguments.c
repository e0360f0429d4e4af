/* Random arguments of calls that set state, right and wrong ones. */
#include "state_calls.h"

/* Enumerations that functions take, valid somewhere. */
static const GLenum values[] = {
    GL_NEVER,
    GL_LESS,
    GL_EQUAL,
    GL_LEQUAL,
    GL_GREATER,
    GL_NOTEQUAL,
    GL_GEQUAL,
    GL_ALWAYS,
    GL_FRONT,
    GL_BACK,
    GL_FRONT_AND_BACK,
    GL_LEFT,
    GL_RIGHT,
    GL_FRONT_LEFT,
    GL_AUX0,
    GL_NONE,
    GL_CW,
    GL_CCW,
    GL_POINT,
    GL_LINE,
    GL_FILL,
    GL_FLAT,
    GL_SMOOTH,
    GL_KEEP,
    GL_REPLACE,
    GL_INCR,
    GL_DECR,
    GL_INVERT,
    GL_INCR_WRAP,
    GL_DECR_WRAP,
    GL_ONE,
    GL_SRC_COLOR,
    GL_ONE_MINUS_SRC_COLOR,
    GL_SRC_ALPHA,
    GL_ONE_MINUS_SRC_ALPHA,
    GL_DST_ALPHA,
    GL_ONE_MINUS_DST_ALPHA,
    GL_DST_COLOR,
    GL_ONE_MINUS_DST_COLOR,
    GL_SRC_ALPHA_SATURATE,
    GL_CONSTANT_COLOR,
    GL_CONSTANT_ALPHA,
    GL_FUNC_ADD,
    GL_FUNC_SUBTRACT,
    GL_FUNC_REVERSE_SUBTRACT,
    GL_MIN,
    GL_MAX,
    GL_CLEAR,
    GL_AND,
    GL_XOR,
    GL_SET,
    GL_MODELVIEW,
    GL_PROJECTION,
    GL_TEXTURE,
    GL_DONT_CARE,
    GL_FASTEST,
    GL_NICEST,
    GL_BYTE,
    GL_UNSIGNED_BYTE,
    GL_SHORT,
    GL_UNSIGNED_SHORT,
    GL_INT,
    GL_UNSIGNED_INT,
    GL_FLOAT,
    GL_DOUBLE,
    GL_FOG_HINT,
    GL_POLYGON_SMOOTH_HINT,
    GL_TEXTURE0,
    GL_TEXTURE1,
    GL_TEXTURE3,
    12345,
};

static const GLenum switches[] = {
    GL_NORMALIZE,
    GL_CLIP_PLANE0,
    GL_CLIP_PLANE5,
    GL_CLIP_DISTANCE7,
    GL_LIGHTING,
    GL_LIGHT7,
    GL_TEXTURE_1D,
    GL_TEXTURE_2D,
    GL_TEXTURE_GEN_S,
    GL_TEXTURE_GEN_Q,
    GL_COLOR_MATERIAL,
    GL_FOG,
    GL_COLOR_SUM,
    GL_RESCALE_NORMAL,
    GL_POINT_SMOOTH,
    GL_LINE_SMOOTH,
    GL_LINE_STIPPLE,
    GL_POLYGON_SMOOTH,
    GL_POLYGON_STIPPLE,
    GL_CULL_FACE,
    GL_POLYGON_OFFSET_FILL,
    GL_POLYGON_OFFSET_LINE,
    GL_POLYGON_OFFSET_POINT,
    GL_SCISSOR_TEST,
    GL_ALPHA_TEST,
    GL_STENCIL_TEST,
    GL_DEPTH_TEST,
    GL_BLEND,
    GL_DITHER,
    GL_COLOR_LOGIC_OP,
    GL_INDEX_LOGIC_OP,
    GL_MULTISAMPLE,
    GL_SAMPLE_ALPHA_TO_COVERAGE,
    GL_SAMPLE_ALPHA_TO_ONE,
    GL_SAMPLE_COVERAGE,
    GL_AUTO_NORMAL,
    GL_MAP1_INDEX,
    GL_MAP2_TEXTURE_COORD_4,
    12345,
    GL_VERTEX_ARRAY,
    GL_NORMAL_ARRAY,
    GL_COLOR_ARRAY,
    GL_TEXTURE_COORD_ARRAY,
    GL_EDGE_FLAG_ARRAY,
    GL_INDEX_ARRAY,
    GL_SECONDARY_COLOR_ARRAY,
    GL_FOG_COORDINATE_ARRAY,
};

static GLint random_integer(random_source *r)
{
    switch (random_below(r, 5)) {
    case 0:
        return (GLint)random_bits(r);
    case 1:
        return random_between(r, -2, 9);
    case 2:
        return 1 << random_below(r, 4);
    default:
        return random_between(r, -300, 300);
    }
}

void choose_arguments(random_source *r, arguments *a)
{
    for (int k = 0; k < 4; ++k) {
        a->e[k] = values[random_below(r, sizeof values / sizeof *values)];
        a->i[k] = random_integer(r);
    }
    a->stride = random_between(r, -1, 2048);
    a->name = switches[random_below(r, sizeof switches / sizeof *switches)];
    for (int k = 0; k < 16; ++k) {
        const float wide = random_signed_octave(r, -8, 8), near = random_float(r, -1.5f, 1.5f);

        a->f[k] = random_chance(r, 5) ? 0.0f : random_chance(r, 60) ? near : wide;
        a->d[k] = random_chance(r, 5) ? 1.0 : (GLdouble)a->f[k] * 1.1;
    }
}
