/* Lesson 8: perspective. What is twice as far away looks half as large: x and y are divided by the
 * distance. Above: a model in an orthographic projection, which divides by nothing, and in a
 * perspective projection. Below: a floor of two triangles, filled by hand. What is mixed inside a
 * triangle must be divided too (right), or the squares bend (left). The right floor is compared
 * with Gnomon's. */
#include "lesson.h"

enum { WIDTH = 800, HEIGHT = 400, FLOOR_WIDTH = 400, FLOOR_HEIGHT = 240 };

static uint32_t color[WIDTH * HEIGHT], depth[WIDTH * HEIGHT];
static uint32_t floors[3][FLOOR_WIDTH * FLOOR_HEIGHT]; /* bent, by hand, Gnomon's */
static uint32_t picture[WIDTH * (FLOOR_HEIGHT + HEIGHT)];
static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];

static const char help[] = "usage: 08_perspective [MODEL.obj [TEXTURE.tga [PICTURE.tga]]]\n"
                           "Draws a model with an orthographic and a perspective projection.\n";

/* The eye stands at the origin and looks along -z; the model is moved in front of it. A point at
 * distance d = -z is drawn at x / (d tan(fov / 2)), y / (d tan(fov / 2)). A matrix cannot divide.
 * It writes d into w, and after the vertex shader everything is divided by w. */
static void make_projections(float eye_distance, float near_plane, gn_transform result[2])
{
    const float aspect = 0.5f * WIDTH / HEIGHT, wide = 1.15f, high = wide / aspect;
    const float fov_y = 2 * gn_atan(high / eye_distance); /* at the middle both show the same */

    lesson_check(gn_orthographic_rh_no(-wide, wide, -high, high, near_plane, 10, &result[0]));
    lesson_check(gn_perspective_rh_no(fov_y, aspect, near_plane, 10, &result[1]));
}

/* The floor's corners, in front of the eye and one unit below it. The texture coordinates count
 * squares: s from 0 to 3, t from 0 to 8. Two triangles: corners 0, 1, 2 and 0, 2, 3. */
static const float floor_position[4][3] = {
    {-1.5f, -1, -1}, {1.5f, -1, -1}, {1.5f, -1, -9}, {-1.5f, -1, -9}};
static const float floor_texcoord[4][2] = {{0, 0}, {3, 0}, {3, 8}, {0, 8}};
static const float half_height = 1.05f; /* tan(fov / 2) */

/* Fills a triangle of the floor by hand. */
static void fill_floor(uint32_t *to, const int index[3], bool divides)
{
    gn_vec3 p[3];
    double w[3], weight[3];

    for (int k = 0; k < 3; ++k) {
        const float *const at = floor_position[index[k]];
        const float distance = -at[2]; /* this is w */
        const float aspect = (float)FLOOR_WIDTH / FLOOR_HEIGHT;
        const float x_ndc = at[0] / (distance * half_height * aspect);
        const float y_ndc = at[1] / (distance * half_height);

        w[k] = distance;
        p[k] = (gn_vec3){lesson_rounded((x_ndc + 1) / 2 * FLOOR_WIDTH),
                         lesson_rounded((y_ndc + 1) / 2 * FLOOR_HEIGHT), 0};
    }
    for (int i = 0; i < FLOOR_WIDTH * FLOOR_HEIGHT; ++i) {
        double st[2] = {0, 0}, one_over_w = 0;

        if (!lesson_barycentric(p, i % FLOOR_WIDTH + 0.5, i / FLOOR_WIDTH + 0.5, weight))
            continue;
        for (int k = 0; k < 3; ++k) {
            const double share = divides ? weight[k] / w[k] : weight[k];

            one_over_w += share;
            st[0] += share * floor_texcoord[index[k]][0];
            st[1] += share * floor_texcoord[index[k]][1];
        }
        const int column = (int)(st[0] / one_over_w), row = (int)(st[1] / one_over_w);
        to[i] = (column + row) % 2 ? 0xFF80B0D0u : 0xFF203040u;
    }
}

