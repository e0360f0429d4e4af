/* Types of the property runner: callbacks for generated arguments, hooks, configuration. Names,
 * values and order follow the public interface of theft 0.4, so that a test compiles against
 * either. */
#ifndef THEFT_TYPES_H
#define THEFT_TYPES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#ifndef THEFT_USE_FLOATING_POINT
#define THEFT_USE_FLOATING_POINT 1
#endif

#define THEFT_DEF_TRIALS 100
#define THEFT_DEF_MAX_COLUMNS 72
#define THEFT_DEF_EXIT_TIMEOUT_MSEC 100
#define THEFT_MAX_ARITY 7
/* Kept for sources that name them; `bloom_bits` has no effect. */
#define THEFT_BLOOM_BITS_MIN 13
#define THEFT_BLOOM_BITS_MAX 33

/* The runner's state; only ever handled by pointer. */
struct theft;
struct theft_type_info;
struct theft_run_config;

typedef uint64_t theft_seed;
typedef uint64_t theft_hash;

struct theft_hasher {
    theft_hash accum;
};

/* How many trials ended in each way. */
struct theft_run_report {
    size_t pass;
    size_t fail;
    size_t skip;
    size_t dup;
};

/* The result of a property. DUP is for the runner only: a property that returns it is in error. */
enum theft_trial_res {
    THEFT_TRIAL_PASS,
    THEFT_TRIAL_FAIL,
    THEFT_TRIAL_SKIP,  /* the arguments do not meet the property's precondition */
    THEFT_TRIAL_DUP,   /* these arguments were tried before; the property was not called */
    THEFT_TRIAL_ERROR, /* stop the whole run */
};

enum theft_run_res {
    THEFT_RUN_PASS = 0,
    THEFT_RUN_FAIL = 1,
    THEFT_RUN_SKIP = 2, /* nothing failed, but nothing passed either */
    THEFT_RUN_ERROR = 3,
    THEFT_RUN_ERROR_MEMORY = -1,
    THEFT_RUN_ERROR_BAD_ARGS = -2,
};

enum theft_generate_res {
    THEFT_GENERATE_OK = 0,
    THEFT_GENERATE_SKIP = 1,
    THEFT_GENERATE_ERROR_ALLOC = -1,
    THEFT_GENERATE_ERROR_MEMORY = -2,
    THEFT_GENERATE_ERROR_BAD_ARGS = -3,
};

/* A property of one to seven generated arguments. It is called again and again while shrinking, so
 * it must not change its arguments nor depend on anything else. Random bits that it asks for
 * restart at one place at each call of a trial. */
typedef enum theft_trial_res theft_propfun1(struct theft *t, void *arg1);
typedef enum theft_trial_res theft_propfun2(struct theft *t, void *arg1, void *arg2);
typedef enum theft_trial_res theft_propfun3(struct theft *t, void *arg1, void *arg2, void *arg3);
typedef enum theft_trial_res theft_propfun4(struct theft *t, void *arg1, void *arg2, void *arg3,
                                            void *arg4);
typedef enum theft_trial_res theft_propfun5(struct theft *t, void *arg1, void *arg2, void *arg3,
                                            void *arg4, void *arg5);
typedef enum theft_trial_res theft_propfun6(struct theft *t, void *arg1, void *arg2, void *arg3,
                                            void *arg4, void *arg5, void *arg6);
typedef enum theft_trial_res theft_propfun7(struct theft *t, void *arg1, void *arg2, void *arg3,
                                            void *arg4, void *arg5, void *arg6, void *arg7);

/* Builds an instance from random bits into *output. Only OK passes an instance on; on SKIP and
 * ERROR the callback releases what it has made. Equal bits must make equal instances. With
 * autoshrinking, smaller bit values must make simpler instances, and all-zero bits the simplest. */
enum theft_alloc_res {
    THEFT_ALLOC_OK,
    THEFT_ALLOC_SKIP,
    THEFT_ALLOC_ERROR,
};
typedef enum theft_alloc_res theft_alloc_cb(struct theft *t, void *env, void **output);

/* Releases an instance; called exactly once for each instance that alloc or shrink passed on. */
typedef void theft_free_cb(void *instance, void *env);

