/* Models: triangles, lines and points in plain arrays, whatever file they come from. */
#ifndef MODEL_H
#define MODEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <gnomon.h>

/* What a map holds. All maps of a part have the same texture coordinates. */
typedef enum map_kind {
    MAP_DIFFUSE = 0, /* colours, and alpha where the format says so */
    MAP_NORMAL,      /* normals in tangent space, or heights (MTL's bump) */
    MAP_SPECULAR,    /* colours of highlights */
    MAP_GLOW,        /* colours of light that the surface gives off */
    MAP_OPACITY,     /* MTL's map_d */
    MAP_ROUGHNESS,   /* glTF: roughness in green, metalness in blue */
    MAP_OCCLUSION,   /* glTF: in red */
    MAP_COUNT
} map_kind;

/* An image that maps show: a file that the model names, or an image file inside the model. */
typedef struct model_image {
    char *name;     /* the file as the model names it; of one inside the model, what it is called */
    uint8_t *bytes; /* the contents of an image file inside the model; otherwise null */
    size_t size;
    bool bare; /* the model holds texels that are not an image file */
} model_image;

/* The image of no map. */
#define MODEL_NO_IMAGE UINT32_MAX

/* A map of a material. */
typedef struct model_map {
    uint32_t image; /* its number in the model, or MODEL_NO_IMAGE */
    gn_wrap wrap_s, wrap_t;
    bool has_filters; /* the file names these; otherwise the viewer chooses */
    gn_minify minify;
    gn_magnify magnify;
    bool has_opacity; /* alpha in a MAP_DIFFUSE is opacity (glTF); otherwise it has no meaning */
    char channel;     /* MTL's -imfchan: r, g, b, m, l or z; 0: not given */
    float strength;   /* glTF's scale of normals and strength of occlusion, MTL's -bm; usually 1 */
} model_map;

/* What becomes of alpha (glTF 2.0, section 3.9.4). */
typedef enum model_alpha {
    MODEL_OPAQUE = 0, /* alpha has no meaning */
    MODEL_MASK,       /* what is below the cut-off is not there */
    MODEL_BLEND       /* the part is blended with what is behind it */
} model_alpha;

/* Highlights, unless a map overrides them. */
#define MODEL_MAX_EXPONENT 1024
typedef struct model_shine {
    float specular[3];
    uint32_t exponent; /* 1 to MODEL_MAX_EXPONENT */
} model_shine;

/* A material without its maps and without its base colour, which is in the vertices' colours. All
 * bytes are set, so that materials can be compared as memory: begin with model_surface_default. */
typedef struct model_surface {
    model_shine shine;
    uint32_t is_unlit;              /* KHR_materials_unlit, MTL's illum 0 */
    uint32_t has_linear_colors;     /* colours are linear light (glTF), otherwise as on a display */
    uint32_t culls_back;            /* back faces are not drawn (glTF, not double-sided) */
    uint32_t is_double_sided;       /* back faces are lit from behind (glTF) */
    uint32_t is_metallic_roughness; /* glTF's material; the members below then hold */
    float metallic, roughness;
    float emissive[3]; /* times the glow map; may be above 1 */
    model_alpha alpha;
    float alpha_cutoff; /* of MODEL_MASK */
} model_surface;

typedef enum model_kind { MODEL_TRIANGLES = 0, MODEL_LINES, MODEL_POINTS } model_kind;

/* A part is drawn in one draw: the primitives of one kind that share a material. */
typedef struct model_part {
    model_kind kind;
    uint32_t vertex_count;
    float *positions;       /* x, y, z, from the model's origin */
    bool has_normals;       /* in the file; otherwise they are computed */
    float *normals;         /* x, y, z, of any length except 0 */
    float *colors;          /* red, green, blue, alpha: the material's times the vertex's */
    bool has_vertex_colors; /* whether the file has colours of vertices */
    bool has_texcoords;
    float *texcoords; /* s, t; t grows upward. Null if the file has none */
    bool has_tangents;
    float *tangents; /* x, y, z, and 1 or -1: the bitangent is that number times normal x tangent.
                        Null without texture coordinates */
    uint32_t *smoothing; /* while a file is read: vertices of equal position get one normal only if
                            this number is equal too. Null: all are 0 */
    uint32_t index_count;
    uint32_t *indices; /* three per triangle, two per line, one per point */
    model_surface surface;
    model_map maps[MAP_COUNT];
    gn_transform world_from_model; /* where the part is drawn */
} model_part;

