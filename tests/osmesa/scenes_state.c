/* Scenes under random states of rasterization and fragments, and of clears. */
#include "scene_parts.h"

#define COMPARISONS                                                                                \
    GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS
#define STENCIL_OPERATIONS                                                                         \
    GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP
#define FACTORS                                                                                    \
    GL_ZERO, GL_ONE, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_DST_COLOR, GL_ONE_MINUS_DST_COLOR,   \
        GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA,                \
        GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_COLOR, GL_CONSTANT_ALPHA,                         \
        GL_ONE_MINUS_CONSTANT_ALPHA

static void set_stencil(const library *gl, random_source *r)
{
    for (int i = 0; i < 2; ++i) {
        const GLenum face = i ? GL_BACK : GL_FRONT;
        const GLenum function = PICK(r, COMPARISONS), fail = PICK(r, STENCIL_OPERATIONS);
        const GLenum depth_fail = PICK(r, STENCIL_OPERATIONS), pass = PICK(r, STENCIL_OPERATIONS);
        const GLint reference = random_between(r, -20, 300);
        const GLuint mask = one_in(r, 2) ? 255 : random_below(r, 256);

        gl->StencilFuncSeparate(face, function, reference, mask);
        gl->StencilOpSeparate(face, fail, depth_fail, pass);
        gl->StencilMaskSeparate(face, one_in(r, 2) ? 255 : random_below(r, 256));
    }
    gl->Enable(GL_STENCIL_TEST);
}

static void set_blending(const library *gl, random_source *r)
{
    const GLenum source = PICK(r, FACTORS, GL_SRC_ALPHA_SATURATE), destination = PICK(r, FACTORS);
    const GLenum alpha_source = PICK(r, FACTORS), alpha_destination = PICK(r, FACTORS);
    const GLenum equation =
        PICK(r, GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX);
    const float red = between(r, -0.2f, 1.2f), green = between(r, 0.0f, 1.0f);

    gl->BlendColor(red, green, 0.3f, between(r, 0.0f, 1.0f));
    gl->BlendEquationSeparate(equation, one_in(r, 2) ? equation : GL_FUNC_ADD);
    gl->BlendFuncSeparate(source, destination, alpha_source, alpha_destination);
    gl->Enable(GL_BLEND);
}

static void set_masks(const library *gl, random_source *r)
{
    const GLboolean red = !one_in(r, 3), green = !one_in(r, 3), blue = !one_in(r, 3);

    gl->ColorMask(red, green, blue, !one_in(r, 3));
    gl->DepthMask(!one_in(r, 3));
}

static void set_scissor(const library *gl, random_source *r, int width, int height)
{
    const int x = random_between(r, -10, width), y = random_between(r, -10, height);
    const int columns = random_between(r, 0, width);

    gl->Scissor(x, y, columns, random_between(r, 0, height));
    gl->Enable(GL_SCISSOR_TEST);
}

static void set_rasterization(const library *gl, random_source *r, int width, int height)
{
    if (one_in(r, 3)) {
        gl->CullFace(PICK(r, GL_FRONT, GL_BACK, GL_BACK, GL_FRONT_AND_BACK));
        gl->Enable(GL_CULL_FACE);
    }
    if (one_in(r, 2))
        gl->FrontFace(GL_CW);
    if (one_in(r, 3)) {
        const float factor = between(r, -3.0f, 3.0f);

        gl->PolygonOffset(factor, between(r, -90.0f, 90.0f));
        gl->Enable(GL_POLYGON_OFFSET_FILL);
    }
    if (one_in(r, 3)) {
        const int x = random_between(r, -20, 40), y = random_between(r, -20, 40);
        const int columns = random_between(r, 1, 2 * width);

        gl->Viewport(x, y, columns, random_between(r, 1, 2 * height));
    }
    if (one_in(r, 3)) {
        const float z_near = between(r, 0.0f, 1.0f);

        gl->DepthRange((GLdouble)z_near, (GLdouble)between(r, 0.0f, 1.0f));
    }
    if (one_in(r, 3))
        set_scissor(gl, r, width, height);
}

void draw_states(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN};
    const int layers = 1 + (int)random_below(r, 3);

    clear_window(gl, r);
    for (int i = 0; i < layers; ++i) {
        set_matrices(gl, r);
        set_rasterization(gl, r, width, height);
        gl->DepthFunc(PICK(r, COMPARISONS));
        one_in(r, 3) ? gl->Disable(GL_DEPTH_TEST) : gl->Enable(GL_DEPTH_TEST);
        if (one_in(r, 2))
            set_blending(gl, r);
        if (one_in(r, 3))
            set_stencil(gl, r);
        if (one_in(r, 3))
            set_masks(gl, r);
        if (one_in(r, 6)) {
            gl->LogicOp(GL_CLEAR + random_below(r, 16));
            gl->Enable(GL_COLOR_LOGIC_OP);
        }
        draw_primitives(gl, r, modes, 3);
    }
}

