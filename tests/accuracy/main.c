/* make accuracy: errors of Gnomon's functions beside other libraries' for equal inputs, against
 * long double. Exit status 1 if another library is closer. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include <cglm/version.h>

#include "../command_line.h"
#include "peers.h"
#include "rows.h"

#define TEXT(x) #x
#define DOTTED(a, b, c) TEXT(a) "." TEXT(b) "." TEXT(c)
#define CGLM_VERSION DOTTED(CGLM_VERSION_MAJOR, CGLM_VERSION_MINOR, CGLM_VERSION_PATCH)

static const char help[] =
    "usage: accuracy [--seed S] [--inputs N]\n"
    "\n"
    "Prints the largest and the mean error of every function that another library has too,\n"
    "Gnomon's beside theirs: cglm's, and for scalar functions the C library's, which cglm calls.\n"
    "The unit is 2^-24 of the quantity in which the function's bound is stated\n"
    "(tests/accuracy/rows.h); for scalar functions it is one unit in the last place. Half of the\n"
    "inputs have magnitudes of 1/8 to 16, the others are small whole numbers, powers of two and\n"
    "their neighbours.\n"
    "Another library counts as closer in two cases: its mean error is smaller than Gnomon's by a\n"
    "twentieth (two orders of one sum differ by less) and by four standard errors, or its\n"
    "largest error is less than half of Gnomon's. That is a failure, unless Gnomon's contract\n"
    "fixes what causes the difference: the row then states it. '-': the library has no such\n"
    "function.\n"
    "\n"
    "GLM and Eigen are compared too if they are installed (make setup-cross) when this\n"
    "program is built; `make accuracy` then has columns for them.\n"
    "\n"
    "  --seed S     seed of the inputs; printed first (default: the time)\n"
    "  --inputs N   inputs for each function (default 200000)\n"
    "\n"
    "Exit status: 0: no library is closer anywhere, 1: one is, 2: wrong command line.\n";

enum { CGLM, MOST_PEERS = 3 };

static const struct peer *peers[MOST_PEERS];
static int peer_count;

/* The errors of one library in one row; `difference_squares` is of the errors, Gnomon's minus the
 * other library's. */
struct errors {
    double largest, sum, difference_squares;
};

/* The errors of one row over all inputs. */
struct measured {
    uint64_t count;
    struct errors own, other[MOST_PEERS];
};

typedef void call(float *in, float *out);

/* Null if the library has no such function. */
static call *function_of(const struct row *row, int peer)
{
    if (peer == CGLM)
        return row->other;
    for (size_t i = 0; i < peers[peer]->count; ++i)
        if (strcmp(peers[peer]->functions[i].row, row->name) == 0)
            return peers[peer]->functions[i].call;
    return NULL;
}

static double add_error(const struct row *row, const struct exact *exact, float *out,
                        struct errors *errors)
{
    settle_sign(row, exact, out);
    const double error = error_of(row, out, exact);
    errors->sum += error;
    errors->largest = fmax(errors->largest, error);
    return error;
}

static void measure(const struct row *row, uint64_t seed, uint64_t inputs, struct measured *m)
{
    uint64_t state = seed * 0x9E3779B97F4A7C15u + 1;
    call *functions[MOST_PEERS];
    memset(m, 0, sizeof *m);
    for (int peer = 0; peer < peer_count; ++peer)
        functions[peer] = function_of(row, peer);
    for (uint64_t i = 0; i < inputs; ++i) {
        float in[MOST_INPUTS] = {0}, copy[MOST_INPUTS], out[MOST_OUTPUTS];
        struct exact exact;
        make_inputs(row, i % 2 == 0 ? RANDOM : STRUCTURED, &state, in);
        if (!row->own(in, out))
            continue;
        evaluate(row, in, &exact);
        const double own_error = add_error(row, &exact, out, &m->own);
        ++m->count;
        for (int peer = 0; peer < peer_count; ++peer) {
            if (!functions[peer])
                continue;
            memcpy(copy, in, sizeof copy);
            functions[peer](copy, out);
            struct errors *const other = &m->other[peer];
            const double difference = own_error - add_error(row, &exact, out, other);
            other->difference_squares += difference * difference;
        }
    }
}

/* An infinite error of another library is never closer; an infinite error of Gnomon's is always
 * worse. */
