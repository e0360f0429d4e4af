/* Reads Assimp's materials. */
#include "assimp_material.h"

#include <assimp/cimport.h>
#include <assimp/material.h>
#include <math.h>
#include <string.h>

#define LIGHT_GREY 0.8f

/* Assimp's name for the material of a file that has none; its colours have no meaning. */
#define NO_MATERIAL "DefaultMaterial"

/* The texture types that formats use for a map; OBJ files name a map of normals as one of
 * heights. */
static const enum aiTextureType map_types[MAP_COUNT][2] = {
    {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR},
    {aiTextureType_NORMALS, aiTextureType_HEIGHT},
    {aiTextureType_SPECULAR, aiTextureType_NONE},
    {aiTextureType_EMISSIVE, aiTextureType_EMISSION_COLOR},
    {aiTextureType_OPACITY, aiTextureType_NONE},
    {aiTextureType_NONE, aiTextureType_NONE},
    {aiTextureType_NONE, aiTextureType_NONE}};

/* Finds the name of a material's map and its channel of texture coordinates. Returns false if there
 * is none. */
static bool find_map(const struct aiMaterial *material, map_kind map, struct aiString *name,
                     unsigned int *channel, enum aiTextureMapMode modes[2])
{
    *channel = 0;
    modes[0] = modes[1] = aiTextureMapMode_Wrap;
    for (int i = 0; i < 2 && map_types[map][i] != aiTextureType_NONE; ++i)
        if (aiGetMaterialTexture(material, map_types[map][i], 0, name, NULL, channel, NULL, NULL,
                                 modes, NULL) == aiReturn_SUCCESS &&
            name->length > 0)
            return true;
    return false;
}

static gn_wrap wrap_of(enum aiTextureMapMode mode)
{
    return mode == aiTextureMapMode_Clamp    ? GN_WRAP_CLAMP_TO_EDGE
           : mode == aiTextureMapMode_Mirror ? GN_WRAP_MIRRORED_REPEAT
           : mode == aiTextureMapMode_Decal  ? GN_WRAP_CLAMP_TO_BORDER
                                             : GN_WRAP_REPEAT;
}

static void read_maps(const struct aiMaterial *material, const struct aiMesh *mesh,
                      mesh_material *result)
{
    unsigned int chosen = AI_MAX_NUMBER_OF_TEXTURECOORDS;
    for (int i = 0; i < MAP_COUNT && material != NULL; ++i) {
        struct aiString name;
        unsigned int channel;
        enum aiTextureMapMode modes[2];
        if (!find_map(material, (map_kind)i, &name, &channel, modes))
            continue;
        if (channel >= AI_MAX_NUMBER_OF_TEXTURECOORDS || mesh->mTextureCoords[channel] == NULL)
            channel = 0;
        if (chosen == AI_MAX_NUMBER_OF_TEXTURECOORDS)
            chosen = channel;
        if (channel != chosen || mesh->mTextureCoords[channel] == NULL)
            continue;
        result->maps[i].length = name.length;
        memcpy(result->maps[i].data, name.data, name.length);
        for (int k = 0; k < 2; ++k)
            result->wraps[i][k] = wrap_of(modes[k]);
    }
    if (chosen == AI_MAX_NUMBER_OF_TEXTURECOORDS)
        chosen = 0;
    result->texcoord_channel = mesh->mTextureCoords[chosen] != NULL ? (int)chosen : -1;
}

static void store_color(const struct aiColor4D *from, float *to)
{
    to[0] = isfinite(from->r) ? from->r : 0.0f;
    to[1] = isfinite(from->g) ? from->g : 0.0f;
    to[2] = isfinite(from->b) ? from->b : 0.0f;
}

static void read_colors(const struct aiMaterial *material, mesh_material *result)
{
    struct aiColor4D color;
    float exponent = 0.0f, opacity = 1.0f;
    if (aiGetMaterialColor(material, AI_MATKEY_BASE_COLOR, &color) == aiReturn_SUCCESS ||
        aiGetMaterialColor(material, AI_MATKEY_COLOR_DIFFUSE, &color) == aiReturn_SUCCESS)
        store_color(&color, result->color);
    if (aiGetMaterialColor(material, AI_MATKEY_COLOR_SPECULAR, &color) == aiReturn_SUCCESS)
        store_color(&color, result->surface.shine.specular);
    if (aiGetMaterialFloatArray(material, AI_MATKEY_SHININESS, &exponent, NULL) ==
            aiReturn_SUCCESS &&
        isfinite(exponent) && exponent >= 1.0f)
        result->surface.shine.exponent = (uint32_t)lrintf(fminf(exponent, MODEL_MAX_EXPONENT));
    if (aiGetMaterialFloatArray(material, AI_MATKEY_OPACITY, &opacity, NULL) == aiReturn_SUCCESS &&
        opacity >= 0.0f && opacity < 1.0f) {
        result->color[3] = opacity;
        result->surface.alpha = MODEL_BLEND;
    }
}

void material_read(const struct aiScene *file, const struct aiMesh *mesh, mesh_material *result)
{
    const struct aiMaterial *material = NULL;
    struct aiString name;
    memset(result, 0, sizeof *result);
    result->surface = model_surface_default();
    for (int c = 0; c < 3; ++c)
        result->color[c] = LIGHT_GREY;
    result->color[3] = 1.0f;
    if (mesh->mMaterialIndex < file->mNumMaterials)
        material = file->mMaterials[mesh->mMaterialIndex];
    read_maps(material, mesh, result);
    if (material != NULL &&
        !(aiGetMaterialString(material, AI_MATKEY_NAME, &name) == aiReturn_SUCCESS &&
          strcmp(name.data, NO_MATERIAL) == 0))
        read_colors(material, result);
}

static bool is_finite_color(const struct aiMaterial *material, const char *key, unsigned int type,
                            unsigned int index)
{
    struct aiColor4D color;
    return aiGetMaterialColor(material, key, type, index, &color) != aiReturn_SUCCESS ||
           (isfinite(color.r) && isfinite(color.g) && isfinite(color.b));
}

bool material_is_finite(const struct aiMaterial *material, struct aiString *name)
{
    float exponent = 0.0f;
    if (aiGetMaterialString(material, AI_MATKEY_NAME, name) != aiReturn_SUCCESS)
        memset(name, 0, sizeof *name);
    return is_finite_color(material, AI_MATKEY_BASE_COLOR) &&
           is_finite_color(material, AI_MATKEY_COLOR_DIFFUSE) &&
           is_finite_color(material, AI_MATKEY_COLOR_SPECULAR) &&
           (aiGetMaterialFloatArray(material, AI_MATKEY_SHININESS, &exponent, NULL) !=
                aiReturn_SUCCESS ||
            isfinite(exponent));
}
