/* All rows of the matrix. */
#include "rows.h"

const state_row *state_rows(size_t *count)
{
    *count = state_single_row_count;
    return state_single_rows;
}
