/* Runs every suite of property tests from one seed. */
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../command_line.h"
#include "properties.h"

static const char help[] =
    "usage: property-tests [--seed S] [--trials N] [--only NAME] [--list]\n"
    "\n"
    "Tests every property of the mathematics and of drawing with random inputs. Prints one line\n"
    "per property, and a last line with the sums; makes a failing input smaller. Exit status:\n"
    "0: all properties hold, 1: one fails, 2: an option is wrong.\n"
    "\n"
    "  --seed S     seed of the inputs; printed first (default: the time)\n"
    "  --trials N   inputs for each property (default 1000; most that draw take a tenth)\n"
    "  --only NAME  runs the properties whose names begin with NAME, on the inputs of a run of "
    "all\n"
    "  --list       prints the names of the properties, or of those that --only chooses\n";

static const suite *const suites[] = {
    &properties_scalar,   &properties_vectors,    &properties_matrices, &properties_transforms,
    &properties_inverse,  &properties_quaternion, &properties_models,   &properties_projections,
    &properties_geometry, &properties_rays,       &properties_edges,    &properties_memory,
    &properties_scenes,   &properties_textures,   &properties_lookup,   &properties_indices};

/* Hooks that keep theft quiet. */

static enum theft_hook_run_pre_res quiet_pre(const struct theft_hook_run_pre_info *info, void *env)
{
    (void)info;
    (void)env;
    return THEFT_HOOK_RUN_PRE_CONTINUE;
}

static enum theft_hook_trial_post_res quiet_post(const struct theft_hook_trial_post_info *info,
                                                 void *env)
{
    (void)info;
    (void)env;
    return THEFT_HOOK_TRIAL_POST_CONTINUE;
}

/* After the first failure of a property, more failures seldom show anything new. */
static enum theft_hook_trial_pre_res stop_at_failure(const struct theft_hook_trial_pre_info *info,
                                                     void *env)
{
    (void)env;
    return info->failures > 0 ? THEFT_HOOK_TRIAL_PRE_HALT : THEFT_HOOK_TRIAL_PRE_CONTINUE;
}

static enum theft_hook_run_post_res keep_report(const struct theft_hook_run_post_info *info,
                                                void *env)
{
    *(struct theft_run_report *)env = info->report;
    return THEFT_HOOK_RUN_POST_CONTINUE;
}

static size_t holding, failing, inputs;

/* So many inputs more may be skipped, for properties with few. */
#define FEW 3

/* Prints one line. A property that skips more than half of its inputs has shown little and fails
 * too. Measured: at most 30 of 100. */
static void run(property p, uint64_t seed, uint64_t trials)
{
    struct theft_run_report report = {0, 0, 0, 0};
    const uint64_t percent = p.trials > 0 ? p.trials : 100;

    p.seed = seed;
    p.trials = (size_t)(trials / 100 * percent + (trials % 100 * percent + 99) / 100);
    p.hooks.run_pre = quiet_pre;
    p.hooks.trial_pre = stop_at_failure;
    p.hooks.trial_post = quiet_post;
    p.hooks.run_post = keep_report;
    p.hooks.env = &report;
    const bool holds = theft_run(&p) == THEFT_RUN_PASS && report.skip <= p.trials / 2 + FEW;
    holding += holds;
    failing += !holds;
    inputs += report.pass + report.fail;
    if (holds)
        printf("properties: %s ... PASS (%zu trials)\n", p.name, report.pass);
    else
        printf("properties: %s ... FAIL (seed 0x%" PRIx64
               ", %zu passed, %zu failed, %zu skipped)\n",
               p.name, seed, report.pass, report.fail, report.skip);
    fflush(stdout);
}

int main(int argc, char **argv)
{
    uint64_t seed = (uint64_t)time(NULL), trials = 1000;
    size_t chosen = 0;
    const char *only = "";
    bool list = false;

    for (int i = 1; i < argc; ++i) {
        const char *const option = argv[i];
        uint64_t *const number = strcmp(option, "--seed") == 0     ? &seed
                                 : strcmp(option, "--trials") == 0 ? &trials
                                                                   : NULL;
        if (strcmp(option, "--help") == 0) {
            fputs(help, stdout);
            return EXIT_SUCCESS;
        } else if (strcmp(option, "--list") == 0) {
            list = true;
        } else if (strcmp(option, "--only") == 0 && argv[i + 1]) {
            only = argv[++i];
        } else if (!number) {
            fprintf(stderr, "property-tests: no option, or no name after it: %s; see --help\n",
                    option);
            return 2;
        } else if (!option_number("property-tests", option, argv[++i], number == &trials,
                                  UINT64_MAX, number)) {
            return 2;
        }
    }
    if (!list)
        printf("properties: seed %" PRIu64 "\n", seed);
    for (size_t s = 0; s < sizeof suites / sizeof *suites; ++s)
        for (size_t k = 0; k < suites[s]->count; ++k) {
            const property *const p = &suites[s]->properties[k];
            if (strncmp(p->name, only, strlen(only)) != 0)
                continue;
            ++chosen;
            if (list)
                puts(p->name);
            else
                run(*p, seed, trials);
        }
    if (chosen == 0) {
        fprintf(stderr, "property-tests: no property's name begins with \"%s\"; see --list\n",
                only);
        return 2;
    }
    if (!list)
        printf("properties: %zu hold, %zu fail, %zu inputs\n", holding, failing, inputs);
    return failing ? EXIT_FAILURE : EXIT_SUCCESS;
}
