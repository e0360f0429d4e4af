/* Reading images with stb_image. */
#include "image.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gnomon/surface.h>
#include <stb/stb_image.h>

static const char *decoder_reason(void)
{
    const char *reason = stbi_failure_reason();
    if (reason != NULL && strcmp(reason, "outofmem") == 0)
        return "not enough memory";
    return reason != NULL ? reason : "no image";
}

/* Bytes R, G, B, A to the library's pixels, in place. */
static void pack(uint8_t *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const uint8_t *b = bytes + 4 * i;
        uint32_t texel =
            (uint32_t)b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
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

/* Where stb_image reads from. It takes what lies behind the end for zeros without a word, so
 * it is noted that it wanted more than there was. */
typedef struct source {
    const uint8_t *bytes;
    size_t size;
    size_t position;
    bool ran_out;
} source;

/* Reads of this size are stb_image filling its buffer, which may end early. */
#define BUFFER_SIZE 128

static int source_read(void *user, char *data, int size)
{
    source *s = user;
    size_t left = s->size - s->position;
    size_t count = (size_t)size < left ? (size_t)size : left;
    memcpy(data, s->bytes + s->position, count);
    s->position += count;
    if (count == 0 || (count < (size_t)size && size != BUFFER_SIZE))
        s->ran_out = true;
    return (int)count;
}

static void source_skip(void *user, int distance)
{
    source *s = user;
    size_t left = s->size - s->position;
    if (distance > 0 && (size_t)distance > left)
        s->position = s->size;
    else
        s->position += (size_t)distance; /* backwards too, modulo the range of size_t */
}

static int source_at_end(void *user)
{
    const source *s = user;
    return s->position >= s->size;
}

bool image_decode(const uint8_t *bytes, size_t size, image *result, const char **reason)
{
    static const stbi_io_callbacks callbacks = {source_read, source_skip, source_at_end};
    source s = {bytes, size, 0, false};
    int width = 0;
    int height = 0;
    int channels;
    memset(result, 0, sizeof *result);
    if (stbi_info_from_callbacks(&callbacks, &s, &width, &height, &channels) == 0) {
        *reason = decoder_reason();
        return false;
    }
    if (!check_size(width, height, reason))
        return false;
    s = (source){bytes, size, 0, false};
    stbi_set_flip_vertically_on_load(1);
    stbi_uc *pixels = stbi_load_from_callbacks(&callbacks, &s, &width, &height, &channels, 4);
    if (pixels == NULL || s.ran_out) {
        *reason = pixels == NULL ? decoder_reason() : "the file is cut short";
        stbi_image_free(pixels);
        return false;
    }
    pack(pixels, (size_t)width * (size_t)height);
    result->width = (uint32_t)width;
    result->height = (uint32_t)height;
    result->texels = (uint32_t *)(void *)pixels;
    return true;
}

/* A whole file, allocated. Null with the reason otherwise. */
static uint8_t *read_file(const char *path, size_t *size, const char **reason)
{
    uint8_t *bytes = NULL;
    size_t capacity = 1 << 16;
    FILE *file = fopen(path, "rb");
    *size = 0;
    if (file == NULL) {
        *reason = strerror(errno);
        return NULL;
    }
    for (;;) {
        uint8_t *larger = realloc(bytes, capacity);
        if (larger == NULL) {
            *reason = "not enough memory";
            break;
        }
        bytes = larger;
        *size += fread(bytes + *size, 1, capacity - *size, file);
        if (*size < capacity) {
            if (ferror(file) == 0) {
                fclose(file);
                return bytes;
            }
            *reason = strerror(errno);
            break;
        }
        capacity *= 2;
    }
    free(bytes);
    fclose(file);
    return NULL;
}

bool image_read(const char *path, image *result, const char **reason)
{
    size_t size;
    uint8_t *bytes = read_file(path, &size, reason);
    if (bytes == NULL)
        return false;
    bool good = image_decode(bytes, size, result, reason);
    free(bytes);
    return good;
}

void image_free(image *i)
{
    stbi_image_free(i->texels);
    memset(i, 0, sizeof *i);
}
