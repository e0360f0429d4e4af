/* Validation of textures: the first fault's status. */
#include "texture_faults.h"

gn_status gn_texture_check(const gn_texture *texture)
{
    return fault_of_texture(texture);
}
