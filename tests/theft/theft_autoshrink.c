/* Autoshrinking: simpler instances from simpler records of the random bits they were made of.
 *
 * A candidate is an edited copy of the present record. The alloc callback is replayed on the
 * candidate while a new record is taken. The new record counts, because it holds what was really
 * consumed: it replaces the present record if the property still fails and if it is smaller in this
 * order: fewer bits, then fewer requests, then lower values, earlier requests first. The order has
 * no infinite descent, so shrinking ends whatever the callbacks do; the limits only bound the time.
 * The idea of shrinking the choices instead of the values is MacIver and Donaldson's ("Test-case
 * reduction via test-case generation", 2020). */
#include "theft_internal.h"

#include <string.h>

enum pass {
    PASS_REMOVE,
    PASS_ZERO,
    PASS_LOWER,
    PASS_SHORTEN,
    PASS_MOVE,
    PASS_COUNT,
};

#define NEIGHBOURHOOD 8

/* `stopped` is NEXT while shrinking goes on; HALT ends all shrinking, `exhausted` only this
 * argument's. */
struct shrinker {
    struct theft *t;
    const struct theft_type_info *type;
    uint8_t index;
    uint32_t pass;
    struct bit_pool candidate;
    size_t failed_in_a_row;
    size_t failed_limit;
    bool exhausted;
    enum step stopped;
};

static const struct bit_pool *present(const struct shrinker *s)
{
    return &s->t->trial.arguments[s->index].pool;
}

static bool running(const struct shrinker *s)
{
    return s->stopped == STEP_NEXT && !s->exhausted;
}

static bool is_smaller(const struct bit_pool *a, const struct bit_pool *b)
{
    const uint64_t a_bits = runner_pool_bits(a);
    const uint64_t b_bits = runner_pool_bits(b);
    if (a_bits != b_bits)
        return a_bits < b_bits;
    if (a->count != b->count)
        return a->count < b->count;
    for (size_t i = 0; i < a->count; ++i)
        if (a->requests[i].value != b->requests[i].value)
            return a->requests[i].value < b->requests[i].value;
    return false;
}

/* Makes the candidate a copy of the present record. Returns false if the pass must end. */
static bool start_candidate(struct shrinker *s)
{
    if (!running(s))
        return false;
    if (!runner_pool_copy(&s->candidate, present(s))) {
        s->stopped = STEP_NO_MEMORY;
        return false;
    }
    return true;
}

static void remove_requests(struct bit_pool *pool, size_t start, size_t count)
{
    memmove(pool->requests + start, pool->requests + start + count,
            (pool->count - start - count) * sizeof *pool->requests);
    pool->count -= count;
}

/* Replays the candidate into *argument. Returns false if there is no usable instance. */
static bool replay_candidate(struct shrinker *s, struct argument *argument)
{
    struct theft *t = s->t;
    runner_stream_seed(&t->stream, t->trial.seed);
    const enum theft_alloc_res result = runner_make_argument(t, s->type, &s->candidate, argument);
    if (t->stream.out_of_memory) {
        s->stopped = STEP_NO_MEMORY;
    } else if (result == THEFT_ALLOC_ERROR) {
        runner_complain(t, "an alloc callback returned an error while shrinking");
        s->stopped = STEP_ERROR;
    }
    if (result == THEFT_ALLOC_OK && (s->stopped != STEP_NEXT || t->stream.discarded)) {
        runner_release_argument(s->type, argument);
        return false;
    }
    return result == THEFT_ALLOC_OK;
}

/* Tries the candidate. Returns true if it has become the present record. */
static bool try_candidate(struct shrinker *s)
{
    struct theft *t = s->t;
    enum step step = runner_attempt_begin(t, s->index, s->pass);
    if (step != STEP_NEXT) {
        s->stopped = step;
        return false;
    }
    struct argument argument;
    bool usable = replay_candidate(s, &argument);
    if (usable && !is_smaller(&argument.pool, present(s))) {
        runner_release_argument(s->type, &argument);
        usable = false;
    }
    if (s->stopped != STEP_NEXT)
        return false;
    step = runner_attempt_made(t, s->index, s->pass,
                               usable ? THEFT_SHRINK_POST_SHRUNK : THEFT_SHRINK_POST_SHRINK_FAILED,
                               usable ? argument.instance : NULL);
    if (step != STEP_NEXT) {
        s->stopped = step;
        if (usable)
            runner_release_argument(s->type, &argument);
        return false;
    }
    if (!usable)
        return false;
    step = runner_attempt_run(t, s->index, s->pass, &argument);
    if (step == STEP_KEPT) {
        s->failed_in_a_row = 0;
        return true;
    }
    if (step == STEP_REJECTED) {
        ++s->failed_in_a_row;
        s->exhausted = s->failed_in_a_row >= s->failed_limit;
    } else if (step != STEP_SEEN) {
        s->stopped = step;
    }
    return false;
}

