/* Lists of triangles, points and lines, with the contracts of contracts/raster.
 * @functions: cover_from cover_each cover_triangles bounds_of_lane
 * @functions: cover_box cover_between cover_point cover_line */
#include "kernel/raster/cover_points_and_lines.inl"
#include "kernel/raster/coverage.inl"
