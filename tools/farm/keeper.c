/* The keeper reads notes from a pipe. The pipe ends when its rank has ended, whatever ended it. */
#include "keeper.h"

#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* How long a task may clean up after SIGTERM. */
static const struct timespec patience = {0, 500000000};

/* A pipe takes a note whole, since it is short (PIPE_BUF). */
typedef struct note {
    enum { WORKS, IS_IDLE, SAYS_NOTHING, ENDS } what;
    uint32_t rank;
    pid_t group; /* of the task that the rank works on */
    char task[128];
} note;

static pid_t keeper_process;

static void keep(int from, pid_t rank_process, const char *name)
{
    note last = {.what = IS_IDLE}, next;
    bool is_silent = true; /* until there is a rank with a number */
    /* Other files would keep open what the launcher waits for. */
    const long most = sysconf(_SC_OPEN_MAX);
    for (int i = 0; i < (most > 0 && most < 4096 ? most : 4096); ++i)
        if (i != from && i != STDERR_FILENO)
            close(i);
    /* Signals to the rank's group are not for the keeper. */
    setsid();
    signal(SIGTERM, SIG_IGN);
    signal(SIGINT, SIG_IGN);
    signal(SIGHUP, SIG_IGN);
    signal(SIGPIPE, SIG_IGN);
    while (read(from, &next, sizeof next) == (ssize_t)sizeof next) {
        is_silent = next.what == SAYS_NOTHING || next.what == ENDS;
        if (next.what != SAYS_NOTHING)
            last = next;
    }
    if (!is_silent && last.what == WORKS)
        dprintf(STDERR_FILENO,
                "%s: rank %u (process %ld) was killed; its task '%s' has no result\n", name,
                (unsigned)last.rank, (long)rank_process, last.task);
    else if (!is_silent)
        dprintf(STDERR_FILENO, "%s: rank %u (process %ld) was killed\n", name, (unsigned)last.rank,
                (long)rank_process);
    if (last.what == WORKS && kill(-last.group, SIGTERM) == 0) {
        nanosleep(&patience, NULL);
        kill(-last.group, SIGKILL);
    }
    _exit(0);
}

int keeper_begin(const char *name)
{
    int ends[2];
    const pid_t rank_process = getpid();
    if (pipe(ends) != 0)
        return -1;
    keeper_process = fork();
    if (keeper_process == 0) {
        close(ends[1]);
        keep(ends[0], rank_process, name);
    }
    close(ends[0]);
    if (keeper_process < 0 || fcntl(ends[1], F_SETFD, FD_CLOEXEC) != 0) {
        close(ends[1]);
        return -1;
    }
    return ends[1];
}

static void tell(int keeper, const note *told)
{
    ssize_t written = write(keeper, told, sizeof *told);
    (void)written;
}

void keeper_watch(int keeper, uint32_t rank, const char *task)
{
    note told = {.what = WORKS, .rank = rank, .group = getpid()};
    snprintf(told.task, sizeof told.task, "%s", task);
    tell(keeper, &told);
}

void keeper_forget(int keeper, uint32_t rank)
{
    const note told = {.what = IS_IDLE, .rank = rank};
    tell(keeper, &told);
}

void keeper_be_silent(int keeper)
{
    const note told = {.what = SAYS_NOTHING};
    tell(keeper, &told);
}

void keeper_end(int keeper)
{
    const note told = {.what = ENDS};
    tell(keeper, &told);
    close(keeper);
    waitpid(keeper_process, NULL, 0);
}
