/* Random blits by the library and by the pinned reference. What both write must be equal, bit for
 * bit, and nothing else may be written. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <gnomon.h>

#include "../../command_line.h"
#include "osmesa.h"
#include "random.h"
#include "scene_pixel.h"
#include "scene_text.h"

#define LARGEST 48
#define GUARD 64
#define MEMORY (2 * GUARD + (LARGEST * 16 + 48) * LARGEST)
/* Of all blits, at most a 25th may be left uncompared (measured: a 57th) and at least half must
 * write (measured: 55 %). Of the pixels that are encoded as sRGB, at most a quarter may be a step
 * off (measured: a tenth). In short runs FEW more are allowed. */
#define SHARE_UNCOMPARED 25
#define SHARE_WRITING 2
#define SHARE_OF_STEPS 4
#define FEW 10

#define COLORS ((size_t)SCENE_COLOR_FORMATS)
#define DEPTHS ((size_t)SCENE_DEPTH_FORMATS)
#define PAIRS (COLORS * COLORS + DEPTHS)

typedef struct blit_case {
    gn_format to_format, from_format;
    uint32_t to_size[2], from_size[2];
    gn_rectangle to, from;
    gn_blit_options options;
    bool whole; /* null rectangles */
} blit_case;

/* A float: any bits except denormals, the ends of ranges, ties of 4 to 16 bits and their
 * neighbours. */
