/* The library's portable lanes under other names, plain_lanes_f and so on, so that recording lanes
 * (recording_lanes.h) can take the library's names. The guard of src/lanes/lanes.h then keeps the
 * stages from including it again. */
#ifndef EXPLAIN_PLAIN_LANES_H
#define EXPLAIN_PLAIN_LANES_H

#define GN_NO_VECTORS

#define lanes_add plain_lanes_add
#define lanes_and plain_lanes_and
#define lanes_as_float plain_lanes_as_float
#define lanes_as_int plain_lanes_as_int
#define lanes_bits plain_lanes_bits
#define lanes_columns plain_lanes_columns
#define lanes_div plain_lanes_div
#define lanes_f plain_lanes_f
#define lanes_floor plain_lanes_floor
#define lanes_floor_to_int plain_lanes_floor_to_int
#define lanes_from_bits plain_lanes_from_bits
#define lanes_greater plain_lanes_greater
#define lanes_i plain_lanes_i
#define lanes_i_add plain_lanes_i_add
#define lanes_i_add_bytes plain_lanes_i_add_bytes
#define lanes_i_add_shorts plain_lanes_i_add_shorts
#define lanes_i_and plain_lanes_i_and
#define lanes_i_clamp plain_lanes_i_clamp
#define lanes_i_equal plain_lanes_i_equal
#define lanes_i_gather plain_lanes_i_gather
#define lanes_i_gather_pairs plain_lanes_i_gather_pairs
#define lanes_i_gather_rows plain_lanes_i_gather_rows
#define lanes_i_greater plain_lanes_i_greater
#define lanes_i_splat_two plain_lanes_i_splat_two
#define lanes_i_high_bytes plain_lanes_i_high_bytes
#define lanes_i_load plain_lanes_i_load
#define lanes_i_load_block plain_lanes_i_load_block
#define lanes_i_max plain_lanes_i_max
#define lanes_i_min plain_lanes_i_min
#define lanes_i_mul plain_lanes_i_mul
#define lanes_i_mul_short plain_lanes_i_mul_short
#define lanes_i_mul_shorts plain_lanes_i_mul_shorts
#define lanes_i_or plain_lanes_i_or
#define lanes_i_plane plain_lanes_i_plane
#define lanes_i_scale_shorts plain_lanes_i_scale_shorts
#define lanes_i_scatter_rows plain_lanes_i_scatter_rows
#define lanes_i_select plain_lanes_i_select
#define lanes_i_shift_left plain_lanes_i_shift_left
#define lanes_i_shift_right plain_lanes_i_shift_right
#define lanes_i_sign_bits plain_lanes_i_sign_bits
#define lanes_i_splat plain_lanes_i_splat
#define lanes_i_store plain_lanes_i_store
#define lanes_i_store_block plain_lanes_i_store_block
#define lanes_i_sub plain_lanes_i_sub
#define lanes_i_sub_bytes plain_lanes_i_sub_bytes
#define lanes_i_sub_shorts plain_lanes_i_sub_shorts
#define lanes_i_xor plain_lanes_i_xor
#define lanes_less_equal plain_lanes_less_equal
#define lanes_load plain_lanes_load
#define lanes_m plain_lanes_m
#define lanes_m_as_int plain_lanes_m_as_int
#define lanes_magnitude plain_lanes_magnitude
#define lanes_max plain_lanes_max
#define lanes_min plain_lanes_min
#define lanes_mul plain_lanes_mul
#define lanes_not plain_lanes_not
#define lanes_pack_unorm8 plain_lanes_pack_unorm8
#define lanes_quad_left plain_lanes_quad_left
#define lanes_quad_lower plain_lanes_quad_lower
#define lanes_quad_right plain_lanes_quad_right
#define lanes_quad_upper plain_lanes_quad_upper
#define lanes_round plain_lanes_round
#define lanes_rows plain_lanes_rows
#define lanes_select plain_lanes_select
#define lanes_splat plain_lanes_splat
#define lanes_sqrt plain_lanes_sqrt
#define lanes_store plain_lanes_store
#define lanes_sub plain_lanes_sub
#define lanes_to_float plain_lanes_to_float
#define lanes_truncate plain_lanes_truncate
#define lanes_unpack_unorm8 plain_lanes_unpack_unorm8

#include "../../src/lanes/lanes.h"

#undef lanes_add
#undef lanes_and
#undef lanes_as_float
#undef lanes_as_int
#undef lanes_bits
#undef lanes_columns
#undef lanes_div
#undef lanes_f
#undef lanes_floor
#undef lanes_floor_to_int
#undef lanes_from_bits
#undef lanes_greater
#undef lanes_i
#undef lanes_i_add
#undef lanes_i_add_bytes
#undef lanes_i_add_shorts
#undef lanes_i_and
#undef lanes_i_clamp
#undef lanes_i_equal
#undef lanes_i_gather
#undef lanes_i_gather_pairs
#undef lanes_i_gather_rows
#undef lanes_i_greater
#undef lanes_i_splat_two
#undef lanes_i_high_bytes
#undef lanes_i_load
#undef lanes_i_load_block
#undef lanes_i_max
#undef lanes_i_min
#undef lanes_i_mul
#undef lanes_i_mul_short
#undef lanes_i_mul_shorts
#undef lanes_i_or
#undef lanes_i_plane
#undef lanes_i_scale_shorts
#undef lanes_i_scatter_rows
#undef lanes_i_select
#undef lanes_i_shift_left
#undef lanes_i_shift_right
#undef lanes_i_sign_bits
#undef lanes_i_splat
#undef lanes_i_store
#undef lanes_i_store_block
#undef lanes_i_sub
#undef lanes_i_sub_bytes
#undef lanes_i_sub_shorts
#undef lanes_i_xor
#undef lanes_less_equal
#undef lanes_load
#undef lanes_m
#undef lanes_m_as_int
#undef lanes_magnitude
#undef lanes_max
#undef lanes_min
#undef lanes_mul
#undef lanes_not
#undef lanes_pack_unorm8
#undef lanes_quad_left
#undef lanes_quad_lower
#undef lanes_quad_right
#undef lanes_quad_upper
#undef lanes_round
#undef lanes_rows
#undef lanes_select
#undef lanes_splat
#undef lanes_sqrt
#undef lanes_store
#undef lanes_sub
#undef lanes_to_float
#undef lanes_truncate
#undef lanes_unpack_unorm8

#endif
