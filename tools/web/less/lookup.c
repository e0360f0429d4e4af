/* src/backends/lookup.c with less (texture_parts.h). */
#include "../../../src/lanes/lanes.h"

#include "texture_parts.h"

#define gather_any(...) ((void)0)
#define fetch_numbered(...) ((void)0)

#include "../../../src/backends/lookup.c"
