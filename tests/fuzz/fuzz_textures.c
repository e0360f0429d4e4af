/* Textures, samplers and lookups of any numbers: every back end reads the same texels, and none
 * reads beyond a level's memory. Generated levels and packed textures keep to their memory too. */
#include <stdlib.h>
#include <string.h>

#include "../../src/texture/lookup_state.h"
#include "../unit/public_lookups.h"
#include "texture_input.h"

#include "../../src/backends/entry_points.h"

typedef struct lookups {
    float coordinate[3][GN_LANES], reference[GN_LANES], lod[GN_LANES];
    float gradient_x[3][GN_LANES], gradient_y[3][GN_LANES];
    int32_t place[3][GN_LANES], level[GN_LANES];
    gn_lookup lookup;
    bool has_level;
    int channel;
} lookups;

/* Fills sixteen lanes: numbers near each other, so that quads have a level of detail, or any. */
static void fill_lanes(fuzz_input *in, float lanes[GN_LANES])
{
    const uint8_t kind = fuzz_byte(in);
    const float start = kind & 1 ? fuzz_float(in) : fuzz_tame(in);
    const float step_x = kind & 2 ? fuzz_float(in) : fuzz_tame(in) * 0.0625f;
    const float step_y = kind & 4 ? fuzz_float(in) : fuzz_tame(in) * 0.0625f;

    for (int l = 0; l < GN_LANES; ++l)
        lanes[l] = start + step_x * (float)(l % 4 + l / 8 * 4) + step_y * (float)(l / 4 % 2);
    for (int i = kind >> 4; i > 0; --i) {
        const uint32_t lane = fuzz_below(in, GN_LANES);

        lanes[lane] = fuzz_float(in);
    }
}

static void fill_numbers(fuzz_input *in, int32_t lanes[GN_LANES])
{
    const uint8_t kind = fuzz_byte(in);
    const int32_t start = kind & 1 ? (int32_t)fuzz_word(in) : (int32_t)fuzz_below(in, 20) - 2;

    for (int l = 0; l < GN_LANES; ++l)
        lanes[l] = (int32_t)((uint32_t)start + (uint32_t)l * (kind >> 1 & 3));
}

static void make_lookups(fuzz_input *in, lookups *u)
{
    const uint8_t kind = fuzz_byte(in);

    memset(u, 0, sizeof *u);
    for (int i = 0; i < 3; ++i) {
        fill_lanes(in, u->coordinate[i]);
        u->lookup.coordinate[i] = u->coordinate[i];
        u->lookup.gradient_x[i] = u->gradient_x[i];
        u->lookup.gradient_y[i] = u->gradient_y[i];
    }
    u->lookup.lod_source = (gn_lod_source)(kind % 3);
    u->channel = kind >> 2 & 3;
    if (kind & 16) {
        fill_lanes(in, u->lod);
        u->lookup.lod = u->lod;
    }
    if (kind & 32) {
        fill_lanes(in, u->reference);
        u->lookup.reference = u->reference;
    }
    for (int i = 0; i < 3 && u->lookup.lod_source == GN_LOD_GRADIENTS; ++i) {
        fill_lanes(in, u->gradient_x[i]);
        fill_lanes(in, u->gradient_y[i]);
    }
    for (int i = 0; i < 3 && kind & 64; ++i)
        fill_numbers(in, u->place[i]);
    u->has_level = kind & 128;
    if (u->has_level)
        fill_numbers(in, u->level);
}

enum { SAMPLE, GATHER, FETCH, SAMPLE_2D, WAYS };

static void lookup_once(const gn_texture_functions *f, const texture_input *t, const lookups *u,
                        int way, float texel[4][GN_LANES])
{
    const int32_t *const place[3] = {u->place[0], u->place[1], u->place[2]};

    memset(texel, 0x5A, 4 * sizeof *texel);
    if (way == SAMPLE)
        f->lookup(f->memory, &t->texture, &t->sampler, &u->lookup, texel);
    else if (way == GATHER)
        f->gather(f->memory, &t->texture, &t->sampler, &u->lookup, u->channel, texel);
    else if (way == FETCH)
        f->fetch(f->memory, &t->texture, place, u->has_level ? u->level : NULL, texel);
    else
        f->lookup_2d(f->memory, &t->texture, &t->sampler, u->coordinate[0], u->coordinate[1],
                     texel);
}

static void require_equal(const float a[4][GN_LANES], const float b[4][GN_LANES])
{
    for (int c = 0; c < 4; ++c)
        for (int l = 0; l < GN_LANES; ++l)
            FUZZ_REQUIRE(fuzz_same_float(a[c][l], b[c][l]));
}

/* The functions of a back end that this processor has, or null. */
static const gn_texture_functions *sampling_of(gn_backend backend, shading_functions *f)
{
    static const gn_pipeline no_shaders;

    if (!gn_backend_available(backend))
        return NULL;
    shading_on(backend, &no_shaders, f);
    return &f->texture_functions;
}

