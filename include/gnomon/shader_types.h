/** @file
 * What shader functions (gnomon/shader_functions.h) take and return: one vertex, one fragment, one
 * lookup in a texture. */
#ifndef GNOMON_SHADER_TYPES_H
#define GNOMON_SHADER_TYPES_H

#include "pipeline.h"
#include "shader_vectors.h"

/** The most texels that a fragment function can look up. */
#define GN_MAX_SHADER_TEXTURES 8

/** One vertex. */
typedef struct gn_vertex {
    gn_vec4 attribute[GN_MAX_ATTRIBUTES]; /**< 0, 0, 0, 1 where the mesh has none */
    uint32_t present;                     /**< bit a: the mesh has attribute a */
    uint32_t vertex_id;                   /**< position in the mesh's arrays */
    uint32_t instance;                    /**< from 0 on */

    float point_size; /**< beforehand raster.point_size; 0 if vertex_writes_point_size is off */
    float clip_distance[GN_MAX_CLIP_DISTANCES]; /**< beforehand 0, which clips nothing */
} gn_vertex;

/** One fragment. */
typedef struct gn_fragment {
    gn_vec4 texel[GN_MAX_SHADER_TEXTURES]; /**< the results of the lookups */
    gn_vec4 position;                      /**< gl_FragCoord; 0, 0, 0, 0 if not switched on */
    gn_vec2 point_coordinate;              /**< gl_PointCoord; 0, 0 if not switched on */
    uint32_t primitive_id;                 /**< gl_PrimitiveID */
    uint32_t covered_samples;              /**< gl_SampleMaskIn; 0 if not switched on */
    uint32_t sample_id;                    /**< gl_SampleID; 0 if it runs for each pixel */
    gn_vec2 sample_position;               /**< gl_SamplePosition; 0.5, 0.5 if for each pixel */
    bool front_facing;                     /**< gl_FrontFacing */

    /** Colours from the second on, beforehand 0. The first colour is the function's result. */
    gn_vec4 color[GN_MAX_COLORS];
    float depth;          /**< beforehand the interpolated depth; 0 if not switched on */
    uint32_t sample_mask; /**< beforehand every bit is set */
    bool discard;         /**< beforehand false */
} gn_fragment;

/** Where a texture is looked up for one fragment; made by the functions below. All members but
 * coordinate, reference and lod must be equal in all fragments of a draw. */
typedef struct gn_texel_lookup {
    const gn_texture *texture; /**< what is looked up */
    const gn_sampler *sampler; /**< how it is looked up */
    gn_vec3 coordinate;        /**< s, t, r; or a direction; or s, t and the layer's number */
    float reference;           /**< what a depth texture is compared with */
    float lod;                 /**< the level of detail, or a bias */
    gn_lod_source lod_source;  /**< what `lod` is */
    bool is_2d;                /**< 2D, with neither `lod` nor `reference` */
    bool has_lod;              /**< `lod` counts; these two are set by the functions below */
} gn_texel_lookup;

/** Returns the attribute of a vertex, or `other` if the mesh has none. */
static inline gn_vec4 gn_attribute_or(const gn_vertex *vertex, uint32_t attribute, gn_vec4 other)
{
    return gn_select4((vertex->present >> attribute & 1u) != 0, vertex->attribute[attribute],
                      other);
}

/** Returns a lookup in a texture of any target, GLSL's texture(). The coordinate is s, t, r, or a
 * direction, or s, t and a layer's number. With a library compiled with both GN_SMALL and
 * GN_BASIC a shader must take gn_lookup_2d, and change nothing in what that returns. */
static inline gn_texel_lookup gn_lookup_any(const gn_texture *texture, const gn_sampler *sampler,
                                            gn_vec3 coordinate)
{
    gn_texel_lookup lookup;

    lookup.texture = texture;
    lookup.sampler = sampler;
    lookup.coordinate = coordinate;
    lookup.reference = 0.0f;
    lookup.lod = 0.0f;
    lookup.lod_source = GN_LOD_IMPLICIT;
    lookup.is_2d = false;
    lookup.has_lod = false;
    return lookup;
}

/** Returns a lookup in a texture of target GN_TEXTURE_2D. */
static inline gn_texel_lookup gn_lookup_2d(const gn_texture *texture, const gn_sampler *sampler,
                                           gn_vec2 coordinate)
{
    gn_texel_lookup lookup =
        gn_lookup_any(texture, sampler, gn_make3(coordinate.x, coordinate.y, 0.0f));

    lookup.is_2d = true;
    return lookup;
}

/** Returns the lookup with its depths compared with a reference: shadow maps. */
static inline gn_texel_lookup gn_lookup_compared(gn_texel_lookup lookup, float reference)
{
    lookup.reference = reference;
    lookup.is_2d = false;
    return lookup;
}

/** Returns the lookup with the level of detail raised by a bias: GLSL's texture() with a bias. */
static inline gn_texel_lookup gn_lookup_bias(gn_texel_lookup lookup, float bias)
{
    lookup.lod = bias;
    lookup.has_lod = true;
    lookup.is_2d = false;
    return lookup;
}

/** Returns the lookup at a given level of detail: GLSL's textureLod(). */
static inline gn_texel_lookup gn_lookup_lod(gn_texel_lookup lookup, float lod)
{
    lookup.lod = lod;
    lookup.has_lod = true;
    lookup.lod_source = GN_LOD_EXPLICIT;
    lookup.is_2d = false;
    return lookup;
}

#endif
