/* Turns options and a model file into a scene. */
#include "picture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "import.h"
#include "look.h"
#include "output.h"
#include "report.h"

static bool has_any(const part_maps *maps)
{
    for (int i = 0; i < MAP_COUNT; ++i)
        if (maps->images[i].texels != NULL)
            return true;
    return false;
}

/* Checks that named maps can be used: a map's file, or a kind of normals, that no part can take is
 * an error. */
static int check_found(const options *o, const model *m, const part_maps *maps)
{
    bool has_texcoords = false;
    bool has_tangents = false;
    bool has_normals = false;
    bool files = o->normals != NORMALS_ANY;
    const char *name = o->model_count == 1 ? o->model : "every model";
    for (size_t i = 0; i < m->part_count; ++i) {
        has_texcoords = has_texcoords || m->parts[i].has_texcoords;
        has_tangents = has_tangents || m->parts[i].has_tangents;
        has_normals = has_normals || maps[i].images[MAP_NORMAL].texels != NULL;
    }
    for (int i = 0; i < MAP_COUNT; ++i)
        files = files || o->maps[i].file != NULL;
    if (files && !has_texcoords)
        return report_fault(name, "has no texture coordinates, so no texture fits it");
    if (o->normals == NORMALS_TANGENT && !has_tangents)
        return report_fault(name, "has no normals, so it has no tangent space");
    if (o->normals != NORMALS_ANY && !has_normals)
        return report_fault(name,
                            "names no such normal map and there is no MODEL%s.tga, .png or .jpg"
                            " beside it; give one with --normal-map %s:FILE",
                            o->normals == NORMALS_TANGENT ? "_nm_tangent" : "_nm",
                            o->normals == NORMALS_TANGENT ? "tangent" : "world");
    return 0;
}

static int throw_shadows(const model *m, const bounding_sphere *bounds, const look *l,
                         shadow_pass *result)
{
    int fault = shadow_begin(bounds, l->light_direction, result);
    if (fault != 0)
        return fault;
    for (size_t i = 0; i < m->part_count; ++i)
        shadow_add_part(result, m->parts + i);
    return shadow_draw(result, l->options->backend);
}

static int add_parts(const options *o, const camera *view, const bounding_sphere *bounds,
                     imported *from, picture *p)
{
    const model *m = &from->model;
    bool mapped = false;
    look l;
    for (size_t i = 0; i < m->part_count; ++i)
        mapped = mapped || has_any(from->maps + i);
    int fault = check_found(o, m, from->maps);
    p->shading = o->shading;
    if (p->shading == SHADING_AUTOMATIC)
        p->shading = mapped || o->shadows ? SHADING_PHONG : SHADING_GOURAUD;
    if (fault == 0)
        fault = look_choose(o, view, p->shading, &l);
    if (fault == 0 && o->shadows) {
        fault = throw_shadows(m, bounds, &l, &p->shadow);
        l.shadow = &p->shadow;
    }
    for (size_t i = 0; i < m->part_count && fault == 0; ++i) {
        look_add_part(p->scene, &l, m->parts + i, from->maps + i);
        maps_free(from->maps + i);
    }
    return fault;
}

static scene *create_scene(const options *o)
{
    scene *s = scene_create(o->width, o->height, GN_FORMAT_RGBA8, GN_FORMAT_D32F);
    memcpy(s->clear_color, o->background, sizeof s->clear_color);
    s->clear_depth = 1.0f;
    s->samples = o->samples;
    return s;
}

int picture_describe(const options *o, picture *result)
{
    camera view;
    imported from;
    memset(result, 0, sizeof *result);
    int fault = import_models(o, shading_traits_of(o->shading)->maps, &from);
    if (fault != 0)
        return fault;
    bounding_sphere sphere = model_bounds(&from.model);
    fault = camera_place(&o->camera, &sphere, o->width, o->height, &view);
    if (fault == 0) {
        result->scene = create_scene(o);
        fault = add_parts(o, &view, &sphere, &from, result);
    }
    result->maps = from.told;
    from.told.text = NULL;
    import_free(&from);
    if (fault != 0)
        picture_free(result);
    return fault;
}

void picture_free(picture *p)
{
    if (p->scene != NULL)
        scene_free(p->scene);
    maps_told_free(&p->maps);
    shadow_free(&p->shadow);
    memset(p, 0, sizeof *p);
}

void picture_print_summary(FILE *file, const char *name, const picture *p)
{
    unsigned long long triangles = scene_triangle_count(p->scene);
    report_print(file, name);
    fprintf(file, ": %ux%u, %llu triangle%s, %s\n", (unsigned)p->scene->width,
            (unsigned)p->scene->height, triangles, triangles == 1 ? "" : "s",
            shading_traits_of(p->shading)->words);
    if (p->maps.text != NULL) {
        fputs("maps: ", file);
        report_print(file, p->maps.text);
        fputc('\n', file);
    }
}

int picture_check_output(const options *o, const char *output_path, unsigned int formats)
{
    if (output_path == NULL)
        return 0;
    for (size_t i = 0; i < o->model_count; ++i)
        if (output_same_file(output_path, o->models[i].path))
            return report_fault(o->models[i].path, "would be overwritten by the picture");
    for (int i = 0; i < MAP_COUNT; ++i)
        if (o->maps[i].file != NULL && output_same_file(output_path, o->maps[i].file))
            return report_fault(o->maps[i].file, "would be overwritten by the picture");
    return picture_format_check(output_path, formats);
}
