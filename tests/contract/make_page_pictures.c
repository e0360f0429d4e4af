/* Draws the web page's pictures with the pinned reference and writes their hashes, if the library
 * draws the same in every bit. */
#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "osmesa.h"
#include "page.h"

#define PROGRAM "pictures"
#define PICTURES_FILE "tests/contract/pictures.txt"
#define SMALL "size=240x180"

static const char explanation[] =
    "# The contract of the web page: hashes of pictures that the pinned reference draws. `make "
    "contract`\n"
    "# writes this file, and `make check-contract` compares the library with it; do not edit it.\n"
    "# Each line is the hash of a picture (page_hash of tools/web/page.h) and its state, which is\n"
    "# empty if every key has its default.\n"
    "gnomon-pictures 1\n";

typedef struct maker {
    reference *reference;
    FILE *out;
    unsigned int pictures, differ;
} maker;

/* The reference's picture, in the order of page_color; null if there is no memory. */
static uint8_t *picture_of(const scene *s, const scene_frame *frame, bool y_down)
{
    const size_t image = (size_t)s->width * s->height;
    const uint32_t *const pixels = (const uint32_t *)frame->color + (frame->images - 1) * image;
    uint8_t *const result = malloc(4 * image);
    for (size_t y = 0; result && y < s->height; ++y)
        for (size_t x = 0; x < s->width; ++x)
            for (size_t c = 0; c < 4; ++c)
                result[4 * (y * s->width + x) + c] =
                    (uint8_t)(pixels[(y_down ? s->height - 1 - y : y) * s->width + x] >> 8 * c);
    return result;
}

/* Draws the scene that is built with the reference, and compares both the picture and the samples
 * behind it. Returns what is wrong; null if nothing is. */
static const char *compare(maker *m, char hash[17], char *more, size_t more_size)
{
    const scene *const s = page_scene();
    const char *fault = "no memory";
    scene_frame ours = {0}, theirs = {0};
    uint8_t *picture = NULL;
    if (!scene_frame_allocate(&ours, s) || !scene_frame_allocate(&theirs, s))
        goto end;
    if (!reference_draw(m->reference, s, &theirs, more, more_size)) {
        fault = "the reference failed: ";
        goto end;
    }
    picture = picture_of(s, &theirs, page_camera()->y_down);
    if (!picture)
        goto end;
    if (scene_draw_library(s, &ours, 0, GN_BACKEND_AUTO) != GN_OK)
        fault = "the library refuses the scene";
    else if (scene_compare(s, &ours, &theirs).pixels > 0)
        fault = "the library differs from the reference";
    else if (memcmp(picture, page_color(), (size_t)4 * s->width * s->height) != 0)
        fault = "the page differs from the library";
    else
        fault = NULL;
    strcpy(hash, page_hash(picture, s->width, s->height));
end:
    free(picture);
    scene_frame_free(&ours);
    scene_frame_free(&theirs);
    return fault;
}

static void add(maker *m, const char *format, ...)
{
    char state[512], hash[17] = "", more[512] = "";
    const char *fault = NULL;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(state, sizeof state, format, arguments);
    va_end(arguments);
    if (page_set_state(state) != 0 || page_build() != 0 || page_draw(0, page_height()) != 0)
        fault = page_message();
    else
        fault = compare(m, hash, more, sizeof more);
    ++m->pictures;
    m->differ += fault != NULL;
    if (fault)
        fprintf(stderr, PROGRAM ": %s: %s%s\n", state, fault, more);
    const char *const canonical = page_state();
    if (!fault)
        fprintf(m->out, "%s%s%s\n", hash, *canonical ? " " : "", canonical);
}

static const char *const models[] = {"teapot", "triangle", "square", "cube"};
static const char *const mapped[] = {"teapot", "square", "cube"};
static const char *const shaders[] = {"vertex-color", "unlit",   "flat",        "gouraud", "toon",
                                      "phong",        "normals", "blinn-phong", "depth"};
static const char *const conventions[] = {"direct3d", "vulkan"};

#define EACH(name, list) for (size_t name = 0; name < sizeof list / sizeof *list; ++name)

static void add_shaders(maker *m)
{
    static const char *const sampled[] = {"phong", "vertex-color", "toon", "depth"};
    EACH(i, models)
    {
        EACH(k, shaders)
        add(m, "model=%s&" SMALL "&shader=%s", models[i], shaders[k]);
        EACH(k, sampled)
        add(m, "model=%s&" SMALL "&shader=%s&samples=4", models[i], sampled[k]);
    }
}

static void add_maps(maker *m)
{
    static const char *const filters[] = {"nearest", "linear"};
    static const char *const textured[] = {"unlit", "gouraud", "phong"};
    EACH(i, mapped)
    {
        EACH(k, textured)
        {
            EACH(f, filters)
            add(m, "model=%s&" SMALL "&shader=%s&filter=%s", mapped[i], textured[k], filters[f]);
            add(m, "model=%s&" SMALL "&shader=%s&maps=off", mapped[i], textured[k]);
        }
        add(m, "model=%s&" SMALL "&filter=linear&samples=4", mapped[i]);
        add(m, "model=%s&" SMALL "&shader=unlit&samples=4", mapped[i]);
    }
}

