/* Scenes with patterns and modes of polygons, and patterns of lines. */
#include "scene_parts.h"

enum { MOST_FLAGGED = 23 };

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

void draw_line_patterns(const library *gl, random_source *r, int width, int height)
{
    const uint32_t draws = 1 + random_below(r, 4);
    const bool is_flat = one_in(r, 3), is_textured = one_in(r, 3);

    (void)width;
    (void)height;
    clear_window(gl, r);
    gl->Enable(GL_LINE_STIPPLE);
    if (one_in(r, 3))
        gl->Enable(GL_DEPTH_TEST);
    if (is_textured)
        set_texture(gl, r);
    gl->ShadeModel(is_flat ? GL_FLAT : GL_SMOOTH);
    gl->PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    gl->LineWidth(one_in(r, 2) ? 1.0f : between(r, 0.3f, 5.0f));
    for (uint32_t i = 0; i < draws; ++i) {
        const uint32_t vertices = 2 + random_below(r, 12);
        GLint repeat;

        set_matrices(gl, r);
        repeat = one_in(r, 2) ? 1 : random_between(r, -2, 9);
        gl->LineStipple(repeat, (GLushort)random_below(r, 0x10000));
        gl->Begin(one_in(r, 3) ? PICK(r, GL_TRIANGLES, GL_TRIANGLE_FAN, GL_QUADS, GL_POLYGON)
                               : PICK(r, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP));
        for (uint32_t k = 0; k < vertices; ++k) {
            const float x = between(r, -1.2f, 1.2f), y = between(r, -1.2f, 1.2f);

            set_color(gl, r);
            if (is_textured)
                gl->TexCoord2f(x, y);
            if (one_in(r, 8))
                gl->Vertex2f(x, y);
            else if (one_in(r, 8))
                gl->Vertex4f(x, y, 0.2f, between(r, 0.7f, 1.3f));
            else
                gl->Vertex3f(x, y, between(r, -0.6f, 0.6f));
        }
        gl->End();
    }
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

/* The vertices of immediate mode, or of arrays with edge flags. */
static void draw_flagged(const library *gl, random_source *r)
{
    static const GLenum modes[] = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN,
                                   GL_QUADS,     GL_QUAD_STRIP,     GL_POLYGON};
    static GLfloat positions[MOST_FLAGGED][3];
    static GLboolean flags[MOST_FLAGGED];
    const GLenum mode = pick(r, modes, sizeof modes / sizeof *modes);
    const uint32_t count = 3 + random_below(r, MOST_FLAGGED - 3);

    set_color(gl, r);
    if (one_in(r, 2)) {
        gl->Begin(mode);
        add_flagged_vertices(gl, r, count);
        gl->End();
        return;
    }
    for (uint32_t i = 0; i < count; ++i) {
        flags[i] = !one_in(r, 3);
        for (int c = 0; c < 3; ++c)
            positions[i][c] = between(r, -0.8f, 0.8f);
    }
    gl->VertexPointer(3, GL_FLOAT, 0, positions);
    gl->EdgeFlagPointer(0, flags);
    gl->EnableClientState(GL_VERTEX_ARRAY);
    gl->EnableClientState(GL_EDGE_FLAG_ARRAY);
    gl->DrawArrays(mode, 0, (GLsizei)count);
    gl->Flush();
}

static void draw_in_mode(const library *gl, random_source *r, GLenum mode)
{
    const uint32_t draws = 1 + random_below(r, 4);

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
    for (uint32_t i = 0; i < draws; ++i)
        draw_flagged(gl, r);
}

void draw_polygon_lines(const library *gl, random_source *r, int width, int height)
{
    (void)width;
    (void)height;
    draw_in_mode(gl, r, GL_LINE);
}

void draw_polygon_points(const library *gl, random_source *r, int width, int height)
{
    (void)width;
    (void)height;
    draw_in_mode(gl, r, GL_POINT);
}

