/* Turns options and a model file into a scene. */
#include "picture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "blended.h"
#include "bounds.h"
#include "edges.h"
#include "gradient.h"
#include "look_parts.h"
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
    for (int i = 0; i < OPTIONS_MAP_COUNT; ++i)
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

static int begin_shadows(const contents *c, const look *l, shadow_pass *result)
{
    const model *m = &c->from.model;
    int fault = shadow_begin(&c->bounds, l->light_direction, result);
    for (size_t i = 0; i < m->part_count && fault == 0; ++i)
        shadow_add_part(result, m->parts + i);
    return fault;
}

shading picture_shading(const options *o, const contents *c)
{
    bool mapped = false;
    bool shines = false;
    bool metallic = false;
    for (size_t i = 0; i < c->from.model.part_count; ++i) {
        mapped = mapped || has_any(c->from.maps + i);
        const float *const specular = c->from.model.parts[i].surface.shine.specular;
        shines = shines || specular[0] > 0.0f || specular[1] > 0.0f || specular[2] > 0.0f;
        metallic = metallic || c->from.model.parts[i].surface.is_metallic_roughness;
    }
    return o->shading != SHADING_AUTOMATIC  ? o->shading
           : metallic                       ? SHADING_METALLIC_ROUGHNESS
           : mapped || shines || o->shadows ? SHADING_PHONG
                                            : SHADING_GOURAUD;
}

static void order_blended(picture *p)
{
    blended_order(p->scene->draws + p->blended_first, p->part_of_draw + p->blended_first,
                  p->blended_count);
}

static scene *create_scene(const options *o, bool is_linear)
{
    scene *s = scene_create(o->width, o->height, is_linear ? GN_FORMAT_SRGB8_A8 : GN_FORMAT_RGBA8,
                            GN_FORMAT_D32F);
    memcpy(s->clear_color, o->background, sizeof s->clear_color);
    for (int c = 0; c < 3 && is_linear; ++c)
        s->clear_color[c] = look_to_linear(o->background[c]);
    s->clear_depth = 1.0f;
    s->samples = o->samples;
    return s;
}

/* Warns of lights of the file that a lit picture does without, unless --light replaces them. */
static void warn_of_lights(const options *o, const model *m, const picture *p)
{
    const char *const name = o->model_count == 1 ? o->model : "models";
    const bool is_lit =
        p->look.is_linear || (p->shading >= SHADING_FLAT && p->shading <= SHADING_BLINN_PHONG);
    if (!is_lit || o->light_given)
        return;
    if (m->light_count > 0 && !p->look.is_linear)
        report_warning(name, "its lights are not used: only --shader %s takes them",
                       shading_traits_of(SHADING_METALLIC_ROUGHNESS)->name);
    else if (m->light_count > GN_MAX_LIGHTS)
        report_warning(name, "only the first %d of its %u lights are used", GN_MAX_LIGHTS,
                       (unsigned)m->light_count);
}

/* Notes what the next draw shows. */
static void note_draw(picture *p, draw_kind kind, size_t part)
{
    p->kind_of_draw[p->scene->draw_count] = kind;
    p->part_of_draw[p->scene->draw_count] = part;
}

static void add_grid(const contents *c, picture *p)
{
    if (!p->look.options->grid)
        return;
    note_draw(p, DRAW_GRID, 0);
    grid_add(p->scene, &p->look, &p->ground, &c->bounds);
}

/* Adds the opaque parts or the blended ones. Maps that nothing else needs are freed at once. */
static void add_parts(const options *o, contents *c, bool blends, bool keep, picture *p)
{
    const model *const m = &c->from.model;
    for (size_t i = 0; i < m->part_count; ++i) {
        if (look_blends(o, m->parts + i) != blends)
            continue;
        note_draw(p, DRAW_PART, i);
        scene_draw *const draw = look_add_part(p->scene, &p->look, m->parts + i, c->from.maps + i);
        if (o->edges)
            edges_push_back(draw);
        else if (!keep)
            maps_free(c->from.maps + i);
    }
}

static void add_edges(const options *o, const contents *c, picture *p)
{
    for (size_t i = 0; i < c->from.model.part_count && o->edges; ++i) {
        note_draw(p, DRAW_EDGES, i);
        edges_add(p->scene, &p->look, c->from.model.parts + i, c->from.maps + i);
    }
}

/* One of the two draws of the grid is left out: whether it is behind everything or in front depends
 * on the camera. */
