/* Draws frames, and says how it went. */
#include "frames.h"

#include <stdlib.h>
#include <string.h>

#include "counts.h"
#include "progress.h"
#include "ranks.h"
#include "span.h"
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
    const int fault = counts_report(stdout, name, false, &f->p, o->backend, &f->d.frame);
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

void frames_print(FILE *words, const frames *f, const char *what, uint32_t count, uint32_t here)
{
    const double seconds = 1e-9 * (double)ranks_largest((uint64_t)(f->seconds * 1e9));
    const span share = span_of(here), memory = span_of_memory();
    if (words == NULL)
        return;
    fprintf(words, "%u %s%s, %.1f %ss a second\n", (unsigned)count, what, count == 1 ? "" : "s",
            count / (seconds > 0.0 ? seconds : 1e-9), what);
    const uint32_t ranks = ranks_count();
    if (ranks == 1)
        return;
    fprintf(words, "%u ranks of %s, each with ", (unsigned)ranks, ranks_engine());
    span_print(words, &share);
    fprintf(words, " %s%s; memory of a rank: ", what, share.most == 1 ? "" : "s");
    span_print(words, &memory);
    fputs(" MiB\n", words);
}

void frames_free(frames *f)
{
    drawing_free(&f->d);
    picture_free(&f->p);
    import_free(&f->c.from);
}
