/* Scenes from text. */
#include "scene.h"

#include <ctype.h>
#include <errno.h>
#include <inttypes.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "scene_memory.h"
#include "scene_text.h"

/* A reader stops at the first fault: from then on every token is empty. */
typedef struct reader {
    FILE *in;
    unsigned long line;
    char token[64];
    bool failed;
    char *error;
    size_t error_size;
} reader;

static void fail(reader *r, const char *format, ...)
{
    if (!r->failed && r->error_size) {
        const int used = snprintf(r->error, r->error_size, "line %lu: ", r->line);
        va_list arguments;

        va_start(arguments, format);
        if (used >= 0 && (size_t)used < r->error_size) {
            vsnprintf(r->error + used, r->error_size - (size_t)used, format, arguments);
        }
        va_end(arguments);
    }
    r->failed = true;
    r->token[0] = '\0';
}

/* The next token, "" at the end of the input or after a fault. */
static const char *next(reader *r)
{
    size_t length = 0;
    int c = ' ';

    if (r->failed) {
        return "";
    }
    while (c == '#' || isspace(c)) {
        while (c == '#' && (c = getc(r->in)) != '\n' && c != EOF) {
            c = '#';
        }
        r->line += c == '\n';
        if (c != EOF) {
            c = getc(r->in);
        }
    }
    while (c != EOF && !isspace(c) && c != '#') {
        if (length + 1 == sizeof r->token) {
            fail(r, "a word of more than %zu characters", sizeof r->token - 1);
            return "";
        }
        r->token[length++] = (char)c;
        c = getc(r->in);
    }
    if (c != EOF) {
        ungetc(c, r->in);
    }
    r->token[length] = '\0';
    return r->token;
}

static uint32_t read_number(reader *r, int base, uint32_t largest)
{
    const char *text = next(r);
    unsigned long long value;
    char *end;

    errno = 0;
    value = strtoull(text, &end, base);
    if (!isxdigit((unsigned char)*text) || *end || errno || value > largest) {
        fail(r, "a number from 0 to %" PRIu32 " expected, not '%s'", largest, text);
        return 0;
    }
    return (uint32_t)value;
}

static int32_t read_integer(reader *r)
{
    const char *text = next(r);
    long long value;
    char *end;

    errno = 0;
    value = strtoll(text, &end, 10);
    if (end == text || *end || errno || value < INT32_MIN || value > INT32_MAX) {
        fail(r, "an integer of 32 bits expected, not '%s'", text);
        return 0;
    }
    return (int32_t)value;
}

static int read_name(reader *r, text_names set)
{
    const char *text = next(r);
    const int value = text_value(set, text);

    if (value < 0) {
        fail(r, "'%s' is none of the values here, such as %s", text, text_name(set, 0));
        return 0;
    }
    return value;
}

static float read_float(reader *r)
{
    const char *text = next(r);
    char *end;
    float f;

    if (!strncmp(text, "nan:", 4)) {
        const uint32_t bits = (uint32_t)strtoul(text + 4, &end, 16);

        if (end == text + 12 && !*end) {
            memcpy(&f, &bits, sizeof f);
            return f;
        }
    } else {
        f = strtof(text, &end);
        if (end != text && !*end) {
            return f;
        }
    }
    fail(r, "a number expected, not '%s'", text);
    return 0.0f;
}

static void read_floats(reader *r, float *values, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        values[i] = read_float(r);
    }
}

static gn_vec3 read_vec3(reader *r)
{
    gn_vec3 v;

    v.x = read_float(r);
    v.y = read_float(r);
    v.z = read_float(r);
    return v;
}

/* count words, each by READ; memory grows with what is there, not with what is promised. */
static uint32_t *read_words(reader *r, size_t count, uint32_t (*read)(reader *r))
{
    size_t capacity = 0;
    uint32_t *words = scene_allocate(1, sizeof *words);

    for (size_t i = 0; i < count && !r->failed; ++i) {
        if (i == capacity) {
            capacity = capacity ? 2 * capacity : 64;
            capacity = capacity < count ? capacity : count;
            words = scene_reallocate(words, capacity, sizeof *words);
        }
        words[i] = read(r);
    }
    return words;
}

static uint32_t read_float_word(reader *r)
{
    const float f = read_float(r);
    uint32_t bits;

    memcpy(&bits, &f, sizeof bits);
    return bits;
}

static uint32_t read_hexadecimal_word(reader *r)
{
    return read_number(r, 16, UINT32_MAX);
}

