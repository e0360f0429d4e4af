/* The operations of lanes in one form. To add an operation, add a line to run_form. */
#include "lanes_test.h"

#include "gather.h"
#include "packed.h"
#include "rows.h"

typedef struct recorder {
    lanes_output *out;
    int count;
} recorder;

static uint32_t *recorded(recorder *r, const char *operation)
{
    lanes_output *out = &r->out[r->count++];

    out->operation = operation;
    return out->word;
}

static void record_i(recorder *r, const char *operation, lanes_i value)
{
    int32_t lane[GN_LANES];
    uint32_t *word = recorded(r, operation);

    lanes_i_store(lane, value);
    GN_EACH_LANE (l)
        word[l] = (uint32_t)lane[l];
}

static void record_f(recorder *r, const char *operation, lanes_f value)
{
    union {
        float f[GN_LANES];
        uint32_t bits[GN_LANES];
    } lane;
    uint32_t *word = recorded(r, operation);

    lanes_store(lane.f, value);
    GN_EACH_LANE (l)
        word[l] = lane.f[l] != lane.f[l] ? 0x7FC00000u : lane.bits[l];
}

static void record_word(recorder *r, const char *operation, uint32_t value)
{
    uint32_t *word = recorded(r, operation);

    GN_EACH_LANE (l)
        word[l] = value;
}

static void record_m(recorder *r, const char *operation, lanes_m value)
{
    record_word(r, operation, lanes_bits(value));
    record_i(r, operation, lanes_m_as_int(value));
}

/* A block of words in memory, and whether the bytes between its rows have changed. */
static void record_memory(recorder *r, const char *operation, const unsigned char *memory,
                          const unsigned char *before)
{
    uint32_t *word = recorded(r, operation);
    uint32_t changed = 0;

    GN_EACH_LANE (l) {
        const unsigned char *p = memory + l / 4 * LANES_STRIDE + l % 4 * 4;

        word[l] =
            (uint32_t)p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
    }
    for (int i = 0; i < LANES_MEMORY; ++i)
        changed += i % LANES_STRIDE >= 16 && memory[i] != before[i];
    record_word(r, operation, changed);
}

static void record_gathers(recorder *r, const lanes_input *in)
{
    const lanes_i index = lanes_i_and(lanes_i_load(in->i), lanes_i_splat(GN_LANES - 2));
    uint32_t offset[3 * GN_LANES];
    lanes_i first, second, row[4];
    int32_t rows[GN_LANES][5] = {{0}};

    record_i(r, "i_gather", lanes_i_gather(in->j, index));
    lanes_i_gather_pairs(in->j, index, &first, &second);
    record_i(r, "i_gather_pairs, first", first);
    record_i(r, "i_gather_pairs, second", second);
    lanes_i_gather_fours(in->j, lanes_i_and(index, lanes_i_splat(GN_LANES - 4)), row);
    for (int c = 0; c < 4; ++c)
        record_i(r, "i_gather_fours", row[c]);
    const lanes_i near = lanes_i_sub(lanes_i_and(lanes_i_load(in->i), lanes_i_splat(31)),
                                     lanes_i_splat(16)); /* from -16 to 15 */
    const unsigned char *const middle = (const unsigned char *)in->j + 16;
    record_i(r, "i_gather_bytes, 1", lanes_i_gather_bytes(middle, near, 1));
    record_i(r, "i_gather_bytes, 2", lanes_i_gather_bytes(middle, near, 2));
    record_i(r, "i_gather_bytes, 4", lanes_i_gather_bytes(middle, near, 4));
    lanes_i_gather_eight(middle, near, &first, &second);
    record_i(r, "i_gather_eight, low", first);
    record_i(r, "i_gather_eight, high", second);
    for (int n = 0; n < 3 * GN_LANES; ++n)
        offset[n] = ((uint32_t)in->j[n / 3] >> n % 3) % 13 * 4;
    for (uint32_t step = 1; step <= 3; step += 2) {
        lanes_i_gather_rows((const unsigned char *)in->i, offset, step, row);
        for (int c = 0; c < 4; ++c)
            record_i(r, step == 1 ? "i_gather_rows" : "i_gather_rows of three", row[c]);
    }
    lanes_i_scatter_rows((unsigned char *)&rows[0][0], sizeof rows[0], row);
    for (int c = 0; c < 5; ++c) {
        uint32_t *word = recorded(r, "i_scatter_rows");
        GN_EACH_LANE (l)
            word[l] = (uint32_t)rows[l][c];
    }
}

