/* The elements of a draw: instances, divisors, base vertex, primitive restart. */
#define _DEFAULT_SOURCE
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <string.h>
#include <sys/mman.h>

#include <gnomon.h>

/* A column of pixels per vertex: vertex n is the lower left corner of a triangle over pixel n of a
 * row. Its attribute 1, from 0 to 255, is the pixel's value. */
#define PIXELS 16
#define VERTICES (3 * PIXELS)

static uint8_t row[PIXELS];
static float position[VERTICES][2];
static float value[VERTICES];
static uint32_t largest_instance;

static void place(const void *uniforms, const gn_vertex_input *input, gn_vertex_output *output)
{
    const bool by_instance = uniforms != NULL;

    if (input->instance > largest_instance)
        largest_instance = input->instance;
    for (int l = 0; l < GN_LANES; ++l) {
        for (int c = 0; c < 4; ++c)
            output->position[c][l] = input->attribute[0][c][l];
        output->varying[0][l] =
            by_instance ? (float)input->instance / 255.0f : input->attribute[1][0][l] / 255.0f;
    }
}

static void shade(const void *uniforms, const gn_fragment_input *input, gn_fragment_output *output)
{
    (void)uniforms;
    for (int c = 0; c < 4; ++c)
        for (int l = 0; l < GN_LANES; ++l)
            output->color[c][l] = input->varying[0][l];
}

static gn_pipeline pipeline;
static gn_mesh mesh;

static void reset(void)
{
    static const float corner[3][2] = {{-0.5f, -4.0f}, {0.5f, -4.0f}, {0.0f, 8.0f}};

    memset(&pipeline, 0, sizeof pipeline);
    memset(&mesh, 0, sizeof mesh);
    memset(row, 0, sizeof row);
    largest_instance = 0;
    pipeline.program.vertex_shader = place;
    pipeline.program.fragment_shader = shade;
    pipeline.program.varying_count = 1;
    pipeline.program.interpolation[0] = GN_FLAT;
    for (int v = 0; v < VERTICES; ++v) {
        position[v][0] = ((float)(v / 3) + 0.5f + corner[v % 3][0]) / (PIXELS / 2) - 1.0f;
        position[v][1] = corner[v % 3][1];
        value[v] = (float)(v + 1);
    }
    mesh.attribute[0].data = &position[0][0];
    mesh.attribute[0].components = 2;
    mesh.attribute[1].data = value;
    mesh.attribute[1].components = 1;
    mesh.vertex_count = VERTICES;
}

static gn_status draw(void)
{
    static unsigned char work[GN_WORKSPACE_SIZE(VERTICES, 1)];
    gn_target target = {0};
    gn_workspace workspace = {0};

    target.color[0] = gn_surface_bottom_up(row, GN_FORMAT_R8, PIXELS, 1);
    workspace.memory = work;
    workspace.size = sizeof work;
    return gn_draw(&target, &pipeline, &mesh, &workspace);
}

static void instances_follow_each_other(void **state)
{
    (void)state;
    reset();
    mesh.count = 3;
    pipeline.program.uniforms = &mesh;
    mesh.instance_count = 5;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(row[0], 4);
    assert_int_equal(largest_instance, 4);
    mesh.instance_count = 0;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(row[0], 0);
}

static void a_divisor_takes_elements_by_instance(void **state)
{
    (void)state;
    static const float wide[5] = {10, -1, 20, -1, 30};

    reset();
    mesh.count = 6;
    mesh.attribute[1].data = wide;
    mesh.attribute[1].stride = 8;
    mesh.attribute[1].divisor = 2;
    for (uint32_t instances = 1; instances <= 6; ++instances) {
        mesh.instance_count = instances;
        assert_int_equal(draw(), GN_OK);
        assert_int_equal(row[0], 10 * ((instances + 1) / 2));
        assert_int_equal(row[1], 10 * ((instances + 1) / 2));
    }
}

