/* The rows of the state matrix, one state at a time. To add a state, add a row. */
#include "rows.h"

#define SCREENS SHAPE_SCREENS, 512, 16
#define FEW_SCREENS SHAPE_SCREENS, 512, 8
#define TEXTURED SHAPE_TEXTURED, 512, 8
#define SAMPLED SHAPE_SAMPLED, 512, 4
#define SPHERE SHAPE_SPHERE, 512, 73
#define PHONG SHAPE_PHONG, 768, 22

/* The text of colour formats, depth formats and texture formats. */
#define COLOR(format) "color-format " format
#define DEPTH(format) "depth-format " format
#define TEXELS(format) "noise 2d " format " 256 1 1 " BILINEAR
#define BILINEAR "uniforms.sampler.magnify linear uniforms.sampler.minify linear "
#define NEAREST "uniforms.sampler.magnify nearest uniforms.sampler.minify nearest "
#define MINIFY(filter) "uniforms.sampler.magnify linear uniforms.sampler.minify " filter " "
#define BLEND(equation, source, destination)                                                       \
    "alpha color.blend[0].enabled on color.blend[0].equation " equation                            \
    " color.blend[0].source " source " color.blend[0].destination " destination " "
#define OVER BLEND("add", "source-alpha", "one-minus-source-alpha")
#define ADDED BLEND("add", "one", "one")
#define LOGIC(operation) "color.logic on color.logic_operation " operation
#define STENCIL(face, function, pass)                                                              \
    "stencil." face ".function " function " stencil." face ".reference 1 "                         \
    "stencil." face ".pass " pass " "
#define BOTH(function, pass)                                                                       \
    "depth-format d24s8 stencil.test on " STENCIL("front", function, pass)                         \
        STENCIL("back", function, pass)
#define COLORS_2                                                                                   \
    "shader outputs program.color_count 2 more-colors rgba8 "                                      \
    "none none none none none none "
#define COLORS_4                                                                                   \
    "shader outputs program.color_count 4 more-colors rgba8 rgba8 rgba8 "                          \
    "none none none none "
#define INTERPOLATION(kind)                                                                        \
    "program.interpolation[0] " kind " program.interpolation[1] " kind                             \
    " program.interpolation[2] " kind " program.interpolation[3] " kind
#define POLYGONS(mode) "raster.polygon_mode_front " mode " raster.polygon_mode_back " mode

#define DRAW WORK_DRAW, "", 0.0f
#define DRAW_AUTO(to) WORK_DRAW_AUTO, to, 0.0f
#define BLIT(to) WORK_BLIT, to, 0.0f
#define BLIT_LINEAR(to) WORK_BLIT_LINEAR, to, 0.0f
#define RESOLVE(to) WORK_RESOLVE, to, 0.0f
#define LEVELS WORK_LEVELS, "", 0.0f