/* Block sizes to try, large ones first: halves, then every size that one element of an array may
 * have. */
static size_t next_block_size(size_t size)
{
    if (size > 2 * NEIGHBOURHOOD)
        return size / 2;
    return size > NEIGHBOURHOOD ? NEIGHBOURHOOD : size - 1;
}

/* Large blocks move by their own size, small ones by one request. */
static size_t block_stride(size_t size)
{
    return size > NEIGHBOURHOOD ? size : 1;
}

/* Leaves out blocks of requests, from the end. */
static void remove_blocks(struct shrinker *s)
{
    for (size_t size = present(s)->count; size > 0; size = next_block_size(size)) {
        const size_t stride = block_stride(size);
        size_t end = present(s)->count;
        while (end >= size && start_candidate(s)) {
            remove_requests(&s->candidate, end - size, size);
            if (try_candidate(s))
                end -= size;
            else
                end = end > stride ? end - stride : 0;
            if (end > present(s)->count)
                end = present(s)->count;
        }
    }
}

/* Sets blocks of two or more values to 0, for values that only fail together; single values are
 * lower_values' part. */
static void zero_blocks(struct shrinker *s)
{
    for (size_t size = present(s)->count; size > 1; size = next_block_size(size)) {
        const size_t stride = block_stride(size);
        for (size_t start = 0; start + size <= present(s)->count; start += stride) {
            if (!start_candidate(s))
                return;
            uint64_t seen = 0;
            for (size_t i = start; i < start + size; ++i) {
                seen |= s->candidate.requests[i].value;
                s->candidate.requests[i].value = 0;
            }
            if (seen != 0)
                (void)try_candidate(s);
        }
    }
}

/* Tries one value at request i. After success the present value at request i is at most this
 * one. */
static bool try_value(struct shrinker *s, size_t i, uint64_t value)
{
    if (i >= present(s)->count || present(s)->requests[i].value <= value || !start_candidate(s))
        return false;
    s->candidate.requests[i].value = value;
    return try_candidate(s);
}

/* Finds the least value of each request: by bisection, which is exact if failing is monotone in the
 * value, then by clearing each set bit by itself, for flags and masks. */
static void lower_values(struct shrinker *s)
{
    for (size_t i = 0; i < present(s)->count && running(s); ++i) {
        uint64_t high = present(s)->requests[i].value;
        if (high == 0 || try_value(s, i, 0))
            continue;
        uint64_t low = 0;
        while (high - low > 1 && running(s)) {
            const uint64_t middle = low + (high - low) / 2;
            if (try_value(s, i, middle))
                high = middle;
            else
                low = middle;
        }
        for (unsigned bit = 64; bit-- > 0 && i < present(s)->count;) {
            const uint64_t value = present(s)->requests[i].value;
            if ((value >> bit & 1) != 0)
                (void)try_value(s, i, value & ~(UINT64_C(1) << bit));
        }
    }
}

/* Returns how many requests fewer an instance consumes if the value of request i is one less; 0 if
 * not fewer. This finds the length fields, and how many requests an element takes. */
static size_t requests_saved(struct shrinker *s, size_t i)
{
    struct argument argument;
    if (present(s)->requests[i].value == 0 || !start_candidate(s))
        return 0;
    --s->candidate.requests[i].value;
    if (!replay_candidate(s, &argument))
        return 0;
    const size_t before = present(s)->count;
    const size_t after = argument.pool.count;
    runner_release_argument(s->type, &argument);
    return after < before ? before - after : 0;
}

/* Leaves out `elements` elements of `size` requests after the length field i at the first place
 * where the property still fails. */
