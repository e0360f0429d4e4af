/* Work on rows over AVX2 registers. */
#include "../kernel/surfaces/row_work.h"

#if GN_HAVE_WIDE_ROWS
#define GN_LANES_AVX2
#define GN_WORK_ON_ROW gni_work_on_row_avx2
#include "../kernel/surfaces/row_work.inl"
#endif
