/* State that glGet computes. */
#include "computed_state.h"

#include <gl_registry.h>
#include <string.h>

#include "../framebuffer/accumulation.h"
#include "../framebuffer/framebuffer_objects.h"
#include "../framebuffer/framebuffer_view.h"

static void write_matrix(const matrix_stack *stack, bool transposed, GLdouble *value)
{
    const GLfloat *const m = stack->m[stack->depth - 1];

    for (int i = 0; i < 16; ++i)
        value[i] = (GLdouble)m[transposed ? i % 4 * 4 + i / 4 : i];
}

void computed_modelview(const context *gl, GLdouble *value)
{
    write_matrix(&gl->transform.modelview, false, value);
}

void computed_projection(const context *gl, GLdouble *value)
{
    write_matrix(&gl->transform.projection, false, value);
}

void computed_texture_matrix(const context *gl, GLdouble *value)
{
    write_matrix(&gl->transform.texture[gl->active_texture], false, value);
}

void computed_transposed_modelview(const context *gl, GLdouble *value)
{
    write_matrix(&gl->transform.modelview, true, value);
}

void computed_transposed_projection(const context *gl, GLdouble *value)
{
    write_matrix(&gl->transform.projection, true, value);
}

void computed_transposed_texture_matrix(const context *gl, GLdouble *value)
{
    write_matrix(&gl->transform.texture[gl->active_texture], true, value);
}

void computed_fog_coordinate(const context *gl, GLdouble *value)
{
    value[0] = (GLdouble)gl->current.attribute[SECONDARY_AND_FOG][3];
}

void computed_secondary_color(const context *gl, GLdouble *value)
{
    memset(value, 0, 4 * sizeof *value);
    for (int i = 0; i < 3; ++i)
        value[i] = (GLdouble)gl->current.attribute[SECONDARY_AND_FOG][i];
    value[3] = 1.0;
}

void computed_point_size_range(const context *gl, GLdouble *value)
{
    (void)gl;
    value[0] = 1.0;
    value[1] = GN_MAX_POINT_SIZE;
}

void computed_line_width_range(const context *gl, GLdouble *value)
{
    (void)gl;
    value[0] = 1.0;
    value[1] = GN_MAX_LINE_WIDTH;
}

void computed_granularity(const context *gl, GLdouble *value)
{
    (void)gl;
    value[0] = (GLdouble)0.1f;
}

void computed_most_lod_bias(const context *gl, GLdouble *value)
{
    (void)gl;
    value[0] = 16.0;
}

void computed_active_texture(const context *gl, GLdouble *value)
{
    value[0] = GL_TEXTURE0 + gl->active_texture;
}

void computed_texture_binding_1d(const context *gl, GLdouble *value)
{
    value[0] = gl->unit[gl->active_texture].bound[TARGET_1D]->name;
}

void computed_texture_binding_2d(const context *gl, GLdouble *value)
{
    value[0] = gl->unit[gl->active_texture].bound[TARGET_2D]->name;
}

void computed_texture_binding_3d(const context *gl, GLdouble *value)
{
    value[0] = gl->unit[gl->active_texture].bound[TARGET_3D]->name;
}

void computed_texture_binding_cube(const context *gl, GLdouble *value)
{
    value[0] = gl->unit[gl->active_texture].bound[TARGET_CUBE]->name;
}

void computed_client_active_texture(const context *gl, GLdouble *value)
{
    value[0] = GL_TEXTURE0 + gl->arrays.client_texture;
}

/* Bits of the framebuffer that is drawn to; 0 if it is incomplete. */
static GLint framebuffer_bits(const context *gl, int channel)
{
    framebuffer_view view;

    return view_draw_framebuffer(gl, &view) ? view.bits[channel] : 0;
}

void computed_red_bits(const context *gl, GLdouble *value)
{
    value[0] = framebuffer_bits(gl, 0);
}

void computed_green_bits(const context *gl, GLdouble *value)
{
    value[0] = framebuffer_bits(gl, 1);
}

void computed_blue_bits(const context *gl, GLdouble *value)
{
    value[0] = framebuffer_bits(gl, 2);
}

void computed_alpha_bits(const context *gl, GLdouble *value)
{
    value[0] = framebuffer_bits(gl, 3);
}

void computed_depth_bits(const context *gl, GLdouble *value)
{
    value[0] = framebuffer_bits(gl, 4);
}

void computed_stencil_bits(const context *gl, GLdouble *value)
{
    value[0] = framebuffer_bits(gl, 5);
}

void computed_bits_of_accumulation(const context *gl, GLdouble *value)
{
    value[0] = accumulation_bits(gl);
}

void computed_samples(const context *gl, GLdouble *value)
{
    framebuffer_view view;

    value[0] = view_draw_framebuffer(gl, &view) ? view.samples : 0;
}

void computed_sample_buffers(const context *gl, GLdouble *value)
{
    computed_samples(gl, value);
    value[0] = value[0] > 0.0;
}

/* Whether GL_FRAMEBUFFER_SRGB has an effect. */
void computed_is_srgb(const context *gl, GLdouble *value)
{
    const framebuffer_object *const framebuffer = gl->draw_framebuffer;

    value[0] = 0.0;
    for (int i = 0; framebuffer && i < GN_MAX_COLORS; ++i)
        if (attached_surface(&framebuffer->attached[i], NULL).format == GN_FORMAT_SRGB8_A8)
            value[0] = 1.0;
}

void computed_draw_buffer(const context *gl, GLdouble *value)
{
    value[0] =
        gl->draw_framebuffer ? gl->draw_framebuffer->draw_buffer[0] : gl->fragment.draw_buffer;
}

void computed_read_buffer(const context *gl, GLdouble *value)
{
    value[0] = gl->read_framebuffer ? gl->read_framebuffer->read_buffer : gl->fragment.read_buffer;
}

void computed_draw_framebuffer(const context *gl, GLdouble *value)
{
    value[0] = gl->draw_framebuffer ? gl->draw_framebuffer->name : 0;
}

void computed_read_framebuffer(const context *gl, GLdouble *value)
{
    value[0] = gl->read_framebuffer ? gl->read_framebuffer->name : 0;
}

void computed_bound_renderbuffer(const context *gl, GLdouble *value)
{
    value[0] = gl->renderbuffer ? gl->renderbuffer->name : 0;
}

void computed_read_format(const context *gl, GLdouble *value)
{
    (void)gl;
    value[0] = GL_RGBA;
}
