#include "pixel_rectangle.h"

#include <gl_registry.h>
#include <string.h>

#include "../draw/draw_state.h"
#include "../draw/fixed_function.h"
#include "../framebuffer/framebuffer_view.h"
#include "../context/gl_errors.h"

enum { CORNERS = 4 };

/* What the shaders of a rectangle read. */
typedef struct rectangle_uniforms {
    fixed_function fixed;
    rectangle_kind kind;
    GLfloat x[2], y[2], z; /* in clip space */
    gn_texture texture;
    gn_sampler sampler;
} rectangle_uniforms;

/* Corners in the order lower left, lower right, upper right, upper left. */
static void rectangle_vertex(const void *uniforms, const gn_vertex_input *input,
                             gn_vertex_output *output)
{
    const rectangle_uniforms *const u = uniforms;

    for (int l = 0; l < GN_LANES; ++l) {
        const uint32_t id = input->vertex_id[l] % CORNERS;
        const int right = id == 1 || id == 2, top = id >= 2;

        output->position[0][l] = u->x[right];
        output->position[1][l] = u->y[top];
        output->position[2][l] = u->z;
        output->position[3][l] = 1.0f;
        output->varying[0][l] = (float)right;
        output->varying[1][l] = (float)top;
    }
}

static void rectangle_fragment(const void *uniforms, const gn_fragment_input *input,
                               gn_fragment_output *output)
{
    static const float secondary[3][GN_LANES];
    const rectangle_uniforms *const u = uniforms;
    float texel[4][GN_LANES];

    gn_fragment_lookup_2d(input, &u->texture, &u->sampler, input->varying[0], input->varying[1],
                          texel);
    for (int c = 0; c < 4; ++c)
        for (int l = 0; l < GN_LANES; ++l)
            output->color[c][l] =
                u->kind == RECTANGLE_COLORS ? texel[c][l] : u->fixed.current[COLOR][c];
    if (u->kind == RECTANGLE_DEPTHS)
        memcpy(output->depth, texel[0], sizeof texel[0]);
    for (int l = 0; l < GN_LANES && u->kind == RECTANGLE_BITS; ++l)
        if (texel[0][l] == 0.0f)
            output->kept &= ~(1u << l);
    finish_fragments(&u->fixed, input, secondary, output);
}

/* The state of fragments is the program's; that of primitives is none: a rectangle is neither
 * culled nor offset, and its depth is not mapped by the depth range. */
static void set_rectangle_pipeline(context *gl, const pixel_rectangle *rectangle,
                                   const framebuffer_view *view, rectangle_uniforms *u,
                                   gn_pipeline *pipeline)
{
    const float width = (float)view->width, height = (float)view->height;
    gn_program *const program = &pipeline->program;
    gn_scissor scissor;

    set_pipeline(gl, pipeline);
    scissor = pipeline->raster.scissor;
    memset(&pipeline->raster, 0, sizeof pipeline->raster);
    pipeline->raster.scissor = scissor;
    pipeline->raster.viewport = (gn_viewport){.enabled = true,
                                              .y = view->rows_go_down ? height : 0.0f,
                                              .width = width,
                                              .height = view->rows_go_down ? -height : height};
    pipeline->depth.clip_depth = GN_NEGATIVE_ONE_TO_ONE;
    memset(&pipeline->depth.range, 0, sizeof pipeline->depth.range);
    set_rectangle_function(gl, rectangle->color, &u->fixed, program);
    if (rectangle->kind == RECTANGLE_DEPTHS)
        memcpy(u->fixed.current[COLOR], rectangle->color, sizeof rectangle->color);
    program->vertex_shader = rectangle_vertex;
    program->fragment_shader = rectangle_fragment;
    program->uniforms = u;
    program->varying_count = 2;
    program->fragment_writes_all_colors = true;
    program->fragment_writes_depth = rectangle->kind == RECTANGLE_DEPTHS;
    program->fragment_discards |= rectangle->kind == RECTANGLE_BITS;
}

static void set_corners(const framebuffer_view *view, const pixel_rectangle *rectangle,
                        rectangle_uniforms *u)
{
    const float width = (float)view->width, height = (float)view->height;

    for (int i = 0; i < 2; ++i) {
        const float x = rectangle->x + (float)(i * rectangle->width) * rectangle->zoom_x;
        const float y = rectangle->y + (float)(i * rectangle->height) * rectangle->zoom_y;

        u->x[i] = x / width * 2.0f - 1.0f;
        u->y[i] = y / height * 2.0f - 1.0f;
    }
    u->z = rectangle->z * 2.0f - 1.0f;
}

void draw_pixel_rectangle(context *gl, const pixel_rectangle *rectangle, const char *function)
{
    static const uint8_t indices[6] = {0, 1, 2, 0, 2, 3};
    const gn_mesh mesh = {
        .vertex_count = CORNERS, .count = 6, .indices = indices, .index_format = GN_INDEX_UINT8};
    gn_workspace workspace = gl->workspace;
    rectangle_uniforms u;
    gn_pipeline pipeline;
    framebuffer_view view;
    gn_status status;

    if (!is_drawable_framebuffer(gl, &view, function))
        return;
    set_rectangle_pipeline(gl, rectangle, &view, &u, &pipeline);
    set_corners(&view, rectangle, &u);
    u.kind = rectangle->kind;
    memset(&u.sampler, 0, sizeof u.sampler);
    u.sampler.wrap_s = u.sampler.wrap_t = GN_WRAP_CLAMP_TO_EDGE;
    u.sampler.magnify = GN_MAGNIFY_NEAREST;
    u.sampler.minify = GN_MINIFY_NEAREST;
    status = gn_texture_packed(GN_TEXTURE_2D, rectangle->format, (uint32_t)rectangle->width,
                               (uint32_t)rectangle->height, 1, 1, rectangle->pixels, &u.texture);
    workspace.size = gn_workspace_size(CORNERS, 2);
    workspace.memory = scratch_memory(gl, &gl->vertices, workspace.size, function);
    if (!status && workspace.memory)
        status = gn_draw(&view.target, &pipeline, &mesh, &workspace);
    if (status)
        debug_line(function, gn_status_text(status));
}
