/* The faults of descriptions, one line each: the status and the words. Each file named .._faults.h
 * is written once and compiled twice: into functions that return statuses, and, if GN_FAULT_TEXTS
 * is defined before this header is included, into functions that return the words. A program that
 * does not ask for the words has no bytes of them. */
#ifndef GN_CONFIG_FAULTS_H
#define GN_CONFIG_FAULTS_H

#include <gnomon/status.h>

#if defined(GN_FAULT_TEXTS)

/* Null if there is no fault. */
typedef const char *fault;
#define NO_FAULT 0
#define FAULT(status, text) (text)

/* Returns the words for the member `after` of element i of eight. The texts are an array of arrays,
 * since a table of pointers would need relocation. */
#define FAULT_IF_EIGHTH(condition, i, status, before, after)                                       \
    do {                                                                                           \
        static const char texts[8][sizeof(before "[0]" after)] = {                                 \
            before "[0]" after, before "[1]" after, before "[2]" after, before "[3]" after,        \
            before "[4]" after, before "[5]" after, before "[6]" after, before "[7]" after};       \
        if (condition)                                                                             \
            return texts[(i)&7];                                                                   \
    } while (0)

#else

typedef gn_status fault;
#define NO_FAULT GN_OK
#define FAULT(status, text) (status)

#define FAULT_IF_EIGHTH(condition, i, status, before, after)                                       \
    do {                                                                                           \
        if (condition)                                                                             \
            return status;                                                                         \
    } while (0)

#endif

#define FAULT_IF(condition, status, text)                                                          \
    do {                                                                                           \
        if (condition)                                                                             \
            return FAULT(status, text);                                                            \
    } while (0)

/* Returns a fault that another function has found. */
#define FAULT_FROM(found)                                                                          \
    do {                                                                                           \
        const fault from = (found);                                                                \
        if (from)                                                                                  \
            return from;                                                                           \
    } while (0)

#endif
