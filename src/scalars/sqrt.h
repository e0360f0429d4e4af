/* The square root in integers, visible to the tests, which compare it with the
 * instruction gn_sqrt uses where there is one. Same contract as gn_sqrt. */
#ifndef GNOMON_SCALARS_SQRT_H
#define GNOMON_SCALARS_SQRT_H

float gn_sqrt_integer(float x);

#endif