/* Equal instances have equal hashes. If every argument has a hash or autoshrinks, repeated
 * combinations of arguments are not tried again. */
typedef theft_hash theft_hash_cb(const void *instance, void *env);

/* Builds a simpler instance into *output: a new one, never `instance` itself. Tactics are numbered
 * from 0 and start again at 0 after each success. Put those that remove most first. */
enum theft_shrink_res {
    THEFT_SHRINK_OK,
    THEFT_SHRINK_DEAD_END,        /* this tactic has nothing to offer here */
    THEFT_SHRINK_NO_MORE_TACTICS, /* and no later tactic has anything either */
    THEFT_SHRINK_ERROR,           /* stop the whole run */
};
typedef enum theft_shrink_res theft_shrink_cb(struct theft *t, const void *instance,
                                              uint32_t tactic, void *env, void **output);

typedef void theft_print_cb(FILE *f, const void *instance, void *env);

/* What a counterexample shows of an autoshrunk argument; the print callback, if any, is always
 * used. DEFAULT shows the requests too if there is no print callback. */
enum theft_autoshrink_print_mode {
    THEFT_AUTOSHRINK_PRINT_DEFAULT = 0x00,
    THEFT_AUTOSHRINK_PRINT_USER = 0x01,
    THEFT_AUTOSHRINK_PRINT_BIT_POOL = 0x02,
    THEFT_AUTOSHRINK_PRINT_REQUESTS = 0x04,
    THEFT_AUTOSHRINK_PRINT_ALL = 0x07,
};

struct theft_autoshrink_config {
    bool enable;
    size_t pool_size; /* expected bits of an instance, a hint; 0: the default */
    enum theft_autoshrink_print_mode print_mode;
    /* Calls of the property in a row without progress after which an argument counts as minimal; 0
     * means 2000. A local minimum usually ends shrinking earlier. */
    size_t max_failed_shrinks;
};

/* How to make and handle one argument. Only `alloc` is required. With autoshrinking, `hash` and
 * `shrink` must be NULL. `env` goes to every callback here. */
struct theft_type_info {
    theft_alloc_cb *alloc;
    theft_free_cb *free;
    theft_hash_cb *hash;
    theft_print_cb *print;
    theft_shrink_cb *shrink;
    struct theft_autoshrink_config autoshrink_config;
    void *env;
};

/* Hooks, in the order a run meets them. ERROR from any of them ends the run with
 * THEFT_RUN_ERROR. */

/* Before the first trial. */
enum theft_hook_run_pre_res {
    THEFT_HOOK_RUN_PRE_ERROR,
    THEFT_HOOK_RUN_PRE_CONTINUE,
};
struct theft_hook_run_pre_info {
    const char *prop_name;
    size_t total_trials;
    theft_seed run_seed;
};
typedef enum theft_hook_run_pre_res
theft_hook_run_pre_cb(const struct theft_hook_run_pre_info *info, void *env);

/* After the last trial; not called when the run ends in an error. */
enum theft_hook_run_post_res {
    THEFT_HOOK_RUN_POST_ERROR,
    THEFT_HOOK_RUN_POST_CONTINUE,
};
struct theft_hook_run_post_info {
    const char *prop_name;
    size_t total_trials;
    theft_seed run_seed;
    struct theft_run_report report;
};
typedef enum theft_hook_run_post_res
theft_hook_run_post_cb(const struct theft_hook_run_post_info *info, void *env);

/* Before a trial's arguments are made. HALT ends the run with what has been counted so far. */
enum theft_hook_gen_args_pre_res {
    THEFT_HOOK_GEN_ARGS_PRE_ERROR,
    THEFT_HOOK_GEN_ARGS_PRE_CONTINUE,
    THEFT_HOOK_GEN_ARGS_PRE_HALT,
};
struct theft_hook_gen_args_pre_info {
    const char *prop_name;
    size_t total_trials;
    size_t trial_id;
    size_t failures;
    theft_seed run_seed;
    theft_seed trial_seed;
    uint8_t arity;
};
typedef enum theft_hook_gen_args_pre_res
theft_hook_gen_args_pre_cb(const struct theft_hook_gen_args_pre_info *info, void *env);

