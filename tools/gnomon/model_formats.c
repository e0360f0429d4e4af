/* The table of formats. */
#include "model_formats.h"

#include <stddef.h>
#include <string.h>

#include "files.h"

/* The beginning of the name of Assimp's importer; empty: tools/models reads the format. */
static const struct {
    char extension[8];
    char name[8];
    char importer[16];
} formats[] = {
    {"obj", "OBJ", ""},
    {"ply", "PLY", ""},
    {"stl", "STL", ""},
    {"gltf", "glTF", ""},
    {"glb", "glTF", ""},
    {"dae", "Collada", "Collada"},
    {"fbx", "FBX", "Autodesk FBX"},
    {"3ds", "3DS", "Discreet 3DS"},
};

#define FORMAT_COUNT (sizeof formats / sizeof formats[0])

/* FORMAT_COUNT: none of them. */
static size_t format_of(const char *path)
{
    size_t f = 0;
    while (f < FORMAT_COUNT && !files_has_extension(path, formats[f].extension))
        ++f;
    return f;
}

const char *model_format_name(const char *path)
{
    const size_t f = format_of(path);
    return f != FORMAT_COUNT ? formats[f].name : NULL;
}

bool model_format_is_assimps(const char *path)
{
    const size_t f = format_of(path);
    return f != FORMAT_COUNT && formats[f].importer[0] != '\0';
}

bool model_format_is(const char *path, const char *importer_name)
{
    const size_t f = format_of(path);
    return f != FORMAT_COUNT &&
           strncmp(importer_name, formats[f].importer, strlen(formats[f].importer)) == 0;
}
