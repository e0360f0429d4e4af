/* Properties of the table of members: every byte of a draw is in the table once, and every row is
 * written, read and simplified. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "packed_draw.h"
#include "random.h"
#include "random_inputs.h"
#include "scene_members.h"
#include "shrink.h"

/* Every byte of a draw but padding is in one row: no byte is in two rows, and the rows have as many
 * bytes as the members. */
static enum theft_trial_res has_every_byte(struct theft *t, void *argument)
{
    unsigned char times[sizeof(scene_draw)] = {0};
    size_t bytes = 0;
    (void)t;
    (void)argument;
    for (size_t i = 0; i < scene_member_count; ++i) {
        const scene_member *const m = &scene_members[i];
        const size_t size = scene_member_values(m) * scene_member_size(m);
        for (size_t line = 0; line < scene_member_lines(m); ++line)
            for (size_t b = 0; b < size; ++b)
                if (times[m->offset + line * m->stride + b]++) {
                    printf("%s: its bytes are in another row too\n", m->name);
                    return THEFT_TRIAL_FAIL;
                }
        bytes += scene_member_lines(m) * size;
    }
    const size_t textures = PACKED_DRAW_TEXTURES * sizeof(gn_texture);
    if (bytes - textures == packed_draw_size)
        return THEFT_TRIAL_PASS;
    printf("the table has %zu bytes of scene_draw beside textures, not %zu\n", bytes - textures,
           packed_draw_size);
    return THEFT_TRIAL_FAIL;
}

static void no_vertices(const void *uniforms, const gn_vertex_input *input,
                        gn_vertex_output *output)
{
    (void)uniforms;
    (void)input;
    (void)output;
}

static void no_fragments(const void *uniforms, const gn_fragment_input *input,
                         gn_fragment_output *output)
{
    (void)uniforms;
    (void)input;
    (void)output;
}

/* Returns what gn_pipeline_check returns for a value on a line, with every switch on. */
static gn_status status_with(const scene_member *m, size_t line, uint32_t value)
{
    scene_draw d;
    scene_default_draw(&d);
    d.state.program.vertex_shader = no_vertices;
    d.state.program.fragment_shader = no_fragments;
    d.state.program.varying_count = GN_MAX_VARYINGS;
    for (size_t i = 0; i < scene_member_count; ++i)
        for (size_t l = 0; l < scene_member_lines(&scene_members[i]); ++l)
            if (scene_members[i].type == MEMBER_SWITCH)
                scene_member_set(&scene_members[i], &d, l, 0, true);
    scene_member_set(m, &d, line, 0, value);
    return gn_pipeline_check(&d.state, NULL);
}

static uint32_t bits_of(float f)
{
    uint32_t bits;
    memcpy(&bits, &f, sizeof bits);
    return bits;
}

/* The library takes the least and the greatest value of every row of the state, and refuses the
 * next. */
static bool has_limits(const scene_member *m, size_t line)
{
    switch (m->type) {
    case MEMBER_NAMED: {
        const uint32_t values = (uint32_t)text_name_count(m->names);
        return !status_with(m, line, values - 1) && status_with(m, line, values) == GN_INVALID_ENUM;
    }
    case MEMBER_BYTE:
    case MEMBER_NUMBER:
        return !status_with(m, line, m->largest) &&
               (m->type == MEMBER_BYTE || m->largest == UINT32_MAX ||
                status_with(m, line, m->largest + 1) == GN_OUT_OF_RANGE);
    case MEMBER_FLOAT:
        return !status_with(m, line, bits_of(m->low)) && !status_with(m, line, bits_of(m->high)) &&
               status_with(m, line, bits_of(nextafterf(m->low, -INFINITY))) &&
               status_with(m, line, bits_of(nextafterf(m->high, INFINITY)));
    default:
        return true;
    }
}

static enum theft_trial_res have_limits(struct theft *t, void *argument)
{
    bool good = true;
    (void)t;
    (void)argument;
    for (size_t i = 0; i < scene_member_count; ++i) {
        const scene_member *const m = &scene_members[i];
        for (size_t line = 0; scene_member_is_state(m) && line < scene_member_lines(m); ++line)
            if (!has_limits(m, line)) {
                printf("%s, line %zu: the library has other limits\n", m->name, line);
                good = false;
            }
    }
    return verdict(good);
}

/* Returns any value that the text may hold. */
static uint32_t any_value(const scene_member *m, random_source *r)
{
    const uint32_t word = (uint32_t)(random_bits(r) >> 32);
    switch (m->type) {
    case MEMBER_SWITCH:
        return word & 1;
    case MEMBER_NAMED:
        return word % (uint32_t)text_name_count(m->names);
    case MEMBER_BYTE:
    case MEMBER_NUMBER:
        return m->largest == UINT32_MAX ? word : word % (m->largest + 1);
    default:
        return word;
    }
}

