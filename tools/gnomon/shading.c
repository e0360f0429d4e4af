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
        {"", "automatic", ALL, true, SCENE_GOURAUD},
        {"vertex-color", "vertex colours", 0, false, SCENE_VERTEX_COLOR},
        {"unlit", "unlit", DIFFUSE, false, SCENE_UNLIT},
        {"flat", "flat", DIFFUSE, true, SCENE_FACES},
        {"gouraud", "Gouraud", DIFFUSE, false, SCENE_GOURAUD},
        {"toon", "toon", DIFFUSE, true, SCENE_TOON},
        {"phong", "Phong", GLOSS, true, SCENE_MAPPED_PHONG},
        {"blinn-phong", "Blinn-Phong", GLOSS, true, SCENE_BLINN_PHONG},
        {"normals", "normals", NORMAL, false, SCENE_NORMAL_COLOR},
        {"depth", "depth", 0, false, SCENE_DEPTH_COLOR},
        {"metallic-roughness", "metallic-roughness", METAL, true, SCENE_METALLIC_ROUGHNESS},
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
