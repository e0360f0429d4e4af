/* The measurements. Times are processor times, minima of several runs, so that other programs on
 * the machine disturb them little; only the disk's is the time that passes.
 *
 * Draws that miss all their rows, as most triangles miss a band in sort-first, tell what a vertex
 * and a triangle cost: once with shared vertices, once with three of its own for each triangle.
 * What draws of several sizes cost above that is divided among drawn triangles, rows and fragments
 * by least squares. */
#include "scale_measure.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "scale_figures.h"
#include "scale_fit.h"
#include "scale_model.h"
#include "scale_work.h"

#include "output.h"
#include "picture_write.h"
#include "png_segments.h"

typedef struct measuring {
    const char *path;
    char model_path[512], picture_path[512];
    int runs;
    bool quick;
    FILE *out;
} measuring;

static bool fail(const char *why)
{
    fprintf(stderr, "scale: %s\n", why);
    return false;
}

static double seconds_of(const struct timeval *t)
{
    return (double)t->tv_sec + (double)t->tv_usec * 1e-6;
}

/* Processor time of this process and of those it has waited for. */
static double used_time(void)
{
    struct rusage children;
    struct timespec own;
    getrusage(RUSAGE_CHILDREN, &children);
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &own);
    return (double)own.tv_sec + (double)own.tv_nsec * 1e-9 + seconds_of(&children.ru_utime) +
           seconds_of(&children.ru_stime);
}

/* The least time of several runs of a function; below 0 if it fails. */
static double least_time(int runs, bool (*function)(void *), void *context)
{
    double least = -1.0;
    for (int i = 0; i < runs; ++i) {
        const double start = used_time();
        if (!function(context))
            return -1.0;
        const double time = used_time() - start;
        least = least < 0.0 || time < least ? time : least;
    }
    return least > 0.0 ? least : least < 0.0 ? least : 1e-9;
}

static bool draw_once(void *context)
{
    scale_model *m = context;
    return drawing_draw(m->p.scene, &m->d) == 0;
}

/* A picture's time without its clear; *clear is the clear's. */
static double draw_time(const measuring *k, scale_model *m, double *clear)
{
    const size_t draws = m->p.scene->draw_count;
    m->p.scene->draw_count = 0;
    *clear = least_time(k->runs, draw_once, m);
    m->p.scene->draw_count = draws;
    const double both = least_time(k->runs, draw_once, m);
    return both < 0.0 || *clear < 0.0 ? -1.0 : both > *clear ? both - *clear : 1e-9;
}

/* Measures draws that miss all rows, with shared vertices and without. */
static bool measure_vertices(measuring *k, double *vertex, double *triangle)
{
    fit_row rows[2];
    double found[FIT_MOST];
    for (int divided = 0; divided < 2; ++divided) {
        scale_model m;
        double clear, time = -1.0;
        if (scale_model_make(k->quick ? 20 : 60, 256, divided, &m)) {
            scene_draw *draw = m.p.scene->draws;
            draw->state.raster.viewport = (gn_viewport){true, 0, 1024, 256, 256};
            time = draw_time(k, &m, &clear);
            rows[divided] = (fit_row){{draw->mesh.vertex_count, draw->mesh.count / 3.0, 0}, time};
        }
        scale_model_free(&m);
        if (time < 0.0)
            return false;
    }
    fit_rows(rows, 2, 2, found);
    *vertex = found[0];
    *triangle = found[1];
    figures_write(k->out, FIGURE_VERTEX, found[0] * 1e9);
    figures_write(k->out, FIGURE_TRIANGLE, found[1] * 1e9);
    return true;
}

/* Adds a row of drawn triangles, rows and fragments. */
static bool measure_draw(const measuring *k, const work *counted, uint32_t side, double vertex,
                         double triangle, fit_row *row, double *clear)
{
    scale_model m;
    double time = -1.0;
    if (scale_model_make(counted->scene.level, side, false, &m)) {
        m.p.scene->draws[0].counted = true;
        if (draw_once(&m)) {
            const gn_draw_statistics s = m.d.frame.statistics;
            const double larger = (double)side / WORK_MOST;
            const double grown = counted->whole.rows * larger;
            row->count[0] = (double)s.drawn;
            row->count[1] = grown > (double)s.drawn ? grown : (double)s.drawn;
            row->count[2] = (double)s.samples_covered;
            m.p.scene->draws[0].counted = false;
            time = draw_time(k, &m, clear);
        }
    }
    scale_model_free(&m);
    if (time < 0.0)
        return false;
    row->seconds = time - vertex * counted->vertices - triangle * counted->triangles;
    if (row->seconds < 0.1 * time)
        row->seconds = 0.1 * time;
    return true;
}

