/* Work on rows over SSE4.1 registers. */
#include "entry_points.h"

#if GN_HAVE_VECTOR_ROWS
#define GN_LANES_SSE41
#define GN_ROWS gni_rows_sse41
#include "../kernel/surfaces/row_work.inl"
#endif
