/* A user's shader that shows what a fragment is told and uses what it may say: facing,
 * primitive, window position, point coordinates, sample mask; discard, depth, sample mask. Its twin
 * in GLSL is in reference/osmesa/programs.c. */
#ifndef SCENE_INPUTS_H
#define SCENE_INPUTS_H

#include <gnomon.h>

/* Sets shaders, varyings and uniforms. What the fragment shader does follows the pipeline's
 * fragment_reads_position, fragment_reads_primitive, fragment_reads_point_coordinate,
 * fragment_reads_sample_mask, fragment_discards, fragment_writes_depth and
 * fragment_writes_sample_mask. */
gn_status inputs_use(gn_pipeline *pipeline, const gn_color_uniforms *uniforms);

#endif
