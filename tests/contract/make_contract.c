/* Draws the contract's scenes with the pinned reference and writes their hashes, if the library
 * draws the same with every back end; or compares a written contract with the reference. */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../command_line.h"
#include "contract.h"
#include "osmesa.h"

#define PROGRAM "contract"
#define DEFAULT_SCENES 5178
#define DEFAULT_SEED 25007 /* for Mesa 25.0.7 */
#define REPORTED 20

typedef struct options {
    uint64_t scenes, seed, every;
    const char *file;
    bool compare;
} options;

typedef struct maker {
    options options;
    reference *reference;
    uint64_t done, differ;
    time_t last_progress;
} maker;

static void print_help(void)
{
    printf("usage: contract [--scenes N] [--seed S] [FILE]\n"
           "       contract --compare [--every N] [FILE]\n"
           "\n"
           "Draws scenes of every class with the pinned reference (OSMesa, llvmpipe) and with\n"
           "every back end of the library, and writes hashes of the reference's pixels. Writes\n"
           "nothing if the library differs. Exit status: 0 if nothing differs, 1 if something\n"
           "does, 2 for a wrong command line.\n"
           "\n"
           "  FILE        the contract (" CONTRACT_FILE ")\n"
           "  --scenes N  scenes in all, shared evenly by the classes (%d)\n"
           "  --seed S    seed of the scenes (%d)\n"
           "  --compare   writes nothing; draws the scenes of the contract with the reference\n"
           "              again and compares with the hashes in the file\n"
           "  --every N   with --compare: only every Nth scene of each class (1)\n",
           DEFAULT_SCENES, DEFAULT_SEED);
}

static bool parse_options(int argc, char **argv, options *o)
{
    const command_option known[] = {
        {"--scenes", .number = &o->scenes, .least = 1},
        {"--seed", .number = &o->seed},
        {"--every", .number = &o->every, .least = 1},
        {"--compare", .flag = &o->compare},
        {.name = NULL},
    };
    *o = (options){DEFAULT_SCENES, DEFAULT_SEED, 1, CONTRACT_FILE, false};
    return command_line_read(PROGRAM, argc, argv, known, &o->file);
}

static void show_progress(maker *m, uint64_t of)
{
    const time_t now = time(NULL);
    ++m->done;
    if (now - m->last_progress < 5)
        return;
    m->last_progress = now;
    fprintf(stderr, PROGRAM ": scene %" PRIu64 " of %" PRIu64 ", %" PRIu64 " differ\n", m->done, of,
            m->differ);
}

static void complain(maker *m, scene_class class, uint64_t number, const char *what,
                     const char *more)
{
    if (m->differ++ < REPORTED)
        fprintf(stderr, PROGRAM ": class %s, scene %" PRIu64 ": %s%s\n", scene_class_name(class),
                number, what, more);
}

/* Compares the frames of both sides and hashes the reference's, its sRGB channels from the
 * library's. Adds to the class's counts of sRGB channels. */
static const char *hash_frames(const scene *s, const scene_frame *ours, const scene_frame *theirs,
                               contract_scene *hashes, contract_class *class)
{
    hash of_reference, of_library;
    uint64_t channels = 0;
    contract_hash_frame(theirs, true, &hashes->pixels, &of_reference, &channels);
    contract_hash_frame(ours, false, &of_library, &hashes->srgb, &class->srgb_channels);
    class->srgb_differing += contract_srgb_differing(ours, theirs);
    if (scene_compare(s, ours, theirs).pixels > 0)
        return "the library differs from the reference";
    if (of_library != hashes->pixels)
        return "differs in a way that the comparison allows and the contract does not (a denormal, "
               "or samples at the top two depths): take another seed";
    return NULL;
}

static const char *hash_drawn(maker *m, const scene *s, contract_scene *hashes,
                              contract_class *class, char *more, size_t more_size)
{
    const char *fault = "no memory";
    scene_frame ours = {0}, theirs = {0};
    if (scene_frame_allocate(&ours, s) && scene_frame_allocate(&theirs, s)) {
        const gn_status status = scene_draw_library(s, &ours, 0, GN_BACKEND_AUTO);
        if (status != GN_OK) {
            snprintf(more, more_size, "%s", gn_status_text(status));
            fault = "the library refuses it: ";
        } else if (!reference_draw(m->reference, s, &theirs, more, more_size)) {
            fault = "the reference failed: ";
        } else {
            fault = hash_frames(s, &ours, &theirs, hashes, class);
        }
    }
    scene_frame_free(&ours);
    scene_frame_free(&theirs);
    for (int b = GN_BACKEND_PORTABLE; !fault && b < GN_BACKEND_COUNT; ++b)
        if (gn_backend_available((gn_backend)b) &&
            contract_draw(s, (gn_backend)b, hashes) != CONTRACT_EQUAL) {
            snprintf(more, more_size, "%s", gn_backend_name((gn_backend)b));
            fault = "back ends differ: ";
        }
    return fault;
}

/* Sets the hashes of a scene. Adds to the class's counts of sRGB channels. */
static bool hash_scene(maker *m, uint64_t seed, uint64_t number, contract_scene *hashes,
                       contract_class *class)
{
    char more[512] = "";
    scene *const s = generate_scene(seed, class->class, number);
    hashes->made = contract_hash_scene(s);
    const char *const fault = hash_drawn(m, s, hashes, class, more, sizeof more);
    scene_free(s);
    if (fault)
        complain(m, class->class, number, fault, more);
    return !fault;
}

