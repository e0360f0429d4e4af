/* Reading the samples of a framebuffer: shaders fetch each sample and write it as floats, from
 * which the pixel's bits are computed. Reads the resolved pixels too. */
#include "gl.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "scene_pixel.h"

/* A triangle that covers the whole viewport. */
static const char vertex_shader[] =
    "void main()\n"
    "{\n"
    "    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0,\n"
    "                       0.0, 1.0);\n"
    "}\n";

static const char fetch_number[] =
    "layout(binding = 0) uniform sampler2DMS image;\n"
    "layout(location = 7) uniform int number;\n"
    "layout(location = 0) out vec4 result;\n"
    "void main() { result = texelFetch(image, ivec2(gl_FragCoord.xy), number); }\n";

static const char fetch_stencil[] =
    "layout(binding = 0) uniform usampler2DMS image;\n"
    "layout(location = 7) uniform int number;\n"
    "layout(location = 0) out vec4 result;\n"
    "void main() { result = vec4(texelFetch(image, ivec2(gl_FragCoord.xy), number)); }\n";

static void switch_on(GLenum capability, bool on)
{
    if (on)
        glEnable(capability);
    else
        glDisable(capability);
}

void reference_set_sample_state(const gn_pipeline *p)
{
    switch_on(GL_SAMPLE_ALPHA_TO_COVERAGE, p->samples.alpha_to_coverage_enabled);
    switch_on(GL_SAMPLE_ALPHA_TO_ONE, p->samples.alpha_to_one_enabled);
    switch_on(GL_SAMPLE_MASK, p->samples.write_disabled != 0);
    glSampleMaski(0, ~(GLbitfield)p->samples.write_disabled);
    switch_on(GL_SAMPLE_SHADING, p->samples.shading_enabled);
    glMinSampleShading(p->samples.least_shading);
}

static void reset_state(const scene *s)
{
    const gn_pipeline defaults = {0};

    reference_set_sample_state(&defaults);
    static const GLenum off[] = {GL_SCISSOR_TEST, GL_DEPTH_TEST,          GL_STENCIL_TEST,
                                 GL_CULL_FACE,    GL_COLOR_LOGIC_OP,      GL_BLEND,
                                 GL_DEPTH_CLAMP,  GL_POLYGON_OFFSET_FILL, GL_PROGRAM_POINT_SIZE};

    for (size_t i = 0; i < sizeof off / sizeof *off; ++i)
        glDisable(off[i]);
    for (GLenum i = 0; i < GN_MAX_CLIP_DISTANCES; ++i)
        glDisable(GL_CLIP_DISTANCE0 + i);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glViewportIndexedf(0, 0.0f, 0.0f, (float)s->width, (float)s->height);
}

/* Writes one sample of every pixel of a texture into `values`, four floats each. */
static void fetch(const scene *s, GLuint program, GLuint texture, GLint sample, float *values)
{
    glUseProgram(program);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
    glUniform1i(7, sample);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glReadPixels(0, 0, (GLsizei)s->width, (GLsizei)s->height, GL_RGBA, GL_FLOAT, values);
}

/* The float that the reference makes of a depth of 24 bits: the product with a binary32 reciprocal,
 * which is a little above 2^-24. The highest two depths become 1. */
static float depth24_as_read(uint32_t value)
{
    return (float)value * (float)(1.0 / 16777215.0);
}

static uint32_t depth24_of(float z)
{
    uint32_t value = (uint32_t)fmin(lrint((double)z * 16777215.0) + 2.0, 16777215.0);

    while (value > 0 && depth24_as_read(value) > z)
        --value;
    return z >= 1.0f ? 16777215 : value;
}

/* Mesa resolves depths of 24 bits through these floats, which changes depths by a step
 * (reference/RULES.md). If that is the whole difference, the depth of sample 0 replaces the
 * resolved one. */
static void undo_depth24(const scene *s, void *depth)
{
    const size_t pixels = (size_t)s->width * s->height;
    const uint32_t *const sample = depth;
    uint32_t *const resolved = (uint32_t *)depth + pixels * GN_SAMPLES;

    for (size_t i = 0; i < pixels; ++i) {
        const float read = depth24_as_read(sample[i] & 0xFFFFFF);
        const float scaled = read >= 1.0f ? 16777215.0f : read * 16777215.0f;

        if ((resolved[i] & 0xFFFFFF) == (uint32_t)lrintf(scaled))
            resolved[i] = (resolved[i] & ~UINT32_C(0xFFFFFF)) | (sample[i] & 0xFFFFFF);
    }
}

static void store_depth(const scene *s, void *depth, size_t i, float z)
{
    uint32_t *const words = depth;

    switch (s->depth_format) {
    case GN_FORMAT_D16:
        ((uint16_t *)depth)[i] = (uint16_t)lrintf(z * 65535.0f);
        break;
    case GN_FORMAT_D24:
    case GN_FORMAT_D24S8:
        words[i] = depth24_of(z);
        break;
    case GN_FORMAT_D32F:
        memcpy(&words[i], &z, sizeof z);
        break;
    case GN_FORMAT_D32FS8:
        memcpy(&words[2 * i], &z, sizeof z);
        words[2 * i + 1] = 0;
        break;
    default:
        break;
    }
}

