/* Evaluates nodes anew, one lane at a time, in plain C. */
#include "graph.h"

static float rounded(float f)
{
    /* To the nearest integer, halves to even: between 2^23 and 2^24 floats are the integers. */
    const float magnitude = f < 0.0f ? -f : f;
    volatile float sum = magnitude + 8388608.0f;

    if (!(magnitude < 8388608.0f))
        return f;
    sum = sum - 8388608.0f;
    return f < 0.0f ? -sum : sum;
}

static bool fits_int(float f)
{
    return f >= -2147483648.0f && f < 2147483648.0f;
}

static uint32_t integer_of(float f)
{
    return fits_int(f) ? (uint32_t)(int32_t)f : 0x80000000u;
}

static float floor_of(float f)
{
    if (!fits_int(f))
        return f;
    const float whole = (float)(int32_t)f;
    return whole > f ? whole - 1.0f : whole;
}

/* The square root by bisection of the bits in double precision, rounded to nearest: a float's
 * square and the square of a midpoint of two floats are exact in double. */
static float root_of(float f)
{
    uint32_t low = 0, high = 0x7F800000u;

    if (!(f > 0.0f) || f - f != 0.0f)
        return f;
    while (high - low > 1) {
        const uint32_t middle = low + (high - low) / 2;
        const double m = (double)float_of_bits(middle);

        if (m * m <= (double)f)
            low = middle;
        else
            high = middle;
    }
    const double half = ((double)float_of_bits(low) + (double)float_of_bits(high)) / 2;
    return half * half < (double)f ? float_of_bits(high) : float_of_bits(low);
}

static uint32_t byte_of(float f)
{
    const float scaled = rounded(f * 255.0f);

    return !fits_int(scaled) || !(scaled > 0.0f) ? 0 : scaled > 255.0f ? 255 : (uint32_t)scaled;
}

/* The parts of two words, combined one by one. */
static uint32_t by_parts(graph_operation operation, uint32_t a, uint32_t b)
{
    const bool bytes = operation == OP_ADD_BYTES || operation == OP_SUB_BYTES;
    const int width = bytes ? 8 : 16;
    const uint32_t most = bytes ? 255 : 65535;
    uint32_t result = 0;

    for (int shift = 0; shift < 32; shift += width) {
        const uint32_t x = a >> shift & most, y = b >> shift & most;
        uint32_t part = 0;

        switch (operation) {
        case OP_ADD_BYTES:
        case OP_ADD_SHORTS:
            part = x + y > most ? most : x + y;
            break;
        case OP_SUB_BYTES:
        case OP_SUB_SHORTS:
            part = x < y ? 0 : x - y;
            break;
        case OP_MUL_SHORTS:
            part = x * y & most;
            break;
        case OP_HIGH_BYTES:
            part = x >> 8;
            break;
        default: /* x * y / 65535, rounded: halves cannot occur, since 65535 is odd */
            part = (uint32_t)(((uint64_t)x * y * 2 + 65535) / 131070);
            break;
        }
        result |= part << shift;
    }
    return result;
}

static uint32_t float_result(const graph_node *n, uint32_t a, uint32_t b, uint32_t c)
{
    const float x = float_of_bits(a), y = float_of_bits(b);
    float r = 0.0f;

    switch (n->operation) {
    case OP_ADD:
        r = x + y;
        break;
    case OP_SUB:
        r = x - y;
        break;
    case OP_MUL:
        r = x * y;
        break;
    case OP_DIV:
        r = x / y;
        break;
    case OP_SQRT:
        r = x < 0.0f ? (x - x) / (x - x) : root_of(x);
        break;
    case OP_FLOOR:
        r = floor_of(x);
        break;
    case OP_TO_FLOAT:
        r = (float)(int32_t)a;
        break;
    case OP_UNPACK_BYTE:
        r = (float)(a >> 8 * n->operand[1] & 255) * (float)(1.0 / 255.0);
        break;
    case OP_MIN:
        return x < y ? a : b;
    case OP_MAX:
        return x > y ? a : b;
    case OP_MAGNITUDE:
        return a & 0x7FFFFFFF;
    default: /* OP_SELECT */
        return a ? b : c;
    }
    return bits_of_float(r);
}

