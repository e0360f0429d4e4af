/* A program for a Cortex-M4 without an operating system or a C library: draws two cubes, one of
 * them through the near plane, in a workspace of 16 KiB. `make size` measures how much of the
 * library this program holds, and runs it in an emulator. Built for a hosted machine, it prints the
 * same hash.
 *
 * TEXTURED     1: a texture with the nearest filter under light, 0: vertex colours
 * USER_SHADER  1: the texture is looked up by a fragment shader of the program
 * DEPTH        the depth format, GN_FORMAT_D16 or GN_FORMAT_NONE */
#include <gnomon.h>

#include "board.h"

#ifndef TEXTURED
#define TEXTURED 1
#endif
#ifndef USER_SHADER
#define USER_SHADER 0
#endif
#ifndef DEPTH
#define DEPTH GN_FORMAT_D16
#endif

enum { SIZE = 64, TEXTURE_SIZE = 16, CORNERS = 36 };

static uint32_t color[SIZE * SIZE];
static uint16_t depth[SIZE * SIZE];
static unsigned char workspace_memory[16384];
static float position[CORNERS][3], attribute[CORNERS][3], texcoord[CORNERS][2];

/* The cube's 12 triangles, outward sides counter-clockwise. */
static void make_cube(void)
{
    static const unsigned char corner[6] = {0, 1, 3, 0, 3, 2};

    for (int face = 0; face < 6; ++face) {
        const int axis = face % 3;
        const float side = face < 3 ? 1.0f : -1.0f;

        for (int k = 0; k < 6; ++k) {
            const int n = 6 * face + k;
            const float u = corner[k] & 1 ? 1.0f : -1.0f;
            const float v = corner[k] & 2 ? 1.0f : -1.0f;

            position[n][axis] = side;
            position[n][(axis + 1) % 3] = u * side;
            position[n][(axis + 2) % 3] = v;
            for (int c = 0; c < 3; ++c)
                attribute[n][c] =
                    TEXTURED ? (c == axis ? side : 0.0f) : (position[n][c] + 1.0f) / 2;
            texcoord[n][0] = u + 1.0f;
            texcoord[n][1] = v + 1.0f;
        }
    }
}

/* Turned about y by an angle of the triangle 3, 4, 5, then moved away; near plane at 0.5, far plane
 * at 10. */
static gn_mat4 camera(float away)
{
    const float sine = 0.6f, cosine = 0.8f, zoom = 1.5f;
    const float a = -10.5f / 9.5f, b = -10.0f / 9.5f;
    gn_mat4 m;

    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            m.m[column][row] = 0.0f;
    m.m[0][0] = zoom * cosine;
    m.m[2][0] = zoom * sine;
    m.m[1][1] = zoom;
    m.m[0][2] = a * -sine;
    m.m[2][2] = a * cosine;
    m.m[3][2] = a * -away + b;
    m.m[0][3] = sine;
    m.m[2][3] = -cosine;
    m.m[3][3] = away;
    return m;
}

#if defined(GN_BASIC)
/* Whether features that the library was compiled without are refused. */
static bool refuses_the_rest(const gn_target *target, gn_pipeline pipeline, const gn_mesh *mesh,
                             gn_workspace *workspace)
{
    const gn_pipeline good = pipeline;
    int refused = 0;

    pipeline.raster.topology = GN_LINES;
    refused += gn_draw(target, &pipeline, mesh, workspace) == GN_NOT_COMPILED;
    pipeline = good;
    pipeline.color.blend[0].enabled = true;
    refused += gn_draw(target, &pipeline, mesh, workspace) == GN_NOT_COMPILED;
    pipeline = good;
    pipeline.raster.polygon_offset.enabled = true;
    refused += gn_draw(target, &pipeline, mesh, workspace) == GN_NOT_COMPILED;
    pipeline = good;
    pipeline.program.color_count = 2;
    refused += gn_draw(target, &pipeline, mesh, workspace) == GN_NOT_COMPILED;
    pipeline = good;
    pipeline.program.clip_distance_count = 1;
    refused += gn_draw(target, &pipeline, mesh, workspace) == GN_NOT_COMPILED;
    pipeline = good;
    pipeline.raster.polygon_mode_front = GN_POLYGON_LINE;
    refused += gn_draw(target, &pipeline, mesh, workspace) == GN_NOT_COMPILED;
    return refused == 6;
}
#endif

#if USER_SHADER
/* Varyings 4 and 5 of the ready-made vertex shader are the texture coordinates. */
static void shade_texture(const void *uniforms, const gn_fragment_input *input,
                          gn_fragment_output *output)
{
    const gn_material *const material = &((const gn_lit_uniforms *)uniforms)->material;

    gn_fragment_lookup_2d(input, material->diffuse_map, &material->sampler, input->varying[4],
                          input->varying[5], output->color);
}
#endif

