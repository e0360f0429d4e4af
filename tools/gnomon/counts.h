/* What became of a picture's triangles and pixels: the lines of --statistics, and a warning if
 * nothing was drawn. */
#ifndef COUNTS_H
#define COUNTS_H

#include <stdbool.h>
#include <stdio.h>

#include "picture.h"

/* Reports on a scene of triangles with depth test that has just been drawn to `frame`. If
 * `is_asked`, prints the counts into `words`. If nothing was drawn, warns on standard error, with
 * the reason; `name` names the picture. In both cases, draws the scene to the frame once more, for
 * draws that count are slower and pictures are not drawn by them. Returns 0, or EXIT_FAULT with the
 * reason printed. */
int counts_report(FILE *words, const char *name, bool is_asked, const picture *p,
                  gn_backend backend, scene_frame *frame);

#endif
