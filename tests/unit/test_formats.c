/* Colour formats: positions of channels in a pixel, results of clears and fragments, alignment.
 * Expected values are written out from the tables of surface.h. */
#include <string.h>

#include "covered.h"

/* A pixel in the units of its format: bytes, words of 16 bits or of 32. */
typedef struct expected {
    gn_format format;
    uint32_t element; /* bytes */
    uint32_t count;
    uint32_t clear[4];    /* of CLEAR */
    uint32_t fragment[4]; /* of SHADED */
} expected;

/* 0.5 is 127.5 of 255, 15.5 of 31, 31.5 of 63, 7.5 of 15, 32767.5 of 65535: a tie in each;
 * 2 and -1 saturate. sRGB has 188 for 0.5. */
static const float CLEAR[4] = {0.5f, 1.0f, 0.25f, -1.0f};

/* 0.75 is 191.25 of 255 and 0.6 is 153; 191 >> 3 = 23, 191 / 17 = 11.2, 153 / 17 = 9. */
static const float SHADED[4] = {0.75f, 0.0f, 2.0f, 0.6f};

static const expected table[] = {
    {GN_FORMAT_RGBA8, 4, 1, {0x0040FF80u}, {0x99FF00BFu}},
    {GN_FORMAT_BGRA8, 4, 1, {0x0080FF40u}, {0x99BF00FFu}},
    {GN_FORMAT_SRGB8_A8, 4, 1, {0x0089FFBCu}, {0x99FF00E1u}},
    {GN_FORMAT_R8, 1, 1, {0x80}, {0xBF}},
    {GN_FORMAT_RG8, 2, 1, {0xFF80}, {0x00BF}},
    {GN_FORMAT_RGB8, 1, 3, {0x80, 0xFF, 0x40}, {0xBF, 0x00, 0xFF}},
    {GN_FORMAT_RGB565, 2, 1, {16u << 11 | 63u << 5 | 8}, {23u << 11 | 31}},
    {GN_FORMAT_RGB5_A1, 2, 1, {16u << 11 | 31u << 6 | 8u << 1}, {23u << 11 | 31u << 1 | 1}},
    {GN_FORMAT_RGBA4, 2, 1, {8u << 12 | 15u << 8 | 4u << 4}, {11u << 12 | 15u << 4 | 9}},
    {GN_FORMAT_R16, 2, 1, {32768}, {49151}},
    {GN_FORMAT_RGBA16, 2, 4, {32768, 65535, 16384, 0}, {49151, 0, 65535, 39321}},
    {GN_FORMAT_R32F, 4, 1, {0x3F000000u}, {0x3F400000u}},
    {GN_FORMAT_RGBA16F, 2, 4, {0x3800, 0x3C00, 0x3400, 0xBC00}, {0x3A00, 0, 0x4000, 0x38CC}},
    {GN_FORMAT_RGB565_SWAPPED, 1, 2, {16u << 3 | 7, 7u << 5 | 8}, {23u << 3, 31}},
    {GN_FORMAT_RGB10_A2, 4, 1, {512u | 1023u << 10 | 256u << 20}, {767u | 1023u << 20 | 2u << 30}},
    {GN_FORMAT_R11F_G11F_B10F,
     4,
     1,
     {0x380u | 0x3C0u << 11 | 0x1A0u << 22},
     {0x3A0u | 0x200u << 22}},
    {GN_FORMAT_RG16F, 4, 1, {0x3C003800u}, {0x00003A00u}},
    {GN_FORMAT_RGB32F,
     4,
     3,
     {0x3F000000u, 0x3F800000u, 0x3E800000u},
     {0x3F400000u, 0, 0x40000000u}},
    {GN_FORMAT_RGBA32F,
     4,
     4,
     {0x3F000000u, 0x3F800000u, 0x3E800000u, 0xBF800000u},
     {0x3F400000u, 0, 0x40000000u, 0x3F19999Au}},
};

#define SIDE 7

static uint32_t memory[SIDE * SIDE * 4 + 4];
static const gn_pipeline plain;
static const float zeros[4];

static uint32_t element_at(const void *at, uint32_t size, size_t i)
{
    return size == 1   ? ((const uint8_t *)at)[i]
           : size == 2 ? ((const uint16_t *)at)[i]
                       : ((const uint32_t *)at)[i];
}

