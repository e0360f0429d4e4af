/* What the files of the glTF reader share. "Section" in their comments is one of the glTF 2.0
 * specification, version 2.0.1, of the Khronos Group.
 *
 * gltf.c             the container, the version and the extensions; runs the stages
 * gltf_values.c      values of the JSON, checked
 * gltf_buffers.c     URIs, buffers and views of them
 * gltf_accessors.c   typed arrays in buffers
 * gltf_materials.c   materials, textures and images
 * gltf_nodes.c       the hierarchy of nodes: places of meshes, skins and lights
 * gltf_primitives.c  primitives of meshes: what they are made of, and their indices
 * gltf_parts.c       parts of the model from the primitives at their places */
#ifndef GLTF_H
#define GLTF_H

#include "json.h"

/* No element of a table. */
#define GLTF_NONE UINT32_MAX

/* The arrays at the root of the file whose elements others name by number. */
typedef enum gltf_table {
    GLTF_ACCESSORS = 0,
    GLTF_BUFFER_VIEWS,
    GLTF_BUFFERS,
    GLTF_IMAGES,
    GLTF_MATERIALS,
    GLTF_MESHES,
    GLTF_NODES,
    GLTF_SAMPLERS,
    GLTF_SCENES,
    GLTF_SKINS,
    GLTF_TEXTURES,
    GLTF_LIGHTS,
    GLTF_TABLES
} gltf_table;

typedef struct gltf_elements {
    uint32_t count;
    uint32_t *tokens;
} gltf_elements;

/* Bytes, and who frees them. */
typedef struct gltf_bytes {
    const uint8_t *bytes;
    size_t size;
    bool is_read;
    uint8_t *decoded; /* from a data: URI */
    size_t decoded_size;
    model_file file;
    bool is_file;
} gltf_bytes;

/* An accessor (section 3.6.2). Elements that are not in `bytes` are zero. */
typedef struct gltf_accessor {
    uint32_t token;
    uint32_t count;
    uint32_t component_type;
    uint32_t components;
    bool is_normalized;
    const uint8_t *bytes; /* null: zeros */
    size_t stride;
    uint32_t sparse_count; /* elements that are replaced */
    uint32_t sparse_type;
    const uint8_t *sparse_indices, *sparse_values;
} gltf_accessor;

enum {
    GLTF_I8 = 5120,
    GLTF_U8 = 5121,
    GLTF_I16 = 5122,
    GLTF_U16 = 5123,
    GLTF_U32 = 5125,
    GLTF_F32 = 5126
};

/* A 3 x 4 matrix by columns: m[3] is the translation. The last row of all matrices is 0 0 0 1. */
typedef struct gltf_matrix {
    double m[4][3];
} gltf_matrix;

typedef struct gltf_material {
    bool is_read;
    model_surface surface;
    float color[4];
    model_map maps[MAP_COUNT];
    bool has_maps;
    uint32_t texcoord;    /* the set of texture coordinates of the maps */
    double transform[6];  /* u' = [0] u + [1] v + [2], v' = [3] u + [4] v + [5] */
    uint32_t first_group; /* of the groups with this material */
} gltf_material;

/* A mesh at a place. */
typedef struct gltf_placement {
    uint32_t node, mesh;
    gltf_matrix world;
} gltf_placement;

typedef struct gltf_skin {
    uint32_t joint_count;
    gltf_matrix *joints; /* null: not yet computed */
} gltf_skin;

enum { GLTF_JOINT_SETS = 2 };

/* A primitive of a mesh. */
typedef struct gltf_primitive {
    uint32_t token;
    uint32_t mode;
    model_kind kind;
    uint32_t material; /* in gltf.materials */
    uint32_t group;
    gltf_accessor position, normal, tangent, texcoord, color; /* count 0: absent */
    gltf_accessor joints[GLTF_JOINT_SETS], weights[GLTF_JOINT_SETS];
    gltf_accessor indices;
    bool is_indexed;
    uint32_t first_vertex, vertex_count; /* those that the indices name */
    uint64_t index_count;                /* in the part */
    uint32_t targets;                    /* the token of the morph targets, or JSON_NONE */
    uint32_t next;                       /* of the same mesh, or GLTF_NONE */
} gltf_primitive;

/* Primitives that make one part. */
typedef struct gltf_group {
    model_kind kind;
    bool has_normals, has_texcoords, has_colors;
    uint32_t material;
    uint32_t next; /* of the same material, or GLTF_NONE */
    uint64_t vertex_count, index_count;
    size_t part;
    uint32_t vertices_done, indices_done;
} gltf_group;

typedef struct gltf {
    model_reader *r;
    json j;
    char path[160];
    gltf_elements tables[GLTF_TABLES];
    const uint8_t *binary; /* the binary chunk, or null */
    size_t binary_size;
    gltf_bytes *buffers;
    uint32_t *images;         /* their numbers in the model, or GLTF_NONE */
    gltf_material *materials; /* those of the file, and the default one last */
    gltf_skin *skins;
    uint32_t *parents;  /* of nodes, or GLTF_NONE */
    gltf_matrix *world; /* of nodes */
    uint32_t *meshes;   /* their first primitives, or GLTF_NONE */
    bool *is_mesh_read;
    gltf_primitive *primitives;
    size_t primitive_count, primitive_capacity;
    gltf_group *groups;
    size_t group_count, group_capacity;
    gltf_placement *placements;
    size_t placement_count, placement_capacity;
} gltf;

