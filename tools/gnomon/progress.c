/* Shows progress on a terminal. */
#define _POSIX_C_SOURCE 200809L
#include "progress.h"

#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define BAR_WIDTH 30
#define LEAST_INTERVAL 0.1
#define LEAST_INTERVAL_OF_LINES 1.0

/* Back to the beginning of the line, and everything in it is removed (ECMA-48: CR, EL). */
#define CLEAR_LINE "\r\033[K"

double progress_clock(void)
{
    struct timespec present;
    clock_gettime(CLOCK_MONOTONIC, &present);
    return (double)present.tv_sec + 1e-9 * (double)present.tv_nsec;
}

void progress_begin(progress *p)
{
    p->visible = isatty(STDERR_FILENO) != 0;
    p->has_lines = false;
    p->tenths = 0;
    p->start = progress_clock();
    p->last = 0.0;
}

void progress_begin_lines(progress *p)
{
    progress_begin(p);
    p->has_lines = !p->visible;
    p->last = p->start;
}

static void show_line(progress *p, uint32_t done, uint32_t all)
{
    const double present = progress_clock();
    const uint32_t tenths = (uint32_t)((uint64_t)10 * done / all);
    if (tenths <= p->tenths || done == all || present - p->last < LEAST_INTERVAL_OF_LINES)
        return;
    p->tenths = tenths;
    p->last = present;
    fprintf(stderr, "gnomon: %u of %u, %.0f s left\n", (unsigned)done, (unsigned)all,
            (present - p->start) / done * (all - done));
}

void progress_show(progress *p, uint32_t done, uint32_t all)
{
    const double present = progress_clock();
    char bar[BAR_WIDTH + 1];
    if (p->has_lines && all > 0)
        show_line(p, done, all);
    if (!p->visible || done == 0 || present - p->last < LEAST_INTERVAL)
        return;
    p->last = present;
    const int filled = (int)((uint64_t)BAR_WIDTH * done / all);
    memset(bar, '#', (size_t)filled);
    memset(bar + filled, '.', (size_t)(BAR_WIDTH - filled));
    bar[BAR_WIDTH] = '\0';
    const double left = (present - p->start) / done * (all - done);
    fprintf(stderr, CLEAR_LINE "[%s] %u of %u, %.0f s left", bar, (unsigned)done, (unsigned)all,
            left);
    fflush(stderr);
}

double progress_end(progress *p)
{
    if (p->visible && p->last > 0.0)
        fputs(CLEAR_LINE, stderr);
    return progress_clock() - p->start;
}
