/* The importing process and its limits. */
#define _DEFAULT_SOURCE
#include "import.h"

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
#include "handover.h"
#include "model_read.h"
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
    set_limit(RLIMIT_AS, address_space() + ((rlim_t)limits->memory << 20));
}

static int read_maps(const options *o, unsigned int wanted, uint64_t bytes, imported *result)
{
    image_budget budget = {o->limits.megapixels, bytes};
    result->maps = calloc(result->model.part_count, sizeof *result->maps);
    if (result->maps == NULL)
        return report_fault(o->model, "not enough memory");
    for (size_t i = 0; i < result->model.part_count; ++i) {
        int fault =
            maps_read(o, result->model.parts + i, wanted, &budget, result->maps + i, &result->told);
        if (fault != 0)
            return fault;
    }
    return 0;
}

static int read_all(const options *o, unsigned int wanted, imported *result)
{
    const uint64_t most = (uint64_t)o->limits.output << 20;
    uint64_t size = 0;
    int fault = model_read(o->model, &result->model);
    for (size_t i = 0; fault == 0 && i < result->model.part_count; ++i)
        size += handover_size(result->model.parts + i);
    if (fault == 0 && size > most)
        fault = report_fault(o->model,
                             "takes %llu MiB when it is imported, more than --import-output %u "
                             "allows",
                             (unsigned long long)(size >> 20) + 1, (unsigned)o->limits.output);
    return fault != 0 ? fault : read_maps(o, wanted, most - size, result);
}

/* Nothing is freed, since the process ends. */
static void run_child(const options *o, unsigned int wanted)
{
    imported what;
    memset(&what, 0, sizeof what);
    confine(&o->limits);
    report_to(send_line);
    files_observe(send_opened);
    bool good = read_all(o, wanted, &what) == 0 ? handover_send_model(to_parent, &what)
                                                : handover_send_text(to_parent, HANDOVER_FAULT, "");
    _exit(good ? 0 : EXIT_FAULT);
}

/* Returns " over 'FILE'" in three pieces, all empty if that file is the model itself. */
typedef struct culprit {
    const char *before, *path, *after;
} culprit;

static culprit last_file(const options *o, const char *opened)
{
    const culprit none = {"", "", ""};
    const culprit named = {" over '", opened, "'"};
    return opened[0] == '\0' || strcmp(opened, o->model) == 0 ? none : named;
}

static int memory_fault(const options *o)
{
    return report_fault(o->model, "cannot be imported: not enough memory (--import-memory %u)",
                        (unsigned)o->limits.memory);
}

static int late_fault(const options *o, culprit c)
{
    return report_fault(o->model,
                        "cannot be imported: it takes longer than --import-seconds %u%s%s%s",
                        (unsigned)o->limits.seconds, c.before, c.path, c.after);
}

/* The child has ended without a record that says why. */
static int end_fault(const options *o, int status, culprit c)
{
    if (WIFEXITED(status) && WEXITSTATUS(status) == EXIT_MEMORY)
        return memory_fault(o);
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
        return late_fault(o, c);
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL)
        return report_fault(o->model,
                            "cannot be imported: the importer was killed%s%s%s, probably because "
                            "memory ran out",
                            c.before, c.path, c.after);
    if (WIFSIGNALED(status))
        return report_fault(o->model, "cannot be imported: the importer crashed%s%s%s (%s)",
                            c.before, c.path, c.after, strsignal(WTERMSIG(status)));
    return report_fault(o->model, "cannot be imported: the importer ended%s%s%s with status %d",
                        c.before, c.path, c.after, WIFEXITED(status) ? WEXITSTATUS(status) : -1);
}

static int state_fault(const options *o, const handover *h, int status, culprit c)
{
    switch (h->state) {
    case HANDOVER_LATE:
        return late_fault(o, c);
    case HANDOVER_TOO_MUCH:
        return report_fault(o->model,
                            "cannot be imported: it takes more than --import-output %u MiB",
                            (unsigned)o->limits.output);
    case HANDOVER_WRONG:
        return report_fault(
            o->model, "cannot be imported: the importer returned something that is not a model");
    case HANDOVER_NO_MEMORY:
        return report_fault(o->model, "not enough memory");
    default:
        return end_fault(o, status, c);
    }
}

