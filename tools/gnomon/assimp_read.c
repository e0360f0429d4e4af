/* Reads models with Assimp. */
#define _POSIX_C_SOURCE 200809L
#include "assimp_read.h"

#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "assimp_files.h"
#include "assimp_material.h"
#include "files.h"
#include "options.h"
#include "model_formats.h"
#include "report.h"

/* Counts of what is drawn differently from what the file says. */
typedef struct oddities {
    uint64_t normals, texcoords, colors; /* vertices with such numbers that are not finite */
    uint64_t flat;                       /* triangles without area */
    uint64_t lines;                      /* lines and points */
} oddities;

static bool has_tangents(const struct aiMesh *mesh, const mesh_material *material)
{
    return material->texcoord_channel >= 0 && mesh->mTangents != NULL &&
           mesh->mBitangents != NULL && mesh->mNormals != NULL;
}

/* The name of a part's map; empty: none. */
static const char *map_name(const model *m, const model_part *part, int map)
{
    const uint32_t image = part->maps[map].image;
    return image != MODEL_NO_IMAGE ? m->images[image].name : "";
}

static bool belongs(const model *m, const model_part *part, const struct aiMesh *mesh,
                    const mesh_material *material)
{
    for (int i = 0; i < MAP_COUNT; ++i)
        if (strcmp(map_name(m, part, i), material->maps[i].data) != 0)
            return false;
    return part->has_vertex_colors == (mesh->mColors[0] != NULL) &&
           part->has_normals == (mesh->mNormals != NULL) &&
           part->has_texcoords == (material->texcoord_channel >= 0) &&
           part->has_tangents == has_tangents(mesh, material) &&
           memcmp(&part->surface, &material->surface, sizeof part->surface) == 0;
}

/* The number of the image with this name, added if there is none; MODEL_NO_IMAGE if there is not
 * enough memory. */
static uint32_t find_image(model *m, const char *name)
{
    for (uint32_t i = 0; i < m->image_count; ++i)
        if (strcmp(m->images[i].name, name) == 0)
            return i;
    model_image *const longer = realloc(m->images, (m->image_count + 1) * sizeof *longer);
    if (longer == NULL)
        return MODEL_NO_IMAGE;
    m->images = longer;
    longer[m->image_count] = (model_image){strdup(name), NULL, 0, false};
    return longer[m->image_count].name != NULL ? m->image_count++ : MODEL_NO_IMAGE;
}

/* The part that a mesh goes to, a new one if none fits. There are never more parts than meshes, so
 * there is room for that many. Returns null if there is not enough memory. */
static model_part *find_part(model *m, const struct aiMesh *mesh, const mesh_material *material)
{
    for (size_t i = 0; i < m->part_count; ++i)
        if (belongs(m, m->parts + i, mesh, material))
            return m->parts + i;
    model_part *part = m->parts + m->part_count++;
    part->has_vertex_colors = mesh->mColors[0] != NULL;
    part->has_normals = mesh->mNormals != NULL;
    part->has_texcoords = material->texcoord_channel >= 0;
    part->has_tangents = has_tangents(mesh, material);
    part->surface = material->surface;
    for (int i = 0; i < MAP_COUNT; ++i) {
        part->maps[i] = model_map_of(MODEL_NO_IMAGE);
        if (material->maps[i].length == 0)
            continue;
        part->maps[i].image = find_image(m, material->maps[i].data);
        part->maps[i].wrap_s = material->wraps[i][0];
        part->maps[i].wrap_t = material->wraps[i][1];
        if (part->maps[i].image == MODEL_NO_IMAGE)
            return NULL;
    }
    return part;
}

static uint64_t count_triangles(const struct aiMesh *mesh)
{
    uint64_t count = 0;
    for (unsigned int i = 0; i < mesh->mNumFaces; ++i)
        count += mesh->mFaces[i].mNumIndices == 3;
    return count;
}

/* Copies numbers; those that are not finite become zero. Returns false if there was one. */
static bool copy_finite(const float *from, size_t count, float *to)
{
    bool finite = true;
    for (size_t i = 0; i < count; ++i) {
        bool good = isfinite(from[i]);
        to[i] = good ? from[i] : 0.0f;
        finite = finite && good;
    }
    return finite;
}

