/* Textures in memory beyond whose ends nothing may be read. Texels have other values than the gaps
 * between rows. */
#ifndef GUARDED_TEXTURE_H
#define GUARDED_TEXTURE_H

#include <stdbool.h>

#include <gnomon.h>

typedef struct guarded {
    unsigned char *mapping; /* its first and last page may not be read */
    size_t mapped;
} guarded;

/* The magnitude of a stride. */
size_t guarded_length(ptrdiff_t stride);

/* A level's bytes from the first to the last, by its strides. */
size_t guarded_span(const gn_texture *t, uint32_t level);

/* Puts a texture of this shape with these strides (which have no effect with one row or layer) into
 * guarded memory, each level at its end or beginning. Channels of texels are 0.25 to 0.5; those of
 * less than 8 bits have any value. Gaps hold NaN or greater values. Returns false if some level is
 * too large to be filled: then that level is 0 and has no gaps of NaN or greater values. */
bool guarded_map(const gn_texture *shape, uint64_t seed, const bool at_end[GN_MAX_LEVELS],
                 gn_texture *t, guarded memory[GN_MAX_LEVELS]);
void guarded_unmap(const gn_texture *t, const guarded memory[GN_MAX_LEVELS]);

#endif
