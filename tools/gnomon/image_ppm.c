/* Reads PPM files. */
#include "image_ppm.h"

#include <string.h>

static bool is_space(uint8_t c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

bool image_is_ppm(const uint8_t *bytes, size_t size)
{
    return size >= 3 && bytes[0] == 'P' && (bytes[1] == '5' || bytes[1] == '6') &&
           (is_space(bytes[2]) || bytes[2] == '#');
}

/* Reads a number after white space and comments. Returns false at anything else. */
static bool read_number(const uint8_t *bytes, size_t size, size_t *at, uint32_t *result)
{
    uint64_t value = 0;
    while (*at < size && (is_space(bytes[*at]) || bytes[*at] == '#')) {
        const bool comment = bytes[*at] == '#';
        while (comment && *at < size && bytes[*at] != '\n')
            ++*at;
        *at += *at < size;
    }
    const size_t first = *at;
    for (; *at < size && bytes[*at] >= '0' && bytes[*at] <= '9'; ++*at) {
        value = value * 10 + (uint64_t)(bytes[*at] - '0');
        if (value > UINT32_MAX)
            value = UINT32_MAX;
    }
    *result = (uint32_t)value;
    return *at > first;
}

const char *image_ppm_header(const uint8_t *bytes, size_t size, ppm_header *result)
{
    uint32_t largest = 0;
    size_t at = 2;
    memset(result, 0, sizeof *result);
    result->channels = bytes[1] == '6' ? 3 : 1;
    if (!read_number(bytes, size, &at, &result->width) ||
        !read_number(bytes, size, &at, &result->height) ||
        !read_number(bytes, size, &at, &largest) || (at < size && !is_space(bytes[at])))
        return at < size ? "the PPM is damaged" : "the file is cut short";
    if (largest != 255)
        return "the PPM's largest value is not 255";
    result->size = at + 1;
    return NULL;
}

void image_ppm_pixels(const uint8_t *bytes, const ppm_header *header, bool bottom_first,
                      uint8_t *result)
{
    const size_t width = header->width, channels = header->channels;
    for (uint32_t y = 0; y < header->height; ++y) {
        const uint8_t *from = bytes + header->size + channels * width * y;
        const uint32_t row = bottom_first ? header->height - 1 - y : y;
        uint8_t *to = result + 4 * width * row;
        for (size_t x = 0; x < width; ++x, from += channels, to += 4) {
            for (size_t c = 0; c < 3; ++c)
                to[c] = from[channels == 3 ? c : 0];
            to[3] = 255;
        }
    }
}
