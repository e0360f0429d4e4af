/* Reads OBJ (Wavefront's "Object Files") and TGA (Truevision's TGA 2.0), and writes TGA. */
#include "obj_tga.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *name;
static unsigned int line_number; /* 0: the file has no lines */

static void fail(const char *what)
{
    fprintf(stderr, line_number ? "%s: %s, line %u\n" : "%s: %s\n", name, what, line_number);
    exit(EXIT_FAILURE);
}

static FILE *open_file(const char *path, const char *mode)
{
    FILE *file = fopen(path, mode);

    name = path;
    line_number = 0;
    if (!file)
        fail("cannot be opened");
    return file;
}

typedef struct vectors {
    gn_vec3 *data;
    long count;
} vectors;

static void append(vectors *list, gn_vec3 v)
{
    if ((list->count & (list->count - 1)) == 0) /* 0 or a power of two: the room doubles */
        list->data = realloc(list->data, (2 * (size_t)list->count + 1) * sizeof v);
    if (!list->data)
        fail("needs more memory");
    list->data[list->count++] = v;
}

/* Reads v, v/vt, v//vn or v/vt/vn. Numbers count from 1 on; -1 is the last vertex so far. */
static void find_corner(const vectors list[3], const char *word, gn_vec3 corner[3])
{
    long number[3] = {0, 0, 0};

    if (sscanf(word, "%ld//%ld", &number[0], &number[2]) < 2)
        sscanf(word, "%ld/%ld/%ld", &number[0], &number[1], &number[2]);
    for (int i = 0; i < 3; ++i) {
        const long at = number[i] < 0 ? list[i].count + number[i] : number[i] - 1;

        if (number[i] ? at < 0 || at >= list[i].count : i == 0)
            fail("a face names a vertex that is not there");
        corner[i] = number[i] ? list[i].data[at] : (gn_vec3){0, 0, 0};
    }
}

/* From the third corner on, each makes a triangle with the first corner and the one before it. */
static void add_face(const vectors list[3], char *words, vectors *corners)
{
    gn_vec3 fan[3][3];
    int n = 0;

    for (char *word = strtok(words, " \t\r\n"); word; word = strtok(NULL, " \t\r\n"), ++n) {
        memcpy(fan[1], fan[2], n > 2 ? sizeof fan[1] : 0);
        find_corner(list, word, fan[n < 2 ? n : 2]);
        for (int i = 0; i < 9 && n >= 2; ++i)
            append(corners, fan[i / 3][i % 3]);
    }
    if (n < 3)
        fail("a face has fewer than three corners");
}

obj_model obj_read(const char *path)
{
    static const char *const kind[3] = {"v ", "vt ", "vn "};
    vectors list[3] = {{NULL, 0}, {NULL, 0}, {NULL, 0}}, corners = {NULL, 0};
    FILE *file = open_file(path, "r");
    char line[4096];

    while (++line_number, fgets(line, sizeof line, file)) {
        gn_vec3 v = {0, 0, 0};

        if (!strchr(line, '\n') && !feof(file))
            fail("the line is too long");
        for (int i = 0; i < 3; ++i) {
            if (strncmp(line, kind[i], strlen(kind[i])) != 0)
                continue;
            if (sscanf(line + 2, "%f%f%f", &v.x, &v.y, &v.z) < (i == 1 ? 1 : 3) ||
                !(gn_vec3_length(v) < 1e30f))
                fail("numbers are missing or too large");
            append(&list[i], v);
        }
        if (!strncmp(line, "f ", 2))
            add_face(list, line + 2, &corners);
    }
    if (!corners.count)
        fail("the file ends without a triangle");
    for (int i = 0; i < 3; ++i)
        free(list[i].data);
    fclose(file);
    return (obj_model){(obj_corner *)corners.data, (uint32_t)(corners.count / 3)};
}

tga_image tga_read(const char *path)
{
    unsigned char head[18] = {0}, texel[4] = {0, 0, 0, 255};
    FILE *file = open_file(path, "rb");
    int packet = 0, left = 0;

    if (fread(head, 1, 18, file) < 18 || head[1] != 0 || (head[2] & 0xF6) != 2 || head[17] & 16 ||
        (head[16] != 8 && head[16] != 24 && head[16] != 32))
        fail("is no TGA file of 8, 24 or 32 bits a pixel");
    const uint32_t width = head[12] + 256u * head[13], height = head[14] + 256u * head[15];
    if (width - 1 >= GN_MAX_SIZE || height - 1 >= GN_MAX_SIZE)
        fail("is not 1 to 16384 pixels wide and high");
    const tga_image image = {calloc((size_t)width * height, sizeof(uint32_t)), width, height};
    if (!image.pixel)
        fail("needs more memory");
    fseek(file, head[0], SEEK_CUR); /* over the image's name */
    for (uint32_t i = 0; i < width * height; ++i) {
        const uint32_t row = head[17] & 32 ? height - 1 - i / width : i / width;
        const bool begins = left == 0;

        packet = begins ? head[2] & 8 ? fgetc(file) : 0 : packet; /* of 1 to 128 pixels */
        left = begins ? packet & 127 : left - 1;
        if ((begins || packet < 128) && !fread(texel, head[16] / 8u, 1, file))
            fail("ends too early");
        memset(texel + 1, texel[0], head[16] == 8 ? 2 : 0); /* grey */
        image.pixel[row * width + i % width] =
            texel[2] | texel[1] << 8 | texel[0] << 16 | (uint32_t)texel[3] << 24;
    }
    fclose(file);
    return image;
}

void tga_write(const char *path, const uint32_t *pixel, uint32_t width, uint32_t height)
{
    const uint8_t head[18] = {[2] = 2, [12] = width, width >> 8, height, height >> 8, 24};
    FILE *file = open_file(path, "wb");

    fwrite(head, 1, sizeof head, file);
    for (size_t i = 0; i < (size_t)width * height; ++i)
        for (int shift = 16; shift >= 0; shift -= 8)
            putc((int)(pixel[i] >> shift & 255), file);
    if (ferror(file) || fclose(file)) {
        open_file(path, "wb"); /* an empty file rather than half a picture */
        fail("cannot be written");
    }
}