/* A mode for each face, with offsets, patterns, lights and textures. */
void draw_polygon_modes(const library *gl, random_source *r, int width, int height)
{
    const float factor = between(r, -3.0f, 3.0f);

    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    gl->PolygonMode(GL_FRONT, PICK(r, GL_POINT, GL_LINE, GL_FILL));
    gl->PolygonMode(GL_BACK, PICK(r, GL_POINT, GL_LINE, GL_FILL));
    gl->PolygonOffset(factor, between(r, -100000.0f, 100000.0f));
    for (GLenum i = 0; i < 3; ++i)
        if (one_in(r, 3))
            gl->Enable(
                PICK(r, GL_POLYGON_OFFSET_POINT, GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_FILL));
    if (one_in(r, 4))
        gl->Enable(GL_CULL_FACE);
    if (one_in(r, 4))
        gl->FrontFace(GL_CW);
    if (one_in(r, 3))
        gl->ShadeModel(GL_FLAT);
    if (one_in(r, 4))
        set_pattern(gl, r);
    if (one_in(r, 4)) {
        const GLint repeat = random_between(r, 1, 5);

        gl->LineStipple(repeat, (GLushort)random_below(r, 0x10000));
        gl->Enable(GL_LINE_STIPPLE);
    }
    gl->Enable(GL_DEPTH_TEST);
    gl->LineWidth(one_in(r, 2) ? 1.0f : between(r, 0.3f, 5.0f));
    gl->PointSize(one_in(r, 2) ? 1.0f : between(r, 0.3f, 5.0f));
    if (one_in(r, 2)) {
        set_lit_state(gl, r);
        draw_lit_vertices(gl, r, one_in(r, 2));
    } else if (one_in(r, 2)) {
        set_texture(gl, r);
        draw_textured_vertices(gl, r, true, false);
    } else {
        draw_flagged(gl, r);
    }
}

static void set_point_parameters(const library *gl, random_source *r)
{
    GLfloat attenuation[3];

    for (int i = 0; i < 3; ++i)
        attenuation[i] = one_in(r, 3) ? 0.0f : between(r, 0.0f, 1.0f);
    if (!one_in(r, 4))
        gl->PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
    if (one_in(r, 2))
        gl->PointParameterf(GL_POINT_SIZE_MIN, between(r, 0.0f, 4.0f));
    if (one_in(r, 2))
        gl->PointParameterf(GL_POINT_SIZE_MAX, between(r, 0.0f, 9.0f));
    gl->PointSize(one_in(r, 2) ? 1.0f : between(r, 0.3f, 20.0f));
}

/* Points whose sizes depend on their distance, some of them smooth, or corners of polygons. */
void draw_attenuated_points(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_POINTS, GL_POINTS, GL_TRIANGLES};

    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    set_point_parameters(gl, r);
    if (one_in(r, 3))
        gl->Enable(GL_DEPTH_TEST);
    if (one_in(r, 3))
        gl->Enable(GL_POINT_SMOOTH);
    gl->PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    draw_primitives(gl, r, modes, sizeof modes / sizeof *modes);
}

/* Smooth lines and points, those of polygons too. */
void draw_smooth(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_POINTS,    GL_LINES,     GL_LINE_STRIP,
                                   GL_LINE_LOOP, GL_TRIANGLES, GL_QUAD_STRIP};

    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    gl->Enable(PICK(r, GL_LINE_SMOOTH, GL_POINT_SMOOTH));
    if (one_in(r, 2))
        gl->Enable(PICK(r, GL_LINE_SMOOTH, GL_POINT_SMOOTH));
    if (one_in(r, 2)) {
        gl->Enable(GL_BLEND);
        gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    }
    if (one_in(r, 3))
        gl->PolygonMode(GL_FRONT_AND_BACK, PICK(r, GL_LINE, GL_POINT));
    if (one_in(r, 3))
        gl->Enable(GL_DEPTH_TEST);
    if (one_in(r, 3))
        gl->ShadeModel(GL_FLAT);
    if (one_in(r, 4)) {
        gl->AlphaFunc(GL_GREATER, between(r, 0.0f, 1.0f));
        gl->Enable(GL_ALPHA_TEST);
    }
    if (one_in(r, 4)) {
        const GLint repeat = random_between(r, 1, 5);

        gl->LineStipple(repeat, (GLushort)random_below(r, 0x10000));
        gl->Enable(GL_LINE_STIPPLE);
    }
    gl->LineWidth(one_in(r, 2) ? 1.0f : between(r, 0.3f, 8.0f));
    gl->PointSize(one_in(r, 2) ? 1.0f : between(r, 0.3f, 12.0f));
    if (one_in(r, 3)) {
        set_texture(gl, r);
        gl->TexCoord2f(0.3f, 0.6f);
    }
    draw_primitives(gl, r, modes, sizeof modes / sizeof *modes);
}
