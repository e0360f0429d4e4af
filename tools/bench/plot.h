/* Pictures of results, as SVG. They have a light background of their own, so that they can be read
 * on pages of any colour. */
#ifndef BENCH_PLOT_H
#define BENCH_PLOT_H

#include "record.h"

/* Bars of the ratios, one panel per scene. */
void plot_ratios(FILE *out, const record_list *list);

/* Curves of the times of the scale series, one panel per series. */
void plot_scale(FILE *out, const record_list *list);

/* Dots of the states' ratios on logarithmic axes, one line per row. */
void plot_states(FILE *out, const record_list *list);

/* Reads results of scenes and draws the picture that fits them. Returns false with a message. */
bool plot(const char *json, const char *svg);

#endif
