/* Scenes from text. */
#include "scene.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "scene_memory.h"
#include "scene_reader.h"

static void read_attribute(reader *r, scene_draw *d, int attribute)
{
    const uint32_t components = read_number(r, 10, 4);
    const size_t count = (size_t)components * d->mesh.vertex_count;
    uint32_t *words;

    if (components == 0) {
        reader_fail(r, "an attribute has 1 to 4 components");
        return;
    }
    words = read_words(r, count, read_float_word);
    if (!r->failed) {
        float *values = scene_reallocate(NULL, count, sizeof *values);

        memcpy(values, words, count * sizeof *values);
        scene_set_attribute(d, (gn_shader_attribute)attribute, values, components,
                            d->mesh.vertex_count);
        free(values);
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
            reader_fail(r, "index %" PRIu32 " does not fit %s", words[i],
                        text_name(TEXT_INDEX, (int)format));
        }
    }
    if (!r->failed)
        scene_set_indices(d, words, count, format);
    free(words);
}

/* The texels of a texture whose other members are there, packed: memory that the caller frees.
 * After a fault null. */
static void *read_texels(reader *r, gn_texture *t)
{
    const bool sampled = scene_is_color_format(t->format) || scene_has_depth(t->format);
    const size_t size = scene_element_size(t->format);

    if (!r->failed && !sampled)
        reader_fail(r, "a texture is of a format of colours or depths, such as rgba8");
    if (!r->failed && (t->width == 0 || t->height == 0))
        reader_fail(r, "a texture has a size");
    if (r->failed)
        return NULL;

    const size_t count = scene_texture_elements(t);
    uint32_t *words = read_words(r, count, read_hexadecimal_word);
    void *packed = NULL;

    if (!r->failed) {
        packed = scene_allocate(count, size);
        for (size_t i = 0; i < count; ++i)
            scene_set_element(packed, size, i, words[i]);
        scene_pack_texture(t, packed);
    }
    free(words);
    return packed;
}

/* A 2D texture of one level. */
static void read_texture(reader *r, scene_draw *d)
{
    gn_texture t;

    memset(&t, 0, sizeof t);
    t.format = (gn_format)read_name(r, TEXT_FORMAT);
    t.width = read_number(r, 10, GN_MAX_SIZE);
    t.height = read_number(r, 10, GN_MAX_SIZE);

    void *const packed = read_texels(r, &t);
    if (packed)
        scene_set_levels(d, &t);
    free(packed);
}

/* Of any target and levels: uniforms.texture or, not SCENE_MAP_COUNT, a map. */
static void read_levels(reader *r, scene_draw *d, scene_map map)
{
    gn_texture t;

    memset(&t, 0, sizeof t);
    t.target = (gn_texture_target)read_name(r, TEXT_TEXTURE_TARGET);
    t.format = (gn_format)read_name(r, TEXT_FORMAT);
    t.width = read_number(r, 10, GN_MAX_SIZE);
    t.height = read_number(r, 10, GN_MAX_SIZE);
    t.depth = read_number(r, 10, GN_MAX_SIZE);
    t.level_count = read_number(r, 10, GN_MAX_LEVELS);

    void *const packed = read_texels(r, &t);
    if (packed && map == SCENE_MAP_COUNT)
        scene_set_levels(d, &t);
    else if (packed)
        scene_set_map(d, map, &t);
    free(packed);
}

/* Function, reference, ignored bits, bits not written; fail, depth fail, pass. */
static void read_stencil_face(reader *r, gn_stencil_face *f)
{
    f->function = (gn_compare)read_name(r, TEXT_COMPARE);
    f->reference = (uint8_t)read_number(r, 10, 255);
    f->compare_disabled = (uint8_t)read_number(r, 10, 255);
    f->write_disabled = (uint8_t)read_number(r, 10, 255);
    f->fail = (gn_stencil_operation)read_name(r, TEXT_STENCIL_OPERATION);
    f->depth_fail = (gn_stencil_operation)read_name(r, TEXT_STENCIL_OPERATION);
    f->pass = (gn_stencil_operation)read_name(r, TEXT_STENCIL_OPERATION);
}

