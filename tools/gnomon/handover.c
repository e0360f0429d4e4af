/* Sends and receives imported models. */
#define _POSIX_C_SOURCE 200809L
#include "handover.h"

#include <errno.h>
#include <math.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <gnomon/surface.h>

/* The header in front of a part's arrays. */
typedef struct part_header {
    uint32_t vertex_count;
    uint32_t index_count;
    uint32_t flags; /* PART_... */
    uint32_t kind;  /* model_kind */
    model_surface surface;
    model_map maps[MAP_COUNT];
    uint32_t widths[MAP_COUNT], heights[MAP_COUNT]; /* 0: no map */
} part_header;

enum {
    PART_HAS_VERTEX_COLORS = 1,
    PART_HAS_TEXCOORDS = 2,
    PART_HAS_TANGENTS = 4,
    PART_NORMALS_IN_TANGENT_SPACE = 8,
    PART_HAS_NORMALS = 16,
    PART_MAP_REPLACES_COLOR = 32
};

typedef struct array {
    void *data;
    uint64_t size;
} array;

#define ARRAY_COUNT 6

/* The arrays of a part in the order in which they are sent; missing arrays have size 0. */
static void list_arrays(const model_part *part, array list[ARRAY_COUNT])
{
    const uint64_t vertices = part->vertex_count;
    list[0] = (array){part->positions, vertices * 3 * sizeof(float)};
    list[1] = (array){part->normals, vertices * 3 * sizeof(float)};
    list[2] = (array){part->colors, vertices * 4 * sizeof(float)};
    list[3] = (array){part->texcoords, part->has_texcoords ? vertices * 2 * sizeof(float) : 0};
    list[4] = (array){part->tangents, part->has_tangents ? vertices * 4 * sizeof(float) : 0};
    list[5] = (array){part->indices, (uint64_t)part->index_count * sizeof(uint32_t)};
}

uint64_t handover_size(const model_part *part)
{
    array list[ARRAY_COUNT];
    uint64_t size = sizeof(part_header);
    list_arrays(part, list);
    for (int i = 0; i < ARRAY_COUNT; ++i)
        size += list[i].size;
    return size;
}

bool handover_send_bytes(int descriptor, const void *bytes, uint64_t size)
{
    const uint8_t *from = bytes;
    while (size > 0) {
        ssize_t count = write(descriptor, from, size > 1 << 30 ? 1 << 30 : (size_t)size);
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0)
            return false;
        from += count;
        size -= (uint64_t)count;
    }
    return true;
}

bool handover_send_text(int descriptor, handover_record kind, const char *text)
{
    size_t length = strlen(text);
    uint32_t header[2] = {(uint32_t)kind, 0};
    header[1] = (uint32_t)(length < HANDOVER_TEXT_SIZE ? length : HANDOVER_TEXT_SIZE - 1);
    return handover_send_bytes(descriptor, header, sizeof header) &&
           handover_send_bytes(descriptor, text, header[1]);
}

static bool send_part(int descriptor, const model_part *part, const part_maps *maps)
{
    part_header header;
    array list[ARRAY_COUNT];
    memset(&header, 0, sizeof header);
    header.vertex_count = part->vertex_count;
    header.index_count = part->index_count;
    header.flags = (part->has_vertex_colors ? PART_HAS_VERTEX_COLORS : 0u) |
                   (part->has_texcoords ? PART_HAS_TEXCOORDS : 0u) |
                   (part->has_tangents ? PART_HAS_TANGENTS : 0u) |
                   (part->has_normals ? PART_HAS_NORMALS : 0u) |
                   (maps->replaces_color ? PART_MAP_REPLACES_COLOR : 0u) |
                   (maps->normals_in_tangent_space ? PART_NORMALS_IN_TANGENT_SPACE : 0u);
    header.kind = (uint32_t)part->kind;
    header.surface = part->surface;
    memcpy(header.maps, part->maps, sizeof header.maps);
    for (int i = 0; i < MAP_COUNT; ++i) {
        header.widths[i] = maps->images[i].width;
        header.heights[i] = maps->images[i].height;
    }
    list_arrays(part, list);
    bool good = handover_send_bytes(descriptor, &header, sizeof header);
    for (int i = 0; i < ARRAY_COUNT; ++i)
        good = good && handover_send_bytes(descriptor, list[i].data, list[i].size);
    for (int i = 0; i < MAP_COUNT; ++i) {
        const image *map = maps->images + i;
        good = good &&
               handover_send_bytes(descriptor, map->texels, (uint64_t)4 * map->width * map->height);
    }
    return good;
}