/* Draws the same floor with Gnomon. Its texture has two by two texels and repeats. */
static void draw_floor(gn_workspace *workspace)
{
    static const uint32_t texels[4] = {0xFF203040u, 0xFF80B0D0u, 0xFF80B0D0u, 0xFF203040u};
    static const float white[4][3] = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
    static const uint8_t indices[6] = {0, 1, 2, 0, 2, 3};
    float texcoord[4][2];
    gn_transform projection;
    gn_texture texture;
    gn_unlit_uniforms uniforms = {
        .map = &texture, .sampler = {.minify = GN_MINIFY_NEAREST, .magnify = GN_MAGNIFY_NEAREST}};
    gn_pipeline pipeline = {.depth.test_enabled = false};
    gn_target target = {
        {gn_surface_bottom_up(floors[2], GN_FORMAT_RGBA8, FLOOR_WIDTH, FLOOR_HEIGHT)}, {0}};
    gn_mesh mesh = {.attribute = {[GN_ATTRIBUTE_POSITION] = {floor_position[0], 3, 0, 0},
                                  [GN_ATTRIBUTE_COLOR] = {white[0], 3, 0, 0},
                                  [GN_ATTRIBUTE_TEXCOORD] = {texcoord[0], 2, 0, 0}},
                    .vertex_count = 4,
                    .indices = indices,
                    .index_format = GN_INDEX_UINT8,
                    .count = 6};

    for (int i = 0; i < 8; ++i) /* from squares to widths of the texture */
        texcoord[i / 2][i % 2] = floor_texcoord[i / 2][i % 2] / 2;
    lesson_check(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, 2, 2, 1, 1, texels, &texture));
    lesson_check(gn_perspective_rh_no(2 * gn_atan(half_height), (float)FLOOR_WIDTH / FLOOR_HEIGHT,
                                      0.5f, 20, &projection));
    uniforms.clip_from_model = projection.matrix;
    lesson_check(gn_use_unlit(&pipeline, &uniforms));
    gn_clear_color(&target.color[0], 0, 0, 0, 1);
    lesson_check(gn_draw(&target, &pipeline, &mesh, workspace));
}

/* Draws the floor bent, straight by hand, and with Gnomon. Returns how many pixels of the last two
 * differ. */
static int draw_floors(gn_workspace *workspace)
{
    static const int triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
    int differing = 0;

    for (int i = 0; i < FLOOR_WIDTH * FLOOR_HEIGHT; ++i)
        floors[0][i] = floors[1][i] = 0xFF000000u;
    for (int t = 0; t < 2; ++t) {
        fill_floor(floors[0], triangles[t], false);
        fill_floor(floors[1], triangles[t], true);
    }
    draw_floor(workspace);
    for (int i = 0; i < FLOOR_WIDTH * FLOOR_HEIGHT; ++i)
        differing += floors[1][i] != floors[2][i];
    return differing;
}

/* The models above, the two floors below. */
static void put_together(void)
{
    for (int y = 0; y < FLOOR_HEIGHT + HEIGHT; ++y)
        for (int x = 0; x < WIDTH; ++x)
            picture[y * WIDTH + x] =
                y >= FLOOR_HEIGHT ? color[(y - FLOOR_HEIGHT) * WIDTH + x]
                                  : floors[x / FLOOR_WIDTH][y * FLOOR_WIDTH + x % FLOOR_WIDTH];
}

int main(int argc, char **argv)
{
    lesson_help(argc, argv, 3, help);
    obj_model model = lesson_model(lesson_argument(argc, argv, 1, "build/examples/teapot.obj"));
    tga_image image = tga_read(lesson_argument(argc, argv, 2, "build/examples/teapot_diffuse.tga"));
    gn_texture texture;
    lesson_check(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, image.width, image.height, 1, 1,
                                   image.pixel, &texture));

    const float eye_distance = lesson_slider("distance of the eye", 2.2f, 1.2f, 8);
    const float near_plane = lesson_slider("near plane", 0.1f, 0.1f, 4);
    const float turn = lesson_slider("turn of the model", -0.9f, -3.14f, 3.14f);
    gn_transform projection[2], turned, moved, view_from_model, clip_from_model;
    make_projections(eye_distance, near_plane, projection);
    lesson_check(gn_rotate_y(turn, &turned));
    lesson_check(gn_translate((gn_vec3){0, 0, -eye_distance}, &moved));
    lesson_check(gn_transform_compose(&moved, &turned, &view_from_model));

    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)},
                        gn_surface_bottom_up(depth, GN_FORMAT_D24, WIDTH, HEIGHT)};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_mesh mesh = lesson_mesh(&model);
    gn_clear_color(&target.color[0], 0.1f, 0.1f, 0.12f, 1);
    gn_clear_depth(&target.depth, 1);
    for (int half = 0; half < 2; ++half) {
        lesson_check(gn_transform_compose(&projection[half], &view_from_model, &clip_from_model));
        gn_unlit_uniforms uniforms = {.clip_from_model = clip_from_model.matrix, .map = &texture};
        gn_pipeline pipeline = {.depth.test_enabled = true};

        uniforms.sampler.minify = GN_MINIFY_LINEAR;
        pipeline.raster.viewport =
            (gn_viewport){true, half * WIDTH / 2.0f, 0, WIDTH / 2.0f, HEIGHT};
        lesson_check(gn_use_unlit(&pipeline, &uniforms));
        lesson_check(gn_draw(&target, &pipeline, &mesh, &workspace));
    }
    printf("floor: %d of %d pixels differ from those by hand\n", draw_floors(&workspace),
           FLOOR_WIDTH * FLOOR_HEIGHT);
    put_together();
    tga_write(lesson_argument(argc, argv, 3, "build/examples/08_perspective.tga"), picture, WIDTH,
              FLOOR_HEIGHT + HEIGHT);
    free(image.pixel);
    free(model.corner);
    return 0;
}
