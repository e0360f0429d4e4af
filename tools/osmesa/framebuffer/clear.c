/* glClear: whole buffers, or what the scissor and the masks leave of them. */
#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "../draw/draw_state.h"
#include "accumulation.h"
#include "framebuffer_view.h"
#include "../context/gl_context.h"
#include "../context/gl_errors.h"

/* Returns the part of a surface that the scissor leaves; absent if it leaves nothing. */
static gn_surface scissored(const context *gl, const gn_surface *surface)
{
    gn_surface part = *surface;
    gn_scissor scissor;
    int64_t x0 = 0, y0 = 0, x1 = surface->width, y1 = surface->height;

    set_scissor(gl, &scissor);
    if (scissor.enabled) {
        const int64_t right = (int64_t)scissor.x + scissor.width;
        const int64_t end = (int64_t)scissor.y + scissor.height;

        x0 = scissor.x > x0 ? scissor.x : x0;
        y0 = scissor.y > y0 ? scissor.y : y0;
        x1 = right < x1 ? right : x1;
        y1 = end < y1 ? end : y1;
    }
    if (!surface->format || x0 >= x1 || y0 >= y1)
        return (gn_surface){0};
    part.pixels = (char *)surface->pixels + (ptrdiff_t)y0 * surface->row_stride +
                  (ptrdiff_t)x0 * (ptrdiff_t)gn_format_size(surface->format);
    part.width = (uint32_t)(x1 - x0);
    part.height = (uint32_t)(y1 - y0);
    return part;
}

/* What is cleared by drawing. */
typedef struct cover {
    const GLfloat *color;
    GLfloat z; /* in clip space */
} cover;

/* One triangle over a surface, whose vertices all have one colour and depth. */
static void cover_vertex(const void *uniforms, const gn_vertex_input *input,
                         gn_vertex_output *output)
{
    const cover *const cleared = uniforms;

    for (int l = 0; l < GN_LANES; ++l) {
        const uint32_t id = input->vertex_id[l];

        output->position[0][l] = id == 1 ? 3.0f : -1.0f;
        output->position[1][l] = id == 2 ? 3.0f : -1.0f;
        output->position[2][l] = cleared->z;
        output->position[3][l] = 1.0f;
    }
}

static void cover_fragment(const void *uniforms, const gn_fragment_input *input,
                           gn_fragment_output *output)
{
    const cover *const cleared = uniforms;

    (void)input;
    for (int c = 0; c < 4; ++c)
        for (int l = 0; l < GN_LANES; ++l)
            output->color[c][l] = cleared->color[c];
}

/* Draws over a target: write masks apply, and a depth is rounded as a fragment's. Queries do not
 * count it. */
static void draw_cover(context *gl, const gn_target *target, gn_pipeline *pipeline,
                       const cover *cleared, const char *function)
{
    const gn_mesh mesh = {.vertex_count = 3, .count = 3};
    gn_workspace workspace = gl->workspace;

    workspace.samples_passed = NULL;
    pipeline->program.vertex_shader = cover_vertex;
    pipeline->program.fragment_shader = cover_fragment;
    pipeline->program.uniforms = cleared;
    workspace.size = gn_workspace_size(3, 0);
    workspace.memory = scratch_memory(gl, &gl->pixels, workspace.size, function);
    if (workspace.memory)
        gn_draw(target, pipeline, &mesh, &workspace);
}

static void clear_channels(context *gl, const gn_surface *surface, const char *function)
{
    const gn_target target = {.color = {*surface}};
    const cover cleared = {gl->fragment.clear_color, 0.0f};
    gn_pipeline state, pipeline;

    set_pipeline(gl, &state);
    memset(&pipeline, 0, sizeof pipeline);
    pipeline.color.write_disabled[0] = state.color.write_disabled[0];
    draw_cover(gl, &target, &pipeline, &cleared, function);
}

