/* Calls of occlusion queries, with random arguments. */
#include "state_calls.h"

/* The reference has other targets, too: one that both have, or none. */
static GLenum target_of(const arguments *a)
{
    static const GLenum targets[] = {GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED,
                                     GL_ANY_SAMPLES_PASSED_CONSERVATIVE, GL_TEXTURE_2D};

    return targets[a->i[1] & 3];
}

/* Draws points, some of which are outside the window. */
static void draw_points(const library *gl, const arguments *a)
{
    gl->Begin(GL_POINTS);
    for (int i = 0; i < 4; ++i)
        gl->Vertex3f(a->f[i], a->f[4 + i], a->f[8 + i]);
    gl->End();
}

GLint call_query(const library *gl, unsigned kind, const arguments *a)
{
    GLuint names[3] = {(GLuint)a->i[0] & 7, (GLuint)a->i[2] & 7, 0};
    GLint value = 0;

    switch (kind) {
    case 0:
        gl->GenQueries(a->i[1] & 7 ? 3 : -1, names);
        return (GLint)(names[0] ^ names[1] << 8 ^ names[2] << 16);
    case 1:
        gl->DeleteQueries(a->i[1] & 7 ? 2 : -1, names);
        break;
    case 2:
        return gl->IsQuery(names[0]);
    case 3:
    case 4:
        gl->BeginQuery(target_of(a), names[0]);
        break;
    case 5:
    case 6:
        gl->EndQuery(target_of(a));
        break;
    case 7:
        gl->GetQueryiv(target_of(a), a->i[2] & 1 ? GL_CURRENT_QUERY : GL_QUERY_COUNTER_BITS,
                       &value);
        break;
    case 8:
        gl->GetQueryiv(target_of(a), a->e[0], &value);
        break;
    case 9:
        gl->GetQueryObjectiv(names[0], GL_QUERY_RESULT, &value);
        break;
    case 10:
        gl->GetQueryObjectuiv(names[0], a->e[0], (GLuint *)&value);
        break;
    case 11: /* in the reference a result may not be there yet */
        gl->GetQueryObjectuiv(names[0], GL_QUERY_RESULT_AVAILABLE, (GLuint *)&value);
        return 0;
    default:
        draw_points(gl, a);
    }
    return value;
}