static uint32_t read_decimal_word(reader *r)
{
    return read_number(r, 10, UINT32_MAX);
}

static void read_attribute(reader *r, scene_draw *d, int attribute)
{
    const uint32_t components = read_number(r, 10, 4);
    const size_t count = (size_t)components * d->mesh.vertex_count;
    uint32_t *words;

    if (components == 0) {
        fail(r, "an attribute has 1 to 4 components");
        return;
    }
    words = read_words(r, count, read_float_word);
    if (!r->failed) {
        scene_set_attribute(d, (gn_shader_attribute)attribute, (const float *)(const void *)words,
                            components, d->mesh.vertex_count);
    }
    free(words);
}

static void read_indices(reader *r, scene_draw *d)
{
    const gn_index_format format = (gn_index_format)read_name(r, TEXT_INDEX);
    const uint32_t count = read_number(r, 10, UINT32_MAX);
    uint32_t *words = read_words(r, count, read_decimal_word);
    const uint32_t largest = format == GN_INDEX_UINT8    ? UINT8_MAX
                             : format == GN_INDEX_UINT16 ? UINT16_MAX
                                                         : UINT32_MAX;

    for (uint32_t i = 0; i < count && !r->failed; ++i) {
        if (words[i] > largest) {
            fail(r, "index %" PRIu32 " does not fit %s", words[i],
                 text_name(TEXT_INDEX, (int)format));
        }
    }
    if (!r->failed) {
        scene_set_indices(d, words, count, format);
    }
    free(words);
}

static void read_texture(reader *r, scene_draw *d)
{
    const gn_format format = (gn_format)read_name(r, TEXT_FORMAT);
    const uint32_t width = read_number(r, 10, GN_MAX_SIZE);
    const uint32_t height = read_number(r, 10, GN_MAX_SIZE);
    uint32_t *words;

    if (format != GN_FORMAT_RGBA8 && format != GN_FORMAT_RGBA32F) {
        fail(r, "a texture is rgba8 or rgba32f");
        return;
    }
    words =
        read_words(r, (size_t)width * height * (gn_format_size(format) / 4), read_hexadecimal_word);
    if (!r->failed) {
        scene_set_texture(d, words, width, height, format);
    }
    free(words);
}

/* Function, reference, ignored bits, bits not written; fail, depth fail, pass. */
static void read_stencil_face(reader *r, gn_stencil_face *f)
{
    f->function = (gn_stencil_function)read_name(r, TEXT_STENCIL_FUNCTION);
    f->reference = (uint8_t)read_number(r, 10, 255);
    f->ignored_bits = (uint8_t)read_number(r, 10, 255);
    f->write_disabled_bits = (uint8_t)read_number(r, 10, 255);
    f->fail = (gn_stencil_operation)read_name(r, TEXT_STENCIL_OPERATION);
    f->depth_fail = (gn_stencil_operation)read_name(r, TEXT_STENCIL_OPERATION);
    f->pass = (gn_stencil_operation)read_name(r, TEXT_STENCIL_OPERATION);
}