/* Every element of the surface is the wanted one, and the next byte is untouched. */
static void assert_elements(const expected *e, const uint32_t wanted[4])
{
    const size_t elements = (size_t)SIDE * SIDE * e->count;

    for (size_t i = 0; i < elements; ++i)
        if (element_at(memory, e->element, i) != wanted[i % e->count])
            fail_msg("format %d, element %zu: %x", (int)e->format, i,
                     element_at(memory, e->element, i));
    assert_int_equal(((const unsigned char *)memory)[elements * e->element], 0x55);
}

/* Clears, then draws SHADED under a state. */
static void combine(const gn_pipeline *state, const expected *e, const float clear[4],
                    const uint32_t wanted[4])
{
    const gn_surface s = gn_surface_bottom_up(memory, e->format, SIDE, SIDE);

    memset(memory, 0x55, sizeof memory);
    assert_int_equal(gn_clear_color(&s, clear[0], clear[1], clear[2], clear[3]), GN_OK);
    cover(&s, state, SHADED);
    assert_elements(e, wanted);
}

static void clears_and_fragments_give_the_values_of_the_table(void **state)
{
    for (size_t f = 0; f < COUNT(table); ++f) {
        const expected *const e = &table[f];
        const gn_surface s = gn_surface_bottom_up(memory, e->format, SIDE, SIDE);

        assert_int_equal(gn_format_size(e->format), e->element * e->count);
        memset(memory, 0x55, sizeof memory);
        assert_int_equal(gn_clear_color(&s, CLEAR[0], CLEAR[1], CLEAR[2], CLEAR[3]), GN_OK);
        assert_elements(e, e->clear);
        combine(&plain, e, CLEAR, e->fragment);
    }
}

/* With the least alignment allowed, and a gap of one element between rows. */
static void fragments_leave_what_is_beside_them(void **state)
{
    static unsigned char bytes[(SIDE * SIDE * 16 + SIDE * 4) + 16];

    for (size_t f = 0; f < COUNT(table); ++f) {
        const expected *const e = &table[f];
        const size_t row = SIDE * e->element * e->count, stride = row + e->element;
        gn_surface s = gn_surface_bottom_up(bytes + e->element, e->format, SIDE, SIDE);

        s.row_stride = (ptrdiff_t)stride;
        memset(bytes, 0x55, sizeof bytes);
        cover(&s, &plain, SHADED);
        for (size_t i = 0; i < sizeof bytes; ++i) {
            const size_t at = i - e->element;
            if (i < e->element || at >= SIDE * stride || at % stride >= row)
                assert_int_equal(bytes[i], 0x55);
        }
    }
}

/* Halves: subnormal, the largest, beyond it, infinite, NaN; each rounded toward zero, by clears
 * too. Floats without sign round toward zero too; clears do not (test_clears.c). */
static void floats_round_toward_zero(void **state)
{
    static const struct {
        uint32_t single, half, red;
    } values[] = {
        {0x3F801FFF, 0x3C00, 0x3C0}, {0x3F802000, 0x3C01, 0x3C0}, {0x3F820000, 0x3C10, 0x3C1},
        {0x3F81FFFF, 0x3C0F, 0x3C0}, {0x38800000, 0x0400, 0x040}, {0xB8800000, 0x8400, 0x000},
        {0x387FFFFF, 0x03FF, 0x03F}, {0x35800000, 0x0010, 0x001}, {0x357FFFFF, 0x000F, 0x000},
        {0x33800000, 0x0001, 0x000}, {0x337FFFFF, 0x0000, 0x000}, {0x477E0000, 0x7BF0, 0x7BF},
        {0x477FE000, 0x7BFF, 0x7BF}, {0x477FFFFF, 0x7BFF, 0x7BF}, {0x47800000, 0x7BFF, 0x7BF},
        {0x7F7FFFFF, 0x7BFF, 0x7BF}, {0xFF7FFFFF, 0xFBFF, 0x000}, {0x7F800000, 0x7C00, 0x7C0},
        {0xFF800000, 0xFC00, 0x000}, {0xBF800000, 0xBC00, 0x000}, {0x7FC00000, 0x7E00, 0x7E0},
        {0xFF800001, 0x7E00, 0x7E0}, {0x80000000, 0x8000, 0x000}};
    const gn_surface halves = gn_surface_bottom_up(memory, GN_FORMAT_RGBA16F, SIDE, SIDE);
    const gn_surface unsigned_floats =
        gn_surface_bottom_up(memory, GN_FORMAT_R11F_G11F_B10F, SIDE, SIDE);

    for (size_t i = 0; i < COUNT(values); ++i) {
        const uint32_t red = values[i].red;
        float c[4];

        for (int k = 0; k < 4; ++k)
            memcpy(&c[k], &values[i].single, sizeof c[k]);
        cover(&halves, &plain, c);
        assert_int_equal(element_at(memory, 2, 3), values[i].half);
        assert_int_equal(gn_clear_color(&halves, c[0], c[1], c[2], c[3]), GN_OK);
        assert_int_equal(element_at(memory, 2, 3), values[i].half);
        cover(&unsigned_floats, &plain, c);
        assert_int_equal(memory[3], red | red << 11 | red >> 1 << 22);
    }
}

