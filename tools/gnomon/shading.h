/* The shaders for pictures, by name, and the maps that they take. */
#ifndef SHADING_H
#define SHADING_H

#include <stdbool.h>

#include "model.h"
#include "scene.h"

typedef enum shading {
    SHADING_AUTOMATIC = 0, /* metallic-roughness for glTF's materials; else Phong if there is a map
                              or shadows, otherwise Gouraud */
    SHADING_VERTEX_COLOR,
    SHADING_UNLIT,
    SHADING_FLAT,
    SHADING_GOURAUD,
    SHADING_TOON,
    SHADING_PHONG,
    SHADING_BLINN_PHONG,
    SHADING_NORMALS,
    SHADING_DEPTH,
    SHADING_METALLIC_ROUGHNESS,
    SHADING_COUNT
} shading;

typedef struct shading_traits {
    char name[24];      /* as --shader names it; empty for SHADING_AUTOMATIC */
    char words[24];     /* in sentences */
    unsigned int maps;  /* a set of 1 << map_kind */
    bool takes_shadows; /* lit at every pixel */
    scene_shader shader;
} shading_traits;

const shading_traits *shading_traits_of(shading which);

/* Returns false if no shader has this name. */
bool shading_by_name(const char *name, shading *result);

#endif
