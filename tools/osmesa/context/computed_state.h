/* State that no member of the context holds as glGet returns it: the functions of state_table.c's
 * rows. Each writes as many values as its row says. */
#ifndef OSMESA_COMPUTED_STATE_H
#define OSMESA_COMPUTED_STATE_H

#include "gl_context.h"

void computed_modelview(const context *gl, GLdouble *value);
void computed_projection(const context *gl, GLdouble *value);
void computed_texture_matrix(const context *gl, GLdouble *value);
void computed_transposed_modelview(const context *gl, GLdouble *value);
void computed_transposed_projection(const context *gl, GLdouble *value);
void computed_transposed_texture_matrix(const context *gl, GLdouble *value);
void computed_fog_coordinate(const context *gl, GLdouble *value);
void computed_secondary_color(const context *gl, GLdouble *value);
void computed_point_size_range(const context *gl, GLdouble *value);
void computed_line_width_range(const context *gl, GLdouble *value);
void computed_granularity(const context *gl, GLdouble *value);
void computed_most_lod_bias(const context *gl, GLdouble *value);
void computed_active_texture(const context *gl, GLdouble *value);
void computed_texture_binding_1d(const context *gl, GLdouble *value);
void computed_texture_binding_2d(const context *gl, GLdouble *value);
void computed_texture_binding_3d(const context *gl, GLdouble *value);
void computed_texture_binding_cube(const context *gl, GLdouble *value);
void computed_client_active_texture(const context *gl, GLdouble *value);
void computed_red_bits(const context *gl, GLdouble *value);
void computed_green_bits(const context *gl, GLdouble *value);
void computed_blue_bits(const context *gl, GLdouble *value);
void computed_alpha_bits(const context *gl, GLdouble *value);
void computed_depth_bits(const context *gl, GLdouble *value);
void computed_stencil_bits(const context *gl, GLdouble *value);
void computed_bits_of_accumulation(const context *gl, GLdouble *value);
void computed_samples(const context *gl, GLdouble *value);
void computed_sample_buffers(const context *gl, GLdouble *value);
void computed_is_srgb(const context *gl, GLdouble *value);
void computed_draw_buffer(const context *gl, GLdouble *value);
void computed_read_buffer(const context *gl, GLdouble *value);
void computed_draw_framebuffer(const context *gl, GLdouble *value);
void computed_read_framebuffer(const context *gl, GLdouble *value);
void computed_bound_renderbuffer(const context *gl, GLdouble *value);
void computed_read_format(const context *gl, GLdouble *value);

#endif
