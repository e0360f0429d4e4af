/* The one draw that is traced at a time. */
#include "tracing.h"

tracing pixel;
