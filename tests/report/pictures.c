/* Pictures for the report (report.py): compares scenes of every class with the pinned reference, as
 * the parity gate does, and writes pictures of some of them as PNG files. */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../command_line.h"
#include "compare.h"
#include "difference.h"
#include "generate.h"
#include "picture_write.h"
#include "shown.h"

#define PROGRAM "report-pictures"
#define DEFAULT_SCENES 24
#define DEFAULT_SHOWN 3
#define DEFAULT_SEED 1
#define MOST_SCENES 10000

static const char help[] =
    "usage: report-pictures [--seed S] [--scenes N] [--shown K] [--class NAME]... [--break]\n"
    "                       DIRECTORY\n"
    "\n"
    "Compares the first N scenes of every class with the pinned reference (OSMesa, llvmpipe), on\n"
    "every back end, as build/parity does. Of K scenes of each class it writes a file into the\n"
    "directory: Gnomon's picture, the reference's and the difference, side by side. The scenes\n"
    "that differ are chosen first, then those whose pictures have the most colours; a scene of "
    "one\n"
    "colour is not chosen. Prints one line for each class and each chosen scene: fields with tabs\n"
    "between.\n"
    "Exit status: 0 if no pixel differs, 1 if one does or the reference is missing, 2 for a wrong\n"
    "command line.\n"
    "\n"
    "  --seed S      seed of the scenes (1)\n"
    "  --scenes N    scenes of each class that are compared, 1 to 10000 (24)\n"
    "  --shown K     scenes of each class that are shown (3)\n"
    "  --class NAME  only this class; may be given several times\n"
    "  --break       for tests: changes one pixel of Gnomon's picture of the first scene\n";

typedef struct options {
    uint64_t seed, scenes, shown;
    bool chosen[CLASS_COUNT]; /* all if none is */
    bool any, breaks;
    const char *directory;
} options;

/* A scene that was compared. */
typedef struct candidate {
    uint64_t number, differ;
    size_t colors;
} candidate;

typedef struct totals {
    uint64_t scenes, triangles, pixels, drawn, color, depth, differ;
} totals;

typedef struct maker {
    options options;
    comparer comparer;
    bool fails;
    time_t last_progress;
} maker;

static bool usage_error(const char *what, const char *value)
{
    fprintf(stderr, PROGRAM ": %s %s (--help says more)\n", what, value);
    return false;
}

static bool parse_value(options *o, const char *name, const char *value)
{
    uint64_t *const number = strcmp(name, "--seed") == 0     ? &o->seed
                             : strcmp(name, "--scenes") == 0 ? &o->scenes
                             : strcmp(name, "--shown") == 0  ? &o->shown
                                                             : NULL;
    if (number)
        return option_number(PROGRAM, name, value, number == &o->scenes,
                             number == &o->scenes ? MOST_SCENES : UINT64_MAX, number);
    if (strcmp(name, "--class") != 0)
        return usage_error("unknown option", name);
    const scene_class c = scene_class_of(value);
    if (c == CLASS_COUNT)
        return usage_error("unknown class", value);
    o->chosen[c] = o->any = true;
    return true;
}

static bool parse_options(int argc, char **argv, options *o)
{
    *o = (options){.seed = DEFAULT_SEED, .scenes = DEFAULT_SCENES, .shown = DEFAULT_SHOWN};
    for (int i = 1; i < argc; ++i)
        if (strcmp(argv[i], "--break") == 0)
            o->breaks = true;
        else if (strncmp(argv[i], "--", 2) != 0)
            o->directory = argv[i];
        else if (i + 1 == argc)
            return usage_error("missing value after", argv[i]);
        else if (!parse_value(o, argv[i], argv[i + 1]))
            return false;
        else
            ++i;
    return o->directory || usage_error("missing", "DIRECTORY");
}

static bool is_wanted(const options *o, int c)
{
    return !o->any || o->chosen[c];
}

/* Whether c is the class whose first scene --break changes. */
static bool is_first(const options *o, int c)
{
    int first = 0;
    while (!is_wanted(o, first))
        ++first;
    return c == first;
}

/* Draws with both and compares; false if the reference fails. */
static bool compare(const maker *m, int c, uint64_t number, const scene *s, comparison *r)
{
    char error[512] = "";
    if (!compare_scene(&m->comparer, s, number, r, error, sizeof error)) {
        fprintf(stderr, PROGRAM ": %s scene %" PRIu64 ": the reference failed: %s\n",
                scene_class_name((scene_class)c), number, error);
        return false;
    }
    if (m->options.breaks && number == 0 && is_first(&m->options, c) && r->status == GN_OK) {
        shown_break(&r->ours, shown_attachment(s));
        r->reference = scene_compare(s, &r->ours, &r->theirs);
    }
    return true;
}

