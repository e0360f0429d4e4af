/* Checks lesson 15, whose shader the reference cannot draw. With a map of one value the lesson must
 * draw what gn_use_phong draws with that exponent, which is compared with the reference. In a few
 * pixels a channel may differ by one step, since gn_use_phong also multiplies by the vertices'
 * white, which is rounded. With the teapot's map most pixels are those of one of its two exponents.
 * usage: check-specular MODEL.obj DIFFUSE.tga SPECULAR.tga DIRECTORY */
#include <gnomon.h>

static gn_status checked_draw(const gn_target *target, const gn_pipeline *pipeline,
                              const gn_mesh *mesh, gn_workspace *workspace);

#define main specular_main
#define gn_draw checked_draw
#include "../../tools/examples/15_specular_map.c"
#undef gn_draw
#undef main

static uint32_t phong[2][WIDTH * HEIGHT], phong_depth[WIDTH * HEIGHT];
static unsigned char phong_memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];
static uint32_t exponents[2];
static unsigned long first_only, second_only, neither, drawn, by_more;

static void draw_phong(const shiny_uniforms *u, const gn_mesh *mesh, uint32_t exponent,
                       uint32_t *pixels)
{
    gn_target target = {{gn_surface_bottom_up(pixels, GN_FORMAT_RGBA8, WIDTH, HEIGHT)},
                        gn_surface_bottom_up(phong_depth, GN_FORMAT_D24, WIDTH, HEIGHT)};
    gn_lit_uniforms lit = {
        .clip_from_model = u->clip_from_model,
        .world_from_model = u->world_from_model,
        .normal_matrix = u->normal_matrix,
        .eye = u->eye,
        .light = {.direction = u->to_light, .ambient = u->ambient, .diffuse = u->diffuse},
        .material = {.diffuse_map = &u->diffuse_map,
                     .sampler = u->sampler,
                     .specular = u->specular,
                     .exponent = exponent}};
    gn_pipeline pipeline = {.depth.test_enabled = true};
    gn_workspace workspace = {.memory = phong_memory, .size = sizeof phong_memory};

    gn_clear_color(&target.color[0], 0.1f, 0.1f, 0.12f, 1);
    gn_clear_depth(&target.depth, 1);
    lesson_check(gn_use_phong(&pipeline, &lit));
    lesson_check(gn_draw(&target, &pipeline, mesh, &workspace));
}

/* Whether a channel differs by more than one step. */
static bool differs_by_more(uint32_t a, uint32_t b)
{
    for (int shift = 0; shift < 32; shift += 8)
        if (abs((int)(a >> shift & 255) - (int)(b >> shift & 255)) > 1)
            return true;
    return false;
}

static gn_status checked_draw(const gn_target *target, const gn_pipeline *pipeline,
                              const gn_mesh *mesh, gn_workspace *workspace)
{
    const gn_status status = gn_draw(target, pipeline, mesh, workspace);

    for (int e = 0; e < 2; ++e)
        draw_phong(pipeline->program.uniforms, mesh, exponents[e], phong[e]);
    first_only = second_only = neither = drawn = by_more = 0;
    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
        const bool first = color[i] == phong[0][i], second = color[i] == phong[1][i];

        drawn += phong_depth[i] != 0xFFFFFF;
        first_only += first && !second;
        second_only += second && !first;
        neither += !first && !second;
        by_more += differs_by_more(color[i], phong[0][i]);
    }
    return status;
}

static void run(char *model, char *diffuse, char *specular, const char *directory)
{
    char picture[4096];
    char *arguments[] = {(char *)"specular", model, diffuse, specular, picture, NULL};

    snprintf(picture, sizeof picture, "%s/15_specular_map.tga", directory);
    if (specular_main(5, arguments) != 0)
        exit(EXIT_FAILURE);
}

int main(int argc, char **argv)
{
    static const uint32_t values[] = {0, 1, 2, 3, 17, 64, 100, 254, 255};
    unsigned long differing = 0, wrong = 0, all = 0;
    char map[4096];

    if (argc != 5)
        return 2;
    snprintf(map, sizeof map, "%s/one-exponent.tga", argv[4]);
    for (size_t i = 0; i < sizeof values / sizeof *values; ++i) {
        const uint32_t texel = values[i] * 0x010101u | 0xFF000000u;

        tga_write(map, &texel, 1, 1);
        exponents[0] = values[i] ? values[i] : 1;
        exponents[1] = exponents[0] + 1;
        run(argv[1], argv[2], map, argv[4]);
        differing += second_only + neither;
        wrong += by_more;
        all += drawn;
    }
    printf("specular, 9 maps of one exponent: of %lu pixels %lu differ from gn_use_phong's by one "
           "step, %lu by more\n",
           all, differing - wrong, wrong);

    /* 255 and 26 are the values of the teapot's map; edges of its squares mix them. */
    exponents[0] = 255;
    exponents[1] = 26;
    run(argv[1], argv[2], argv[3], argv[4]);
    printf("specular: of %lu pixels of the teapot, %lu show exponent 255, %lu exponent 26, %lu "
           "others\n",
           drawn, first_only, second_only, neither);
    return wrong > 0 || differing > all / 100 || first_only < drawn / 100 ||
           second_only < drawn / 100 || neither > drawn / 10;
}
