/* What scenes share: matrices, colours and primitives; and the scenes of primitives. */
#include "scenes.h"

#include "scene_parts.h"

void set_matrices(const library *gl, random_source *r)
{
    const float z_near = between(r, 0.5f, 2.0f);
    const float half = between(r, 0.3f, 1.5f);
    const uint32_t moves = random_below(r, 4);

    gl->MatrixMode(GL_PROJECTION);
    gl->LoadIdentity();
    if (one_in(r, 3))
        gl->Ortho(-half, half, -half, half, -2.0, 2.0);
    else
        gl->Frustum(-half, half, -half, half, z_near, z_near + 6.0);
    gl->MatrixMode(GL_MODELVIEW);
    gl->LoadIdentity();
    gl->Translatef(0.0f, 0.0f, -z_near - between(r, 0.2f, 3.0f));
    for (uint32_t i = 0; i < moves; ++i) {
        const float x = between(r, -1.0f, 1.0f), y = between(r, -1.0f, 1.0f);
        const float z = between(r, -1.0f, 1.0f), angle = between(r, -180.0f, 180.0f);

        if (one_in(r, 3))
            gl->Rotatef(angle, x, y, z);
        else if (one_in(r, 2))
            gl->Translatef(0.4f * x, 0.4f * y, 0.4f * z);
        else
            gl->Scalef(1.0f + 0.5f * x, 1.0f + 0.5f * y, 1.0f + 0.5f * z);
    }
}

void set_color(const library *gl, random_source *r)
{
    const float red = between(r, -0.1f, 1.1f), green = between(r, -0.1f, 1.1f);
    const float blue = between(r, -0.1f, 1.1f), alpha = between(r, 0.0f, 1.0f);

    gl->Color4f(red, green, blue, alpha);
}

static void add_vertices(const library *gl, random_source *r, uint32_t count, float size)
{
    const float x0 = between(r, -1.0f, 1.0f), y0 = between(r, -1.0f, 1.0f);

    for (uint32_t i = 0; i < count; ++i) {
        const float x = x0 + between(r, -size, size), y = y0 + between(r, -size, size);
        const float z = between(r, -0.6f, 0.6f);

        if (!one_in(r, 4))
            set_color(gl, r);
        if (one_in(r, 8))
            gl->Vertex2f(x, y);
        else if (one_in(r, 8))
            gl->Vertex4f(x, y, z, between(r, 0.7f, 1.3f));
        else
            gl->Vertex3f(x, y, z);
    }
}

void draw_primitives(const library *gl, random_source *r, const GLenum *modes, uint32_t n)
{
    const uint32_t draws = 1 + random_below(r, 4);

    for (uint32_t i = 0; i < draws; ++i) {
        const GLenum mode = pick(r, modes, n);
        const uint32_t count = 3 + random_below(r, 24);
        const float size = one_in(r, 3) ? 0.2f : 1.0f;

        set_color(gl, r);
        gl->Begin(mode);
        add_vertices(gl, r, count, size);
        gl->End();
        if (one_in(r, 3))
            gl->Flush();
    }
}

void clear_window(const library *gl, random_source *r)
{
    const float red = between(r, 0.0f, 1.0f), green = between(r, 0.0f, 1.0f);
    const float blue = between(r, 0.0f, 1.0f), alpha = between(r, 0.0f, 1.0f);

    gl->ClearColor(red, green, blue, alpha);
    gl->ClearDepth(between(r, 0.6f, 1.0f));
    gl->ClearStencil((GLint)random_below(r, 256));
    gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

static void draw_triangles(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN};

    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    draw_primitives(gl, r, modes, 3);
}

/* Vertices on centres and sides of pixels. Quads and polygons would be divided by rules of their
 * own. */
static void draw_ties(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_POINTS, GL_LINES,
                                   GL_LINE_STRIP};
    const uint32_t draws = 2 + random_below(r, 5);

    clear_window(gl, r);
    gl->MatrixMode(GL_PROJECTION);
    gl->LoadIdentity();
    gl->Ortho(0.0, width, 0.0, height, -1.0, 1.0);
    gl->MatrixMode(GL_MODELVIEW);
    gl->LoadIdentity();
    for (uint32_t i = 0; i < draws; ++i) {
        const uint32_t count = 3 + random_below(r, 12);

        gl->PointSize((float)(1 + random_below(r, 6)));
        gl->LineWidth((float)(1 + random_below(r, 6)));
        gl->Begin(pick(r, modes, 5));
        for (uint32_t n = 0; n < count; ++n) {
            const float x = 0.5f * (float)random_below(r, 2 * (uint32_t)width);
            const float y = 0.5f * (float)random_below(r, 2 * (uint32_t)height);

            set_color(gl, r);
            gl->Vertex2f(x, y);
        }
        gl->End();
    }
}

