/* The confined process and its limits. */
#define _DEFAULT_SOURCE
#include "confined.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include "files.h"
#include "report.h"

/* Exit status of a child that crashed because memory ran out. */
#define EXIT_MEMORY 3

/* A crash counts as lack of memory if this many bytes cannot be mapped any more. */
#define LITTLE_MEMORY ((size_t)32 << 20)

/* Many more files than the child opens at once: the model, one beside it, the pipe. */
#define OPEN_FILES 256

/* The child's end of the pipe. */
static int to_parent;

/* The parent process, which waits for the child. */
static pid_t parent;

static void send_line(const char *line)
{
    handover_send_text(to_parent, HANDOVER_LINE, line);
}

static void send_opened(const char *path)
{
    handover_send_text(to_parent, HANDOVER_OPENED, path);
}

/* If memory is short, C++ code calls abort after an exception that nobody catches, and code that
 * does not check malloc crashes. Ends the child with EXIT_MEMORY in these cases, otherwise by the
 * signal. */
static void tell_memory(int number)
{
    void *probe =
        mmap(NULL, LITTLE_MEMORY, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (probe == MAP_FAILED)
        _exit(EXIT_MEMORY);
    signal(number, SIG_DFL);
    raise(number);
}

/* Handlers have a stack of their own, since the usual one may be exhausted. */
static void handle_crashes(void)
{
    static const int numbers[] = {SIGABRT, SIGSEGV, SIGBUS};
    static char memory[1 << 16];
    stack_t stack;
    struct sigaction action;
    memset(&stack, 0, sizeof stack);
    memset(&action, 0, sizeof action);
    stack.ss_sp = memory;
    stack.ss_size = sizeof memory;
    sigaltstack(&stack, NULL);
    action.sa_handler = tell_memory;
    action.sa_flags = SA_ONSTACK;
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; ++i)
        sigaction(numbers[i], &action, NULL);
}

bool confined_limits_memory(void)
{
#if defined(__SANITIZE_ADDRESS__)
    return false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
    return false;
#else
    return true;
#endif
#else
    return true;
#endif
}

/* Lowers a limit; a lower limit stays. */
static void set_limit(int which, rlim_t most)
{
    struct rlimit limit;
    if (getrlimit(which, &limit) != 0)
        return;
    if (limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur > most)
        limit.rlim_cur = most;
    /* A process that reaches its hard limit of time gets SIGKILL, not SIGXCPU. */
    if (limit.rlim_max == RLIM_INFINITY || limit.rlim_max > most + 1)
        limit.rlim_max = most + 1;
    setrlimit(which, &limit);
}

/* Bytes of address space that the process uses before it begins; 0 if not known. */
static rlim_t address_space(void)
{
    unsigned long pages = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    if (file != NULL) {
        if (fscanf(file, "%lu", &pages) != 1)
            pages = 0;
        fclose(file);
    }
    return (rlim_t)pages * (rlim_t)sysconf(_SC_PAGESIZE);
}

/* Libraries must not print in the command's name, so standard input, output and error lead nowhere.
 * The child does not outlive its parent. */
static void confine(const import_limits *limits)
{
    int nowhere = open("/dev/null", O_RDWR);
    for (int i = 0; i < 3 && nowhere >= 0; ++i)
        dup2(nowhere, i);
    if (nowhere > 2)
        close(nowhere);
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) /* the parent ended before the line above */
        _exit(EXIT_FAULT);
#endif
    handle_crashes();
    set_limit(RLIMIT_CORE, 0);
    set_limit(RLIMIT_FSIZE, 0);
    set_limit(RLIMIT_NOFILE, OPEN_FILES);
    set_limit(RLIMIT_CPU, (rlim_t)limits->seconds + 1);
    if (confined_limits_memory())
        set_limit(RLIMIT_AS, address_space() + ((rlim_t)limits->memory << 20));
}

/* What is read, and how much of it is allowed. */
typedef struct target {
    const char *path;
    const import_limits *limits;
} target;

/* Returns " over 'FILE'" in three pieces, all empty if that file is the model itself. */
typedef struct culprit {
    const char *before, *path, *after;
} culprit;

static culprit last_file(const char *path, const char *opened)
{
    const culprit none = {"", "", ""};
    const culprit named = {" over '", opened, "'"};
    return opened[0] == '\0' || strcmp(opened, path) == 0 ? none : named;
}

static int memory_fault(const target *t)
{
    return report_fault(t->path, "cannot be imported: not enough memory (--import-memory %u)",
                        (unsigned)t->limits->memory);
}

