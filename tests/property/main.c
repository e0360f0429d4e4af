/* Runs every suite of property tests from one seed. */
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../command_line.h"
#include "properties.h"
#include "properties_draw.h"
#include "selection.h"

static const char help[] =
    "usage: property-tests [--seed S] [--trials N] [--only NAME] [--list]\n"
    "\n"
    "Tests every property of the mathematics and of drawing with random inputs. Prints one line\n"
    "per property, and a last line with the sums; makes a failing input smaller. Exit status:\n"
    "0: all properties hold, 1: one fails, 2: an option is wrong.\n"
    "\n"
    "  --seed S     seed of the inputs; printed first (default: the time)\n"
    "  --trials N   inputs for each property (default 1000; properties that draw take a tenth)\n"
    "  --only NAME  runs the property of that name, or, if none has it, all whose names contain\n"
    "               NAME; the inputs are those of a run of all properties from the same seed\n"
    "  --list       prints the names of the properties, or of those that --only chooses\n";

/* Calls every suite; returns how many properties failed. */
static int run(uint64_t seed, size_t trials)
{
    return properties_math(seed, trials) + properties_scalar(seed, trials) +
           properties_vectors(seed, trials) + properties_inverse(seed, trials) +
           properties_linear(seed, trials) + properties_quaternion(seed, trials) +
           properties_models(seed, trials) + properties_projections(seed, trials) +
           properties_geometry(seed, trials) + properties_rays(seed, trials) +
           properties_draw(seed, trials < 10 ? 1 : trials / 10);
}

int main(int argc, char **argv)
{
    uint64_t seed = (uint64_t)time(NULL);
    uint64_t trials = 1000;
    const char *only = NULL;
    bool list = false;

    for (int i = 1; i < argc; ++i) {
        if (strcmp(argv[i], "--help") == 0) {
            fputs(help, stdout);
            return EXIT_SUCCESS;
        }
        if (strcmp(argv[i], "--list") == 0) {
            list = true;
            continue;
        }
        if (strcmp(argv[i], "--only") == 0) {
            only = argv[++i];
            if (!only) {
                fputs("property-tests: --only takes a name; see --help\n", stderr);
                return 2;
            }
            continue;
        }
        uint64_t *const number = strcmp(argv[i], "--seed") == 0     ? &seed
                                 : strcmp(argv[i], "--trials") == 0 ? &trials
                                                                    : NULL;
        if (!number) {
            fprintf(stderr, "property-tests: unknown option %s; see --help\n", argv[i]);
            return 2;
        }
        const char *const option = argv[i];
        if (!option_number("property-tests", option, argv[++i], number == &trials, UINT64_MAX,
                           number))
            return 2;
    }
    run(seed, (size_t)trials); /* nothing is chosen yet: collects the names */
    if (selection_choose(only) == 0) {
        fprintf(stderr, "property-tests: no property is named \"%s\", and no name contains it",
                only);
        selection_print_near(only, stderr);
        fputs("; --list prints all names\n", stderr);
        return 2;
    }
    if (list) {
        selection_print(stdout);
        return EXIT_SUCCESS;
    }
    printf("properties: seed %" PRIu64 "\n", seed);
    fflush(stdout);
    const int failed = run(seed, (size_t)trials);

    property_print_sum();
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
