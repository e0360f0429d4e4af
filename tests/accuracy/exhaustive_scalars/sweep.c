/* A pass is cut into pieces that threads fetch one after the other. */
#include "sweep.h"

#include <errno.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <time.h>

#define SIGN_BIT 0x80000000u
#define MAGNITUDES ((uint64_t)1 << 31)
#define PIECES 4096u /* a power of two */
/* Pieces are taken in a scattered order: number times this, modulo PIECES. It is odd, so every
 * piece is taken once. */
#define SCATTER 1597u
#define SHOWN 10 /* misrounded inputs printed for each function */

struct shared {
    const struct pass *pass;
    pthread_mutex_t lock;
    pthread_cond_t finished;
    unsigned next, done, running;
    struct tally total;
};

struct block {
    unsigned count;
    uint32_t magnitudes[BLOCK];
    uint32_t expected[REFERENCE_COUNT][2][BLOCK]; /* by sign */
};

double seconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

static void show(const checked_function *function, float x, float got, uint32_t expected)
{
    fprintf(stderr, "\n%s(%a): %a, should be %a\n", function->name, (double)x, (double)got,
            (double)from_bits(expected));
}

static void check_block(const struct pass *pass, const struct block *block, struct tally *tally)
{
    for (unsigned f = 0; f < pass->count; ++f) {
        const checked_function *function = pass->functions[f];
        const reference *references = function->references;
        for (unsigned i = 0; i < 2 * block->count; ++i) {
            unsigned sign = i & 1, place = i >> 1;
            float x = from_bits(block->magnitudes[place] | (sign != 0 ? SIGN_BIT : 0));
            float got[2];
            uint32_t first = block->expected[references[0]][sign][place], second = 0;
            if (function->one != NULL) {
                got[0] = function->one(x);
                got[1] = 0.0f;
            } else {
                function->two(x, &got[0], &got[1]);
                second = block->expected[references[1]][sign][place];
            }
            if (bits_of(got[0]) != first || bits_of(got[1]) != second) {
                bool other = bits_of(got[0]) == first;
                if (tally->misrounded[f]++ < SHOWN)
                    show(function, x, got[other], other ? second : first);
            }
        }
    }
    tally->inputs += 2 * (uint64_t)block->count;
}

/* The magnitudes of [first, last) that are multiples of the stride. */
static void check_range(const struct pass *pass, uint64_t first, uint64_t last, uint64_t stride,
                        struct tally *tally)
{
    struct block block;
    uint64_t magnitude = (first + stride - 1) / stride * stride;
    while (magnitude < last) {
        bool known[REFERENCE_COUNT] = {[REFERENCE_NONE] = true};
        block.count = 0;
        for (; magnitude < last && block.count < BLOCK; magnitude += stride)
            block.magnitudes[block.count++] = (uint32_t)magnitude;
        for (unsigned f = 0; f < pass->count; ++f) {
            for (unsigned part = 0; part < 2; ++part) {
                reference which = pass->functions[f]->references[part];
                if (!known[which]) {
                    known[which] = true;
                    tally->decided +=
                        reference_values(which, block.magnitudes, block.count,
                                         block.expected[which][0], block.expected[which][1]);
                }
            }
        }
        check_block(pass, &block, tally);
    }
}

static void *work(void *argument)
{
    struct shared *shared = argument;
    struct tally own = {0};
    pthread_mutex_lock(&shared->lock);
    while (shared->next < PIECES) {
        uint64_t piece = shared->next++ * SCATTER % PIECES;
        pthread_mutex_unlock(&shared->lock);
        check_range(shared->pass, piece * (MAGNITUDES / PIECES),
                    (piece + 1) * (MAGNITUDES / PIECES), shared->pass->stride, &own);
        pthread_mutex_lock(&shared->lock);
        shared->done += 1;
    }
    shared->total.inputs += own.inputs;
    shared->total.decided += own.decided;
    for (unsigned f = 0; f < shared->pass->count; ++f)
        shared->total.misrounded[f] += own.misrounded[f];
    shared->running -= 1;
    pthread_cond_signal(&shared->finished);
    pthread_mutex_unlock(&shared->lock);
    return NULL;
}

bool sweep(const struct pass *pass, unsigned jobs, report_progress *report, void *context,
           struct tally *total)
{
    struct shared shared = {.pass = pass, .lock = PTHREAD_MUTEX_INITIALIZER};
    pthread_t threads[MOST_JOBS];
    unsigned started = 0;
    pthread_cond_init(&shared.finished, NULL);
    pthread_mutex_lock(&shared.lock);
    while (started < jobs && pthread_create(&threads[started], NULL, work, &shared) == 0)
        ++started;
    shared.running = started;
    while (shared.running > 0) {
        struct timespec wake;
        clock_gettime(CLOCK_REALTIME, &wake);
        wake.tv_nsec += 500000000;
        wake.tv_sec += wake.tv_nsec / 1000000000;
        wake.tv_nsec %= 1000000000;
        pthread_cond_timedwait(&shared.finished, &shared.lock, &wake);
        report(context, (double)shared.done / PIECES);
    }
    pthread_mutex_unlock(&shared.lock);
    for (unsigned i = 0; i < started; ++i)
        pthread_join(threads[i], NULL);
    pthread_cond_destroy(&shared.finished);
    *total = shared.total;
    return started > 0;
}

double sweep_cost(const struct pass *pass)
{
    const uint64_t stride = 99991; /* a prime */
    struct tally ignored = {0};
    double start = seconds_now();
    check_range(pass, 0, MAGNITUDES, stride, &ignored);
    return (seconds_now() - start) * (double)stride / (double)pass->stride;
}