/* A light of a scene file, in the model's world. */
typedef struct model_light {
    gn_light_kind kind;
    float color[3];     /* times the intensity, as KHR_lights_punctual states it */
    double position[3]; /* of point and spot */
    float direction[3]; /* in which the light travels, unit length: of directional and spot */
    float range;        /* 0: unlimited */
    float inner, outer; /* of spot: half angles in radians */
} model_light;

typedef struct model {
    double origin[3]; /* is added to every position: far coordinates do not fit floats */
    size_t part_count;
    model_part *parts;
    uint32_t image_count;
    model_image *images;
    uint32_t light_count;
    model_light *lights;
    uint32_t material_count; /* of the file, used by primitives */
} model;

/* The material of a file that names none: opaque, with weak highlights that show the shape. */
model_surface model_surface_default(void);

/* A map of an image, or of MODEL_NO_IMAGE, that repeats and has strength 1. */
model_map model_map_of(uint32_t image);

/* Which maps of a set, of 1 << map_kind, repeat otherwise than the first of them. Maps without an
 * image of the model count for none. */
unsigned int model_maps_unlike_first(const model_part *part, unsigned int maps);

/* Vertices of a primitive: 3, 2 or 1; and what the library calls a list of such primitives. */
uint32_t model_corners(model_kind kind);
gn_topology model_topology(model_kind kind);

/* Allocates a part's arrays, zeroed, and places it where its model is; texture coordinates and
 * tangents only if has_texcoords and has_tangents ask for them. Returns false if there is not
 * enough memory; model_free frees what was allocated. */
bool model_part_allocate(model_part *part, uint32_t vertex_count, uint32_t index_count);

/* Makes a model of one part, whose arrays it allocates likewise, with texture coordinates and
 * tangents or without. Returns false, with nothing to free, if there is not enough memory. */
bool model_allocate(model *m, bool has_texcoords, uint32_t vertex_count, uint32_t index_count);

/* The bytes that model_part_allocate allocates. */
uint64_t model_part_size(const model_part *part, uint32_t vertex_count, uint32_t index_count);

void model_part_free(model_part *part);
void model_free(model *m);

/* The angle of creases if the user names none. */
#define MODEL_CREASE_DEGREES 40.0

/* Computes the normal of every vertex whose normal is zero or not finite: the sum of the normals of
 * the triangles around its position, weighted by their angles there (Thürmer and Wüthrich,
 * "Computing Vertex Normals from Polygonal Facets", 1998), over all parts. Vertices of equal
 * position and smoothing count as one.
 *
 * An edge is a crease if the normals of its triangles differ by more than `crease_degrees`, 0 to
 * 180. Where creases divide the triangles around a position into groups, each group has a normal of
 * its own, and the vertices that groups share are copied. Vertices with a smoothing are not
 * divided. Where more than two triangles share an edge, each is compared with the one before it.
 * Triangles that share only the position are divided too, but not if all there face within half of
 * the angle from the normal. With 180 nothing is divided.
 *
 * Takes what longer arrays need from *memory_left. Returns false if there is not enough memory,
 * also while it works; the model can then only be freed. */
bool model_complete_normals(model *m, double crease_degrees, uint64_t *memory_left);

/* Computes the tangents of a part that has_tangents, where the file has none and their fourth
 * number is 0: along growing s, across the normal. Returns false if there is not enough memory. */
bool model_complete_tangents(model_part *part);

/* The bytes that model_complete_tangents allocates. */
uint64_t model_tangents_size(const model_part *part);

/* Whether a triangle, of three corners of a part, has no area: its edges are parallel, or one has
 * no length. */
bool model_is_flat(const model_part *part, const uint32_t corner[3]);

uint64_t model_triangle_count(const model *m);
uint64_t model_primitive_count(const model *m, model_kind kind);

#endif
