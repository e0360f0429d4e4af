/* Calls of the stacks of attributes and of KHR_debug's groups, and labels of objects. */
#include "state_calls.h"

/* Any groups, or one. GL_PIXEL_MODE_BIT is left out: the reference saves the buffer that
 * glReadBuffer has named last, whichever framebuffer was bound, and restores it for the one that is
 * bound. */
GLbitfield attribute_groups(const arguments *a)
{
    const GLbitfield groups = a->i[0] & 7   ? 1u << (a->i[1] & 31)
                              : a->i[0] & 8 ? (GLbitfield)a->i[1]
                                            : GL_ALL_ATTRIB_BITS;

    return groups & ~(GLbitfield)GL_PIXEL_MODE_BIT;
}

/* A colour follows what is popped: until then, the reference's materials do not follow the colour
 * that was popped. */
void call_stacks(const library *gl, unsigned kind, const arguments *a)
{
    switch (kind) {
    case 0:
        gl->PushAttrib(attribute_groups(a));
        break;
    case 1:
        gl->PopAttrib();
        gl->Color4f(a->f[0], a->f[1], a->f[2], a->f[3]);
        break;
    case 2:
        gl->PushClientAttrib(a->i[0] & 7 ? (GLbitfield)a->i[1] & 3u : GL_CLIENT_ALL_ATTRIB_BITS);
        break;
    case 3:
        gl->PushDebugGroup(a->i[0] & 7 ? GL_DEBUG_SOURCE_APPLICATION : a->e[0], 1, 2, "ab");
        break;
    case 4:
        gl->PopDebugGroup();
        break;
    case 5:
        gl->ObjectLabel(a->i[0] & 7 ? GL_TEXTURE : a->e[0], (GLuint)a->i[1] & 3,
                        a->i[2] & 7 ? 2 : 256, "ab");
        break;
    default:
        gl->PopClientAttrib();
    }
}
