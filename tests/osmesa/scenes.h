/* Random scenes of OpenGL's fixed function, by class. A scene is a pure function of its seed, so
 * that two libraries get the same calls.
 *
 * Not alone: registry.py writes gl_registry.h, which it includes. */
#ifndef OSMESA_SCENES_H
#define OSMESA_SCENES_H

#include "random.h"
#include "two_libraries.h"

typedef struct scene_class {
    const char *name;
    void (*draw)(const library *gl, random_source *r, int width, int height);
    unsigned most_differing; /* pixels in a run: by a rule that is not known yet */
} scene_class;

extern const scene_class scene_classes[];
extern const unsigned scene_class_count;

#endif
