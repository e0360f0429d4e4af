/* A checked draw, as a back end receives it, and the words of drawing.
 *
 * The way from gn_draw to a pixel, for a triangle with vertex colours that is smaller than 64
 * pixels, without indices, on one thread, with GN_FORMAT_RGBA8 and D24: the files that do its work,
 * in that order. A file may call several of the files below it.
 *
 *   src/draw/draw.c                 gn_draw
 *   src/draw/prepare.c              prepares the job: checks, sizes, the workspace
 *   src/formats/surface.c           gn_target_check
 *   src/draw/check.c                the first fault of pipeline and mesh
 *   src/backends/choose.c           which back end is best on this processor
 *   src/backends/entry_points.h     shading_on and draw_on, by the number of the back end
 *   src/backends/backend.inl        the text of a back end, which src/backends/avx2.c compiles
 *   kernel/draw/mesh.inl            draw_mesh, draw_slice, draw_segment
 *   kernel/draw/draw_state.inl      set_draw_state, once a draw
 *   kernel/fragment/resolve_state.inl  set_fragment_state, once a draw
 *   kernel/draw/vertices.inl        shade_slots, store_vertices; between them the vertex shader
 *   kernel/geometry/fetch_attributes.inl  fetch_attributes
 *   kernel/shaders/vertex.inl       shade_plain, the ready-made vertex shader
 *   kernel/geometry/viewport.inl    place_vertices
 *   kernel/draw/primitives.inl      add_primitives
 *   kernel/draw/elements.inl        locate_elements
 *   kernel/geometry/assemble.h      assemble_triangles
 *   kernel/draw/triangles.inl       add_group
 *   kernel/raster/cull.inl          cull_triangles
 *   kernel/draw/list.inl            append_triangle, flush_list, draw_list
 *   kernel/raster/setup.inl         setup_triangles
 *   kernel/raster/coverage.inl      cover_triangles
 *   kernel/raster/cover_small.inl   cover_small
 *   kernel/raster/block_queue.inl   add_square, flush_queue
 *   kernel/fragment/fused.inl       color_d24_blocks, which fragment_functions_of chose
 *   kernel/fragment/loops.inl       shade_blocks, shade_block, ready_made_color
 *   kernel/fragment/depth.inl       test_depth
 *   kernel/fragment/planes.inl      interpolate
 *   kernel/fragment/output.inl      write_rgba8, write_pixels
 *   formats/pixel_rows.h            store_pixels
 *
 * Other ways: with indices, scan_indices and map_slots (mesh.inl) find the vertices that they name,
 * and draw_shared_segment shades each once; on several threads, draw_rounds (rounds.inl) calls
 * shade_slots, add_primitives and draw_list in shade_task, cull_task and band_task;
 * kernel/raster/cover_large.inl from 64 pixels on, kernel/raster/cover_packed.inl if fragments call
 * a shader (kernel/fragment/shader.inl), which looks up textures by kernel/texture/lookup.inl, and
 * take_steps (kernel/fragment/steps.inl) in states that are not fused (fused.inl).
 *
 * Glossary. Each word has this meaning alone in kernel/draw, geometry, raster and fragment;
 * triangle strips and fans are topologies, and numbers are rounded where a function's name says so.
 * Sixteen stands for LANES (lanes/count.h): with one lane, groups, lists and blocks hold one, and a
 * square is one pixel.
 *
 *   element  an index of the mesh, or a vertex of a mesh without indices
 *   slice    the elements of one instance between two restarts
 *   segment  the elements of a slice that the reference takes at a time (segment_elements)
 *   chunk    a part of a mesh's indices, scanned for its range of vertices before it is drawn
 *   slot     the place of a shaded vertex in the workspace
 *   packet   sixteen slots, which are shaded together
 *   group    up to sixteen assembled triangles, as offsets of their vertices
 *   piece    one of the triangles that a clipped triangle is divided into
 *   list     up to sixteen primitives that can be seen, with their bounds; all of one kind
 *   sink     where a full list goes: it is drawn, or stored for the bands
 *   set-up   the primitives of a list with edge functions and planes
 *   square   4x4 pixels, at even coordinates
 *   half     the lower or the upper two rows of a square
 *   block    sixteen pixels that are shaded at once, one a lane: a square, two halves,
 *            or a row of sixteen
 *   span     neighbouring covered squares of a row of squares that are handed to fragments together
 *   queue    blocks that coverage has found and fragments have not shaded
 *   batch    blocks that take a step together
 *   step     one loop over the blocks of a batch: test, source, encode, load, combine or store
 *   opaque   of a triangle: alpha is 1, and depths need no clamp (setup_opaque)
 *   fate     what becomes of a primitive: drawn, or why not (fates.inl)
 *   task     one call of a gn_task, on any thread
 *   worker   the state of one thread's work on primitives
 *   round    consecutive segments of a slice that tasks cull, and then draw, together
 *   phase    tasks that run at the same time: they scan chunks, shade, cull, or draw bands
 *   band     the rows of the target that one task of a round draws */
#ifndef GN_KERNEL_DRAW_JOB_H
#define GN_KERNEL_DRAW_JOB_H

#include "../../config/features.h"
#include "../geometry/mesh_slice.h"
#include "../shaders/shading.h"

/* A draw as a back end receives it. */
typedef struct draw_job {
    const gn_target *target;
    const gn_pipeline *pipeline;
    shading_functions shading;
    const mesh_slice *mesh; /* all elements of the first instance */
    uint32_t instances;
    unsigned char *memory; /* aligned; a vertex is named by its offset from here */
    uint32_t memory_size;

    gn_parallel *parallel; /* null: the calling thread draws alone */
    void *user;
    uint32_t threads;               /* how many run tasks, or UNKNOWN_THREADS */
    uint64_t *samples_passed;       /* null: not counted */
    gn_draw_statistics *statistics; /* likewise */
} draw_job;

static inline bool counts_samples(const draw_job *job)
{
    return job->samples_passed || (GN_HAVE_STATISTICS && job->statistics);
}

#endif
