/* Rows of pixels where a square is one pixel, with the contracts of contracts/raster.
 * @defines: -DGN_SMALL -DGN_BASIC -DGN_LANES=1
 * @functions: bounds_of_lane cover_pixels */
#include "raster/cover_pixels.h"
