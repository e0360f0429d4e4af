/* Shaders as functions of one vertex and fragment: frames have the bits of those of loops over
 * lanes that are written by hand, on every back end, with everything that a function may use. */
#include <assert.h>

#include "drawing.h"
#include "noise.h"

enum { SIDE = 32, VERTICES = 90, TEXTURE_SIDE = 16, VARYINGS = 9 };

typedef struct varyings {
    gn_vec4 color;
    gn_vec3 place;
    gn_vec2 texcoord;
} varyings;

typedef struct uniforms {
    gn_mat4 matrix;
    gn_vec4 tint;
    gn_texture map, cube, shadow;
    gn_sampler sampler, compared;
} uniforms;

static uniforms u;
static uint32_t texels[6 * TEXTURE_SIDE * TEXTURE_SIDE * 2];
static uint16_t depths[TEXTURE_SIDE * TEXTURE_SIDE];
static float positions[VERTICES][4], colors[VERTICES][3], texcoords[VERTICES][2];

static float random_between(float low, float high)
{
    static uint32_t seed = 7;

    return low + (high - low) * noise(&seed);
}

static int set_up(void **state)
{
    for (int i = 0; i < 4 * VERTICES; ++i) {
        const int v = i / 4, n = i % 4;

        positions[v][n] = n == 3 ? random_between(0.5f, 2.0f) : random_between(-1.2f, 1.2f);
        colors[v][n % 3] = random_between(0, 1);
        texcoords[v][n % 2] = random_between(-2, 2);
    }
    for (size_t i = 0; i < sizeof texels / sizeof *texels; ++i)
        texels[i] = (uint32_t)random_between(0, 0x1p32f);
    for (size_t i = 0; i < sizeof depths / sizeof *depths; ++i)
        depths[i] = (uint16_t)random_between(0, 65535);
    gn_mat4_identity(&u.matrix);
    u.matrix.m[1][0] = 0.3f;
    u.matrix.m[2][1] = -0.2f;
    u.tint = gn_make4(0.9f, 0.5f, 0.7f, 0.8f);
    u.sampler.minify = GN_MINIFY_LINEAR_MIPMAP_LINEAR;
    u.compared.compare = GN_LESS_OR_EQUAL;
    u.compared.minify = GN_MINIFY_LINEAR;
    return gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, TEXTURE_SIDE, TEXTURE_SIDE, 1, 5,
                             texels, &u.map) != GN_OK ||
           gn_texture_packed(GN_TEXTURE_CUBE, GN_FORMAT_RGBA8, TEXTURE_SIDE, TEXTURE_SIDE, 1, 3,
                             texels, &u.cube) != GN_OK ||
           gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_D16, TEXTURE_SIDE, TEXTURE_SIDE, 1, 1, depths,
                             &u.shadow) != GN_OK;
}

typedef struct frame {
    float color[2][GN_SAMPLES * SIDE * SIDE][4];
    float depth[GN_SAMPLES * SIDE * SIDE];
    uint64_t passed;
} frame;

static void draw(const gn_pipeline *pipeline, bool multisampled, gn_backend backend, frame *out)
{
    static unsigned char memory[GN_WORKSPACE_SIZE(VERTICES, GN_MAX_VARYINGS)];
    gn_target target = {{gn_surface_bottom_up(out->color[0], GN_FORMAT_RGBA32F, SIDE, SIDE),
                         gn_surface_bottom_up(out->color[1], GN_FORMAT_RGBA32F, SIDE, SIDE)},
                        gn_surface_bottom_up(out->depth, GN_FORMAT_D32F, SIDE, SIDE)};
    gn_mesh mesh = mesh_of(positions[0], 4, VERTICES);
    gn_workspace workspace = {.memory = memory,
                              .size = sizeof memory,
                              .backend = backend,
                              .samples_passed = &out->passed};

    mesh.attribute[GN_ATTRIBUTE_COLOR] = floats(colors[0], 3);
    mesh.attribute[GN_ATTRIBUTE_TEXCOORD] = floats(texcoords[0], 2);
    mesh.instance_count = 2;
    memset(out, 0, sizeof *out);
    if (multisampled)
        make_multisampled(&target);
    assert_int_equal(gn_clear_depth(&target.depth, 1), GN_OK);
    assert_int_equal(gn_draw(&target, pipeline, &mesh, &workspace), GN_OK);
}

