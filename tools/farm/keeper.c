/* The keeper reads numbers of process groups from a pipe. The pipe ends when its rank has ended,
 * whatever ended it. */
#include "keeper.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* How long a task may clean up after SIGTERM. */
static const struct timespec patience = {0, 500000000};

static pid_t keeper_process;

static void keep(int from)
{
    pid_t group = 0, next;
    /* Other files would keep open what the launcher waits for. */
    const long most = sysconf(_SC_OPEN_MAX);
    for (int i = 0; i < (most > 0 && most < 4096 ? most : 4096); ++i)
        if (i != from)
            close(i);
    /* Signals to the rank's group are not for the keeper. */
    setsid();
    signal(SIGTERM, SIG_IGN);
    signal(SIGINT, SIG_IGN);
    signal(SIGHUP, SIG_IGN);
    while (read(from, &next, sizeof next) == (ssize_t)sizeof next)
        group = next;
    if (group > 0 && kill(-group, SIGTERM) == 0) {
        nanosleep(&patience, NULL);
        kill(-group, SIGKILL);
    }
    _exit(0);
}

int keeper_begin(void)
{
    int ends[2];
    if (pipe(ends) != 0)
        return -1;
    keeper_process = fork();
    if (keeper_process == 0) {
        close(ends[1]);
        keep(ends[0]);
    }
    close(ends[0]);
    if (keeper_process < 0 || fcntl(ends[1], F_SETFD, FD_CLOEXEC) != 0) {
        close(ends[1]);
        return -1;
    }
    return ends[1];
}

static void tell(int keeper, pid_t group)
{
    ssize_t written = write(keeper, &group, sizeof group);
    (void)written;
}

void keeper_watch(int keeper)
{
    tell(keeper, getpid());
}

void keeper_forget(int keeper)
{
    tell(keeper, 0);
}

void keeper_end(int keeper)
{
    close(keeper);
    waitpid(keeper_process, NULL, 0);
}
