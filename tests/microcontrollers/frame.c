/* The program that `make bench-embedded` runs on a microcontroller's processor: draws a sphere of
 * 1,200 triangles at two sizes, and prints for each size how many instructions clearing and drawing
 * took, how many pixels are covered, a hash of all pixels and the bytes of stack used. Built for a
 * hosted machine, it prints the same hashes, and 0 for what only a board measures.
 *
 * SCENE  0: vertex colours, 1: a texture with the nearest filter, 2: with the linear filter,
 *        3: a shader of the user's, written for one fragment */
#include <gnomon.h>

#include "board.h"

#if !defined(BOARD_LARGE)
#define BOARD_LARGE 240 /* pixels on a side */
#endif
#if !defined(SCENE)
#define SCENE 0
#endif

enum {
    CELLS = 10, /* along each side of a face of the cube from which the sphere is made */
    FACES = 6,
    VERTICES = FACES * (CELLS + 1) * (CELLS + 1),
    INDICES = FACES * CELLS * CELLS * 6,
    LARGE = BOARD_LARGE,
    SMALL = 60,
    TEXTURE_SIZE = 64,
    VARYINGS = SCENE == 1 || SCENE == 2 ? 6 : 4
};

static uint32_t color[LARGE * LARGE];
static uint16_t depth[LARGE * LARGE];
static float position[VERTICES][3], attribute[VERTICES][3], texcoord[VERTICES][2];
static uint16_t indices[INDICES];
static union {
    uint64_t alignment;
    unsigned char memory[GN_WORKSPACE_SIZE(VERTICES, VARYINGS)];
} workspace_memory;

/* Outward sides are counter-clockwise. */
static void make_sphere(void)
{
    static const unsigned char corner[6] = {0, 1, 3, 0, 3, 2};
    uint32_t v = 0, i = 0;

    for (int face = 0; face < FACES; ++face) {
        const int axis = face % 3;
        const float side = face < 3 ? 1.0f : -1.0f;
        const uint32_t first = v;

        for (int row = 0; row <= CELLS; ++row) {
            for (int column = 0; column <= CELLS; ++column, ++v) {
                const float s = (float)column / CELLS, t = (float)row / CELLS;
                float p[3];

                p[axis] = side;
                p[(axis + 1) % 3] = (2.0f * s - 1.0f) * side;
                p[(axis + 2) % 3] = 2.0f * t - 1.0f;
                const float length = gn_sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
                for (int c = 0; c < 3; ++c) {
                    position[v][c] = p[c] / length;
                    attribute[v][c] = SCENE == 3 ? position[v][c] : (position[v][c] + 1.0f) * 0.5f;
                }
                texcoord[v][0] = s * 2.0f;
                texcoord[v][1] = t * 2.0f;
            }
        }
        for (uint32_t cell = 0; cell < CELLS * CELLS; ++cell) {
            const uint32_t lower = first + cell / CELLS * (CELLS + 1) + cell % CELLS;

            for (int n = 0; n < 6; ++n)
                indices[i++] =
                    (uint16_t)(lower + (corner[n] & 1u) + (corner[n] >> 1) * (CELLS + 1u));
        }
    }
}

/* Turned about two axes by angles of the triangles 3, 4, 5 and 5, 12, 13, then moved away; near
 * plane at 0.5, far plane at 10. */
static gn_mat4 camera(void)
{
    const float s = 0.6f, c = 0.8f, q = 5.0f / 13.0f, r = 12.0f / 13.0f;
    const float turned[3][3] = {{c, s * q, -s * r}, {0.0f, r, q}, {s, -c * q, c * r}};
    const float zoom = 2.415f, away = 2.768f;
    gn_mat4 m;

    for (int column = 0; column < 4; ++column) {
        float p[3] = {0.0f, 0.0f, -away};

        for (int row = 0; row < 3 && column < 3; ++row)
            p[row] = turned[column][row];
        m.m[column][0] = zoom * p[0];
        m.m[column][1] = zoom * p[1];
        m.m[column][2] = -10.5f / 9.5f * p[2] + (column == 3 ? -10.0f / 9.5f : 0.0f);
        m.m[column][3] = -p[2];
    }
    return m;
}

#if SCENE == 3
typedef struct look {
    gn_mat4 clip_from_model;
    gn_vec3 to_light;
} look;

typedef struct surface {
    gn_vec3 normal;
    float shine;
} surface;

static gn_vec4 place(const look *u, gn_vertex *vertex, surface *out)
{
    out->normal = gn_xyz4(vertex->attribute[GN_ATTRIBUTE_NORMAL]);
    out->shine = 0.75f;
    return gn_multiply_mat4(&u->clip_from_model, vertex->attribute[GN_ATTRIBUTE_POSITION]);
}

static gn_vec4 paint(const look *u, const surface *in, gn_fragment *fragment)
{
    const float lit = gn_maximum1(gn_dot3(in->normal, u->to_light), 0.125f);

    (void)fragment;
    return gn_make4(lit, lit * in->shine, lit * 0.5f, 1.0f);
}

GN_SHADERS(use_look, look, surface, place, paint);
#endif

static gn_mesh mesh;
static gn_pipeline pipeline;

