/* Small triangles where a square is a pixel, with the contracts of contracts/raster.
 * @functions: set_pixel_edges next_pixel_row cover_pixel_row cover_pixels
 * @defines: -DGN_LANES=1 -DGN_SMALL -DGN_BASIC */
#include "kernel/raster/cover_pixels.inl"
