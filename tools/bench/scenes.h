/* The benchmark's scenes, 1024x1024, colour RGBA8, depth D24, test LESS, a
 * perspective of 90 degrees, near 0.5, far 200:
 *
 *   S1  fill: 64 full-screen quads back to front, the top 1.25 times further than the
 *       bottom, four colours interpolated
 *   S3  cube-sphere of 199,692 triangles, about 820 pixels across, lit per vertex,
 *       back faces culled
 *   S5  cube-sphere of 1,002,252 triangles, 564 pixels across, lit the same way
 *   S6  clear only */
#ifndef BENCH_SCENES_H
#define BENCH_SCENES_H

#include "scene.h"

#define BENCH_SCENE_COUNT 4

/* The name, "S1" and so on, of a scene by its position in the list above. */
const char *bench_scene_name(int index);

/* The caller frees it by scene_free. */
scene *bench_scene(int index);

#endif