static void record_packed(recorder *r, const lanes_input *in)
{
    float packed[4 * GN_LANES];
    lanes_f vector[4];

    record_f(r, "splat_vec4", lanes_splat_vec4(in->a));
    lanes_spread(lanes_load(in->a), vector);
    for (int i = 0; i < 4; ++i)
        record_f(r, "spread", vector[i]);
    GN_EACH_LANE (l) {
        packed[l] = in->a[l];
        packed[GN_LANES + l] = in->b[l];
        packed[2 * GN_LANES + l] = in->c[l];
        packed[3 * GN_LANES + l] = in->d[l];
    }
    lanes_load_vec3(packed, vector);
    for (int i = 0; i < 3; ++i)
        record_f(r, "load_vec3", vector[i]);
    vector[0] = lanes_load(in->d);
    lanes_store_vec3(packed, vector);
    for (int i = 0; i < 4; ++i) /* the last of which is not written */
        record_f(r, "store_vec3", lanes_load(packed + GN_LANES * i));
}

#if !GN_LANES_HAVE_PAIRS

/* Where number `at` of a lane's pixel is, in rows of pixels that have so many bytes. */
static unsigned char *pixel(unsigned char *const row[4], int l, int bytes, int at)
{
    return row[l / 4] + l % 4 * bytes + at;
}

/* The loads and stores of rows.h that not every form has, by their definition. */
static lanes_i loaded(unsigned char *const row[4], int bytes, int at, int count)
{
    int32_t value[GN_LANES];

    GN_EACH_LANE (l) {
        const unsigned char *const p = pixel(row, l, bytes, at);

        value[l] = count == 3 ? p[0] | p[1] << 8 | p[2] << 16 : number_of_bytes(p, count);
    }
    return lanes_i_load(value);
}

static void stored(unsigned char *const row[4], int bytes, int at, int count, lanes_i a)
{
    int32_t value[GN_LANES];

    lanes_i_store(value, a);
    GN_EACH_LANE (l)
        for (int n = 0; n < count; ++n)
            pixel(row, l, bytes, at)[n] = (unsigned char)((uint32_t)value[l] >> 8 * n);
}

#endif

/* Memory that starts with other bytes for each operation, so that all that is stored is seen. */
enum { ROWS_WORDS = 5 * GN_LANES };

static void fill(int32_t *memory, const lanes_input *in)
{
    for (int n = 0; n < ROWS_WORDS; ++n)
        memory[n] = (int32_t)((uint32_t)in->i[n % GN_LANES] + (uint32_t)n);
}

static void record_stored(recorder *r, const char *operation, int32_t *memory,
                          const lanes_input *in)
{
    for (int n = 0; n < ROWS_WORDS; n += GN_LANES)
        record_i(r, operation, lanes_i_load(memory + n));
    fill(memory, in);
}

