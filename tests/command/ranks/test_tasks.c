/* Tasks over ranks: every task is done once, by whoever is free; results come in order; after a
 * fault nothing hangs, and all ranks know the status. usage: test_tasks SEED ROUNDS */
#define _POSIX_C_SOURCE 200809L
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "ranks.h"
#include "report.h"
#include "tasks.h"

enum { MOST_TASKS = 60, NO_FAULT = MOST_TASKS, FAULT_STATUS = 7 };

/* What all ranks know about a round. */
typedef struct round {
    uint32_t seed, count, fault; /* the task that fails */
    bool has_results, take_fails;
    uint64_t done;  /* by this rank: bit N for task N */
    uint32_t taken; /* at rank 0 */
    bool wrong;
} round;

static uint32_t mix(uint32_t x)
{
    x = (x ^ x >> 16) * 0x7feb352du;
    x = (x ^ x >> 15) * 0x846ca68bu;
    return x ^ x >> 16;
}

/* A task has: its time in microseconds, and the size of its result. */
static uint32_t time_of(const round *r, uint32_t number)
{
    const uint32_t x = mix(r->seed ^ mix(number));
    return x % 4 == 0 ? 0 : x / 4 % 3000;
}

static uint32_t size_of(const round *r, uint32_t number)
{
    const uint32_t x = mix(r->seed + mix(number + 99));
    return x % 8 == 0 ? 0 : x % 3 == 0 ? x / 8 % 300000 : x / 8 % 300;
}

static void wait_microseconds(uint32_t count)
{
    const struct timespec time = {0, (long)count * 1000};
    nanosleep(&time, NULL);
}

static int work(void *context, tasks *t, uint32_t number, task_result *result)
{
    round *r = context;
    if (number >= r->count || (r->done >> number & 1) != 0)
        r->wrong = true;
    r->done |= UINT64_C(1) << number % 64;
    /* At rank 0, results up to here have been taken. */
    if (ranks_number() == 0 && r->has_results && number >= r->taken + 4 * ranks_count())
        r->wrong = true;
    for (int i = 0; i < 4; ++i) {
        wait_microseconds(time_of(r, number) / 4);
        tasks_poll(t);
    }
    if (number == r->fault)
        return FAULT_STATUS;
    if (r->has_results) {
        result->size = size_of(r, number);
        result->bytes = malloc((size_t)result->size + 1);
        memset(result->bytes, (int)(number & 255), (size_t)result->size);
    }
    return 0;
}

static int take(void *context, uint32_t number, const task_result *result)
{
    round *r = context;
    if (number != r->taken || ranks_number() != 0 || result->size != size_of(r, number))
        r->wrong = true;
    for (uint64_t i = 0; i < result->size; ++i)
        if (result->bytes[i] != (number & 255))
            r->wrong = true;
    ++r->taken;
    return r->take_fails && number == r->count / 2 ? FAULT_STATUS : 0;
}

/* Collective. Whether no task was done twice, and no fewer than `least`. N powers of two are all
 * different if their sum has N bits that are set. */
static bool are_done_once(const round *r, uint32_t least)
{
    uint32_t own = 0, bits = 0;
    for (uint64_t rest = r->done; rest != 0; rest &= rest - 1)
        ++own;
    for (uint64_t sum = ranks_sum(r->done); sum != 0; sum &= sum - 1)
        ++bits;
    return ranks_sum(own) == bits && bits >= least;
}

/* Collective. */
static bool play(uint32_t seed)
{
    round r = {.seed = seed, .fault = NO_FAULT};
    r.count = mix(seed) % MOST_TASKS;
    r.has_results = mix(seed + 1) % 2 == 0;
    if (mix(seed + 2) % 3 == 0 && r.count > 0)
        r.fault = mix(seed + 3) % r.count;
    r.take_fails = r.has_results && r.count > 0 && mix(seed + 4) % 4 == 0;
    const tasks_job job = {r.count, &r, work, r.has_results ? take : NULL};
    const bool fails = r.fault != NO_FAULT || r.take_fails;
    uint32_t here;
    const int status = tasks_run(&job, &here);
    bool good = are_done_once(&r, fails ? 0 : r.count);
    good = good && !r.wrong && status == (fails ? FAULT_STATUS : 0);
    if (!fails && ranks_sum(here) != r.count)
        good = false;
    if (ranks_number() == 0 && r.has_results && !fails && r.taken != r.count)
        good = false;
    if (ranks_largest(!good) == 0)
        return true;
    if (ranks_number() == 0)
        printf("FAILED: seed %u: %u tasks%s, fault at %u, status %d, %u taken\n", (unsigned)seed,
               (unsigned)r.count, r.has_results ? " with results" : "", (unsigned)r.fault, status,
               (unsigned)r.taken);
    return false;
}

int main(int argc, char **argv)
{
    if (ranks_begin(&argc, &argv) != 0 || argc != 3)
        return EXIT_USAGE;
    const uint32_t seed = (uint32_t)strtoul(argv[1], NULL, 10);
    const int rounds = atoi(argv[2]);
    int passed = 0;
    for (int i = 0; i < rounds; ++i)
        passed += play(mix(seed) + (uint32_t)i);
    if (ranks_number() == 0)
        printf("tasks over %u ranks: %d passed, %d failed\n", (unsigned)ranks_count(), passed,
               rounds - passed);
    return ranks_end(passed == rounds ? 0 : 1);
}