static gn_pipeline new_pipeline(void)
{
    gn_pipeline pipeline;

    memset(&pipeline, 0, sizeof pipeline);
    pipeline.depth.test_enabled = true;
    pipeline.depth.function = GN_LESS_OR_EQUAL; /* the second instance is seen */
    return pipeline;
}

static void use(gn_pipeline *pipeline, gn_vertex_shader *vertex, gn_fragment_shader *fragment)
{
    pipeline->program.vertex_shader = vertex;
    pipeline->program.fragment_shader = fragment;
    pipeline->program.uniforms = &u;
    pipeline->program.varying_count = VARYINGS;
}

/* Compares frames with those of the pipeline with these loops. At least so many samples pass that
 * the comparison says something. */
static void compare(const gn_pipeline *functions, gn_vertex_shader *vertex,
                    gn_fragment_shader *fragment)
{
    static frame a, b;
    gn_pipeline loops = *functions;

    use(&loops, vertex, fragment);
    for (gn_backend k = GN_BACKEND_AUTO; k < GN_BACKEND_COUNT; k = backend_after(k))
        for (int multisampled = 0; multisampled < 2; ++multisampled) {
            draw(functions, multisampled, k, &a);
            draw(&loops, multisampled, k, &b);
            assert_in_range(a.passed, 100, UINT32_MAX);
            assert_memory_equal(&a, &b, sizeof a);
        }
}

/* Vertices: a matrix, attributes that are there or not, numbers, an unwritten varying. */

static gn_vec4 vertex_function(const uniforms *v, gn_vertex *vertex, varyings *out)
{
    const gn_vec4 position = vertex->attribute[GN_ATTRIBUTE_POSITION];
    const gn_vec4 other = gn_make4(0.25f, 0.5f, 0.75f, 1.0f);

    out->color = gn_multiply4(gn_attribute_or(vertex, GN_ATTRIBUTE_COLOR, other), v->tint);
    out->color.w = gn_attribute_or(vertex, GN_ATTRIBUTE_TANGENT, other).y;
    out->place.x = vertex->attribute[GN_ATTRIBUTE_NORMAL].w;
    out->place.y = 0.01f * (float)vertex->vertex_id + (float)vertex->instance;
    out->texcoord = gn_xy4(vertex->attribute[GN_ATTRIBUTE_TEXCOORD]);
    return gn_multiply_mat4(&v->matrix, position);
}

static void vertex_loop(const void *values, const gn_vertex_input *input, gn_vertex_output *output)
{
    const uniforms *v = values;
    const float(*p)[GN_LANES] = input->attribute[GN_ATTRIBUTE_POSITION];
    const float(*color)[GN_LANES] = input->attribute[GN_ATTRIBUTE_COLOR];

    assert(input->present ==
           (1u << GN_ATTRIBUTE_POSITION | 1u << GN_ATTRIBUTE_COLOR | 1u << GN_ATTRIBUTE_TEXCOORD));
    for (int l = 0; l < GN_LANES; ++l) {
        for (int row = 0; row < 4; ++row)
            output->position[row][l] =
                ((v->matrix.m[0][row] * p[0][l] + v->matrix.m[1][row] * p[1][l]) +
                 v->matrix.m[2][row] * p[2][l]) +
                v->matrix.m[3][row] * p[3][l];
        output->varying[0][l] = color[0][l] * v->tint.x;
        output->varying[1][l] = color[1][l] * v->tint.y;
        output->varying[2][l] = color[2][l] * v->tint.z;
        output->varying[3][l] = 0.5f;
        output->varying[4][l] = 1.0f;
        output->varying[5][l] = 0.01f * (float)input->vertex_id[l] + (float)input->instance;
        output->varying[7][l] = input->attribute[GN_ATTRIBUTE_TEXCOORD][0][l];
        output->varying[8][l] = input->attribute[GN_ATTRIBUTE_TEXCOORD][1][l];
    }
}

/* Fragments: varyings alone. */

static gn_vec4 plain_function(const uniforms *v, const varyings *in, gn_fragment *fragment)
{
    const gn_vec4 back = gn_make4(in->place.x, in->place.y, in->place.z, in->texcoord.x);

    return gn_select4(fragment->front_facing, gn_mix4(in->color, v->tint, 0.25f), back);
}

