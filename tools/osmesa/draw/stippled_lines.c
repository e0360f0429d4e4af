#include "stippled_lines.h"

#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "prepared_draw.h"
#include "draw_state.h"
#include "unfilled.h"
#include "../framebuffer/framebuffer_view.h"
#include "../render_mode/primitive_stages.h"

/* Pieces are drawn when so many vertices wait. */
enum { MOST_WAITING = 512, PATTERN_BITS = 16 };

/* Clip coordinates are those of the window over a power of two, which is exact. The greatest
 * viewport reaches so far from its centre: 0, or for larger targets this. */
#define WINDOW_RANGE ((float)GN_MAX_SIZE / 2.0f)

/* No line in a viewport is longer. */
#define MOST_LENGTH (4.0f * (float)GN_MAX_SIZE)

/* What the shaders read. Values are linear in the window: those of the vertices times 1 / w, which
 * is a varying of its own, as the reference interpolates them. */
typedef struct piece_uniforms {
    const fixed_function *fixed;
    const shaded_vertex *vertex;
    const gn_program *program; /* that of lines without a pattern */
    float center[2];           /* of the viewport */
    float up;                  /* 1, or -1 in an upside-down viewport, whose ties differ */
} piece_uniforms;

typedef struct stippler {
    context *gl;
    const char *function;
    shaded_vertex *waiting;
    uint32_t count;
} stippler;

static void piece_vertex(const void *uniforms, const gn_vertex_input *input,
                         gn_vertex_output *output)
{
    const piece_uniforms *const u = uniforms;
    const uint32_t varyings = u->program->varying_count;

    for (uint32_t l = 0; l < input->count; ++l) {
        const shaded_vertex *const v = &u->vertex[input->vertex_id[l]];

        output->position[0][l] = (v->window[0] - u->center[0]) / WINDOW_RANGE;
        output->position[1][l] = (v->window[1] - u->center[1]) / (u->up * WINDOW_RANGE);
        output->position[2][l] = v->window[2];
        output->position[3][l] = 1.0f;
        for (uint32_t i = 0; i < varyings; ++i)
            output->varying[i][l] = u->program->interpolation[i] == GN_FLAT
                                        ? v->varying[i]
                                        : v->varying[i] * v->window[3];
        output->varying[varyings][l] = v->window[3];
    }
}

static void piece_fragment(const void *uniforms, const gn_fragment_input *input,
                           gn_fragment_output *output)
{
    const piece_uniforms *const u = uniforms;
    const uint32_t varyings = u->program->varying_count;
    const float *const one_over_w = input->varying[varyings];
    float varying[GN_MAX_VARYINGS][GN_LANES];
    gn_fragment_input corrected = *input;

    for (uint32_t i = 0; i < varyings; ++i)
        for (int l = 0; l < GN_LANES; ++l)
            varying[i][l] = u->program->interpolation[i] == GN_FLAT
                                ? input->varying[i][l]
                                : input->varying[i][l] * (1.0f / one_over_w[l]);
    corrected.varying = (const float(*)[GN_LANES])varying;
    fixed_fragment(u->fixed, &corrected, output);
}

/* Draws the pieces that wait. */
static void draw_pieces(stippler *s, const placement *place)
{
    piece_uniforms uniforms = {
        .fixed = place->fixed, .vertex = s->waiting, .program = place->program};
    framebuffer_view view;
    gn_mesh mesh = {.vertex_count = s->count, .count = s->count};
    gn_target target;
    gn_pipeline pipeline;
    gn_program *const program = &pipeline.program;

    if (!s->count || !set_target(s->gl, &target, s->function) ||
        !is_drawable_framebuffer(s->gl, &view, s->function))
        return;
    uniforms.center[0] = (float)view.width > WINDOW_RANGE ? WINDOW_RANGE : 0.0f;
    uniforms.center[1] = (float)view.height > WINDOW_RANGE ? WINDOW_RANGE : 0.0f;
    set_pipeline(s->gl, &pipeline);
    uniforms.up = pipeline.raster.viewport.height < 0.0f ? -1.0f : 1.0f;
    *program = *place->program;
    program->vertex_shader = piece_vertex;
    program->fragment_shader = piece_fragment;
    program->uniforms = &uniforms;
    program->clip_distance_count = 0;
    program->clip_plane = NULL;
    for (uint32_t i = 0; i < program->varying_count; ++i)
        if (program->interpolation[i] != GN_FLAT)
            program->interpolation[i] = GN_NOPERSPECTIVE;
    program->interpolation[program->varying_count++] = GN_NOPERSPECTIVE;
    pipeline.raster.topology = GN_LINES;
    pipeline.raster.viewport = (gn_viewport){.enabled = true,
                                             .x = uniforms.center[0] - WINDOW_RANGE,
                                             .y = uniforms.center[1] - uniforms.up * WINDOW_RANGE,
                                             .width = 2.0f * WINDOW_RANGE,
                                             .height = uniforms.up * 2.0f * WINDOW_RANGE};
    pipeline.depth.clip_depth = GN_ZERO_TO_ONE;
    pipeline.depth.range.z_near = 0.0f;
    pipeline.depth.range.z_far = 1.0f;
    mesh.attribute[0] =
        (gn_attribute){.data = s->waiting->window, .components = 4, .stride = sizeof *s->waiting};
    draw_prepared(s->gl, &target, &pipeline, &mesh, s->function);
    s->count = 0;
}

