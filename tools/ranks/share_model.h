/* A model in parts: rank 0 has read it, and each rank gets its part of the triangles. */
#ifndef SHARE_MODEL_H
#define SHARE_MODEL_H

#include "picture.h"

/* Collective. Gives each rank its part of the triangles, with the vertices that they use and the
 * maps that they need; rank 0 keeps its own part only. At ranks above 0 the contents are empty
 * before and must be freed with import_free(&c->from) later; they have no list of maps in words.
 * Parts of the model without triangles stay as empty ones.
 * The bounds stay those of the whole. If a rank has not enough memory, it prints that, and all
 * ranks end. */
void share_model_in_parts(contents *c, const options *o);

#endif