static void pixels_are_aligned_to_their_element(void **state)
{
    for (size_t f = 0; f < COUNT(table); ++f) {
        const expected *const e = &table[f];
        gn_target t = {0};

        for (uint32_t offset = 0; offset < 4; ++offset) {
            const gn_status wanted = offset % e->element ? GN_MISALIGNED : GN_OK;

            t.color[0] = gn_surface_bottom_up((unsigned char *)memory + offset, e->format, 2, 2);
            assert_int_equal(gn_target_check(&t), wanted);
            t.color[0].pixels = memory;
            t.color[0].row_stride += (ptrdiff_t)offset;
            assert_int_equal(gn_target_check(&t), wanted);
            t.color[0].row_stride = -t.color[0].row_stride;
            assert_int_equal(gn_target_check(&t), wanted);
        }
        t.color[0].row_stride = (ptrdiff_t)(gn_format_size(e->format) * 2 - e->element);
        assert_int_equal(gn_target_check(&t), GN_INVALID_STRIDE);
        t.depth = t.color[0];
        memset(&t.color[0], 0, sizeof t.color[0]);
        assert_int_equal(gn_target_check(&t), GN_INVALID_FORMAT);
    }
}

static bool is_float(gn_format format)
{
    return format == GN_FORMAT_R32F || format == GN_FORMAT_RGBA16F || format == GN_FORMAT_RGBA32F ||
           format == GN_FORMAT_RG16F || format == GN_FORMAT_R11F_G11F_B10F ||
           format == GN_FORMAT_RGB32F;
}

/* 0 + s, s * 1, and the minimum of s and a greater value are s. */
static void blending_that_changes_nothing_gives_fragments(void **state)
{
    static const float ones[4] = {1.0f, 1.0f, 1.0f, 1.0f};
    static const float twos[4] = {2.0f, 2.0f, 2.0f, 2.0f};
    for (size_t f = 0; f < COUNT(table); ++f) {
        gn_pipeline p = {0};

        p.color.blend[0].enabled = true;
        p.color.blend[0].source = GN_FACTOR_ONE;
        p.color.blend[0].destination = GN_FACTOR_ONE;
        combine(&p, &table[f], zeros, table[f].fragment);
        p.color.blend[0].source = GN_FACTOR_DESTINATION_COLOR;
        p.color.blend[0].destination = GN_FACTOR_ZERO;
        combine(&p, &table[f], ones, table[f].fragment);
        p.color.blend[0].equation = GN_EQUATION_MIN;
        combine(&p, &table[f], twos, table[f].fragment);
    }
}

