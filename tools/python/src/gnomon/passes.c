/* Draws one view. Normals and labels, and the depths of a picture with smooth edges, have a pass of
 * their own, whose pixels have one sample. */
#include "passes.h"

#include <math.h>
#include <string.h>

/* Keeps a surface from shadowing itself: the map's depths move away from the light by this many
 * times their slope from texel to texel, and by this many of the smallest steps. */
#define SHADOW_FACTOR 2.0f
#define SHADOW_UNITS 4.0f

/* The varying of the ready-made vertex shader that holds the normal's x. */
enum { VARYING_NORMAL = 6 };

/* The most bands of rows that a clear or a sum over pixels is divided into: more than threads, so
 * that a thread that is late takes fewer. */
#define BANDS_A_THREAD 4

/* What the geometry pass' shaders read; the ready-made one reads the beginning. */
typedef struct geometry_uniforms {
    gn_lit_uniforms lit;
    const views_part *part;
    int normals, labels; /* the first channels of their colours; -1: not drawn */
} geometry_uniforms;

static uint32_t samples(const views_job *job)
{
    return job->smooth_edges ? GN_SAMPLES : 1;
}

static bool has_geometry(const views_job *job)
{
    return job->normals || job->labels_drawn || (job->depth && (!job->color || job->smooth_edges));
}

static bool has_vertex_normals(const views_part *part)
{
    return part->mesh.attribute[GN_ATTRIBUTE_NORMAL].data != NULL;
}

static void corner(const gn_mesh *mesh, size_t i, double result[3])
{
    const float *const positions = mesh->attribute[GN_ATTRIBUTE_POSITION].data;
    const uint32_t *const indices = mesh->indices;

    for (int c = 0; c < 3; ++c)
        result[c] = positions[3 * (size_t)indices[i] + c];
}

/* The normal of a face, in the space of the normal matrix; 0 for a face without area. Products of
 * floats do not overflow in double precision. */
static void face_normal(const geometry_uniforms *u, uint32_t face, float result[3])
{
    double a[3], b[3], c[3], n[3], turned[3];

    corner(&u->part->mesh, 3 * (size_t)face, a);
    corner(&u->part->mesh, 3 * (size_t)face + 1, b);
    corner(&u->part->mesh, 3 * (size_t)face + 2, c);
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;

        n[i] = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
    }
    for (int i = 0; i < 3; ++i)
        turned[i] = u->lit.normal_matrix.m[0][i] * n[0] + u->lit.normal_matrix.m[1][i] * n[1] +
                    u->lit.normal_matrix.m[2][i] * n[2];
    const double length =
        sqrt(turned[0] * turned[0] + turned[1] * turned[1] + turned[2] * turned[2]);
    for (int i = 0; i < 3; ++i)
        result[i] = length > 0.0 ? (float)(turned[i] / length) : 0.0f;
}

/* Square roots and quotients are exact to the last bit on every machine. The loops are written so
 * that compilers turn them into vectors. */
static void write_normals(const geometry_uniforms *u, const gn_fragment_input *in,
                          float (*color)[GN_LANES])
{
    if (!has_vertex_normals(u->part)) {
        float n[3];

        face_normal(u, in->primitive_id, n);
        for (int c = 0; c < 3; ++c)
            for (int l = 0; l < GN_LANES; ++l)
                color[c][l] = n[c];
        return;
    }
    const float *const x = in->varying[VARYING_NORMAL], *const y = in->varying[VARYING_NORMAL + 1];
    const float *const z = in->varying[VARYING_NORMAL + 2];

    for (int l = 0; l < GN_LANES; ++l) {
        const float square = x[l] * x[l] + y[l] * y[l] + z[l] * z[l];
        const float scale = 1.0f / sqrtf(square > 0.0f ? square : 1.0f);

        color[0][l] = x[l] * scale;
        color[1][l] = y[l] * scale;
        color[2][l] = z[l] * scale;
    }
}

static void write_labels(const geometry_uniforms *u, const gn_fragment_input *in,
                         float color[GN_LANES])
{
    const views_part *const part = u->part;
    const uint32_t face = in->primitive_id;
    const int32_t label = part->labels ? part->labels[face] : part->first_label + (int32_t)face;
    float bits;

    memcpy(&bits, &label, sizeof bits);
    for (int l = 0; l < GN_LANES; ++l)
        color[l] = bits;
}

static void shade_geometry(const void *uniforms, const gn_fragment_input *in,
                           gn_fragment_output *out)
{
    const geometry_uniforms *const u = uniforms;

    if (u->normals >= 0)
        write_normals(u, in, out->color + u->normals);
    if (u->labels >= 0)
        write_labels(u, in, out->color[u->labels]);
}