/* The alpha test and the sum of colours. */
void draw_alpha(const library *gl, random_source *r, int width, int height)
{
    const GLenum mode = PICK(r, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_QUADS, GL_POINTS, GL_LINES);
    const bool has_sum = one_in(r, 2), has_array = one_in(r, 2);
    const uint32_t vertices = 12 + random_below(r, 20);

    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    gl->AlphaFunc(PICK(r, COMPARISONS),
                  one_in(r, 4) ? between(r, -0.2f, 1.2f) : (float)random_below(r, 256) / 255.0f);
    gl->Enable(GL_ALPHA_TEST);
    if (has_sum)
        gl->Enable(GL_COLOR_SUM);
    if (one_in(r, 3))
        gl->ShadeModel(GL_FLAT);
    gl->SecondaryColor3f(0.3f, between(r, -0.5f, 1.5f), 0.1f);
    gl->Begin(mode);
    for (uint32_t i = 0; i < vertices; ++i) {
        const float x = between(r, -1.0f, 1.0f), y = between(r, -1.0f, 1.0f);
        const float red = between(r, -0.2f, 1.2f), green = between(r, -0.2f, 1.2f);

        set_color(gl, r);
        if (has_array)
            gl->SecondaryColor3f(red, green, 0.5f);
        gl->Vertex3f(x, y, between(r, -0.6f, 0.6f));
    }
    gl->End();
}

/* Fog. With one fog coordinate of all vertices last bits of floats may differ, so that vertices
 * have coordinates of their own. */
void draw_fog(const library *gl, random_source *r, int width, int height)
{
    const float red = between(r, -0.2f, 1.2f), green = between(r, 0.0f, 1.0f);
    const float color[4] = {red, green, between(r, 0.0f, 1.0f), 0.4f};
    const GLenum mode = PICK(r, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_LINES);
    const float start = between(r, 0.5f, 4.0f);
    const GLenum fog_mode = PICK(r, GL_LINEAR, GL_EXP, GL_EXP2);
    const bool has_coordinates = one_in(r, 3), has_array = one_in(r, 2) || has_coordinates;

    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    gl->Fogfv(GL_FOG_COLOR, color);
    gl->Fogi(GL_FOG_MODE, (GLint)fog_mode);
    gl->Fogf(GL_FOG_DENSITY, between(r, 0.0f, 1.0f));
    gl->Fogf(GL_FOG_START, start);
    gl->Fogf(GL_FOG_END, one_in(r, 10) ? start : start + between(r, -1.0f, 4.0f));
    if (has_coordinates)
        gl->Fogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
    gl->Enable(GL_FOG);
    if (one_in(r, 4))
        gl->Enable(GL_COLOR_SUM);
    gl->FogCoordf(between(r, 0.0f, 4.0f));
    gl->Begin(mode);
    for (uint32_t i = 0; i < 18; ++i) {
        const float x = between(r, -1.0f, 1.0f), y = between(r, -1.0f, 1.0f);

        set_color(gl, r);
        if (has_array)
            gl->FogCoordf(between(r, -1.0f, 5.0f));
        gl->Vertex3f(x, y, between(r, -0.6f, 0.6f));
    }
    gl->End();
}

/* Clears of some buffers, with masks and scissors, over a drawing. Depths are 0, 0.5 or 1: with a
 * scissor, or a mask of stencil, the reference may be a step off at others, by a rule that is not
 * known. */
void draw_clears(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_TRIANGLES};
    const int clears = 1 + (int)random_below(r, 4);

    gl->Enable(GL_DEPTH_TEST);
    clear_window(gl, r);
    set_matrices(gl, r);
    draw_primitives(gl, r, modes, 1);
    for (int i = 0; i < clears; ++i) {
        const float red = between(r, -0.5f, 1.5f), green = between(r, 0.0f, 1.0f);
        GLbitfield buffers = 0;

        if (one_in(r, 2))
            set_scissor(gl, r, width, height);
        if (one_in(r, 2))
            set_masks(gl, r);
        gl->StencilMask(one_in(r, 2) ? ~0u : random_below(r, 256));
        gl->ClearColor(red, green, between(r, 0.0f, 1.0f), 0.25f);
        gl->ClearDepth((GLdouble)random_below(r, 3) / 2.0);
        gl->ClearStencil(random_between(r, -300, 300));
        buffers |= one_in(r, 2) ? GL_COLOR_BUFFER_BIT : 0;
        buffers |= one_in(r, 2) ? GL_DEPTH_BUFFER_BIT : 0;
        buffers |= one_in(r, 2) ? GL_STENCIL_BUFFER_BIT : 0;
        gl->Clear(buffers);
    }
}