/* The tangent of a vertex, and on which side of tangent and normal the bitangent is. If texture
 * coordinates do not change, Assimp has no tangent; any direction along the surface is used. */
static void copy_tangent(const struct aiMesh *mesh, size_t i, float *result)
{
    const struct aiVector3D n = mesh->mNormals[i];
    const struct aiVector3D t = mesh->mTangents[i];
    const struct aiVector3D b = mesh->mBitangents[i];
    const float side = b.x * (n.y * t.z - n.z * t.y) + b.y * (n.z * t.x - n.x * t.z) +
                       b.z * (n.x * t.y - n.y * t.x);
    const bool along_x = fabsf(n.x) < 0.5f;
    const bool has_normal = isfinite(n.x) && isfinite(n.y) && isfinite(n.z);
    result[0] = along_x ? 0.0f : -n.z;
    result[1] = along_x ? n.z : 0.0f;
    result[2] = along_x ? -n.y : n.x;
    result[3] = side < 0.0f ? -1.0f : 1.0f;
    if (isfinite(t.x + t.y + t.z) && t.x * t.x + t.y * t.y + t.z * t.z > 0.0f) {
        result[0] = t.x;
        result[1] = t.y;
        result[2] = t.z;
    } else if (!has_normal) {
        result[0] = 1.0f;
        result[1] = result[2] = 0.0f;
    }
}

/* Appends a mesh to a part whose arrays are large enough, and counts oddities. Returns null, or
 * what is wrong with the mesh. */
static const char *append(const struct aiMesh *mesh, const mesh_material *material,
                          model_part *part, oddities *odd)
{
    uint32_t base = part->vertex_count;
    for (size_t i = 0; i < mesh->mNumVertices; ++i) {
        size_t v = base + i;
        const struct aiVector3D *p = mesh->mVertices + i;
        float *color = part->colors + 4 * v;
        part->positions[3 * v] = p->x;
        part->positions[3 * v + 1] = p->y;
        part->positions[3 * v + 2] = p->z;
        if (mesh->mNormals != NULL) {
            float *normal = part->normals + 3 * v;
            const struct aiVector3D n = mesh->mNormals[i];
            if (!copy_finite((const float[3]){n.x, n.y, n.z}, 3, normal)) {
                /* A zero normal is computed later. */
                memset(normal, 0, 3 * sizeof *normal);
                ++odd->normals;
            }
        }
        memcpy(color, material->color, sizeof material->color);
        if (part->has_vertex_colors) {
            const struct aiColor4D c = mesh->mColors[0][i];
            odd->colors += !copy_finite((const float[4]){c.r, c.g, c.b, c.a}, 4, color);
        }
        if (part->has_texcoords) {
            const struct aiVector3D t = mesh->mTextureCoords[material->texcoord_channel][i];
            odd->texcoords += !copy_finite((const float[2]){t.x, t.y}, 2, part->texcoords + 2 * v);
        }
        if (part->has_tangents)
            copy_tangent(mesh, i, part->tangents + 4 * v);
    }
    part->vertex_count += mesh->mNumVertices;
    for (size_t i = 0; i < mesh->mNumFaces; ++i) {
        const struct aiFace *face = mesh->mFaces + i;
        if (face->mNumIndices != 3) {
            ++odd->lines;
            continue;
        }
        for (int k = 0; k < 3; ++k) {
            if (face->mIndices[k] >= mesh->mNumVertices)
                return "a triangle names a vertex that is not there";
            size_t v = base + (size_t)face->mIndices[k];
            for (size_t c = 0; c < 3; ++c)
                if (!isfinite(part->positions[3 * v + c]))
                    return "the position of a vertex is not a finite number";
            part->indices[part->index_count++] = (uint32_t)v;
        }
        odd->flat += model_is_flat(part, part->indices + part->index_count - 3);
    }
    return NULL;
}

/* Copies the image inside the file that a material names, if it names one: by number, "*0", or by
 * file name. Returns null, or what is wrong. */
