/* What the fuzz targets share. */
#include "fuzz.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

fuzz_input fuzz_begin(const uint8_t *bytes, size_t size)
{
    fuzz_input in = {bytes, size, 0, 0};

    for (size_t i = 0; i < size && i < 4; ++i)
        in.tail |= (uint32_t)bytes[i] << 8 * i;
    return in;
}

uint8_t fuzz_byte(fuzz_input *in)
{
    if (in->at < in->size)
        return in->bytes[in->at++];
    in->tail = in->tail * 1664525u + 1013904223u;
    return (uint8_t)(in->tail >> 24);
}

static uint32_t number(fuzz_input *in, int bytes)
{
    uint32_t value = 0;

    for (int i = 0; i < bytes; ++i)
        value |= (uint32_t)fuzz_byte(in) << 8 * i;
    return value;
}

uint32_t fuzz_word(fuzz_input *in)
{
    return number(in, 4);
}

uint32_t fuzz_magnitude(fuzz_input *in)
{
    const uint32_t word = fuzz_word(in);

    return word >> fuzz_below(in, 32);
}

uint32_t fuzz_below(fuzz_input *in, uint32_t n)
{
    return number(in, n <= 256 ? 1 : n <= 65536 ? 2 : 4) % n;
}

bool fuzz_rarely(fuzz_input *in, uint32_t n)
{
    return fuzz_byte(in) % n == n - 1;
}

static float float_of(uint32_t bits)
{
    float f;

    memcpy(&f, &bits, sizeof f);
    return f;
}

float fuzz_float(fuzz_input *in)
{
    static const float odd[] = {0.0f,
                                1.0f,
                                0.5f,
                                2.0f,
                                3.0f,
                                0x1p-24f,
                                1.0f - 0x1p-24f,
                                1.0f + 0x1p-23f,
                                16777216.0f,
                                2147483648.0f,
                                4294967296.0f,
                                32768.0f,
                                16384.0f,
                                255.0f,
                                FLT_MAX,
                                FLT_MIN,
                                FLT_MIN / 2,
                                0x1p-149f,
                                0x1p64f,
                                0x1p-64f,
                                0x1p126f,
                                GN_PI,
                                INFINITY,
                                NAN};
    const uint8_t kind = fuzz_byte(in);
    const uint32_t count = sizeof odd / sizeof odd[0];

    switch (kind >> 6) {
    case 0:
        return kind & 32 ? -odd[(kind & 31) % count] : odd[(kind & 31) % count];
    case 1:
        return (float)(int8_t)fuzz_byte(in) * (1.0f / 64.0f);
    case 2: /* any power of two, and its neighbours */
        return float_of((number(in, 1) << 23 | (uint32_t)(kind & 1) << 31) + (kind >> 1 & 3) - 1);
    default:
        return float_of(number(in, 4));
    }
}

float fuzz_tame(fuzz_input *in)
{
    const uint8_t byte = fuzz_byte(in);

    return byte == 0x80 ? fuzz_float(in) : (float)(int8_t)byte * (1.0f / 64.0f);
}

void fuzz_fail(const char *claim, const char *file, int line)
{
    fprintf(stderr, "%s:%d: does not hold: %s\n", file, line, claim);
    fflush(NULL);
    abort();
}

void *fuzz_memory(size_t size)
{
    void *memory = size ? malloc(size) : NULL;

    if (size && !memory) {
        fprintf(stderr, "fuzz: not enough memory for %zu bytes\n", size);
        exit(EXIT_FAILURE);
    }
    return memory;
}

/* Random numbers */

static struct {
    fuzz_input begin, in;
    uint64_t state;
} feed;

void fuzz_random_seed(uint64_t seed);
uint64_t fuzz_random_bits(void);

void fuzz_random_seed(uint64_t seed)
{
    fuzz_input first = feed.begin;

    feed.in = feed.begin;
    feed.state = fuzz_word(&first) ^ seed;
}

void fuzz_feed_random(const fuzz_input *in)
{
    feed.begin = *in;
    fuzz_random_seed(0);
}

/* Two bytes of the input are the highest bits, on which choices depend; the others follow from the
 * place in the sequence, as everything does behind the input's end. */
uint64_t fuzz_random_bits(void)
{
    uint64_t z = feed.state += UINT64_C(0x9E3779B97F4A7C15); /* splitmix64, as in random.h */

    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    z ^= z >> 31;
    if (feed.in.at + 2 > feed.in.size)
        return z;
    return (uint64_t)number(&feed.in, 2) << 48 | z >> 16;
}

void fuzz_run_tasks(void *user, gn_task *task, void *context, uint32_t count)
{
    uint32_t *const order = user;
    uint32_t step = 1;

    /* Tasks first, first + step, ... modulo count are all tasks if step and count have no common
     * divisor; count - 1 has none, and runs backwards. */
    *order = *order * 1664525u + 1013904223u;
    if (*order >> 31 && count > 1)
        step = count - 1;
    for (uint32_t i = 0, at = count ? (*order >> 8) % count : 0; i < count; ++i) {
        task(context, at);
        at = (uint32_t)(((uint64_t)at + step) % count);
    }
}

bool fuzz_same_float(float a, float b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (isnan(a) && isnan(b));
}