/* Rows of pixels lie apart, in another order than the lanes. */
static void record_rows(recorder *r, const lanes_input *in)
{
    int32_t memory[ROWS_WORDS];
    unsigned char *const bytes = (unsigned char *)memory;
    unsigned char *const row[4] = {bytes + 160, bytes + 4, bytes + 240, bytes + 82};
    unsigned char *const odd[4] = {bytes + 161, bytes + 3, bytes + 240, bytes + 81};
    const lanes_i word[4] = {lanes_i_load(in->i), lanes_i_load(in->j),
                             lanes_as_int(lanes_load(in->a)), lanes_as_int(lanes_load(in->b))};
    lanes_i out[11];

    fill(memory, in);
    record_i(r, "i_load_bytes", lanes_i_load_bytes(odd));
    record_i(r, "i_load_shorts", lanes_i_load_shorts(row));
    lanes_i_store_bytes(odd, word[0]);
    record_stored(r, "i_store_bytes", memory, in);
    lanes_i_store_shorts(row, word[1]);
    record_stored(r, "i_store_shorts", memory, in);
#if GN_LANES_HAVE_PAIRS
    out[0] = lanes_i_load_threes(odd);
    lanes_i_load_pairs(row, &out[1], &out[2]);
    lanes_i_load_fours(row, out + 3);
    lanes_i_load_triples(row, out + 7);
    lanes_i_store_threes(odd, word[1]);
    record_stored(r, "i_store_threes", memory, in);
    lanes_i_store_pairs(row, word[0], word[1]);
    record_stored(r, "i_store_pairs", memory, in);
    lanes_i_store_triples(row, word);
    record_stored(r, "i_store_triples", memory, in);
    lanes_i_store_fours(row, word);
#else
    out[0] = loaded(odd, 3, 0, 3);
    for (int c = 0; c < 2; ++c)
        out[1 + c] = loaded(row, 8, 4 * c, 4);
    for (int c = 0; c < 4; ++c)
        out[3 + c] = loaded(row, 16, 4 * c, 4);
    for (int c = 0; c < 3; ++c)
        out[7 + c] = loaded(row, 12, 4 * c, 4);
    stored(odd, 3, 0, 3, word[1]);
    record_stored(r, "i_store_threes", memory, in);
    for (int c = 0; c < 2; ++c)
        stored(row, 8, 4 * c, 4, word[c]);
    record_stored(r, "i_store_pairs", memory, in);
    for (int c = 0; c < 3; ++c)
        stored(row, 12, 4 * c, 4, word[c]);
    record_stored(r, "i_store_triples", memory, in);
    for (int c = 0; c < 4; ++c)
        stored(row, 16, 4 * c, 4, word[c]);
#endif
    record_stored(r, "i_store_fours", memory, in);
    for (int n = 0; n < 10; ++n)
        record_i(r, "i_load_threes, i_load_pairs, i_load_fours, i_load_triples", out[n]);
}

#define JOINED(a, b) a##b
#define NAMED(prefix, name) JOINED(prefix, name)
#define RUN_FORM NAMED(run_, LANES_FORM)

lanes_form RUN_FORM;

