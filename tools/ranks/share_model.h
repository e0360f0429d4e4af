/* Models are read once: by rank 0, which gives the other ranks the whole model or their parts of
 * it. At ranks above 0 the contents are empty before; they get the same ones, but for the list of
 * maps in words, need not be able to read the files, and free the contents with
 * import_free(&c->from). If a rank has not enough memory, it prints that, and all ranks end. */
#ifndef SHARE_MODEL_H
#define SHARE_MODEL_H

#include "picture.h"

/* Collective. Reads as picture_import does, at rank 0, and gives all ranks the whole. Returns the
 * same at all ranks. */
int share_import(const options *o, contents *result);

/* Collective. Gives all ranks what rank 0 has. */
void share_model(contents *c);

/* Collective. Gives each rank its part of the triangles, with the vertices that they use and the
 * maps that they need; rank 0 keeps its own part only. Parts of the model without triangles stay as
 * empty ones. The bounds stay those of the whole. */
void share_model_in_parts(contents *c, const options *o);

#endif
