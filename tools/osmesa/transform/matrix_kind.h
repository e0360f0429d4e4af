/* What is known of a matrix beside its elements: what was multiplied into it. The reference chooses
 * by it how a matrix is inverted, and in which space vertices are lit. */
#ifndef OSMESA_MATRIX_KIND_H
#define OSMESA_MATRIX_KIND_H

#include <stdbool.h>

#include "../context/gl_types.h"

/* Parts of a matrix, as bits. */
enum matrix_part {
    MATRIX_GENERAL = 1,
    MATRIX_ROTATION = 2,
    MATRIX_TRANSLATION = 4,
    MATRIX_UNIFORM_SCALE = 8,
    MATRIX_SCALE = 16,
    MATRIX_AFFINE = 32, /* any other 3x3 part */
    MATRIX_PERSPECTIVE = 64
};

typedef enum matrix_shape {
    SHAPE_IDENTITY,
    SHAPE_DIAGONAL,      /* scales and a translation */
    SHAPE_FLAT_DIAGONAL, /* the same in x and y */
    SHAPE_AFFINE,
    SHAPE_GENERAL
} matrix_shape;

typedef struct matrix_kind {
    unsigned parts;
    matrix_shape shape; /* of the last analysis */
    bool is_stale;      /* to be analysed */
    bool is_unknown;    /* elements were given by the program: the parts are to be found, too */
} matrix_kind;

/* Records that a part was multiplied into a matrix; MATRIX_GENERAL: a matrix of the program. */
void add_part(matrix_kind *kind, unsigned parts);

/* Records that the matrix was replaced by one of the program. */
void forget_parts(matrix_kind *kind);

/* Records that the matrix was replaced by the identity. The parts stay, as in the reference. */
void set_identity_kind(matrix_kind *kind);

/* Brings the kind of a matrix up to date. */
void analyse_matrix(matrix_kind *kind, const GLfloat m[16]);

/* Whether a matrix of this kind keeps the lengths of vectors. */
bool keeps_lengths(const matrix_kind *kind);

/* Writes the inverse of an analysed matrix, the identity if it has none. */
void invert_matrix(const matrix_kind *kind, const GLfloat m[16], GLfloat inverse[16]);

#endif