static uint32_t random_float_bits(random_source *r)
{
    static const uint32_t special[] = {0x00000000u, 0x80000000u, 0x3F800000u, 0x3F800001u,
                                       0x7F800000u, 0xFF800000u, 0x7FC00000u, 0x7F7FFFFFu,
                                       0xBF800000u, 0x477FE000u, 0x47800000u, 0x4B008000u};
    static const uint32_t largest[] = {15, 31, 63, 255, 65535};
    const uint32_t kind = random_below(r, 8);
    float value;
    uint32_t bits;

    if (kind == 0)
        return special[random_below(r, sizeof special / sizeof *special)];
    if (kind == 1) {
        bits = (uint32_t)random_bits(r);
        const uint32_t exponent = bits >> 23 & 255;
        return exponent < 60 ? 0 : exponent == 255 ? 0x7FC00000u : bits;
    }
    if (kind < 5) {
        const uint32_t n = largest[random_below(r, 5)];
        const uint32_t halves = random_below(r, 2 * n + 1);
        value = (float)halves / (2.0f * (float)n);
        memcpy(&bits, &value, sizeof bits);
        if (bits > 8) {
            const int32_t step = random_between(r, -3, 3);
            bits += (uint32_t)step;
        }
        return bits;
    }
    value = random_float(r, -0.5f, 1.5f);
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

/* Depths have values that draws store. */
static uint32_t random_depth_bits(random_source *r)
{
    const float value =
        random_chance(r, 10) ? (random_chance(r, 50) ? 1.0f : 0.0f) : random_octave(r, -20, -1);
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

/* When the reference does not copy memory, it blits depths of 24 bits through floats, and some
 * depths come out a step off (reference/RULES.md). Returns a lesser depth that comes out exact. */
static uint32_t lasting_depth(uint32_t depth)
{
    for (; depth > 0; depth = depth * 3 / 4) {
        const float z = (float)depth * (float)(1.0 / 16777215.0);
        const double error = (double)(z * 16777215.0f) - depth;
        if (error > -0.5 && error < 0.5)
            break;
    }
    return depth;
}

static void fill(random_source *r, gn_format format, void *pixels, size_t count)
{
    const size_t bytes = count * gn_format_size(format);
    uint32_t *const words = pixels;
    uint16_t *const halves = pixels;
    const bool is_float = scene_is_color_format(format) && scene_is_float_format(format);

    for (size_t i = 0; i < bytes; ++i)
        ((unsigned char *)pixels)[i] = (unsigned char)random_below(r, 256);
    for (size_t i = 0; i < bytes / 4; ++i)
        if (is_float && scene_channel_width(format, 0) == 32)
            words[i] = random_float_bits(r);
        else if (format == GN_FORMAT_D32F || (format == GN_FORMAT_D32FS8 && i % 2 == 0))
            words[i] = random_depth_bits(r);
        else if (format == GN_FORMAT_D32FS8)
            words[i] &= 255;
        else if (format == GN_FORMAT_D24)
            words[i] = lasting_depth(words[i] & 0xFFFFFF);
        else if (format == GN_FORMAT_D24S8)
            words[i] = (words[i] & 0xFF000000u) | lasting_depth(words[i] & 0xFFFFFF);
    for (size_t i = 0; is_float && scene_channel_width(format, 0) == 16 && i < bytes / 2; ++i) {
        if ((halves[i] & 0x7FFF) > 0x7C00)
            halves[i] = 0x7E00;
        if (random_chance(r, 50))
            halves[i] = (uint16_t)(0x3000 + random_below(r, 0x0C10));
    }
}

static int32_t random_corner(random_source *r, uint32_t size, bool beyond)
{
    return beyond ? random_between(r, -12, (int32_t)size + 12)
                  : random_between(r, 0, (int32_t)size);
}

/* Seldom an empty rectangle, for which nothing is drawn. */
static gn_rectangle random_rectangle(random_source *r, const uint32_t size[2], bool beyond)
{
    gn_rectangle a;

    do {
        a.x0 = random_corner(r, size[0], beyond);
        a.y0 = random_corner(r, size[1], beyond);
        a.x1 = random_corner(r, size[0], beyond);
        a.y1 = random_corner(r, size[1], beyond);
    } while ((a.x0 == a.x1 || a.y0 == a.y1) && random_chance(r, 90));
    return a;
}

static uint32_t random_size(random_source *r)
{
    return random_chance(r, 50) ? 1 + random_below(r, 8) : 1 + random_below(r, LARGEST);
}

static blit_case random_case(random_source *r, uint64_t number)
{
    const uint32_t pair = (uint32_t)(number >> 32);
    blit_case c;
    memset(&c, 0, sizeof c);
    c.from_format = pair < COLORS * COLORS ? scene_color_formats[pair / COLORS]
                                           : scene_depth_formats[pair - COLORS * COLORS];
    c.to_format = pair < COLORS * COLORS ? scene_color_formats[pair % COLORS] : c.from_format;
    for (int n = 0; n < 2; ++n) {
        c.from_size[n] = random_size(r);
        c.to_size[n] = random_size(r);
    }
    if (pair < COLORS * COLORS && random_chance(r, 40))
        c.options.filter = GN_BLIT_LINEAR;
    c.whole = random_chance(r, 25);
    if (c.whole) {
        if (random_chance(r, 60))
            memcpy(c.to_size, c.from_size, sizeof c.to_size);
        c.to.x1 = (int32_t)c.to_size[0];
        c.to.y1 = (int32_t)c.to_size[1];
        c.from.x1 = (int32_t)c.from_size[0];
        c.from.y1 = (int32_t)c.from_size[1];
    } else {
        const bool from_beyond = random_chance(r, 35);
        const bool to_beyond = random_chance(r, 35);
        c.from = random_rectangle(r, c.from_size, from_beyond);
        c.to = random_rectangle(r, c.to_size, to_beyond);
        if (random_chance(r, 30)) {
            c.to.x1 =
                c.to.x0 + (random_chance(r, 50) ? c.from.x1 - c.from.x0 : c.from.x0 - c.from.x1);
            c.to.y1 =
                c.to.y0 + (random_chance(r, 50) ? c.from.y1 - c.from.y0 : c.from.y0 - c.from.y1);
        }
    }
    if (random_chance(r, 30)) {
        c.options.scissor.enabled = true;
        c.options.scissor.x = random_between(r, -4, (int32_t)c.to_size[0]);
        c.options.scissor.y = random_between(r, -4, (int32_t)c.to_size[1]);
        c.options.scissor.width = random_below(r, c.to_size[0] + 8);
        c.options.scissor.height = random_below(r, c.to_size[1] + 8);
    }
    if (pair >= COLORS * COLORS) {
        c.options.depth_disabled = random_chance(r, 25);
        c.options.stencil_disabled = random_chance(r, 25);
    }
    return c;
}

/* A surface with a random stride and alignment in guarded memory, and its contents. */
typedef struct guarded {
    gn_surface surface;
    unsigned char *memory;
} guarded;

static guarded guard(random_source *r, unsigned char *memory, const gn_surface *packed)
{
    const uint32_t element = (uint32_t)scene_element_size(packed->format);
    const ptrdiff_t row = packed->row_stride;
    const ptrdiff_t stride = row + (ptrdiff_t)(element * random_below(r, 3));
    guarded g = {*packed, memory};

    memset(memory, 0xA5, MEMORY);
    g.surface.pixels = memory + GUARD + element * random_below(r, 3);
    g.surface.row_stride = stride;
    if (random_chance(r, 40)) {
        g.surface.pixels = (unsigned char *)g.surface.pixels + stride * (packed->height - 1);
        g.surface.row_stride = -stride;
    }
    for (uint32_t y = 0; y < packed->height; ++y)
        memcpy((unsigned char *)g.surface.pixels + (ptrdiff_t)y * g.surface.row_stride,
               (unsigned char *)packed->pixels + (ptrdiff_t)y * row, (size_t)row);
    return g;
}

/* Copies the rows into packed memory; returns false if anything beside them was written. */
static bool unguard(const guarded *g, const gn_surface *packed)
{
    bool clean = true;

    for (uint32_t y = 0; y < packed->height; ++y) {
        unsigned char *const row =
            (unsigned char *)g->surface.pixels + (ptrdiff_t)y * g->surface.row_stride;
        memcpy((unsigned char *)packed->pixels + (ptrdiff_t)y * packed->row_stride, row,
               (size_t)packed->row_stride);
        memset(row, 0xA5, (size_t)packed->row_stride);
    }
    for (size_t i = 0; i < MEMORY; ++i)
        clean = clean && g->memory[i] == 0xA5;
    return clean;
}

static bool elements_equal(gn_format format, bool exact, const unsigned char *a,
                           const unsigned char *b)
{
    const size_t size = gn_format_size(format);
    if (memcmp(a, b, size) == 0)
        return true;
    if (format == GN_FORMAT_SRGB8_A8 && !exact) {
        for (int c = 0; c < 4; ++c) {
            const int off = a[c] - b[c];
            if (off < -1 || off > 1 || (c == 3 && off != 0))
                return false;
        }
        return true;
    }
    uint32_t x[4], y[4];

    if (!scene_is_float_format(format))
        return false;
    const int count = scene_pixel_channels(a, format, 0, x);
    scene_pixel_channels(b, format, 0, y);
    for (int c = 0; c < count; ++c)
        if (x[c] != y[c] && !(isnan(scene_channel_value(format, c, x[c])) &&
                              isnan(scene_channel_value(format, c, y[c]))))
            return false;
    return true;
}

/* A rectangle from low to high is cut at `limit`: the end of the other rectangle that moves with it
 * (rule 1 of Blits in reference/RULES.md). `anchor` and `end` are its ends that belong to low and
 * high. */
static int32_t moved_end(int32_t limit, int32_t low, int32_t high, int32_t anchor, int32_t end)
{
    const float share = (float)(limit - low) / (float)(high - low);

    return anchor + (int32_t)roundf(share * (float)(end - anchor));
}

/* What the cut to the visible part of the destination, low to high, leaves along one dimension. */
typedef enum cut_result {
    SOME_LEFT,
    NONE_VISIBLE,  /* a rectangle is empty, or lies beside its surface */
    NO_COUNTERPART /* the source's rectangle moves out of the source */
} cut_result;

/* The ends of the rectangles as they are given. */
static cut_result first_cut(int32_t to0, int32_t to1, int32_t low, int32_t high, int32_t from0,
                            int32_t from1, int32_t size)
{
    const bool is_turned = to0 > to1;
    int32_t first = is_turned ? to1 : to0, last = is_turned ? to0 : to1;
    int32_t anchor = is_turned ? from1 : from0, end = is_turned ? from0 : from1;

    if (first == last || anchor == end || low >= high || first >= high || last <= low ||
        (anchor <= 0 && end <= 0) || (anchor >= size && end >= size))
        return NONE_VISIBLE;
    if (last > high) {
        end = moved_end(high, first, last, anchor, end);
        last = high;
    }
    if (first < low)
        anchor = moved_end(low, first, last, anchor, end);
    if (anchor == end) /* no whole texel; but a place, which is read if the source has it */
        return anchor < 0 || anchor > size ? NO_COUNTERPART : SOME_LEFT;
    return (anchor <= 0 && end <= 0) || (anchor >= size && end >= size) ? NO_COUNTERPART
                                                                        : SOME_LEFT;
}

/* Whether no part of the visible destination has a counterpart on the source. Then the reference
 * cuts a rectangle inside out and may draw beside it (reference/RULES.md); nothing may be drawn. */
static bool has_no_counterpart(const blit_case *c)
{
    const gn_scissor *const s = &c->options.scissor;
    int32_t low[2] = {0, 0};
    int32_t high[2] = {(int32_t)c->to_size[0], (int32_t)c->to_size[1]};

    if (s->enabled) {
        const int32_t begins[2] = {s->x, s->y};
        const int32_t ends[2] = {s->x + (int32_t)s->width, s->y + (int32_t)s->height};

        for (int n = 0; n < 2; ++n) {
            low[n] = begins[n] > 0 ? begins[n] : 0;
            high[n] = ends[n] < high[n] ? ends[n] : high[n];
        }
    }
    const cut_result x = first_cut(c->to.x0, c->to.x1, low[0], high[0], c->from.x0, c->from.x1,
                                   (int32_t)c->from_size[0]);
    const cut_result y = first_cut(c->to.y0, c->to.y1, low[1], high[1], c->from.y0, c->from.y1,
                                   (int32_t)c->from_size[1]);

    return x != NONE_VISIBLE && y != NONE_VISIBLE && (x == NO_COUNTERPART || y == NO_COUNTERPART);
}

typedef struct totals {
    uint64_t blits, writing, without_counterpart, pixels, written, differ, stray, encoded, steps;
} totals;

static void report(const blit_case *c, uint64_t number)
{
    fprintf(stderr,
            "blit %" PRIu32 ": %s %" PRIu32 "x%" PRIu32 " (%" PRId32 ", %" PRId32 ", %" PRId32
            ", %" PRId32 ") to %s %" PRIu32 "x%" PRIu32 " (%" PRId32 ", %" PRId32 ", %" PRId32
            ", %" PRId32 "), %s",
            (uint32_t)number, text_name(TEXT_FORMAT, (int)c->from_format), c->from_size[0],
            c->from_size[1], c->from.x0, c->from.y0, c->from.x1, c->from.y1,
            text_name(TEXT_FORMAT, (int)c->to_format), c->to_size[0], c->to_size[1], c->to.x0,
            c->to.y0, c->to.x1, c->to.y1,
            c->options.filter == GN_BLIT_LINEAR ? "linear" : "nearest");
    if (c->options.scissor.enabled)
        fprintf(stderr, ", scissor %" PRId32 " %" PRId32 " %" PRIu32 " %" PRIu32,
                c->options.scissor.x, c->options.scissor.y, c->options.scissor.width,
                c->options.scissor.height);
    fprintf(stderr, "%s%s\n", c->options.depth_disabled ? ", keeps depth" : "",
            c->options.stencil_disabled ? ", keeps stencil" : "");
}

static void print_bytes(const char *name, const unsigned char *p, size_t size)
{
    fprintf(stderr, " %s", name);
    for (size_t i = 0; i < size; ++i)
        fprintf(stderr, "%s%02x", i % 4 == 0 ? " " : "", p[i]);
}

/* Tests one blit; returns false if either side refuses it. */
static bool compare(reference *osmesa, random_source *r, uint64_t number, totals *t,
                    uint64_t *pair_differ)
{
    static union {
        unsigned char byte[MEMORY];
        uint64_t aligned;
    } source, before, ours, theirs, guarded_source, guarded_destination;
    const blit_case c = random_case(r, number);
    gn_surface from =
        gn_surface_bottom_up(source.byte, c.from_format, c.from_size[0], c.from_size[1]);
    gn_surface to = gn_surface_bottom_up(ours.byte, c.to_format, c.to_size[0], c.to_size[1]);
    gn_surface wanted = to;
    const size_t count = (size_t)to.width * to.height;
    const size_t size = gn_format_size(to.format);
    char error[256] = "";

    fill(r, from.format, source.byte, (size_t)from.width * from.height);
    fill(r, to.format, ours.byte, count);
    memcpy(before.byte, ours.byte, sizeof before);
    memcpy(theirs.byte, ours.byte, sizeof theirs);
    wanted.pixels = theirs.byte;

    const guarded s = guard(r, guarded_source.byte, &from);
    const guarded d = guard(r, guarded_destination.byte, &to);
    const gn_status status = gn_blit(&d.surface, c.whole ? NULL : &c.to, &s.surface,
                                     c.whole ? NULL : &c.from, &c.options);
    const bool clean = unguard(&d, &to);
    if (status != GN_OK || !clean) {
        report(&c, number);
        fprintf(stderr, "  %s\n", status ? gn_status_text(status) : "wrote beside the surface");
        t->stray += status == GN_OK;
        return status == GN_OK;
    }
    if (!reference_blit(osmesa, &wanted, &c.to, &from, &c.from, &c.options, error, sizeof error)) {
        report(&c, number);
        fprintf(stderr, "  the reference: %s\n", error);
        return false;
    }

    const bool has_written = memcmp(ours.byte, before.byte, sizeof before) != 0;

    ++t->blits;
    t->writing += has_written;
    if (has_no_counterpart(&c)) {
        ++t->without_counterpart;
        if (has_written) {
            report(&c, number);
            fprintf(stderr, "  wrote pixels without a counterpart\n");
            ++t->stray;
        }
        return true;
    }

    /* Encoded as sRGB, which the reference approximates: a channel may be a step off. */
    const bool is_encoded =
        to.format == GN_FORMAT_SRGB8_A8 && (c.from_format != to.format || c.options.filter);
    uint64_t differ = 0;

    for (size_t i = 0; i < count; ++i) {
        const unsigned char *const a = ours.byte + i * size;
        const unsigned char *const b = theirs.byte + i * size;

        t->written += memcmp(a, before.byte + i * size, size) != 0;
        t->encoded += is_encoded && memcmp(a, before.byte + i * size, size) != 0;
        t->steps += is_encoded && memcmp(a, b, size) != 0;
        if (!elements_equal(to.format, !is_encoded, a, b) && differ++ == 0 && *pair_differ == 0 &&
            (report(&c, number), true)) {
            fprintf(stderr, "  first at (%zu, %zu):", i % to.width, i / to.width);
            print_bytes("before", before.byte + i * size, size);
            print_bytes("ours", a, size);
            print_bytes("theirs", b, size);
            fprintf(stderr, "\n");
        }
    }
    t->pixels += count;
    t->differ += differ;
    *pair_differ += differ;
    return true;
}

static void show_progress(uint64_t pair, const totals *t)
{
    static time_t last;
    const time_t now = time(NULL);

    if (last == 0)
        last = now;
    if (now - last < 5)
        return;
    last = now;
    fprintf(stderr, "blits: pair %" PRIu64 " of %zu, %" PRIu64 " pixels differ\n", pair + 1, PAIRS,
            t->differ);
}

int main(int argc, char **argv)
{
    uint64_t seed = 1, blits = 33000, first = 0, only = PAIRS;
    char error[512] = "";
    static uint64_t differ[PAIRS];
    totals t;

    for (int i = 1; i < argc; i += 2) {
        uint64_t *const number = !strcmp(argv[i], "--seed")    ? &seed
                                 : !strcmp(argv[i], "--blits") ? &blits
                                 : !strcmp(argv[i], "--first") ? &first
                                 : !strcmp(argv[i], "--pair")  ? &only
                                                               : NULL;
        const bool asks_help = !strcmp(argv[i], "--help");

        if (!number) {
            fprintf(asks_help ? stdout : stderr,
                    "usage: blits [--blits N] [--seed S] [--pair P] [--first K]\n"
                    "Compares random blits with OSMesa's, for every pair of formats or for pair "
                    "number P\n(0 to %zu), from blit number K on.\n",
                    PAIRS - 1);
            return asks_help ? EXIT_SUCCESS : 2;
        }
        if (!option_number("blits", argv[i], argv[i + 1], number == &blits,
                           number == &only ? PAIRS - 1 : UINT64_MAX, number))
            return 2;
    }
    reference *const osmesa = reference_create(REFERENCE_PINNED, error, sizeof error);
    if (!osmesa) {
        fprintf(stderr, "blits: no reference: %s\n", error);
        return EXIT_FAILURE;
    }
    memset(&t, 0, sizeof t);
    bool fine = true;
    for (uint64_t p = 0; p < PAIRS && fine; ++p) {
        if (only < PAIRS && p != only)
            continue;
        for (uint64_t n = 0; fine && n < blits / PAIRS + (p < blits % PAIRS); ++n) {
            const uint64_t number = p << 32 | (first + n);
            random_source r = random_seed(seed * UINT64_C(0x9E3779B97F4A7C15) + number);

            fine = compare(osmesa, &r, number, &t, &differ[p]);
            show_progress(p, &t);
        }
    }
    for (size_t p = 0; p < PAIRS; ++p)
        if (differ[p])
            printf("%s to %s: %" PRIu64 " differ\n",
                   text_name(TEXT_FORMAT,
                             (int)(p < COLORS * COLORS ? scene_color_formats[p / COLORS]
                                                       : scene_depth_formats[p - COLORS * COLORS])),
                   text_name(TEXT_FORMAT,
                             (int)(p < COLORS * COLORS ? scene_color_formats[p % COLORS]
                                                       : scene_depth_formats[p - COLORS * COLORS])),
                   differ[p]);
    reference_destroy(osmesa);

    const bool compares_enough = t.without_counterpart <= t.blits / SHARE_UNCOMPARED + FEW;
    const bool writes_enough = t.writing + FEW >= t.blits / SHARE_WRITING;
    const bool few_steps = t.steps <= t.encoded / SHARE_OF_STEPS + FEW;

    if (!compares_enough || !writes_enough || !few_steps)
        fprintf(stderr, "blits: too many %s\n",
                !compares_enough ? "are not compared"
                : !writes_enough ? "write nothing"
                                 : "steps of sRGB");
    printf("blits: %" PRIu64 " blits of %zu pairs of formats, %" PRIu64 " pixels compared, %" PRIu64
           " written, %" PRIu64 " a step of sRGB off; %" PRIu64
           " blits of places without a counterpart, where the reference is not asked; %" PRIu64
           " differ\n",
           t.blits, (size_t)PAIRS, t.pixels, t.written, t.steps, t.without_counterpart, t.differ);
    return fine && compares_enough && writes_enough && few_steps && t.blits > 0 && t.differ == 0 &&
                   t.stray == 0
               ? EXIT_SUCCESS
               : EXIT_FAILURE;
}
