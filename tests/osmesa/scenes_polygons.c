/* Scenes with patterns and modes of polygons, and patterns of lines. */
#include "scene_parts.h"

static void set_pattern(const library *gl, random_source *r)
{
    static GLubyte bytes[2048];

    fill_bytes(r, bytes, sizeof bytes);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1 << random_below(r, 4));
    gl->PixelStorei(GL_UNPACK_SKIP_PIXELS, one_in(r, 2) ? 0 : random_between(r, 0, 11));
    gl->PixelStorei(GL_UNPACK_LSB_FIRST, one_in(r, 3));
    gl->PolygonStipple(bytes);
    gl->Enable(GL_POLYGON_STIPPLE);
}

void draw_stippled_polygons(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_TRIANGLES,  GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS,
                                   GL_QUAD_STRIP, GL_POLYGON,        GL_LINE_STRIP,   GL_POINTS};

    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    set_pattern(gl, r);
    if (one_in(r, 2))
        gl->Enable(GL_DEPTH_TEST);
    if (one_in(r, 3)) {
        gl->StencilFunc(GL_ALWAYS, 3, 255);
        gl->StencilOp(GL_KEEP, GL_INCR, GL_INVERT);
        gl->Enable(GL_STENCIL_TEST);
    }
    draw_primitives(gl, r, modes, sizeof modes / sizeof *modes);
}

static void add_flagged_vertices(const library *gl, random_source *r, uint32_t count)
{
    const float x0 = between(r, -1.0f, 1.0f), y0 = between(r, -1.0f, 1.0f);
    const float size = one_in(r, 3) ? 0.3f : 1.0f;

    for (uint32_t i = 0; i < count; ++i) {
        const float x = x0 + between(r, -size, size), y = y0 + between(r, -size, size);

        gl->EdgeFlag(!one_in(r, 3));
        if (!one_in(r, 4))
            set_color(gl, r);
        gl->Vertex3f(x, y, between(r, -0.6f, 0.6f));
    }
}

/* Polygons as lines or points, with edge flags. */
void draw_unfilled(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN,
                                   GL_QUADS,     GL_QUAD_STRIP,     GL_POLYGON};
    const uint32_t draws = 1 + random_below(r, 4);
    const GLenum mode = PICK(r, GL_LINE, GL_POINT, GL_LINE);

    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    gl->PolygonMode(GL_FRONT_AND_BACK, mode);
    if (mode == GL_LINE && one_in(r, 3))
        gl->PolygonMode(GL_BACK, GL_FILL);
    if (one_in(r, 3))
        gl->Enable(GL_CULL_FACE);
    if (one_in(r, 2))
        gl->Enable(GL_DEPTH_TEST);
    if (one_in(r, 3))
        gl->ShadeModel(GL_FLAT);
    gl->LineWidth(one_in(r, 2) ? 1.0f : between(r, 0.3f, 5.0f));
    gl->PointSize(one_in(r, 2) ? 1.0f : between(r, 0.3f, 5.0f));
    for (uint32_t i = 0; i < draws; ++i) {
        set_color(gl, r);
        gl->Begin(pick(r, modes, 6));
        add_flagged_vertices(gl, r, 3 + random_below(r, 20));
        gl->End();
    }
}
