/* How many vertices, triangles, fragments and texture samples are processed at a time, as
 * structures of arrays. It is the length of the arrays that shaders and lookups take. */
#ifndef GNOMON_LANES_H
#define GNOMON_LANES_H

#define GN_LANES 16

#endif
