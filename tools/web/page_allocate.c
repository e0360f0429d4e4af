/* Memory that the caller of the page's functions fills in. */
#include <stdlib.h>

#include "page.h"

void *page_allocate(uint32_t bytes)
{
    return malloc(bytes != 0 ? bytes : 1);
}

void page_free(void *memory)
{
    free(memory);
}
