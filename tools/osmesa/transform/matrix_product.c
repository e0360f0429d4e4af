/* Products of matrices with translations, scales, rotations and projections. */
#include "matrix_product.h"

#include <math.h>
#include <string.h>

enum { X = 0, Y = 4, Z = 8, W = 12 }; /* the columns */

void set_identity(GLfloat m[16])
{
    memset(m, 0, 16 * sizeof *m);
    m[0] = m[5] = m[10] = m[15] = 1.0f;
}

void multiply_matrices(GLfloat result[16], const GLfloat a[16], const GLfloat b[16])
{
    GLfloat product[16];

    for (int column = 0; column < 4; ++column) {
        const GLfloat *const by = b + 4 * column;

        for (int row = 0; row < 4; ++row)
            product[4 * column + row] =
                a[X + row] * by[0] + a[Y + row] * by[1] + a[Z + row] * by[2] + a[W + row] * by[3];
    }
    memcpy(result, product, sizeof product);
}

void translate_matrix(GLfloat m[16], GLfloat x, GLfloat y, GLfloat z)
{
    for (int row = 0; row < 4; ++row)
        m[W + row] = m[X + row] * x + m[Y + row] * y + m[Z + row] * z + m[W + row];
}

void scale_matrix(GLfloat m[16], GLfloat x, GLfloat y, GLfloat z)
{
    for (int row = 0; row < 4; ++row) {
        m[X + row] *= x;
        m[Y + row] *= y;
        m[Z + row] *= z;
    }
}

/* Sets the rotation around one axis, from axis a toward axis b. */
static void set_plane_rotation(GLfloat m[16], int a, int b, GLfloat cosine, GLfloat sine)
{
    m[5 * a] = m[5 * b] = cosine;
    m[4 * a + b] = sine;
    m[4 * b + a] = -sine;
}

/* Rotations around an axis of coordinates have exact zeros and ones. The C library's sine and
 * cosine are those that the reference calls. */
bool rotate_matrix(GLfloat m[16], GLfloat degrees, GLfloat x, GLfloat y, GLfloat z)
{
    static const double pi = 3.14159265358979323846;
    const GLfloat angle = (GLfloat)((double)degrees * pi / 180.0);
    const GLfloat sine = sinf(angle), cosine = cosf(angle);
    GLfloat rotation[16];

    set_identity(rotation);
    if (x == 0.0f && y == 0.0f && z != 0.0f) {
        set_plane_rotation(rotation, 0, 1, cosine, z < 0.0f ? -sine : sine);
    } else if (x == 0.0f && y != 0.0f && z == 0.0f) {
        set_plane_rotation(rotation, 2, 0, cosine, y < 0.0f ? -sine : sine);
    } else if (x != 0.0f && y == 0.0f && z == 0.0f) {
        set_plane_rotation(rotation, 1, 2, cosine, x < 0.0f ? -sine : sine);
    } else {
        const GLfloat length = sqrtf(x * x + y * y + z * z);
        const GLfloat rest = 1.0f - cosine;

        if (!(length > 1.0e-4f))
            return false;
        x /= length;
        y /= length;
        z /= length;
        rotation[0] = rest * (x * x) + cosine;
        rotation[4] = rest * (x * y) - z * sine;
        rotation[8] = rest * (z * x) + y * sine;
        rotation[1] = rest * (x * y) + z * sine;
        rotation[5] = rest * (y * y) + cosine;
        rotation[9] = rest * (y * z) - x * sine;
        rotation[2] = rest * (z * x) - y * sine;
        rotation[6] = rest * (y * z) + x * sine;
        rotation[10] = rest * (z * z) + cosine;
    }
    multiply_matrices(m, m, rotation);
    return true;
}

void multiply_frustum(GLfloat m[16], GLfloat left, GLfloat right, GLfloat bottom, GLfloat top,
                      GLfloat z_near, GLfloat z_far)
{
    GLfloat projection[16] = {0.0f};

    projection[0] = (2.0f * z_near) / (right - left);
    projection[5] = (2.0f * z_near) / (top - bottom);
    projection[8] = (right + left) / (right - left);
    projection[9] = (top + bottom) / (top - bottom);
    projection[10] = -(z_far + z_near) / (z_far - z_near);
    projection[11] = -1.0f;
    projection[14] = -(2.0f * z_far * z_near) / (z_far - z_near);
    multiply_matrices(m, m, projection);
}

void multiply_ortho(GLfloat m[16], GLfloat left, GLfloat right, GLfloat bottom, GLfloat top,
                    GLfloat z_near, GLfloat z_far)
{
    GLfloat projection[16] = {0.0f};

    projection[0] = 2.0f / (right - left);
    projection[12] = -(right + left) / (right - left);
    projection[5] = 2.0f / (top - bottom);
    projection[13] = -(top + bottom) / (top - bottom);
    projection[10] = -2.0f / (z_far - z_near);
    projection[14] = -(z_far + z_near) / (z_far - z_near);
    projection[15] = 1.0f;
    multiply_matrices(m, m, projection);
}
