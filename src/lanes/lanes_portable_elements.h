/* The operations of lanes_portable.h on the shorts and the bytes of lanes.
 * Not alone: lanes_portable.h includes it after the types of lanes. */
#ifndef GN_LANES_LANES_PORTABLE_ELEMENTS_H
#define GN_LANES_LANES_PORTABLE_ELEMENTS_H

/* The shorts and bytes of lanes, in either byte order. Loops over them become vector instructions
 * for 16 and 8 bits. */
typedef union lanes_elements {
    lanes_i words;
    uint16_t shorts[2 * LANES];
    unsigned char bytes[4 * LANES];
} lanes_elements;

/* Multiplies the two shorts of each lane, each modulo 2^16. */
static inline lanes_i lanes_i_mul_shorts(lanes_i a, lanes_i b)
{
    const lanes_elements factor = {b};
    lanes_elements r = {a};

    GN_EACH_ELEMENT (n, 2)
        r.shorts[n] = (uint16_t)((uint32_t)r.shorts[n] * factor.shorts[n]);
    return r.words;
}

/* Shifts the two shorts of each lane to the right by 8 bits, filling with zeros. */
static inline lanes_i lanes_i_high_bytes(lanes_i a)
{
    lanes_elements r = {a};

    GN_EACH_ELEMENT (n, 2)
        r.shorts[n] = (uint16_t)(r.shorts[n] >> 8);
    return r.words;
}

/* Returns min(a + b, 255) for each byte, as min(a, 255 - b) + b. */
static inline lanes_i lanes_i_add_bytes(lanes_i a, lanes_i b)
{
    const lanes_elements other = {b};
    lanes_elements r = {a};

    GN_EACH_ELEMENT (n, 4) {
        const unsigned char most = (unsigned char)~other.bytes[n];

        r.bytes[n] = (unsigned char)((r.bytes[n] < most ? r.bytes[n] : most) + other.bytes[n]);
    }
    return r.words;
}

/* Returns max(a - b, 0) for each byte, as max(a, b) - b. */
static inline lanes_i lanes_i_sub_bytes(lanes_i a, lanes_i b)
{
    const lanes_elements other = {b};
    lanes_elements r = {a};

    GN_EACH_ELEMENT (n, 4)
        r.bytes[n] = (unsigned char)((r.bytes[n] > other.bytes[n] ? r.bytes[n] : other.bytes[n]) -
                                     other.bytes[n]);
    return r.words;
}

/* Returns min(a + b, 65535) for each short. */
static inline lanes_i lanes_i_add_shorts(lanes_i a, lanes_i b)
{
    const lanes_elements other = {b};
    lanes_elements r = {a};

    GN_EACH_ELEMENT (n, 2) {
        const uint16_t most = (uint16_t)~other.shorts[n];

        r.shorts[n] = (uint16_t)((r.shorts[n] < most ? r.shorts[n] : most) + other.shorts[n]);
    }
    return r.words;
}

/* Returns max(a - b, 0) for each short. */
static inline lanes_i lanes_i_sub_shorts(lanes_i a, lanes_i b)
{
    const lanes_elements other = {b};
    lanes_elements r = {a};

    GN_EACH_ELEMENT (n, 2)
        r.shorts[n] = (uint16_t)((r.shorts[n] > other.shorts[n] ? r.shorts[n] : other.shorts[n]) -
                                 other.shorts[n]);
    return r.words;
}

/* Returns a * b / 65535 for each short: (p + p / 2^16 + 2^15) / 2^16 with p = a * b, which is exact
 * if a or b is 0 or 65535. 32 bits hold the sum. */
static inline lanes_i lanes_i_scale_shorts(lanes_i a, lanes_i b)
{
    const lanes_elements factor = {b};
    lanes_elements r = {a};

    GN_EACH_ELEMENT (n, 2) {
        const uint32_t product = (uint32_t)r.shorts[n] * factor.shorts[n];

        r.shorts[n] = (uint16_t)((product + (product >> 16) + 0x8000u) >> 16);
    }
    return r.words;
}

#endif
