/* glRenderMode (OpenGL 2.1 sections 5.2 and 5.3). */
#include <gl_registry.h>

#include "../context/gl_context.h"
#include "../context/gl_errors.h"
#include "feedback.h"
#include "selection.h"

/* Leaves the mode. Returns what glRenderMode returns for it. */
static GLint leave_mode(context *gl)
{
    return gl->render_mode == GL_SELECT     ? finish_selection(gl)
           : gl->render_mode == GL_FEEDBACK ? finish_feedback(gl)
                                            : 0;
}

/* As in the reference, a mode whose buffer has no size is an error, but entered. */
GLint glRenderMode(GLenum mode)
{
    context *const gl = enter(__func__);
    GLint result;

    if (!gl)
        return 0;
    result = leave_mode(gl);
    if (mode != GL_RENDER && mode != GL_SELECT && mode != GL_FEEDBACK) {
        gl_error(gl, GL_INVALID_ENUM, __func__);
        return 0;
    }
    if ((mode == GL_SELECT && !gl->selection.size) || (mode == GL_FEEDBACK && !gl->feedback.size))
        gl_error(gl, GL_INVALID_OPERATION, __func__);
    gl->render_mode = mode;
    return result;
}