static void a_base_vertex_is_added_to_indices(void **state)
{
    (void)state;
    static const uint8_t indices[] = {250, 251, 252, 3, 4, 5};

    reset();
    mesh.indices = indices;
    mesh.index_format = GN_INDEX_UINT8;
    mesh.count = 3;
    mesh.base_vertex = -244;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(row[2], 9);
    assert_int_equal(row[1], 0);
    mesh.first = 3;
    mesh.base_vertex = 6;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(row[3], 12);
    mesh.base_vertex = VERTICES - 6;
    assert_int_equal(gn_mesh_check(&mesh), GN_OK);
    mesh.base_vertex = VERTICES - 5;
    assert_int_equal(gn_mesh_check(&mesh), GN_INDEX_OUT_OF_RANGE);
    assert_int_equal(draw(), GN_INDEX_OUT_OF_RANGE);
    mesh.base_vertex = -4;
    assert_int_equal(gn_mesh_check(&mesh), GN_INDEX_OUT_OF_RANGE);
    assert_int_equal(draw(), GN_INDEX_OUT_OF_RANGE);

    /* Without indices a restart has no effect. */
    mesh.index_format = GN_INDEX_NONE;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(row[1], 6);
}

static void a_restart_begins_anew(void **state)
{
    (void)state;
    static const uint16_t indices[] = {65535, 0, 1, 65535, 65535, 6, 7, 8, 9, 65535, 12, 13, 14};

    reset();
    mesh.indices = indices;
    mesh.index_format = GN_INDEX_UINT16;
    mesh.count = 13;
    assert_int_equal(draw(), GN_INDEX_OUT_OF_RANGE);
    mesh.restart = GN_RESTART_FIXED_INDEX;
    assert_int_equal(draw(), GN_OK);
    for (int i = 0; i < PIXELS; ++i)
        assert_int_equal(row[i], i == 2 || i == 4 ? 3 * i + 3 : 0);

    /* Another restart index, so that 65535 is out of range. The index is compared before the base
     * vertex is added. */
    mesh.restart = GN_RESTART_INDEX;
    mesh.restart_index = 65535;
    mesh.base_vertex = 3;
    assert_int_equal(gn_mesh_check(&mesh), GN_OK);
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(row[3], 12);
    assert_int_equal(row[5], 18);
    mesh.restart_index = 0;
    memset(row, 0, sizeof row);
    assert_int_equal(gn_mesh_check(&mesh), GN_INDEX_OUT_OF_RANGE);
    assert_int_equal(draw(), GN_INDEX_OUT_OF_RANGE);
    for (int i = 0; i < PIXELS; ++i)
        assert_int_equal(row[i], 0);
    mesh.restart = (gn_restart)3;
    assert_int_equal(gn_mesh_check(&mesh), GN_INVALID_ENUM);
    assert_int_equal(draw(), GN_INVALID_ENUM);
}

/* Elements from 2^32 on: first and count have 32 bits, and their sum may have more. */
static void elements_beyond_32_bits(void **state)
{
    (void)state;
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
    reset();
    mesh.indices = indices;
    mesh.index_format = GN_INDEX_UINT8;
    mesh.restart = GN_RESTART_FIXED_INDEX;
    mesh.first = first;
    mesh.count = 16 + sizeof triangles;
    assert_int_equal(draw(), GN_OK);
    for (int i = 0; i < PIXELS; ++i)
        assert_int_equal(row[i], i == 0 || i == 2 ? 3 * i + 3 : 0);
    munmap(indices, size);
}

static void restarts_alone_draw_nothing(void **state)
{
    (void)state;
    static const uint8_t indices[] = {255, 255, 255};

    reset();
    mesh.indices = indices;
    mesh.index_format = GN_INDEX_UINT8;
    mesh.restart = GN_RESTART_FIXED_INDEX;
    for (mesh.count = 0; mesh.count <= 3; ++mesh.count) {
        assert_int_equal(draw(), GN_OK);
        for (int i = 0; i < PIXELS; ++i)
            assert_int_equal(row[i], 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(instances_follow_each_other),
        cmocka_unit_test(a_divisor_takes_elements_by_instance),
        cmocka_unit_test(a_base_vertex_is_added_to_indices),
        cmocka_unit_test(a_restart_begins_anew),
        cmocka_unit_test(elements_beyond_32_bits),
        cmocka_unit_test(restarts_alone_draw_nothing),
    };

    return cmocka_run_group_tests_name("elements", tests, NULL, NULL);
}
