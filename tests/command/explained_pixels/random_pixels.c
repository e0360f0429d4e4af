/* Explains random pixels of the scenes that parity generates, of every class, and of random states
 * of the web page: all shaders, filters, samples, polygon modes and conventions occur. For each
 * pixel explain_pixel compares the traced words with gn_draw's and evaluates every recorded
 * operation anew; here the report is checked for what every fragment must have. A random primitive
 * must be among the fragments, or the report must say why it is not. Prints "N passed, N failed".
 *
 *   explain-pixels [SEED [SCENES [STATES]]]    scenes of each class, states of the page */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../command_line.h"
#include "explain.h"
#include "camera.h"
#include "formula.h"
#include "generate.h"
#include "page.h"
#include "told.h"

static uint64_t random_state;

static uint32_t random_below(uint32_t n)
{
    random_state = random_state * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)((random_state >> 33) % n);
}

/* Makes of a scene one that can be explained, with formats of the page and the command. */
static void adapt(scene *s)
{
    s->color_format = GN_FORMAT_RGBA8;
    if (s->depth_format != GN_FORMAT_NONE && s->depth_format != GN_FORMAT_D24)
        s->depth_format = GN_FORMAT_D32F;
    for (int a = 0; a < GN_MAX_COLORS - 1; ++a)
        s->more_colors[a] = GN_FORMAT_NONE;
}

/* Returns whether a fragment's stages have a value of this name, or one that begins so. */
static bool has_value(const report_fragment *f, const char *wanted, bool is_beginning)
{
    const size_t length = strlen(wanted) + !is_beginning;
    const uint32_t range[2][2] = {{f->shared, f->shared_end}, {f->own, f->own_end}};

    for (int r = 0; r < 2; ++r) {
        for (uint32_t s = range[r][0]; s < range[r][1]; ++s) {
            for (uint32_t n = 0; n < told.stages[s].count; ++n) {
                const char *name = report_words(told.values[told.stages[s].first + n].name);

                if (strncmp(name, wanted, length) == 0)
                    return true;
            }
        }
    }
    return false;
}

/* Whether the value that has this name has this expression. */
static bool has_formula(const report_fragment *f, const char *name, const char *expression)
{
    for (uint32_t s = f->own; s < f->own_end; ++s) {
        for (uint32_t n = 0; n < told.stages[s].count; ++n) {
            const report_value *const v = &told.values[told.stages[s].first + n];

            if (strcmp(report_words(v->name), name) == 0)
                return strcmp(report_words(v->expression), expression) == 0;
        }
    }
    return true;
}

/* Whether a formula of the fragment has this name. */
static bool mentions(const report_fragment *f, const char *name)
{
    const uint32_t range[2][2] = {{f->shared, f->shared_end}, {f->own, f->own_end}};

    for (int r = 0; r < 2; ++r)
        for (uint32_t s = range[r][0]; s < range[r][1]; ++s)
            for (uint32_t n = 0; n < told.stages[s].count; ++n)
                if (strstr(report_words(told.values[told.stages[s].first + n].expression), name))
                    return true;
    return false;
}

/* Returns what a fragment lacks of what it must have, or null. */
static const char *missing(const scene *s, const explain_view *view, const report_fragment *f)
{
    static const char always[][20] = {"v1.clip.x",    "v1.clip.w",   "v1.one_over_w",
                                      "v1.ndc.z",     "v1.window.y", "v1.snapped.x",
                                      "depth.origin", "depth.per_x", "one_over_w.per_y"};
    static const char of_triangles[][24] = {"v3.position.x", "v2.snapped.y", "twice_the_area",
                                            "one_over_area"};
    const scene_draw *const d = &s->draws[f->draw];
    const bool is_triangle = strcmp(f->kind, "triangle") == 0;
    const bool is_written = strcmp(report_words(f->result), "written") == 0;

    for (size_t i = 0; i < sizeof always / sizeof always[0]; ++i)
        if (!has_value(f, always[i], false))
            return always[i];
    for (size_t i = 0; i < sizeof of_triangles / sizeof of_triangles[0]; ++i)
        if (is_triangle && !has_value(f, of_triangles[i], false))
            return of_triangles[i];
    if (scene_is_sampled(s) && f == &told.fragments[told.fragment_count - 1] &&
        !has_value(f, "resolved.red", false))
        return "the resolve";
    if (!has_formula(f, "depth", "depth.per_y * y + (depth.per_x * x + depth.origin)"))
        return "the formula of depth";
    if (!has_formula(f, "red",
                     "(red_over_w.per_y * y + (red_over_w.per_x * x + "
                     "red_over_w.origin)) * w") &&
        !scene_is_sampled(s) && d->state.program.interpolation[0] == GN_SMOOTH &&
        d->shader != SCENE_FLAT)
        return "the formula of red";
    if (view && (!has_value(f, "v1.world.x", false) || !has_value(f, "v1.view.z", false)))
        return "world and view coordinates";
    if (view && is_written && scene_shader_is_lit(d->shader) && d->shader != SCENE_NORMAL_COLOR &&
        (!mentions(f, "light.diffuse.x") || !mentions(f, "light.ambient.z")))
        return "the light";
    if (view && is_triangle && is_written && d->shader != SCENE_DEPTH_COLOR &&
        (scene_draw_has_texture(d) || scene_draw_has_map(d, SCENE_NORMAL_MAP)) &&
        !has_value(f, scene_draw_has_texture(d) ? "diffuse_map.red" : "normal_map.red", true))
        return "a texel";
    if (is_triangle && !scene_is_sampled(s) && !has_value(f, "barycentric.", true))
        return "barycentric";
    if (!is_written || d->shader == SCENE_DEPTH_ONLY)
        return NULL;
    if (!has_value(f, "shaded.red", true))
        return "shaded.red";
    return has_value(f, "word", true) ? NULL : "word";
}

