/* Follows what is multiplied into a matrix, and inverts it accordingly. */
#include "matrix_kind.h"

#include <math.h>
#include <string.h>

#include "matrix_product.h"

enum {
    AFFINE_PARTS =
        MATRIX_ROTATION | MATRIX_TRANSLATION | MATRIX_UNIFORM_SCALE | MATRIX_SCALE | MATRIX_AFFINE
};

static const float tolerance = 1e-6f;

void add_part(matrix_kind *kind, unsigned parts)
{
    kind->parts |= parts;
    kind->is_stale = true;
    if (parts & MATRIX_GENERAL)
        kind->is_unknown = true;
}

void forget_parts(matrix_kind *kind)
{
    kind->parts = MATRIX_GENERAL;
    kind->is_stale = kind->is_unknown = true;
}

void set_identity_kind(matrix_kind *kind)
{
    kind->shape = SHAPE_IDENTITY;
    kind->is_stale = kind->is_unknown = false;
}

bool keeps_lengths(const matrix_kind *kind)
{
    return !(kind->parts & ~(unsigned)(MATRIX_ROTATION | MATRIX_TRANSLATION));
}

static bool has_only(const matrix_kind *kind, unsigned parts)
{
    return !(kind->parts & ~parts);
}

/* The shape of a matrix whose parts are known. */
static matrix_shape shape_by_parts(const matrix_kind *kind, const GLfloat m[16])
{
    if (kind->parts == 0)
        return SHAPE_IDENTITY;
    if (has_only(kind, MATRIX_TRANSLATION | MATRIX_UNIFORM_SCALE | MATRIX_SCALE))
        return m[10] == 1.0f && m[14] == 0.0f ? SHAPE_FLAT_DIAGONAL : SHAPE_DIAGONAL;
    return has_only(kind, AFFINE_PARTS) ? SHAPE_AFFINE : SHAPE_GENERAL;
}

static bool is_small(float x)
{
    return x * x < tolerance * tolerance;
}

static bool is_large(float x)
{
    return x * x > tolerance * tolerance;
}

static float dot(const GLfloat *a, const GLfloat *b, int n)
{
    float sum = a[0] * b[0];

    for (int i = 1; i < n; ++i)
        sum += a[i] * b[i];
    return sum;
}

/* The parts of a matrix that turns x and y only. */
static unsigned plane_parts(const GLfloat m[16])
{
    const bool has_scale = is_large(dot(m, m, 2) - 1.0f) || is_large(dot(m + 4, m + 4, 2) - 1.0f);

    return (has_scale ? MATRIX_SCALE : 0u) |
           (is_large(dot(m, m + 4, 2)) ? MATRIX_AFFINE : MATRIX_ROTATION);
}

/* The parts of any affine matrix. It is a rotation if the third column is the product of the
 * others. */
static unsigned affine_parts(const GLfloat m[16])
{
    const float length = dot(m, m, 3);
    const bool is_even =
        is_small(length - dot(m + 4, m + 4, 3)) && is_small(length - dot(m + 8, m + 8, 3));
    const unsigned scale = !is_even                  ? MATRIX_SCALE
                           : is_large(length - 1.0f) ? MATRIX_UNIFORM_SCALE
                                                     : 0u;
    const float rest[3] = {(m[1] * m[6] - m[2] * m[5]) - m[8], (m[2] * m[4] - m[0] * m[6]) - m[9],
                           (m[0] * m[5] - m[1] * m[4]) - m[10]};
    const bool turns = is_small(dot(m, m + 4, 3)) && dot(rest, rest, 3) < tolerance * tolerance;

    return scale | (turns ? MATRIX_ROTATION : MATRIX_AFFINE);
}

static unsigned diagonal_parts(const GLfloat m[16])
{
    if (is_small(m[0] - m[5]) && is_small(m[0] - m[10]))
        return is_large(m[0] - 1.0f) ? MATRIX_UNIFORM_SCALE : 0u;
    return MATRIX_SCALE;
}