static bool read_state(reader *r, const char *keyword, gn_pipeline *p)
{
    if (!strcmp(keyword, "topology")) {
        p->topology = (gn_topology)read_name(r, TEXT_TOPOLOGY);
    } else if (!strcmp(keyword, "provoking-vertex")) {
        p->provoking_vertex = (gn_provoking_vertex)read_name(r, TEXT_PROVOKING);
    } else if (!strcmp(keyword, "cull")) {
        p->cull = (gn_cull)read_name(r, TEXT_CULL);
    } else if (!strcmp(keyword, "front-face")) {
        p->front_face = (gn_front_face)read_name(r, TEXT_FRONT_FACE);
    } else if (!strcmp(keyword, "viewport")) {
        p->viewport.set = true;
        p->viewport.x = read_float(r);
        p->viewport.y = read_float(r);
        p->viewport.width = read_float(r);
        p->viewport.height = read_float(r);
    } else if (!strcmp(keyword, "depth-range")) {
        p->depth_range.set = true;
        p->depth_range.z_near = read_float(r);
        p->depth_range.z_far = read_float(r);
    } else if (!strcmp(keyword, "scissor")) {
        p->scissor.set = true;
        p->scissor.x = read_integer(r);
        p->scissor.y = read_integer(r);
        p->scissor.width = read_number(r, 10, UINT32_MAX);
        p->scissor.height = read_number(r, 10, UINT32_MAX);
    } else if (!strcmp(keyword, "polygon-offset")) {
        p->polygon_offset.set = true;
        p->polygon_offset.factor = read_float(r);
        p->polygon_offset.units = read_float(r);
        p->polygon_offset.clamp = read_float(r);
    } else if (!strcmp(keyword, "clip-depth")) {
        p->clip_depth = (gn_clip_depth)read_name(r, TEXT_CLIP_DEPTH);
    } else if (!strcmp(keyword, "depth-clamp")) {
        p->depth_clamp = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "depth-test")) {
        p->depth_test = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "depth-function")) {
        p->depth_function = (gn_compare)read_name(r, TEXT_COMPARE);
    } else if (!strcmp(keyword, "depth-write")) {
        p->depth_write_disabled = read_name(r, TEXT_SWITCH) == 0;
    } else if (!strcmp(keyword, "stencil-test")) {
        p->stencil_test = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "stencil-front")) {
        read_stencil_face(r, &p->stencil_front);
    } else if (!strcmp(keyword, "stencil-back")) {
        read_stencil_face(r, &p->stencil_back);
    } else if (!strcmp(keyword, "samples-disabled")) {
        p->samples_disabled = read_number(r, 10, (1u << GN_SAMPLES) - 1);
    } else if (!strcmp(keyword, "alpha-to-coverage")) {
        p->alpha_to_coverage = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "alpha-to-one")) {
        p->alpha_to_one = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "reads-position")) {
        p->fragment_reads_position = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "reads-primitive")) {
        p->fragment_reads_primitive = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "discards")) {
        p->fragment_discards = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "writes-depth")) {
        p->fragment_writes_depth = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "point-size")) {
        p->point_size = read_float(r);
    } else if (!strcmp(keyword, "program-point-size")) {
        p->program_point_size = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "line-width")) {
        p->line_width = read_float(r);
    } else if (!strcmp(keyword, "point-origin")) {
        p->point_origin = (gn_point_origin)read_name(r, TEXT_POINT_ORIGIN);
    } else if (!strcmp(keyword, "reads-point-coordinate")) {
        p->fragment_reads_point_coordinate = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "polygon-mode")) {
        p->polygon_mode_front = (gn_polygon_mode)read_name(r, TEXT_POLYGON_MODE);
        p->polygon_mode_back = (gn_polygon_mode)read_name(r, TEXT_POLYGON_MODE);
    } else if (!strcmp(keyword, "interpolation")) {
        for (int i = 0; i < 4; ++i) {
            p->interpolation[i] = (gn_interpolation)read_name(r, TEXT_INTERPOLATION);
        }
    } else {
        return false;
    }
    return true;
}

/* The attachment that a keyword is for: the first, or with -of behind it the one whose number
 * follows. False where the keyword is another. */
static bool is_of_attachment(reader *r, const char *keyword, const char *name, uint32_t *attachment)
{
    const size_t length = strlen(name);

    *attachment = 0;
    if (strncmp(keyword, name, length) != 0) {
        return false;
    }
    if (!strcmp(keyword + length, "-of")) {
        *attachment = read_number(r, 10, GN_MAX_COLORS - 1);
        return true;
    }
    return !keyword[length];
}

static void read_blend(reader *r, gn_blend *b)
{
    b->enabled = true;
    b->equation = (gn_blend_equation)read_name(r, TEXT_EQUATION);
    b->source = (gn_blend_factor)read_name(r, TEXT_FACTOR);
    b->destination = (gn_blend_factor)read_name(r, TEXT_FACTOR);
    b->alpha_equation = (gn_blend_equation)read_name(r, TEXT_EQUATION);
    b->alpha_source = (gn_blend_factor)read_name(r, TEXT_FACTOR);
    b->alpha_destination = (gn_blend_factor)read_name(r, TEXT_FACTOR);
}

static bool read_color_state(reader *r, const char *keyword, gn_pipeline *p)
{
    uint32_t a;

    if (!strcmp(keyword, "color-count")) {
        p->color_count = read_number(r, 10, GN_MAX_COLORS);
    } else if (is_of_attachment(r, keyword, "color-mask", &a)) {
        p->color_write_disabled[a] = 0;
        for (unsigned c = 0; c < 4; ++c) {
            p->color_write_disabled[a] |= read_name(r, TEXT_SWITCH) == 0 ? 1u << c : 0;
        }
    } else if (!strcmp(keyword, "blend-constant")) {
        read_floats(r, p->blend_constant, 4);
    } else if (is_of_attachment(r, keyword, "blend", &a)) {
        read_blend(r, &p->blend[a]);
    } else if (!strcmp(keyword, "logic-operation")) {
        p->color_logic = true;
        p->logic_operation = (gn_logic_operation)read_name(r, TEXT_LOGIC);
    } else {
        return false;
    }
    return true;
}

