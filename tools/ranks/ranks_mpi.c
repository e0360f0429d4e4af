/* Ranks with MPI (MPI 3.1, https://www.mpi-forum.org/docs/mpi-3.1/mpi31-report.pdf). */
#include "ranks.h"

#include <limits.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "launched.h"
#include "plain_file.h"
#include "report.h"

/* MPI counts elements with int, so longer messages are sent in pieces. */
#define PIECE ((uint64_t)1 << 30)

/* Tags of the messages that have no kind. */
enum { SWAP_TAG = 1001 };

static struct {
    bool started;
    int count, number;
    char engine[64];
} mpi = {false, 1, 0, ""};

/* "Open MPI v4.1.4, package: ..." becomes "Open MPI 4.1.4", "MPICH Version:\t4.0.2\n..." becomes
 * "MPICH 4.0.2". */
static void find_engine(void)
{
    char text[MPI_MAX_LIBRARY_VERSION_STRING] = "";
    int length = 0;
    char *result = mpi.engine;
    MPI_Get_library_version(text, &length);
    text[strcspn(text, ",\n")] = '\0';
    for (const char *c = text; *c != '\0' && result < mpi.engine + sizeof mpi.engine - 1; ++c) {
        if (strncmp(c, " Version:", 9) == 0)
            c += 9;
        if (c[0] == ' ' && c[1] == 'v' && c[2] >= '0' && c[2] <= '9') {
            *result++ = ' ';
            ++c;
            continue;
        }
        *result++ = *c == '\t' ? ' ' : *c;
    }
    *result = '\0';
}

int ranks_begin(int *argc, char ***argv)
{
    const char *wanted = getenv("GNOMON_MPI");
    int provided;
    if (launched_by() == NULL && (wanted == NULL || strcmp(wanted, "1") != 0))
        return launched_without_mpi() ? report_usage("", "%s", LAUNCHED_WITHOUT_MPI) : 0;
    MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_size(MPI_COMM_WORLD, &mpi.count);
    MPI_Comm_rank(MPI_COMM_WORLD, &mpi.number);
    mpi.started = true;
    find_engine();
    return 0;
}

int ranks_end(int status)
{
    const int result = (int)ranks_largest((uint64_t)status);
    if (mpi.started)
        MPI_Finalize();
    mpi.started = false;
    return result;
}

void ranks_abort(int status)
{
    /* MPICH's launcher ends at once when it is told of the abort, and loses what it has not yet
     * read of the message that says why. */
    const struct timespec until_it_is_read = {0, 300000000};
    fflush(NULL);
    if (mpi.started) {
        nanosleep(&until_it_is_read, NULL);
        MPI_Abort(MPI_COMM_WORLD, status);
    }
    exit(status);
}

uint32_t ranks_count(void)
{
    return (uint32_t)mpi.count;
}

uint32_t ranks_number(void)
{
    return (uint32_t)mpi.number;
}

const char *ranks_engine(void)
{
    return mpi.engine;
}

void ranks_send(uint32_t to, int kind, const void *bytes, uint64_t size)
{
    const char *next = bytes;
    do {
        const uint64_t piece = size < PIECE ? size : PIECE;
        MPI_Send(next, (int)piece, MPI_BYTE, (int)to, kind, MPI_COMM_WORLD);
        next += piece;
        size -= piece;
    } while (size > 0);
}

