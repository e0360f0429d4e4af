/* The elements of a mesh that are drawn together. */
#ifndef GN_KERNEL_GEOMETRY_MESH_SLICE_H
#define GN_KERNEL_GEOMETRY_MESH_SLICE_H

#include <gnomon/draw.h>

/* A slice: the elements of one instance between two restarts. The job's mesh has all elements of
 * the first instance. Members are those of gn_mesh, except `base`, `instance` and `primitive`. */
typedef struct mesh_slice {
    const gn_attribute *attribute;
    uint32_t vertex_count;
    const void *indices;
    gn_index_format index_format;
    size_t first;
    uint32_t count;
    uint32_t base; /* added to indices; the sum wraps */
    uint32_t instance;
    uint32_t primitive; /* the number of its first primitive in the instance; numbering continues
                           after restarts */
    bool restarts;      /* at restart_index, which is compared before the base is added */
    uint32_t restart_index;
} mesh_slice;

#endif