/* Finds the elements of all tables. */
bool gltf_read_tables(gltf *g);
void gltf_free_tables(gltf *g);

/* Where a token is; the next call overwrites it. */
const char *gltf_path(gltf *g, uint32_t token);

/* The token of an element of a table. */
uint32_t gltf_element(const gltf *g, gltf_table table, uint32_t index);

/* Each sets *value to what a member of an object holds, and leaves it if the member is not there.
 * They return false with a fault that names the member if it is of another kind. */
bool gltf_integer(gltf *g, uint32_t object, const char *name, uint64_t most, uint64_t *value);
bool gltf_number(gltf *g, uint32_t object, const char *name, double *value);
bool gltf_numbers(gltf *g, uint32_t object, const char *name, uint32_t count, double *values);
bool gltf_boolean(gltf *g, uint32_t object, const char *name, bool *value);
bool gltf_index(gltf *g, uint32_t object, const char *name, gltf_table table, uint32_t *value);

/* The same for a member that is an array or an object; its token is JSON_NONE if it is not there.
 */
bool gltf_container(gltf *g, uint32_t object, const char *name, json_kind kind, uint32_t *token);

/* The element of a table that a token names. */
bool gltf_index_of(gltf *g, uint32_t token, gltf_table table, uint32_t *value);

/* The token of an extension of an object, or JSON_NONE. */
uint32_t gltf_extension(const gltf *g, uint32_t object, const char *name);

/* The bytes of a data: URI, decoded to memory of *size bytes that reader_release frees. Returns
 * null with the fault recorded. */
bool gltf_is_data_uri(const gltf *g, uint32_t token);
uint8_t *gltf_data_uri(gltf *g, uint32_t token, size_t *size);

/* The name of a file that a URI names, percent-decoded, in memory of *capacity bytes that
 * reader_release frees. Returns null with the fault recorded. */
char *gltf_file_name(gltf *g, uint32_t token, size_t *capacity);

/* The bytes of a view of a buffer. */
bool gltf_view(gltf *g, uint32_t view, const uint8_t **bytes, size_t *size, size_t *stride);
void gltf_free_buffers(gltf *g);

/* Reads and checks an accessor: all its bytes are there. */
bool gltf_read_accessor(gltf *g, uint32_t index, gltf_accessor *a);

/* Returns false with a fault if the accessor that a token names has so many elements, and bytes for
 * none of them, that a small file would make a large model. Sparse elements are no excuse. */
bool gltf_has_bytes(gltf *g, uint32_t token, const gltf_accessor *a);

/* The bytes of one component. */
size_t gltf_component_size(uint32_t type);

/* Converts elements to floats, integers by section 3.6.2.2 if they are normalized: those that
 * `which` names, or if it is null those from `first` on. */
void gltf_floats(const gltf_accessor *a, const uint32_t *which, uint32_t first, uint32_t count,
                 float *values);

/* The first component of elements of an accessor of unsigned integers. */
void gltf_integers(const gltf_accessor *a, uint32_t first, uint32_t count, uint32_t *values);

/* Reads a material at its first use; the default one has the number of all others. */
bool gltf_read_material(gltf *g, uint32_t index, const gltf_material **material);

gltf_matrix gltf_identity(void);
gltf_matrix gltf_multiply(const gltf_matrix *a, const gltf_matrix *b);
double gltf_determinant(const gltf_matrix *m);

/* Reads the hierarchy: the places of all meshes of the scene, and the lights. */
bool gltf_read_nodes(gltf *g);

/* The matrices of a skin's joints. */
bool gltf_read_skin(gltf *g, uint32_t index, const gltf_skin **skin);

/* Reads the primitives of a mesh at its first use. */
bool gltf_read_mesh(gltf *g, uint32_t mesh);

/* The number that a primitive's source has of indices: those of its accessor, or its vertices. */
uint32_t gltf_source_count(const gltf_primitive *p);

/* The source indices, in memory that reader_release frees; null with the fault recorded. */
uint32_t *gltf_source_indices(gltf *g, const gltf_primitive *p);

/* Makes single points, lines or triangles of the source indices (section 3.7.2.1), and counts
 * vertices from first_vertex on; is_turned exchanges two corners of triangles. Null `indices`: only
 * counts. Returns the count. */
uint64_t gltf_expand(const gltf_primitive *p, const uint32_t *source, bool is_turned,
                     uint32_t *indices);

/* Reads a morph target's accessor of an attribute; its count is 0 if there is none. */
bool gltf_read_target(gltf *g, const gltf_primitive *p, uint32_t target, const char *name,
                      gltf_accessor *a);

/* Makes the parts. */
bool gltf_make_parts(gltf *g);

#endif
