/* Ranks: the processes that mpirun, srun and the like start together. Everything that goes from one
 * process to another goes through these functions. ranks_mpi.c has them with MPI, ranks_one.c for a
 * process that is alone; a program is linked with one of the two.
 *
 * "Collective" means: every rank calls the function, in the same order as other collective
 * functions, and it may wait for all of them.
 *
 * A fault of MPI itself, such as a lost connection, ends all ranks; MPI prints the reason. Memory
 * that a function needs for itself is small; if there is none, all ranks end with a message. */
#ifndef RANKS_H
#define RANKS_H

#include <stdbool.h>
#include <stdint.h>

/* Starts MPI if a launcher has started this process, or if GNOMON_MPI is set to 1 in the
 * environment; otherwise this process is alone, and nothing is started. Returns 0. If the program
 * is linked without MPI and a launcher has started several processes, prints why it cannot work
 * and returns EXIT_USAGE (report.h). Call it before anything is printed, and ranks_end once at the
 * end if it returned 0. */
int ranks_begin(int *argc, char ***argv);

/* Collective. Ends MPI. Returns the largest status of all ranks. */
int ranks_end(int status);

/* Ends all ranks at once with this status, without waiting for anyone: for faults after which other
 * ranks would wait forever. */
void ranks_abort(int status);

/* How many ranks there are, at least 1; which one this is, from 0 on. */
uint32_t ranks_count(void);
uint32_t ranks_number(void);

/* "Open MPI 4.1.4", or "" if MPI has not been started. */
const char *ranks_engine(void);

/* Messages between two ranks. Messages of one kind from one rank arrive in the order of sending.
 * ranks_send may wait until the receiver takes the message. The receiver must ask for exactly as
 * many bytes as were sent. `kind` is 0 to 1000. */
void ranks_send(uint32_t to, int kind, const void *bytes, uint64_t size);
void ranks_receive(uint32_t from, int kind, void *bytes, uint64_t size);

/* Whether a message of this kind has come and waits; sets *from to its sender. Never waits. */
bool ranks_waits(int kind, uint32_t *from);

/* Sends to and receives from partners at the same time, so that no two ranks wait for each other.
 * Either size may be 0. */
void ranks_swap(uint32_t to, const void *sent, uint64_t sent_size, uint32_t from, void *received,
                uint64_t received_size);

/* Collective functions. */

/* Copies bytes of one rank to all others. */
void ranks_share(uint32_t from, void *bytes, uint64_t size);

/* The largest, or the sum, of every rank's number. */
uint64_t ranks_largest(uint64_t number);
uint64_t ranks_sum(uint64_t number);

/* Returns the largest status of all ranks: 0 only if no rank has a fault. Collective. */
static inline int ranks_agree(int status)
{
    return (int)ranks_largest((uint64_t)status);
}

/* Collects one number of each rank, in order, at all ranks: ranks_count() numbers. */
void ranks_collect(uint64_t number, uint64_t *numbers);

/* Replaces every float by the smallest that a rank has at its place. None may be NaN. */
void ranks_least(float *values, uint64_t count);

/* A file that all ranks write to, each its own parts. */
typedef struct ranks_file ranks_file;

/* Collective. Opens an existing file for writing. Returns null at all ranks if it cannot be opened
 * at one, with the reason at that rank in `reason`, which is otherwise empty. */
ranks_file *ranks_file_open(const char *path, char reason[256]);

/* Writes at this offset; not collective. Returns false with the reason. */
bool ranks_file_write(ranks_file *file, uint64_t offset, const void *bytes, uint64_t size,
                      char reason[256]);

/* Collective. Waits until all that was written is in the file, and closes it. Returns false at a
 * rank with the reason if its data may be lost. */
bool ranks_file_close(ranks_file *file, char reason[256]);

#endif
