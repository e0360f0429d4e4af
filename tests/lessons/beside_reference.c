/* Linked into a lesson by -Wl,--wrap=main,--wrap=gn_draw and so on (tests/lessons/lessons.mk):
 * compares what the lesson draws with what OSMesa draws, bit for bit. Draws of ready-made shaders
 * are recorded as a scene. When the lesson clears the target again, or ends, the reference draws
 * that scene, and the lesson's own memory is compared with it. Prints one line at the end of the
 * program; the program ends with status 3 if a pixel differs. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "osmesa.h"

int __real_main(int argc, char **argv);
int __wrap_main(int argc, char **argv);
gn_status __real_gn_draw(const gn_target *target, const gn_pipeline *pipeline, const gn_mesh *mesh,
                         gn_workspace *workspace);
gn_status __real_gn_clear_color(const gn_surface *surface, float red, float green, float blue,
                                float alpha);
gn_status __real_gn_clear_depth(const gn_surface *surface, float depth);
gn_status __wrap_gn_draw(const gn_target *target, const gn_pipeline *pipeline, const gn_mesh *mesh,
                         gn_workspace *workspace);
gn_status __wrap_gn_clear_color(const gn_surface *surface, float red, float green, float blue,
                                float alpha);
gn_status __wrap_gn_clear_depth(const gn_surface *surface, float depth);

/* The last clear of each surface, and the targets that have been drawn to since. */
enum { SURFACES = 16, TARGETS = 8 };

typedef struct cleared {
    const void *pixels;
    float color[4];
    float depth;
} cleared;

typedef struct recorded {
    gn_target target;
    scene *scene;
} recorded;

static cleared surfaces[SURFACES];
static recorded targets[TARGETS];
static reference *mesa;
static char fault[512];

static struct {
    unsigned int targets, draws, other_draws;
    uint64_t color, depth, pixels;
} sums;

static void fail(const char *what)
{
    fprintf(stderr, "beside_reference: %s\n", what);
    exit(4);
}

/* ---- Comparison ---- */

/* A surface's rows, from the bottom up, tightly packed. */
static void copy_surface(const gn_surface *surface, void *to)
{
    const size_t row = surface->width * gn_format_size(surface->format);

    for (uint32_t y = 0; y < surface->height && surface->format != GN_FORMAT_NONE; ++y)
        memcpy((char *)to + y * row,
               (const char *)surface->pixels + (ptrdiff_t)y * surface->row_stride, row);
}

static void compare(recorded *r)
{
    scene_frame ours;
    scene_frame theirs;

    if (r->scene == NULL)
        return;
    if (mesa == NULL && fault[0] == '\0')
        mesa = reference_create(REFERENCE_PINNED, fault, sizeof fault);
    if (mesa != NULL) {
        if (!scene_frame_allocate(&ours, r->scene) || !scene_frame_allocate(&theirs, r->scene))
            fail("not enough memory");
        if (!reference_draw(mesa, r->scene, &theirs, fault, sizeof fault))
            fail(fault);
        copy_surface(&r->target.color[0], ours.color);
        copy_surface(&r->target.depth, ours.depth);
        const scene_difference d = scene_compare(r->scene, &ours, &theirs);
        sums.targets += 1;
        sums.draws += (unsigned int)r->scene->draw_count;
        sums.color += d.color_pixels;
        sums.depth += d.depth_pixels;
        sums.pixels += (uint64_t)r->scene->width * r->scene->height;
        scene_frame_free(&ours);
        scene_frame_free(&theirs);
    }
    scene_free(r->scene);
    r->scene = NULL;
}

static void finish(void)
{
    for (int i = 0; i < TARGETS; ++i)
        compare(&targets[i]);
    if (fault[0] != '\0')
        printf("reference: absent: %s\n", fault);
    else
        printf("reference: %u draws to %u targets: colour of %" PRIu64 ", depth of %" PRIu64
               " of %" PRIu64 " pixels differ; %u draws of other shaders\n",
               sums.draws, sums.targets, sums.color, sums.depth, sums.pixels, sums.other_draws);
}

/* Not at exit: Mesa would have ended before. */
int __wrap_main(int argc, char **argv)
{
    const int status = __real_main(argc, argv);

    finish();
    return status != 0 ? status : sums.color + sums.depth > 0 ? 3 : 0;
}

/* ---- Recording ---- */

static cleared *cleared_surface(const void *pixels)
{
    for (int i = 0; i < SURFACES; ++i) {
        if (surfaces[i].pixels == NULL)
            surfaces[i].pixels = pixels;
        if (surfaces[i].pixels == pixels)
            return &surfaces[i];
    }
    fail("too many surfaces");
    return NULL;
}

/* Compares the targets that show this surface, before it is cleared. */
static void before_clear(const void *pixels)
{
    for (int i = 0; i < TARGETS; ++i)
        if (targets[i].target.color[0].pixels == pixels || targets[i].target.depth.pixels == pixels)
            compare(&targets[i]);
}

