/* Properties over the random scenes of the parity gate, without a reference: a picture depends only
 * on the scene, not on memory, workspace or rows; scenes survive being written; failing scenes
 * shrink. And of the table of members: every byte of a draw is in it once, and every row is
 * written, read and simplified. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "generate.h"
#include "packed_draw.h"
#include "random.h"
#include "random_inputs.h"
#include "scene_members.h"
#include "shrink.h"

typedef struct instance {
    scene_class class;
    uint64_t number;
    uint64_t choice; /* what a property needs besides the scene */
} instance;

static enum theft_alloc_res make_instance(struct theft *t, void *env, void **output)
{
    instance *const i = *output = allocated(sizeof *i);
    (void)env;
    i->class = (scene_class)theft_random_choice(t, CLASS_COUNT);
    i->number = theft_random_bits(t, 20);
    i->choice = theft_random_bits(t, 16);
    return THEFT_ALLOC_OK;
}

static void print_instance(FILE *f, const void *argument, void *env)
{
    const instance *i = argument;
    (void)env;
    fprintf(f, "%s scene %" PRIu64 " of seed 0, choice %" PRIu64 "\n", scene_class_name(i->class),
            i->number, i->choice);
}

static scene *scene_of(const instance *i)
{
    return generate_scene(0, i->class, i->number);
}

static scene_frame frame_of(const scene *s)
{
    scene_frame frame;
    if (!scene_frame_allocate(&frame, s)) {
        fprintf(stderr, "properties: out of memory\n");
        exit(EXIT_FAILURE);
    }
    return frame;
}

/* Draws both scenes, each in its workspace, and compares the bits. */
static bool same_picture(const scene *a, size_t workspace_a, const scene *b, size_t workspace_b)
{
    scene_frame frame_a = frame_of(a), frame_b = frame_of(b);
    const bool same = scene_draw_library(a, &frame_a, workspace_a, GN_BACKEND_AUTO) == GN_OK &&
                      scene_draw_library(b, &frame_b, workspace_b, GN_BACKEND_AUTO) == GN_OK &&
                      scene_compare(a, &frame_a, &frame_b).pixels == 0;
    scene_frame_free(&frame_a);
    scene_frame_free(&frame_b);
    return same;
}

static enum theft_trial_res any_workspace(struct theft *t, void *argument)
{
    const instance *i = argument;
    scene *s = scene_of(i);
    (void)t;
    const size_t least = gn_workspace_size(0, scene_varyings(s));
    const bool same = same_picture(s, 0, s, least + (i->choice & 3 ? i->choice : 0));
    scene_free(s);
    return verdict(same);
}

static scene *read_back(const scene *s)
{
    char error[256];
    scene *back = NULL;
    FILE *const text = tmpfile();
    if (text && scene_write(s, text)) {
        rewind(text);
        back = scene_read(text, error, sizeof error);
    }
    if (text)
        fclose(text);
    return back;
}

static enum theft_trial_res survives_text(struct theft *t, void *argument)
{
    scene *const s = scene_of(argument), *const back = read_back(s);
    (void)t;
    const bool same = back && scene_triangle_count(s) == scene_triangle_count(back) &&
                      same_picture(s, 0, back, 0);
    scene_free(s);
    scene_free(back);
    return verdict(same);
}

static gn_surface top_down(const scene *s, void *memory, gn_format format)
{
    const gn_surface image = gn_surface_top_down(memory, format, s->width, s->height);
    return scene_is_sampled(s) ? gn_surface_multisampled(&image) : image;
}

/* A scene drawn into surfaces whose first row in memory is the top row. */
static bool draw_top_down(const scene *s, scene_frame *frame)
{
    gn_target target;
    memset(&target, 0, sizeof target);
    for (int a = 0; a < GN_MAX_COLORS; ++a)
        if (scene_color_format(s, a) != GN_FORMAT_NONE)
            target.color[a] = top_down(s, scene_frame_color(frame, a), scene_color_format(s, a));
    if (s->depth_format != GN_FORMAT_NONE)
        target.depth = top_down(s, frame->depth, s->depth_format);
    const size_t size = scene_workspace_size(s);
    gn_workspace workspace = {.memory = malloc(size), .size = size};
    const bool good = workspace.memory && scene_draw_to_target(s, &target, &workspace) == GN_OK;
    free(workspace.memory);
    return good;
}

/* For the image of every sample. */
static bool rows_reversed(const scene *s, const void *a, const void *b, gn_format format)
{
    const size_t row = s->width * gn_format_size(format);
    const uint32_t images = scene_is_sampled(s) ? GN_SAMPLES : 1;
    for (uint32_t y = 0; y < images * s->height && row > 0; ++y) {
        const uint32_t image = y / s->height * s->height;
        const uint32_t mirrored = image + s->height - 1 - y % s->height;
        if (memcmp((const char *)a + row * y, (const char *)b + row * mirrored, row) != 0)
            return false;
    }
    return true;
}

static bool colors_reversed(const scene *s, const scene_frame *up, const scene_frame *down)
{
    bool reversed = true;
    for (int a = 0; a < GN_MAX_COLORS; ++a)
        reversed = reversed && rows_reversed(s, scene_frame_color(up, a),
                                             scene_frame_color(down, a), scene_color_format(s, a));
    return reversed;
}

