/* Work on rows over the lanes that every processor of the target has. */
#define GN_ROWS gni_rows
#include "../kernel/surfaces/row_work.inl"