static void show_grid(picture *p, const bounding_sphere *bounds, const gn_transform *turn)
{
    const bool is_above =
        p->look.options->grid && grid_is_seen_from_above(&p->ground, bounds, &p->look, turn);
    for (size_t i = 0; i < p->scene->draw_count; ++i) {
        gn_mesh *const mesh = &p->scene->draws[i].mesh;
        if (p->kind_of_draw[i] == DRAW_GRID)
            mesh->count = (i < p->blended_first) == is_above ? p->scene->draws[i].index_count : 0;
    }
}

static void add_draws(const options *o, contents *c, bool keep, picture *p)
{
    const model *const m = &c->from.model;
    gn_transform still;
    gn_transform_identity(&still);
    if (o->grid)
        p->ground = grid_of(m, &c->bounds, o);
    if (o->background_is_gradient) {
        note_draw(p, DRAW_BACKGROUND, 0);
        gradient_add(p->scene, o->background, o->background_below, p->look.is_linear);
    }
    add_grid(c, p);
    add_parts(o, c, false, keep, p);
    add_edges(o, c, p);
    p->blended_first = p->scene->draw_count;
    add_parts(o, c, true, keep, p);
    p->blended_count = p->scene->draw_count - p->blended_first;
    add_grid(c, p);
    show_grid(p, &c->bounds, &still);
    for (size_t i = 0; i < m->part_count && o->edges && !keep; ++i)
        maps_free(c->from.maps + i);
    order_blended(p);
}

static int begin_picture(const options *o, const camera *view, contents *c, bool keep, picture *p)
{
    const model *m = &c->from.model;
    p->shading = picture_shading(o, c);
    int fault = look_choose(o, view, p->shading, &p->look);
    look_choose_lights(&p->look, m, &c->bounds);
    warn_of_lights(o, m, p);
    if (fault == 0)
        p->scene = create_scene(o, p->look.is_linear);
    if (fault == 0 && o->shadows) {
        fault = begin_shadows(c, &p->look, &p->shadow);
        if (fault == 0)
            fault = shadow_draw(&p->shadow, o->backend);
        if (c->complete_shadows != NULL)
            fault = c->complete_shadows(&p->shadow, fault);
        p->look.shadow = &p->shadow;
    }
    const size_t most = 2 * m->part_count + 4;
    p->part_of_draw = calloc(most, sizeof *p->part_of_draw);
    p->kind_of_draw = calloc(most, sizeof *p->kind_of_draw);
    if (fault == 0 && (p->part_of_draw == NULL || p->kind_of_draw == NULL))
        fault = report_fault("model", "not enough memory");
    if (fault == 0)
        add_draws(o, c, keep, p);
    return fault;
}

int picture_import(const options *o, contents *result)
{
    result->complete_shadows = NULL;
    int fault = import_models(o, shading_traits_of(o->shading)->maps, &result->from);
    if (fault != 0)
        return fault;
    result->bounds = model_bounds(&result->from.model);
    fault = check_found(o, &result->from.model, result->from.maps);
    if (fault == 0)
        fault = picture_check_opened(result, o->output);
    if (fault == 0)
        fault = picture_check_opened(result, o->depth_output);
    if (fault != 0)
        import_free(&result->from);
    return fault;
}

int picture_build(const options *o, contents *c, bool keep, picture *result)
{
    camera view;
    memset(result, 0, sizeof *result);
    int fault = camera_place(&o->camera, &c->bounds, o->width, o->height, &view);
    if (fault != 0)
        return fault;
    fault = begin_picture(o, &view, c, keep, result);
    if (fault == 0 &&
        !maps_told_words(&c->from.told, shading_traits_of(o->shading)->maps, &result->maps))
        fault = report_fault("maps", "not enough memory");
    if (fault != 0)
        picture_free(result);
    return fault;
}

static int move_shadows(picture *p, const contents *c, const gn_transform *turn)
{
    gn_mat4 placed;
    shadow_pass *pass = &p->shadow;
    shadow_free(pass);
    int fault = begin_shadows(c, &p->look, pass);
    for (size_t i = 0; i < c->from.model.part_count && fault == 0; ++i) {
        gn_mat4_multiply(&turn->matrix, &c->from.model.parts[i].world_from_model.matrix, &placed);
        shadow_place(pass, i, &placed);
    }
    if (fault == 0)
        fault = shadow_draw(pass, p->look.options->backend);
    for (size_t i = 0; i < p->scene->draw_count && fault == 0; ++i)
        shadow_apply(pass, p->scene->draws + i);
    return fault;
}

