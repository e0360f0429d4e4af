/* The built-in models: teapot, triangle, square and cube, with their maps. */
#include <stdlib.h>
#include <string.h>

#include "bounds.h"
#include "page_parts.h"
#include "teapot_scene.h"

#define TEAPOT_LEVEL 16

/* Texels of the square's and the cube's maps, and how often the square repeats them. */
#define MAP_SIZE 128
#define SQUARE_REPEATS 3.0f

/* Of the cube's tiles, in texels: their size, and the width of their slanted border. */
#define TILE 32
#define SLANT 4

static const model_shine shine = {{0.45f, 0.45f, 0.45f}, 40};

void page_contents_free(page_contents *c)
{
    for (size_t p = 0; c->maps != NULL && p < c->model.part_count; ++p)
        for (int k = 0; k < MAP_COUNT; ++k)
            free(c->maps[p].images[k].texels);
    free(c->maps);
    model_free(&c->model);
    model_free(&c->ground);
    memset(c, 0, sizeof *c);
}

bool page_contents_allocate(page_contents *c, uint32_t parts)
{
    memset(c, 0, sizeof *c);
    c->model.parts = calloc(parts, sizeof *c->model.parts);
    c->maps = calloc(parts, sizeof *c->maps);
    if (c->model.parts != NULL)
        c->model.part_count = parts;
    return c->model.parts != NULL && c->maps != NULL;
}

static bool create_teapot(page_contents *c)
{
    const unsigned int all = (1u << OPTIONS_MAP_COUNT) - 1;
    c->maps = calloc(1, sizeof *c->maps);
    c->bounds = teapot_sphere();
    return c->maps != NULL && teapot_create_glazed(TEAPOT_LEVEL, &c->model) &&
           teapot_create_ground(&c->ground) && teapot_create_maps(all, true, c->maps);
}

/* A vertex of a small model. */
typedef struct vertex {
    float position[3], normal[3], color[3], texcoord[2];
} vertex;

/* Fills a part in, which has one diffuse colour for each vertex. */
static bool fill(page_contents *c, bool has_texcoords, const vertex *vertices, uint32_t count,
                 const uint32_t *indices, uint32_t index_count)
{
    if (!page_contents_allocate(c, 1))
        return false;
    model_part *const part = c->model.parts;
    part->has_texcoords = part->has_tangents = has_texcoords;
    if (!model_part_allocate(part, count, index_count))
        return false;
    for (size_t v = 0; v < count; ++v) {
        memcpy(part->positions + 3 * v, vertices[v].position, sizeof vertices[v].position);
        memcpy(part->normals + 3 * v, vertices[v].normal, sizeof vertices[v].normal);
        memcpy(part->colors + 4 * v, vertices[v].color, sizeof vertices[v].color);
        part->colors[4 * v + 3] = 1.0f;
        if (has_texcoords)
            memcpy(part->texcoords + 2 * v, vertices[v].texcoord, sizeof vertices[v].texcoord);
    }
    memcpy(part->indices, indices, index_count * sizeof *indices);
    part->surface.shine = shine;
    c->maps->replaces_color = true;
    c->bounds = model_bounds(&c->model);
    return model_complete_tangents(part);
}

static bool create_triangle(page_contents *c)
{
    static const vertex vertices[3] = {
        {{-1.0f, -0.75f, 0.0f}, {0.0f, 0.0f, 1.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f}},
        {{1.0f, -0.75f, 0.0f}, {0.0f, 0.0f, 1.0f}, {0.0f, 1.0f, 0.0f}, {1.0f, 0.0f}},
        {{0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 1.0f}, {0.5f, 1.0f}},
    };
    static const uint32_t indices[3] = {0, 1, 2};
    return fill(c, false, vertices, 3, indices, 3);
}

/* Texel x, y of a map, whose lowest row is row 0. */
typedef uint32_t texel(uint32_t x, uint32_t y);

static uint32_t rgb(uint32_t red, uint32_t green, uint32_t blue)
{
    return red | green << 8 | blue << 16 | UINT32_C(0xff000000);
}

static bool create_map(page_contents *c, map_kind kind, texel *make)
{
    image *const map = c->maps->images + kind;
    map->width = map->height = MAP_SIZE;
    map->texels = malloc((size_t)MAP_SIZE * MAP_SIZE * sizeof *map->texels);
    if (map->texels == NULL)
        return false;
    for (uint32_t y = 0; y < MAP_SIZE; ++y)
        for (uint32_t x = 0; x < MAP_SIZE; ++x)
            map->texels[y * MAP_SIZE + x] = make(x, y);
    return true;
}

/* Small chequers within large ones, so that filters differ at every distance. */
static uint32_t chequered(uint32_t x, uint32_t y)
{
    const bool large = ((x / 32 + y / 32) & 1) != 0, small = ((x / 4 + y / 4) & 1) != 0;
    if (large)
        return small ? rgb(238, 222, 194) : rgb(226, 206, 172);
    return small ? rgb(38, 92, 112) : rgb(176, 70, 44);
}