void ranks_receive(uint32_t from, int kind, void *bytes, uint64_t size)
{
    char *next = bytes;
    do {
        const uint64_t piece = size < PIECE ? size : PIECE;
        MPI_Recv(next, (int)piece, MPI_BYTE, (int)from, kind, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        next += piece;
        size -= piece;
    } while (size > 0);
}

bool ranks_waits(int kind, uint32_t *from)
{
    MPI_Status status;
    int found = 0;
    *from = 0;
    if (!mpi.started)
        return false;
    MPI_Iprobe(MPI_ANY_SOURCE, kind, MPI_COMM_WORLD, &found, &status);
    if (found)
        *from = (uint32_t)status.MPI_SOURCE;
    return found != 0;
}

void ranks_swap(uint32_t to, const void *sent, uint64_t sent_size, uint32_t from, void *received,
                uint64_t received_size)
{
    const char *out = sent;
    char *in = received;
    if (!mpi.started) {
        if (received_size > 0)
            memmove(received, sent, received_size);
        return;
    }
    while (sent_size > 0 || received_size > 0) {
        const uint64_t sending = sent_size < PIECE ? sent_size : PIECE;
        const uint64_t receiving = received_size < PIECE ? received_size : PIECE;
        MPI_Sendrecv(out, (int)sending, MPI_BYTE, sending > 0 ? (int)to : MPI_PROC_NULL, SWAP_TAG,
                     in, (int)receiving, MPI_BYTE, receiving > 0 ? (int)from : MPI_PROC_NULL,
                     SWAP_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        out += sending;
        in += receiving;
        sent_size -= sending;
        received_size -= receiving;
    }
}

void ranks_share(uint32_t from, void *bytes, uint64_t size)
{
    char *next = bytes;
    while (mpi.started && size > 0) {
        const uint64_t piece = size < PIECE ? size : PIECE;
        MPI_Bcast(next, (int)piece, MPI_BYTE, (int)from, MPI_COMM_WORLD);
        next += piece;
        size -= piece;
    }
}

uint64_t ranks_largest(uint64_t number)
{
    uint64_t result = number;
    if (mpi.started)
        MPI_Allreduce(&number, &result, 1, MPI_UINT64_T, MPI_MAX, MPI_COMM_WORLD);
    return result;
}

uint64_t ranks_sum(uint64_t number)
{
    uint64_t result = number;
    if (mpi.started)
        MPI_Allreduce(&number, &result, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
    return result;
}

void ranks_collect(uint64_t number, uint64_t *numbers)
{
    numbers[0] = number;
    if (mpi.started)
        MPI_Allgather(&number, 1, MPI_UINT64_T, numbers, 1, MPI_UINT64_T, MPI_COMM_WORLD);
}

void ranks_least(float *values, uint64_t count)
{
    while (mpi.started && count > 0) {
        const uint64_t piece = count < PIECE / sizeof *values ? count : PIECE / sizeof *values;
        MPI_Allreduce(MPI_IN_PLACE, values, (int)piece, MPI_FLOAT, MPI_MIN, MPI_COMM_WORLD);
        values += piece;
        count -= piece;
    }
}

/* A process that has not started MPI writes files as any process does. */
struct ranks_file {
    MPI_File file;
    int descriptor; /* without MPI */
};

/* MPICH tells the reason in its last line: "Other I/O error , error stack:\nFUNCTION(58): Other I/O
 * error No space left on device". */
static bool say(char reason[256], int error)
{
    char text[MPI_MAX_ERROR_STRING] = "";
    int length = 0;
    MPI_Error_string(error, text, &length);
    length = (int)strlen(text);
    while (length > 0 && text[length - 1] == '\n')
        text[--length] = '\0';
    const char *line = strrchr(text, '\n');
    const char *words = line != NULL ? strstr(line, "): ") : NULL;
    snprintf(reason, 256, "%.255s", words != NULL ? words + 3 : line != NULL ? line + 1 : text);
    return false;
}

/* Returns whether this rank can open the file for writing. */
static bool try_to_open(const char *path, char reason[256])
{
    const int descriptor = plain_file_open(path, reason);
    return descriptor >= 0 && plain_file_close(descriptor, reason);
}

ranks_file *ranks_file_open(const char *path, char reason[256])
{
    reason[0] = '\0';
    ranks_file *result = malloc(sizeof *result);
    if (result == NULL)
        snprintf(reason, 256, "not enough memory");
    if (!mpi.started) {
        if (result == NULL || (result->descriptor = plain_file_open(path, reason)) >= 0)
            return result;
        free(result);
        return NULL;
    }
    /* Open MPI waits forever in MPI_File_open if one rank alone cannot open the file. */
    if (ranks_largest(result == NULL || !try_to_open(path, reason)) != 0) {
        free(result);
        return NULL;
    }
    const int error =
        MPI_File_open(MPI_COMM_WORLD, path, MPI_MODE_WRONLY, MPI_INFO_NULL, &result->file);
    if (error != MPI_SUCCESS)
        say(reason, error);
    if (ranks_largest(error != MPI_SUCCESS) == 0)
        return result;
    if (error == MPI_SUCCESS)
        MPI_File_close(&result->file);
    free(result);
    return NULL;
}

bool ranks_file_write(ranks_file *file, uint64_t offset, const void *bytes, uint64_t size,
                      char reason[256])
{
    const char *next = bytes;
    if (!mpi.started)
        return plain_file_write(file->descriptor, offset, bytes, size, reason);
    while (size > 0) {
        const uint64_t piece = size < PIECE ? size : PIECE;
        MPI_Status status;
        int written = 0;
        const int error =
            MPI_File_write_at(file->file, (MPI_Offset)offset, next, (int)piece, MPI_BYTE, &status);
        if (error != MPI_SUCCESS)
            return say(reason, error);
        MPI_Get_count(&status, MPI_BYTE, &written);
        if (written != (int)piece) {
            snprintf(reason, 256, "only %d of %llu bytes were written; the disk may be full",
                     written, (unsigned long long)piece);
            return false;
        }
        next += piece;
        offset += piece;
        size -= piece;
    }
    return true;
}

bool ranks_file_close(ranks_file *file, char reason[256])
{
    ranks_file closed = *file;
    free(file);
    if (!mpi.started)
        return plain_file_close(closed.descriptor, reason);
    int error = MPI_File_sync(closed.file);
    const int closing = MPI_File_close(&closed.file);
    if (error == MPI_SUCCESS)
        error = closing;
    return error == MPI_SUCCESS || say(reason, error);
}
