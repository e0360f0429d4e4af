/* Cubes whose filters stop at the edges of faces, as without GL_TEXTURE_CUBE_MAP_SEAMLESS, over
 * lanes: the face that a direction meets, the place on it, and how the place moves from fragment to
 * fragment (OpenGL 2.1 section 3.8.6). reference/RULES.md has the rules under "Cubes". */
#include <math.h>

#include "fixed_texture.h"
#include "lane_function.h"

/* The components of vectors along a face's normal, s and t. */
typedef struct face_axes {
    int face; /* 0 to 5: +x, -x, +y, -y, +z, -z */
    float major, minor[2];
} face_axes;

/* All branches are selections, so that compilers find lanes. */
static int face_of(float x, float y, float z)
{
    const bool is_x = !(fabsf(x) <= fabsf(y));
    const float most = fabsf(x) > fabsf(y) ? fabsf(x) : fabsf(y);
    const int axis = !(most > fabsf(z)) ? 2 : is_x ? 0 : 1;
    const float major = axis == 0 ? x : axis == 1 ? y : z;

    return 2 * axis + (copysignf(1.0f, major) < 0.0f ? 1 : 0);
}

/* Returns the components of a vector on a face. */
static face_axes on_face(int face, float x, float y, float z)
{
    const int axis = face / 2;
    const bool is_back = face % 2 != 0;
    const float along_s = axis == 0 ? -z : x, along_t = axis == 1 ? z : -y;

    return (face_axes){
        face,
        axis == 0   ? x
        : axis == 1 ? y
                    : z,
        {is_back && axis != 1 ? -along_s : along_s, is_back && axis == 1 ? -along_t : along_t}};
}

/* Writes the change of s and t on a face when the direction changes by a gradient. */
static void move_on_face(const face_axes *at, float inverse, const face_axes *change, float to[2])
{
    const float major = change->major * inverse;

    for (int i = 0; i < 2; ++i)
        to[i] = (change->minor[i] - major * at->minor[i]) * (0.5f * inverse);
}

/* Writes the differences of a coordinate within each lane's row and column of its quad. */
static void write_gradients(const float coordinate[GN_LANES], float along_x[GN_LANES],
                            float along_y[GN_LANES])
{
    for (int l = 0; l < GN_LANES; l += 2)
        along_x[l] = along_x[l + 1] = coordinate[l + 1] - coordinate[l];
    for (int block = 0; block < GN_LANES; block += 8)
        for (int l = block; l < block + 4; ++l)
            along_y[l] = along_y[l + 4] = coordinate[l + 4] - coordinate[l];
}

LANE_FUNCTION
void place_on_faces(texture_place *place, bool shares_level)
{
    float(*const c)[GN_LANES] = place->coordinate;
    float(*const dx)[GN_LANES] = place->along_x;
    float(*const dy)[GN_LANES] = place->along_y;

    for (int i = 0; i < 3; ++i)
        write_gradients(c[i], dx[i], dy[i]);
    for (int l = 0; l < GN_LANES; ++l) {
        const face_axes at = on_face(face_of(c[0][l], c[1][l], c[2][l]), c[0][l], c[1][l], c[2][l]);
        const face_axes along_x = on_face(at.face, dx[0][l], dx[1][l], dx[2][l]);
        const face_axes along_y = on_face(at.face, dy[0][l], dy[1][l], dy[2][l]);
        const float inverse = 1.0f / at.major;
        const float scale = fabsf(0.5f * inverse);
        float moved[2][2];

        move_on_face(&at, inverse, &along_x, moved[0]);
        move_on_face(&at, inverse, &along_y, moved[1]);
        for (int i = 0; i < 2; ++i) {
            c[i][l] = at.minor[i] * scale + 0.5f;
            dx[i][l] = moved[0][i];
            dy[i][l] = moved[1][i];
        }
        c[2][l] = (float)at.face;
    }
    for (int i = 0; i < 2 && shares_level; ++i)
        for (int l = 0; l < GN_LANES; ++l) {
            dx[i][l] = dx[i][l & ~5];
            dy[i][l] = dy[i][l & ~5];
        }
    place->has_gradients = true;
}
