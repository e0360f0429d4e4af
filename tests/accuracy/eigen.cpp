/* The rows of the tables computed with Eigen. Scalar functions are Eigen's own, which are for
 * arrays, if it has them, otherwise the C library's. */
#include <Eigen/Dense>

#include "peers.h"

namespace
{

using Eigen::Affine3f;
using Eigen::Matrix3f;
using Eigen::Matrix4f;
using Eigen::Quaternionf;
using Eigen::Vector2f;
using Eigen::Vector3f;
using Eigen::Vector4f;

template <typename T> T of(const float *in)
{
    return Eigen::Map<const T>(in);
}

template <typename T> void put(const T &value, float *out)
{
    Eigen::Map<T>(out, value.rows(), value.cols()) = value;
}

void put_quat(const Quaternionf &q, float *out)
{
    put<Vector4f>(q.coeffs(), out);
}

void put_rotation(float angle, const Vector3f &unit_axis, float *out)
{
    put(Affine3f(Eigen::AngleAxisf(angle, unit_axis)).matrix(), out);
}

/* Inputs: axis, angle, translation, scale. */
Affine3f model(const float *in)
{
    return Eigen::Translation3f(of<Vector3f>(in + 4)) *
           Eigen::AngleAxisf(in[3], of<Vector3f>(in).normalized()) *
           Eigen::Scaling(of<Vector3f>(in + 7));
}

#define FUNCTION [](float *in, float *out)

#define SCALAR(name)                                                                               \
    {                                                                                              \
#name, FUNCTION                                                                            \
        {                                                                                          \
            const Eigen::Array4f results = Eigen::Array4f::Constant(in[0]).name();                 \
            *out = results(0);                                                                     \
        }                                                                                          \
    }

#define VECTORS(n)                                                                                 \
    {"vec" #n " dot", FUNCTION{ *out = of<Vector##n##f>(in).dot(of<Vector##n##f>(in + n));         \
    }                                                                                              \
    }                                                                                              \
    , {"vec" #n " length", FUNCTION{ *out = of<Vector##n##f>(in).norm();                           \
    }                                                                                              \
    }                                                                                              \
    , {"vec" #n " distance",                                                                       \
       FUNCTION{ *out = (of<Vector##n##f>(in) - of<Vector##n##f>(in + n)).norm();                  \
    }                                                                                              \
    }                                                                                              \
    ,                                                                                              \
    {                                                                                              \
        "vec" #n " normalize", FUNCTION                                                            \
        {                                                                                          \
            put<Vector##n##f>(of<Vector##n##f>(in).normalized(), out);                             \
        }                                                                                          \
    }

#define MATRICES(n)                                                                                \
    {"mat" #n " multiply",                                                                         \
     FUNCTION{put<Matrix##n##f>(of<Matrix##n##f>(in) * of<Matrix##n##f>(in + n * n), out);         \
    }                                                                                              \
    }                                                                                              \
    , {"mat" #n " times vec" #n,                                                                   \
       FUNCTION{put<Vector##n##f>(of<Matrix##n##f>(in) * of<Vector##n##f>(in + n * n), out);       \
    }                                                                                              \
    }                                                                                              \
    , {"mat" #n " transpose", FUNCTION{put<Matrix##n##f>(of<Matrix##n##f>(in).transpose(), out);   \
    }                                                                                              \
    }                                                                                              \
    , {"mat" #n " determinant", FUNCTION{ *out = of<Matrix##n##f>(in).determinant();               \
    }                                                                                              \
    }                                                                                              \
    ,                                                                                              \
    {                                                                                              \
        "mat" #n " invert", FUNCTION                                                               \
        {                                                                                          \
            put<Matrix##n##f>(of<Matrix##n##f>(in).inverse(), out);                                \
        }                                                                                          \
    }

