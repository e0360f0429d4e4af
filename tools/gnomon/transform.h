/* gnomon transform: transform_read.c turns a text into a setup, transform_compute.c the setup into
 * matrices and places, transform_print.c these into lines. Only the last one prints to standard
 * output, after everything else has succeeded. TRANSFORM.md describes the text. */
#ifndef TRANSFORM_H
#define TRANSFORM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include <gnomon.h>

#include "options.h"

/* The statements that may occur at most once. */
typedef enum keyword {
    KEYWORD_SCREEN,
    KEYWORD_SCALE,
    KEYWORD_TRANSLATE,
    KEYWORD_POSITION,
    KEYWORD_TARGET,
    KEYWORD_RIGHT,
    KEYWORD_UP,
    KEYWORD_FORWARD,
    KEYWORD_PERSPECTIVE,
    KEYWORD_ORTHOGRAPHIC,
    KEYWORD_FRUSTUM,
    KEYWORD_NEAR,
    KEYWORD_FAR,
    KEYWORD_CONVENTION,
    KEYWORD_DEPTH,
    KEYWORD_COUNT
} keyword;

/* Numbers of a statement and its line; the line is 0 if the statement does not occur. */
typedef struct statement {
    unsigned long line;
    float number[4];
} statement;

typedef struct statements {
    statement *all;
    size_t count;
} statements;

/* The contents of a setup's text. */
typedef struct setup {
    const char *file; /* for messages */
    convention_option convention;
    bool infinite, reversed;
    statement given[KEYWORD_COUNT];
    statements rotations, points;
} setup;

/* Why a place has no normalised device coordinates and no pixel. */
typedef enum division { DIVIDED, IN_EYE_PLANE, BEHIND_EYE, TOO_LARGE } division;

/* Bits of place.outside; the planes as the camera sees them. */
enum {
    OUTSIDE_LEFT = 1,
    OUTSIDE_RIGHT = 2,
    OUTSIDE_BOTTOM = 4,
    OUTSIDE_TOP = 8,
    OUTSIDE_NEAR = 16,
    OUTSIDE_FAR = 32
};

/* A point at every stage; ndc and pixel only if it was divided. */
typedef struct place {
    gn_vec3 local, world, view;
    gn_vec4 clip;
    division division;
    unsigned outside;
    gn_vec3 ndc, pixel; /* pixel.z is the depth */
} place;

typedef struct places {
    gn_transform model, view, projection, viewport;
    gn_transform combined; /* from local to clip coordinates */
    bool has_combined;     /* false: its numbers are too large */
    place *all;
    size_t count;
} places;

/* Each returns 0, or the exit status with the reason printed. A setup or places must be zeroed
 * before, and freed in either case. */
int transform_read(FILE *in, const char *file, setup *result);
int transform_compute(const setup *s, places *result);

void transform_print(const setup *s, const places *p, bool with_matrices);

void transform_setup_free(setup *s);
void transform_places_free(places *p);

/* The statement's word in the text. */
const char *transform_keyword(keyword which);

/* Prints "gnomon: FILE:LINE: why", without the line if it is 0, and returns EXIT_USAGE. */
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
int transform_fault(const char *file, unsigned long line, const char *format, ...);

#endif