static bool fail(passes_fault *fault, gn_status status, const char *words)
{
    fault->status = status;
    fault->words = words;
    return false;
}

static bool draw(passes_tools *tools, const gn_target *target, const gn_pipeline *pipeline,
                 const gn_mesh *mesh, passes_fault *fault)
{
    const gn_status status = gn_draw(target, pipeline, mesh, &tools->workspace);

    if (status == GN_OK)
        return true;
    return fail(fault, status, gn_draw_fault(target, pipeline, mesh, &tools->workspace));
}

/* The picture of a view in an array of pictures; absent for a null array. */
static gn_surface picture(const views_job *job, void *pixels, gn_format format, uint32_t view)
{
    const size_t size = gn_format_size(format) * job->width * job->height;

    return gn_surface_top_down(pixels ? (unsigned char *)pixels + size * view : NULL,
                               pixels ? format : GN_FORMAT_NONE, job->width, job->height);
}

/* The surfaces that one thread draws its views to, with all samples. */
static gn_surface own_surface(const views_job *job, void *pixels, gn_format format, bool is_smooth)
{
    const gn_surface image = gn_surface_top_down(pixels, format, job->width, job->height);

    return is_smooth ? gn_surface_multisampled(&image) : image;
}

static void set_state(gn_pipeline *pipeline, const views_job *job)
{
    pipeline->raster = job->raster;
    pipeline->depth.test_enabled = true;
    if (job->reversed) {
        pipeline->depth.function = GN_GREATER;
        pipeline->depth.clip_depth = GN_ZERO_TO_ONE;
    }
}

static float farthest(const views_job *job)
{
    return job->reversed ? 0.0f : 1.0f;
}

static gn_mat4 clip_from_model(const views_job *job, uint32_t view, const views_part *part)
{
    gn_mat4 result;

    gn_mat4_multiply(&job->camera[view].clip_from_world, &part->world_from_model, &result);
    return result;
}

/* What is done to bands of a picture's rows, by all threads of the pool. Rows of arrays count from
 * the top and those of surfaces from the bottom, which is no matter where each is done once. */
typedef struct band_work {
    void (*work)(const struct band_work *w, uint32_t first, uint32_t count);
    const views_job *job;
    uint32_t view, bands;
    const gn_target *target; /* for clears */
    const float *depth;      /* for distances */
    const gn_surface *to, *from;
} band_work;

static void run_band(void *context, uint32_t band)
{
    const band_work *const w = context;
    const uint64_t height = w->job->height;
    const uint32_t first = (uint32_t)(height * band / w->bands);

    w->work(w, first, (uint32_t)(height * (band + 1) / w->bands) - first);
}

static void in_bands(band_work *w, const passes_tools *tools)
{
    const uint32_t most = tools->pool ? tools->threads * BANDS_A_THREAD : 1;

    w->bands = most < w->job->height ? most : w->job->height;
    if (tools->pool)
        thread_pool_run(tools->pool, run_band, w, w->bands);
    else
        run_band(w, 0);
}

static void clear_colors(const band_work *w, uint32_t first, uint32_t count)
{
    const float *const back = w->job->background;
    const gn_surface color = gn_surface_rows(&w->target->color[0], first, count);
    const gn_surface depth = gn_surface_rows(&w->target->depth, first, count);

    gn_clear_color(&color, back[0], back[1], back[2], back[3]);
    gn_clear_depth(&depth, farthest(w->job));
}

static void clear_geometry(const band_work *w, uint32_t first, uint32_t count)
{
    const views_job *const job = w->job;
    const size_t pixel = (size_t)job->width * (job->height * (size_t)w->view + first);
    const size_t pixels = (size_t)job->width * count;
    const gn_surface depth = gn_surface_rows(&w->target->depth, first, count);

    gn_clear_depth(&depth, farthest(job));
    if (job->normals)
        memset(job->normals + 3 * pixel, 0, 3 * sizeof(float) * pixels);
    if (job->labels_drawn)
        memset(job->labels_drawn + pixel, 0xFF, sizeof(int32_t) * pixels);
}

/* Writes the distances of a view's pixels. */
static void write_distances(const band_work *w, uint32_t first, uint32_t count)
{
    const views_job *const job = w->job;
    const views_camera *const c = &job->camera[w->view];
    const double scale = job->reversed ? 1.0 : 2.0, offset = job->reversed ? 0.0 : -1.0;
    const float *const depth = w->depth + (size_t)job->width * first;
    const float nothing = farthest(job);
    const size_t pixels = (size_t)job->width * count;
    float *const distance =
        job->depth + (size_t)job->width * (job->height * (size_t)w->view + first);

    for (size_t i = 0; i < pixels; ++i) {
        const double ndc = scale * depth[i] + offset;
        const float d =
            (float)((ndc * c->w - c->z) / (c->z_per_distance - ndc * c->w_per_distance));

        distance[i] = depth[i] == nothing ? 0.0f : d;
    }
}

