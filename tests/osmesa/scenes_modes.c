/* Scenes in GL_SELECT and GL_FEEDBACK. What the program's memory then has is drawn as pixels, one
 * for each word of 32 bits, after the word that glRenderMode returns. */
#include <string.h>

#include "scene_parts.h"

enum { MOST_WORDS = 128 * 128 };

static GLuint words[MOST_WORDS];

/* Returns how many words the buffer gets after the first one. Some scenes have more. */
static GLsizei choose_size(random_source *r, int width, int height)
{
    const GLsizei all = width * height - 1;

    memset(words, 0, sizeof words);
    return one_in(r, 8) ? 1 + (GLsizei)random_below(r, 60) : all;
}

static void save_state(const library *gl)
{
    gl->PushAttrib(GL_ALL_ATTRIB_BITS);
    gl->PushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
}

/* Ends the mode, and draws the words under the state that was saved. */
static void show_words(const library *gl, int width, int height)
{
    words[0] = (GLuint)gl->RenderMode(GL_RENDER);
    gl->PopClientAttrib();
    gl->PopAttrib();
    gl->WindowPos2i(0, 0);
    gl->DrawPixels(width, height, GL_RGBA, GL_UNSIGNED_BYTE, words);
}

/* Draws a scene of another class, and disables the arrays that it has enabled. */
static void draw_class(const library *gl, random_source *r, const char *name, int width, int height)
{
    gl->PushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    for (unsigned i = 0; i < scene_class_count; ++i)
        if (strcmp(scene_classes[i].name, name) == 0)
            scene_classes[i].draw(gl, r, width, height);
    gl->PopClientAttrib();
}

static void change_names(const library *gl, random_source *r)
{
    switch (random_below(r, 8)) {
    case 0:
        gl->InitNames();
        break;
    case 1:
    case 2:
        gl->PushName((GLuint)random_bits(r));
        break;
    case 3:
        gl->PopName();
        break;
    default:
        gl->LoadName((GLuint)random_bits(r));
    }
}

/* What hits: primitives of all modes, clipped or not, and raster positions. */
void draw_selected(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_POINTS,     GL_LINES,          GL_LINE_STRIP,   GL_LINE_LOOP,
                                   GL_TRIANGLES,  GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS,
                                   GL_QUAD_STRIP, GL_POLYGON};
    const GLsizei size = choose_size(r, width, height);
    const uint32_t draws = 1 + random_below(r, 20);

    save_state(gl);
    gl->SelectBuffer(size, words + 1);
    gl->RenderMode(GL_SELECT);
    gl->InitNames();
    gl->PushName(5);
    if (one_in(r, 3))
        gl->DepthRange((GLdouble)between(r, 0.0f, 1.0f), (GLdouble)between(r, 0.0f, 1.0f));
    for (uint32_t i = 0; i < draws; ++i) {
        const GLenum mode = pick(r, modes, sizeof modes / sizeof *modes);

        set_matrices(gl, r);
        if (one_in(r, 8)) {
            gl->Enable(GL_CULL_FACE);
            gl->CullFace(PICK(r, GL_FRONT, GL_BACK, GL_FRONT_AND_BACK));
        }
        if (one_in(r, 8))
            gl->PolygonMode(GL_FRONT_AND_BACK, PICK(r, GL_POINT, GL_LINE, GL_FILL));
        if (one_in(r, 6))
            gl->RasterPos3f(between(r, -1.0f, 1.0f), 0.1f, between(r, -1.0f, 1.0f));
        if (one_in(r, 6))
            gl->WindowPos3f(0.0f, 0.0f, between(r, -0.2f, 1.2f));
        if (one_in(r, 4))
            draw_class(gl, r, one_in(r, 2) ? "clipped-surfaces" : "arrays", width, height);
        else
            draw_primitives(gl, r, &mode, 1);
        change_names(gl, r);
    }
    show_words(gl, width, height);
}

/* In flat shading, no triangle is clipped where colours are written: the reference then has colours
 * of earlier triangles in vertices that clipping makes. */
