/* A triangle that covers a whole target, drawn with a fragment shader of the test's. */
#ifndef UNIT_COVERED_H
#define UNIT_COVERED_H

#include "unit.h"

static inline void cover_all(const void *uniforms, const gn_vertex_input *input,
                             gn_vertex_output *output)
{
    for (int l = 0; l < GN_LANES; ++l) {
        output->position[0][l] = input->vertex_id[l] == 1 ? 3.0f : -1.0f;
        output->position[1][l] = input->vertex_id[l] == 2 ? 3.0f : -1.0f;
    }
}

/* Red, green, blue and alpha of the first colour are the four floats of the uniforms. */
static inline void shade_one_color(const void *uniforms, const gn_fragment_input *input,
                                   gn_fragment_output *output)
{
    for (int c = 0; c < 4; ++c)
        for (int l = 0; l < GN_LANES; ++l)
            output->color[c][l] = ((const float *)uniforms)[c];
}

/* Draws under a state; its fragment shader, or else the colour of the uniforms. */
static inline gn_status cover_target(const gn_target *target, const gn_pipeline *state,
                                     const void *uniforms, gn_backend backend)
{
    static unsigned char memory[GN_WORKSPACE_SIZE(3, 0)];
    const gn_mesh mesh = {.vertex_count = 3, .count = 3};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory, .backend = backend};
    gn_pipeline pipeline = *state;

    pipeline.program.vertex_shader = cover_all;
    if (!pipeline.program.fragment_shader)
        pipeline.program.fragment_shader = shade_one_color;
    pipeline.program.uniforms = uniforms;
    return gn_draw(target, &pipeline, &mesh, &workspace);
}

static inline void cover(const gn_surface *surface, const gn_pipeline *state, const float color[4])
{
    const gn_target target = {.color = {*surface}};

    assert_int_equal(cover_target(&target, state, color, GN_BACKEND_AUTO), GN_OK);
}

#endif
