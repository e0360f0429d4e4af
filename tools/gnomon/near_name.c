/* Compares the names in a folder with one that was not found there. */
#define _POSIX_C_SOURCE 200809L
#include "near_name.h"

#include <ctype.h>
#include <dirent.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#include "edit_distance.h"
#include "files.h"
#include "text.h"

/* A folder is read for one message only, and may be any folder of the machine. */
enum { MOST_ENTRIES = 10000 };

/* Longer names are not compared; file systems allow 255 bytes. */
enum { MOST_LENGTH = 255 };

/* How far a name is from the wanted one. */
enum { IS_EQUAL, HAS_OTHER_ENDING, HAS_ONE_EDIT, HAS_TWO_EDITS, IS_FAR };

/* Writes the name in lower case, without percent encoding (RFC 3986, section 2.1) and without
 * blanks at its end. Returns false if it is too long, empty or no name of a file. */
static bool simplify(const char *name, char result[MOST_LENGTH + 1])
{
    size_t length = 0;
    for (const char *c = name; *c != '\0'; ++c) {
        const int high = *c == '%' ? text_hexadecimal(c[1]) : -1;
        const int low = high >= 0 ? text_hexadecimal(c[2]) : -1;
        const int value = low >= 0 ? 16 * high + low : (unsigned char)*c;
        if (length == MOST_LENGTH)
            return false;
        if (value == 0)
            return false;
        result[length++] = (char)(value < 128 ? tolower(value) : value);
        c += low >= 0 ? 2 : 0;
    }
    while (length > 0 && isspace((unsigned char)result[length - 1]))
        --length;
    result[length] = '\0';
    return length > 0;
}

/* The length of a name without its extension. */
static size_t stem_length(const char *name)
{
    const char *dot = strrchr(name, '.');
    return dot != NULL && dot > name ? (size_t)(dot - name) : strlen(name);
}

static bool is_picture(const char *name)
{
    static const char endings[][5] = {"png", "jpg", "jpeg", "tga", "bmp", "ppm", "pgm"};
    for (size_t i = 0; i < sizeof endings / sizeof endings[0]; ++i)
        if (files_has_extension(name, endings[i]))
            return true;
    return false;
}

/* Compares two simplified names. */
static int distance(const char *wanted, const char *name)
{
    const size_t stem = stem_length(wanted);
    if (strcmp(wanted, name) == 0)
        return IS_EQUAL;
    if (stem == stem_length(name) && strncmp(wanted, name, stem) == 0 && is_picture(wanted) &&
        is_picture(name))
        return HAS_OTHER_ENDING;
    const int edits = edit_distance(wanted, name);
    return edits > 2 || stem <= (size_t)edits ? IS_FAR : edits == 1 ? HAS_ONE_EDIT : HAS_TWO_EDITS;
}

/* Returns the path's folder, allocated, and the name in it; null if there is not enough memory. */
static char *split(const char *path, const char **name)
{
    const char *slash = strrchr(path, '/');
    if (slash == NULL)
        slash = strrchr(path, '\\');
    *name = slash != NULL ? slash + 1 : path;
    if (slash == NULL)
        return strdup(".");
    char *folder = strndup(path, (size_t)(slash - path) + 1);
    for (char *c = folder; c != NULL && *c != '\0'; ++c)
        if (*c == '\\' && *slash == '\\')
            *c = '/';
    return folder;
}

static bool is_file(int folder, const char *name)
{
    struct stat status;
    return fstatat(folder, name, &status, 0) == 0 && S_ISREG(status.st_mode);
}

/* Returns the nearest name in an open folder, allocated; null if there is none. */
static char *nearest_in(DIR *folder, const char *wanted)
{
    char best[MOST_LENGTH + 1] = "", simple[MOST_LENGTH + 1];
    int best_distance = IS_FAR;
    const struct dirent *entry;
    for (int i = 0; i < MOST_ENTRIES && (entry = readdir(folder)) != NULL; ++i) {
        const char *name = entry->d_name;
        if (strlen(name) > MOST_LENGTH || !simplify(name, simple))
            continue;
        const int d = distance(wanted, simple);
        if (d < best_distance || (d == best_distance && d < IS_FAR && strcmp(name, best) < 0)) {
            if (!is_file(dirfd(folder), name))
                continue;
            best_distance = d;
            strcpy(best, name);
        }
    }
    return best_distance < IS_FAR ? strdup(best) : NULL;
}

char *files_nearest(const char *path)
{
    char wanted[MOST_LENGTH + 1];
    const char *name;
    char *result = NULL;
    if (access(path, F_OK) == 0)
        return NULL;
    char *folder_path = split(path, &name);
    DIR *folder = folder_path != NULL && simplify(name, wanted) ? opendir(folder_path) : NULL;
    if (folder != NULL) {
        result = nearest_in(folder, wanted);
        closedir(folder);
    }
    free(folder_path);
    return result;
}

/* The text that files_reason_with_nearest returns; the next call overwrites it. */
static char nearest_text[1024];

const char *files_reason_with_nearest(const char *path, const char *model_path, const char *reason)
{
    const char *slash = strrchr(path, '/');
    const char *where = "in that folder";
    char *nearest = files_nearest(path);
    if (nearest == NULL && model_path != NULL && slash != NULL && access(path, F_OK) != 0) {
        char *beside = files_beside(model_path, slash + 1);
        where = "beside the model";
        if (beside != NULL)
            nearest = access(beside, F_OK) == 0 && slash[1] != '\0' ? strdup(slash + 1)
                                                                    : files_nearest(beside);
        free(beside);
    }
    if (nearest == NULL)
        return reason;
    snprintf(nearest_text, sizeof nearest_text, "%s; there is '%s' %s", reason, nearest, where);
    free(nearest);
    return nearest_text;
}
