/* Asks both libraries what is attached to the framebuffers that are bound, and compares the answers
 * and the errors. */
#include "compare_attachments.h"

#include <stdio.h>

static const GLenum targets[] = {GL_DRAW_FRAMEBUFFER, GL_READ_FRAMEBUFFER, 12345};

static const GLenum attachments[] = {GL_COLOR_ATTACHMENT0,
                                     GL_COLOR_ATTACHMENT1,
                                     GL_COLOR_ATTACHMENT9,
                                     GL_DEPTH_ATTACHMENT,
                                     GL_STENCIL_ATTACHMENT,
                                     GL_DEPTH_STENCIL_ATTACHMENT,
                                     GL_FRONT_LEFT,
                                     GL_FRONT_RIGHT,
                                     GL_BACK_LEFT,
                                     GL_BACK_RIGHT,
                                     GL_FRONT,
                                     GL_BACK,
                                     GL_AUX0,
                                     GL_DEPTH,
                                     GL_STENCIL,
                                     12345};

static const GLenum names[] = {
    GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE,    GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME,
    GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL,  GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE,
    GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER,  GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING,
    GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE,
    GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE,     GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE,
    GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE,     GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE,
    GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE,   12345};

enum {
    TARGETS = sizeof targets / sizeof *targets,
    NAMES = sizeof names / sizeof *names,
    ATTACHMENTS = sizeof attachments / sizeof *attachments
};

bool are_attachments_equal(const library libraries[LIBRARIES])
{
    for (int question = 0; question < TARGETS * ATTACHMENTS * NAMES; ++question) {
        const GLenum target = targets[question / NAMES / ATTACHMENTS];
        const GLenum attachment = attachments[question / NAMES % ATTACHMENTS];
        const GLenum name = names[question % NAMES];
        GLint value[LIBRARIES] = {-1, -1};
        GLenum error[LIBRARIES];

        for (int l = 0; l < LIBRARIES; ++l) {
            libraries[l].GetFramebufferAttachmentParameteriv(target, attachment, name, &value[l]);
            error[l] = libraries[l].GetError();
        }
        if (value[0] != value[1] || error[0] != error[1]) {
            printf("attachment %#x of %#x, %#x: %d, error %#x beside %d, error %#x\n", attachment,
                   target, name, value[0], error[0], value[1], error[1]);
            return false;
        }
    }
    return true;
}
