/* Reads models from OBJ files; reads and writes images as TGA files. A file that is missing or
 * wrong ends the program, with one line on stderr that says what is wrong. */
#ifndef OBJ_TGA_H
#define OBJ_TGA_H

#include <gnomon.h>

typedef struct obj_corner {
    gn_vec3 position, texcoord, normal; /* 0, 0, 0 where the file has none; texcoord is s, t, 0 */
} obj_corner;

typedef struct obj_model {
    obj_corner *corner; /* three for each triangle; polygons become fans. The caller frees them */
    uint32_t count;     /* of corners */
} obj_model;

typedef struct tga_image {
    uint32_t *pixel; /* GN_FORMAT_RGBA8, bottom row first. The caller frees them */
    uint32_t width, height;
} tga_image;

obj_model obj_read(const char *path);
tga_image tga_read(const char *path); /* 8, 24 or 32 bits a pixel, with or without run lengths */
void tga_write(const char *path, const uint32_t *pixel, uint32_t width, uint32_t height);

#endif
