/* An indexed draw gives the picture of the same elements drawn without indices: meshes that name
 * few vertices many times, longer than what the library keeps at a time. */
#include <stdlib.h>
#include <string.h>

#include <gnomon.h>

#include "random.h"
#include "random_inputs.h"

enum {
    SIDE = 16, /* pixels */
    MAX_VERTICES = 1100,
    LEAST_ELEMENTS = 1000,
    MAX_ELEMENTS = LEAST_ELEMENTS + 7000,
    VARYINGS = 4,
    POSITION = 3, /* floats of a position */
    COLOR = 4
};

typedef struct indexed {
    gn_topology topology;
    gn_index_format format;
    uint32_t vertices, elements, instances;
    uint32_t near; /* indices near each other name as many different vertices */
    uint64_t numbers, memory;
} indexed;

typedef struct picture {
    uint32_t color[SIDE * SIDE], depth[SIDE * SIDE];
} picture;

static enum theft_alloc_res make_indexed(struct theft *t, void *env, void **output)
{
    indexed *const m = *output = allocated(sizeof *m);
    (void)env;
    m->topology = (gn_topology)theft_random_choice(t, GN_LINE_LOOP + 1);
    m->format = theft_random_bits(t, 1) ? GN_INDEX_UINT16 : GN_INDEX_UINT32;
    m->instances = 1 + (uint32_t)theft_random_choice(t, 2);
    m->elements = LEAST_ELEMENTS + (uint32_t)theft_random_choice(t, MAX_ELEMENTS - LEAST_ELEMENTS);
    m->vertices = 1 + (uint32_t)theft_random_choice(t, theft_random_bits(t, 2) ? 80 : MAX_VERTICES);
    m->near = 1 + (uint32_t)theft_random_choice(t, (m->vertices + 1) / 2);
    m->numbers = theft_random_bits(t, 32);
    m->memory = theft_random_bits(t, 20);
    return THEFT_ALLOC_OK;
}

static void print_indexed(FILE *f, const void *instance, void *env)
{
    const indexed *m = instance;
    (void)env;
    fprintf(f,
            "topology %d, index format %d, %" PRIu32 " vertices, %" PRIu32 " elements, %" PRIu32
            " instances, near %" PRIu32 ", numbers %" PRIu64 ", memory %" PRIu64 "\n",
            (int)m->topology, (int)m->format, m->vertices, m->elements, m->instances, m->near,
            m->numbers, m->memory);
}

static float position[MAX_VERTICES][POSITION], color[MAX_VERTICES][COLOR];
static float unpacked_position[MAX_ELEMENTS][POSITION], unpacked_color[MAX_ELEMENTS][COLOR];
static uint32_t wide[MAX_ELEMENTS];
static uint16_t narrow[MAX_ELEMENTS];

/* The window of indices moves over the vertices once or a few times. Some indices lie outside. */
static void make_arrays(const indexed *m)
{
    random_source r = random_seed(m->numbers);
    const uint32_t passes = random_chance(&r, 80) ? 1 : 1 + random_below(&r, 4);
    const uint32_t stray = random_chance(&r, 20) ? 1 : 0;
    for (uint32_t v = 0; v < m->vertices; ++v) {
        for (int c = 0; c < POSITION; ++c)
            position[v][c] = random_float(&r, -1.2f, 1.2f);
        for (int c = 0; c < COLOR; ++c)
            color[v][c] = random_unit(&r);
    }
    for (uint32_t i = 0; i < m->elements; ++i) {
        const uint32_t first = i * passes % m->elements * (m->vertices - m->near) / m->elements;
        wide[i] = random_chance(&r, stray) ? random_below(&r, m->vertices)
                                           : first + random_below(&r, m->near);
        narrow[i] = (uint16_t)wide[i];
        memcpy(unpacked_position[i], position[wide[i]], sizeof position[0]);
        memcpy(unpacked_color[i], color[wide[i]], sizeof color[0]);
    }
}

static bool draw_mesh(const indexed *m, bool with_indices, gn_backend backend, size_t size,
                      picture *p)
{
    gn_color_uniforms uniforms;
    gn_target target = {{gn_surface_bottom_up(p->color, GN_FORMAT_RGBA8, SIDE, SIDE)},
                        gn_surface_bottom_up(p->depth, GN_FORMAT_D24, SIDE, SIDE)};
    gn_pipeline pipeline = {.depth.test_enabled = true, .raster.topology = m->topology};
    gn_mesh mesh = {.vertex_count = with_indices ? m->vertices : m->elements,
                    .count = m->elements,
                    .instance_count = m->instances};
    gn_workspace workspace = {.memory = malloc(size), .size = size, .backend = backend};
    if (with_indices) {
        mesh.index_format = m->format;
        mesh.indices = m->format == GN_INDEX_UINT16 ? (const void *)narrow : wide;
    }
    mesh.attribute[GN_ATTRIBUTE_POSITION] = (gn_attribute){
        .data = with_indices ? position[0] : unpacked_position[0], .components = POSITION};
    mesh.attribute[GN_ATTRIBUTE_COLOR] =
        (gn_attribute){.data = with_indices ? color[0] : unpacked_color[0], .components = COLOR};
    memset(&uniforms, 0, sizeof uniforms);
    gn_mat4_identity(&uniforms.clip_from_model);
    const bool drawn = workspace.memory && gn_use_vertex_color(&pipeline, &uniforms) == GN_OK &&
                       gn_clear_color(&target.color[0], 0, 0, 0, 0) == GN_OK &&
                       gn_clear_depth(&target.depth, 1) == GN_OK &&
                       gn_draw(&target, &pipeline, &mesh, &workspace) == GN_OK;
    free(workspace.memory);
    return drawn;
}

/* The library keeps as many vertices as the memory holds, up to those that it needs. */
static size_t some_memory(const indexed *m)
{
    const uint32_t vertices = (uint32_t)(m->memory % (2 * m->near + 2 * GN_LANES));

    return gn_workspace_size(vertices, VARYINGS) + (size_t)(m->memory % 64);
}

static gn_backend some_backend(const indexed *m)
{
    const int chosen = (int)(m->numbers % GN_BACKEND_COUNT);

    return gn_backend_available((gn_backend)chosen) ? (gn_backend)chosen : GN_BACKEND_PORTABLE;
}

static enum theft_trial_res same_without_indices(struct theft *t, void *argument)
{
    static picture with, without;
    const indexed *m = argument;
    const size_t full = gn_workspace_size(MAX_VERTICES, VARYINGS);
    const size_t sizes[] = {gn_workspace_size(0, VARYINGS), some_memory(m), full};
    (void)t;
    make_arrays(m);
    if (!draw_mesh(m, false, GN_BACKEND_PORTABLE, full, &without))
        return THEFT_TRIAL_FAIL;
    for (size_t n = 0; n < sizeof sizes / sizeof *sizes; ++n)
        if (!draw_mesh(m, true, some_backend(m), sizes[n], &with) ||
            memcmp(&with, &without, sizeof with) != 0)
            return THEFT_TRIAL_FAIL;
    return THEFT_TRIAL_PASS;
}

static const property indices[] = {
    DRAWING("indices draw what their vertices draw without indices", same_without_indices,
            INSTANCES(make_indexed, print_indexed, NULL), 10),
};

SUITE(properties_indices, indices);
