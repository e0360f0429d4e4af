/* Shrinks scenes that fail the gate. A smaller scene must fail in the same way. */
#include "failure.h"

#include <errno.h>
#include <inttypes.h>
#include <string.h>

#include "shrink.h"

#define SHRINK_ATTEMPTS 4000

failure failure_of(const comparison *r)
{
    if (!compare_fails(r))
        return (failure){FAILURE_NONE, GN_OK, GN_BACKEND_AUTO};
    if (r->status != GN_OK)
        return (failure){FAILURE_REFUSED, r->status, GN_BACKEND_AUTO};
    if (r->workspace.pixels > 0)
        return (failure){FAILURE_BACKENDS, GN_OK, r->differing};
    if (r->threads.pixels > 0)
        return (failure){FAILURE_THREADS, GN_OK, GN_BACKEND_AUTO};
    if (r->reference.counts_differ && r->reference.pixels == 1)
        return (failure){FAILURE_COUNT, GN_OK, GN_BACKEND_AUTO};
    return (failure){r->reference.coverage_pixels > 0 ? FAILURE_COVERAGE : FAILURE_PIXELS, GN_OK,
                     GN_BACKEND_AUTO};
}

/* The failure that a smaller scene must show. */
typedef struct wanted {
    comparer comparer;
    uint64_t number;
    failure failure;
} wanted;

static failure failure_of_scene(const wanted *w, const scene *s)
{
    failure f = {FAILURE_NONE, GN_OK, GN_BACKEND_AUTO};
    char error[512];
    comparison r;
    if (compare_scene(&w->comparer, s, w->number, &r, error, sizeof error))
        f = failure_of(&r);
    compare_free(&r);
    return f;
}

static bool shows_failure(const scene *s, void *context)
{
    const wanted *const w = context;
    const failure f = failure_of_scene(w, s);
    return f.kind == w->failure.kind && f.status == w->failure.status &&
           f.backend == w->failure.backend;
}

static bool write_scene(const scene *s, const char *name)
{
    FILE *const out = fopen(name, "w");
    const bool written = out && scene_write(s, out);
    const int fault = errno;
    if (out && fclose(out) == 0 && written)
        return true;
    fprintf(stderr, "parity: cannot write %s: %s\n", name, strerror(written ? errno : fault));
    return false;
}

bool failure_keep(const comparer *c, const scene *s, uint64_t number, const char *name)
{
    wanted w = {*c, number, {FAILURE_NONE, GN_OK, GN_BACKEND_AUTO}};
    w.comparer.everything = true;
    w.failure = failure_of_scene(&w, s);
    scene *const small = w.failure.kind == FAILURE_NONE
                             ? scene_copy(s)
                             : shrink_scene(s, shows_failure, &w, SHRINK_ATTEMPTS);
    const bool written = write_scene(small, name);
    if (written)
        fprintf(stderr,
                "parity: kept the smallest failing scene, %" PRIu32 "x%" PRIu32 " with %" PRIu64
                " triangles; replay it with: parity --replay %s\n",
                small->width, small->height, scene_triangle_count(small), name);
    scene_free(small);
    return written;
}
