/* Checks every correctly rounded scalar function for every float against references (references.c),
 * on all processors. */
#include <inttypes.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../../command_line.h"
#include "functions.h"
#include "sweep.h"

struct progress {
    const struct pass *passes;
    const double *costs;
    unsigned count, current;
    double started, total_cost;
    bool terminal;
    int last_tenth;
};

static void print_names(FILE *stream, const struct pass *pass)
{
    for (unsigned f = 0; f < pass->count; ++f)
        fprintf(stream, "%s%s", f > 0 ? ", " : "", pass->functions[f]->name);
}

/* The time left is estimated from the time that the finished part took, in proportion to the
 * costs. */
static void report(void *context, double done)
{
    struct progress *progress = context;
    double cost = progress->costs[progress->current] * done;
    for (unsigned i = 0; i < progress->current; ++i)
        cost += progress->costs[i];
    double part = cost / progress->total_cost, passed = seconds_now() - progress->started;
    int tenth = (int)(part * 10.0);
    if (part <= 0.0 || (!progress->terminal && tenth <= progress->last_tenth))
        return;
    progress->last_tenth = tenth;
    int left = (int)(passed / part - passed + 0.5);
    fprintf(stderr, "%s%3d %%  ", progress->terminal ? "\r\033[K" : "", (int)(part * 100.0));
    print_names(stderr, &progress->passes[progress->current]);
    fprintf(stderr, "  %d:%02d left%s", left / 60, left % 60, progress->terminal ? "" : "\n");
    fflush(stderr);
}

static bool share_a_reference(const checked_function *a, const checked_function *b)
{
    for (unsigned i = 0; i < 2; ++i) {
        for (unsigned j = 0; j < 2; ++j)
            if (a->references[i] == b->references[j] && a->references[i] != REFERENCE_NONE)
                return true;
    }
    return false;
}

static unsigned divide_into_passes(const bool chosen[], uint64_t stride, struct pass passes[])
{
    unsigned count = 0;
    const checked_function *previous = NULL;
    for (unsigned f = 0; f < checked_function_count; ++f) {
        const checked_function *function = &checked_functions[f];
        if (!chosen[f])
            continue;
        if (previous == NULL || !share_a_reference(previous, function)) {
            passes[count].count = 0;
            passes[count++].stride = stride;
        }
        struct pass *pass = &passes[count - 1];
        pass->functions[pass->count++] = previous = function;
    }
    return count;
}

/* Returns 0 if all are correctly rounded, 1 if some are not, 2 if the test could not run. */
static int run(const bool chosen[], uint64_t stride, unsigned jobs)
{
    static struct pass passes[MOST_FUNCTIONS];
    double costs[MOST_FUNCTIONS];
    uint64_t inputs = 0, misrounded = 0, decided = 0;
    unsigned functions = 0;
    struct progress progress = {.passes = passes,
                                .costs = costs,
                                .count = divide_into_passes(chosen, stride, passes),
                                .terminal = isatty(STDERR_FILENO)};
    for (unsigned i = 0; i < progress.count; ++i) {
        costs[i] = sweep_cost(&passes[i]);
        progress.total_cost += costs[i];
    }
    progress.started = seconds_now();
    for (unsigned i = 0; i < progress.count; ++i) {
        struct tally tally;
        progress.current = i;
        if (!sweep(&passes[i], jobs, report, &progress, &tally)) {
            fprintf(stderr, "exhaustive-scalars: no thread can be started\n");
            return 2;
        }
        if (progress.terminal)
            fprintf(stderr, "\r\033[K");
        for (unsigned f = 0; f < passes[i].count; ++f) {
            printf("%s: %" PRIu64 " inputs, %" PRIu64 " misrounded\n", passes[i].functions[f]->name,
                   tally.inputs, tally.misrounded[f]);
            inputs += tally.inputs;
            misrounded += tally.misrounded[f];
            ++functions;
        }
        fflush(stdout);
        decided += tally.decided;
    }
    double seconds = seconds_now() - progress.started;
    printf("%u functions, %" PRIu64 " inputs, %" PRIu64 " misrounded; MPFR decided %" PRIu64
           "; %.0f s in %u threads, %.1f ns an input and thread\n",
           functions, inputs, misrounded, decided, seconds, jobs,
           seconds * 1e9 * jobs / (double)inputs);
    return misrounded > 0;
}

static void help(FILE *stream)
{
    fprintf(stream,
            "usage: exhaustive-scalars [--stride N] [--jobs N] [NAME...]\n"
            "Checks that scalar functions are correctly rounded, for every float or for every\n"
            "N-th float of each sign. --jobs: number of threads (default: of processors).\n"
            "Names of functions (default: all):\n ");
    for (unsigned f = 0; f < checked_function_count; ++f)
        fprintf(stream, " %s", checked_functions[f].name);
    fprintf(stream,
            "\nExit status: 0: all are correctly rounded, 1: some are not, 2: it could not run.\n");
}

int main(int argc, char **argv)
{
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    uint64_t stride = 1;
    uint64_t jobs = processors < 1 ? 1 : processors > MOST_JOBS ? MOST_JOBS : (uint64_t)processors;
    bool chosen[MOST_FUNCTIONS] = {false}, any = false;
    for (int i = 1; i < argc; ++i) {
        unsigned f = 0;
        if (strcmp(argv[i], "--help") == 0) {
            help(stdout);
            return 0;
        }
        uint64_t *const number = strcmp(argv[i], "--stride") == 0 ? &stride
                                 : strcmp(argv[i], "--jobs") == 0 ? &jobs
                                                                  : NULL;
        if (number) {
            const char *const option = argv[i];
            if (!option_number("exhaustive-scalars", option, argv[++i], 1,
                               number == &jobs ? MOST_JOBS : UINT32_MAX, number))
                return 2;
            continue;
        }
        while (f < checked_function_count && strcmp(argv[i], checked_functions[f].name) != 0)
            ++f;
        if (f == checked_function_count) {
            fprintf(stderr, "exhaustive-scalars: cannot use '%s'\n", argv[i]);
            help(stderr);
            return 2;
        }
        chosen[f] = any = true;
    }
    for (unsigned f = 0; f < checked_function_count && !any; ++f)
        chosen[f] = true;
    return run(chosen, stride, (unsigned)jobs);
}