static void clear_color(context *gl, const gn_surface *whole, const char *function)
{
    const GLfloat *const color = gl->fragment.clear_color;
    const GLboolean *const mask = gl->fragment.color_mask;
    const gn_surface surface = scissored(gl, whole);

    if (!surface.format)
        return;
    if (mask[0] && mask[1] && mask[2] && mask[3])
        gn_clear_color(&surface, color[0], color[1], color[2], color[3]);
    else if (mask[0] || mask[1] || mask[2] || mask[3])
        clear_channels(gl, &surface, function);
}

/* Returns the float that Gnomon clears to what the double is in a format of n bits: it rounds the
 * product of depth and 2^n - 1 to the nearest integer. The quotient's error is too small to change
 * that integer again. */
static float clear_depth_of(GLdouble depth, gn_format format)
{
    const GLdouble most = format == GN_FORMAT_D16 ? 65535.0 : 16777215.0;

    if (format == GN_FORMAT_D32F || format == GN_FORMAT_D32FS8)
        return (float)depth;
    return (float)(nearbyint(depth * most) / most);
}

/* Clears depth, stencil or both as the reference does where a clear has a scissor or a mask. */
static void draw_depth_and_stencil(context *gl, const gn_surface *surface, bool has_depth,
                                   bool has_stencil, const char *function)
{
    const fragment_state *const f = &gl->fragment;
    const gn_target target = {.depth = *surface};
    const cover cleared = {f->clear_color, (GLfloat)f->clear_depth * 2.0f - 1.0f};
    gn_pipeline pipeline;

    memset(&pipeline, 0, sizeof pipeline);
    pipeline.depth.test_enabled = true;
    pipeline.depth.function = GN_ALWAYS;
    pipeline.depth.write_disabled = !has_depth;
    pipeline.stencil.test_enabled = has_stencil;
    pipeline.stencil.front = (gn_stencil_face){.reference = (uint8_t)f->clear_stencil,
                                               .write_disabled = (uint8_t)~f->stencil[0].write_mask,
                                               .pass = GN_STENCIL_REPLACE};
    pipeline.stencil.back = pipeline.stencil.front;
    draw_cover(gl, &target, &pipeline, &cleared, function);
}

static void clear_depth_and_stencil(context *gl, GLbitfield buffers, const framebuffer_view *view,
                                    const char *function)
{
    const fragment_state *const f = &gl->fragment;
    const gn_surface whole = view->target.depth;
    const gn_surface surface = scissored(gl, &whole);
    const bool has_depth = (buffers & GL_DEPTH_BUFFER_BIT) && view->bits[4] && f->depth_mask;
    const GLuint mask = f->stencil[0].write_mask & 255u;
    const bool has_stencil = (buffers & GL_STENCIL_BUFFER_BIT) && view->bits[5] && mask;
    const float depth = clear_depth_of(f->clear_depth, surface.format);
    const uint8_t stencil = (uint8_t)f->clear_stencil;

    if (!surface.format || !(has_depth || has_stencil))
        return;
    if (surface.width != whole.width || surface.height != whole.height ||
        (has_stencil && mask != 255u))
        draw_depth_and_stencil(gl, &surface, has_depth, has_stencil, function);
    else if (has_depth && has_stencil)
        gn_clear_depth_stencil(&surface, depth, stencil);
    else if (has_depth)
        gn_clear_depth(&surface, depth);
    else
        gn_clear_stencil(&surface, stencil);
}

void glClear(GLbitfield buffers)
{
    context *const gl = enter(__func__);
    framebuffer_view view;

    if (!gl)
        return;
    if (buffers & ~(GLbitfield)(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT |
                                GL_ACCUM_BUFFER_BIT)) {
        gl_error(gl, GL_INVALID_VALUE, __func__);
        return;
    }
    if (!is_drawable_framebuffer(gl, &view, __func__) || gl->render_mode != GL_RENDER)
        return;
    for (int i = 0; (buffers & GL_COLOR_BUFFER_BIT) && i < GN_MAX_COLORS; ++i)
        clear_color(gl, &view.target.color[i], __func__);
    if (buffers & (GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT))
        clear_depth_and_stencil(gl, buffers, &view, __func__);
    if (buffers & GL_ACCUM_BUFFER_BIT)
        clear_accumulation(gl);
}
