/* The table of formats, and checks of formats that state their own length. */
#define _POSIX_C_SOURCE 200809L
#include "model_formats.h"

#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "files.h"
#include "report.h"

typedef enum format {
    FORMAT_OBJ,
    FORMAT_PLY,
    FORMAT_STL,
    FORMAT_GLTF,
    FORMAT_GLB,
    FORMAT_COLLADA,
    FORMAT_FBX,
    FORMAT_3DS,
    FORMAT_COUNT
} format;

/* The beginning of the name of Assimp's importer. */
static const struct {
    char extension[8];
    char importer[24];
} formats[FORMAT_COUNT] = {
    {"obj", "Wavefront Object"},
    {"ply", "Stanford Polygon"},
    {"stl", "Stereolithography"},
    {"gltf", "glTF"},
    {"glb", "glTF"},
    {"dae", "Collada"},
    {"fbx", "Autodesk FBX"},
    {"3ds", "Discreet 3DS"},
};

/* FORMAT_COUNT: none of them. */
static format format_of(const char *path)
{
    int f = 0;
    while (f < FORMAT_COUNT && !files_has_extension(path, formats[f].extension))
        ++f;
    return (format)f;
}

const char *model_format_name(const char *path)
{
    static const char names[FORMAT_COUNT][8] = {"OBJ",  "PLY",     "STL", "glTF",
                                                "glTF", "Collada", "FBX", "3DS"};
    const format f = format_of(path);
    return f != FORMAT_COUNT ? names[f] : NULL;
}

int model_format_is(const char *path, const char *importer_name)
{
    format f = format_of(path);
    return f != FORMAT_COUNT &&
           strncmp(importer_name, formats[f].importer, strlen(formats[f].importer)) == 0;
}

static uint32_t little_endian_32(const unsigned char *bytes)
{
    return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 |
           (uint32_t)bytes[3] << 24;
}

static int length_fault(const char *path, uint64_t announced, uint64_t size)
{
    return report_fault(path, "it is cut short: it announces %llu bytes but has %llu",
                        (unsigned long long)announced, (unsigned long long)size);
}

/* STL is a text of facets, or 80 bytes, a count and 50 bytes per triangle (3D Systems, 1989). */
static int check_stl(const char *path, FILE *file, uint64_t size)
{
    unsigned char start[84];
    char end[256];
    size_t length = fread(start, 1, sizeof start, file);
    uint64_t whole = 84;
    if (length == sizeof start)
        whole += 50 * (uint64_t)little_endian_32(start + 80);
    if (length < 5 || memcmp(start, "solid", 5) != 0)
        return whole > size || length < sizeof start ? length_fault(path, whole, size) : 0;
    /* Some binary files begin with that word too. */
    if (length == sizeof start && whole == size)
        return 0;
    long tail = size < sizeof end - 1 ? (long)size : (long)sizeof end - 1;
    length = fseek(file, -tail, SEEK_END) == 0 ? fread(end, 1, (size_t)tail, file) : 0;
    for (size_t i = 0; i + 8 <= length; ++i)
        if (memcmp(end + i, "endsolid", 8) == 0)
            return 0;
    report_warning(path, "it does not end with endsolid: it may be cut short");
    return 0;
}

/* glTF 2.0, section 4.4.1: the magic number, the version and the total length. */
static int check_glb(const char *path, FILE *file, uint64_t size)
{
    unsigned char start[12];
    size_t length = fread(start, 1, sizeof start, file);
    if (memcmp(start, "glTF", length < 4 ? length : 4) != 0)
        return report_fault(path, "is not a binary glTF file: it does not begin with glTF");
    if (length < sizeof start)
        return length_fault(path, sizeof start, size);
    uint64_t whole = little_endian_32(start + 8);
    return whole > size ? length_fault(path, whole, size) : 0;
}

static int check_gltf(const char *path, FILE *file)
{
    int c = getc(file);
    while (c == ' ' || c == '\t' || c == '\r' || c == '\n')
        c = getc(file);
    return c == '{' ? 0 : report_fault(path, "is not a glTF file: it does not begin with {");
}

/* The main chunk of a 3DS file: two bytes of kind, four of length. */
static int check_3ds(const char *path, FILE *file, uint64_t size)
{
    unsigned char start[6];
    if (fread(start, 1, sizeof start, file) < sizeof start)
        return length_fault(path, sizeof start, size);
    uint64_t whole = little_endian_32(start + 2);
    return whole > size ? length_fault(path, whole, size) : 0;
}

static int check(const char *path, format which, FILE *file, uint64_t size)
{
    switch (which) {
    case FORMAT_OBJ:
        return model_check_obj(path, file);
    case FORMAT_PLY:
        return model_check_ply(path, file, size);
    case FORMAT_STL:
        return check_stl(path, file, size);
    case FORMAT_GLTF:
        return check_gltf(path, file);
    case FORMAT_GLB:
        return check_glb(path, file, size);
    case FORMAT_3DS:
        return check_3ds(path, file, size);
    default:
        return 0;
    }
}

/* Skips a byte-order mark, as assimp_files.c does. */
static void skip_mark(FILE *file)
{
    char start[3];
    if (fread(start, 1, sizeof start, file) != sizeof start ||
        memcmp(start, "\xef\xbb\xbf", sizeof start) != 0)
        rewind(file);
}

int model_format_check(const char *path)
{
    const char *reason;
    uint64_t size;
    format which = format_of(path);
    int descriptor = files_open(path, &size, &reason);
    if (descriptor < 0)
        return report_fault(path, "cannot be read: %s", reason);
    FILE *file = fdopen(descriptor, "rb");
    if (file == NULL) {
        close(descriptor);
        return report_fault(path, "cannot be read: %s", strerror(errno));
    }
    int fault = 0;
    if (which == FORMAT_COUNT) {
        fault = report_fault(path, "its extension is not that of a model format; formats are %s",
                             MODEL_FORMATS_IN_WORDS);
    } else if (size == 0) {
        fault = report_fault(path, "it is empty");
    } else {
        if (which == FORMAT_OBJ || which == FORMAT_PLY || which == FORMAT_GLTF)
            skip_mark(file);
        fault = check(path, which, file, size);
    }
    fclose(file);
    return fault;
}
