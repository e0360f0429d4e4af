/* A user's shader that shows every input of a fragment and uses every output: it reads facing,
 * primitive, window position, point coordinates, sample mask and sample; it discards, and writes
 * depth and sample mask. Its twin in GLSL is in reference/osmesa/programs.c. */
#ifndef SCENE_INPUTS_H
#define SCENE_INPUTS_H

#include <gnomon.h>

/* Sets shaders, varyings and uniforms. The fragment shader does what these members of the pipeline
 * ask for: fragment_reads_position, fragment_reads_primitive, fragment_reads_point_coordinate,
 * fragment_reads_sample_mask, fragment_reads_sample, fragment_discards, fragment_writes_depth and
 * fragment_writes_sample_mask. */
gn_status inputs_use(gn_pipeline *pipeline, const gn_color_uniforms *uniforms, gn_backend backend);

#endif
