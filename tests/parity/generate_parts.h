/* The generators of the classes, and the shapes that they share. Shapes add vertices and indices to
 * the next draw, under its state. */
#ifndef PARITY_GENERATE_PARTS_H
#define PARITY_GENERATE_PARTS_H

#include "builder.h"

/* How a vertex's position is chosen. */
typedef enum placement {
    PLACE_ANYWHERE, /* any float in the viewport or a little around it, w from 1/4 to 4 */
    PLACE_AFFINE,   /* any float in the viewport or a little around it, w = 1 */
    PLACE_INSIDE,   /* within the view volume */
    PLACE_TIES,     /* multiples of 1, 1/2, 1/4, 1/256 or 1/512 pixel, w a power of two */
    PLACE_CLIP,     /* clip coordinates within -2..2, w of any sign */
    PLACE_COUNT
} placement;

void shape_place(builder *b, vertex *v, placement p);

/* Shapes of separate triangles. */
void shape_triangles(builder *b, placement p, uint32_t count);
void shape_tiny(builder *b, uint32_t count);
void shape_slivers(builder *b, uint32_t count);
void shape_ties(builder *b, uint32_t count);

/* Triangles so thin that snapping reverses their winding or makes their area more than zero. */
void shape_turning(builder *b, uint32_t count);

void shape_huge(builder *b, uint32_t count);
void shape_offscreen(builder *b, uint32_t count);
void shape_behind(builder *b, uint32_t count);
void shape_near_crossing(builder *b, uint32_t count);
void shape_degenerate(builder *b, uint32_t count);

/* Indexed triangles: a grid with random diagonals and moved inner vertices, and triangles around a
 * point. All windings are equal if nothing crosses. */
void shape_grid(builder *b, uint32_t columns, uint32_t rows);

/* A grid with 1 to `most` columns and 1 to `most` rows. */
void shape_any_grid(builder *b, uint32_t most);
void shape_hub(builder *b, uint32_t spokes);

/* Layers that overlap over much of the viewport: equal depths, common planes, interpenetrating
 * triangles. */
void shape_pile(builder *b, uint32_t count);

/* A strip that winds through the viewport, or a fan; sets the topology. */
void shape_strip(builder *b, uint32_t triangles);

/* Random indices over few vertices; keeps the topology. */
void shape_random_indices(builder *b, placement p, uint32_t vertices, uint32_t triangles);

/* One of the shapes of separate triangles. */
void shape_separate(builder *b, uint32_t count);

/* Any comparison but the default. */
static inline gn_compare random_comparison(random_source *r)
{
    return (gn_compare)(GN_NEVER + random_below(r, GN_ALWAYS - GN_NEVER + 1));
}

/* A random depth range, scissor and polygon offset, with `enabled` true. */
gn_depth_range random_depth_range(builder *b);
gn_scissor random_scissor(builder *b);
gn_polygon_offset random_polygon_offset(builder *b);
/* One of the shapes of separate triangles, or a strip or a fan. */
void shape_any(builder *b, uint32_t count);

/* Sets the next draw's shader to that of reference/scene/inputs.h. */
void random_inputs(builder *b);

/* Sets the next draw's shader to that of reference/scene/derivatives.h. */
void random_derivatives(builder *b);

/* Sets a random stencil test for the next draw. */
void random_stencil(builder *b);
/* Points or lines; sets the topology and sizes. */
void shape_points(builder *b, uint32_t count);
void shape_lines(builder *b, uint32_t count);
/* One of the colour formats besides RGBA8 and RGBA32F. */
gn_format random_color_format(builder *b);

/* A format of texels: one of RGBA8, RGBA32F and SRGB8_A8, or of all formats of colours. */
gn_format random_texel_format(random_source *r, bool is_common);

/* Adds, each now and then, restarts among the existing indices, a base vertex and instances. A draw
 * without indices gets only instances. */
void shape_elements(builder *b);

/* Sets clip distances for the next draw, whose vertices exist. */
void random_clip_planes(builder *b, uint32_t count);

/* Sets a polygon mode for each face, with widths and sizes. */
void state_outlines(builder *b);

/* Changes a draw with polygon modes so that it avoids what the reference draws otherwise than
 * OpenGL. */
void fit_outlines(builder *b);

/* A perspective camera that looks at a body about the origin, turned and stretched; add_body adds
 * the body. */
void random_camera(builder *b);

/* A directional light of random colours. */
void random_light(builder *b);
void add_body(builder *b);

/* The texels of a draw's maps, the diffuse map last. */
typedef struct shading_memory {
    void *texels[1 + SCENE_MAP_COUNT];
} shading_memory;

/* A shape for the ready-made shaders: mostly a body with normals before a camera. */
void shape_shaded(builder *b);