/* Pixels as build/parity counts them: samples, where a pixel has several. */
static uint64_t pixel_count(const scene *s)
{
    return (uint64_t)s->width * s->height * (scene_is_sampled(s) ? GN_SAMPLES : 1);
}

static void count_scene(maker *m, const scene *s, const comparison *r, totals *t)
{
    ++t->scenes;
    t->triangles += scene_triangle_count(s);
    t->pixels += pixel_count(s);
    t->drawn += r->drawn;
    t->color += r->reference.color_pixels;
    t->depth += r->reference.depth_pixels;
    t->differ += compare_count(r);
    m->fails = m->fails || compare_fails(r);
}

static void show_progress(maker *m, int c, uint64_t number)
{
    const time_t now = time(NULL);
    if (now - m->last_progress < 2)
        return;
    m->last_progress = now;
    fprintf(stderr, "report: pictures: class %d of %d, %s, scene %" PRIu64 "\n", c + 1, CLASS_COUNT,
            scene_class_name((scene_class)c), number);
}

/* Scenes that differ come first, then those of the most colours, then the first ones. */
static int by_interest(const void *a, const void *b)
{
    const candidate *const x = a, *const y = b;
    if ((x->differ > 0) != (y->differ > 0))
        return x->differ > 0 ? -1 : 1;
    if (x->colors != y->colors)
        return x->colors > y->colors ? -1 : 1;
    return (x->number > y->number) - (x->number < y->number);
}

static int by_number(const void *a, const void *b)
{
    const candidate *const x = a, *const y = b;
    return (x->number > y->number) - (x->number < y->number);
}

/* Moves the scenes to be shown to the front, in the order of their numbers; returns how many. */
static uint64_t choose(candidate *list, uint64_t count, uint64_t most)
{
    uint64_t chosen = 0;
    qsort(list, count, sizeof *list, by_interest);
    while (chosen < count && chosen < most && (list[chosen].differ > 0 || list[chosen].colors > 1))
        ++chosen;
    qsort(list, chosen, sizeof *list, by_number);
    return chosen;
}

/* Gnomon's picture, the reference's and their difference, side by side with transparent gaps: the
 * second costs next to nothing in the file where it equals the first. */
typedef struct triptych {
    const scene *scene;
    const scene_frame *ours, *theirs;
    int attachment;
} triptych;

enum { PANELS = 3, GAP = 4 };

static uint32_t triptych_width(const scene *s)
{
    return PANELS * s->width + (PANELS - 1) * GAP;
}

static void triptych_row(const void *context, uint32_t y, uint8_t *row)
{
    const triptych *const p = context;
    const size_t width = p->scene->width, first = shown_row(p->ours, y);
    memset(row, 0, (size_t)4 * triptych_width(p->scene));
    for (size_t x = 0; x < width; ++x) {
        uint8_t *const ours = row + 4 * x, *const theirs = ours + 4 * (width + GAP);
        uint8_t *const both = theirs + 4 * (width + GAP);
        shown_pixel(p->ours, p->attachment, first + x, ours);
        shown_pixel(p->theirs, p->attachment, first + x, theirs);
        if (shown_differs(p->scene, p->ours, p->theirs, first + x))
            difference_shown(ours, theirs, true, both);
        ours[3] = theirs[3] = both[3] = 255;
    }
}

static bool write_triptych(const maker *m, const triptych *p, int c, uint64_t number)
{
    char path[4096];
    const int length = snprintf(path, sizeof path, "%s/%s-%" PRIu64 ".png", m->options.directory,
                                scene_class_name((scene_class)c), number);
    if (length < 0 || (size_t)length >= sizeof path) {
        fprintf(stderr, PROGRAM ": the directory's name is too long\n");
        return false;
    }
    return picture_write_file(path, PICTURE_PNG, PNG_RGBA8, triptych_width(p->scene),
                              p->scene->height, triptych_row, p) == 0;
}

static const char *name_of(gn_format format)
{
    const char *const name = scene_format_of(format)->name;
    return name ? name : "none";
}

