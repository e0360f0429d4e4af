/* Parses the command line. */
#include "options.h"

#include <ctype.h>
#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gnomon/surface.h>

#include "report.h"

#define DEFAULT_FOV_DEGREES 40.0f
#define DEFAULT_TESSELLATION 16
#define MAX_TESSELLATION 128

/* A day; a TiB; the pixels of the largest possible texture. */
#define MAX_SECONDS 86400
#define MAX_MEBIBYTES (1 << 20)
#define MAX_MEGAPIXELS 256
static const import_limits default_limits = {30, 2048, 1024, 64};

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
    OPTION_MAP_PIXELS
};

#define MODEL_COMMANDS (COMMAND_RENDER | COMMAND_COMPARE)
#define ALL_COMMANDS (COMMAND_RENDER | COMMAND_COMPARE | COMMAND_DEMO)

static const struct {
    char name[20];
    bool takes_value;
    int value;
    int commands;
} option_table[] = {
    {"help", false, 'h', ALL_COMMANDS},
    {"output", true, 'o', ALL_COMMANDS},
    {"size", true, OPTION_SIZE, ALL_COMMANDS},
    {"eye", true, OPTION_EYE, MODEL_COMMANDS},
    {"target", true, OPTION_TARGET, MODEL_COMMANDS},
    {"up", true, OPTION_UP, MODEL_COMMANDS},
    {"fov", true, OPTION_FOV, MODEL_COMMANDS},
    {"orthographic", true, OPTION_ORTHOGRAPHIC, MODEL_COMMANDS},
    {"shader", true, OPTION_SHADER, ALL_COMMANDS},
    {"background", true, OPTION_BACKGROUND, MODEL_COMMANDS},
    {"light", true, OPTION_LIGHT, MODEL_COMMANDS},
    {"texture", true, OPTION_TEXTURE, MODEL_COMMANDS},
    {"normal-map", true, OPTION_NORMAL_MAP, ALL_COMMANDS},
    {"specular-map", true, OPTION_SPECULAR_MAP, MODEL_COMMANDS},
    {"glow-map", true, OPTION_GLOW_MAP, MODEL_COMMANDS},
    {"filter", true, OPTION_FILTER, ALL_COMMANDS},
    {"shadows", false, OPTION_SHADOWS, ALL_COMMANDS},
    {"exponent", true, OPTION_EXPONENT, ALL_COMMANDS},
    {"bands", true, OPTION_BANDS, ALL_COMMANDS},
    {"backend", true, OPTION_BACKEND, MODEL_COMMANDS},
    {"wireframe", false, OPTION_WIREFRAME, MODEL_COMMANDS},
    {"samples", true, OPTION_SAMPLES, ALL_COMMANDS},
    {"statistics", false, OPTION_STATISTICS, ALL_COMMANDS},
    {"depth", true, OPTION_DEPTH, COMMAND_RENDER},
    {"picture", true, OPTION_PICTURE, COMMAND_DEMO},
    {"tessellation", true, OPTION_TESSELLATION, COMMAND_DEMO},
    {"import-seconds", true, OPTION_IMPORT_SECONDS, MODEL_COMMANDS},
    {"import-memory", true, OPTION_IMPORT_MEMORY, MODEL_COMMANDS},
    {"import-output", true, OPTION_IMPORT_OUTPUT, MODEL_COMMANDS},
    {"map-pixels", true, OPTION_MAP_PIXELS, MODEL_COMMANDS},
};

#define OPTION_COUNT (sizeof option_table / sizeof option_table[0])

const char *options_command_name(command which)
{
    switch (which) {
    case COMMAND_RENDER:
        return "render";
    case COMMAND_COMPARE:
        return "compare";
    default:
        return "demo";
    }
}

/* Reads a finite float at *text and moves *text behind it. */
static bool parse_float(const char **text, float *result)
{
    char *end;
    if (isspace((unsigned char)**text))
        return false;
    double value = strtod(*text, &end);
    *result = (float)value;
    if (end == *text || !isfinite(*result))
        return false;
    *text = end;
    return true;
}

