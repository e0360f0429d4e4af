/* Views: a list of cameras, from a text. A line has options of the camera in the command's own
 * words, as in "--eye 0,1,5 --fov 30"; # begins a comment. */
#ifndef VIEWS_H
#define VIEWS_H

#include "camera.h"

typedef struct view {
    uint64_t line; /* in the file, from 1 on */
    camera_options camera;
} view;

typedef struct views {
    view *list;
    uint32_t count;
} views;

#define VIEWS_MOST 100000

/* Reads views. What a line does not say is as in `others`; a line with --fov is not orthographic
 * even if the others are. Returns 0; EXIT_USAGE if the text is wrong, with the line and the option;
 * or EXIT_FAULT if the file cannot be read. The reason has been printed then. Free either way. */
int views_read(const char *path, const camera_options *others, views *result);

/* Checks that every camera can be placed to look at this sphere. Returns 0, or EXIT_FAULT with the
 * line and the option printed. */
int views_check(const char *path, const views *v, const bounding_sphere *sphere, uint32_t width,
                uint32_t height);

void views_free(views *v);

#endif