static const char *copy_embedded(const struct aiScene *file, model_image *image)
{
    const struct aiTexture *found = NULL;
    if (image->name[0] == '*') {
        unsigned long number = strtoul(image->name + 1, NULL, 10);
        if (number >= file->mNumTextures)
            return "a material names an image inside the file that is not there";
        found = file->mTextures[number];
    }
    for (unsigned int i = 0; i < file->mNumTextures && found == NULL; ++i)
        if (strcmp(file->mTextures[i]->mFilename.data, image->name) == 0)
            found = file->mTextures[i];
    if (found == NULL)
        return NULL;
    /* In Assimp, height 0 means an image file of mWidth bytes; otherwise there are raw texels. */
    image->bare = found->mHeight != 0;
    if (image->bare)
        return NULL;
    image->size = found->mWidth;
    image->bytes = malloc(image->size + 1);
    if (image->bytes == NULL)
        return IMPORT_NO_MEMORY;
    memcpy(image->bytes, found->pcData, image->size);
    return NULL;
}

/* Counts the materials of triangles. Returns false if there is not enough memory. */
static bool count_materials(const struct aiScene *file, uint32_t *count)
{
    bool *seen = calloc((size_t)file->mNumMaterials + 1, sizeof *seen);
    if (seen == NULL)
        return false;
    *count = 0;
    for (unsigned int i = 0; i < file->mNumMeshes; ++i) {
        const unsigned int material = file->mMeshes[i]->mMaterialIndex;
        if (material >= file->mNumMaterials || seen[material] ||
            count_triangles(file->mMeshes[i]) == 0)
            continue;
        seen[material] = true;
        ++*count;
    }
    free(seen);
    return true;
}

