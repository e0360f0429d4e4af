/* Validation of textures: returns the status of the first fault. */
#include "texture_faults.h"

gn_status gn_texture_check(const gn_texture *texture)
{
    return fault_of_texture(texture);
}
