/* Parsers of the values of options. Each returns false if the text is not such a value as a
 * whole. */
#ifndef OPTION_VALUES_H
#define OPTION_VALUES_H

#include "options.h"

/* A finite float; three, separated by commas. */
bool parse_single(const char *text, float *result);
bool parse_vector(const char *text, gn_vec3 *result);

/* Whether the text is a list of numbers one of which is not finite as a float. */
bool parse_has_infinite(const char *text);

/* A whole number of digits only, from `least` to `most`. */
bool parse_within(const char *text, uint32_t least, uint32_t most, uint32_t *result);

/* A whole number of digits only; numbers beyond 32 bits become UINT32_MAX. */
bool parse_whole(const char *text, uint32_t *result);

/* WIDTHxHEIGHT. */
bool parse_size(const char *text, uint32_t *width, uint32_t *height);

/* X,Y. */
bool parse_pixel(const char *text, uint32_t *x, uint32_t *y);

/* #rrggbb or #rrggbbaa. The # may be left out, since shells take it for a comment. */
bool parse_color(const char *text, float color[4]);

/* The number of a word in a list. */
bool parse_word(const char *text, const char words[][12], int count, int *result);

/* A file name, or `none`. */
bool parse_map(const char *text, map_option *result);

/* `none`, or which of the existing maps, or a file with its kind before a colon. */
bool parse_normal_map(const char *text, options *o);

/* An axis and degrees: x, y, z or X,Y,Z, a comma, a number. */
bool parse_rotation(const char *text, gn_vec3 *axis, float *degrees);

/* An axis: x, y, z or X,Y,Z. */
bool parse_axis(const char *text, gn_vec3 *axis);

/* One factor for all directions, or three. */
bool parse_scale(const char *text, gn_vec3 *factors);

/* Words that name a value of their option. */
bool parse_cull(const char *text, gn_cull *result);
bool parse_filter(const char *text, filter_option *result);
bool parse_sort(const char *text, sort_option *result);

bool parse_backend(const char *text, gn_backend *result);

/* "auto, portable, .. or wasm-simd128": every back end, present here or not. */
const char *parse_backend_names(void);

#endif
