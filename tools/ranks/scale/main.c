/* Predicts how pictures and sequences scale over ranks: a cost model, and a simulation of events.
 *
 * The cost model. A rank pays
 *
 *   start                                      once
 *   read T                                     rank 0 reads the model's file; the others wait
 *   2 S (N - 1) / (N B) + (log2 N + N - 1) L   sharing the model, S = 40 V + 12 T bytes
 *   N extract V + (N - 1) S / (N B)            instead in sort-last: rank 0 sends each its part
 *   prepare T + touch P                        its own copy of the model, memory for its pixels
 *   clear P + vertex V + triangle T + drawn D + row R + fragment F      drawing
 *   (N - 1) (k L + 8 P / (N B) + merge P / N)  sort-last: exchange of bands of colour and depth
 *   compress (empty and drawn pixels)          its rows of the file
 *   bytes of them / disk                       writing
 *   log2 N L                                   each of 4 or 5 agreements at the ends of phases
 *
 * for V vertices, T triangles, D of them drawn, with R rows of pixels and F fragments, P pixels, N
 * ranks, latency L, bandwidth B and bands that are exchanged in k pieces. In sort-first (Molnar,
 * Cox, Ellsworth and Fuchs, "A Sorting Classification of Parallel Rendering", 1994) every rank pays
 * V and T in full, but only its band's D, R, F and P. In sort-last it pays V / N and T / N, its
 * part's D, R and F, all P for clearing, and the exchange: direct send (Hsu, 1993; Ma, Painter,
 * Hansen and Krogh, 1994, compare it with binary swap, which has log2 N messages a rank instead of
 * N - 1 and sends as many bytes). D, R and F of bands and parts are counted by the library in the
 * scene itself (scale_work.h), so unequal loads are those of the scene. Frames of a sequence cost a
 * whole picture each and are handed out by rank 0, which draws too.
 *
 * The figures, such as nanoseconds a fragment, are stated (scale_figures.c) or measured by
 * --measure and --messages. The simulation (scale_engine.h) adds what formulas leave out: busy
 * ports, the order of writers, waiting. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ranks.h"
#include "scale_figures.h"
#include "scale_measure.h"
#include "scale_messages.h"
#include "scale_model.h"
#include "scale_print.h"
#include "scale_ways.h"
#include "scale_work.h"

#define EXIT_WRONG 2
#define MOST_LEVEL 400
#define MOST_FRAMES 100000
#define MOST_SIDE 65536

static const char help[] =
    "usage: scale [OPTION...]\n"
    "\n"
    "Predicts by simulation how long gnomon takes on 1, 2, 4 ... 1024 ranks, for three scenes:\n"
    "triangles (a million small ones), pixels (16384x16384), frames (a thousand). All show the\n"
    "teapot. The ways are sort-first (each rank draws a band of rows), sort-last (each rank draws\n"
    "a part of the triangles), frames (rank 0 hands out frames, each a file) and animation (the\n"
    "same to one file). Efficiency is T(1) / (N T(N)); \"pictures alone\" leaves out starting,\n"
    "reading, sharing and preparing, which happen once. \"formula\" is the cost model without\n"
    "waiting for ports (scale_ways.h). The output depends on the options and figures alone.\n"
    "\n"
    "  --scene NAME          only this scene\n"
    "  --way NAME            only this way\n"
    "  --ranks N             the most ranks, a power of two up to 1024; default: 1024\n"
    "  --ranks-a-machine N   1 to 1024; default: 16. They share the machine's port.\n"
    "                        If --ranks is no more than that, files are on its own disk\n"
    "  --size N              pixels a side instead of the scene's, 16 to 65536\n"
    "  --level N             64 N^2 triangles instead of the scene's, N 1 to 400\n"
    "  --frames N            pictures instead of the scene's, 1 to 100000\n"
    "  --figures FILE        figures that were measured; lines NAME=VALUE\n"
    "  --set NAME=VALUE      one figure\n"
    "  --list                prints the figures alone\n"
    "  --json                prints JSON\n"
    "  --table               prints one line for each scene and way, as a table of Markdown\n"
    "\n"
    "Other work:\n"
    "  --measure FILE        measures figures here, to a new file\n"
    "  --quick               with --measure: in seconds, less exactly\n"
    "  --messages FILE       under mpirun -n 2: measures messages, and adds them to the file\n"
    "  --model FILE          writes the scene's model as OBJ; with --scene or --level\n"
    "  --help                this text\n"
    "\n"
    "Exit status: 0: done; 1: a fault; 2: wrong usage.\n";

typedef struct chosen {
    const work_scene *scene;
    way_kind way;                                         /* WAY_COUNT: all */
    uint32_t ranks, ranks_a_machine, side, level, frames; /* 0: the scene's */
    figures f;
    bool list, json, table, quick;
    const char *measure, *messages, *model;
} chosen;

