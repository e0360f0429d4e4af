/* Parses the command line. */
#include "options.h"

#include <getopt.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "option_values.h"
#include "report.h"
#include "rotation.h"

#define DEFAULT_FOV_DEGREES 40.0f
#define DEFAULT_TESSELLATION 16

#define DEFAULT_FRAMES 101
#define DEFAULT_RATE 25

static const import_limits default_limits = {30, 2048, 1024, 64};

/* What getopt_long returns for a word that is no option: its number in RETURN_IN_ORDER. */
#define WORD_ALONE 1

enum {
    OPTION_SIZE = 256,
    OPTION_EYE,
    OPTION_TARGET,
    OPTION_UP,
    OPTION_FOV,
    OPTION_ORTHOGRAPHIC,
    OPTION_SHADER,
    OPTION_BACKGROUND,
    OPTION_DEPTH,
    OPTION_LIGHT,
    OPTION_TEXTURE,
    OPTION_BACKEND,
    OPTION_PICTURE,
    OPTION_TESSELLATION,
    OPTION_WIREFRAME,
    OPTION_SAMPLES,
    OPTION_STATISTICS,
    OPTION_NORMAL_MAP,
    OPTION_SPECULAR_MAP,
    OPTION_GLOW_MAP,
    OPTION_FILTER,
    OPTION_SHADOWS,
    OPTION_EXPONENT,
    OPTION_BANDS,
    OPTION_IMPORT_SECONDS,
    OPTION_IMPORT_MEMORY,
    OPTION_IMPORT_OUTPUT,
    OPTION_MAP_PIXELS,
    OPTION_HELP_ALL,
    OPTION_FORMAT,
    OPTION_ROTATE,
    OPTION_SCALE,
    OPTION_TRANSLATE,
    OPTION_NEAR,
    OPTION_FAR,
    OPTION_CULL,
    OPTION_NO_DEPTH_TEST,
    OPTION_POINTS,
    OPTION_AXIS,
    OPTION_FRAMES,
    OPTION_RATE,
    OPTION_SCRIPT,
    OPTION_PIXEL,
    OPTION_PRIMITIVE,
    OPTION_JSON,
    OPTION_STATE,
    OPTION_VIEWS,
    OPTION_SORT,
    OPTION_OPAQUE
};

#define STILL_COMMANDS (COMMAND_RENDER | COMMAND_COMPARE)
#define MODEL_COMMANDS (STILL_COMMANDS | COMMAND_SPIN | COMMAND_VIEW | COMMAND_EXPLAIN)
#define PICTURE_COMMANDS (MODEL_COMMANDS | COMMAND_DEMO)
#define OUTPUT_COMMANDS ((PICTURE_COMMANDS | COMMAND_DIFF) & ~COMMAND_EXPLAIN)
#define FILE_COMMANDS (COMMAND_DIFF | COMMAND_INFO)
#define IMPORT_COMMANDS (MODEL_COMMANDS | FILE_COMMANDS)
#define ALL_COMMANDS (PICTURE_COMMANDS | FILE_COMMANDS)