int RUN_FORM(const lanes_input *in, lanes_output out[LANES_OPERATIONS_MAX])
{
    const lanes_f a = lanes_load(in->a), b = lanes_load(in->b);
    const lanes_f c = lanes_load(in->c), d = lanes_load(in->d);
    const lanes_i i = lanes_i_load(in->i), j = lanes_i_load(in->j);
    const lanes_m m = lanes_from_bits(in->bits);
    union { /* of words, for their alignment */
        unsigned char bytes[LANES_MEMORY];
        int32_t word[LANES_MEMORY / 4];
    } memory;
    recorder r = {out, 0};

    record_f(&r, "load", a);
    record_f(&r, "splat", lanes_splat(in->x));
    record_f(&r, "columns", lanes_columns(in->x, in->pixel, in->z));
    record_f(&r, "rows", lanes_rows(in->x, in->pixel));
    record_f(&r, "add", lanes_add(a, b));
    record_f(&r, "sub", lanes_sub(a, b));
    record_f(&r, "mul", lanes_mul(a, b));
    record_f(&r, "div", lanes_div(a, b));
    record_f(&r, "sqrt", lanes_sqrt(a));
    record_f(&r, "mul, add", lanes_add(lanes_mul(a, b), c));
    record_f(&r, "min", lanes_min(a, b));
    record_f(&r, "max", lanes_max(a, b));
    record_m(&r, "greater", lanes_greater(a, b));
    record_m(&r, "less_equal", lanes_less_equal(a, b));
    record_m(&r, "from_bits", m);
    record_m(&r, "not", lanes_not(m));
    record_m(&r, "and", lanes_and(m, lanes_greater(a, b)));
    record_f(&r, "select", lanes_select(m, a, b));
    record_f(&r, "to_float", lanes_to_float(i));
    record_i(&r, "as_int", lanes_as_int(lanes_select(lanes_greater(a, a), b, lanes_to_float(i))));
    record_i(&r, "truncate", lanes_truncate(a));
    record_i(&r, "round", lanes_round(a));
    /* A zero may have either sign. */
    record_f(&r, "floor", lanes_add(lanes_floor(a), lanes_splat(0.0f)));
    record_i(&r, "floor_to_int", lanes_floor_to_int(a));
    record_f(&r, "quad_left", lanes_quad_left(a));
    record_f(&r, "quad_right", lanes_quad_right(a));
    record_f(&r, "quad_lower", lanes_quad_lower(a));
    record_f(&r, "quad_upper", lanes_quad_upper(a));
    record_i(&r, "i_load", i);
    record_i(&r, "i_splat", lanes_i_splat(in->low));
    record_i(&r, "i_splat_two", lanes_i_splat_two(in->low, in->high));
    record_i(&r, "i_plane", lanes_i_plane(in->per_column, in->per_row));
    record_i(&r, "i_add", lanes_i_add(i, j));
    record_i(&r, "i_sub", lanes_i_sub(i, j));
    record_i(&r, "i_mul", lanes_i_mul(i, j));
    record_i(&r, "i_xor", lanes_i_xor(i, j));
    record_i(&r, "i_mul_short",
             lanes_i_mul_short(lanes_i_shift_right(i, 16), (int16_t)(in->low & 0xFFFF)));
    record_i(&r, "i_mul_shorts", lanes_i_mul_shorts(i, j));
    record_i(&r, "i_high_bytes", lanes_i_high_bytes(i));
    record_i(&r, "i_add_bytes", lanes_i_add_bytes(i, j));
    record_i(&r, "i_sub_bytes", lanes_i_sub_bytes(i, j));
    record_i(&r, "i_add_shorts", lanes_i_add_shorts(i, j));
    record_i(&r, "i_sub_shorts", lanes_i_sub_shorts(i, j));
    record_i(&r, "i_scale_shorts", lanes_i_scale_shorts(i, j));
    record_i(&r, "i_shift_left", lanes_i_shift_left(i, 8));
    record_i(&r, "i_shift_right", lanes_i_shift_right(i, 8));
    record_i(&r, "i_min", lanes_i_min(i, j));
    record_i(&r, "i_max", lanes_i_max(i, j));
    record_f(&r, "as_float", lanes_as_float(lanes_as_int(a)));
    record_i(&r, "i_or", lanes_i_or(i, j));
    record_i(&r, "i_and", lanes_i_and(i, j));
    record_m(&r, "i_greater", lanes_i_greater(i, j));
    record_m(&r, "i_equal", lanes_i_equal(i, j));
    record_i(&r, "i_select", lanes_i_select(m, i, j));
    record_i(&r, "i_clamp", lanes_i_clamp(i, lanes_i_splat(in->low), lanes_i_splat(in->high)));
    record_word(&r, "i_sign_bits", lanes_i_sign_bits(i));
    record_i(&r, "pack_unorm8", lanes_pack_unorm8(a, b, c, d));
    record_f(&r, "unpack_unorm8, 0", lanes_unpack_unorm8(i, 0));
    record_f(&r, "unpack_unorm8, 1", lanes_unpack_unorm8(i, 1));
    record_f(&r, "unpack_unorm8, 2", lanes_unpack_unorm8(i, 2));
    record_f(&r, "unpack_unorm8, 3", lanes_unpack_unorm8(i, 3));
    record_gathers(&r, in);
    record_packed(&r, in);
    record_rows(&r, in);

    for (int n = 0; n < LANES_MEMORY; ++n)
        memory.bytes[n] = in->memory[n];
    record_i(&r, "i_load_block",
             lanes_i_load_block(memory.bytes + 2 * LANES_STRIDE, memory.bytes, LANES_STRIDE));
    lanes_i_store_block(memory.bytes + 2 * LANES_STRIDE, memory.bytes, LANES_STRIDE, i);
    record_memory(&r, "i_store_block", memory.bytes, in->memory);
    return r.count;
}
