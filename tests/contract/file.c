/* The contract's file: writing and reading. After a head, each class is a line with the sums over
 * its scenes, then a line for each scene, then its exceptions. The comment at the head of the file,
 * which contract_write writes, says what the words mean. */
#include "contract.h"

#include <inttypes.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static const char explanation[] =
    "# The contract: hashes of the pixels that the pinned reference draws. `make contract` writes\n"
    "# this file and `make check-contract` compares the library with it; do not edit it. A "
    "changed\n"
    "# line of pixels is a changed picture. tests/contract/contract.h says what is hashed.\n"
    "#\n"
    "# class NAME SCENES MADE PIXELS     hashes of the hashes of the scenes that follow\n"
    "# MADE PIXELS                       a scene, number 0 first: MADE is of the scene itself, "
    "PIXELS\n"
    "#                                   of what the reference drew\n"
    "# srgb CHANNELS DIFFERING HASH      of the class before: red, green and blue of SRGB8_A8. "
    "HASH is\n"
    "#                                   of the library's values, not of the reference's, which "
    "depend\n"
    "#                                   on the processor; in DIFFERING channels the two differed, "
    "by a\n"
    "#                                   step (two after a resolve), when the file was made\n"
    "# MADE PIXELS SRGB                  a scene with such channels\n";

void contract_free(contract *c)
{
    for (int i = 0; i < c->class_count; ++i)
        free(c->classes[i].scenes);
    memset(c, 0, sizeof *c);
}

/* Adds an empty class; null if there is no memory. */
static contract_class *add_class(contract *c, scene_class class, uint64_t count)
{
    contract_class *const added = &c->classes[c->class_count];
    memset(added, 0, sizeof *added);
    added->class = class;
    added->count = count;
    added->scenes = calloc(count ? (size_t)count : 1, sizeof *added->scenes);
    added->made = added->pixels = added->srgb = HASH_EMPTY;
    if (!added->scenes)
        return NULL;
    ++c->class_count;
    for (uint64_t i = 0; i < count; ++i)
        added->scenes[i].pixels = added->scenes[i].srgb = HASH_EMPTY;
    return added;
}

bool contract_allocate(contract *c, uint64_t seed, uint64_t scenes)
{
    memset(c, 0, sizeof *c);
    c->seed = seed;
    c->scenes = scenes;
    for (uint64_t i = 0; i < CLASS_COUNT; ++i)
        if (!add_class(c, (scene_class)i, scenes / CLASS_COUNT + (i < scenes % CLASS_COUNT)))
            return false;
    return true;
}

void contract_sum(contract_class *c)
{
    c->made = c->pixels = c->srgb = HASH_EMPTY;
    for (uint64_t i = 0; i < c->count; ++i) {
        contract_add(&c->made, c->scenes[i].made);
        contract_add(&c->pixels, c->scenes[i].pixels);
        contract_add(&c->srgb, c->scenes[i].srgb);
    }
}

static void write_scene(const contract_scene *s, FILE *out)
{
    fprintf(out, "%08" PRIx32 " %016" PRIx64, s->made, s->pixels);
    if (s->srgb != HASH_EMPTY)
        fprintf(out, " %016" PRIx64, s->srgb);
    fputc('\n', out);
}

bool contract_write(const contract *c, FILE *out)
{
    fputs(explanation, out);
    fprintf(out, "gnomon-contract 1\nreference %s\nprofile %s\n", c->reference, c->profile);
    fprintf(out, "seed %" PRIu64 "\nscenes %" PRIu64 "\n", c->seed, c->scenes);
    for (int i = 0; i < c->class_count; ++i) {
        const contract_class *const class = &c->classes[i];
        fprintf(out, "class %s %" PRIu64 " %016" PRIx64 " %016" PRIx64 "\n",
                scene_class_name(class->class), class->count, class->made, class->pixels);
        if (class->srgb_channels > 0)
            fprintf(out, "srgb %" PRIu64 " %" PRIu64 " %016" PRIx64 "\n", class->srgb_channels,
                    class->srgb_differing, class->srgb);
        for (uint64_t s = 0; s < class->count; ++s)
            write_scene(&class->scenes[s], out);
    }
    fputs("end-contract\n", out);
    return fflush(out) == 0 && !ferror(out);
}

/* A file being read, line by line. */
typedef struct reader {
    FILE *in;
    contract *contract;
    uint64_t scene; /* those of the last class that have been read */
    int line;
    bool head, ended;
    char *error;
    size_t error_size;
} reader;

static bool fail(reader *r, const char *format, ...)
{
    va_list arguments;
    const int written = snprintf(r->error, r->error_size, "line %d: ", r->line);
    va_start(arguments, format);
    if (written > 0 && (size_t)written < r->error_size)
        vsnprintf(r->error + written, r->error_size - (size_t)written, format, arguments);
    va_end(arguments);
    return false;
}

