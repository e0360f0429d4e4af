/* Clipping, the counts, with the contracts of contracts/geometry.
 * @functions: room_of piece_count */
#include "geometry/clip.h"
