/* A pixel taken apart: the primitives with fragments there, traced through the library's own stages
 * (stages.h). */
#ifndef EXPLAIN_H
#define EXPLAIN_H

#include "scene.h"
#include "prose.h"

/* What a scene does not say. With `is_known`, the camera's matrix from world to view coordinates,
 * and the draws' matrices from model to world coordinates are right for every shader. With
 * `y_down`, as Vulkan has it, row 0 of the scene is the top row of the picture. */
typedef struct explain_view {
    bool is_known, y_down;
    gn_mat4 view_from_world;
} explain_view;

/* A primitive, as the report numbers it: the first one of a draw is 0. */
typedef struct explain_primitive {
    uint32_t draw, primitive;
} explain_primitive;

/* What was found out, beside the report. Colours and words are those of GN_FORMAT_RGBA8. */
typedef struct explained {
    uint32_t x, y; /* from the left and from the bottom of the picture */
    uint32_t row;  /* of the scene: y, or with y_down counted from the top */
    uint32_t width, height, samples;
    uint32_t word;       /* as the traced stages left it; with samples, resolved */
    uint32_t drawn_word; /* as gn_draw leaves it */
    uint32_t sample_word[4];
    uint32_t fragments; /* that were found */
    uint32_t nodes;     /* operations that were evaluated anew */
    uint32_t faults;    /* checks that failed: 0 if all is well */
} explained;

/* Explains the pixel that lies x pixels from the left and y from the bottom of the picture. `view`
 * may be null: nothing is known. `asked` may be null; if this primitive has no fragment at the
 * pixel, the report says why. Returns null, or why it cannot, in words: the pixel lies outside,
 * memory ran out, or the scene has a format or a topology that is not explained. The report
 * (explain_text, explain_json) is good until the next call. */
const char *explain_pixel(const scene *s, uint32_t x, uint32_t y, const explain_view *view,
                          const explain_primitive *asked, explained *out);

/* Returns how many primitives a draw of a scene has; 0 if its topology is not explained. */
uint32_t explain_primitives(const scene_draw *draw);

/* Writes the report for readers, and as JSON. Each fragment is an object; "missing" is there if the
 * primitive that was asked for has no fragment: an object with the same members, whose result is
 * the reason.
 *
 *   {"pixel": [x,y], "size": [w,h], "color": "8 hexadecimal digits of the stored word",
 *    "text": "the text of explain_text",
 *    "fragments": [{"draw": 0, "primitive": 12, "kind": "triangle", "result": "written",
 *      "corners": [[X,Y],...],      snapped, in 1/256 pixel; (0,0) is the centre of pixel (0,0),
 *                                     with rows counted from the bottom
 *      "stages": [{"name": "Vertex 1 of 3", "values":
 *        [{"name": "v1.clip.x", "value": "0.25", "bits": "3e800000", "expression": "..."}]}]}],
 *    "missing": {"draw": 0, "primitive": 13, ...}} */
void explain_text(const explained *e, prose *out);
void explain_json(const explained *e, prose *out);

void explain_free(void);

#endif
