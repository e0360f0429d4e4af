/* Scenes with clip planes. */
#include "scene_parts.h"

/* Sets some clip planes, most of which leave a part of the scene, under the modelview matrix. */
static void set_clip_planes(const library *gl, random_source *r)
{
    const uint32_t count = 1 + random_below(r, 3);

    for (uint32_t i = 0; i < count; ++i) {
        const float x = between(r, -1.0f, 1.0f), y = between(r, -1.0f, 1.0f);
        const float z = between(r, -1.0f, 1.0f), distance = between(r, -0.3f, 0.8f);
        const GLdouble plane[4] = {(GLdouble)x, (GLdouble)y, (GLdouble)z, (GLdouble)distance};
        const GLenum name = GL_CLIP_PLANE0 + random_below(r, 8);

        gl->ClipPlane(name, plane);
        gl->Enable(name);
        if (one_in(r, 4))
            gl->Rotatef(between(r, -40.0f, 40.0f), x, y, z);
    }
}

static void draw_clipped_modes(const library *gl, random_source *r, const GLenum *modes,
                               uint32_t count)
{
    clear_window(gl, r);
    gl->Enable(GL_DEPTH_TEST);
    set_matrices(gl, r);
    set_clip_planes(gl, r);
    if (one_in(r, 3))
        set_matrices(gl, r);
    if (one_in(r, 3))
        gl->PointSize(between(r, 1.0f, 9.0f));
    draw_primitives(gl, r, modes, count);
}

void draw_clipped(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS,
                                   GL_POLYGON};

    (void)width;
    (void)height;
    draw_clipped_modes(gl, r, modes, sizeof modes / sizeof *modes);
}

void draw_clipped_lines(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_LINES, GL_LINE_STRIP, GL_POINTS};

    (void)width;
    (void)height;
    draw_clipped_modes(gl, r, modes, sizeof modes / sizeof *modes);
}

/* Lit and textured primitives, which are clipped. */
void draw_clipped_surfaces(const library *gl, random_source *r, int width, int height)
{
    (void)width;
    (void)height;
    clear_window(gl, r);
    gl->Enable(GL_DEPTH_TEST);
    set_matrices(gl, r);
    set_clip_planes(gl, r);
    if (one_in(r, 2)) {
        set_lit_state(gl, r);
        draw_lit_vertices(gl, r, one_in(r, 2));
    } else {
        set_texture(gl, r);
        draw_textured_vertices(gl, r, true, false);
    }
}
