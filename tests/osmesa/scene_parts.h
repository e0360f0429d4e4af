/* Parts of random scenes.
 *
 * Not alone: registry.py writes gl_registry.h, which it includes. */
#ifndef OSMESA_SCENE_PARTS_H
#define OSMESA_SCENE_PARTS_H

#include "scenes.h"

static inline float between(random_source *r, float low, float high)
{
    return random_float(r, low, high);
}

static inline bool one_in(random_source *r, uint32_t n)
{
    return random_below(r, n) == 0;
}

static inline GLenum pick(random_source *r, const GLenum *list, uint32_t count)
{
    return list[random_below(r, count)];
}

#define PICK(r, ...)                                                                               \
    pick(r, (const GLenum[]){__VA_ARGS__}, sizeof((const GLenum[]){__VA_ARGS__}) / sizeof(GLenum))

/* Sets a camera, or a plane, and some transformations. */
void set_matrices(const library *gl, random_source *r);

void set_color(const library *gl, random_source *r);

/* Clears everything to random values. */
void clear_window(const library *gl, random_source *r);

/* Draws some primitives of random vertices in one of the modes. */
void draw_primitives(const library *gl, random_source *r, const GLenum *modes, uint32_t count);

/* Scenes of scenes_state.c and scenes_arrays.c. */
void draw_states(const library *gl, random_source *r, int width, int height);
void draw_alpha(const library *gl, random_source *r, int width, int height);
void draw_fog(const library *gl, random_source *r, int width, int height);
void draw_clears(const library *gl, random_source *r, int width, int height);
void draw_arrays(const library *gl, random_source *r, int width, int height);

/* Draws primitives of vertices with normals, and with colours if asked for. */
void draw_lit_vertices(const library *gl, random_source *r, bool has_colors);

/* Sets lights of all kinds, materials, and what becomes of normals. */
void set_lit_state(const library *gl, random_source *r);

/* Scenes of scenes_lighting.c. */
void draw_directional(const library *gl, random_source *r, int width, int height);
void draw_lighting(const library *gl, random_source *r, int width, int height);
void draw_color_material(const library *gl, random_source *r, int width, int height);

/* Scenes of scenes_framebuffers.c. */
void draw_renderbuffers(const library *gl, random_source *r, int width, int height);
void draw_multisampled(const library *gl, random_source *r, int width, int height);
void draw_to_texture(const library *gl, random_source *r, int width, int height);
void draw_to_layers(const library *gl, random_source *r, int width, int height);
void draw_blits(const library *gl, random_source *r, int width, int height);

/* Scenes of scenes_clipping.c. */
void draw_clipped(const library *gl, random_source *r, int width, int height);
void draw_clipped_lines(const library *gl, random_source *r, int width, int height);
void draw_clipped_surfaces(const library *gl, random_source *r, int width, int height);

/* Scenes of scenes_pixels.c. */
void draw_pixels(const library *gl, random_source *r, int width, int height);
void draw_bitmaps(const library *gl, random_source *r, int width, int height);
void fill_bytes(random_source *r, GLubyte *bytes, uint32_t count);

/* Scenes of scenes_modes.c. */
void draw_selected(const library *gl, random_source *r, int width, int height);
void draw_fed_back(const library *gl, random_source *r, int width, int height);

/* Scenes of scenes_polygons.c. */
void draw_line_patterns(const library *gl, random_source *r, int width, int height);
void draw_stippled_polygons(const library *gl, random_source *r, int width, int height);
void draw_polygon_lines(const library *gl, random_source *r, int width, int height);
void draw_polygon_points(const library *gl, random_source *r, int width, int height);
void draw_polygon_modes(const library *gl, random_source *r, int width, int height);
void draw_smooth(const library *gl, random_source *r, int width, int height);
void draw_attenuated_points(const library *gl, random_source *r, int width, int height);

/* Scenes of scenes_accumulation.c. */
void draw_accumulated(const library *gl, random_source *r, int width, int height);

/* Scenes of scenes_evaluators.c. */
void draw_curves(const library *gl, random_source *r, int width, int height);
void draw_surfaces(const library *gl, random_source *r, int width, int height);
void draw_lit_surfaces(const library *gl, random_source *r, int width, int height);

/* Scenes of scenes_transfer.c. */
void draw_transferred(const library *gl, random_source *r, int width, int height);
void draw_read_pixels(const library *gl, random_source *r, int width, int height);
void draw_transferred_textures(const library *gl, random_source *r, int width, int height);
void draw_copies(const library *gl, random_source *r, int width, int height);

/* Set a texture of the active unit, how it is sampled, its environment, its matrix, and generated
 * coordinates. */
void set_texture(const library *gl, random_source *r);
void set_texture_sampling(const library *gl, random_source *r, GLenum target);
void set_texture_environment(const library *gl, random_source *r);
void set_texture_matrix(const library *gl, random_source *r);
void set_texture_generation(const library *gl, random_source *r);

/* Sets sums of colours and fog, which come after textures. */
void set_later_states(const library *gl, random_source *r);

/* Draws primitives of vertices with texture coordinates, of three components if asked for. */
void draw_textured_vertices(const library *gl, random_source *r, bool has_normals, bool has_r);

/* Scenes of scenes_targets.c. */
void draw_shadows(const library *gl, random_source *r, int width, int height);
void draw_cubes(const library *gl, random_source *r, int width, int height);
void draw_seamless_cubes(const library *gl, random_source *r, int width, int height);
void draw_volumes(const library *gl, random_source *r, int width, int height);
void draw_units(const library *gl, random_source *r, int width, int height);
void draw_generated_levels(const library *gl, random_source *r, int width, int height);
void draw_srgb(const library *gl, random_source *r, int width, int height);
void draw_lod_limits(const library *gl, random_source *r, int width, int height);

/* Scenes of scenes_texture.c. */
void draw_textures(const library *gl, random_source *r, int width, int height);
void draw_copied_texture(const library *gl, random_source *r, int width, int height);
void draw_generated_coordinates(const library *gl, random_source *r, int width, int height);
void draw_mixed(const library *gl, random_source *r, int width, int height);

/* Scenes of scenes_combine.c. */
void draw_combine(const library *gl, random_source *r, int width, int height);

/* Scenes of scenes_lists.c. */
void draw_listed_scene(const library *gl, random_source *r, int width, int height);
void draw_nested_lists(const library *gl, random_source *r, int width, int height);

#endif
