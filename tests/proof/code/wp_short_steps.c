/* The functions of wp_steps.c with the short batches of plain C.
 * @functions: shader_colors compact_batch most_together blocks_together step_together
 * @functions: step_blocks shade_rest name_rows most_columns step_columns step_rows
 * @options: -wp-model Typed+cast */
#include "kernel/fragment/steps.inl"

#if STEP_BLOCKS != 4
#error "These proofs are meant for batches of 4 blocks, one column of rows."
#endif
