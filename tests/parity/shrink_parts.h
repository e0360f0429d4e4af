/* Shared by the passes of shrinking: the best scene so far, and copies of a scene with one draw
 * changed. */
#ifndef PARITY_SHRINK_PARTS_H
#define PARITY_SHRINK_PARTS_H

#include "shrink.h"

typedef struct shrinking {
    scene *best;
    shrink_predicate *fails;
    void *context;
    unsigned attempts; /* calls that are left */
} shrinking;

/* Frees the candidate, or makes it the best scene if it fails. */
bool shrink_try(shrinking *s, scene *candidate);

/* The part of a mesh to keep. */
typedef struct mesh_selection {
    const uint32_t *vertices; /* of the old arrays, in their new order; null: all */
    uint32_t vertex_count;
    bool keep_indices; /* only if all vertices are kept */
    uint32_t first, count;
    unsigned attributes; /* bit a: attribute a is kept */
} mesh_selection;

/* Selects all of a mesh. */
mesh_selection mesh_select_all(const gn_mesh *mesh);

/* Returns a copy of the scene in which a draw has only the selected part of its mesh. */
scene *copy_with_selection(const scene *s, size_t draw, const mesh_selection *selection);

/* Passes: each tries its simplifications on the best scene, and returns true if one was kept. */
bool shrink_draws(shrinking *s);
bool shrink_meshes(shrinking *s);
bool shrink_state(shrinking *s);
bool shrink_target(shrinking *s);
bool shrink_numbers(shrinking *s);

/* Tries a draw's texture with fewer levels, layers and rows. */
bool shrink_texture(shrinking *s, size_t draw);

#endif