static bool is_closer(const struct measured *m, const struct errors *other)
{
    const double n = (double)m->count;
    const double own_mean = m->own.sum / n, other_mean = other->sum / n;
    const double standard_error = sqrt(other->difference_squares) / n;
    if (m->count == 0 || !isfinite(own_mean))
        return true;
    if (!isfinite(other_mean))
        return false;
    return (own_mean - other_mean > 4.0 * standard_error &&
            own_mean - other_mean > 0.05 * other_mean) ||
           m->own.largest > 2.0 * other->largest;
}

static void print_errors(const struct errors *errors, double n)
{
    printf(" %9.4g %7.4f", errors->largest, errors->sum / n);
}

/* Prints the row; returns whether another library is closer and no contract fixes the reason. */
static bool print_row(const struct row *row, const struct measured *m)
{
    int closer = 0;
    printf("%-28s", row->name);
    print_errors(&m->own, (double)m->count);
    for (int peer = 0; peer < peer_count; ++peer)
        if (function_of(row, peer))
            print_errors(&m->other[peer], (double)m->count);
        else
            printf(" %9s %7s", "-", "-");
    for (int peer = 0; peer < peer_count; ++peer)
        if (function_of(row, peer) && is_closer(m, &m->other[peer]))
            printf("%s%s", closer++ == 0 ? "  closer: " : ", ", peers[peer]->name);
    if (closer > 0 && row->fixed)
        printf(" (%s)", row->fixed);
    putchar('\n');
    fflush(stdout);
    return closer > 0 && !row->fixed;
}

/* Prints the libraries; returns whether every function of theirs is in a row. */
static bool find_peers(const struct table *const *tables, size_t count)
{
    static const struct peer cglm = {"cglm", CGLM_VERSION, NULL, 0};
    const struct peer *const all[MOST_PEERS] = {&cglm, &glm_peer, &eigen_peer};
    bool known = true;
    for (int i = 0; i < MOST_PEERS; ++i)
        if (all[i])
            peers[peer_count++] = all[i];
        else
            printf("skipped: %s: not compared, since it was absent when this was built: "
                   "'make setup-cross' installs it\n",
                   i == 1 ? "GLM" : "Eigen");
    for (int peer = 0; peer < peer_count; ++peer) {
        for (size_t i = 0; i < peers[peer]->count; ++i) {
            const char *name = peers[peer]->functions[i].row;
            bool found = false;
            for (size_t t = 0; t < count; ++t)
                for (size_t r = 0; r < tables[t]->count; ++r)
                    found = found || strcmp(tables[t]->rows[r].name, name) == 0;
            if (!found)
                fprintf(stderr, "accuracy: %s: no row '%s'\n", peers[peer]->name, name);
            known = known && found;
        }
    }
    return known;
}

int main(int argc, char **argv)
{
    static const struct table *const tables[] = ALL_TABLES;
    uint64_t seed = (uint64_t)time(NULL), inputs = 200000;
    int functions = 0, closer = 0;
    const int terminal = isatty(STDERR_FILENO);
    const command_option known[] = {
        {"--seed", .number = &seed}, {"--inputs", .number = &inputs, .least = 1}, {NULL}};
    if (command_line_asks_help(argc, argv)) {
        fputs(help, stdout);
        return 0;
    }
    if (!command_line_read("accuracy", argc, argv, known, NULL))
        return 2;
    printf("accuracy: seed %" PRIu64 ", %" PRIu64 " inputs each\n", seed, inputs);
    const size_t table_count = sizeof tables / sizeof tables[0];
    if (!find_peers(tables, table_count))
        return 2;
    printf("compared with");
    for (int peer = 0; peer < peer_count; ++peer)
        printf("%s %s %s", peer == 0 ? "" : ",", peers[peer]->name, peers[peer]->version);
    printf("\n%-28s %9s %7s", "error in units of 2^-24", "largest", "mean");
    for (int peer = 0; peer < peer_count; ++peer)
        printf(" %9s %7s", peers[peer]->name, "mean");
    putchar('\n');
    for (size_t t = 0; t < table_count; ++t) {
        for (size_t i = 0; i < tables[t]->count; ++i) {
            const struct row *row = &tables[t]->rows[i];
            struct measured m;
            if (terminal)
                fprintf(stderr, "\r%s\033[K\r", row->name);
            measure(row, seed, inputs, &m);
            closer += print_row(row, &m);
            ++functions;
        }
    }
    printf("%d functions, %d where another library is closer\n", functions, closer);
    return closer > 0;
}
