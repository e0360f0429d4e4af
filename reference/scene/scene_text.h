/* Scenes as text: one keyword with its values per line, bulk data as bare values.
 *
 *    gnomon-scene 1
 *    size 64 48
 *    color-format rgba8
 *    more-colors none r8 none none none none none   (attachments 1 to 7, if there are some)
 *    depth-format d24
 *    clear-color 0x0p+0 0x0p+0 0x0p+0 0x1p+0
 *    clear-depth 0x1p+0
 *    draw vertex-color
 *      topology triangles
 *      ...
 *      vertices 3
 *      position 3
 *        (3 times 3 floats)
 *      indices uint8 3
 *        0 1 2
 *      elements 0 3
 *      texture rgba8 2 2
 *        ff0000ff ...
 *      texture-levels cube srgb8-a8 2 2 1 2
 *        (instead of texture: target, format, width, height, depth, levels; 24 texels, then 6)
 *    end-draw
 *    end-scene
 *
 * Floats are C's hexadecimal floats, which are exact. A NaN is written with its bits, as
 * nan:7fc00000. Texels are the hexadecimal elements of surface.h; texels of floats are written as
 * their bits. Keywords of a draw may be in any order, except that attributes follow `vertices`.
 * Keywords left out have the values of scene_add_draw. # starts a comment that ends with the
 * line. */
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
    TEXT_MAP
} text_names;

/* The number of names of an enumeration; they belong to the values from 0 on. */
int text_name_count(text_names set);

/* The name of a value, "invalid" if it has none. */
const char *text_name(text_names set, int value);

/* The value of a name, -1 if there is none. */
int text_value(text_names set, const char *name);

#endif