static void plain_loop(const void *values, const gn_fragment_input *in, gn_fragment_output *out)
{
    const uniforms *v = values;
    const float tint[4] = {v->tint.x, v->tint.y, v->tint.z, v->tint.w};

    for (int c = 0; c < 4; ++c)
        for (int l = 0; l < GN_LANES; ++l)
            out->color[c][l] = in->front_facing
                                   ? in->varying[c][l] * (1.0f - 0.25f) + tint[c] * 0.25f
                                   : in->varying[4 + c][l];
}

GN_SHADERS(use_plain, uniforms, varyings, vertex_function, plain_function);

static gn_vec4 vertex_without_uniforms(const void *none, gn_vertex *vertex, varyings *out)
{
    (void)none;
    (void)out;
    return vertex->attribute[GN_ATTRIBUTE_POSITION];
}

static gn_vec4 fragment_without_uniforms(const void *none, const varyings *in,
                                         gn_fragment *fragment)
{
    (void)none;
    (void)fragment;
    return in->color;
}

GN_SHADERS(use_no_uniforms, void, varyings, vertex_without_uniforms, fragment_without_uniforms);

static void varyings_are_a_struct(void **state)
{
    gn_pipeline p = new_pipeline();

    p.program.interpolation[0] = GN_NOPERSPECTIVE;
    p.raster.topology = GN_TRIANGLE_STRIP;
    assert_int_equal(use_plain(NULL, &u), GN_NULL_POINTER);
    assert_int_equal(use_plain(&p, NULL), GN_NULL_POINTER);
    assert_int_equal(use_no_uniforms(&p, NULL), GN_OK);
    assert_int_equal(use_plain(&p, &u), GN_OK);
    assert_int_equal(GN_VARYING_COUNT(varyings), VARYINGS);
    assert_int_equal(p.program.varying_count, VARYINGS);
    assert_int_equal(p.program.interpolation[0], GN_SMOOTH);
    assert_int_equal(p.raster.topology, GN_TRIANGLE_STRIP);
    assert_true(p.depth.test_enabled);
    assert_ptr_equal(p.program.uniforms, &u);
    p.raster.topology = GN_TRIANGLES;
    p.program.interpolation[5] = GN_FLAT;
    p.program.interpolation[8] = GN_NOPERSPECTIVE;
    compare(&p, vertex_loop, plain_loop);
}

/* Textures: implicit levels of detail, a bias, a level, a comparison. */

static void lookups(const uniforms *v, const varyings *in, gn_texel_lookup *lookup)
{
    const gn_vec3 at = gn_make3(in->texcoord.x, in->texcoord.y, 0);
    const gn_vec3 direction = gn_make3(in->place.x, in->place.y, in->color.y);

    lookup[0] = gn_lookup_2d(&v->map, &v->sampler, in->texcoord);
    lookup[1] = gn_lookup_bias(gn_lookup_any(&v->cube, &v->sampler, direction), in->color.x);
    lookup[2] = gn_lookup_lod(gn_lookup_2d(&v->map, &v->sampler, in->texcoord), 3 * in->color.y);
    lookup[3] = gn_lookup_compared(gn_lookup_any(&v->shadow, &v->compared, at), in->color.z);
    lookup[4] = gn_lookup_any(&v->map, &v->sampler, at);
}

static gn_vec4 textured_function(const uniforms *v, const varyings *in, gn_fragment *fragment)
{
    const gn_vec4 *texel = fragment->texel;

    (void)v;
    (void)in;
    return gn_add4(gn_add4(gn_scale4(texel[0], 2), gn_scale4(texel[1], 3)),
                   gn_add4(gn_scale4(texel[2], 5), gn_add4(gn_scale4(texel[3], 7), texel[4])));
}

static void textured_loop(const void *values, const gn_fragment_input *in, gn_fragment_output *out)
{
    const uniforms *v = values;
    const float *s = in->varying[7], *t = in->varying[8];
    const gn_lookup cube = {.coordinate = {in->varying[4], in->varying[5], in->varying[1]},
                            .lod = in->varying[0]};
    float lod[GN_LANES], texel[5][4][GN_LANES];
    const gn_lookup level = {.coordinate = {s, t}, .lod_source = GN_LOD_EXPLICIT, .lod = lod};
    const gn_lookup shadow = {.coordinate = {s, t}, .reference = in->varying[2]};

    for (int l = 0; l < GN_LANES; ++l)
        lod[l] = 3 * in->varying[1][l];
    gn_fragment_lookup_2d(in, &v->map, &v->sampler, s, t, texel[0]);
    gn_fragment_lookup(in, &v->cube, &v->sampler, &cube, texel[1]);
    gn_fragment_lookup(in, &v->map, &v->sampler, &level, texel[2]);
    gn_fragment_lookup(in, &v->shadow, &v->compared, &shadow, texel[3]);
    gn_fragment_lookup_2d(in, &v->map, &v->sampler, s, t, texel[4]);
    for (int c = 0; c < 4; ++c)
        for (int l = 0; l < GN_LANES; ++l)
            out->color[c][l] = (texel[0][c][l] * 2 + texel[1][c][l] * 3) +
                               (texel[2][c][l] * 5 + (texel[3][c][l] * 7 + texel[4][c][l]));
}

