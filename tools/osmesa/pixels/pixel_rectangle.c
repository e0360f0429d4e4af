/* Draws a rectangle of pixels as a mesh with shaders of its own. */
#include "pixel_rectangle.h"

#include <gl_registry.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../draw/draw_state.h"
#include "../draw/fixed_function.h"
#include "../framebuffer/framebuffer_view.h"
#include "../context/gl_errors.h"
#include "depth_stencil.h"

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
            output->color[c][l] = u->kind == RECTANGLE_COLORS || u->kind == RECTANGLE_STENCIL
                                      ? texel[c][l]
                                      : u->fixed.current[COLOR][c];
    if (u->kind == RECTANGLE_DEPTHS)
        memcpy(output->depth, texel[0], sizeof texel[0]);
    for (int l = 0; l < GN_LANES && u->kind == RECTANGLE_BITS; ++l)
        if (texel[0][l] == 0.0f)
            output->kept &= ~(1u << l);
    if (u->kind != RECTANGLE_STENCIL)
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
    if (rectangle->skips_tests)
        pipeline->depth.test_enabled = pipeline->stencil.test_enabled = false;
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

pixel_rectangle rectangle_at_raster_position(const context *gl, rectangle_kind kind, GLsizei width,
                                             GLsizei height)
{
    const raster_position_state *const r = &gl->raster_position;
    pixel_rectangle rectangle = {
        .kind = kind,
        .x = floorf(r->position[0] + 0.5f),
        .y = floorf(r->position[1] + 0.5f),
        .zoom_x = gl->pixel_zoom[0],
        .zoom_y = gl->pixel_zoom[1],
        .z = r->position[2],
        .width = width,
        .height = height,
        .format = GN_FORMAT_RGBA32F,
    };

    memcpy(rectangle.color, r->color, sizeof rectangle.color);
    return rectangle;
}

/* Sets stencil indices, and depths if asked for, where a drawn pixel's alpha is 1. */
static void merge_stencil(const context *gl, const pixel_rectangle *rectangle,
                          const framebuffer_view *view, const GLfloat (*drawn)[4])
{
    const gn_surface *const whole = &view->target.depth;
    const unsigned mask = gl->fragment.stencil[0].write_mask & 0xFFu;
    const uint32_t samples = whole->samples > 1 ? whole->samples : 1;

    for (uint32_t s = 0; s < samples; ++s) {
        const gn_surface surface = gn_surface_sample(whole, s);

        for (GLint y = 0; y < view->height; ++y) {
            unsigned char *pixel = (unsigned char *)surface.pixels + y * surface.row_stride;
            const GLfloat(*from)[4] = drawn + (size_t)y * (size_t)view->width;

            for (GLint x = 0; x < view->width; ++x, pixel += gn_format_size(surface.format)) {
                if (from[x][3] != 1.0f)
                    continue;
                set_stencil(&surface, pixel, (unsigned)from[x][0], mask);
                if (rectangle->sets_depth && gl->fragment.depth_mask)
                    set_depth(&surface, pixel, (GLdouble)from[x][1]);
            }
        }
    }
}

/* Draws indices as colours into memory of their own, whose alpha tells which pixels are covered. No
 * test but the scissor applies. */
static gn_status draw_stencil(context *gl, const pixel_rectangle *rectangle,
                              const framebuffer_view *view, gn_pipeline *pipeline,
                              const gn_mesh *mesh, gn_workspace *workspace, const char *function)
{
    const size_t pixels = (size_t)view->width * (size_t)view->height;
    GLfloat(*const drawn)[4] = calloc(pixels, sizeof *drawn);
    gn_target target = {0};
    gn_status status;

    if (!drawn) {
        gl_error(gl, GL_OUT_OF_MEMORY, function);
        return GN_OK;
    }
    target.color[0] = gn_surface_bottom_up(drawn, GN_FORMAT_RGBA32F, (uint32_t)view->width,
                                           (uint32_t)view->height);
    memset(&pipeline->depth, 0, sizeof pipeline->depth);
    memset(&pipeline->stencil, 0, sizeof pipeline->stencil);
    memset(&pipeline->color, 0, sizeof pipeline->color);
    pipeline->depth.clip_depth = GN_NEGATIVE_ONE_TO_ONE;
    pipeline->program.fragment_discards = false;
    status = gn_draw(&target, pipeline, mesh, workspace);
    if (!status)
        merge_stencil(gl, rectangle, view, (const GLfloat(*)[4])drawn);
    free(drawn);
    return status;
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
        status = rectangle->kind == RECTANGLE_STENCIL
                     ? draw_stencil(gl, rectangle, &view, &pipeline, &mesh, &workspace, function)
                     : gn_draw(&view.target, &pipeline, &mesh, &workspace);
    if (status)
        debug_line(function, gn_status_text(status));
}
