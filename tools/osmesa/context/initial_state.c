/* Sets the state of a new context. */
#include "initial_state.h"

#include <gl_registry.h>
#include <string.h>

#include "../transform/matrix_product.h"

static void set_four(GLfloat to[4], GLfloat x, GLfloat y, GLfloat z, GLfloat w)
{
    to[0] = x;
    to[1] = y;
    to[2] = z;
    to[3] = w;
}

static void set_current_values(current_state *c)
{
    set_four(c->attribute[NORMAL], 0.0f, 0.0f, 1.0f, 1.0f);
    set_four(c->attribute[COLOR], 1.0f, 1.0f, 1.0f, 1.0f);
    for (int i = 0; i < TEXTURE_UNITS; ++i)
        set_four(c->attribute[TEXTURE_COORDINATE + i], 0.0f, 0.0f, 0.0f, 1.0f);
    c->edge_flag = GL_TRUE;
    c->index = 1.0f;
}

static void set_arrays(array_state *arrays)
{
    static const GLint sizes[ARRAYS] = {[VERTEX_ARRAY] = 4,
                                        [NORMAL_ARRAY] = 3,
                                        [COLOR_ARRAY] = 4,
                                        [SECONDARY_COLOR_ARRAY] = 3,
                                        [FOG_COORDINATE_ARRAY] = 1,
                                        [EDGE_FLAG_ARRAY] = 1,
                                        [INDEX_ARRAY] = 1,
                                        [TEXTURE_COORDINATE_ARRAY] = 4,
                                        [TEXTURE_COORDINATE_ARRAY + 1] = 4,
                                        [TEXTURE_COORDINATE_ARRAY + 2] = 4,
                                        [TEXTURE_COORDINATE_ARRAY + 3] = 4};

    for (int i = 0; i < ARRAYS; ++i) {
        arrays->array[i].size = sizes[i];
        arrays->array[i].type = i == EDGE_FLAG_ARRAY ? GL_UNSIGNED_BYTE : GL_FLOAT;
    }
}

static void set_stack(matrix_stack *stack, GLfloat (*m)[16], matrix_kind *kind, GLint limit)
{
    stack->m = m;
    stack->kind = kind;
    stack->limit = limit;
    stack->depth = 1;
    set_identity(m[0]);
}

static void set_transform(context *gl)
{
    transform_state *const t = &gl->transform;

    t->mode = GL_MODELVIEW;
    set_stack(&t->modelview, gl->modelview, gl->modelview_kind, MODELVIEW_DEPTH);
    set_stack(&t->projection, gl->projection, gl->projection_kind, PROJECTION_DEPTH);
    for (int i = 0; i < TEXTURE_UNITS; ++i)
        set_stack(&t->texture[i], gl->texture[i], gl->texture_kind[i], TEXTURE_DEPTH);
    t->depth_range[1] = 1.0f;
}

static void set_lighting(lighting_state *lighting)
{
    lighting->shade_model = GL_SMOOTH;
    lighting->color_material_face = GL_FRONT_AND_BACK;
    lighting->color_material_mode = GL_AMBIENT_AND_DIFFUSE;
    lighting->color_control = GL_SINGLE_COLOR;
    set_four(lighting->ambient, 0.2f, 0.2f, 0.2f, 1.0f);
    for (int i = 0; i < LIGHTS; ++i) {
        light_state *const light = &lighting->light[i];
        const GLfloat first = i == 0 ? 1.0f : 0.0f;

        set_four(light->ambient, 0.0f, 0.0f, 0.0f, 1.0f);
        set_four(light->diffuse, first, first, first, 1.0f);
        set_four(light->specular, first, first, first, 1.0f);
        set_four(light->position, 0.0f, 0.0f, 1.0f, 0.0f);
        light->spot_direction[2] = -1.0f;
        light->spot_cutoff = 180.0f;
        light->constant_attenuation = 1.0f;
    }
    for (int i = 0; i < 2; ++i) {
        material_state *const material = &lighting->material[i];

        set_four(material->color[MATERIAL_AMBIENT], 0.2f, 0.2f, 0.2f, 1.0f);
        set_four(material->color[MATERIAL_DIFFUSE], 0.8f, 0.8f, 0.8f, 1.0f);
        set_four(material->color[MATERIAL_SPECULAR], 0.0f, 0.0f, 0.0f, 1.0f);
        set_four(material->color[MATERIAL_EMISSION], 0.0f, 0.0f, 0.0f, 1.0f);
        material->indexes[1] = material->indexes[2] = 1.0f;
    }
}

static void set_raster_position(raster_position_state *r)
{
    set_four(r->position, 0.0f, 0.0f, 0.0f, 1.0f);
    set_four(r->color, 1.0f, 1.0f, 1.0f, 1.0f);
    set_four(r->secondary_color, 0.0f, 0.0f, 0.0f, 1.0f);
    r->index = 1.0f;
    for (int u = 0; u < TEXTURE_UNITS; ++u)
        set_four(r->coordinate[u], 0.0f, 0.0f, 0.0f, 1.0f);
    r->is_valid = GL_TRUE;
}

