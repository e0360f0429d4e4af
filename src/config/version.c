/* The library's version. */
#include <gnomon/version.h>

uint32_t gn_version(void)
{
    return GN_VERSION;
}
