/* What gnomon.wasm, the module without vectors, exports beside the functions of page.h. */
#ifndef PAGE_EXPLAIN_H
#define PAGE_EXPLAIN_H

#include <stdint.h>

/* Explains the pixel that lies x pixels from the left and y from the bottom of the picture of
 * page_build, as JSON (explain_json in tools/explain/explain.h). The text is good until the next
 * call. Returns null on failure, with page_message. */
const char *page_explain(uint32_t x, uint32_t y);

#endif
