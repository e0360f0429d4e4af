/* Reading models with Assimp. */
#define _POSIX_C_SOURCE 200809L
#include "model.h"

#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "material.h"
#include "report.h"

static bool has_tangents(const struct aiMesh *mesh, const mesh_material *material)
{
    return material->texcoord_channel >= 0 && mesh->mTangents != NULL &&
           mesh->mBitangents != NULL && mesh->mNormals != NULL;
}

static bool belongs(const model_part *part, const struct aiMesh *mesh,
                    const mesh_material *material)
{
    for (int i = 0; i < MAP_COUNT; i++) {
        const char *name = part->maps[i].name != NULL ? part->maps[i].name : "";
        if (strcmp(name, material->maps[i].data) != 0)
            return false;
    }
    return part->has_vertex_colors == (mesh->mColors[0] != NULL) &&
           part->has_texcoords == (material->texcoord_channel >= 0) &&
           part->has_tangents == has_tangents(mesh, material) &&
           memcmp(&part->shine, &material->shine, sizeof part->shine) == 0;
}

/* The part a mesh goes to; a new one where none fits. There are never more parts than
 * meshes, which is what is allocated. Null where there is no memory. */
static model_part *find_part(model *m, const struct aiMesh *mesh, const mesh_material *material)
{
    for (size_t i = 0; i < m->part_count; i++) {
        if (belongs(m->parts + i, mesh, material))
            return m->parts + i;
    }
    model_part *part = m->parts + m->part_count++;
    part->has_vertex_colors = mesh->mColors[0] != NULL;
    part->has_texcoords = material->texcoord_channel >= 0;
    part->has_tangents = has_tangents(mesh, material);
    part->shine = material->shine;
    for (int i = 0; i < MAP_COUNT; i++) {
        if (material->maps[i].length == 0)
            continue;
        part->maps[i].name = strdup(material->maps[i].data);
        if (part->maps[i].name == NULL)
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

/* The tangent of a vertex and on which side of it and the normal the bitangent is. Assimp has none
 * where texture coordinates do not change: then any direction along the surface. */
static void copy_tangent(const struct aiMesh *mesh, size_t i, float *result)
{
    const struct aiVector3D n = mesh->mNormals[i];
    const struct aiVector3D t = mesh->mTangents[i];
    const struct aiVector3D b = mesh->mBitangents[i];
    const float side = b.x * (n.y * t.z - n.z * t.y) + b.y * (n.z * t.x - n.x * t.z) +
                       b.z * (n.x * t.y - n.y * t.x);
    const bool along_x = fabsf(n.x) < 0.5f;
    result[0] = along_x ? 0.0f : -n.z;
    result[1] = along_x ? n.z : 0.0f;
    result[2] = along_x ? -n.y : n.x;
    result[3] = side < 0.0f ? -1.0f : 1.0f;
    if (isfinite(t.x + t.y + t.z) && t.x * t.x + t.y * t.y + t.z * t.z > 0.0f) {
        result[0] = t.x;
        result[1] = t.y;
        result[2] = t.z;
    }
}

/* Appends a mesh to a part whose arrays are large enough. Null, or what is wrong with it. */
static const char *append(const struct aiMesh *mesh, const mesh_material *material,
                          model_part *part)
{
    uint32_t base = part->vertex_count;
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
        memcpy(color, material->color, sizeof material->color);
        if (part->has_vertex_colors) {
            color[0] = finite_or_zero(mesh->mColors[0][i].r);
            color[1] = finite_or_zero(mesh->mColors[0][i].g);
            color[2] = finite_or_zero(mesh->mColors[0][i].b);
            color[3] = finite_or_zero(mesh->mColors[0][i].a);
        }
        if (part->has_texcoords) {
            const struct aiVector3D *t = mesh->mTextureCoords[material->texcoord_channel] + i;
            part->texcoords[2 * v] = finite_or_zero(t->x);
            part->texcoords[2 * v + 1] = finite_or_zero(t->y);
        }
        if (part->has_tangents)
            copy_tangent(mesh, i, part->tangents + 4 * v);
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
    texture->bare = found->mHeight != 0;
    if (texture->bare)
        return NULL;
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
        mesh_material material;
        material_read(file, mesh, &material);
        model_part *part = find_part(m, mesh, &material);
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
        else if (!model_part_allocate(part, (uint32_t)counts[2 * p], (uint32_t)counts[2 * p + 1]))
            wrong = no_memory;
        part->vertex_count = 0;
        part->index_count = 0;
    }
    for (size_t i = 0; i < mesh_count && wrong == NULL; i++) {
        const struct aiMesh *mesh = file->mMeshes[i];
        if (count_triangles(mesh) == 0)
            continue;
        mesh_material material;
        material_read(file, mesh, &material);
        wrong = append(mesh, &material, find_part(m, mesh, &material));
    }
    for (size_t i = 0; i < MAP_COUNT * m->part_count && wrong == NULL; i++)
        wrong = copy_embedded(file, &m->parts[i / MAP_COUNT].maps[i % MAP_COUNT]);
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
                         aiProcess_TransformUVCoords | aiProcess_CalcTangentSpace;
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

bool model_part_allocate(model_part *part, uint32_t vertex_count, uint32_t index_count)
{
    size_t vertices = vertex_count;
    part->vertex_count = vertex_count;
    part->index_count = index_count;
    part->positions = calloc(vertices + 1, 3 * sizeof(float));
    part->normals = calloc(vertices + 1, 3 * sizeof(float));
    part->colors = calloc(vertices + 1, 4 * sizeof(float));
    part->texcoords = part->has_texcoords ? calloc(vertices + 1, 2 * sizeof(float)) : NULL;
    part->tangents = part->has_tangents ? calloc(vertices + 1, 4 * sizeof(float)) : NULL;
    part->indices = calloc((size_t)index_count + 1, sizeof(uint32_t));
    return part->positions != NULL && part->normals != NULL && part->colors != NULL &&
           part->indices != NULL && (!part->has_texcoords || part->texcoords != NULL) &&
           (!part->has_tangents || part->tangents != NULL);
}

void model_free(model *m)
{
    for (size_t i = 0; i < m->part_count; i++) {
        model_part *part = m->parts + i;
        free(part->positions);
        free(part->normals);
        free(part->colors);
        free(part->texcoords);
        free(part->tangents);
        free(part->indices);
        for (int k = 0; k < MAP_COUNT; k++) {
            free(part->maps[k].name);
            free(part->maps[k].bytes);
        }
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
