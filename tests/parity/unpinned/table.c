/* The distances of groups of classes as a table. */
#include "table.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

typedef enum group {
    OTHERS, /* classes that no other group has */
    SHAPES,
    CLIPPED,
    LAYERS,
    POINTS_AND_LINES,
    INTERPOLATION,
    COLORS,
    FLOATS,
    LIT,
    TEXTURES,
    LEVELS,
    SAMPLES,
    MIXED,
    GROUP_COUNT
} group;

static const char *const group_names[GROUP_COUNT] = {
    "other classes",
    "triangles of all shapes and sizes",
    "clipped triangles",
    "overlapping triangles, depth, stencil",
    "points and lines",
    "interpolation, inputs of shaders",
    "colours of integers: formats, blending",
    "colours of floats: formats, blending",
    "lit, at vertices and at pixels",
    "textures of one level",
    "textures: levels, volumes, cubes, shadows",
    "four samples a pixel",
    "all of these mixed",
};

static group group_of(scene_class c)
{
    switch (c) {
    case CLASS_TINY:
    case CLASS_SLIVERS:
    case CLASS_TIES:
    case CLASS_HUGE:
    case CLASS_DEGENERATE:
    case CLASS_MESHES:
    case CLASS_STRIPS:
    case CLASS_FRAMEBUFFERS:
    case CLASS_CULLING:
    case CLASS_SEGMENTS:
    case CLASS_INDEXED:
    case CLASS_INSTANCES:
    case CLASS_SCISSOR:
    case CLASS_BATCHES:
    case CLASS_BATCH_ENDS:
        return SHAPES;
    case CLASS_OFFSCREEN:
    case CLASS_BEHIND:
    case CLASS_NEAR_CROSSING:
    case CLASS_CLIP_DEPTH:
    case CLASS_CLIP_DISTANCE:
        return CLIPPED;
    case CLASS_PILES:
    case CLASS_FILLS:
    case CLASS_DEPTH_STATE:
    case CLASS_STENCIL:
    case CLASS_COUNTING:
    case CLASS_OFFSET:
        return LAYERS;
    case CLASS_POINTS:
    case CLASS_LINES:
    case CLASS_POINT_COORDINATES:
    case CLASS_OUTLINES:
        return POINTS_AND_LINES;
    case CLASS_INTERPOLATION:
    case CLASS_INPUTS:
    case CLASS_DERIVATIVES:
        return INTERPOLATION;
    case CLASS_COLOR_RANGE:
    case CLASS_COLOR_MASK:
    case CLASS_BLEND:
    case CLASS_LOGIC:
        return COLORS;
    case CLASS_FLOAT_COLOR:
    case CLASS_FLOAT_BLEND:
        return FLOATS;
    case CLASS_LIT:
    case CLASS_PHONG:
    case CLASS_SHADERS:
    case CLASS_SHADOWED:
    case CLASS_MATERIALS:
        return LIT;
    case CLASS_TEXTURED:
    case CLASS_TEXTURES:
        return TEXTURES;
    case CLASS_MIPMAPS:
    case CLASS_VOLUMES:
    case CLASS_CUBES:
    case CLASS_SHADOWS:
        return LEVELS;
    case CLASS_SAMPLES:
    case CLASS_SAMPLE_SHADING:
    case CLASS_MASKS:
        return SAMPLES;
    case CLASS_FORMATS:
    case CLASS_ATTACHMENTS:
    case CLASS_MIXED:
    case CLASS_SEQUENCES:
        return MIXED;
    default:
        return OTHERS;
    }
}

static void print_share(uint64_t part, uint64_t of)
{
    if (part == 0)
        printf(" 0 |");
    else
        printf(" %.2g %% |", 100.0 * (double)part / (double)of);
}

/* Whole numbers without an exponent, other sizes with two digits. */
static void print_size(double size)
{
    printf(size >= 10.0 ? " %.0f" : " %.2g", size);
}

/* The largest size and the mean. */
static void print_sizes(const distance_sizes *sizes)
{
    if (sizes->pixels == 0) {
        printf(" 0 |");
        return;
    }
    print_size(sizes->largest);
    printf(",");
    print_size(sizes->sum / (double)sizes->pixels);
    printf(" |");
}

static void print_row(const char *name, const distance *d)
{
    printf("| %s | %" PRIu64 " | %" PRIu64 " |", name, d->scenes, d->covered);
    print_share(d->color, d->covered);
    print_share(d->visible, d->covered);
    print_sizes(&d->steps);
    print_sizes(&d->relative);
    print_share(d->coverage, d->covered);
    print_share(d->depth, d->covered);
    print_sizes(&d->depth_steps);
    printf("\n");
}

static void print_head(const char *rows)
{
    printf(
        "\n| %s | scenes | covered pixels | other colour | by more than 1/255 | largest, mean in "
        "1/255 | floats: largest, mean, relative | other coverage | other depth or stencil | "
        "largest, mean in steps of 24 bits |\n"
        "|---|---|---|---|---|---|---|---|---|---|\n",
        rows);
}

void table_print(const distance of_class[CLASS_COUNT], bool by_class, const distance *all)
{
    distance of_group[GROUP_COUNT];

    memset(of_group, 0, sizeof of_group);
    if (by_class)
        print_head("class");
    for (int c = 0; c < CLASS_COUNT; ++c) {
        if (by_class && of_class[c].scenes > 0)
            print_row(scene_class_name((scene_class)c), &of_class[c]);
        distance_add(&of_group[group_of((scene_class)c)], &of_class[c]);
    }
    print_head("classes");
    for (int i = 1; i <= GROUP_COUNT; ++i)
        if (of_group[i % GROUP_COUNT].scenes > 0)
            print_row(group_names[i % GROUP_COUNT], &of_group[i % GROUP_COUNT]);
    print_row("all", all);
    printf("\n");
}