/* Before the property sees a trial's arguments. */
enum theft_hook_trial_pre_res {
    THEFT_HOOK_TRIAL_PRE_ERROR,
    THEFT_HOOK_TRIAL_PRE_CONTINUE,
    THEFT_HOOK_TRIAL_PRE_HALT,
};
struct theft_hook_trial_pre_info {
    const char *prop_name;
    size_t total_trials;
    size_t trial_id;
    size_t failures;
    theft_seed run_seed;
    theft_seed trial_seed;
    uint8_t arity;
    void **args;
};
typedef enum theft_hook_trial_pre_res
theft_hook_trial_pre_cb(const struct theft_hook_trial_pre_info *info, void *env);

/* In the child process, before each call of the property, where `fork.enable` is set. */
enum theft_hook_fork_post_res {
    THEFT_HOOK_FORK_POST_ERROR,
    THEFT_HOOK_FORK_POST_CONTINUE,
};
struct theft_hook_fork_post_info {
    struct theft *t;
    const char *prop_name;
    size_t total_trials;
    size_t failures;
    theft_seed run_seed;
    uint8_t arity;
    void **args;
};
typedef enum theft_hook_fork_post_res
theft_hook_fork_post_cb(const struct theft_hook_fork_post_info *info, void *env);

/* After a trial; after a failure, with the shrunk arguments. Arguments that were never made (a
 * skipping alloc) are NULL. The property is called again on REPEAT, at most 10000 times; the first
 * result is the one that counts. */
enum theft_hook_trial_post_res {
    THEFT_HOOK_TRIAL_POST_ERROR,
    THEFT_HOOK_TRIAL_POST_CONTINUE,
    THEFT_HOOK_TRIAL_POST_REPEAT,
    THEFT_HOOK_TRIAL_POST_REPEAT_ONCE,
};
struct theft_hook_trial_post_info {
    struct theft *t;
    const char *prop_name;
    size_t total_trials;
    size_t trial_id;
    size_t failures;
    theft_seed run_seed;
    theft_seed trial_seed;
    uint8_t arity;
    void **args;
    enum theft_trial_res result;
    bool repeat;
};
typedef enum theft_hook_trial_post_res
theft_hook_trial_post_cb(const struct theft_hook_trial_post_info *info, void *env);

/* Once for each failing trial, after shrinking. */
enum theft_hook_counterexample_res {
    THEFT_HOOK_COUNTEREXAMPLE_CONTINUE,
    THEFT_HOOK_COUNTEREXAMPLE_ERROR,
};
struct theft_hook_counterexample_info {
    struct theft *t;
    const char *prop_name;
    size_t total_trials;
    size_t trial_id;
    theft_seed trial_seed;
    uint8_t arity;
    struct theft_type_info **type_info;
    void **args;
};
typedef enum theft_hook_counterexample_res
theft_hook_counterexample_cb(const struct theft_hook_counterexample_info *info, void *env);

/* Before each attempt at a simpler argument. HALT keeps what has been reached. */
enum theft_hook_shrink_pre_res {
    THEFT_HOOK_SHRINK_PRE_ERROR,
    THEFT_HOOK_SHRINK_PRE_CONTINUE,
    THEFT_HOOK_SHRINK_PRE_HALT,
};
struct theft_hook_shrink_pre_info {
    const char *prop_name;
    size_t total_trials;
    size_t trial_id;
    size_t failures;
    theft_seed run_seed;
    theft_seed trial_seed;
    uint8_t arity;
    size_t shrink_count;
    size_t successful_shrinks;
    size_t failed_shrinks;
    uint8_t arg_index;
    void *arg;
    uint32_t tactic;
};
typedef enum theft_hook_shrink_pre_res
theft_hook_shrink_pre_cb(const struct theft_hook_shrink_pre_info *info, void *env);

/* After an attempt made a simpler argument (SHRUNK: `arg` is the new one, not yet tried) or did
 * not (`arg` is the present one). */