bool handover_send_model(int descriptor, const imported *what)
{
    const char *told = what->told.text != NULL ? what->told.text : "";
    const uint32_t count = (uint32_t)what->model.part_count;
    const uint32_t counts[3] = {count, what->model.material_count, what->model.light_count};
    bool good = handover_send_text(descriptor, HANDOVER_RESULT, told) &&
                handover_send_bytes(descriptor, counts, sizeof counts) &&
                handover_send_bytes(descriptor, what->model.origin, sizeof what->model.origin) &&
                handover_send_bytes(descriptor, what->model.lights,
                                    what->model.light_count * sizeof *what->model.lights);
    for (uint32_t i = 0; i < count && good; ++i)
        good = send_part(descriptor, what->model.parts + i, what->maps + i);
    return good;
}

static bool end(handover *h, handover_state state)
{
    h->state = state;
    return false;
}

/* Milliseconds, rounded up, up to a minute. */
static int time_left(const handover *h)
{
    struct timespec present;
    clock_gettime(CLOCK_MONOTONIC, &present);
    double left = difftime(h->deadline.tv_sec, present.tv_sec) * 1e3 +
                  (double)(h->deadline.tv_nsec - present.tv_nsec) * 1e-6;
    return left <= 0.0 ? 0 : left >= 6e4 ? 60000 : (int)ceil(left);
}

bool handover_receive_bytes(handover *h, void *bytes, uint64_t size)
{
    uint8_t *to = bytes;
    if (size > h->bytes_left)
        return end(h, HANDOVER_TOO_MUCH);
    h->bytes_left -= size;
    while (size > 0) {
        struct pollfd waiting = {h->descriptor, POLLIN, 0};
        int left = time_left(h);
        if (left == 0)
            return end(h, HANDOVER_LATE);
        if (poll(&waiting, 1, left) <= 0)
            continue;
        ssize_t count = read(h->descriptor, to, size > 1 << 30 ? 1 << 30 : (size_t)size);
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            return end(h, HANDOVER_ENDED);
        to += count;
        size -= (uint64_t)count;
    }
    return true;
}

bool handover_receive(handover *h, handover_record *kind, char text[HANDOVER_TEXT_SIZE])
{
    uint32_t header[2];
    if (!handover_receive_bytes(h, header, sizeof header))
        return false;
    if (header[0] > HANDOVER_RESULT || header[1] >= HANDOVER_TEXT_SIZE)
        return end(h, HANDOVER_WRONG);
    *kind = (handover_record)header[0];
    if (!handover_receive_bytes(h, text, header[1]))
        return false;
    text[header[1]] = '\0';
    return true;
}

/* Properties that drawing assumes of a part. */
static bool is_sound(const part_header *header)
{
    for (int i = 0; i < MAP_COUNT; ++i)
        if (header->widths[i] > GN_MAX_SIZE || header->heights[i] > GN_MAX_SIZE ||
            (header->widths[i] == 0) != (header->heights[i] == 0))
            return false;
    return header->kind <= MODEL_POINTS &&
           header->index_count % model_corners((model_kind)header->kind) == 0 &&
           header->surface.shine.exponent >= 1 &&
           header->surface.shine.exponent <= MODEL_MAX_EXPONENT &&
           (unsigned)header->surface.alpha <= MODEL_BLEND && isfinite(header->surface.alpha_cutoff);
}

static bool receive_maps(handover *h, const part_header *header, part_maps *maps)
{
    maps->replaces_color = (header->flags & PART_MAP_REPLACES_COLOR) != 0;
    maps->normals_in_tangent_space = (header->flags & PART_NORMALS_IN_TANGENT_SPACE) != 0;
    for (int i = 0; i < MAP_COUNT; ++i) {
        image *map = maps->images + i;
        const uint64_t size = (uint64_t)4 * header->widths[i] * header->heights[i];
        if (size == 0)
            continue;
        if (size > h->bytes_left)
            return end(h, HANDOVER_TOO_MUCH);
        map->texels = malloc((size_t)size);
        if (map->texels == NULL)
            return end(h, HANDOVER_NO_MEMORY);
        map->width = header->widths[i];
        map->height = header->heights[i];
        if (!handover_receive_bytes(h, map->texels, size))
            return false;
    }
    return true;
}