static void store_stencil(const scene *s, void *depth, size_t i, uint32_t stencil)
{
    uint32_t *const words = depth;

    switch (s->depth_format) {
    case GN_FORMAT_D24S8:
        words[i] |= stencil << 24;
        break;
    case GN_FORMAT_D32FS8:
        words[2 * i + 1] = stencil;
        break;
    case GN_FORMAT_S8:
        ((uint8_t *)depth)[i] = (uint8_t)stencil;
        break;
    default:
        break;
    }
}

static void read_sample(reference *r, const scene *s, const framebuffer *f, uint32_t sample,
                        float *values, scene_frame *frame)
{
    const size_t pixels = (size_t)s->width * s->height;
    char *depth = frame->depth;

    for (int a = 0; a < GN_MAX_COLORS; ++a) {
        const gn_format format = scene_color_format(s, a);

        if (format == GN_FORMAT_NONE)
            continue;
        char *const color =
            (char *)scene_frame_color(frame, a) + pixels * sample * gn_format_size(format);

        fetch(s, r->sample_programs[0], f->color[a], (GLint)sample, values);
        for (size_t i = 0; i < pixels; ++i)
            scene_pixel_store(color, format, i, values + 4 * i);
    }
    if (depth)
        depth += pixels * sample * gn_format_size(s->depth_format);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, f->depth);
    if (scene_has_depth(s->depth_format)) {
        if (scene_has_stencil(s->depth_format)) {
            glTexParameteri(GL_TEXTURE_2D_MULTISAMPLE, GL_DEPTH_STENCIL_TEXTURE_MODE,
                            GL_DEPTH_COMPONENT);
        }
        fetch(s, r->sample_programs[0], f->depth, (GLint)sample, values);
        for (size_t i = 0; i < pixels; ++i)
            store_depth(s, depth, i, values[4 * i]);
    }
    if (scene_has_stencil(s->depth_format)) {
        glTexParameteri(GL_TEXTURE_2D_MULTISAMPLE, GL_DEPTH_STENCIL_TEXTURE_MODE, GL_STENCIL_INDEX);
        fetch(s, r->sample_programs[1], f->depth, (GLint)sample, values);
        for (size_t i = 0; i < pixels; ++i)
            store_stencil(s, depth, i, (uint32_t)values[4 * i]);
    }
}

bool reference_read_samples(reference *r, const scene *s, const framebuffer *f, scene_frame *frame,
                            char *error, size_t error_size)
{
    const GLint width = (GLint)s->width;
    const GLint height = (GLint)s->height;
    const GLuint source = f->name;
    const framebuffer samples = *f;
    scene single = *s;
    scene floats = *s;
    float *values;

    if (!r->sample_programs[0]) {
        r->sample_programs[0] = reference_link(vertex_shader, fetch_number, error, error_size);
        r->sample_programs[1] = reference_link(vertex_shader, fetch_stencil, error, error_size);
    }
    if (!r->sample_programs[0] || !r->sample_programs[1])
        return false;
    reset_state(s);
    single.samples = 0;
    floats.samples = 0;
    floats.color_format = GN_FORMAT_RGBA32F;
    floats.depth_format = GN_FORMAT_NONE;
    memset(floats.more_colors, 0, sizeof floats.more_colors);
    if (!reference_framebuffer(r, &single, error, error_size))
        return false;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, source);
    for (int a = 0; a < GN_MAX_COLORS; ++a) {
        if (scene_color_format(s, a) != GN_FORMAT_NONE) {
            glReadBuffer((GLenum)(GL_COLOR_ATTACHMENT0 + a));
            glDrawBuffer((GLenum)(GL_COLOR_ATTACHMENT0 + a));
            glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                              GL_NEAREST);
        }
    }
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height,
                      (scene_has_depth(s->depth_format) ? GL_DEPTH_BUFFER_BIT : 0) |
                          (scene_has_stencil(s->depth_format) ? GL_STENCIL_BUFFER_BIT : 0),
                      GL_NEAREST);
    framebuffer_choose_colors(s, GN_MAX_COLORS);
    if (!reference_framebuffer(r, &single, error, error_size))
        return false;
    reference_read_image(s, GN_SAMPLES, frame);
    if (!reference_framebuffer(r, &floats, error, error_size))
        return false;
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    values = malloc((size_t)s->width * s->height * 4 * sizeof *values);
    if (!values)
        return reference_fail(error, error_size, "out of memory");
    for (uint32_t sample = 0; sample < GN_SAMPLES; ++sample)
        read_sample(r, s, &samples, sample, values, frame);
    free(values);
    if (s->depth_format == GN_FORMAT_D24 || s->depth_format == GN_FORMAT_D24S8)
        undo_depth24(s, frame->depth);
    return reference_check("reading samples", error, error_size);
}
