/* Models are read once: by rank 0, which then shares them with the other ranks. */
#ifndef SHARE_H
#define SHARE_H

#include "picture.h"

/* Collective. As picture_import at rank 0; the other ranks get the same contents, but for the list
 * of maps in words, and need not be able to read the files. Returns the same at all ranks. */
int share_import(const options *o, contents *result);

/* Collective. Copies the contents of rank 0 to all others, whose own are empty before. Returns the
 * same at all ranks: 0, or EXIT_FAULT if one has not enough memory, with the reason printed there.
 * Free with import_free(&c->from) either way. */
int share_contents(contents *c);

#endif
