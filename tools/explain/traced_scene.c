/* reference/scene/scene_library.c once more, with another function in place of gn_draw: a scene's
 * draws get their shaders and uniforms from the same text as in the ordinary picture. */
#include <gnomon.h>

#include "traced_scene.h"

#define gn_draw traced_draw
#define scene_draw_to_target traced_scene_draw
#define scene_varyings traced_scene_varyings
#define scene_workspace_size traced_scene_workspace_size
#define scene_draw_in_workspace traced_scene_draw_in_workspace
#define scene_draw_library traced_scene_draw_library
#include "../../reference/scene/scene_library.c"
