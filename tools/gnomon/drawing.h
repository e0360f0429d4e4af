/* Draws scenes with the library into one frame, and reads the frame's rows for picture files. */
#ifndef DRAWING_H
#define DRAWING_H

#include "scene.h"

typedef struct drawing {
    scene_frame frame;
    gn_workspace workspace;
} drawing;

/* Allocates for a scene, and for others that differ from it in uniforms alone. Returns 0, or
 * EXIT_FAULT with the reason printed; free with drawing_free either way. */
int drawing_allocate(const scene *s, gn_backend backend, drawing *result);

/* Draws the scene. Returns 0, or EXIT_FAULT with the reason printed. */
int drawing_draw(const scene *s, drawing *d);

void drawing_free(drawing *d);

/* Rows of a frame (png_write.h): the image that is shown, which is the resolved one if there are
 * samples. The context is the frame. */
void drawing_color_row(const void *frame, uint32_t y, uint8_t *row); /* PNG_RGBA8 */
void drawing_depth_row(const void *frame, uint32_t y, uint8_t *row); /* PNG_GREY16 */

#endif
