/* gn_draw: its statuses, after which nothing has changed, and small pictures worked by hand. */
#include <stdlib.h>

#include "canvas.h"

static void faults_touch_nothing(void **state)
{
    (void)state;
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
#undef EXPECT
    assert_int_equal(gn_draw(NULL, &c.pipeline, &c.mesh, &c.workspace), GN_NULL_POINTER);
    assert_int_equal(gn_draw(&c.target, NULL, &c.mesh, &c.workspace), GN_NULL_POINTER);
    assert_int_equal(gn_draw(&c.target, &c.pipeline, NULL, &c.workspace), GN_NULL_POINTER);
    assert_int_equal(gn_draw(&c.target, &c.pipeline, &c.mesh, NULL), GN_NULL_POINTER);
}

static void a_square_covers_everything(void **state)
{
    (void)state;
    reset(square, 4, GN_TRIANGLE_STRIP);
    assert_int_equal(draw(), GN_OK);
    for (int i = 0; i < SIZE * SIZE; ++i)
        assert_int_equal(c.color[i], 0xFFFFFFFFu);

    /* The last, incomplete triangle draws nothing; fewer than three vertices draw nothing. */
    reset(square, 4, GN_TRIANGLES);
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(covered(), SIZE * (SIZE - 1) / 2);
    c.mesh.count = 2;
    c.pipeline.raster.topology = GN_TRIANGLE_FAN;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(covered(), SIZE * (SIZE - 1) / 2);
}

/* Pixel centres are on the diagonal. They belong to the triangle whose left edge is the diagonal:
 * window (0,0) (8,0) (0,8) has it as its right edge, the other half as its left edge. */
static void ties_belong_to_left_and_bottom_edges(void **state)
{
    (void)state;
    static const float lower[12] = {-1, -1, 0, 1, 1, -1, 0, 1, -1, 1, 0, 1};
    static const float upper[12] = {1, -1, 0, 1, 1, 1, 0, 1, -1, 1, 0, 1};

    reset(upper, 3, GN_TRIANGLES);
    assert_int_equal(draw(), GN_OK);
    const int upper_count = covered();
    reset(lower, 3, GN_TRIANGLES);
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(upper_count + covered(), SIZE * SIZE);
    assert_int_equal(c.color[0 * SIZE + 7], 0);

    /* Pixel centres 1.5 to 4.5: those at 1.5 are covered, those at 4.5 are not. */
    static const float inner[16] = {-0.625f, -0.625f, 0, 1, 0.125f, -0.625f, 0, 1,
                                    -0.625f, 0.125f,  0, 1, 0.125f, 0.125f,  0, 1};
    reset(inner, 4, GN_TRIANGLE_STRIP);
    assert_int_equal(draw(), GN_OK);
    for (int y = 0; y < SIZE; ++y) {
        for (int x = 0; x < SIZE; ++x) {
            const int inside = x >= 1 && x < 4 && y >= 1 && y < 4;
            assert_int_equal(c.color[y * SIZE + x], inside ? 0xFFFFFFFFu : 0);
        }
    }
}

static void winding_and_culling(void **state)
{
    (void)state;
    const struct {
        gn_cull cull;
        gn_front_face front;
        bool drawn;
    } cases[] = {
        {GN_CULL_NONE, GN_FRONT_COUNTER_CLOCKWISE, true},
        {GN_CULL_BACK, GN_FRONT_COUNTER_CLOCKWISE, true},
        {GN_CULL_FRONT, GN_FRONT_COUNTER_CLOCKWISE, false},
        {GN_CULL_BACK, GN_FRONT_CLOCKWISE, false},
        {GN_CULL_FRONT, GN_FRONT_CLOCKWISE, true},
        {GN_CULL_FRONT_AND_BACK, GN_FRONT_CLOCKWISE, false},
    };

    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        reset(square, 4, GN_TRIANGLE_STRIP); /* counter-clockwise */
        c.pipeline.raster.cull = cases[i].cull;
        c.pipeline.raster.front_face = cases[i].front;
        assert_int_equal(draw(), GN_OK);
        assert_int_equal(covered(), cases[i].drawn ? SIZE * SIZE : 0);
    }
}

