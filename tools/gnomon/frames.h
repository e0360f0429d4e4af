/* Frames: pictures of the same models, turned or from several cameras. All ranks draw and write
 * them, each frame at one rank. */
#ifndef FRAMES_H
#define FRAMES_H

#include "drawing.h"
#include "picture.h"
#include "picture_files.h"
#include "tasks.h"

typedef struct frames {
    contents c;
    picture p;
    drawing d;
    double seconds; /* of drawing, at this rank */
} frames;

/* Collective. Prepares for drawing the contents that stand in `f`. Returns the same at all ranks;
 * free with frames_free either way. */
int frames_begin(const options *o, frames *f);

/* Draws the contents, turned, from the options' camera. The options differ in the camera alone from
 * those at the beginning, and must stay until the next frame. Returns 0, or EXIT_FAULT with the
 * reason printed. */
int frames_draw(frames *f, const options *o, const gn_transform *turn);

/* Warns if nothing is to be seen in the frame that has been drawn; `name` names it. Returns 0, or
 * EXIT_FAULT with the reason printed. The frame is drawn once more then. */
int frames_warn(const char *name, const options *o, frames *f);

/* The rows of the frame that has been drawn; while they are read, questions of other ranks are
 * answered. */
typedef struct frames_rows {
    const scene_frame *frame;
    tasks *t;
} frames_rows;
void frames_color_row(const void *rows, uint32_t y, uint8_t *row);
void frames_depth_row(const void *rows, uint32_t y, uint8_t *row);

/* Collective. Prints how many frames were drawn and how fast; over several ranks, also how many
 * each of them drew (`here` at this rank) and how much memory it took. `words` is null at ranks
 * that print nothing. */
void frames_print(FILE *words, const frames *f, const char *what, uint32_t count, uint32_t here);

void frames_free(frames *f);

#endif
