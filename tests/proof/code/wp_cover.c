/* Squares, batches of blocks and edges in 64 bits, with the contracts of contracts/raster.
 * @functions: square_block square_start square_mask squares_inside begins_outside
 * @functions: start_queue flush_queue make_queue_room add_square add_span add_partial_square
 * @functions: wide_product owns_ties set_edge_through values_at step_right is_outside is_inside
 * @functions: edge_mask
 * @functions: count_inside count_outside cover_row set_large_edge
 * @functions: set_large_edges set_edges_of_each cover_row_of_each cover_rows cover_large */
#include "kernel/raster/cover_large.inl"
