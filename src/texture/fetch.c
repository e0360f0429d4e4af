/* Fetching texels for callers, compiled for the instruction set that every processor of the target
 * has. */
#include "fetch.h"

void gn_fetch(const gn_texture *texture, const int32_t *const coordinate[3], const int32_t *level,
              float texel[4][GN_LANES])
{
    fetch_numbered(texture, coordinate, level, texel);
}
