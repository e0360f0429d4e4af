/* What lanes in four 128-bit registers have in common; each register holds a row of a block. */
#ifndef GN_LANES_FOUR_REGISTERS_H
#define GN_LANES_FOUR_REGISTERS_H

/* r.q[n] = EXPRESSION for each of the four registers. */
#define LANES_EACH_REGISTER(type, EXPRESSION)                                                      \
    type r;                                                                                        \
    {                                                                                              \
        enum { n = 0 };                                                                            \
        r.q[n] = EXPRESSION;                                                                       \
    }                                                                                              \
    {                                                                                              \
        enum { n = 1 };                                                                            \
        r.q[n] = EXPRESSION;                                                                       \
    }                                                                                              \
    {                                                                                              \
        enum { n = 2 };                                                                            \
        r.q[n] = EXPRESSION;                                                                       \
    }                                                                                              \
    {                                                                                              \
        enum { n = 3 };                                                                            \
        r.q[n] = EXPRESSION;                                                                       \
    }                                                                                              \
    return r

#endif
