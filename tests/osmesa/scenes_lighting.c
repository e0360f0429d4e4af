/* Scenes with lights and materials. */
#include "scene_parts.h"

static void set_vector(random_source *r, float low, float high, float v[4])
{
    for (int i = 0; i < 4; ++i)
        v[i] = between(r, low, high);
}

static void set_light_colors(const library *gl, random_source *r, GLenum light)
{
    static const GLenum names[] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR};
    float v[4];

    for (int i = 0; i < 3; ++i) {
        set_vector(r, i == 0 ? 0.0f : 0.2f, i == 0 ? 0.3f : 1.0f, v);
        gl->Lightfv(light, names[i], v);
    }
}

static void set_attenuation(const library *gl, random_source *r, GLenum light)
{
    gl->Lightf(light, GL_CONSTANT_ATTENUATION, between(r, 0.2f, 1.0f));
    if (one_in(r, 2))
        gl->Lightf(light, GL_LINEAR_ATTENUATION, between(r, 0.0f, 0.4f));
    if (one_in(r, 2))
        gl->Lightf(light, GL_QUADRATIC_ATTENUATION, between(r, 0.0f, 0.2f));
}

static void set_spot(const library *gl, random_source *r, GLenum light)
{
    float v[4];

    set_vector(r, -1.0f, 1.0f, v);
    v[2] -= 1.0f;
    gl->Lightfv(light, GL_SPOT_DIRECTION, v);
    gl->Lightf(light, GL_SPOT_CUTOFF, between(r, 20.0f, 90.0f));
    gl->Lightf(light, GL_SPOT_EXPONENT, one_in(r, 3) ? 0.0f : between(r, 0.0f, 20.0f));
}

/* Some lights: directional ones, or any. */
static void set_lights(const library *gl, random_source *r, bool any)
{
    const uint32_t lights = random_below(r, any ? 4 : 3) + (one_in(r, 12) ? 0 : 1);
    float v[4];

    gl->Enable(GL_LIGHTING);
    for (uint32_t i = 0; i < lights; ++i) {
        const GLenum light = GL_LIGHT0 + random_below(r, 8);

        set_light_colors(gl, r, light);
        set_vector(r, -2.0f, 2.0f, v);
        v[2] += 2.0f;
        v[3] = any && one_in(r, 2) ? between(r, 0.5f, 1.5f) : 0.0f;
        gl->Lightfv(light, GL_POSITION, v);
        if (any && one_in(r, 3))
            set_attenuation(gl, r, light);
        if (any && one_in(r, 3))
            set_spot(gl, r, light);
        gl->Enable(light);
    }
    if (one_in(r, 2)) {
        set_vector(r, 0.0f, 0.4f, v);
        gl->LightModelfv(GL_LIGHT_MODEL_AMBIENT, v);
    }
    gl->LightModeli(GL_LIGHT_MODEL_TWO_SIDE, one_in(r, 3));
    if (any && one_in(r, 3))
        gl->LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    if (any && one_in(r, 3))
        gl->LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
}

static void set_materials(const library *gl, random_source *r)
{
    static const GLenum names[] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION};
    float v[4];

    for (int i = 0; i < 4; ++i) {
        set_vector(r, 0.0f, i == 3 ? 0.2f : 1.0f, v);
        if (one_in(r, 3))
            gl->Materialfv(GL_FRONT_AND_BACK, names[i], v);
        else if (one_in(r, 2))
            gl->Materialfv(one_in(r, 2) ? GL_FRONT : GL_BACK, names[i], v);
    }
    if (!one_in(r, 3))
        gl->Materialf(GL_FRONT, GL_SHININESS, between(r, 0.0f, 128.0f));
    if (!one_in(r, 3))
        gl->Materialf(GL_BACK, GL_SHININESS, between(r, 0.0f, 60.0f));
}

