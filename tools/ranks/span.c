/* The smallest and the largest number of all ranks. */
#define _XOPEN_SOURCE 700
#include "span.h"

#include <sys/resource.h>

#include "ranks.h"

span span_of(uint64_t number)
{
    const span s = {UINT64_MAX - ranks_largest(UINT64_MAX - number), ranks_largest(number)};
    return s;
}

span span_of_memory(void)
{
    struct rusage usage;
    const bool known = getrusage(RUSAGE_SELF, &usage) == 0;
    return span_of(known ? ((uint64_t)usage.ru_maxrss + 1023) / 1024 : 0);
}

void span_print(FILE *file, const span *s)
{
    fprintf(file, "%llu", (unsigned long long)s->least);
    if (s->most != s->least)
        fprintf(file, " to %llu", (unsigned long long)s->most);
}
