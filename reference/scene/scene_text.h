/* Scenes as text: each line is a keyword with its values; bulk data are bare values.
 *
 *   gnomon-scene 1
 *   size 64 48
 *   color-format rgba8
 *   more-colors none r8 none none none none none   (attachments 1 to 7, where there are some)
 *   depth-format d24
 *   clear-color 0x0p+0 0x0p+0 0x0p+0 0x1p+0
 *   clear-depth 0x1p+0
 *   draw vertex-color
 *     depth.test on
 *     depth.function less-or-equal
 *     color.blend[2].source one-minus-source-alpha
 *     uniforms.light.ambient 0x1p-2 0x1p-2 0x1p-1
 *     ...
 *     vertices 3
 *     position 3
 *       (3 times 3 floats)
 *     indices uint8 3
 *       0 1 2
 *     elements 0 3
 *     texture cube srgb8-a8 2 2 1 2   (target, format, width, height, depth, levels)
 *       ff0000ff ...                  (24 texels, then 6)
 *   end-draw
 *   end-scene
 *
 * Most keywords of a draw are the members of scene_draw (scene_members.c); members of `state` are
 * written without that word. Members that are left out have the values of scene_default_draw.
 * Floats are C's hexadecimal floats, which are exact; a NaN is written as its bits, nan:7fc00000.
 * Texels are the elements of surface.h in hexadecimal, floats as their bits. Keywords of a draw may
 * stand in any order, except that attributes follow `vertices`, and `elements` follows the
 * positions and the indices. A comment begins with # and ends with the line. */
#ifndef SCENE_TEXT_H
#define SCENE_TEXT_H

/* The enumerations that have names in the text. */
typedef enum text_names {
    TEXT_SHADER,
    TEXT_FORMAT,
    TEXT_TOPOLOGY,
    TEXT_PROVOKING,
    TEXT_CULL,
    TEXT_FRONT_FACE,
    TEXT_COMPARE,
    TEXT_STENCIL_OPERATION,
    TEXT_INTERPOLATION,
    TEXT_LOCATION,
    TEXT_INDEX,
    TEXT_RESTART,
    TEXT_ATTRIBUTE,
    TEXT_SWITCH,
    TEXT_WRAP,
    TEXT_MAGNIFY,
    TEXT_MINIFY,
    TEXT_FACTOR,
    TEXT_EQUATION,
    TEXT_LOGIC,
    TEXT_CLIP_DEPTH,
    TEXT_POINT_ORIGIN,
    TEXT_POLYGON_MODE,
    TEXT_TEXTURE_TARGET,
    TEXT_NORMAL_SPACE,
    TEXT_LIGHT_KIND,
    TEXT_MAP
} text_names;

/* Returns the number of names of an enumeration; they belong to the values from 0 on. */
int text_name_count(text_names set);

/* Returns the name of a value, "invalid" if it has none. */
const char *text_name(text_names set, int value);

/* Returns the value of a name, -1 if there is none. */
int text_value(text_names set, const char *name);

#endif
