/* The rows of the tables computed with GLM, by its functions that name their convention. Its scalar
 * functions are the C library's. */
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/gtx/euler_angles.hpp>
#include <glm/gtx/exterior_product.hpp>
#include <glm/gtx/intersect.hpp>
#include <glm/gtx/matrix_decompose.hpp>
#include <glm/gtx/quaternion.hpp>

#include <limits>

#include "peers.h"

namespace
{

template <typename T> T of(const float *in)
{
    T value;
    for (int i = 0; i < static_cast<int>(sizeof value / sizeof *in); ++i)
        glm::value_ptr(value)[i] = in[i];
    return value;
}

template <typename T> void put(const T &value, float *out)
{
    for (int i = 0; i < static_cast<int>(sizeof value / sizeof *out); ++i)
        out[i] = glm::value_ptr(value)[i];
}

glm::quat quat(const float *in)
{
    return glm::quat(in[3], in[0], in[1], in[2]);
}

void put_quat(const glm::quat &q, float *out)
{
    put(glm::vec4(q.x, q.y, q.z, q.w), out);
}

/* Inputs: axis, angle, translation, scale. */
glm::mat4 model(const float *in)
{
    const glm::mat4 moved = glm::translate(glm::mat4(1.0f), of<glm::vec3>(in + 4));
    return glm::scale(glm::rotate(moved, in[3], of<glm::vec3>(in)), of<glm::vec3>(in + 7));
}

/* Inputs: the corners, the origin, the direction. */
glm::vec3 hit(const float *in)
{
    glm::vec2 weights;
    float t;
    return glm::intersectRayTriangle(of<glm::vec3>(in + 9), of<glm::vec3>(in + 12),
                                     of<glm::vec3>(in), of<glm::vec3>(in + 3),
                                     of<glm::vec3>(in + 6), weights, t)
               ? glm::vec3(t, weights)
               : glm::vec3(std::numeric_limits<float>::quiet_NaN());
}

#define FUNCTION [](float *in, float *out)

/* Functions with one name for vectors of n components. */
#define VECTORS(n)                                                                                 \
    {"vec" #n " dot", FUNCTION{ *out = glm::dot(of<glm::vec##n>(in), of<glm::vec##n>(in + n));     \
    }                                                                                              \
    }                                                                                              \
    , {"vec" #n " length", FUNCTION{ *out = glm::length(of<glm::vec##n>(in));                      \
    }                                                                                              \
    }                                                                                              \
    , {"vec" #n " distance",                                                                       \
       FUNCTION{ *out = glm::distance(of<glm::vec##n>(in), of<glm::vec##n>(in + n));               \
    }                                                                                              \
    }                                                                                              \
    , {"vec" #n " normalize", FUNCTION{put(glm::normalize(of<glm::vec##n>(in)), out);              \
    }                                                                                              \
    }                                                                                              \
    , {"vec" #n " reflect",                                                                        \
       FUNCTION{put(glm::reflect(of<glm::vec##n>(in), of<glm::vec##n>(in + n)), out);              \
    }                                                                                              \
    }                                                                                              \
    ,                                                                                              \
    {                                                                                              \
        "vec" #n " refract", FUNCTION                                                              \
        {                                                                                          \
            put(glm::refract(of<glm::vec##n>(in), of<glm::vec##n>(in + n), in[2 * n]), out);       \
        }                                                                                          \
    }

#define MATRICES(n)                                                                                \
    {"mat" #n " multiply", FUNCTION{put(of<glm::mat##n>(in) * of<glm::mat##n>(in + n * n), out);   \
    }                                                                                              \
    }                                                                                              \
    , {"mat" #n " times vec" #n,                                                                   \
       FUNCTION{put(of<glm::mat##n>(in) * of<glm::vec##n>(in + n * n), out);                       \
    }                                                                                              \
    }                                                                                              \
    , {"mat" #n " transpose", FUNCTION{put(glm::transpose(of<glm::mat##n>(in)), out);              \
    }                                                                                              \
    }                                                                                              \
    , {"mat" #n " determinant", FUNCTION{ *out = glm::determinant(of<glm::mat##n>(in));            \
    }                                                                                              \
    }                                                                                              \
    ,                                                                                              \
    {                                                                                              \
        "mat" #n " invert", FUNCTION                                                               \
        {                                                                                          \
            put(glm::inverse(of<glm::mat##n>(in)), out);                                           \
        }                                                                                          \
    }

#define PROJECTIONS(name, convention)                                                              \
    {"orthographic " name,                                                                         \
     FUNCTION{put(glm::ortho##convention(in[0], in[1], in[2], in[3], in[4], in[5]), out);          \
    }                                                                                              \
    }                                                                                              \
    , {"frustum " name,                                                                            \
       FUNCTION{put(glm::frustum##convention(in[0], in[1], in[2], in[3], in[4], in[5]), out);      \
    }                                                                                              \
    }                                                                                              \
    ,                                                                                              \
    {                                                                                              \
        "perspective " name, FUNCTION                                                              \
        {                                                                                          \
            put(glm::perspective##convention(in[0], in[1], in[2], in[3]), out);                    \
        }                                                                                          \
    }

const peer_function functions[] = {{"rsqrt", FUNCTION{ *out = glm::inversesqrt(in[0]);
} // namespace
}
, VECTORS(2), VECTORS(3), VECTORS(4),
    {"vec3 add", FUNCTION{put(of<glm::vec3>(in) + of<glm::vec3>(in + 3), out);
}
}
, {"vec3 subtract", FUNCTION{put(of<glm::vec3>(in) - of<glm::vec3>(in + 3), out);
}
}
, {"vec3 scale", FUNCTION{put(of<glm::vec3>(in) * in[3], out);
}
}
, {"vec2 cross", FUNCTION{ *out = glm::cross(of<glm::vec2>(in), of<glm::vec2>(in + 2));
}
}
, {"vec3 cross", FUNCTION{put(glm::cross(of<glm::vec3>(in), of<glm::vec3>(in + 3)), out);
}
}
, {"vec3 mix", FUNCTION{put(glm::mix(of<glm::vec3>(in), of<glm::vec3>(in + 3), in[6]), out);
}
}
, MATRICES(3), MATRICES(4),
    {"mat4 transform point",
     FUNCTION{put(glm::vec3(of<glm::mat4>(in) * glm::vec4(of<glm::vec3>(in + 16), 1)), out);
}
}
, {"mat4 transform direction",
   FUNCTION{put(glm::vec3(of<glm::mat4>(in) * glm::vec4(of<glm::vec3>(in + 16), 0)), out);
}
}
, {"translate", FUNCTION{put(glm::translate(glm::mat4(1.0f), of<glm::vec3>(in)), out);
}
}
, {"scale", FUNCTION{put(glm::scale(glm::mat4(1.0f), of<glm::vec3>(in)), out);
}
}
, {"rotate x", FUNCTION{put(glm::eulerAngleX(in[0]), out);
}
}
, {"rotate y", FUNCTION{put(glm::eulerAngleY(in[0]), out);
}
}
, {"rotate z", FUNCTION{put(glm::eulerAngleZ(in[0]), out);
}
}
, {"rotate axis", FUNCTION{put(glm::rotate(glm::mat4(1.0f), in[0], of<glm::vec3>(in + 1)), out);
}
}
, {"look at rh",
   FUNCTION{
       put(glm::lookAtRH(of<glm::vec3>(in), of<glm::vec3>(in + 3), of<glm::vec3>(in + 6)), out);
}
}
, {"look at lh",
   FUNCTION{
       put(glm::lookAtLH(of<glm::vec3>(in), of<glm::vec3>(in + 3), of<glm::vec3>(in + 6)), out);
}
}
, {"TRS", FUNCTION{put(model(in), out);
}
}
, {"TRS, inverse", FUNCTION{put(glm::inverse(model(in)), out);
}
}
, {"decompose TRS, scale", FUNCTION{glm::vec3 scale, translation, skew;
glm::vec4 perspective;
glm::quat orientation;
glm::decompose(of<glm::mat4>(in), scale, orientation, translation, skew, perspective);
put(scale, out);
}
}
, PROJECTIONS("rh no", RH_NO), PROJECTIONS("rh zo", RH_ZO), PROJECTIONS("lh no", LH_NO),
    PROJECTIONS("lh zo", LH_ZO),
    {"perspective rh no, inverse",
     FUNCTION{put(glm::inverse(glm::perspectiveRH_NO(in[0], in[1], in[2], in[3])), out);
}
}
, {"quat from axis and angle",
   FUNCTION{put_quat(glm::angleAxis(in[0], glm::normalize(of<glm::vec3>(in + 1))), out);
}
}
, {"quat from mat3", FUNCTION{put_quat(glm::quat_cast(of<glm::mat3>(in)), out);
}
}
, {"quat from directions", FUNCTION{put_quat(glm::rotation(glm::normalize(of<glm::vec3>(in)),
                                                           glm::normalize(of<glm::vec3>(in + 3))),
                                             out);
}
}
, {"quat multiply", FUNCTION{put_quat(quat(in) * quat(in + 4), out);
}
}
, {"quat to mat3", FUNCTION{put(glm::mat3_cast(quat(in)), out);
}
}
, {"quat rotate", FUNCTION{put(quat(in) * of<glm::vec3>(in + 4), out);
}
}
, {"quat slerp", FUNCTION{put_quat(glm::slerp(quat(in), quat(in + 4), in[8]), out);
}
}
, {"ray meets triangle, t", FUNCTION{ *out = hit(in).x;
}
}
, {"ray meets triangle, u and v", FUNCTION{const glm::vec3 found = hit(in);
put(glm::vec2(found.y, found.z), out);
}
}
,
}
;

#define TEXT(x) #x
#define DOTTED(a, b, c, d) TEXT(a) "." TEXT(b) "." TEXT(c) "." TEXT(d)

} // namespace

extern "C" const peer glm_peer = {
    "GLM", DOTTED(GLM_VERSION_MAJOR, GLM_VERSION_MINOR, GLM_VERSION_PATCH, GLM_VERSION_REVISION),
    functions, sizeof functions / sizeof functions[0]};
