/* gn_draw: its statuses, after which nothing has changed; what a workspace must hold and keeps; and
 * the elements of a mesh: base vertices and restarts at the ends of what is valid. What is drawn is
 * compared with the reference (tests/parity). */
#define _DEFAULT_SOURCE
#include <sys/mman.h>

#include "canvas.h"

static void faults_touch_nothing(void **state)
{
    static canvas before;

    reset(square, 4, GN_TRIANGLE_STRIP);
    before = c;

#define EXPECT(status)                                                                             \
    do {                                                                                           \
        assert_int_equal(draw(), status);                                                          \
        assert_memory_equal(c.color, before.color, sizeof c.color);                                \
        assert_memory_equal(c.depth, before.depth, sizeof c.depth);                                \
        c = before;                                                                                \
    } while (0)

    c.target.color[0].width = 0;
    EXPECT(GN_INVALID_SIZE);
    c.pipeline.program.vertex_shader = NULL;
    EXPECT(GN_NO_SHADER);
    c.pipeline.program.fragment_shader = NULL;
    EXPECT(GN_NO_SHADER);
    c.mesh.count = 5;
    EXPECT(GN_INDEX_OUT_OF_RANGE);
    c.workspace.memory = NULL;
    EXPECT(GN_NULL_POINTER);
    c.workspace.size = gn_workspace_size(0, c.pipeline.program.varying_count) - 1;
    EXPECT(GN_WORKSPACE_TOO_SMALL);
    c.workspace.backend = GN_BACKEND_COUNT;
    EXPECT(GN_BACKEND_UNAVAILABLE);
#if defined(__x86_64__) || defined(__arm__)
    c.workspace.backend = GN_BACKEND_WASM_SIMD128;
    EXPECT(GN_BACKEND_UNAVAILABLE);
#endif
#undef EXPECT
    assert_int_equal(gn_draw(NULL, &c.pipeline, &c.mesh, &c.workspace), GN_NULL_POINTER);
    assert_int_equal(gn_draw(&c.target, NULL, &c.mesh, &c.workspace), GN_NULL_POINTER);
    assert_int_equal(gn_draw(&c.target, &c.pipeline, NULL, &c.workspace), GN_NULL_POINTER);
    assert_int_equal(gn_draw(&c.target, &c.pipeline, &c.mesh, NULL), GN_NULL_POINTER);
}

/* A value that is no back end shows that the workspace is read and the processor is not asked. */
static void a_workspace_keeps_the_choice(void **state)
{
    reset(square, 4, GN_TRIANGLE_STRIP);
    assert_int_equal(drawn(), SIZE * SIZE);
    assert_int_equal(c.workspace.backend, GN_BACKEND_AUTO);
    assert_int_equal(c.workspace.chosen_backend, gn_backend_best());
    c.workspace.chosen_backend = GN_BACKEND_PORTABLE;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(c.workspace.chosen_backend, GN_BACKEND_PORTABLE);
    c.workspace.chosen_backend = GN_BACKEND_COUNT;
    assert_int_equal(draw(), GN_BACKEND_UNAVAILABLE);
    c.workspace.backend = GN_BACKEND_PORTABLE;
    assert_int_equal(draw(), GN_OK);
}

/* Clip distances take room as varyings do. */
static void a_workspace_may_be_too_small(void **state)
{
    reset(square, 4, GN_TRIANGLE_STRIP);
    c.pipeline.program.clip_distance_count = GN_MAX_CLIP_DISTANCES;
    c.workspace.size =
        gn_workspace_size(0, c.pipeline.program.varying_count + GN_MAX_CLIP_DISTANCES);
    assert_int_equal(drawn(), SIZE * SIZE);
    c.workspace.size -= 1;
    assert_int_equal(draw(), GN_WORKSPACE_TOO_SMALL);
    assert_int_equal(c.workspace.size_needed, c.workspace.size + 1);
}

