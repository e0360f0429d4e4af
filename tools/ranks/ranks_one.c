/* A process that is alone. */
#include "ranks.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "launched.h"
#include "plain_file.h"
#include "report.h"

int ranks_begin(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    const char *by = launched_by();
    if (by == NULL && launched_without_mpi())
        return report_usage("", "%s", LAUNCHED_WITHOUT_MPI);
    if (by == NULL || launched_count(by) <= 1)
        return 0;
    return report_usage(
        "",
        "started %ld times by a launcher of MPI (%s is set), but built without MPI; "
        "'make mpi' builds build/mpi/gnomon",
        launched_count(by), by);
}

int ranks_end(int status)
{
    return status;
}

void ranks_abort(int status)
{
    exit(status);
}

uint32_t ranks_count(void)
{
    return 1;
}

uint32_t ranks_number(void)
{
    return 0;
}

const char *ranks_engine(void)
{
    return "";
}

/* Nobody else is there to send to or to receive from. */
static void refuse(void)
{
    fputs("gnomon: a message to or from a rank that does not exist\n", stderr);
    abort();
}

void ranks_send(uint32_t to, int kind, const void *bytes, uint64_t size)
{
    (void)to, (void)kind, (void)bytes, (void)size;
    refuse();
}

void ranks_receive(uint32_t from, int kind, void *bytes, uint64_t size)
{
    (void)from, (void)kind, (void)bytes, (void)size;
    refuse();
}

bool ranks_waits(int kind, uint32_t *from)
{
    (void)kind;
    *from = 0;
    return false;
}

void ranks_swap(uint32_t to, const void *sent, uint64_t sent_size, uint32_t from, void *received,
                uint64_t received_size)
{
    if (to != 0 || from != 0 || sent_size != received_size)
        refuse();
    if (sent_size > 0)
        memmove(received, sent, sent_size);
}

void ranks_share(uint32_t from, void *bytes, uint64_t size)
{
    (void)from, (void)bytes, (void)size;
}

uint64_t ranks_largest(uint64_t number)
{
    return number;
}

uint64_t ranks_sum(uint64_t number)
{
    return number;
}

void ranks_collect(uint64_t number, uint64_t *numbers)
{
    numbers[0] = number;
}

void ranks_least(float *values, uint64_t count)
{
    (void)values, (void)count;
}

struct ranks_file {
    int descriptor;
};

ranks_file *ranks_file_open(const char *path, char reason[256])
{
    ranks_file *file = malloc(sizeof *file);
    reason[0] = '\0';
    if (file == NULL) {
        snprintf(reason, 256, "not enough memory");
        return NULL;
    }
    file->descriptor = plain_file_open(path, reason);
    if (file->descriptor >= 0)
        return file;
    free(file);
    return NULL;
}

bool ranks_file_write(ranks_file *file, uint64_t offset, const void *bytes, uint64_t size,
                      char reason[256])
{
    return plain_file_write(file->descriptor, offset, bytes, size, reason);
}

bool ranks_file_close(ranks_file *file, char reason[256])
{
    const int descriptor = file->descriptor;
    free(file);
    return plain_file_close(descriptor, reason);
}
