/* Reads images: TGA and PPM here, the other formats with stb_image. */
#include "image.h"

#include <inttypes.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <stb/stb_image.h>

#include <gnomon/surface.h>

#include "files.h"
#include "image_exif.h"
#include "image_file.h"
#include "image_ppm.h"
#include "image_tga.h"
#include "options.h"

/* The text that decoder_reason returns; the next call overwrites it. */
static char reason_text[256];

static const char *decoder_reason(image_kind kind)
{
    const char *reason = stbi_failure_reason();
    if (reason != NULL && strcmp(reason, "outofmem") == 0)
        return IMPORT_NO_MEMORY;
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
static const char *size_fault(uint32_t width, uint32_t height, uint32_t bytes_per_pixel,
                              const image_budget *budget)
{
    if (width < 1 || height < 1 || width > GN_MAX_SIZE || height > GN_MAX_SIZE)
        return "the image is larger than 16384 pixels, or empty";
    const uint64_t pixels = (uint64_t)width * height;
    const uint64_t size = bytes_per_pixel * pixels;
    if (pixels > (uint64_t)budget->megapixels << 20) {
        snprintf(reason_text, sizeof reason_text,
                 "it has %ux%u pixels, more than --map-pixels %" PRIu32 " allows (times 1024x1024)",
                 (unsigned)width, (unsigned)height, budget->megapixels);
        return reason_text;
    }
    if (size > budget->bytes_left) {
        snprintf(reason_text, sizeof reason_text,
                 "its %ux%u pixels take %" PRIu64 " MiB, and --import-output leaves %" PRIu64,
                 (unsigned)width, (unsigned)height, (size + (1 << 20) - 1) >> 20,
                 budget->bytes_left >> 20);
        return reason_text;
    }
    return NULL;
}

/* Returns null, or why a PNG is not decoded. stb_image would call it damaged, or memory short. */
static const char *png_fault(const uint8_t *bytes, size_t size, uint32_t most_bits,
                             const image_budget *budget)
{
    png_header h;
    if (!image_png_header(bytes, size, &h))
        return NULL;
    const uint32_t bits = h.bits == 16 && most_bits == 16 ? 16 : 8;
    const char *reason = size_fault(h.width, h.height, bits / 2, budget);
    /* stb_image counts the bytes of all four channels in an int. */
    if (reason != NULL || h.bits != 16 || !h.has_colors ||
        (uint64_t)8 * h.width * h.height <= INT_MAX)
        return reason;
    snprintf(reason_text, sizeof reason_text,
             "it has %ux%u pixels of 16 bits a channel, more than can be decoded",
             (unsigned)h.width, (unsigned)h.height);
    return reason_text;
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

static const char cut_short[] = "the file is cut short";

static const stbi_io_callbacks callbacks = {source_read, source_skip, source_at_end};

/* Reads size and channels of a file that stb_image reads. Returns null, or what is wrong. */
static const char *read_header(source s, image_kind kind, image_values *result)
{
    const source start = s;
    int width, height, channels;
    if (stbi_info_from_callbacks(&callbacks, &s, &width, &height, &channels) == 0)
        return s.ran_out || image_is_cut_short(kind, s.bytes, s.size, 0, 0) ? cut_short
                                                                            : decoder_reason(kind);
    result->width = width > 0 ? (uint32_t)width : 0;
    /* A BMP whose upper row is the first has a negative height. */
    const bool is_top_down = kind == IMAGE_BMP && height < 0;
    result->height = is_top_down ? 0 - (uint32_t)height : height > 0 ? (uint32_t)height : 0;
    result->channels = (uint32_t)channels;
    s = start;
    result->bits = kind == IMAGE_PNG && stbi_is_16_bit_from_callbacks(&callbacks, &s) ? 16 : 8;
    return NULL;
}

/* Rounds values of 16 bits to the nearest of 8, in place, since stb_image would drop the lower byte
 * (PNG, section 13.12: the scales end at 65535 = 257 * 255). */
static void narrow(void *values, size_t count)
{
    uint8_t *to = values;
    for (size_t i = 0; i < count; ++i) {
        uint16_t value;
        memcpy(&value, to + 2 * i, sizeof value);
        to[i] = (uint8_t)((value + 128u) / 257);
    }
}

/* Decodes a file that stb_image reads. Returns null, or what is wrong. */
static const char *decode_pixels(source s, image_kind kind, uint32_t file_bits, bool bottom_first,
                                 image_values *result)
{
    int width, height, channels;
    stbi_set_flip_vertically_on_load(bottom_first);
    result->values =
        file_bits == 16
            ? (void *)stbi_load_16_from_callbacks(&callbacks, &s, &width, &height, &channels, 4)
            : stbi_load_from_callbacks(&callbacks, &s, &width, &height, &channels, 4);
    if (result->values == NULL || s.ran_out) {
        const char *reason = s.ran_out ? cut_short : decoder_reason(kind);
        stbi_image_free(result->values);
        result->values = NULL;
        return reason;
    }
    if (file_bits > result->bits) {
        const size_t size = (size_t)4 * result->width * result->height;
        narrow(result->values, size);
        void *shorter = realloc(result->values, size);
        result->values = shorter != NULL ? shorter : result->values;
    }
    return NULL;
}

/* The headers of the formats that are read without stb_image. */
typedef struct own_headers {
    ppm_header ppm;
    tga_header tga;
} own_headers;

/* Returns null, or why a TGA or PPM cannot be read. */
static const char *read_own_header(image_kind kind, const uint8_t *bytes, size_t size,
                                   own_headers *headers, image_values *result)
{
    const ppm_header *ppm = &headers->ppm;
    const tga_header *tga = &headers->tga;
    const char *reason = kind == IMAGE_TGA ? image_tga_header(bytes, size, &headers->tga)
                                           : image_ppm_header(bytes, size, &headers->ppm);
    if (reason != NULL)
        return reason;
    result->width = kind == IMAGE_TGA ? tga->width : ppm->width;
    result->height = kind == IMAGE_TGA ? tga->height : ppm->height;
    result->channels = kind == IMAGE_TGA ? tga->channels : ppm->channels;
    result->bits = 8;
    return NULL;
}

/* Decodes a TGA or PPM. Returns null, or what is wrong. */
static const char *decode_own_pixels(image_kind kind, const uint8_t *bytes, size_t size,
                                     const own_headers *headers, bool bottom_first,
                                     image_values *result)
{
    const char *reason = NULL;
    result->values = malloc((size_t)4 * result->width * result->height);
    if (result->values == NULL)
        return IMPORT_NO_MEMORY;
    if (kind == IMAGE_TGA)
        reason = image_tga_pixels(bytes, size, &headers->tga, bottom_first, result->values);
    else
        image_ppm_pixels(bytes, &headers->ppm, bottom_first, result->values);
    if (reason != NULL) {
        free(result->values);
        result->values = NULL;
    }
    return reason;
}

/* Decodes an image to at most `most_bits` a channel. Returns null, or what is wrong. */
static const char *decode(const uint8_t *bytes, size_t size, uint32_t most_bits, bool bottom_first,
                          image_budget *budget, image_values *result)
{
    const source s = {bytes, size, 0, false};
    const image_kind kind = image_kind_of(bytes, size);
    const bool is_own = kind == IMAGE_TGA || kind == IMAGE_PPM;
    own_headers headers;
    memset(result, 0, sizeof *result);
    if (size == 0)
        return "the file is empty";
    if (kind == IMAGE_OTHER)
        return "it is not a " IMAGE_FORMATS_IN_WORDS;
    const char *reason = kind == IMAGE_PNG ? png_fault(bytes, size, most_bits, budget) : NULL;
    if (reason == NULL)
        reason = is_own ? read_own_header(kind, bytes, size, &headers, result)
                        : read_header(s, kind, result);
    if (reason != NULL)
        return reason;
    const uint32_t file_bits = result->bits;
    if (result->bits > most_bits)
        result->bits = most_bits;
    snprintf(result->format, sizeof result->format, "%s", image_kind_name(kind));
    result->orientation = image_exif_orientation(bytes, size);
    reason = size_fault(result->width, result->height, result->bits / 2, budget);
    if (reason == NULL && image_is_cut_short(kind, bytes, size, result->width, result->height))
        reason = cut_short;
    if (reason == NULL)
        reason = is_own ? decode_own_pixels(kind, bytes, size, &headers, bottom_first, result)
                        : decode_pixels(s, kind, file_bits, bottom_first, result);
    if (reason == NULL)
        budget->bytes_left -= (uint64_t)(result->bits / 2) * result->width * result->height;
    return reason;
}

bool image_decode(const uint8_t *bytes, size_t size, image_budget *budget, image *result,
                  const char **reason)
{
    image_values decoded;
    memset(result, 0, sizeof *result);
    *reason = decode(bytes, size, 8, true, budget, &decoded);
    if (*reason != NULL)
        return false;
    pack(decoded.values, (size_t)decoded.width * decoded.height);
    *result = (image){decoded.width, decoded.height, decoded.values, decoded.orientation};
    return true;
}

bool image_read_values(const char *path, image_budget *budget, image_values *result,
                       const char **reason)
{
    size_t size;
    uint8_t *bytes = files_read(path, &size, reason);
    memset(result, 0, sizeof *result);
    if (bytes == NULL)
        return false;
    *reason = decode(bytes, size, 16, false, budget, result);
    free(bytes);
    return *reason == NULL;
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