static void add_conventions(maker *m)
{
    static const char *const looks[] = {"phong", "flat", "gouraud", "depth"};
    static const char *const cull[] = {"back", "front"};
    EACH(c, conventions)
    EACH(i, models)
    {
        EACH(k, looks)
        add(m, "model=%s&" SMALL "&shader=%s&convention=%s", models[i], looks[k], conventions[c]);
        EACH(k, cull)
        add(m, "model=%s&" SMALL "&cull=%s&convention=%s", models[i], cull[k], conventions[c]);
        add(m, "model=%s&" SMALL "&samples=4&convention=%s", models[i], conventions[c]);
    }
    EACH(i, models)
    EACH(k, cull)
    add(m, "model=%s&" SMALL "&cull=%s", models[i], cull[k]);
}

static void add_polygons(maker *m)
{
    static const char *const polygons[] = {"line", "point"};
    EACH(i, models)
    EACH(k, polygons)
    {
        add(m, "model=%s&" SMALL "&polygons=%s", models[i], polygons[k]);
        add(m, "model=%s&" SMALL "&shader=vertex-color&cull=back&polygons=%s&convention=vulkan",
            models[i], polygons[k]);
    }
    /* No outlines with samples: the reference loses pixels of sampled lines at borders of its tiles
     * (reference/RULES.md, "What the contract leaves out"). */
    EACH(i, models)
    add(m, "model=%s&" SMALL "&polygons=point&samples=4", models[i]);
}

static void add_shadows(maker *m)
{
    static const char *const shadowed[] = {"flat", "toon", "phong", "blinn-phong"};
    static const char *const casting[] = {"teapot", "cube"};
    EACH(i, casting)
    {
        EACH(k, shadowed)
        add(m, "model=%s&" SMALL "&shader=%s&shadows=on", casting[i], shadowed[k]);
        EACH(c, conventions)
        add(m, "model=%s&" SMALL "&samples=4&shadows=on&convention=%s", casting[i], conventions[c]);
    }
}

/* What a visitor of the page sees first: the lessons to choose from (tools/web/presets.js), and one
 * control set differently. */
static void add_first_steps(maker *m)
{
    static const char *const states[] = {
        "shader=gouraud&maps=off&polygons=line",
        "shader=flat&maps=off&cull=front",
        "model=cube&shader=flat&fov=70",
        "model=triangle&shader=vertex-color&samples=4",
        "model=square&shader=unlit",
        "model=cube&shader=unlit",
        "shader=toon&maps=off&bands=4",
        "exponent=64",
        "filter=nearest",
        "filter=linear",
        "samples=4",
        "polygons=line",
        "polygons=point",
        "cull=back",
        "cull=front",
        "shadows=on",
        "convention=direct3d",
        "convention=vulkan",
        "size=320x240",
        "size=800x600",
        "size=1280x720",
    };
    EACH(k, shaders)
    {
        add(m, "shader=%s", shaders[k]);
        add(m, "shader=%s&maps=off", shaders[k]);
    }
    EACH(i, states)
    add(m, "%s", states[i]);
}

/* What the page begins with, which depends on the window (SIZES of tools/web/view.js), and the
 * lessons and one control set differently from there. Outlines have one sample, as above. */
static void add_beginnings(maker *m)
{
    static const char *const sizes[] = {"320x240", "384x288", "512x384", "640x480"};
    static const char *const states[] = {
        "model=triangle&shader=vertex-color&",
        "shader=flat&maps=off&cull=front&",
        "model=square&shader=unlit&",
        "model=cube&shader=flat&fov=70&",
        "shader=gouraud&maps=off&",
        "shader=flat&maps=off&",
        "shader=toon&maps=off&bands=4&",
        "maps=off&",
        "shader=blinn-phong&maps=off&",
        "exponent=64&",
        "shadows=on&",
        "filter=nearest&",
        "filter=linear&",
        "convention=direct3d&",
        "convention=vulkan&",
        "",
    };
    EACH(i, sizes)
    {
        add(m, "shader=gouraud&maps=off&polygons=line&size=%s", sizes[i]);
        add(m, "size=%s", sizes[i]);
        EACH(k, states)
        add(m, "%ssize=%s&samples=4", states[k], sizes[i]);
        EACH(k, shaders)
        add(m, "shader=%s&size=%s&samples=4", shaders[k], sizes[i]);
        for (size_t k = 1; k < sizeof models / sizeof *models; ++k)
            add(m, "model=%s&size=%s&samples=4", models[k], sizes[i]);
    }
}

