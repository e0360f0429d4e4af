/* The event simulation: ranks that work, send, receive, meet and write, on machines whose ports and
 * whose file system serve one transfer after the other.
 *
 * What a transfer of n bytes costs is LogGP's model without its overheads (Alexandrov, Ionescu,
 * Schauser, Scheiman, "LogGP", 1995): its first byte arrives after the latency, its last one
 * n / bandwidth later. It occupies the sender's port for n / bandwidth, and from the arrival of its
 * first byte the receiver's port for as long; a port that is busy lets it wait. All ranks of a
 * machine share the machine's two ports, one out and one in. A transfer between ranks of one
 * machine does not pass them: each rank has two ports of its own for those. A file that is written
 * occupies the port out and then the file system; on a single machine, only its disk.
 *
 * Left out: the two ends of a message as work of the processor, congestion inside the network,
 * memory that ranks of one machine share, and everything that is random. */
#ifndef SCALE_ENGINE_H
#define SCALE_ENGINE_H

#include <stdbool.h>
#include <stdint.h>

/* What a rank spends time on. */
typedef enum time_kind {
    TIME_START,
    TIME_READ,
    TIME_SHARE,
    TIME_PREPARE,
    TIME_VERTICES,
    TIME_TRIANGLES,
    TIME_FRAGMENTS,
    TIME_CLEAR,
    TIME_EXCHANGE,
    TIME_MERGE,
    TIME_COMPRESS,
    TIME_WRITE,
    TIME_HANDOUT, /* waiting for a frame to draw, or for those who draw */
    TIME_AGREE,   /* messages of agreements */
    TIME_UNEQUAL, /* waiting for ranks that have more to do */
    TIME_KINDS
} time_kind;

/* "reading the model" and so on; and a word for a table or JSON, "read". */
const char *time_kind_text(time_kind kind);
const char *time_kind_word(time_kind kind);

/* Whether it is spent once, before the first picture. */
static inline bool time_kind_begins(time_kind kind)
{
    return kind <= TIME_PREPARE;
}

typedef enum step_kind {
    STEP_END,
    STEP_WORK,        /* takes `seconds` */
    STEP_SEND,        /* sends to `other`; goes on when the last byte has left */
    STEP_RECEIVE,     /* waits for the next message of this tag from `other` */
    STEP_RECEIVE_ANY, /* from anyone */
    STEP_LOOK,        /* takes no time: whether a message of this tag waits */
    STEP_AGREE,       /* waits for all ranks; then ceil(log2(ranks)) messages of no bytes. The time
                         counts as TIME_UNEQUAL and TIME_AGREE, but before the first picture as
                         what it is spent on */
    STEP_WRITE        /* writes bytes; goes on when they are in the file */
} step_kind;

typedef struct step {
    step_kind kind;
    time_kind spent_on;
    double seconds, bytes; /* not negative */
    uint32_t other;
    int tag;
} step;

/* What the last step brought: whether there is a message, and its sender. */
typedef struct step_result {
    bool found;
    uint32_t from;
} step_result;

/* What ranks do: `next` says a rank's next step, given what its last one brought. */
typedef struct rank_program {
    void (*next)(void *state, uint32_t rank, const step_result *last, step *result);
    void *state;
} rank_program;

typedef struct machine_room {
    uint32_t ranks;
    uint32_t ranks_a_machine;
    bool one_machine;          /* files are on its disk, not on a file system that machines share */
    double latency, bandwidth; /* between machines: seconds, bytes a second */
    double local_latency, local_bandwidth; /* between ranks of one machine */
    double disk_bandwidth;                 /* of one machine's disk */
    double shared_disk_bandwidth;          /* of the file system of several machines */
} machine_room;

typedef struct run_times {
    double seconds;           /* until the last rank has ended */
    double spent[TIME_KINDS]; /* means over the ranks; they add up to `seconds`: a rank that has
                                 ended waits for others */
    double sent_bytes;        /* by all ranks, without files */
    uint64_t messages;
} run_times;

/* Runs programs until all have ended. Returns false, with a message on standard error, if ranks
 * wait for messages that never come or memory is short. */
bool engine_run(const machine_room *room, const rank_program *program, run_times *result);

/* ceil(log2(n)), n at least 1. */
uint32_t engine_log2(uint32_t n);

#endif