static int late_fault(const target *t, culprit c)
{
    return report_fault(t->path,
                        "cannot be imported: it takes longer than --import-seconds %u%s%s%s",
                        (unsigned)t->limits->seconds, c.before, c.path, c.after);
}

/* The child has ended without a record that says why. */
static int end_fault(const target *t, int status, culprit c)
{
    if (WIFEXITED(status) && WEXITSTATUS(status) == EXIT_MEMORY)
        return memory_fault(t);
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
        return late_fault(t, c);
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL)
        return report_fault(t->path,
                            "cannot be imported: the importer was killed%s%s%s, probably because "
                            "memory ran out",
                            c.before, c.path, c.after);
    if (WIFSIGNALED(status))
        return report_fault(t->path, "cannot be imported: the importer crashed%s%s%s (%s)",
                            c.before, c.path, c.after, strsignal(WTERMSIG(status)));
    return report_fault(t->path, "cannot be imported: the importer ended%s%s%s with status %d",
                        c.before, c.path, c.after, WIFEXITED(status) ? WEXITSTATUS(status) : -1);
}

static int state_fault(const target *t, const handover *h, int status, culprit c)
{
    switch (h->state) {
    case HANDOVER_LATE:
        return late_fault(t, c);
    case HANDOVER_TOO_MUCH:
        return report_fault(t->path,
                            "cannot be imported: it takes more than --import-output %u MiB",
                            (unsigned)t->limits->output);
    case HANDOVER_WRONG:
        return report_fault(
            t->path, "cannot be imported: the importer returned something that is not a model");
    case HANDOVER_NO_MEMORY:
        return report_fault(t->path, "not enough memory");
    default:
        return end_fault(t, status, c);
    }
}

/* Receives until the result is complete, the child sends a fault (*told: its reason is printed), or
 * receiving fails. Returns whether the result is complete. */
static bool receive_all(handover *h, char *last, confined_receive *receive, void *result,
                        bool *told)
{
    static char text[HANDOVER_TEXT_SIZE];
    handover_record kind;
    while (handover_receive(h, &kind, text)) {
        if (kind == HANDOVER_LINE)
            report_line(text);
        if (kind == HANDOVER_OPENED) {
            strcpy(last, text);
            if (!files_list_add(&h->opened, text)) {
                h->state = HANDOVER_NO_MEMORY;
                return false;
            }
        }
        if (kind == HANDOVER_FAULT) {
            *told = true;
            return false;
        }
        if (kind == HANDOVER_RESULT)
            return receive(h, text, result);
    }
    return false;
}

int confined_run(const char *path, const import_limits *limits, confined_work *work,
                 const void *context, confined_receive *receive, void *result)
{
    static char opened[HANDOVER_TEXT_SIZE];
    const target t = {path, limits};
    int ends[2];
    int status = 0;
    bool told = false;
    handover h = {-1, {0, 0}, (uint64_t)limits->output << 20, HANDOVER_GOING, {NULL, 0}};
    /* Adds room for headers and lines, so that the limit counts the contents alone. */
    h.bytes_left += (uint64_t)1 << 20;
    opened[0] = '\0';
    if (pipe(ends) != 0)
        return report_fault(path, "cannot be imported: %s", strerror(errno));
    /* If an ignored SIGCHLD was inherited, the child's status would be lost. */
    signal(SIGCHLD, SIG_DFL);
    fflush(NULL);
    parent = getpid();
    pid_t child = fork();
    if (child == 0) {
        /* Nothing is freed, since the process ends. */
        close(ends[0]);
        to_parent = ends[1];
        confine(limits);
        report_to(send_line);
        files_observe(send_opened);
        _exit(work(to_parent, context) ? 0 : EXIT_FAULT);
    }
    close(ends[1]);
    if (child < 0) {
        close(ends[0]);
        return report_fault(path, "cannot be imported: %s", strerror(errno));
    }
    h.descriptor = ends[0];
    clock_gettime(CLOCK_MONOTONIC, &h.deadline);
    h.deadline.tv_sec += (time_t)limits->seconds;
    bool good = receive_all(&h, opened, receive, result, &told);
    /* A child that has ended keeps its exit status. */
    kill(child, SIGKILL);
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
        ;
    close(ends[0]);
    if (!good && !told)
        state_fault(&t, &h, status, last_file(path, opened));
    files_list_free(&h.opened);
    return good ? 0 : EXIT_FAULT;
}
