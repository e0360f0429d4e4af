/* Converts bytes of sRGB to linear colours and back. */
#ifndef GN_FORMATS_SRGB_H
#define GN_FORMATS_SRGB_H

#include "unorm.h"

/* Let a float in 0 to 1 have the upper half h and the lower half l. Its byte, by sRGB's transfer
 * function (OpenGL 4.5 section 17.3.7) and rounding to nearest, is (entry + l) >> 16 for the entry
 * h - GN_SRGB_FIRST, or for entry 0 if h is less. No two bytes begin between floats of equal upper
 * halves, so an entry knows one byte and where the next begins. */
#define GN_SRGB_FIRST 0x391E
#define GN_SRGB_STEPS (0x3F80 - GN_SRGB_FIRST + 1)

extern const int32_t gni_srgb_steps[GN_SRGB_STEPS];

/* Converts the byte from bit `shift` on from sRGB to linear, as the reference does. */
static inline lanes_f srgb_value(lanes_i word, int shift)
{
    const lanes_f x =
        lanes_to_float(lanes_i_and(lanes_i_shift_right(word, shift), lanes_i_splat(255)));
    const lanes_f square = lanes_mul(x, x);
    const lanes_f odd =
        lanes_add(lanes_splat(0x1.8AC20Ep-17f), lanes_mul(square, lanes_splat(0x1.381256p-26f)));
    const lanes_f even =
        lanes_add(lanes_splat(0.0023f), lanes_mul(square, lanes_splat(0x1.65DCC2p-17f)));
    const lanes_f curve = lanes_add(lanes_mul(x, odd), even);

    return lanes_select(lanes_greater(x, lanes_splat(15.0f)), curve,
                        lanes_mul(x, lanes_splat(0x1.465AACp-12f)));
}

/* Returns linear channels as bytes of sRGB. */
static inline lanes_i srgb8(lanes_f channel)
{
    const lanes_i x = lanes_as_int(saturated(channel));
    const lanes_i upper = lanes_i_sub(lanes_i_shift_right(x, 16), lanes_i_splat(GN_SRGB_FIRST));
    const lanes_i step = lanes_i_gather(gni_srgb_steps, lanes_i_max(upper, lanes_i_splat(0)));

    return lanes_i_shift_right(lanes_i_add(step, lanes_i_and(x, lanes_i_splat(0xFFFF))), 16);
}

#endif