static bool read_uniforms(reader *r, const char *keyword, scene_draw *d)
{
    scene_uniforms *u = &d->uniforms;

    if (!strcmp(keyword, "clip-from-model")) {
        read_floats(r, &u->light.clip_from_model.m[0][0], 16);
    } else if (!strcmp(keyword, "normal-matrix")) {
        read_floats(r, &u->light.normal_matrix.m[0][0], 9);
    } else if (!strcmp(keyword, "light-direction")) {
        u->light.light_direction = read_vec3(r);
    } else if (!strcmp(keyword, "ambient")) {
        u->light.ambient = read_vec3(r);
    } else if (!strcmp(keyword, "diffuse")) {
        u->light.diffuse = read_vec3(r);
    } else if (!strcmp(keyword, "view-from-model")) {
        read_floats(r, &d->view_from_model.m[0][0], 16);
    } else if (!strcmp(keyword, "specular")) {
        d->specular = read_vec3(r);
    } else if (!strcmp(keyword, "sampler")) {
        u->sampler.wrap_s = (gn_wrap)read_name(r, TEXT_WRAP);
        u->sampler.wrap_t = (gn_wrap)read_name(r, TEXT_WRAP);
        u->sampler.magnify = (gn_magnify)read_name(r, TEXT_MAGNIFY);
        u->sampler.minify = (gn_minify)read_name(r, TEXT_MINIFY);
    } else {
        return false;
    }
    return true;
}

static bool read_mesh(reader *r, const char *keyword, scene_draw *d)
{
    if (!strcmp(keyword, "vertices")) {
        for (int a = 0; a < text_name_count(TEXT_ATTRIBUTE); ++a) {
            if (d->mesh.attribute[a].data) {
                fail(r, "vertices stands after an attribute");
            }
        }
        d->mesh.vertex_count = read_number(r, 10, UINT32_MAX);
    } else if (!strcmp(keyword, "indices")) {
        read_indices(r, d);
    } else if (!strcmp(keyword, "clears-color")) {
        d->clear.color = true;
        read_floats(r, d->clear.color_value, 4);
    } else if (!strcmp(keyword, "clears-depth")) {
        d->clear.depth = true;
        d->clear.depth_value = read_float(r);
        d->clear.stencil_value = (uint8_t)read_number(r, 10, 255);
    } else if (!strcmp(keyword, "counted")) {
        d->counted = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "elements")) {
        d->mesh.first = read_number(r, 10, UINT32_MAX);
        d->mesh.count = read_number(r, 10, UINT32_MAX);
    } else if (!strcmp(keyword, "divisor")) {
        const int attribute = read_name(r, TEXT_ATTRIBUTE);
        d->mesh.attribute[attribute].divisor = read_number(r, 10, UINT32_MAX);
    } else if (!strcmp(keyword, "restart")) {
        d->mesh.restart = (gn_restart)read_name(r, TEXT_RESTART);
        d->mesh.restart_index = read_number(r, 10, UINT32_MAX);
    } else if (!strcmp(keyword, "base-vertex")) {
        d->mesh.base_vertex = (int32_t)read_number(r, 10, UINT32_MAX);
    } else if (!strcmp(keyword, "instances")) {
        d->mesh.instance_count = read_number(r, 10, UINT32_MAX);
    } else if (!strcmp(keyword, "texture")) {
        read_texture(r, d);
    } else {
        for (int a = 0; a < text_name_count(TEXT_ATTRIBUTE); ++a) {
            if (!strcmp(keyword, text_name(TEXT_ATTRIBUTE, a))) {
                read_attribute(r, d, a);
                return true;
            }
        }
        return false;
    }
    return true;
}

static void read_clip_plane(reader *r, scene_draw *d)
{
    uint32_t *const count = &d->state.clip_distance_count;

    if (*count == GN_MAX_CLIP_DISTANCES) {
        fail(r, "more than %d clip planes", GN_MAX_CLIP_DISTANCES);
        return;
    }
    read_floats(r, d->clip_plane[(*count)++], 4);
}