static const struct {
    char name[20];
    int takes_value; /* as for getopt_long */
    int value;
    int commands;
} option_table[] = {
    {"help", no_argument, 'h', ALL_COMMANDS},
    {"help-all", no_argument, OPTION_HELP_ALL, MODEL_COMMANDS},
    {"output", required_argument, 'o', OUTPUT_COMMANDS},
    {"size", required_argument, OPTION_SIZE, PICTURE_COMMANDS},
    {"eye", required_argument, OPTION_EYE, MODEL_COMMANDS},
    {"target", required_argument, OPTION_TARGET, MODEL_COMMANDS},
    {"up", required_argument, OPTION_UP, MODEL_COMMANDS},
    {"fov", required_argument, OPTION_FOV, MODEL_COMMANDS},
    {"orthographic", required_argument, OPTION_ORTHOGRAPHIC, MODEL_COMMANDS},
    {"shader", required_argument, OPTION_SHADER, PICTURE_COMMANDS},
    {"background", required_argument, OPTION_BACKGROUND, MODEL_COMMANDS},
    {"light", required_argument, OPTION_LIGHT, MODEL_COMMANDS},
    {"texture", required_argument, OPTION_TEXTURE, MODEL_COMMANDS},
    {"normal-map", required_argument, OPTION_NORMAL_MAP, PICTURE_COMMANDS},
    {"specular-map", required_argument, OPTION_SPECULAR_MAP, MODEL_COMMANDS},
    {"glow-map", required_argument, OPTION_GLOW_MAP, MODEL_COMMANDS},
    {"filter", required_argument, OPTION_FILTER, PICTURE_COMMANDS},
    {"opaque", no_argument, OPTION_OPAQUE, MODEL_COMMANDS},
    {"shadows", no_argument, OPTION_SHADOWS, PICTURE_COMMANDS},
    {"exponent", required_argument, OPTION_EXPONENT, PICTURE_COMMANDS},
    {"bands", required_argument, OPTION_BANDS, PICTURE_COMMANDS},
    {"backend", required_argument, OPTION_BACKEND, MODEL_COMMANDS},
    {"wireframe", no_argument, OPTION_WIREFRAME, MODEL_COMMANDS},
    {"samples", required_argument, OPTION_SAMPLES, PICTURE_COMMANDS},
    {"statistics", no_argument, OPTION_STATISTICS, STILL_COMMANDS | COMMAND_DEMO},
    {"rotate", required_argument, OPTION_ROTATE, MODEL_COMMANDS},
    {"scale", required_argument, OPTION_SCALE, MODEL_COMMANDS},
    {"translate", required_argument, OPTION_TRANSLATE, MODEL_COMMANDS},
    {"near", required_argument, OPTION_NEAR, MODEL_COMMANDS},
    {"far", required_argument, OPTION_FAR, MODEL_COMMANDS},
    {"cull", required_argument, OPTION_CULL, MODEL_COMMANDS},
    {"no-depth-test", no_argument, OPTION_NO_DEPTH_TEST, MODEL_COMMANDS},
    {"points", optional_argument, OPTION_POINTS, MODEL_COMMANDS},
    {"format", required_argument, OPTION_FORMAT, COMMAND_RENDER | COMMAND_DIFF | COMMAND_SPIN},
    {"axis", required_argument, OPTION_AXIS, COMMAND_SPIN},
    {"frames", required_argument, OPTION_FRAMES, COMMAND_SPIN},
    {"rate", required_argument, OPTION_RATE, COMMAND_SPIN},
    {"script", required_argument, OPTION_SCRIPT, COMMAND_VIEW},
    {"depth", required_argument, OPTION_DEPTH, COMMAND_RENDER},
    {"views", required_argument, OPTION_VIEWS, COMMAND_RENDER},
    {"sort", required_argument, OPTION_SORT, COMMAND_RENDER},
    {"pixel", required_argument, OPTION_PIXEL, COMMAND_EXPLAIN},
    {"primitive", required_argument, OPTION_PRIMITIVE, COMMAND_EXPLAIN},
    {"json", no_argument, OPTION_JSON, COMMAND_EXPLAIN},
    {"state", required_argument, OPTION_STATE, COMMAND_EXPLAIN},
    {"picture", required_argument, OPTION_PICTURE, COMMAND_DEMO},
    {"tessellation", required_argument, OPTION_TESSELLATION, COMMAND_DEMO},
    {"import-seconds", required_argument, OPTION_IMPORT_SECONDS, IMPORT_COMMANDS},
    {"import-memory", required_argument, OPTION_IMPORT_MEMORY, IMPORT_COMMANDS},
    {"import-output", required_argument, OPTION_IMPORT_OUTPUT, IMPORT_COMMANDS},
    {"map-pixels", required_argument, OPTION_MAP_PIXELS, IMPORT_COMMANDS},
};

#define OPTION_COUNT (sizeof option_table / sizeof option_table[0])

const char *options_command_name(command which)
{
    switch (which) {
    case COMMAND_RENDER:
        return "render";
    case COMMAND_COMPARE:
        return "compare";
    case COMMAND_DIFF:
        return "diff";
    case COMMAND_INFO:
        return "info";
    case COMMAND_SPIN:
        return "spin";
    case COMMAND_VIEW:
        return "view";
    case COMMAND_EXPLAIN:
        return "explain";
    default:
        return "demo";
    }
}

/* Whether an option takes floats. */
static bool takes_floats(int option)
{
    return option == OPTION_EYE || option == OPTION_TARGET || option == OPTION_UP ||
           option == OPTION_LIGHT || option == OPTION_FOV || option == OPTION_ORTHOGRAPHIC ||
           option == OPTION_ROTATE || option == OPTION_SCALE || option == OPTION_TRANSLATE ||
           option == OPTION_NEAR || option == OPTION_FAR;
}

