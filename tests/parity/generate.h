/* Random scenes for the comparison with the reference, by class. A scene is a pure
 * function of seed, class and number. */
#ifndef PARITY_GENERATE_H
#define PARITY_GENERATE_H

#include "scene.h"

typedef enum scene_class {
    CLASS_TINY,              /* triangles smaller than a few pixels */
    CLASS_SLIVERS,           /* long and thin */
    CLASS_TIES,              /* vertices and edges on pixel centres and their halves */
    CLASS_HUGE,              /* up to 1e5 pixels and more */
    CLASS_OFFSCREEN,         /* mostly outside the view volume, some on its border */
    CLASS_BEHIND,            /* some w below 0 */
    CLASS_NEAR_CROSSING,     /* the camera is inside the scene */
    CLASS_DEGENERATE,        /* no area, repeated and collinear vertices, w = 0 */
    CLASS_MESHES,            /* shared edges: grids and fans around points */
    CLASS_PILES,             /* overlapping, depth tested, equal depths, interpenetrating */
    CLASS_FILLS,             /* layers over the whole target, level and rolled, many opaque */
    CLASS_STRIPS,            /* strips and fans, leftover vertices */
    CLASS_FRAMEBUFFERS,      /* odd sizes, fractional viewports */
    CLASS_DEPTH_STATE,       /* formats, functions, write mask, ranges */
    CLASS_CULLING,           /* culling, winding, provoking vertex */
    CLASS_SEGMENTS,          /* slivers in draws longer than a segment of the reference */
    CLASS_INTERPOLATION,     /* smooth, noperspective, flat, w differing strongly */
    CLASS_INDEXED,           /* 8, 16 and 32 bit indices, offsets, unused vertices */
    CLASS_LIT,               /* flat and Gouraud shading under rotations */
    CLASS_TEXTURED,          /* textures of all sizes, formats, wraps and filters */
    CLASS_TEXTURES,          /* one level: 2D and 1D, all formats, wraps, filters */
    CLASS_MIPMAPS,           /* levels of detail of 2D and 1D textures */
    CLASS_VOLUMES,           /* 3D textures and 2D arrays */
    CLASS_CUBES,             /* cubes, whose filters reach over edges */
    CLASS_SHADOWS,           /* depths compared in lookups */
    CLASS_PHONG,             /* a user's shader: textured, a highlight at every pixel */
    CLASS_SHADERS,           /* the ready-made shaders with all maps and lights */
    CLASS_SHADOWED,          /* the shaders that light pixels, with a shadow map */
    CLASS_INPUTS,            /* facing, primitive, position; discard, depth written by the shader */
    CLASS_DERIVATIVES,       /* differences in quads, also at edges of triangles and targets */
    CLASS_STENCIL,           /* both faces, all functions, operations and masks */
    CLASS_COUNTING,          /* samples passed, with discard, depth and stencil */
    CLASS_FLOAT_COLOR,       /* RGBA32F */
    CLASS_COLOR_RANGE,       /* colours outside 0..1 in RGBA8 */
    CLASS_SCISSOR,           /* a rectangle of pixels, in blocks and strips, empty, outside */
    CLASS_OFFSET,            /* polygon offset */
    CLASS_COLOR_MASK,        /* channels that are not written */
    CLASS_BLEND,             /* factors, equations, separate alpha, constants */
    CLASS_FLOAT_BLEND,       /* blending in RGBA32F, R32F, RGBA16F */
    CLASS_LOGIC,             /* logical operations on colours */
    CLASS_CLIP_DEPTH,        /* depth clamp, clip depths from 0 to 1 */
    CLASS_POINTS,            /* sizes of the state and of the vertex shader */
    CLASS_LINES,             /* separate, strips and loops, of all widths */
    CLASS_POINT_COORDINATES, /* where in its point a fragment is */
    CLASS_FORMATS,           /* every colour format, at the limits of its conversion */
    CLASS_INSTANCES,         /* instances, base vertex, primitive restart */
    CLASS_CLIP_DISTANCE,     /* the user's clip distances */
    CLASS_OUTLINES,          /* triangles drawn as lines and points, by face */
    CLASS_ATTACHMENTS,       /* several colours, holes, each with its own blending and mask */
    CLASS_SAMPLES,           /* several samples a pixel */
    CLASS_MASKS,             /* sample masks that shaders read and write */
    CLASS_MIXED,             /* several draws, each of one of the classes above */
    CLASS_SEQUENCES,         /* 7 to 20 draws, all states at random, clears between some */
    CLASS_BATCHES,           /* overlapping triangles that share batches, in every kind of state */
    CLASS_BATCH_ENDS,        /* batches that end within a triangle, a row or a draw */
    CLASS_SAMPLE_SHADING,    /* shaders that run for each sample; centroids */
    CLASS_MATERIALS,   /* ready-made shaders with cut-offs of alpha, several lights; glTF's material
                        */
    CLASS_UPSIDE_DOWN, /* scenes of the other classes under viewports of negative height */
    CLASS_COUNT
} scene_class;

/* "tiny" and so on. */
const char *scene_class_name(scene_class c);

/* The class of this name, CLASS_COUNT if there is none. */
scene_class scene_class_of(const char *name);

/* The caller frees the scene. */
scene *generate_scene(uint64_t seed, scene_class c, uint64_t number);

#endif
