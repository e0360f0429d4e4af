/* The classes of random scenes: their names, and one scene of a class. */
#include "generate.h"

#include <string.h>

#include "generate_parts.h"

const char *scene_class_name(scene_class c)
{
    switch (c) {
    case CLASS_TINY:
        return "tiny";
    case CLASS_SLIVERS:
        return "slivers";
    case CLASS_TIES:
        return "ties";
    case CLASS_HUGE:
        return "huge";
    case CLASS_OFFSCREEN:
        return "offscreen";
    case CLASS_BEHIND:
        return "behind";
    case CLASS_NEAR_CROSSING:
        return "near-crossing";
    case CLASS_DEGENERATE:
        return "degenerate";
    case CLASS_MESHES:
        return "meshes";
    case CLASS_PILES:
        return "piles";
    case CLASS_FILLS:
        return "fills";
    case CLASS_STRIPS:
        return "strips";
    case CLASS_FRAMEBUFFERS:
        return "framebuffers";
    case CLASS_DEPTH_STATE:
        return "depth-state";
    case CLASS_CULLING:
        return "culling";
    case CLASS_SEGMENTS:
        return "segments";
    case CLASS_INTERPOLATION:
        return "interpolation";
    case CLASS_INDEXED:
        return "indexed";
    case CLASS_LIT:
        return "lit";
    case CLASS_TEXTURED:
        return "textured";
    case CLASS_TEXTURES:
        return "textures";
    case CLASS_MIPMAPS:
        return "mipmaps";
    case CLASS_VOLUMES:
        return "volumes";
    case CLASS_CUBES:
        return "cubes";
    case CLASS_SHADOWS:
        return "shadows";
    case CLASS_PHONG:
        return "phong";
    case CLASS_SHADERS:
        return "shaders";
    case CLASS_SHADOWED:
        return "shadowed";
    case CLASS_INPUTS:
        return "inputs";
    case CLASS_DERIVATIVES:
        return "derivatives";
    case CLASS_STENCIL:
        return "stencil";
    case CLASS_COUNTING:
        return "counting";
    case CLASS_FLOAT_COLOR:
        return "float-color";
    case CLASS_COLOR_RANGE:
        return "color-range";
    case CLASS_SCISSOR:
        return "scissor";
    case CLASS_OFFSET:
        return "offset";
    case CLASS_COLOR_MASK:
        return "color-mask";
    case CLASS_BLEND:
        return "blend";
    case CLASS_FLOAT_BLEND:
        return "float-blend";
    case CLASS_LOGIC:
        return "logic";
    case CLASS_CLIP_DEPTH:
        return "clip-depth";
    case CLASS_POINTS:
        return "points";
    case CLASS_LINES:
        return "lines";
    case CLASS_POINT_COORDINATES:
        return "point-coordinates";
    case CLASS_FORMATS:
        return "formats";
    case CLASS_INSTANCES:
        return "instances";
    case CLASS_ATTACHMENTS:
        return "attachments";
    case CLASS_SAMPLES:
        return "samples";
    case CLASS_MASKS:
        return "masks";
    case CLASS_SAMPLE_SHADING:
        return "sample-shading";
    case CLASS_CLIP_DISTANCE:
        return "clip-distances";
    case CLASS_OUTLINES:
        return "outlines";
    case CLASS_MIXED:
        return "mixed";
    case CLASS_SEQUENCES:
        return "sequences";
    case CLASS_BATCHES:
        return "batches";
    case CLASS_BATCH_ENDS:
        return "batch-ends";
    case CLASS_MATERIALS:
        return "materials";
    case CLASS_UPSIDE_DOWN:
        return "upside-down";
    case CLASS_COUNT:
        break;
    }
    return "";
}

scene_class scene_class_of(const char *name)
{
    int c = 0;
    while (c < CLASS_COUNT && strcmp(name, scene_class_name((scene_class)c)) != 0)
        ++c;
    return (scene_class)c;
}

/* A scene of separate triangles under the common state. */
static void generate_triangles(builder *b, void (*shape)(builder *, uint32_t))
{
    builder_common_target(b);
    builder_common_state(b);
    shape(b, builder_triangle_count(b));
    builder_draw(b);
}