static bool wrong(const char *what, const char *value)
{
    fprintf(stderr, "scale: %s: '%s' (see scale --help)\n", what, value);
    return false;
}

static bool take_number(const char *name, const char *value, uint32_t least, uint32_t most,
                        uint32_t *result)
{
    char *end, what[96];
    errno = 0;
    const unsigned long number = strtoul(value, &end, 10);
    if (value[0] < '0' || value[0] > '9' || *end != '\0' || errno != 0 || number < least ||
        number > most) {
        snprintf(what, sizeof what, "%s takes a number from %u to %u", name, (unsigned)least,
                 (unsigned)most);
        return wrong(what, value);
    }
    *result = (uint32_t)number;
    return true;
}

static bool take_scene(const char *value, chosen *c)
{
    for (int i = 0; i < WORK_SCENES; ++i) {
        if (strcmp(value, work_scenes[i].name) == 0) {
            c->scene = &work_scenes[i];
            return true;
        }
    }
    return wrong("no such scene", value);
}

static bool take_way(const char *value, chosen *c)
{
    for (int i = 0; i < WAY_COUNT; ++i) {
        if (strcmp(value, way_name((way_kind)i)) == 0) {
            c->way = (way_kind)i;
            return true;
        }
    }
    return wrong("no such way", value);
}

static bool take_ranks(const char *value, chosen *c)
{
    if (!take_number("--ranks", value, 1, WORK_MOST, &c->ranks))
        return false;
    return (c->ranks & (c->ranks - 1)) == 0 || wrong("--ranks takes a power of two", value);
}

/* Options that have no value. */
static bool take_flag(const char *name, chosen *c)
{
    bool *const flag = strcmp(name, "--list") == 0    ? &c->list
                       : strcmp(name, "--json") == 0  ? &c->json
                       : strcmp(name, "--table") == 0 ? &c->table
                       : strcmp(name, "--quick") == 0 ? &c->quick
                                                      : NULL;
    if (flag != NULL)
        *flag = true;
    return flag != NULL;
}

static bool take_value(const char *name, const char *value, chosen *c)
{
    if (strcmp(name, "--scene") == 0)
        return take_scene(value, c);
    if (strcmp(name, "--way") == 0)
        return take_way(value, c);
    if (strcmp(name, "--ranks") == 0)
        return take_ranks(value, c);
    if (strcmp(name, "--ranks-a-machine") == 0)
        return take_number(name, value, 1, WORK_MOST, &c->ranks_a_machine);
    if (strcmp(name, "--size") == 0)
        return take_number(name, value, 16, MOST_SIDE, &c->side);
    if (strcmp(name, "--level") == 0)
        return take_number(name, value, 1, MOST_LEVEL, &c->level);
    if (strcmp(name, "--frames") == 0)
        return take_number(name, value, 1, MOST_FRAMES, &c->frames);
    if (strcmp(name, "--set") == 0)
        return figures_set(&c->f, value, FIGURE_GIVEN);
    if (strcmp(name, "--figures") == 0)
        return figures_read(&c->f, value);
    if (strcmp(name, "--measure") == 0)
        c->measure = value;
    else if (strcmp(name, "--messages") == 0)
        c->messages = value;
    else if (strcmp(name, "--model") == 0)
        c->model = value;
    else
        return wrong("unknown option", name);
    return true;
}

static bool takes_value(const char *name)
{
    static const char *const names[] = {"--scene",   "--way",     "--ranks",    "--ranks-a-machine",
                                        "--size",    "--level",   "--frames",   "--set",
                                        "--figures", "--measure", "--messages", "--model"};
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i)
        if (strcmp(name, names[i]) == 0)
            return true;
    return false;
}

