/* Expressions that order.awk must name, or must not: `named` at the end of a line says which.
 * Not part of any program. */
#include <stdbool.h>
#include <stdint.h>

typedef struct source {
    uint64_t state;
} source;

typedef struct maker {
    source random;
    uint32_t (*next)(source *s);
} maker;

typedef struct pair {
    uint32_t a, b;
} pair;

uint32_t below(source *s, uint32_t n);
uint32_t make(maker *m);
uint32_t next(void);
uint32_t pure(const source *s);
uint32_t of_two(uint32_t a, uint32_t b);
uint64_t mix(uint64_t *x);
void *memory_of(void *memory, uint32_t n);

static uint32_t arguments(source *s)
{
    const uint32_t deep = of_two(1 + (below(s, 2) & 1), 3 * below(s, 4)); /* named */
    const uint32_t across = of_two(below(s, 1),                           /* named */
                                   below(s, 2));
    const uint32_t inner = below(s, below(s, 5));
    return deep + across + inner + of_two(below(s, 4), pure(s));
}

static uint32_t operands(source *s, maker *m, uint64_t *x, uint32_t *array)
{
    uint32_t sum = next() + (10 + next() % 22); /* named */
    sum += below(s, 3);
    array[below(s, 3)] = below(s, 4);           /* named */
    array[below(s, 3)] += below(s, 4);          /* named */
    sum += m->next(&m->random) << make(m);      /* two types: not known to be one thing */
    sum += m->next(&m->random) << below(s, 2);  /* named */
    sum += (uint32_t)(mix(x) ^ mix(x));         /* named */
    sum += (below(s, 2), 1) + (below(s, 3), 2); /* named */
    return sum + of_two(*(uint32_t *)memory_of(x, 1), *(uint32_t *)memory_of(x, 2));
}

static pair initializers(source *s)
{
    const pair made = {below(s, 1), below(s, 2)}; /* named */
    const pair nested[2] = {{below(s, 1), 2}, {3, 4}};
    const uint32_t first = below(s, 1), second = below(s, 2);
    return (pair){made.a + first, nested[0].a + second};
}

static uint32_t ordered(source *s, float x)
{
    const bool both = below(s, 2) && below(s, 3);
    const bool either = below(s, 2) || below(s, 3);
    const uint32_t chosen = below(s, 2) ? below(s, 3) : below(s, 4);
    const bool infinite = x > __builtin_inff() || x < -__builtin_inff();
    const bool beyond = x * __builtin_inff() == __builtin_inff();
    return (below(s, 2), below(s, 3)) + both + either + chosen + infinite + beyond;
}

uint32_t every_one(source *s, maker *m, uint64_t *x, uint32_t *array);
uint32_t every_one(source *s, maker *m, uint64_t *x, uint32_t *array)
{
    arguments(s);
    operands(s, m, x, array);
    initializers(s);
    return ordered(s, 1.0f);
}