/* Sets what a ready-made shader of the next draw reads besides positions and colours: light, maps
 * with their sampler, and texture coordinates of the vertices, which exist. The maps are in
 * `memory`, which the caller frees after the draw. */
void random_shading(builder *b, shading_memory *memory);
void free_shading(shading_memory *memory);

/* Fills a 2D texture over memory that the caller frees. */
void *random_map(builder *b, gn_texture *t);

/* Wraps and filters of maps, with one level or several. Borders are not 0, like the texels. */
void random_map_sampler(random_source *r, gn_sampler *s);

gn_vec3 random_vec3(random_source *r, float low, float high);

/* Adds a draw with a shadow map: `choose` returns its shader, `add_more` may change what the shader
 * reads, or is null. */
void shadowed_draw(builder *b, scene_shader (*choose)(builder *), void (*add_more)(builder *));

/* Sets what SCENE_METALLIC_ROUGHNESS reads besides what random_shading sets. */
void random_metallic(builder *b, shading_memory *memory);

/* Sets a random texture and sampler for the next draw, and texture coordinates for its vertices,
 * which exist. Returns the texture's texels; the caller frees them after the draw. */
void *random_sampling(builder *b, gn_texture_target target, uint32_t levels, bool depths);
void *random_any_sampling(builder *b);

/* Sets a lit shader with a texture of one level for the next draw. Returns the texels; the caller
 * frees them after the draw. */
void *random_picture(builder *b);

/* The generators, one per class; each begins with the target. */
void generate_meshes(builder *b);
void generate_piles(builder *b);
void generate_fills(builder *b);
void generate_strips(builder *b);
void generate_framebuffers(builder *b);
void generate_depth_state(builder *b);
void generate_culling(builder *b);
void generate_segments(builder *b);
void generate_interpolation(builder *b);
void generate_indexed(builder *b);
void generate_lit(builder *b);
void generate_textured(builder *b);
void generate_textures(builder *b);
void generate_mipmaps(builder *b);
void generate_volumes(builder *b);
void generate_cubes(builder *b);
void generate_shadows(builder *b);
void generate_phong(builder *b);
void generate_shaders(builder *b);
void generate_shadowed(builder *b);
void generate_materials(builder *b);
void generate_inputs(builder *b);
void generate_derivatives(builder *b);
void generate_stencil(builder *b);
void generate_counting(builder *b);
void generate_float_color(builder *b);
void generate_color_range(builder *b);
void generate_scissor(builder *b);
void generate_offset(builder *b);
void generate_color_mask(builder *b);
void generate_blend(builder *b);
void generate_float_blend(builder *b);
void generate_logic(builder *b);
void generate_clip_depth(builder *b);
void generate_points(builder *b);
void generate_lines(builder *b);
void generate_point_coordinates(builder *b);
void generate_formats(builder *b);
void generate_instances(builder *b);
void generate_attachments(builder *b);
void generate_clip_distance(builder *b);
void generate_outlines(builder *b);
void generate_mixed(builder *b);

void generate_sequences(builder *b);
void generate_batches(builder *b);
void generate_batch_ends(builder *b);

/* Adds a draw whose states are all chosen independently; without blending unless may_blend. */
void varied_draw(builder *b, bool may_blend);
bool may_blend_after(const builder *b, uint32_t draws);

gn_viewport random_viewport(builder *b);
gn_format random_depth_format(builder *b); /* or no depth, or stencil alone */

/* Sets how an attachment of the next draw is combined with its pixels: by alpha and one minus
 * alpha, by any blending, or under a mask. */
void lay_over(builder *b, int attachment);
void random_blend(builder *b, int attachment);
void random_mask(builder *b, int attachment);

/* Adds attachments after the first, sets a shader for them, and their blending and masks;
 * attachments of floats are blended only where layers are few. */
void add_attachments(builder *b);
void random_outputs(builder *b);
void mix_attachments(builder *b, bool blends_floats);

/* Makes the surfaces of a finished scene multisampled. */
void make_sampled(random_source *r, scene *s);

/* A scene of any other class with several samples a pixel. */
scene *generate_sampled(uint64_t seed);

/* A scene of any other class without textures or light, with several samples a pixel, now and then
 * with one; its shaders use sample masks. */
scene *generate_masks(uint64_t seed);
scene *generate_upside_down(uint64_t seed);

/* Chooses what a draw's fragment shader is run for, and where its varyings are interpolated. */
void random_sample_shading(random_source *r, scene_draw *d);
scene *generate_sample_shading(uint64_t seed);

/* Sets write masks, blending and logical operations for a draw of the mixed classes. */
void mix_color_state(builder *b);

#endif