static bool read_state(reader *r, const char *keyword, gn_pipeline *p)
{
    if (!strcmp(keyword, "topology")) {
        p->raster.topology = (gn_topology)read_name(r, TEXT_TOPOLOGY);
    } else if (!strcmp(keyword, "provoking-vertex")) {
        p->raster.provoking_vertex = (gn_provoking_vertex)read_name(r, TEXT_PROVOKING);
    } else if (!strcmp(keyword, "cull")) {
        p->raster.cull = (gn_cull)read_name(r, TEXT_CULL);
    } else if (!strcmp(keyword, "front-face")) {
        p->raster.front_face = (gn_front_face)read_name(r, TEXT_FRONT_FACE);
    } else if (!strcmp(keyword, "viewport")) {
        p->raster.viewport.set = true;
        p->raster.viewport.x = read_float(r);
        p->raster.viewport.y = read_float(r);
        p->raster.viewport.width = read_float(r);
        p->raster.viewport.height = read_float(r);
    } else if (!strcmp(keyword, "depth-range")) {
        p->depth.range.set = true;
        p->depth.range.z_near = read_float(r);
        p->depth.range.z_far = read_float(r);
    } else if (!strcmp(keyword, "scissor")) {
        p->raster.scissor.set = true;
        p->raster.scissor.x = read_integer(r);
        p->raster.scissor.y = read_integer(r);
        p->raster.scissor.width = read_number(r, 10, UINT32_MAX);
        p->raster.scissor.height = read_number(r, 10, UINT32_MAX);
    } else if (!strcmp(keyword, "polygon-offset")) {
        p->raster.polygon_offset.set = true;
        p->raster.polygon_offset.factor = read_float(r);
        p->raster.polygon_offset.units = read_float(r);
        p->raster.polygon_offset.clamp = read_float(r);
    } else if (!strcmp(keyword, "clip-depth")) {
        p->depth.clip_depth = (gn_clip_depth)read_name(r, TEXT_CLIP_DEPTH);
    } else if (!strcmp(keyword, "depth-clamp")) {
        p->depth.clamp = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "depth-test")) {
        p->depth.test = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "depth-function")) {
        p->depth.function = (gn_compare)read_name(r, TEXT_COMPARE);
    } else if (!strcmp(keyword, "depth-write")) {
        p->depth.write_disabled = read_name(r, TEXT_SWITCH) == 0;
    } else if (!strcmp(keyword, "stencil-test")) {
        p->stencil.test = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "stencil-front")) {
        read_stencil_face(r, &p->stencil.front);
    } else if (!strcmp(keyword, "stencil-back")) {
        read_stencil_face(r, &p->stencil.back);
    } else if (!strcmp(keyword, "samples-disabled")) {
        p->samples.write_disabled = read_number(r, 10, (1u << GN_SAMPLES) - 1);
    } else if (!strcmp(keyword, "alpha-to-coverage")) {
        p->samples.alpha_to_coverage = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "alpha-to-one")) {
        p->samples.alpha_to_one = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "reads-position")) {
        p->program.fragment_reads_position = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "reads-primitive")) {
        p->program.fragment_reads_primitive = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "discards")) {
        p->program.fragment_discards = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "writes-depth")) {
        p->program.fragment_writes_depth = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "point-size")) {
        p->raster.point_size = read_float(r);
    } else if (!strcmp(keyword, "program-point-size")) {
        p->program.vertex_writes_point_size = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "line-width")) {
        p->raster.line_width = read_float(r);
    } else if (!strcmp(keyword, "point-origin")) {
        p->raster.point_origin = (gn_point_origin)read_name(r, TEXT_POINT_ORIGIN);
    } else if (!strcmp(keyword, "reads-point-coordinate")) {
        p->program.fragment_reads_point_coordinate = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "reads-sample-mask")) {
        p->program.fragment_reads_sample_mask = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "writes-sample-mask")) {
        p->program.fragment_writes_sample_mask = read_name(r, TEXT_SWITCH) == 1;
    } else if (!strcmp(keyword, "polygon-mode")) {
        p->raster.polygon_mode_front = (gn_polygon_mode)read_name(r, TEXT_POLYGON_MODE);
        p->raster.polygon_mode_back = (gn_polygon_mode)read_name(r, TEXT_POLYGON_MODE);
    } else if (!strcmp(keyword, "interpolation")) {
        for (int i = 0; i < 4; ++i)
            p->program.interpolation[i] = (gn_interpolation)read_name(r, TEXT_INTERPOLATION);
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
    if (strncmp(keyword, name, length) != 0)
        return false;
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
        p->program.color_count = read_number(r, 10, GN_MAX_COLORS);
    } else if (is_of_attachment(r, keyword, "color-mask", &a)) {
        p->color.write_disabled[a] = 0;
        for (unsigned c = 0; c < 4; ++c)
            p->color.write_disabled[a] |= read_name(r, TEXT_SWITCH) == 0 ? 1u << c : 0;
    } else if (!strcmp(keyword, "blend-constant")) {
        read_floats(r, p->color.blend_constant, 4);
    } else if (is_of_attachment(r, keyword, "blend", &a)) {
        read_blend(r, &p->color.blend[a]);
    } else if (!strcmp(keyword, "logic-operation")) {
        p->color.logic = true;
        p->color.logic_operation = (gn_logic_operation)read_name(r, TEXT_LOGIC);
    } else {
        return false;
    }
    return true;
}

