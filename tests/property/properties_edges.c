/* Shared edges are drawn once and only once: the triangles of a triangulated rectangle, each drawn
 * alone, cover every pixel of the rectangle exactly once and no other pixel. */
#include <string.h>

#include <gnomon.h>

#include "random.h"
#include "random_inputs.h"

#define MAX_CELLS 6
#define MAX_VERTICES ((MAX_CELLS + 1) * (MAX_CELLS + 1))
#define MAX_TRIANGLES (2 * MAX_CELLS * MAX_CELLS)
#define MAX_SIDE 64

/* A triangulation in units of 1/256 pixel, so that snapping changes nothing. */
typedef struct mesh {
    uint32_t width, height; /* of the target; powers of two, so that placement is exact */
    int32_t x0, y0, x1, y1; /* the outline */
    uint32_t vertex_count, triangle_count;
    int32_t position[MAX_VERTICES][2];
    float w[MAX_VERTICES];
    bool is_ready_made; /* the shader */
    uint32_t triangle[MAX_TRIANGLES][3];
} mesh;

static int64_t doubled_area(const mesh *m, const uint32_t *t)
{
    const int32_t *a = m->position[t[0]], *b = m->position[t[1]], *c = m->position[t[2]];
    return (int64_t)(b[0] - a[0]) * (c[1] - a[1]) - (int64_t)(c[0] - a[0]) * (b[1] - a[1]);
}

/* Whether every triangle has the proper winding, so that the triangles tile the outline. */
static bool tiles(const mesh *m)
{
    for (uint32_t i = 0; i < m->triangle_count; ++i)
        if (doubled_area(m, m->triangle[i]) < 0)
            return false;
    return true;
}

static void add_triangle(mesh *m, uint32_t a, uint32_t b, uint32_t c, uint32_t turn)
{
    const uint32_t corner[3] = {a, b, c};
    for (uint32_t k = 0; k < 3; ++k)
        m->triangle[m->triangle_count][k] = corner[(k + turn) % 3];
    ++m->triangle_count;
}

static void make_grid(mesh *m, random_source *r, int32_t columns, int32_t rows, int32_t grain,
                      bool jitter)
{
    m->vertex_count = m->triangle_count = 0;
    for (int32_t j = 0; j <= rows; ++j)
        for (int32_t i = 0; i <= columns; ++i) {
            int32_t *p = m->position[m->vertex_count++];
            const int32_t step_x = (m->x1 - m->x0) / columns, step_y = (m->y1 - m->y0) / rows;
            p[0] = i == columns ? m->x1 : m->x0 + step_x * i;
            p[1] = j == rows ? m->y1 : m->y0 + step_y * j;
            if (jitter && i > 0 && i < columns)
                p[0] += random_between(r, -step_x / 2, step_x / 2);
            if (jitter && j > 0 && j < rows)
                p[1] += random_between(r, -step_y / 2, step_y / 2);
            if (i > 0 && i < columns)
                p[0] -= p[0] % grain;
            if (j > 0 && j < rows)
                p[1] -= p[1] % grain;
        }
    for (uint32_t j = 0; j < (uint32_t)rows; ++j)
        for (uint32_t i = 0; i < (uint32_t)columns; ++i) {
            const uint32_t low = j * ((uint32_t)columns + 1) + i;
            const uint32_t high = low + (uint32_t)columns + 1, turn = random_below(r, 3);
            if (random_chance(r, 50)) {
                add_triangle(m, low, low + 1, high + 1, turn);
                add_triangle(m, low, high + 1, high, turn);
            } else {
                add_triangle(m, low, low + 1, high, turn);
                add_triangle(m, low + 1, high + 1, high, turn);
            }
        }
}