/* Whether an option counts beside --state, which says everything about the picture. */
static bool goes_with_state(int option)
{
    return option == WORD_ALONE || option == OPTION_STATE || option == OPTION_PIXEL ||
           option == OPTION_PRIMITIVE || option == OPTION_JSON || option == OPTION_BACKEND;
}

static bool is_transformation(int option)
{
    return option == OPTION_ROTATE || option == OPTION_SCALE || option == OPTION_TRANSLATE;
}

/* Adds a transformation to the model in front of it; before the first model, to those of all
 * models. Returns as take_value does; sets the status of the transformation. */
static const char *take_transformation(int option, const char *text, options *o, gn_status *status)
{
    gn_transform *to =
        o->model_count > 0 ? &o->models[o->model_count - 1].world_from_model : &o->world_from_all;
    gn_transform next;
    gn_vec3 v;
    float degrees;
    switch (option) {
    case OPTION_ROTATE:
        if (!parse_rotation(text, &v, &degrees))
            return "AXIS,DEGREES where AXIS is x, y, z or X,Y,Z";
        *status = rotation_about(v, degrees, &next);
        break;
    case OPTION_SCALE:
        if (!parse_scale(text, &v))
            return "a number, or three numbers X,Y,Z";
        *status = gn_scale(v, &next);
        break;
    default:
        if (!parse_vector(text, &v))
            return "three numbers X,Y,Z";
        *status = gn_translate(v, &next);
    }
    if (*status == GN_OK)
        *status = gn_transform_compose(&next, to, to);
    return NULL;
}

/* Reads the value of one option, null if it has none. Returns null, or a description of the
 * expected value. */
static const char *take_value(int option, const char *text, options *o)
{
    static const char vector_form[] = "three numbers X,Y,Z";
    static const char map_form[] = "a file name, or none";
    camera_options *camera = &o->camera;
    switch (option) {
    case 'o':
        o->output = text;
        return *text != '\0' ? NULL : "a file name";
    case OPTION_DEPTH:
        o->depth_output = text;
        return *text != '\0' ? NULL : "a file name";
    case OPTION_PICTURE:
        o->picture_output = text;
        return *text != '\0' ? NULL : "a file name";
    case OPTION_TEXTURE:
        return parse_map(text, o->maps + MAP_DIFFUSE) ? NULL : map_form;
    case OPTION_SPECULAR_MAP:
        return parse_map(text, o->maps + MAP_SPECULAR) ? NULL : map_form;
    case OPTION_GLOW_MAP:
        return parse_map(text, o->maps + MAP_GLOW) ? NULL : map_form;
    case OPTION_NORMAL_MAP:
        return parse_normal_map(text, o) ? NULL
                                         : "any, tangent, world, none, tangent:FILE or world:FILE";
    case OPTION_FILTER:
        o->filter_given = true;
        return parse_filter(text, &o->filter) ? NULL : "mipmap, linear or nearest";
    case OPTION_OPAQUE:
        o->opaque = true;
        return NULL;
    case OPTION_SHADOWS:
        o->shadows = true;
        return NULL;
    case OPTION_WIREFRAME:
        o->wireframe = true;
        return NULL;
    case OPTION_POINTS:
        o->points = true;
        o->point_size = 1.0f;
        return text == NULL || parse_single(text, &o->point_size) ? NULL
                                                                  : "a size in pixels, above 0";
    case OPTION_AXIS:
        return parse_axis(text, &o->axis) ? NULL : "x, y, z, or three numbers X,Y,Z";
    case OPTION_SCRIPT:
        o->script = text;
        return *text != '\0' ? NULL : "a file name";
    case OPTION_VIEWS:
        o->views = text;
        return *text != '\0' ? NULL : "a file name";
    case OPTION_PIXEL:
        o->pixel = text;
        return parse_pixel(text, &o->pixel_x, &o->pixel_y) ? NULL : "two whole numbers X,Y";
    case OPTION_PRIMITIVE:
        o->primitive = text;
        return parse_pixel(text, &o->primitive_draw, &o->primitive_number)
                   ? NULL
                   : "two whole numbers DRAW,PRIMITIVE";
    case OPTION_JSON:
        o->json = true;
        return NULL;
    case OPTION_STATE:
        o->state = text;
        return NULL;
    case OPTION_CULL:
        o->cull_given = true;
        return parse_cull(text, &o->cull) ? NULL : "back, front or none";
    case OPTION_NO_DEPTH_TEST:
        o->depth_test_disabled = true;
        return NULL;
    case OPTION_FORMAT:
        o->format_given = true;
        return picture_format_by_name(text, &o->format) ? NULL
                                                        : "png, tga or ppm, or for render raw";
    case OPTION_NEAR:
        camera->near_given = true;
        return parse_single(text, &camera->near) ? NULL : "a distance";
    case OPTION_FAR:
        camera->far_given = true;
        return parse_single(text, &camera->far) ? NULL : "a distance";
    case OPTION_STATISTICS:
        o->statistics = true;
        return NULL;
    case OPTION_SORT:
        return parse_sort(text, &o->sort) ? NULL : "first or last";
    case OPTION_SIZE:
        return parse_size(text, &o->width, &o->height) ? NULL : "WIDTHxHEIGHT, as in 800x600";
    case OPTION_SAMPLES:
        return parse_whole(text, &o->samples) ? NULL : "1 or 4";
    case OPTION_EYE:
        camera->eye_given = true;
        return parse_place(text, &camera->eye, camera->eye_rest) ? NULL : vector_form;
    case OPTION_TARGET:
        camera->target_given = true;
        return parse_place(text, &camera->target, camera->target_rest) ? NULL : vector_form;
    case OPTION_UP:
        camera->up_given = true;
        return parse_vector(text, &camera->up) ? NULL : vector_form;
    case OPTION_FOV:
        camera->fov_given = true;
        return parse_single(text, &camera->fov_degrees) ? NULL : "a number of degrees";
    case OPTION_ORTHOGRAPHIC:
        camera->orthographic = true;
        return parse_single(text, &camera->orthographic_height) ? NULL : "a height";
    case OPTION_LIGHT:
        o->light_given = true;
        return parse_vector(text, &o->light) ? NULL : vector_form;
    case OPTION_SHADER:
        o->shading_given = true;
        return shading_by_name(text, &o->shading) ? NULL : shading_names();
    case OPTION_BACKEND:
        return parse_backend(text, &o->backend) ? NULL : parse_backend_names();
    default:
        return parse_color(text, o->background) ? NULL : "#rrggbb or #rrggbbaa";
    }
}

