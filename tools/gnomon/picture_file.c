/* Reads picture files in a confined process. */
#include "picture_file.h"

#include <stdlib.h>
#include <string.h>

#include "confined.h"
#include "report.h"

typedef struct request {
    const char *path;
    const import_limits *limits;
} request;

/* What precedes the values in the pipe. */
typedef struct header {
    uint32_t width, height, bits, channels, orientation;
} header;

static uint64_t size_of_values(const header *h)
{
    return (uint64_t)h->width * h->height * (h->bits / 2);
}

/* The child's work. Nothing is freed, since the process ends. */
static bool send_picture(int descriptor, const void *context)
{
    const request *r = context;
    image_budget budget = {r->limits->megapixels, (uint64_t)r->limits->output << 20};
    image_values v;
    const char *reason;
    if (!image_read_values(r->path, &budget, &v, &reason)) {
        report_fault(r->path, "cannot be read as a picture: %s", reason);
        return handover_send_text(descriptor, HANDOVER_FAULT, "");
    }
    const header h = {v.width, v.height, v.bits, v.channels, v.orientation};
    return handover_send_text(descriptor, HANDOVER_RESULT, v.format) &&
           handover_send_bytes(descriptor, &h, sizeof h) &&
           handover_send_bytes(descriptor, v.values, size_of_values(&h));
}

static bool end(handover *from, handover_state state)
{
    from->state = state;
    return false;
}

static bool receive_picture(handover *from, const char *text, void *result)
{
    image_values *v = result;
    header h;
    if (!handover_receive_bytes(from, &h, sizeof h))
        return false;
    if (h.width < 1 || h.width > GN_MAX_SIZE || h.height < 1 || h.height > GN_MAX_SIZE ||
        (h.bits != 8 && h.bits != 16) || h.channels < 1 || h.channels > 4 || h.orientation < 1 ||
        h.orientation > 8)
        return end(from, HANDOVER_WRONG);
    if (size_of_values(&h) > from->bytes_left)
        return end(from, HANDOVER_TOO_MUCH);
    *v = (image_values){h.width, h.height, h.bits, h.channels, "", NULL, h.orientation};
    strncpy(v->format, text, sizeof v->format - 1);
    v->values = malloc((size_t)size_of_values(&h));
    if (v->values == NULL)
        return end(from, HANDOVER_NO_MEMORY);
    return handover_receive_bytes(from, v->values, size_of_values(&h));
}

int picture_file_read(const char *path, const import_limits *limits, image_values *result)
{
    const request r = {path, limits};
    memset(result, 0, sizeof *result);
    int fault = confined_run(path, limits, send_picture, &r, receive_picture, result);
    if (fault != 0)
        picture_file_free(result);
    return fault;
}

void picture_file_free(image_values *picture)
{
    free(picture->values);
    memset(picture, 0, sizeof *picture);
}

uint32_t picture_file_value(const image_values *picture, size_t i, int c)
{
    const size_t at = 4 * i + (size_t)c;
    return picture->bits == 16 ? ((const uint16_t *)picture->values)[at]
                               : ((const uint8_t *)picture->values)[at] * 257u;
}