static void flat_takes_the_provoking_vertex(void **state)
{
    (void)state;
    static const float colors[16] = {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 0, 1};

    for (int first = 0; first < 2; ++first) {
        reset(square, 4, GN_TRIANGLE_STRIP);
        c.mesh.attribute[GN_ATTRIBUTE_COLOR].data = colors;
        c.pipeline.raster.provoking_vertex = first ? GN_PROVOKING_FIRST : GN_PROVOKING_LAST;
        for (int n = 0; n < 4; ++n)
            c.pipeline.program.interpolation[n] = GN_FLAT;
        assert_int_equal(draw(), GN_OK);
        /* OpenGL 4.5 table 13.2: vertex i + 2 of a strip's triangle i, or vertex i. */
        assert_int_equal(c.color[0], first ? 0xFF0000FFu : 0xFFFF0000u);
        assert_int_equal(c.color[SIZE * SIZE - 1], first ? 0xFF00FF00u : 0xFF00FFFFu);
    }
}

/* The stored depth is 0.5; squares at window depth 0.25, 0.5 and 0.75 are tested. */
static void depth_functions(void **state)
{
    (void)state;
    const struct {
        gn_compare function;
        bool passes[3];
    } cases[] = {
        {GN_LESS, {true, false, false}},
        {GN_NEVER, {false, false, false}},
        {GN_EQUAL, {false, true, false}},
        {GN_LESS_OR_EQUAL, {true, true, false}},
        {GN_GREATER, {false, false, true}},
        {GN_NOT_EQUAL, {true, false, true}},
        {GN_GREATER_OR_EQUAL, {false, true, true}},
        {GN_ALWAYS, {true, true, true}},
    };
    const gn_format formats[] = {GN_FORMAT_D16, GN_FORMAT_D24, GN_FORMAT_D32F};
    const uint32_t values[3][3] = {{16384, 32768, 49151},
                                   {4194304, 8388608, 12582911},
                                   {0x3E800000u, 0x3F000000u, 0x3F400000u}};

    for (size_t f = 0; f < 3; ++f) {
        for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
            for (int depth = 0; depth < 3; ++depth) {
                float positions[16];
                uint16_t low;

                memcpy(positions, square, sizeof positions);
                for (int v = 0; v < 4; ++v)
                    positions[4 * v + 2] = (float)(depth - 1) * 0.5f;
                reset(positions, 4, GN_TRIANGLE_STRIP);
                c.target.depth = gn_surface_bottom_up(c.depth, formats[f], SIZE, SIZE);
                c.pipeline.depth.test = true;
                c.pipeline.depth.function = cases[i].function;
                assert_int_equal(gn_clear_depth(&c.target.depth, 0.5f), GN_OK);
                assert_int_equal(draw(), GN_OK);
                const bool passes = cases[i].passes[depth];
                assert_int_equal(covered(), passes ? SIZE * SIZE : 0);
                memcpy(&low, c.depth, sizeof low);
                assert_int_equal(f == 0 ? low : c.depth[0], values[f][passes ? depth : 1]);
            }
        }
    }
}

static void depth_is_written_only_when_asked(void **state)
{
    (void)state;
    reset(square, 4, GN_TRIANGLE_STRIP);
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(c.depth[0], 0xFFFFFF); /* the test is off: OpenGL 4.5 section 17.3.5 */
    c.pipeline.depth.test = true;
    c.pipeline.depth.write_disabled = true;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(c.depth[0], 0xFFFFFF);
    c.pipeline.depth.write_disabled = false;
    c.pipeline.depth.range.set = true;
    c.pipeline.depth.range.z_near = 0.0f;
    c.pipeline.depth.range.z_far = 0.0f;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(c.depth[0], 0);
}

/* Only depth, without colour or a fragment shader, and only colour. */
static void one_surface_is_enough(void **state)
{
    (void)state;
    reset(square, 4, GN_TRIANGLE_STRIP);
    c.target.color[0].format = GN_FORMAT_NONE;
    c.pipeline.program.fragment_shader = NULL;
    c.pipeline.depth.test = true;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(covered(), 0);
    assert_int_equal(c.depth[0], 8388608);

    reset(square, 4, GN_TRIANGLE_STRIP);
    c.target.depth.format = GN_FORMAT_NONE;
    c.pipeline.depth.test = true;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(covered(), SIZE * SIZE);
}