gn_status __wrap_gn_clear_color(const gn_surface *surface, float red, float green, float blue,
                                float alpha)
{
    const float color[4] = {red, green, blue, alpha};

    before_clear(surface->pixels);
    memcpy(cleared_surface(surface->pixels)->color, color, sizeof color);
    return __real_gn_clear_color(surface, red, green, blue, alpha);
}

gn_status __wrap_gn_clear_depth(const gn_surface *surface, float depth)
{
    before_clear(surface->pixels);
    cleared_surface(surface->pixels)->depth = depth;
    return __real_gn_clear_depth(surface, depth);
}

static recorded *target_of(const gn_target *target)
{
    recorded *unused = NULL;

    for (int i = 0; i < TARGETS; ++i) {
        recorded *r = &targets[i];
        if (r->scene != NULL && r->target.color[0].pixels == target->color[0].pixels &&
            r->target.depth.pixels == target->depth.pixels &&
            r->target.color[0].height == target->color[0].height)
            return r;
        if (r->scene == NULL)
            unused = r;
    }
    if (unused == NULL)
        fail("too many targets");
    const gn_surface *any = target->color[0].format ? &target->color[0] : &target->depth;
    unused->target = *target;
    unused->scene =
        scene_create(any->width, any->height, target->color[0].format, target->depth.format);
    if (target->color[0].format)
        memcpy(unused->scene->clear_color, cleared_surface(target->color[0].pixels)->color,
               sizeof unused->scene->clear_color);
    if (target->depth.format)
        unused->scene->clear_depth = cleared_surface(target->depth.pixels)->depth;
    return unused;
}

/* An attribute's components, tightly packed. */
static void record_attribute(scene_draw *draw, const gn_mesh *mesh, uint32_t a)
{
    const gn_attribute *from = &mesh->attribute[a];
    const size_t size = from->components * sizeof(float);
    const size_t stride = from->stride ? from->stride : size;
    char *packed;

    if (from->data == NULL)
        return;
    packed = malloc(mesh->vertex_count * size);
    if (packed == NULL)
        fail("not enough memory");
    for (size_t i = 0; i < mesh->vertex_count; ++i)
        memcpy(packed + i * size, (const char *)from->data + i * stride, size);
    scene_set_attribute(draw, (gn_shader_attribute)a, (const float *)(const void *)packed,
                        from->components, mesh->vertex_count);
    free(packed);
}

static void record_indices(scene_draw *draw, const gn_mesh *mesh)
{
    const size_t size = scene_index_size(mesh->index_format);
    const uint32_t count = mesh->first + mesh->count;
    uint32_t *indices;

    if (size == 0)
        return;
    indices = malloc(count * sizeof *indices);
    if (indices == NULL)
        fail("not enough memory");
    for (uint32_t i = 0; i < count; ++i)
        indices[i] = scene_element(mesh->indices, size, i);
    scene_set_indices(draw, indices, count, mesh->index_format);
    free(indices);
}

/* A 2D texture whose levels lie one after the other; the caller frees its texels. */
static gn_texture packed_texture(const gn_texture *from)
{
    gn_texture to = *from;
    const size_t pixel = gn_format_size(from->format);
    char *next = malloc(gn_texture_memory_size(from->target, from->format, from->width,
                                               from->height, 1, from->level_count));

    if (next == NULL)
        fail("not enough memory");
    scene_pack_texture(&to, next);
    for (uint32_t level = 0; level < scene_level_count(from); ++level) {
        const scene_extent extent = scene_level_extent(from, level);

        for (uint32_t y = 0; y < extent.height; ++y, next += extent.width * pixel)
            memcpy(next,
                   (const char *)from->level[level].texels +
                       (ptrdiff_t)y * from->level[level].row_stride,
                   extent.width * pixel);
    }
    return to;
}

static void record_texture(scene_draw *draw, const gn_texture *texture)
{
    if (texture == NULL)
        return;
    const gn_texture packed = packed_texture(texture);
    scene_set_levels(draw, &packed);
    free((void *)(uintptr_t)packed.level[0].texels);
}

static void record_map(scene_draw *draw, scene_map map, const gn_texture *texture)
{
    if (texture == NULL)
        return;
    const gn_texture packed = packed_texture(texture);
    scene_set_map(draw, map, &packed);
    free((void *)(uintptr_t)packed.level[0].texels);
}

