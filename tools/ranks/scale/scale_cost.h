/* What a rank pays for its share of the drawing, by the figures. */
#ifndef SCALE_COST_H
#define SCALE_COST_H

#include "scale_ways.h"

typedef struct cost {
    double clear, vertices, triangles, fragments, compress; /* seconds */
    double bytes;                                           /* of compressed rows */
} cost;

/* Seconds of a count, by a figure in nanoseconds. */
double cost_ns(const figures *f, figure_kind kind, double count);

/* Pixels of a whole picture. */
double cost_pixels(const work *w);

/* Seconds of a rank before its first picture: its copy of the model, and memory for pixels. */
double cost_of_preparing(way_kind way, const work *w, const figures *f, uint32_t ranks);

/* A rank's of one picture; a rank's of one frame. */
cost cost_of_picture(way_kind way, const work *w, const figures *f, uint32_t ranks, uint32_t rank);
cost cost_of_frame(const work *w, const figures *f, uint32_t frame);

/* In how many pieces a rank's band is exchanged in sort-last, each of which is a message. */
double cost_pieces(const work *w, uint32_t ranks);

#endif
