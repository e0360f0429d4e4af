/* Two ranks send a message to and fro. Short messages tell the latency; long ones, less the
 * latency, the bandwidth. Both are the best of several series, since other programs may run. */
#include "scale_messages.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "ranks.h"
#include "scale_figures.h"

#define LONG_MESSAGE ((uint64_t)1 << 22)

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

/* Seconds of one message; only rank 0's are of interest. */
static double message_time(void *bytes, uint64_t size, int times, int series)
{
    double best = 1e9;
    for (int s = 0; s < series; ++s) {
        const double start = now();
        for (int i = 0; i < times; ++i) {
            if (ranks_number() == 0)
                ranks_send(1, 1, bytes, size);
            else
                ranks_receive(0, 1, bytes, size);
            if (ranks_number() == 0)
                ranks_receive(1, 2, bytes, size);
            else
                ranks_send(0, 2, bytes, size);
        }
        const double time = (now() - start) / (2.0 * times);
        best = time < best ? time : best;
    }
    return best;
}

static bool write_figures(const char *path, double latency, double bandwidth)
{
    FILE *out = fopen(path, "a");
    if (out != NULL) {
        fprintf(out, "# messages between two ranks, %s\n", ranks_engine());
        figures_write(out, FIGURE_LOCAL_LATENCY, latency * 1e6);
        figures_write(out, FIGURE_LOCAL_BANDWIDTH, bandwidth * 1e-6);
    }
    if (out == NULL || fclose(out) != 0) {
        fprintf(stderr, "scale: cannot write %s: %s\n", path, strerror(errno));
        return false;
    }
    return true;
}

bool messages_measure(const char *path)
{
    bool good = true;
    if (ranks_count() < 2) {
        fprintf(stderr, "scale: --messages takes two ranks: mpirun -n 2\n");
        return false;
    }
    char *bytes = calloc(1, LONG_MESSAGE);
    if (ranks_largest(bytes == NULL) != 0) {
        fprintf(stderr, "scale: not enough memory\n");
        free(bytes);
        return false;
    }
    if (ranks_number() < 2) {
        const double latency = message_time(bytes, 8, 200, 20);
        const double longer = message_time(bytes, LONG_MESSAGE, 4, 10);
        if (ranks_number() == 0)
            good = write_figures(path, latency, (double)LONG_MESSAGE / (longer - latency));
    }
    free(bytes);
    return ranks_largest(!good) == 0;
}
