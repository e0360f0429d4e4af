/* Parsers of the values of options, and checks of values that depend on others. */
#include "option_values.h"

#include <ctype.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "report.h"

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

bool parse_has_infinite(const char *text)
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

bool parse_single(const char *text, float *result)
{
    return parse_float(&text, result) && *text == '\0';
}

bool parse_vector(const char *text, gn_vec3 *result)
{
    return parse_float(&text, &result->x) && *text++ == ',' && parse_float(&text, &result->y) &&
           *text++ == ',' && parse_float(&text, &result->z) && *text == '\0';
}

bool parse_place(const char *text, gn_vec3 *result, double rest[3])
{
    if (!parse_vector(text, result))
        return false;
    const float rounded[3] = {result->x, result->y, result->z};
    for (int c = 0; c < 3; ++c) {
        char *end;
        rest[c] = strtod(text, &end) - (double)rounded[c];
        text = end + 1;
    }
    return true;
}

/* An axis at *text; moves *text behind it. */
static bool take_axis(const char **text, gn_vec3 *axis)
{
    const char letter = **text;
    if (letter >= 'x' && letter <= 'z') {
        *axis = (gn_vec3){letter == 'x', letter == 'y', letter == 'z'};
        ++*text;
        return true;
    }
    if (!parse_float(text, &axis->x) || *(*text)++ != ',' || !parse_float(text, &axis->y) ||
        *(*text)++ != ',')
        return false;
    return parse_float(text, &axis->z);
}

bool parse_axis(const char *text, gn_vec3 *axis)
{
    return take_axis(&text, axis) && *text == '\0';
}

bool parse_rotation(const char *text, gn_vec3 *axis, float *degrees)
{
    return take_axis(&text, axis) && *text++ == ',' && parse_single(text, degrees);
}

