/* The generators of the classes, and the shapes they share. Shapes add vertices and
 * indices to the draw in the making, under the state it has. */
#ifndef PARITY_GENERATE_PARTS_H
#define PARITY_GENERATE_PARTS_H

#include "builder.h"

/* How the position of a vertex is chosen. */
typedef enum placement {
    PLACE_ANYWHERE, /* any float in and a little around the viewport, w from 1/4 to 4 */
    PLACE_AFFINE,   /* the same with w = 1 */
    PLACE_INSIDE,   /* within the view volume */
    PLACE_TIES,     /* multiples of 1, 1/2, 1/4, 1/256 or 1/512 pixel, w a power of two */
    PLACE_CLIP,     /* clip coordinates within -2..2, w of any sign */
    PLACE_COUNT
} placement;

void shape_place(builder *b, vertex *v, placement p);

/* Separate triangles, one shape each. */
void shape_triangles(builder *b, placement p, uint32_t count);
void shape_tiny(builder *b, uint32_t count);
void shape_slivers(builder *b, uint32_t count);
void shape_ties(builder *b, uint32_t count);

/* So thin that snapping turns them over, or gives them an area. */
void shape_turning(builder *b, uint32_t count);

void shape_huge(builder *b, uint32_t count);
void shape_offscreen(builder *b, uint32_t count);
void shape_behind(builder *b, uint32_t count);
void shape_near_crossing(builder *b, uint32_t count);
void shape_degenerate(builder *b, uint32_t count);

/* Indexed triangles over a grid with random diagonals, its inner vertices moved, and
 * triangles around a point. Windings are all the same where nothing crosses. */
void shape_grid(builder *b, uint32_t columns, uint32_t rows);

/* A grid of 1 to `most` columns and as many rows at most. */
void shape_any_grid(builder *b, uint32_t most);
void shape_hub(builder *b, uint32_t spokes);

/* Layers that overlap over much of the viewport: equal depths, common planes,
 * interpenetrating. */
void shape_pile(builder *b, uint32_t count);

/* A strip that winds through the viewport, or a fan; the topology is set. */
void shape_strip(builder *b, uint32_t triangles);

/* Random indices over few vertices; the topology stays. */
void shape_random_indices(builder *b, placement p, uint32_t vertices, uint32_t triangles);

/* One of the shapes of separate triangles. */
void shape_separate(builder *b, uint32_t count);

/* Any comparison but the default. */
static inline gn_compare random_comparison(random_source *r)
{
    return (gn_compare)(GN_NEVER + random_below(r, GN_ALWAYS - GN_NEVER + 1));
}

/* A range and a scissor to try things with; set. */
gn_depth_range random_depth_range(builder *b);
gn_scissor random_scissor(builder *b);
gn_polygon_offset random_polygon_offset(builder *b);
/* One of the shapes of separate triangles, or a strip or a fan. */
void shape_any(builder *b, uint32_t count);

/* Makes the next draw's shader that of reference/scene/inputs.h. */
void random_inputs(builder *b);

/* Makes it that of reference/scene/derivatives.h. */
void random_derivatives(builder *b);

/* A random stencil test of the next draw. */
void random_stencil(builder *b);
/* Points or lines; sets the topology and sizes. */
void shape_points(builder *b, uint32_t count);
void shape_lines(builder *b, uint32_t count);
/* One of the colour formats beside RGBA8 and RGBA32F. */
gn_format random_color_format(builder *b);

/* Restarts among the indices there are, a base vertex, instances: each now and then. Of a
 * draw without indices, instances alone. */
void shape_elements(builder *b);

/* Clip distances of the next draw, whose vertices are there. */
void random_clip_planes(builder *b, uint32_t count);

/* Polygon modes by face, with widths and sizes. */
void state_outlines(builder *b);

/* Of a draw with polygon modes: takes out what the reference draws otherwise than OpenGL. */
void fit_outlines(builder *b);

/* A perspective camera over a body about the origin, turned and stretched, and that body. */
void random_camera(builder *b);

/* A directional light of any colours. */
void random_light(builder *b);
void add_body(builder *b);

/* The texels of a draw's maps, the diffuse one last. */
typedef struct shading_memory {
    void *texels[1 + SCENE_MAP_COUNT];
} shading_memory;

/* What a ready-made shader of the next draw looks at beside places and colours: light, maps with
 * their sampler, texture coordinates of the vertices, which are there. The maps are the memory's,
 * which the caller frees after the draw. */
void random_shading(builder *b, shading_memory *memory);
void free_shading(shading_memory *memory);

/* A random texture and sampler of the next draw, whose vertices are there and get coordinates for
 * it. The texels, which the caller frees after the draw, are the texture's. */
void *random_sampling(builder *b, gn_texture_target target, uint32_t levels, bool depths);
void *random_any_sampling(builder *b);

/* One class each, from the target on. */
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

/* A draw every state of which is chosen for itself; without blending where it may not. */
void varied_draw(builder *b, bool may_blend);
bool may_blend_after(const builder *b, uint32_t draws);

gn_viewport random_viewport(builder *b);
gn_format random_depth_format(builder *b); /* or none, or stencil alone */

/* How an attachment of the next draw is combined: by alpha and one minus alpha, any blending, a
 * mask. */
void lay_over(builder *b, int attachment);
void random_blend(builder *b, int attachment);
void random_mask(builder *b, int attachment);

/* Attachments after the first; a shader for them; blending and masks of them, of floats only where
 * layers are few. */
void add_attachments(builder *b);
void random_outputs(builder *b);
void mix_attachments(builder *b, bool blends_floats);

/* Gives the pixels of a finished scene several samples. */
void make_sampled(random_source *r, scene *s);

/* A scene of any other class with several samples a pixel. */
scene *generate_sampled(uint64_t seed);

/* The same, but of colours without textures or light, with sample masks in the shaders; now and
 * then of one sample. */
scene *generate_masks(uint64_t seed);

/* What mixed draws have of the classes of colours combined with those of the target. */
void mix_color_state(builder *b);

#endif
