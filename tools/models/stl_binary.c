/* Binary STL files, and the colours that two programs put into them. */
#include <math.h>
#include <string.h>

#include "stl.h"

static unsigned free_bytes(const stl_facets *f, size_t number)
{
    const uint8_t *const b = f->records + STL_RECORD_SIZE * number + STL_RECORD_SIZE - 2;
    return b[0] | (unsigned)b[1] << 8;
}

void stl_decode(const stl_facets *f, size_t number, stl_facet *facet)
{
    const uint8_t *const b = f->records + STL_RECORD_SIZE * number;
    for (size_t c = 0; c < 3; ++c)
        facet->normal[c] = reader_float(b + 4 * c);
    for (size_t i = 0; i < 9; ++i)
        facet->corners[i / 3][i % 3] = (double)reader_float(b + 12 + 4 * i);
}

void stl_decode_color(const stl_facets *f, size_t number, float color[4])
{
    const unsigned bits = free_bytes(f, number), is_set = bits >> 15;
    memcpy(color, f->color, 4 * sizeof *color);
    if (f->coloring == STL_NO_COLORS || is_set != (f->coloring == STL_VISCAM))
        return;
    for (unsigned c = 0; c < 3; ++c)
        color[f->coloring == STL_VISCAM ? 2 - c : c] = (float)(bits >> 5 * c & 31) / 31.0f;
}

/* Finds the colour of the whole that Magics writes into the header: "COLOR=" and four bytes. */
static const uint8_t *find_color(const uint8_t *header)
{
    for (size_t i = 0; i + 10 <= 80; ++i)
        if (memcmp(header + i, "COLOR=", 6) == 0)
            return header + i + 6;
    return NULL;
}

static void choose_coloring(model_reader *r, stl_facets *f)
{
    const uint8_t *const color = find_color(r->bytes);
    bool is_used = false;
    for (size_t i = 0; i < f->count && f->coloring == STL_NO_COLORS && color == NULL; ++i) {
        const unsigned bits = free_bytes(f, i);
        is_used = is_used || bits != 0;
        if (bits >> 15 != 0)
            f->coloring = STL_VISCAM;
    }
    if (color != NULL) {
        f->coloring = STL_MAGICS;
        for (int c = 0; c < 3; ++c)
            f->color[c] = (float)color[c] / 255.0f;
        if (color[3] != 255)
            reader_warn(r, NULL, "the alpha of COLOR= is not drawn");
    }
    if (f->coloring == STL_NO_COLORS && is_used)
        reader_warn(r, NULL, "the attribute bytes of triangles are not drawn");
}

bool stl_read_binary(model_reader *r, stl_facets *f)
{
    const uint64_t count = reader_word(r->bytes + 80);
    const uint64_t expected = STL_HEADER_SIZE + STL_RECORD_SIZE * count;
    if (r->size < expected)
        return reader_fail(r, "it is cut short: %llu triangles take %llu bytes, but it has %zu",
                           (unsigned long long)count, (unsigned long long)expected, r->size);
    if (r->size > expected)
        reader_warn(r, NULL, "%llu bytes behind the last triangle are left out",
                    (unsigned long long)(r->size - expected));
    f->count = (size_t)count;
    f->records = r->bytes + STL_HEADER_SIZE;
    choose_coloring(r, f);
    return true;
}
