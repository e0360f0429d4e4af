/* Floats of 16 bits (IEEE 754 binary16). */
#ifndef OSMESA_HALF_FLOAT_H
#define OSMESA_HALF_FLOAT_H

#include <stdint.h>

/* Returns the bits of the nearest half, ties to even. */
uint16_t half_of(float x);

/* Returns the float of a half's bits. */
float float_of_half(uint16_t bits);

#endif
