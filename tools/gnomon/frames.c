/* Draws frames, and says how it went. */
#define _XOPEN_SOURCE 700
#include "frames.h"

#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

#include "counts.h"
#include "progress.h"
#include "ranks.h"
#include "together.h"

int frames_begin(const options *o, frames *f)
{
    together_begin();
    int fault = picture_build(o, &f->c, false, &f->p);
    if (fault == 0)
        fault = drawing_allocate(f->p.scene, o->backend, &f->d);
    return together_end(fault);
}

int frames_draw(frames *f, const options *o, const gn_transform *turn)
{
    const double start = progress_clock();
    int fault = picture_place(&f->p, o, &f->c, turn);
    if (fault == 0)
        fault = drawing_draw(f->p.scene, &f->d);
    f->seconds += progress_clock() - start;
    return fault;
}

int frames_warn(const char *name, const options *o, frames *f)
{
    scene *s = f->p.scene;
    const int fault = counts_report(stdout, name, false, s, o->backend, &f->d.frame);
    for (size_t i = 0; i < s->draw_count; ++i)
        s->draws[i].counted = false; /* the next frame is drawn faster */
    return fault;
}

void frames_color_row(const void *rows, uint32_t y, uint8_t *row)
{
    const frames_rows *r = rows;
    tasks_poll(r->t);
    drawing_color_row(r->frame, y, row);
}

void frames_depth_row(const void *rows, uint32_t y, uint8_t *row)
{
    const frames_rows *r = rows;
    tasks_poll(r->t);
    drawing_depth_row(r->frame, y, row);
}

/* MiB that this process has had in memory at most, rounded up. */
static uint64_t peak_memory(void)
{
    struct rusage usage;
    if (getrusage(RUSAGE_SELF, &usage) != 0)
        return 0;
    return ((uint64_t)usage.ru_maxrss + 1023) / 1024;
}

static uint64_t ranks_smallest(uint64_t number)
{
    return UINT64_MAX - ranks_largest(UINT64_MAX - number);
}

void frames_print(FILE *words, const frames *f, const char *what, uint32_t count, uint32_t here)
{
    const uint64_t memory = peak_memory();
    const double seconds = 1e-9 * (double)ranks_largest((uint64_t)(f->seconds * 1e9));
    const uint64_t least = ranks_smallest(here), most = ranks_largest(here);
    const uint64_t memory_least = ranks_smallest(memory), memory_most = ranks_largest(memory);
    if (words == NULL)
        return;
    fprintf(words, "%u %s%s, %.1f %ss a second\n", (unsigned)count, what, count == 1 ? "" : "s",
            count / (seconds > 0.0 ? seconds : 1e-9), what);
    if (ranks_count() > 1)
        fprintf(words, "%u ranks (%s): %llu to %llu %ss each, %llu to %llu MiB of memory each\n",
                (unsigned)ranks_count(), ranks_engine(), (unsigned long long)least,
                (unsigned long long)most, what, (unsigned long long)memory_least,
                (unsigned long long)memory_most);
}

void frames_free(frames *f)
{
    drawing_free(&f->d);
    picture_free(&f->p);
    import_free(&f->c.from);
}