static bool choose(int argc, char **argv, chosen *c)
{
    memset(c, 0, sizeof *c);
    c->way = WAY_COUNT;
    c->ranks = WORK_MOST;
    c->ranks_a_machine = 16;
    figures_state(&c->f);
    for (int i = 1; i < argc; ++i) {
        if (take_flag(argv[i], c))
            continue;
        if (!takes_value(argv[i]))
            return wrong("unknown option", argv[i]);
        if (i + 1 == argc)
            return wrong("an option without its value", argv[i]);
        if (!take_value(argv[i], argv[i + 1], c))
            return false;
        ++i;
    }
    if (c->json && c->table)
        return wrong("this cannot be used with --json", "--table");
    if (c->quick && c->measure == NULL)
        return wrong("this goes with --measure", "--quick");
    return true;
}

static work_scene scene_of(const chosen *c, const work_scene *scene_chosen)
{
    work_scene result = *scene_chosen;
    result.side = c->side != 0 ? c->side : result.side;
    result.level = c->level != 0 ? c->level : result.level;
    result.frames = c->frames != 0 ? c->frames : result.frames;
    return result;
}

static bool run_way(const chosen *c, const work *w, way_kind way, unsigned int *elements)
{
    const way_place place = {c->ranks_a_machine, c->ranks <= c->ranks_a_machine};
    way_runs r = {.way = way};
    for (uint32_t n = 1; n <= c->ranks; n *= 2) {
        if (!way_run(way, w, &c->f, n, &place, &r.run[r.count]))
            return false;
        r.formula[r.count] = way_formula(way, w, &c->f, n, &place);
        r.memory[r.count] = way_memory(way, w, &c->f, n);
        ++r.count;
    }
    if (c->json)
        print_json(w, &r, c->ranks_a_machine, elements);
    else if (c->table)
        print_table_row(w, &r);
    else
        print_runs(w, &r);
    return true;
}

static bool run_scene(const chosen *c, const work_scene *which, unsigned int *elements)
{
    const work_scene changed = scene_of(c, which);
    work *w = malloc(sizeof *w);
    bool good = w != NULL;
    if (!good)
        fprintf(stderr, "scale: not enough memory\n");
    good = good && work_count(&changed, w);
    if (good && !c->json && !c->table)
        print_scene(w, c->ranks_a_machine);
    for (int way = 0; way < WAY_COUNT && good; ++way) {
        const bool wanted = c->way == WAY_COUNT
                                ? changed.frames > 1 || !way_has_frames((way_kind)way)
                                : c->way == (way_kind)way;
        if (wanted)
            good = run_way(c, w, (way_kind)way, elements);
    }
    free(w);
    return good;
}

static bool predict(const chosen *c)
{
    unsigned int elements = 0;
    bool good = true;
    printf("%s", c->json ? "[" : "");
    if (c->table)
        print_table_head();
    else if (!c->json)
        print_figures(&c->f);
    for (int i = 0; i < WORK_SCENES && good; ++i)
        if (c->scene == NULL || c->scene == &work_scenes[i])
            good = run_scene(c, &work_scenes[i], &elements);
    printf("%s", c->json ? "\n]\n" : "");
    return good;
}

static bool write_model(const chosen *c)
{
    const work_scene changed = scene_of(c, c->scene != NULL ? c->scene : &work_scenes[0]);
    scale_model m;
    const bool good =
        scale_model_make(changed.level, 256, false, &m) && scale_model_write(&m, c->model);
    scale_model_free(&m);
    return good;
}

static int run(int argc, char **argv)
{
    chosen c;
    bool good;
    for (int i = 1; i < argc; ++i) {
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            fputs(help, stdout);
            return EXIT_SUCCESS;
        }
    }
    if (!choose(argc, argv, &c))
        return EXIT_WRONG;
    if (c.messages != NULL)
        good = messages_measure(c.messages);
    else if (ranks_count() > 1)
        return wrong("this works in one process", argv[0]), EXIT_WRONG;
    else if (c.measure != NULL)
        good = measure_figures(c.measure, c.quick);
    else if (c.model != NULL)
        good = write_model(&c);
    else if (c.list)
        good = (print_figures(&c.f), true);
    else
        good = predict(&c);
    if (fflush(stdout) != 0 || ferror(stdout)) {
        fprintf(stderr, "scale: cannot write standard output: %s\n", strerror(errno));
        good = false;
    }
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}

int main(int argc, char **argv)
{
    const int status = ranks_begin(&argc, &argv);
    return status != 0 ? status : ranks_end(run(argc, argv));
}
