/* A header for the test of the documentation's filter: what stands in comments must reach the
 * reader as it is. 50 % of a < b, a@b, #5, a\b, "quoted", a * b and *pointer* are no commands.
 *
 *   row         text
 *   .count      a member that this table describes
 *
 *   behind      a blank line of the table
 *
 * A list:
 * - the first item, which goes
 *   on in a second line;
 * - the second.
 * And prose that wraps before a minus: 3
 * - 2, or before a number, 1 or
 * 2. It ends here. */
#ifndef GNOMON_SAMPLE_H
#define GNOMON_SAMPLE_H

#include <stdint.h>

/* Serves both macros. */
#define GN_SAMPLE_A 1
#define GN_SAMPLE_B 2

#define GN_SAMPLE_C 3 /* at the end of its line */

/* Left out, with its comment. */
#define GN_SAMPLE_INTERNAL_ 4

/* A struct that names x, y, place and size. See gn_sample_first, `gn_sample_kind` and `code that a
 * line divides`. */
typedef struct gn_sample {
    float x, y;
    uint32_t count;
    const char *name; /* at the end of
                         two lines */
    float low, high;  /* of both */
    float (*row)[4];  /* a pointer */
    int place[2], size[2];

    /* Before a member. */
    int before;
} gn_sample;

/* One line: GN_SAMPLE_ZERO and GN_SAMPLE_ONE. */
typedef enum gn_sample_kind { GN_SAMPLE_ZERO = 0, GN_SAMPLE_ONE } gn_sample_kind;

/* Several lines. */
typedef enum gn_sample_other {
    GN_SAMPLE_LEFT = 0, /* with a comma */
    GN_SAMPLE_RIGHT     /* the last */
} gn_sample_other;

/* A comment that stands alone is for readers of the header. */

/* Serves three functions. */
int gn_sample_first(int a);
int gn_sample_second(int a, /* of a parameter */
                     int b);
int gn_sample_third(void);

/* Before a choice. */
#if defined(GN_SAMPLE_A) && GN_SAMPLE_A > 0
typedef void gn_sample_function(const gn_sample *sample);
#else
typedef int gn_sample_function(const gn_sample *sample);
#endif

/* One of a family. */
static inline int gn_sample_two2(int a)
{
    /* inside */
    if (a)
        return 1;
    return 0;
}

static inline int gn_sample_two3(int a)
{
    return a;
}

#endif
