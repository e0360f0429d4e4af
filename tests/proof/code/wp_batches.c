/* Batches of small triangles and of samples, with the contracts of contracts/raster.
 * @functions: join_squares square_coverage count_covered add_halves finish_halves
 * @functions: sample_offset shade_sample_batch add_sampled_square add_sampled_run
 * @functions: set_sampled_edge has_ended skip_outside sample_masks
 * @functions: cover_sample_row cover_samples
 * @granted: stays */
#include "raster/cover_packed.h"
#include "raster/cover_samples.h"
#include "raster/cover_small.h"
