/* The faults of textures in words. */
#define GN_FAULT_TEXTS
#include "texture_faults.h"

const char *gn_texture_fault(const gn_texture *texture)
{
    return fault_of_texture(texture);
}