static void read_draw(reader *r, scene *s)
{
    const scene_shader shader = (scene_shader)read_name(r, TEXT_SHADER);
    scene_draw *d = scene_add_draw(s);
    char keyword[sizeof r->token];

    d->shader = shader;
    while (!r->failed) {
        strcpy(keyword, next(r));
        if (!strcmp(keyword, "end-draw")) {
            break;
        }
        if (!*keyword) {
            fail(r, "the text ends within a draw");
        } else if (!strcmp(keyword, "clip-plane")) {
            read_clip_plane(r, d);
        } else if (!read_state(r, keyword, &d->state) && !read_color_state(r, keyword, &d->state) &&
                   !read_uniforms(r, keyword, d) && !read_mesh(r, keyword, d)) {
            fail(r, "'%s' is no keyword of a draw", keyword);
        }
    }
    if (!r->failed && d->mesh.indices && (uint64_t)d->mesh.first + d->mesh.count > d->index_count) {
        fail(r, "elements beyond the %" PRIu32 " indices", d->index_count);
    }
}

static bool has_more_colors(const scene *s)
{
    for (int a = 1; a < GN_MAX_COLORS; ++a) {
        if (scene_color_format(s, a) != GN_FORMAT_NONE) {
            return true;
        }
    }
    return false;
}

static bool read_frame(reader *r, const char *keyword, scene *s)
{
    if (!strcmp(keyword, "size")) {
        s->width = read_number(r, 10, GN_MAX_SIZE);
        s->height = read_number(r, 10, GN_MAX_SIZE);
    } else if (!strcmp(keyword, "color-format")) {
        s->color_format = (gn_format)read_name(r, TEXT_FORMAT);
    } else if (!strcmp(keyword, "more-colors")) {
        for (int a = 0; a < GN_MAX_COLORS - 1; ++a) {
            s->more_colors[a] = (gn_format)read_name(r, TEXT_FORMAT);
            if (!r->failed && s->more_colors[a] != GN_FORMAT_NONE &&
                !scene_is_color_format(s->more_colors[a])) {
                fail(r, "more-colors are formats of colours, such as rgba8, or none");
            }
        }
    } else if (!strcmp(keyword, "depth-format")) {
        s->depth_format = (gn_format)read_name(r, TEXT_FORMAT);
    } else if (!strcmp(keyword, "clear-color")) {
        read_floats(r, s->clear_color, 4);
    } else if (!strcmp(keyword, "clear-depth")) {
        s->clear_depth = read_float(r);
    } else if (!strcmp(keyword, "clear-stencil")) {
        s->clear_stencil = (uint8_t)read_number(r, 10, 255);
    } else if (!strcmp(keyword, "samples")) {
        s->samples = read_number(r, 10, GN_SAMPLES);
    } else if (!strcmp(keyword, "draw")) {
        read_draw(r, s);
    } else {
        return false;
    }
    return true;
}

scene *scene_read(FILE *in, char *error, size_t error_size)
{
    reader r = {in, 1, "", false, error, error_size};
    scene *s = scene_create(0, 0, GN_FORMAT_NONE, GN_FORMAT_NONE);
    char keyword[sizeof r.token];

    if (error_size) {
        error[0] = '\0';
    }
    if (strcmp(next(&r), "gnomon-scene") || strcmp(next(&r), "1")) {
        fail(&r, "not a scene: the text starts with 'gnomon-scene 1'");
    }
    while (!r.failed) {
        strcpy(keyword, next(&r));
        if (!strcmp(keyword, "end-scene")) {
            break;
        }
        if (!*keyword) {
            fail(&r, "the text ends before end-scene");
        } else if (!read_frame(&r, keyword, s)) {
            fail(&r, "'%s' is no keyword of a scene", keyword);
        }
    }
    if (!r.failed && (s->width == 0 || s->height == 0)) {
        fail(&r, "a scene has a size");
    }
    if (!r.failed && !scene_is_color_format(s->color_format) &&
        (s->color_format != GN_FORMAT_NONE || !has_more_colors(s))) {
        fail(&r, "a scene's color-format is one of colours, such as rgba8");
    }
    if (!r.failed && scene_is_color_format(s->depth_format)) {
        fail(&r, "a scene's depth-format is one of depth or stencil, or none");
    }
    if (r.failed) {
        scene_free(s);
        return NULL;
    }
    return s;
}
