/* What the files of the page share. */
#ifndef PAGE_PARTS_H
#define PAGE_PARTS_H

#include "page.h"

#include "camera.h"
#include "look.h"
#include "maps.h"
#include "model.h"
#include "options.h"

/* Messages (page_message.c). */

/* Forgets the message; every public function that may fail begins with it. */
void page_begin(void);

/* Sets the message to the texts in a row, up to a null pointer. Returns 1. */
int page_fail(const char *first, ...);

/* The state (page_state.c). */

typedef enum page_model_name {
    PAGE_TEAPOT = 0,
    PAGE_TRIANGLE,
    PAGE_SQUARE,
    PAGE_CUBE,
    PAGE_DROPPED
} page_model_name;

/* A state in the words of the command's options. `camera` holds what the state says of the camera;
 * the rest decides what the draws contain. */
typedef struct page_settings {
    page_model_name model;
    bool maps;
    options options;
} page_settings;

const page_settings *page_settings_now(void);

/* Sets eye and target. */
int page_set_camera(gn_vec3 eye, gn_vec3 target);

/* A number that changes with every change of the state; and one that changes when something beside
 * the camera, the convention and the picture's size does. */
uint32_t page_state_version(void);
uint32_t page_settings_version(void);

/* Models (page_shapes.c, page_model.c). */

typedef struct page_contents {
    model model;
    model ground;    /* the teapot's; zeroed: none */
    part_maps *maps; /* one of each part */
    bounding_sphere bounds;
} page_contents;

void page_contents_free(page_contents *c);

/* Makes contents of parts without maps, zeroed. Returns false if there is not enough memory; free
 * the contents either way. */
bool page_contents_allocate(page_contents *c, uint32_t parts);

/* Makes a built-in model. Returns 0; free with page_contents_free. */
int page_shape_create(page_model_name name, page_contents *result);

/* The dropped model; null, with the message set, if there is none. The number changes with it. */
const page_contents *page_dropped(void);
uint32_t page_dropped_version(void);

/* The scene (page_build.c). */

/* The scene that page_build made; null if there is none. */
scene *page_built(void);

/* The back end that draws; never GN_BACKEND_AUTO. */
gn_backend page_used_backend(void);

/* The direction towards the light of the scene. */
gn_vec3 page_light(void);

/* A number that changes with the arrays and maps of the draws. */
uint32_t page_contents_version(void);

/* The number that a draw's arrays and maps keep as long as page_contents_version stays. */
uint32_t page_mesh_of_draw(size_t draw);

#endif
