/* Reading models with Assimp. */
#define _POSIX_C_SOURCE 200809L
#include "model.h"

#include <assimp/cimport.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "report.h"

#define LIGHT_GREY 0.8f

/* What Assimp calls the material of a file that has none; its colour means nothing. */
#define NO_MATERIAL "DefaultMaterial"

/* A mesh of the file, as far as it decides which part it goes to. */
typedef struct mesh_kind {
    bool has_colors;
    int texcoord_channel;    /* -1: none */
    struct aiString texture; /* empty: none */
} mesh_kind;

static mesh_kind kind_of(const struct aiScene *file, const struct aiMesh *mesh)
{
    static const enum aiTextureType types[] = {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR};
    mesh_kind kind;
    unsigned int channel = 0;
    memset(&kind, 0, sizeof kind);
    kind.has_colors = mesh->mColors[0] != NULL;
    if (mesh->mMaterialIndex < file->mNumMaterials) {
        const struct aiMaterial *material = file->mMaterials[mesh->mMaterialIndex];
        for (int i = 0; i < 2 && kind.texture.length == 0; i++) {
            if (aiGetMaterialTexture(material, types[i], 0, &kind.texture, NULL, &channel, NULL,
                                     NULL, NULL, NULL) != aiReturn_SUCCESS)
                kind.texture.length = 0;
        }
    }
    if (channel >= AI_MAX_NUMBER_OF_TEXTURECOORDS || mesh->mTextureCoords[channel] == NULL)
        channel = 0;
    kind.texcoord_channel = mesh->mTextureCoords[channel] != NULL ? (int)channel : -1;
    if (kind.texcoord_channel < 0)
        kind.texture.length = 0;
    kind.texture.data[kind.texture.length] = '\0';
    return kind;
}

static bool belongs(const model_part *part, const mesh_kind *kind)
{
    const char *name = part->texture.name != NULL ? part->texture.name : "";
    return part->has_vertex_colors == kind->has_colors &&
           part->has_texcoords == (kind->texcoord_channel >= 0) &&
           strcmp(name, kind->texture.data) == 0;
}

/* The part a mesh goes to; a new one where none fits. There are never more parts than
 * meshes, which is what is allocated. Null where there is no memory. */
static model_part *find_part(model *m, const mesh_kind *kind)
{
    for (size_t i = 0; i < m->part_count; i++) {
        if (belongs(m->parts + i, kind))
            return m->parts + i;
    }
    model_part *part = m->parts + m->part_count++;
    part->has_vertex_colors = kind->has_colors;
    part->has_texcoords = kind->texcoord_channel >= 0;
    if (kind->texture.length > 0) {
        part->texture.name = strdup(kind->texture.data);
        if (part->texture.name == NULL)
            return NULL;
    }
    return part;
}

static uint64_t count_triangles(const struct aiMesh *mesh)
{
    uint64_t count = 0;
    for (unsigned int i = 0; i < mesh->mNumFaces; i++)
        count += mesh->mFaces[i].mNumIndices == 3;
    return count;
}

static float finite_or_zero(float value)
{
    return isfinite(value) ? value : 0.0f;
}

static void material_color(const struct aiScene *file, const struct aiMesh *mesh, float color[4])
{
    struct aiColor4D diffuse;
    struct aiString name;
    color[0] = color[1] = color[2] = LIGHT_GREY;
    color[3] = 1.0f;
    if (mesh->mMaterialIndex >= file->mNumMaterials)
        return;
    const struct aiMaterial *material = file->mMaterials[mesh->mMaterialIndex];
    if (aiGetMaterialString(material, AI_MATKEY_NAME, &name) == aiReturn_SUCCESS &&
        strcmp(name.data, NO_MATERIAL) == 0)
        return;
    if (aiGetMaterialColor(material, AI_MATKEY_BASE_COLOR, &diffuse) != aiReturn_SUCCESS &&
        aiGetMaterialColor(material, AI_MATKEY_COLOR_DIFFUSE, &diffuse) != aiReturn_SUCCESS)
        return;
    color[0] = finite_or_zero(diffuse.r);
    color[1] = finite_or_zero(diffuse.g);
    color[2] = finite_or_zero(diffuse.b);
}

