/* Ready generators for C's scalar types and zero-terminated arrays. */
#include "theft_internal.h"

#include <inttypes.h>
#include <string.h>

void theft_generic_free_cb(void *instance, void *env)
{
    (void)env;
    free(instance);
}

/* A number of random width up to `bits`: a value, then how far to shift it down. */
static uint64_t number_of_any_width(struct theft *t, unsigned bits)
{
    const uint64_t value = theft_random_bits(t, (uint8_t)bits);
    return value >> theft_random_choice(t, bits);
}

static enum theft_alloc_res hand_over(const void *value, size_t size, void **output)
{
    *output = malloc(size);
    if (*output == NULL)
        return THEFT_ALLOC_ERROR;
    memcpy(*output, value, size);
    return THEFT_ALLOC_OK;
}

#define DEFINE_UNSIGNED(name, type)                                                                \
    static enum theft_alloc_res alloc_##name(struct theft *t, void *env, void **output)            \
    {                                                                                              \
        const type value = (type)(env != NULL ? theft_random_choice(t, *(const type *)env)         \
                                              : number_of_any_width(t, 8 * sizeof(type)));         \
        return hand_over(&value, sizeof value, output);                                            \
    }                                                                                              \
    static void print_##name(FILE *f, const void *instance, void *env)                             \
    {                                                                                              \
        const uintmax_t value = *(const type *)instance;                                           \
        (void)env;                                                                                 \
        fprintf(f, "%" PRIuMAX " (0x%" PRIxMAX ")", value, value);                                 \
    }

/* Magnitude m, then sign: m or -1 - m, which reaches every value of the type and shrinks to 0. */
#define DEFINE_SIGNED(name, type)                                                                  \
    static enum theft_alloc_res alloc_##name(struct theft *t, void *env, void **output)            \
    {                                                                                              \
        const int64_t magnitude =                                                                  \
            (int64_t)(env != NULL ? theft_random_choice(t, (uint64_t) * (const type *)env)         \
                                  : number_of_any_width(t, 8 * sizeof(type) - 1));                 \
        const type value = (type)(theft_random_bits(t, 1) != 0 ? -1 - magnitude : magnitude);      \
        return hand_over(&value, sizeof value, output);                                            \
    }                                                                                              \
    static void print_##name(FILE *f, const void *instance, void *env)                             \
    {                                                                                              \
        const intmax_t value = *(const type *)instance;                                            \
        (void)env;                                                                                 \
        fprintf(f, "%" PRIdMAX, value);                                                            \
    }

/* Within a limit: L * 2^-digits times m or -1 - m, as for the signed integers. Else: the bit
 * pattern without the sign, then the sign. */
#define DEFINE_FLOATING(name, type, pattern, digits)                                               \
    static enum theft_alloc_res alloc_##name(struct theft *t, void *env, void **output)            \
    {                                                                                              \
        type value;                                                                                \
        if (env != NULL) {                                                                         \
            const type step = (type)1 / (type)(UINT64_C(1) << (digits));                           \
            const type magnitude = (type)theft_random_bits(t, digits);                             \
            const bool negative = theft_random_bits(t, 1) != 0;                                    \
            value = *(const type *)env * (step * (negative ? -1 - magnitude : magnitude));         \
        } else {                                                                                   \
            const unsigned sign_bit = 8 * sizeof(pattern) - 1;                                     \
            pattern bits = (pattern)theft_random_bits(t, (uint8_t)sign_bit);                       \
            bits |= (pattern)((pattern)theft_random_bits(t, 1) << sign_bit);                       \
            memcpy(&value, &bits, sizeof value);                                                   \
        }                                                                                          \
        return hand_over(&value, sizeof value, output);                                            \
    }                                                                                              \
    static void print_##name(FILE *f, const void *instance, void *env)                             \
    {                                                                                              \
        const double value = (double)*(const type *)instance;                                      \
        (void)env;                                                                                 \
        fprintf(f, "%.17g (%a)", value, value);                                                    \
    }

DEFINE_UNSIGNED(uint, unsigned)
DEFINE_UNSIGNED(uint8, uint8_t)
DEFINE_UNSIGNED(uint16, uint16_t)
DEFINE_UNSIGNED(uint32, uint32_t)
DEFINE_UNSIGNED(uint64, uint64_t)
DEFINE_UNSIGNED(size, size_t)
DEFINE_SIGNED(int, int)
DEFINE_SIGNED(int8, int8_t)
DEFINE_SIGNED(int16, int16_t)
DEFINE_SIGNED(int32, int32_t)
DEFINE_SIGNED(int64, int64_t)
#if THEFT_USE_FLOATING_POINT
DEFINE_FLOATING(float, float, uint32_t, 24)
DEFINE_FLOATING(double, double, uint64_t, 53)
#endif

