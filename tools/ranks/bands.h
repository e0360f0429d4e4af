/* Sort-first (Molnar, Cox, Ellsworth and Fuchs, "A Sorting Classification of Parallel Rendering",
 * 1994): each rank draws some rows of one target that nobody has as a whole. A rank's surfaces have
 * the target's full size and are cut by the scissor, so every pixel is that of a single process in
 * every state. Only memory of rows that are touched is used. */
#ifndef BANDS_H
#define BANDS_H

#include "scene.h"

/* Rows of a picture, counted from the top. */
typedef struct row_range {
    uint32_t first, count;
} row_range;

/* Row n of a picture belongs to unit (n + band_shift(height)) / unit. */
static inline uint32_t band_shift(uint32_t height)
{
    return height & 1;
}

/* The rows of units first to end - 1 of a picture, as far as there are such rows. */
row_range band_of_units(uint32_t height, uint32_t unit, uint64_t first, uint64_t end);

/* The rows of one of `count` ranks. Ranks have consecutive rows from the top, in whole units of
 * `unit` rows, an even number. Only the last unit may be shorter, and the first one by one row, so
 * that all bands begin at even rows of the window: differences between the pixels of a square of
 * two by two may depend on which of them pass the tests (GN_AT_CENTROID). Numbers of units differ
 * by at most one.
 *
 * Heights are equal and a rank has one band: every band costs the vertices of the whole scene once
 * more, so many narrow bands for a better balance would make the part grow that does not scale. */
row_range band_of_rank(uint32_t height, uint32_t unit, uint32_t number, uint32_t count);

/* Makes a zeroed frame of which no page has memory before it is touched. Returns false if there are
 * not enough addresses. */
bool band_frame_reserve(scene_frame *frame, const scene *s);
void band_frame_release(scene_frame *frame);

/* Returns the memory of these rows to the system, but for pages at their ends. What the rows hold
 * afterwards is not known. */
void band_frame_forget(scene_frame *frame, row_range rows);

/* Clears rows of the frame and draws the scene there, with all clears between draws. The scene's
 * own scissors hold as well. Samples are not resolved. Counts go where the workspace says. */
gn_status band_draw(const scene *s, row_range rows, scene_frame *frame, gn_workspace *workspace);

/* Resolves samples of these rows; does nothing if pixels have one sample. */
gn_status band_resolve(const scene *s, row_range rows, scene_frame *frame);

#endif
