/* Draws random lines with the two functions of lesson 1, Gnomon's and Bresenham's, and compares
 * them. usage: check-line COUNT SEED */
#include <gnomon.h>

/* Names the back end, since to find it takes longer than to draw a line. */
static gn_status quick_draw(const gn_target *target, const gn_pipeline *pipeline,
                            const gn_mesh *mesh, gn_workspace *workspace)
{
    static gn_backend best;

    best = best == GN_BACKEND_AUTO ? gn_backend_best() : best;
    workspace->backend = best;
    return gn_draw(target, pipeline, mesh, workspace);
}

#define main line_main
#define gn_draw quick_draw
#include "../../tools/examples/01_line.c"
#undef gn_draw
#undef main

/* Returns a number from 0 to below - 1 (Marsaglia, "Xorshift RNGs", 2003). */
static int random_below(uint32_t *state, uint32_t below)
{
    *state ^= *state << 13;
    *state ^= *state >> 17;
    *state ^= *state << 5;
    return (int)(*state % below);
}

int main(int argc, char **argv)
{
    const gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)}, {0}};
    const int count = argc == 3 ? atoi(argv[1]) : 0;
    const unsigned int seed = argc == 3 ? (unsigned int)strtoul(argv[2], NULL, 10) : 0;
    uint32_t state = seed * 2654435769u | 1;
    gn_pipeline pipeline = {.raster.topology = GN_LINES};
    gn_transform clip_from_window;
    gn_color_uniforms uniforms;
    int wrong = 0;

    if (count <= 0) {
        fputs("usage: check-line COUNT SEED\n", stderr);
        return 2;
    }
    lesson_check(gn_orthographic_rh_no(0, WIDTH, 0, HEIGHT, -1, 1, &clip_from_window));
    uniforms.clip_from_model = clip_from_window.matrix;
    lesson_check(gn_use_vertex_color(&pipeline, &uniforms));
    for (int i = 0; i < count; ++i) {
        line l;

        l.x0 = random_below(&state, WIDTH);
        l.y0 = random_below(&state, HEIGHT);
        l.x1 = random_below(&state, WIDTH);
        l.y1 = random_below(&state, HEIGHT);
        clear(&target);
        bresenham(l);
        draw_line(&target, &pipeline, l);
        if (different_pixels() > 0 && wrong++ == 0)
            printf("another line: %d %d %d %d\n", l.x0, l.y0, l.x1, l.y1);
    }
    printf("%d of %d random lines (seed %u) differ from Bresenham's\n", wrong, count, seed);
    return wrong > 0;
}
