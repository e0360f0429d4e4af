/* What becomes of a model that Assimp has read: this file stands in for Assimp and hands the
 * command any scene of meshes, materials and images that its importers may make, hostile numbers
 * included. What comes out can be drawn. */
#include <assimp/cimport.h>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bounds.h"
#include "assimp_files.h"
#include "fuzz.h"
#include "assimp_read.h"
#include "report.h"

enum { MOST_MESHES = 4, MOST_VERTICES = 16, MOST_FACES = 12, MOST_IMAGES = 3, PROPERTIES = 12 };

static fuzz_input *input;
static int faults;

/* Memory of the scene, in one list. */
static void *blocks[512];
static size_t block_count;

static void *block(size_t size)
{
    void *const memory = fuzz_memory(size ? size : 1);

    FUZZ_REQUIRE(block_count < sizeof blocks / sizeof blocks[0]);
    memset(memory, 0, size ? size : 1);
    return blocks[block_count++] = memory;
}

static struct aiVector3D *vectors(unsigned int count)
{
    struct aiVector3D *const v = block(count * sizeof *v);

    for (unsigned int i = 0; i < count; ++i) {
        v[i].x = fuzz_tame(input);
        v[i].y = fuzz_tame(input);
        v[i].z = fuzz_tame(input);
    }
    return v;
}

static void fill_string(struct aiString *s)
{
    static const char *const names[] = {"*0", "*1",  "*99999999999999999999", "a.png", "",
                                        "*",  "*-1", "DefaultMaterial",       "a/../b"};

    strcpy(s->data, names[fuzz_below(input, sizeof names / sizeof names[0])]);
    s->length = (ai_uint32)strlen(s->data);
}

static struct aiMesh *make_mesh(void)
{
    struct aiMesh *const m = block(sizeof *m);
    const uint8_t has = fuzz_byte(input);

    m->mNumVertices = fuzz_below(input, MOST_VERTICES);
    m->mVertices = vectors(m->mNumVertices);
    m->mNormals = has & 1 ? vectors(m->mNumVertices) : NULL;
    m->mTangents = has & 2 ? vectors(m->mNumVertices) : NULL;
    m->mBitangents = has & 4 ? vectors(m->mNumVertices) : NULL;
    if (has & 8) {
        m->mColors[0] = block(m->mNumVertices * sizeof *m->mColors[0]);
        for (unsigned int i = 0; i < m->mNumVertices; ++i)
            m->mColors[0][i].g = fuzz_tame(input);
    }
    if (has & 16)
        m->mTextureCoords[0] = vectors(m->mNumVertices);
    if (has & 32)
        m->mTextureCoords[1] = vectors(m->mNumVertices);
    m->mMaterialIndex = fuzz_below(input, 4);
    m->mNumFaces = fuzz_below(input, MOST_FACES);
    m->mFaces = block(m->mNumFaces * sizeof *m->mFaces);
    for (unsigned int i = 0; i < m->mNumFaces; ++i) {
        struct aiFace *const f = &m->mFaces[i];

        f->mNumIndices = fuzz_rarely(input, 8) ? fuzz_below(input, 5) : 3;
        f->mIndices = block(f->mNumIndices * sizeof *f->mIndices);
        for (unsigned int k = 0; k < f->mNumIndices; ++k) {
            const uint8_t byte = fuzz_byte(input);

            f->mIndices[k] = byte == 255           ? fuzz_word(input)
                             : m->mNumVertices > 0 ? byte % m->mNumVertices
                                                   : 0;
        }
    }
    return m;
}

/* A material's property: a colour, a number, the name of a map or its channel, under any of the
 * keys that the command asks for, of the right size and type or not. */
static struct aiMaterialProperty *make_property(void)
{
    static const char *const keys[] = {"?mat.name",  "$clr.diffuse",   "$clr.specular",
                                       "$clr.base",  "$mat.shininess", "$tex.file",
                                       "$tex.uvwsrc"};
    static const unsigned int maps[] = {aiTextureType_DIFFUSE,  aiTextureType_NORMALS,
                                        aiTextureType_HEIGHT,   aiTextureType_SPECULAR,
                                        aiTextureType_EMISSIVE, aiTextureType_BASE_COLOR};
    struct aiMaterialProperty *const p = block(sizeof *p);
    const uint32_t key = fuzz_below(input, sizeof keys / sizeof keys[0]);
    float numbers[4];

    strcpy(p->mKey.data, keys[key]);
    p->mKey.length = (ai_uint32)strlen(keys[key]);
    p->mSemantic = key >= 5 ? maps[fuzz_below(input, 6)] : 0;
    if (key == 0 || key == 5) { /* strings: the length in 32 bits, the bytes, a zero */
        struct aiString s = {0};

        fill_string(&s);
        p->mType = aiPTI_String;
        p->mDataLength = 4 + s.length + 1;
        p->mData = block(p->mDataLength);
        memcpy(p->mData, &s.length, 4);
        memcpy(p->mData + 4, s.data, s.length + 1);
    } else if (key == 6) {
        const int channel = (int)fuzz_byte(input) - 4;

        p->mType = aiPTI_Integer;
        p->mDataLength = sizeof channel;
        p->mData = block(sizeof channel);
        memcpy(p->mData, &channel, sizeof channel);
    } else {
        for (int i = 0; i < 4; ++i)
            numbers[i] = fuzz_float(input);
        p->mType = aiPTI_Float;
        p->mDataLength = key == 4 ? 4 : fuzz_rarely(input, 4) ? 16 : 12;
        p->mData = block(16);
        memcpy(p->mData, numbers, p->mDataLength);
    }
    return p;
}