static void resolve(const band_work *w, uint32_t first, uint32_t count)
{
    const gn_surface to = gn_surface_rows(w->to, first, count),
                     from = gn_surface_rows(w->from, first, count);

    gn_resolve(&to, &from);
}

/* All passes take positions from the library's vertex shaders, so that their depths are equal. */
static bool draw_geometry_of(const views_job *job, uint32_t view, const views_part *part,
                             const gn_target *target, passes_tools *tools, passes_fault *fault)
{
    const gn_color_uniforms color_uniforms = {clip_from_model(job, view, part)};
    geometry_uniforms uniforms;
    gn_pipeline pipeline;

    memset(&uniforms, 0, sizeof uniforms);
    memset(&pipeline, 0, sizeof pipeline);
    set_state(&pipeline, job);
    gn_use_depth_only(&pipeline, &color_uniforms);
    if (!job->normals && !job->labels_drawn)
        return draw(tools, target, &pipeline, &part->mesh, fault);
    uniforms.lit.clip_from_model = color_uniforms.clip_from_model;
    uniforms.lit.world_from_model = part->world_from_model;
    uniforms.lit.normal_matrix = part->normal_matrix;
    if (job->normals_of_camera)
        gn_mat3_multiply(&job->camera[view].camera_from_world, &part->normal_matrix,
                         &uniforms.lit.normal_matrix);
    uniforms.part = part;
    uniforms.normals = job->normals ? 0 : -1;
    uniforms.labels = !job->labels_drawn ? -1 : job->normals ? 4 : 0;
    if (job->normals && has_vertex_normals(part))
        gn_use_normal_color(&pipeline, &uniforms.lit);
    pipeline.program.fragment_shader = shade_geometry;
    pipeline.program.uniforms = &uniforms;
    pipeline.program.color_count = job->normals && job->labels_drawn ? 2 : 1;
    pipeline.program.fragment_reads_primitive = true;
    pipeline.program.fragment_writes_all_colors = true;
    return draw(tools, target, &pipeline, &part->mesh, fault);
}

/* Draws normals and labels, or only depth if neither is wanted. */
static bool draw_geometry(const views_job *job, uint32_t view, passes_tools *tools,
                          passes_fault *fault)
{
    const gn_surface labels = picture(job, job->labels_drawn, GN_FORMAT_R32F, view);
    gn_target target;
    band_work work = {clear_geometry, job, view, 0, &target, tools->depth, NULL, NULL};

    memset(&target, 0, sizeof target);
    target.depth = own_surface(job, tools->depth, GN_FORMAT_D32F, false);
    target.color[0] = job->normals ? picture(job, job->normals, GN_FORMAT_RGB32F, view) : labels;
    if (job->normals)
        target.color[1] = labels;
    in_bands(&work, tools);
    for (uint32_t i = 0; i < job->part_count; ++i)
        if (!draw_geometry_of(job, view, &job->part[i], &target, tools, fault))
            return false;
    return true;
}

static gn_status use_shader(gn_pipeline *pipeline, views_shader shader,
                            const gn_unlit_uniforms *unlit, const gn_lit_uniforms *lit)
{
    switch (shader) {
    case VIEWS_FLAT:
        return gn_use_flat(pipeline, lit);
    case VIEWS_GOURAUD:
        return gn_use_gouraud(pipeline, lit);
    case VIEWS_TOON:
        return gn_use_toon(pipeline, lit);
    case VIEWS_PHONG:
        return gn_use_phong(pipeline, lit);
    case VIEWS_BLINN_PHONG:
        return gn_use_blinn_phong(pipeline, lit);
    case VIEWS_NORMAL_COLOR:
        return gn_use_normal_color(pipeline, lit);
    default:
        return gn_use_unlit(pipeline, unlit);
    }
}

/* Four texels of a shadow map are compared and the results mixed; places beyond it are lit. */
static void set_shadow(gn_shadow *shadow, const views_job *job, gn_texture *map)
{
    gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_D32F, job->shadow_size, job->shadow_size, 1, 1,
                      job->shadow, map);
    shadow->map = map;
    shadow->clip_from_world = job->shadow_from_world;
    shadow->sampler.wrap_s = shadow->sampler.wrap_t = GN_WRAP_CLAMP_TO_BORDER;
    shadow->sampler.minify = GN_MINIFY_LINEAR;
    shadow->sampler.compare = GN_LESS_OR_EQUAL;
    for (int i = 0; i < 4; ++i)
        shadow->sampler.border[i] = 1.0f;
}

