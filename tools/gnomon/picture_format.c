/* Formats of pictures by name. */
#define _POSIX_C_SOURCE 200809L
#include "picture_format.h"

#include <string.h>
#include <strings.h>

#include "output.h"
#include "report.h"

static const struct {
    picture_format format;
    char name[4];
} formats[] = {
    {PICTURE_PNG, "png"}, {PICTURE_TGA, "tga"}, {PICTURE_PPM, "ppm"}, {PICTURE_RAW, "raw"}};

#define FORMAT_COUNT (sizeof formats / sizeof formats[0])

/* The name's last dot; null without a suffix. */
static const char *suffix_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    const char *name = slash != NULL ? slash + 1 : path;
    const char *dot = strrchr(name, '.');
    return dot != name ? dot : NULL;
}

bool picture_is_gif(const char *path)
{
    const char *suffix = suffix_of(path);
    return suffix != NULL && strcasecmp(suffix, ".gif") == 0;
}

bool picture_has_suffix(const char *path)
{
    return suffix_of(path) != NULL;
}

bool picture_format_by_name(const char *name, picture_format *result)
{
    for (size_t i = 0; i < FORMAT_COUNT; ++i) {
        if (strcasecmp(name, formats[i].name) == 0) {
            *result = formats[i].format;
            return true;
        }
    }
    return false;
}

bool picture_format_of(const char *path, picture_format *result)
{
    const char *suffix = suffix_of(path);
    *result = PICTURE_PNG;
    return suffix == NULL || picture_format_by_name(suffix + 1, result);
}

int picture_format_check(const char *path, unsigned int allowed)
{
    picture_format format;
    const char *fault = output_fault(path);
    if (fault == NULL && picture_is_gif(path))
        fault = "a GIF has at most 256 colours; write a PNG, also an animated one, and convert it: "
                "ffmpeg -i FILE.png FILE.gif";
    if (fault == NULL && (!picture_format_of(path, &format) || ((unsigned)format & allowed) == 0))
        fault = allowed == PICTURE_PNG ? "it is a PNG file, whose name must end in .png"
                : (allowed & PICTURE_RAW) != 0
                    ? "the name of a picture must end in " PICTURE_SUFFIXES_OR_RAW_IN_WORDS
                    : "the name of a picture must end in " PICTURE_SUFFIXES_IN_WORDS;
    return fault == NULL ? 0 : report_fault(path, "cannot be written: %s", fault);
}
