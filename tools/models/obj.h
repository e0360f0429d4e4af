/* What the stages of the reader of OBJ share. The format is that of Wavefront's "Advanced
 * Visualizer" manual, appendix B1.
 *
 *   obj_vertices.c  reads v, vt, vn and mtllib, wherever they stand
 *   obj_faces.c     reads f, l and p into groups of triangles, lines and points
 *   obj_parts.c     makes a part of every group
 *   obj.c           runs these stages, and reads the other statements
 *
 * All vertices are read before the first face, so that a face may name those that come later, and
 * an index out of range is found on its line. */
#ifndef OBJ_H
#define OBJ_H

#include "mtl.h"
#include "polygon.h"
#include "read.h"

/* No number of a vertex, of texture coordinates or of a normal. */
#define OBJ_NONE UINT32_MAX

/* The numbers behind v, vt and vn. */
typedef struct obj_vertices {
    double (*positions)[3]; /* what fits no float is NaN */
    float (*colors)[4];     /* null: no vertex has one */
    float (*texcoords)[2];
    float (*normals)[3];
    size_t position_count, texcoord_count, normal_count;
    size_t position_room, color_room, texcoord_room, normal_room;
    size_t file_normal_count; /* behind these come normals of flat faces */
} obj_vertices;

/* A corner of a face: numbers from 0, or OBJ_NONE. */
typedef struct obj_corner {
    uint32_t v, vt, vn;
} obj_corner;

/* A vertex of a group. */
typedef struct obj_vertex {
    obj_corner corner;
    uint32_t smoothing;
    uint32_t group, index;
    uint32_t next; /* the vertex before it with this v, plus 1; 0: there is none */
} obj_vertex;

/* Primitives that become one part. */
typedef struct obj_group {
    model_kind kind;
    uint32_t material; /* MTL_NO_MATERIAL: none */
    bool has_texcoords, has_normals, has_colors, has_smoothing;
    uint32_t vertex_count;
    uint32_t *indices;
    size_t index_count, index_room;
} obj_group;

/* Groups of one material: kinds, and three presences. */
#define OBJ_GROUPS_OF_MATERIAL 24

typedef struct obj_reader {
    model_reader *r;
    obj_vertices vertices;
    mtl_materials materials;

    /* Where reading is. */
    size_t positions_before, texcoords_before, normals_before;
    uint32_t material;  /* of usemtl */
    uint32_t smoothing; /* of s */
    obj_corner *corners;
    size_t corner_count, corner_room;
    polygon polygon;

    /* What was read. */
    obj_group *groups;
    size_t group_count, group_room;
    uint32_t *group_of; /* by material and presences; number plus 1 */
    size_t group_of_count;
    obj_vertex *group_vertices;
    size_t group_vertex_count, group_vertex_room;
    uint32_t *last_vertex; /* of each v: number plus 1 */
} obj_reader;

/* The smoothing of faces before any s, and of those behind s off. */
#define OBJ_SMOOTH_ALL 0
#define OBJ_FLAT UINT32_MAX

/* Reads the rest of a statement f, l or p. */
bool obj_read_face(obj_reader *o, text_cursor *t, text_word keyword);

/* Makes a point of every vertex, for a file that has nothing else: a cloud of points. */
bool obj_add_cloud(obj_reader *o);

/* Reads all v, vt, vn and mtllib of the file. */
bool obj_read_vertices(obj_reader *o);

/* Whether a vertex has a colour. */
bool obj_has_color(const obj_vertices *v, uint32_t vertex);

/* Makes parts of the groups. */
bool obj_make_parts(obj_reader *o);

/* Cuts a word at #, which begins a comment, and skips the rest of the line. Returns false if there
 * is no # behind its first character. */
bool obj_cut_comment(text_cursor *t, text_word *word);

/* A cursor at the beginning of the file. */
text_cursor obj_begin(const model_reader *r);

#endif