/* Appends a mesh to a part whose arrays are large enough. Null, or what is wrong with it. */
static const char *append(const struct aiScene *file, const struct aiMesh *mesh,
                          const mesh_kind *kind, model_part *part)
{
    uint32_t base = part->vertex_count;
    float material[4];
    material_color(file, mesh, material);
    for (size_t i = 0; i < mesh->mNumVertices; i++) {
        size_t v = base + i;
        const struct aiVector3D *p = mesh->mVertices + i;
        float *color = part->colors + 4 * v;
        part->positions[3 * v] = p->x;
        part->positions[3 * v + 1] = p->y;
        part->positions[3 * v + 2] = p->z;
        if (mesh->mNormals != NULL) {
            part->normals[3 * v] = mesh->mNormals[i].x;
            part->normals[3 * v + 1] = mesh->mNormals[i].y;
            part->normals[3 * v + 2] = mesh->mNormals[i].z;
        }
        memcpy(color, material, sizeof material);
        if (kind->has_colors) {
            color[0] = finite_or_zero(mesh->mColors[0][i].r);
            color[1] = finite_or_zero(mesh->mColors[0][i].g);
            color[2] = finite_or_zero(mesh->mColors[0][i].b);
            color[3] = finite_or_zero(mesh->mColors[0][i].a);
        }
        if (kind->texcoord_channel >= 0) {
            const struct aiVector3D *t = mesh->mTextureCoords[kind->texcoord_channel] + i;
            part->texcoords[2 * v] = finite_or_zero(t->x);
            part->texcoords[2 * v + 1] = finite_or_zero(t->y);
        }
    }
    part->vertex_count += mesh->mNumVertices;
    for (size_t i = 0; i < mesh->mNumFaces; i++) {
        const struct aiFace *face = mesh->mFaces + i;
        if (face->mNumIndices != 3)
            continue;
        for (int k = 0; k < 3; k++) {
            if (face->mIndices[k] >= mesh->mNumVertices)
                return "a triangle names a vertex that is not there";
            size_t v = base + (size_t)face->mIndices[k];
            for (size_t c = 0; c < 3; c++) {
                if (!isfinite(part->positions[3 * v + c]))
                    return "the position of a vertex is not a finite number";
            }
            part->indices[part->index_count++] = (uint32_t)v;
        }
    }
    return NULL;
}

/* Copies the image inside the file that a part's texture names, where it names one: by
 * number, "*0", or by file name. Null, or what is wrong. */
static const char *copy_embedded(const struct aiScene *file, model_texture *texture)
{
    const struct aiTexture *found = NULL;
    if (texture->name == NULL)
        return NULL;
    if (texture->name[0] == '*') {
        unsigned long number = strtoul(texture->name + 1, NULL, 10);
        if (number >= file->mNumTextures)
            return "a material names an image inside the file that is not there";
        found = file->mTextures[number];
    }
    for (unsigned int i = 0; i < file->mNumTextures && found == NULL; i++) {
        if (strcmp(file->mTextures[i]->mFilename.data, texture->name) == 0)
            found = file->mTextures[i];
    }
    if (found == NULL)
        return NULL;
    /* Assimp: height 0 means an image file of mWidth bytes, otherwise bare texels. */
    if (found->mHeight != 0)
        return "the texture inside it is not an image file (go on without it: --shader gouraud)";
    texture->size = found->mWidth;
    texture->bytes = malloc(texture->size + 1);
    if (texture->bytes == NULL)
        return "not enough memory";
    memcpy(texture->bytes, found->pcData, texture->size);
    return NULL;
}

/* From Assimp's scene to parts. Null, or what is wrong. */
static const char *convert(const struct aiScene *file, model *m)
{
    static const char no_memory[] = "not enough memory";
    uint64_t total = 0;
    size_t mesh_count = file->mNumMeshes;
    m->parts = calloc(mesh_count + 1, sizeof *m->parts);
    uint64_t *counts = calloc(mesh_count + 1, 2 * sizeof *counts);
    const char *wrong = m->parts == NULL || counts == NULL ? no_memory : NULL;

    for (size_t i = 0; i < mesh_count && wrong == NULL; i++) {
        const struct aiMesh *mesh = file->mMeshes[i];
        uint64_t triangles = count_triangles(mesh);
        if (triangles == 0)
            continue;
        mesh_kind kind = kind_of(file, mesh);
        model_part *part = find_part(m, &kind);
        if (part == NULL) {
            wrong = no_memory;
            break;
        }
        counts[2 * (part - m->parts)] += mesh->mNumVertices;
        counts[2 * (part - m->parts) + 1] += 3 * triangles;
        total += triangles;
    }
    if (wrong == NULL && total == 0)
        wrong = "there are no triangles in it";
    for (size_t p = 0; p < m->part_count && wrong == NULL; p++) {
        model_part *part = m->parts + p;
        if (counts[2 * p] > UINT32_MAX || counts[2 * p + 1] > UINT32_MAX)
            wrong = "it has more vertices than 32 bits count";
        else if (!model_part_allocate(part, (uint32_t)counts[2 * p], (uint32_t)counts[2 * p + 1],
                                      part->has_texcoords))
            wrong = no_memory;
        part->vertex_count = 0;
        part->index_count = 0;
    }
    for (size_t i = 0; i < mesh_count && wrong == NULL; i++) {
        const struct aiMesh *mesh = file->mMeshes[i];
        if (count_triangles(mesh) == 0)
            continue;
        mesh_kind kind = kind_of(file, mesh);
        wrong = append(file, mesh, &kind, find_part(m, &kind));
    }
    for (size_t p = 0; p < m->part_count && wrong == NULL; p++)
        wrong = copy_embedded(file, &m->parts[p].texture);
    free(counts);
    return wrong;
}

