/* Blits, resolves and clears of any surfaces write only where they may, and whole what they write
 * in parts: a blit equals the blits of its parts, which the scissor cuts. */
#include <stdlib.h>
#include <string.h>

#include "surface_input.h"

static gn_rectangle rectangle(fuzz_input *in, const gn_surface *s)
{
    const int32_t width = (int32_t)(s->width & 0x7FFF), height = (int32_t)(s->height & 0x7FFF);
    gn_rectangle r = {0, 0, width, height};
    int32_t *const corner[4] = {&r.x0, &r.y0, &r.x1, &r.y1};
    const uint8_t kind = fuzz_byte(in);

    for (int i = 0; i < 4; ++i)
        if (kind >> i & 1)
            *corner[i] =
                kind & 128 ? (int32_t)fuzz_magnitude(in) : (int32_t)fuzz_below(in, 64) - 16;
    if (kind & 16) {
        const int32_t x = r.x0;

        r.x0 = r.x1;
        r.x1 = x;
    }
    return r;
}

/* The pixels that a rectangle and a scissor may write. */
typedef struct bounds {
    int64_t x0, y0, x1, y1;
} bounds;

static bounds bounds_of(const gn_rectangle *to, const gn_scissor *scissor)
{
    bounds b = {to->x0 < to->x1 ? to->x0 : to->x1, to->y0 < to->y1 ? to->y0 : to->y1,
                to->x0 < to->x1 ? to->x1 : to->x0, to->y0 < to->y1 ? to->y1 : to->y0};

    if (scissor->enabled) {
        const int64_t right = (int64_t)scissor->x + scissor->width;
        const int64_t top = (int64_t)scissor->y + scissor->height;

        b.x0 = b.x0 > scissor->x ? b.x0 : scissor->x;
        b.y0 = b.y0 > scissor->y ? b.y0 : scissor->y;
        b.x1 = b.x1 < right ? b.x1 : right;
        b.y1 = b.y1 < top ? b.y1 : top;
    }
    return b;
}

/* The part of a scissor left of x, or from x on. */
static gn_scissor part(const gn_scissor *whole, const gn_surface *s, int32_t x, bool right)
{
    const int64_t from = whole->enabled ? whole->x : 0;
    const int64_t to = whole->enabled ? from + whole->width : s->width;
    const int64_t begin = right ? (x > from ? x : from) : from;
    const int64_t end = right ? to : (x < to ? x : to);
    gn_scissor p = *whole;

    p.enabled = true;
    if (!whole->enabled) {
        p.y = 0;
        p.height = s->height;
    }
    p.x = (int32_t)(begin > INT32_MAX ? INT32_MAX : begin);
    p.width = (uint32_t)(end > begin ? end - begin : 0);
    return p;
}

static bool is_within(const gn_rectangle *r, const gn_surface *s)
{
    const int32_t width = (int32_t)s->width, height = (int32_t)s->height;

    return r->x0 >= 0 && r->x0 <= width && r->x1 >= 0 && r->x1 <= width && r->y0 >= 0 &&
           r->y0 <= height && r->y1 >= 0 && r->y1 <= height;
}

static void blit(fuzz_input *in, surface_input *to, surface_input *from)
{
    const uint8_t kind = fuzz_byte(in);
    gn_blit_options options = {0};
    const bool itself = kind & 1 && to->memory;
    const gn_surface *const source = itself ? &to->surface : &from->surface;
    const gn_rectangle a = rectangle(in, &to->surface), b = rectangle(in, source);

    options.filter = kind & 2 ? GN_BLIT_LINEAR : GN_BLIT_NEAREST;
    options.depth_disabled = kind & 4;
    options.stencil_disabled = kind & 8;
    if (kind & 16) {
        options.scissor.enabled = true;
        options.scissor.x = (int32_t)fuzz_below(in, 64) - 16;
        options.scissor.y = (int32_t)fuzz_below(in, 64) - 16;
        options.scissor.width = fuzz_below(in, 64);
        options.scissor.height = fuzz_below(in, 64);
        if (kind & 32)
            options.scissor.x = (int32_t)fuzz_word(in);
        if (kind & 64)
            options.scissor.width = fuzz_word(in);
    }
    if (fuzz_rarely(in, 64))
        options.filter = (gn_blit_filter)fuzz_word(in);

    const gn_rectangle *const at = kind & 128 ? NULL : &a;
    const gn_rectangle whole = {0, 0, (int32_t)to->surface.width, (int32_t)to->surface.height};
    const bounds written = bounds_of(at ? at : &whole, &options.scissor);
    const gn_status status = gn_blit(&to->surface, at, source, &b, &options);

    FUZZ_REQUIRE(status >= GN_OK && status < GN_STATUS_COUNT);
    if (status != GN_OK)
        FUZZ_REQUIRE(surface_holds_outside(to, 0, 0, 0, 0, 0));
    else
        FUZZ_REQUIRE(surface_holds_outside(to, written.x0, written.y0, written.x1, written.y1, 1));
    FUZZ_REQUIRE(surface_holds_outside(from, 0, 0, 0, 0, 0));
    if (status == GN_OK && to->memory && is_within(&b, source)) {
        /* Each pixel reads the texels that it would read without a cut. (Where the source is cut
         * too, its end is rounded to a pixel of what the scissor has left.) */
        unsigned char *const expected = surface_copy(to);
        const int32_t middle = (int32_t)fuzz_below(in, 32);
        const gn_scissor scissor = options.scissor;

        surface_restore(to);
        for (int right = 0; right < 2; ++right) {
            options.scissor = part(&scissor, &to->surface, middle, right);
            FUZZ_REQUIRE(gn_blit(&to->surface, at, source, &b, &options) == GN_OK);
        }
        FUZZ_REQUIRE(memcmp(expected, to->memory, to->size) == 0);
        free(expected);
    }
    surface_restore(to);
}

