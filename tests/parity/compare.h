/* One scene drawn by the library and by the reference, compared. */
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
    bool coverage_only; /* colour and depth may differ: not the contract's Mesa */
    bool everything;    /* all workspaces and numbers of threads on every scene, not some */
} comparer;

/* What became of a scene. The frames are empty (null) where the status is a fault. */
typedef struct comparison {
    gn_status status;           /* the library's */
    scene_difference reference; /* ours and the reference's */
    scene_difference workspace; /* ours with other workspaces and back ends */
    scene_difference threads;   /* ours with threads */
    gn_backend differing;       /* where workspace has pixels: the back end asked for there */
    uint64_t drawn;             /* pixels the reference drew on */
    scene_frame ours, theirs;
} comparison;

/* The pools of a comparer, for the whole run; false where threads cannot be had. */
bool compare_start(comparer *c);
void compare_stop(comparer *c);

/* Draws and compares; the number chooses the smaller workspace and the threads. False with
 * a reason where the reference could not draw. compare_free frees the frames. */
bool compare_scene(const comparer *c, const scene *s, uint64_t number, comparison *result,
                   char *error, size_t error_size);
void compare_free(comparison *result);

/* Whether the scene fails the gate. */
bool compare_fails(const comparer *c, const comparison *result);

/* Pixels that differ, in whatever way; at least 1 where the library reports a fault. */
uint64_t compare_count(const comparison *result);

/* Prints both values of the first `limit` differing pixels to stdout. */
void compare_print_pixels(const comparison *result, uint64_t limit);

#endif