scene *generate_scene(uint64_t seed, scene_class c, uint64_t number)
{
    /* The seed comes from the class's name, not from its position in the enumeration, so that a new
     * class leaves the scenes of the others unchanged. */
    uint64_t mix = seed;
    for (const char *name = scene_class_name(c); *name; ++name)
        mix = random_splitmix(&mix) ^ (unsigned char)*name;
    mix = random_splitmix(&mix) ^ number;

    if (c == CLASS_SAMPLES)
        return generate_sampled(mix);
    if (c == CLASS_MASKS)
        return generate_masks(mix);
    if (c == CLASS_SAMPLE_SHADING)
        return generate_sample_shading(mix);
    if (c == CLASS_UPSIDE_DOWN)
        return generate_upside_down(mix);

    builder b;
    builder_begin(&b, random_splitmix(&mix));
    switch (c) {
    case CLASS_TINY:
        generate_triangles(&b, shape_tiny);
        break;
    case CLASS_SLIVERS:
        generate_triangles(&b, shape_slivers);
        break;
    case CLASS_TIES:
        generate_triangles(&b, shape_ties);
        break;
    case CLASS_HUGE:
        generate_triangles(&b, shape_huge);
        break;
    case CLASS_OFFSCREEN:
        generate_triangles(&b, shape_offscreen);
        break;
    case CLASS_BEHIND:
        generate_triangles(&b, shape_behind);
        break;
    case CLASS_NEAR_CROSSING:
        generate_triangles(&b, shape_near_crossing);
        break;
    case CLASS_DEGENERATE:
        generate_triangles(&b, shape_degenerate);
        break;
    case CLASS_MESHES:
        generate_meshes(&b);
        break;
    case CLASS_PILES:
        generate_piles(&b);
        break;
    case CLASS_FILLS:
        generate_fills(&b);
        break;
    case CLASS_STRIPS:
        generate_strips(&b);
        break;
    case CLASS_FRAMEBUFFERS:
        generate_framebuffers(&b);
        break;
    case CLASS_DEPTH_STATE:
        generate_depth_state(&b);
        break;
    case CLASS_CULLING:
        generate_culling(&b);
        break;
    case CLASS_SEGMENTS:
        generate_segments(&b);
        break;
    case CLASS_INTERPOLATION:
        generate_interpolation(&b);
        break;
    case CLASS_INDEXED:
        generate_indexed(&b);
        break;
    case CLASS_LIT:
        generate_lit(&b);
        break;
    case CLASS_TEXTURED:
        generate_textured(&b);
        break;
    case CLASS_TEXTURES:
        generate_textures(&b);
        break;
    case CLASS_MIPMAPS:
        generate_mipmaps(&b);
        break;
    case CLASS_VOLUMES:
        generate_volumes(&b);
        break;
    case CLASS_CUBES:
        generate_cubes(&b);
        break;
    case CLASS_SHADOWS:
        generate_shadows(&b);
        break;
    case CLASS_PHONG:
        generate_phong(&b);
        break;
    case CLASS_SHADERS:
        generate_shaders(&b);
        break;
    case CLASS_SHADOWED:
        generate_shadowed(&b);
        break;
    case CLASS_INPUTS:
        generate_inputs(&b);
        break;
    case CLASS_DERIVATIVES:
        generate_derivatives(&b);
        break;
    case CLASS_STENCIL:
        generate_stencil(&b);
        break;
    case CLASS_COUNTING:
        generate_counting(&b);
        break;
    case CLASS_FLOAT_COLOR:
        generate_float_color(&b);
        break;
    case CLASS_COLOR_RANGE:
        generate_color_range(&b);
        break;
    case CLASS_SCISSOR:
        generate_scissor(&b);
        break;
    case CLASS_OFFSET:
        generate_offset(&b);
        break;
    case CLASS_COLOR_MASK:
        generate_color_mask(&b);
        break;
    case CLASS_BLEND:
        generate_blend(&b);
        break;
    case CLASS_FLOAT_BLEND:
        generate_float_blend(&b);
        break;
    case CLASS_LOGIC:
        generate_logic(&b);
        break;
    case CLASS_CLIP_DEPTH:
        generate_clip_depth(&b);
        break;
    case CLASS_POINTS:
        generate_points(&b);
        break;
    case CLASS_LINES:
        generate_lines(&b);
        break;
    case CLASS_POINT_COORDINATES:
        generate_point_coordinates(&b);
        break;
    case CLASS_FORMATS:
        generate_formats(&b);
        break;
    case CLASS_INSTANCES:
        generate_instances(&b);
        break;
    case CLASS_SEQUENCES:
        generate_sequences(&b);
        break;
    case CLASS_BATCHES:
        generate_batches(&b);
        break;
    case CLASS_BATCH_ENDS:
        generate_batch_ends(&b);
        break;
    case CLASS_ATTACHMENTS:
        generate_attachments(&b);
        break;
    case CLASS_CLIP_DISTANCE:
        generate_clip_distance(&b);
        break;
    case CLASS_OUTLINES:
        generate_outlines(&b);
        break;
    case CLASS_MATERIALS:
        generate_materials(&b);
        break;
    default:
        generate_mixed(&b);
        break;
    }
    const bool may_be_sampled = c == CLASS_MIXED || c == CLASS_SEQUENCES || c == CLASS_SHADERS ||
                                c == CLASS_SHADOWED || c == CLASS_BATCHES ||
                                c == CLASS_BATCH_ENDS || c == CLASS_MATERIALS;
    if (may_be_sampled && random_chance(&b.random, 20))
        make_sampled(&b.random, b.scene);
    if (c == CLASS_MIXED || c == CLASS_SEQUENCES || b.metallic) {
        random_source shading = random_seed(mix); /* of its own, so that other states stay */
        for (size_t i = 0; i < b.scene->draw_count; ++i)
            random_sample_shading(&shading, &b.scene->draws[i]);
    }
    return builder_end(&b);
}
