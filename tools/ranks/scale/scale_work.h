/* The work of a scene: how many vertices, triangles, rows and fragments fall to each of 1, 2, 4 ...
 * 1,024 bands of the picture and parts of the triangles. */
#ifndef SCALE_WORK_H
#define SCALE_WORK_H

#include <stdbool.h>
#include <stdint.h>

#define WORK_LEVELS 11 /* 2^0 to 2^10 divisions */
#define WORK_MOST (1u << (WORK_LEVELS - 1))
#define WORK_TURNS 16 /* pictures of a turn that are counted */

/* The three scenes. All are the teapot as `gnomon render` and `gnomon spin` draw it from a file. */
typedef struct work_scene {
    const char *name;
    uint32_t side;   /* pixels */
    uint32_t level;  /* of teapot_create: 64 level^2 triangles */
    uint32_t frames; /* 1: one picture */
} work_scene;

#define WORK_SCENES 3
extern const work_scene work_scenes[WORK_SCENES];

/* What one band, part or picture holds. */
typedef struct work_share {
    double drawn;     /* triangles that can cover pixels */
    double rows;      /* rows of pixels of these triangles */
    double fragments; /* before the depth test */
    double covered;   /* pixels that show the model; not known of parts */
} work_share;

typedef struct work {
    work_scene scene;
    double vertices, triangles;
    double model_bytes; /* positions, normals, colours and indices */
    work_share whole;
    /* Band i of 2^level, from the bottom to the top, is at 2^level + i; parts likewise. */
    work_share band[2 * WORK_MOST], part[2 * WORK_MOST];
    work_share turn[WORK_TURNS]; /* of pictures of a turn, at equal angles */
} work;

/* Counts with the library's statistics, in a picture of at most 1,024 pixels a side, which stands
 * for larger ones: fragments grow with the pixels, rows with the rows. Returns false with a message
 * if memory is short. */
bool work_count(const work_scene *which, work *result);

/* A scene in which all bands, parts and pictures are equal, for checks against formulas. */
void work_level(const work *like, work *result);

#endif