/* Converts Assimp's scene to parts. Returns null, or what is wrong. */
static const char *convert(const struct aiScene *file, model *m, oddities *odd)
{
    static const char no_memory[] = IMPORT_NO_MEMORY;
    uint64_t total = 0;
    size_t mesh_count = file->mNumMeshes;
    m->parts = calloc(mesh_count + 1, sizeof *m->parts);
    uint64_t *counts = calloc(mesh_count + 1, 2 * sizeof *counts);
    const char *wrong = m->parts == NULL || counts == NULL ? no_memory : NULL;

    for (size_t i = 0; i < mesh_count && wrong == NULL; ++i) {
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
    for (size_t p = 0; p < m->part_count && wrong == NULL; ++p) {
        model_part *part = m->parts + p;
        if (counts[2 * p] > UINT32_MAX || counts[2 * p + 1] > UINT32_MAX)
            wrong = "it has more vertices than 32 bits count";
        else if (!model_part_allocate(part, (uint32_t)counts[2 * p], (uint32_t)counts[2 * p + 1]))
            wrong = no_memory;
        part->vertex_count = 0;
        part->index_count = 0;
    }
    for (size_t i = 0; i < mesh_count && wrong == NULL; ++i) {
        const struct aiMesh *mesh = file->mMeshes[i];
        if (count_triangles(mesh) == 0)
            continue;
        mesh_material material;
        material_read(file, mesh, &material);
        wrong = append(mesh, &material, find_part(m, mesh, &material), odd);
    }
    for (uint32_t i = 0; i < m->image_count && wrong == NULL; ++i)
        wrong = copy_embedded(file, m->images + i);
    if (wrong == NULL && !count_materials(file, &m->material_count))
        wrong = no_memory;
    free(counts);
    return wrong;
}

static void warn_of(const char *path, uint64_t count, const char *one, const char *several,
                    const char *what)
{
    if (count > 0)
        report_warning(path, "%" PRIu64 " %s %s", count, count == 1 ? one : several, what);
}

/* What these formats have and Assimp's scene holds, but is not drawn. */
static void warn_of_undrawn(const char *path, const struct aiScene *file, const oddities *odd)
{
    uint64_t bones = 0, morphs = 0;
    for (unsigned int i = 0; i < file->mNumMeshes; ++i) {
        bones += file->mMeshes[i]->mNumBones;
        morphs += file->mMeshes[i]->mNumAnimMeshes;
    }
    warn_of(path, odd->lines, "line or point is", "lines and points are", "not drawn");
    warn_of(path, bones, "bone of a skin is", "bones of skins are",
            "not drawn: the mesh is as it was bound");
    warn_of(path, morphs, "morph target is", "morph targets are", "not drawn");
    warn_of(path, file->mNumAnimations, "animation is", "animations are", "not drawn");
    warn_of(path, file->mNumCameras, "camera is", "cameras are", "not used");
    warn_of(path, file->mNumLights, "light is", "lights are", "not used");
}

static void warn(const char *path, const struct aiScene *file, const oddities *odd)
{
    assimp_files_warn();
    warn_of_undrawn(path, file, odd);
    for (unsigned int i = 0; i < file->mNumMaterials; ++i) {
        struct aiString name;
        if (!material_is_finite(file->mMaterials[i], &name))
            report_warning(path,
                           "material '%s' has a number that is not finite; the default of "
                           "materials is used",
                           name.data);
    }
    warn_of(path, odd->normals, "vertex has a normal that is", "vertices have normals that are",
            "not finite; they are computed from the triangles");
    warn_of(path, odd->texcoords, "vertex has texture coordinates",
            "vertices have texture coordinates", "that are not finite; 0 is used");
    warn_of(path, odd->colors, "vertex has a colour that is", "vertices have colours that are",
            "not finite; 0 is used");
    warn_of(path, odd->flat, "triangle has", "triangles have", "no area and cannot be seen");
}

/* Whether the importer that Assimp chose is for the file's extension. If Assimp does not recognise
 * the contents by extension, it chooses by the contents. */
static bool is_of_its_format(const char *path, const struct aiScene *file)
{
    const struct aiMetadata *data = file->mMetaData;
    for (unsigned int i = 0; data != NULL && i < data->mNumProperties; ++i)
        if (strcmp(data->mKeys[i].data, "SourceAsset_Format") == 0 &&
            data->mValues[i].mType == AI_AISTRING)
            return model_format_is(path, ((const struct aiString *)data->mValues[i].mData)->data);
    return true;
}

static int import_fault(const char *path)
{
    const char *reason;
    const char *missing = assimp_files_missing(&reason);
    const char *words = aiGetErrorString();
    if (strstr(words, "bad_alloc") != NULL || strstr(words, "std::vector") != NULL ||
        strstr(words, "vector::") != NULL)
        return report_fault(path, "cannot be read: " IMPORT_NO_MEMORY);
    if (missing != NULL)
        return report_fault(path, "cannot be read: the file '%s' that it names: %s", missing,
                            reason);
    return report_fault(path, "is not a model that Assimp can read: %s", words);
}

/* The main chunk of a 3DS file begins with two bytes of kind and four of length. Assimp reads what
 * is there of a file that is cut short. */
static int check_3ds(const char *path)
{
    uint8_t start[6];
    uint64_t size;
    const char *reason;
    const int descriptor = files_open(path, &size, &reason);
    if (descriptor < 0)
        return report_fault(path, "cannot be read: %s", reason);
    const ssize_t length = read(descriptor, start, sizeof start);
    close(descriptor);
    const uint64_t whole = (uint64_t)start[2] | (uint64_t)start[3] << 8 | (uint64_t)start[4] << 16 |
                           (uint64_t)start[5] << 24;
    if (length < (ssize_t)sizeof start || whole > size)
        return report_fault(path, "it is cut short: it announces %llu bytes but has %llu",
                            (unsigned long long)(length < (ssize_t)sizeof start ? 6 : whole),
                            (unsigned long long)size);
    return 0;
}

int assimp_read(const char *path, double crease_degrees, model *result)
{
    const unsigned int steps = aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                               aiProcess_PreTransformVertices | aiProcess_GenUVCoords |
                               aiProcess_TransformUVCoords | aiProcess_CalcTangentSpace;
    oddities odd = {0, 0, 0, 0, 0};
    memset(result, 0, sizeof *result);
    int fault = files_has_extension(path, "3ds") ? check_3ds(path) : 0;
    if (fault != 0)
        return fault;
    const struct aiScene *file = aiImportFileEx(path, steps, assimp_files(path));
    if (file == NULL) {
        fault = import_fault(path);
    } else if (!is_of_its_format(path, file)) {
        fault = report_fault(path, "its extension does not match its contents; formats are %s",
                             MODEL_FORMATS_IN_WORDS);
    } else {
        const char *wrong = convert(file, result, &odd);
        uint64_t memory_left = UINT64_MAX;
        if (wrong == NULL && !model_complete_normals(result, crease_degrees, &memory_left))
            wrong = IMPORT_NO_MEMORY;
        if (wrong == NULL)
            warn(path, file, &odd);
        else
            fault = report_fault(path, "%s", wrong);
    }
    if (fault != 0)
        model_free(result);
    if (file != NULL)
        aiReleaseImport(file);
    assimp_files_free();
    return fault;
}
