/* The contract as data: for a fixed set of scenes, hashes of the pinned reference's pixels. The
 * program `contract` (make_contract.c) draws the scenes with the reference and writes the file;
 * `contract-check` (check_contract.c) needs no OpenGL, draws them with the library and compares.
 *
 * What is hashed: every channel of every sample and of the resolved image, of every colour
 * attachment, depth and stencil, and the counts of samples passed and of primitives. Values are
 * hashed, not bytes of memory, so that byte order does not matter.
 *
 * The comparison with the reference allows five differences (tools/guide/verification.md). The
 * contract allows three of them:
 * - NaN: the reference's bits are those of its processor. Each NaN of the reference counts as the
 *   NaN that the library promises for that size (gnomon/backend.h). The library's are hashed as
 *   they are.
 * - Red, green and blue of SRGB8_A8 have a hash of their own. The reference encodes them with the
 *   processor's estimate of the reciprocal square root, which differs between processors, and is a
 *   step off the rounded value in places: on another machine the reference would have other
 *   hashes. So this hash is of the LIBRARY's values. It is written only if every channel is as near
 *   to the reference's as the comparison demands; the file counts the channels and those that
 *   differ.
 * - Resolved depths of 24 bits are hashed as the comparison takes them
 *   (reference/osmesa/samples.c).
 *
 * Denormal floats that the reference flushes to zero, and samples at the top two depths of 24 bits,
 * do not occur in the contract's scenes: `make contract` fails if one does, and wants another
 * seed. */
#ifndef CONTRACT_H
#define CONTRACT_H

#include "../portability/hash.h"
#include "generate.h"

void contract_add(hash *h, uint64_t value);

/* The hashes of a scene. */
typedef struct contract_scene {
    uint32_t made; /* of the scene itself */
    hash pixels;   /* of the reference's pixels and counts */
    hash srgb;     /* of the library's sRGB channels; HASH_EMPTY: there are none */
} contract_scene;

typedef struct contract_class {
    scene_class class;
    uint64_t count;
    contract_scene *scenes;
    hash made, pixels, srgb;                /* of the scenes' hashes, in order */
    uint64_t srgb_channels, srgb_differing; /* channels; those where the reference has another */
} contract_class;

typedef struct contract {
    char reference[160]; /* version and renderer */
    char profile[160];   /* what makes its pixels those of every machine */
    uint64_t seed, scenes;
    contract_class classes[CLASS_COUNT];
    int class_count;
} contract;

/* Returns a contract of this many scenes, shared evenly by the classes, without hashes; false if
 * there is no memory. */
bool contract_allocate(contract *c, uint64_t seed, uint64_t scenes);
void contract_free(contract *c);

/* Sets the hashes of a class from those of its scenes. */
void contract_sum(contract_class *c);

/* Writes the file; false if writing failed. Reads it; false with a message in error, in which case
 * the contract must be freed too. */
bool contract_write(const contract *c, FILE *out);
bool contract_read(contract *c, FILE *in, char *error, size_t error_size);

/* Returns the hash of a scene: of all members that differ from scene_default_draw's, and of all
 * vertices, indices and texels. */
uint32_t contract_hash_scene(const scene *s);

/* Hashes a frame: the values of its sRGB channels, and all others with the counts. In the
 * reference's frames each NaN counts as the library's. Adds to *channels the number of sRGB
 * channels. */
void contract_hash_frame(const scene_frame *f, bool is_reference, hash *pixels, hash *srgb,
                         uint64_t *channels);

/* Returns the number of sRGB channels in which two frames differ. */
uint64_t contract_srgb_differing(const scene_frame *a, const scene_frame *b);

/* What a back end makes of a scene. */
typedef enum contract_verdict {
    CONTRACT_EQUAL,
    CONTRACT_DIFFERS, /* in pixels or counts */
    CONTRACT_REFUSED,
    CONTRACT_NO_MEMORY
} contract_verdict;

contract_verdict contract_draw(const scene *s, gn_backend backend, const contract_scene *expected);

/* Prints the names of the available back ends, as in "portable, sse2". */
void contract_print_backends(FILE *out);

/* Reads the contract from a file, from stdin if the name is "-"; false after a message that begins
 * with the program's name. */
bool contract_open(contract *c, const char *program, const char *name);

#define CONTRACT_FILE "tests/contract/contract.txt"

#endif