typedef struct clear {
    float color[4], depth;
    uint8_t stencil;
    int kind;
} clear;

static gn_status do_clear(const clear *c, const gn_surface *s)
{
    switch (c->kind) {
    case 0:
        return gn_clear_color(s, c->color[0], c->color[1], c->color[2], c->color[3]);
    case 1:
        return gn_clear_depth(s, c->depth);
    case 2:
        return gn_clear_stencil(s, c->stencil);
    default:
        return gn_clear_depth_stencil(s, c->depth, c->stencil);
    }
}

/* No rows, and rows and samples that a surface does not have, are absent. */
static void take_parts(fuzz_input *in, const gn_surface *s)
{
    const bool any = fuzz_rarely(in, 4);
    const uint32_t first = any ? fuzz_magnitude(in) : fuzz_below(in, 40);
    const uint32_t count = any ? fuzz_magnitude(in) : fuzz_below(in, 40);
    const uint32_t sample = any ? fuzz_magnitude(in) : fuzz_below(in, 8);
    const gn_surface rows = gn_surface_rows(s, first, count);
    const bool has_rows = count > 0 && first < s->height && (uint64_t)first + count <= s->height;
    const bool has_sample = sample < (s->samples ? s->samples : 1);

    FUZZ_REQUIRE((rows.pixels != NULL) == has_rows && rows.height == (has_rows ? count : 0));
    FUZZ_REQUIRE((gn_surface_sample(s, sample).pixels != NULL) == has_sample);
}

/* A clear of the whole equals clears of its rows and samples. */
static void clear_surface(fuzz_input *in, surface_input *s)
{
    clear c;

    c.kind = (int)fuzz_below(in, 4);
    for (int i = 0; i < 4; ++i)
        c.color[i] = fuzz_float(in);
    c.depth = fuzz_float(in);
    c.stencil = fuzz_byte(in);
    const gn_status status = do_clear(&c, &s->surface);

    FUZZ_REQUIRE(status >= GN_OK && status < GN_STATUS_COUNT);
    FUZZ_REQUIRE(surface_holds_outside(s, 0, 0, status ? 0 : INT32_MAX, INT32_MAX, 15));
    if (status == GN_OK && s->memory && !s->overlaps) {
        unsigned char *const expected = surface_copy(s);
        const uint32_t cut = fuzz_below(in, s->surface.height < 65536 ? s->surface.height : 1);
        const gn_surface parts[2] = {gn_surface_rows(&s->surface, 0, cut),
                                     gn_surface_rows(&s->surface, cut, s->surface.height - cut)};

        surface_restore(s);
        for (int i = 0; i < 2; ++i)
            for (uint32_t n = 0; n < (s->surface.samples > 1 ? s->surface.samples : 1); ++n) {
                const gn_surface sample = gn_surface_sample(&parts[i], n);

                if (parts[i].height > 0)
                    FUZZ_REQUIRE(do_clear(&c, &sample) == GN_OK);
            }
        FUZZ_REQUIRE(memcmp(expected, s->memory, s->size) == 0);
        free(expected);
        take_parts(in, &s->surface);
    }
    surface_restore(s);
}

static void resolve(surface_input *to, surface_input *from)
{
    const gn_status status = gn_resolve(&to->surface, &from->surface);

    FUZZ_REQUIRE(status >= GN_OK && status < GN_STATUS_COUNT);
    FUZZ_REQUIRE(surface_holds_outside(to, 0, 0, status ? 0 : INT32_MAX, INT32_MAX, 1));
    FUZZ_REQUIRE(surface_holds_outside(from, 0, 0, 0, 0, 0));
    surface_restore(to);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    fuzz_input in = fuzz_begin(bytes, size);
    const uint8_t kind = fuzz_byte(&in);
    const uint32_t samples[2] = {kind & 64 ? GN_SAMPLES : kind >> 5 & 1,
                                 kind & 128 ? GN_SAMPLES : 0};
    surface_input s[2];

    for (int i = 0; i < 2; ++i) {
        const bool same = i == 1 && kind & 16;
        const gn_format format = same ? s[0].surface.format : surface_format(&in, kind >> 3 & 1);
        const uint32_t width = same && kind & 8 ? s[0].surface.width : 1 + fuzz_below(&in, 40);
        const uint32_t height = same && kind & 8 ? s[0].surface.height : 1 + fuzz_below(&in, 24);

        if (!surface_make(&in, format, width, height, samples[i], &s[i])) {
            if (i == 1)
                surface_free(&s[0]);
            return -1;
        }
    }
    switch (kind & 3) {
    case 0:
    case 1:
        blit(&in, &s[0], &s[1]);
        break;
    case 2:
        clear_surface(&in, &s[0]);
        break;
    default:
        resolve(&s[0], &s[1]);
        break;
    }
    surface_free(&s[0]);
    surface_free(&s[1]);
    return 0;
}
