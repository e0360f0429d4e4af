/* Parses the command line. */
#include "options.h"

#include <getopt.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "command_table.h"
#include "edit_distance.h"
#include "model.h"
#include "option_table.h"
#include "option_values.h"
#include "report.h"
#include "rotation.h"

#define DEFAULT_FOV_DEGREES 40.0f
#define DEFAULT_TESSELLATION 16

/* The commands whose pictures are meant to be looked at, not to be compared pixel by pixel, and the
 * one that explains their pixels. */
#define LOOKED_AT (COMMAND_RENDER | COMMAND_SPIN | COMMAND_VIEW | COMMAND_EXPLAIN)

/* Above this many pixels, one sample is the default: four take five times the memory. */
#define MOST_SMOOTH_PIXELS ((uint64_t)4096 * 4096)

#define DEFAULT_FRAMES 101
#define DEFAULT_RATE 25

static const import_limits default_limits = {30, 2048, 1024, 64};

/* What getopt_long returns for a word that is no option: its number in RETURN_IN_ORDER. */
#define WORD_ALONE 1

/* What getopt_long returns for an option: the number of its row above this. */
#define FIRST_ROW 256

/* Whether an option takes floats. */
static bool takes_floats(const option_row *row)
{
    return row->value.kind >= OPTION_NUMBER;
}

/* Whether an option counts beside --state, which says everything about the picture. */
static bool goes_with_state(const option_row *row)
{
    return row->commands == COMMAND_EXPLAIN || row->value.kind == OPTION_BACKEND;
}

/* Adds a transformation to the model in front of it; before the first model, to those of all
 * models. Returns whether the text is one; sets the status of the transformation. */
static bool take_transformation(option_kind kind, const char *text, options *o, gn_status *status)
{
    gn_transform *to =
        o->model_count > 0 ? &o->models[o->model_count - 1].world_from_model : &o->world_from_all;
    gn_transform next;
    gn_vec3 v;
    float degrees;
    if (kind == OPTION_ROTATE  ? !parse_rotation(text, &v, &degrees)
        : kind == OPTION_SCALE ? !parse_scale(text, &v)
                               : !parse_vector(text, &v))
        return false;
    *status = kind == OPTION_ROTATE  ? rotation_about(v, degrees, &next)
              : kind == OPTION_SCALE ? gn_scale(v, &next)
                                     : gn_translate(v, &next);
    if (*status == GN_OK)
        *status = gn_transform_compose(&next, to, to);
    return true;
}

/* Reads the value of an option, null if it has none. Returns whether it is one. */
static bool take_value(const option_row *row, const char *text, options *o)
{
    char *const at = (char *)o;
    void *const place = at + row->value.place;
    if (row->value.given != 0)
        *(bool *)(at + row->value.given) = true;
    switch (row->value.kind) {
    case OPTION_FLAG:
        *(bool *)place = true;
        return true;
    case OPTION_TEXT:
    case OPTION_FILE:
        *(const char **)place = text;
        return row->value.kind == OPTION_TEXT || *text != '\0';
    case OPTION_CHOICE:
        return parse_word(text, row->words, place);
    case OPTION_SHADER:
        return shading_by_name(text, place);
    case OPTION_BACKEND:
        return parse_backend(text, place);
    case OPTION_FORMAT:
        return picture_format_by_name(text, place) &&
               (*(picture_format *)place != PICTURE_RAW || strstr(row->words, "raw") != NULL);
    case OPTION_MAP:
        return parse_map(text, place);
    case OPTION_NORMAL_MAP:
        return parse_normal_map(text, row->words, o);
    case OPTION_SAMPLES:
        return parse_whole(text, place);
    case OPTION_SIZE:
        return parse_size(text, &o->width, &o->height);
    case OPTION_PAIR:
        ((pair_option *)place)->typed = text;
        return parse_pair(text, place);
    case OPTION_BACKGROUND:
        return parse_background(text, o);
    case OPTION_EDGES:
        o->edges = true;
        o->edges_color_given = text != NULL;
        return text == NULL || parse_color(text, o->edges_color);
    case OPTION_POINTS:
        o->points = true;
        o->point_size = 1.0f;
        return text == NULL || parse_single(text, &o->point_size);
    case OPTION_AXIS:
        return parse_axis(text, place);
    case OPTION_NUMBER:
        return parse_single(text, place);
    case OPTION_PLACE:
        return parse_place(text, place,
                           place == &o->camera.eye ? o->camera.eye_rest : o->camera.target_rest);
    default:
        return parse_vector(text, place);
    }
}

/* What the value of an option must be; valid until the next call. */
static const char *expected_value(const option_row *row)
{
    static char listed[128];
    if (row->value.form != NULL)
        return row->value.form;
    size_t at = 0;
    for (const char *word = row->words; *word != '\0' && at < sizeof listed;) {
        const size_t length = strcspn(word, " ");
        const char *next = word + length + (word[length] == ' ');
        const char *before = at == 0 ? "" : *next == '\0' ? " or " : ", ";
        at +=
            (size_t)snprintf(listed + at, sizeof listed - at, "%s%.*s", before, (int)length, word);
        word = next;
    }
    return listed;
}

