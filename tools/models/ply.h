/* What the parts of the PLY reader share: the header, rows of elements, and the mesh they make.
 *
 * The format is Greg Turk's, "The PLY Polygon File Format", 1994. The way of a file is
 *   ply_header.c   the header: elements and their properties
 *   ply_values.c   numbers and lists behind it, text or binary
 *   ply_rows.c     elements as rows: which property goes where
 *   ply_faces.c    faces, strips and edges as corners
 *   ply_parts.c    corners as parts with vertices of their own
 *   ply.c          the order of all this. */
#ifndef PLY_H
#define PLY_H

#include "read.h"
#include "text.h"

typedef enum ply_encoding { PLY_ASCII, PLY_LITTLE_ENDIAN, PLY_BIG_ENDIAN } ply_encoding;

typedef enum ply_type {
    PLY_INT8,
    PLY_UINT8,
    PLY_INT16,
    PLY_UINT16,
    PLY_INT32,
    PLY_UINT32,
    PLY_FLOAT32,
    PLY_FLOAT64,
    PLY_TYPE_COUNT
} ply_type;

typedef struct ply_property {
    text_word name;
    bool is_list;
    ply_type type;       /* of the number, or of a list's numbers */
    ply_type count_type; /* of a list's length */
} ply_property;

typedef struct ply_element {
    text_word name;
    uint64_t count;
    size_t first_property, property_count;
} ply_element;

/* Names are words of the file. */
typedef struct ply_header {
    ply_encoding encoding;
    size_t element_count, element_room;
    ply_element *elements;
    size_t property_count, property_room;
    ply_property *properties; /* of all elements, one after another */
    size_t texture_count, texture_room;
    text_word *textures; /* "comment TextureFile NAME" */
    text_cursor body;    /* at the first byte behind the header */
} ply_header;

/* The bytes of a type. */
size_t ply_type_size(ply_type type);
bool ply_type_is_float(ply_type type);

/* Reads the header. Free it with ply_header_free either way. */
bool ply_header_read(model_reader *r, ply_header *h);
void ply_header_free(model_reader *r, ply_header *h);

/* Where reading is behind the header. */
typedef struct ply_source {
    model_reader *r;
    ply_encoding encoding;
    text_cursor at; /* of a binary file only at and end are used */
    const ply_element *element;
    uint64_t number; /* of the element that is read, from 0 as indices count */
    uint64_t line;   /* the line on which the element begins */
} ply_source;

/* The line of the element that is read, for messages; null if the file is binary. */
const char *ply_place(const ply_source *s);

/* Records a fault at that place. Returns false. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
bool ply_fail(const ply_source *s, const char *format, ...);

/* Begins the next element of s->element: in a text, on a new line. */
bool ply_begin_row(ply_source *s);

/* Warns of words that a text has behind the numbers of an element. */
void ply_end_row(ply_source *s);

/* Reads a number of a property. */
bool ply_read_number(ply_source *s, const ply_property *p, ply_type type, double *value);

/* Reads the length of a list; the rest of the file is long enough for it. */
bool ply_read_length(ply_source *s, const ply_property *p, size_t *length);

/* How many elements the rest of the file has room for, at most. */
uint64_t ply_room(const ply_source *s, const ply_header *h);

/* Passes all elements of s->element. */
bool ply_skip(ply_source *s, const ply_header *h);

/* A name of a property, and where its value goes: the number of a value, or of a list. */
typedef struct ply_name {
    const char *name;
    uint8_t target;
    bool is_list;
} ply_name;

enum { PLY_VALUES = 24, PLY_LISTS = 2, PLY_NOWHERE = 255 };

/* The elements of one kind as rows of values and lists. */
typedef struct ply_rows {
    ply_source *source;
    const ply_element *element;
    const ply_property *properties; /* of the element */
    uint8_t *targets;               /* one per property */
    bool has_value[PLY_VALUES], has_list[PLY_LISTS];
    ply_type types[PLY_VALUES];
    double values[PLY_VALUES];
    size_t list_length[PLY_LISTS], list_room[PLY_LISTS];
    double *lists[PLY_LISTS];
} ply_rows;

/* Finds where each property of s->element goes; `names` ends in a null name. Properties that have
 * no name there, or whose target is taken, are warned of unless `is_quiet`. */
bool ply_rows_begin(ply_rows *rows, ply_source *s, const ply_header *h, const ply_name *names,
                    bool is_quiet);

/* Reads the next element. */
bool ply_rows_next(ply_rows *rows);
void ply_rows_free(ply_rows *rows);

/* Whether the element has all of these values; warns of those that stand alone. */
bool ply_rows_have(ply_rows *rows, int first, int count, const char *what);

/* The colours of vertices, faces and edges are the values from PLY_RED on. */
enum { PLY_RED, PLY_GREEN, PLY_BLUE, PLY_ALPHA, PLY_COLOR_COUNT };
#define PLY_COLOR_NAMES                                                                            \
    {"red", PLY_RED, false}, {"green", PLY_GREEN, false}, {"blue", PLY_BLUE, false},               \
        {"alpha", PLY_ALPHA, false}, {"r", PLY_RED, false}, {"g", PLY_GREEN, false},               \
        {"b", PLY_BLUE, false}, {"a", PLY_ALPHA, false}, {"diffuse_red", PLY_RED, false},          \
        {"diffuse_green", PLY_GREEN, false}, {"diffuse_blue", PLY_BLUE, false},                    \
    {                                                                                              \
        "diffuse_alpha", PLY_ALPHA, false                                                          \
    }

/* The colour of what has none in the file: red, green and blue. */
#define PLY_GREY 0.8f

/* The row's colour, grey if it has none: bytes are divided by 255, 16 bits by 65535; 32 bits hold
 * bytes, as writers use them; floats stay. */
void ply_rows_color(const ply_rows *rows, float color[4]);

/* The number of the texture of a primitive without one. */
#define PLY_NO_TEXTURE UINT32_MAX

/* Primitives of one kind. */
typedef struct ply_primitives {
    size_t corner_count, corner_room, wedge_room, color_room, texture_room;
    uint32_t *corners;  /* vertices */
    bool has_wedges;    /* texture coordinates of corners */
    float *wedges;      /* s and t of each corner */
    bool has_colors;    /* colours of primitives */
    float *colors;      /* four of each primitive */
    bool has_textures;  /* numbers of textures */
    uint32_t *textures; /* one of each primitive */
} ply_primitives;

/* A mesh as the file has it. Arrays that it lacks are null. */
typedef struct ply_mesh {
    size_t vertex_count;
    double *positions;
    float *normals, *colors, *texcoords;
    ply_primitives triangles, lines;
} ply_mesh;

/* Reads the elements of s->element into the mesh, whose vertices have been read. Faces are read
 * before strips, since they say what attributes triangles have. */
bool ply_read_faces(ply_source *s, const ply_header *h, ply_mesh *mesh);
bool ply_read_strips(ply_source *s, const ply_header *h, ply_mesh *mesh);
bool ply_read_edges(ply_source *s, const ply_header *h, ply_mesh *mesh);

/* Adds a corner for every vertex, for a cloud of points; not for those whose position is not
 * finite: scanners write so where they saw nothing. */
bool ply_add_points(model_reader *r, const ply_mesh *mesh, ply_primitives *points);
void ply_primitives_free(model_reader *r, ply_primitives *p);

/* Makes parts of the mesh's primitives; of its vertices as points if `has_points`. */
bool ply_make_parts(model_reader *r, const ply_header *h, ply_mesh *mesh, bool has_points);

#endif