static void draw_flat_feedback(const library *gl, random_source *r)
{
    const uint32_t count = 3 + random_below(r, 12);

    gl->MatrixMode(GL_PROJECTION);
    gl->LoadIdentity();
    gl->MatrixMode(GL_MODELVIEW);
    gl->LoadIdentity();
    for (GLenum i = 0; i < 8; ++i)
        gl->Disable(GL_CLIP_PLANE0 + i);
    gl->ShadeModel(GL_FLAT);
    gl->Begin(random_below(r, 10));
    for (uint32_t i = 0; i < count; ++i) {
        const float x = between(r, -0.9f, 0.9f), y = between(r, -0.9f, 0.9f);

        set_color(gl, r);
        gl->Vertex2f(x, y);
    }
    gl->End();
    gl->ShadeModel(GL_SMOOTH);
}

static void set_polygons(const library *gl, random_source *r)
{
    if (one_in(r, 2)) {
        gl->PolygonMode(GL_FRONT, PICK(r, GL_POINT, GL_LINE, GL_FILL));
        gl->PolygonMode(GL_BACK, PICK(r, GL_POINT, GL_LINE, GL_FILL));
    }
    if (one_in(r, 3)) {
        gl->PolygonOffset(between(r, -2.0f, 2.0f), between(r, -5.0f, 5.0f));
        gl->Enable(PICK(r, GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE));
    }
    if (one_in(r, 3)) {
        gl->Enable(GL_CULL_FACE);
        gl->CullFace(PICK(r, GL_FRONT, GL_BACK));
    }
    gl->FrontFace(PICK(r, GL_CW, GL_CCW));
    gl->LineStipple(2, 0x5555);
    if (one_in(r, 6))
        gl->Enable(GL_LINE_STIPPLE);
}

/* A list of whole primitives: of others the reference makes more than they have. */
static void draw_listed(const library *gl, random_source *r)
{
    const GLuint list = gl->GenLists(1);

    gl->NewList(list, GL_COMPILE);
    gl->Begin(PICK(r, GL_POINTS, GL_LINES, GL_TRIANGLES));
    for (int i = 0; i < 12; ++i) {
        const float x = between(r, -1.2f, 1.2f), y = between(r, -1.2f, 1.2f);

        set_color(gl, r);
        gl->Vertex2f(x, y);
    }
    gl->End();
    gl->PassThrough(between(r, 0.0f, 1.0f));
    gl->EndList();
    gl->CallList(list);
    gl->DeleteLists(list, 1);
}

/* Scenes of other classes. Those with edge flags are left out: in polygons as lines or points the
 * reference takes those of vertices for false in these modes. */
void draw_fed_back(const library *gl, random_source *r, int width, int height)
{
    static const char *const classes[] = {
        "triangles",      "quads",         "quad-strips",      "polygons", "points", "lighting",
        "color-material", "textures",      "texgen",           "mixed",    "units",  "arrays",
        "clipped",        "clipped-lines", "clipped-surfaces", "bitmaps",  "lines"};
    const GLsizei size = choose_size(r, width, height);
    const uint32_t scenes = 1 + random_below(r, 3);

    save_state(gl);
    gl->FeedbackBuffer(size,
                       PICK(r, GL_2D, GL_3D, GL_3D_COLOR, GL_3D_COLOR_TEXTURE, GL_4D_COLOR_TEXTURE),
                       (GLfloat *)(void *)(words + 1));
    gl->RenderMode(GL_FEEDBACK);
    for (uint32_t i = 0; i < scenes; ++i) {
        gl->PassThrough(between(r, -9.0f, 9.0f));
        set_polygons(gl, r);
        if (one_in(r, 4))
            draw_flat_feedback(gl, r);
        else if (one_in(r, 8))
            draw_listed(gl, r);
        else
            draw_class(gl, r, classes[random_below(r, sizeof classes / sizeof *classes)], width,
                       height);
    }
    show_words(gl, width, height);
}
