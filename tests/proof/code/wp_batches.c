/* Batches of small triangles and of samples, with the contracts of contracts/raster.
 * @functions: join_squares covered_lanes count_covered add_halves finish_halves
 * @functions: lanes_i_splat lanes_i_plane lanes_i_load lanes_i_add lanes_i_sub
 * @functions: lanes_i_mul lanes_i_or lanes_i_sign_bits edge_values not_negative
 * @functions: cover_small_row cover_small
 * @functions: set_small_edge set_small_edges step_up lanes_met cover_packed_row cover_packed
 * @functions: sample_offset flush_sample_queue add_sampled_square add_sampled_span
 * @functions: set_least_edge set_edge_of_samples set_sampled_edge set_sampled_edges
 * @functions: has_ended skip_outside sample_masks cover_sample_row cover_sample_rows
 * @functions: cover_triangle_samples sample_masks_between cover_sample_row_between
 * @functions: cover_samples_between
 * @functions: rectangle_mask cover_box_samples */
#include "kernel/raster/cover_packed.inl"
#include "kernel/raster/cover_samples.inl"
#include "kernel/raster/cover_small.inl"
