/* Prints what tools/examples/obj_tga.h reads from a file, for tests/lessons/files.sh: the corners
 * of a model, or the pixels of an image, bottom row first. `copy` writes an image again. usage:
 * lesson-files obj FILE | tga FILE | copy FILE TO */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../tools/examples/obj_tga.h"

static void show_vector(gn_vec3 v)
{
    printf(" %g,%g,%g", (double)v.x, (double)v.y, (double)v.z);
}

static void show_model(const char *path)
{
    obj_model model = obj_read(path);

    printf("%u corners\n", (unsigned)model.count);
    for (uint32_t i = 0; i < model.count; ++i) {
        show_vector(model.corner[i].position);
        show_vector(model.corner[i].texcoord);
        show_vector(model.corner[i].normal);
        printf("\n");
    }
    free(model.corner);
}

static void show_image(const char *path)
{
    tga_image image = tga_read(path);

    printf("%ux%u", (unsigned)image.width, (unsigned)image.height);
    for (uint32_t i = 0; i < image.width * image.height; ++i)
        printf(" %08x", (unsigned)image.pixel[i]);
    printf("\n");
    free(image.pixel);
}

int main(int argc, char **argv)
{
    if (argc == 3 && strcmp(argv[1], "obj") == 0) {
        show_model(argv[2]);
    } else if (argc == 3 && strcmp(argv[1], "tga") == 0) {
        show_image(argv[2]);
    } else if (argc == 4 && strcmp(argv[1], "copy") == 0) {
        tga_image image = tga_read(argv[2]);

        tga_write(argv[3], image.pixel, image.width, image.height);
        free(image.pixel);
    } else {
        fputs("usage: lesson-files obj FILE | tga FILE | copy FILE TO\n", stderr);
        return 2;
    }
    return EXIT_SUCCESS;
}
