/* make accuracy: errors of our functions beside another library's over the same inputs, against
 * long double. Exit status 1 where the other library is closer. */
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "rows.h"

static const char help[] =
    "usage: accuracy [--seed S] [--inputs N]\n"
    "\n"
    "Prints the largest and the mean error of every function that another library has too,\n"
    "ours beside theirs: cglm's, and of scalar functions the C library's, which cglm calls.\n"
    "The unit is 2^-24 of what the function's bound is stated in (tests/accuracy/rows.h), for\n"
    "scalar functions one unit in the last place. Inputs of magnitudes 1/8 to 16 and, every\n"
    "second one, small whole numbers, powers of two and neighbours.\n"
    "The other library is closer where its mean error is smaller than ours by a twentieth (two\n"
    "orders of the same sum differ by less) and by four standard errors, or its largest is less\n"
    "than half of ours.\n"
    "\n"
    "  --seed S     what the inputs are made from; printed first (default: the time)\n"
    "  --inputs N   for each function (default 200000)\n"
    "\n"
    "Exit status: 0 nowhere closer, 1 somewhere, 2 usage.\n";

/* Of one row over all inputs. `difference` is ours minus theirs. */
struct measured {
    uint64_t count;
    double own_largest, other_largest, own_sum, other_sum, difference_squares;
};

static void measure(const struct row *row, uint64_t seed, uint64_t inputs, struct measured *m)
{
    uint64_t state = seed * 0x9E3779B97F4A7C15u + 1;
    memset(m, 0, sizeof *m);
    for (uint64_t i = 0; i < inputs; ++i) {
        float in[MOST_INPUTS] = {0}, copy[MOST_INPUTS], own[MOST_OUTPUTS], other[MOST_OUTPUTS];
        struct exact exact;
        make_inputs(row, i % 2 == 0 ? RANDOM : STRUCTURED, &state, in);
        if (!row->own(in, own))
            continue;
        memcpy(copy, in, sizeof copy);
        row->other(copy, other);
        evaluate(row, in, &exact);
        const double own_error = error_of(row, own, &exact);
        const double other_error = error_of(row, other, &exact);
        ++m->count;
        m->own_sum += own_error;
        m->other_sum += other_error;
        m->difference_squares += (own_error - other_error) * (own_error - other_error);
        m->own_largest = fmax(m->own_largest, own_error);
        m->other_largest = fmax(m->other_largest, other_error);
    }
}

/* An infinite error of theirs is never closer, one of ours always worse. */
static int other_is_closer(const struct measured *m)
{
    const double n = (double)m->count;
    const double own_mean = m->own_sum / n, other_mean = m->other_sum / n;
    const double standard_error = sqrt(m->difference_squares) / n;
    if (m->count == 0 || !isfinite(own_mean))
        return 1;
    if (!isfinite(other_mean))
        return 0;
    return (own_mean - other_mean > 4.0 * standard_error &&
            own_mean - other_mean > 0.05 * other_mean) ||
           m->own_largest > 2.0 * m->other_largest;
}

static int parse(const char *text, uint64_t *number)
{
    char *end;
    if (text == NULL)
        return 0;
    errno = 0;
    *number = strtoull(text, &end, 0);
    return errno == 0 && end != text && *end == '\0' && *text != '-';
}

int main(int argc, char **argv)
{
    static const struct table *const tables[] = ALL_TABLES;
    uint64_t seed = (uint64_t)time(NULL), inputs = 200000;
    int functions = 0, closer = 0;
    const int terminal = isatty(STDERR_FILENO);
    for (int i = 1; i < argc; ++i) {
        if (strcmp(argv[i], "--help") == 0) {
            fputs(help, stdout);
            return 0;
        }
        uint64_t *const number = strcmp(argv[i], "--seed") == 0     ? &seed
                                 : strcmp(argv[i], "--inputs") == 0 ? &inputs
                                                                    : NULL;
        if (!number || !parse(argv[++i], number) || inputs == 0) {
            fprintf(stderr, "accuracy: bad option %s; see --help\n", argv[i < argc ? i : argc - 1]);
            return 2;
        }
    }
    printf("accuracy: seed %" PRIu64 ", %" PRIu64 " inputs each\n", seed, inputs);
    printf("%-28s %10s %10s %10s %10s\n", "error in units of 2^-24", "largest", "mean", "other's",
           "mean");
    for (size_t t = 0; t < sizeof tables / sizeof tables[0]; ++t) {
        for (size_t i = 0; i < tables[t]->count; ++i) {
            const struct row *row = &tables[t]->rows[i];
            struct measured m;
            if (terminal)
                fprintf(stderr, "\r%s\033[K\r", row->name);
            measure(row, seed, inputs, &m);
            const int worse = other_is_closer(&m);
            const double n = (double)m.count;
            printf("%-28s %10.3f %10.4f %10.3f %10.4f%s\n", row->name, m.own_largest, m.own_sum / n,
                   m.other_largest, m.other_sum / n, worse ? "  the other is closer" : "");
            fflush(stdout);
            ++functions;
            closer += worse;
        }
    }
    printf("%d functions, %d where another library is closer\n", functions, closer);
    return closer > 0;
}
