/* Builds the scene of the state, and moves the camera.
 *
 * A scene is kept from one build to the next: if only the camera, the convention or the size has
 * changed, its draws are placed anew, and their arrays and maps stay where they are. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "blended.h"
#include "orbit.h"
#include "page_parts.h"
#include "shadow.h"
#include "teapot_scene.h"

/* The built-in model that was used last. */
static page_contents built_in;
static page_model_name built_in_name;

/* The scene, what it was made of, and whether it is that of the state. */
static struct {
    scene *scene;
    bool is_built;     /* without a fault */
    uint32_t state;    /* page_state_version */
    uint32_t settings; /* page_settings_version */
    uint32_t dropped;  /* page_dropped_version */
    page_settings made_of;
    camera camera;
    look look;
    uint32_t version;    /* page_contents_version */
    size_t *parts;       /* of each draw: the number of the part that it shows */
    size_t opaque_count; /* the draws that do not blend come first */
} built;

static gn_backend backend = GN_BACKEND_AUTO;

static void forget_scene(void)
{
    built.is_built = false;
    scene_free(built.scene);
    built.scene = NULL;
    free(built.parts);
    built.parts = NULL;
}

void page_use_backend(gn_backend chosen)
{
    backend = chosen;
    forget_scene();
}

gn_backend page_used_backend(void)
{
    return backend == GN_BACKEND_AUTO ? gn_backend_best() : backend;
}

scene *page_built(void)
{
    const bool is_current = built.is_built && built.state == page_state_version() &&
                            built.dropped == page_dropped_version();
    return is_current ? built.scene : NULL;
}

const scene *page_scene(void)
{
    return page_built();
}

const camera *page_camera(void)
{
    return page_built() != NULL ? &built.camera : NULL;
}

uint32_t page_mesh_of_draw(size_t draw)
{
    /* The teapot's draws are not sorted. */
    return (uint32_t)(built.parts != NULL ? built.parts[draw] : draw);
}

gn_vec3 page_light(void)
{
    return built.look.light_direction;
}

uint32_t page_contents_version(void)
{
    return built.version;
}

/* The contents of the state's model; null with the message set. */
static const page_contents *contents_now(void)
{
    const page_model_name name = page_settings_now()->model;
    if (name == PAGE_DROPPED)
        return page_dropped();
    if (built_in.model.part_count == 0 || built_in_name != name) {
        page_contents_free(&built_in);
        if (page_shape_create(name, &built_in) != 0)
            return NULL;
        built_in_name = name;
    }
    return &built_in;
}

/* The square is a floor, which reaches far into the picture. */
static void place_on_floor(camera_options *asked)
{
    if (!asked->eye_given)
        asked->eye = (gn_vec3){0.3f, 0.35f, 1.4f};
    if (!asked->target_given)
        asked->target = (gn_vec3){0.0f, -0.05f, 0.2f};
    asked->eye_given = asked->target_given = true;
}

/* Where the state, or else the model, wants the camera. */
static int place_camera(const page_contents *contents, camera_options *asked, camera *result)
{
    const page_settings *const s = page_settings_now();
    *asked = s->options.camera;
    if (s->model == PAGE_TEAPOT)
        teapot_place_camera(asked);
    if (s->model == PAGE_SQUARE)
        place_on_floor(asked);
    return camera_place(asked, &contents->bounds, s->options.width, s->options.height, result);
}

static bool is_finite(gn_vec3 v)
{
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z);
}

/* A whole turn, in the pixels of orbit_turn, and as many steps of a zoom as any distance has. */
#define WHOLE_TURN 900
#define MOST_STEPS 2000

/* The camera as an orbit moves it, with up as it is in every state. */
static int begin_move(camera_options *moved)
{
    camera placed;
    page_begin();
    const page_contents *const contents = contents_now();
    if (contents == NULL || place_camera(contents, moved, &placed) != 0)
        return 1;
    const gn_vec3 up = moved->up;
    orbit_begin(moved, &placed);
    moved->up = up;
    return 0;
}

static int end_move(const camera_options *moved)
{
    if (!is_finite(moved->eye) || !is_finite(moved->target))
        return page_fail("the camera would be too far away", (const char *)NULL);
    return page_set_camera(moved->eye, moved->target);
}

int page_turn(int right, int down)
{
    camera_options moved;
    if (begin_move(&moved) != 0)
        return 1;
    orbit_turn(&moved, right % WHOLE_TURN, down % WHOLE_TURN);
    return end_move(&moved);
}

int page_pan(int right, int down)
{
    camera_options moved;
    if (begin_move(&moved) != 0)
        return 1;
    orbit_pan(&moved, right, down, page_settings_now()->options.height);
    return end_move(&moved);
}

int page_zoom(int steps)
{
    camera_options moved;
    if (begin_move(&moved) != 0)
        return 1;
    const int bounded = steps > MOST_STEPS ? MOST_STEPS : steps < -MOST_STEPS ? -MOST_STEPS : steps;
    orbit_zoom(&moved, bounded);
    return end_move(&moved);
}

