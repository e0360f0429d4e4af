/* Starts the shell for a task, reads what it prints, and waits for its end without blocking. */
#include "task_run.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "keeper.h"
#include "launched.h"
#include "result_file.h"

/* Becomes the task. */
static void be_task(const task_run *run, int output, uint32_t rank)
{
    char number[16];
    const int nothing = open("/dev/null", O_RDONLY);
    setpgid(0, 0);
    signal(SIGPIPE, SIG_IGN);
    keeper_watch(run->keeper, rank, run->task->name);
    signal(SIGPIPE, SIG_DFL);
    signal(SIGXFSZ, SIG_DFL);
    snprintf(number, sizeof number, "%u", (unsigned)rank);
    if (nothing < 0 || dup2(nothing, STDIN_FILENO) < 0 || dup2(output, STDOUT_FILENO) < 0 ||
        setenv("FARM_RANK", number, 1) != 0)
        _exit(127);
    /* Files of the launcher and of MPI are not the task's. */
    for (int i = 3; i < 1024; ++i)
        close(i);
    /* A program that is linked with MPI would otherwise take itself for one of the ranks. */
    launched_forget();
    execl("/bin/sh", "sh", "-c", run->task->command, (char *)NULL);
    _exit(127);
}

bool task_start(task_run *run, const task *started, uint32_t rank, char reason[REASON_SIZE])
{
    int ends[2];
    run->task = started;
    run->rank = rank;
    run->length = 0;
    run->has_result = false;
    if (pipe(ends) != 0) {
        snprintf(reason, REASON_SIZE, "%s", strerror(errno));
        return false;
    }
    fcntl(ends[0], F_SETFL, O_NONBLOCK);
    fflush(NULL);
    run->process = fork();
    if (run->process == 0)
        be_task(run, ends[1], rank);
    close(ends[1]);
    run->output = ends[0];
    if (run->process > 0)
        return true;
    snprintf(reason, REASON_SIZE, "%s", strerror(errno));
    run->process = 0;
    close(ends[0]);
    return false;
}

static void end_line(task_run *run)
{
    if (run->length <= LINE_MOST) {
        run->line[run->length] = '\0';
        if (strlen(run->line) == run->length && is_result(run->line, run->task->name)) {
            memcpy(run->result, run->line, run->length + 1);
            run->has_result = true;
        }
    }
    run->length = 0;
}

/* Returns whether there may be more to read. */
static bool read_some(task_run *run)
{
    char bytes[4096];
    const ssize_t count = read(run->output, bytes, sizeof bytes);
    if (count <= 0)
        return count < 0 && errno == EINTR;
    for (ssize_t i = 0; i < count; ++i)
        if (bytes[i] == '\n')
            end_line(run);
        else if (run->length < LINE_MOST)
            run->line[run->length++] = bytes[i];
        else
            run->length = LINE_MOST + 1;
    return true;
}

bool task_has_ended(task_run *run, int milliseconds)
{
    struct pollfd output = {.fd = run->output, .events = POLLIN};
    int status;
    if (poll(&output, 1, milliseconds) > 0 && !read_some(run))
        poll(NULL, 0, milliseconds); /* the task has closed its output and still runs */
    if (waitpid(run->process, &status, WNOHANG) != run->process)
        return false;
    keeper_forget(run->keeper, run->rank);
    /* A pipe holds 64 KiB. What the task has left running may go on writing. */
    for (int i = 0; i < 64 && read_some(run); ++i)
        continue;
    close(run->output);
    run->process = 0;
    if (WIFSIGNALED(status))
        snprintf(run->ended, sizeof run->ended, "signal %d", WTERMSIG(status));
    else
        snprintf(run->ended, sizeof run->ended, "exit status %d", WEXITSTATUS(status));
    return true;
}
