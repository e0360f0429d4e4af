/* Chooses which properties run (selection.h). */
#include <ctype.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "selection.h"

enum { NAMES_MAX = 1024, NAME_SIZE = 128, NEAR_MAX = 4 };

static char names[NAMES_MAX][NAME_SIZE];
static bool chosen[NAMES_MAX];
static size_t name_count;
static bool has_chosen;

static void remember(const char *name)
{
    if (name_count == NAMES_MAX || strlen(name) >= NAME_SIZE) {
        fprintf(stderr, "property-tests: no room for the name of the property %s\n", name);
        exit(2);
    }
    strcpy(names[name_count], name);
    ++name_count;
}

bool selection_includes(const char *name)
{
    if (!has_chosen) {
        remember(name);
        return false;
    }
    for (size_t i = 0; i < name_count; ++i)
        if (strcmp(names[i], name) == 0)
            return chosen[i];
    return false;
}

size_t selection_choose(const char *only)
{
    size_t equal = 0, containing = 0;

    has_chosen = true;
    for (size_t i = 0; i < name_count; ++i) {
        equal += only && strcmp(names[i], only) == 0;
        containing += !only || strstr(names[i], only) != NULL;
    }
    for (size_t i = 0; i < name_count; ++i)
        chosen[i] = !only        ? true
                    : equal != 0 ? strcmp(names[i], only) == 0
                                 : strstr(names[i], only) != NULL;
    return equal ? equal : containing;
}

void selection_print(FILE *file)
{
    for (size_t i = 0; i < name_count; ++i)
        if (chosen[i])
            fprintf(file, "%s\n", names[i]);
}

static bool is_same_triple(const char *a, const char *b)
{
    for (int i = 0; i < 3; ++i)
        if (tolower((unsigned char)a[i]) != tolower((unsigned char)b[i]))
            return false;
    return true;
}

/* Returns how many of the runs of three characters of `only` occur in `name`. A wrong letter costs
 * three of them. */
static size_t in_common(const char *only, const char *name)
{
    size_t common = 0;

    for (const char *a = only; a[0] && a[1] && a[2]; ++a) {
        const char *b = name;
        while (b[0] && b[1] && b[2] && !is_same_triple(a, b))
            ++b;
        common += b[0] && b[1] && b[2];
    }
    return common;
}

void selection_print_near(const char *only, FILE *file)
{
    bool printed[NAMES_MAX] = {false};

    for (int count = 0; count < NEAR_MAX; ++count) {
        size_t best = 0, best_common = 0;
        for (size_t i = 0; i < name_count; ++i) {
            const size_t common = printed[i] ? 0 : in_common(only, names[i]);
            if (common > best_common) {
                best = i;
                best_common = common;
            }
        }
        if (best_common == 0)
            break;
        printed[best] = true;
        fprintf(file, "%s\"%s\"", count == 0 ? "; near it: " : ", ", names[best]);
    }
}
