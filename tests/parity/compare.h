/* Draws one scene with the library and with the reference and compares the frames. */
#ifndef PARITY_COMPARE_H
#define PARITY_COMPARE_H

#include "../../tools/threads/pool.h"
#include "osmesa.h"
#include "scene.h"

/* Numbers of threads that scenes are drawn with: 1, 2, 3 and 8. */
#define COMPARE_POOLS 4

typedef struct comparer {
    reference *reference;
    thread_pool *pools[COMPARE_POOLS];
    bool everything; /* every scene with all workspaces and numbers of threads, not with some */
} comparer;

/* The result for one scene. The frames are empty (null) if the status is a fault. */
typedef struct comparison {
    gn_status status;           /* the library's */
    scene_difference reference; /* the library's frame against the reference's */
    scene_difference
        workspace; /* the library's frame against those with other workspaces and back ends */
    scene_difference threads; /* the library's frame against those with threads */
    gn_backend differing;     /* if `workspace` counts pixels: the back end that differs */
    uint64_t drawn;           /* pixels that the reference drew on */
    scene_frame ours, theirs;
} comparison;

/* Creates a comparer's pools of threads, for the whole run. Returns false if threads cannot be
 * started. */
bool compare_start(comparer *c);
void compare_stop(comparer *c);

/* Draws and compares. The number selects the smaller workspaces and the threads. Returns false with
 * a reason if the reference could not draw. compare_free frees the frames. */
bool compare_scene(const comparer *c, const scene *s, uint64_t number, comparison *result,
                   char *error, size_t error_size);
void compare_free(comparison *result);

/* Whether the scene fails the gate. */
bool compare_fails(const comparison *result);

/* Pixels that differ in any way; at least 1 if the library reports a fault. */
uint64_t compare_count(const comparison *result);

/* Prints both values of the first `limit` differing pixels to stdout. */
void compare_print_pixels(const comparison *result, uint64_t limit);

#endif