/* White, with a clip distance of -3 right of the view volume and 1 elsewhere. */
static void shade_far_distances(const void *uniforms, const gn_vertex_input *input,
                                gn_vertex_output *output)
{
    for (int l = 0; l < GN_LANES; ++l) {
        for (int i = 0; i < 4; ++i) {
            output->position[i][l] = input->attribute[GN_ATTRIBUTE_POSITION][i][l];
            output->varying[i][l] = 1.0f;
        }
        output->clip_distance[0][l] = output->position[0][l] > 1.0f ? -3.0f : 1.0f;
    }
}

/* A vertex lies at x = 3. Linear distances leave what is left of x = 0. A plane of which all is in
 * front leaves what is in the view volume. */
static void distances_of_new_vertices_are_those_of_planes(void **state)
{
    static const float far_right[] = {-1, -4, 0, 1, 3, 0, 0, 1, -1, 4, 0, 1};
    static const float in_front[1][4] = {{0, 0, 0, 1}};

    reset(far_right, 3, GN_TRIANGLES);
    c.pipeline.program.vertex_shader = shade_far_distances;
    c.pipeline.program.clip_distance_count = 1;
    assert_int_equal(drawn(), SIZE * SIZE / 2);
    c.pipeline.program.clip_plane = in_front;
    assert_int_equal(drawn(), SIZE * SIZE);
}

/* Vertex n is the lower left corner of a triangle over pixel n of a row. Its colour is n + 1. */
enum { PIXELS = 16, VERTICES = 3 * PIXELS };

static uint8_t row[PIXELS];
static float corners[VERTICES][4], values[VERTICES];

static void reset_row(const void *indices, gn_index_format format, uint32_t count)
{
    static const float corner[3][2] = {{-0.5f, -4.0f}, {0.5f, -4.0f}, {0.0f, 8.0f}};

    for (int v = 0; v < VERTICES; ++v) {
        corners[v][0] = ((float)(v / 3) + 0.5f + corner[v % 3][0]) / (PIXELS / 2) - 1.0f;
        corners[v][1] = corner[v % 3][1];
        corners[v][3] = 1.0f;
        values[v] = (float)(v + 1) / 255.0f;
    }
    memset(row, 0, sizeof row);
    reset(corners[0], VERTICES, GN_TRIANGLES);
    c.target.color[0] = gn_surface_bottom_up(row, GN_FORMAT_R8, PIXELS, 1);
    c.target.depth.format = GN_FORMAT_NONE;
    c.pipeline.program.interpolation[0] = GN_FLAT;
    c.mesh.attribute[GN_ATTRIBUTE_COLOR] = floats(values, 1);
    c.mesh.indices = indices;
    c.mesh.index_format = format;
    c.mesh.count = count;
}

static void expect_status(gn_status status)
{
    assert_int_equal(gn_mesh_check(&c.mesh), status);
    assert_int_equal(draw(), status);
}

/* Two instances share an element. No instances are one. */
static void a_divisor_takes_elements_by_instance(void **state)
{
    static const float values_apart[5] = {10 / 255.0f, -1, 20 / 255.0f, -1, 30 / 255.0f};

    reset_row(NULL, GN_INDEX_NONE, 6);
    c.mesh.attribute[GN_ATTRIBUTE_COLOR] = (gn_attribute){values_apart, 1, 8, 2};
    for (uint32_t n = 0; n <= 6; ++n) {
        c.mesh.instance_count = n;
        expect_status(GN_OK);
        assert_int_equal(row[0], n ? 10 * ((n + 1) / 2) : 10);
        assert_int_equal(row[1], row[0]);
    }
}

