/* Scenes of display lists: whole scenes of other classes that are compiled, and lists that call
 * each other. */
#include <string.h>

#include "scene_parts.h"

/* Classes whose scenes are compiled. Others draw quads and strips of more vertices than they need,
 * of which the reference makes something else in lists. */
static const char *const listed[] = {
    "triangles", "points",      "states",   "alpha",          "fog",
    "arrays",    "directional", "lighting", "color-material", "textures"};

static const scene_class *find_class(const char *name)
{
    for (unsigned i = 0; i < scene_class_count; ++i)
        if (strcmp(scene_classes[i].name, name) == 0)
            return &scene_classes[i];
    return NULL;
}

/* Compiles a scene of another class and draws it, several times if it does not clear in between. */
void draw_listed_scene(const library *gl, random_source *r, int width, int height)
{
    const GLuint list = gl->GenLists(3) + random_below(r, 3);
    const uint32_t calls = random_below(r, 3);
    const char *const name = listed[random_below(r, sizeof listed / sizeof *listed)];

    clear_window(gl, r);
    set_matrices(gl, r);
    if (one_in(r, 2))
        set_color(gl, r);
    gl->NewList(list, GL_COMPILE);
    find_class(name)->draw(gl, r, width, height);
    gl->EndList();
    for (uint32_t i = 0; i < calls; ++i) {
        set_color(gl, r);
        gl->CallList(list);
    }
    if (one_in(r, 2))
        gl->CallLists(1, GL_UNSIGNED_INT, &list);
}

/* What the vertices of a list have. All have a colour, since the reference does not always keep
 * that of a list's last vertex as the current one. The first vertex of a primitive has all of it:
 * an attribute that appears later makes the reference lose values, or take a primitive for an
 * unfinished one. */
typedef struct layout {
    bool has_color, has_normal, has_secondary, is_flat;
} layout;

static layout choose_layout(random_source *r)
{
    const bool has_normal = one_in(r, 3), has_secondary = one_in(r, 3);

    return (layout){true, has_normal, has_secondary, one_in(r, 6)};
}

static void add_vertex(const library *gl, random_source *r, const layout *has, bool is_first)
{
    const float x = between(r, -1.2f, 1.2f), y = between(r, -1.2f, 1.2f);
    const float z = between(r, -0.6f, 0.6f);

    if (has->has_color && (is_first || one_in(r, 2)))
        set_color(gl, r);
    if (has->has_normal && (is_first || one_in(r, 2)))
        gl->Normal3f(x, y, z);
    if (has->has_secondary && (is_first || one_in(r, 2)))
        gl->SecondaryColor3f(y, z, x);
    has->is_flat ? gl->Vertex2f(x, y) : gl->Vertex3f(x, y, z);
}

static void add_primitive(const library *gl, random_source *r, const layout *has)
{
    const GLenum mode = random_below(r, GL_POLYGON + 1);
    const uint32_t vertices = 12; /* the reference draws more than whole primitives have */

    gl->Begin(mode);
    for (uint32_t i = 0; i < vertices; ++i)
        add_vertex(gl, r, has, i == 0);
    gl->End();
}

/* Fills a list with primitives, changes of state and calls of the lists before it. */
static void fill_list(const library *gl, random_source *r, GLuint first, GLuint own)
{
    const uint32_t parts = 1 + random_below(r, 7);
    const layout has = choose_layout(r);

    for (uint32_t i = 0; i < parts; ++i) {
        const float angle = between(r, -40.0f, 40.0f);
        const GLubyte names[3] = {(GLubyte)random_below(r, own ? own : 1), 200, 0};

        switch (random_below(r, 9)) {
        case 0:
            set_color(gl, r);
            break;
        case 1:
            gl->Rotatef(angle, 0.2f, 0.3f, 1.0f);
            break;
        case 2:
            one_in(r, 2) ? gl->Enable(GL_DEPTH_TEST) : gl->Disable(GL_DEPTH_TEST);
            break;
        case 3:
            if (own > 0)
                gl->CallList(first + random_below(r, own));
            break;
        case 4:
            gl->ListBase(first);
            if (own > 0)
                gl->CallLists(3, GL_UNSIGNED_BYTE, names);
            break;
        case 5:
            one_in(r, 2) ? gl->Enable(GL_COLOR_SUM) : gl->Disable(GL_COLOR_SUM);
            break;
        default:
            add_primitive(gl, r, &has);
        }
    }
}

/* The vertices of a list, between glBegin and glEnd outside it. */
static void call_within_primitive(const library *gl, random_source *r, GLuint list)
{
    const uint32_t vertices = 3 + random_below(r, 9);
    const layout has = choose_layout(r);

    gl->NewList(list, GL_COMPILE);
    for (uint32_t i = 0; i < vertices; ++i)
        add_vertex(gl, r, &has, i == 0);
    gl->EndList();
    gl->Begin(PICK(r, GL_TRIANGLES, GL_TRIANGLE_FAN, GL_TRIANGLE_STRIP));
    add_vertex(gl, r, &has, true);
    gl->CallList(list);
    gl->End();
}

void draw_nested_lists(const library *gl, random_source *r, int width, int height)
{
    enum { LISTS = 4 };
    const GLuint first = gl->GenLists(LISTS + 1);
    const layout has = choose_layout(r);

    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    set_color(gl, r);
    for (GLuint i = 0; i < LISTS; ++i) {
        gl->NewList(first + i, GL_COMPILE);
        fill_list(gl, r, first, i);
        gl->EndList();
        if (one_in(r, 3))
            set_color(gl, r);
    }
    gl->CallList(first + LISTS - 1);
    set_color(gl, r);
    add_primitive(gl, r, &has);
    gl->CallList(first + random_below(r, LISTS));
    set_color(gl, r);
    if (one_in(r, 3))
        call_within_primitive(gl, r, first + LISTS);
    gl->DeleteLists(first, LISTS);
}
