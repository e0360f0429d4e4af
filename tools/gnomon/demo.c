/* gnomon demo: the library and OSMesa draw the teapot. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "help.h"
#include "look.h"
#include "output.h"
#include "picture.h"
#include "report.h"
#include "teapot_scene.h"

static bool create_maps(const options *o, part_maps *maps)
{
    unsigned int wanted = 0;
    if (o->shading != SHADING_AUTOMATIC)
        wanted = shading_traits_of(o->shading)->maps;
    for (int i = 0; i < OPTIONS_MAP_COUNT; ++i)
        if (o->maps[i].none)
            wanted &= ~(1u << i);
    return teapot_create_maps(wanted, o->normals != NORMALS_WORLD, maps);
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
    const bounding_sphere sphere = teapot_sphere();
    camera_options asked = o->camera;
    camera view;
    look l;
    model teapot;
    model ground;
    part_maps maps;
    memset(result, 0, sizeof *result);
    teapot_place_camera(&asked);
    asked.fov_degrees = TEAPOT_FOV_DEGREES;
    int fault = camera_place(&asked, &sphere, o->width, o->height, &view);
    if (fault != 0)
        return fault;
    result->shading = o->shading != SHADING_AUTOMATIC ? o->shading
                      : o->shadows                    ? SHADING_PHONG
                                                      : SHADING_GOURAUD;
    look_choose(o, &view, result->shading, &l);
    teapot_light(&l);
    bool made = teapot_create_glazed(o->tessellation, &teapot);
    made = teapot_create_ground(&ground) && made;
    made = create_maps(o, &maps) && made;
    if (made && o->shadows) {
        fault = throw_shadow(&sphere, &l, &teapot, &result->shadow);
        l.shadow = &result->shadow;
    }
    if (made && fault == 0) {
        scene *s = scene_create(o->width, o->height, GN_FORMAT_RGBA8, GN_FORMAT_D32F);
        memcpy(s->clear_color, teapot_background, sizeof s->clear_color);
        s->clear_depth = 1.0f;
        s->samples = o->samples;
        teapot_add_draws(&l, &maps, &ground, &teapot, s);
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
    if (result == OPTIONS_HELP)
        return help_print(COMMAND_DEMO, false);
    if (result == OPTIONS_WRONG)
        return status;
    if (o.output == NULL)
        o.output = "gnomon-demo.png";
    if (o.picture_output != NULL && output_same_file(o.output, o.picture_output))
        return report_fault(o.output, "cannot be both the comparison and the picture");

    picture p;
    int fault = picture_format_check(o.output, PICTURE_ANY);
    if (fault == 0 && o.picture_output != NULL)
        fault = picture_format_check(o.picture_output, PICTURE_ANY);
    if (fault == 0)
        fault = describe(&o, &p);
    return fault == 0 ? compare_picture(&o, "teapot", &p) : fault;
}
