/* Calls of selection and feedback, with random arguments. */
#include "state_calls.h"

enum { WORDS = 64 };

/* Right and wrong arguments of glSelectBuffer and glFeedbackBuffer; a size is at most that of the
 * memory. Without memory a buffer has no size: the reference writes to it. */
static GLsizei buffer_size(const arguments *a, bool has_memory)
{
    return (a->i[0] & 15) == 0 ? a->i[1] % (WORDS + 1) : has_memory ? WORDS - (a->i[1] & 3) : 0;
}

GLint call_mode(const library *gl, unsigned kind, const arguments *a)
{
    static GLuint hits[WORDS];
    static GLfloat values[WORDS];
    const bool has_memory = (a->i[2] & 7) != 0;
    const GLsizei size = buffer_size(a, has_memory);

    switch (kind) {
    case 0:
        gl->SelectBuffer(has_memory || size < 0 ? size : 0, has_memory ? hits : NULL);
        break;
    case 1:
        gl->FeedbackBuffer(size, a->i[3] & 7 ? GL_2D + (GLenum)(a->i[3] & 7) - 1 : a->e[0],
                           has_memory ? values : NULL);
        break;
    case 2:
    case 3:
        return gl->RenderMode(a->i[0] & 7 ? GL_RENDER + ((GLenum)a->i[1] & 3) : a->e[0]);
    case 4:
        gl->InitNames();
        break;
    case 5:
        gl->LoadName((GLuint)a->i[0]);
        break;
    case 6:
        for (int i = a->i[1] & 15; i >= 0; --i)
            gl->PushName((GLuint)a->i[0]);
        break;
    case 7:
        gl->PopName();
        break;
    case 8:
        gl->PassThrough(a->f[0]);
        break;
    case 9:
        gl->Begin(GL_POINTS + (GLenum)(a->i[0] & 7));
        gl->Vertex3f(0.1f, 0.2f, 0.3f * a->f[0]);
        gl->Vertex3f(0.3f, 0.2f, 0.1f);
        gl->Vertex3f(0.2f, a->f[1], 0.1f);
        if (a->i[1] & 1)
            gl->PushName(1);
        if (a->i[1] & 2)
            gl->RenderMode(GL_RENDER);
        gl->End();
        break;
    default: {
        void *pointer = NULL;

        gl->GetPointerv(a->i[0] & 1 ? GL_SELECTION_BUFFER_POINTER : GL_FEEDBACK_BUFFER_POINTER,
                        &pointer);
        return pointer == hits ? 1 : pointer == values ? 2 : pointer ? 3 : 0;
    }
    }
    return 0;
}
