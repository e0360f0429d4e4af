/* The farm: a list of tasks over the ranks of MPI. Rank 0 hands tasks out and runs tasks itself; it
 * looks for messages while its own task runs as a process beside it, so no rank waits for a task of
 * another rank. Waiting ranks sleep: a rank that waited inside MPI would take the processor from
 * the tasks. */
#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "farm_options.h"
#include "keeper.h"
#include "ranks.h"
#include "report.h"
#include "result_file.h"
#include "task_list.h"
#include "task_run.h"

/* Milliseconds between two looks for messages. */
enum { PAUSE = 5 };

/* Kinds of messages: what has become of a task, and its line; the number of the next task. */
enum { OUTCOME = 1, LINE = 2, NEXT = 3 };

/* In place of a task's number: no task has been run yet; there are no more tasks. */
static const uint64_t none = UINT64_MAX;

typedef struct outcome {
    uint64_t task;
    uint64_t length; /* of the line with its '\0'; 0: no result */
    char ended[64];
} outcome;

typedef struct farm {
    farm_options options;
    task_list list;
    task_run run;

    /* Rank 0 alone uses these. */
    result_file results;
    size_t next;                 /* the task to hand out next */
    size_t running;              /* tasks that are running */
    size_t before, now, without; /* tasks that had a result, have got one, have ended without */
    uint32_t *idle;              /* ranks that wait for a task */
    uint32_t idle_count, gone;   /* gone: ranks that know that there are no more tasks */
    bool stopped;
    struct timespec began;
    double reported; /* when progress was printed last */
} farm;

static void sleep_a_little(void)
{
    poll(NULL, 0, PAUSE);
}

static void say(const farm *state, const char *what, const char *why)
{
    fflush(stdout);
    if (ranks_count() > 1)
        fprintf(stderr, "%s, rank %u: %s: %s\n", state->options.name, (unsigned)ranks_number(),
                what, why);
    else
        fprintf(stderr, "%s: %s: %s\n", state->options.name, what, why);
}

/* Ends all ranks; their keepers end the tasks. */
static void give_up(const farm *state, const char *what, const char *why)
{
    say(state, what, why);
    keeper_be_silent(state->run.keeper);
    ranks_abort(EXIT_FAULT);
}

static double seconds_since(const struct timespec *began)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)(now.tv_sec - began->tv_sec) + 1e-9 * (double)(now.tv_nsec - began->tv_nsec);
}

/* Rank 0 */

static void report_progress(farm *state)
{
    const double seconds = seconds_since(&state->began);
    const size_t ended = state->now + state->without;
    const size_t left = state->list.count - state->before - ended;
    if (left > 0 && seconds - state->reported < 1)
        return;
    state->reported = seconds;
    fprintf(stderr, "%s: %zu of %zu tasks, %.1f a minute, %.0f minutes left, %u ranks\n",
            state->options.name, state->before + state->now, state->list.count,
            60 * (double)ended / (seconds > 1e-3 ? seconds : 1e-3),
            ended > 0 ? seconds / (double)ended * (double)left / 60 : 0, (unsigned)ranks_count());
}

static void take_outcome(farm *state, uint32_t from, const outcome *came, const char *line)
{
    char reason[REASON_SIZE];
    const char *name = state->list.tasks[came->task].name;
    --state->running;
    if (came->length > 0) {
        if (!result_file_add(&state->results, line, reason))
            give_up(state, state->options.results, reason);
        ++state->now;
    } else {
        fprintf(stderr,
                "%s: task '%.200s', run by rank %u: %s, and no line that begins with its name\n",
                state->options.name, name, (unsigned)from, came->ended);
        ++state->without;
        state->stopped |= state->options.stop;
    }
    report_progress(state);
}

/* Returns the number of the next task, which is running from now on, or `none`. */
static uint64_t take_task(farm *state)
{
    while (state->next < state->list.count && state->list.tasks[state->next].done)
        ++state->next;
    if (state->stopped || state->next == state->list.count)
        return none;
    ++state->running;
    return state->next++;
}

/* Describes the task that this rank has run. */
static outcome own_outcome(const farm *state)
{
    outcome result = {.task = (uint64_t)(state->run.task - state->list.tasks)};
    if (state->run.has_result)
        result.length = strlen(state->run.result) + 1;
    snprintf(result.ended, sizeof result.ended, "%s", state->run.ended);
    return result;
}

static void start(farm *state, uint64_t number)
{
    char reason[REASON_SIZE];
    if (!task_start(&state->run, &state->list.tasks[number], ranks_number(), reason))
        give_up(state, state->list.tasks[number].name, reason);
}

static void take_messages(farm *state)
{
    static char line[LINE_MOST + 1];
    uint32_t from;
    while (ranks_waits(OUTCOME, &from)) {
        outcome came;
        ranks_receive(from, OUTCOME, &came, sizeof came);
        if (came.task != none) {
            if (came.length > 0)
                ranks_receive(from, LINE, line, came.length);
            take_outcome(state, from, &came, line);
        }
        state->idle[state->idle_count++] = from;
    }
}

static void answer_idle(farm *state)
{
    while (state->idle_count > 0) {
        const uint64_t number = take_task(state);
        /* A rank that knows that there are no more tasks waits inside MPI and takes a processor
         * from those that still run. So ranks are told when nothing runs any more. */
        if (number == none && state->running > 0)
            return;
        ranks_send(state->idle[--state->idle_count], NEXT, &number, sizeof number);
        state->gone += number == none;
    }
}

