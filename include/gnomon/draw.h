/** @file
 * Drawing: a mesh passes through a pipeline into a target. */
#ifndef GNOMON_DRAW_H
#define GNOMON_DRAW_H

#include "backend.h"
#include "parallel.h"
#include "pipeline.h"
#include "statistics.h"

/** One array of vertex attributes, in the caller's memory. Components that the array lacks are 0,
 * 0, 0, 1; an attribute without data is 0, 0, 0, 1 for every vertex. With a divisor d (OpenGL's
 * VertexAttribDivisor) all vertices of instance i read element i / d, and the array must hold
 * (instance_count - 1) / d + 1 elements. With divisor 0 the array holds one element for every
 * vertex. */
typedef struct gn_attribute {
    const float *data;   /**< first component of the first vertex; null: absent */
    uint32_t components; /**< 1 to 4 if there is data */
    uint32_t stride;     /**< bytes from vertex to vertex, a multiple of 4; 0: tightly packed */
    uint32_t divisor;    /**< instances that share one element; 0: one element per vertex */
} gn_attribute;

/** The elements of a mesh's indices. */
typedef enum gn_index_format {
    GN_INDEX_NONE = 0, /**< vertices are drawn in order */
    GN_INDEX_UINT8,    /**< uint8_t */
    GN_INDEX_UINT16,   /**< uint16_t */
    GN_INDEX_UINT32    /**< uint32_t */
} gn_index_format;

/** The index that ends a strip, fan or list and begins a new one (PRIMITIVE_RESTART). It is
 * compared before base_vertex is added. */
typedef enum gn_restart {
    GN_RESTART_NONE = 0,    /**< no index does */
    GN_RESTART_FIXED_INDEX, /**< the largest value of the index format */
    GN_RESTART_INDEX        /**< the member restart_index */
} gn_restart;

/**
 * Vertices and the order in which they are drawn. A zeroed gn_mesh draws nothing.
 *
 *     field          OpenGL                                    zero value
 *     attribute      VertexAttribPointer                       0, 0, 0, 1 for all vertices
 *     .. divisor     VertexAttribDivisor                       one element per vertex
 *     vertex_count   none: reads stay below it                 0
 *     indices        ELEMENT_ARRAY_BUFFER                      null
 *     index_format   type of DrawElements                      GN_INDEX_NONE: DrawArrays
 *     first, count   of DrawArrays; offset, count of DrawElements  0
 *     restart        PRIMITIVE_RESTART, .._FIXED_INDEX         GN_RESTART_NONE: off
 *     restart_index  PrimitiveRestartIndex                     0
 *     base_vertex    DrawElementsBaseVertex                    0
 *     instance_count DrawArraysInstanced                       0, which draws one
 *
 * A draw takes elements first to first + count - 1: of the indices if there are any, otherwise of
 * the vertices. Elements left over after the last whole triangle or line are not drawn. */
typedef struct gn_mesh {
    gn_attribute attribute[GN_MAX_ATTRIBUTES];
    uint32_t vertex_count; /**< vertices in the attribute arrays */
    const void *indices;   /**< aligned to its element; ignored for GN_INDEX_NONE */
    gn_index_format index_format;
    uint32_t first;
    uint32_t count;

    /** Used only with indices. */
    gn_restart restart;
    uint32_t restart_index; /**< for GN_RESTART_INDEX */
    int32_t base_vertex;    /**< added to every index */

    uint32_t instance_count; /**< how many times the mesh is drawn, one after the other; 0 means
                                  1 */
} gn_mesh;

/** Memory that the library may use during a draw. It may have any alignment; nothing in it outlives
 * the call. Memory beyond 4 GiB is not used. A zeroed workspace with memory and size is valid, and
 * so is a copy of a workspace. The caller sets the members up to `statistics`; the library keeps
 * `chosen_backend` and returns `size_needed`.
 *
 * More memory than the minimum saves vertex shading. If the range from the least to the greatest
 * index is no longer than the number of indices, and its vertices fit, each vertex of the range is
 * shaded once, even one that no index names. If the indices advance through the vertices in order,
 * less is enough: as many vertices as a thousand successive indices name, rounded up to a power of
 * two. gn_workspace_size(vertex_count, varying_count) is enough for this on the calling thread,
 * gn_workspace_size_parallel on several threads. With less memory the draw is made in parts and
 * vertices are shaded for each index; the pixels are the same. */
