/* The scalar functions in integers. Each has the contract of the public function of its name.
 * Targets without doubles in hardware use nothing else. Elsewhere the public functions compute in
 * double and call these only if the double does not decide the rounding (double_forms.h). The tests
 * check both forms. */
#ifndef GNOMON_SCALARS_INTEGER_FORMS_H
#define GNOMON_SCALARS_INTEGER_FORMS_H

float gn_sqrt_integer(float x);
float gn_rsqrt_integer(float x);
float gn_sin_integer(float x);
float gn_cos_integer(float x);
void gn_sincos_integer(float x, float *sine, float *cosine);
float gn_tan_integer(float x);
float gn_asin_integer(float x);
float gn_acos_integer(float x);
float gn_atan_integer(float x);
float gn_atan2_integer(float y, float x);
float gn_degrees_integer(float radians);
float gn_radians_integer(float degrees);
float gn_exp2_integer(float x);
float gn_exp_integer(float x);
float gn_log2_integer(float x);
float gn_log_integer(float x);
float gn_pow_integer(float x, float y);

#endif