/* Computes all formulas of a fragment from the values that they name, as a reader would. Returns
 * what is wrong with the first wrong one, or null. */
static const char *wrong_formula(const report_fragment *f, unsigned *count)
{
    static char words[700];
    const uint32_t first = told.stages[f->shared].first;
    const uint32_t range[2][2] = {{f->shared, f->shared_end}, {f->own, f->own_end}};

    for (int r = 0; r < 2; ++r) {
        for (uint32_t s = range[r][0]; s < range[r][1]; ++s) {
            for (uint32_t n = 0; n < told.stages[s].count; ++n) {
                const report_value *const v = &told.values[told.stages[s].first + n];

                if (!v->is_computed)
                    continue;
                const char *const fault = formula_fault(first, told.stages[s].first + n);

                ++*count;
                if (fault) {
                    snprintf(words, sizeof words, "%s: %s", report_words(v->name), fault);
                    return words;
                }
            }
        }
    }
    return NULL;
}

static unsigned formulas, passed, failed, fragments, unexplained, missing_primitives;

/* What is explained, for messages. */
static char subject[512];

static void fail(uint32_t x, uint32_t y, const char *why, const char *more)
{
    printf("%s, pixel %u,%u from the bottom: %s%s\n", subject, (unsigned)x, (unsigned)y, why, more);
    ++failed;
}

/* Chooses a primitive of a scene. Returns false if the draw that was chosen has none. */
static bool choose_primitive(const scene *s, explain_primitive *chosen)
{
    if (s->draw_count == 0)
        return false;
    chosen->draw = random_below((uint32_t)s->draw_count);
    const uint32_t count = explain_primitives(&s->draws[chosen->draw]);

    chosen->primitive = count ? random_below(count) : 0;
    return count != 0;
}

/* Returns what is wrong with what is told of the primitive that was asked for, or null. It is
 * either among the fragments or missing with a reason. */
static const char *wrong_missing(const explain_primitive *asked)
{
    bool is_found = false;

    for (uint32_t i = 0; i < told.fragment_count; ++i)
        is_found |= told.fragments[i].draw == asked->draw &&
                    told.fragments[i].primitive == asked->primitive;
    if (is_found == told.has_missing)
        return is_found ? "it is told twice" : "it is not told";
    if (is_found)
        return NULL;
    ++missing_primitives;
    if (told.missing.draw != asked->draw || told.missing.primitive != asked->primitive)
        return "another one is told";
    if (strlen(report_words(told.missing.result)) < 20)
        return "it has no reason";
    return has_value(&told.missing, "v1.clip.w", false) ? NULL : "its vertices are not told";
}

/* Whether pictures of a scene can be explained: all draws have shaders of the library, and are
 * lists of triangles, lines or points, drawn once. */
static bool is_explainable(const scene *s)
{
    for (size_t i = 0; i < s->draw_count; ++i) {
        const scene_draw *const d = &s->draws[i];
        const gn_topology topology = d->state.raster.topology;
        const bool is_list =
            topology == GN_TRIANGLES || topology == GN_LINES || topology == GN_POINTS;
        const bool is_users = d->shader == SCENE_PHONG || d->shader == SCENE_INPUTS ||
                              d->shader == SCENE_DERIVATIVES || d->shader == SCENE_OUTPUTS ||
                              d->shader == SCENE_SAMPLED;

        if (is_users || !is_list || d->mesh.instance_count > 1 ||
            d->mesh.restart != GN_RESTART_NONE)
            return false;
    }
    return true;
}