static gn_status draw_cube(const gn_target *target, float away)
{
    static uint32_t texels[TEXTURE_SIZE * TEXTURE_SIZE];
    static gn_mesh mesh;
    static gn_pipeline pipeline;
    gn_workspace workspace = {.memory = workspace_memory, .size = sizeof workspace_memory};
    gn_status status;

    mesh.attribute[GN_ATTRIBUTE_POSITION].data = position[0];
    mesh.attribute[GN_ATTRIBUTE_POSITION].components = 3;
    mesh.vertex_count = CORNERS;
    mesh.count = CORNERS;
    pipeline.depth.test_enabled = DEPTH != GN_FORMAT_NONE;
    pipeline.raster.cull = GN_CULL_BACK;
#if TEXTURED
    static gn_texture texture;
    static gn_lit_uniforms uniforms;

    for (uint32_t i = 0; i < TEXTURE_SIZE * TEXTURE_SIZE; ++i)
        texels[i] = (i ^ i / TEXTURE_SIZE) & 4 ? 0xFF2040FFu : 0xFFFFFFFFu - 0x000301u * i;
    texture.level[0].texels = texels;
    texture.level[0].row_stride = TEXTURE_SIZE * 4;
    texture.width = texture.height = TEXTURE_SIZE;
    texture.format = GN_FORMAT_RGBA8;
    uniforms.material.diffuse_map = &texture;
    uniforms.material.sampler.magnify = GN_MAGNIFY_NEAREST;
    uniforms.material.sampler.minify = GN_MINIFY_NEAREST;
    uniforms.clip_from_model = camera(away);
    for (int i = 0; i < 3; ++i)
        uniforms.normal_matrix.m[i][i] = 1.0f;
    uniforms.light.direction.x = 0.6f;
    uniforms.light.direction.z = 0.8f;
    uniforms.light.ambient.x = uniforms.light.ambient.y = uniforms.light.ambient.z = 0.3f;
    uniforms.light.diffuse.x = uniforms.light.diffuse.y = uniforms.light.diffuse.z = 0.7f;
    mesh.attribute[GN_ATTRIBUTE_NORMAL].data = attribute[0];
    mesh.attribute[GN_ATTRIBUTE_NORMAL].components = 3;
    mesh.attribute[GN_ATTRIBUTE_TEXCOORD].data = texcoord[0];
    mesh.attribute[GN_ATTRIBUTE_TEXCOORD].components = 2;
    status = gn_use_gouraud(&pipeline, &uniforms);
#if USER_SHADER
    pipeline.program.fragment_shader = shade_texture;
#endif
#else
    static gn_color_uniforms uniforms;

    (void)texels;
    uniforms.clip_from_model = camera(away);
    mesh.attribute[GN_ATTRIBUTE_COLOR].data = attribute[0];
    mesh.attribute[GN_ATTRIBUTE_COLOR].components = 3;
    status = gn_use_vertex_color(&pipeline, &uniforms);
#endif
    if (!status)
        status = gn_draw(target, &pipeline, &mesh, &workspace);
#if defined(GN_BASIC)
    if (!status && !refuses_the_rest(target, pipeline, &mesh, &workspace))
        status = GN_NOT_COMPILED;
#endif
    return status;
}

static gn_status draw(void)
{
    static gn_target target;
    gn_status status;

    make_cube();
    target.color[0] = gn_surface_bottom_up(color, GN_FORMAT_RGBA8, SIZE, SIZE);
    status = gn_clear_color(&target.color[0], 0.1f, 0.2f, 0.3f, 1.0f);
    if (DEPTH != GN_FORMAT_NONE) {
        target.depth = gn_surface_bottom_up(depth, DEPTH, SIZE, SIZE);
        if (!status)
            status = gn_clear_depth(&target.depth, 1.0f);
    }
    if (!status)
        status = draw_cube(&target, 3.5f);
    return status ? status : draw_cube(&target, 1.5f);
}

/* FNV-1a over the pixels as numbers; 0 where drawing failed or drew nothing. */
static uint32_t picture(void)
{
    uint32_t hash = 0x811C9DC5u, drawn = 0;

    if (draw())
        return 0;
    for (int i = 0; i < SIZE * SIZE; ++i) {
        const uint32_t word[2] = {color[i], depth[i]};

        drawn += color[i] != color[0];
        for (int n = 0; n < 8; ++n)
            hash = (hash ^ (word[n / 4] >> 8 * (n % 4) & 255)) * 0x01000193u;
    }
    return drawn ? hash : 0;
}

/* Prints the hash, then the bytes of stack used. */
int main(void)
{
    board_paint_stack();
    board_print_number(picture());
    board_print("\n");
    board_print_number(board_stack());
    board_print("\n");
    return 0;
}