enum theft_hook_shrink_post_res {
    THEFT_HOOK_SHRINK_POST_ERROR,
    THEFT_HOOK_SHRINK_POST_CONTINUE,
};
enum theft_shrink_post_state {
    THEFT_SHRINK_POST_SHRINK_FAILED,
    THEFT_SHRINK_POST_SHRUNK,
    THEFT_SHRINK_POST_DONE_SHRINKING,
};
struct theft_hook_shrink_post_info {
    const char *prop_name;
    size_t total_trials;
    size_t trial_id;
    theft_seed run_seed;
    theft_seed trial_seed;
    uint8_t arity;
    size_t shrink_count;
    size_t successful_shrinks;
    size_t failed_shrinks;
    uint8_t arg_index;
    void *arg;
    uint32_t tactic;
    enum theft_shrink_post_state state;
};
typedef enum theft_hook_shrink_post_res
theft_hook_shrink_post_cb(const struct theft_hook_shrink_post_info *info, void *env);

/* After the property was called with a simpler argument. REPEAT as for trial_post. */
enum theft_hook_shrink_trial_post_res {
    THEFT_HOOK_SHRINK_TRIAL_POST_ERROR,
    THEFT_HOOK_SHRINK_TRIAL_POST_CONTINUE,
    THEFT_HOOK_SHRINK_TRIAL_POST_REPEAT,
    THEFT_HOOK_SHRINK_TRIAL_POST_REPEAT_ONCE,
};
struct theft_hook_shrink_trial_post_info {
    const char *prop_name;
    size_t total_trials;
    size_t trial_id;
    size_t failures;
    theft_seed run_seed;
    theft_seed trial_seed;
    uint8_t arity;
    size_t shrink_count;
    size_t successful_shrinks;
    size_t failed_shrinks;
    uint8_t arg_index;
    void **args;
    uint32_t tactic;
    enum theft_trial_res result;
};
typedef enum theft_hook_shrink_trial_post_res
theft_hook_shrink_trial_post_cb(const struct theft_hook_shrink_trial_post_info *info, void *env);

/* A configuration of theft_run. Exactly one property is set, and as many type_info as it has
 * arguments; everything else may be zero. */
struct theft_run_config {
    theft_propfun1 *prop1;
    theft_propfun2 *prop2;
    theft_propfun3 *prop3;
    theft_propfun4 *prop4;
    theft_propfun5 *prop5;
    theft_propfun6 *prop6;
    theft_propfun7 *prop7;
    const struct theft_type_info *type_info[THEFT_MAX_ARITY];

    const char *name;
    /* Trials with these seeds run first, in addition to the number asked for. */
    size_t always_seed_count;
    theft_seed *always_seeds;
    size_t trials;
    /* The first trial after the always_seeds has this seed itself, so a failing trial is repeated
     * by giving its seed. 0: a fixed default. */
    theft_seed seed;
    uint8_t bloom_bits;

    /* Call the property in a child process, so that a crash or a hang is a failure that shrinks.
     * POSIX systems only; elsewhere asking for it is THEFT_RUN_ERROR_BAD_ARGS. Times are in
     * milliseconds; timeout 0 waits for ever, signal 0 is SIGTERM, and SIGKILL follows
     * `exit_timeout` later (0: THEFT_DEF_EXIT_TIMEOUT_MSEC). */
    struct {
        bool enable;
        size_t timeout;
        int signal;
        size_t exit_timeout;
    } fork;

    /* NULL: printing defaults for run_pre, run_post, trial_post and counterexample, nothing for
     * the others. `env` goes to every hook. */
    struct {
        theft_hook_run_pre_cb *run_pre;
        theft_hook_run_post_cb *run_post;
        theft_hook_gen_args_pre_cb *gen_args_pre;
        theft_hook_trial_pre_cb *trial_pre;
        theft_hook_fork_post_cb *fork_post;
        theft_hook_trial_post_cb *trial_post;
        theft_hook_counterexample_cb *counterexample;
        theft_hook_shrink_pre_cb *shrink_pre;
        theft_hook_shrink_post_cb *shrink_post;
        theft_hook_shrink_trial_post_cb *shrink_trial_post;
        void *env;
    } hooks;
};

#endif