static void check_pixel(const scene *s, const explain_view *view, uint32_t x, uint32_t y)
{
    prose json = {0};
    explained e;
    explain_primitive asked;
    const bool asks = choose_primitive(s, &asked);
    const char *const fault = explain_pixel(s, x, y, view, asks ? &asked : NULL, &e);

    if (!is_explainable(s)) {
        ++unexplained;
        if (!fault || !strstr(fault, "only"))
            fail(x, y, "a scene that cannot be explained is not refused: ", fault ? fault : "");
        return;
    }
    if (fault) {
        fail(x, y, fault, "");
        return;
    }
    if (e.faults || e.word != e.drawn_word) {
        fail(x, y, prose_of(&told.fault), e.faults ? "" : "another word");
        return;
    }
    for (uint32_t i = 0; i < told.fragment_count; ++i) {
        const char *const lacks = missing(s, view, &told.fragments[i]);

        if (lacks) {
            fail(x, y, "a fragment lacks ", lacks);
            return;
        }
        /* The formulas of random scenes have operations that the page does not need. */
        const char *const wrong = view ? wrong_formula(&told.fragments[i], &formulas) : NULL;
        if (wrong) {
            fail(x, y, "a formula: ", wrong);
            return;
        }
    }
    const char *const wrong = asks ? wrong_missing(&asked) : NULL;
    if (wrong) {
        fail(x, y, "the primitive that is asked for: ", wrong);
        return;
    }
    explain_json(&e, &json);
    if (json.failed || json.length < 100)
        fail(x, y, "no JSON", "");
    prose_free(&json);
    fragments += e.fragments;
    ++passed;
}

static void check_scene(uint64_t seed, scene_class c, uint64_t number)
{
    scene *const s = generate_scene(seed, c, number);

    random_state = seed * 1000003 + (uint64_t)c * 1009 + number;
    snprintf(subject, sizeof subject, "%s %" PRIu64, scene_class_name(c), number);
    adapt(s);
    for (int i = 0; i < 3; ++i) {
        const uint32_t x = random_below(s->width), y = random_below(s->height);

        check_pixel(s, NULL, x, y);
    }
    scene_free(s);
}

/* Adds "&key=value", with one of the values, to a state. */
static void add_choice(char *state, size_t size, const char *key, const char *const *values,
                       uint32_t count)
{
    const size_t length = strlen(state);

    snprintf(state + length, size - length, "%s%s=%s", length ? "&" : "", key,
             values[random_below(count)]);
}

#define ADD(key, ...)                                                                              \
    do {                                                                                           \
        static const char *const values[] = {__VA_ARGS__};                                         \
        add_choice(subject, sizeof subject, key, values, sizeof values / sizeof values[0]);        \
    } while (0)

/* A random state of the page; eyes that are near make triangles cross the view volume. */
static void choose_state(void)
{
    subject[0] = '\0';
    ADD("model", "teapot", "triangle", "square", "cube", "cube");
    ADD("size", "40x30", "33x27", "64x64");
    ADD("shader", "vertex-color", "unlit", "flat", "gouraud", "toon", "phong", "blinn-phong",
        "normals", "depth");
    ADD("maps", "on", "on", "off");
    ADD("filter", "nearest", "linear", "mipmap");
    ADD("samples", "1", "1", "4");
    ADD("polygons", "fill", "fill", "fill", "line", "point");
    ADD("cull", "none", "none", "back", "front");
    ADD("convention", "opengl", "direct3d", "vulkan");
    if (random_below(3) == 0)
        ADD("eye", "0.3,0.2,1.1", "1.5,0.4,0.9", "-2,1,3");
    if (strstr(subject, "phong") || strstr(subject, "toon"))
        ADD("shadows", "on", "off");
}

static void check_state(uint64_t seed, uint64_t number)
{
    random_state = seed * 1000033 + number;
    choose_state();
    if (page_set_state(subject) != 0 || page_build() != 0) {
        fail(0, 0, "the page has no such state: ", page_message());
        return;
    }
    const camera *const c = page_camera();
    const explain_view view = {true, c->y_down, c->view_from_world};
    const scene *const s = page_scene();

    for (int i = 0; i < 4; ++i) {
        const uint32_t x = random_below(s->width), y = random_below(s->height);

        check_pixel(s, &view, x, y);
    }
}

int main(int argc, char **argv)
{
    uint64_t number_of[] = {1, 10, 100};
    static const char *const name[] = {"SEED", "SCENES", "STATES"};

    for (int i = 1; i < argc; ++i) {
        if (i > 3) {
            fputs("usage: explain-pixels [SEED [SCENES [STATES]]]\n", stderr);
            return 2;
        }
        if (!option_number("explain-pixels", name[i - 1], argv[i], 0, UINT64_MAX,
                           &number_of[i - 1]))
            return 2;
    }
    const uint64_t seed = number_of[0], scenes = number_of[1], states = number_of[2];

    for (int c = 0; c < CLASS_COUNT; ++c)
        for (uint64_t number = 0; number < scenes; ++number)
            check_scene(seed, (scene_class)c, number);
    for (uint64_t number = 0; number < states; ++number)
        check_state(seed, number);
    explain_free();
    printf("%u fragments, %u formulas, %u primitives without a fragment; %u pixels of scenes that "
           "cannot be explained\n",
           fragments, formulas, missing_primitives, unexplained);
    if (fragments < passed / 4) {
        printf("hardly any pixel is covered\n");
        ++failed;
    }
    if (unexplained > passed) { /* measured: half as many */
        printf("hardly any pixel is explained\n");
        ++failed;
    }
    printf("%u passed, %u failed\n", passed, failed);
    return failed ? 1 : 0;
}
