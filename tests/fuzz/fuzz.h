/* What the fuzz targets share. A target is one file fuzz_NAME.c with LLVMFuzzerTestOneInput, which
 * libFuzzer, AFL++ and replay.c call with bytes. It draws its values from those bytes one after
 * another, so that a fuzzer that changes a byte changes a value. Behind the last byte the values
 * follow from the first four bytes, so that a short input makes a whole draw, not an empty one. A
 * target ends the program by FUZZ_REQUIRE if a claim does not hold; the sanitizers find the rest.
 */
#ifndef FUZZ_H
#define FUZZ_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <gnomon.h>

/* The fuzzers' entry. Returns 0, or -1 for an input that is not worth keeping. */
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

typedef struct fuzz_input {
    const uint8_t *bytes;
    size_t size, at;
    uint32_t tail; /* of the bytes behind the end */
} fuzz_input;

fuzz_input fuzz_begin(const uint8_t *bytes, size_t size);

/* Returns the next byte; the next four as a number. */
uint8_t fuzz_byte(fuzz_input *in);
uint32_t fuzz_word(fuzz_input *in);

/* Returns a number that is spread over all lengths in bits. */
uint32_t fuzz_magnitude(fuzz_input *in);

/* Returns a number below n, which is above 0, from as few bytes as n needs. */
uint32_t fuzz_below(fuzz_input *in, uint32_t n);

/* Returns true for one byte in n; n is 2 to 256. */
bool fuzz_rarely(fuzz_input *in, uint32_t n);

/* Returns any float: a number with which arithmetic goes wrong, one of few digits, or any bits. */
float fuzz_float(fuzz_input *in);

/* Returns a number from -2 to 2 of few digits, now and then any float. */
float fuzz_tame(fuzz_input *in);

/* Ends the program with a message if a claim does not hold. */
#define FUZZ_REQUIRE(claim)                                                                        \
    do {                                                                                           \
        if (!(claim))                                                                              \
            fuzz_fail(#claim, __FILE__, __LINE__);                                                 \
    } while (0)
_Noreturn void fuzz_fail(const char *claim, const char *file, int line);

/* Returns `size` bytes without values, of which not one more may be read or written; null only for
 * size 0. The caller frees the memory. */
void *fuzz_memory(size_t size);

/* From now on the random numbers of scenes and properties (tests/parity/random.h) are the rest of
 * the input; behind its end they follow from its first bytes. */
void fuzz_feed_random(const fuzz_input *in);

/* A gn_parallel that runs the tasks on the calling thread, in an order that depends on *user, a
 * uint32_t. */
void fuzz_run_tasks(void *user, gn_task *task, void *context, uint32_t count);

/* Whether a is b, or both are NaN. */
bool fuzz_same_float(float a, float b);

#endif