static uint32_t integer_result(const graph_node *n, uint32_t a, uint32_t b, uint32_t c)
{
    const int32_t i = (int32_t)a, j = (int32_t)b, k = (int32_t)c;
    const int64_t scale = (int64_t)1 << (n->operand[1] & 31);

    switch (n->operation) {
    case OP_TRUNCATE:
        return integer_of(float_of_bits(a));
    case OP_ROUND:
        return integer_of(rounded(float_of_bits(a)));
    case OP_FLOOR_TO_INT:
        return integer_of(floor_of(float_of_bits(a)));
    case OP_I_ADD:
        return a + b;
    case OP_I_SUB:
        return a - b;
    case OP_I_MUL:
        return a * b;
    case OP_I_SHIFT_LEFT:
        return a << n->operand[1];
    case OP_I_SHIFT_RIGHT:
        return (uint32_t)(((int64_t)i - (int64_t)((uint64_t)i % (uint64_t)scale)) / scale);
    case OP_I_MIN:
        return i < j ? a : b;
    case OP_I_MAX:
        return i > j ? a : b;
    case OP_I_OR:
        return a | b;
    case OP_I_AND:
        return a & b;
    case OP_I_XOR:
        return a ^ b;
    case OP_I_SELECT:
        return a ? b : c;
    case OP_I_CLAMP:
        return i < j ? b : i > k ? c : a;
    case OP_PACK_BYTE:
        return byte_of(float_of_bits(a));
    case OP_PACK_WORD:
        return a + (b << 8) + (c << 16) + (graph_bits(n->operand[3]) << 24);
    default:
        return by_parts((graph_operation)n->operation, a, b);
    }
}

static bool truth_of(const graph_node *n, uint32_t a, uint32_t b)
{
    switch (n->operation) {
    case OP_GREATER:
        return float_of_bits(a) > float_of_bits(b);
    case OP_LESS_EQUAL:
        return float_of_bits(a) <= float_of_bits(b);
    case OP_AND:
        return a && b;
    case OP_NOT:
        return !a;
    case OP_I_GREATER:
        return (int32_t)a > (int32_t)b;
    default:
        return a == b;
    }
}

static bool is_nan(uint32_t bits)
{
    return (bits & 0x7FFFFFFF) > 0x7F800000;
}

/* Whether the operands that the result depends on were recorded. A choice depends on one of two. */
static bool has_operands(const graph_node *n)
{
    const graph_traits *const traits = &graph_traits_of[n->operation];

    if (traits->notation == NOTATION_CHOICE)
        return n->operand[0] && n->operand[graph_bits(n->operand[0]) ? 1 : 2];
    for (int i = 0; i < traits->operands; ++i)
        if (n->operand[i] == 0 && !(i == 1 && graph_has_count((graph_operation)n->operation)))
            return false;
    return true;
}

bool graph_check(node_id node, uint32_t *found)
{
    const graph_node *const n = &trace.nodes[node];
    const graph_operation operation = (graph_operation)n->operation;
    const uint32_t a = graph_bits(n->operand[0]);
    const uint32_t b = graph_has_count(operation) ? n->operand[1] : graph_bits(n->operand[1]);
    const uint32_t c = graph_bits(n->operand[2]);
    const char type = graph_traits_of[operation].type;

    *found = n->bits;
    if (graph_traits_of[operation].notation == NOTATION_LEAF)
        return true;
    if (!has_operands(n))
        return false;
    *found = type == 'm'   ? (truth_of(n, a, b) ? UINT32_MAX : 0)
             : type == 'f' ? float_result(n, a, b, c)
                           : integer_result(n, a, b, c);
    return *found == n->bits || (type == 'f' && is_nan(*found) && is_nan(n->bits));
}

uint32_t graph_check_all(node_id *first)
{
    uint32_t wrong = 0, found;

    *first = 0;
    for (node_id n = 1; n < trace.count; ++n) {
        if (!graph_check(n, &found)) {
            ++wrong;
            *first = *first ? *first : n;
        }
    }
    return wrong;
}
