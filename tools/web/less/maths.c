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

/* Powers of bases that are not negative, with exponents below a few thousand: those of a zoom,
 * which are whole (orbit.c, page_zoom), and of the encoding of colours (look_colors.c), which
 * become floats. A fraction of the exponent is a sum of halves of halves, each of them a square
 * root. */
double pow(double base, double exponent)
{
    const double size = fabs(exponent);
    double power = 1.0, root = base;
    for (int i = 0; i < (int)size; ++i)
        power *= base;
    for (double rest = size - (int)size; rest > 0.0;) {
        root = sqrt(root);
        rest *= 2.0;
        if (rest >= 1.0) {
            power *= root;
            rest -= 1.0;
        }
    }
    return exponent < 0.0 ? 1.0 / power : power;
}
