/* Reads views. */
#include "views.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "option_values.h"
#include "report.h"
#include "text_lines.h"

/* Longer than any path. */
#define PLACE_SIZE 4200

static int wrong(const char *what, const char *reason)
{
    report_fault(what, "%s", reason);
    return EXIT_USAGE;
}

/* Takes an option, "--eye" or "--eye=VALUE", and its value from the rest of the line. */
static int take_option(char *word, char **rest, camera_options *asked)
{
    char *value = strchr(word, '=');
    const char *expected;
    camera_options ignored = *asked;
    if (value != NULL)
        *value++ = '\0';
    if (strncmp(word, "--", 2) != 0 || !options_take_camera(word + 2, "0", &ignored, &expected))
        return wrong(word, "not an option of a camera: --eye, --target, --up, --fov, "
                           "--orthographic, --near or --far");
    if (value == NULL)
        value = text_lines_word(rest);
    if (value == NULL)
        return wrong(word, "no value after it");
    options_take_camera(word + 2, value, asked, &expected);
    if (expected == NULL)
        return 0;
    report_fault(word, "'%s': not %s%s", value,
                 parse_has_infinite(value) ? "finite in 32 bits; it takes " : "", expected);
    return EXIT_USAGE;
}

/* Reads a line, which is changed. Sets *any to whether it has a view. */
static int read_line(char *line, const camera_options *others, camera_options *result, bool *any)
{
    /* Which projection the line asks for, as if there were no other options. */
    camera_options own = *others;
    own.fov_given = own.orthographic = false;
    char *word;
    *any = false;
    while ((word = text_lines_word(&line)) != NULL) {
        const int fault = take_option(word, &line, &own);
        if (fault != 0)
            return fault;
        *any = true;
    }
    if (own.fov_given && own.orthographic)
        return wrong("--fov", "cannot be used together with --orthographic");
    *result = own;
    if (!own.fov_given && !own.orthographic) {
        result->fov_given = others->fov_given;
        result->orthographic = others->orthographic;
    }
    return 0;
}

static bool add(views *v, uint64_t line, const camera_options *asked)
{
    /* Room for as many views again whenever their number is a power of two. */
    if ((v->count & (v->count - 1)) == 0) {
        view *list = realloc(v->list, (v->count > 0 ? 2 * (size_t)v->count : 1) * sizeof *list);
        if (list == NULL)
            return false;
        v->list = list;
    }
    v->list[v->count++] = (view){line, *asked};
    return true;
}

static int read_lines(const char *path, text_lines *text, const camera_options *others,
                      views *result)
{
    char place[PLACE_SIZE];
    char *line;
    int fault = 0;
    while (fault == 0 && (line = text_lines_next(text)) != NULL) {
        camera_options asked;
        bool any = false;
        snprintf(place, sizeof place, "%s:%llu", path, (unsigned long long)text->number);
        report_where(place);
        fault = text->has_zero ? wrong("view", "a zero byte is in the line")
                               : read_line(line, others, &asked, &any);
        if (fault == 0 && any && result->count == VIEWS_MOST)
            fault = wrong("view", "more than 100000 views");
        else if (fault == 0 && any && !add(result, text->number, &asked))
            fault = report_fault("view", "not enough memory");
        report_where(NULL);
    }
    return fault;
}

int views_read(const char *path, const camera_options *others, views *result)
{
    text_lines text;
    memset(result, 0, sizeof *result);
    int fault = text_lines_read(path, &text);
    if (fault == 0)
        fault = read_lines(path, &text, others, result);
    if (fault == 0 && result->count == 0)
        fault = wrong(path, "has no view; a line such as --eye 0,1,5 is one");
    text_lines_free(&text);
    return fault;
}

int views_check(const char *path, const views *v, const bounding_sphere *sphere, uint32_t width,
                uint32_t height)
{
    char place[PLACE_SIZE];
    camera placed;
    int fault = 0;
    for (uint32_t i = 0; i < v->count && fault == 0; ++i) {
        snprintf(place, sizeof place, "%s:%llu", path, (unsigned long long)v->list[i].line);
        report_where(place);
        fault = camera_place(&v->list[i].camera, sphere, width, height, &placed);
        report_where(NULL);
    }
    return fault;
}

void views_free(views *v)
{
    free(v->list);
    memset(v, 0, sizeof *v);
}
