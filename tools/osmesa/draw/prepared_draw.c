/* Draws a mesh with the workspace of the context, which grows as needed. */
#include "prepared_draw.h"

#include <gl_registry.h>
#include <stdlib.h>

#include "draw_threads.h"
#include "../context/gl_errors.h"

/* Workspaces grow up to this many vertices. */
enum { MOST_STORED_VERTICES = 1 << 16 };

/* Starts the threads of the workspace, and grows its memory until each vertex is shaded once.
 * Returns false if memory is short. */
static bool grow_workspace(context *gl, const gn_mesh *mesh, uint32_t varyings)
{
    const uint32_t stored =
        mesh->vertex_count < MOST_STORED_VERTICES ? mesh->vertex_count : MOST_STORED_VERTICES;
    size_t size;

    start_draw_threads(&gl->workspace);
    /* No topology has more primitives than elements. */
    size = gl->workspace.parallel ? gn_workspace_size_parallel(stored, mesh->count, varyings)
                                  : gn_workspace_size(stored, varyings);
    if (size <= gl->workspace.size)
        return true;
    free(gl->workspace.memory);
    gl->workspace.size = 2 * size;
    gl->workspace.memory = malloc(gl->workspace.size);
    if (!gl->workspace.memory)
        gl->workspace.size = 0;
    return gl->workspace.memory != NULL;
}

void draw_prepared(context *gl, const gn_target *target, const gn_pipeline *pipeline,
                   const gn_mesh *mesh, const char *function)
{
    const gn_program *const program = &pipeline->program;
    gn_status status;

    if (!grow_workspace(gl, mesh, program->varying_count + program->clip_distance_count)) {
        gl_error(gl, GL_OUT_OF_MEMORY, function);
        return;
    }
    status = gn_draw(target, pipeline, mesh, &gl->workspace);
    if (status)
        debug_line(function, status == GN_INDEX_OUT_OF_RANGE ? "an index is out of range"
                                                             : gn_status_text(status));
}
