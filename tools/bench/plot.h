/* Pictures of results, as SVG, with a light ground of their own, so that they can be read
 * on pages of any colour. */
#ifndef BENCH_PLOT_H
#define BENCH_PLOT_H

#include "record.h"

/* Bars of the ratios, a panel a scene. */
void plot_ratios(FILE *out, const record_list *list);

/* Curves of the times of the scale series, a panel a series. */
void plot_scale(FILE *out, const record_list *list);

/* Reads results and draws one of the two, whichever they are. False with a message. */
bool plot(const char *json, const char *svg);

#endif
