/* The part of theft 0.4's interface that the properties use, for machines without libtheft: names,
 * values and order are theft's, so that a property compiles against either. theft.c implements it;
 * its random sequences, the text it prints and how it shrinks are its own. */
#ifndef THEFT_H
#define THEFT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* The runner's state; only ever handled by pointer. */
struct theft;

/* The result of a property; DUP is for theft alone. SKIP: the arguments do not meet the property's
 * precondition. ERROR ends the whole run. */
enum theft_trial_res {
    THEFT_TRIAL_PASS,
    THEFT_TRIAL_FAIL,
    THEFT_TRIAL_SKIP,
    THEFT_TRIAL_DUP,
    THEFT_TRIAL_ERROR
};

/* A property is called again and again while its arguments shrink, so it must not change them nor
 * depend on anything else. Random bits that it asks for are equal at each call of a trial. */
typedef enum theft_trial_res theft_propfun1(struct theft *t, void *arg1);
typedef enum theft_trial_res theft_propfun2(struct theft *t, void *arg1, void *arg2);
typedef enum theft_trial_res theft_propfun3(struct theft *t, void *arg1, void *arg2, void *arg3);

/* Makes an instance of random bits, in *output. On SKIP and ERROR nothing is left. Equal bits make
 * equal instances; to shrink, lower values make simpler instances, and zeros the simplest. */
enum theft_alloc_res { THEFT_ALLOC_OK, THEFT_ALLOC_SKIP, THEFT_ALLOC_ERROR };
typedef enum theft_alloc_res theft_alloc_cb(struct theft *t, void *env, void **output);
typedef void theft_free_cb(void *instance, void *env);
typedef void theft_print_cb(FILE *f, const void *instance, void *env);

/* How to make and handle one argument; only `alloc` is required. */
struct theft_type_info {
    theft_alloc_cb *alloc;
    theft_free_cb *free;
    theft_print_cb *print;
    struct {
        bool enable;
    } autoshrink_config;
    void *env;
};

/* How many trials ended in each way. */
struct theft_run_report {
    size_t pass, fail, skip, dup;
};

/* Hooks before each trial and after the run. Those before the run and after each trial, without
 * which theft prints lines of its own, are not called here. */
struct theft_hook_run_pre_info;
struct theft_hook_trial_post_info;
struct theft_hook_trial_pre_info {
    size_t failures;
};
struct theft_hook_run_post_info {
    struct theft_run_report report;
};
enum theft_hook_run_pre_res { THEFT_HOOK_RUN_PRE_ERROR, THEFT_HOOK_RUN_PRE_CONTINUE };
enum theft_hook_run_post_res { THEFT_HOOK_RUN_POST_ERROR, THEFT_HOOK_RUN_POST_CONTINUE };
enum theft_hook_trial_pre_res {
    THEFT_HOOK_TRIAL_PRE_ERROR,
    THEFT_HOOK_TRIAL_PRE_CONTINUE,
    THEFT_HOOK_TRIAL_PRE_HALT
};
enum theft_hook_trial_post_res { THEFT_HOOK_TRIAL_POST_ERROR, THEFT_HOOK_TRIAL_POST_CONTINUE };
typedef enum theft_hook_run_pre_res
theft_hook_run_pre_cb(const struct theft_hook_run_pre_info *info, void *env);
typedef enum theft_hook_run_post_res
theft_hook_run_post_cb(const struct theft_hook_run_post_info *info, void *env);
typedef enum theft_hook_trial_pre_res
theft_hook_trial_pre_cb(const struct theft_hook_trial_pre_info *info, void *env);
typedef enum theft_hook_trial_post_res
theft_hook_trial_post_cb(const struct theft_hook_trial_post_info *info, void *env);

/* One property, and a type_info for each of its arguments. */
struct theft_run_config {
    theft_propfun1 *prop1;
    theft_propfun2 *prop2;
    theft_propfun3 *prop3;
    const struct theft_type_info *type_info[3];
    const char *name;
    size_t trials;
    uint64_t seed; /* of the first trial too, so that a trial's seed repeats it */
    struct {
        theft_hook_run_pre_cb *run_pre;
        theft_hook_run_post_cb *run_post;
        theft_hook_trial_pre_cb *trial_pre;
        theft_hook_trial_post_cb *trial_post;
        void *env; /* of every hook */
    } hooks;
};

/* The result of a run; SKIP: nothing failed, but nothing passed either. */
enum theft_run_res { THEFT_RUN_PASS, THEFT_RUN_FAIL, THEFT_RUN_SKIP, THEFT_RUN_ERROR };

/* Calls the property with `trials` sets of arguments. A set that fails is shrunk, as far as its
 * arguments' types allow, and printed with the trial's seed. */
enum theft_run_res theft_run(const struct theft_run_config *config);

/* Returns `bits` random bits, at most 64. A request is the unit that shrinking changes. */
uint64_t theft_random_bits(struct theft *t, uint8_t bits);

/* Returns a number below `ceil`, uniformly; 0 if there is none. */
uint64_t theft_random_choice(struct theft *t, uint64_t ceil);

void theft_generic_free_cb(void *instance, void *env);

#endif
