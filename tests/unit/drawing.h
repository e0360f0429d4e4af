/* What draws in these tests share: their parts in few words, and the plainest shaders. */
#ifndef UNIT_DRAWING_H
#define UNIT_DRAWING_H

#include <string.h>

#include "unit.h"

/* As a strip, all of a target. */
static const float square[16] = {-1, -1, 0, 1, 1, -1, 0, 1, -1, 1, 0, 1, 1, 1, 0, 1};

/* Returns the next back end that can run, or GN_BACKEND_COUNT. */
static inline gn_backend backend_after(int backend)
{
    do
        ++backend;
    while (backend < GN_BACKEND_COUNT && !gn_backend_available((gn_backend)backend));
    return (gn_backend)backend;
}

static inline gn_attribute floats(const float *data, uint32_t components)
{
    return (gn_attribute){.data = data, .components = components};
}

/* Vertices with positions alone, which ready-made shaders draw white. */
static inline gn_mesh mesh_of(const float *positions, uint32_t components, uint32_t count)
{
    gn_mesh mesh;

    memset(&mesh, 0, sizeof mesh);
    mesh.attribute[GN_ATTRIBUTE_POSITION] = floats(positions, components);
    mesh.vertex_count = mesh.count = count;
    return mesh;
}

/* Shows the vertices' colours; positions are in clip space. */
static inline gn_pipeline colored_pipeline(gn_topology topology)
{
    static gn_color_uniforms identity;
    gn_pipeline pipeline;

    memset(&pipeline, 0, sizeof pipeline);
    gn_mat4_identity(&identity.clip_from_model);
    assert_int_equal(gn_use_vertex_color(&pipeline, &identity), GN_OK);
    pipeline.raster.topology = topology;
    return pipeline;
}

static inline void make_multisampled(gn_target *target)
{
    for (int i = 0; i < GN_MAX_COLORS; ++i)
        if (target->color[i].format != GN_FORMAT_NONE)
            target->color[i] = gn_surface_multisampled(&target->color[i]);
    if (target->depth.format != GN_FORMAT_NONE)
        target->depth = gn_surface_multisampled(&target->depth);
}

static inline void pass_positions(const void *uniforms, const gn_vertex_input *input,
                                  gn_vertex_output *output)
{
    (void)uniforms;
    memcpy(output->position, input->attribute[GN_ATTRIBUTE_POSITION], sizeof *input->attribute);
}

static inline void shade_white(const void *uniforms, const gn_fragment_input *input,
                               gn_fragment_output *output)
{
    (void)uniforms;
    (void)input;
    for (int channel = 0; channel < 4; ++channel)
        for (int l = 0; l < GN_LANES; ++l)
            output->color[channel][l] = 1.0f;
}

#endif
