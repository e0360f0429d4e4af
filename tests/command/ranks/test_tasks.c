/* Tasks over ranks: every task is done once, by whoever is free; results come in order; after a
 * fault nothing hangs, and all ranks know the status. usage: test_tasks LOG SEED ROUNDS */
#define _POSIX_C_SOURCE 200809L
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "ranks.h"
#include "report.h"
#include "tasks.h"

enum { MOST_TASKS = 80, NO_FAULT = MOST_TASKS, FAULT_STATUS = 7 };

/* What all ranks know about a round. */
typedef struct round {
    uint32_t seed, count, fault; /* the task that fails */
    bool has_results, take_fails;
    int log;
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
    char line[32];
    const int length = snprintf(line, sizeof line, "%u\n", (unsigned)number);
    if (write(r->log, line, (size_t)length) != length)
        r->wrong = true;
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

/* Whether the log has each task once; after a fault, not more than once. */
static bool log_is_good(const char *path, const round *r, bool failed)
{
    uint32_t times[MOST_TASKS] = {0};
    unsigned number;
    bool good = true;
    FILE *file = fopen(path, "r");
    while (fscanf(file, "%u", &number) == 1) {
        good = good && number < r->count;
        if (number < r->count)
            ++times[number];
    }
    fclose(file);
    for (uint32_t i = 0; i < r->count; ++i)
        good = good && (times[i] == 1 || (failed && times[i] == 0));
    return good;
}

/* Collective. */
static bool play(const char *path, uint32_t seed)
{
    round r = {.seed = seed, .fault = NO_FAULT};
    r.count = mix(seed) % MOST_TASKS;
    r.has_results = mix(seed + 1) % 2 == 0;
    if (mix(seed + 2) % 3 == 0 && r.count > 0)
        r.fault = mix(seed + 3) % r.count;
    r.take_fails = r.has_results && r.count > 0 && mix(seed + 4) % 4 == 0;
    if (ranks_number() == 0)
        fclose(fopen(path, "w"));
    ranks_wait_for_all();
    r.log = open(path, O_WRONLY | O_APPEND);
    const tasks_job job = {r.count, &r, work, r.has_results ? take : NULL};
    const bool fails = r.fault != NO_FAULT || r.take_fails;
    uint32_t here;
    const int status = tasks_run(&job, &here);
    close(r.log);
    bool good = !r.wrong && status == (fails ? FAULT_STATUS : 0);
    if (!fails && ranks_sum(here) != r.count)
        good = false;
    if (ranks_number() == 0)
        good =
            good && log_is_good(path, &r, fails) && (!r.has_results || fails || r.taken == r.count);
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
    if (ranks_begin(&argc, &argv) != 0 || argc != 4)
        return EXIT_USAGE;
    const uint32_t seed = (uint32_t)strtoul(argv[2], NULL, 10);
    const int rounds = atoi(argv[3]);
    int passed = 0;
    for (int i = 0; i < rounds; ++i)
        passed += play(argv[1], mix(seed) + (uint32_t)i);
    if (ranks_number() == 0)
        printf("tasks over %u ranks: %d passed, %d failed\n", (unsigned)ranks_count(), passed,
               rounds - passed);
    return ranks_end(passed == rounds ? 0 : 1);
}
