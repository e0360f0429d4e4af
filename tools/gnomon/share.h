/* Models are read once: by rank 0, which then shares them with the other ranks. */
#ifndef SHARE_H
#define SHARE_H

#include "picture.h"

/* Collective. As picture_import at rank 0; the other ranks get the same contents, but for the list
 * of maps in words, and need not be able to read the files. Returns the same at all ranks. */
int share_import(const options *o, contents *result);

#endif