static void a_base_vertex_is_added_to_indices(void **state)
{
    static const uint8_t indices[] = {250, 251, 252, 3, 4, 5};

    reset_row(indices, GN_INDEX_UINT8, 3);
    c.mesh.base_vertex = -244;
    expect_status(GN_OK);
    assert_true(row[2] == 9 && row[1] == 0);
    c.mesh.first = 3;
    c.mesh.base_vertex = 6;
    expect_status(GN_OK);
    assert_int_equal(row[3], 12);
    c.mesh.base_vertex = VERTICES - 6;
    expect_status(GN_OK);
    c.mesh.base_vertex = VERTICES - 5;
    expect_status(GN_INDEX_OUT_OF_RANGE);
    c.mesh.base_vertex = -4;
    expect_status(GN_INDEX_OUT_OF_RANGE);
    c.mesh.index_format = GN_INDEX_NONE; /* nothing to add it to */
    expect_status(GN_OK);
    assert_int_equal(row[1], 6);
}

static void a_restart_begins_anew(void **state)
{
    static const uint16_t indices[] = {65535, 0, 1, 65535, 65535, 6, 7, 8, 9, 65535, 12, 13, 14};

    reset_row(indices, GN_INDEX_UINT16, 13);
    expect_status(GN_INDEX_OUT_OF_RANGE);
    c.mesh.restart = GN_RESTART_FIXED_INDEX;
    expect_status(GN_OK);
    for (int i = 0; i < PIXELS; ++i)
        assert_int_equal(row[i], i == 2 || i == 4 ? 3 * i + 3 : 0);

    /* The index is compared before the base vertex is added. */
    c.mesh.restart = GN_RESTART_INDEX;
    c.mesh.restart_index = 65535;
    c.mesh.base_vertex = 3;
    expect_status(GN_OK);
    assert_true(row[3] == 12 && row[5] == 18);
    c.mesh.restart_index = 0; /* so that 65535 is out of range */
    expect_status(GN_INDEX_OUT_OF_RANGE);
    c.mesh.restart = (gn_restart)3;
    expect_status(GN_INVALID_ENUM);
}

/* Elements from 2^32 on: first and count have 32 bits, and their sum may have more. */
static void elements_beyond_32_bits(void **state)
{
    const size_t size = ((size_t)UINT32_MAX >> 16 << 16) + 0x20000;
    const uint32_t first = UINT32_MAX - 15;
    static const uint8_t triangles[] = {255, 0, 1, 2, 255, 6, 7, 8};

    if (sizeof(size_t) == 4)
        skip();
    uint8_t *const indices = mmap(NULL, size, PROT_READ | PROT_WRITE,
                                  MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    assert_true(indices != MAP_FAILED);
    memset(indices + first, 255, 16);
    memcpy(indices + first + 16, triangles, sizeof triangles);
    reset_row(indices, GN_INDEX_UINT8, 16 + sizeof triangles);
    c.mesh.restart = GN_RESTART_FIXED_INDEX;
    c.mesh.first = first;
    assert_int_equal(draw(), GN_OK);
    for (int i = 0; i < PIXELS; ++i)
        assert_int_equal(row[i], i == 0 || i == 2 ? 3 * i + 3 : 0);
    munmap(indices, size);
}

static void restarts_alone_draw_nothing(void **state)
{
    static const uint8_t indices[] = {255, 255, 255};

    reset_row(indices, GN_INDEX_UINT8, 0);
    c.mesh.restart = GN_RESTART_FIXED_INDEX;
    for (; c.mesh.count <= 3; ++c.mesh.count) {
        expect_status(GN_OK);
        for (int i = 0; i < PIXELS; ++i)
            assert_int_equal(row[i], 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faults_touch_nothing),
        cmocka_unit_test(a_workspace_keeps_the_choice),
        cmocka_unit_test(a_workspace_may_be_too_small),
        cmocka_unit_test(distances_of_new_vertices_are_those_of_planes),
        cmocka_unit_test(a_divisor_takes_elements_by_instance),
        cmocka_unit_test(a_base_vertex_is_added_to_indices),
        cmocka_unit_test(a_restart_begins_anew),
        cmocka_unit_test(elements_beyond_32_bits),
        cmocka_unit_test(restarts_alone_draw_nothing),
    };
    return cmocka_run_group_tests_name("draw", tests, NULL, NULL);
}