/* How long normals are, by how many of what state. */
static void set_normals(const library *gl, random_source *r)
{
    if (one_in(r, 2))
        gl->Enable(GL_NORMALIZE);
    else if (one_in(r, 2))
        gl->Enable(GL_RESCALE_NORMAL);
}

static void set_normal(const library *gl, random_source *r)
{
    const float x = between(r, -1.0f, 1.0f), y = between(r, -1.0f, 1.0f);

    gl->Normal3f(x, y, between(r, -0.3f, 1.2f));
}

void draw_lit_vertices(const library *gl, random_source *r, bool has_colors)
{
    static const GLenum modes[] = {GL_TRIANGLES,  GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN,
                                   GL_QUAD_STRIP, GL_QUADS,          GL_POLYGON};
    const uint32_t draws = 1 + random_below(r, 2);

    for (uint32_t d = 0; d < draws; ++d) {
        const uint32_t vertices = 6 + random_below(r, 20);

        set_normal(gl, r);
        gl->Begin(pick(r, modes, 6));
        for (uint32_t i = 0; i < vertices; ++i) {
            const float x = between(r, -1.0f, 1.0f), y = between(r, -1.0f, 1.0f);

            if (!one_in(r, 4))
                set_normal(gl, r);
            if (has_colors)
                set_color(gl, r);
            gl->Vertex3f(x, y, between(r, -0.6f, 0.6f));
        }
        gl->End();
        gl->Flush();
    }
}

static void set_turn(const library *gl, random_source *r)
{
    const float x = between(r, -1.0f, 1.0f), y = between(r, -1.0f, 1.0f);

    gl->MatrixMode(GL_MODELVIEW);
    gl->LoadIdentity();
    gl->Translatef(0.3f * x, 0.3f * y, -3.0f);
    if (!one_in(r, 4))
        gl->Rotatef(between(r, -180.0f, 180.0f), x, y, one_in(r, 2) ? 1.0f : 0.0f);
}

/* Directional lights, which the reference lights in object space if lengths are kept. */
void draw_directional(const library *gl, random_source *r, int width, int height)
{
    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    if (!one_in(r, 3))
        set_turn(gl, r);
    if (one_in(r, 3))
        gl->ShadeModel(GL_FLAT);
    set_normals(gl, r);
    set_materials(gl, r);
    set_lights(gl, r, false);
    draw_lit_vertices(gl, r, false);
}

void set_lit_state(const library *gl, random_source *r)
{
    set_normals(gl, r);
    set_materials(gl, r);
    set_lights(gl, r, true);
}

/* All kinds of lights. */
void draw_lighting(const library *gl, random_source *r, int width, int height)
{
    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    set_lit_state(gl, r);
    if (one_in(r, 4))
        set_turn(gl, r);
    if (one_in(r, 6))
        gl->Enable(GL_COLOR_SUM);
    if (one_in(r, 4)) {
        gl->Enable(GL_FOG);
        gl->Fogf(GL_FOG_DENSITY, between(r, 0.0f, 0.4f));
    }
    draw_lit_vertices(gl, r, one_in(r, 2));
}

/* Materials that follow the colour. GL_BACK with two sides and colours of vertices is left out: the
 * reference then reads what is not set. So are materials that are set before they follow the
 * colour, with no drawing between: the reference then takes them for those of the vertices. */
void draw_color_material(const library *gl, random_source *r, int width, int height)
{
    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    set_normals(gl, r);
    set_lights(gl, r, one_in(r, 2));
    set_color(gl, r);
    gl->ColorMaterial(
        PICK(r, GL_FRONT, GL_FRONT_AND_BACK),
        PICK(r, GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_AMBIENT_AND_DIFFUSE));
    gl->Enable(GL_COLOR_MATERIAL);
    if (one_in(r, 2))
        set_color(gl, r);
    set_materials(gl, r);
    draw_lit_vertices(gl, r, !one_in(r, 3));
    if (one_in(r, 3)) {
        gl->Disable(GL_COLOR_MATERIAL);
        draw_lit_vertices(gl, r, one_in(r, 2));
    }
}
