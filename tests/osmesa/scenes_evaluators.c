/* Scenes of evaluators: curves and surfaces with colours, normals and texture coordinates. */
#include "scene_parts.h"

enum { MOST_ORDER = 8, MOST_STRIDE = 6, MOST_POINTS = MOST_ORDER * MOST_ORDER * MOST_STRIDE };

/* The domain of maps and grids, mostly 0 to 1. */
typedef struct domain {
    float low, high;
} domain;

static domain choose_domain(random_source *r)
{
    const float low = between(r, -2.0f, 2.0f), size = between(r, 0.3f, 3.0f);

    return one_in(r, 2) ? (domain){0.0f, 1.0f}
                        : (domain){low, one_in(r, 4) ? low - size : low + size};
}

typedef struct patch {
    domain u, v;
    GLint order[2];
} patch;

/* Surfaces have two points or more in each direction: of one, the reference reads memory that was
 * never set where it computes normals. */
static patch choose_patch(random_source *r, bool has_normals)
{
    const GLint least = has_normals ? 2 : 1;
    const domain u = choose_domain(r), v = choose_domain(r);
    const GLint rows = one_in(r, 2) ? 4 : random_between(r, least, MOST_ORDER);
    const GLint columns = one_in(r, 2) ? 4 : random_between(r, least, MOST_ORDER);

    return (patch){u, v, {rows, columns}};
}

/* Sets a map of a surface, or of a curve of the same target. Components are random around the grid
 * of the points, within `low` and `high`. */
static void set_map(const library *gl, random_source *r, GLenum target, const patch *p,
                    bool is_surface, float low, float high)
{
    static GLfloat floats[MOST_POINTS];
    static GLdouble doubles[MOST_POINTS];
    const GLint stride = random_between(r, 4, MOST_STRIDE);
    const GLint rows = p->order[0], columns = is_surface ? p->order[1] : 1;
    const bool is_position =
        target >= GL_MAP2_VERTEX_3 || (target < GL_MAP2_COLOR_4 && target >= GL_MAP1_VERTEX_3);

    for (GLint i = 0; i < rows; ++i)
        for (GLint j = 0; j < columns; ++j)
            for (GLint c = 0; c < stride; ++c) {
                const float x = rows > 1 ? 2.4f * (float)i / (float)(rows - 1) - 1.2f : 0.0f;
                const float y = columns > 1 ? 2.4f * (float)j / (float)(columns - 1) - 1.2f : 0.0f;
                const float at = !is_position ? 0.0f
                                 : c == 0     ? x
                                 : c == 1     ? y
                                 : c == 3     ? 1.0f
                                              : 0.0f;
                const GLint place = (i * columns + j) * stride + c;

                floats[place] = at + between(r, low, high);
                doubles[place] = (GLdouble)floats[place];
            }
    if (is_surface && one_in(r, 3))
        gl->Map2d(target, (GLdouble)p->u.low, (GLdouble)p->u.high, stride * columns, rows,
                  (GLdouble)p->v.low, (GLdouble)p->v.high, stride, columns, doubles);
    else if (is_surface)
        gl->Map2f(target, p->u.low, p->u.high, stride * columns, rows, p->v.low, p->v.high, stride,
                  columns, floats);
    else if (one_in(r, 3))
        gl->Map1d(target, (GLdouble)p->u.low, (GLdouble)p->u.high, stride, rows, doubles);
    else
        gl->Map1f(target, p->u.low, p->u.high, stride, rows, floats);
    if (!one_in(r, 12))
        gl->Enable(target);
}

static void set_maps(const library *gl, random_source *r, bool is_surface, bool is_lit)
{
    const GLenum first = is_surface ? GL_MAP2_COLOR_4 : GL_MAP1_COLOR_4;
    const bool has_normals = is_surface && is_lit && one_in(r, 2);
    const patch p = choose_patch(r, is_lit);
    const GLenum position = one_in(r, 3) ? GL_MAP1_VERTEX_4 : GL_MAP1_VERTEX_3;

    set_map(gl, r, first + position - GL_MAP1_COLOR_4, &p, is_surface, -0.3f, 0.3f);
    if (has_normals)
        gl->Enable(GL_AUTO_NORMAL);
    for (int i = 0; i < 3; ++i) {
        static const GLenum others[] = {GL_MAP1_COLOR_4,         GL_MAP1_INDEX,
                                        GL_MAP1_NORMAL,          GL_MAP1_TEXTURE_COORD_1,
                                        GL_MAP1_TEXTURE_COORD_2, GL_MAP1_TEXTURE_COORD_3,
                                        GL_MAP1_TEXTURE_COORD_4};
        const GLenum other = others[random_below(r, sizeof others / sizeof *others)];
        const patch own = choose_patch(r, false);

        if (one_in(r, 3))
            set_map(gl, r, first + other - GL_MAP1_COLOR_4, one_in(r, 2) ? &own : &p, is_surface,
                    other == GL_MAP1_NORMAL ? -1.0f : -0.1f, 1.1f);
    }
    if (!one_in(r, 8)) {
        gl->MapGrid1f(random_between(r, 1, 12), p.u.low, p.u.high);
        gl->MapGrid2f(random_between(r, 1, 9), p.u.low, p.u.high, random_between(r, 1, 9), p.v.low,
                      p.v.high);
    }
}

