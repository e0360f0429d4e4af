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
    "Tests every property of the mathematics and of drawing with random inputs. Prints one line\n"
    "per property, and makes a failing input smaller. Exit status: 0: all properties hold, 1:\n"
    "one fails.\n"
    "\n"
    "  --seed S     seed of the inputs; printed first (default: the time)\n"
    "  --trials N   inputs for each property (default 1000; properties that draw take a tenth)\n";

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
    const int failed =
        properties_math(seed, (size_t)trials) + properties_scalar(seed, (size_t)trials) +
        properties_vectors(seed, (size_t)trials) + properties_inverse(seed, (size_t)trials) +
        properties_linear(seed, (size_t)trials) + properties_quaternion(seed, (size_t)trials) +
        properties_models(seed, (size_t)trials) + properties_projections(seed, (size_t)trials) +
        properties_geometry(seed, (size_t)trials) + properties_rays(seed, (size_t)trials) +
        properties_draw(seed, trials < 10 ? 1 : (size_t)(trials / 10));
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
