/* Lookups by the library: by a user's shader in a draw on a back end, and by calls. */
#include "../../unit/public_lookups.h"

#include <stdio.h>
#include <string.h>

#include "lookups.h"

/* A block's values from a grid, one array per component. */
typedef struct block_places {
    float place[4][GN_LANES], gradient_x[4][GN_LANES], gradient_y[4][GN_LANES];
} block_places;

/* For a block whose halves begin at (x[0], y[0]) and (x[1], y[1]). */
static int32_t place_of_lane(const int32_t x[2], const int32_t y[2], int l)
{
    return (y[l / 8] + l / 4 % 2) * GRID_WIDTH + x[l / 8] + l % 4;
}

static void load_block(const lookup_places *p, const int32_t x[2], const int32_t y[2],
                       block_places *b)
{
    for (int l = 0; l < GN_LANES; ++l) {
        const int32_t at = place_of_lane(x, y, l);

        for (int n = 0; n < 4; ++n) {
            b->place[n][l] = p->place[at][n];
            b->gradient_x[n][l] = p->gradient_x[at][n];
            b->gradient_y[n][l] = p->gradient_y[at][n];
        }
    }
}

static void fetch(const lookup_case *c, const gn_texture_functions *f, const block_places *b,
                  float texel[4][GN_LANES])
{
    int32_t number[4][GN_LANES];
    const int32_t *const coordinate[3] = {number[0], number[1], number[2]};

    for (int n = 0; n < 4; ++n)
        for (int l = 0; l < GN_LANES; ++l)
            number[n][l] = (int32_t)b->place[n][l];
    f->fetch(f->memory, &c->texture, coordinate, number[3], texel);
}

static void lookup_block(const lookup_case *c, const gn_texture_functions *f, const int32_t x[2],
                         const int32_t y[2], float texel[4][GN_LANES])
{
    block_places b;
    gn_lookup lookup;

    load_block(&c->places, x, y, &b);
    memset(&lookup, 0, sizeof lookup);
    for (int n = 0; n < 3; ++n)
        lookup.coordinate[n] = b.place[n];
    lookup.reference = b.gradient_x[3];
    switch (c->kind) {
    case LOOKUP_FETCH:
        fetch(c, f, &b, texel);
        return;
    case LOOKUP_GATHER:
        f->gather(f->memory, &c->texture, &c->sampler, &lookup, c->channel, texel);
        return;
    case LOOKUP_BIAS:
        lookup.lod = b.place[3];
        break;
    case LOOKUP_LOD:
        lookup.lod_source = GN_LOD_EXPLICIT;
        lookup.lod = b.place[3];
        break;
    case LOOKUP_GRADIENTS:
        lookup.lod_source = GN_LOD_GRADIENTS;
        for (int n = 0; n < 3; ++n) {
            lookup.gradient_x[n] = b.gradient_x[n];
            lookup.gradient_y[n] = b.gradient_y[n];
        }
        break;
    default:
        break;
    }
    if (c->kind == LOOKUP_IMPLICIT && c->target == GN_TEXTURE_2D && (x[0] / 4) % 2 == 1 &&
        c->sampler.compare == GN_COMPARE_DEFAULT)
        f->lookup_2d(f->memory, &c->texture, &c->sampler, b.place[0], b.place[1], texel);
    else
        f->lookup(f->memory, &c->texture, &c->sampler, &lookup, texel);
}

static void cover(const void *uniforms, const gn_vertex_input *input, gn_vertex_output *output)
{
    (void)uniforms;
    for (int l = 0; l < GN_LANES; ++l) {
        output->position[0][l] = input->vertex_id[l] == 1 ? 3.0f : -1.0f;
        output->position[1][l] = input->vertex_id[l] == 2 ? 3.0f : -1.0f;
        output->position[2][l] = 0.0f;
        output->position[3][l] = 1.0f;
    }
}

static void shade(const void *uniforms, const gn_fragment_input *input, gn_fragment_output *output)
{
    lookup_block(uniforms, input->texture_functions, input->x, input->y, output->color);
}

bool library_lookup(const lookup_case *c, gn_backend backend, float (*texel)[4], char *error,
                    size_t error_size)
{
    static unsigned char memory[GN_WORKSPACE_SIZE(3, 0)];
    gn_target target;
    gn_pipeline pipeline;
    gn_mesh mesh;
    gn_workspace workspace;
    gn_status status;

    memset(&target, 0, sizeof target);
    memset(&pipeline, 0, sizeof pipeline);
    memset(&mesh, 0, sizeof mesh);
    memset(&workspace, 0, sizeof workspace);
    target.color[0] = gn_surface_bottom_up(texel, GN_FORMAT_RGBA32F, GRID_WIDTH, GRID_HEIGHT);
    pipeline.program.vertex_shader = cover;
    pipeline.program.fragment_shader = shade;
    pipeline.program.uniforms = c;
    mesh.vertex_count = 3;
    mesh.count = 3;
    workspace.memory = memory;
    workspace.size = sizeof memory;
    workspace.backend = backend;
    status = gn_texture_check(&c->texture);
    if (!status)
        status = gn_sampler_check(&c->sampler);
    if (!status)
        status = gn_draw(&target, &pipeline, &mesh, &workspace);
    if (status)
        snprintf(error, error_size, "the library: %s", gn_status_text(status));
    return !status;
}

void library_lookup_directly(const lookup_case *c, float (*texel)[4])
{
    float block[4][GN_LANES];

    for (int32_t y = 0; y < GRID_HEIGHT; y += 4) {
        for (int32_t x = 0; x < GRID_WIDTH; x += 4) {
            const int32_t column[2] = {x, x};
            const int32_t row[2] = {y, y + 2};

            lookup_block(c, &public_lookups, column, row, block);
            for (int l = 0; l < GN_LANES; ++l)
                for (int n = 0; n < 4; ++n)
                    texel[place_of_lane(column, row, l)][n] = block[n][l];
        }
    }
}