static void indices_of_every_width(void **state)
{
    (void)state;
    static const uint8_t bytes[4] = {9, 0, 1, 3};
    static const uint16_t shorts[4] = {9, 0, 1, 3};
    static const uint32_t words[4] = {9, 0, 1, 3};
    const void *indices[3] = {bytes, shorts, words};

    for (int i = 0; i < 3; ++i) {
        reset(square, 4, GN_TRIANGLES);
        c.mesh.index_format = (gn_index_format)(GN_INDEX_UINT8 + i);
        c.mesh.indices = indices[i];
        c.mesh.first = 1;
        c.mesh.count = 3;
        assert_int_equal(draw(), GN_OK);
        assert_int_equal(covered(), SIZE * (SIZE + 1) / 2);
        assert_int_equal(c.color[SIZE - 1], 0xFFFFFFFFu);
        assert_int_equal(c.color[SIZE * (SIZE - 1)], 0);
    }
}

static void back_ends_have_names_and_agree(void **state)
{
    (void)state;
    static canvas first;
    const gn_backend best = gn_backend_best();

    assert_true(best > GN_BACKEND_AUTO && best < GN_BACKEND_COUNT);
    assert_true(gn_backend_available(best));
    assert_true(gn_backend_available(GN_BACKEND_AUTO));
    assert_true(gn_backend_available(GN_BACKEND_PORTABLE));
    assert_false(gn_backend_available(GN_BACKEND_COUNT));
    assert_false(gn_backend_available((gn_backend)-1));
    assert_string_equal(gn_backend_name(GN_BACKEND_PORTABLE), "portable");
    assert_string_equal(gn_backend_name(GN_BACKEND_COUNT), "unknown");
    for (int b = GN_BACKEND_AUTO; b < GN_BACKEND_COUNT; ++b) {
        reset(square, 4, GN_TRIANGLE_STRIP);
        c.workspace.backend = (gn_backend)b;
        c.pipeline.depth.test = true;
        if (!gn_backend_available((gn_backend)b))
            continue;
        assert_int_equal(draw(), GN_OK);
        if (b == GN_BACKEND_AUTO)
            first = c;
        assert_memory_equal(c.color, first.color, sizeof c.color);
        assert_memory_equal(c.depth, first.depth, sizeof c.depth);
    }
    c.workspace.backend = GN_BACKEND_COUNT;
    assert_int_equal(draw(), GN_BACKEND_UNAVAILABLE);
#if defined(__x86_64__) || defined(__arm__)
    c.workspace.backend = GN_BACKEND_WASM_SIMD128;
    assert_int_equal(draw(), GN_BACKEND_UNAVAILABLE);
#endif
}

/* A value that is no back end shows that the workspace is read and the processor is not asked. */
static void a_workspace_keeps_the_choice(void **state)
{
    (void)state;
    reset(square, 4, GN_TRIANGLE_STRIP);
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(c.workspace.backend, GN_BACKEND_AUTO);
    assert_int_equal(c.workspace.best, gn_backend_best());
    c.workspace.best = GN_BACKEND_PORTABLE;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(c.workspace.best, GN_BACKEND_PORTABLE);
    c.workspace.best = GN_BACKEND_COUNT;
    assert_int_equal(draw(), GN_BACKEND_UNAVAILABLE);
    c.workspace.backend = GN_BACKEND_PORTABLE;
    assert_int_equal(draw(), GN_OK);
}

static void on_this_thread(void *user, gn_task *task, void *context, uint32_t count)
{
    (void)user;
    for (uint32_t i = 0; i < count; ++i)
        task(context, i);
}

/* Steps between sizes of workspaces, in bytes: every whole number of floats, or one in five where
 * the sanitizer would make that half a minute. The steps leave every remainder of a row of
 * lanes. */
#if defined(__SANITIZE_ADDRESS__)
#define SIZE_STEP 20
#else
#define SIZE_STEP 4
#endif

/* From the smallest workspace to one for threads. Some sizes leave hardly a byte besides the parts
 * that are allotted first. The bytes behind a workspace stay unchanged. */
