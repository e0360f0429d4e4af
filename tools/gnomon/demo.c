/* gnomon demo: the library and OSMesa draw the teapot. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "comparison.h"
#include "counts.h"
#include "look.h"
#include "output.h"
#include "picture.h"
#include "report.h"
#include "teapot.h"
#include "teapot_maps.h"

static const char usage[] =
    "gnomon demo [-o OUT] [OPTION...]: draw the Utah teapot, tessellated from Newell's Bezier\n"
    "patches, with Gnomon and with OSMesa, and count the pixels that differ in any bit.\n"
    "\n"
    "  gnomon demo\n"
    "  gnomon demo --picture teapot.png --tessellation 32 --size 1600x1200\n"
    "\n"
    "  -o, --output OUT        Gnomon's picture, OSMesa's and the difference, side by side;\n"
    "                          .png, .tga or .ppm; default: gnomon-demo.png. For this option\n"
    "                          and the next, - is standard output; messages then go to\n"
    "                          standard error\n"
    "  --picture OUT           Gnomon's picture alone\n"
    "  --size WxH              size in pixels, up to 16384x16384; default: 800x600\n"
    "  --samples 4             four samples a pixel; default: 1\n"
    "  --tessellation N        segments along each side of a patch, 1 to 128; default: 16\n"
    "  --shader NAME           a ready-made shader (gnomon render --help lists them), with maps\n"
    "                          made for the teapot; default: Gouraud without maps\n"
    "  --normal-map KIND       tangent, world or none; default: tangent\n"
    "  --filter, --shadows, --exponent, --bands, --statistics    as for gnomon render\n"
    "\n"
    "Exit status: 0: no pixel differs; 1: some do, or an output is at fault; 2: wrong usage.\n";

static const float background[4] = {0.933f, 0.925f, 0.906f, 1.0f};
static const model_shine shine = {{0.45f, 0.45f, 0.45f}, 40};
static const float glaze[4] = {0.80f, 0.46f, 0.31f, 1.0f};

/* Texels per side of each patch's cell of the maps. */
#define MAP_CELL 64

/* The shadow is a disc on the ground, dark in the middle and of the background's colour at its
 * edge, so that the edge is not visible. */
#define SHADOW_SEGMENTS 64
#define SHADOW_RINGS 16

static bool create_shadow(model *result)
{
    memset(result, 0, sizeof *result);
    result->parts = calloc(1, sizeof *result->parts);
    if (result->parts == NULL)
        return false;
    result->part_count = 1;
    model_part *part = result->parts;
    uint32_t columns = SHADOW_SEGMENTS + 1;
    if (!model_part_allocate(part, columns * (SHADOW_RINGS + 1),
                             SHADOW_SEGMENTS * SHADOW_RINGS * 6)) {
        model_free(result);
        return false;
    }
    part->index_count = 0;
    for (uint32_t ring = 0; ring <= SHADOW_RINGS; ++ring) {
        double r = (double)ring / SHADOW_RINGS;
        double fade = (1.0 - r * r) * (1.0 - r * r);
        for (uint32_t i = 0; i <= SHADOW_SEGMENTS; ++i) {
            double angle = 2.0 * 3.14159265358979323846 * (i % SHADOW_SEGMENTS) / SHADOW_SEGMENTS;
            size_t v = (size_t)ring * columns + i;
            part->positions[3 * v] = (float)(0.25 + 3.3 * r * cos(angle));
            part->positions[3 * v + 1] = -0.01f;
            part->positions[3 * v + 2] = (float)(-0.25 + 2.7 * r * sin(angle));
            for (size_t c = 0; c < 3; ++c)
                part->colors[4 * v + c] = background[c] * (float)(1.0 - 0.62 * fade);
            part->colors[4 * v + 3] = 1.0f;
            if (ring == 0 || i == 0)
                continue;
            uint32_t d = (uint32_t)v;
            uint32_t corners[6] = {d, d - 1, d - columns, d - 1, d - 1 - columns, d - columns};
            memcpy(part->indices + part->index_count, corners, sizeof corners);
            part->index_count += 6;
        }
    }
    return true;
}

/* The lit ground, which has the background's colour where there is no shadow. */
static void light_ground(model_part *ground, const look *l)
{
    float lit = fmaxf(l->light_direction.y, 0.0f);
    const float light[3] = {l->ambient.x + l->diffuse.x * lit, l->ambient.y + l->diffuse.y * lit,
                            l->ambient.z + l->diffuse.z * lit};
    for (size_t v = 0; v < ground->vertex_count; ++v) {
        for (size_t c = 0; c < 3; ++c)
            ground->colors[4 * v + c] = background[c] / light[c];
        ground->normals[3 * v + 1] = 1.0f;
    }
}

static bool create_maps(const options *o, part_maps *maps)
{
    unsigned int wanted = shading_traits_of(o->shading)->maps;
    memset(maps, 0, sizeof *maps);
    maps->normals_in_tangent_space = o->normals != NORMALS_WORLD;
    for (int i = 0; i < MAP_COUNT; ++i) {
        if (o->shading != SHADING_AUTOMATIC && (wanted >> i & 1) != 0 && !o->maps[i].none &&
            !teapot_map_create((map_kind)i, maps->normals_in_tangent_space, MAP_CELL,
                               maps->images + i)) {
            maps_free(maps);
            return false;
        }
    }
    return true;
}

