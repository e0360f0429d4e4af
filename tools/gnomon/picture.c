/* From options and a model file to a scene. */
#include "picture.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "image.h"
#include "report.h"

/* A light over the viewer's shoulder, and enough from everywhere to see the rest by. */
#define AMBIENT 0.25f
#define DIFFUSE 0.75f

/* "DIRECTORY OF MODEL/name", allocated; an absolute name as it is. Backslashes, as some
 * exporters write, are slashes. Null where there is no memory. */
static char *beside_model(const char *model_path, const char *name)
{
    const char *slash = strrchr(model_path, '/');
    size_t directory = slash != NULL && name[0] != '/' ? (size_t)(slash - model_path) + 1 : 0;
    char *path = malloc(directory + strlen(name) + 1);
    if (path == NULL)
        return NULL;
    memcpy(path, model_path, directory);
    strcpy(path + directory, name);
    for (char *c = path + directory; *c != '\0'; c++) {
        if (*c == '\\')
            *c = '/';
    }
    return path;
}

size_t picture_stem_length(const char *model_path)
{
    const char *slash = strrchr(model_path, '/');
    const char *name = slash != NULL ? slash + 1 : model_path;
    const char *dot = strrchr(name, '.');
    return dot != NULL && dot > name ? (size_t)(dot - model_path) : strlen(model_path);
}

/* MODEL without its extension + "_diffuse" + tga, png or jpg, allocated, where there is such
 * a file; otherwise null. */
static char *conventional_texture(const char *model_path)
{
    static const char endings[][16] = {"_diffuse.tga", "_diffuse.png", "_diffuse.jpg"};
    size_t stem = picture_stem_length(model_path);
    char *path = malloc(stem + sizeof endings[0]);
    if (path == NULL)
        return NULL;
    memcpy(path, model_path, stem);
    for (int i = 0; i < 3; i++) {
        strcpy(path + stem, endings[i]);
        if (access(path, F_OK) == 0)
            return path;
    }
    free(path);
    return NULL;
}

/* Reads the texture a part is to have. 0 and an image, without texels where there is none to
 * have; otherwise EXIT_FAULT with the reason printed. */
static int read_texture(const options *o, const model_part *part, image *result)
{
    const char *reason = NULL;
    memset(result, 0, sizeof *result);
    if (!part->has_texcoords)
        return 0;
    if (o->texture != NULL) {
        if (image_read(o->texture, result, &reason))
            return 0;
        return report_fault(o->texture, "cannot be read as a texture: %s", reason);
    }
    if (part->texture.bytes != NULL) {
        if (image_decode(part->texture.bytes, part->texture.size, result, &reason))
            return 0;
        return report_fault(o->model,
                            "the texture inside it cannot be read: %s"
                            " (go on without it: --shader gouraud)",
                            reason);
    }
    if (part->texture.name != NULL) {
        char *path = beside_model(o->model, part->texture.name);
        bool good = false;
        reason = "not enough memory";
        if (path != NULL)
            good = image_read(path, result, &reason);
        if (!good)
            report_fault(o->model,
                         "its texture '%s' cannot be read: %s"
                         " (go on without it: --shader gouraud)",
                         path != NULL ? path : part->texture.name, reason);
        free(path);
        return good ? 0 : EXIT_FAULT;
    }
    char *path = conventional_texture(o->model);
    int fault = 0;
    if (path != NULL && !image_read(path, result, &reason))
        fault = report_fault(path,
                             "cannot be read as a texture: %s"
                             " (go on without it: --shader gouraud)",
                             reason);
    free(path);
    return fault;
}

static void whiten(model_part *part)
{
    for (size_t i = 0; i < 4 * (size_t)part->vertex_count; i++)
        part->colors[i] = 1.0f;
}

scene_draw *picture_add_part(scene *s, const model_part *part, scene_shader shader,
                             const camera *view, gn_vec3 light_direction)
{
    scene_draw *draw = scene_add_draw(s);
    gn_light_uniforms *light = &draw->uniforms.light;
    draw->shader = shader;
    draw->state.depth_test = true;
    draw->uniforms.sampler.minify = GN_MINIFY_LINEAR;
    light->clip_from_model = view->clip_from_world;
    gn_mat3_identity(&light->normal_matrix);
    light->light_direction = light_direction;
    light->ambient = (gn_vec3){AMBIENT, AMBIENT, AMBIENT};
    light->diffuse = (gn_vec3){DIFFUSE, DIFFUSE, DIFFUSE};
    scene_set_attribute(draw, GN_ATTRIBUTE_POSITION, part->positions, 3, part->vertex_count);
    scene_set_attribute(draw, GN_ATTRIBUTE_COLOR, part->colors, 4, part->vertex_count);
    if (shader != SCENE_VERTEX_COLOR)
        scene_set_attribute(draw, GN_ATTRIBUTE_NORMAL, part->normals, 3, part->vertex_count);
    if (shader == SCENE_TEXTURED_GOURAUD)
        scene_set_attribute(draw, GN_ATTRIBUTE_TEXCOORD, part->texcoords, 2, part->vertex_count);
    scene_set_indices(draw, part->indices, part->index_count, GN_INDEX_UINT32);
    return draw;
}

