/* Makes a target and a pipeline of OpenGL's state. */
#include "draw_state.h"

#include <gl_registry.h>
#include <string.h>

#include "../framebuffer/framebuffer_objects.h"
#include "../framebuffer/framebuffer_view.h"

static gn_compare comparison(GLenum function)
{
    return (gn_compare)(GN_NEVER + (function - GL_NEVER));
}

static gn_blend_factor factor_of(GLenum factor)
{
    switch (factor) {
    case GL_ZERO:
        return GN_FACTOR_ZERO;
    case GL_SRC_COLOR:
        return GN_FACTOR_SOURCE_COLOR;
    case GL_ONE_MINUS_SRC_COLOR:
        return GN_FACTOR_ONE_MINUS_SOURCE_COLOR;
    case GL_DST_COLOR:
        return GN_FACTOR_DESTINATION_COLOR;
    case GL_ONE_MINUS_DST_COLOR:
        return GN_FACTOR_ONE_MINUS_DESTINATION_COLOR;
    case GL_SRC_ALPHA:
        return GN_FACTOR_SOURCE_ALPHA;
    case GL_ONE_MINUS_SRC_ALPHA:
        return GN_FACTOR_ONE_MINUS_SOURCE_ALPHA;
    case GL_DST_ALPHA:
        return GN_FACTOR_DESTINATION_ALPHA;
    case GL_ONE_MINUS_DST_ALPHA:
        return GN_FACTOR_ONE_MINUS_DESTINATION_ALPHA;
    case GL_CONSTANT_COLOR:
        return GN_FACTOR_CONSTANT_COLOR;
    case GL_ONE_MINUS_CONSTANT_COLOR:
        return GN_FACTOR_ONE_MINUS_CONSTANT_COLOR;
    case GL_CONSTANT_ALPHA:
        return GN_FACTOR_CONSTANT_ALPHA;
    case GL_ONE_MINUS_CONSTANT_ALPHA:
        return GN_FACTOR_ONE_MINUS_CONSTANT_ALPHA;
    case GL_SRC_ALPHA_SATURATE:
        return GN_FACTOR_SOURCE_ALPHA_SATURATE;
    default:
        return GN_FACTOR_ONE;
    }
}

static gn_blend_equation equation_of(GLenum equation)
{
    switch (equation) {
    case GL_FUNC_SUBTRACT:
        return GN_EQUATION_SUBTRACT;
    case GL_FUNC_REVERSE_SUBTRACT:
        return GN_EQUATION_REVERSE_SUBTRACT;
    case GL_MIN:
        return GN_EQUATION_MIN;
    case GL_MAX:
        return GN_EQUATION_MAX;
    default:
        return GN_EQUATION_ADD;
    }
}

static gn_logic_operation logic_operation(GLenum function)
{
    static const gn_logic_operation operations[] = {
        GN_LOGIC_CLEAR,         GN_LOGIC_AND,         GN_LOGIC_AND_REVERSE, GN_LOGIC_COPY,
        GN_LOGIC_AND_INVERTED,  GN_LOGIC_NOOP,        GN_LOGIC_XOR,         GN_LOGIC_OR,
        GN_LOGIC_NOR,           GN_LOGIC_EQUIVALENT,  GN_LOGIC_INVERT,      GN_LOGIC_OR_REVERSE,
        GN_LOGIC_COPY_INVERTED, GN_LOGIC_OR_INVERTED, GN_LOGIC_NAND,        GN_LOGIC_SET};

    return operations[function - GL_CLEAR];
}

static gn_stencil_operation stencil_operation(GLenum operation)
{
    switch (operation) {
    case GL_ZERO:
        return GN_STENCIL_ZERO;
    case GL_REPLACE:
        return GN_STENCIL_REPLACE;
    case GL_INCR:
        return GN_STENCIL_INCREMENT;
    case GL_DECR:
        return GN_STENCIL_DECREMENT;
    case GL_INVERT:
        return GN_STENCIL_INVERT;
    case GL_INCR_WRAP:
        return GN_STENCIL_INCREMENT_WRAP;
    case GL_DECR_WRAP:
        return GN_STENCIL_DECREMENT_WRAP;
    default:
        return GN_STENCIL_KEEP;
    }
}

static gn_stencil_face stencil_face(const stencil_state *state)
{
    const GLint reference = state->reference < 0     ? 0
                            : state->reference > 255 ? 255
                                                     : state->reference;

    return (gn_stencil_face){
        .function = comparison(state->function),
        .reference = (uint8_t)reference,
        .compare_disabled = (uint8_t)~state->compare_mask,
        .write_disabled = (uint8_t)~state->write_mask,
        .fail = stencil_operation(state->fail),
        .depth_fail = stencil_operation(state->depth_fail),
        .pass = stencil_operation(state->pass),
    };
}

bool set_target(context *gl, gn_target *target, const char *function)
{
    framebuffer_view view;

    if (!is_drawable_framebuffer(gl, &view, function))
        return false;
    *target = view.target;
    for (int i = 0; i < GN_MAX_COLORS; ++i)
        if (target->color[i].format)
            return true;
    return target->depth.format != GN_FORMAT_NONE;
}

