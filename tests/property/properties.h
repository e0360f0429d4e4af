/* The suites of property tests, each a table of properties, written to the interface of theft 0.4.
 * main.c runs them; the fuzz targets run them on a fuzzer's input. */
#ifndef PROPERTIES_H
#define PROPERTIES_H

#include <inttypes.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <theft.h>

/* A property. Its `trials` are per cent of those of --trials; 0 stands for 100. */
typedef struct theft_run_config property;

typedef struct suite {
    const property *properties;
    size_t count;
} suite;

/* Mathematics. */
extern const suite properties_scalar, properties_vectors, properties_matrices,
    properties_transforms, properties_inverse, properties_quaternion, properties_models,
    properties_projections, properties_geometry, properties_rays;

/* Drawing. */
extern const suite properties_edges, properties_memory, properties_scenes, properties_textures,
    properties_lookup, properties_indices;

/* What a file of properties ends with: its name and its table. */
#define SUITE(name, table) const suite name = {table, sizeof(table) / sizeof *(table)}

/* Rows of a table: what is printed, the function, and the types of its arguments. */
#define PROPERTY1(title, function, a)                                                              \
    {                                                                                              \
        .name = title, .prop1 = function, .type_info = { a }                                       \
    }
#define PROPERTY2(title, function, a, b)                                                           \
    {                                                                                              \
        .name = title, .prop2 = function, .type_info = { a, b }                                    \
    }
#define PROPERTY3(title, function, a, b, c)                                                        \
    {                                                                                              \
        .name = title, .prop3 = function, .type_info = { a, b, c }                                 \
    }

/* The same for one argument, with a percentage of the trials. */
#define DRAWING(title, function, a, percent)                                                       \
    {                                                                                              \
        .name = title, .prop1 = function, .type_info = {a}, .trials = percent                      \
    }

/* The type of an argument that shrinks by its random bits. */
#define INSTANCES(make, show, environment)                                                         \
    (&(const struct theft_type_info){.alloc = make,                                                \
                                     .free = theft_generic_free_cb,                                \
                                     .print = show,                                                \
                                     .autoshrink_config = {.enable = true},                        \
                                     .env = environment})

static inline enum theft_trial_res verdict(bool holds)
{
    return holds ? THEFT_TRIAL_PASS : THEFT_TRIAL_FAIL;
}

#endif
