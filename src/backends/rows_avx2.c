/* Work on rows over AVX2 registers. */
#include "entry_points.h"

#if GN_HAVE_VECTOR_ROWS && GN_HAVE_AVX2
#define GN_LANES_AVX2
#define GN_ROWS gni_rows_avx2
#include "../kernel/surfaces/row_work.inl"
#endif