static enum theft_trial_res rows_either_way(struct theft *t, void *argument)
{
    scene *s = scene_of(argument);
    scene_frame up = frame_of(s), down = frame_of(s);
    (void)t;
    const bool same = scene_draw_library(s, &up, 0, GN_BACKEND_AUTO) == GN_OK &&
                      draw_top_down(s, &down) && colors_reversed(s, &up, &down) &&
                      rows_reversed(s, up.depth, down.depth, s->depth_format);
    scene_frame_free(&up);
    scene_frame_free(&down);
    scene_free(s);
    return verdict(same);
}

/* Members. */

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

/* Returns what gn_pipeline_check returns for a value on a line, with every switch on. */
static gn_status status_with(const scene_member *m, size_t line, uint32_t value)
{
    static const gn_color_uniforms uniforms;
    scene_draw d;
    scene_default_draw(&d);
    gn_use_vertex_color(&d.state, &uniforms);
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

/* Gives some or all members of a draw any value. */
static void any_members(scene_draw *d, random_source *r)
{
    const uint32_t percent = random_chance(r, 50) ? 5 : 100;
    for (size_t i = 0; i < scene_member_count; ++i) {
        const scene_member *const m = &scene_members[i];
        for (size_t line = 0; line < scene_member_lines(m); ++line)
            for (size_t v = 0; v < scene_member_values(m); ++v)
                if (m->type != MEMBER_ELSEWHERE && random_chance(r, percent))
                    scene_member_set(m, d, line, v, any_value(m, r));
    }
}

static enum theft_trial_res survive_text(struct theft *t, void *argument)
{
    random_source r = random_seed(*(uint64_t *)argument);
    scene *const s = scene_create(4, 4, GN_FORMAT_RGBA8, GN_FORMAT_NONE);
    (void)t;
    any_members(scene_add_draw(s), &r);
    scene *const back = read_back(s);
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
        return THEFT_TRIAL_FAIL;
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

/* A fault that appears as long as one value of one line of some draw is as it was planted. */
typedef struct planted {
    const scene_member *member;
    size_t line, value;
} planted;

static bool has_planted(const scene *s, void *context)
{
    const planted *const p = context;
    scene_draw by_default;
    scene_default_draw(&by_default);
    for (size_t i = 0; i < s->draw_count; ++i)
        if (scene_member_get(p->member, &s->draws[i], p->line, p->value) !=
            scene_member_get(p->member, &by_default, p->line, p->value))
            return true;
    return false;
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

/* A random scene with any values of members in one draw; for the topology or a member of the mesh a
 * scene without triangles, since those decide how many triangles there are. Null if the draw lacks
 * what was planted: states that exclude each other. */
static scene *plant(random_source *r, planted *p)
{
    const scene_class class = (scene_class)random_below(r, CLASS_COUNT);
    scene *s;

    do {
        p->member = &scene_members[random_below(r, (uint32_t)scene_member_count)];
        p->line = random_below(r, (uint32_t)scene_member_lines(p->member));
        p->value = random_below(r, (uint32_t)scene_member_values(p->member));
    } while (p->member->type == MEMBER_ELSEWHERE);
    if (scene_member_is_state(p->member) && strcmp(p->member->name, "raster.topology") != 0)
        s = generate_scene(0, class, random_bits(r));
    else
        s = scene_create(4, 4, GN_FORMAT_RGBA8, GN_FORMAT_NONE);
    if (s->draw_count == 0) /* a scene of blits and clears, too */
        scene_add_draw(s);
    any_members(&s->draws[random_below(r, (uint32_t)s->draw_count)], r);
    if (has_planted(s, p))
        return s;
    scene_free(s);
    return NULL;
}

static enum theft_trial_res shrink_to_one(struct theft *t, void *argument)
{
    random_source r = random_seed(*(uint64_t *)argument);
    planted p;
    scene *s = NULL;

    (void)t;
    for (int tries = 0; !s && tries < 16; ++tries)
        s = plant(&r, &p);
    if (!s)
        return THEFT_TRIAL_SKIP;
    scene *const small = shrink_scene(s, has_planted, &p, 5000);
    const bool good = has_planted(small, &p) && small->draw_count == 1 &&
                      scene_triangle_count(small) <= 1 && is_simple(&small->draws[0], &p);
    scene_free(s);
    scene_free(small);
    return verdict(good);
}

#define INSTANCE INSTANCES(make_instance, print_instance, NULL)

static const property scenes[] = {
    DRAWING("any workspace gives the same picture", any_workspace, INSTANCE, 10),
    DRAWING("top-down surfaces hold the same picture", rows_either_way, INSTANCE, 10),
    DRAWING("a scene survives being written", survives_text, INSTANCE, 10),
    DRAWING("the table of members has every byte of a draw once", has_every_byte, SEEDS, 1),
    DRAWING("members have the library's limits", have_limits, SEEDS, 1),
    DRAWING("any members survive being written", survive_text, SEEDS, 10),
    DRAWING("misspelt members and values are named", misspelt_is_named, SEEDS, 10),
    DRAWING("failing scenes shrink to one triangle and one member", shrink_to_one, SEEDS, 5),
};

SUITE(properties_scenes, scenes);
