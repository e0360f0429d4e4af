/* Lesson 21: a scene on a microcontroller. There is no operating system, no heap and not enough
 * memory for a picture: of the display's 240 rows only 16 fit. So the scene is drawn fifteen times,
 * each time into one band of rows, and each band is sent to the display, from the top down. */
#include "lesson.h" /* only to write what the display shows to a file */

enum { WIDTH = 240, HEIGHT = 240, BAND = 16 };
enum { RINGS = 24, SECTORS = 12, VERTICES = RINGS * SECTORS, INDICES = 6 * VERTICES };

/* All memory that the firmware needs, known when it is compiled. */
static uint8_t band_color[2 * WIDTH * BAND]; /* 5 bits of red, 6 of green, 5 of blue */
static uint16_t band_depth[WIDTH * BAND];
static float position[VERTICES][3], normal[VERTICES][3];
static uint16_t indices[INDICES];
static unsigned char memory[GN_WORKSPACE_SIZE(VERTICES, 4)]; /* a lit colour has 4 varyings */

/* Stands for the display, which keeps the two bytes of each pixel that it is sent. It fills its
 * rows from left to right, the top row first. */
static uint8_t display[WIDTH * HEIGHT][2];
static uint32_t picture[WIDTH * HEIGHT];

static const char help[] = "usage: 21_microcontroller [PICTURE.tga]\n"
                           "Draws a torus for a display of 240x240 pixels, in bands of 16 rows.\n";

static uint16_t vertex_at(int ring, int sector)
{
    return (uint16_t)(ring % RINGS * SECTORS + sector % SECTORS);
}

/* A torus. Firmware would have these numbers in its flash memory. */
static void make_torus(void)
{
    int next = 0;

    for (int i = 0; i < VERTICES; ++i) {
        const float around = (float)(i / SECTORS) * (2 * GN_PI / RINGS);
        const float along = (float)(i % SECTORS) * (2 * GN_PI / SECTORS);
        const float n[3] = {gn_cos(along) * gn_cos(around), gn_cos(along) * gn_sin(around),
                            gn_sin(along)};

        for (int c = 0; c < 3; ++c) {
            const float middle = c == 0 ? gn_cos(around) : c == 1 ? gn_sin(around) : 0;
            normal[i][c] = n[c];
            position[i][c] = 0.7f * middle + 0.3f * n[c];
        }
    }
    for (int i = 0; i < VERTICES; ++i) {
        const int r = i / SECTORS, s = i % SECTORS;
        const uint16_t square[6] = {vertex_at(r, s),     vertex_at(r + 1, s),
                                    vertex_at(r, s + 1), vertex_at(r, s + 1),
                                    vertex_at(r + 1, s), vertex_at(r + 1, s + 1)};

        for (int k = 0; k < 6; ++k)
            indices[next++] = square[k];
    }
}

/* The display's driver. Displays on SPI take the higher byte of a pixel first, and so does
 * GN_FORMAT_RGB565_SWAPPED store it: the band is sent as it is. */
static void send_to_display(int first)
{
    for (int i = 0; i < WIDTH * BAND; ++i)
        for (int byte = 0; byte < 2; ++byte)
            display[first * WIDTH + i][byte] = band_color[2 * i + byte];
}

/* Draws the display's rows from `first` on, counted from the top. The viewport is the whole
 * display's. A viewport's y goes up from the band's lowest row, so the display's lowest row is
 * rows_below rows lower. Triangles without pixels in the band are dropped. */
static void draw_band(int first, const gn_lit_uniforms *uniforms)
{
    const gn_target target = {
        {gn_surface_top_down(band_color, GN_FORMAT_RGB565_SWAPPED, WIDTH, BAND)},
        gn_surface_top_down(band_depth, GN_FORMAT_D16, WIDTH, BAND)};
    const int rows_below = HEIGHT - (first + BAND);
    const gn_mesh mesh = {.attribute = {[GN_ATTRIBUTE_POSITION] = {position[0], 3, 0, 0},
                                        [GN_ATTRIBUTE_NORMAL] = {normal[0], 3, 0, 0}},
                          .vertex_count = VERTICES,
                          .indices = indices,
                          .index_format = GN_INDEX_UINT16,
                          .count = INDICES};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_pipeline pipeline = {.depth.test_enabled = true, .raster.cull = GN_CULL_BACK};

    pipeline.raster.viewport = (gn_viewport){true, 0, (float)-rows_below, WIDTH, HEIGHT};
    lesson_check(gn_use_gouraud(&pipeline, uniforms));
    gn_clear_color(&target.color[0], 0, 0.1f, 0.2f, 1);
    gn_clear_depth(&target.depth, 1);
    lesson_check(gn_draw(&target, &pipeline, &mesh, &workspace));
    send_to_display(first);
}

/* What the display shows, as GN_FORMAT_RGBA8. tga_write takes the bottom row first. */
static void look_at_display(void)
{
    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
        const uint32_t c = (uint32_t)display[i][0] << 8 | display[i][1];
        const uint32_t red = c >> 11, green = c >> 5 & 0x3F, blue = c & 0x1F;
        const int row = HEIGHT - 1 - i / WIDTH;

        picture[row * WIDTH + i % WIDTH] =
            (red * 255 / 31) | (green * 255 / 63) << 8 | (blue * 255 / 31) << 16 | 0xFF000000u;
    }
}

int main(int argc, char **argv)
{
    gn_transform view, projection, turned, clip;
    gn_lit_uniforms uniforms = {.light = {.direction = {0.36f, 0.48f, 0.8f},
                                          .ambient = {0.1f, 0.1f, 0.1f},
                                          .diffuse = {0.9f, 0.6f, 0.1f}}};

    lesson_help(argc, argv, 1, help);
    const float tilt = lesson_slider("tilt of the torus", -0.9f, -3.14f, 3.14f);
    const float fov = lesson_slider("field of view", 0.8f, 0.2f, 2);
    const float near_plane = lesson_slider("near plane", 1, 1, 4); /* cuts the torus open */
    make_torus();
    lesson_check(gn_rotate_x(tilt, &turned));
    lesson_check(gn_look_at_rh((gn_vec3){0, 0, 3}, (gn_vec3){0, 0, 0}, (gn_vec3){0, 1, 0}, &view));
    lesson_check(gn_perspective_rh_no(fov, (float)WIDTH / HEIGHT, near_plane, 5, &projection));
    lesson_check(gn_transform_compose(&view, &turned, &clip));
    lesson_check(gn_transform_compose(&projection, &clip, &clip));
    uniforms.clip_from_model = clip.matrix;
    uniforms.world_from_model = turned.matrix;
    gn_transform_normal_matrix(&turned, &uniforms.normal_matrix);
    for (int first = 0; first < HEIGHT; first += BAND)
        draw_band(first, &uniforms);

    printf("memory: %u bytes for bands, %u for the model, %u for the library\n",
           (unsigned)(sizeof band_color + sizeof band_depth),
           (unsigned)(sizeof position + sizeof normal + sizeof indices), (unsigned)sizeof memory);
    look_at_display();
    tga_write(lesson_argument(argc, argv, 1, "build/examples/21_microcontroller.tga"), picture,
              WIDTH, HEIGHT);
    return 0;
}
