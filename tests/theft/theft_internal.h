/* What the runner's parts share: the random stream with its record, the set of tried arguments, the
 * state of a run, and the steps from one part to the next. */
#ifndef THEFT_INTERNAL_H
#define THEFT_INTERNAL_H

#include "theft.h"

/* Every loop that user code could keep running has one of these limits. */
#define RUNNER_MAX_SHRINK_ATTEMPTS 100000
#define RUNNER_MAX_REPEATS 10000
#define RUNNER_DEFAULT_FAILED_SHRINKS 2000
#define RUNNER_MAX_ZEROS_PAST_END 65536

/* The answers that an alloc callback got, in order: enough to build its instance again. */
struct bit_request {
    uint64_t value;
    uint8_t bits;
};
struct bit_pool {
    struct bit_request *requests;
    size_t count;
    size_t capacity;
};

/* Where requests for bits are answered from: from `replay` if it is set, otherwise from the
 * generator. If `record` is set, it receives the answers. `discarded`: a replay asked for so much
 * beyond the end that its instance must not be used. */
struct bit_stream {
    uint64_t state;
    uint64_t buffer;
    unsigned available;
    struct bit_pool *record;
    const struct bit_pool *replay;
    size_t cursor;
    size_t zeros_past_end;
    bool discarded;
    bool out_of_memory;
};

struct hash_set {
    theft_hash *slots;
    size_t capacity;
    size_t count;
};

/* One argument of a trial; `pool` is empty unless its type autoshrinks. */
struct argument {
    void *instance;
    struct bit_pool pool;
    bool live;
};

struct theft {
    FILE *out;
    struct theft_run_config config;
    uint8_t arity;
    bool hashable;
    size_t total_trials;
    theft_seed run_seed;
    struct bit_stream stream;
    struct hash_set tried;        /* by the trials */
    struct hash_set shrink_tried; /* by the shrinking of the present trial */
    struct theft_run_report report;
    struct theft_print_trial_result_env print_env;
    struct {
        size_t id;
        theft_seed seed;
        struct argument arguments[THEFT_MAX_ARITY];
        void *instances[THEFT_MAX_ARITY];
        size_t shrink_count;
        size_t successful_shrinks;
        size_t failed_shrinks;
    } trial;
};

/* How a step of a run ended. KEPT and REJECTED: whether a simpler argument still fails. SEEN: the
 * arguments were tried before. HALT: stop here, keeping what there is. */
enum step {
    STEP_NEXT,
    STEP_KEPT,
    STEP_REJECTED,
    STEP_SEEN,
    STEP_HALT,
    STEP_ERROR,
    STEP_NO_MEMORY,
};

/* theft_random.c */
uint64_t runner_next_word(uint64_t *state);
uint64_t runner_low_bits(unsigned bits);
void runner_stream_seed(struct bit_stream *stream, theft_seed seed);
bool runner_pool_append(struct bit_pool *pool, struct bit_request request);
bool runner_pool_copy(struct bit_pool *to, const struct bit_pool *from);
void runner_pool_free(struct bit_pool *pool);
uint64_t runner_pool_bits(const struct bit_pool *pool);

/* theft_hash.c: NEXT if `hash` was new, SEEN, or NO_MEMORY. */
enum step runner_hash_set_insert(struct hash_set *set, theft_hash hash);
void runner_hash_set_free(struct hash_set *set);

/* theft_call.c: makes, remembers and releases arguments, and calls the property. With `replay` NULL
 * an argument is made from the generator. On any result but OK nothing is left in *argument. OK
 * with t->stream.discarded returns the instance only to be released unused. */
enum theft_alloc_res runner_make_argument(struct theft *t, const struct theft_type_info *info,
                                          const struct bit_pool *replay, struct argument *argument);
void runner_release_argument(const struct theft_type_info *info, struct argument *argument);
enum step runner_remember_arguments(struct theft *t, struct hash_set *set);
enum theft_trial_res runner_call_property(struct theft *t);

/* theft_fork.c */
bool runner_fork_available(void);
enum theft_trial_res runner_call_forked(struct theft *t,
                                        enum theft_trial_res (*call)(struct theft *t));

/* theft_shrink.c: shrinks all arguments of a failing trial. The attempt functions are one attempt
 * in three parts: whether it may start; what it made; whether the property still fails with the
 * candidate, which the last part takes over. */
enum step runner_shrink(struct theft *t);
enum step runner_attempt_begin(struct theft *t, uint8_t index, uint32_t tactic);
enum step runner_attempt_made(struct theft *t, uint8_t index, uint32_t tactic,
                              enum theft_shrink_post_state state, void *instance);
enum step runner_attempt_run(struct theft *t, uint8_t index, uint32_t tactic,
                             struct argument *candidate);

/* theft_autoshrink.c */
enum step runner_autoshrink(struct theft *t, uint8_t index);

/* theft_report.c: `runner_complain` writes a line on stderr that names the property and seed. */
void runner_complain(const struct theft *t, const char *text);
void runner_print_argument(FILE *f, const struct theft_type_info *info,
                           const struct argument *argument);

#endif