/* Checks options that are valid one by one against each other. Returns 0 if nothing is wrong. */
static int check(command which, const options *o)
{
    const char *name = command_name(which);
    if (which == COMMAND_RENDER && o->output == NULL)
        return report_usage(name, "no output file; give one with -o OUT.png");
    if (which == COMMAND_EXPLAIN && o->pixel.typed == NULL)
        return report_usage(name, "no pixel; give one with --pixel X,Y");
    if (o->camera.orthographic && o->camera.fov_given)
        return report_usage(name, "--fov and --orthographic cannot be used together");
    if (o->wireframe && o->points)
        return report_usage(name, "--wireframe and --points cannot be used together");
    if (o->edges && (o->wireframe || o->points))
        return report_usage(name, "--edges and --%s cannot be used together",
                            o->wireframe ? "wireframe" : "points");
    if (o->format_given && o->output == NULL)
        return report_usage(name, "--format is for the output, which -o names");
    if (o->format_given && picture_has_suffix(o->output))
        return report_usage(
            name, "--format is for names without a suffix, such as -, and '%s' has one", o->output);
    if (which == COMMAND_COMPARE && (o->wireframe || o->edges || o->grid) && o->samples > 1)
        return report_usage(name,
                            "--%s and --samples cannot be used together: OSMesa loses pieces of "
                            "such lines",
                            o->wireframe ? "wireframe"
                            : o->edges   ? "edges"
                                         : "grid");
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
    o->samples = (which & LOOKED_AT) != 0 ? GN_SAMPLES : 1;
    o->camera.up.y = 1.0f;
    o->camera.fov_degrees = DEFAULT_FOV_DEGREES;
    memcpy(o->background, background, sizeof background);
    o->tessellation = DEFAULT_TESSELLATION;
    /* info counts the vertices of the file. */
    o->crease_degrees = which == COMMAND_INFO ? 180.0f : (float)MODEL_CREASE_DEGREES;
    o->axis = (gn_vec3){0.0f, 1.0f, 0.0f};
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
    const size_t begin = offsetof(options, camera), end = begin + sizeof *camera;
    for (const option_row *row = option_table; row < option_table + option_count; ++row) {
        options o;
        if (row->value.given < begin || row->value.given >= end || strcmp(row->name, name) != 0)
            continue;
        o.camera = *camera;
        *expected = take_value(row, value, &o) ? NULL : expected_value(row);
        *camera = o.camera;
        return true;
    }
    return false;
}

/* The long options of a command, for getopt_long, which sets numbers of rows. Returns a list that
 * is valid until the next call. */
static const struct option *list_options(command which)
{
    static struct option list[128];
    size_t count = 0;
    memset(list, 0, sizeof list);
    for (size_t i = 0; i < option_count; ++i) {
        const option_row *row = option_table + i;
        if ((row->commands & (int)which) == 0 || row->value.kind == OPTION_HEADING)
            continue;
        list[count].name = row->name;
        list[count].has_arg = row->argument == NULL     ? no_argument
                              : row->argument[0] == '[' ? optional_argument
                                                        : required_argument;
        list[count++].val = FIRST_ROW + (int)i;
    }
    return list;
}

/* The row of an option that getopt_long has found by its letter or its name. */
static const option_row *row_of(command which, int option)
{
    const option_row *row = option_table + (option >= FIRST_ROW ? option - FIRST_ROW : 0);
    while (option < FIRST_ROW &&
           ((row->commands & (int)which) == 0 || row->value.kind == OPTION_HEADING ||
            option_letter(row) != option))
        ++row;
    return row;
}

/* An option as it is written; valid until the next call. */
static const char *written(const option_row *row)
{
    static char name[24];
    snprintf(name, sizeof name, "--%s", row->name);
    return option_letter(row) == 'o' ? "-o" : name;
}

/* Prints what is wrong with the value of an option, and returns EXIT_USAGE. */
static int report_value(command which, const option_row *row, const char *text,
                        const char *expected)
{
    const bool is_infinite = takes_floats(row) && parse_has_infinite(text);
    return report_usage(command_name(which), "%s '%s': not %s%s", written(row), text,
                        is_infinite ? "finite in 32 bits; it takes " : "", expected);
}

/* Takes the value of an option that takes a whole number. Returns 0, or the exit status with the
 * reason printed. */
static int take_whole(command which, const option_row *row, const char *text, options *o)
{
    char expected[64];
    uint32_t number;
    snprintf(expected, sizeof expected, "%s from %u to %u", row->value.form,
             (unsigned)row->value.least, (unsigned)row->value.most);
    if (!parse_whole(text, &number))
        return report_value(which, row, text, expected);
    if (number < row->value.least || number > row->value.most)
        return report_fault(written(row), "impossible value '%s': not %s", text, expected);
    memcpy((char *)o + row->value.place, &number, sizeof number);
    return 0;
}

