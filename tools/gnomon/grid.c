/* Lines of a grid. */
#include "grid.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bounds.h"
#include "scene_memory.h"

/* How far the grid reaches from the middle, in radii of the model. */
#define REACH 3.0

/* The colour, and its opacity in the middle. It is seen on light and on dark backgrounds. */
#define GREY 0.5f
#define OPACITY 0.6f

/* The greatest of 1, 2 and 5 times powers of ten that is not above a value. */
static double round_down(double value)
{
    const double power = pow(10.0, floor(log10(value)));
    return value >= 10.0 * power  ? 10.0 * power
           : value >= 5.0 * power ? 5.0 * power
           : value >= 2.0 * power ? 2.0 * power
                                  : power;
}

grid grid_of(const model *m, const bounding_sphere *bounds, const options *o)
{
    const gn_vec3 v = o->camera.up;
    const float up[3] = {v.x, v.y, v.z};
    double low[3], high[3];
    int axis = 1;
    for (int c = 0; c < 3; ++c)
        axis = fabsf(up[c]) > fabsf(up[axis]) ? c : axis;
    model_box(m, low, high);
    const bool is_up = up[axis] >= 0.0f;
    return (grid){axis, is_up ? 1.0 : -1.0, is_up ? low[axis] : high[axis],
                  round_down(bounds->radius / 4.0)};
}

/* A grid that is made: square cells, whose corners are the vertices. */
typedef struct cells {
    uint32_t side; /* vertices on a side */
    float *positions, *colors;
    uint32_t *indices;
    uint32_t index_count;
} cells;

/* Begins at the first line within reach below the middle, in cells from the world's origin. */
static double first_line(const grid *g, const bounding_sphere *bounds, int axis)
{
    const double middle = bounds->center[axis] + bounds->origin[axis];
    return ceil((middle - REACH * bounds->radius) / g->spacing);
}

static float opacity_at(const bounding_sphere *bounds, const double place[3], int axis)
{
    double square = 0.0;
    for (int c = 0; c < 3; ++c)
        if (c != axis)
            square += (place[c] - bounds->center[c]) * (place[c] - bounds->center[c]);
    const double left = 1.0 - sqrt(square) / (REACH * bounds->radius);
    return left > 0.0 ? (float)(left * left * (3.0 - 2.0 * left)) * OPACITY : 0.0f;
}

static void write_vertices(const grid *g, const bounding_sphere *bounds, cells *c)
{
    const int across[2] = {(g->axis + 1) % 3, (g->axis + 2) % 3};
    const double first[2] = {first_line(g, bounds, across[0]), first_line(g, bounds, across[1])};
    for (uint32_t v = 0; v < c->side * c->side; ++v) {
        const uint32_t number[2] = {v % c->side, v / c->side};
        double place[3];
        place[g->axis] = g->level;
        for (int k = 0; k < 2; ++k)
            place[across[k]] = (first[k] + number[k]) * g->spacing - bounds->origin[across[k]];
        for (int k = 0; k < 3; ++k) {
            c->positions[3 * v + (uint32_t)k] = (float)place[k];
            c->colors[4 * v + (uint32_t)k] = GREY;
        }
        c->colors[4 * v + 3] = opacity_at(bounds, place, g->axis);
    }
}

static void add_line(cells *c, uint32_t a, uint32_t b)
{
    if (c->colors[4 * a + 3] == 0.0f && c->colors[4 * b + 3] == 0.0f)
        return;
    c->indices[c->index_count++] = a;
    c->indices[c->index_count++] = b;
}

static void write_lines(cells *c)
{
    for (uint32_t i = 0; i < c->side; ++i)
        for (uint32_t k = 0; k + 1 < c->side; ++k) {
            add_line(c, i * c->side + k, i * c->side + k + 1);
            add_line(c, k * c->side + i, (k + 1) * c->side + i);
        }
}

void grid_add(scene *s, const look *l, const grid *g, const bounding_sphere *bounds)
{
    static const part_maps no_maps;
    const uint32_t side = (uint32_t)floor(2.0 * REACH * bounds->radius / g->spacing) + 1;
    const size_t vertices = (size_t)side * side;
    cells c = {side, scene_allocate(3 * vertices, sizeof *c.positions),
               scene_allocate(4 * vertices, sizeof *c.colors),
               scene_allocate(4 * vertices, sizeof *c.indices), 0};
    float *const normals = scene_allocate(3 * vertices, sizeof *normals);
    model_part part;
    look own = *l;
    options plain = *l->options;
    write_vertices(g, bounds, &c);
    write_lines(&c);
    memset(&part, 0, sizeof part);
    part.kind = MODEL_LINES;
    part.vertex_count = (uint32_t)vertices;
    part.positions = c.positions;
    part.normals = normals;
    part.colors = c.colors;
    part.indices = c.indices;
    part.index_count = c.index_count;
    part.surface = model_surface_default();
    part.surface.alpha = MODEL_BLEND;
    for (int i = 0; i < MAP_COUNT; ++i)
        part.maps[i] = model_map_of(MODEL_NO_IMAGE);
    gn_transform_identity(&part.world_from_model);
    plain.opaque = plain.shading_given = plain.points = plain.wireframe = false;
    plain.point_size = 0.0f;
    own.options = &plain;
    own.shading = SHADING_UNLIT;
    own.shadow = NULL;
    scene_draw *const draw = look_add_part(s, &own, &part, &no_maps);
    draw->state.depth.test_enabled = false;
    draw->state.depth.clamp_enabled = true;
    free(c.positions);
    free(c.colors);
    free(c.indices);
    free(normals);
}

bool grid_is_seen_from_above(const grid *g, const bounding_sphere *bounds, const look *l,
                             const gn_transform *turn)
{
    double place[3] = {bounds->center[0], bounds->center[1], bounds->center[2]};
    double up[3] = {0.0, 0.0, 0.0};
    place[g->axis] = g->level;
    up[g->axis] = g->up;
    const gn_vec3 on = gn_mat4_transform_point(
        &turn->matrix, (gn_vec3){(float)place[0], (float)place[1], (float)place[2]});
    const gn_vec3 normal = gn_mat4_transform_direction(
        &turn->matrix, (gn_vec3){(float)up[0], (float)up[1], (float)up[2]});
    const gn_vec3 from = l->options->camera.orthographic ? l->view.target : on;
    return gn_vec3_dot(gn_vec3_subtract(l->view.eye, from), normal) >= 0.0f;
}
