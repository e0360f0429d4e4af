/* Reads views. */
#include "views.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files.h"
#include "option_values.h"
#include "report.h"

/* Longer than any path. */
#define PLACE_SIZE 4200

/* Ends the word at the beginning of *text, which is moved behind it. Returns the word, or null at
 * the end of the line and before a comment. */
static char *next_word(char **text)
{
    static const char blanks[] = " \t\r\v\f";
    char *word = *text + strspn(*text, blanks);
    if (*word == '\0' || *word == '#')
        return NULL;
    *text = word + strcspn(word, blanks);
    if (**text != '\0')
        *(*text)++ = '\0';
    return word;
}

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
        value = next_word(rest);
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
    while ((word = next_word(&line)) != NULL) {
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

/* Reads a text that ends with a zero. */
static int read_text(const char *path, char *text, size_t size, const camera_options *others,
                     views *result)
{
    char place[PLACE_SIZE];
    int fault = 0;
    size_t at = 0;
    for (uint64_t number = 1; at < size && fault == 0; ++number) {
        char *line = text + at, *end = memchr(line, '\n', size - at);
        const size_t length = end != NULL ? (size_t)(end - line) : size - at;
        camera_options asked;
        bool any = false;
        line[length] = '\0';
        snprintf(place, sizeof place, "%s:%llu", path, (unsigned long long)number);
        report_where(place);
        fault = strlen(line) == length ? read_line(line, others, &asked, &any)
                                       : wrong("view", "a zero byte is in the line");
        if (fault == 0 && any && result->count == VIEWS_MOST)
            fault = wrong("view", "more than 100000 views");
        else if (fault == 0 && any && !add(result, number, &asked))
            fault = report_fault("view", "not enough memory");
        report_where(NULL);
        at += length + 1;
    }
    return fault;
}

int views_read(const char *path, const camera_options *others, views *result)
{
    size_t size;
    const char *reason;
    memset(result, 0, sizeof *result);
    char *bytes = (char *)files_read(path, &size, &reason);
    char *text = bytes != NULL ? realloc(bytes, size + 1) : NULL;
    if (text == NULL) {
        if (bytes != NULL)
            reason = "not enough memory";
        free(bytes);
        return report_fault(path, "cannot be read: %s", reason);
    }
    text[size] = '\0';
    int fault = read_text(path, text, size, others, result);
    if (fault == 0 && result->count == 0)
        fault = wrong(path, "has no view; a line such as --eye 0,1,5 is one");
    free(text);
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
