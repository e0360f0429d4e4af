/* Clipping of polygons, with the contracts of contracts/geometry. WP takes from Eva
 * (eva_clipping.c) that plane_distance, interpolate_vertex and place_new_vertices work: they see
 * the workspace as vertices, which WP's model of memory cannot.
 * @functions: room_of clip_room clip_to_plane clip_triangle piece_count take_pieces */
#include "kernel/geometry/clip.inl"
