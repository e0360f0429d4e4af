/* Computes the raster position from the coordinates that the program gives. */
#include "raster_position.h"

#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "../lighting/color_material.h"
#include "../draw/fixed_function.h"
#include "../render_mode/selection.h"
#include "../transform/clip_planes.h"

static const GLfloat *top_of(const matrix_stack *stack)
{
    return stack->m[stack->depth - 1];
}

/* to = m * v */
static void transform(const GLfloat *m, const GLfloat v[4], GLfloat to[4])
{
    for (int row = 0; row < 4; ++row)
        to[row] = m[row] * v[0] + m[4 + row] * v[1] + m[8 + row] * v[2] + m[12 + row] * v[3];
}

static GLfloat forward_dot_4(const GLfloat *a, const GLfloat *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/* Whether a vertex in clip space is within the view volume, that of z from -w to w in any case. NaN
 * is. */
static bool is_in_view_volume(const GLfloat clip[4])
{
    for (int i = 0; i < 3; ++i)
        if (clip[i] > clip[3] || clip[i] < -clip[3])
            return false;
    return true;
}

/* Whether no clip plane cuts a vertex off. NaN is not cut off. */
static bool is_before_clip_planes(context *gl, const GLfloat clip[4])
{
    GLfloat plane[CLIP_PLANES][4];
    const uint32_t count = derive_clip_planes(gl, plane);

    for (uint32_t i = 0; i < count; ++i)
        if (clip_distance(plane[i], clip[0], clip[1], clip[2], clip[3]) < 0.0f)
            return false;
    return true;
}

/* Maps clip space to the window (section 2.11.1). */
static void place_in_window(const context *gl, const GLfloat clip[4], GLfloat window[4])
{
    const GLint *const viewport = gl->transform.viewport;
    const GLfloat *const range = gl->transform.depth_range;
    const bool from_zero = gl->transform.clip_depth == GL_ZERO_TO_ONE;
    const bool is_flipped = gl->transform.clip_origin == GL_UPPER_LEFT;
    const GLfloat one_over_w = clip[3] == 0.0f ? 1.0f : 1.0f / clip[3];

    for (int i = 0; i < 2; ++i) {
        const GLfloat half = 0.5f * (GLfloat)viewport[2 + i];

        window[i] = (clip[i] * one_over_w) * (is_flipped && i == 1 ? -half : half) +
                    (half + (GLfloat)viewport[i]);
    }
    window[2] = from_zero ? (clip[2] * one_over_w) * (range[1] - range[0]) + range[0]
                          : (clip[2] * one_over_w) *
                                    (GLfloat)(0.5 * ((double)range[1] - (double)range[0])) +
                                (GLfloat)(0.5 * ((double)range[0] + (double)range[1]));
    window[3] = clip[3];
}

/* Generates the texture coordinates of a unit (section 2.11.4). `normal` is in the space that is
 * used. */
static void generate_coordinate(const texture_unit *unit, const GLfloat vertex[4],
                                const GLfloat eye[4], const GLfloat normal[4], GLfloat to[4])
{
    GLfloat direction[3] = {eye[0], eye[1], eye[2]};
    GLfloat reflected[4] = {0.0f}, square, scale, twice;

    make_unit_length(direction);
    twice = 2.0f * forward_dot_3(normal, direction);
    for (int i = 0; i < 3; ++i)
        reflected[i] = direction[i] - normal[i] * twice;
    square = reflected[0] * reflected[0] + reflected[1] * reflected[1] +
             (reflected[2] + 1.0f) * (reflected[2] + 1.0f);
    scale = square > 0.0f ? 0.5f * (1.0f / sqrtf(square)) : 0.0f;
    for (int i = 0; i < 4; ++i) {
        const texture_generation *const generation = &unit->generation[i];

        if (!generation->enabled)
            continue;
        switch (generation->mode) {
        case GL_OBJECT_LINEAR:
            to[i] = forward_dot_4(vertex, generation->object_plane);
            break;
        case GL_EYE_LINEAR:
            to[i] = forward_dot_4(eye, generation->eye_plane);
            break;
        case GL_SPHERE_MAP:
            to[i] = reflected[i] * scale + 0.5f;
            break;
        case GL_REFLECTION_MAP:
            to[i] = reflected[i];
            break;
        default:
            to[i] = normal[i];
        }
    }
}

static void set_coordinates(context *gl, const GLfloat vertex[4], const GLfloat eye[4],
                            const GLfloat normal[4])
{
    for (int u = 0; u < TEXTURE_UNITS; ++u) {
        GLfloat coordinate[4];

        memcpy(coordinate, gl->current.attribute[TEXTURE_COORDINATE + u], sizeof coordinate);
        generate_coordinate(&gl->unit[u], vertex, eye, normal, coordinate);
        transform(top_of(&gl->transform.texture[u]), coordinate, gl->raster_position.coordinate[u]);
    }
}

/* Sets the normal of the vertex, in eye space or as it is. */
static void set_normal(const context *gl, const eye_derived *eye, GLfloat normal[4])
{
    const GLfloat *const n = gl->current.attribute[NORMAL];
    const GLfloat *const inverse = eye->inverse;

    for (int i = 0; i < 3; ++i)
        normal[i] = eye->is_used ? n[0] * inverse[4 * i] + n[1] * inverse[4 * i + 1] +
                                       n[2] * inverse[4 * i + 2]
                                 : n[i];
    normal[3] = 0.0f;
}

void set_raster_position(context *gl, const GLfloat vertex[4])
{
    raster_position_state *const r = &gl->raster_position;
    unit_derived units[TEXTURE_UNITS];
    eye_derived space;
    GLfloat eye[4], clip[4], normal[4];

    transform(top_of(&gl->transform.modelview), vertex, eye);
    transform(top_of(&gl->transform.projection), eye, clip);
    r->is_valid = is_in_view_volume(clip) && is_before_clip_planes(gl, clip);
    if (!r->is_valid)
        return;
    place_in_window(gl, clip, r->position);
    r->distance = gl->fog.coordinate_source == GL_FOG_COORDINATE
                      ? gl->current.attribute[SECONDARY_AND_FOG][3]
                      : sqrtf(forward_dot_3(eye, eye));
    memset(units, 0, sizeof units);
    memset(&space, 0, sizeof space);
    follow_current_color(gl);
    set_eye_space(gl, set_texture_units(gl, units), &space);
    set_normal(gl, &space, normal);
    if (gl->lighting.enabled) {
        light_raster_position(gl, &space, vertex, normal, r->color, r->secondary_color);
    } else {
        memcpy(r->color, gl->current.attribute[COLOR], sizeof r->color);
        memcpy(r->secondary_color, gl->current.attribute[SECONDARY_AND_FOG], sizeof(GLfloat[3]));
        r->secondary_color[3] = 1.0f;
    }
    set_coordinates(gl, vertex, eye, normal);
    if (gl->render_mode == GL_SELECT)
        note_hit(gl, r->position[2]);
}

void set_window_position(context *gl, GLfloat x, GLfloat y, GLfloat z)
{
    raster_position_state *const r = &gl->raster_position;
    const GLfloat *const range = gl->transform.depth_range;
    const GLfloat depth = !(z > 0.0f) ? 0.0f : z > 1.0f ? 1.0f : z;

    r->position[0] = x;
    r->position[1] = y;
    r->position[2] = depth * (range[1] - range[0]) + range[0];
    r->position[3] = 1.0f;
    r->distance = gl->fog.coordinate_source == GL_FOG_COORDINATE
                      ? gl->current.attribute[SECONDARY_AND_FOG][3]
                      : 0.0f;
    for (int c = 0; c < 4; ++c) {
        r->color[c] = clamped_color(gl->current.attribute[COLOR][c]);
        r->secondary_color[c] =
            c == 3 ? 1.0f : clamped_color(gl->current.attribute[SECONDARY_AND_FOG][c]);
    }
    memcpy(r->coordinate, gl->current.attribute[TEXTURE_COORDINATE], sizeof r->coordinate);
    r->is_valid = GL_TRUE;
    if (gl->render_mode == GL_SELECT)
        note_hit(gl, r->position[2]);
}
