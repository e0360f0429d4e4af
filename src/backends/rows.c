/* Work on rows over the portable lanes. */
#define GN_ROWS gni_rows_portable
#include "../kernel/surfaces/row_work.inl"
