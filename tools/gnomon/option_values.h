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

/* An option that takes a whole number, and the number's place in options. */
typedef struct whole_option {
    char name[16]; /* without dashes */
    char form[24]; /* "a whole number" */
    uint32_t least, most;
    size_t place;
} whole_option;

/* Returns null if the option of this name takes none. */
const whole_option *whole_option_named(const char *name);

/* WIDTHxHEIGHT, each as for parse_whole. */
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

/* Each check returns 0, or the exit status with the reason printed. */

/* Whether there is what uses the maps that are asked for: a model, and a shader that takes them.
 * `name` is the command's. */
int check_map_options(command which, const char *name, const options *o);

/* The size, the samples and the points. */
int check_number_options(command which, const options *o);

#endif