static void record_lit(scene_draw *draw, const gn_lit_uniforms *u)
{
    scene_light *light = &draw->uniforms.light;
    scene_surface *surface = &draw->surface;

    light->clip_from_model = u->clip_from_model;
    light->normal_matrix = u->normal_matrix;
    light->light_direction = u->light.direction;
    light->ambient = u->light.ambient;
    light->diffuse = u->light.diffuse;
    surface->world_from_model = u->world_from_model;
    surface->eye = u->eye;
    surface->has_point_light = u->light.kind == GN_LIGHT_POINT;
    surface->has_spot_light = u->light.kind == GN_LIGHT_SPOT;
    surface->light_range = u->light.range;
    surface->cone[0] = u->light.inner_cosine;
    surface->cone[1] = u->light.outer_cosine;
    surface->more_light_count = u->more_light_count;
    for (uint32_t i = 0; i < u->more_light_count; ++i)
        surface->more_lights[i] = u->more_lights[i];
    surface->alpha_cutoff = u->material.alpha_cutoff;
    surface->light_position = u->light.position;
    surface->attenuation[0] = u->light.constant;
    surface->attenuation[1] = u->light.linear;
    surface->attenuation[2] = u->light.quadratic;
    surface->exponent = u->material.exponent;
    surface->bands = u->material.bands;
    surface->normal_space = u->material.normal_space;
    surface->shadow_sampler = u->shadow.sampler;
    surface->shadow_from_world = u->shadow.clip_from_world;
    draw->specular = u->material.specular;
    draw->uniforms.sampler = u->material.sampler;
    record_texture(draw, u->material.diffuse_map);
    record_map(draw, SCENE_NORMAL_MAP, u->material.normal_map);
    record_map(draw, SCENE_SPECULAR_MAP, u->material.specular_map);
    record_map(draw, SCENE_GLOW_MAP, u->material.glow_map);
    record_map(draw, SCENE_SHADOW_MAP, u->shadow.map);
}

static bool has_shaders_of(const gn_pipeline *pipeline, const gn_pipeline *known)
{
    return pipeline->program.vertex_shader == known->program.vertex_shader &&
           pipeline->program.fragment_shader == known->program.fragment_shader;
}

/* The shader of a draw that uses gn_lit_uniforms; SCENE_SHADER_COUNT if it is none of them. */
static scene_shader lit_shader(const gn_pipeline *pipeline)
{
    static const struct {
        scene_shader shader;
        gn_status (*use)(gn_pipeline *, const gn_lit_uniforms *);
    } lit[] = {{SCENE_FACES, gn_use_flat},
               {SCENE_GOURAUD, gn_use_gouraud},
               {SCENE_TOON, gn_use_toon},
               {SCENE_MAPPED_PHONG, gn_use_phong},
               {SCENE_BLINN_PHONG, gn_use_blinn_phong},
               {SCENE_NORMAL_COLOR, gn_use_normal_color}};
    static const gn_lit_uniforms none;

    for (size_t i = 0; i < sizeof lit / sizeof *lit; ++i) {
        gn_pipeline known = {.depth.test_enabled = false};

        if (lit[i].use(&known, &none) == GN_OK && has_shaders_of(pipeline, &known))
            return lit[i].shader;
    }
    return SCENE_SHADER_COUNT;
}

/* Fills in shader and uniforms; returns false for a shader that is not ready-made. */
static bool record_shader(scene_draw *draw, const gn_pipeline *pipeline)
{
    static const gn_color_uniforms color;
    static const gn_unlit_uniforms unlit;
    gn_pipeline known[3] = {{.depth.test_enabled = false},
                            {.depth.test_enabled = false},
                            {.depth.test_enabled = false}};
    const void *u = pipeline->program.uniforms;

    gn_use_vertex_color(&known[0], &color);
    gn_use_depth_only(&known[1], &color);
    gn_use_unlit(&known[2], &unlit);
    if (has_shaders_of(pipeline, &known[0]) || has_shaders_of(pipeline, &known[1])) {
        draw->shader = has_shaders_of(pipeline, &known[0]) ? SCENE_VERTEX_COLOR : SCENE_DEPTH_ONLY;
        draw->uniforms.light.clip_from_model = ((const gn_color_uniforms *)u)->clip_from_model;
        return true;
    }
    if (has_shaders_of(pipeline, &known[2])) {
        draw->shader = SCENE_UNLIT;
        draw->uniforms.light.clip_from_model = ((const gn_unlit_uniforms *)u)->clip_from_model;
        draw->uniforms.sampler = ((const gn_unlit_uniforms *)u)->sampler;
        record_texture(draw, ((const gn_unlit_uniforms *)u)->map);
        return true;
    }
    draw->shader = lit_shader(pipeline);
    if (draw->shader == SCENE_SHADER_COUNT)
        return false;
    record_lit(draw, u);
    if (draw->shader == SCENE_GOURAUD && ((const gn_lit_uniforms *)u)->material.diffuse_map)
        draw->shader = SCENE_TEXTURED_GOURAUD;
    return true;
}

static bool record(const gn_target *target, const gn_pipeline *pipeline, const gn_mesh *mesh)
{
    recorded *r = target_of(target);
    scene_draw *draw = scene_add_draw(r->scene);

    draw->state = *pipeline;
    if (!record_shader(draw, pipeline)) {
        scene_free(r->scene); /* the target shows what the reference cannot draw */
        r->scene = NULL;
        return false;
    }
    for (uint32_t a = 0; a <= GN_ATTRIBUTE_TANGENT; ++a)
        record_attribute(draw, mesh, a);
    record_indices(draw, mesh);
    draw->mesh.first = mesh->first;
    draw->mesh.count = mesh->count;
    return true;
}

gn_status __wrap_gn_draw(const gn_target *target, const gn_pipeline *pipeline, const gn_mesh *mesh,
                         gn_workspace *workspace)
{
    const gn_status status = __real_gn_draw(target, pipeline, mesh, workspace);

    if (status == GN_OK && !record(target, pipeline, mesh))
        ++sums.other_draws;
    return status;
}
