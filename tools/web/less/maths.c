/* Stands in for parts of the C library with large tables. */
#include <math.h>

/* The C library's sines call this for angles of more than a million. page_turn takes whole turns
 * away, and a map that a glTF file turns so far is not turned. */
int __rem_pio2_large(double *x, double *y, int e0, int nx, int prec);
int __rem_pio2_large(double *x, double *y, int e0, int nx, int prec)
{
    (void)x, (void)e0, (void)nx, (void)prec;
    y[0] = y[1] = 0.0;
    return 0;
}

/* The only power is that of a zoom, whose exponent is whole and bounded (orbit.c, page_zoom). */
double pow(double base, double exponent)
{
    double power = 1.0;
    for (int i = 0; i < (int)fabs(exponent); ++i)
        power *= base;
    return exponent < 0.0 ? 1.0 / power : power;
}