static void print_scene(int c, const candidate *at, const scene *s, const comparison *r)
{
    printf("scene\tclass=%s\tnumber=%" PRIu64 "\twidth=%" PRIu32 "\theight=%" PRIu32 "\tcolor=",
           scene_class_name((scene_class)c), at->number, s->width, s->height);
    for (int a = 0, printed = 0; a < GN_MAX_COLORS; ++a)
        if (a == 0 || scene_color_format(s, a) != GN_FORMAT_NONE)
            printf("%s%s", printed++ ? ", " : "", name_of(scene_color_format(s, a)));
    printf("\tdepth=%s\tsamples=%d\tdraws=%zu\ttriangles=%" PRIu64 "\tpixels=%" PRIu64
           "\tdrawn=%" PRIu64 "\tdiffer=%" PRIu64 "\tcolor_pixels=%" PRIu64
           "\tdepth_pixels=%" PRIu64 "\tcolor_largest=%g\tdepth_largest=%g\tcolors=%zu\tshown=%d\n",
           name_of(s->depth_format), scene_is_sampled(s) ? GN_SAMPLES : 1, s->draw_count,
           scene_triangle_count(s), pixel_count(s), r->drawn, compare_count(r),
           r->reference.color_pixels, r->reference.depth_pixels, r->reference.color_largest,
           r->reference.depth_largest, at->colors, shown_attachment(s));
}

static bool show_scene(const maker *m, int c, const candidate *at)
{
    comparison r;
    scene *const s = generate_scene(m->options.seed, (scene_class)c, at->number);
    bool good = compare(m, c, at->number, s, &r);
    if (good) {
        const triptych p = {s, &r.ours, &r.theirs, shown_attachment(s)};
        good = write_triptych(m, &p, c, at->number);
        print_scene(c, at, s, &r);
    }
    compare_free(&r);
    scene_free(s);
    return good;
}

static bool make_class(maker *m, int c)
{
    const options *const o = &m->options;
    candidate *const list = calloc(o->scenes, sizeof *list);
    totals t;
    bool good = list != NULL;
    memset(&t, 0, sizeof t);
    for (uint64_t n = 0; good && n < o->scenes; ++n) {
        comparison r;
        scene *const s = generate_scene(o->seed, (scene_class)c, n);
        show_progress(m, c, n);
        good = compare(m, c, n, s, &r);
        if (good) {
            count_scene(m, s, &r, &t);
            list[n] =
                (candidate){n, compare_count(&r),
                            r.status == GN_OK ? shown_colors(&r.ours, shown_attachment(s)) : 0};
        }
        compare_free(&r);
        scene_free(s);
    }
    if (good)
        printf("class\tnumber=%d\tname=%s\tscenes=%" PRIu64 "\ttriangles=%" PRIu64
               "\tpixels=%" PRIu64 "\tdrawn=%" PRIu64 "\tcolor=%" PRIu64 "\tdepth=%" PRIu64
               "\tdiffer=%" PRIu64 "\n",
               c, scene_class_name((scene_class)c), t.scenes, t.triangles, t.pixels, t.drawn,
               t.color, t.depth, t.differ);
    const uint64_t shown = good ? choose(list, o->scenes, o->shown) : 0;
    for (uint64_t i = 0; good && i < shown; ++i)
        good = show_scene(m, c, &list[i]);
    free(list);
    return good;
}

/* Starts the reference and the threads. */
static bool start(maker *m)
{
    char error[512] = "";
    m->comparer.reference = reference_create(REFERENCE_PINNED, error, sizeof error);
    if (!m->comparer.reference) {
        fprintf(stderr,
                "report: no page is written, since the reference is missing: %s ('make setup' "
                "installs OSMesa)\n",
                error);
        return false;
    }
    if (!compare_start(&m->comparer)) {
        fprintf(stderr, PROGRAM ": threads cannot be started\n");
        return false;
    }
    printf("reference\tname=%s %s, %s\tclasses=%d\n", reference_driver_name(m->comparer.reference),
           reference_mesa_version(m->comparer.reference), reference_renderer(m->comparer.reference),
           CLASS_COUNT);
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
        if (gn_backend_available((gn_backend)b))
            printf("backend\tname=%s\n", gn_backend_name((gn_backend)b));
    return true;
}

int main(int argc, char **argv)
{
    maker m;
    memset(&m, 0, sizeof m);
    for (int i = 1; i < argc; ++i)
        if (strcmp(argv[i], "--help") == 0) {
            fputs(help, stdout);
            return 0;
        }
    if (!parse_options(argc, argv, &m.options))
        return 2;
    m.last_progress = time(NULL);
    bool good = start(&m);
    for (int c = 0; good && c < CLASS_COUNT; ++c)
        if (is_wanted(&m.options, c))
            good = make_class(&m, c);
    if (m.comparer.reference) {
        compare_stop(&m.comparer);
        reference_destroy(m.comparer.reference);
    }
    if (good)
        printf("end\tfails=%s\n", m.fails ? "yes" : "no");
    if (fflush(stdout) != 0 || ferror(stdout))
        good = false;
    return good && !m.fails ? 0 : 1;
}
