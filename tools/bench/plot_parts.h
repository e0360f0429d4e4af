/* The parts of pictures. Coordinates are SVG's, y downwards. */
#ifndef BENCH_PLOT_PARTS_H
#define BENCH_PLOT_PARTS_H

#include <stdio.h>

#define INK "#202124"
#define FAINT "#dadce0"
#define MIDDLING "#5f6368"

typedef enum anchor { ANCHOR_START, ANCHOR_MIDDLE, ANCHOR_END } anchor;

void part_begin(FILE *out, int width, int height, const char *title, const char *subtitle);
void part_end(FILE *out);
void part_line(FILE *out, double x0, double y0, double x1, double y1, const char *color,
               double width);
void part_bar(FILE *out, double x, double y, double width, double height, const char *color);
void part_dot(FILE *out, double x, double y, const char *color);

/* Formatted text, as by printf, with its base line at y. */
void part_text(FILE *out, double x, double y, anchor a, int size, const char *color,
               const char *format, ...) __attribute__((format(printf, 7, 8)));

#endif