/* The teapot on its ground; pictures of normals and depths have no ground. */
static void add_draws(const look *l, const part_maps *maps, model *ground, const model *teapot,
                      scene *s)
{
    static const part_maps none;
    look below = *l;
    below.shading = l->options->shadows ? SHADING_PHONG : SHADING_VERTEX_COLOR;
    if (l->options->shadows)
        light_ground(ground->parts, l);
    if (l->shading != SHADING_NORMALS && l->shading != SHADING_DEPTH)
        look_add_part(s, &below, ground->parts, &none);
    look_add_part(s, l, teapot->parts, maps);
}

static int throw_shadow(const bounding_sphere *bounds, const look *l, const model *teapot,
                        shadow_pass *result)
{
    int fault = shadow_begin(bounds, l->light_direction, result);
    if (fault == 0) {
        shadow_add_part(result, teapot->parts);
        fault = shadow_draw(result, GN_BACKEND_AUTO);
    }
    return fault;
}

static int describe(const options *o, picture *result)
{
    static const bounding_sphere sphere = {{0.2, 1.45, 0.0}, 3.6};
    camera_options asked = o->camera;
    camera view;
    look l;
    model teapot;
    model ground;
    part_maps maps;
    memset(result, 0, sizeof *result);
    asked.eye_given = asked.target_given = true;
    asked.eye = (gn_vec3){3.4f, 4.6f, 8.6f};
    asked.target = (gn_vec3){0.2f, 1.35f, 0.0f};
    asked.fov_degrees = 35.0f;
    int fault = camera_place(&asked, &sphere, o->width, o->height, &view);
    if (fault != 0)
        return fault;
    result->shading = o->shading != SHADING_AUTOMATIC ? o->shading
                      : o->shadows                    ? SHADING_PHONG
                                                      : SHADING_GOURAUD;
    look_choose(o, &view, result->shading, &l);
    gn_vec3_normalize((gn_vec3){-0.4f, 0.75f, 0.7f}, &l.light_direction);
    l.ambient = (gn_vec3){0.30f, 0.31f, 0.36f};
    l.diffuse = (gn_vec3){0.82f, 0.78f, 0.72f};
    bool made = teapot_create(o->tessellation, glaze, &teapot);
    if (made)
        teapot.parts->shine = shine;
    made = create_shadow(&ground) && made;
    made = create_maps(o, &maps) && made;
    if (made && o->shadows) {
        fault = throw_shadow(&sphere, &l, &teapot, &result->shadow);
        l.shadow = &result->shadow;
    }
    if (made && fault == 0) {
        scene *s = scene_create(o->width, o->height, GN_FORMAT_RGBA8, GN_FORMAT_D32F);
        memcpy(s->clear_color, background, sizeof s->clear_color);
        s->clear_depth = 1.0f;
        s->samples = o->samples;
        add_draws(&l, &maps, &ground, &teapot, s);
        result->scene = s;
    }
    model_free(&ground);
    model_free(&teapot);
    maps_free(&maps);
    return made ? fault : report_fault("teapot", "not enough memory");
}

int command_demo(int argc, char **argv)
{
    options o;
    int status;
    options_result result = options_parse(COMMAND_DEMO, argc, argv, &o, &status);
    if (result == OPTIONS_HELP) {
        fputs(usage, stdout);
        return finish_output(0);
    }
    if (result == OPTIONS_WRONG)
        return status;
    if (o.output == NULL)
        o.output = "gnomon-demo.png";
    if (o.picture_output != NULL && output_same_file(o.output, o.picture_output))
        return report_fault(o.output, "cannot be both the comparison and the picture");

    FILE *words = output_words(o.output, o.picture_output);
    picture p;
    int fault = picture_format_check(o.output, PICTURE_ANY);
    if (fault == 0 && o.picture_output != NULL)
        fault = picture_format_check(o.picture_output, PICTURE_ANY);
    if (fault == 0)
        fault = describe(&o, &p);
    if (fault != 0)
        return fault;
    comparison c;
    picture_print_summary(words, "teapot", &p);
    fault = comparison_make(p.scene, &p.shadow, GN_BACKEND_AUTO, words, &c);
    if (fault == 0)
        fault = comparison_write_triptych(&c, o.output);
    if (fault == 0)
        comparison_name_triptych(words, o.output);
    if (fault == 0 && o.picture_output != NULL)
        fault = comparison_write_picture(&c, o.picture_output);
    if (fault == 0)
        fault = counts_report(words, o.output, o.statistics, p.scene, GN_BACKEND_AUTO, &c.ours);
    if (fault == 0 && c.difference.pixels + c.samples.pixels + c.shadow_texels > 0)
        fault = EXIT_FAULT;
    comparison_free(&c);
    picture_free(&p);
    return finish_output(fault);
}
