/* The entry points of back ends, and calls of them by the back end's number. The files
 * NAME.c and shading_NAME.c define those of one back end, from backend.inl and shading.inl.
 *
 * A call compares numbers and names the function. A table of functions would need relocation, which
 * some compilers make data for, and a program that calls one of its functions would link them all.
 */
#ifndef GN_BACKENDS_ENTRY_POINTS_H
#define GN_BACKENDS_ENTRY_POINTS_H

#include "../config/backends.h"
#include "../config/features.h"
#include "../kernel/draw/job.h"
#include "../kernel/math/bulk_job.h"
#include "../kernel/shaders/shading.h"
#include "../kernel/surfaces/row_work.h"

/* Declares the entry points of each row of GN_BACKENDS. Those of back ends that are not compiled
 * are not defined.
 *
 * gni_draw_<name> runs a whole draw. If an index is at or beyond the mesh's vertex_count, returns
 * GN_INDEX_OUT_OF_RANGE and draws nothing. gni_bulk_<name> works on whole blocks of vectors or
 * matrices. gni_shading_<name> fills in the functions for a pipeline's shaders; the user's own
 * shaders stay what they are. With GN_SMALL no gni_shading_<name> is defined. */
#define GN_DECLARE_ENTRY_POINTS(name, NAME, have, text)                                            \
    gn_status gni_draw_##name(const draw_job *job);                                                \
    void gni_bulk_##name(const bulk_job *job);                                                     \
    void gni_shading_##name(const gn_pipeline *pipeline, shading_functions *out);
GN_BACKENDS(GN_DECLARE_ENTRY_POINTS)
#undef GN_DECLARE_ENTRY_POINTS

/* The form of one lane beside the portable back end, if GN_HAVE_ONE_LANE. */
gn_status gni_draw_one_lane(const draw_job *job);
void gni_shading_one_lane(const gn_pipeline *pipeline, shading_functions *out);

/* Whether work on rows has forms for vector instructions of x86, which the processor is asked for.
 */
#define GN_HAVE_VECTOR_ROWS (GN_HAVE_SSE41 && !GN_IS_SMALL)

/* Work on rows is compiled over the portable lanes and, for x86, over SSE4.1 and AVX2. It is apart
 * from the back ends, so that a program that only clears or blits does not link a rasterizer. */
void gni_rows_portable(const row_work *work);
void gni_rows_sse41(const row_work *work);
void gni_rows_avx2(const row_work *work);

static inline bool backend_is_compiled(gn_backend backend)
{
#define GN_IS_COMPILED(name, NAME) || backend == GN_BACKEND_##NAME
    return false GN_COMPILED_BACKENDS(GN_IS_COMPILED);
#undef GN_IS_COMPILED
}

/* Returns GN_BACKEND_UNAVAILABLE if the back end is not compiled. */
static inline gn_status draw_on(gn_backend backend, const draw_job *job)
{
#define GN_DRAW_ON(name, NAME)                                                                     \
    if (backend == GN_BACKEND_##NAME)                                                              \
        return gni_draw_##name(job);
    GN_COMPILED_BACKENDS(GN_DRAW_ON)
#undef GN_DRAW_ON
    return GN_BACKEND_UNAVAILABLE;
}

/* Precondition: the back end is compiled. */
static inline void bulk_on(gn_backend backend, const bulk_job *job)
{
#define GN_BULK_ON(name, NAME)                                                                     \
    if (backend == GN_BACKEND_##NAME)                                                              \
        gni_bulk_##name(job);
    GN_COMPILED_BACKENDS(GN_BULK_ON)
#undef GN_BULK_ON
}

/* Fills in what a draw shades with. With GN_SMALL there is one form of lookups (lookup.c) and of
 * shaders, whatever the back end, and with GN_BASIC only gn_texture_lookup_2d. Writes nothing if
 * the back end is not compiled. */
void gni_small_texture_functions(gn_texture_functions *out);

static inline void shading_on(gn_backend backend, const gn_pipeline *pipeline,
                              shading_functions *out)
{
#if GN_SPECIALISED
#define GN_SHADING_ON(name, NAME)                                                                  \
    if (backend == GN_BACKEND_##NAME)                                                              \
        gni_shading_##name(pipeline, out);
    GN_COMPILED_BACKENDS(GN_SHADING_ON)
#undef GN_SHADING_ON
#else
    (void)backend;
    gni_small_texture_functions(&out->texture_functions);
    out->vertex_shader = pipeline->program.vertex_shader;
    out->fragment_shader = pipeline->program.fragment_shader;
#endif
}

/* From this many pixels on the processor is asked which back end it runs. On a virtual machine
 * asking can take as long as work on tens of thousands of pixels. */
#define ROW_PIXELS_TO_ASK 32768

/* Returns the back end whose lanes work on `pixels` pixels. */
static inline gn_backend backend_of_rows(size_t pixels)
{
    return GN_HAVE_VECTOR_ROWS && pixels >= ROW_PIXELS_TO_ASK ? gn_backend_best()
                                                              : GN_BACKEND_PORTABLE;
}

static inline void rows_on(gn_backend backend, const row_work *work)
{
#if GN_HAVE_VECTOR_ROWS
    if (GN_HAVE_AVX2 && backend >= GN_BACKEND_AVX2) {
        gni_rows_avx2(work);
        return;
    }
    if (backend == GN_BACKEND_SSE41) {
        gni_rows_sse41(work);
        return;
    }
#else
    (void)backend;
#endif
    gni_rows_portable(work);
}

#endif
