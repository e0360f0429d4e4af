/* Whether the back end that the library chooses is the one that measured best. */
#include "chosen.h"

void chosen_print(FILE *out, const char *what, const double mean[GN_BACKEND_COUNT])
{
    const gn_backend chosen = gn_backend_best();
    gn_backend best = chosen;
    int measured = 0;

    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b) {
        measured += mean[b] > 0.0;
        if (mean[b] > mean[best])
            best = (gn_backend)b;
    }
    if (measured < 2 || !(mean[chosen] > 0.0))
        return;
    fprintf(out, "%s, default %s: %.2f, best %s", what, gn_backend_name(chosen), mean[chosen],
            gn_backend_name(best));
    if (best != chosen)
        fprintf(out, ": %.2f", mean[best]);
    fprintf(out, "\n");
}
