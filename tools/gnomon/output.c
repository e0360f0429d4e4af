/* Output files: written beside their final place and renamed at the end. */
#define _XOPEN_SOURCE 700
#include "output.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "report.h"

/* Files that the signal handler removes. A slot is written only while its signals are blocked. */
static char *pending[OUTPUT_LIMIT];

static const int ending_signals[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ};
#define SIGNAL_COUNT (sizeof ending_signals / sizeof ending_signals[0])

static void remove_pending(int number)
{
    for (int i = 0; i < OUTPUT_LIMIT; ++i)
        if (pending[i] != NULL)
            unlink(pending[i]);
    signal(number, SIG_DFL);
    raise(number);
}

/* Holds the signals back. */
static void block_signals(sigset_t *previous)
{
    sigset_t blocked;
    sigemptyset(&blocked);
    for (size_t i = 0; i < SIGNAL_COUNT; ++i)
        sigaddset(&blocked, ending_signals[i]);
    sigprocmask(SIG_BLOCK, &blocked, previous);
}

/* The signals are blocked. */
static void replace_pending(char *from, char *to)
{
    for (int i = 0; i < OUTPUT_LIMIT; ++i) {
        if (pending[i] == from) {
            pending[i] = to;
            break;
        }
    }
}

static void remove_from_pending(char *path)
{
    sigset_t previous;
    block_signals(&previous);
    replace_pending(path, NULL);
    sigprocmask(SIG_SETMASK, &previous, NULL);
}

/* mkstemp. No signal comes between the file and its place among those that are pending. */
static int make_temporary(char *path)
{
    sigset_t previous;
    block_signals(&previous);
    const int descriptor = mkstemp(path);
    const int reason = errno;
    if (descriptor >= 0)
        replace_pending(NULL, path);
    sigprocmask(SIG_SETMASK, &previous, NULL);
    errno = reason;
    return descriptor;
}

static void handle_signals(void)
{
    struct sigaction action;
    struct sigaction previous;
    memset(&action, 0, sizeof action);
    action.sa_handler = remove_pending;
    for (size_t i = 0; i < SIGNAL_COUNT; ++i) {
        /* A signal that was ignored on purpose, as under nohup, stays ignored. */
        if (sigaction(ending_signals[i], NULL, &previous) == 0 && previous.sa_handler == SIG_DFL)
            sigaction(ending_signals[i], &action, NULL);
    }
}

static void release(output *o)
{
    free(o->final);
    free(o->temporary);
    memset(o, 0, sizeof *o);
}

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

/* The directory of a path's last name, allocated; null if there is not enough memory. */
static char *directory_of(const char *path)
{
    size_t length = (size_t)(base_name(path) - path);
    char *directory = strdup(length > 0 ? path : ".");
    if (directory != NULL && length > 0)
        directory[length] = '\0';
    return directory;
}

bool output_is_standard(const char *path)
{
    static const char *const names[] = {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"};
    struct stat there;
    struct stat standard;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i)
        if (strcmp(path, names[i]) == 0)
            return true;
    return stat(path, &there) == 0 && fstat(STDOUT_FILENO, &standard) == 0 &&
           (S_ISREG(there.st_mode) || S_ISFIFO(there.st_mode)) && there.st_dev == standard.st_dev &&
           there.st_ino == standard.st_ino;
}

FILE *output_words(const char *first, const char *second)
{
    return (first != NULL && output_is_standard(first)) ||
                   (second != NULL && output_is_standard(second))
               ? stderr
               : stdout;
}

const char *output_fault(const char *path)
{
    struct stat status;
    if (output_is_standard(path))
        return NULL;
    if (stat(path, &status) == 0) {
        if (S_ISDIR(status.st_mode))
            return "it is a directory";
        if (access(path, W_OK) != 0 || !S_ISREG(status.st_mode))
            return access(path, W_OK) != 0 ? strerror(errno) : NULL;
    }
    /* A symbolic link's file is elsewhere; whether it can be written shows when it is opened. */
    char *directory = directory_of(path);
    const char *fault = directory == NULL ? "not enough memory" : NULL;
    if (fault == NULL && access(directory, W_OK | X_OK) != 0)
        fault = strerror(errno);
    free(directory);
    return fault;
}