static bool read_uniforms(reader *r, const char *keyword, scene_draw *d)
{
    scene_uniforms *u = &d->uniforms;

    if (!strcmp(keyword, "clip-from-model"))
        read_floats(r, &u->light.clip_from_model.m[0][0], 16);
    else if (!strcmp(keyword, "normal-matrix"))
        read_floats(r, &u->light.normal_matrix.m[0][0], 9);
    else if (!strcmp(keyword, "light-direction"))
        u->light.light_direction = read_vec3(r);
    else if (!strcmp(keyword, "ambient"))
        u->light.ambient = read_vec3(r);
    else if (!strcmp(keyword, "diffuse"))
        u->light.diffuse = read_vec3(r);
    else if (!strcmp(keyword, "view-from-model"))
        read_floats(r, &d->view_from_model.m[0][0], 16);
    else if (!strcmp(keyword, "specular"))
        d->specular = read_vec3(r);
    else
        return false;
    return true;
}

static bool read_surface(reader *r, const char *keyword, scene_surface *s)
{
    if (!strcmp(keyword, "world-from-model")) {
        read_floats(r, &s->world_from_model.m[0][0], 16);
    } else if (!strcmp(keyword, "eye")) {
        s->eye = read_vec3(r);
    } else if (!strcmp(keyword, "point-light")) {
        s->has_point_light = true;
        s->light_position = read_vec3(r);
        read_floats(r, s->attenuation, 3);
    } else if (!strcmp(keyword, "exponent")) {
        s->exponent = read_number(r, 10, UINT32_MAX);
    } else if (!strcmp(keyword, "bands")) {
        s->bands = read_number(r, 10, UINT32_MAX);
    } else if (!strcmp(keyword, "normal-space")) {
        s->normal_space = (gn_normal_space)read_name(r, TEXT_NORMAL_SPACE);
    } else if (!strcmp(keyword, "shadow-sampler")) {
        s->shadow_sampler.wrap_s = (gn_wrap)read_name(r, TEXT_WRAP);
        s->shadow_sampler.wrap_t = (gn_wrap)read_name(r, TEXT_WRAP);
        s->shadow_sampler.magnify = (gn_magnify)read_name(r, TEXT_MAGNIFY);
        s->shadow_sampler.minify = (gn_minify)read_name(r, TEXT_MINIFY);
        s->shadow_sampler.compare = (gn_compare)read_name(r, TEXT_COMPARE);
        read_floats(r, s->shadow_sampler.border, 4);
    } else if (!strcmp(keyword, "shadow-from-world")) {
        read_floats(r, &s->shadow_from_world.m[0][0], 16);
    } else if (!strcmp(keyword, "depth-colors")) {
        s->black = read_float(r);
        s->white = read_float(r);
    } else {
        return false;
    }
    return true;
}

