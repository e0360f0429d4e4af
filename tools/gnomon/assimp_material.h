/* What Assimp's materials say about the surface of a mesh. */
#ifndef ASSIMP_MATERIAL_H
#define ASSIMP_MATERIAL_H

#include <assimp/scene.h>

#include "model.h"

typedef struct mesh_material {
    float color[4];                  /* the diffuse colour, or light grey */
    model_surface surface;           /* the material's, or weak highlights */
    int texcoord_channel;            /* -1: the mesh has no texture coordinates */
    struct aiString maps[MAP_COUNT]; /* names of the maps; empty: no map */
    gn_wrap wraps[MAP_COUNT][2];
} mesh_material;

/* The channel is the one of the material's first map; maps with another channel are left out. */
void material_read(const struct aiScene *file, const struct aiMesh *mesh, mesh_material *result);

/* Whether the numbers that material_read reads from a material are finite; and the material's
 * name. */
bool material_is_finite(const struct aiMaterial *material, struct aiString *name);

#endif