static bool measure_draws(measuring *k, double vertex, double triangle)
{
    static const uint32_t levels[] = {10, 40, 80}, sides[] = {256, 1024, 2048};
    const int level_count = k->quick ? 1 : 3, side_count = k->quick ? 2 : 3;
    fit_row rows[9];
    double found[FIT_MOST], clear = 0.0;
    uint32_t count = 0;
    work *counted = malloc(sizeof *counted);
    bool good = counted != NULL || fail("not enough memory");
    for (int l = 0; l < level_count && good; ++l) {
        const work_scene which = {"", WORK_MOST, levels[l], 1};
        good = work_count(&which, counted);
        for (int s = 0; s < side_count && good; ++s)
            good = measure_draw(k, counted, sides[s], vertex, triangle, &rows[count++], &clear);
    }
    free(counted);
    if (!good)
        return false;
    const double error = fit_rows(rows, count, 3, found);
    const double cleared = sides[side_count - 1];
    figures_write(k->out, FIGURE_DRAWN, found[0] * 1e9);
    figures_write(k->out, FIGURE_ROW, found[1] * 1e9);
    figures_write(k->out, FIGURE_FRAGMENT, found[2] * 1e9);
    fprintf(k->out, "# the last three fit %u draws, each within %.0f %%\n", (unsigned)count,
            100.0 * error);
    figures_write(k->out, FIGURE_CLEAR, clear / (cleared * cleared) * 1e9);
    return true;
}

static bool use_new_memory(void *context)
{
    scale_model *m = context;
    drawing d;
    const bool good =
        drawing_allocate(m->p.scene, m->o.backend, &d) == 0 && drawing_draw(m->p.scene, &d) == 0;
    drawing_free(&d);
    return good;
}

/* Pictures of 64 MiB a surface are memory that the system gives and takes back each time. */
static bool measure_memory(measuring *k)
{
    scale_model m;
    double used = -1.0, again = -1.0;
    if (scale_model_make(1, 4096, false, &m)) {
        const size_t draws = m.p.scene->draw_count;
        m.p.scene->draw_count = 0;
        again = least_time(k->runs, draw_once, &m);
        used = least_time(k->runs, use_new_memory, &m);
        m.p.scene->draw_count = draws;
    }
    scale_model_free(&m);
    if (used < 0.0 || again < 0.0)
        return false;
    const double pixels = 4096.0 * 4096.0;
    figures_write(k->out, FIGURE_TOUCH, (used > again ? used - again : 0.0) / pixels * 1e9);
    return true;
}

typedef struct compressing {
    const measuring *k;
    scale_model m;
    double bytes;
} compressing;

/* A frame's file, as spin writes it. */
static bool compress_frame(void *context)
{
    compressing *c = context;
    const options *o = &c->m.o;
    return picture_write_file(c->k->picture_path, PICTURE_PNG, PNG_RGBA8, o->width, o->height,
                              drawing_color_row, &c->m.d.frame) == 0;
}

/* A rank's rows of one picture. */
static bool compress_rows(void *context)
{
    compressing *c = context;
    const options *o = &c->m.o;
    png_segments segments;
    const row_range rows = {0, o->height};
    const bool good = png_segments_make(PNG_RGBA8, o->width, o->height, rows, drawing_color_row,
                                        &c->m.d.frame, &segments);
    c->bytes = (double)segments.size;
    png_segments_free(&segments);
    return good;
}

/* Seconds and bytes of the picture that is drawn now, [0] as a frame, [1] as rows. */
static bool compress(compressing *c, double seconds[2])
{
    const int runs = c->k->quick ? 1 : 3;
    if (!draw_once(&c->m))
        return false;
    seconds[0] = least_time(runs, compress_frame, c);
    seconds[1] = least_time(runs, compress_rows, c);
    return seconds[0] > 0.0 && seconds[1] > 0.0;
}

static void write_compression(const measuring *k, figure_kind empty, double pixels, double covered,
                              double all_empty, double drawn, double unit)
{
    const double each = all_empty / pixels;
    const double shown = (drawn - each * (pixels - covered)) / covered;
    figures_write(k->out, empty, each * unit);
    figures_write(k->out, empty + 1, (shown > 0.0 ? shown : 0.0) * unit);
}