/* The window's rows go down, so the scissor's distance from the bottom becomes that from the top.
 */
void set_scissor(const context *gl, gn_scissor *scissor)
{
    const GLint *const box = gl->fragment.scissor_box;
    const int64_t top =
        gl->draw_framebuffer ? box[1] : (int64_t)gl->window.height - box[1] - box[3];

    scissor->enabled = gl->fragment.scissor;
    scissor->x = box[0];
    scissor->width = (uint32_t)box[2];
    scissor->y = (int32_t)(top < INT32_MIN ? INT32_MIN : top > INT32_MAX ? INT32_MAX : top);
    scissor->height = (uint32_t)box[3];
    if (top < INT32_MIN)
        scissor->height = 0;
}

static void set_raster(const context *gl, gn_raster *raster)
{
    const raster_state *const r = &gl->raster;
    const GLint *const viewport = gl->transform.viewport;

    /* A negative height places y upwards in rows that go down, and front faces turn the other way.
     */
    const bool rows_go_down = !gl->draw_framebuffer;
    const bool is_flipped = rows_go_down != (gl->transform.clip_origin == GL_UPPER_LEFT);
    const GLint bottom = viewport[1], top = viewport[1] + viewport[3];
    const GLint first = gl->transform.clip_origin == GL_UPPER_LEFT ? top : bottom;

    raster->viewport = (gn_viewport){.enabled = true,
                                     .x = (float)viewport[0],
                                     .y = (float)(rows_go_down ? gl->window.height - first : first),
                                     .width = (float)viewport[2],
                                     .height = (float)(is_flipped ? -viewport[3] : viewport[3])};
    raster->front_face =
        (r->front_face == GL_CCW) != is_flipped ? GN_FRONT_COUNTER_CLOCKWISE : GN_FRONT_CLOCKWISE;
    if (r->cull)
        raster->cull = r->cull_face == GL_FRONT  ? GN_CULL_FRONT
                       : r->cull_face == GL_BACK ? GN_CULL_BACK
                                                 : GN_CULL_FRONT_AND_BACK;
    /* As in the reference, those of points and lines offset filled polygons, too. */
    raster->polygon_offset.enabled = r->offset_fill || r->offset_line || r->offset_point;
    raster->polygon_offset.factor = r->offset_factor;
    raster->polygon_offset.units = r->offset_units;
    raster->point_size = r->point_size;
    raster->line_width = r->line_width;
    set_scissor(gl, &raster->scissor);
}

static void set_color(const fragment_state *f, gn_color *color)
{
    for (int channel = 0; channel < 4; ++channel)
        if (!f->color_mask[channel])
            color->write_disabled[0] |= 1u << channel;
    color->blend[0].enabled = f->blend;
    color->blend[0].equation = equation_of(f->blend_equation);
    color->blend[0].source = factor_of(f->blend_source);
    color->blend[0].destination = factor_of(f->blend_destination);
    color->blend[0].alpha_equation = equation_of(f->blend_alpha_equation);
    color->blend[0].alpha_source = factor_of(f->blend_alpha_source);
    color->blend[0].alpha_destination = factor_of(f->blend_alpha_destination);
    memcpy(color->blend_constant, f->blend_color, sizeof f->blend_color);
    color->logic_enabled = f->logic_operation;
    color->logic_operation = logic_operation(f->logic_function);
}

/* Repeats the state of the first colour, and keeps what a texture of red, green and blue lacks. */
static void set_attachments(const framebuffer_object *framebuffer, gn_color *color)
{
    const uint32_t write_disabled = color->write_disabled[0];

    for (int i = 0; i < GN_MAX_COLORS; ++i) {
        const int index = attachment_index(framebuffer->draw_buffer[i]);
        const attachment *const attached = index >= 0 ? &framebuffer->attached[index] : NULL;
        unsigned char bits[6] = {0};

        color->write_disabled[i] = write_disabled;
        color->blend[i] = color->blend[0];
        if (attached && attached_surface(attached, bits).format && !bits[3])
            color->write_disabled[i] |= GN_CHANNEL_ALPHA;
    }
}

void set_pipeline(const context *gl, gn_pipeline *pipeline)
{
    const fragment_state *const f = &gl->fragment;

    memset(pipeline, 0, sizeof *pipeline);
    set_raster(gl, &pipeline->raster);
    pipeline->depth.test_enabled = f->depth_test;
    pipeline->depth.function = comparison(f->depth_function);
    pipeline->depth.write_disabled = !f->depth_mask;
    pipeline->depth.clip_depth =
        gl->transform.clip_depth == GL_ZERO_TO_ONE ? GN_ZERO_TO_ONE : GN_NEGATIVE_ONE_TO_ONE;
    pipeline->depth.range.enabled = true;
    pipeline->depth.range.z_near = gl->transform.depth_range[0];
    pipeline->depth.range.z_far = gl->transform.depth_range[1];
    pipeline->stencil.test_enabled = f->stencil_test;
    pipeline->stencil.front = stencil_face(&f->stencil[0]);
    pipeline->stencil.back = stencil_face(&f->stencil[1]);
    set_color(f, &pipeline->color);
    if (gl->draw_framebuffer)
        set_attachments(gl->draw_framebuffer, &pipeline->color);
}
