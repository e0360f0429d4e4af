/* The picture of the web page: its state as keys and values, its model, its drawing. The page's
 * JavaScript calls these functions in a WebAssembly module; tests and `gnomon explain --state` call
 * them natively, so that a state has the same scene everywhere. There is one picture per module or
 * program.
 *
 * A function that returns int returns 0, or 1 with the reason in page_message(). Pointers to texts
 * and arrays are good until the next call that changes what they describe. */
#ifndef PAGE_H
#define PAGE_H

#include <stdint.h>

#include "camera.h"
#include "scene.h"

/* Memory for arguments and for arrays of a model. Returns null if there is none. */
void *page_allocate(uint32_t bytes);
void page_free(void *memory);

/* Why the last call failed, in one sentence; empty if it did not. */
const char *page_message(void);

/* State. A state is text of the form "model=teapot&shader=phong&samples=4"; keys that are missing
 * have their defaults. It is what the page's URL holds behind its "#".
 *
 *   model       teapot, triangle, square, cube; dropped: the model that page_model_... describes
 *   size        WIDTHxHEIGHT, 1x1 to 4096x4096; default 640x480
 *   shader      as `gnomon render --shader`; default phong
 *   maps        on, off: the maps of the model; default on
 *   filter      nearest, linear, mipmap; default mipmap
 *   samples     1, 4
 *   polygons    fill, line, point; default fill
 *   cull        none, back, front; default none
 *   shadows     on, off; default off
 *   bands       of the toon shader, 2 to 255; exponent: of highlights, 1 to 1024
 *   convention  opengl, direct3d, vulkan: the projection and the range of depth that the names
 *               stand for; default opengl
 *   fov         degrees; default 35
 *   near, far   distances; default: around the model
 *   eye, target X,Y,Z; default: chosen so that the model is framed
 *
 * page_set changes one key; an empty value means the default. page_set_state replaces all. Both
 * leave the state as it was if a key or a value is wrong. page_state returns the canonical text:
 * keys in the order above, defaults left out, numbers with as many digits as restore their bits. */
int page_set(const char *key, const char *value);
int page_set_state(const char *state);
const char *page_state(void);

/* The camera, moved as by a hand in a window (orbit.h); these set eye and target. */
int page_turn(int right, int down);
int page_pan(int right, int down);
int page_zoom(int steps);

/* The model that is called "dropped". page_model_begin forgets the one before and says how many
 * parts will come. For each part page_model_part returns 0, and the arrays below can be written:
 * positions (x, y, z), normals (x, y, z; zeros are completed), texcoords (s, t; null if the part
 * has none), indices (three per triangle). page_model_color and page_model_map belong to the part
 * that was begun last; page_model_map returns RGBA8 texels to be written, the top row first, or
 * null. page_model_end checks everything (indices, finite numbers) and completes normals and
 * tangents. */
int page_model_begin(uint32_t parts);
int page_model_part(uint32_t vertices, uint32_t indices, int has_texcoords);
float *page_model_positions(void);
float *page_model_normals(void);
float *page_model_texcoords(void);
uint32_t *page_model_indices(void);
int page_model_color(float red, float green, float blue, float alpha);
int page_model_shine(float red, float green, float blue, uint32_t exponent);
uint32_t *page_model_map(uint32_t kind, uint32_t width, uint32_t height); /* map_kind */
int page_model_end(void);

/* Makes the scene of the state. Every function below needs it; every function above undoes it. */
int page_build(void);

/* For native callers, not exported by the modules: the scene and its camera, null if it is not
 * built; and the back end to draw with, which is otherwise the best one. After page_use_backend the
 * scene must be built again. If the camera's y_down is set, row 0 of the scene's frame is the top
 * row of the picture. */
const scene *page_scene(void);
const camera *page_camera(void);
void page_use_backend(gn_backend backend);

/* Clears and draws rows `from` up to, but not including, `end`, counted from the bottom. Other rows
 * of the picture are unspecified. Samples are resolved. So several instances of a module draw one
 * picture in bands; the pixels are those of one call with all rows. */
int page_draw(uint32_t from, uint32_t end);

/* The drawn picture: RGBA8, 4 bytes a pixel in the order red, green, blue, alpha; the bottom row
 * first, as WebGL's readPixels returns it. Depths are floats. */
uint32_t page_width(void);
uint32_t page_height(void);
const uint8_t *page_color(void);
const float *page_depth(void);

/* The hash of a picture of this size as 16 hexadecimal digits: FNV-1a of 64 bits over width,
 * height (4 bytes each, the low byte first) and the bytes of page_color's form. */
const char *page_hash(const uint8_t *color, uint32_t width, uint32_t height);

/* The back end that draws ("wasm-simd128"), and the library's version. */
const char *page_backend(void);
const char *page_version(void);

/* What another renderer needs to draw the same scene, as JSON. Addresses are bytes in the module's
 * memory. Matrices are 16 or 9 numbers, column-major. Texts are those of the state.
 *
 *   {"contents": N,                another number than before if attributes, indices or maps may be
 *                                  others; with the same number they are where they were
 *    "width": W, "height": H, "samples": 1, "clear": [r,g,b,a],
 *    "zeroToOne": false,            clip space's depth range: 0..w instead of -w..w
 *    "topDown": false,              the convention's y points down in clip space
 *    "light": {"direction": [x,y,z], "ambient": [r,g,b], "diffuse": [r,g,b]},
 *    "draws": [{
 *      "shader": "vertex-color",    as --shader, or "gouraud" with a texture
 *      "polygons": "fill", "cull": "none", "frontClockwise": false, "depthTest": true,
 *      "clipFromModel": [16], "worldFromModel": [16], "normalMatrix": [9], "eye": [x,y,z],
 *      "lightDirection": [x,y,z],   the light's direction for this draw: negative for the
 *                                   flat shader if y points down, because its normals, the
 *                                   product of derivatives, are negative then
 *      "specular": [r,g,b], "exponent": 40, "bands": 4, "normalsOfTangents": true,
 *      "black": 0, "white": 1,      the depth shader's
 *      "vertices": N,
 *      "attributes": {"position": {"at": ADDRESS, "components": 3}, "normal": ..., "color": ...,
 *                     "texcoord": ..., "tangent": ...},        those that the mesh has
 *      "indices": {"at": ADDRESS, "count": N},                 32-bit
 *      "maps": {"diffuse": {"at": ADDRESS, "width": W, "height": H, "levels": L}, "normal": ...,
 *               "specular": ..., "glow": ..., "shadow": ...},  levels one after the other, the
 *                                                              lowest row first; RGBA8, shadow
 *                                                              32-bit floats
 *      "shadowFromWorld": [16],
 *      "filter": "mipmap"}]}
 */
const char *page_describe(void);

#endif
