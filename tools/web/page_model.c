/* The dropped model: its parts as the page's JavaScript fills them in, and their checks. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bounds.h"
#include "page_parts.h"
#include "page_text.h"

#define MAX_PARTS 4096
#define MAX_VERTICES (1u << 25)
#define MAX_INDICES (3u << 25)
#define MAX_MAP_SIZE 8192

static page_contents dropped;
static uint32_t begun; /* parts so far */
static bool is_complete;
static uint32_t version;

static text words; /* for messages with numbers */

static const char *number(uint64_t n)
{
    text_clear(&words);
    text_add_whole(&words, n);
    return text_of(&words);
}

static int fail_for_memory(void)
{
    return page_fail("there is not enough memory for the model", (const char *)NULL);
}

/* Gives the model up. */
static int abandon(int status)
{
    page_contents_free(&dropped);
    begun = 0;
    return status;
}

int page_model_begin(uint32_t parts)
{
    page_begin();
    abandon(0);
    is_complete = false;
    ++version;
    if (parts == 0 || parts > MAX_PARTS)
        return page_fail("a model has 1 to 4096 parts, not ", number(parts), (const char *)NULL);
    if (!page_contents_allocate(&dropped, parts)) {
        fail_for_memory();
        return abandon(1);
    }
    return 0;
}

static model_part *current(void)
{
    return begun > 0 && !is_complete ? dropped.model.parts + begun - 1 : NULL;
}

static int fail_without_part(void)
{
    return page_fail("no part of a model has been begun", (const char *)NULL);
}

int page_model_part(uint32_t vertices, uint32_t indices, int has_texcoords)
{
    static const float grey[4] = {0.8f, 0.8f, 0.8f, 1.0f};
    page_begin();
    if (is_complete || begun == dropped.model.part_count)
        return page_fail("the model has more parts than were announced", (const char *)NULL);
    if (vertices > MAX_VERTICES)
        return page_fail("a part has at most 33554432 vertices, not ", number(vertices),
                         (const char *)NULL);
    if (indices > MAX_INDICES || indices % 3 != 0)
        return page_fail("a part has at most 100663296 indices, three for each triangle, not ",
                         number(indices), (const char *)NULL);
    model_part *const part = dropped.model.parts + begun;
    part->has_texcoords = part->has_tangents = has_texcoords != 0;
    if (!model_part_allocate(part, vertices, indices)) {
        fail_for_memory();
        return abandon(1);
    }
    part->surface.shine = (model_shine){{0.0f, 0.0f, 0.0f}, 1};
    dropped.maps[begun].normals_in_tangent_space = true;
    ++begun;
    return page_model_color(grey[0], grey[1], grey[2], grey[3]);
}

float *page_model_positions(void)
{
    return current() != NULL ? current()->positions : NULL;
}

float *page_model_normals(void)
{
    return current() != NULL ? current()->normals : NULL;
}

float *page_model_texcoords(void)
{
    return current() != NULL ? current()->texcoords : NULL;
}

uint32_t *page_model_indices(void)
{
    return current() != NULL ? current()->indices : NULL;
}

int page_model_color(float red, float green, float blue, float alpha)
{
    const float color[4] = {red, green, blue, alpha};
    model_part *const part = current();
    page_begin();
    if (part == NULL)
        return fail_without_part();
    for (int c = 0; c < 4; ++c)
        if (!(color[c] >= 0.0f && color[c] <= 1.0f))
            return page_fail("a colour's channel is not from 0 to 1", (const char *)NULL);
    for (size_t v = 0; v < part->vertex_count; ++v)
        memcpy(part->colors + 4 * v, color, sizeof color);
    return 0;
}

int page_model_shine(float red, float green, float blue, uint32_t exponent)
{
    const float color[3] = {red, green, blue};
    model_part *const part = current();
    page_begin();
    if (part == NULL)
        return fail_without_part();
    for (int c = 0; c < 3; ++c)
        if (!(color[c] >= 0.0f && color[c] <= 1.0f))
            return page_fail("a highlight's channel is not from 0 to 1", (const char *)NULL);
    if (exponent < 1 || exponent > MODEL_MAX_EXPONENT)
        return page_fail("a highlight's exponent is from 1 to 1024, not ", number(exponent),
                         (const char *)NULL);
    memcpy(part->surface.shine.specular, color, sizeof color);
    part->surface.shine.exponent = exponent;
    return 0;
}

