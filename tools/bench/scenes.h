/* The benchmark's scenes: colour RGBA8, depth D24, test LESS, a perspective of 90 degrees,
 * near 0.5, far 200; every frame clears both. Lengths are pixels.
 *
 *   S1  fill: 64 full-screen quads back to front, the top 1.25 times further than the
 *       bottom, four colours interpolated: w is the same along every row, which is drawn
 *       faster. "S1 rolled" has a rolled camera, and w differs along its rows
 *   S2  the same with a repeating bilinear texture of 512x512, coordinates 0 to 4
 *       "S2 nearest" takes the nearest texel; "S2 levels" mixes two levels, and "S2 cube" those of
 *       a cube map, by a user's shader (reference/scene/sampled.h)
 *   S3  cube-sphere of 199,692 triangles, about 820 across, lit per vertex, back faces
 *       culled
 *   S4  cube-sphere of 10,092 triangles, 1000 across, textured, Phong's highlight at every
 *       pixel (reference/scene/phong.h), back faces culled
 *       (gnomon functions: phong_function_shader.h, the same by functions of one fragment);
 *       "S4 ready" is the same with the ready-made gn_use_phong
 *   S5  cube-sphere of 1,002,252 triangles, 564 across, as S3
 *   S6  clear only
 *
 * S1 to S6 are 1024x1024. The scale series vary one thing: "triangles/N" are spheres as S3
 * of N triangles, "fill/N" four quads as S1 and "sphere/N" the sphere of S3, both N pixels
 * a side. */
#ifndef BENCH_SCENES_H
#define BENCH_SCENES_H

#include "scene.h"

typedef enum bench_shape {
    BENCH_CLEAR,
    BENCH_QUADS,
    BENCH_ROLLED_QUADS,
    BENCH_TEXTURED_QUADS,
    BENCH_NEAREST_QUADS,
    BENCH_LEVEL_QUADS,
    BENCH_CUBE_QUADS,
    BENCH_SPHERE,
    BENCH_PHONG_SPHERE,
    BENCH_READY_PHONG_SPHERE
} bench_shape;

typedef struct bench_scene {
    char name[24];
    bench_shape shape;
    uint32_t side;   /* of the target */
    uint32_t detail; /* quads, at most 64; or squares along an edge of the sphere's cube */
    float across;    /* width of the sphere's outline, as a part of the side */
} bench_scene;

#define BENCH_SCENE_COUNT 11
#define BENCH_SCALE_COUNT 19

extern const bench_scene bench_scenes[BENCH_SCENE_COUNT];
extern const bench_scene bench_scale[BENCH_SCALE_COUNT];

/* The caller frees it with scene_free. */
scene *bench_build(const bench_scene *b);

#endif
