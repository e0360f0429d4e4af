/* A turning cube with a texture, on a display of 240x240 pixels, drawn in bands of 16 rows from the
 * top down. All memory is known when the program is compiled. */
#include <gnomon.h>

#include "display.h"

enum { BAND = 16, CORNERS = 24, INDICES = 36, VARYINGS = 6 }; /* a lit colour, s and t */

static uint8_t band_color[2 * DISPLAY_WIDTH * BAND]; /* GN_FORMAT_RGB565_SWAPPED */
static uint16_t band_depth[DISPLAY_WIDTH * BAND];    /* GN_FORMAT_D16 */
static uint64_t memory[GN_WORKSPACE_SIZE(CORNERS, VARYINGS) / sizeof(uint64_t)];

/* What every corner of a side has: the side's normal, and axes along its width and its height.
 * Seen from outside, the axes go right and up. */
static const int8_t sides[6][3][3] = {
    {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}}, {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
    {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
};

static struct corner {
    float position[3], normal[3], texcoord[2];
} corners[CORNERS];
static uint8_t indices[INDICES];

/* An arrow that points up, so that the display shows whether it is upside down. Rows from the
 * bottom up, as textures have them; white 0xFFFF, red 0xC904, blue 0x2B5A. */
#define W 0xFFFF
#define R 0xC904
#define B 0x2B5A
static const uint16_t texels[8 * 8] = {
    B, B, B, B, B, B, B, B, /* the bottom */
    B, W, W, R, R, W, W, B, /**/
    B, W, W, R, R, W, W, B, /**/
    B, W, W, R, R, W, W, B, /**/
    B, R, R, R, R, R, R, B, /**/
    B, W, R, R, R, R, W, B, /**/
    B, W, W, R, R, W, W, B, /**/
    B, B, B, B, B, B, B, B, /* the top */
};
static const gn_texture texture = {
    .format = GN_FORMAT_RGB565,
    .width = 8,
    .height = 8,
    .level = {{.texels = texels, .row_stride = 8 * sizeof *texels}},
};

static void make_cube(void)
{
    static const uint8_t triangles[6] = {0, 1, 3, 0, 3, 2};

    for (int i = 0; i < CORNERS; ++i) {
        const int8_t(*const side)[3] = sides[i / 4];
        const int right = i & 1, up = i >> 1 & 1;

        for (int axis = 0; axis < 3; ++axis) {
            const int sum =
                side[0][axis] + side[1][axis] * (2 * right - 1) + side[2][axis] * (2 * up - 1);

            corners[i].position[axis] = (float)sum;
            corners[i].normal[axis] = side[0][axis];
        }
        corners[i].texcoord[0] = (float)right;
        corners[i].texcoord[1] = (float)up;
    }
    for (int i = 0; i < INDICES; ++i)
        indices[i] = (uint8_t)(i / 6 * 4 + triangles[i % 6]);
}

/* Sets where the cube stands in frame n, and the light. */
static gn_status set_scene(uint32_t n, gn_lit_uniforms *uniforms)
{
    gn_transform projection, view, turn, tilt, model, clip;
    gn_status status =
        gn_perspective_rh_no(0.8f, (float)DISPLAY_WIDTH / DISPLAY_HEIGHT, 1, 20, &projection);

    if (!status)
        status =
            gn_look_at_rh((gn_vec3){0, 0, 5.5f}, (gn_vec3){0, 0, 0}, (gn_vec3){0, 1, 0}, &view);
    if (!status)
        status = gn_rotate_y(0.6f + 0.05f * (float)n, &turn);
    if (!status)
        status = gn_rotate_x(0.5f, &tilt);
    if (!status)
        status = gn_transform_compose(&tilt, &turn, &model);
    if (!status)
        status = gn_transform_compose(&view, &model, &clip);
    if (!status)
        status = gn_transform_compose(&projection, &clip, &clip);
    *uniforms = (gn_lit_uniforms){
        .clip_from_model = clip.matrix,
        .world_from_model = model.matrix,
        .light = {.direction = {0.36f, 0.8f, 0.48f},
                  .ambient = {0.3f, 0.3f, 0.3f},
                  .diffuse = {0.7f, 0.7f, 0.7f}},
        .material = {.diffuse_map = &texture,
                     .sampler = {.magnify = GN_MAGNIFY_NEAREST, .minify = GN_MINIFY_NEAREST}},
    };
    gn_transform_normal_matrix(&model, &uniforms->normal_matrix);
    return status;
}

/* Draws the rows of the display from `first` on. The viewport is the whole display. In windows y
 * goes up and 0 is the band's last row, so the bottom of the display lies the rows below the band
 * lower. */
static gn_status draw_band(int first, const gn_lit_uniforms *uniforms)
{
    const gn_target target = {
        {gn_surface_top_down(band_color, GN_FORMAT_RGB565_SWAPPED, DISPLAY_WIDTH, BAND)},
        gn_surface_top_down(band_depth, GN_FORMAT_D16, DISPLAY_WIDTH, BAND)};
    const uint32_t stride = sizeof *corners;
    const gn_mesh mesh = {
        .attribute = {[GN_ATTRIBUTE_POSITION] = {corners->position, 3, stride, 0},
                      [GN_ATTRIBUTE_NORMAL] = {corners->normal, 3, stride, 0},
                      [GN_ATTRIBUTE_TEXCOORD] = {corners->texcoord, 2, stride, 0}},
        .vertex_count = CORNERS,
        .indices = indices,
        .index_format = GN_INDEX_UINT8,
        .count = INDICES};
    const int rows_below = DISPLAY_HEIGHT - (first + BAND);
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_pipeline pipeline = {.depth.test_enabled = true, .raster.cull = GN_CULL_BACK};
    gn_status status = gn_use_gouraud(&pipeline, uniforms);

    pipeline.raster.viewport =
        (gn_viewport){true, 0, (float)-rows_below, DISPLAY_WIDTH, DISPLAY_HEIGHT};
    if (!status)
        status = gn_clear_color(&target.color[0], 0.05f, 0.1f, 0.2f, 1);
    if (!status)
        status = gn_clear_depth(&target.depth, 1);
    return status ? status : gn_draw(&target, &pipeline, &mesh, &workspace);
}

int main(void)
{
    gn_lit_uniforms uniforms;
    gn_status status = GN_OK;
    uint32_t frame = 0;
    bool more = true;

    make_cube();
    while (more && status == GN_OK) {
        status = set_scene(frame++, &uniforms);
        display_begin();
        for (int first = 0; status == GN_OK && first < DISPLAY_HEIGHT; first += BAND) {
            status = draw_band(first, &uniforms);
            display_send(band_color, sizeof band_color);
        }
        more = display_end();
    }
    return status; /* gn_status_text says it in words */
}
