/* The text of `gnomon transform`: any text has places of its points, or one line that says what is
 * wrong with it; every number that is printed is finite. */
#define _POSIX_C_SOURCE 200809L
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "fuzz.h"
#include "report.h"
#include "transform.h"

static int lines;

static void count_line(const char *line)
{
    ++lines;
    FUZZ_REQUIRE(strncmp(line, "gnomon: setup", 13) == 0);
}

static bool is_finite(gn_vec3 v)
{
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z);
}

/* The invariants of a point. */
static void require_sense(const place *p)
{
    FUZZ_REQUIRE(is_finite(p->local));
    FUZZ_REQUIRE(p->division != DIVIDED || (is_finite(p->ndc) && is_finite(p->pixel)));
    FUZZ_REQUIRE(p->division != DIVIDED || p->clip.w > 0.0f);
    FUZZ_REQUIRE(p->division != BEHIND_EYE || p->clip.w < 0.0f);
}

/* Prints into a file that has no name, and returns its text, which the caller frees. */
static char *printed(const setup *s, const places *p)
{
    FILE *const file = tmpfile();
    const int shown = dup(STDOUT_FILENO);

    FUZZ_REQUIRE(file && shown >= 0);
    fflush(stdout);
    FUZZ_REQUIRE(dup2(fileno(file), STDOUT_FILENO) >= 0);
    transform_print(s, p, true);
    fflush(stdout);
    const off_t size = lseek(fileno(file), 0, SEEK_END);
    FUZZ_REQUIRE(dup2(shown, STDOUT_FILENO) >= 0 && size >= 0);
    char *const text = fuzz_memory((size_t)size + 1);

    FUZZ_REQUIRE(pread(fileno(file), text, (size_t)size, 0) == (ssize_t)size);
    text[size] = '\0';
    close(shown);
    fclose(file);
    return text;
}

/* Returns how many words of a text are numbers; each is finite. */
static size_t count_numbers(char *text)
{
    size_t count = 0;

    for (char *word = strtok(text, " \n"); word; word = strtok(NULL, " \n")) {
        char *end;
        const double value = strtod(word, &end);

        if (end == word || (*end && !ispunct((unsigned char)*end)))
            continue;
        FUZZ_REQUIRE(isfinite(value));
        ++count;
    }
    return count;
}

/* At least the matrices, their inverses, and each point in four spaces and with its number. */
static size_t least_numbers(const places *p)
{
    return 16 * (8 + (p->has_combined ? 2 : 0)) + p->count * (1 + 3 + 3 + 3 + 4);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    FILE *const in = size ? fmemopen((void *)bytes, size, "r") : NULL;
    setup s;
    places p;

    if (!in)
        return -1;
    memset(&s, 0, sizeof s);
    memset(&p, 0, sizeof p);
    lines = 0;
    report_to(count_line);
    int fault = transform_read(in, "setup", &s);

    if (fault == 0)
        fault = transform_compute(&s, &p);
    FUZZ_REQUIRE((fault != 0) == (lines > 0) && lines < 2);
    if (fault == 0) {
        FUZZ_REQUIRE(p.count == s.points.count);
        for (size_t i = 0; i < p.count; ++i)
            require_sense(&p.all[i]);
        char *const text = printed(&s, &p);

        FUZZ_REQUIRE(count_numbers(text) >= least_numbers(&p));
        free(text);
    }
    transform_places_free(&p);
    transform_setup_free(&s);
    fclose(in);
    return 0;
}