static enum theft_alloc_res alloc_bool(struct theft *t, void *env, void **output)
{
    const bool value = theft_random_bits(t, 1) != 0;
    (void)env;
    return hand_over(&value, sizeof value, output);
}

static void print_bool(FILE *f, const void *instance, void *env)
{
    (void)env;
    fputs(*(const bool *)instance ? "true" : "false", f);
}

/* Three bits before each element say whether there is one, so that an element is a block of two
 * requests that autoshrinking can leave out anywhere. Bits of 0 make 'a'. */
static enum theft_alloc_res alloc_array(struct theft *t, void *env, void **output)
{
    const size_t longest = env != NULL ? *(const size_t *)env : 64;
    size_t length = 0;
    size_t capacity = 64;
    uint8_t *array = malloc(capacity);
    if (array == NULL)
        return THEFT_ALLOC_ERROR;
    while (length < longest && theft_random_bits(t, 3) != 0) {
        if (length + 1 == capacity) {
            uint8_t *grown = realloc(array, capacity * 2);
            if (grown == NULL) {
                free(array);
                return THEFT_ALLOC_ERROR;
            }
            array = grown;
            capacity *= 2;
        }
        const uint8_t element = (uint8_t)('a' + theft_random_bits(t, 8));
        array[length++] = element == 0 ? 'a' : element;
    }
    array[length] = 0;
    *output = array;
    return THEFT_ALLOC_OK;
}

static void print_array(FILE *f, const void *instance, void *env)
{
    const uint8_t *array = instance;
    (void)env;
    fputc('"', f);
    for (size_t i = 0; array[i] != 0; ++i)
        if (array[i] >= ' ' && array[i] <= '~' && array[i] != '"' && array[i] != '\\')
            fputc(array[i], f);
        else
            fprintf(f, "\\%03o", array[i]);
    fputc('"', f);
}

#define TYPE_INFO(name)                                                                            \
    {                                                                                              \
        .alloc = alloc_##name, .free = theft_generic_free_cb, .print = print_##name,               \
        .autoshrink_config = {.enable = true},                                                     \
    }

const struct theft_type_info *theft_get_builtin_type_info(enum theft_builtin_type_info type)
{
    static const struct theft_type_info infos[] = {
        [THEFT_BUILTIN_bool] = TYPE_INFO(bool),
        [THEFT_BUILTIN_uint] = TYPE_INFO(uint),
        [THEFT_BUILTIN_uint8_t] = TYPE_INFO(uint8),
        [THEFT_BUILTIN_uint16_t] = TYPE_INFO(uint16),
        [THEFT_BUILTIN_uint32_t] = TYPE_INFO(uint32),
        [THEFT_BUILTIN_uint64_t] = TYPE_INFO(uint64),
        [THEFT_BUILTIN_size_t] = TYPE_INFO(size),
        [THEFT_BUILTIN_int] = TYPE_INFO(int),
        [THEFT_BUILTIN_int8_t] = TYPE_INFO(int8),
        [THEFT_BUILTIN_int16_t] = TYPE_INFO(int16),
        [THEFT_BUILTIN_int32_t] = TYPE_INFO(int32),
        [THEFT_BUILTIN_int64_t] = TYPE_INFO(int64),
#if THEFT_USE_FLOATING_POINT
        [THEFT_BUILTIN_float] = TYPE_INFO(float),
        [THEFT_BUILTIN_double] = TYPE_INFO(double),
#endif
        [THEFT_BUILTIN_char_ARRAY] = TYPE_INFO(array),
        [THEFT_BUILTIN_uint8_t_ARRAY] = TYPE_INFO(array),
    };
    const size_t index = (size_t)type;
    return index < sizeof infos / sizeof infos[0] ? &infos[index] : NULL;
}

void theft_copy_builtin_type_info(enum theft_builtin_type_info type, struct theft_type_info *info)
{
    const struct theft_type_info *builtin = theft_get_builtin_type_info(type);
    memset(info, 0, sizeof *info);
    if (builtin != NULL)
        *info = *builtin;
}
