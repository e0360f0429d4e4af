/** @file
 * What became of the primitives and fragments of draws: the answer to "why is the picture empty?".
 *
 *     gn_draw_statistics statistics = {0};
 *     workspace.statistics = &statistics;
 *     gn_draw(&target, &pipeline, &mesh, &workspace);
 *
 * gn_draw adds its counts to those that are there, so that several draws can be summed. A draw that
 * returns a fault adds nothing. Every count is exact. It depends on the target's size, the
 * pipeline, the mesh and, for samples_passed, on the target's depth and stencil; it does not depend
 * on the back end, the number of threads and tasks, or the size of the workspace. Draws that count
 * are slower, since the fast loops of frequent states do not count. A GN_BASIC library does not
 * count.
 *
 * If a picture is empty, the counts say why:
 *
 *     primitives is 0       there are too few elements
 *     outside               the matrix or the camera is wrong; behind: the camera looks away
 *     not_finite            the matrix is NaN or all zero, for example because a projection failed
 *     culled                the winding is the other one
 *     without_area          the vertices coincide, or the viewport has a width or height of 0
 *     missed                the scissor is empty or elsewhere, or the primitives are too small
 *     samples_covered is 0  the primitives are too thin
 *     samples_passed is 0   the depth or stencil test fails, or the shader discards
 *     covered, but black    a texture is zeroed, and the status of the draw says so
 *     none of these         color.write_disabled, blending or the surface hides them */
#ifndef GNOMON_STATISTICS_H
#define GNOMON_STATISTICS_H

#include <stdint.h>

/**
 * A primitive is a triangle, a line or a point of the pipeline's topology. A triangle that is
 * drawn as lines or points (polygon modes) is one primitive, and so is a triangle that clipping
 * divides. Every primitive is counted once in `primitives` and once in one of the next six counts,
 * which is the first that holds for it:
 *
 *     primitives = not_finite + outside + without_area + culled + missed + drawn
 *
 * If clipping divides a triangle and none of its pieces is drawn, each piece has a fate of its own.
 * The triangle counts under the one that comes last in that sum. */
typedef struct gn_draw_statistics {
    uint64_t primitives; /**< those of all instances, and of all strips, fans and lists between
                              restarts. Elements that are left over are no primitive. A line loop
                              has a line for every element */

    /** A vertex has an x, y, z or clip distance that is infinite or NaN, or a w that is NaN; but
     * with depth.clamp_enabled z may have any value, and an infinite z is inside if w is infinite
     * too. Also counts primitives with a vertex whose place in the window is not finite or beyond
     * 32,769 pixels from the origin after clipping; a vertex at (0, 0, 0, 0) has such a place. But
     * a triangle that is drawn as lines or points counts as drawn if another edge or vertex is. */
    uint64_t not_finite;

    /** Clipping leaves nothing: no part lies inside the view volume and has clip distances that are
     * not negative. Points are outside with their centres. Also counts what gn_draw does not draw
     * since a distance w +- x, y or z overflows, or since a side of the view volume clips it and
     * a coordinate is not finite. */
    uint64_t outside;

    /** A filled triangle whose three vertices lie on one line after they have snapped to 1/256
     * pixel; likewise a culled one that is not filled, if the other face is filled and not culled;
     * a line whose ends have the same window coordinates. */
    uint64_t without_area;

    uint64_t culled; /**< a triangle that raster.cull drops for the way it faces */

    /** No pixel's centre lies in the smallest upright rectangle around the primitive and also in
     * the target and the scissor: the primitive is off the scissor, or lies between the centres. If
     * pixels have several samples, the rectangle extends 3/8 pixel further on every side. The
     * rectangle is that of the part that clipping leaves. For a triangle that is drawn as lines or
     * points, none of its edges or vertices has a pixel, or all are outside. */
    uint64_t missed;

    uint64_t drawn; /**< the others, which can cover pixels. A thin triangle may still cover none */

    /** Parts of two counts above. */
    uint64_t behind;  /**< of `outside`: no vertex has a w above 0, so all lie behind the eye */
    uint64_t clipped; /**< of `drawn`: a vertex is outside, so only a part is drawn */

    /** Fragments; if a pixel has several samples, samples are counted instead. */
    uint64_t samples_covered; /**< by primitives, in the target and the scissor; before the fragment
                                   shader, tests and masks */
    uint64_t samples_passed;  /**< as gn_workspace.samples_passed counts them */
} gn_draw_statistics;

#endif