static bool can(const texture_input *t, int way)
{
    const gn_texture_target target = t->texture.target;

    return way == SAMPLE || way == FETCH || (way == SAMPLE_2D && target == GN_TEXTURE_2D) ||
           (way == GATHER && target != GN_TEXTURE_1D && target != GN_TEXTURE_3D);
}

static void lookup_everywhere(const texture_input *t, const lookups *u)
{
    float expected[4][GN_LANES], texel[4][GN_LANES], one[4];
    static lookup_state states[2];
    gn_lookup_memory memory;

    for (int way = 0; way < WAYS; ++way) {
        if (!can(t, way))
            continue;
        lookup_once(&public_lookups, t, u, way, expected);
        for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b) {
            shading_functions f;
            const gn_texture_functions *const of_backend = sampling_of((gn_backend)b, &f);

            if (!of_backend)
                continue;
            start_lookup_memory(&memory, states, 2);
            f.texture_functions.memory = &memory;
            lookup_once(of_backend, t, u, way, texel);
            require_equal((const float(*)[GN_LANES])expected, (const float(*)[GN_LANES])texel);
        }
    }

    /* One place with a level of its own is sixteen equal places. */
    lookups same = *u;

    same.lookup.lod_source = GN_LOD_EXPLICIT;
    same.lookup.lod = same.lod;
    same.lookup.reference = same.reference;
    for (int l = 0; l < GN_LANES; ++l) {
        for (int i = 0; i < 3; ++i)
            same.coordinate[i][l] = u->coordinate[i][0];
        same.lod[l] = u->lod[0];
        same.reference[l] = u->reference[0];
    }
    for (int i = 0; i < 3; ++i)
        same.lookup.coordinate[i] = same.coordinate[i];
    gn_texture_lookup(&t->texture, &t->sampler, &same.lookup, expected);
    gn_texture_lookup_at(
        &t->texture, &t->sampler,
        (const float[3]){same.coordinate[0][0], same.coordinate[1][0], same.coordinate[2][0]},
        same.lod[0], same.reference[0], one);
    for (int c = 0; c < 4; ++c)
        FUZZ_REQUIRE(fuzz_same_float(one[c], expected[c][0]));
}

/* Levels go to memory of exactly the size that the contract asks for; with a byte less, nothing is
 * written. */
static void generate(fuzz_input *in, const texture_input *t)
{
    gn_texture made = t->texture, kept;
    const size_t one =
        gn_texture_memory_size(made.target, made.format, made.width, made.height, made.depth, 1);
    uint32_t levels = 1;

    while (made.width >> levels || made.height >> levels ||
           (made.target == GN_TEXTURE_3D && made.depth >> levels))
        ++levels;
    const size_t size = gn_texture_memory_size(made.target, made.format, made.width, made.height,
                                               made.depth, levels) -
                        one;
    const size_t given = fuzz_rarely(in, 16) && size ? size - 1 : size;
    unsigned char *const memory = fuzz_memory(given);

    if (memory)
        memset(memory, 0x5A, given);
    kept = made;
    const gn_status status = gn_texture_generate_levels(&made, memory, given);

    if (status != GN_OK) {
        FUZZ_REQUIRE(memcmp(&made, &kept, sizeof made) == 0);
        for (size_t i = 0; i < given; ++i)
            FUZZ_REQUIRE(memory[i] == 0x5A);
    } else {
        FUZZ_REQUIRE(given == size && gn_texture_check(&made) == GN_OK);
        FUZZ_REQUIRE(made.level_count == levels);
    }
    free(memory);
}

static void pack(const gn_texture *t)
{
    static const uint64_t aligned[1];
    gn_texture packed = {0};
    const gn_texture untouched = packed;
    const gn_status status = gn_texture_packed(t->target, t->format, t->width, t->height, t->depth,
                                               t->level_count, aligned, &packed);

    if (status != GN_OK)
        FUZZ_REQUIRE(memcmp(&packed, &untouched, sizeof packed) == 0);
    else
        FUZZ_REQUIRE(gn_texture_check(&packed) == GN_OK);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    fuzz_input in = fuzz_begin(bytes, size);
    texture_input t;
    lookups u;

    if (!texture_make(&in, 20, &t))
        return -1;
    const gn_status status = gn_texture_check(&t.texture);

    FUZZ_REQUIRE(status >= GN_OK && status < GN_STATUS_COUNT);
    FUZZ_REQUIRE((status == GN_OK) == (gn_texture_fault(&t.texture) == NULL));
    FUZZ_REQUIRE((gn_sampler_check(&t.sampler) == GN_OK) == (gn_sampler_fault(&t.sampler) == NULL));
    pack(&t.texture);
    if (status == GN_OK) {
        if (gn_sampler_check(&t.sampler) == GN_OK) {
            make_lookups(&in, &u);
            lookup_everywhere(&t, &u);
        }
        generate(&in, &t);
    }
    texture_free(&t);
    return 0;
}