/* Whether the text is a list of numbers one of which is not finite as a float. */
static bool has_infinite(const char *text)
{
    char *end;
    for (;; text = end + 1) {
        float value = (float)strtod(text, &end);
        if (end == text || (*end != ',' && *end != '\0'))
            return false;
        if (!isfinite(value))
            return true;
        if (*end == '\0')
            return false;
    }
}

/* Whether an option takes floats. */
static bool takes_floats(int option)
{
    return option == OPTION_EYE || option == OPTION_TARGET || option == OPTION_UP ||
           option == OPTION_LIGHT || option == OPTION_FOV || option == OPTION_ORTHOGRAPHIC;
}

static bool parse_single(const char *text, float *result)
{
    return parse_float(&text, result) && *text == '\0';
}

static bool parse_vector(const char *text, gn_vec3 *result)
{
    return parse_float(&text, &result->x) && *text++ == ',' && parse_float(&text, &result->y) &&
           *text++ == ',' && parse_float(&text, &result->z) && *text == '\0';
}

/* Reads a whole number of digits only; numbers beyond 32 bits become UINT32_MAX. */
static bool parse_count(const char **text, uint32_t *result)
{
    uint64_t value = 0;
    if (!isdigit((unsigned char)**text))
        return false;
    for (; isdigit((unsigned char)**text); ++(*text)) {
        value = value * 10 + (uint64_t)(**text - '0');
        if (value > UINT32_MAX)
            value = UINT32_MAX;
    }
    *result = (uint32_t)value;
    return true;
}

static bool parse_within(const char *text, uint32_t least, uint32_t most, uint32_t *result)
{
    return parse_count(&text, result) && *text == '\0' && *result >= least && *result <= most;
}

static bool parse_size(const char *text, uint32_t *width, uint32_t *height)
{
    return parse_count(&text, width) && (*text == 'x' || *text == 'X') && *++text != '\0' &&
           parse_count(&text, height) && *text == '\0';
}

/* #rrggbb or #rrggbbaa. The # may be left out, since shells take it for a comment. */
static bool parse_color(const char *text, float color[4])
{
    if (*text == '#')
        ++text;
    size_t length = strlen(text);
    if ((length != 6 && length != 8) || strspn(text, "0123456789abcdefABCDEF") != length)
        return false;
    color[3] = 1.0f;
    for (size_t i = 0; i < length / 2; ++i) {
        char digits[3] = {text[2 * i], text[2 * i + 1], '\0'};
        color[i] = (float)strtoul(digits, NULL, 16) / 255.0f;
    }
    return true;
}

/* The number of a word in a list. */
static bool parse_word(const char *text, const char words[][12], int count, int *result)
{
    for (int i = 0; i < count; ++i) {
        if (strcmp(text, words[i]) == 0) {
            *result = i;
            return true;
        }
    }
    return false;
}

static bool parse_filter(const char *text, filter_option *result)
{
    static const char words[][12] = {"mipmap", "linear", "nearest"};
    int number;
    if (!parse_word(text, words, 3, &number))
        return false;
    *result = (filter_option)number;
    return true;
}

static bool parse_map(const char *text, map_option *result)
{
    result->none = strcmp(text, "none") == 0;
    result->file = result->none ? NULL : text;
    return *text != '\0';
}

/* `none`, or which of the existing maps, or a file with its kind before a colon. */
static bool parse_normal_map(const char *text, options *o)
{
    static const char words[][12] = {"any", "tangent", "world", "none"};
    map_option *map = o->maps + MAP_NORMAL;
    char word[12] = "";
    int number;
    size_t length = strcspn(text, ":");
    if (length >= sizeof word)
        return false;
    memcpy(word, text, length);
    if (!parse_word(word, words, 4, &number))
        return false;
    map->none = number == 3;
    map->file = text[length] == ':' ? text + length + 1 : NULL;
    o->normals = map->none ? NORMALS_ANY : (normal_option)number;
    return map->file == NULL || (*map->file != '\0' && (number == 1 || number == 2));
}

static bool parse_backend(const char *text, gn_backend *result)
{
    for (int i = 0; i < GN_BACKEND_COUNT; ++i) {
        if (strcmp(text, gn_backend_name((gn_backend)i)) == 0) {
            *result = (gn_backend)i;
            return true;
        }
    }
    return false;
}

