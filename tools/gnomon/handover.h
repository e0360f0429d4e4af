/* The confined process sends records through a pipe: lines of text, and finally what it has read,
 * such as a model with its maps. */
#ifndef HANDOVER_H
#define HANDOVER_H

#include <time.h>

#include "import.h"

typedef enum handover_record {
    HANDOVER_LINE,   /* a line to print */
    HANDOVER_OPENED, /* the path of a file that has been opened */
    HANDOVER_FAULT,  /* failure, the last record; the reason is among the lines */
    HANDOVER_RESULT  /* what was asked for, the last record */
} handover_record;

/* Why receiving ended. */
typedef enum handover_state {
    HANDOVER_GOING,
    HANDOVER_ENDED,    /* the pipe was closed */
    HANDOVER_LATE,     /* the deadline has passed */
    HANDOVER_TOO_MUCH, /* more bytes than allowed */
    HANDOVER_WRONG,    /* bytes that are not a valid record */
    HANDOVER_NO_MEMORY
} handover_state;

typedef struct handover {
    int descriptor;           /* the reading end of the pipe */
    struct timespec deadline; /* by CLOCK_MONOTONIC */
    uint64_t bytes_left;
    handover_state state;
    files_list opened; /* who receives the result may take it */
} handover;

/* Bytes in the pipe for a part without its maps: its header and its arrays. */
uint64_t handover_size(const model_part *part);

/* The child's side. Return false if the pipe is closed. Bytes follow the text of a result. */
bool handover_send_text(int descriptor, handover_record kind, const char *text);
bool handover_send_bytes(int descriptor, const void *bytes, uint64_t size);
bool handover_send_model(int descriptor, const imported *what);

/* The parent's side: receives the next record's kind, and the text of a line or a path, which is
 * cut if it is too long. Returns false with the reason in `state`. */
#define HANDOVER_TEXT_SIZE 16384
bool handover_receive(handover *h, handover_record *kind, char text[HANDOVER_TEXT_SIZE]);

/* Receives this many bytes. Returns false with the reason in `state`. */
bool handover_receive_bytes(handover *h, void *bytes, uint64_t size);

/* Receives what follows the HANDOVER_RESULT of a model. Counts, indices and sizes are checked.
 * Returns false with the reason in `state`; free with import_free either way. */
bool handover_receive_model(handover *h, imported *result);

#endif
