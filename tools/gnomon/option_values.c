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

bool parse_size(const char *text, uint32_t *width, uint32_t *height)
{
    return parse_signed(&text, width) && (*text == 'x' || *text == 'X') && *++text != '\0' &&
           parse_signed(&text, height) && *text == '\0';
}

bool parse_pair(const char *text, pair_option *result)
{
    return parse_count(&text, &result->x) && *text == ',' && *++text != '\0' &&
           parse_count(&text, &result->y) && *text == '\0';
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

bool parse_background(const char *text, options *o)
{
    const char *const comma = strchr(text, ',');
    char upper[16] = "";
    const size_t length = comma != NULL ? (size_t)(comma - text) : 0;
    o->background_is_gradient = comma != NULL;
    if (comma == NULL)
        return parse_color(text, o->background);
    if (length >= sizeof upper)
        return false;
    memcpy(upper, text, length);
    return parse_color(upper, o->background) && parse_color(comma + 1, o->background_below);
}

bool parse_word(const char *text, const char *words, int *result)
{
    const size_t length = strlen(text);
    for (int i = 0; *words != '\0'; ++i) {
        const size_t end = strcspn(words, " ");
        if (length == end && strncmp(text, words, end) == 0) {
            *result = i;
            return true;
        }
        words += end + (words[end] == ' ');
    }
    return false;
}

bool parse_map(const char *text, map_option *result)
{
    result->none = strcmp(text, "none") == 0;
    result->file = result->none ? NULL : text;
    return *text != '\0';
}

bool parse_normal_map(const char *text, const char *words, options *o)
{
    map_option *map = o->maps + MAP_NORMAL;
    char word[12] = "";
    int number;
    size_t length = strcspn(text, ":");
    if (length >= sizeof word)
        return false;
    memcpy(word, text, length);
    if (!parse_word(word, words, &number))
        return false;
    o->normals = strcmp(word, "tangent") == 0 ? NORMALS_TANGENT
                 : strcmp(word, "world") == 0 ? NORMALS_WORLD
                                              : NORMALS_ANY;
    map->none = strcmp(word, "none") == 0;
    map->file = text[length] == ':' ? text + length + 1 : NULL;
    return map->file == NULL || (*map->file != '\0' && o->normals != NORMALS_ANY);
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
    if (!(o->crease_degrees >= 0.0f && o->crease_degrees <= 180.0f))
        return report_fault("--crease", "impossible angle; it must be 0 to 180 degrees");
    return 0;
}
