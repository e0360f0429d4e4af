/* Batches of blocks and of rows in the fragment stages, with the contracts of contracts/fragment.
 * @functions: shader_colors compact_halves compact_rows most_together blocks_together step_together
 * @functions: step_blocks step_rest name_rows most_columns step_columns step_rows
 * @options: -wp-model Typed+cast */
#include "fragment/steps.h"
