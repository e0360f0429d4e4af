/* The property tests: every suite, from one seed. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "properties.h"
#include "properties_draw.h"

static const char help[] =
    "usage: property-tests [--seed S] [--trials N]\n"
    "\n"
    "Runs every property of the mathematics and of drawing on random inputs, one line a\n"
    "property, and shrinks what fails. Exit status 0 where all hold, 1 otherwise.\n"
    "\n"
    "  --seed S     what the inputs are made from; printed first (default: the time)\n"
    "  --trials N   inputs a property (default 1000; those that draw take a tenth)\n";

static int parse(const char *text, uint64_t *number)
{
    char *end;

    errno = 0;
    *number = strtoull(text, &end, 0);
    return errno == 0 && end != text && *end == '\0' && *text != '-';
}

int main(int argc, char **argv)
{
    uint64_t seed = (uint64_t)time(NULL);
    uint64_t trials = 1000;

    for (int i = 1; i < argc; ++i) {
        if (strcmp(argv[i], "--help") == 0) {
            fputs(help, stdout);
            return EXIT_SUCCESS;
        }
        uint64_t *const number = strcmp(argv[i], "--seed") == 0     ? &seed
                                 : strcmp(argv[i], "--trials") == 0 ? &trials
                                                                    : NULL;
        if (!number || i + 1 == argc || !parse(argv[++i], number) || trials == 0) {
            fprintf(stderr, "property-tests: bad option %s; see --help\n", argv[i]);
            return 2;
        }
    }
    printf("properties: seed %" PRIu64 "\n", seed);
    fflush(stdout);
    const int failed = properties_math(seed, (size_t)trials) +
                       properties_models(seed, (size_t)trials) +
                       properties_projections(seed, (size_t)trials) +
                       properties_inverse(seed, (size_t)trials) +
                       properties_linear(seed, (size_t)trials) +
                       properties_quaternion(seed, (size_t)trials) +
                       properties_draw(seed, trials < 10 ? 1 : (size_t)(trials / 10));
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