/* "auto, portable, .. or wasm-simd128": every back end, present here or not. */
static const char *backend_names(void)
{
    static char names[GN_BACKEND_COUNT * 20];
    size_t end = 0;

    for (int i = 0; i < GN_BACKEND_COUNT; ++i)
        end += (size_t)snprintf(names + end, sizeof names - end, "%s%s",
                                i == 0                      ? ""
                                : i == GN_BACKEND_COUNT - 1 ? " or "
                                                            : ", ",
                                gn_backend_name((gn_backend)i));
    return names;
}

/* Reads the value of one option. Returns null, or a description of the expected value. */
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
        return parse_filter(text, &o->filter) ? NULL : "mipmap, linear or nearest";
    case OPTION_SHADOWS:
        o->shadows = true;
        return NULL;
    case OPTION_EXPONENT:
        return parse_within(text, 1, 1024, &o->exponent) ? NULL : "a whole number, 1 to 1024";
    case OPTION_BANDS:
        return parse_within(text, 2, 256, &o->bands) ? NULL : "a whole number, 2 to 256";
    case OPTION_WIREFRAME:
        o->wireframe = true;
        return NULL;
    case OPTION_STATISTICS:
        o->statistics = true;
        return NULL;
    case OPTION_SIZE:
        return parse_size(text, &o->width, &o->height) ? NULL : "WIDTHxHEIGHT, as in 800x600";
    case OPTION_SAMPLES:
        return parse_within(text, 1, GN_SAMPLES, &o->samples) &&
                       (o->samples == 1 || o->samples == GN_SAMPLES)
                   ? NULL
                   : "1 or 4";
    case OPTION_EYE:
        camera->eye_given = true;
        return parse_vector(text, &camera->eye) ? NULL : vector_form;
    case OPTION_TARGET:
        camera->target_given = true;
        return parse_vector(text, &camera->target) ? NULL : vector_form;
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
        return shading_by_name(text, &o->shading)
                   ? NULL
                   : "vertex-color, unlit, flat, gouraud, toon, phong, blinn-phong, normals or "
                     "depth";
    case OPTION_BACKEND:
        return parse_backend(text, &o->backend) ? NULL : backend_names();
    case OPTION_IMPORT_SECONDS:
        return parse_within(text, 1, MAX_SECONDS, &o->limits.seconds)
                   ? NULL
                   : "a whole number, 1 to 86400";
    case OPTION_IMPORT_MEMORY:
        return parse_within(text, 1, MAX_MEBIBYTES, &o->limits.memory)
                   ? NULL
                   : "a whole number of MiB, 1 to 1048576";
    case OPTION_IMPORT_OUTPUT:
        return parse_within(text, 1, MAX_MEBIBYTES, &o->limits.output)
                   ? NULL
                   : "a whole number of MiB, 1 to 1048576";
    case OPTION_MAP_PIXELS:
        return parse_within(text, 1, MAX_MEGAPIXELS, &o->limits.megapixels)
                   ? NULL
                   : "a whole number, 1 to 256";
    case OPTION_BACKGROUND:
        return parse_color(text, o->background) ? NULL : "#rrggbb or #rrggbbaa";
    default:
        return parse_count(&text, &o->tessellation) && *text == '\0' ? NULL : "a whole number";
    }
}

/* Checks options that are valid one by one against each other. Returns 0 if nothing is wrong. */
static int check(command which, const options *o)
{
    const char *name = options_command_name(which);
    const shading_traits *traits = shading_traits_of(o->shading);
    if (which == COMMAND_RENDER && o->output == NULL)
        return report_usage(name, "no output file; give one with -o OUT.png");
    if (o->camera.orthographic && o->camera.fov_given)
        return report_usage(name, "--fov and --orthographic cannot be used together");
    if (which == COMMAND_COMPARE && o->wireframe && o->samples > 1)
        return report_usage(name, "--wireframe and --samples cannot be used together: "
                                  "OSMesa loses pieces of such lines");
    for (int i = 0; i < MAP_COUNT; ++i) {
        static const char map_names[MAP_COUNT][16] = {"texture", "normal-map", "specular-map",
                                                      "glow-map"};
        if (o->maps[i].file != NULL && (traits->maps >> i & 1) == 0)
            return report_usage(name, "--%s cannot be used with --shader %s, which has no such map",
                                map_names[i], traits->name);
    }
    if (which == COMMAND_DEMO && o->maps[MAP_NORMAL].file != NULL)
        return report_usage(name,
                            "--normal-map takes no file here: the teapot has maps of its own");
    if (o->shadows && !traits->takes_shadows)
        return report_usage(name,
                            "--shadows cannot be used with --shader %s, which is not lit per pixel",
                            traits->name);
    if (!gn_backend_available(o->backend))
        return report_fault("--backend",
                            "%s is not available: the processor or this build of the "
                            "library lacks it",
                            gn_backend_name(o->backend));
    if (o->width < 1 || o->width > GN_MAX_SIZE || o->height < 1 || o->height > GN_MAX_SIZE)
        return report_fault("--size", "impossible size; width and height are 1 to %d pixels",
                            GN_MAX_SIZE);
    if (o->tessellation < 1 || o->tessellation > MAX_TESSELLATION)
        return report_fault("--tessellation", "impossible; it is 1 to %d", MAX_TESSELLATION);
    return 0;
}

