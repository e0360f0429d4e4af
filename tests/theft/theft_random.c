/* The random stream: a seeded generator, the record of answered requests, and their replay. */
#include "theft_internal.h"

#include <string.h>
#include <time.h>

/* SplitMix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number generators", 2014). */
uint64_t runner_next_word(uint64_t *state)
{
    uint64_t word = *state += UINT64_C(0x9e3779b97f4a7c15);
    word = (word ^ (word >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    word = (word ^ (word >> 27)) * UINT64_C(0x94d049bb133111eb);
    return word ^ (word >> 31);
}

uint64_t runner_low_bits(unsigned bits)
{
    return bits >= 64 ? UINT64_MAX : (UINT64_C(1) << bits) - 1;
}

/* The seed is mixed first: SplitMix64 states that differ by a multiple of its increment would
 * return shifted copies of one sequence. */
void runner_stream_seed(struct bit_stream *stream, theft_seed seed)
{
    uint64_t state = seed;
    memset(stream, 0, sizeof *stream);
    stream->state = runner_next_word(&state);
}

bool runner_pool_append(struct bit_pool *pool, struct bit_request request)
{
    if (pool->count == pool->capacity) {
        size_t capacity = pool->capacity < 16 ? 16 : 2 * pool->capacity;
        if (capacity > SIZE_MAX / sizeof *pool->requests)
            return false;
        struct bit_request *grown = realloc(pool->requests, capacity * sizeof *pool->requests);
        if (grown == NULL)
            return false;
        pool->requests = grown;
        pool->capacity = capacity;
    }
    pool->requests[pool->count++] = request;
    return true;
}

bool runner_pool_copy(struct bit_pool *to, const struct bit_pool *from)
{
    to->count = 0;
    for (size_t i = 0; i < from->count; ++i)
        if (!runner_pool_append(to, from->requests[i]))
            return false;
    return true;
}

void runner_pool_free(struct bit_pool *pool)
{
    free(pool->requests);
    memset(pool, 0, sizeof *pool);
}

uint64_t runner_pool_bits(const struct bit_pool *pool)
{
    uint64_t bits = 0;
    for (size_t i = 0; i < pool->count; ++i)
        bits += pool->requests[i].bits;
    return bits;
}

static uint64_t generated_bits(struct bit_stream *stream, unsigned bits)
{
    uint64_t value = stream->buffer;
    if (bits <= stream->available) {
        stream->buffer >>= bits;
        stream->available -= bits;
    } else {
        const unsigned missing = bits - stream->available;
        const uint64_t word = runner_next_word(&stream->state);
        value |= word << stream->available;
        stream->buffer = missing == 64 ? 0 : word >> missing;
        stream->available = 64 - missing;
    }
    return value & runner_low_bits(bits);
}

/* An alloc callback may wait for a bit that is set, and zeros for ever would hang it. So after a
 * long run of zeros beyond the end it gets generated bits, and the candidate is thrown away. */
static uint64_t replayed_bits(struct bit_stream *stream, unsigned bits)
{
    if (stream->cursor < stream->replay->count)
        return stream->replay->requests[stream->cursor++].value & runner_low_bits(bits);
    if (stream->zeros_past_end < RUNNER_MAX_ZEROS_PAST_END) {
        ++stream->zeros_past_end;
        return 0;
    }
    stream->discarded = true;
    return generated_bits(stream, bits);
}

uint64_t theft_random_bits(struct theft *t, uint8_t bits)
{
    struct bit_stream *stream = &t->stream;
    if (bits > 64) {
        runner_complain(t, "theft_random_bits: more than 64 bits asked at once");
        abort();
    }
    if (bits == 0)
        return 0;
    const uint64_t value =
        stream->replay != NULL ? replayed_bits(stream, bits) : generated_bits(stream, bits);
    if (stream->record != NULL && !stream->discarded && !stream->out_of_memory) {
        const struct bit_request request = {value, bits};
        stream->out_of_memory = !runner_pool_append(stream->record, request);
    }
    return value;
}

void theft_random_bits_bulk(struct theft *t, uint32_t bits, uint64_t *buf)
{
    for (; bits >= 64; bits -= 64)
        *buf++ = theft_random_bits(t, 64);
    if (bits > 0)
        *buf = theft_random_bits(t, (uint8_t)bits);
}

uint64_t theft_random(struct theft *t)
{
    return theft_random_bits(t, 64);
}

#if THEFT_USE_FLOATING_POINT
double theft_random_double(struct theft *t)
{
    return (double)theft_random_bits(t, 53) * 0x1p-53;
}

/* Each request is accepted with probability above 1/2, so the modulo at the end is met with
 * probability below 2^-64; a value that shrinks stays accepted, which keeps a replay aligned. */
uint64_t theft_random_choice(struct theft *t, uint64_t ceil)
{
    if (ceil < 2)
        return 0;
    uint8_t bits = 0;
    for (uint64_t greatest = ceil - 1; greatest != 0; greatest >>= 1)
        ++bits;
    uint64_t value = theft_random_bits(t, bits);
    for (int retries = 0; value >= ceil && retries < 64; ++retries)
        value = theft_random_bits(t, bits);
    return value % ceil;
}
#endif

/* The call count keeps calls apart that see the same clock. */
theft_seed theft_seed_of_time(void)
{
    static uint64_t calls;
    struct timespec now = {0};
    (void)timespec_get(&now, TIME_UTC);
    uint64_t state = (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec;
    state = runner_next_word(&state) + calls++;
    return runner_next_word(&state);
}