/* Takes a word that is no option. Returns 0, or EXIT_USAGE with the reason printed. */
static int take_word(command which, char *word, bool behind_points, options *o)
{
    const char *name = command_name(which);
    float size;
    if (which == COMMAND_DEMO)
        return report_usage(name, "'%s': demo takes no model", word);
    if (*word == '\0')
        return report_usage(name, "'': an empty file name");
    if (behind_points && parse_single(word, &size) && access(word, F_OK) != 0)
        return report_usage(name, "'%s': no such file; a size of points is written --points=%s",
                            word, word);
    if (which == COMMAND_TRANSFORM && o->model_count == 1)
        return report_usage(name, "'%s': only one setup", word);
    if (o->model_count == OPTIONS_MAX_MODELS)
        return report_usage(name, "'%s': more than %d files", word, OPTIONS_MAX_MODELS);
    model_option *m = o->models + o->model_count++;
    m->path = word;
    m->world_from_model = o->world_from_all;
    o->model = o->models[0].path;
    return 0;
}

/* Takes an option. Returns 0, or the exit status with the reason printed. */
static int take_option(command which, const option_row *row, const char *text, options *o)
{
    gn_status status = GN_OK;
    if (row->value.kind == OPTION_WHOLE)
        return take_whole(which, row, text, o);
    if (row->value.kind >= OPTION_ROTATE ? !take_transformation(row->value.kind, text, o, &status)
                                         : !take_value(row, text, o))
        return report_value(which, row, text, expected_value(row));
    return status == GN_OK ? 0
                           : report_fault(written(row), "impossible transformation '%s': %s", text,
                                          gn_status_text(status));
}

/* Reports the word that getopt_long has refused: it has returned `option`. */
static int report_word(command which, const struct option *list, int option, const char *word)
{
    const char *name = command_name(which);
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
    if (count < 2) {
        char typed[64];
        const char *meant = NULL;
        snprintf(typed, sizeof typed, "%.*s", (int)length, word + 2);
        for (const struct option *o = list; is_long && o->name != NULL; ++o)
            meant = edit_distance_nearer(typed, meant, o->name);
        return meant != NULL
                   ? report_usage(name, "unknown option '%s'; did you mean '--%s'?", word, meant)
                   : report_usage(name, "unknown option '%s'", word);
    }
    return report_usage(name, "'%s' is ambiguous: %s", word, found);
}

/* Checks what stands on the command line against what the command needs. Returns 0, or the exit
 * status with the reason printed. */
static int check_words(command which, const options *o, const option_row *beside_state)
{
    const char *name = command_name(which);
    const bool needs_model = (which & COMMANDS_OF_MODELS) != 0 && which != COMMAND_SPIN;
    if (o->state != NULL && o->model_count > 0)
        return report_usage(name, "--state and a model cannot be used together");
    if (o->state != NULL && beside_state != NULL)
        return report_usage(name, "--state and %s cannot be used together", written(beside_state));
    if (needs_model && o->model_count == 0 && o->state == NULL)
        return report_usage(name, "no model file");
    if (which == COMMAND_INFO && o->model_count == 0)
        return report_usage(name, "no file");
    if (which == COMMAND_DIFF && o->model_count != 2)
        return report_usage(name, "it takes two pictures, not %zu", o->model_count);
    return check(which, o);
}

options_result options_parse(command which, int argc, char **argv, options *result,
                             int *exit_status)
{
    const struct option *list = list_options(which);
    const bool has_output = (which & (COMMAND_EXPLAIN | COMMAND_INFO | COMMAND_TRANSFORM)) == 0;
    const option_row *beside_state = NULL; /* the first option that does not go with --state */
    bool behind_points = false;            /* --points stands before the word, without a size */
    set_defaults(which, result);
    *exit_status = 0;
    opterr = 0;
    optind = 1;
    while (*exit_status == 0) {
        /* An unknown letter alone leaves optind at its word, so the word is remembered. */
        int word = optind < argc ? optind : argc - 1;
        int option = getopt_long(argc, argv, has_output ? "-:ho:" : "-:h", list, NULL);
        if (option == -1)
            break;
        if (option == WORD_ALONE) {
            *exit_status = take_word(which, optarg, behind_points, result);
            behind_points = false;
            continue;
        }
        if (option == ':' || option == '?') {
            *exit_status =
                report_word(which, list, option, argv[optind > word ? optind - 1 : word]);
            break;
        }
        const option_row *row = row_of(which, option);
        if (row->value.kind <= OPTION_HELP_ALL)
            return row->value.kind == OPTION_HELP ? OPTIONS_HELP : OPTIONS_HELP_ALL;
        *exit_status = take_option(which, row, optarg, result);
        behind_points = row->value.kind == OPTION_POINTS && optarg == NULL;
        if (beside_state == NULL && !goes_with_state(row))
            beside_state = row;
    }
    for (; optind < argc && *exit_status == 0; ++optind) /* behind -- */
        *exit_status = take_word(which, argv[optind], false, result);
    if (!result->samples_given && (uint64_t)result->width * result->height > MOST_SMOOTH_PIXELS)
        result->samples = 1;
    if (*exit_status == 0)
        *exit_status = check_words(which, result, beside_state);
    return *exit_status == 0 ? OPTIONS_READY : OPTIONS_WRONG;
}