/* Triangles around one point of the rectangle. */
static void make_hub(mesh *m, random_source *r, uint32_t per_side)
{
    m->vertex_count = m->triangle_count = 0;
    m->position[0][0] = random_between(r, m->x0, m->x1);
    m->position[0][1] = random_between(r, m->y0, m->y1);
    m->vertex_count = 1;
    for (uint32_t side = 0; side < 4; ++side)
        for (uint32_t i = 0; i < per_side; ++i) {
            const int32_t along_x = (int32_t)((uint32_t)(m->x1 - m->x0) * i / per_side);
            const int32_t along_y = (int32_t)((uint32_t)(m->y1 - m->y0) * i / per_side);
            int32_t *p = m->position[m->vertex_count++];
            p[0] = side == 0   ? m->x0 + along_x
                   : side == 1 ? m->x1
                   : side == 2 ? m->x1 - along_x
                               : m->x0;
            p[1] = side == 0   ? m->y0
                   : side == 1 ? m->y0 + along_y
                   : side == 2 ? m->y1
                               : m->y1 - along_y;
        }
    for (uint32_t i = 0; i < 4 * per_side; ++i)
        add_triangle(m, 0, 1 + i, 1 + (i + 1) % (4 * per_side), random_below(r, 3));
}

static enum theft_alloc_res make_mesh(struct theft *t, void *env, void **output)
{
    static const int32_t grains[] = {256, 128, 64, 1};
    mesh *const m = *output = allocated(sizeof *m);
    (void)env;
    const bool hub = theft_random_bits(t, 1) != 0;
    const int32_t columns = 1 + (int32_t)theft_random_choice(t, MAX_CELLS);
    const int32_t rows = 1 + (int32_t)theft_random_choice(t, MAX_CELLS);
    const int32_t grain = grains[theft_random_bits(t, 2)];
    const uint64_t shape = theft_random_bits(t, 3);
    random_source r = random_seed(theft_random_bits(t, 24));

    m->width = 8u << random_below(&r, 4);
    m->height = 8u << random_below(&r, 4);
    /* The outline, sometimes partly outside the viewport, with at least a pixel per cell. */
    const int32_t reach = shape & 1 ? 8 : 0;
    const int32_t low_x = random_between(&r, -reach, (int32_t)m->width - MAX_CELLS - 1);
    const int32_t low_y = random_between(&r, -reach, (int32_t)m->height - MAX_CELLS - 1);
    m->x0 = 256 * low_x + random_between(&r, 0, 255) / grain * grain;
    m->y0 = 256 * low_y + random_between(&r, 0, 255) / grain * grain;
    m->x1 = 256 * random_between(&r, low_x + MAX_CELLS + 1, (int32_t)m->width + reach);
    m->x1 += shape & 1 ? random_between(&r, 0, 255) / grain * grain : 0;
    m->y1 = 256 * random_between(&r, low_y + MAX_CELLS + 1, (int32_t)m->height + reach);
    m->y1 += shape & 1 ? random_between(&r, 0, 255) / grain * grain : 0;
    if (hub) {
        make_hub(m, &r, (uint32_t)columns);
    } else {
        make_grid(m, &r, columns, rows, grain, true);
        if (!tiles(m))
            make_grid(m, &r, columns, rows, 1, false);
    }
    m->is_ready_made = shape & 4;
    for (uint32_t i = 0; i < m->vertex_count; ++i)
        m->w[i] = shape & 2 ? random_power(&r, -2, 2) : 1.0f;
    return THEFT_ALLOC_OK;
}

static void print_mesh(FILE *f, const void *instance, void *env)
{
    const mesh *m = instance;
    (void)env;
    fprintf(f,
            "target %" PRIu32 "x%" PRIu32 ", outline (%" PRId32 ", %" PRId32 ") to (%" PRId32
            ", %" PRId32 "), all in 1/256 pixel\n",
            m->width, m->height, m->x0, m->y0, m->x1, m->y1);
    for (uint32_t i = 0; i < m->triangle_count; ++i) {
        for (int k = 0; k < 3; ++k) {
            const uint32_t v = m->triangle[i][k];
            fprintf(f, "  (%" PRId32 ", %" PRId32 ", w %g)", m->position[v][0], m->position[v][1],
                    (double)m->w[v]);
        }
        fprintf(f, "\n");
    }
}

