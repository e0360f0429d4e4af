/* Models over ranks: rank 0 has read them, and the others get all of them or a part. */
#ifndef SHARE_MODEL_H
#define SHARE_MODEL_H

#include "picture.h"

/* Both functions are collective. At ranks above 0 the contents are empty before and must be freed
 * with import_free(&c->from) later; they have no list of maps in words. If a rank has not enough
 * memory, it prints that, and all ranks end. */

/* Gives all ranks everything. */
void share_whole_model(contents *c);

/* Gives each rank its part of the triangles, with the vertices that they use and the maps that they
 * need; rank 0 keeps its own part only. Parts of the model without triangles stay as empty ones.
 * `has_segments`: see triangle_parts.h. The bounds stay those of the whole. */
void share_model_in_parts(contents *c, bool has_segments);

#endif
