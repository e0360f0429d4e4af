/* Makes the picture of a lesson's page from the image that the lesson has written: half as wide and
 * high, every pixel the mean of four. `check` compares instead with the picture that is there. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "image.h"
#include "../../tools/examples/obj_tga.h"
#include "png_write.h"

/* The mean of a channel of four pixels, rounded. */
static uint8_t mean(const tga_image *from, uint32_t x, uint32_t y, int channel)
{
    const uint32_t *pixel = from->pixel + (size_t)2 * y * from->width + 2 * x;
    const uint32_t four[4] = {pixel[0], pixel[1], pixel[from->width], pixel[from->width + 1]};
    uint32_t sum = 2;
    for (int i = 0; i < 4; ++i)
        sum += four[i] >> (8 * channel) & 255;
    return (uint8_t)(sum / 4);
}

static void put_row(const void *context, uint32_t y, uint8_t *row)
{
    const tga_image *from = context;
    for (uint32_t x = 0; x < from->width / 2; ++x)
        for (int c = 0; c < 3; ++c)
            row[3 * x + (uint32_t)c] = mean(from, x, from->height / 2 - 1 - y, c);
}

static int write_picture(const tga_image *from, const char *path)
{
    output file;
    int fault = output_open(&file, path);
    if (fault != 0)
        return fault;
    fault = png_write(&file, PNG_RGB8, from->width / 2, from->height / 2, put_row, from);
    if (fault == 0)
        fault = output_finish(&file);
    if (fault == 0)
        fault = output_rename(&file);
    output_abandon(&file);
    return fault;
}

static int check_picture(const tga_image *from, const char *path)
{
    image_budget budget = {64, UINT64_C(1) << 30};
    const char *reason;
    image there;
    size_t different = 0;
    if (!image_read(path, &budget, &there, &reason)) {
        fprintf(stderr, "%s: %s\n", path, reason);
        return 1;
    }
    if (there.width != from->width / 2 || there.height != from->height / 2) {
        fprintf(stderr, "%s: another size than the lesson's picture\n", path);
        return 1;
    }
    for (uint32_t i = 0; i < there.width * there.height; ++i)
        for (int c = 0; c < 3; ++c)
            different += mean(from, i % there.width, i / there.width, c) !=
                         (there.texels[i] >> (8 * c) & 255);
    image_free(&there);
    if (different > 0)
        fprintf(stderr,
                "%s: %zu channels differ from what the lesson draws; make lesson-pictures\n", path,
                different);
    return different > 0;
}

int main(int argc, char **argv)
{
    const bool checks = argc == 4 && strcmp(argv[1], "check") == 0;
    if (argc != 3 && !checks) {
        fputs("usage: lesson-picture [check] LESSON.tga PICTURE.png\n", stderr);
        return 2;
    }
    tga_image from = tga_read(argv[argc - 2]);
    const int fault =
        checks ? check_picture(&from, argv[argc - 1]) : write_picture(&from, argv[argc - 1]);
    free(from.pixel);
    return fault;
}