/* The maps that the state shows of those that a part has. */
static part_maps shown_maps(const page_settings *s, const part_maps *all)
{
    part_maps shown = *all;
    const unsigned int wanted = s->maps ? shading_traits_of(s->options.shading)->maps : 0;
    for (int k = 0; k < MAP_COUNT; ++k)
        if ((wanted >> k & 1) == 0)
            shown.images[k].texels = NULL;
    return shown;
}

/* Copies of the model cannot report that memory is missing, so that some is asked for first: for
 * all arrays, twice with shadows, for a second copy of mirrored tangents or the sorting of
 * triangles, and for maps with their levels. */
static bool has_memory(const page_contents *c, bool twice)
{
    uint64_t bytes = (uint64_t)1 << 20;
    for (size_t p = 0; p < c->model.part_count; ++p) {
        const model_part *const part = c->model.parts + p;
        bytes += ((uint64_t)part->vertex_count * 64 + (uint64_t)part->index_count * 4) *
                     (twice ? 2 : 1) +
                 (uint64_t)part->vertex_count * 32 + (uint64_t)part->index_count * 16 +
                 sizeof(scene_draw) * 4;
        for (int k = 0; k < MAP_COUNT; ++k)
            bytes += (uint64_t)c->maps[p].images[k].width * c->maps[p].images[k].height * 8;
    }
    void *const memory = bytes <= SIZE_MAX ? malloc((size_t)bytes) : NULL;
    free(memory);
    return memory != NULL;
}

static int throw_shadows(const page_contents *c, const look *l, shadow_pass *result)
{
    int fault = shadow_begin(&c->bounds, l->light_direction, result);
    for (size_t p = 0; p < c->model.part_count && fault == 0; ++p)
        shadow_add_part(result, c->model.parts + p);
    return fault == 0 ? shadow_draw(result, backend) : fault;
}

/* Adds the draws of a model's parts, those that blend last. */
static int add_parts(const page_contents *c, const page_settings *s, const look *l, scene *to)
{
    built.parts = malloc(c->model.part_count * sizeof *built.parts);
    if (built.parts == NULL)
        return page_fail("there is not enough memory for the model", (const char *)NULL);
    for (int blends = 0; blends < 2; ++blends) {
        for (size_t p = 0; p < c->model.part_count; ++p) {
            if (look_blends(l->options, c->model.parts + p) != (blends != 0))
                continue;
            const part_maps maps = shown_maps(s, c->maps + p);
            built.parts[to->draw_count] = p;
            look_add_part(to, l, c->model.parts + p, &maps);
        }
        if (blends == 0)
            built.opaque_count = to->draw_count;
    }
    return 0;
}

static int add_draws(const page_contents *c, const page_settings *s, const look *l, scene *to)
{
    if (c->ground.part_count == 0)
        return add_parts(c, s, l, to);
    const part_maps maps = shown_maps(s, c->maps);
    teapot_add_draws(l, &maps, (model *)&c->ground, &c->model, to);
    return 0;
}

/* Places the draws as the camera sees them. */
static void place_draws(const page_contents *c)
{
    scene *const to = built.scene;
    gn_transform here;
    gn_transform_identity(&here);
    built.look.view = built.camera;
    for (size_t i = 0; i < to->draw_count; ++i)
        look_place(to->draws + i, &built.look,
                   built.parts != NULL ? &c->model.parts[built.parts[i]].world_from_model : &here);
    if (built.parts != NULL)
        blended_order(to->draws + built.opaque_count, built.parts + built.opaque_count,
                      to->draw_count - built.opaque_count);
}

/* Makes the scene's draws, of a camera that is placed. */
static int make_scene(const page_contents *c, const page_settings *s)
{
    const options *const o = &built.made_of.options;
    shadow_pass shadow;
    int fault = 0;
    forget_scene();
    if (!has_memory(c, o->shadows))
        return page_fail("there is not enough memory for the model", (const char *)NULL);
    built.made_of = *s;
    memset(&shadow, 0, sizeof shadow);
    look_choose(o, &built.camera, o->shading, &built.look);
    teapot_light(&built.look);
    if (o->shadows) {
        fault = throw_shadows(c, &built.look, &shadow);
        built.look.shadow = &shadow;
    }
    if (fault == 0) {
        built.scene = scene_create(o->width, o->height, GN_FORMAT_RGBA8, GN_FORMAT_D32F);
        memcpy(built.scene->clear_color, teapot_background, sizeof built.scene->clear_color);
        fault = add_draws(c, s, &built.look, built.scene);
        ++built.version;
    }
    built.look.shadow = NULL;
    shadow_free(&shadow);
    if (fault != 0)
        forget_scene();
    return fault;
}

int page_build(void)
{
    const page_settings *const s = page_settings_now();
    camera_options asked;
    page_begin();
    built.is_built = false;
    const page_contents *const contents = contents_now();
    if (contents == NULL || place_camera(contents, &asked, &built.camera) != 0)
        return 1;
    if (built.scene == NULL || built.settings != page_settings_version() ||
        built.dropped != page_dropped_version()) {
        if (make_scene(contents, s) != 0)
            return 1;
        built.settings = page_settings_version();
        built.dropped = page_dropped_version();
    }
    place_draws(contents);
    built.scene->width = s->options.width;
    built.scene->height = s->options.height;
    built.scene->samples = s->options.samples;
    built.state = page_state_version();
    built.is_built = true;
    return 0;
}
