/* Scenes of the accumulation buffer. */
#include "scene_parts.h"

static void set_scissor(const library *gl, random_source *r, int width, int height)
{
    const GLint x = random_between(r, -10, width), y = random_between(r, -10, height);
    const GLsizei columns = (GLsizei)random_below(r, (uint32_t)width);
    const GLsizei rows = (GLsizei)random_below(r, (uint32_t)height);

    gl->Scissor(x, y, columns, rows);
    gl->Enable(GL_SCISSOR_TEST);
}

static void clear_buffer(const library *gl, random_source *r)
{
    const float red = between(r, -1.2f, 1.2f), green = between(r, -1.0f, 1.0f);
    const float blue = between(r, -1.0f, 1.0f), alpha = between(r, -1.0f, 1.0f);

    gl->ClearAccum(red, green, blue, alpha);
    gl->Clear(GL_ACCUM_BUFFER_BIT);
}

static void set_mask(const library *gl, random_source *r)
{
    const GLboolean red = one_in(r, 2), green = one_in(r, 2);
    const GLboolean blue = one_in(r, 2), alpha = one_in(r, 2);

    gl->ColorMask(red, green, blue, alpha);
}

/* Sums beyond -1 to 1, too. The last drawing makes the reference copy its colours to the program's
 * memory: GL_RETURN alone does not. */
void draw_accumulated(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN};
    const uint32_t steps = 3 + random_below(r, 8);

    clear_window(gl, r);
    set_matrices(gl, r);
    clear_buffer(gl, r);
    for (uint32_t i = 0; i < steps; ++i) {
        const float value = between(r, -1.2f, 1.2f);

        switch (random_below(r, 7)) {
        case 0:
            draw_primitives(gl, r, modes, 3);
            break;
        case 1:
            set_scissor(gl, r, width, height);
            break;
        case 2:
            gl->Disable(GL_SCISSOR_TEST);
            break;
        case 3:
            set_mask(gl, r);
            break;
        case 4:
            clear_buffer(gl, r);
            break;
        default:
            gl->Accum(PICK(r, GL_ADD, GL_MULT, GL_ACCUM, GL_ACCUM, GL_LOAD, GL_RETURN),
                      one_in(r, 9) ? 30.0f * value : value);
        }
    }
    gl->Accum(GL_RETURN, one_in(r, 3) ? 1.0f : between(r, 0.3f, 2.0f));
    draw_primitives(gl, r, modes, 3);
}
