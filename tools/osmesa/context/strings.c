/* What the implementation says of itself, and the ends of frames. */
#include <gl_registry.h>

#include "gl_context.h"
#include "gl_errors.h"
#include "../framebuffer/window.h"

#define TEXT_OF(number) #number
#define TEXT(number) TEXT_OF(number)

const GLubyte *glGetString(GLenum name)
{
    context *const gl = enter(__func__);
    const char *text = NULL;

    if (!gl)
        return NULL;
    switch (name) {
    case GL_VENDOR:
        text = "Gnomon";
        break;
    case GL_RENDERER:
        text = "Gnomon";
        break;
    case GL_VERSION:
        text = "1.5 Gnomon " TEXT(GN_VERSION_MAJOR) "." TEXT(GN_VERSION_MINOR) "." TEXT(
            GN_VERSION_PATCH);
        break;
    case GL_EXTENSIONS:
        text = "GL_ARB_clip_control GL_ARB_depth_buffer_float GL_ARB_depth_texture "
               "GL_ARB_framebuffer_object GL_ARB_framebuffer_sRGB "
               "GL_ARB_half_float_pixel GL_ARB_multisample GL_ARB_multitexture "
               "GL_ARB_occlusion_query GL_ARB_occlusion_query2 "
               "GL_ARB_pixel_buffer_object GL_ARB_point_parameters "
               "GL_ARB_seamless_cube_map GL_ARB_shadow GL_ARB_texture_border_clamp "
               "GL_ARB_texture_cube_map GL_ARB_texture_env_add "
               "GL_ARB_texture_env_combine GL_ARB_texture_env_crossbar "
               "GL_ARB_texture_env_dot3 GL_ARB_texture_mirrored_repeat "
               "GL_ARB_texture_non_power_of_two GL_ARB_transpose_matrix "
               "GL_ARB_vertex_buffer_object GL_ARB_window_pos "
               "GL_ATI_texture_env_combine3 GL_EXT_abgr GL_EXT_bgra GL_EXT_blend_color "
               "GL_EXT_blend_equation_separate GL_EXT_blend_func_separate "
               "GL_EXT_blend_minmax GL_EXT_blend_subtract GL_EXT_copy_texture "
               "GL_EXT_draw_range_elements GL_EXT_fog_coord GL_EXT_framebuffer_blit "
               "GL_EXT_framebuffer_multisample GL_EXT_framebuffer_object "
               "GL_EXT_framebuffer_sRGB GL_EXT_multi_draw_arrays "
               "GL_EXT_packed_depth_stencil GL_EXT_packed_pixels "
               "GL_EXT_pixel_buffer_object GL_EXT_point_parameters "
               "GL_EXT_rescale_normal GL_EXT_secondary_color "
               "GL_EXT_separate_specular_color GL_EXT_shadow_funcs GL_EXT_stencil_wrap "
               "GL_EXT_subtexture GL_EXT_texture GL_EXT_texture3D "
               "GL_EXT_texture_cube_map GL_EXT_texture_edge_clamp "
               "GL_EXT_texture_env_add GL_EXT_texture_env_combine "
               "GL_EXT_texture_env_dot3 GL_EXT_texture_lod_bias GL_EXT_texture_object "
               "GL_EXT_texture_sRGB GL_EXT_vertex_array GL_IBM_texture_mirrored_repeat "
               "GL_KHR_debug GL_NV_blend_square GL_NV_texgen_reflection "
               "GL_NV_texture_env_combine4 GL_SGIS_generate_mipmap "
               "GL_SGIS_texture_border_clamp GL_SGIS_texture_edge_clamp "
               "GL_SGIS_texture_lod";
        break;
    default:
        gl_error(gl, GL_INVALID_ENUM, __func__);
    }
    return (const GLubyte *)text;
}

void glFlush(void)
{
    context *const gl = enter(__func__);

    if (gl)
        finish_window(&gl->window);
}

void glFinish(void)
{
    context *const gl = enter(__func__);

    if (gl)
        finish_window(&gl->window);
}
