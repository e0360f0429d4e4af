/* Reading images with stb_image. */
#include "image.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include <gnomon/surface.h>
#include <stb/stb_image.h>

static const char *decoder_reason(void)
{
    const char *reason = stbi_failure_reason();
    return reason != NULL ? reason : "no image";
}

/* Bytes R, G, B, A to the library's pixels, in place. */
static void pack(uint8_t *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const uint8_t *b = bytes + 4 * i;
        uint32_t texel = (uint32_t)b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 |
                         (uint32_t)b[3] << 24;
        memcpy(bytes + 4 * i, &texel, sizeof texel);
    }
}

static bool check_size(int width, int height, const char **reason)
{
    if (width >= 1 && height >= 1 && width <= GN_MAX_SIZE && height <= GN_MAX_SIZE)
        return true;
    *reason = "the image is larger than 16384 pixels";
    return false;
}

static bool finish(stbi_uc *pixels, int width, int height, image *result, const char **reason)
{
    if (pixels == NULL) {
        *reason = decoder_reason();
        return false;
    }
    pack(pixels, (size_t)width * (size_t)height);
    result->width = (uint32_t)width;
    result->height = (uint32_t)height;
    result->texels = (uint32_t *)(void *)pixels;
    return true;
}

bool image_read(const char *path, image *result, const char **reason)
{
    int width = 0;
    int height = 0;
    int channels;
    struct stat status;
    memset(result, 0, sizeof *result);
    if (stat(path, &status) == 0 && S_ISDIR(status.st_mode)) {
        *reason = "it is a directory";
        return false;
    }
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        *reason = strerror(errno);
        return false;
    }
    bool known = stbi_info_from_file(file, &width, &height, &channels) != 0;
    if (!known)
        *reason = decoder_reason();
    bool good = known && check_size(width, height, reason);
    if (good) {
        stbi_set_flip_vertically_on_load(1);
        stbi_uc *pixels = stbi_load_from_file(file, &width, &height, &channels, 4);
        good = finish(pixels, width, height, result, reason);
    }
    fclose(file);
    return good;
}

bool image_decode(const uint8_t *bytes, size_t size, image *result, const char **reason)
{
    int width = 0;
    int height = 0;
    int channels;
    memset(result, 0, sizeof *result);
    if (size > INT_MAX) {
        *reason = "the image is too large";
        return false;
    }
    if (stbi_info_from_memory(bytes, (int)size, &width, &height, &channels) == 0) {
        *reason = decoder_reason();
        return false;
    }
    if (!check_size(width, height, reason))
        return false;
    stbi_set_flip_vertically_on_load(1);
    return finish(stbi_load_from_memory(bytes, (int)size, &width, &height, &channels, 4), width,
                  height, result, reason);
}

void image_free(image *i)
{
    stbi_image_free(i->texels);
    memset(i, 0, sizeof *i);
}