/* Checks options that are valid one by one against each other. Returns 0 if nothing is wrong. */
static int check(command which, const options *o)
{
    const char *name = options_command_name(which);
    if (which == COMMAND_RENDER && o->output == NULL)
        return report_usage(name, "no output file; give one with -o OUT.png");
    if (which == COMMAND_EXPLAIN && o->pixel == NULL)
        return report_usage(name, "no pixel; give one with --pixel X,Y");
    if (o->camera.orthographic && o->camera.fov_given)
        return report_usage(name, "--fov and --orthographic cannot be used together");
    if (o->wireframe && o->points)
        return report_usage(name, "--wireframe and --points cannot be used together");
    if (o->format_given && o->output == NULL)
        return report_usage(name, "--format is for the output, which -o names");
    if (o->format_given && picture_has_suffix(o->output))
        return report_usage(
            name, "--format is for names without a suffix, such as -, and '%s' has one", o->output);
    if (o->format == PICTURE_RAW && which != COMMAND_RENDER)
        return report_usage(name, "--format raw is for render; others write png, tga or ppm");
    if (which == COMMAND_COMPARE && o->wireframe && o->samples > 1)
        return report_usage(name, "--wireframe and --samples cannot be used together: "
                                  "OSMesa loses pieces of such lines");
    if (check_map_options(which, name, o) != 0)
        return EXIT_USAGE;
    if (o->shadows && !shading_traits_of(o->shading)->takes_shadows)
        return report_usage(name,
                            "--shadows cannot be used with --shader %s, which is not lit per pixel",
                            shading_traits_of(o->shading)->name);
    if (!gn_backend_available(o->backend))
        return report_fault("--backend",
                            "%s is not available: the processor or this build of the "
                            "library lacks it",
                            gn_backend_name(o->backend));
    if (o->views != NULL && o->sort != SORT_FIRST)
        return report_usage(name, "--sort and --views cannot be used together: ranks divide the "
                                  "views, not their pictures");
    return check_number_options(which, o);
}