/* Finds parts and shape from the elements. */
static void analyse_elements(matrix_kind *kind, const GLfloat m[16])
{
    const bool is_affine = m[3] == 0.0f && m[7] == 0.0f && m[11] == 0.0f && m[15] == 1.0f;
    const bool is_flat = m[8] == 0.0f && m[9] == 0.0f && m[2] == 0.0f && m[6] == 0.0f &&
                         m[10] == 1.0f && m[14] == 0.0f;
    const bool is_diagonal = m[4] == 0.0f && m[8] == 0.0f && m[1] == 0.0f && m[9] == 0.0f &&
                             m[2] == 0.0f && m[6] == 0.0f;
    const bool moves = m[12] != 0.0f || m[13] != 0.0f || m[14] != 0.0f;
    const bool is_plain = is_affine && is_flat && is_diagonal;
    const bool has_no_scale = m[0] == 1.0f && m[5] == 1.0f;

    kind->parts = moves ? MATRIX_TRANSLATION : 0u;
    if (!is_affine) {
        kind->shape = SHAPE_GENERAL;
        kind->parts |= MATRIX_GENERAL;
    } else if (is_plain && has_no_scale && !moves) {
        kind->shape = SHAPE_IDENTITY;
    } else if (is_plain) {
        kind->shape = SHAPE_FLAT_DIAGONAL;
        kind->parts |= has_no_scale ? 0u : MATRIX_SCALE;
    } else if (is_flat) {
        kind->shape = SHAPE_AFFINE;
        kind->parts |= plane_parts(m);
    } else if (is_diagonal) {
        kind->shape = SHAPE_DIAGONAL;
        kind->parts |= diagonal_parts(m);
    } else {
        kind->shape = SHAPE_AFFINE;
        kind->parts |= affine_parts(m);
    }
}

void analyse_matrix(matrix_kind *kind, const GLfloat m[16])
{
    if (kind->is_unknown)
        analyse_elements(kind, m);
    else if (kind->is_stale)
        kind->shape = shape_by_parts(kind, m);
    kind->is_stale = kind->is_unknown = false;
}

/* Inverses */

static bool invert_diagonal(const GLfloat m[16], bool moves, int axes, GLfloat inverse[16])
{
    set_identity(inverse);
    for (int i = 0; i < axes; ++i) {
        if (m[5 * i] == 0.0f)
            return false;
        inverse[5 * i] = 1.0f / m[5 * i];
        if (moves)
            inverse[12 + i] = -(m[12 + i] * inverse[5 * i]);
    }
    return true;
}

/* Writes the cofactors of the 3x3 part over its determinant. The determinant adds positive and
 * negative terms apart. */
static bool invert_3x3(const GLfloat m[16], GLfloat inverse[16])
{
    const float term[6] = {m[0] * m[5] * m[10], m[1] * m[6] * m[8],   m[2] * m[4] * m[9],
                           -m[2] * m[5] * m[8], -m[1] * m[4] * m[10], -m[0] * m[6] * m[9]};
    float positive = 0.0f, negative = 0.0f, determinant, scale;

    for (int i = 0; i < 6; ++i)
        if (term[i] >= 0.0f)
            positive += term[i];
        else
            negative += term[i];
    determinant = positive + negative;
    if (fabsf(determinant) < 1e-25f)
        return false;
    scale = 1.0f / determinant;
    inverse[0] = (m[5] * m[10] - m[6] * m[9]) * scale;
    inverse[4] = -(m[4] * m[10] - m[6] * m[8]) * scale;
    inverse[8] = (m[4] * m[9] - m[5] * m[8]) * scale;
    inverse[1] = -(m[1] * m[10] - m[2] * m[9]) * scale;
    inverse[5] = (m[0] * m[10] - m[2] * m[8]) * scale;
    inverse[9] = -(m[0] * m[9] - m[1] * m[8]) * scale;
    inverse[2] = (m[1] * m[6] - m[2] * m[5]) * scale;
    inverse[6] = -(m[0] * m[6] - m[2] * m[4]) * scale;
    inverse[10] = (m[0] * m[5] - m[1] * m[4]) * scale;
    return true;
}

