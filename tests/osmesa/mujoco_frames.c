/* For LD_PRELOAD: writes what the program reads with mjr_readPixels, colours and depths, to the
 * file FRAMES of the environment. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>

/* As in MuJoCo's header, which is not read so that the tests compile without MuJoCo. */
typedef struct mjrRect {
    int left, bottom, width, height;
} mjrRect;
typedef void read_pixels(unsigned char *rgb, float *depth, mjrRect viewport, const void *context);

read_pixels mjr_readPixels;

void mjr_readPixels(unsigned char *rgb, float *depth, mjrRect viewport, const void *context)
{
    static read_pixels *next;
    static FILE *file;
    const size_t pixels = (size_t)viewport.width * (size_t)viewport.height;

    if (!file) {
        *(void **)(void *)&next = dlsym(RTLD_NEXT, "mjr_readPixels");
        file = fopen(getenv("FRAMES"), "wb");
    }
    if (!next || !file)
        abort();
    next(rgb, depth, viewport, context);
    fwrite(rgb, 3, pixels, file);
    fwrite(depth, sizeof *depth, pixels, file);
    fflush(file);
}