/* Returns a scene of one draw without vertices, in which some or all members have any value. */
static scene *any_members(uint64_t seed)
{
    random_source r = random_seed(seed);
    scene *const s = scene_create(4, 4, GN_FORMAT_RGBA8, GN_FORMAT_NONE);
    scene_draw *const d = scene_add_draw(s);
    const uint32_t percent = random_chance(&r, 50) ? 5 : 100;
    for (size_t i = 0; i < scene_member_count; ++i) {
        const scene_member *const m = &scene_members[i];
        for (size_t line = 0; line < scene_member_lines(m); ++line)
            for (size_t v = 0; v < scene_member_values(m); ++v)
                if (m->type != MEMBER_ELSEWHERE && random_chance(&r, percent))
                    scene_member_set(m, d, line, v, any_value(m, &r));
    }
    return s;
}

static scene *read_back(const scene *s, char *error, size_t error_size)
{
    scene *back = NULL;
    FILE *const text = tmpfile();
    if (text && scene_write(s, text)) {
        rewind(text);
        back = scene_read(text, error, error_size);
    }
    if (text)
        fclose(text);
    return back;
}

static enum theft_trial_res survive_text(struct theft *t, void *argument)
{
    char error[256] = "";
    scene *const s = any_members(*(uint64_t *)argument);
    scene *const back = read_back(s, error, sizeof error);
    (void)t;
    /* This memory holds members alone; everything else is zero on both sides. */
    const bool same = back && back->draw_count == 1 &&
                      memcmp(&s->draws[0], &back->draws[0], sizeof(scene_draw)) == 0;
    scene_free(s);
    scene_free(back);
    return verdict(same);
}

/* A line whose name or value has a wrong letter is a fault that names the line and the word. */
static enum theft_trial_res misspelt_is_named(struct theft *t, void *argument)
{
    random_source r = random_seed(*(uint64_t *)argument);
    const scene_member *m;
    char name[SCENE_MEMBER_NAME], error[256] = "", expected[128];
    FILE *const text = tmpfile();
    (void)t;
    if (!text)
        return THEFT_TRIAL_ERROR;
    do
        m = &scene_members[random_below(&r, (uint32_t)scene_member_count)];
    while (m->type == MEMBER_ELSEWHERE);
    const bool beyond = m->lines && random_chance(&r, 30), value = random_chance(&r, 50);
    scene_member_name(m, beyond ? m->lines : 0, name);
    if (!beyond && !value)
        name[random_below(&r, (uint32_t)strlen(name))] = '?';
    fprintf(text, "gnomon-scene 1\nsize 1 1\ncolor-format rgba8\ndraw unlit\n%s o?\n", name);
    rewind(text);
    scene *const s = scene_read(text, error, sizeof error);
    fclose(text);
    if (!beyond && value)
        snprintf(expected, sizeof expected, "'o?'");
    else
        snprintf(expected, sizeof expected, "'%s' is no keyword of a draw", name);
    const bool named = !s && strncmp(error, "line 5: ", 8) == 0 && strstr(error, expected);
    scene_free(s);
    return verdict(named);
}

/* A fault that appears as long as one value of one line is as it was planted. */
typedef struct planted {
    const scene_member *member;
    size_t line, value;
} planted;

static bool has_planted(const scene *s, void *context)
{
    const planted *const p = context;
    scene_draw by_default;
    scene_default_draw(&by_default);
    return s->draw_count == 1 && scene_member_get(p->member, &s->draws[0], p->line, p->value) !=
                                     scene_member_get(p->member, &by_default, p->line, p->value);
}

/* Whether every line but the planted one is at its default or simplest. */
static bool is_simple(const scene_draw *d, const planted *p)
{
    scene_draw by_default;
    scene_default_draw(&by_default);
    for (size_t i = 0; i < scene_member_count; ++i) {
        const scene_member *const m = &scene_members[i];
        for (size_t line = 0; line < scene_member_lines(m); ++line)
            for (size_t v = 0; v < scene_member_values(m); ++v) {
                const uint32_t value = scene_member_get(m, d, line, v);
                if (m->type != MEMBER_ELSEWHERE && value != m->simplest &&
                    value != scene_member_get(m, &by_default, line, v) &&
                    !(m == p->member && line == p->line))
                    return false;
            }
    }
    return true;
}

static enum theft_trial_res shrink_to_one(struct theft *t, void *argument)
{
    random_source r = random_seed(*(uint64_t *)argument);
    scene *const s = any_members(random_bits(&r));
    planted p;
    (void)t;
    do {
        p.member = &scene_members[random_below(&r, (uint32_t)scene_member_count)];
        p.line = random_below(&r, (uint32_t)scene_member_lines(p.member));
        p.value = random_below(&r, (uint32_t)scene_member_values(p.member));
    } while (p.member->type == MEMBER_ELSEWHERE);
    if (!has_planted(s, &p)) {
        scene_free(s);
        return THEFT_TRIAL_SKIP;
    }
    scene *const small = shrink_scene(s, has_planted, &p, 5000);
    const bool good = has_planted(small, &p) && is_simple(&small->draws[0], &p);
    scene_free(s);
    scene_free(small);
    return verdict(good);
}

static const property members[] = {
    DRAWING("the table of members has every byte of a draw once", has_every_byte, SEEDS, 1),
    DRAWING("members have the library's limits", have_limits, SEEDS, 1),
    DRAWING("any members survive being written", survive_text, SEEDS, 10),
    DRAWING("misspelt members and values are named", misspelt_is_named, SEEDS, 10),
    DRAWING("failing members shrink to one", shrink_to_one, SEEDS, 10),
};

SUITE(properties_members, members);