const peer_function functions[] = {
    SCALAR(sqrt), SCALAR(rsqrt), SCALAR(sin), SCALAR(cos), SCALAR(exp), SCALAR(log), SCALAR(log2),
    {"pow", FUNCTION{const Eigen::Array4f results =
                         Eigen::Array4f::Constant(in[0]).pow(Eigen::Array4f::Constant(in[1]));
*out = results(0);
} // namespace
}
, VECTORS(2), VECTORS(3), VECTORS(4),
    {"vec3 add", FUNCTION{put<Vector3f>(of<Vector3f>(in) + of<Vector3f>(in + 3), out);
}
}
, {"vec3 subtract", FUNCTION{put<Vector3f>(of<Vector3f>(in) - of<Vector3f>(in + 3), out);
}
}
, {"vec3 scale", FUNCTION{put<Vector3f>(of<Vector3f>(in) * in[3], out);
}
}
, {"vec3 cross", FUNCTION{put<Vector3f>(of<Vector3f>(in).cross(of<Vector3f>(in + 3)), out);
}
}
, MATRICES(3), MATRICES(4),
    {"mat4 transform point",
     FUNCTION{put<Vector3f>(Affine3f(of<Matrix4f>(in)) * of<Vector3f>(in + 16), out);
}
}
, {"mat4 transform direction",
   FUNCTION{put<Vector3f>(Affine3f(of<Matrix4f>(in)).linear() * of<Vector3f>(in + 16), out);
}
}
, {"mat4 trace", FUNCTION{ *out = of<Matrix4f>(in).trace();
}
}
, {"mat4 rigid inverse", FUNCTION{put(Eigen::Isometry3f(of<Matrix4f>(in)).inverse().matrix(), out);
}
}
, {"translate", FUNCTION{put(Affine3f(Eigen::Translation3f(of<Vector3f>(in))).matrix(), out);
}
}
, {"scale", FUNCTION{put(Affine3f(Eigen::Scaling(of<Vector3f>(in))).matrix(), out);
}
}
, {"rotate x", FUNCTION{put_rotation(in[0], Vector3f::UnitX(), out);
}
}
, {"rotate y", FUNCTION{put_rotation(in[0], Vector3f::UnitY(), out);
}
}
, {"rotate z", FUNCTION{put_rotation(in[0], Vector3f::UnitZ(), out);
}
}
, {"rotate axis", FUNCTION{put_rotation(in[0], of<Vector3f>(in + 1).normalized(), out);
}
}
, {"TRS", FUNCTION{put(model(in).matrix(), out);
}
}
, {"TRS, inverse", FUNCTION{put(model(in).inverse().matrix(), out);
}
}
, {"decompose TRS, scale", FUNCTION{Matrix3f rotation, scale;
Affine3f(of<Matrix4f>(in)).computeRotationScaling(&rotation, &scale);
put<Vector3f>(scale.diagonal(), out);
}
}
, {"decompose TRS, rotation", FUNCTION{put<Matrix3f>(Affine3f(of<Matrix4f>(in)).rotation(), out);
}
}
, {"box transformed",
   FUNCTION{const Eigen::AlignedBox3f box(of<Vector3f>(in + 16), of<Vector3f>(in + 19));
const Eigen::AlignedBox3f around = box.transformed(Affine3f(of<Matrix4f>(in)));
put<Vector3f>(around.min(), out);
put<Vector3f>(around.max(), out + 3);
}
}
, {"quat from axis and angle",
   FUNCTION{put_quat(Quaternionf(Eigen::AngleAxisf(in[0], of<Vector3f>(in + 1).normalized())), out);
}
}
, {"quat from mat3", FUNCTION{put_quat(Quaternionf(of<Matrix3f>(in)), out);
}
}
, {"quat from directions",
   FUNCTION{put_quat(Quaternionf::FromTwoVectors(of<Vector3f>(in), of<Vector3f>(in + 3)), out);
}
}
, {"quat multiply", FUNCTION{put_quat(Quaternionf(in) * Quaternionf(in + 4), out);
}
}
, {"quat to mat3", FUNCTION{put(Quaternionf(in).toRotationMatrix(), out);
}
}
, {"quat rotate", FUNCTION{put<Vector3f>(Quaternionf(in) * of<Vector3f>(in + 4), out);
}
}
, {"quat slerp", FUNCTION{put_quat(Quaternionf(in).slerp(in[8], Quaternionf(in + 4)), out);
}
}
,
}
;

#define TEXT(x) #x
#define DOTTED(a, b, c) TEXT(a) "." TEXT(b) "." TEXT(c)

} // namespace

extern "C" const peer eigen_peer = {
    "Eigen", DOTTED(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION), functions,
    sizeof functions / sizeof functions[0]};