static void set_defaults(command which, options *o)
{
    static const float background[4] = {0.9294118f, 0.9333333f, 0.9372549f, 1.0f};
    memset(o, 0, sizeof *o);
    o->width = which == COMMAND_DEMO ? 800 : 1024;
    o->height = which == COMMAND_DEMO ? 600 : 1024;
    o->samples = 1;
    o->camera.up.y = 1.0f;
    o->camera.fov_degrees = DEFAULT_FOV_DEGREES;
    memcpy(o->background, background, sizeof background);
    o->tessellation = DEFAULT_TESSELLATION;
    o->limits = default_limits;
}

options_result options_parse(command which, int argc, char **argv, options *result,
                             int *exit_status)
{
    const char *name = options_command_name(which);
    struct option long_options[OPTION_COUNT + 1];
    size_t count = 0;
    memset(long_options, 0, sizeof long_options);
    for (size_t i = 0; i < OPTION_COUNT; ++i) {
        if ((option_table[i].commands & (int)which) == 0)
            continue;
        long_options[count].name = option_table[i].name;
        long_options[count].has_arg = option_table[i].takes_value ? required_argument : no_argument;
        long_options[count].val = option_table[i].value;
        ++count;
    }

    set_defaults(which, result);
    *exit_status = EXIT_USAGE;
    opterr = 0;
    optind = 1;
    for (;;) {
        /* An unknown letter alone leaves optind at its word, so the word is remembered. */
        int word = optind < argc ? optind : argc - 1;
        int option = getopt_long(argc, argv, ":ho:", long_options, NULL);
        if (option == -1)
            break;
        if (option == 'h')
            return OPTIONS_HELP;
        if (option == ':' || option == '?') {
            const char *why = option == ':' ? "no value after" : "unknown option";
            if (option == '?' && optopt != 0 && optopt != 'o' && optopt > 255)
                why = "no value allowed in";
            report_usage(name, "%s '%s'", why, argv[optind > word ? optind - 1 : word]);
            return OPTIONS_WRONG;
        }
        const char *expected = take_value(option, optarg, result);
        if (expected != NULL) {
            const char *option_name = "-o";
            for (size_t i = 0; i < count; ++i)
                if (option != 'o' && long_options[i].val == option)
                    option_name = long_options[i].name;
            report_usage(
                name, "%s%s '%s': not %s%s", option == 'o' ? "" : "--", option_name, optarg,
                takes_floats(option) && has_infinite(optarg) ? "finite in 32 bits; it takes " : "",
                expected);
            return OPTIONS_WRONG;
        }
    }

    int model_count = argc - optind;
    if (which == COMMAND_DEMO && model_count > 0) {
        report_usage(name, "'%s': demo takes no model", argv[optind]);
        return OPTIONS_WRONG;
    }
    if (which != COMMAND_DEMO && model_count != 1) {
        if (model_count == 0)
            report_usage(name, "no model file");
        else
            report_usage(name, "'%s': one model at a time", argv[optind + 1]);
        return OPTIONS_WRONG;
    }
    result->model = which == COMMAND_DEMO ? NULL : argv[optind];
    *exit_status = check(which, result);
    return *exit_status == 0 ? OPTIONS_READY : OPTIONS_WRONG;
}