static void draw_flat(const library *gl, random_source *r, int width, int height)
{
    gl->ShadeModel(GL_FLAT);
    draw_triangles(gl, r, width, height);
}

static void draw_quads(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_QUADS};

    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    draw_primitives(gl, r, modes, 1);
}

static void draw_quad_strips(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_QUAD_STRIP};

    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    draw_primitives(gl, r, modes, 1);
}

static void draw_polygons(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_POLYGON};

    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    draw_primitives(gl, r, modes, 1);
}

static void draw_flat_quads(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON};

    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    gl->ShadeModel(GL_FLAT);
    draw_primitives(gl, r, modes, 3);
}

static void draw_points(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_POINTS};

    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    gl->PointSize(one_in(r, 2) ? 1.0f : between(r, 0.3f, 12.0f));
    draw_primitives(gl, r, modes, 1);
}

static void draw_lines(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP};

    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    gl->LineWidth(one_in(r, 2) ? 1.0f : between(r, 0.3f, 9.0f));
    draw_primitives(gl, r, modes, 3);
}

/* In one scene of two hundred with zoomed rectangles of stencil, a row is of the next texel, and
 * with copied depths, one is a step off. In one multisampled scene of forty a resolved depth is a
 * step off, which the pixel with the hash of all depths shows. In one scene of four hundred of
 * polygon-modes, lines have the pattern of polygons in one library alone. */
const scene_class scene_classes[] = {
    {"ties", draw_ties, 0},
    {"triangles", draw_triangles, 0},
    {"flat", draw_flat, 0},
    {"quads", draw_quads, 0},
    {"quad-strips", draw_quad_strips, 0},
    {"polygons", draw_polygons, 0},
    {"flat-quads", draw_flat_quads, 0},
    {"points", draw_points, 0},
    {"lines", draw_lines, 2},
    {"states", draw_states, 0},
    {"alpha", draw_alpha, 0},
    {"fog", draw_fog, 2},
    {"clears", draw_clears, 0},
    {"arrays", draw_arrays, 0},
    {"directional", draw_directional, 0},
    {"lighting", draw_lighting, 0},
    {"color-material", draw_color_material, 0},
    {"textures", draw_textures, 0},
    {"copied-texture", draw_copied_texture, 0},
    {"texgen", draw_generated_coordinates, 0},
    {"mixed", draw_mixed, 0},
    {"clipped", draw_clipped, 0},
    {"clipped-lines", draw_clipped_lines, 0},
    {"clipped-surfaces", draw_clipped_surfaces, 0},
    {"combine", draw_combine, 300}, /* last bits, in one scene of 250 */
    {"bitmaps", draw_bitmaps, 0},
    {"pixels", draw_pixels, 0},
    {"polygon-stipple", draw_stippled_polygons, 0},
    {"line-stipple", draw_line_patterns, 0},
    {"polygon-lines", draw_polygon_lines, 0},
    {"polygon-points", draw_polygon_points, 0},
    {"polygon-modes", draw_polygon_modes, 0},
    {"smooth", draw_smooth, 0},
    {"attenuated-points", draw_attenuated_points, 0},
    {"accumulated", draw_accumulated, 0},
    {"curves", draw_curves, 2},
    {"surfaces", draw_surfaces, 2},
    {"lit-surfaces", draw_lit_surfaces, 2},
    {"transfer", draw_transferred, 20},
    {"read-pixels", draw_read_pixels, 0},
    {"transferred-textures", draw_transferred_textures, 0},
    {"copies", draw_copies, 20},
    {"shadows", draw_shadows, 0},
    {"cubes", draw_cubes, 0},
    {"seamless-cubes", draw_seamless_cubes, 0},
    {"volumes", draw_volumes, 0},
    {"units", draw_units, 0},
    {"generated-levels", draw_generated_levels, 0},
    {"srgb", draw_srgb, 0},
    {"lod-limits", draw_lod_limits, 0},
    {"renderbuffers", draw_renderbuffers, 0},
    {"multisampled", draw_multisampled, 1},
    {"blits", draw_blits, 0},
    {"to-texture", draw_to_texture, 0},
    {"to-layers", draw_to_layers, 0},
    {"lists", draw_listed_scene, 2}, /* draws fog, too */
    {"nested-lists", draw_nested_lists, 0},
    {"selection", draw_selected, 0},
    {"feedback", draw_fed_back, 0},
};
const unsigned scene_class_count = sizeof scene_classes / sizeof *scene_classes;