/* Assimp 5.2 reads a PLY header for ever that does not end. Looks for the end within the first
 * 64 KiB, where it is in any other PLY file. */
static bool is_endless_ply(FILE *file)
{
    static const char end[] = "end_header";
    size_t length = sizeof end - 1;
    char *text = malloc(1 << 16);
    bool found = text == NULL;
    size_t size = text != NULL ? fread(text, 1, 1 << 16, file) : 0;
    bool is_ply = size >= 3 && memcmp(text, "ply", 3) == 0;
    for (size_t i = 0; is_ply && i + length <= size && !found; i++)
        found = memcmp(text + i, end, length) == 0;
    free(text);
    return is_ply && !found;
}

int model_read(const char *path, model *result)
{
    memset(result, 0, sizeof *result);

    /* What Assimp itself says to the first two is less clear. */
    struct stat status;
    FILE *probe = fopen(path, "rb");
    if (probe == NULL)
        return report_fault(path, "cannot be read: %s", strerror(errno));
    bool is_directory = fstat(fileno(probe), &status) == 0 && S_ISDIR(status.st_mode);
    bool endless = !is_directory && is_endless_ply(probe);
    fclose(probe);
    if (is_directory)
        return report_fault(path, "cannot be read: it is a directory");
    if (endless)
        return report_fault(path, "cannot be read: the header of this PLY file has no end");

    unsigned int steps = aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                         aiProcess_PreTransformVertices | aiProcess_GenUVCoords |
                         aiProcess_TransformUVCoords;
    const struct aiScene *file = aiImportFile(path, steps);
    if (file == NULL && strstr(aiGetErrorString(), "bad_alloc") != NULL)
        return report_fault(path, "cannot be read: not enough memory");
    if (file == NULL)
        return report_fault(path, "is no model that Assimp can read: %s", aiGetErrorString());
    const char *wrong = convert(file, result);
    aiReleaseImport(file);
    if (wrong == NULL && !model_complete_normals(result))
        wrong = "not enough memory";
    if (wrong != NULL) {
        model_free(result);
        return report_fault(path, "%s", wrong);
    }
    return 0;
}

bool model_part_allocate(model_part *part, uint32_t vertex_count, uint32_t index_count,
                         bool with_texcoords)
{
    size_t vertices = vertex_count;
    part->vertex_count = vertex_count;
    part->index_count = index_count;
    part->has_texcoords = with_texcoords;
    part->positions = calloc(vertices + 1, 3 * sizeof(float));
    part->normals = calloc(vertices + 1, 3 * sizeof(float));
    part->colors = calloc(vertices + 1, 4 * sizeof(float));
    part->texcoords = with_texcoords ? calloc(vertices + 1, 2 * sizeof(float)) : NULL;
    part->indices = calloc((size_t)index_count + 1, sizeof(uint32_t));
    return part->positions != NULL && part->normals != NULL && part->colors != NULL &&
           part->indices != NULL && (!with_texcoords || part->texcoords != NULL);
}

void model_free(model *m)
{
    for (size_t i = 0; i < m->part_count; i++) {
        model_part *part = m->parts + i;
        free(part->positions);
        free(part->normals);
        free(part->colors);
        free(part->texcoords);
        free(part->indices);
        free(part->texture.name);
        free(part->texture.bytes);
    }
    free(m->parts);
    memset(m, 0, sizeof *m);
}

uint64_t model_triangle_count(const model *m)
{
    uint64_t count = 0;
    for (size_t i = 0; i < m->part_count; i++)
        count += m->parts[i].index_count / 3;
    return count;
}

bounding_sphere model_bounds(const model *m)
{
    bounding_sphere sphere = {{0.0, 0.0, 0.0}, 0.0};
    double low[3] = {DBL_MAX, DBL_MAX, DBL_MAX};
    double high[3] = {-DBL_MAX, -DBL_MAX, -DBL_MAX};
    for (size_t p = 0; p < m->part_count; p++) {
        const model_part *part = m->parts + p;
        for (size_t i = 0; i < part->index_count; i++) {
            const float *position = part->positions + 3 * (size_t)part->indices[i];
            for (int c = 0; c < 3; c++) {
                low[c] = fmin(low[c], (double)position[c]);
                high[c] = fmax(high[c], (double)position[c]);
            }
        }
    }
    for (int c = 0; c < 3; c++)
        sphere.center[c] = 0.5 * (low[c] + high[c]);
    for (size_t p = 0; p < m->part_count; p++) {
        const model_part *part = m->parts + p;
        for (size_t i = 0; i < part->index_count; i++) {
            const float *position = part->positions + 3 * (size_t)part->indices[i];
            double square = 0.0;
            for (int c = 0; c < 3; c++) {
                double d = (double)position[c] - sphere.center[c];
                square += d * d;
            }
            sphere.radius = fmax(sphere.radius, sqrt(square));
        }
    }
    if (!(sphere.radius > 0.0))
        sphere.radius = 1.0;
    return sphere;
}
