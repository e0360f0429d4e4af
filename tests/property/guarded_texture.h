/* Textures in memory beyond whose ends nothing may be read, with texels that tell themselves from
 * what lies between their rows. */
#ifndef GUARDED_TEXTURE_H
#define GUARDED_TEXTURE_H

#include <stdbool.h>

#include <gnomon.h>

typedef struct guarded {
    unsigned char *mapping; /* its first and last page may not be read */
    size_t mapped;
} guarded;

/* A stride's magnitude. */
size_t guarded_length(ptrdiff_t stride);

/* A level's bytes from the first to the last, by its strides. */
size_t guarded_span(const gn_texture *t, uint32_t level);

/* Puts a texture of that shape and those strides (which do not count where there is one row or
 * layer) into guarded memory, each level at its end or beginning. Texels have channels from 0.25 to
 * 0.5, those of less than 8 bits any; what lies between them is NaN or above. False where some
 * level is too large to be filled: it is 0, and nothing of it is NaN or above. */
bool guarded_map(const gn_texture *shape, uint64_t seed, const bool at_end[GN_MAX_LEVELS],
                 gn_texture *t, guarded memory[GN_MAX_LEVELS]);
void guarded_unmap(const gn_texture *t, const guarded memory[GN_MAX_LEVELS]);

#endif