int output_open(output *o, const char *path)
{
    struct stat status;
    bool exists = stat(path, &status) == 0;
    memset(o, 0, sizeof *o);
    o->path = path;
    if (output_is_standard(path)) {
        int copy = dup(STDOUT_FILENO);
        o->file = copy >= 0 ? fdopen(copy, "wb") : NULL;
        if (o->file != NULL)
            return 0;
        int reason = errno;
        if (copy >= 0)
            close(copy);
        return report_fault(path, "cannot be written: %s", strerror(reason));
    }
    if (exists && S_ISDIR(status.st_mode))
        return report_fault(path, "cannot be written: it is a directory");
    if (exists && !S_ISREG(status.st_mode)) {
        o->file = fopen(path, "wb");
        return o->file != NULL ? 0 : report_fault(path, "cannot be written: %s", strerror(errno));
    }
    if (exists && access(path, W_OK) != 0)
        return report_fault(path, "cannot be written: %s", strerror(errno));

    static const char suffix[] = ".XXXXXX";
    o->final = exists ? realpath(path, NULL) : strdup(path);
    if (o->final != NULL)
        o->temporary = malloc(strlen(o->final) + sizeof suffix);
    if (o->temporary == NULL) {
        release(o);
        return report_fault(path, "cannot be written: not enough memory");
    }
    strcpy(o->temporary, o->final);
    strcat(o->temporary, suffix);

    handle_signals();
    int descriptor = make_temporary(o->temporary);
    if (descriptor < 0) {
        int reason = errno;
        release(o);
        return report_fault(path, "cannot be written: %s", strerror(reason));
    }
    mode_t mask = umask(0);
    umask(mask);
    mode_t mode = exists ? (status.st_mode & 0777) : (0666 & ~mask);
    o->file = fdopen(descriptor, "wb");
    if (o->file == NULL || fchmod(descriptor, mode) != 0) {
        int reason = errno;
        if (o->file == NULL)
            close(descriptor);
        output_abandon(o);
        return report_fault(path, "cannot be written: %s", strerror(reason));
    }
    return 0;
}

/* Returns EXIT_FAULT after abandoning the output. */
static int fail(output *o, int reason)
{
    const char *path = o->path;
    output_abandon(o);
    return report_fault(path, "cannot be written: %s", strerror(reason));
}

int output_finish(output *o)
{
    bool good = fflush(o->file) == 0 && ferror(o->file) == 0;
    int reason = errno;
    if (fclose(o->file) != 0 && good) {
        good = false;
        reason = errno;
    }
    o->file = NULL;
    return good ? 0 : fail(o, reason);
}

int output_rename(output *o)
{
    if (o->temporary != NULL) {
        if (rename(o->temporary, o->final) != 0)
            return fail(o, errno);
        remove_from_pending(o->temporary);
    }
    release(o);
    return 0;
}

void output_abandon(output *o)
{
    if (o->file != NULL)
        fclose(o->file);
    if (o->temporary != NULL) {
        unlink(o->temporary);
        remove_from_pending(o->temporary);
    }
    release(o);
}

/* stat of the directory that a path's last name is in. */
static bool stat_directory(const char *path, struct stat *status)
{
    char *directory = directory_of(path);
    bool good = directory != NULL && stat(directory, status) == 0;
    free(directory);
    return good;
}

bool output_same_file(const char *a, const char *b)
{
    struct stat status_a;
    struct stat status_b;
    if (strcmp(a, b) == 0 || (output_is_standard(a) && output_is_standard(b)))
        return true;
    bool exists_a = stat(a, &status_a) == 0;
    bool exists_b = stat(b, &status_b) == 0;
    if (exists_a != exists_b)
        return false;
    if (exists_a ? !S_ISREG(status_a.st_mode)
                 : strcmp(base_name(a), base_name(b)) != 0 || !stat_directory(a, &status_a) ||
                       !stat_directory(b, &status_b))
        return false;
    return status_a.st_dev == status_b.st_dev && status_a.st_ino == status_b.st_ino;
}
