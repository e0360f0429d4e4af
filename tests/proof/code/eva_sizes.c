/* Sizes of workspaces and textures, for all arguments: no sum or product wraps around.
 * @sources: draw/prepare.c texture/packed_levels.c
 * @options: -warn-unsigned-overflow
 * @reaches: gn_workspace_size gn_workspace_size_parallel vertices_size segment_size as_size
 * @reaches: gn_texture_memory_size fault_of_shape fault_of_targets_size most_levels
 * @reaches: gni_packed_bytes bytes_of_level extent_of_level size_of_level */
#include "eva.h"

#include <gnomon/draw.h>
#include <gnomon/texture.h>

int main(void)
{
    volatile size_t size;

    size = gn_workspace_size(any_uint32, any_uint32);
    size = gn_workspace_size_parallel(any_uint32, any_uint32, any_uint32);
    //@ loop unroll 8;
    for (uint32_t target = 0; target < 8; ++target)
        size = gn_texture_memory_size((gn_texture_target)target, (gn_format)any_uint32, any_uint32,
                                      any_uint32, any_uint32, any_uint32);
    return 0;
}
