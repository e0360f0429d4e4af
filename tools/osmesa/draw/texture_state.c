/* What textures of a draw are, derived once. */
#include <gl_registry.h>
#include <string.h>

#include "fixed_texture.h"
#include "../textures/texel_pixels.h"
#include "../framebuffer/framebuffer_view.h"

static texture_operation operation_of(GLenum mode)
{
    return mode == GL_REPLACE ? TEXTURE_REPLACES
           : mode == GL_DECAL ? TEXTURE_DECALS
           : mode == GL_BLEND ? TEXTURE_BLENDS
           : mode == GL_ADD   ? TEXTURE_ADDS
                              : TEXTURE_MODULATES;
}

/* Tables 3.22 and 3.23; what they leave undefined keeps the colour, as in the reference. */
static void set_operations(GLenum mode, GLenum base_format, unit_derived *unit)
{
    const bool has_color = base_format != GL_ALPHA;
    const bool has_alpha =
        base_format != GL_RGB && base_format != GL_LUMINANCE && base_format != GL_RED;
    const bool is_intensity = base_format == GL_INTENSITY;

    unit->color_operation = has_color ? operation_of(mode) : TEXTURE_KEEPS;
    unit->alpha_operation = !has_alpha                         ? TEXTURE_KEEPS
                            : mode == GL_REPLACE               ? TEXTURE_REPLACES
                            : mode == GL_DECAL                 ? TEXTURE_KEEPS
                            : is_intensity && mode == GL_BLEND ? TEXTURE_BLENDS
                            : is_intensity && mode == GL_ADD   ? TEXTURE_ADDS
                                                               : TEXTURE_MODULATES;
    if (mode == GL_DECAL && base_format != GL_RGBA)
        unit->color_operation =
            base_format == GL_RGB || base_format == GL_RED ? TEXTURE_REPLACES : TEXTURE_KEEPS;
}

static float clamped(float x)
{
    return x > 0.0f ? x < 1.0f ? x : 1.0f : 0.0f;
}

/* Without GL_TEXTURE_CUBE_MAP_SEAMLESS a cube's faces are layers, which end at their edges. */
static void set_separate_faces(unit_derived *unit)
{
    unit->has_separate_faces = true;
    unit->texture.target = GN_TEXTURE_2D_ARRAY;
    unit->texture.depth = CUBE_FACES;
    unit->sampler.wrap_s = unit->sampler.wrap_t = GN_WRAP_CLAMP_TO_EDGE;
}

/* Finds the texture that is read: of several that are enabled and complete, the last one. */
static bool find_texture(const texture_unit *state, bool seamless_cubes, unit_derived *unit)
{
    for (int i = TEXTURE_TARGETS - 1; i >= 0; --i) {
        texture_object *const object = state->bound[i];

        if (!state->enabled[i] ||
            !describe_texture(object, state->lod_bias, &unit->texture, &unit->sampler))
            continue;
        set_operations(state->mode, read_base_format(object), unit);
        unit->depth_mode = is_depth_format(object->image[0][object->base_level].base_format)
                               ? object->depth_mode
                               : 0;
        unit->clamps_reference = object->image[0][object->base_level].is_fixed_depth;
        unit->is_compared = unit->depth_mode && unit->sampler.compare;
        if (unit->texture.target == GN_TEXTURE_CUBE && !seamless_cubes)
            set_separate_faces(unit);
        for (int axis = 0; axis < 3; ++axis)
            unit->clamps[axis] = object->wrap[axis] == GL_CLAMP && linear_filters(object) > 0;
        unit->most = linear_filters(object) == 2 ? 1.0f : 0x1.fffffep-1f;
        return true;
    }
    return false;
}

static bool needs_eye(const texture_generation generation[4])
{
    for (int i = 0; i < 4; ++i)
        if (generation[i].enabled && generation[i].mode != GL_OBJECT_LINEAR)
            return true;
    return false;
}

bool set_texture_units(context *gl, unit_derived units[TEXTURE_UNITS])
{
    const bool is_fixed = !draws_floats(gl);
    bool needs = false, is_product = false;

    for (int u = 0; u < TEXTURE_UNITS; ++u) {
        const texture_unit *const state = &gl->unit[u];
        matrix_stack *const stack = &gl->transform.texture[u];
        matrix_kind *const kind = &stack->kind[stack->depth - 1];
        unit_derived *const unit = &units[u];

        unit->enabled = find_texture(state, gl->seamless_cubes, unit);
        if (!unit->enabled)
            continue;
        unit->combines = state->mode == GL_COMBINE || state->mode == GL_COMBINE4_NV;
        unit->combines_four = state->mode == GL_COMBINE4_NV;
        memcpy(unit->combine, state->combine, sizeof unit->combine);
        unit->follows_product = is_product;
        is_product = !unit->combines && unit->color_operation == TEXTURE_MODULATES;
        for (int c = 0; c < 4; ++c)
            unit->color[c] = is_fixed ? clamped(state->color[c]) : state->color[c];
        memcpy(unit->coordinate, gl->current.attribute[TEXTURE_COORDINATE + u],
               sizeof unit->coordinate);
        memcpy(unit->generation, state->generation, sizeof unit->generation);
        for (int i = 0; i < 4; ++i)
            unit->generates = unit->generates || state->generation[i].enabled;
        unit->has_reflected_depth =
            state->generation[2].enabled && state->generation[2].mode == GL_REFLECTION_MAP;
        needs = needs || needs_eye(state->generation);
        analyse_matrix(kind, stack->m[stack->depth - 1]);
        unit->has_matrix = kind->shape != SHAPE_IDENTITY;
        memcpy(unit->matrix, stack->m[stack->depth - 1], sizeof unit->matrix);
    }
    return needs;
}

void set_texture_varyings(const context *gl, const gn_mesh *mesh, unit_derived units[TEXTURE_UNITS],
                          gn_program *program)
{
    (void)gl;
    for (int u = 0; u < TEXTURE_UNITS; ++u) {
        unit_derived *const unit = &units[u];

        unit->varying = -1;
        if (!unit->enabled ||
            !(unit->generates || unit->has_matrix || mesh->attribute[TEXTURE_COORDINATE + u].data))
            continue;
        unit->varying = (int)program->varying_count;
        program->varying_count += 4;
    }
}
