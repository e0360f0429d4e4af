/* The time of a run by formula, and the memory of a rank. */
#include "scale_cost.h"

static double draws(const cost *c)
{
    return c->clear + c->vertices + c->triangles + c->fragments;
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

/* What all ways begin with. */
static double begins(way_kind way, const work *w, const figures *f, uint32_t ranks, double latency,
                     double bandwidth)
{
    const double n = ranks;
    double result = f->value[FIGURE_START] + cost_ns(f, FIGURE_READ, w->triangles) +
                    cost_of_preparing(way, w, f, ranks);
    if (ranks > 1 && way == WAY_SORT_LAST) {
        const double extract = cost_ns(f, FIGURE_EXTRACT, w->vertices);
        return result + (n - 1) * (extract + w->model_bytes / (n * bandwidth)) +
               larger(extract, latency) + engine_log2(ranks) * latency;
    }
    if (ranks > 1)
        result += (2 * engine_log2(ranks) + n - 1) * latency +
                  2 * w->model_bytes * (n - 1) / (n * bandwidth);
    return result;
}

static double of_picture(way_kind way, const work *w, const figures *f, uint32_t ranks,
                         double latency, double bandwidth, double disk)
{
    const double n = ranks, pixels = cost_pixels(w);
    double drawing = 0.0, compressing = 0.0, bytes = 0.0, result = 0.0;
    for (uint32_t i = 0; i < ranks; ++i) {
        const cost c = cost_of_picture(way, w, f, ranks, i);
        drawing = larger(drawing, draws(&c));
        compressing = larger(compressing, c.compress);
        bytes += c.bytes;
    }
    if (way == WAY_SORT_LAST)
        result += (n - 1) * (cost_pieces(w, ranks) * latency + 8 * pixels / (n * bandwidth)) +
                  cost_ns(f, FIGURE_MERGE, pixels * (n - 1) / n);
    const int agreements = way == WAY_SORT_LAST ? 4 : 3;
    return result + drawing + compressing + bytes / disk +
           agreements * engine_log2(ranks) * latency;
}

static double of_frames(way_kind way, const work *w, const figures *f, uint32_t ranks,
                        double latency, double bandwidth, double disk)
{
    const double frames = w->scene.frames, n = ranks;
    double drawing = 0.0, bytes = 0.0;
    for (uint32_t i = 0; i < w->scene.frames; ++i) {
        const cost c = cost_of_frame(w, f, i);
        drawing += draws(&c) + c.compress;
        bytes += c.bytes;
    }
    const double rounds = (double)((w->scene.frames + ranks - 1) / ranks);
    /* Either drawing or the disk is busy all the time; a rank's own frames reach the disk one after
     * the other with their drawing. */
    double result = larger(drawing / frames * rounds + bytes / disk / n, bytes / disk);
    if (way == WAY_ANIMATION && ranks > 1)
        result = larger(result, bytes * (n - 1) / n / bandwidth);
    return result + engine_log2(ranks) * latency;
}

double way_formula(way_kind way, const work *w, const figures *f, uint32_t ranks,
                   const way_place *place)
{
    const bool local = ranks <= place->ranks_a_machine;
    const double latency = f->value[local ? FIGURE_LOCAL_LATENCY : FIGURE_LATENCY] * 1e-6;
    const double bandwidth = f->value[local ? FIGURE_LOCAL_BANDWIDTH : FIGURE_BANDWIDTH] * 1e6;
    const double disk = f->value[place->one_machine ? FIGURE_DISK : FIGURE_SHARED_DISK] * 1e6;
    return begins(way, w, f, ranks, latency, bandwidth) +
           (way_has_frames(way)
                ? of_frames(way, w, f, ranks, latency, bandwidth, disk)
                : w->scene.frames * of_picture(way, w, f, ranks, latency, bandwidth, disk));
}

double way_memory(way_kind way, const work *w, const figures *f, uint32_t ranks)
{
    const double pixels = cost_pixels(w);
    double bytes = 0.0;
    if (way_has_frames(way))
        return 2 * w->model_bytes + 8 * pixels + cost_of_frame(w, f, 0).bytes;
    for (uint32_t i = 0; i < ranks; ++i)
        bytes = larger(bytes, cost_of_picture(way, w, f, ranks, i).bytes);
    if (way == WAY_SORT_FIRST)
        return 2 * w->model_bytes + 8 * pixels / ranks + bytes;
    return w->model_bytes + w->model_bytes / ranks + 8 * pixels + 8 * pixels / ranks + bytes;
}