static bool receive_part(handover *h, model_part *part, part_maps *maps)
{
    part_header header;
    array list[ARRAY_COUNT];
    if (!handover_receive_bytes(h, &header, sizeof header))
        return false;
    if (!is_sound(&header))
        return end(h, HANDOVER_WRONG);
    part->has_vertex_colors = (header.flags & PART_HAS_VERTEX_COLORS) != 0;
    part->has_texcoords = (header.flags & PART_HAS_TEXCOORDS) != 0;
    part->has_tangents = (header.flags & PART_HAS_TANGENTS) != 0;
    part->has_normals = (header.flags & PART_HAS_NORMALS) != 0;
    part->kind = (model_kind)header.kind;
    part->surface = header.surface;
    memcpy(part->maps, header.maps, sizeof part->maps);
    part->vertex_count = header.vertex_count;
    part->index_count = header.index_count;
    if (handover_size(part) - sizeof header > h->bytes_left)
        return end(h, HANDOVER_TOO_MUCH);
    if (!model_part_allocate(part, header.vertex_count, header.index_count))
        return end(h, HANDOVER_NO_MEMORY);
    list_arrays(part, list);
    for (int i = 0; i < ARRAY_COUNT; ++i)
        if (!handover_receive_bytes(h, list[i].data, list[i].size))
            return false;
    for (size_t i = 0; i < part->index_count; ++i)
        if (part->indices[i] >= part->vertex_count)
            return end(h, HANDOVER_WRONG);
    return receive_maps(h, &header, maps);
}

/* Properties that drawing assumes of a light. */
static bool is_sound_light(const model_light *l)
{
    bool is_finite = isfinite(l->range) && isfinite(l->inner) && isfinite(l->outer);
    for (int c = 0; c < 3; ++c)
        is_finite = is_finite && isfinite(l->color[c]) && isfinite(l->position[c]) &&
                    isfinite(l->direction[c]);
    return is_finite && (unsigned)l->kind <= GN_LIGHT_SPOT && l->range >= 0.0f;
}

static bool receive_lights(handover *h, uint32_t count, model *m)
{
    if (count > h->bytes_left / sizeof *m->lights)
        return end(h, HANDOVER_TOO_MUCH);
    m->lights = calloc((size_t)count + 1, sizeof *m->lights);
    if (m->lights == NULL)
        return end(h, HANDOVER_NO_MEMORY);
    m->light_count = count;
    if (!handover_receive_bytes(h, m->lights, count * sizeof *m->lights))
        return false;
    for (uint32_t i = 0; i < count; ++i)
        if (!is_sound_light(m->lights + i))
            return end(h, HANDOVER_WRONG);
    return true;
}

bool handover_receive_model(handover *h, imported *result)
{
    uint32_t counts[3];
    if (!handover_receive_bytes(h, counts, sizeof counts) ||
        !handover_receive_bytes(h, result->model.origin, sizeof result->model.origin))
        return false;
    for (int c = 0; c < 3; ++c)
        if (!isfinite(result->model.origin[c]))
            return end(h, HANDOVER_WRONG);
    if (!receive_lights(h, counts[2], &result->model))
        return false;
    const uint32_t count = counts[0];
    result->model.material_count = counts[1];
    if (count == 0)
        return end(h, HANDOVER_WRONG);
    if (count > h->bytes_left / sizeof(part_header))
        return end(h, HANDOVER_TOO_MUCH);
    result->model.parts = calloc(count, sizeof *result->model.parts);
    result->maps = calloc(count, sizeof *result->maps);
    if (result->model.parts == NULL || result->maps == NULL)
        return end(h, HANDOVER_NO_MEMORY);
    result->model.part_count = count;
    for (uint32_t i = 0; i < count; ++i)
        if (!receive_part(h, result->model.parts + i, result->maps + i))
            return false;
    return true;
}
