/* Batches of blocks and of rows in the fragment stages, with the contracts of contracts/fragment.
 * Batches are as long as with vector registers: those of plain C have one column of rows, so that
 * loops over columns would hardly be tried (wp_short_steps.c).
 * @functions: shader_colors compact_batch most_together blocks_together step_together
 * @functions: step_blocks shade_rest name_rows most_columns step_columns step_rows
 * @options: -wp-model Typed+cast */
#include "kernel/fragment/pixels.inl"

/* Decides on lengths alone after this: the lanes of pixels.inl are arrays. */
#undef GN_LANES_ARRAYS
#include "kernel/fragment/batch.inl"
#define GN_LANES_ARRAYS
#include "kernel/fragment/steps.inl"

#if STEP_BLOCKS != 16
#error "These proofs are meant for batches of 16 blocks, four columns of rows."
#endif