static bool shorten_by(struct shrinker *s, size_t i, size_t elements, size_t size)
{
    const size_t removed = elements * size;
    const size_t stride = elements == 1 ? 1 : removed;
    for (size_t start = i + 1; start + removed <= present(s)->count; start += stride) {
        if (!start_candidate(s))
            return false;
        s->candidate.requests[i].value -= elements;
        remove_requests(&s->candidate, start, removed);
        if (try_candidate(s))
            return true;
    }
    return false;
}

/* Lowers a length and leaves out as many elements anywhere behind it, not just the last ones. */
static void shorten_sequences(struct shrinker *s)
{
    for (size_t i = 0; i < present(s)->count && running(s); ++i) {
        const size_t size = requests_saved(s, i);
        if (size == 0)
            continue;
        const size_t most = (present(s)->count - i - 1) / size;
        const uint64_t length = present(s)->requests[i].value;
        size_t elements = length < most ? (size_t)length : most;
        while (elements > 0 && running(s))
            if (i >= present(s)->count || present(s)->requests[i].value < elements ||
                !shorten_by(s, i, elements, size))
                elements /= 2;
    }
}

/* Takes `amount` from request i and adds it to request j, or exchanges the two values if `amount`
 * is 0. */
static bool try_move(struct shrinker *s, size_t i, size_t j, uint64_t amount)
{
    if (j >= present(s)->count || !start_candidate(s))
        return false;
    struct bit_request *from = &s->candidate.requests[i];
    struct bit_request *to = &s->candidate.requests[j];
    const uint64_t room = runner_low_bits(to->bits) - to->value;
    if (from->bits != to->bits || amount > from->value || amount > room)
        return false;
    if (amount == 0) {
        if (from->value <= to->value)
            return false;
        const uint64_t value = from->value;
        from->value = to->value;
        to->value = value;
    } else {
        from->value -= amount;
        to->value += amount;
    }
    return try_candidate(s);
}

/* Moves value from a request to a later request of equal width near it, or exchanges the two
 * values. Moving empties one of two addends, which other passes then remove; exchanging sorts. */
static void move_values(struct shrinker *s)
{
    for (size_t i = 0; i < present(s)->count && running(s); ++i) {
        for (size_t j = i + 1; j <= i + NEIGHBOURHOOD && j < present(s)->count; ++j) {
            const struct bit_request from = present(s)->requests[i];
            const struct bit_request to = present(s)->requests[j];
            const uint64_t room = runner_low_bits(to.bits) - to.value;
            const uint64_t most = from.value < room ? from.value : room;
            if (from.value == 0 || from.bits != to.bits)
                continue;
            if ((most > 0 && try_move(s, i, j, most)) || try_move(s, i, j, 0))
                continue;
            if ((most > 1 && try_move(s, i, j, most / 2)) || most == 0)
                continue;
            (void)try_move(s, i, j, 1);
        }
    }
}

static void run_pass(struct shrinker *s)
{
    switch ((enum pass)s->pass) {
    case PASS_REMOVE:
        remove_blocks(s);
        break;
    case PASS_ZERO:
        zero_blocks(s);
        break;
    case PASS_LOWER:
        lower_values(s);
        break;
    case PASS_SHORTEN:
        shorten_sequences(s);
        break;
    case PASS_MOVE:
        move_values(s);
        break;
    case PASS_COUNT:
        break;
    }
}

/* Runs the passes in turn until a whole round of them changes nothing. */
enum step runner_autoshrink(struct theft *t, uint8_t index)
{
    const struct theft_type_info *type = t->config.type_info[index];
    const size_t limit = type->autoshrink_config.max_failed_shrinks;
    struct shrinker s = {
        .t = t,
        .type = type,
        .index = index,
        .failed_limit = limit == 0 ? RUNNER_DEFAULT_FAILED_SHRINKS : limit,
        .stopped = STEP_NEXT,
    };
    size_t successes;
    do {
        successes = t->trial.successful_shrinks;
        for (s.pass = 0; s.pass < PASS_COUNT && running(&s); ++s.pass)
            run_pass(&s);
    } while (running(&s) && t->trial.successful_shrinks > successes);
    runner_pool_free(&s.candidate);
    return s.stopped;
}
