/* src/backends/portable.c with fewer formats. */
#include "formats.h"

#include "../../../src/backends/portable.c"
