/* Lesson 21: a scene on a microcontroller. There is no operating system, no heap and not enough
 * memory for a picture: the display has 240x240 pixels of two bytes, and only 24 rows of them fit.
 * So the scene is drawn ten times, each time into one band of rows, and each band is sent to the
 * display. */
#include "lesson.h" /* only to write the display's contents to a file */

enum { WIDTH = 240, HEIGHT = 240, BAND = 24 };
enum { RINGS = 24, SECTORS = 12, VERTICES = RINGS * SECTORS, INDICES = 6 * VERTICES };

/* All memory that the firmware needs, known when it is compiled. */
static uint16_t band_color[WIDTH * BAND], band_depth[WIDTH * BAND];
static float position[VERTICES][3], normal[VERTICES][3];
static uint16_t indices[INDICES];
static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];

/* Stands for the display, which keeps what it is sent. */
static uint32_t display[WIDTH * HEIGHT];

static const char help[] = "usage: 21_microcontroller [PICTURE.tga]\n"
                           "Draws a torus for a display of 240x240 pixels, in bands of 24 rows.\n";

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

/* The display's driver: sends rows first to first + BAND - 1. Displays on SPI take the higher byte
 * first; with GN_FORMAT_RGB565_SWAPPED that is how the band lies in memory. */
static void send_to_display(const gn_surface *band, int first)
{
    const gn_surface whole = gn_surface_bottom_up(display, GN_FORMAT_RGBA8, WIDTH, HEIGHT);
    const gn_surface rows = gn_surface_rows(&whole, (uint32_t)first, BAND);

    lesson_check(gn_blit(&rows, NULL, band, NULL, NULL));
}

/* The viewport is the whole display's, moved down so that row `first` is row 0 of the band.
 * Triangles outside the band are clipped away or have no pixels in it. */
static void draw_band(int first, const gn_lit_uniforms *uniforms)
{
    const gn_target target = {
        {gn_surface_bottom_up(band_color, GN_FORMAT_RGB565_SWAPPED, WIDTH, BAND)},
        gn_surface_bottom_up(band_depth, GN_FORMAT_D16, WIDTH, BAND)};
    const gn_mesh mesh = {.attribute = {[GN_ATTRIBUTE_POSITION] = {position[0], 3, 0, 0},
                                        [GN_ATTRIBUTE_NORMAL] = {normal[0], 3, 0, 0}},
                          .vertex_count = VERTICES,
                          .indices = indices,
                          .index_format = GN_INDEX_UINT16,
                          .count = INDICES};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_pipeline pipeline = {.depth.test = true, .raster.cull = GN_CULL_BACK};

    pipeline.raster.viewport = (gn_viewport){true, 0, (float)-first, WIDTH, HEIGHT};
    lesson_check(gn_use_gouraud(&pipeline, uniforms));
    gn_clear_color(&target.color[0], 0, 0.1f, 0.2f, 1);
    gn_clear_depth(&target.depth, 1);
    lesson_check(gn_draw(&target, &pipeline, &mesh, &workspace));
    send_to_display(&target.color[0], first);
}

int main(int argc, char **argv)
{
    gn_transform view, projection, turned, clip;
    gn_lit_uniforms uniforms = {.light = {.direction = {0.36f, 0.48f, 0.8f},
                                          .ambient = {0.1f, 0.1f, 0.1f},
                                          .diffuse = {0.9f, 0.6f, 0.1f}}};

    lesson_help(argc, argv, 1, help);
    make_torus();
    lesson_check(gn_rotate_x(-0.9f, &turned));
    lesson_check(gn_look_at_rh((gn_vec3){0, 0, 3}, (gn_vec3){0, 0, 0}, (gn_vec3){0, 1, 0}, &view));
    lesson_check(gn_perspective_rh_no(0.8f, (float)WIDTH / HEIGHT, 1, 5, &projection));
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
    tga_write(lesson_argument(argc, argv, 1, "build/examples/21_microcontroller.tga"), display,
              WIDTH, HEIGHT);
    return 0;
}
