/* Classes of triangles for oracle B. */
#ifndef TESTS_EXACT_CLASSES_H
#define TESTS_EXACT_CLASSES_H

#include "clip_triangle.h"
#include "random.h"

typedef enum triangle_class {
    CLASS_AFFINE,
    CLASS_INSIDE,
    CLASS_SMALL,
    CLASS_LARGE,
    CLASS_CLIPPED,
    CLASS_BEHIND,
    CLASS_RAW,
    CLASS_GRID,
    CLASS_HUGE,
    CLASS_VAST,
    CLASS_THIN,
    CLASS_THINNER,
    CLASS_THINNEST,
    TRIANGLE_CLASSES
} triangle_class;

const char *class_name(triangle_class c);

/* Makes a random triangle for a viewport. */
void random_clip_triangle(random_source *r, triangle_class c, const gn_viewport *viewport,
                          clip_vertex vertex[3]);

#endif
