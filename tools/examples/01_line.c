/* Lesson 1: a line from pixel to pixel. Bresenham's line takes, column by column, the pixel whose
 * centre is nearest to the line. It needs additions of integers alone. Gnomon draws the same
 * pixels, if both ends of the line are placed as draw_line places them. */
#include "lesson.h"

enum { WIDTH = 64, HEIGHT = 48, MAGNIFIED = 10 };
static const uint32_t background = 0xFF201C18, ink = 0xFFFFFFFF; /* alpha, blue, green, red */

static uint32_t color[WIDTH * HEIGHT], by_hand[WIDTH * HEIGHT];
static uint32_t picture[WIDTH * MAGNIFIED * HEIGHT * MAGNIFIED];
static unsigned char memory[GN_WORKSPACE_SIZE(2, GN_SHADER_VARYINGS)];

static const char help[] =
    "usage: 01_line [X0 Y0 X1 Y1 [PICTURE.tga]]  (pixels, from 0 0 to 63 47)\n"
    "Draws a line, or a star of lines, with Gnomon and as Bresenham did.\n";

typedef struct line {
    int x0, y0, x1, y1;
} line;

/* The line advances along a, its longer direction, and sometimes along b. `error` says how far the
 * line is beyond the lower edge of the pixel, in units of 1 / (2 length): when it passes the upper
 * edge, b takes a step. On the edge itself two pixels are equally near, and either is right. Gnomon
 * takes the step, but in a steep line always the left pixel. */
static void bresenham(line l)
{
    const bool steep = abs(l.y1 - l.y0) > abs(l.x1 - l.x0);
    const bool forward = steep ? l.y0 <= l.y1 : l.x0 <= l.x1;
    const line from = forward ? l : (line){l.x1, l.y1, l.x0, l.y0};
    const int a0 = steep ? from.y0 : from.x0, a1 = steep ? from.y1 : from.x1;
    const int b0 = steep ? from.x0 : from.y0, b1 = steep ? from.x1 : from.y1;
    const int length = a1 - a0, rise = abs(b1 - b0), step = b0 < b1 ? 1 : -1;
    const int limit = 2 * length + (steep && step > 0); /* where two pixels are equally near */
    int error = length, b = b0;

    for (int a = a0; a <= a1; ++a) {
        by_hand[steep ? a * WIDTH + b : b * WIDTH + a] = ink;
        error += 2 * rise;
        if (error >= limit) {
            b += step;
            error -= 2 * length;
        }
    }
}

/* A vertex a little to the lower left of the pixel's centre: gnomon/draw.h explains why. */
static gn_vec3 vertex_at(int x, int y)
{
    const float offset = 0.5f - 1.0f / 1024;

    return (gn_vec3){(float)x + offset, (float)y + offset, 0};
}

/* OpenGL's lines lack the pixel in which they end, so that in a strip of lines no pixel is drawn
 * twice. A point at the end adds it. */
static void draw_line(const gn_target *target, gn_pipeline *pipeline, line l)
{
    const bool backward = abs(l.y1 - l.y0) > abs(l.x1 - l.x0) ? l.y1 < l.y0 : l.x1 < l.x0;
    const gn_vec3 ends[2] = {vertex_at(l.x0, l.y0), vertex_at(l.x1, l.y1)};
    const gn_vec3 position[2] = {ends[backward], ends[!backward]};
    gn_mesh mesh = {.attribute[GN_ATTRIBUTE_POSITION] = {&position[0].x, 3, 0, 0},
                    .vertex_count = 2,
                    .count = 2};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};

    pipeline->raster.topology = GN_LINES;
    lesson_check(gn_draw(target, pipeline, &mesh, &workspace));
    pipeline->raster.topology = GN_POINTS;
    mesh.first = mesh.count = 1;
    lesson_check(gn_draw(target, pipeline, &mesh, &workspace));
}

static int different_pixels(void)
{
    int count = 0;

    for (int i = 0; i < WIDTH * HEIGHT; ++i)
        count += color[i] != by_hand[i];
    return count;
}

static void clear(const gn_target *target)
{
    gn_clear_color(&target->color[0], 24 / 255.0f, 28 / 255.0f, 32 / 255.0f, 1);
    for (int i = 0; i < WIDTH * HEIGHT; ++i)
        by_hand[i] = background;
}

static void draw_both(const gn_target *target, gn_pipeline *pipeline, line l)
{
    bresenham(l);
    draw_line(target, pipeline, l);
}

static void draw_star(const gn_target *target, gn_pipeline *pipeline)
{
    const int rays = lesson_slider_int("rays", 24, 1, 90);
    const float inner = lesson_slider("inner radius", 6, 0, 22);
    const float turn = lesson_slider("turn of the star", 0, 0, 1);

    for (int i = 0; i < rays; ++i) {
        const float angle = (float)i * (2 * GN_PI / (float)rays) + turn;
        const float x = gn_cos(angle), y = gn_sin(angle);
        const line ray = {32 + (int)gn_round(inner * x), 24 + (int)gn_round(inner * y),
                          32 + (int)gn_round(22 * x), 24 + (int)gn_round(22 * y)};

        draw_both(target, pipeline, ray);
    }
}

/* A blit to a larger surface repeats pixels. */
static void magnify(const gn_surface *from)
{
    const gn_surface to =
        gn_surface_bottom_up(picture, GN_FORMAT_RGBA8, WIDTH * MAGNIFIED, HEIGHT * MAGNIFIED);

    lesson_check(gn_blit(&to, NULL, from, NULL, NULL));
}

int main(int argc, char **argv)
{
    lesson_help(argc, argv, argc > 1 && argc < 5 ? 0 : 5, help); /* all four numbers, or none */
    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)}, {0}};
    gn_pipeline pipeline = {.raster.topology = GN_LINES};
    gn_transform clip_from_window; /* model coordinates are window coordinates */
    lesson_check(gn_orthographic_rh_no(0, WIDTH, 0, HEIGHT, -1, 1, &clip_from_window));
    gn_color_uniforms uniforms = {clip_from_window.matrix};
    lesson_check(gn_use_vertex_color(&pipeline, &uniforms));

    clear(&target);
    if (lesson_words(argc, argv) >= 5) {
        const line l = {atoi(argv[1]), atoi(argv[2]), atoi(argv[3]), atoi(argv[4])};
        if (l.x0 < 0 || l.x0 >= WIDTH || l.x1 < 0 || l.x1 >= WIDTH || l.y0 < 0 || l.y0 >= HEIGHT ||
            l.y1 < 0 || l.y1 >= HEIGHT) {
            fputs("01_line: an end of the line is outside the picture\n", stderr);
            return 2;
        }
        draw_both(&target, &pipeline, l);
    } else {
        draw_star(&target, &pipeline);
    }
    printf("%d pixels differ from Bresenham's\n", different_pixels());
    magnify(&target.color[0]);
    tga_write(lesson_argument(argc, argv, 5, "build/examples/01_line.tga"), picture,
              WIDTH * MAGNIFIED, HEIGHT * MAGNIFIED);
    return 0;
}