typedef struct gn_workspace {
    /* The caller sets these; all but the first two may stay zero. */
    void *memory;          /**< not null */
    size_t size;           /**< bytes */
    gn_backend backend;    /**< GN_BACKEND_AUTO: the fastest; any other must be available */
    uint32_t threads;      /**< threads that run the tasks; 0: unknown, taken as 8. Few threads get
                                larger tasks; more than 64 gain nothing */
    gn_parallel *parallel; /**< null: only the calling thread; the pixels are the same */
    void *user;            /**< passed to parallel */

    /** Null, or a counter: a draw adds to it the number of its fragments that are covered, kept by
     * the shader and passed by the stencil and depth tests (OpenGL's query SAMPLES_PASSED). If a
     * pixel has several samples, samples are counted instead of fragments. The count is exact and
     * equal with every back end and any number of threads. */
    uint64_t *samples_passed;

    /** Null, or counts that a draw adds to: what became of its primitives and fragments
     * (gnomon/statistics.h). Both this and samples_passed may be set. Without either, drawing is
     * faster, because common states then take code of their own. */
    gn_draw_statistics *statistics;

    /* The library keeps this from draw to draw. */

    /** What GN_BACKEND_AUTO chose. Begin with GN_BACKEND_AUTO; the first draw asks the processor
     * (gn_backend_best) and writes the answer, which later draws take. */
    gn_backend chosen_backend;

    /* The library returns this. */

    /** Written with GN_WORKSPACE_TOO_SMALL alone: the least size that is enough. */
    size_t size_needed;
} gn_workspace;

/** Bytes of one vertex between the stages: window coordinates, snapped coordinates, clip
 * coordinates, outcode, and the varyings in rows of four. */
#define GN_WORKSPACE_VERTEX_SIZE(varying_count) (48 + 16 * (((size_t)(varying_count) + 3) / 4))

/** Bytes of one task's scratch: a triangle for each lane and the vertices that clipping makes. */
#if GN_LANES == 1
#define GN_WORKSPACE_TASK_SIZE(varying_count)                                                      \
    (64 + ((179 + 12 * (size_t)(varying_count)) & ~(size_t)63) +                                   \
     32 * GN_WORKSPACE_VERTEX_SIZE(varying_count))
#else
#define GN_WORKSPACE_TASK_SIZE(varying_count)                                                      \
    (2432 + 192 * (size_t)(varying_count) + 32 * GN_WORKSPACE_VERTEX_SIZE(varying_count))
#endif

/** gn_workspace_size as a constant expression, for static arrays. Precondition: the size fits a
 * size_t, and varying_count is within its limit. At least three vertices are stored, GN_LANES
 * at a time; 64 bytes are for alignment. */
#define GN_WORKSPACE_SIZE(vertex_count, varying_count)                                             \
    (64 + GN_WORKSPACE_TASK_SIZE(varying_count) +                                                  \
     (((vertex_count) > 3 ? (size_t)(vertex_count) : 3) + GN_LANES - 1) / GN_LANES * GN_LANES *    \
         GN_WORKSPACE_VERTEX_SIZE(varying_count))

GN_BEGIN

/** Returns the workspace bytes with which the calling thread shades each vertex of a mesh of
 * vertex_count vertices once. With vertex_count 0, returns the least that a draw with that many
 * varyings needs. Clip distances count as varyings: for a pipeline that has clip distances,
 * varying_count is the sum of both. Returns SIZE_MAX if the size would not fit a size_t or if
 * varying_count is above GN_MAX_VARYINGS + GN_MAX_CLIP_DISTANCES. */
GN_API size_t gn_workspace_size(uint32_t vertex_count, uint32_t varying_count);