static struct aiMaterial *make_material(void)
{
    struct aiMaterial *const m = block(sizeof *m);

    m->mNumProperties = m->mNumAllocated = fuzz_below(input, PROPERTIES);
    m->mProperties = block(m->mNumProperties * sizeof *m->mProperties);
    for (unsigned int i = 0; i < m->mNumProperties; ++i)
        m->mProperties[i] = make_property();
    return m;
}

static struct aiTexture *make_image(void)
{
    struct aiTexture *const t = block(sizeof *t);

    t->mHeight = fuzz_rarely(input, 4) ? 1 + fuzz_below(input, 4) : 0;
    t->mWidth = fuzz_below(input, 32);
    /* Bytes of a file, or texels of four bytes. */
    t->pcData = block(t->mHeight ? (size_t)4 * t->mWidth * t->mHeight : t->mWidth);
    fill_string(&t->mFilename);
    return t;
}

/* In place of Assimp's functions of the same names. */

const struct aiScene *aiImportFileEx(const char *path, unsigned int flags, struct aiFileIO *files)
{
    struct aiScene *const s = block(sizeof *s);

    (void)path;
    (void)flags;
    (void)files;
    if (fuzz_rarely(input, 64))
        return NULL;
    s->mNumMeshes = fuzz_below(input, MOST_MESHES);
    s->mMeshes = block(s->mNumMeshes * sizeof *s->mMeshes);
    s->mNumMaterials = fuzz_below(input, 3);
    s->mMaterials = block(s->mNumMaterials * sizeof *s->mMaterials);
    s->mNumTextures = fuzz_below(input, MOST_IMAGES);
    s->mTextures = block(s->mNumTextures * sizeof *s->mTextures);
    for (unsigned int i = 0; i < s->mNumMeshes; ++i)
        s->mMeshes[i] = make_mesh();
    for (unsigned int i = 0; i < s->mNumMaterials; ++i)
        s->mMaterials[i] = make_material();
    for (unsigned int i = 0; i < s->mNumTextures; ++i)
        s->mTextures[i] = make_image();
    return s;
}

void aiReleaseImport(const struct aiScene *released)
{
    (void)released;
}

const char *aiGetErrorString(void)
{
    return "nothing to read";
}

static void look_at_line(const char *line)
{
    faults += !strstr(line, "warning");
    FUZZ_REQUIRE(strncmp(line, "gnomon: model", 13) == 0);
}

static void require_sound(const model_part *part)
{
    FUZZ_REQUIRE(part->index_count > 0 && part->index_count % 3 == 0);
    FUZZ_REQUIRE(part->surface.shine.exponent >= 1 &&
                 part->surface.shine.exponent <= MODEL_MAX_EXPONENT);
    for (uint32_t i = 0; i < part->index_count; ++i) {
        FUZZ_REQUIRE(part->indices[i] < part->vertex_count);
        for (uint32_t c = 0; c < 3; ++c) {
            FUZZ_REQUIRE(isfinite(part->positions[3 * part->indices[i] + c]));
            FUZZ_REQUIRE(isfinite(part->normals[3 * part->indices[i] + c]));
        }
    }
    for (uint32_t v = 0; v < part->vertex_count; ++v) {
        for (uint32_t c = 0; c < 4; ++c)
            FUZZ_REQUIRE(isfinite(part->colors[4 * v + c]));
        for (uint32_t c = 0; c < 2 && part->has_texcoords; ++c)
            FUZZ_REQUIRE(isfinite(part->texcoords[2 * v + c]));
        for (uint32_t c = 0; c < 4 && part->has_tangents; ++c)
            FUZZ_REQUIRE(isfinite(part->tangents[4 * v + c]));
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    fuzz_input in = fuzz_begin(bytes, size);
    model m;

    input = &in;
    faults = 0;
    report_to(look_at_line);
    const int fault = assimp_read("model", MODEL_CREASE_DEGREES, &m);

    FUZZ_REQUIRE(faults == (fault != 0));
    if (fault == 0) {
        const bounding_sphere sphere = model_bounds(&m);

        FUZZ_REQUIRE(m.part_count > 0 && sphere.radius > 0.0 && isfinite(sphere.radius));
        for (size_t p = 0; p < m.part_count; ++p)
            require_sound(&m.parts[p]);
        model_free(&m);
    }
    for (size_t i = 0; i < block_count; ++i)
        free(blocks[i]);
    block_count = 0;
    return 0;
}
