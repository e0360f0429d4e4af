/* Runs the property in a child process, so that crashes and hangs are failures like any other. */
#define _POSIX_C_SOURCE 200809L
#include "theft_internal.h"

#if defined(__unix__) || defined(__APPLE__)

#include <errno.h>
#include <limits.h>
#include <poll.h>
#include <signal.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

bool runner_fork_available(void)
{
    return true;
}

static int64_t milliseconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000 + now.tv_nsec / 1000000;
}

/* Waits until the pipe is readable or closed by the child's end. Returns false after `limit`
 * milliseconds (negative: never). */
static bool wait_for_child(int pipe_end, int64_t limit)
{
    const int64_t deadline = milliseconds_now() + limit;
    for (;;) {
        int64_t left = -1;
        if (limit >= 0) {
            left = deadline - milliseconds_now();
            left = left < 0 ? 0 : left > INT_MAX ? INT_MAX : left;
        }
        struct pollfd poll_on = {.fd = pipe_end, .events = POLLIN};
        const int ready = poll(&poll_on, 1, (int)left);
        if (ready > 0)
            return true;
        if ((ready == 0 && milliseconds_now() >= deadline) || (ready < 0 && errno != EINTR))
            return false;
    }
}

/* The result goes through the pipe, not the exit status: handlers of sanitizers and signals exit
 * with small numbers too. */
static void run_child(struct theft *t, int pipe_end, enum theft_trial_res (*call)(struct theft *t))
{
    enum theft_trial_res result = THEFT_TRIAL_ERROR;
    const struct theft_hook_fork_post_info info = {
        .t = t,
        .prop_name = t->config.name,
        .total_trials = t->total_trials,
        .failures = t->report.fail,
        .run_seed = t->run_seed,
        .arity = t->arity,
        .args = t->trial.instances,
    };
    if (t->config.hooks.fork_post == NULL ||
        t->config.hooks.fork_post(&info, t->config.hooks.env) == THEFT_HOOK_FORK_POST_CONTINUE)
        result = call(t);
    fflush(NULL);
    const uint8_t byte = (uint8_t)result;
    _exit(write(pipe_end, &byte, 1) == 1 ? EXIT_SUCCESS : EXIT_FAILURE);
}

enum theft_trial_res runner_call_forked(struct theft *t,
                                        enum theft_trial_res (*call)(struct theft *t))
{
    int ends[2];
    if (pipe(ends) != 0) {
        runner_complain(t, "pipe failed");
        return THEFT_TRIAL_ERROR;
    }
    fflush(NULL);
    const pid_t child = fork();
    if (child < 0) {
        close(ends[0]);
        close(ends[1]);
        runner_complain(t, "fork failed");
        return THEFT_TRIAL_ERROR;
    }
    if (child == 0) {
        close(ends[0]);
        run_child(t, ends[1], call);
    }
    close(ends[1]);

    const size_t timeout = t->config.fork.timeout;
    const int64_t limit = timeout == 0 ? -1 : timeout > INT_MAX ? INT_MAX : (int64_t)timeout;
    if (!wait_for_child(ends[0], limit)) {
        const size_t grace = t->config.fork.exit_timeout == 0 ? THEFT_DEF_EXIT_TIMEOUT_MSEC
                                                              : t->config.fork.exit_timeout;
        kill(child, t->config.fork.signal == 0 ? SIGTERM : t->config.fork.signal);
        if (!wait_for_child(ends[0], grace > INT_MAX ? INT_MAX : (int64_t)grace))
            kill(child, SIGKILL);
    }
    uint8_t byte = 0;
    ssize_t got;
    do {
        got = read(ends[0], &byte, 1);
    } while (got < 0 && errno == EINTR);
    close(ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) {
            runner_complain(t, "waitpid failed");
            return THEFT_TRIAL_ERROR;
        }
    }
    if (!WIFEXITED(status) || WEXITSTATUS(status) != EXIT_SUCCESS)
        return THEFT_TRIAL_FAIL;
    return got == 1 ? (enum theft_trial_res)byte : THEFT_TRIAL_PASS;
}

#else

bool runner_fork_available(void)
{
    return false;
}

enum theft_trial_res runner_call_forked(struct theft *t,
                                        enum theft_trial_res (*call)(struct theft *t))
{
    (void)t;
    (void)call;
    return THEFT_TRIAL_ERROR;
}

#endif