uint32_t *page_model_map(uint32_t kind, uint32_t width, uint32_t height)
{
    model_part *const part = current();
    page_begin();
    if (part == NULL)
        fail_without_part();
    else if (kind >= MAP_COUNT)
        page_fail("there is no kind of map with the number ", number(kind), (const char *)NULL);
    else if (!part->has_texcoords)
        page_fail("the part has no texture coordinates, so no map fits it", (const char *)NULL);
    else if (width == 0 || height == 0 || width > MAX_MAP_SIZE || height > MAX_MAP_SIZE)
        page_fail("a map is 1x1 to 8192x8192 texels large", (const char *)NULL);
    if (*page_message() != '\0')
        return NULL;
    image *const map = dropped.maps[begun - 1].images + kind;
    free(map->texels);
    map->width = width;
    map->height = height;
    map->texels = calloc((size_t)width * height, sizeof *map->texels);
    if (map->texels == NULL)
        fail_for_memory();
    return map->texels;
}

static int fail_at(uint32_t part, const char *what, uint64_t element, const char *why)
{
    text line = {0};
    text_add(&line, "part ");
    text_add_whole(&line, (uint64_t)part + 1);
    text_add(&line, ": ");
    text_add(&line, what);
    text_add(&line, " ");
    text_add_whole(&line, element);
    text_add(&line, " ");
    const int status = page_fail(text_of(&line), why, (const char *)NULL);
    free(line.chars);
    return status;
}

static int check_floats(uint32_t part, const char *what, const float *values, uint32_t vertices,
                        uint32_t components)
{
    for (size_t i = 0; i < (size_t)vertices * components; ++i)
        if (!isfinite(values[i]))
            return fail_at(part, what, i / components, "is not finite");
    return 0;
}

static int check_part(uint32_t p)
{
    const model_part *const part = dropped.model.parts + p;
    const uint32_t vertices = part->vertex_count;
    int fault = check_floats(p, "the position of vertex", part->positions, vertices, 3);
    if (fault == 0)
        fault = check_floats(p, "the normal of vertex", part->normals, vertices, 3);
    if (fault == 0 && part->has_texcoords)
        fault = check_floats(p, "the texture coordinate of vertex", part->texcoords, vertices, 2);
    for (uint32_t i = 0; i < part->index_count && fault == 0; ++i)
        if (part->indices[i] >= vertices)
            fault = fail_at(p, "index", i, "names a vertex that the part does not have");
    return fault;
}

/* From the order of JavaScript's bytes and rows to that of the library's texels. */
static void turn_map(image *map)
{
    for (uint32_t y = 0; y < map->height / 2; ++y) {
        uint32_t *const upper = map->texels + (size_t)y * map->width;
        uint32_t *const lower = map->texels + (size_t)(map->height - 1 - y) * map->width;
        for (uint32_t x = 0; x < map->width; ++x) {
            const uint32_t texel = upper[x];
            upper[x] = lower[x];
            lower[x] = texel;
        }
    }
    for (size_t i = 0; i < (size_t)map->width * map->height; ++i) {
        uint8_t bytes[4];
        memcpy(bytes, map->texels + i, sizeof bytes);
        map->texels[i] = (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 |
                         (uint32_t)bytes[3] << 24;
    }
}

static int complete(void)
{
    if (begun == 0 || begun < dropped.model.part_count)
        return page_fail("the model has fewer parts than were announced", (const char *)NULL);
    for (uint32_t p = 0; p < begun; ++p)
        if (check_part(p) != 0)
            return 1;
    if (model_triangle_count(&dropped.model) == 0)
        return page_fail("the model has no triangles", (const char *)NULL);
    bool good = model_complete_normals(&dropped.model);
    for (uint32_t p = 0; p < begun && good; ++p) {
        good = model_complete_tangents(dropped.model.parts + p);
        for (int k = 0; k < MAP_COUNT; ++k)
            if (dropped.maps[p].images[k].texels != NULL)
                turn_map(dropped.maps[p].images + k);
    }
    if (!good)
        return fail_for_memory();
    dropped.bounds = model_bounds(&dropped.model);
    return 0;
}

int page_model_end(void)
{
    page_begin();
    if (is_complete)
        return page_fail("no model has been begun", (const char *)NULL);
    if (complete() != 0)
        return abandon(1);
    is_complete = true;
    return 0;
}

const page_contents *page_dropped(void)
{
    if (is_complete)
        return &dropped;
    page_fail("no model has been dropped on this page", (const char *)NULL);
    return NULL;
}

uint32_t page_dropped_version(void)
{
    return version;
}