/* s * 1 + d - s * 1, in two draws. */
static void subtracting_what_was_added_gives_the_clear(void **state)
{
    static const float small[4] = {0.5f, 0.125f, 0.5f, 0.25f};

    for (size_t f = 0; f < COUNT(table); ++f) {
        const expected *const e = &table[f];
        const gn_surface s = gn_surface_bottom_up(memory, e->format, SIDE, SIDE);
        uint32_t before[COUNT(memory)];
        gn_pipeline p = {0};

        if (e->format == GN_FORMAT_RGB565 || e->format == GN_FORMAT_RGB565_SWAPPED ||
            e->format == GN_FORMAT_RGB5_A1 || e->format == GN_FORMAT_RGB10_A2 ||
            e->format == GN_FORMAT_RGBA4 || e->format == GN_FORMAT_SRGB8_A8)
            continue; /* these formats lose digits in between */
        assert_int_equal(gn_clear_color(&s, 0.125f, 0.25f, 0.25f, 0.25f), GN_OK);
        memcpy(before, memory, sizeof before);
        p.color.blend[0].enabled = true;
        p.color.blend[0].destination = GN_FACTOR_ONE;
        cover(&s, &p, small);
        assert_memory_not_equal(before, memory, sizeof before);
        p.color.blend[0].equation = GN_EQUATION_REVERSE_SUBTRACT;
        cover(&s, &p, small);
        assert_memory_equal(before, memory, sizeof before);
    }
}

static void alpha_that_is_not_there_is_one(void **state)
{
    static const uint32_t nothing[4] = {0, 0, 0, 0};
    for (size_t f = 0; f < COUNT(table); ++f) {
        const expected *e = &table[f];
        const bool opaque = e->format == GN_FORMAT_R8 || e->format == GN_FORMAT_RG8 ||
                            e->format == GN_FORMAT_RGB8 || e->format == GN_FORMAT_RGB565 ||
                            e->format == GN_FORMAT_R16 || e->format == GN_FORMAT_R32F ||
                            e->format == GN_FORMAT_RG16F || e->format == GN_FORMAT_RGB565_SWAPPED ||
                            e->format == GN_FORMAT_R11F_G11F_B10F || e->format == GN_FORMAT_RGB32F;
        gn_pipeline p = {0};

        p.color.blend[0].enabled = true;
        p.color.blend[0].source = GN_FACTOR_DESTINATION_ALPHA;
        combine(&p, e, zeros, opaque ? e->fragment : nothing);
    }
}

/* In formats of integers the bits of the clear, 0.5, 1, 0.25 and 0. In formats of floats and sRGB
 * colours stay as the fragments' are. */
static void logic_inverts_the_bits_of_integers(void **state)
{
    for (size_t f = 0; f < COUNT(table); ++f) {
        const expected *e = &table[f];
        uint32_t inverted[4];
        gn_pipeline p = {0};

        for (uint32_t i = 0; i < 4; ++i)
            inverted[i] = ~e->clear[i] & (UINT32_MAX >> (32 - 8 * e->element));
        p.color.logic_enabled = true;
        p.color.logic_operation = GN_LOGIC_INVERT;
        combine(&p, e, CLEAR,
                is_float(e->format) || e->format == GN_FORMAT_SRGB8_A8 ? e->fragment : inverted);
    }
}

/* The channels of a mask, then the others: the result is as without masks. The first mask alone
 * changes those of its channels that the format has. */
static void masks_keep_the_other_channels(void **state)
{
    for (size_t f = 0; f < COUNT(table); ++f) {
        const expected *const e = &table[f];
        const gn_surface s = gn_surface_bottom_up(memory, e->format, SIDE, SIDE);

        for (uint32_t mask = 0; mask <= GN_CHANNEL_ALL; ++mask) {
            gn_pipeline p = {.color.write_disabled = {GN_CHANNEL_ALL}};

            combine(&p, e, CLEAR, e->clear);
            p.color.write_disabled[0] = mask;
            cover(&s, &p, SHADED);
            /* Green is the second of four bytes. */
            if (mask == (GN_CHANNEL_ALL & ~GN_CHANNEL_GREEN) && e->count == 1 && e->element == 4 &&
                !is_float(e->format) && e->format != GN_FORMAT_RGB10_A2)
                assert_int_equal((memory[0] ^ e->clear[0]) & ~0xFF00u, 0);
            p.color.write_disabled[0] = GN_CHANNEL_ALL & ~mask;
            cover(&s, &p, SHADED);
            assert_elements(e, e->fragment);
        }
    }
}

