/* The names of enumerators in the text of a scene. */
#include "scene_text.h"

#include <ctype.h>
#include <string.h>

#include "scene.h"
#include "scene_format.h"

/* Each array of names is in the order of its enumeration's values. */
#define NAME(shader, name) name,
static const char *const shader_names[] = {SCENE_SHADERS(NAME)};

/* Makes the names of formats: "rgb5-a1" for RGB5_A1. */
#define LONGEST_NAME 24

static const char *const *format_names(int *count)
{
    static char texts[SCENE_FORMATS][LONGEST_NAME] = {"none"};
    static const char *names[SCENE_FORMATS];

    *count = SCENE_FORMATS;
    for (int f = 0; !names[0] && f < SCENE_FORMATS; ++f) {
        const char *const name = scene_format_of((gn_format)f)->name;

        for (int i = 0; name && name[i]; ++i)
            texts[f][i] = (char)(name[i] == '_' ? '-' : tolower((unsigned char)name[i]));
    }
    for (int f = 0; f < SCENE_FORMATS; ++f)
        names[f] = texts[f];
    return names;
}

static const char *const topology_names[] = {
    "triangles", "triangle-strip", "triangle-fan", "points", "lines", "line-strip", "line-loop"};
static const char *const provoking_names[] = {"last", "first"};
static const char *const cull_names[] = {"none", "back", "front", "front-and-back"};
static const char *const front_face_names[] = {"counter-clockwise", "clockwise"};
static const char *const compare_names[] = {
    "default",          "never", "less", "equal", "less-or-equal", "greater", "not-equal",
    "greater-or-equal", "always"};
static const char *const stencil_operation_names[] = {"keep",           "zero",          "replace",
                                                      "increment",      "decrement",     "invert",
                                                      "increment-wrap", "decrement-wrap"};
static const char *const interpolation_names[] = {"smooth", "noperspective", "flat"};
static const char *const location_names[] = {"center", "centroid", "sample"};
static const char *const index_names[] = {"none", "uint8", "uint16", "uint32"};
static const char *const restart_names[] = {"none", "fixed", "index"};
static const char *const attribute_names[] = {"position", "color", "normal", "texcoord", "tangent"};
static const char *const switch_names[] = {"off", "on"};
static const char *const wrap_names[] = {"repeat", "clamp-to-edge", "mirrored-repeat",
                                         "clamp-to-border", "mirror-clamp-to-edge"};
static const char *const magnify_names[] = {"linear", "nearest"};
static const char *const minify_names[] = {
    "nearest-mipmap-linear", "nearest", "linear", "nearest-mipmap-nearest", "linear-mipmap-nearest",
    "linear-mipmap-linear"};
static const char *const normal_space_names[] = {"model", "tangents"};
static const char *const light_kind_names[] = {"directional", "point", "spot"};
static const char *const map_names[] = {"normal-map", "specular-map",           "glow-map",
                                        "shadow-map", "metallic-roughness-map", "occlusion-map"};
static const char *const texture_target_names[] = {"2d", "1d", "2d-array", "3d", "cube"};
static const char *const factor_names[] = {"default",
                                           "zero",
                                           "one",
                                           "source-color",
                                           "one-minus-source-color",
                                           "destination-color",
                                           "one-minus-destination-color",
                                           "source-alpha",
                                           "one-minus-source-alpha",
                                           "destination-alpha",
                                           "one-minus-destination-alpha",
                                           "constant-color",
                                           "one-minus-constant-color",
                                           "constant-alpha",
                                           "one-minus-constant-alpha",
                                           "source-alpha-saturate"};
static const char *const equation_names[] = {"default",          "add", "subtract",
                                             "reverse-subtract", "min", "max"};

static const char *const logic_names[] = {
    "copy", "clear",      "and",    "and-reverse", "and-inverted",  "noop",        "xor",  "or",
    "nor",  "equivalent", "invert", "or-reverse",  "copy-inverted", "or-inverted", "nand", "set"};
static const char *const clip_depth_names[] = {"negative-one-to-one", "zero-to-one"};
static const char *const polygon_mode_names[] = {"fill", "line", "point"};

static const char *const point_origin_names[] = {"upper-left", "lower-left"};

#define SET(array)                                                                                 \
    {                                                                                              \
        array, (int)(sizeof array / sizeof *array)                                                 \
    }

static const struct {
    const char *const *names;
    int count;
} sets[] = {
    [TEXT_SHADER] = SET(shader_names),
    [TEXT_TOPOLOGY] = SET(topology_names),
    [TEXT_PROVOKING] = SET(provoking_names),
    [TEXT_CULL] = SET(cull_names),
    [TEXT_FRONT_FACE] = SET(front_face_names),
    [TEXT_COMPARE] = SET(compare_names),
    [TEXT_STENCIL_OPERATION] = SET(stencil_operation_names),
    [TEXT_INTERPOLATION] = SET(interpolation_names),
    [TEXT_LOCATION] = SET(location_names),
    [TEXT_INDEX] = SET(index_names),
    [TEXT_RESTART] = SET(restart_names),
    [TEXT_ATTRIBUTE] = SET(attribute_names),
    [TEXT_SWITCH] = SET(switch_names),
    [TEXT_WRAP] = SET(wrap_names),
    [TEXT_MAGNIFY] = SET(magnify_names),
    [TEXT_MINIFY] = SET(minify_names),
    [TEXT_FACTOR] = SET(factor_names),
    [TEXT_EQUATION] = SET(equation_names),
    [TEXT_LOGIC] = SET(logic_names),
    [TEXT_CLIP_DEPTH] = SET(clip_depth_names),
    [TEXT_POINT_ORIGIN] = SET(point_origin_names),
    [TEXT_POLYGON_MODE] = SET(polygon_mode_names),
    [TEXT_TEXTURE_TARGET] = SET(texture_target_names),
    [TEXT_NORMAL_SPACE] = SET(normal_space_names),
    [TEXT_LIGHT_KIND] = SET(light_kind_names),
    [TEXT_MAP] = SET(map_names),
};

static const char *const *names_of(text_names set, int *count)
{
    if (set == TEXT_FORMAT)
        return format_names(count);
    *count = sets[set].count;
    return sets[set].names;
}

int text_name_count(text_names set)
{
    int count;

    names_of(set, &count);
    return count;
}

const char *text_name(text_names set, int value)
{
    int count;
    const char *const *const names = names_of(set, &count);

    return value >= 0 && value < count ? names[value] : "invalid";
}

int text_value(text_names set, const char *name)
{
    int count;
    const char *const *const names = names_of(set, &count);

    for (int value = 0; value < count; ++value)
        if (!strcmp(name, names[value]))
            return value;
    return -1;
}