GN_TEXTURED_SHADERS(use_textures, uniforms, varyings, vertex_function, 5, lookups,
                    textured_function);

static void textures_are_sampled_for_all_lanes(void **state)
{
    gn_pipeline p = new_pipeline();

    assert_int_equal(use_textures(&p, &u), GN_OK);
    compare(&p, vertex_loop, textured_loop);
}

/* Of the textures and samplers that lookups name, each in turn; the pipeline is left as it was. */
static void textures_are_checked_when_used(void **state)
{
    const gn_pipeline before = new_pipeline();
    gn_pipeline p = before;
    uniforms wrong = u;

    wrong.map.level[0].texels = NULL;
    assert_int_equal(use_textures(&p, &wrong), gn_texture_check(&wrong.map));
    assert_int_not_equal(gn_texture_check(&wrong.map), GN_OK);
    wrong.map = u.cube; /* of a lookup in a 2D texture */
    assert_int_equal(use_textures(&p, &wrong), GN_INVALID_ENUM);
    wrong.map = u.map;
    wrong.cube.target = (gn_texture_target)99;
    assert_int_equal(use_textures(&p, &wrong), GN_INVALID_ENUM);
    wrong.cube = u.cube;
    wrong.compared.max_anisotropy = GN_MAX_ANISOTROPY + 1;
    assert_int_equal(use_textures(&p, &wrong), GN_OUT_OF_RANGE);
    assert_memory_equal(&p, &before, sizeof p);
    wrong.compared = u.compared;
    assert_int_equal(use_textures(NULL, &wrong), GN_NULL_POINTER);
    assert_int_equal(use_textures(&p, NULL), GN_NULL_POINTER);
    assert_int_equal(use_textures(&p, &wrong), GN_OK);
}

/* All inputs and outputs of a fragment. */

static gn_vec4 whole_function(const uniforms *v, const varyings *in, gn_fragment *fragment)
{
    (void)v;
    fragment->discard = in->color.x > 0.6f;
    fragment->depth = 0.5f * fragment->depth + 0.25f * in->color.y;
    fragment->sample_mask &= fragment->primitive_id & 1u ? 0xFFFFFFFFu : 5u;
    fragment->color[1] = gn_make4(
        (float)fragment->primitive_id, (float)fragment->covered_samples, fragment->depth,
        (fragment->front_facing ? 1.0f : 2.0f) +
            (float)fragment->sample_id * fragment->sample_position.x + fragment->sample_position.y);
    return fragment->position;
}

static void whole_loop(const void *values, const gn_fragment_input *in, gn_fragment_output *out)
{
    (void)values;
    for (int l = 0; l < GN_LANES; ++l) {
        out->kept &= ~((uint32_t)(in->varying[0][l] > 0.6f) << l);
        out->depth[l] = 0.5f * out->depth[l] + 0.25f * in->varying[1][l];
        out->sample_mask[l] &= in->primitive_id & 1u ? 0xFFFFFFFFu : 5u;
        for (int c = 0; c < 4; ++c)
            out->color[c][l] = in->position[c][l];
        out->color[4][l] = (float)in->primitive_id;
        out->color[5][l] = (float)in->sample_mask[l];
        out->color[6][l] = out->depth[l];
        out->color[7][l] = (in->front_facing ? 1.0f : 2.0f) +
                           (float)in->sample_id * in->sample_position[0] + in->sample_position[1];
    }
}

GN_VERTEX_SHADER(vertices, uniforms, varyings, 0, vertex_function);
GN_FRAGMENT_SHADER(whole_fragments, uniforms, varyings, 2, whole_function);

static void fragments_have_all_inputs_and_outputs(void **state)
{
    gn_pipeline p = new_pipeline();

    use(&p, vertices, whole_fragments);
    p.program.color_count = 2;
    p.program.fragment_reads_position = p.program.fragment_reads_primitive = true;
    p.program.fragment_reads_sample = p.program.fragment_reads_sample_mask = true;
    p.program.fragment_discards = p.program.fragment_writes_depth = true;
    p.program.fragment_writes_sample_mask = true;
    compare(&p, vertex_loop, whole_loop);
}