/* A floor, which is seen at a small angle. */
static bool create_square(page_contents *c)
{
    static const float r = SQUARE_REPEATS;
    const vertex vertices[4] = {
        {{-1.0f, 0.0f, 1.0f}, {0.0f, 1.0f, 0.0f}, {0.9f, 0.3f, 0.2f}, {0.0f, 0.0f}},
        {{1.0f, 0.0f, 1.0f}, {0.0f, 1.0f, 0.0f}, {0.2f, 0.8f, 0.3f}, {r, 0.0f}},
        {{1.0f, 0.0f, -1.0f}, {0.0f, 1.0f, 0.0f}, {0.2f, 0.4f, 0.9f}, {r, r}},
        {{-1.0f, 0.0f, -1.0f}, {0.0f, 1.0f, 0.0f}, {0.9f, 0.8f, 0.2f}, {0.0f, r}},
    };
    static const uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
    return fill(c, true, vertices, 4, indices, 6) && create_map(c, MAP_DIFFUSE, chequered);
}

/* Whether a texel of the cube's maps is on the slanted border of a tile, and where to it falls. */
static bool is_slanted(uint32_t x, uint32_t y, int *right, int *up)
{
    const uint32_t u = x % TILE, v = y % TILE;
    const uint32_t from_side = u < TILE / 2 ? u : TILE - 1 - u;
    const uint32_t from_end = v < TILE / 2 ? v : TILE - 1 - v;
    *right = *up = 0;
    if (from_side < from_end)
        *right = u < TILE / 2 ? -1 : 1;
    else
        *up = v < TILE / 2 ? -1 : 1;
    return from_side < SLANT || from_end < SLANT;
}

static uint32_t tiled(uint32_t x, uint32_t y)
{
    return ((x / TILE + y / TILE) & 1) != 0 ? rgb(214, 172, 96) : rgb(70, 120, 150);
}

/* Flat tiles, with borders of the normals (0.6, 0, 0.8), and so on. */
static uint32_t slanted(uint32_t x, uint32_t y)
{
    int right, up;
    if (!is_slanted(x, y, &right, &up))
        return rgb(128, 128, 255);
    return rgb((uint32_t)(128 + right * 76), (uint32_t)(128 + up * 76), 230);
}

static uint32_t polished(uint32_t x, uint32_t y)
{
    return ((x / TILE + y / TILE) & 1) != 0 ? rgb(255, 255, 255) : rgb(60, 60, 60);
}

static bool create_cube(page_contents *c)
{
    /* A face's normal, and the directions of s and t: normal = s x t. */
    static const float faces[6][3][3] = {
        {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
        {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}}, {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
        {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
    };
    static const float colors[6][3] = {{0.85f, 0.3f, 0.25f}, {0.2f, 0.6f, 0.65f},
                                       {0.9f, 0.85f, 0.7f},  {0.35f, 0.3f, 0.4f},
                                       {0.9f, 0.65f, 0.2f},  {0.3f, 0.45f, 0.8f}};
    vertex vertices[24];
    uint32_t indices[36];
    for (uint32_t f = 0; f < 6; ++f) {
        for (uint32_t k = 0; k < 4; ++k) {
            vertex *const v = vertices + 4 * f + k;
            const float s = k == 1 || k == 2 ? 1.0f : 0.0f, t = k >= 2 ? 1.0f : 0.0f;
            for (int i = 0; i < 3; ++i)
                v->position[i] = faces[f][0][i] + (2.0f * s - 1.0f) * faces[f][1][i] +
                                 (2.0f * t - 1.0f) * faces[f][2][i];
            memcpy(v->normal, faces[f][0], sizeof v->normal);
            memcpy(v->color, colors[f], sizeof v->color);
            v->texcoord[0] = s;
            v->texcoord[1] = t;
        }
        const uint32_t d = 4 * f, corners[6] = {d, d + 1, d + 2, d, d + 2, d + 3};
        memcpy(indices + (size_t)6 * f, corners, sizeof corners);
    }
    if (!fill(c, true, vertices, 24, indices, 36))
        return false;
    c->maps->normals_in_tangent_space = true;
    return create_map(c, MAP_DIFFUSE, tiled) && create_map(c, MAP_NORMAL, slanted) &&
           create_map(c, MAP_SPECULAR, polished);
}

int page_shape_create(page_model_name name, page_contents *result)
{
    bool made = false;
    memset(result, 0, sizeof *result);
    switch (name) {
    case PAGE_TEAPOT:
        made = create_teapot(result);
        break;
    case PAGE_TRIANGLE:
        made = create_triangle(result);
        break;
    case PAGE_SQUARE:
        made = create_square(result);
        break;
    default:
        made = create_cube(result);
        break;
    }
    if (made)
        return 0;
    page_contents_free(result);
    return page_fail("there is not enough memory for the model", (const char *)NULL);
}
