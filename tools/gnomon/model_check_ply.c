/* Checks headers of PLY files before Assimp reads them. Assimp 5.2 never ends on a header without
 * an end, and allocates as many elements as a header announces. */
#define _POSIX_C_SOURCE 200809L
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "model_formats.h"
#include "report.h"

#define LINE_SIZE 512

typedef struct element {
    char name[64];
    unsigned long long count;
    unsigned long long least; /* bytes of one element */
} element;

/* Bytes of a scalar in a binary file. */
static unsigned int scalar_size(const char *type)
{
    static const struct {
        char name[8];
        unsigned int size;
    } types[] = {{"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},
                 {"short", 2}, {"ushort", 2},  {"int16", 2},  {"uint16", 2},
                 {"int", 4},   {"uint", 4},    {"int32", 4},  {"uint32", 4},
                 {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
    for (size_t i = 0; i < sizeof types / sizeof types[0]; ++i)
        if (strcmp(type, types[i].name) == 0)
            return types[i].size;
    return 1;
}

/* Reads a line, cut if it is longer than `text`. Returns false if no line with an end follows, or
 * if a byte cannot belong to a header. */
static bool read_line(FILE *file, char *text, uint64_t *read)
{
    size_t length = 0;
    for (;;) {
        int c = getc_unlocked(file);
        if (c == EOF || c == '\0')
            return false;
        ++*read;
        if (c == '\n')
            break;
        if (length + 1 < LINE_SIZE && c != '\r')
            text[length++] = (char)c;
    }
    text[length] = '\0';
    return true;
}

int model_check_ply(const char *path, FILE *file, uint64_t size)
{
    char line[LINE_SIZE];
    uint64_t header = 0;
    bool binary = false;
    element e = {"", 0, 0};
    /* The sum cannot overflow: it ends when it exceeds the file's size. */
    unsigned long long needed = 0;
    bool first = true;
    for (;;) {
        char word[3][64] = {"", "", ""};
        if (!read_line(file, line, &header))
            return report_fault(path, "it is cut short: the header of this PLY file has no end");
        int words = sscanf(line, "%63s %63s %63s", word[0], word[1], word[2]);
        if (first && strcmp(line, "ply") != 0)
            return report_fault(path, "is not a PLY file: its first line is not ply");
        first = false;
        bool ends = strncmp(line, "end_header", 10) == 0 &&
                    (line[10] == '\0' || line[10] == ' ' || line[10] == '\t');
        if (ends || strcmp(word[0], "element") == 0) {
            unsigned long long least = e.least > 0 ? e.least : 1;
            if (e.count > (size - needed) / least)
                return report_fault(path,
                                    "it is cut short: its header announces %llu of '%s', more "
                                    "than its %llu bytes hold",
                                    e.count, e.name, (unsigned long long)size);
            needed += e.count * least;
            memset(&e, 0, sizeof e);
        }
        if (ends)
            break;
        if (strcmp(word[0], "format") == 0)
            binary = strncmp(word[1], "binary", 6) == 0;
        if (strcmp(word[0], "element") == 0 && words == 3) {
            strcpy(e.name, word[1]);
            e.count = strtoull(word[2], NULL, 10);
        }
        /* In a text an element needs at least a digit and a space. */
        if (strcmp(word[0], "property") == 0)
            e.least += !binary                        ? 2
                       : strcmp(word[1], "list") == 0 ? scalar_size(word[2])
                                                      : scalar_size(word[1]);
    }
    /* The last digit of a text may have nothing behind it. */
    if (needed > size - header + (binary ? 0 : 1))
        return report_fault(path,
                            "it is cut short: its header announces %llu bytes at least, and %llu "
                            "follow it",
                            needed, (unsigned long long)(size - header));
    return 0;
}