/* Colour a is a / 8 in red and 1 in alpha. */
static void shade_all_colors(const void *uniforms, const gn_fragment_input *input,
                             gn_fragment_output *output)
{
    for (int a = 0; a < GN_MAX_COLORS; ++a)
        for (int c = 0; c < 4; ++c)
            for (int l = 0; l < GN_LANES; ++l)
                output->color[4 * a + c][l] = c == 0 ? (float)a / 8.0f : 1.0f;
}

/* Surfaces of R32F, and of RG8 at odd places, cleared to 0.25; one attachment is a hole.
 * Attachments that the shader writes have its colour, added if blending says so, but not where a
 * mask forbids it. */
static void each_attachment_has_its_color(void **state)
{
    static uint32_t images[GN_MAX_COLORS][SIDE * SIDE];
    static const uint16_t bytes[] = {0, 32, 0, 96, 0, 0, 0, 223};
    enum { HOLE = 2, ADDED = 4, MASKED = 5 };

    for (int written = 1; written <= GN_MAX_COLORS; ++written) {
        gn_pipeline p = {.program.fragment_shader = shade_all_colors};
        gn_target t = {0};

        p.program.color_count = GN_MAX_COLORS;
        for (int a = 0; a < GN_MAX_COLORS; ++a) {
            t.color[a] =
                gn_surface_bottom_up(images[a], a % 2 ? GN_FORMAT_RG8 : GN_FORMAT_R32F, SIDE, SIDE);
            assert_int_equal(gn_clear_color(&t.color[a], 0.25f, 0.25f, 0.25f, 0.25f), GN_OK);
            /* Missing attachments are not written, whatever colour the shader outputs. */
            if (a == HOLE || a >= written)
                t.color[a].format = GN_FORMAT_NONE;
        }
        p.color.blend[ADDED].enabled = true;
        p.color.blend[ADDED].destination = GN_FACTOR_ONE;
        p.color.write_disabled[MASKED] = GN_CHANNEL_RED;
        assert_int_equal(cover_target(&t, &p, NULL, GN_BACKEND_AUTO), GN_OK);
        for (int i = 0; i < GN_MAX_COLORS * SIDE * SIDE; ++i) {
            const int a = i % GN_MAX_COLORS, at = i / GN_MAX_COLORS;
            const bool kept = a == HOLE || a >= written;
            float value;

            memcpy(&value, &images[a][at], sizeof value);
            if (a % 2)
                assert_int_equal(((const uint16_t *)images[a])[at], kept ? 0x4040
                                                                    : a == MASKED
                                                                        ? 0xFF40
                                                                        : 0xFF00 | bytes[a]);
            else
                assert_true(value == (kept ? 0.25f : (float)a / 8 + (a == ADDED ? 0.25f : 0)));
        }
    }
}

/* Attachments beyond the pipeline's count stay as they are; they need a shader all the same. */
static void attachments_beyond_the_count_stay(void **state)
{
    static uint32_t images[2][SIDE * SIDE];
    gn_pipeline p = {.program.fragment_shader = shade_all_colors};
    gn_target t = {0};

    p.program.color_count = GN_MAX_COLORS;
    for (int a = 0; a < 2; ++a) {
        t.color[a] = gn_surface_bottom_up(images[a], GN_FORMAT_RGBA8, SIDE, SIDE);
        assert_int_equal(gn_clear_color(&t.color[a], 0, 0, 1, 0), GN_OK);
    }
    assert_int_equal(cover_target(&t, &p, NULL, GN_BACKEND_AUTO), GN_OK);
    assert_int_equal(images[1][0], 0xFFFFFF20);
    assert_int_equal(gn_clear_color(&t.color[1], 0, 0, 1, 0), GN_OK);
    assert_int_equal(cover_target(&t, &plain, SHADED, GN_BACKEND_AUTO), GN_OK);
    assert_int_equal(images[0][0], 0x99FF00BF);
    assert_int_equal(images[1][0], 0x00FF0000);
    t.color[0].format = GN_FORMAT_NONE;
    p = (gn_pipeline){.program.vertex_shader = cover_all};
    assert_int_equal(gn_pipeline_check(&p, &t), GN_NO_SHADER);
}

