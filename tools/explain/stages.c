/* The stages of the tracing back end. The headers below are those that every back end of the
 * library compiles (src/backends/backend.inl, shading.inl). Where a stage begins or ends at a
 * function that one header defines and another one calls, the function is renamed while its header
 * is included, and a function with its old name calls it and tells what it computed. Not one
 * expression of the library is repeated, but for clipping (clipping.h) and edge functions
 * (coverage.h), which the library computes in scalar C: these are computed anew and
 * compared. */
#undef GN_SMALL

#include <stdlib.h>
#include <string.h>

#include "recording_lanes.h"
#include "told.h"
#include "stages.h"
#include "tracing.h"

/* Lookups take the ways of the back ends with registers, on every target. */
#undef GN_STATES_SPECIALISED
#define GN_STATES_SPECIALISED 1

#include "around_textures.h"

/* From here on the stages take the ways of a small library: every state takes the same steps, one
 * block at a time, on one thread. The bits are the same. */
#undef GN_STATES_SPECIALISED
#define GN_STATES_SPECIALISED 0
#undef GN_HAVE_TASKS
#define GN_HAVE_TASKS 0

#include "around_vertices.h"

#include "around_triangles.h"

#include "around_fragments.h"

/* Small triangles are not packed: the batches of these stages hold one block. */
#include "../../src/kernel/raster/cover_packed.inl"
#define cover_packed(...) ((void)0)

#include "around_culling.h"

#include "../../src/kernel/draw/mesh.inl"
#include "../../src/draw/prepare.h"

node_id record_leaf(const void *address, uint32_t bits, graph_operation type)
{
    bool is_float = false;
    const char *const name = names_texel(address, &is_float);
    const node_id node = graph_add(*name && is_float ? OP_FLOAT : type, bits, 0, 0, 0, 0);

    if (*name)
        graph_name(node, name);
    graph_store(address, node);
    return node;
}

node_id record_constant(float f)
{
    const node_id term = pixel_lane >= 0 ? flat_origin(f) : 0;

    return term ? term : graph_number(f);
}

/* The form compiled here of a ready-made shader, otherwise the shader itself. */
static gn_vertex_shader *vertex_shader_here(gn_vertex_shader *shader)
{
    return shader == gni_shade_vertex_surface    ? shade_vertex_surface
           : shader == gni_shade_vertex_metallic ? shade_vertex_metallic
           : shader == gni_shade_vertex_lit      ? shade_vertex_lit
           : shader == gni_shade_vertex_color    ? shade_vertex_color
           : shader == gni_shade_vertex_unlit    ? shade_vertex_unlit
           : shader == gni_shade_vertex_position ? shade_vertex_position
                                                 : shader;
}

gn_status stages_draw(const gn_target *target, const gn_pipeline *pipeline, const gn_mesh *mesh,
                      gn_workspace *workspace)
{
    const gn_program *const program = &pipeline->program;
    draw_job job;
    mesh_slice whole;
    const gn_status status = gni_prepare_draw(&job, &whole, target, pipeline, mesh, workspace);

    if (status)
        return status;
    job.parallel = 0;
    job.shading.texture_functions.lookup_2d = traced_lookup_2d;
    job.shading.texture_functions.lookup = traced_lookup;
    job.shading.texture_functions.gather = gather_any;
    job.shading.texture_functions.fetch = fetch_numbered;
    job.shading.vertex_shader = vertex_shader_here(program->vertex_shader);
    traced_shader = own_fragment_shader(program->fragment_shader);
    /* Another function than the pipeline's marks a ready-made shader (set_color_defaults). */
    job.shading.fragment_shader =
        traced_shader != program->fragment_shader ? traced_fragment_shader : traced_shader;
    traced_varyings = program->varying_count;
    pixel.labels = 0;
    pixel_lane = -1;
    nodes_at_last = 0;
    memset(last_terms, 0, sizeof last_terms);
    return draw_mesh(&job);
}
