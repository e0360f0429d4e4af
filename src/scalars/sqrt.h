/* The square root in integers, visible to the tests, which compare it with the instruction that
 * gn_sqrt uses where there is one. Its contract is that of gn_sqrt. */
#ifndef GNOMON_SCALARS_SQRT_H
#define GNOMON_SCALARS_SQRT_H

float gn_sqrt_integer(float x);

#endif
