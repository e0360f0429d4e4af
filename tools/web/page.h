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

/* Memory for arguments. Returns null if there is none. */
void *page_allocate(uint32_t bytes);
void page_free(void *memory);

/* Why the last call failed, in one sentence; empty if it did not. */
const char *page_message(void);

/* State. A state is text of the form "model=teapot&shader=phong&samples=4"; keys that are missing
 * have their defaults. It is what the page's URL holds behind its "#".
 *
 *   model       teapot, triangle, square, cube; dropped: the model of page_model_...
 *   size        WIDTHxHEIGHT, 1x1 to 4096x4096; default 640x480
 *   shader      as `gnomon render --shader`, but not metallic-roughness; default phong, but unlit
 * for materials that say so maps        on, off: the maps of the model; default on filter nearest,
 * linear, mipmap; default mipmap, but the model's filters where it has some samples     1, 4
 *   polygons    fill, line, point; default fill
 *   cull        none, back, front; default none, but back for materials that say so
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

/* The model that is called "dropped", from files that were dropped on the page. page_model_begin
 * forgets the one before. Then page_model_file takes each file, the first as number 0, and returns
 * memory for its bytes, which must be written; null if there is not enough. Images are needed
 * only by name, so their size may be 0. page_model_read reads the one file among them that is a
 * model (OBJ, PLY, STL, glTF), and those that it names, which are found by their names without
 * folders. page_model_describe then returns as JSON
 *
 *   {"name": "box.obj", "parts": N, "vertices": N, "triangles": N, "lines": N, "points": N,
 *    "warnings": ["box.obj: line 4: ..."],
 *    "images": [{"number": N, "name": "wood.png", "file": N},           a file, by its number
 *               {"number": N, "name": "wood", "at": ADDRESS, "size": N}]}   inside the model
 *
 * or an empty text with the reason in page_message(). For each of these images page_model_image
 * returns memory for its RGBA8 texels, to be written, the top row first; null if they are too many.
 * A map whose image is not given is left out. page_model_end completes the maps; then the warnings
 * are complete too. A model whose coordinates are large lies around its own origin. */
void page_model_begin(void);
uint8_t *page_model_file(const char *name, uint32_t size);
int page_model_read(void);
const char *page_model_describe(void);
uint32_t *page_model_image(uint32_t number, uint32_t width, uint32_t height);
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
 *                                  others; with the same number they are where they were, but
 *                                  the indices of draws that mix may have another order
 *    "width": W, "height": H, "samples": 1, "clear": [r,g,b,a],
 *    "zeroToOne": false,            clip space's depth range: 0..w instead of -w..w
 *    "topDown": false,              the convention's y points down in clip space
 *    "light": {"direction": [x,y,z], "ambient": [r,g,b], "diffuse": [r,g,b]},
 *    "draws": [{                    in the order of drawing
 *      "mesh": N,                   a number of its own, which it keeps while "contents" stays
 *      "shader": "vertex-color",    as --shader, or "gouraud" with a texture
 *      "topology": "triangles",     or "lines", "points"
 *      "polygons": "fill", "cull": "none", "frontClockwise": false, "depthTest": true,
 *      "depthWrite": true,
 *      "blend": "none",             "mix": colours are mixed by the source's alpha; "cut": they are
 *                                   the source's. In both, the source's alpha is added to the
 *                                   target's, times one minus the source's
 *      "alphaCutoff": 0,            fragments whose alpha is below it are discarded
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
 *      "sampler": {"wrapS": "repeat", "wrapT": "clamp-to-edge", "minify": "linear-mipmap-linear",
 *                  "magnify": "linear"}}]}                     of all maps but the shadow; the
 *                                                              names are those of gn_wrap,
 *                                                              gn_minify and gn_magnify; the
 *                                                              border is white
 */
const char *page_describe(void);

#endif
