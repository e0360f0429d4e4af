/* Calls of display lists, with random arguments, and lists of calls that set state. */
#include "state_calls.h"

/* Kinds of calls of textures that take one number. The reference records it as four, so that in
 * lists it takes one for GL_TEXTURE_BORDER_COLOR, too, which OpenGL does not. */
enum { SCALAR_KINDS = 2 };

/* glClearIndex: the reference records a float and takes its bits for the index. */
enum { CLEAR_INDEX = 8 };

/* Kinds of calls of evaluators that set maps and grids. */
enum { MAP_KINDS = 8 };

/* Compiles calls in a list, which may be executed, too. The list has an end whatever its beginning
 * says; without a beginning, that is an error. */
static void compile_calls(const library *gl, const arguments *a)
{
    const unsigned bits = (unsigned)a->i[0];

    gl->NewList(bits & 3, bits & 4 ? GL_COMPILE : bits & 56 ? GL_COMPILE_AND_EXECUTE : 12345);
    if (bits & 8192)
        gl->PushAttrib(attribute_groups(a) & ~(GLbitfield)GL_CURRENT_BIT);
    if (bits & 64)
        call_matrix(gl, (unsigned)a->i[1] % MATRIX_KINDS, a);
    if (bits & 128)
        call_light(gl, (unsigned)a->i[2] % LIGHT_KINDS, a);
    if (bits & 256)
        call_texture(gl, SCALAR_KINDS + (unsigned)a->i[3] % (TEXTURE_KINDS - SCALAR_KINDS), a);
    if (bits & 512 && (unsigned)a->i[2] % KINDS != CLEAR_INDEX)
        call_function(gl, (unsigned)a->i[2] % KINDS, a);
    if (bits & 32768)
        call_evaluators(gl, (unsigned)a->i[1] % MAP_KINDS, a);
    if (bits & 8192)
        gl->PopAttrib();
    if (bits & 1024)
        gl->ListBase((GLuint)a->i[3] & 1);
    if ((bits & 6144) == 6144)
        gl->NewList(1, GL_COMPILE);
    gl->EndList();
}

void call_lists(const library *gl, unsigned kind, const arguments *a)
{
    const GLubyte names[] = {1, 2, 0, (GLubyte)(a->i[3] & 3)};

    switch (kind) {
    case 0:
    case 1:
        compile_calls(gl, a);
        break;
    case 2:
        gl->CallList((GLuint)a->i[0] & 3);
        break;
    case 3:
        gl->CallLists((a->i[0] & 7) < 5 ? a->i[0] & 7 : -1, a->i[1] & 15 ? GL_UNSIGNED_BYTE : 12345,
                      names);
        break;
    case 4:
        gl->ListBase((GLuint)a->i[0] & 1);
        break;
    case 5:
        gl->DeleteLists((GLuint)a->i[0] & 3, (a->i[1] & 3) - 1);
        break;
    case 6:
        gl->DeleteLists(gl->GenLists((a->i[0] & 7) - 1), 2);
        break;
    case 7: /* a draw of nothing, between glBegin and glEnd or not */
        gl->NewList(3, GL_COMPILE);
        gl->DrawArrays(a->e[0] & 1 ? GL_TRIANGLES : 12345, 0, 0);
        gl->EndList();
        if (a->i[0] & 1)
            gl->Begin(GL_TRIANGLES);
        gl->CallList(3);
        gl->End();
        break;
    default:
        gl->EndList();
    }
}
