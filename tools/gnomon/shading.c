/* The table of shaders. */
#include "shading.h"

#include <string.h>

#define DIFFUSE (1u << MAP_DIFFUSE)
#define NORMAL (1u << MAP_NORMAL)
#define GLOSS (DIFFUSE | NORMAL | 1u << MAP_SPECULAR | 1u << MAP_GLOW)
#define METAL (DIFFUSE | NORMAL | 1u << MAP_GLOW | 1u << MAP_ROUGHNESS | 1u << MAP_OCCLUSION)
#define ALL (GLOSS | METAL)

const shading_traits *shading_traits_of(shading which)
{
    static const shading_traits traits[SHADING_COUNT] = {
        {"", "automatic", ALL, true},
        {"vertex-color", "vertex colours", 0, false},
        {"unlit", "unlit", DIFFUSE, false},
        {"flat", "flat", DIFFUSE, true},
        {"gouraud", "Gouraud", DIFFUSE, false},
        {"toon", "toon", DIFFUSE, true},
        {"phong", "Phong", GLOSS, true},
        {"blinn-phong", "Blinn-Phong", GLOSS, true},
        {"normals", "normals", NORMAL, false},
        {"depth", "depth", 0, false},
        {"metallic-roughness", "metallic-roughness", METAL, true},
    };
    return traits + which;
}

bool shading_by_name(const char *name, shading *result)
{
    for (int i = SHADING_AUTOMATIC + 1; i < SHADING_COUNT; ++i) {
        if (strcmp(name, shading_traits_of((shading)i)->name) == 0) {
            *result = (shading)i;
            return true;
        }
    }
    return false;
}
