/* Lesson 3: filled triangles. A pixel belongs to a triangle if its centre lies on the inner side of
 * all three edges. The signs of three areas decide this. Divided by the triangle's area, they are
 * the pixel's barycentric coordinates, which mix the corners' colours. The lesson fills a pentagon
 * of five triangles by hand and with Gnomon: no pixel is drawn twice, and none is left out. */
#include "lesson.h"

enum { WIDTH = 64, HEIGHT = 48, MAGNIFIED = 10, MOST_TRIANGLES = 12 };

typedef struct vertex {
    gn_vec2 position;
    gn_vec3 color;
} vertex;

static vertex vertices[3 * MOST_TRIANGLES];
static uint32_t color[WIDTH * HEIGHT];
static int owners[WIDTH * HEIGHT]; /* by hand: how many triangles own a pixel */
static gn_vec3 by_hand[WIDTH * HEIGHT];
static uint32_t picture[WIDTH * MAGNIFIED * HEIGHT * MAGNIFIED];
static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];

static const char help[] = "usage: 03_triangles [PICTURE.tga]\n"
                           "Fills triangles with Gnomon and by hand, and compares.\n";

/* Returns twice the area of the triangle of a, b and the point (x, y): above 0 if the point lies to
 * the left of the edge from a to b, 0 if it lies on the edge, below 0 if it lies to the right.
 * Gnomon rounds vertices to 1/256 pixel; the vertices here are centres of pixels, which stay as
 * they are. */
static double area(gn_vec2 a, gn_vec2 b, double x, double y)
{
    return ((double)b.x - a.x) * (y - a.y) - ((double)b.y - a.y) * (x - a.x);
}

/* A centre on an edge must belong to one of the two triangles beside it. It belongs to the triangle
 * for which the edge is a left edge, which leads down, or a bottom edge, which leads to the right.
 */
static bool is_inside(gn_vec2 a, gn_vec2 b, double x, double y)
{
    const double side = area(a, b, x, y);
    const bool is_left_or_bottom = b.y < a.y || (b.y == a.y && b.x > a.x);

    return side > 0 || (side == 0 && is_left_or_bottom);
}

/* Fills a triangle: every pixel of the window whose centre it owns gets the corners' colours, mixed
 * by alpha, beta and gamma. Each is the share of the triangle's area that lies opposite its corner,
 * so together they are 1. */
static void fill_by_hand(const vertex v[3])
{
    const gn_vec2 a = v[0].position, b = v[1].position, c = v[2].position;
    const double whole = area(a, b, c.x, c.y);

    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
        const double x = i % WIDTH + 0.5, y = i / WIDTH + 0.5;

        if (!is_inside(a, b, x, y) || !is_inside(b, c, x, y) || !is_inside(c, a, x, y))
            continue;

        const float alpha = (float)(area(b, c, x, y) / whole);
        const float beta = (float)(area(c, a, x, y) / whole);
        const float gamma = (float)(area(a, b, x, y) / whole);
        by_hand[i] = gn_vec3_add(
            gn_vec3_add(gn_vec3_scale(v[0].color, alpha), gn_vec3_scale(v[1].color, beta)),
            gn_vec3_scale(v[2].color, gamma));
        ++owners[i];
    }
}

/* The largest difference of a pixel's channels, in steps of 1/255. */
static int steps_apart(gn_vec3 hand, uint32_t pixel)
{
    const float channel[3] = {hand.x, hand.y, hand.z};
    int most = 0;

    for (int i = 0; i < 3; ++i) {
        const int apart = abs((int)gn_round(channel[i] * 255) - (int)(pixel >> 8 * i & 255));

        most = apart > most ? apart : most;
    }
    return most;
}

/* Returns a corner of the polygon: the centre of a pixel, so that edges pass through many centres.
 */
static gn_vec2 corner_of_polygon(float turns, float radius)
{
    const float angle = turns * 2 * GN_PI;

    return (gn_vec2){32.5f + gn_round(radius * gn_cos(angle)),
                     22.5f + gn_round(radius * gn_sin(angle))};
}

/* Lists the corners of each triangle counter-clockwise: the middle, one corner, the next. Returns
 * the number of triangles. */
static uint32_t make_polygon(void)
{
    const int triangles = lesson_slider_int("triangles", 5, 3, MOST_TRIANGLES);
    const float turn = lesson_slider("turn of the first corner", 0.25f, 0, 1);
    const float radius = lesson_slider("radius in pixels", 22, 6, 22);
    static const gn_vec3 colors[3] = {{1, 0.95f, 0.7f}, {0.9f, 0.4f, 0.1f}, {0.2f, 0.3f, 0.7f}};

    for (int i = 0; i < triangles; ++i) {
        const float from = (float)i / (float)triangles, to = (float)(i + 1) / (float)triangles;

        vertices[3 * i] = (vertex){{32.5f, 22.5f}, colors[0]};
        vertices[3 * i + 1] = (vertex){corner_of_polygon(from + turn, radius), colors[1]};
        vertices[3 * i + 2] = (vertex){corner_of_polygon(to + turn, radius), colors[2]};
        fill_by_hand(&vertices[3 * i]);
    }
    return (uint32_t)triangles;
}

int main(int argc, char **argv)
{
    int twice = 0, differing = 0, steps = 0;

    lesson_help(argc, argv, 1, help);
    const uint32_t triangles = make_polygon();

    /* Tells gn_draw where the vertices lie: for each attribute the first number, how many numbers a
     * vertex has, and how many bytes lie between one vertex and the next. */
    gn_mesh mesh = {
        .attribute = {[GN_ATTRIBUTE_POSITION] = {.data = &vertices[0].position.x,
                                                 .components = 2,
                                                 .stride = sizeof(vertex)},
                      [GN_ATTRIBUTE_COLOR] = {.data = &vertices[0].color.x,
                                              .components = 3,
                                              .stride = sizeof(vertex)}},
        .vertex_count = 3 * triangles, /* vertices in the arrays */
        .count = 3 * triangles,        /* vertices to draw, from the first on */
    };
    gn_transform clip_from_window; /* positions are given in pixels */
    lesson_check(gn_orthographic_rh_no(0, WIDTH, 0, HEIGHT, -1, 1, &clip_from_window));
    gn_color_uniforms uniforms = {clip_from_window.matrix};
    gn_pipeline pipeline = {.depth.test_enabled = false};
    lesson_check(gn_use_vertex_color(&pipeline, &uniforms));

    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)}, {0}};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_clear_color(&target.color[0], 0, 0, 0, 0);
    lesson_check(gn_draw(&target, &pipeline, &mesh, &workspace));

    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
        const int apart = steps_apart(by_hand[i], color[i]);

        twice += owners[i] > 1;
        differing += (owners[i] > 0) != (color[i] != 0);
        steps = apart > steps ? apart : steps;
    }
    printf("%d pixels drawn twice, %d differ from those by hand\n", twice, differing);
    printf("colours: at most %d of 255 steps from those by hand\n", steps);

    gn_surface large =
        gn_surface_bottom_up(picture, GN_FORMAT_RGBA8, WIDTH * MAGNIFIED, HEIGHT * MAGNIFIED);
    lesson_check(gn_blit(&large, NULL, &target.color[0], NULL, NULL));
    tga_write(lesson_argument(argc, argv, 1, "build/examples/03_triangles.tga"), picture,
              WIDTH * MAGNIFIED, HEIGHT * MAGNIFIED);
    return 0;
}