static void hand_out(farm *state)
{
    while (true) {
        take_messages(state);
        answer_idle(state);
        if (state->run.process == 0) {
            const uint64_t number = take_task(state);
            if (number != none)
                start(state, number);
            else if (state->running == 0 && state->gone == ranks_count() - 1)
                return;
            else
                sleep_a_little();
        } else if (task_has_ended(&state->run, PAUSE)) {
            const outcome own = own_outcome(state);
            take_outcome(state, 0, &own, state->run.result);
        }
    }
}

static int print_figures(const farm *state)
{
    const size_t left = state->list.count - state->before - state->now;
    printf(
        "%s: %zu tasks, %zu done now by %u ranks in %.1f s, %zu done before, %zu without a result, "
        "%zu not run\n",
        state->options.name, state->list.count, state->now, (unsigned)ranks_count(),
        seconds_since(&state->began), state->before, state->without, left - state->without);
    if (fflush(stdout) != 0) {
        say(state, "standard output", strerror(errno));
        return EXIT_FAULT;
    }
    return left == 0 ? 0 : EXIT_FAULT;
}

/* The other ranks */

static void work(farm *state)
{
    outcome sent = {.task = none};
    while (true) {
        uint64_t number;
        uint32_t from;
        ranks_send(0, OUTCOME, &sent, sizeof sent);
        if (sent.length > 0)
            ranks_send(0, LINE, state->run.result, sent.length);
        while (!ranks_waits(NEXT, &from))
            sleep_a_little();
        ranks_receive(0, NEXT, &number, sizeof number);
        if (number == none)
            return;
        start(state, number);
        while (!task_has_ended(&state->run, PAUSE))
            continue;
        sent = own_outcome(state);
    }
}

/* All ranks */

/* Rank 0 reads the list and the results; the others get the list's text from it. Returns whether
 * there is something to do or to say; if not, the reason has been printed. */
static bool read_list(farm *state)
{
    char reason[REASON_SIZE] = "";
    uint64_t size = 0;
    size_t length = 0;
    char *text = NULL;
    if (ranks_number() == 0) {
        text = read_whole(state->options.tasks, &length, reason);
        if (text == NULL)
            say(state, state->options.tasks, reason);
        size = text == NULL ? 0 : length + 1;
    }
    ranks_share(0, &size, sizeof size);
    if (size == 0)
        return false;
    if (ranks_number() != 0)
        text = malloc(size);
    if (text == NULL)
        give_up(state, state->options.tasks, "not enough memory");
    ranks_share(0, text, size);
    bool is_right = task_list_begin(&state->list, text, (size_t)size - 1, reason);
    if (!is_right && (ranks_number() == 0 || strcmp(reason, "not enough memory") == 0))
        say(state, state->options.tasks, reason);
    if (is_right && ranks_number() == 0) {
        is_right = result_file_open(&state->results, state->options.results, &state->list, reason);
        if (!is_right)
            say(state, state->options.results, reason);
    }
    return ranks_largest(!is_right) == 0;
}

static int run(farm *state)
{
    if (!read_list(state))
        return EXIT_FAULT;
    if (ranks_number() != 0) {
        work(state);
        return 0;
    }
    for (size_t i = 0; i < state->list.count; ++i) {
        state->list.tasks[i].done &= !state->options.again;
        state->before += state->list.tasks[i].done;
    }
    state->idle = calloc(ranks_count(), sizeof *state->idle);
    if (state->idle == NULL)
        give_up(state, state->options.tasks, "not enough memory");
    clock_gettime(CLOCK_MONOTONIC, &state->began);
    hand_out(state);
    return print_figures(state);
}

static int usage(const farm *state, const char *wrong)
{
    if (ranks_number() == 0)
        fprintf(stderr, "%s: %s (farm --help explains it)\n", state->options.name, wrong);
    return EXIT_USAGE;
}

static int begin(farm *state, int argc, char **argv)
{
    char wrong[256];
    if (!farm_options_read(&state->options, argc, argv, wrong))
        return usage(state, wrong);
    if (state->options.help) {
        if (ranks_number() == 0)
            fputs(farm_help, stdout);
        return fflush(stdout) == 0 ? 0 : EXIT_FAULT;
    }
    if (state->options.ranks > 0 && state->options.ranks != (long)ranks_count()) {
        snprintf(
            wrong, sizeof wrong,
            "%ld ranks are wanted, and there are %u; the launcher must be the one of the MPI that "
            "the farm is linked with",
            state->options.ranks, (unsigned)ranks_count());
        return usage(state, wrong);
    }
    return run(state);
}

int main(int argc, char **argv)
{
    static farm state;
    /* Ignored, as a parent may leave it, it would hide how tasks end. */
    signal(SIGCHLD, SIG_DFL);
    state.run.keeper = keeper_begin("farm");
    if (state.run.keeper < 0) {
        fprintf(stderr, "farm: a process cannot be started: %s\n", strerror(errno));
        return EXIT_FAULT;
    }
    const int keeper = state.run.keeper;
    /* Beyond a limit of the size of files, writing fails and is reported. */
    signal(SIGXFSZ, SIG_IGN);
    int status = ranks_begin(&argc, &argv);
    if (status == 0) {
        keeper_forget(keeper, ranks_number());
        status = ranks_end(begin(&state, argc, argv));
    }
    keeper_end(keeper);
    task_list_end(&state.list);
    free(state.idle);
    return status;
}
