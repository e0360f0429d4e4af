/* Reads images with stb_image. */
#include "image.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <stb/stb_image.h>

#include <gnomon/surface.h>

#include "files.h"
#include "image_file.h"

/* The text that decoder_reason returns; the next call overwrites it. */
static char reason_text[256];

static const char *decoder_reason(image_kind kind)
{
    const char *reason = stbi_failure_reason();
    if (reason != NULL && strcmp(reason, "outofmem") == 0)
        return "not enough memory";
    snprintf(reason_text, sizeof reason_text, "the %s is damaged or of an unusual kind (%s)",
             image_kind_name(kind), reason != NULL && *reason != '\0' ? reason : "no reason known");
    return reason_text;
}

/* Converts bytes R, G, B, A to the library's pixels, in place. */
static void pack(uint8_t *bytes, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        const uint8_t *b = bytes + 4 * i;
        uint32_t texel =
            (uint32_t)b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
        memcpy(bytes + 4 * i, &texel, sizeof texel);
    }
}

/* Returns null, or why an image of this size is not decoded. */
static const char *size_fault(int width, int height, const image_budget *budget)
{
    if (width < 1 || height < 1 || width > GN_MAX_SIZE || height > GN_MAX_SIZE)
        return "the image is larger than 16384 pixels, or empty";
    const uint64_t pixels = (uint64_t)width * (uint64_t)height;
    if (pixels > (uint64_t)budget->megapixels << 20) {
        snprintf(reason_text, sizeof reason_text,
                 "it has %dx%d pixels, more than --map-pixels %" PRIu32 " allows (times 1024x1024)",
                 width, height, budget->megapixels);
        return reason_text;
    }
    if (4 * pixels > budget->bytes_left) {
        snprintf(reason_text, sizeof reason_text,
                 "its %dx%d pixels take %" PRIu64 " MiB, and --import-output leaves %" PRIu64,
                 width, height, (4 * pixels + (1 << 20) - 1) >> 20, budget->bytes_left >> 20);
        return reason_text;
    }
    return NULL;
}

/* The source that stb_image reads from. stb_image reads zeros behind the end without an error, so
 * the source records that more was read than exists. */
typedef struct source {
    const uint8_t *bytes;
    size_t size;
    size_t position;
    bool ran_out;
} source;

/* Reads of this size fill stb_image's buffer, and may end early. */
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

bool image_decode(const uint8_t *bytes, size_t size, image_budget *budget, image *result,
                  const char **reason)
{
    static const stbi_io_callbacks callbacks = {source_read, source_skip, source_at_end};
    static const char cut_short[] = "the file is cut short";
    source s = {bytes, size, 0, false};
    int width = 0;
    int height = 0;
    int channels;
    const image_kind kind = image_kind_of(bytes, size);
    memset(result, 0, sizeof *result);
    *reason = kind == IMAGE_OTHER ? "it is not a " IMAGE_FORMATS_IN_WORDS : NULL;
    if (size == 0)
        *reason = "the file is empty";
    if (*reason != NULL)
        return false;
    if (stbi_info_from_callbacks(&callbacks, &s, &width, &height, &channels) == 0) {
        const bool is_short = s.ran_out || image_is_cut_short(kind, bytes, size, 0, 0);
        *reason = is_short ? cut_short : decoder_reason(kind);
        return false;
    }
    *reason = size_fault(width, height, budget);
    if (*reason == NULL && image_is_cut_short(kind, bytes, size, (uint32_t)width, (uint32_t)height))
        *reason = cut_short;
    if (*reason != NULL)
        return false;
    s = (source){bytes, size, 0, false};
    stbi_set_flip_vertically_on_load(1);
    stbi_uc *pixels = stbi_load_from_callbacks(&callbacks, &s, &width, &height, &channels, 4);
    if (pixels == NULL || s.ran_out) {
        *reason = s.ran_out ? cut_short : decoder_reason(kind);
        stbi_image_free(pixels);
        return false;
    }
    pack(pixels, (size_t)width * (size_t)height);
    result->width = (uint32_t)width;
    result->height = (uint32_t)height;
    result->texels = (uint32_t *)(void *)pixels;
    budget->bytes_left -= (uint64_t)4 * result->width * result->height;
    return true;
}

bool image_read(const char *path, image_budget *budget, image *result, const char **reason)
{
    size_t size;
    uint8_t *bytes = files_read(path, &size, reason);
    memset(result, 0, sizeof *result);
    if (bytes == NULL)
        return false;
    bool good = image_decode(bytes, size, budget, result, reason);
    free(bytes);
    return good;
}

void image_free(image *i)
{
    stbi_image_free(i->texels);
    memset(i, 0, sizeof *i);
}