static void every_workspace_serves_threads(void **state)
{
    (void)state;
    enum { VARYINGS = 4, GUARD = 2048 };
    static const uint8_t indices[4] = {0, 1, 2, 3};
    static unsigned char guard[GUARD];
    const size_t least = gn_workspace_size(0, VARYINGS);
    const size_t most = gn_workspace_size_parallel(4, 2, VARYINGS);
    unsigned char *memory = malloc(most + GUARD);

    assert_non_null(memory);
    for (int indexed = 0; indexed < 2; ++indexed) {
        reset(square, 4, GN_TRIANGLE_STRIP);
        c.mesh.indices = indexed ? indices : NULL;
        c.mesh.index_format = indexed ? GN_INDEX_UINT8 : GN_INDEX_NONE;
        c.workspace.memory = memory;
        c.workspace.backend = GN_BACKEND_PORTABLE;
        c.workspace.parallel = on_this_thread;
        memset(memory, 0, most + GUARD);
        for (c.workspace.size = least; c.workspace.size <= most; c.workspace.size += SIZE_STEP) {
            memset(c.color, 0, sizeof c.color);
            assert_int_equal(draw(), GN_OK);
            assert_int_equal(covered(), SIZE * SIZE);
            assert_memory_equal(memory + c.workspace.size, guard, GUARD);
        }
    }
    free(memory);
}

enum { PLACES_SIDE = 200 };

static bool places_are_even;
static uint8_t times_shaded[PLACES_SIDE][PLACES_SIDE];

/* Red and green are the lane's pixel. */
static void paint_places(const void *uniforms, const gn_fragment_input *input,
                         gn_fragment_output *output)
{
    (void)uniforms;
    for (int half = 0; half < 2; ++half)
        places_are_even = places_are_even && input->x[half] % 2 == 0 && input->y[half] % 2 == 0;
    for (int l = 0; l < GN_LANES; ++l) {
        const int32_t x = input->x[l / 8] + l % 4;
        const int32_t y = input->y[l / 8] + l / 4 % 2;

        output->color[0][l] = (float)x / 255.0f;
        output->color[1][l] = (float)y / 255.0f;
        output->color[2][l] = 0.0f;
        output->color[3][l] = 1.0f;
        if (input->coverage >> l & 1u)
            ++times_shaded[y][x];
    }
}

/* The shader is called for each pixel once. Small blocks, from every row on, and large blocks on a
 * target of their own. */
static void shaders_know_their_pixels(void **state)
{
    (void)state;
    static uint32_t pixels[PLACES_SIDE * PLACES_SIDE];
    float positions[12] = {0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 1};

    for (int i = 0; i < 40; ++i) {
        const int side = i < 20 ? SIZE : PLACES_SIDE;
        int drawn = 0;

        positions[1] = positions[5] = -1.0f + 0.0975f * (float)(i % 20);
        positions[9] = positions[1] + (i % 3 ? 0.4f : 1.4f);
        reset(positions, 3, GN_TRIANGLES);
        memset(pixels, 0, sizeof pixels);
        c.target.color[0] =
            gn_surface_bottom_up(pixels, GN_FORMAT_RGBA8, (uint32_t)side, (uint32_t)side);
        c.target.depth.format = GN_FORMAT_NONE;
        c.pipeline.program.fragment_shader = paint_places;
        places_are_even = true;
        memset(times_shaded, 0, sizeof times_shaded);
        assert_int_equal(draw(), GN_OK);
        assert_true(places_are_even);
        for (int p = 0; p < side * side; ++p) {
            assert_int_equal(times_shaded[p / side][p % side], pixels[p] ? 1 : 0);
            if (pixels[p]) {
                assert_int_equal(pixels[p], 0xFF000000u + (uint32_t)(p / side << 8 | p % side));
                ++drawn;
            }
        }
        assert_true(drawn > 0);
    }
}

/* On memory that ends with the surface, so that the sanitizers see accesses beyond. Sizes are odd
 * too, and triangles are small, so that their blocks reach over the edges. */