/* As in the reference, everything is linear in the window here. */
static void set_on_line(const shaded_vertex *a, const shaded_vertex *b, GLfloat t, shaded_vertex *v)
{
    for (int i = 0; i < 4; ++i)
        v->window[i] = a->window[i] + t * (b->window[i] - a->window[i]);
    for (int i = 0; i < GN_MAX_VARYINGS; ++i)
        v->varying[i] = a->varying[i] + t * (b->varying[i] - a->varying[i]);
}

static void add_piece(stippler *s, const placement *place, const shaded_vertex *a,
                      const shaded_vertex *b, GLfloat begin, GLfloat end)
{
    shaded_vertex *piece;

    if (s->count == MOST_WAITING)
        draw_pieces(s, place);
    piece = s->waiting + s->count;
    piece[0] = *a;
    piece[1] = *b;
    if (begin > 0.0f)
        set_on_line(a, b, begin, &piece[0]);
    if (end < 1.0f)
        set_on_line(a, b, end, &piece[1]);
    s->count += 2;
}

static bool has_bit(const raster_state *r, int place)
{
    return r->stipple_pattern >> (place / r->stipple_factor % PATTERN_BITS) & 1;
}

/* Returns a line's length in pixels of the pattern, which are those along its longer axis. */
static GLfloat pattern_length(const shaded_vertex *a, const shaded_vertex *b)
{
    const GLfloat x = fabsf(b->window[0] - a->window[0]), y = fabsf(b->window[1] - a->window[1]);

    return x > y ? x : y;
}

static void stipple_line(void *user, const placement *place, const shaded_vertex *a,
                         const shaded_vertex *b, bool begins_pattern)
{
    stippler *const s = user;
    GLint *const counter = &s->gl->stipple_counter;
    const raster_state *const r = &s->gl->raster;
    const GLfloat length = pattern_length(a, b);
    shaded_vertex first = *a;
    GLfloat begin = 0.0f;
    bool is_on = false;

    if (begins_pattern)
        *counter = 0;
    if (!(length <= MOST_LENGTH))
        return;
    copy_flat_varyings(place, b, &first);
    const int pixels = (int)ceilf(length);
    for (int i = 0; i < pixels; ++i) {
        const bool bit = has_bit(r, *counter + i);

        if (bit == is_on)
            continue;
        if (is_on)
            add_piece(s, place, &first, b, begin / length, (GLfloat)i / length);
        else
            begin = (GLfloat)i;
        is_on = bit;
    }
    if (is_on && begin < length)
        add_piece(s, place, &first, b, begin / length, 1.0f);
    *counter += pixels;
    /* Before it overflows, whole patterns are left out: a later line may have another factor. */
    if (*counter > INT32_MAX / 2)
        *counter %= r->stipple_factor * PATTERN_BITS;
}

static void begin_pattern(void *user)
{
    stippler *const s = user;

    s->gl->stipple_counter = 0;
}

static void skip_point(void *user, const placement *place, const shaded_vertex *v)
{
    (void)user;
    (void)place;
    (void)v;
}

static void skip_triangle(void *user, const placement *place, const shaded_vertex *const v[3])
{
    (void)user;
    (void)place;
    (void)v;
}

static void finish(void *user, const placement *place)
{
    draw_pieces(user, place);
}

bool draws_stippled_lines(const context *gl, GLenum mode)
{
    const raster_state *const r = &gl->raster;

    if (!r->line_stipple || mode == GL_POINTS || (mode >= GL_TRIANGLES && r->offset_line))
        return false;
    for (int side = 0; mode >= GL_TRIANGLES && side < 2; ++side)
        if (!(r->cull && r->cull_face != (side ? GL_FRONT : GL_BACK)) &&
            r->polygon_mode[side] != GL_LINE)
            return false;
    return true;
}

void draw_stippled_lines(context *gl, GLenum mode, const gn_mesh *mesh, const char *function)
{
    stippler s = {.gl = gl, .function = function};
    const primitive_sink sink = {.user = &s,
                                 .point = skip_point,
                                 .line = stipple_line,
                                 .triangle = skip_triangle,
                                 .begin_pattern = begin_pattern,
                                 .finish = finish};

    s.waiting = scratch_memory(gl, &gl->corners, MOST_WAITING * sizeof *s.waiting, function);
    if (s.waiting)
        pass_primitives(gl, mode, mesh, &sink, function);
}
