/* What the importing process hands over through a pipe: records of a kind each, lines of text, and
 * in the end the model with its maps. */
#ifndef HANDOVER_H
#define HANDOVER_H

#include <time.h>

#include "import.h"

typedef enum handover_record {
    HANDOVER_LINE,   /* a line to be printed */
    HANDOVER_OPENED, /* the path of a file that has been opened */
    HANDOVER_FAULT,  /* the end, the reason being among the lines */
    HANDOVER_MODEL   /* the model and its maps: the end */
} handover_record;

/* Why receiving ended. */
typedef enum handover_state {
    HANDOVER_GOING,
    HANDOVER_ENDED,    /* the pipe was closed */
    HANDOVER_LATE,     /* at the deadline */
    HANDOVER_TOO_MUCH, /* more bytes than are allowed */
    HANDOVER_WRONG,    /* bytes that make no sense */
    HANDOVER_NO_MEMORY
} handover_state;

typedef struct handover {
    int descriptor;           /* of the pipe's end that is read */
    struct timespec deadline; /* by CLOCK_MONOTONIC */
    uint64_t bytes_left;
    handover_state state;
} handover;

/* Bytes in the pipe of a part without its maps: its header and its arrays. */
uint64_t handover_size(const model_part *part);

/* The child's side. False: the pipe is closed. */
bool handover_send_text(int descriptor, handover_record kind, const char *text);
bool handover_send_model(int descriptor, const imported *what);

/* The parent's side: the next record's kind, and the text that belongs to a line or a path, cut
 * where it is longer. False: `state` says why. */
#define HANDOVER_TEXT_SIZE 16384
bool handover_receive(handover *h, handover_record *kind, char text[HANDOVER_TEXT_SIZE]);

/* What follows HANDOVER_MODEL. Counts, indices and sizes are checked. False: `state` says why; free
 * what there is with import_free either way. */
bool handover_receive_model(handover *h, imported *result);

#endif