static void memory_ends_with_the_surface(void **state)
{
    (void)state;
    uint32_t seed = 1;

    for (uint32_t i = 0; i < 4000; ++i) {
        const uint32_t width = 1 + i % 37, height = 1 + i % 31;
        uint32_t *pixels = malloc(sizeof *pixels * width * height);
        uint32_t *depths = malloc(sizeof *depths * width * height);
        float positions[12];

        assert_true(pixels && depths);
        for (int v = 0; v < 12; ++v) {
            seed = seed * 1664525u + 1013904223u;
            positions[v] = v % 4 < 2 ? (float)(seed >> 8) * 0x1p-23f - 0.5f : v % 4 == 3;
        }
        reset(positions, 3, GN_TRIANGLES);
        memset(pixels, 0, sizeof *pixels * width * height);
        c.target.color[0] = gn_surface_bottom_up(pixels, GN_FORMAT_RGBA8, width, height);
        c.target.depth = gn_surface_bottom_up(depths, GN_FORMAT_D24, width, height);
        assert_int_equal(gn_clear_depth(&c.target.depth, 1.0f), GN_OK);
        c.pipeline.depth.test = true;
        c.pipeline.program.fragment_shader = paint_places;
        memset(times_shaded, 0, sizeof times_shaded);
        assert_int_equal(draw(), GN_OK);
        for (uint32_t y = 0; y < height; ++y) {
            for (uint32_t x = 0; x < width; ++x)
                assert_int_equal(pixels[y * width + x],
                                 times_shaded[y][x] ? 0xFF000000u + (y << 8 | x) : 0);
        }
        free(pixels);
        free(depths);
    }
}

/* Blocks hang over a surface of one row, whose stride nothing limits. */
static void the_stride_of_one_row_is_free(void **state)
{
    static const ptrdiff_t strides[] = {PTRDIFF_MAX - 3, PTRDIFF_MIN, PTRDIFF_MIN / 2, 0};
    (void)state;

    for (size_t i = 0; i < sizeof strides / sizeof strides[0]; ++i) {
        for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b) {
            reset(square, 4, GN_TRIANGLE_STRIP);
            c.target.color[0].height = c.target.depth.height = 1;
            c.target.color[0].row_stride = c.target.depth.row_stride = strides[i];
            c.pipeline.depth.test = true;
            c.workspace.backend = (gn_backend)b;
            if (!gn_backend_available((gn_backend)b))
                continue;
            assert_int_equal(draw(), GN_OK);
            assert_int_equal(covered(), SIZE);
        }
    }
}

static void set_random_triangle(float positions[12], float size, uint32_t *seed)
{
    float center[2] = {0};

    for (int v = -2; v < 12; ++v) {
        *seed = *seed * 1664525u + 1013904223u;
        const float random = (float)(*seed >> 8) * 0x1p-23f - 1.0f;
        if (v < 0)
            center[v + 2] = random;
        else
            positions[v] = v % 4 < 2 ? center[v % 4] + size * random : v % 4 == 3;
    }
}

/* A called shader gets packed pixels, the ready-made shader squares of pixels. Both draw the same
 * pixels, for triangles of all sizes, cut by scissors, on every back end. */
static void packed_pixels_are_the_same(void **state)
{
    (void)state;
    enum { SIDE = PLACES_SIDE, COUNT = SIDE * SIDE };
    static const float sizes[] = {0.02f, 0.1f, 0.3f, 0.55f, 0.6f, 0.65f, 1.0f, 3.0f, 40.0f};
    static uint32_t squares[COUNT], packed[COUNT];
    uint32_t seed = 1;

    for (int i = 0; i < 1200; ++i) {
        float positions[12];

        set_random_triangle(positions, sizes[i % 9], &seed);
        reset(positions, 3, GN_TRIANGLES);
        c.workspace.backend = (gn_backend)(i / 9 % GN_BACKEND_COUNT);
        if (!gn_backend_available(c.workspace.backend))
            c.workspace.backend = GN_BACKEND_AUTO;
        c.target.depth.format = GN_FORMAT_NONE;
        c.pipeline.raster.scissor =
            (gn_scissor){i % 2, (int32_t)(seed >> 9) % SIDE, (int32_t)(seed >> 20) % SIDE,
                         1 + (uint32_t)i * 7 % 90, 1 + (uint32_t)i * 5 % 70};
        for (int shader = 0; shader < 2; ++shader) {
            uint32_t *const pixels = shader ? packed : squares;

            memset(pixels, 0, sizeof squares);
            c.target.color[0] = gn_surface_bottom_up(pixels, GN_FORMAT_RGBA8, SIDE, SIDE);
            if (shader)
                c.pipeline.program.fragment_shader = paint_places;
            assert_int_equal(draw(), GN_OK);
        }
        for (int p = 0; p < COUNT; ++p)
            assert_int_equal(packed[p],
                             squares[p] ? 0xFF000000u + (uint32_t)(p / SIDE << 8 | p % SIDE) : 0);
    }
}