/* The two images, of SIDE columns and SIDE rows, hold the same pixels. */
static void assert_bytes_exchanged(uint16_t images[2][GN_SAMPLES * SIDE * SIDE])
{
    for (size_t i = 0; i < SIDE * SIDE; ++i) {
        const unsigned char *const exchanged = (const unsigned char *)&images[1][i];

        assert_int_equal(exchanged[0] << 8 | exchanged[1], images[0][i]);
    }
}

/* Clears, draws under states that replace, blend, mask and combine, blits to and from other
 * formats, resolves and reads back: RGB565_SWAPPED has the pixels of RGB565. */
static void swapped_pixels_are_those_of_rgb565(void **state)
{
    static const gn_format formats[2] = {GN_FORMAT_RGB565, GN_FORMAT_RGB565_SWAPPED};
    static uint16_t image[2][GN_SAMPLES * SIDE * SIDE], other[2][GN_SAMPLES * SIDE * SIDE];
    static uint32_t wide[2][SIDE * SIDE], colors[SIDE * SIDE];
    const gn_surface source = gn_surface_bottom_up(colors, GN_FORMAT_RGBA8, SIDE, SIDE);
    const gn_blit_options options[2] = {{0}, {.filter = GN_BLIT_LINEAR}};
    const gn_rectangle part = {1, 0, 6, 5};

    for (uint32_t i = 0; i < SIDE * SIDE; ++i)
        colors[i] = i * 0x9E3779B1u;
    for (uint32_t n = 0; n < 40; ++n) {
        const float mean[4] = {(float)n / 40.0f, 0.7f, (float)(n % 7) / 7.0f, 0.4f};
        gn_pipeline p = {0};

        p.color.blend[0].enabled = n % 4 == 1;
        p.color.blend[0].source = (gn_blend_factor)(1 + n % 15);
        p.color.blend[0].destination = (gn_blend_factor)(1 + n * 7 % 15);
        p.color.blend[0].equation = (gn_blend_equation)(n % 6);
        p.color.logic_enabled = n % 4 == 2;
        p.color.logic_operation = (gn_logic_operation)(n % 16);
        p.color.write_disabled[0] = n % 4 == 3 ? n % 8 : 0;
        for (int f = 0; f < 2; ++f) {
            const gn_surface s = gn_surface_bottom_up(image[f], formats[f], SIDE, SIDE);
            const gn_surface samples = gn_surface_multisampled(&s);
            const gn_surface to = gn_surface_bottom_up(other[f], formats[f], SIDE, SIDE);
            const gn_surface back = gn_surface_bottom_up(wide[f], GN_FORMAT_RGBA8, SIDE, SIDE);

            for (uint32_t i = 0; i < GN_SAMPLES; ++i) {
                const gn_surface one = gn_surface_sample(&samples, i);
                assert_int_equal(gn_clear_color(&one, 0.1f * (float)i, 0.5f, mean[0], 1), GN_OK);
            }
            assert_int_equal(gn_resolve(&to, &samples), GN_OK);
            assert_int_equal(gn_blit(&s, NULL, &source, NULL, NULL), GN_OK);
            cover(&s, &p, mean);
            assert_int_equal(gn_blit(&to, &part, &s, NULL, &options[n % 2]), GN_OK);
            assert_int_equal(gn_blit(&back, NULL, &s, NULL, NULL), GN_OK);
        }
        assert_bytes_exchanged(image);
        assert_bytes_exchanged(other);
        assert_memory_equal(wide[0], wide[1], sizeof wide[0]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clears_and_fragments_give_the_values_of_the_table),
        cmocka_unit_test(fragments_leave_what_is_beside_them),
        cmocka_unit_test(floats_round_toward_zero),
        cmocka_unit_test(pixels_are_aligned_to_their_element),
        cmocka_unit_test(blending_that_changes_nothing_gives_fragments),
        cmocka_unit_test(subtracting_what_was_added_gives_the_clear),
        cmocka_unit_test(alpha_that_is_not_there_is_one),
        cmocka_unit_test(logic_inverts_the_bits_of_integers),
        cmocka_unit_test(masks_keep_the_other_channels),
        cmocka_unit_test(each_attachment_has_its_color),
        cmocka_unit_test(attachments_beyond_the_count_stay),
        cmocka_unit_test(swapped_pixels_are_those_of_rgb565),
    };

    return cmocka_run_group_tests_name("formats", tests, NULL, NULL);
}
