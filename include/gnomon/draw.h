/* Drawing: a mesh goes through a pipeline into a target. */
#ifndef GNOMON_DRAW_H
#define GNOMON_DRAW_H

#include "backend.h"
#include "parallel.h"
#include "pipeline.h"

/* One array of vertex attributes, in the caller's memory. Components that the
 * array lacks are 0, 0, 0, 1; so is all of an attribute without data. With a divisor d (OpenGL's
 * VertexAttribDivisor) all vertices of instance i have element i / d, and the array must
 * hold one for every instance; with 0 it has one for every vertex. */
typedef struct gn_attribute {
    const float *data;   /* the first vertex's first component; null: absent */
    uint32_t components; /* 1 to 4 where there is data */
    uint32_t stride;     /* bytes from vertex to vertex, a multiple of 4; 0: tightly packed */
    uint32_t divisor;    /* instances that an element serves; 0: elements are vertices' */
} gn_attribute;

typedef enum gn_index_format {
    GN_INDEX_NONE = 0, /* vertices are taken in order */
    GN_INDEX_UINT8,
    GN_INDEX_UINT16,
    GN_INDEX_UINT32
} gn_index_format;

/* Which index ends a strip, fan or list and starts it anew (PRIMITIVE_RESTART). It is compared
 * before base_vertex is added. */
typedef enum gn_restart {
    GN_RESTART_NONE = 0,
    GN_RESTART_FIXED_INDEX, /* the largest of the index format */
    GN_RESTART_INDEX        /* restart_index */
} gn_restart;

/* Vertices and the order to take them in. A zeroed gn_mesh draws nothing.
 *
 *   field          OpenGL                                    zero value
 *   attribute      VertexAttribPointer                       0, 0, 0, 1 for all vertices
 *   .. divisor     VertexAttribDivisor                       elements are vertices'
 *   vertex_count   none: reads stay below it                 0
 *   indices        ELEMENT_ARRAY_BUFFER                      null
 *   index_format   type of DrawElements                      GN_INDEX_NONE: DrawArrays
 *   first, count   of DrawArrays; offset, count of DrawElements  0
 *   restart        PRIMITIVE_RESTART, .._FIXED_INDEX         GN_RESTART_NONE: off
 *   restart_index  PrimitiveRestartIndex                     0
 *   base_vertex    DrawElementsBaseVertex                    0
 *   instance_count DrawArraysInstanced                       0, which draws one
 *
 * Elements first to first + count - 1 are drawn: of the indices where there are any, otherwise
 * of the vertices. What is left over after the last whole triangle or line is not drawn. */
typedef struct gn_mesh {
    gn_attribute attribute[GN_MAX_ATTRIBUTES];
    uint32_t vertex_count; /* vertices in the attribute arrays */
    const void *indices;   /* null for GN_INDEX_NONE; aligned to its element */
    gn_index_format index_format;
    uint32_t first;
    uint32_t count;

    /* Of indices alone. */
    gn_restart restart;
    uint32_t restart_index; /* of GN_RESTART_INDEX */
    int32_t base_vertex;    /* added to every index */

    uint32_t instance_count; /* times that all is drawn, one after the other; 0 means 1 */
} gn_mesh;

/* Memory the library may use during a draw; nothing in it outlives the call.
 * Any alignment; of more than 4 GiB the rest is not used. More memory than the minimum saves
 * vertex shading: where the range of vertices that the indices name is no longer than the
 * indices drawn, and fits, each vertex of it is shaded once, named or not. Where the indices
 * go along with the vertices it is enough that those fit which are in use at once.
 * gn_workspace_size(vertex_count, varying_count) is enough for that on the calling thread,
 * gn_workspace_size_parallel on several. Otherwise the draw is made in parts, vertices are
 * shaded for each index, and the pixels are the same. */
typedef struct gn_workspace {
    void *memory;
    size_t size;           /* bytes */
    gn_backend backend;    /* GN_BACKEND_AUTO: the fastest; another must be available */
    gn_parallel *parallel; /* null: the calling thread alone; the pixels are the same */
    void *user;            /* for parallel */
    uint32_t threads;      /* that run parallel's tasks; 0: not known. Few divide less finely */
    size_t needed;         /* written with GN_WORKSPACE_TOO_SMALL: the least size there is */

    /* Null, or what a draw adds the number of its fragments to that are covered, kept by the
     * shader and passed by stencil and depth tests: a query of SAMPLES_PASSED, of samples where a
     * pixel has several. Exact with any back end and threads. */
    uint64_t *samples_passed;
} gn_workspace;

/* Bytes of one vertex between the stages: window, snapped and clip coordinates, outcode,
 * and the varyings in rows of four. */
#define GN_WORKSPACE_VERTEX_SIZE(varying_count) (48 + 16 * (((size_t)(varying_count) + 3) / 4))

/* Bytes of what is under way: sixteen triangles and the vertices that clipping makes. */
#define GN_WORKSPACE_TASK_SIZE(varying_count)                                                      \
    (2432 + 192 * (size_t)(varying_count) + 32 * GN_WORKSPACE_VERTEX_SIZE(varying_count))

/* gn_workspace_size as a constant expression, for static arrays, where the size fits a
 * size_t and varying_count its limit. Vertices come sixteen at a time; 64 bytes are for
 * alignment. */
#define GN_WORKSPACE_SIZE(vertex_count, varying_count)                                             \
    (64 + GN_WORKSPACE_TASK_SIZE(varying_count) +                                                  \
     ((vertex_count) == 0 ? 1 : ((size_t)(vertex_count) + GN_LANES - 1) / GN_LANES) * GN_LANES *   \
         GN_WORKSPACE_VERTEX_SIZE(varying_count))

GN_BEGIN

