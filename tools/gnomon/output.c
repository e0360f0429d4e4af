/* Output files: written beside their final place and renamed at the end. */
#define _XOPEN_SOURCE 700
#include "output.h"

#include <errno.h>
#include <fcntl.h>
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

/* Where a link leads: its target, beside the link if it is relative, allocated. */
static char *beside_link(const char *link, const char *target)
{
    const size_t length = target[0] == '/' ? 0 : (size_t)(base_name(link) - link);
    char *path = malloc(length + strlen(target) + 1);
    if (path != NULL) {
        memcpy(path, link, length);
        strcpy(path + length, target);
    }
    return path;
}

/* Where a path leads if it is a symbolic link, otherwise the path, allocated. The file need not
 * exist yet. Null with the reason in errno: not enough memory, or a loop of links. */
static char *follow_links(const char *path)
{
    enum { MOST_LINKS = 40 };
    char target[4096];
    char *at = strdup(path);
    for (int i = 0; i < MOST_LINKS && at != NULL; ++i) {
        const ssize_t length = readlink(at, target, sizeof target - 1);
        if (length < 0)
            return at;
        target[length] = '\0';
        char *next = beside_link(at, target);
        free(at);
        at = next;
    }
    if (at != NULL) {
        free(at);
        errno = ELOOP;
    }
    return NULL;
}

/* Why no file can be made beside this one; names the directory if its rights are the reason. The
 * text is valid until the next call. */
static const char *fault_beside(const char *file, int reason)
{
    static char text[4096 + 256];
    char *directory = directory_of(file);
    if (directory == NULL || (reason != EACCES && reason != EPERM && reason != EROFS)) {
        free(directory);
        return strerror(reason);
    }
    snprintf(text, sizeof text, "no file can be made in the directory '%s': %s", directory,
             strerror(reason));
    free(directory);
    return text;
}

/* Returns 0, or why nothing can be made beside this file. */
static int try_directory(const char *file)
{
    char *directory = directory_of(file);
    const int reason = directory == NULL ? ENOMEM : access(directory, W_OK | X_OK) != 0 ? errno : 0;
    free(directory);
    return reason;
}

/* Standard output may be closed; the command then has it open for reading alone (main.c). */
static const char *standard_fault(void)
{
    const int flags = fcntl(STDOUT_FILENO, F_GETFL);
    return flags == -1 || (flags & O_ACCMODE) == O_RDONLY ? strerror(EBADF) : NULL;
}

const char *output_fault(const char *path)
{
    struct stat status;
    if (output_is_standard(path))
        return standard_fault();
    if (stat(path, &status) == 0) {
        if (S_ISDIR(status.st_mode))
            return "it is a directory";
        if (access(path, W_OK) != 0)
            return strerror(errno);
        if (!S_ISREG(status.st_mode))
            return NULL;
    } else if (errno != ENOENT && errno != EACCES) {
        return strerror(errno);
    }
    char *file = follow_links(path);
    const int reason = file != NULL ? try_directory(file) : errno;
    const char *fault = file == NULL || reason == 0 ? NULL : fault_beside(file, reason);
    if (file == NULL)
        fault = strerror(reason);
    free(file);
    return fault;
}

/* The file's name and a suffix for mkstemp, in its directory, allocated; null if there is not
 * enough memory. Long names are cut, between characters, since file systems limit names, some to
 * 143 bytes. */
static char *temporary_name(const char *file)
{
    enum { MOST_KEPT = 100 };
    static const char suffix[] = ".XXXXXX";
    const char *name = base_name(file);
    size_t length = strlen(name);
    if (length > MOST_KEPT)
        for (length = MOST_KEPT; length > 0 && ((unsigned char)name[length] & 0xc0) == 0x80;)
            --length;
    length += (size_t)(name - file);
    char *path = malloc(length + sizeof suffix);
    if (path != NULL) {
        memcpy(path, file, length);
        strcpy(path + length, suffix);
    }
    return path;
}

/* Returns EXIT_FAULT with the reason printed. */
static int refuse(const char *path, const char *reason)
{
    return report_fault(path, "cannot be written: %s", reason);
}

static int open_standard(output *o)
{
    const char *fault = standard_fault();
    if (fault != NULL)
        return refuse(o->path, fault);
    int copy = dup(STDOUT_FILENO);
    o->file = copy >= 0 ? fdopen(copy, "wb") : NULL;
    if (o->file != NULL)
        return 0;
    int reason = errno;
    if (copy >= 0)
        close(copy);
    return refuse(o->path, strerror(reason));
}

int output_open(output *o, const char *path)
{
    struct stat status;
    memset(o, 0, sizeof *o);
    o->path = path;
    if (output_is_standard(path))
        return open_standard(o);
    const char *fault = output_fault(path);
    if (fault != NULL)
        return refuse(path, fault);
    const bool exists = stat(path, &status) == 0;
    if (exists && !S_ISREG(status.st_mode)) {
        o->file = fopen(path, "wb");
        return o->file != NULL ? 0 : refuse(path, strerror(errno));
    }
    o->final = follow_links(path);
    if (o->final != NULL)
        o->temporary = temporary_name(o->final);
    if (o->temporary == NULL) {
        int reason = errno;
        release(o);
        return refuse(path, strerror(reason));
    }

    handle_signals();
    int descriptor = make_temporary(o->temporary);
    if (descriptor < 0) {
        fault = fault_beside(o->final, errno);
        release(o);
        return refuse(path, fault);
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
        return refuse(path, strerror(reason));
    }
    return 0;
}

/* Returns EXIT_FAULT after abandoning the output. */
static int fail(output *o, int reason)
{
    const char *path = o->path;
    output_abandon(o);
    return refuse(path, strerror(reason));
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

/* Whether two files that do not exist yet have one name in one directory. */
static bool same_new_file(const char *a, const char *b)
{
    struct stat status_a;
    struct stat status_b;
    char *file_a = follow_links(a);
    char *file_b = follow_links(b);
    const bool same = file_a != NULL && file_b != NULL &&
                      strcmp(base_name(file_a), base_name(file_b)) == 0 &&
                      stat_directory(file_a, &status_a) && stat_directory(file_b, &status_b) &&
                      status_a.st_dev == status_b.st_dev && status_a.st_ino == status_b.st_ino;
    free(file_a);
    free(file_b);
    return same;
}

bool output_same_file(const char *a, const char *b)
{
    struct stat status_a;
    struct stat status_b;
    if (strcmp(a, b) == 0 || (output_is_standard(a) && output_is_standard(b)))
        return true;
    bool exists_a = stat(a, &status_a) == 0;
    bool exists_b = stat(b, &status_b) == 0;
    if (!exists_a && !exists_b)
        return same_new_file(a, b);
    return exists_a && exists_b && S_ISREG(status_a.st_mode) &&
           status_a.st_dev == status_b.st_dev && status_a.st_ino == status_b.st_ino;
}