/* Returns the status of what makes the pipeline. */
static gn_status make_scene(void)
{
    if (gn_workspace_size(VERTICES, VARYINGS) != sizeof workspace_memory.memory)
        return GN_WORKSPACE_TOO_SMALL; /* the constant differs from the function */
    make_sphere();
    mesh.attribute[GN_ATTRIBUTE_POSITION].data = position[0];
    mesh.attribute[GN_ATTRIBUTE_POSITION].components = 3;
    mesh.vertex_count = VERTICES;
    mesh.indices = indices;
    mesh.index_format = GN_INDEX_UINT16;
    mesh.count = INDICES;
    pipeline.depth.test_enabled = true;
    pipeline.raster.cull = GN_CULL_BACK;
#if SCENE == 0
    static gn_color_uniforms uniforms;

    uniforms.clip_from_model = camera();
    mesh.attribute[GN_ATTRIBUTE_COLOR].data = attribute[0];
    mesh.attribute[GN_ATTRIBUTE_COLOR].components = 3;
    return gn_use_vertex_color(&pipeline, &uniforms);
#elif SCENE == 3
    static look uniforms;

    uniforms.clip_from_model = camera();
    uniforms.to_light = gn_make3(0.36f, 0.48f, 0.8f);
    mesh.attribute[GN_ATTRIBUTE_NORMAL].data = attribute[0];
    mesh.attribute[GN_ATTRIBUTE_NORMAL].components = 3;
    return use_look(&pipeline, &uniforms);
#else
    static gn_unlit_uniforms uniforms;
    static uint32_t texels[TEXTURE_SIZE * TEXTURE_SIZE];
    static gn_texture texture;
    const gn_status status = gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, TEXTURE_SIZE,
                                               TEXTURE_SIZE, 1, 1, texels, &texture);

    for (uint32_t i = 0; i < TEXTURE_SIZE * TEXTURE_SIZE; ++i)
        texels[i] = (i ^ i / TEXTURE_SIZE) & 8 ? 0xFF2040FFu : 0xFFFFFFFFu - 0x000301u * i;
    uniforms.clip_from_model = camera();
    uniforms.map = &texture;
    uniforms.sampler.magnify = SCENE == 1 ? GN_MAGNIFY_NEAREST : GN_MAGNIFY_LINEAR;
    uniforms.sampler.minify = SCENE == 1 ? GN_MINIFY_NEAREST : GN_MINIFY_LINEAR;
    mesh.attribute[GN_ATTRIBUTE_COLOR].data = attribute[0];
    mesh.attribute[GN_ATTRIBUTE_COLOR].components = 3;
    mesh.attribute[GN_ATTRIBUTE_TEXCOORD].data = texcoord[0];
    mesh.attribute[GN_ATTRIBUTE_TEXCOORD].components = 2;
    return status ? status : gn_use_unlit(&pipeline, &uniforms);
#endif
}

static void print_number(uint32_t n)
{
    board_print(" ");
    board_print_number(n);
}

/* FNV-1a over the pixels as numbers. */
static uint32_t hash_of(uint32_t size)
{
    uint32_t hash = 0x811C9DC5u;

    for (uint32_t i = 0; i < size * size; ++i) {
        const uint32_t word[2] = {color[i], depth[i]};

        for (int n = 0; n < 8; ++n)
            hash = (hash ^ (word[n / 4] >> 8 * (n % 4) & 255)) * 0x01000193u;
    }
    return hash;
}

/* Prints: size, instructions of clearing and of drawing, covered pixels, hash, stack. */
static gn_status draw(uint32_t size)
{
    gn_workspace workspace = {.memory = workspace_memory.memory,
                              .size = sizeof workspace_memory.memory};
    static gn_target target;
    uint32_t covered = 0;
    gn_status status;

    target.color[0] = gn_surface_bottom_up(color, GN_FORMAT_RGBA8, size, size);
    target.depth = gn_surface_bottom_up(depth, GN_FORMAT_D16, size, size);
    board_paint_stack();
    board_start();
    status = gn_clear_color(&target.color[0], 0.1f, 0.2f, 0.3f, 1.0f);
    if (!status)
        status = gn_clear_depth(&target.depth, 1.0f);
    const uint32_t cleared = board_instructions();
    if (status)
        return status;
    board_start();
    status = gn_draw(&target, &pipeline, &mesh, &workspace);
    const uint32_t drawn = board_instructions();
    const uint32_t stack = board_stack();
    for (uint32_t i = 0; i < size * size; ++i)
        covered += depth[i] != 0xFFFF;
    print_number(size);
    print_number(cleared);
    print_number(drawn);
    print_number(covered);
    print_number(hash_of(size));
    print_number(stack);
    board_print("\n");
    return status;
}

/* Prints the instructions that a loop of 3,000,000 takes by the board's count, then two pictures,
 * then the bytes of the workspace. */
int main(void)
{
    gn_status status = make_scene();

    print_number(board_loop());
    board_print("\n");
    if (!status)
        status = draw(LARGE);
    if (!status)
        status = draw(SMALL);
    print_number(sizeof workspace_memory.memory);
    board_print("\n");
    if (status)
        board_print("failed\n");
    return status != GN_OK;
}