/* Receives until the model is complete, the child sends a fault (*told: its reason is printed), or
 * receiving fails. */
static int receive(handover *h, char *opened, imported *result, bool *told)
{
    static char text[HANDOVER_TEXT_SIZE];
    handover_record kind;
    while (handover_receive(h, &kind, text)) {
        if (kind == HANDOVER_LINE)
            report_line(text);
        if (kind == HANDOVER_OPENED)
            strcpy(opened, text);
        if (kind == HANDOVER_FAULT) {
            *told = true;
            return EXIT_FAULT;
        }
        if (kind == HANDOVER_MODEL) {
            result->told.text = text[0] != '\0' ? strdup(text) : NULL;
            return handover_receive_model(h, result) ? 0 : EXIT_FAULT;
        }
    }
    return EXIT_FAULT;
}

int import_model(const options *o, unsigned int wanted, imported *result)
{
    static char opened[HANDOVER_TEXT_SIZE];
    int ends[2];
    int status = 0;
    bool told = false;
    handover h = {-1, {0, 0}, (uint64_t)o->limits.output << 20, HANDOVER_GOING};
    /* Adds room for headers and lines, so that the limit counts the model alone. */
    h.bytes_left += (uint64_t)1 << 20;
    memset(result, 0, sizeof *result);
    opened[0] = '\0';
    if (pipe(ends) != 0)
        return report_fault(o->model, "cannot be imported: %s", strerror(errno));
    /* If an ignored SIGCHLD was inherited, the child's status would be lost. */
    signal(SIGCHLD, SIG_DFL);
    fflush(NULL);
    parent = getpid();
    pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        to_parent = ends[1];
        run_child(o, wanted);
    }
    close(ends[1]);
    if (child < 0) {
        close(ends[0]);
        return report_fault(o->model, "cannot be imported: %s", strerror(errno));
    }
    h.descriptor = ends[0];
    clock_gettime(CLOCK_MONOTONIC, &h.deadline);
    h.deadline.tv_sec += (time_t)o->limits.seconds;
    int fault = receive(&h, opened, result, &told);
    /* A child that has ended keeps its exit status. */
    kill(child, SIGKILL);
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
        ;
    close(ends[0]);
    if (fault != 0 && !told)
        state_fault(o, &h, status, last_file(o, opened));
    if (fault != 0)
        import_free(result);
    return fault;
}

/* Moves the parts and maps of a model to the end of others. Returns false if there is not enough
 * memory; `from` must be freed either way. */
static bool append(imported *to, imported *from)
{
    const size_t count = to->model.part_count, added = from->model.part_count;
    model_part *parts = realloc(to->model.parts, (count + added) * sizeof *parts);
    if (parts == NULL)
        return false;
    to->model.parts = parts;
    part_maps *maps = realloc(to->maps, (count + added) * sizeof *maps);
    if (maps == NULL)
        return false;
    to->maps = maps;
    memcpy(parts + count, from->model.parts, added * sizeof *parts);
    memcpy(maps + count, from->maps, added * sizeof *maps);
    to->model.part_count += added;
    from->model.part_count = 0;
    return maps_told_append(&to->told, &from->told);
}

int import_models(const options *o, unsigned int wanted, imported *result)
{
    options one = *o;
    int fault = 0;
    memset(result, 0, sizeof *result);
    for (size_t i = 0; i < o->model_count && fault == 0; ++i) {
        imported next;
        one.model = o->models[i].path;
        fault = import_model(&one, wanted, &next);
        if (fault != 0)
            break;
        for (size_t p = 0; p < next.model.part_count; ++p)
            next.model.parts[p].world_from_model = o->models[i].world_from_model;
        if (!append(result, &next))
            fault = report_fault(one.model, "not enough memory");
        import_free(&next);
    }
    if (fault != 0)
        import_free(result);
    return fault;
}

void import_free(imported *i)
{
    for (size_t p = 0; i->maps != NULL && p < i->model.part_count; ++p)
        maps_free(i->maps + p);
    free(i->maps);
    i->maps = NULL;
    model_free(&i->model);
    maps_told_free(&i->told);
}