static void transpose_3x3(const GLfloat m[16], float scale, GLfloat inverse[16])
{
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            inverse[4 * j + i] = scale * m[4 * i + j];
}

static void move_back(const GLfloat m[16], GLfloat inverse[16])
{
    for (int i = 0; i < 3; ++i)
        inverse[12 + i] = -(m[12] * inverse[i] + m[13] * inverse[4 + i] + m[14] * inverse[8 + i]);
}

/* Rotations are transposed, and scaled back if all axes have one scale. */
static bool invert_affine(const matrix_kind *kind, const GLfloat m[16], GLfloat inverse[16])
{
    set_identity(inverse);
    if (!has_only(kind, MATRIX_ROTATION | MATRIX_TRANSLATION | MATRIX_UNIFORM_SCALE)) {
        if (!invert_3x3(m, inverse))
            return false;
        move_back(m, inverse);
        return true;
    }
    if (kind->parts & MATRIX_UNIFORM_SCALE) {
        const float square = m[0] * m[0] + m[4] * m[4] + m[8] * m[8];

        if (square == 0.0f)
            return false;
        transpose_3x3(m, 1.0f / square, inverse);
    } else {
        transpose_3x3(m, 1.0f, inverse);
    }
    if (kind->parts & MATRIX_TRANSLATION)
        move_back(m, inverse);
    return true;
}

/* Moves the largest of the elements of a column, from `first` down, up by exchanges of neighbours.
 */
static void choose_pivot(GLfloat *row[4], int first)
{
    for (int i = 3; i > first; --i) {
        if (fabsf(row[i][first]) > fabsf(row[i - 1][first])) {
            GLfloat *const other = row[i];

            row[i] = row[i - 1];
            row[i - 1] = other;
        }
    }
}

/* Gaussian elimination of the matrix beside the identity, then substitution from the last row up.
 */
static bool invert_general(const GLfloat m[16], GLfloat inverse[16])
{
    GLfloat work[4][8] = {{0.0f}};
    GLfloat *row[4] = {work[0], work[1], work[2], work[3]};

    for (int r = 0; r < 4; ++r) {
        for (int c = 0; c < 4; ++c)
            work[r][c] = m[4 * c + r];
        work[r][4 + r] = 1.0f;
    }
    for (int pivot = 0; pivot < 4; ++pivot) {
        choose_pivot(row, pivot);
        if (row[pivot][pivot] == 0.0f)
            return false;
        for (int r = pivot + 1; r < 4; ++r) {
            const float factor = row[r][pivot] / row[pivot][pivot];

            for (int c = pivot + 1; c < 8; ++c)
                row[r][c] -= factor * row[pivot][c];
        }
    }
    for (int r = 3; r >= 0; --r) {
        const float scale = 1.0f / row[r][r];

        for (int c = 4; c < 8; ++c) {
            for (int known = 3; known > r; --known)
                row[r][c] -= row[known][c] * row[r][known];
            row[r][c] = scale * row[r][c];
            inverse[4 * (c - 4) + r] = row[r][c];
        }
    }
    return true;
}

void invert_matrix(const matrix_kind *kind, const GLfloat m[16], GLfloat inverse[16])
{
    const bool moves = kind->parts & MATRIX_TRANSLATION;
    bool is_regular = false;

    switch (kind->shape) {
    case SHAPE_DIAGONAL:
        is_regular = invert_diagonal(m, moves, 3, inverse);
        break;
    case SHAPE_FLAT_DIAGONAL:
        is_regular = invert_diagonal(m, moves, 2, inverse);
        break;
    case SHAPE_AFFINE:
        is_regular = invert_affine(kind, m, inverse);
        break;
    case SHAPE_GENERAL:
        is_regular = invert_general(m, inverse);
        break;
    default:
        break;
    }
    if (!is_regular)
        set_identity(inverse);
}