static void pass_position(const void *uniforms, const gn_vertex_input *input,
                          gn_vertex_output *output)
{
    (void)uniforms;
    memcpy(output->position, input->attribute[0], 4 * sizeof *output->position);
}

static void paint_white(const void *uniforms, const gn_fragment_input *input,
                        gn_fragment_output *output)
{
    (void)uniforms;
    (void)input;
    for (int i = 0; i < 4 * GN_LANES; ++i)
        output->color[i / GN_LANES][i % GN_LANES] = 1.0f;
}

static enum theft_trial_res shared_edges_once(struct theft *t, void *instance)
{
    static uint32_t pixels[MAX_SIDE * MAX_SIDE];
    static uint8_t covered[MAX_SIDE * MAX_SIDE];
    static unsigned char memory[GN_WORKSPACE_SIZE(16, GN_SHADER_VARYINGS)];
    const mesh *m = instance;
    (void)t;
    float position[MAX_VERTICES][4];
    const float half_width = (float)m->width * 0.5f, half_height = (float)m->height * 0.5f;
    for (uint32_t i = 0; i < m->vertex_count; ++i) {
        position[i][0] = ((float)m->position[i][0] / 256.0f - half_width) / half_width * m->w[i];
        position[i][1] = ((float)m->position[i][1] / 256.0f - half_height) / half_height * m->w[i];
        position[i][2] = 0.0f;
        position[i][3] = m->w[i];
    }
    gn_target target = {{gn_surface_bottom_up(pixels, GN_FORMAT_RGBA8, m->width, m->height)}, {0}};
    gn_pipeline pipeline = {.program.vertex_shader = pass_position,
                            .program.fragment_shader = paint_white};
    gn_color_uniforms uniforms;
    gn_mat4_identity(&uniforms.clip_from_model);
    if (m->is_ready_made)
        gn_use_vertex_color(&pipeline, &uniforms); /* without colours: opaque black */
    gn_mesh one = {.attribute[GN_ATTRIBUTE_POSITION] = {&position[0][0], 4, 0, 0},
                   .vertex_count = m->vertex_count,
                   .index_format = GN_INDEX_UINT32,
                   .count = 3};
    gn_workspace workspace = {.memory = memory,
                              .size = GN_WORKSPACE_SIZE(16, pipeline.program.varying_count)};
    memset(covered, 0, sizeof covered);
    for (uint32_t i = 0; i < m->triangle_count; ++i) {
        memset(pixels, 0, sizeof pixels);
        one.indices = m->triangle[i];
        if (gn_draw(&target, &pipeline, &one, &workspace) != GN_OK)
            return THEFT_TRIAL_FAIL;
        for (uint32_t p = 0; p < m->width * m->height; ++p)
            covered[p] = (uint8_t)(covered[p] + (pixels[p] != 0));
    }
    for (uint32_t y = 0; y < m->height; ++y)
        for (uint32_t x = 0; x < m->width; ++x) {
            /* Left sides and bottom sides own the centres that lie on them. */
            const int32_t cx = (int32_t)(256 * x + 128), cy = (int32_t)(256 * y + 128);
            const bool inside = cx >= m->x0 && cx < m->x1 && cy >= m->y0 && cy < m->y1;
            if (covered[y * m->width + x] != inside)
                return THEFT_TRIAL_FAIL;
        }
    return THEFT_TRIAL_PASS;
}

static const property edges[] = {
    DRAWING("shared edges are drawn once and only once", shared_edges_once,
            INSTANCES(make_mesh, print_mesh, NULL), 10),
};

SUITE(properties_edges, edges);