static bool measure_compression(measuring *k)
{
    compressing c = {.k = k};
    const uint32_t side = k->quick ? 256 : 2048;
    const double pixels = (double)side * side;
    double empty[2], drawn[2], empty_bytes = 0.0, drawn_bytes = 0.0, covered = 0.0;
    bool good = scale_model_make(40, side, false, &c.m) && compress(&c, drawn);
    for (size_t i = 0; i < (size_t)side * side && good; ++i)
        covered += ((const float *)c.m.d.frame.depth)[i] < 1.0f;
    if (good) {
        const size_t draws = c.m.p.scene->draw_count;
        drawn_bytes = c.bytes;
        c.m.p.scene->draw_count = 0;
        good = compress(&c, empty);
        c.m.p.scene->draw_count = draws;
        empty_bytes = c.bytes;
    }
    scale_model_free(&c.m);
    remove(k->picture_path);
    if (!good)
        return fail("a picture cannot be written");
    write_compression(k, FIGURE_FRAME_EMPTY, pixels, covered, empty[0], drawn[0], 1e9);
    write_compression(k, FIGURE_COMPRESS_EMPTY, pixels, covered, empty[1], drawn[1], 1e9);
    write_compression(k, FIGURE_BYTES_EMPTY, pixels, covered, empty_bytes, drawn_bytes, 1.0);
    return true;
}

typedef struct reading {
    options o;
    contents c;
    picture p;
} reading;

static bool read_once(void *context)
{
    reading *r = context;
    if (picture_import(&r->o, &r->c) != 0)
        return false;
    import_free(&r->c.from);
    return true;
}

static bool prepare_once(void *context)
{
    reading *r = context;
    if (picture_build(&r->o, &r->c, true, &r->p) != 0)
        return false;
    picture_free(&r->p);
    return true;
}

static bool measure_reading(measuring *k)
{
    reading r;
    scale_model m;
    const bool made = scale_model_make(k->quick ? 10 : 60, 256, false, &m);
    const bool written = made && scale_model_write(&m, k->model_path);
    double read = -1.0, prepared = -1.0;
    memset(&r, 0, sizeof r);
    if (written) {
        r.o = m.o;
        r.o.model = r.o.models[0].path = k->model_path;
        read = least_time(k->quick ? 1 : 3, read_once, &r);
    }
    if (read >= 0.0 && picture_import(&r.o, &r.c) == 0) {
        prepared = least_time(k->runs, prepare_once, &r);
        import_free(&r.c.from);
    }
    const double triangles = made ? m.p.scene->draws[0].mesh.count / 3.0 : 1.0;
    scale_model_free(&m);
    remove(k->model_path);
    if (prepared < 0.0)
        return false;
    figures_write(k->out, FIGURE_READ, read / triangles * 1e9);
    figures_write(k->out, FIGURE_PREPARE, prepared / triangles * 1e9);
    return true;
}

#define MERGED ((size_t)1 << 20)

typedef struct merging {
    float *depth[3]; /* the own ones, the other rank's, and those that have come */
    uint32_t *color[3];
    size_t size; /* of a value: not known to the compiler, as in merge.c */
} merging;

/* As ranks merge: rows are copied on both sides, and a pixel of the other rank wins if its depth is
 * less. */
static bool merge_once(void *context)
{
    const merging *m = context;
    float *depth = m->depth[0];
    uint32_t *color = m->color[0];
    memcpy(m->depth[2], m->depth[1], MERGED * m->size);
    memcpy(m->color[2], m->color[1], MERGED * m->size);
    for (size_t i = 0; i < MERGED; ++i) {
        if (!(m->depth[2][i] < depth[i]))
            continue;
        memcpy((char *)depth + i * m->size, (char *)m->depth[2] + i * m->size, m->size);
        memcpy((char *)color + i * m->size, (char *)m->color[2] + i * m->size, m->size);
    }
    return true;
}