static scene_shader untextured_shader(shading asked)
{
    switch (asked) {
    case SHADING_COLOR:
        return SCENE_VERTEX_COLOR;
    case SHADING_FLAT:
        return SCENE_FLAT;
    default:
        return SCENE_GOURAUD;
    }
}

static int add_parts(const options *o, model *m, const camera *view, gn_vec3 light, scene *s)
{
    bool may_have_texture = o->shading == SHADING_AUTOMATIC || o->shading == SHADING_TEXTURED;
    bool textured = false;
    bool has_texcoords = false;
    for (size_t i = 0; i < m->part_count; i++) {
        model_part *part = m->parts + i;
        image texture = {0, 0, NULL};
        has_texcoords = has_texcoords || part->has_texcoords;
        if (may_have_texture) {
            int fault = read_texture(o, part, &texture);
            if (fault != 0)
                return fault;
        }
        if (texture.texels == NULL) {
            picture_add_part(s, part, untextured_shader(o->shading), view, light);
            continue;
        }
        if (!part->has_vertex_colors)
            whiten(part);
        scene_draw *draw = picture_add_part(s, part, SCENE_TEXTURED_GOURAUD, view, light);
        scene_set_texture(draw, texture.texels, texture.width, texture.height, GN_FORMAT_RGBA8);
        image_free(&texture);
        textured = true;
    }
    if (!textured && (o->texture != NULL || o->shading == SHADING_TEXTURED)) {
        if (!has_texcoords)
            return report_fault(o->model, "has no texture coordinates, so no texture fits it");
        return report_fault(o->model,
                            "names no texture and there is no %s beside it;"
                            " give one with --texture FILE",
                            "MODEL_diffuse.tga, .png or .jpg");
    }
    return 0;
}

int picture_describe(const options *o, scene **result)
{
    camera view;
    model m;
    gn_vec3 light = o->light;
    *result = NULL;
    if (o->light_given && gn_vec3_normalize(light, &light) != GN_OK)
        return report_fault("--light", "impossible direction: the vector is zero");
    int fault = model_read(o->model, &m);
    if (fault != 0)
        return fault;
    bounding_sphere sphere = model_bounds(&m);
    fault = camera_place(&o->camera, &sphere, o->width, o->height, &view);
    if (fault == 0 && o->shading == SHADING_FLAT && !model_facet(&m))
        fault = report_fault(o->model, "not enough memory");
    if (fault == 0) {
        scene *s = scene_create(o->width, o->height, GN_FORMAT_RGBA8, GN_FORMAT_D32F);
        memcpy(s->clear_color, o->background, sizeof s->clear_color);
        s->clear_depth = 1.0f;
        s->samples = o->samples;
        fault = add_parts(o, &m, &view, o->light_given ? light : view.light_direction, s);
        for (size_t i = 0; o->wireframe && i < s->draw_count; i++) {
            s->draws[i].state.polygon_mode_front = GN_POLYGON_LINE;
            s->draws[i].state.polygon_mode_back = GN_POLYGON_LINE;
        }
        if (fault == 0)
            *result = s;
        else
            scene_free(s);
    }
    model_free(&m);
    return fault;
}

void picture_print_summary(const char *name, const scene *s)
{
    static const char words[SCENE_SHADER_COUNT][16] = {"vertex colours", "flat", "Gouraud",
                                                       "textured", "Phong"};
    scene_shader most = SCENE_VERTEX_COLOR;
    for (size_t i = 0; i < s->draw_count; i++) {
        if (s->draws[i].shader > most)
            most = s->draws[i].shader;
    }
    unsigned long long triangles = scene_triangle_count(s);
    printf("%s: %ux%u, %llu triangle%s, %s\n", name, (unsigned)s->width, (unsigned)s->height,
           triangles, triangles == 1 ? "" : "s", words[most]);
}