static void draw_mesh(const library *gl, random_source *r, bool is_surface)
{
    const GLint first = one_in(r, 3) ? random_between(r, -2, 4) : 0;
    const GLint last = random_between(r, 0, 9), other = random_between(r, 0, 9);

    if (is_surface)
        gl->EvalMesh2(PICK(r, GL_POINT, GL_LINE, GL_FILL, GL_FILL), first, last, first, other);
    else
        gl->EvalMesh1(PICK(r, GL_POINT, GL_LINE, GL_LINE), first, last);
}

/* Sets all attributes that maps set. In the reference, evaluators lose the current values of
 * those. */
static void set_current_values(const library *gl, random_source *r)
{
    const float s = between(r, 0.0f, 1.0f), t = between(r, 0.0f, 1.0f);

    set_color(gl, r);
    gl->Normal3f(0.0f, 0.6f, 0.8f);
    gl->TexCoord4f(s, t, 0.0f, 1.0f);
}

/* Vertices at random places, of evaluators and of others; those of lists are of evaluators alone,
 * since the reference crashes where both are compiled. */
static void draw_coordinates(const library *gl, random_source *r, bool is_surface, bool is_listed)
{
    const uint32_t count = 3 + random_below(r, 12);

    gl->Begin(is_surface ? PICK(r, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_POINTS)
                         : PICK(r, GL_LINE_STRIP, GL_TRIANGLE_STRIP, GL_POINTS));
    for (uint32_t i = 0; i < count; ++i) {
        const float u = between(r, -0.2f, 1.2f), v = between(r, -0.2f, 1.2f);
        const GLint column = random_between(r, -1, 9), row = random_between(r, -1, 9);

        if (!is_listed && one_in(r, 6)) {
            set_current_values(gl, r);
            gl->Vertex3f(u, v, u - v);
        } else if (is_surface) {
            one_in(r, 2)   ? gl->EvalCoord2f(u, v)
            : one_in(r, 2) ? gl->EvalCoord2d((GLdouble)u, (GLdouble)v)
                           : gl->EvalPoint2(column, row);
        } else {
            one_in(r, 2)   ? gl->EvalCoord1f(u)
            : one_in(r, 2) ? gl->EvalCoord1d((GLdouble)u)
                           : gl->EvalPoint1(column);
        }
    }
    gl->End();
}

/* Lists have one drawing, of surfaces: where a list changes maps between two, some pixels differ,
 * and so do colours of curves in lists, in one scene of ten. */
static void draw_maps(const library *gl, random_source *r, bool is_surface, bool is_lit)
{
    const bool is_listed = is_surface && !is_lit && one_in(r, 4);
    const uint32_t draws = is_listed ? 1 : 1 + random_below(r, 3);

    set_current_values(gl, r);
    if (is_listed)
        gl->NewList(1, one_in(r, 2) ? GL_COMPILE : GL_COMPILE_AND_EXECUTE);
    for (uint32_t i = 0; i < draws; ++i) {
        if (i == 0 || one_in(r, 3))
            set_maps(gl, r, is_surface, is_lit);
        if (!is_listed)
            set_current_values(gl, r);
        one_in(r, 3) ? draw_coordinates(gl, r, is_surface, is_listed)
                     : draw_mesh(gl, r, is_surface);
    }
    if (!is_listed)
        return;
    gl->EndList();
    set_current_values(gl, r);
    gl->CallList(1);
}

/* Curves are points and lines, whose pixels may be a step off. */
void draw_curves(const library *gl, random_source *r, int width, int height)
{
    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    if (one_in(r, 3))
        gl->LineWidth(between(r, 0.3f, 5.0f));
    draw_maps(gl, r, false, false);
}

void draw_surfaces(const library *gl, random_source *r, int width, int height)
{
    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    gl->Enable(GL_DEPTH_TEST);
    if (one_in(r, 2))
        set_texture(gl, r);
    draw_maps(gl, r, true, false);
}

void draw_lit_surfaces(const library *gl, random_source *r, int width, int height)
{
    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    set_lit_state(gl, r);
    if (one_in(r, 2))
        gl->Enable(GL_DEPTH_TEST);
    draw_maps(gl, r, true, true);
}