static bool measure_merging(measuring *k)
{
    merging m = {.size = sizeof(float)};
    uint32_t random = 1;
    bool good = true;
    for (int side = 0; side < 3; ++side) {
        m.depth[side] = malloc(MERGED * sizeof(float));
        m.color[side] = malloc(MERGED * sizeof(uint32_t));
        good = good && m.depth[side] != NULL && m.color[side] != NULL;
        for (size_t i = 0; i < MERGED && good; ++i) {
            random = random * 1664525u + 1013904223u;
            m.depth[side][i] = side == 0 ? 1.0f : (float)(random >> 8) / 8388608.0f;
            m.color[side][i] = random;
        }
    }
    if (good)
        figures_write(k->out, FIGURE_MERGE,
                      least_time(k->runs, merge_once, &m) / (double)MERGED * 1e9);
    for (int side = 0; side < 3; ++side) {
        free(m.depth[side]);
        free(m.color[side]);
    }
    return good || fail("not enough memory");
}

#define EXTRACTED ((size_t)1 << 19)

/* As rank 0 chooses a part: it marks the vertices of some triangles, counts and numbers them. */
static bool extract_once(void *context)
{
    volatile size_t *const kept = context;
    const size_t part = EXTRACTED / 8;
    uint32_t *numbers = calloc(EXTRACTED, sizeof *numbers);
    uint32_t *chosen = malloc(part * sizeof *chosen);
    size_t used = 0, next = 0;
    for (size_t i = 0; i < 6 * part && numbers != NULL; ++i)
        numbers[i / 6] = 1;
    for (size_t v = 0; v < EXTRACTED && numbers != NULL; ++v)
        used += numbers[v];
    for (size_t v = 0; v < EXTRACTED && numbers != NULL && chosen != NULL; ++v) {
        if (numbers[v] != 0) {
            numbers[v] = (uint32_t)next;
            chosen[next++] = (uint32_t)v;
        }
    }
    const bool good = numbers != NULL && chosen != NULL && used == next;
    *kept = used + (good ? chosen[next / 2] : 0);
    free(numbers);
    free(chosen);
    return good || fail("not enough memory");
}

static bool measure_extracting(measuring *k)
{
    size_t kept = 0;
    const double time = least_time(k->runs, extract_once, &kept);
    if (time > 0.0)
        figures_write(k->out, FIGURE_EXTRACT, time / (double)EXTRACTED * 1e9);
    return time > 0.0;
}

/* Writes 64 MiB, or 4, and waits until they are on the disk. */
static bool measure_disk(measuring *k)
{
    const size_t size = (size_t)(k->quick ? 4 : 64) << 20;
    char *bytes = malloc(size);
    struct timespec start, end;
    bool good = bytes != NULL;
    for (size_t i = 0; i < size && good; ++i)
        bytes[i] = (char)(i * 2654435761u >> 13);
    clock_gettime(CLOCK_MONOTONIC, &start);
    FILE *file = good ? fopen(k->picture_path, "wb") : NULL;
    good = file != NULL && fwrite(bytes, 1, size, file) == size && fflush(file) == 0 &&
           fsync(fileno(file)) == 0;
    clock_gettime(CLOCK_MONOTONIC, &end);
    if (file != NULL)
        fclose(file);
    remove(k->picture_path);
    free(bytes);
    const double seconds =
        (double)(end.tv_sec - start.tv_sec) + (double)(end.tv_nsec - start.tv_nsec) * 1e-9;
    if (good)
        figures_write(k->out, FIGURE_DISK, (double)size * 1e-6 / (seconds > 0 ? seconds : 1e-9));
    return good || fail("64 MB cannot be written beside the file of figures");
}

static bool measure_all(measuring *k)
{
    double vertex, triangle;
    fprintf(k->out, "# measured by scale --measure, back end %s\n",
            gn_backend_name(gn_backend_best()));
    return measure_vertices(k, &vertex, &triangle) && measure_draws(k, vertex, triangle) &&
           measure_memory(k) && measure_merging(k) && measure_extracting(k) &&
           measure_compression(k) && measure_reading(k) && measure_disk(k);
}

bool measure_figures(const char *path, bool quick)
{
    measuring k = {.path = path, .runs = quick ? 2 : 7, .quick = quick};
    output out;
    if (snprintf(k.model_path, sizeof k.model_path, "%s.obj", path) >= (int)sizeof k.model_path ||
        snprintf(k.picture_path, sizeof k.picture_path, "%s.png", path) >=
            (int)sizeof k.picture_path)
        return fail("the file's name is too long");
    if (output_open(&out, path) != 0)
        return false;
    k.out = out.file;
    const bool good = measure_all(&k) && output_finish(&out) == 0 && output_rename(&out) == 0;
    output_abandon(&out);
    return good;
}