static void set_raster(raster_state *r)
{
    r->point_size = r->line_width = r->point_fade_threshold = 1.0f;
    r->point_size_max = GN_MAX_POINT_SIZE;
    r->point_attenuation[0] = 1.0f;
    r->stipple_factor = 1;
    r->stipple_pattern = 0xFFFF;
    r->cull_face = GL_BACK;
    r->front_face = GL_CCW;
    r->polygon_mode[0] = r->polygon_mode[1] = GL_FILL;
}

static void set_fragments(fragment_state *f)
{
    f->dither = f->multisample = GL_TRUE;
    f->alpha_function = GL_ALWAYS;
    for (int i = 0; i < 2; ++i) {
        stencil_state *const stencil = &f->stencil[i];

        stencil->function = GL_ALWAYS;
        stencil->fail = stencil->depth_fail = stencil->pass = GL_KEEP;
        stencil->compare_mask = stencil->write_mask = 0xFF;
    }
    f->depth_function = GL_LESS;
    f->blend_source = f->blend_alpha_source = GL_ONE;
    f->blend_destination = f->blend_alpha_destination = GL_ZERO;
    f->blend_equation = f->blend_alpha_equation = GL_FUNC_ADD;
    f->logic_function = GL_COPY;
    f->sample_coverage_value = 1.0f;
    memset(f->color_mask, GL_TRUE, sizeof f->color_mask);
    f->depth_mask = GL_TRUE;
    f->index_mask = -1;
    f->clear_depth = 1.0;
    f->draw_buffer = f->read_buffer = GL_FRONT;
}

static void set_combine_half(enum combine_half name, combine_state *half)
{
    static const GLenum sources[] = {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT, GL_CONSTANT};

    half->mode = GL_MODULATE;
    half->scale = 1.0f;
    for (int i = 0; i < COMBINE_ARGUMENTS; ++i) {
        half->source[i] = sources[i];
        half->operand[i] = name == COMBINE_COLOR && i < 2 ? GL_SRC_COLOR : GL_SRC_ALPHA;
    }
}

static void set_texture_unit(texture_unit *unit)
{
    unit->mode = GL_MODULATE;
    set_combine_half(COMBINE_COLOR, &unit->combine[COMBINE_COLOR]);
    set_combine_half(COMBINE_ALPHA, &unit->combine[COMBINE_ALPHA]);
    for (int i = 0; i < 4; ++i) {
        texture_generation *const generation = &unit->generation[i];

        generation->mode = GL_EYE_LINEAR;
        if (i < 2)
            generation->object_plane[i] = generation->eye_plane[i] = 1.0f;
    }
}

static void set_evaluators(context *gl)
{
    evaluator_state *const e = &gl->evaluator;

    e->segments1 = e->segments2[0] = e->segments2[1] = 1;
    e->domain1[1] = e->domain2[1] = e->domain2[3] = 1.0f;
    for (int i = 0; i < EVALUATOR_MAPS; ++i) {
        evaluator_map *const map = &gl->map1[i];

        map->order[0] = map->order[1] = 1;
        map->domain[1] = map->domain[3] = 1.0f;
        gl->map2[i] = *map;
    }
}

void set_initial_state(context *gl)
{
    hint_state *const hint = &gl->hint;

    set_current_values(&gl->current);
    set_raster_position(&gl->raster_position);
    set_arrays(&gl->arrays);
    set_transform(gl);
    gl->transform.clip_origin = GL_LOWER_LEFT;
    gl->transform.clip_depth = GL_NEGATIVE_ONE_TO_ONE;
    set_lighting(&gl->lighting);
    for (int i = 0; i < TEXTURE_UNITS; ++i)
        set_texture_unit(&gl->unit[i]);
    gl->fog.mode = GL_EXP;
    gl->fog.density = gl->fog.end = 1.0f;
    gl->fog.coordinate_source = GL_FRAGMENT_DEPTH;
    set_raster(&gl->raster);
    memset(gl->polygon_pattern, 0xFF, sizeof gl->polygon_pattern);
    set_fragments(&gl->fragment);
    gl->pixel_zoom[0] = gl->pixel_zoom[1] = 1.0f;
    set_four(gl->transfer.scale, 1.0f, 1.0f, 1.0f, 1.0f);
    gl->transfer.depth_scale = 1.0f;
    for (int i = 0; i < PIXEL_MAPS; ++i)
        gl->map[i].size = 1;
    set_evaluators(gl);
    gl->pack.alignment = gl->unpack.alignment = 4;
    gl->render_mode = GL_RENDER;
    gl->selection.least_z = 1.0f;
    gl->feedback.type = GL_2D;
    hint->perspective = hint->point = hint->line = hint->polygon = hint->fog = hint->mipmap =
        hint->compression = GL_DONT_CARE;
    gl->clamp_vertex_color = GL_TRUE;
    gl->clamp_fragment_color = gl->clamp_read_color = GL_FIXED_ONLY;
    gl->debug_groups = 1;
    gl->provoking_vertex = GL_LAST_VERTEX_CONVENTION;
}