static void set_defaults(command which, options *o)
{
    static const float background[4] = {0.9294118f, 0.9333333f, 0.9372549f, 1.0f};
    memset(o, 0, sizeof *o);
    const bool is_wide = which == COMMAND_DEMO || which == COMMAND_VIEW;
    o->width = is_wide ? 800 : 1024;
    o->height = is_wide ? 600 : 1024;
    o->samples = 1;
    o->camera.up.y = 1.0f;
    o->camera.fov_degrees = DEFAULT_FOV_DEGREES;
    memcpy(o->background, background, sizeof background);
    o->tessellation = DEFAULT_TESSELLATION;
    o->axis = (gn_vec3){1.0f, 1.0f, 0.0f};
    o->frames = DEFAULT_FRAMES;
    o->rate = DEFAULT_RATE;
    o->limits = default_limits;
    gn_transform_identity(&o->world_from_all);
}

picture_format options_format(const options *o)
{
    picture_format format = o->format;
    if (!o->format_given)
        picture_format_of(o->output, &format);
    return format;
}

bool options_take_camera(const char *name, const char *value, camera_options *camera,
                         const char **expected)
{
    static const int taken[] = {OPTION_EYE,          OPTION_TARGET, OPTION_UP, OPTION_FOV,
                                OPTION_ORTHOGRAPHIC, OPTION_NEAR,   OPTION_FAR};
    options o;
    int option = 0;
    for (size_t i = 0; i < OPTION_COUNT; ++i)
        if (strcmp(option_table[i].name, name) == 0)
            option = option_table[i].value;
    for (size_t i = 0; i < sizeof taken / sizeof taken[0]; ++i) {
        if (taken[i] != option)
            continue;
        o.camera = *camera;
        *expected = take_value(option, value, &o);
        *camera = o.camera;
        return true;
    }
    return false;
}

/* The long options of a command, for getopt_long. Returns how many there are. */
static size_t list_options(command which, struct option list[OPTION_COUNT + 1])
{
    size_t count = 0;
    memset(list, 0, (OPTION_COUNT + 1) * sizeof *list);
    for (size_t i = 0; i < OPTION_COUNT; ++i) {
        if ((option_table[i].commands & (int)which) == 0)
            continue;
        list[count].name = option_table[i].name;
        list[count].has_arg = option_table[i].takes_value;
        list[count].val = option_table[i].value;
        ++count;
    }
    return count;
}

const char *options_name(command which, size_t index)
{
    struct option list[OPTION_COUNT + 1];
    return index < list_options(which, list) ? list[index].name : NULL;
}

/* An option as it is written; valid until the next call. */
static const char *written(int option)
{
    static char name[sizeof option_table[0].name + 2];
    size_t i = 0;
    while (option_table[i].value != option)
        ++i;
    snprintf(name, sizeof name, "--%s", option_table[i].name);
    return option == 'o' ? "-o" : name;
}

/* Prints what is wrong with the value of an option, and returns EXIT_USAGE. */
static int report_value(command which, int option, const char *text, const char *expected)
{
    const bool is_infinite = takes_floats(option) && parse_has_infinite(text);
    return report_usage(options_command_name(which), "%s '%s': not %s%s", written(option), text,
                        is_infinite ? "finite in 32 bits; it takes " : "", expected);
}

/* Takes the value of an option that takes a whole number. Returns 0, or the exit status with the
 * reason printed. */
static int take_whole(command which, int option, const whole_option *w, const char *text,
                      options *o)
{
    char expected[64];
    uint32_t number;
    snprintf(expected, sizeof expected, "%s from %u to %u", w->form, (unsigned)w->least,
             (unsigned)w->most);
    if (!parse_whole(text, &number))
        return report_value(which, option, text, expected);
    if (number < w->least || number > w->most)
        return report_fault(written(option), "impossible value '%s': not %s", text, expected);
    memcpy((char *)o + w->place, &number, sizeof number);
    return 0;
}

/* Takes a word that is no option. Returns 0, or EXIT_USAGE with the reason printed. */
static int take_word(command which, char *word, bool behind_points, options *o)
{
    const char *name = options_command_name(which);
    float size;
    if (which == COMMAND_DEMO)
        return report_usage(name, "'%s': demo takes no model", word);
    if (*word == '\0')
        return report_usage(name, "'': an empty file name");
    if (behind_points && parse_single(word, &size) && access(word, F_OK) != 0)
        return report_usage(name, "'%s': no such file; a size of points is written --points=%s",
                            word, word);
    if (o->model_count == OPTIONS_MAX_MODELS)
        return report_usage(name, "'%s': more than %d files", word, OPTIONS_MAX_MODELS);
    model_option *m = o->models + o->model_count++;
    m->path = word;
    m->world_from_model = o->world_from_all;
    o->model = o->models[0].path;
    return 0;
}

