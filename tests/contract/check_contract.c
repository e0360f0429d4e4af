/* Draws the contract's scenes with every back end of the library and compares with the committed
 * hashes. Needs a C compiler alone, no OpenGL. */
#include <errno.h>
#include <inttypes.h>
#include <string.h>
#include <time.h>

#include "../command_line.h"
#include "contract.h"

#define PROGRAM "contract-check"
#define SHOWN_SCENES 8

typedef struct options {
    uint64_t every;
    const char *file, *keep;
    scene_class only; /* CLASS_COUNT: all */
} options;

/* What differs in a class. */
typedef struct findings {
    uint64_t scenes, made, drawn; /* those compared; other scenes; other pixels */
    uint64_t numbers[SHOWN_SCENES];
    bool backends[GN_BACKEND_COUNT];
    contract_verdict last; /* the last that is not CONTRACT_EQUAL */
} findings;

typedef struct check {
    options options;
    const contract *contract;
    uint64_t done, scenes;
    int equal, differ;
    bool kept;
    time_t last_progress;
} check;

static void print_help(void)
{
    printf("usage: contract-check [--every N] [--class NAME] [--keep FILE] [CONTRACT]\n"
           "\n"
           "Draws the scenes that the contract lists with every back end of the library, and\n"
           "compares hashes of the scenes and of the pixels with the contract's, which the\n"
           "pinned reference made. Exit status: 0 if all are equal, 1 if not, 2 for a wrong\n"
           "command line.\n"
           "\n"
           "  CONTRACT      the file (" CONTRACT_FILE "); - is standard input\n"
           "  --every N     only every Nth scene of each class (1)\n"
           "  --class NAME  only this class\n"
           "  --keep FILE   writes the first scene whose pixels differ, as text\n");
}

static bool parse_options(int argc, char **argv, options *o)
{
    const char *class = NULL;
    const command_option known[] = {
        {"--every", .number = &o->every, .least = 1},
        {"--class", .text = &class},
        {"--keep", .text = &o->keep},
        {.name = NULL},
    };
    *o = (options){.every = 1, .file = CONTRACT_FILE, .only = CLASS_COUNT};
    if (!command_line_read(PROGRAM, argc, argv, known, &o->file))
        return false;
    if (class)
        o->only = scene_class_of(class);
    if (class && o->only == CLASS_COUNT)
        fprintf(stderr, PROGRAM ": unknown class: %s\n", class);
    return !class || o->only != CLASS_COUNT;
}

static void show_progress(check *k, scene_class class)
{
    const time_t now = time(NULL);
    ++k->done;
    if (now - k->last_progress < 5)
        return;
    k->last_progress = now;
    fprintf(stderr, PROGRAM ": scene %" PRIu64 " of %" PRIu64 ", class %s, %d classes differ\n",
            k->done, k->scenes, scene_class_name(class), k->differ);
}

static void keep_scene(check *k, const scene *s)
{
    if (k->kept || !k->options.keep)
        return;
    k->kept = true;
    FILE *const out = fopen(k->options.keep, "w");
    const bool written = out && scene_write(s, out);
    if (out && fclose(out) == 0 && written)
        fprintf(stderr, PROGRAM ": kept the first differing scene: %s\n", k->options.keep);
    else
        fprintf(stderr, PROGRAM ": cannot write %s: %s\n", k->options.keep, strerror(errno));
}

static void check_scene(check *k, scene_class class, uint64_t number,
                        const contract_scene *expected, findings *f)
{
    scene *const s = generate_scene(k->contract->seed, class, number);
    const uint64_t found = f->made + f->drawn;
    ++f->scenes;
    if (contract_hash_scene(s) != expected->made) {
        ++f->made;
    } else {
        bool equal = true;
        for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b) {
            if (!gn_backend_available((gn_backend)b))
                continue;
            const contract_verdict v = contract_draw(s, (gn_backend)b, expected);
            if (v == CONTRACT_EQUAL)
                continue;
            equal = false;
            f->backends[b] = true;
            f->last = v;
        }
        f->drawn += !equal;
        if (!equal)
            keep_scene(k, s);
    }
    if (found < f->made + f->drawn && found < SHOWN_SCENES)
        f->numbers[found] = number;
    scene_free(s);
}

