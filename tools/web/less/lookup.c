/* src/backends/lookup.c with less (texture_parts.h). */
#include "../../../src/lanes/lanes.h"

#include "texture_parts.h"

#define gather_any(memory, ...) ((void)(memory))
#define fetch_numbered(memory, ...) ((void)(memory))

#include "../../../src/backends/lookup.c"