int picture_place(picture *p, const options *o, const contents *c, const gn_transform *turn)
{
    camera view;
    int fault = camera_place(&o->camera, &c->bounds, o->width, o->height, &view);
    if (fault == 0)
        fault = look_choose(o, &view, p->shading, &p->look);
    look_choose_lights(&p->look, &c->from.model, &c->bounds);
    p->look.shadow = o->shadows ? &p->shadow : NULL;
    for (size_t i = 0; i < p->scene->draw_count && fault == 0; ++i) {
        const draw_kind kind = p->kind_of_draw[i];
        gn_transform placed = *turn;
        const model_part *const part = c->from.model.parts + p->part_of_draw[i];
        if (kind <= DRAW_EDGES &&
            gn_transform_compose(turn, &part->world_from_model, &placed) != GN_OK)
            return report_fault("model", "cannot be turned: its place is too far away");
        if (kind != DRAW_BACKGROUND)
            look_place(p->scene->draws + i, &p->look, &placed);
    }
    if (fault == 0) {
        show_grid(p, &c->bounds, turn);
        order_blended(p);
    }
    return fault == 0 && o->shadows ? move_shadows(p, c, turn) : fault;
}

int picture_describe(const options *o, picture *result)
{
    contents c;
    int fault = picture_import(o, &c);
    if (fault != 0)
        return fault;
    fault = picture_build(o, &c, false, result);
    import_free(&c.from);
    return fault;
}

void picture_free(picture *p)
{
    if (p->scene != NULL)
        scene_free(p->scene);
    free(p->maps);
    free(p->part_of_draw);
    free(p->kind_of_draw);
    shadow_free(&p->shadow);
    memset(p, 0, sizeof *p);
}

void picture_print_summary(FILE *file, const char *name, const picture *p)
{
    picture_print_summary_of(file, name, p, picture_primitive_count(p));
}

bool picture_is_part(const picture *p, size_t draw)
{
    return p->kind_of_draw == NULL || p->kind_of_draw[draw] == DRAW_PART;
}

uint64_t picture_primitive_count(const picture *p)
{
    uint64_t count = 0;
    for (size_t i = 0; i < p->scene->draw_count; ++i) {
        scene one = *p->scene;
        one.draws = p->scene->draws + i;
        one.draw_count = 1;
        count += picture_is_part(p, i) ? scene_triangle_count(&one) : 0;
    }
    return count;
}

/* What the draws of a scene are made of, in the singular. */
static const char *primitive_words(const picture *p)
{
    bool has[3] = {false, false, false};
    for (size_t i = 0; i < p->scene->draw_count; ++i) {
        const gn_topology topology = p->scene->draws[i].state.raster.topology;
        if (picture_is_part(p, i))
            has[topology == GN_POINTS ? 2 : topology == GN_LINES ? 1 : 0] = true;
    }
    return !has[1] && !has[2]   ? "triangle"
           : !has[0] && !has[2] ? "line"
           : !has[0] && !has[1] ? "point"
                                : "primitive";
}

void picture_print_summary_of(FILE *file, const char *name, const picture *p, uint64_t primitives)
{
    report_print(file, name);
    fprintf(file, ": %ux%u, %llu %s%s, %s\n", (unsigned)p->scene->width, (unsigned)p->scene->height,
            (unsigned long long)primitives, primitive_words(p), primitives == 1 ? "" : "s",
            shading_traits_of(p->shading)->words);
    if (p->maps != NULL) {
        fputs("maps: ", file);
        report_print(file, p->maps);
        fputc('\n', file);
    }
    if (p->ground.spacing > 0.0)
        fprintf(file, "grid: lines at multiples of %.6g\n", p->ground.spacing);
}

static int check_input(const char *output_path, const char *input_path)
{
    return output_same_file(output_path, input_path)
               ? report_fault(input_path, "would be overwritten by the picture")
               : 0;
}

int picture_check_opened(const contents *c, const char *output_path)
{
    const files_list *opened = &c->from.opened;
    int fault = 0;
    for (size_t i = 0; i < opened->count && fault == 0 && output_path != NULL; ++i)
        fault = check_input(output_path, opened->paths[i]);
    return fault;
}

int picture_check_output(const options *o, const char *output_path, unsigned int formats)
{
    int fault = 0;
    if (output_path == NULL)
        return 0;
    for (size_t i = 0; i < o->model_count && fault == 0; ++i)
        fault = check_input(output_path, o->models[i].path);
    for (int i = 0; i < OPTIONS_MAP_COUNT && fault == 0; ++i)
        if (o->maps[i].file != NULL)
            fault = check_input(output_path, o->maps[i].file);
    return fault == 0 ? picture_format_check(output_path, formats) : fault;
}