/* Writes the variables that the reference has set for Mesa (reference/osmesa/context.c). */
static void write_profile(char *text, size_t size)
{
    static const char *const names[] = {"GALLIUM_DRIVER", "GALLIUM_OVERRIDE_CPU_CAPS",
                                        "GALLIVM_PERF", "MESA_GLSL_DISABLE_IO_OPT"};
    size_t used = 0;
    for (size_t i = 0; i < sizeof names / sizeof *names && used < size; ++i) {
        const char *const value = getenv(names[i]);
        used += (size_t)snprintf(text + used, size - used, "%s%s=%s", i > 0 ? " " : "", names[i],
                                 value ? value : "");
    }
}

static bool start(maker *m)
{
    char error[512] = "";
    m->reference = reference_create(REFERENCE_PINNED, error, sizeof error);
    if (!m->reference)
        fprintf(stderr, PROGRAM ": no reference: %s\n", error);
    return m->reference;
}

static bool write_file(const contract *c, const char *name)
{
    char partial[512];
    snprintf(partial, sizeof partial, "%s.partial", name);
    FILE *const out = fopen(partial, "w");
    const bool written = out && contract_write(c, out);
    if (out && fclose(out) == 0 && written && rename(partial, name) == 0)
        return true;
    fprintf(stderr, PROGRAM ": cannot write %s: %s\n", name, strerror(errno));
    return false;
}

/* Says which classes the new contract changes. */
static void print_changes(const contract *old, const contract *new)
{
    int made = 0, drawn = 0, added = new->class_count;
    for (int i = 0; i < new->class_count; ++i)
        for (int j = 0; j < old->class_count; ++j) {
            const contract_class *const a = &old->classes[j], *const b = &new->classes[i];
            if (a->class != b->class)
                continue;
            const bool other = a->made != b->made || a->count != b->count;
            --added;
            made += other;
            drawn += !other && (a->pixels != b->pixels || a->srgb != b->srgb);
            if (!other && (a->pixels != b->pixels || a->srgb != b->srgb))
                printf("PIXELS CHANGED: class %s\n", scene_class_name(b->class));
        }
    printf("against the file before: %d classes new, %d with other scenes, %d with other pixels of "
           "the same scenes\n",
           added, made, drawn);
}

static bool make(maker *m)
{
    const options *const o = &m->options;
    contract old, c;
    uint64_t channels = 0, differing = 0;
    char error[256];
    if (!contract_allocate(&c, o->seed, o->scenes)) {
        fprintf(stderr, PROGRAM ": no memory\n");
        contract_free(&c);
        return false;
    }
    snprintf(c.reference, sizeof c.reference, "Mesa %s, %s", reference_mesa_version(m->reference),
             reference_renderer(m->reference));
    write_profile(c.profile, sizeof c.profile);
    for (int i = 0; i < c.class_count; ++i) {
        contract_class *const class = &c.classes[i];
        for (uint64_t n = 0; n < class->count; ++n) {
            hash_scene(m, c.seed, n, &class->scenes[n], class);
            show_progress(m, c.scenes);
        }
        contract_sum(class);
        channels += class->srgb_channels;
        differing += class->srgb_differing;
    }
    FILE *const before = fopen(o->file, "r");
    if (before && m->differ == 0 && contract_read(&old, before, error, sizeof error)) {
        print_changes(&old, &c);
        contract_free(&old);
    }
    if (before)
        fclose(before);
    const bool written = m->differ == 0 && write_file(&c, o->file);
    printf("%s: %" PRIu64 " scenes, %d classes, %" PRIu64 " scenes differ from the reference; "
           "%" PRIu64 " channels of sRGB, %" PRIu64 " a step from the reference's\n",
           written ? "contract written" : "contract NOT written", c.scenes, c.class_count,
           m->differ, channels, differing);
    contract_free(&c);
    return written;
}

static bool compare(maker *m)
{
    const options *const o = &m->options;
    contract c;
    uint64_t scenes = 0;
    if (!contract_open(&c, PROGRAM, o->file)) {
        contract_free(&c);
        return false;
    }
    for (int i = 0; i < c.class_count; ++i)
        scenes += (c.classes[i].count + o->every - 1) / o->every;
    for (int i = 0; i < c.class_count; ++i) {
        contract_class class = c.classes[i];
        for (uint64_t n = 0; n < class.count; n += o->every) {
            const contract_scene *const wanted = &class.scenes[n];
            contract_scene hashes = {0};
            if (hash_scene(m, c.seed, n, &hashes, &class) &&
                (hashes.made != wanted->made || hashes.pixels != wanted->pixels ||
                 hashes.srgb != wanted->srgb))
                complain(m, class.class, n,
                         hashes.made != wanted->made ? "another scene than the contract's"
                                                     : "other pixels than the contract's",
                         "");
            show_progress(m, scenes);
        }
    }
    printf("contract beside the reference: %" PRIu64 " of %" PRIu64 " scenes, %" PRIu64 " differ\n",
           scenes, c.scenes, m->differ);
    contract_free(&c);
    return m->differ == 0 && scenes > 0;
}

static bool run(maker *m)
{
    if (!start(m))
        return false;
    return m->options.compare ? compare(m) : make(m);
}

int main(int argc, char **argv)
{
    maker m;
    memset(&m, 0, sizeof m);
    if (command_line_asks_help(argc, argv)) {
        print_help();
        return 0;
    }
    if (!parse_options(argc, argv, &m.options))
        return 2;
    m.last_progress = time(NULL);
    const bool passes = run(&m);
    if (m.reference)
        reference_destroy(m.reference);
    return passes ? 0 : 1;
}