static void a_triangle_through_the_eye_is_clipped(void **state)
{
    (void)state;
    /* The third vertex is behind the eye. A point with the weight c of that vertex has z = -2c and
     * w = 1 - 2c, in front of the near plane for c <= 1/4. Its NDC y is (4c - 1) / (1 - 2c), from
     * -1 to 0, and |x| <= (y + 3) / 2 covers the width. */
    static const float positions[12] = {-1, -1, 0, 1, 1, -1, 0, 1, 0, 3, -2, -1};

    reset(positions, 3, GN_TRIANGLES);
    assert_int_equal(draw(), GN_OK);
    for (int i = 0; i < SIZE * SIZE; ++i)
        assert_int_equal(c.color[i], i < SIZE * SIZE / 2 ? 0xFFFFFFFFu : 0);
}

static void samples_are_counted(void **state)
{
    (void)state;
    uint64_t passed = 5;

    reset(square, 4, GN_TRIANGLE_STRIP);
    c.workspace.samples_passed = &passed;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(passed, 5 + SIZE * SIZE); /* added */
    c.pipeline.depth.test = true;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(passed, 5 + 2 * SIZE * SIZE);
    assert_int_equal(draw(), GN_OK); /* equal depth does not pass */
    assert_int_equal(passed, 5 + 2 * SIZE * SIZE);
    c.pipeline.depth.test = false;
    c.mesh.count = 3;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(passed, 5 + 2 * SIZE * SIZE + SIZE * (SIZE - 1) / 2);
}

/* Keeps every other column, at depth 1/4. */
static void keep_columns(const void *uniforms, const gn_fragment_input *in, gn_fragment_output *out)
{
    (void)uniforms;
    assert_true(in->position == NULL && in->front_facing && in->primitive_id == 0);
    out->kept &= 0x5555;
    for (int l = 0; l < GN_LANES; ++l) {
        out->color[0][l] = out->color[1][l] = out->color[2][l] = out->color[3][l] = 1.0f;
        out->depth[l] = 0.25f;
    }
}

/* The shader runs also without colours, for depth and stencil. */
static void depth_comes_from_the_shader(void **state)
{
    (void)state;
    uint64_t passed = 0;

    reset(square, 4, GN_TRIANGLE_STRIP);
    c.target.color[0].format = GN_FORMAT_NONE;
    c.target.depth.format = GN_FORMAT_D24S8;
    assert_int_equal(gn_clear_depth_stencil(&c.target.depth, 0.5f, 7), GN_OK);
    c.workspace.samples_passed = &passed;
    c.pipeline.program.fragment_shader = keep_columns;
    c.pipeline.program.fragment_discards = true;
    c.pipeline.program.fragment_writes_depth = true;
    c.pipeline.depth.test = true;
    c.pipeline.stencil.test = true;
    c.pipeline.stencil.front.pass = GN_STENCIL_INCREMENT;
    assert_int_equal(draw(), GN_OK);
    for (int i = 0; i < SIZE * SIZE; ++i)
        assert_int_equal(c.depth[i], i % 2 ? 7u << 24 | 0x800000 : 8u << 24 | 0x400000);
    assert_int_equal(passed, SIZE * SIZE / 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faults_touch_nothing),
        cmocka_unit_test(a_square_covers_everything),
        cmocka_unit_test(ties_belong_to_left_and_bottom_edges),
        cmocka_unit_test(winding_and_culling),
        cmocka_unit_test(flat_takes_the_provoking_vertex),
        cmocka_unit_test(depth_functions),
        cmocka_unit_test(depth_is_written_only_when_asked),
        cmocka_unit_test(one_surface_is_enough),
        cmocka_unit_test(indices_of_every_width),
        cmocka_unit_test(back_ends_have_names_and_agree),
        cmocka_unit_test(a_workspace_keeps_the_choice),
        cmocka_unit_test(every_workspace_serves_threads),
        cmocka_unit_test(shaders_know_their_pixels),
        cmocka_unit_test(memory_ends_with_the_surface),
        cmocka_unit_test(the_stride_of_one_row_is_free),
        cmocka_unit_test(packed_pixels_are_the_same),
        cmocka_unit_test(a_triangle_through_the_eye_is_clipped),
        cmocka_unit_test(samples_are_counted),
        cmocka_unit_test(depth_comes_from_the_shader),
    };
    return cmocka_run_group_tests_name("draw", tests, NULL, NULL);
}
