/* Property runner for machines without libtheft: the public interface of theft 0.4, with an
 * implementation of its own. Differences that a test may notice: the random sequences; the text
 * printed; autoshrinking, which here is a fixed series of passes over the recorded requests and
 * ends at a local minimum or after 100000 attempts for one failing trial. */
#ifndef THEFT_H
#define THEFT_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#define THEFT_VERSION_MAJOR 0
#define THEFT_VERSION_MINOR 4
#define THEFT_VERSION_PATCH 5

#include "theft_types.h"

/* Calls a property with `trials` sets of generated arguments. A set that fails is shrunk and
 * reported, and the run goes on. The outcome depends on the configuration only. Misuse is reported
 * on stderr and returns THEFT_RUN_ERROR_BAD_ARGS. Trials that skip or repeat earlier arguments
 * count towards `trials`. */
enum theft_run_res theft_run(const struct theft_run_config *cfg);

/* Makes the instance of `seed`, prints it to `f` and frees it. */
enum theft_generate_res theft_generate(FILE *f, theft_seed seed, const struct theft_type_info *info,
                                       void *hook_env);

/* Random bits, for alloc callbacks, shrink callbacks and properties. A request is the unit that
 * autoshrinking changes, so ask for one decision at a time and for no more bits than it needs.
 * While autoshrinking replays a shortened record, requests beyond its end return 0. */

/* Returns `bits` random bits as a number. For 0 bits returns 0 and consumes nothing; more than 64
 * abort. */
uint64_t theft_random_bits(struct theft *t, uint8_t bits);

/* Writes `bits` random bits into the ceil(bits / 64) words of `buf`, least significant first;
 * unused high bits are 0. Each word is a separate request. */
void theft_random_bits_bulk(struct theft *t, uint32_t bits, uint64_t *buf);

/* Returns 64 random bits. */
uint64_t theft_random(struct theft *t);

#if THEFT_USE_FLOATING_POINT
/* Returns a multiple of 2^-53 in [0, 1), uniformly, by one request. */
double theft_random_double(struct theft *t);

/* Returns a number below `ceil`, uniformly, by rejection of requests as wide as ceil - 1. For a
 * `ceil` of 0 or 1 returns 0 without any request. */
uint64_t theft_random_choice(struct theft *t, uint64_t ceil);
#endif

/* 64-bit FNV-1a, in one call or piece by piece; theft_hash_done also resets. */
theft_hash theft_hash_onepass(const uint8_t *data, size_t bytes);
void theft_hash_init(struct theft_hasher *h);
void theft_hash_sink(struct theft_hasher *h, const uint8_t *data, size_t bytes);
theft_hash theft_hash_done(struct theft_hasher *h);

/* The state of a line of dots; all zero is a valid start. */
#define THEFT_PRINT_TRIAL_RESULT_ENV_TAG 0xe7a6
struct theft_print_trial_result_env {
    uint16_t tag;
    const uint8_t max_column; /* 0: THEFT_DEF_MAX_COLUMNS */
    uint8_t column;
    size_t scale_pass;
    size_t scale_skip;
    size_t scale_dup;
    size_t consec_pass;
    size_t consec_skip;
    size_t consec_dup;
};

/* Prints one character for a trial: `.` pass, `F` fail, `s` skip, `d` duplicate, `E` error. Each
 * full line makes passes, skips and duplicates ten times as rare; repeats are not shown. */
void theft_print_trial_result(struct theft_print_trial_result_env *print_env,
                              const struct theft_hook_trial_post_info *info);

/* Prints the seed and each argument; the default counterexample hook. */
enum theft_hook_counterexample_res
theft_print_counterexample(const struct theft_hook_counterexample_info *info, void *env);

void theft_print_run_pre_info(FILE *f, const struct theft_hook_run_pre_info *info);
void theft_print_run_post_info(FILE *f, const struct theft_hook_run_post_info *info);

/* Ready hooks. The first three are the defaults; the last ends a run after its first failure. */
enum theft_hook_run_pre_res
theft_hook_run_pre_print_info(const struct theft_hook_run_pre_info *info, void *env);
enum theft_hook_run_post_res
theft_hook_run_post_print_info(const struct theft_hook_run_post_info *info, void *env);
enum theft_hook_trial_post_res
theft_hook_trial_post_print_result(const struct theft_hook_trial_post_info *info, void *env);
enum theft_hook_trial_pre_res
theft_hook_first_fail_halt(const struct theft_hook_trial_pre_info *info, void *env);

/* `hooks.env` of the configuration. */
void *theft_hook_get_env(struct theft *t);

/* The file that the runner prints to; stdout at first. */
void theft_set_output_stream(struct theft *t, FILE *out);

theft_seed theft_seed_of_time(void);
void theft_generic_free_cb(void *instance, void *env);
const char *theft_trial_res_str(enum theft_trial_res res);
const char *theft_run_res_str(enum theft_run_res res);

/* Ready generators, all autoshrinking. Instances are pointers to the type. `env` may point to a
 * limit L of that type. Unsigned values are then below L (L >= 1), signed and floating values in
 * [-L, L) (L > 0), uniformly; an array has at most *(size_t *)env elements. Without `env`, integers
 * have a random width, so that small integers are frequent; floating values are any bit pattern, so
 * also infinities and NaNs; arrays have at most 64 elements. Arrays hold no zero but the one after
 * their last element. */
enum theft_builtin_type_info {
    THEFT_BUILTIN_bool,
    THEFT_BUILTIN_uint,
    THEFT_BUILTIN_uint8_t,
    THEFT_BUILTIN_uint16_t,
    THEFT_BUILTIN_uint32_t,
    THEFT_BUILTIN_uint64_t,
    THEFT_BUILTIN_size_t,
    THEFT_BUILTIN_int,
    THEFT_BUILTIN_int8_t,
    THEFT_BUILTIN_int16_t,
    THEFT_BUILTIN_int32_t,
    THEFT_BUILTIN_int64_t,
#if THEFT_USE_FLOATING_POINT
    THEFT_BUILTIN_float,
    THEFT_BUILTIN_double,
#endif
    THEFT_BUILTIN_char_ARRAY,
    THEFT_BUILTIN_uint8_t_ARRAY,
};

/* Returns NULL for a value that is no theft_builtin_type_info. */
const struct theft_type_info *theft_get_builtin_type_info(enum theft_builtin_type_info type);

/* Returns a copy, for setting `env`; all zero for a value that is no theft_builtin_type_info. */
void theft_copy_builtin_type_info(enum theft_builtin_type_info type, struct theft_type_info *info);

#endif