/* Copies the lights, turned to a view. */
static void set_lights(gn_light light[GN_MAX_LIGHTS], const views_job *job, uint32_t view)
{
    const gn_vec3 forward = job->camera[view].forward;

    memcpy(light, job->light, sizeof job->light);
    for (uint32_t i = 0; i < job->light_count; ++i)
        if (job->light_follows >> i & 1)
            light[i].direction = (gn_vec3){-forward.x, -forward.y, -forward.z};
}

static bool draw_colors_of(const views_job *job, uint32_t view, const views_part *part,
                           const gn_target *target, passes_tools *tools, passes_fault *fault)
{
    gn_light light[GN_MAX_LIGHTS];
    gn_unlit_uniforms unlit;
    gn_lit_uniforms lit;
    gn_pipeline pipeline;
    gn_texture map;

    memset(&unlit, 0, sizeof unlit);
    memset(&lit, 0, sizeof lit);
    memset(&pipeline, 0, sizeof pipeline);
    unlit.clip_from_model = lit.clip_from_model = clip_from_model(job, view, part);
    unlit.map = part->material.diffuse_map;
    unlit.sampler = part->material.sampler;
    lit.world_from_model = part->world_from_model;
    lit.normal_matrix = part->normal_matrix;
    lit.eye = job->camera[view].eye;
    set_lights(light, job, view);
    lit.light = light[0];
    lit.more_lights = light + 1;
    lit.more_light_count = job->light_count - 1;
    if (job->shadow)
        set_shadow(&lit.shadow, job, &map);
    lit.material = part->material;
    set_state(&pipeline, job);
    const gn_status status = use_shader(&pipeline, part->shader, &unlit, &lit);
    if (status != GN_OK)
        return fail(fault, status, NULL);
    return draw(tools, target, &pipeline, &part->mesh, fault);
}

static bool draw_colors(const views_job *job, uint32_t view, passes_tools *tools,
                        passes_fault *fault)
{
    const gn_surface result = picture(job, job->color, GN_FORMAT_RGBA8, view);
    gn_target target;
    band_work work = {clear_colors, job, view, 0, &target, tools->depth, &result, &target.color[0]};

    memset(&target, 0, sizeof target);
    target.color[0] =
        job->smooth_edges ? own_surface(job, tools->color, GN_FORMAT_RGBA8, true) : result;
    target.depth = own_surface(job, tools->depth, GN_FORMAT_D32F, job->smooth_edges);
    in_bands(&work, tools);
    for (uint32_t i = 0; i < job->part_count; ++i)
        if (!draw_colors_of(job, view, &job->part[i], &target, tools, fault))
            return false;
    work.work = resolve;
    if (job->smooth_edges)
        in_bands(&work, tools);
    return true;
}

bool passes_draw(const views_job *job, uint32_t view, passes_tools *tools, passes_fault *fault)
{
    band_work distances = {write_distances, job, view, 0, NULL, tools->depth, NULL, NULL};

    if (has_geometry(job) && !draw_geometry(job, view, tools, fault))
        return false;
    if (has_geometry(job) && job->depth)
        in_bands(&distances, tools);
    if (job->color && !draw_colors(job, view, tools, fault))
        return false;
    if (!has_geometry(job) && job->depth)
        in_bands(&distances, tools);
    return true;
}

bool passes_are_empty(const views_job *job, const passes_tools *tools)
{
    const size_t count = (size_t)job->width * job->height * (job->color ? samples(job) : 1);
    const float nothing = farthest(job);

    for (size_t i = 0; i < count; ++i)
        if (tools->depth[i] != nothing)
            return false;
    return true;
}

bool passes_draw_shadow(const views_job *job, passes_tools *tools, passes_fault *fault)
{
    gn_target target;

    memset(&target, 0, sizeof target);
    target.depth =
        gn_surface_bottom_up(job->shadow, GN_FORMAT_D32F, job->shadow_size, job->shadow_size);
    gn_clear_depth(&target.depth, 1.0f);
    for (uint32_t i = 0; i < job->part_count; ++i) {
        gn_color_uniforms uniforms;
        gn_pipeline pipeline;

        memset(&pipeline, 0, sizeof pipeline);
        gn_mat4_multiply(&job->shadow_from_world, &job->part[i].world_from_model,
                         &uniforms.clip_from_model);
        gn_use_depth_only(&pipeline, &uniforms);
        pipeline.depth.test_enabled = true;
        pipeline.raster.polygon_offset.enabled = true;
        pipeline.raster.polygon_offset.factor = SHADOW_FACTOR;
        pipeline.raster.polygon_offset.units = SHADOW_UNITS;
        if (!draw(tools, &target, &pipeline, &job->part[i].mesh, fault))
            return false;
    }
    return true;
}
