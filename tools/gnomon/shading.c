/* The table of shaders. */
#include "shading.h"

#include <string.h>

#define DIFFUSE (1u << MAP_DIFFUSE)
#define NORMAL (1u << MAP_NORMAL)
#define ALL (DIFFUSE | NORMAL | 1u << MAP_SPECULAR | 1u << MAP_GLOW)

const shading_traits *shading_traits_of(shading which)
{
    static const shading_traits traits[SHADING_COUNT] = {
        {"", "automatic", ALL, true},           {"vertex-color", "vertex colours", 0, false},
        {"unlit", "unlit", DIFFUSE, false},     {"flat", "flat", DIFFUSE, true},
        {"gouraud", "Gouraud", DIFFUSE, false}, {"toon", "toon", DIFFUSE, true},
        {"phong", "Phong", ALL, true},          {"blinn-phong", "Blinn-Phong", ALL, true},
        {"normals", "normals", NORMAL, false},  {"depth", "depth", 0, false},
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
