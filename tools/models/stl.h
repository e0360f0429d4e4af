/* What the parts of the STL reader share: facets, from a text or from a binary file. */
#ifndef STL_H
#define STL_H

#include "read.h"

/* A binary file is 80 bytes, the number of triangles, and 50 bytes for each: the normal, three
 * corners, two bytes that the format leaves free ("StereoLithography Interface Specification",
 * 3D Systems, 1989). */
#define STL_HEADER_SIZE 84
#define STL_RECORD_SIZE 50

typedef struct stl_facet {
    float normal[3]; /* zero: none that can be used */
    double corners[3][3];
} stl_facet;

/* How the two free bytes of a binary record hold a colour of 15 bits. */
typedef enum stl_coloring {
    STL_NO_COLORS,
    STL_VISCAM, /* bit 15 set: has a colour, blue in the lowest bits */
    STL_MAGICS  /* bit 15 clear: has a colour, red in the lowest bits */
} stl_coloring;

/* All facets of a file: an array of a text, or the records of a binary file. */
typedef struct stl_facets {
    size_t count;
    stl_facet *array;
    size_t room;
    const uint8_t *records;
    stl_coloring coloring;
    float color[4]; /* of facets that have none of their own */
} stl_facets;

/* Reads a text. */
bool stl_read_text(model_reader *r, stl_facets *facets);

/* Checks a file that has at least a header, and finds its records and how they are coloured. */
bool stl_read_binary(model_reader *r, stl_facets *facets);

/* A facet of a binary file, and its colour. */
void stl_decode(const stl_facets *facets, size_t number, stl_facet *facet);
void stl_decode_color(const stl_facets *facets, size_t number, float color[4]);

/* Makes a part of the facets; corners of equal position, normal and colour become one vertex. */
bool stl_make_part(model_reader *r, const stl_facets *facets);

#endif