/* Whether the last class, if any, has been read whole and its sums are those of its scenes. */
static bool class_is_whole(reader *r)
{
    if (r->contract->class_count == 0)
        return true;
    contract_class *const class = &r->contract->classes[r->contract->class_count - 1];
    const contract_class written = *class;
    if (r->scene != class->count)
        return fail(r, "class %s has %" PRIu64 " scenes, not %" PRIu64,
                    scene_class_name(class->class), r->scene, class->count);
    contract_sum(class);
    if (class->made != written.made || class->pixels != written.pixels ||
        (class->srgb_channels > 0 && class->srgb != written.srgb))
        return fail(r, "the file is damaged: the sums of class %s are not those of its scenes",
                    scene_class_name(class->class));
    return true;
}

static bool read_class(reader *r, const char *line)
{
    char name[32];
    uint64_t count, made, pixels;
    if (!class_is_whole(r))
        return false;
    if (sscanf(line, "class %31s %" SCNu64 " %" SCNx64 " %" SCNx64, name, &count, &made, &pixels) !=
            4 ||
        count > r->contract->scenes)
        return fail(r, "no class");
    const scene_class class = scene_class_of(name);
    if (class == CLASS_COUNT)
        return fail(r, "class %s is not one of the generator's", name);
    for (int i = 0; i < r->contract->class_count; ++i)
        if (r->contract->classes[i].class == class)
            return fail(r, "class %s stands twice", name);
    contract_class *const added = add_class(r->contract, class, count);
    if (!added)
        return fail(r, "no memory");
    added->made = made;
    added->pixels = pixels;
    r->scene = 0;
    return true;
}

static bool read_srgb(reader *r, const char *line)
{
    if (r->contract->class_count == 0 || r->scene > 0)
        return fail(r, "sums of sRGB must follow a class");
    contract_class *const class = &r->contract->classes[r->contract->class_count - 1];
    return sscanf(line, "srgb %" SCNu64 " %" SCNu64 " %" SCNx64, &class->srgb_channels,
                  &class->srgb_differing, &class->srgb) == 3 ||
           fail(r, "no sums of sRGB");
}

static bool read_scene(reader *r, const char *line)
{
    if (r->contract->class_count == 0)
        return fail(r, "a scene without a class");
    contract_class *const class = &r->contract->classes[r->contract->class_count - 1];
    if (r->scene == class->count)
        return fail(r, "class %s has more than %" PRIu64 " scenes", scene_class_name(class->class),
                    class->count);
    contract_scene *const s = &class->scenes[r->scene++];
    const int read =
        sscanf(line, "%8" SCNx32 " %16" SCNx64 " %16" SCNx64, &s->made, &s->pixels, &s->srgb);
    return read >= 2 || fail(r, "no hashes of a scene");
}

static bool starts_with(const char *line, const char *word)
{
    return strncmp(line, word, strlen(word)) == 0;
}

/* Copies the rest of a line of the head. */
static bool read_text(char text[160], const char *line)
{
    snprintf(text, 160, "%.*s", (int)strcspn(line, "\r\n"), line);
    return true;
}

static bool read_line(reader *r, const char *line)
{
    contract *const c = r->contract;
    if (line[0] == '#' || line[0] == '\n')
        return true;
    if (!r->head) {
        r->head = starts_with(line, "gnomon-contract 1\n");
        return r->head || fail(r, "this is no contract of version 1");
    }
    if (starts_with(line, "reference "))
        return read_text(c->reference, line + 10);
    if (starts_with(line, "profile "))
        return read_text(c->profile, line + 8);
    if (starts_with(line, "seed "))
        return sscanf(line, "seed %" SCNu64, &c->seed) == 1 || fail(r, "no seed");
    if (starts_with(line, "scenes "))
        return sscanf(line, "scenes %" SCNu64, &c->scenes) == 1 || fail(r, "no number of scenes");
    if (starts_with(line, "class "))
        return read_class(r, line);
    if (starts_with(line, "srgb "))
        return read_srgb(r, line);
    if (starts_with(line, "end-contract"))
        return r->ended = class_is_whole(r);
    return read_scene(r, line);
}

bool contract_read(contract *c, FILE *in, char *error, size_t error_size)
{
    reader r = {in, c, 0, 0, false, false, error, error_size};
    char line[256];
    uint64_t scenes = 0;
    memset(c, 0, sizeof *c);
    while (!r.ended && fgets(line, sizeof line, in)) {
        ++r.line;
        if (!read_line(&r, line))
            return false;
    }
    if (!r.ended)
        return fail(&r, "the file ends too early");
    for (int i = 0; i < c->class_count; ++i)
        scenes += c->classes[i].count;
    return scenes == c->scenes || fail(&r, "%" PRIu64 " scenes, not %" PRIu64, scenes, c->scenes);
}