static bool read_sampler(reader *r, const char *keyword, gn_sampler *s)
{
    if (!strcmp(keyword, "sampler")) {
        s->wrap_s = (gn_wrap)read_name(r, TEXT_WRAP);
        s->wrap_t = (gn_wrap)read_name(r, TEXT_WRAP);
        s->magnify = (gn_magnify)read_name(r, TEXT_MAGNIFY);
        s->minify = (gn_minify)read_name(r, TEXT_MINIFY);
    } else if (!strcmp(keyword, "wrap-r")) {
        s->wrap_r = (gn_wrap)read_name(r, TEXT_WRAP);
    } else if (!strcmp(keyword, "texture-compare")) {
        s->compare = (gn_compare)read_name(r, TEXT_COMPARE);
    } else if (!strcmp(keyword, "lod-bias")) {
        s->lod_bias = read_float(r);
    } else if (!strcmp(keyword, "lod-clamp")) {
        s->lod_clamped = true;
        s->min_lod = read_float(r);
        s->max_lod = read_float(r);
    } else if (!strcmp(keyword, "max-anisotropy")) {
        s->max_anisotropy = read_number(r, 10, GN_MAX_ANISOTROPY);
    } else if (!strcmp(keyword, "border")) {
        read_floats(r, s->border, 4);
    } else {
        return false;
    }
    return true;
}

static bool read_mesh(reader *r, const char *keyword, scene_draw *d)
{
    if (!strcmp(keyword, "vertices")) {
        for (int a = 0; a < text_name_count(TEXT_ATTRIBUTE); ++a)
            if (d->mesh.attribute[a].data)
                reader_fail(r, "vertices stands after an attribute");
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
    } else if (!strcmp(keyword, "texture-levels")) {
        read_levels(r, d, SCENE_MAP_COUNT);
    } else if (text_value(TEXT_MAP, keyword) >= 0) {
        read_levels(r, d, (scene_map)text_value(TEXT_MAP, keyword));
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
    uint32_t *const count = &d->state.program.clip_distance_count;

    if (*count == GN_MAX_CLIP_DISTANCES) {
        reader_fail(r, "more than %d clip planes", GN_MAX_CLIP_DISTANCES);
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
        strcpy(keyword, reader_next(r));
        if (!strcmp(keyword, "end-draw"))
            break;
        if (!*keyword)
            reader_fail(r, "the text ends within a draw");
        else if (!strcmp(keyword, "clip-plane"))
            read_clip_plane(r, d);
        else if (!read_state(r, keyword, &d->state) && !read_color_state(r, keyword, &d->state) &&
                 !read_uniforms(r, keyword, d) && !read_surface(r, keyword, &d->surface) &&
                 !read_sampler(r, keyword, &d->uniforms.sampler) && !read_mesh(r, keyword, d))
            reader_fail(r, "'%s' is no keyword of a draw", keyword);
    }
    if (!r->failed && d->mesh.indices && (uint64_t)d->mesh.first + d->mesh.count > d->index_count)
        reader_fail(r, "elements beyond the %" PRIu32 " indices", d->index_count);
}

static bool has_more_colors(const scene *s)
{
    for (int a = 1; a < GN_MAX_COLORS; ++a)
        if (scene_color_format(s, a) != GN_FORMAT_NONE)
            return true;
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
                !scene_is_color_format(s->more_colors[a]))
                reader_fail(r, "more-colors are formats of colours, such as rgba8, or none");
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

    if (error_size)
        error[0] = '\0';
    if (strcmp(reader_next(&r), "gnomon-scene") || strcmp(reader_next(&r), "1"))
        reader_fail(&r, "not a scene: the text starts with 'gnomon-scene 1'");
    while (!r.failed) {
        strcpy(keyword, reader_next(&r));
        if (!strcmp(keyword, "end-scene"))
            break;
        if (!*keyword)
            reader_fail(&r, "the text ends before end-scene");
        else if (!read_frame(&r, keyword, s))
            reader_fail(&r, "'%s' is no keyword of a scene", keyword);
    }
    if (!r.failed && (s->width == 0 || s->height == 0))
        reader_fail(&r, "a scene has a size");
    if (!r.failed && !scene_is_color_format(s->color_format) &&
        (s->color_format != GN_FORMAT_NONE || !has_more_colors(s)))
        reader_fail(&r, "a scene's color-format is one of colours, such as rgba8");
    if (!r.failed && scene_is_color_format(s->depth_format))
        reader_fail(&r, "a scene's depth-format is one of depth or stencil, or none");
    if (r.failed) {
        scene_free(s);
        return NULL;
    }
    return s;
}