/* Inputs and outputs that are not switched on are 0 and harmless: runs the function above without
 * its outputs. */
static void bare_loop(const void *values, const gn_fragment_input *in, gn_fragment_output *out)
{
    (void)values;
    for (int l = 0; l < GN_LANES; ++l) {
        for (int c = 0; c < 4; ++c)
            out->color[c][l] = 0;
        out->color[4][l] = (float)in->primitive_id;
        out->color[5][l] = 0;
        out->color[6][l] = 0.5f * 0.0f + 0.25f * in->varying[1][l];
        out->color[7][l] = (in->front_facing ? 1.0f : 2.0f) + 0.5f;
    }
}

static void what_is_not_switched_on_is_zero(void **state)
{
    gn_pipeline p = new_pipeline();

    use(&p, vertices, whole_fragments);
    p.program.color_count = 2;
    compare(&p, vertex_loop, bare_loop);
}

/* Clip distances, and sizes and coordinates of points, with textures and two colours. */

static gn_vec4 clipped_function(const uniforms *v, gn_vertex *vertex, varyings *out)
{
    const gn_vec4 position = vertex_function(v, vertex, out);

    vertex->clip_distance[0] = position.x + 0.7f;
    vertex->clip_distance[2] = 0.6f - position.y;
    vertex->point_size += 3.0f * vertex->attribute[GN_ATTRIBUTE_COLOR].x;
    return position;
}

static void clipped_loop(const void *values, const gn_vertex_input *input, gn_vertex_output *output)
{
    vertex_loop(values, input, output);
    for (int l = 0; l < GN_LANES; ++l) {
        output->clip_distance[0][l] = output->position[0][l] + 0.7f;
        output->clip_distance[2][l] = 0.6f - output->position[1][l];
        if (output->point_size)
            output->point_size[l] += 3.0f * input->attribute[GN_ATTRIBUTE_COLOR][0][l];
    }
}

static gn_vec4 point_function(const uniforms *v, const varyings *in, gn_fragment *fragment)
{
    (void)v;
    (void)in;
    fragment->color[1] = fragment->texel[0];
    return gn_make4(fragment->point_coordinate.x, fragment->point_coordinate.y, 1, 1);
}

static void point_loop(const void *values, const gn_fragment_input *in, gn_fragment_output *out)
{
    const uniforms *v = values;

    gn_fragment_lookup_2d(in, &v->map, &v->sampler, in->varying[7], in->varying[8], out->color + 4);
    for (int l = 0; l < GN_LANES; ++l) {
        out->color[0][l] = in->point_coordinate[0][l];
        out->color[1][l] = in->point_coordinate[1][l];
        out->color[2][l] = out->color[3][l] = 1;
    }
}

static void lookup_one(const uniforms *v, const varyings *in, gn_texel_lookup *lookup)
{
    lookup[0] = gn_lookup_2d(&v->map, &v->sampler, in->texcoord);
}

GN_VERTEX_SHADER(clipped_vertices, uniforms, varyings, 3, clipped_function);
GN_TEXTURED_FRAGMENT_SHADER(point_fragments, uniforms, varyings, 2, 1, lookup_one, point_function);

static void vertices_have_distances_and_sizes(void **state)
{
    for (int points = 0; points < 2; ++points) {
        gn_pipeline p = new_pipeline();

        use(&p, clipped_vertices, point_fragments);
        p.raster.topology = points ? GN_POINTS : GN_TRIANGLES;
        p.raster.point_size = 2;
        p.program.clip_distance_count = 3;
        p.program.vertex_writes_point_size = points;
        p.program.fragment_reads_point_coordinate = true;
        p.program.color_count = 2;
        compare(&p, clipped_loop, point_loop);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(varyings_are_a_struct),
        cmocka_unit_test(textures_are_sampled_for_all_lanes),
        cmocka_unit_test(textures_are_checked_when_used),
        cmocka_unit_test(fragments_have_all_inputs_and_outputs),
        cmocka_unit_test(what_is_not_switched_on_is_zero),
        cmocka_unit_test(vertices_have_distances_and_sizes),
    };

    return cmocka_run_group_tests_name("shader functions", tests, set_up, NULL);
}