/** Returns the workspace bytes that are best for drawing a mesh on several threads. vertex_count is
 * the number of the mesh's vertices; without indices, the number of vertices drawn. triangle_count
 * is the number of triangles, lines or points drawn. varying_count is that of gn_workspace_size,
 * clip distances included.
 *
 * Threads draw in rounds of some 57,000 triangles. The first phase of a round shades vertices, the
 * second finds what is visible, the third draws the target in bands of about equal work. With less
 * memory rounds are shorter, down to some hundreds of triangles; if not all vertices fit beside the
 * triangles, they are shaded for each index. With less memory than the shortest round takes, half a
 * megabyte or more, the calling thread draws alone.
 *
 * Returns SIZE_MAX in the cases of gn_workspace_size. */
GN_API size_t gn_workspace_size_parallel(uint32_t vertex_count, uint32_t triangle_count,
                                         uint32_t varying_count);

/** Returns the first fault of a mesh: GN_NULL_POINTER (mesh); GN_INVALID_ENUM (index format or
 * restart); GN_NOT_COMPILED (restarts or instances in a GN_BASIC library); GN_NULL_POINTER (no
 * indices although index_format needs them, unless count is 0); GN_MISALIGNED (indices). Then for
 * each attribute with data in turn: GN_MISALIGNED or GN_INVALID_ATTRIBUTE (components or stride).
 * Last GN_INDEX_OUT_OF_RANGE: without indices, first + count is above vertex_count, unless count is
 * 0; with indices, an index that is no restart, plus base_vertex in 32-bit arithmetic, is at or
 * above vertex_count. The memory of the indices must hold first + count elements; this cannot be
 * checked. */
GN_API gn_status gn_mesh_check(const gn_mesh *mesh);