static void report(const check *k, const contract_class *c, const findings *f)
{
    const uint64_t found = f->made + f->drawn;
    fprintf(stderr, PROGRAM ": class %s: of %" PRIu64 " scenes", scene_class_name(c->class),
            f->scenes);
    if (f->made > 0)
        fprintf(stderr, " %" PRIu64 " are other scenes than the contract's", f->made);
    if (f->drawn > 0) {
        fprintf(stderr, "%s %" PRIu64 " have other pixels%s (", f->made > 0 ? "," : "", f->drawn,
                f->last == CONTRACT_REFUSED     ? ", or the library refuses them"
                : f->last == CONTRACT_NO_MEMORY ? ", or there is no memory"
                                                : "");
        const char *before = "";
        for (int b = 0; b < GN_BACKEND_COUNT; ++b)
            if (f->backends[b]) {
                fprintf(stderr, "%s%s", before, gn_backend_name((gn_backend)b));
                before = ", ";
            }
        fprintf(stderr, ")");
    }
    fprintf(stderr, ": numbers");
    for (uint64_t i = 0; i < found && i < SHOWN_SCENES; ++i)
        fprintf(stderr, " %" PRIu64, f->numbers[i]);
    fprintf(stderr, "%s\n", found > SHOWN_SCENES ? " ..." : "");
    fprintf(stderr,
            PROGRAM ": beside the reference: build/parity --class %s --seed %" PRIu64
                    " --first %" PRIu64 " --scenes 1\n",
            scene_class_name(c->class), k->contract->seed, f->numbers[0]);
}

static void check_class(check *k, const contract_class *c)
{
    findings f;
    memset(&f, 0, sizeof f);
    for (uint64_t i = 0; i < c->count; i += k->options.every) {
        check_scene(k, c->class, i, &c->scenes[i], &f);
        show_progress(k, c->class);
    }
    if (f.made + f.drawn > 0) {
        report(k, c, &f);
        ++k->differ;
    } else {
        ++k->equal;
    }
}

/* Names the classes of the generator that the contract lacks. Returns their number. */
static int missing_classes(const contract *c)
{
    int missing = 0;
    for (int i = 0; i < CLASS_COUNT; ++i) {
        bool found = false;
        for (int n = 0; n < c->class_count; ++n)
            found = found || (c->classes[n].class == (scene_class)i && c->classes[n].count > 0);
        if (!found)
            fprintf(stderr, PROGRAM ": the contract has no scenes of class %s (make contract)\n",
                    scene_class_name((scene_class)i));
        missing += !found;
    }
    return missing;
}

static bool is_chosen(const options *o, const contract_class *c)
{
    return o->only == CLASS_COUNT || o->only == c->class;
}

static bool run(check *k)
{
    const contract *const c = k->contract;
    const int missing = missing_classes(c);
    for (int i = 0; i < c->class_count; ++i)
        if (is_chosen(&k->options, &c->classes[i]))
            k->scenes += (c->classes[i].count + k->options.every - 1) / k->options.every;
    printf("contract of %s, seed %" PRIu64 "\n", c->reference, c->seed);
    fflush(stdout);
    for (int i = 0; i < c->class_count; ++i)
        if (is_chosen(&k->options, &c->classes[i]))
            check_class(k, &c->classes[i]);
    printf("contract: %" PRIu64 " scenes, %d classes, %d equal, %d differ", k->done,
           k->equal + k->differ + missing, k->equal, k->differ);
    if (missing > 0)
        printf(", %d not in the contract", missing);
    printf(" (");
    contract_print_backends(stdout);
    printf(")\n");
    return k->differ == 0 && missing == 0 && k->done > 0;
}

int main(int argc, char **argv)
{
    check k;
    contract c;
    memset(&k, 0, sizeof k);
    if (command_line_asks_help(argc, argv)) {
        print_help();
        return 0;
    }
    if (!parse_options(argc, argv, &k.options))
        return 2;
    k.contract = &c;
    k.last_progress = time(NULL);
    const bool passes = contract_open(&c, PROGRAM, k.options.file) && run(&k);
    contract_free(&c);
    return passes ? 0 : 1;
}
