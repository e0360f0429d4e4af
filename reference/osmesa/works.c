/* Blits, resolves and the making of levels, prepared for timing. */
#include "gl.h"

#include <string.h>

bool reference_prepare_blit(reference_prepared *p, const scene *to, gn_blit_filter filter,
                            char *error, size_t error_size)
{
    p->blit_mask = (scene_is_color_format(to->color_format) ? GL_COLOR_BUFFER_BIT : 0) |
                   (scene_has_depth(to->depth_format) ? GL_DEPTH_BUFFER_BIT : 0) |
                   (scene_has_stencil(to->depth_format) ? GL_STENCIL_BUFFER_BIT : 0);
    p->filter = filter == GN_BLIT_LINEAR ? GL_LINEAR : GL_NEAREST;
    return framebuffer_create(&p->to, to, REFERENCE_DEPTH_OF_SCENE, p->target.is_layered, error,
                              error_size);
}

void reference_blit_prepared(reference_prepared *p)
{
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, p->target.name);
    glReadBuffer(p->blit_mask & GL_COLOR_BUFFER_BIT ? GL_COLOR_ATTACHMENT0 : GL_NONE);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, p->to.name);
    glBlitFramebuffer(0, 0, (GLint)p->target.width, (GLint)p->target.height, 0, 0,
                      (GLint)p->to.width, (GLint)p->to.height, p->blit_mask, p->filter);
    glFinish();
}

bool reference_read_blit(reference_prepared *p, const scene *to, scene_frame *frame, char *error,
                         size_t error_size)
{
    glBindFramebuffer(GL_FRAMEBUFFER, p->to.name);
    reference_read_image(to, 0, frame);
    return reference_check("a blit", error, error_size);
}

void reference_make_levels(reference_prepared *p)
{
    const GLenum target = reference_texture_target(p->scene->draws[0].uniforms.texture.target);

    glActiveTexture(GL_TEXTURE0);
    glBindTexture(target, p->draws[0].texture);
    glGenerateMipmap(target);
    glFinish();
}

bool reference_read_levels(reference_prepared *p, void *memory, char *error, size_t error_size)
{
    const gn_texture *const t = &p->scene->draws[0].uniforms.texture;
    const GLenum target = reference_texture_target(t->target);
    const reference_image_format f = reference_image_format_of(t->format);
    char *next = memory;

    glBindTexture(target, p->draws[0].texture);
    for (uint32_t level = 1; level < scene_level_count(t); ++level) {
        const scene_extent e = scene_level_extent(t, level);
        const size_t face = (size_t)e.width * e.height;
        const bool is_cube = t->target == GN_TEXTURE_CUBE;

        for (GLenum i = 0; i < (is_cube ? 6 : 1); ++i) {
            const size_t texels = is_cube ? face : face * e.layers;

            glGetTexImage(is_cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + i : target, (GLint)level,
                          f.format, f.type, next);
            reference_turn_pixels(t->format, next, texels, false);
            next += texels * gn_format_size(t->format);
        }
    }
    return reference_check("making levels", error, error_size);
}