bool parse_scale(const char *text, gn_vec3 *factors)
{
    if (!parse_single(text, &factors->x))
        return parse_vector(text, factors);
    factors->y = factors->z = factors->x;
    return true;
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

/* As parse_count, but a minus may stand before the digits: the number is then 0. */
static bool parse_signed(const char **text, uint32_t *result)
{
    const bool is_negative = **text == '-';
    *text += is_negative;
    const bool good = parse_count(text, result);
    if (good && is_negative)
        *result = 0;
    return good;
}

bool parse_whole(const char *text, uint32_t *result)
{
    return parse_signed(&text, result) && *text == '\0';
}

const whole_option *whole_option_named(const char *name)
{
    /* A day is 86400 seconds, a TiB 1048576 MiB; the largest possible texture has 256 times
     * 1024x1024 pixels. */
    static const whole_option all[] = {
        {"exponent", "a whole number", 1, 1024, offsetof(options, exponent)},
        {"bands", "a whole number", 2, 256, offsetof(options, bands)},
        {"frames", "a whole number", 1, 100000, offsetof(options, frames)},
        {"rate", "a whole number", 1, 1000, offsetof(options, rate)},
        {"tessellation", "a whole number", 1, 128, offsetof(options, tessellation)},
        {"import-seconds", "a whole number", 1, 86400, offsetof(options, limits.seconds)},
        {"import-memory", "a whole number of MiB", 1, 1048576, offsetof(options, limits.memory)},
        {"import-output", "a whole number of MiB", 1, 1048576, offsetof(options, limits.output)},
        {"map-pixels", "a whole number", 1, 256, offsetof(options, limits.megapixels)},
    };
    for (size_t i = 0; i < sizeof all / sizeof all[0]; ++i)
        if (strcmp(all[i].name, name) == 0)
            return all + i;
    return NULL;
}

bool parse_size(const char *text, uint32_t *width, uint32_t *height)
{
    return parse_signed(&text, width) && (*text == 'x' || *text == 'X') && *++text != '\0' &&
           parse_signed(&text, height) && *text == '\0';
}

bool parse_pixel(const char *text, uint32_t *x, uint32_t *y)
{
    return parse_count(&text, x) && *text == ',' && *++text != '\0' && parse_count(&text, y) &&
           *text == '\0';
}

bool parse_color(const char *text, float color[4])
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

bool parse_word(const char *text, const char words[][12], int count, int *result)
{
    for (int i = 0; i < count; ++i) {
        if (strcmp(text, words[i]) == 0) {
            *result = i;
            return true;
        }
    }
    return false;
}

bool parse_map(const char *text, map_option *result)
{
    result->none = strcmp(text, "none") == 0;
    result->file = result->none ? NULL : text;
    return *text != '\0';
}

bool parse_normal_map(const char *text, options *o)
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

bool parse_backend(const char *text, gn_backend *result)
{
    for (int i = 0; i < GN_BACKEND_COUNT; ++i) {
        if (strcmp(text, gn_backend_name((gn_backend)i)) == 0) {
            *result = (gn_backend)i;
            return true;
        }
    }
    return false;
}

const char *parse_backend_names(void)
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

bool parse_cull(const char *text, gn_cull *result)
{
    static const char words[][12] = {"none", "back", "front"};
    static const gn_cull values[] = {GN_CULL_NONE, GN_CULL_BACK, GN_CULL_FRONT};
    int number;
    if (!parse_word(text, words, 3, &number))
        return false;
    *result = values[number];
    return true;
}

bool parse_filter(const char *text, filter_option *result)
{
    static const char words[][12] = {"mipmap", "linear", "nearest"};
    int number;
    if (!parse_word(text, words, 3, &number))
        return false;
    *result = (filter_option)number;
    return true;
}

bool parse_sort(const char *text, sort_option *result)
{
    static const char words[][12] = {"first", "last"};
    int number;
    if (!parse_word(text, words, 2, &number))
        return false;
    *result = (sort_option)number;
    return true;
}

int check_map_options(command which, const char *name, const options *o)
{
    static const char names[OPTIONS_MAP_COUNT][16] = {"texture", "normal-map", "specular-map",
                                                      "glow-map"};
    const shading_traits *traits = shading_traits_of(o->shading);
    const bool is_default = o->shading == SHADING_AUTOMATIC;
    const unsigned int takes = which == COMMAND_DEMO && is_default ? 0 : traits->maps;
    if (which == COMMAND_DEMO && o->maps[MAP_NORMAL].file != NULL)
        return report_usage(name,
                            "--normal-map takes no file here: the teapot has maps of its own");
    for (int i = 0; i < OPTIONS_MAP_COUNT; ++i) {
        const bool has_kind = i == MAP_NORMAL && o->normals != NORMALS_ANY;
        if (o->maps[i].file == NULL && !has_kind)
            continue;
        if (which == COMMAND_SPIN && o->model_count == 0)
            return report_usage(
                name, "--%s cannot be used without a model: the triangle takes no maps", names[i]);
        /* A key of view may choose a shader that takes normal maps of this kind. */
        if ((takes >> i & 1) == 0 && (o->maps[i].file != NULL || which != COMMAND_VIEW))
            return report_usage(name, "--%s cannot be used with %s%s, which has no such map",
                                names[i], is_default ? "the default shader" : "--shader ",
                                traits->name);
    }
    return 0;
}

int check_number_options(command which, const options *o)
{
    const bool is_tiled = which == COMMAND_RENDER && o->views == NULL;
    const uint32_t largest = is_tiled ? OPTIONS_MAX_TILED_SIZE : GN_MAX_SIZE;
    if (o->width < 1 || o->width > largest || o->height < 1 || o->height > largest)
        return report_fault("--size", "impossible size; width and height are 1 to %u pixels",
                            (unsigned)largest);
    if (o->samples != 1 && o->samples != GN_SAMPLES)
        return report_fault("--samples", "impossible number; it must be 1 or 4");
    if (o->points && !(o->point_size > 0.0f))
        return report_fault("--points", "impossible size; it must be above 0");
    return 0;
}