/* In what follows, clip distances count as varyings: for a pipeline that has some, varying_count is
 * the sum of both. */

/* Workspace bytes with which the calling thread shades each vertex of a mesh of that many
 * once. With vertex_count 0, the least a draw with that many varyings needs.
 * SIZE_MAX where the size would not fit a size_t or varying_count is above
 * GN_MAX_VARYINGS + GN_MAX_CLIP_DISTANCES. */
GN_API size_t gn_workspace_size(uint32_t vertex_count, uint32_t varying_count);

/* Workspace bytes with which a mesh of that many vertices (without indices, as many as are
 * drawn) and triangles is best drawn on several threads. They draw in rounds of some 57,000
 * triangles: first the vertices are shaded, then what can be seen is found, then rows of the
 * target are drawn. With less memory rounds are shorter, down to some hundreds of triangles,
 * and where not all vertices fit beside them, they are shaded for each index. With less
 * than such a round takes, some hundred kilobytes, the calling thread draws alone.
 * SIZE_MAX as above. */
GN_API size_t gn_workspace_size_parallel(uint32_t vertex_count, uint32_t triangle_count,
                                         uint32_t varying_count);

/* The first fault of a mesh: GN_NULL_POINTER (mesh), GN_INVALID_ENUM (index format or restart),
 * GN_NULL_POINTER (indices that its index format asks for, unless count is 0),
 * GN_MISALIGNED (indices); then for each attribute with data in turn GN_MISALIGNED or
 * GN_INVALID_ATTRIBUTE (components or stride); last GN_INDEX_OUT_OF_RANGE (first + count
 * beyond vertex_count without indices, or an index that is no restart and, with base_vertex
 * added as numbers of 32 bits are, at or beyond vertex_count; the
 * indices themselves must hold first + count elements, which cannot be checked). */
GN_API gn_status gn_mesh_check(const gn_mesh *mesh);

/* The same fault in words that name the field, such as "attribute[2].stride is no multiple of
 * 4", in static storage; null where there is none. */
GN_API const char *gn_mesh_fault(const gn_mesh *mesh);

/* Draws a mesh. Checks the target, the pipeline, the mesh (gn_target_check,
 * gn_pipeline_check, gn_mesh_check), then that the target's colour has a fragment
 * shader (GN_NO_SHADER), that the library was not compiled
 * without what is asked (GN_NOT_COMPILED), and that the workspace is there (GN_NULL_POINTER) and
 * holds at least gn_workspace_size(0, varying_count + clip_distance_count) bytes
 * (GN_WORKSPACE_TOO_SMALL, and workspace->needed says how many), and that the library holds its
 * back end (GN_BACKEND_UNAVAILABLE). An index at or beyond vertex_count is found last. On a fault
 * nothing is drawn.
 *
 * Triangles, lines and points are drawn in order. Positions are clipped to -w <= x, y, z <= w (of
 * z, as depth.clip_depth and depth.clamp say; then a z that is clipped against nothing may be anything)
 * and to clip distances that are not negative, points being drawn whole or not at all, by their
 * centre, and mapped to window coordinates;
 * vertices snap to 1/256 pixel; a pixel is covered where its centre lies inside, or on a left edge
 * or a horizontal bottom edge, so that triangles sharing an edge never both cover a pixel on it.
 * Where pixels have several samples, the same is asked of each sample, and lines are rectangles;
 * the fragment shader runs once a pixel, at its centre.
 *
 * Points are squares. Where a pixel has one sample, lines are drawn as follows. A line that is
 * longer along x, or as long, covers its width along y in every column; any other line covers its
 * width along x in every row. The diamond-exit rule (OpenGL 4.5 section 14.5.1) decides the columns
 * or rows at both ends: a line has the pixel in whose diamond it begins and lacks the one in whose
 * diamond it ends. Its width does not change that, while OpenGL shifts lines of even width by half
 * a pixel first. A vertex at the very centre of a pixel breaks this rule, here and in the
 * reference: a line that is longer along y and leads down lacks the pixel it begins in.
 *
 * To draw lines of width 1 from pixel to pixel, place the vertex of pixel (x, y) at
 * x + 0.5 - 1/1024, y + 0.5 - 1/1024 in the window. Then
 * - every line has the pixel it begins in, one pixel in each column or row, and not the pixel it
 *   ends in, so that a strip has every joint; a point of size 1 at the last vertex adds that pixel;
 * - a line that leads to the right, or up if it is longer along y, has the pixels nearest to the
 *   line between the centres, of two as near the one to its left: Bresenham's line. A line that
 *   leads the other way has pixels at most 1/256 pixel farther away than the nearest.
 * This needs window coordinates that are off by less than 1/1024 pixel, as they are under
 * gn_orthographic_rh_no(0, width, 0, height, ...) in targets of up to 4,096 pixels a side.
 *
 * OpenGL 4.5 chapters 10 to 17; the order of every operation is the reference rasterizer's, so that
 * results are equal bit for bit (reference/RULES.md). Not drawn are primitives
 * - with a vertex whose x, y or z is not finite or whose w is NaN,
 * - to be clipped, with a vertex whose distance w +- x, y or z to a plane they cross
 *   is not finite,
 * - with a vertex left more than 32,768 pixels from the origin after clipping, which
 *   takes coordinates so large that clipping loses their digits.
 *
 * Preconditions: the processor has the back end that is named (gn_backend_available); it is not
 * asked, since that takes 20 microseconds on some virtual machines. The FPU rounds to nearest,
 * keeps denormals and has its exceptions masked, as a C program starts. The target must not overlap
 * the mesh, the workspace, textures or uniforms. */
GN_API gn_status gn_draw(const gn_target *target, const gn_pipeline *pipeline, const gn_mesh *mesh,
                         gn_workspace *workspace);

GN_END

#endif
