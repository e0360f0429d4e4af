/* The primitives of a list one after another, with the contracts of contracts/raster.
 * @functions: cover_each */
#include "kernel/raster/cover_points_and_lines.inl"
#include "kernel/raster/coverage.inl"