/* Numbers, cameras and sizes. */
static void add_others(maker *m)
{
    static const char *const states[] = {
        SMALL "&shader=toon&bands=2",
        SMALL "&shader=toon&bands=7",
        SMALL "&exponent=1",
        SMALL "&shader=blinn-phong&exponent=300",
        "model=cube&" SMALL "&exponent=1024",
        SMALL "&near=9&far=10.5",
        SMALL "&near=0.001&far=1000000",
        SMALL "&far=10&convention=direct3d",
        "model=square&" SMALL "&near=0.5&convention=vulkan",
        SMALL "&fov=5",
        SMALL "&fov=120&eye=1,2.5,2.5",
        SMALL "&eye=0.2,1.3,0&target=3,1.3,0.1",
        "model=cube&" SMALL "&eye=0,0,0&target=1,1,1",
        "model=cube&" SMALL "&eye=0,5,0&target=0,0,0",
        "model=square&" SMALL "&eye=0,0.02,0&target=1,0,0",
        "model=triangle&" SMALL "&shader=vertex-color&eye=0,0,3&target=0,0,0",
        "model=triangle&" SMALL "&shader=vertex-color&eye=0.2,0.1,0.05&target=0,0,0",
        "size=1x1",
        "size=17x5&samples=4",
        "size=333x211",
        "size=16x300&convention=vulkan",
    };
    EACH(i, states)
    add(m, "%s", states[i]);
}

static void make(maker *m)
{
    fputs(explanation, m->out);
    fprintf(m->out, "reference Mesa %s, %s\n", reference_mesa_version(m->reference),
            reference_renderer(m->reference));
    EACH(i, models)
    if (i > 0)
        add(m, "model=%s", models[i]);
    add(m, "model=triangle&shader=vertex-color");
    add_first_steps(m);
    add_beginnings(m);
    add(m, "samples=4&shadows=on");
    add_shaders(m);
    add_maps(m);
    add_conventions(m);
    add_polygons(m);
    add_shadows(m);
    add_others(m);
}

/* Whether two files have the same pictures, in the same order. */
static bool same_pictures(const char *one, const char *other)
{
    char a[1024], b[1024];
    FILE *const in[2] = {fopen(one, "r"), fopen(other, "r")};
    bool same = in[0] && in[1], more = same;
    while (same && more) {
        const char *const first = fgets(a, sizeof a, in[0]);
        const char *const second = fgets(b, sizeof b, in[1]);
        more = first && second;
        same = more ? strcmp(a, b) == 0 || strncmp(a, "reference ", 10) == 0 : first == second;
        if (!same)
            fprintf(stderr, PROGRAM ": the contract differs in: %s", first ? a : "its end\n");
    }
    for (int i = 0; i < 2; ++i)
        if (in[i])
            fclose(in[i]);
    return same;
}

/* Whether there is a reference. */
static bool start(maker *m)
{
    char error[512] = "";
    m->reference = reference_create(REFERENCE_PINNED, error, sizeof error);
    if (!m->reference)
        fprintf(stderr, PROGRAM ": no reference: %s\n", error);
    return m->reference;
}

/* Writes the pictures to a file beside `name`, and then gives the file this name or compares it. */
static int write_or_compare(maker *m, const char *name, bool compares)
{
    char partial[512];
    snprintf(partial, sizeof partial, "%s.partial", name);
    m->out = fopen(partial, "w");
    if (m->out)
        make(m);
    bool good = m->out && !ferror(m->out) && fclose(m->out) == 0;
    if (!good)
        fprintf(stderr, PROGRAM ": cannot write %s: %s\n", partial, strerror(errno));
    good = good && m->differ == 0;
    if (good && compares)
        good = same_pictures(partial, name);
    if (compares || !good)
        remove(partial);
    else
        good = rename(partial, name) == 0;
    printf("pictures %s: %u states, %u differ from the reference\n",
           compares ? (good ? "are the contract's" : "are NOT the contract's")
           : good   ? "written"
                    : "NOT written",
           m->pictures, m->differ);
    return good ? 0 : 1;
}

int main(int argc, char **argv)
{
    const bool compares = argc > 1 && strcmp(argv[1], "--compare") == 0;
    const int first = compares ? 2 : 1;
    const char *const name = argc > first ? argv[first] : PICTURES_FILE;
    maker m = {0};
    if (argc > first + 1 || strncmp(name, "--", 2) == 0) {
        fprintf(
            stderr,
            "usage: pictures [--compare] [FILE]: writes the contract's pictures,\n" PICTURES_FILE
            ", if the library draws what the pinned reference does;\n"
            "with --compare, compares with this file instead\n");
        return 2;
    }
    if (!start(&m)) {
        printf("%sno reference: 'make setup' provides it\n",
               compares ? "skipped: pictures beside the reference: " : PROGRAM ": ");
        return compares ? 0 : 1;
    }
    const int status = write_or_compare(&m, name, compares);
    reference_destroy(m.reference);
    return status;
}