/**
 * Draws a mesh. Returns GN_OK, or the first fault. Then nothing is drawn, except after the last one
 * of the list.
 *
 * @par Statuses
 * In the order of the checks:
 * - of the target, what gn_target_check returns;
 * - of the pipeline, what gn_pipeline_check returns for this target;
 * - of the mesh, what gn_mesh_check returns, but for its indices;
 * - GN_NULL_POINTER: the workspace or its memory;
 * - GN_WORKSPACE_TOO_SMALL: the workspace holds fewer bytes than gn_workspace_size(0, varying_count
 *   + clip_distance_count);
 * - GN_NOT_COMPILED: workspace->statistics is not null, but a GN_BASIC library cannot count;
 * - GN_BACKEND_UNAVAILABLE: the library does not contain workspace->backend;
 * - GN_INDEX_OUT_OF_RANGE: an index is at or above vertex_count;
 * - of a texture or sampler that the fragment shader looked up, what gn_texture_check or
 *   gn_sampler_check returns. The mesh is drawn, with opaque black in place of its texels.
 *
 * @par
 * gn_draw_fault says in words which field is wrong, but not of a texture or sampler that a shader
 * looks up: gn_texture_fault and gn_sampler_fault do. A wrong matrix is no fault:
 * gn_perspective_fault finds wrong arguments, and workspace->statistics what became of the mesh.
 *
 * @par After a fault
 * The target, workspace->samples_passed and workspace->statistics are as they were, except after a
 * fault of a texture or sampler. The contents of workspace->memory are unspecified, as after every
 * draw. With GN_WORKSPACE_TOO_SMALL workspace->size_needed is the number of bytes that is enough.
 *
 * @par Preconditions
 * The processor has the named back end (gn_backend_available); a draw does not ask, because asking
 * takes up to 50 microseconds on virtual machines. The FPU rounds to nearest, keeps denormals and
 * has its exceptions masked, as a C program starts. The stack has 96 KiB left, or 12 KiB with
 * GN_SMALL and GN_BASIC over one lane, and what the caller's shaders use. With GN_SMALL and
 * GN_BASIC, but without GN_DEBUG, textures and samplers that a caller's shader looks up are valid
 * (gn_texture_check, gn_sampler_check).
 *
 * @par Threads and aliasing
 * Draws may run on several threads at once if each has its own target, workspace and counters;
 * pipelines, meshes, textures and uniforms may be shared. The target must not overlap the mesh, the
 * workspace, textures or uniforms.
 *
 * @par Which pixels triangles cover
 * Triangles, lines and points are drawn in order. Positions are clipped to -w <= x, y, z <= w and
 * to clip distances that are not negative. depth.clip_depth and depth.clamp_enabled change the
 * bounds of z; a z that nothing clips may have any value. It may even be infinite or NaN if x and y
 * are not clipped either. Clipped positions are mapped to window coordinates, and vertices snap to
 * 1/256 pixel. A pixel is covered if its centre lies inside, or on a left edge or a horizontal
 * bottom edge (top edge, if the viewport's height is negative), so that triangles that share an
 * edge never both cover a pixel on it. If pixels have several samples, the rule applies to each
 * sample; gn_samples says how often and where the fragment shader runs.
 *
 * @par Which pixels points and lines cover
 * Points are squares. A point is drawn whole or not at all, depending on its centre. If pixels have
 * several samples, lines are rectangles. If a pixel has one sample, lines follow these rules. A
 * line that is at least as long along x as along y covers its width along y in every column; any
 * other line covers its width along x in every row. The diamond-exit rule (OpenGL 4.5 section
 * 14.5.1) decides the columns or rows at both ends: a line has the pixel in whose diamond it begins
 * and lacks the pixel in whose diamond it ends. The line's width does not change which pixels these
 * are, whereas OpenGL first shifts lines of even width by half a pixel.
 *
 * @par Lines of width 1 from pixel to pixel
 * Place the vertex of pixel (x, y) at x + 0.5 - 1/1024, y + 0.5 - 1/1024 in the window. (At the
 * centre itself, where rows of pixels tie, rounding errors of the transform would decide.) Then
 * - every line has the pixel it begins in, one pixel in each column or row, and not the pixel it
 *   ends in, so that a strip has every joint; a point of size 1 at the last vertex adds that pixel;
 * - a line that leads to the right, or up if it is longer along y, has the pixels nearest to the
 *   line between the centres (Bresenham's line). Of two that are equally near, a line that is
 *   longer along y has the left one; any other line has the upper one if it rises and the lower one
 *   if it falls. A line that leads the other way has pixels at most 1/256 pixel farther away than
 *   the nearest.
 *
 * @par
 * This placement needs window coordinates that are off by less than 1/1024 pixel, as they are with
 * gn_orthographic_rh_no(0, width, 0, height, ...) in targets of up to 4,096 pixels a side.
 *
 * @par Primitives that are not drawn
 * - primitives with a vertex whose x or y is not finite, whose z is not finite and is clipped (an
 *   infinite z is inside if w is infinite too), or whose w is NaN;
 * - primitives that a side of the view volume clips, with a vertex that has a coordinate that is
 *   not finite or whose distance w +- x, y or z to that side overflows;
 * - primitives, or the triangles that a clipped one is divided into, with a vertex whose place in
 *   the window is then not finite or lies more than 32,769 pixels from the origin. This takes an
 *   infinite w, or coordinates so large that clipping loses their digits. If a triangle is
 *   drawn as lines or points, only its edges or vertices with such a place are left out.
 *
 * @par Bits
 * Drawing follows OpenGL 4.5 chapters 10 to 17. The order of every operation is the reference's, so
 * that results are equal bit for bit. */
GN_API gn_status gn_draw(const gn_target *target, const gn_pipeline *pipeline, const gn_mesh *mesh,
                         gn_workspace *workspace);

/** Returns in words what gn_draw would refuse, in static storage; null if it would draw. The words
 * begin with the field: "color[0].width is not in 1 to GN_MAX_SIZE", "depth.function is no
 * gn_compare", "attribute[2].stride is no multiple of 4", "workspace.memory is null". Of several
 * faults it finds the one whose status gn_draw returns; a back end that the processor lacks, which
 * gn_draw takes for granted, is a fault here. Textures and samplers of a caller's shader are not
 * looked at. Draws nothing, writes nothing, and reads every index of the mesh. */
GN_API const char *gn_draw_fault(const gn_target *target, const gn_pipeline *pipeline,
                                 const gn_mesh *mesh, const gn_workspace *workspace);

GN_END

#endif
