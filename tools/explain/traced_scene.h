/* Scenes that the tracing stages draw. */
#ifndef EXPLAIN_TRACED_SCENE_H
#define EXPLAIN_TRACED_SCENE_H

#include "scene.h"

/* Does what scene_draw_to_target does, with traced_draw in place of gn_draw. */
gn_status traced_scene_draw(const scene *s, const gn_target *target, gn_workspace *workspace);

/* Does what gn_draw does at the pixel (tracing.h) alone, and tells every fragment there. */
gn_status traced_draw(const gn_target *target, const gn_pipeline *pipeline, const gn_mesh *mesh,
                      gn_workspace *workspace);

#endif