const bench_row single_states[] = {
    {"scene", "S1", SCREENS, "", DRAW},
    {"scene", "S1 rolled", SHAPE_ROLLED, 512, 16, "", DRAW},
    {"scene", "S2", TEXTURED, "", DRAW},
    {"scene", "S2 nearest", SHAPE_TEXTURED, 512, 16, NEAREST, DRAW},
    {"scene", "S2 levels", SAMPLED, "noise 2d rgba8 256 1 9 " MINIFY("linear-mipmap-linear"), DRAW},
    {"scene", "S2 cube", SAMPLED, "noise cube rgba8 256 1 9 " MINIFY("linear-mipmap-linear"), DRAW},
    {"scene", "S3", SPHERE, "", DRAW},
    {"scene", "S4", SHAPE_USER, 768, 22, "", DRAW},
    {"scene", "S4 ready", PHONG, "", DRAW},
    {"scene", "S5", SHAPE_SPHERE, 512, 145, "shift 0 0 -0.475", DRAW},

    {"colour", "BGRA8 colour", SCREENS, COLOR("bgra8"), DRAW},
    {"colour", "R8 colour", SCREENS, COLOR("r8"), DRAW},
    {"colour", "RG8 colour", SCREENS, COLOR("rg8"), DRAW},
    {"colour", "RGB8 colour", SCREENS, COLOR("rgb8"), DRAW},
    {"colour", "RGB565 colour", SCREENS, COLOR("rgb565"), DRAW},
    {"colour", "RGB565_SWAPPED colour", SCREENS, COLOR("rgb565-swapped"), DRAW},
    {"colour", "RGB5_A1 colour", SCREENS, COLOR("rgb5-a1"), DRAW},
    {"colour", "RGBA4 colour", SCREENS, COLOR("rgba4"), DRAW},
    {"colour", "R16 colour", SCREENS, COLOR("r16"), DRAW},
    {"colour", "RGBA16 colour", SCREENS, COLOR("rgba16"), DRAW},
    {"colour", "R32F colour", SCREENS, COLOR("r32f"), DRAW},
    {"colour", "RGBA32F colour", SCREENS, COLOR("rgba32f"), DRAW},
    {"colour", "RGBA16F colour", SCREENS, COLOR("rgba16f"), DRAW},
    {"colour", "RG16F colour", SCREENS, COLOR("rg16f"), DRAW},
    {"colour", "sRGB colour", SCREENS, COLOR("srgb8-a8"), DRAW},
    {"colour", "RGB10_A2 colour", SCREENS, COLOR("rgb10-a2"), DRAW},
    {"colour", "R11F_G11F_B10F colour", SCREENS, COLOR("r11f-g11f-b10f"), DRAW},
    {"colour", "RGB32F colour", SCREENS, COLOR("rgb32f"), DRAW},
    {"colour", "sRGB colour, sphere", SPHERE, COLOR("srgb8-a8"), DRAW},
    {"colour", "RGB565 colour, sphere", SPHERE, COLOR("rgb565"), DRAW},
    {"colour", "RGBA16F colour, sphere", SPHERE, COLOR("rgba16f"), DRAW},

    {"depth", "no depth", SHAPE_SCREENS, 512, 32, DEPTH("none"), DRAW},
    {"depth", "D16", SCREENS, DEPTH("d16"), DRAW},
    {"depth", "D32F", SCREENS, DEPTH("d32f"), DRAW},
    {"depth", "D24S8", SCREENS, DEPTH("d24s8"), DRAW},
    {"depth", "D32FS8", SCREENS, DEPTH("d32fs8"), DRAW},
    {"depth", "S8", SCREENS, DEPTH("s8"), DRAW},
    {"depth", "D16, sphere", SPHERE, DEPTH("d16"), DRAW},
    {"depth", "D24S8, sphere", SPHERE, DEPTH("d24s8"), DRAW},
    {"depth", "no depth, sphere", SPHERE, DEPTH("none"), DRAW},
    {"depth", "depth only", SHAPE_SCREENS, 512, 32, "shader depth-only", DRAW},
    {"depth", "depth only, D16", SHAPE_SCREENS, 512, 32, "shader depth-only depth-format d16",
     DRAW},
    {"depth", "depth only, sphere", SPHERE, "shader depth-only", DRAW},
    {"depth", "no test", SCREENS, "depth.test off", DRAW},
    {"depth", "depth not written", SCREENS, "depth.write_disabled on", DRAW},
    {"depth", "LEQUAL", SCREENS, "depth.function less-or-equal", DRAW},
    {"depth", "GREATER, front to back", SCREENS,
     "front-to-back depth.function greater clear-depth 0", DRAW},
    {"depth", "hidden, LESS front to back", SHAPE_SCREENS, 512, 64, "front-to-back", DRAW},
    {"depth", "NOTEQUAL", SCREENS, "depth.function not-equal", DRAW},
    {"depth", "ALWAYS", SCREENS, "depth.function always", DRAW},
    {"depth", "NEVER", SHAPE_SCREENS, 512, 64, "depth.function never", DRAW},
    {"depth", "EQUAL after a first pass", SCREENS, "front-to-back again", DRAW},
    {"depth", "reversed, D32F", SCREENS,
     "depth-format d32f depth.clip_depth zero-to-one depth.function greater clear-depth 0 "
     "front-to-back",
     DRAW},
    {"depth", "depth range", SCREENS,
     "depth.range.set on depth.range.z_near 0.25 depth.range.z_far 0.75", DRAW},
    {"depth", "depth clamp, sphere", SPHERE, "shift 0 0 0.4 raster.cull none depth.clamp on", DRAW},

    {"blend", "alpha blend", SCREENS, OVER, DRAW},
    {"blend", "alpha blend, sphere", SPHERE, OVER, DRAW},
    {"blend", "premultiplied blend", SCREENS, BLEND("add", "one", "one-minus-source-alpha"), DRAW},
    {"blend", "additive blend", SCREENS, ADDED, DRAW},
    {"blend", "multiplied blend", SCREENS, BLEND("add", "zero", "source-color"), DRAW},
    {"blend", "screened blend", SCREENS, BLEND("add", "one-minus-destination-color", "one"), DRAW},
    {"blend", "subtracted blend", SCREENS, BLEND("reverse-subtract", "source-alpha", "one"), DRAW},
    {"blend", "min blend", SCREENS, BLEND("min", "one", "one"), DRAW},
    {"blend", "max blend", SCREENS, BLEND("max", "one", "one"), DRAW},
    {"blend", "constant blend", SCREENS,
     BLEND("add", "constant-color",
           "one-minus-constant-alpha") "color.blend_constant 0.25 0.5 0.75 0.5",
     DRAW},
    {"blend", "saturate blend", SCREENS, BLEND("add", "source-alpha-saturate", "one"), DRAW},
    {"blend", "destination alpha blend", SCREENS,
     BLEND("add", "destination-alpha", "one-minus-destination-alpha"), DRAW},
    {"blend", "separate alpha blend", SCREENS,
     OVER "color.blend[0].alpha_equation max color.blend[0].alpha_source one "
          "color.blend[0].alpha_destination one",
     DRAW},
    {"blend", "alpha blend, no depth", SCREENS, OVER DEPTH("none"), DRAW},
    {"blend", "alpha blend, depth not written", SCREENS, OVER "depth.write_disabled on", DRAW},
    {"blend", "alpha blend, BGRA8", SCREENS, OVER COLOR("bgra8"), DRAW},
    {"blend", "alpha blend, RGB565", FEW_SCREENS, OVER COLOR("rgb565"), DRAW},
    {"blend", "alpha blend, RGBA16F", FEW_SCREENS, OVER COLOR("rgba16f"), DRAW},
    {"blend", "alpha blend, RGBA16", FEW_SCREENS, OVER COLOR("rgba16"), DRAW},
    {"blend", "alpha blend, RGBA32F", FEW_SCREENS, OVER COLOR("rgba32f"), DRAW},
    {"blend", "alpha blend, R8", FEW_SCREENS, OVER COLOR("r8"), DRAW},
    {"blend", "alpha blend, RGB10_A2", FEW_SCREENS, OVER COLOR("rgb10-a2"), DRAW},
    {"blend", "additive blend of a texture", TEXTURED, ADDED, DRAW},
    {"blend", "alpha blend of a texture", TEXTURED, OVER, DRAW},

    {"logic", "XOR", SCREENS, LOGIC("xor"), DRAW},
    {"logic", "AND", SCREENS, LOGIC("and"), DRAW},
    {"logic", "INVERT", SCREENS, LOGIC("invert"), DRAW},
    {"logic", "OR_INVERTED", SCREENS, LOGIC("or-inverted"), DRAW},
    {"logic", "XOR, RGB565", SCREENS, LOGIC("xor") " color-format rgb565", DRAW},
    {"logic", "XOR, sphere", SPHERE, LOGIC("xor"), DRAW},

    {"masks", "red not written", SCREENS, "color.write_disabled[0] 1", DRAW},
    {"masks", "only alpha written", SCREENS, "color.write_disabled[0] 7", DRAW},
    {"masks", "no colour written", SCREENS, "color.write_disabled[0] 15", DRAW},
    {"masks", "mask and blend", SCREENS, OVER "color.write_disabled[0] 8", DRAW},
    {"masks", "red not written, RGB565", SCREENS, "color.write_disabled[0] 1 color-format rgb565",
     DRAW},

    {"stencil", "stencil test and increment", SCREENS,
     BOTH("less-or-equal", "increment") "clear-stencil 1", DRAW},
    {"stencil", "stencil test, equal", SCREENS, BOTH("equal", "keep") "clear-stencil 1", DRAW},
    {"stencil", "stencil test, hidden", SHAPE_SCREENS, 512, 64, BOTH("equal", "keep"), DRAW},
    {"stencil", "stencil increment, S8", SCREENS,
     "clear-stencil 1 " BOTH("always", "increment") "depth-format s8", DRAW},
    {"stencil", "stencil replace, D32FS8", SCREENS, BOTH("always", "replace") "depth-format d32fs8",
     DRAW},
    {"stencil", "stencil invert, masks", SCREENS,
     BOTH("not-equal", "invert") "stencil.front.write_disabled 240 stencil.back.write_disabled 240 "
                                 "stencil.front.compare_disabled 3 stencil.back.compare_disabled 3 "
                                 "clear-stencil 128",
     DRAW},
    {"stencil", "stencil, two-sided sphere", SPHERE,
     "raster.cull none depth-format d24s8 stencil.test on depth.write_disabled on " STENCIL(
         "front", "always", "increment-wrap") STENCIL("back", "always", "decrement-wrap"),
     DRAW},
    {"stencil", "stencil, shadow volume", SHAPE_SCREENS, 512, 32,
     "front-to-back depth-format d24s8 stencil.test on color.write_disabled[0] 15 "
     "depth.write_disabled on clear-depth 0.99 "
     "stencil.front.depth_fail decrement-wrap stencil.back.depth_fail increment-wrap",
     DRAW},
    {"stencil", "stencil increment, sphere", SPHERE, BOTH("always", "increment"), DRAW},

    {"samples", "4 samples", SHAPE_SCREENS, 512, 4, "samples 4", DRAW},
    {"samples", "4 samples, sphere", SHAPE_SPHERE, 512, 41, "samples 4", DRAW},
    {"samples", "4 samples, Phong", SHAPE_PHONG, 512, 22, "samples 4", DRAW},
    {"samples", "4 samples, texture", SHAPE_TEXTURED, 512, 4, "samples 4", DRAW},
    {"samples", "4 samples, alpha blend", SHAPE_SCREENS, 512, 4, "samples 4 " OVER, DRAW},
    {"samples", "4 samples, no depth", SHAPE_SCREENS, 512, 4, "samples 4 " DEPTH("none"), DRAW},
    {"samples", "4 samples, RGB565", SHAPE_SCREENS, 512, 4, "samples 4 " COLOR("rgb565"), DRAW},
    {"samples", "4 samples, RGBA16F", SHAPE_SCREENS, 512, 4, "samples 4 " COLOR("rgba16f"), DRAW},
    {"samples", "4 samples, stencil", SHAPE_SCREENS, 512, 4,
     "samples 4 " BOTH("always", "increment"), DRAW},
    {"samples", "4 samples, depth only", SHAPE_SCREENS, 512, 8, "samples 4 shader depth-only",
     DRAW},
    {"samples", "4 samples, alpha to coverage", SHAPE_SCREENS, 512, 4,
     "samples 4 alpha samples.alpha_to_coverage on", DRAW},
    {"samples", "4 samples, alpha to one", SHAPE_SCREENS, 512, 4,
     "samples 4 alpha samples.alpha_to_one on", DRAW},
    {"samples", "4 samples, mask", SHAPE_SCREENS, 512, 4, "samples 4 samples.write_disabled 5",
     DRAW},
    {"samples", "4 samples, lines", SHAPE_LINES, 512, 29, "samples 4", DRAW},

    {"attachments", "2 attachments", SHAPE_SCREENS, 512, 12, COLORS_2, DRAW},
    {"attachments", "4 attachments", SHAPE_SCREENS, 512, 8, COLORS_4, DRAW},
    {"attachments", "8 attachments", SHAPE_SCREENS, 512, 4,
     "shader outputs program.color_count 8 more-colors rgba8 rgba8 rgba8 rgba8 rgba8 rgba8 rgba8",
     DRAW},
    {"attachments", "4 attachments, blended", SHAPE_SCREENS, 512, 6,
     COLORS_4 OVER "color.blend[1].enabled on color.blend[1].source one "
                   "color.blend[1].destination one",
     DRAW},
    {"attachments", "G-buffer formats", SHAPE_SCREENS, 512, 8,
     "shader outputs program.color_count 4 more-colors rgba16f rgb10-a2 r32f none none none none",
     DRAW},
    {"attachments", "2 attachments, sphere", SPHERE, COLORS_2, DRAW},
    {"attachments", "1 of 2 attachments drawn", SHAPE_SCREENS, 512, 12,
     "more-colors rgba8 none none none none none none", DRAW},

    {"interpolation", "noperspective", SCREENS, INTERPOLATION("noperspective"), DRAW},
    {"interpolation", "noperspective, rolled", SHAPE_ROLLED, 512, 16,
     INTERPOLATION("noperspective"), DRAW},
    {"interpolation", "flat colours", SCREENS, INTERPOLATION("flat"), DRAW},
    {"interpolation", "flat colours, sphere", SPHERE, "shader flat", DRAW},
    {"interpolation", "mixed", SCREENS,
     "program.interpolation[0] flat program.interpolation[1] noperspective", DRAW},

    {"filters", "nearest", SAMPLED, "noise 2d rgba8 256 1 1 " NEAREST, DRAW},
    {"filters", "bilinear", SAMPLED, TEXELS("rgba8"), DRAW},
    {"filters", "bilinear, magnified", SAMPLED, "noise 2d rgba8 32 1 1 " BILINEAR, DRAW},
    {"filters", "nearest of nearest level", SAMPLED,
     "noise 2d rgba8 256 1 9 uniforms.sampler.magnify nearest "
     "uniforms.sampler.minify nearest-mipmap-nearest",
     DRAW},
    {"filters", "nearest of two levels", SAMPLED,
     "noise 2d rgba8 256 1 9 uniforms.sampler.magnify nearest "
     "uniforms.sampler.minify nearest-mipmap-linear",
     DRAW},
    {"filters", "bilinear of nearest level", SAMPLED,
     "noise 2d rgba8 256 1 9 " MINIFY("linear-mipmap-nearest"), DRAW},
    {"filters", "trilinear, bias", SAMPLED,
     "noise 2d rgba8 256 1 9 " MINIFY("linear-mipmap-linear") "uniforms.sampler.lod_bias 0.5",
     DRAW},
    {"filters", "trilinear, rolled sphere", PHONG,
     "noise 2d rgba8 256 1 9 " MINIFY("linear-mipmap-linear"), DRAW},
    {"filters", "anisotropic 4", SHAPE_SAMPLED, 256, 2,
     "noise 2d rgba8 128 1 8 stretch " MINIFY(
         "linear-mipmap-linear") "uniforms.sampler.max_anisotropy 4",
     DRAW},
    {"filters", "anisotropic 16", SHAPE_SAMPLED, 256, 2,
     "noise 2d rgba8 128 1 8 stretch " MINIFY(
         "linear-mipmap-linear") "uniforms.sampler.max_anisotropy 16",
     DRAW},
    {"filters", "clamp to edge", SAMPLED,
     TEXELS("rgba8") "uniforms.sampler.wrap_s clamp-to-edge uniforms.sampler.wrap_t clamp-to-edge",
     DRAW},
    {"filters", "mirrored repeat", SAMPLED,
     TEXELS(
         "rgba8") "uniforms.sampler.wrap_s mirrored-repeat uniforms.sampler.wrap_t mirrored-repeat",
     DRAW},
    {"filters", "clamp to border", SAMPLED,
     TEXELS(
         "rgba8") "uniforms.sampler.wrap_s clamp-to-border uniforms.sampler.wrap_t clamp-to-border "
                  "uniforms.sampler.border 1 0.5 0 1",
     DRAW},

    {"targets", "1D", SAMPLED, "noise 1d rgba8 256 1 1 " BILINEAR, DRAW},
    {"targets", "array", SAMPLED, "noise 2d-array rgba8 256 4 1 " BILINEAR, DRAW},
    {"targets", "array, trilinear", SAMPLED,
     "noise 2d-array rgba8 256 4 9 " MINIFY("linear-mipmap-linear"), DRAW},
    {"targets", "3D", SAMPLED, "noise 3d rgba8 64 64 1 " BILINEAR, DRAW},
    {"targets", "3D, nearest", SAMPLED, "noise 3d rgba8 64 64 1 " NEAREST, DRAW},
    {"targets", "3D, trilinear", SHAPE_SAMPLED, 512, 2,
     "noise 3d rgba8 64 64 7 " MINIFY("linear-mipmap-linear"), DRAW},
    {"targets", "cube, nearest", SAMPLED, "noise cube rgba8 128 1 1 " NEAREST, DRAW},
    {"targets", "cube, bilinear", SAMPLED, "noise cube rgba8 128 1 1 " BILINEAR, DRAW},
    {"targets", "shadow compare, nearest", SAMPLED,
     "noise 2d d24 256 1 1 " NEAREST "uniforms.sampler.compare less-or-equal", DRAW},
    {"targets", "shadow compare, bilinear", SAMPLED,
     "noise 2d d24 256 1 1 " BILINEAR "uniforms.sampler.compare less-or-equal", DRAW},
    {"targets", "shadow compare, D32F", SAMPLED,
     "noise 2d d32f 256 1 1 " BILINEAR "uniforms.sampler.compare less-or-equal", DRAW},
    {"targets", "shadow compare, cube", SAMPLED,
     "noise cube d24 128 1 1 " BILINEAR "uniforms.sampler.compare less-or-equal", DRAW},
    {"targets", "shadow compare, array", SAMPLED,
     "noise 2d-array d24 256 4 1 " BILINEAR "uniforms.sampler.compare less-or-equal", DRAW},
    {"targets", "depths, bilinear", SAMPLED, TEXELS("d24"), DRAW},

    {"texels", "R8 texels", SAMPLED, TEXELS("r8"), DRAW},
    {"texels", "RG8 texels", SAMPLED, TEXELS("rg8"), DRAW},
    {"texels", "RGB8 texels", SAMPLED, TEXELS("rgb8"), DRAW},
    {"texels", "BGRA8 texels", SAMPLED, TEXELS("bgra8"), DRAW},
    {"texels", "RGB565 texels", SAMPLED, TEXELS("rgb565"), DRAW},
    {"texels", "RGBA4 texels", SAMPLED, TEXELS("rgba4"), DRAW},
    {"texels", "RGB10_A2 texels", SAMPLED, TEXELS("rgb10-a2"), DRAW},
    {"texels", "RGBA16 texels", SAMPLED, TEXELS("rgba16"), DRAW},
    {"texels", "RGBA16F texels", SAMPLED, TEXELS("rgba16f"), DRAW},
    {"texels", "R32F texels", SAMPLED, TEXELS("r32f"), DRAW},
    {"texels", "RGBA32F texels", SAMPLED, TEXELS("rgba32f"), DRAW},
    {"texels", "R11F_G11F_B10F texels", SAMPLED, TEXELS("r11f-g11f-b10f"), DRAW},
    {"texels", "RGB32F texels", SAMPLED, TEXELS("rgb32f"), DRAW},
    {"texels", "sRGB texels", SAMPLED, TEXELS("srgb8-a8"), DRAW},
    {"texels", "sRGB texels, trilinear", SAMPLED,
     "noise 2d srgb8-a8 256 1 9 " MINIFY("linear-mipmap-linear"), DRAW},

    {"primitives", "points 1", SHAPE_POINTS, 512, 256, "", DRAW},
    {"primitives", "points 8", SHAPE_POINTS, 512, 160, "raster.point_size 8", DRAW},
    {"primitives", "points of the shader's sizes", SHAPE_POINTS, 512, 160,
     "sizes program.vertex_writes_point_size on", DRAW},
    {"primitives", "lines width 1", SHAPE_LINES, 512, 57, "", DRAW},
    {"primitives", "lines width 4", SHAPE_LINES, 512, 41, "raster.line_width 4", DRAW},
    {"primitives", "line strips", SHAPE_LINE_STRIPS, 512, 57, "", DRAW},
    {"primitives", "line loops", SHAPE_LINE_LOOPS, 512, 57, "", DRAW},
    {"primitives", "strips with restarts", SHAPE_STRIPS, 512, 73, "", DRAW},
    {"primitives", "one strip", SHAPE_ONE_STRIP, 512, 73, "", DRAW},
    {"primitives", "fans with restarts", SHAPE_FANS, 512, 72, "", DRAW},
    {"primitives", "16-bit indices", SPHERE, "index uint16", DRAW},
    {"primitives", "no indices", SHAPE_SPHERE, 512, 57, "index none", DRAW},
    {"primitives", "16 instances", SHAPE_SPHERE, 512, 17,
     "mesh.instance_count 16 mesh.attribute[1].divisor 1 depth.function less-or-equal", DRAW},
    {"primitives", "2,000 small draws", SHAPE_CUBES, 512, 2000, "", DRAW},
    {"primitives", "2,000 small draws, AUTO", SHAPE_CUBES, 512, 2000, "", DRAW_AUTO("")},
    {"primitives", "not culled", SPHERE, "raster.cull none", DRAW},
    {"primitives", "front culled", SPHERE, "raster.cull front", DRAW},
    {"primitives", "large triangles of a sphere", SHAPE_SPHERE, 2048, 17, "", DRAW},

    {"polygons", "wireframe sphere", SHAPE_SPHERE, 512, 41, POLYGONS("line"), DRAW},
    {"polygons", "polygons as points", SHAPE_SPHERE, 512, 57, POLYGONS("point"), DRAW},
    {"polygons", "polygon offset sphere", SPHERE,
     "raster.polygon_offset.set on raster.polygon_offset.factor 1 raster.polygon_offset.units 1",
     DRAW},
    {"polygons", "polygon offset screens", SCREENS,
     "raster.polygon_offset.set on raster.polygon_offset.factor 1 raster.polygon_offset.units 1",
     DRAW},

    {"clipping", "half clipped sphere", SPHERE, "shift 1 0 0", DRAW},
    {"clipping", "sphere cut by the near plane", SPHERE, "shift 0 0 0.4 raster.cull none", DRAW},
    {"clipping", "2 clip distances, sphere", SPHERE,
     "program.clip_distance_count 2 clip_plane[0] 1 0 0.25 0.5 clip_plane[1] 0 1 0 0.5", DRAW},
    {"clipping", "1 clip distance, screens", SCREENS,
     "program.clip_distance_count 1 clip_plane[0] 1 1 0 0.125", DRAW},
    {"clipping", "scissor, screens", SHAPE_SCREENS, 512, 32,
     "raster.scissor.set on raster.scissor.x 67 raster.scissor.y 35 raster.scissor.width 301 "
     "raster.scissor.height 413",
     DRAW},
    {"clipping", "scissor, sphere", SPHERE,
     "raster.scissor.set on raster.scissor.x 67 raster.scissor.y 35 raster.scissor.width 301 "
     "raster.scissor.height 413",
     DRAW},
    {"clipping", "viewport", SHAPE_SCREENS, 512, 24,
     "raster.viewport.set on raster.viewport.x 13.25 raster.viewport.y 40 "
     "raster.viewport.width 467.5 raster.viewport.height 400",
     DRAW},

    {"shaders", "unlit", SHAPE_SCREENS, 512, 16, "shader unlit", DRAW},
    {"shaders", "unlit with a texture", TEXTURED, "shader unlit", DRAW},
    {"shaders", "flat", PHONG, "shader faces plain", DRAW},
    {"shaders", "Gouraud with a point light", SPHERE, "point-light", DRAW},
    {"shaders", "textured Gouraud, sphere", PHONG, "shader textured-gouraud", DRAW},
    {"shaders", "toon", PHONG, "shader toon surface.bands 4", DRAW},
    {"shaders", "Phong without a texture", PHONG, "plain", DRAW},
    {"shaders", "trilinear Phong", PHONG, "noise 2d rgba8 256 1 9 " MINIFY("linear-mipmap-linear"),
     DRAW},
    {"shaders", "Phong with a point light", PHONG, "point-light", DRAW},
    {"shaders", "Phong with maps", PHONG,
     "map normal-map rgba8 map specular-map rgba8 "
     "map glow-map rgba8",
     DRAW},
    {"shaders", "Phong with a tangent map", PHONG,
     "map normal-map rgba8 tangents surface.normal_space tangents", DRAW},
    {"shaders", "Phong with a shadow map", PHONG, "map shadow-map d32f shadow", DRAW},
    {"shaders", "Phong as functions", SHAPE_USER, 768, 22, "phong_functions on", DRAW},
    {"shaders", "Blinn-Phong", PHONG, "shader blinn-phong", DRAW},
    {"shaders", "Phong with a spot light", PHONG,
     "point-light surface.has_spot_light on surface.cone 0.9 0.5 surface.light_range 10", DRAW},
    {"shaders", "Phong with four lights", PHONG,
     "surface.more_light_count 3 surface.more_lights[0].diffuse 0.5 0.25 0.25 "
     "surface.more_lights[0].direction 1 0 0 surface.more_lights[1].diffuse 0.25 0.5 0.25 "
     "surface.more_lights[1].direction 0 1 0 surface.more_lights[2].diffuse 0.25 0.25 0.5 "
     "surface.more_lights[2].kind point surface.more_lights[2].position 1 -1 2",
     DRAW},
    {"shaders", "Phong with a cut-off", PHONG, "surface.alpha_cutoff 0.5", DRAW},
    {"shaders", "metallic-roughness", PHONG,
     "shader metallic-roughness surface.metallic 0.5 surface.roughness 0.5", DRAW},
    {"shaders", "metallic-roughness with maps", PHONG,
     "shader metallic-roughness surface.metallic 1 surface.roughness 1 "
     "surface.normal_scale 1 surface.occlusion_strength 1 surface.emissive 1 1 1 "
     "map normal-map rgba8 tangents map metallic-roughness-map rgba8 map occlusion-map rgba8 "
     "map glow-map rgba8",
     DRAW},
    {"shaders", "normals as colours", SHAPE_PHONG, 1024, 29, "shader normal-color plain", DRAW},
    {"shaders", "depth as grey", SCREENS, "shader depth-color", DRAW},
    {"shaders", "derivatives", SCREENS, "shader derivatives", DRAW},

    {"fragments", "discard", SCREENS, "shader inputs alpha program.fragment_discards on", DRAW},
    {"fragments", "written depth", SCREENS, "shader inputs alpha program.fragment_writes_depth on",
     DRAW},
    {"fragments", "front facing", SCREENS, "shader inputs alpha", DRAW},
    {"fragments", "position", SCREENS, "shader inputs alpha program.fragment_reads_position on",
     DRAW},
    {"fragments", "primitive number", SCREENS,
     "shader inputs alpha program.fragment_reads_primitive on", DRAW},
    {"fragments", "point coordinates", SHAPE_POINTS, 512, 160,
     "raster.point_size 8 shader inputs alpha program.fragment_reads_point_coordinate on", DRAW},
    {"fragments", "written sample mask", SHAPE_SCREENS, 512, 4,
     "samples 4 shader inputs alpha program.fragment_writes_sample_mask on", DRAW},
    {"fragments", "discard, sphere", SPHERE, "shader inputs alpha program.fragment_discards on",
     DRAW},

    {"clears", "clear colour and depth", SHAPE_NOTHING, 2048, 0, "", DRAW},
    {"clears", "clear colour", SHAPE_NOTHING, 2048, 0, DEPTH("none"), DRAW},
    {"clears", "clear RGB565 and D16", SHAPE_NOTHING, 2048, 0,
     "color-format rgb565 depth-format d16", DRAW},
    {"clears", "clear RGBA16F and D32F", SHAPE_NOTHING, 2048, 0,
     "color-format rgba16f depth-format d32f", DRAW},
    {"clears", "clear RGB8 and D24S8", SHAPE_NOTHING, 2048, 0,
     "color-format rgb8 depth-format d24s8", DRAW},
    {"clears", "clear 4 samples", SHAPE_NOTHING, 1024, 0, "samples 4", DRAW},

    {"blits", "blit", SHAPE_SCREENS, 4096, 2, "", BLIT("")},
    {"blits", "blit D24S8", SHAPE_SCREENS, 4096, 2, "depth-format d24s8",
     BLIT("color-format none depth-format d24s8")},
    {"blits", "blit RGBA8 to RGB565", SHAPE_SCREENS, 1024, 2, "", BLIT(COLOR("rgb565"))},
    {"blits", "blit RGBA16F to RGBA8", SHAPE_SCREENS, 1024, 2, COLOR("rgba16f"),
     BLIT(COLOR("rgba8"))},
    {"blits", "blit RGBA8 to sRGB", SHAPE_SCREENS, 1024, 2, "", BLIT(COLOR("srgb8-a8"))},
    {"blits", "blit scaled, nearest", SHAPE_SCREENS, 1024, 2, "", BLIT("size 700 1300")},
    {"blits", "blit scaled, linear", SHAPE_SCREENS, 1024, 2, "", BLIT_LINEAR("size 700 1300")},
    {"blits", "blit scaled, linear, RGB565", SHAPE_SCREENS, 1024, 2, COLOR("rgb565"),
     BLIT_LINEAR("size 700 1300")},
    {"resolves", "resolve RGBA8", SHAPE_SCREENS, 1024, 2, "samples 4", RESOLVE("")},
    {"resolves", "resolve sRGB", SHAPE_SCREENS, 1024, 2, "samples 4 color-format srgb8-a8",
     RESOLVE("")},
    {"resolves", "resolve RGBA16F", SHAPE_SCREENS, 1024, 2, "samples 4 color-format rgba16f",
     RESOLVE("")},
    {"resolves", "resolve D32F", SHAPE_SCREENS, 1024, 2, "samples 4 depth-format d32f",
     RESOLVE("color-format none depth-format d32f")},
    {"levels", "levels of 2D", SHAPE_SAMPLED, 64, 2, "noise 2d rgba8 1024 1 11", LEVELS},
    {"levels", "levels of sRGB", SHAPE_SAMPLED, 64, 2, "noise 2d srgb8-a8 1024 1 11", LEVELS},
    {"levels", "levels of odd size", SHAPE_SAMPLED, 64, 2, "noise 2d rgba8 999 1 10", LEVELS},
    {"levels", "levels of RGB565", SHAPE_SAMPLED, 64, 2, "noise 2d rgb565 1024 1 11", LEVELS},
    {"levels", "levels of RGBA16F", SHAPE_SAMPLED, 64, 2, "noise 2d rgba16f 1024 1 11", LEVELS},
    {"levels", "levels of a cube", SHAPE_SAMPLED, 64, 2, "noise cube rgba8 512 1 10", LEVELS},
    {"levels", "levels of 3D", SHAPE_SAMPLED, 64, 2, "noise 3d rgba8 128 128 8", LEVELS},

    {GROUP_FIXED, "nothing", SHAPE_NOTHING, 8, 0, "", DRAW},
    {GROUP_FIXED, "one cube", SHAPE_CUBES, 8, 1, "", DRAW},
};

const size_t single_state_count = sizeof single_states / sizeof *single_states;