/* Takes an option that getopt_long has found. Returns 0, or the exit status with the reason
 * printed. */
static int take_option(command which, int option, const char *text, options *o)
{
    const whole_option *whole = whole_option_named(written(option) + 2);
    gn_status status = GN_OK;
    const char *expected;
    if (whole != NULL)
        return take_whole(which, option, whole, text, o);
    if (is_transformation(option))
        expected = take_transformation(option, text, o, &status);
    else
        expected = take_value(option, text, o);
    if (status != GN_OK)
        return report_fault(written(option), "impossible transformation '%s': %s", text,
                            gn_status_text(status));
    /* The teapot has maps of both kinds. */
    if (which == COMMAND_DEMO && option == OPTION_NORMAL_MAP &&
        (expected != NULL || strcmp(text, "any") == 0))
        expected = "tangent, world or none";
    return expected == NULL ? 0 : report_value(which, option, text, expected);
}

/* Reports the word that getopt_long has refused: it has returned `option`. */
static int report_word(command which, const struct option *list, int option, const char *word)
{
    const char *name = options_command_name(which);
    const bool is_long = strncmp(word, "--", 2) == 0;
    const size_t length = is_long ? strcspn(word + 2, "=") : 0;
    char found[256] = "";
    size_t count = 0;
    if (option == ':')
        return report_usage(name, "no value after '%s'", word);
    if (is_long && optopt != 0)
        return report_usage(name, "no value allowed in '%s'", word);
    for (const struct option *o = list; is_long && o->name != NULL; ++o) {
        const size_t at = strlen(found);
        if (strncmp(o->name, word + 2, length) == 0)
            snprintf(found + at, sizeof found - at, "%s--%s", count++ > 0 ? ", " : "", o->name);
    }
    if (count < 2)
        return report_usage(name, "unknown option '%s'", word);
    return report_usage(name, "'%s' is ambiguous: %s", word, found);
}

options_result options_parse(command which, int argc, char **argv, options *result,
                             int *exit_status)
{
    const char *name = options_command_name(which);
    struct option list[OPTION_COUNT + 1];
    const bool has_output = (which & OUTPUT_COMMANDS) != 0;
    int beside_state = 0;       /* the first option that does not go with --state */
    bool behind_points = false; /* --points stands before the word, without a size */
    list_options(which, list);
    set_defaults(which, result);
    opterr = 0;
    optind = 1;
    for (;;) {
        /* An unknown letter alone leaves optind at its word, so the word is remembered. */
        int word = optind < argc ? optind : argc - 1;
        int option = getopt_long(argc, argv, has_output ? "-:ho:" : "-:h", list, NULL);
        if (option == -1)
            break;
        if (option == 'h' || option == OPTION_HELP_ALL)
            return option == 'h' ? OPTIONS_HELP : OPTIONS_HELP_ALL;
        if (option == ':' || option == '?') {
            *exit_status =
                report_word(which, list, option, argv[optind > word ? optind - 1 : word]);
            return OPTIONS_WRONG;
        }
        *exit_status = option == WORD_ALONE ? take_word(which, optarg, behind_points, result)
                                            : take_option(which, option, optarg, result);
        if (*exit_status != 0)
            return OPTIONS_WRONG;
        behind_points = option == OPTION_POINTS && optarg == NULL;
        if (beside_state == 0 && !goes_with_state(option))
            beside_state = option;
    }
    for (; optind < argc; ++optind) { /* behind -- */
        *exit_status = take_word(which, argv[optind], false, result);
        if (*exit_status != 0)
            return OPTIONS_WRONG;
    }
    if (result->state != NULL && result->model_count > 0)
        *exit_status = report_usage(name, "--state and a model cannot be used together");
    else if (result->state != NULL && beside_state != 0)
        *exit_status =
            report_usage(name, "--state and %s cannot be used together", written(beside_state));
    else if ((which & MODEL_COMMANDS) != 0 && which != COMMAND_SPIN && result->model_count == 0 &&
             result->state == NULL)
        *exit_status = report_usage(name, "no model file");
    else if (which == COMMAND_INFO && result->model_count == 0)
        *exit_status = report_usage(name, "no file");
    else if (which == COMMAND_DIFF && result->model_count != 2)
        *exit_status = report_usage(name, "it takes two pictures, not %zu", result->model_count);
    else
        *exit_status = check(which, result);
    return *exit_status == 0 ? OPTIONS_READY : OPTIONS_WRONG;
}
