/* Exact coverage, depth and colour of a triangle in clip space, without a clipper: oracle B.
 *
 * The mathematics. A float is an integer times a power of two. So if all coordinates of a triangle
 * are multiplied by one large power of two, they are integers, and sums and products of integers of
 * any length (GMP's) are exact. A common factor changes neither a sign nor a ratio.
 *
 * Vertices. The viewport maps (x, y, w) of clip space to the homogeneous window coordinates
 *
 *     V = (x * scale_x + w * translate_x, y * scale_y + w * translate_y, w),
 *
 * whose window coordinates are V.x / V.w and V.y / V.w. Nothing is divided here, so w may be
 * negative or zero.
 *
 * Edges. Let P = (x, y, 1) be the centre of a pixel. The determinants
 *
 *     e0 = |P, V1, V2|,  e1 = |V0, P, V2|,  e2 = |V0, V1, P|
 *
 * are linear in x and y, and by Cramer's rule e0*V0 + e1*V1 + e2*V2 = D*P with D = |V0, V1, V2|. So
 * the ray from the eye through P meets the triangle's plane at the point with the weights e0, e1,
 * e2 divided by their sum. If D is negative, all signs are changed. The point lies inside the
 * triangle if all three weights have the sign of their sum; it lies before the eye if its w does.
 * Its w is (e0*w0 + e1*w1 + e2*w2) / sum = D / sum. So after the change of signs both hold if all
 * three e are positive: a triangle that crosses the plane of the eye needs no other treatment.
 * (Olano and Greer 1997 draw triangles in this way.)
 *
 * The view volume. The point's clip coordinates are e0*v0 + e1*v1 + e2*v2, but for a positive
 * factor. So -w <= z <= w are two further functions that are linear in x and y,
 *
 *     e0*(z0 + w0) + e1*(z1 + w1) + e2*(z2 + w2) > 0   and   with w - z in place of z + w.
 *
 * -w <= x <= w and -w <= y <= w say that P lies in the viewport. Clipping is thus three to five
 * signs and four comparisons.
 *
 * Depth and attributes. A smooth (perspective-correct) attribute is linear on the triangle in clip
 * space: (e0*a0 + e1*a1 + e2*a2) / (e0 + e1 + e2). Window depth and noperspective attributes are
 * linear in the window: the weights are those of the projected vertices, e*w / D, and their sum is
 * one. For a vertex behind the eye, that is the linear function through the place x/w, y/w to which
 * the vertex projects. Each value is a ratio of two integers. */
#ifndef EXACT_CLIP_TRIANGLE_H
#define EXACT_CLIP_TRIANGLE_H

#include <stdbool.h>
#include <stdint.h>

#include <gnomon/pipeline.h>

/* Attributes: the first half is smooth, the second noperspective. */
#define EXACT_ATTRIBUTES 4

typedef struct clip_vertex {
    float position[4]; /* finite */
    float attribute[EXACT_ATTRIBUTES];
} clip_vertex;

typedef struct clip_triangle clip_triangle;

/* Returns a triangle without vertices; null if there is no memory. GMP ends the program if it gets
 * no memory. */
clip_triangle *clip_triangle_create(void);
void clip_triangle_free(clip_triangle *t);

/* Sets the triangle and the viewport, whose depth range is 0 to 1. */
void clip_triangle_set(clip_triangle *t, const clip_vertex vertex[3], const gn_viewport *viewport);

/* Goes to the centre of the pixel (x, y); then to the next pixel on the right. */
void clip_triangle_go(clip_triangle *t, int32_t x, int32_t y);
void clip_triangle_step(clip_triangle *t);

/* Returns 1 if the centre is inside what lies in the view volume, -1 if it is outside, 0 if it is
 * exactly on an edge. Triangles without area have no inside and no edges. */
int clip_triangle_covers(const clip_triangle *t);

/* The values at the centre: attributes, then the window depth. `slope` is how fast a value changes
 * there: the length of its gradient, per pixel. Both are rounded to double and within 2^-49 of
 * themselves. Precondition: the centre is covered. */
enum { EXACT_DEPTH = EXACT_ATTRIBUTES, EXACT_VALUES };

typedef struct exact_values {
    double value[EXACT_VALUES], slope[EXACT_VALUES];
} exact_values;

exact_values clip_triangle_values(clip_triangle *t);

/* Returns the distance from the centre to the nearest edge of what lies in the view volume, in
 * pixels; infinity if nothing does. These edges are found by clipping in long double, about 1e-15
 * of the coordinates' size; that part of the oracle decides on no coverage. */
double clip_triangle_distance(const clip_triangle *t);

/* Returns the largest coordinate of a vertex, divided by the least w in view, times half of the
 * viewport's size: the size of the numbers whose rounding moves the corners that clipping makes, in
 * pixels. */
double clip_triangle_reach(const clip_triangle *t);

#endif
