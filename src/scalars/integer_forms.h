/* The scalar functions in integers. Each has the contract of the public function of its name.
 * Targets without doubles in hardware use nothing else. Elsewhere the public functions compute in
 * double and call these only if the double does not decide the rounding (double_forms.h). The tests
 * check both forms. */
#ifndef GN_SCALARS_INTEGER_FORMS_H
#define GN_SCALARS_INTEGER_FORMS_H

float gni_sqrt_integer(float x);
float gni_rsqrt_integer(float x);
float gni_sin_integer(float x);
float gni_cos_integer(float x);
void gni_sincos_integer(float x, float *sine, float *cosine);
float gni_tan_integer(float x);
float gni_asin_integer(float x);
float gni_acos_integer(float x);
float gni_atan_integer(float x);
float gni_atan2_integer(float y, float x);
float gni_degrees_integer(float radians);
float gni_radians_integer(float degrees);
float gni_exp2_integer(float x);
float gni_exp_integer(float x);
float gni_log2_integer(float x);
float gni_log_integer(float x);
float gni_pow_integer(float x, float y);

#endif
