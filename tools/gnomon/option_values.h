/* Parsers of the values of options, and checks of values that depend on other options. A parser
 * returns false if the text is not such a value as a whole. */
#ifndef OPTION_VALUES_H
#define OPTION_VALUES_H

#include "options.h"

/* A finite float; three, separated by commas. */
bool parse_single(const char *text, float *result);
bool parse_vector(const char *text, gn_vec3 *result);

/* Three such numbers as floats, and what the floats lack. */
bool parse_place(const char *text, gn_vec3 *result, double rest[3]);

/* Whether the text is a list of numbers one of which is not finite as a float. */
bool parse_has_infinite(const char *text);

/* A whole number: digits, perhaps after a minus. Numbers below 0 become 0, those beyond 32 bits
 * UINT32_MAX: both lie outside the ranges of all options. */
bool parse_whole(const char *text, uint32_t *result);

/* WIDTHxHEIGHT, each as for parse_whole. */
bool parse_size(const char *text, uint32_t *width, uint32_t *height);

/* X,Y. */
bool parse_pair(const char *text, pair_option *result);

/* #rrggbb or #rrggbbaa. The # may be left out, since shells take it for a comment. */
bool parse_color(const char *text, float color[4]);

/* One such colour, or that of the top row, a comma and that of the bottom row. */
bool parse_background(const char *text, options *o);

/* The number of a word among words with blanks between them. */
bool parse_word(const char *text, const char *words, int *result);

/* A file name, or `none`. */
bool parse_map(const char *text, map_option *result);

/* One of these words, which say which of the existing maps; behind `tangent` or `world`, a colon
 * and a file may stand. */
bool parse_normal_map(const char *text, const char *words, options *o);

/* An axis and degrees: x, y, z or X,Y,Z, a comma, a number. */
bool parse_rotation(const char *text, gn_vec3 *axis, float *degrees);

/* An axis: x, y, z or X,Y,Z. */
bool parse_axis(const char *text, gn_vec3 *axis);

/* One factor for all directions, or three. */
bool parse_scale(const char *text, gn_vec3 *factors);

bool parse_backend(const char *text, gn_backend *result);

/* Each check returns 0, or the exit status with the reason printed. */

/* Whether there is what uses the maps that are asked for: a model, and a shader that takes them.
 * `name` is the command's. */
int check_map_options(command which, const char *name, const options *o);

/* The size, the samples and the points. */
int check_number_options(command which, const options *o);

#endif
