/* Lookups by the reference: a triangle over the grid, drawn into floats. Coordinates come from
 * textures, texel by texel, so that they are exact. */
#include "gl.h"

#include <stdio.h>
#include <string.h>

#include "lookups.h"

static const GLenum targets[] = {GL_TEXTURE_2D, GL_TEXTURE_1D, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_3D,
                                 GL_TEXTURE_CUBE_MAP};

/* Compatibility profile only: what a depth texture returns besides red. In the core profile that is
 * 0, 0, 1. */
#define DEPTH_TEXTURE_MODE 0x884B

/* From EXT_texture_filter_anisotropic. */
#define MAX_ANISOTROPY 0x84FE

static const char vertex_text[] =
    "void main() {\n"
    "  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, "
    "1.0);\n"
    "}\n";

/* The fragment shader of a kind of lookup in a target. */
static void write_shader(const lookup_case *c, char *text, size_t size)
{
    static const char *const samplers[] = {"2D", "1D", "2DArray", "3D", "Cube"};
    static const char *const coordinates[] = {"xy", "x", "xyz", "xyz", "xyz"};
    static const char *const gradients[] = {"xy", "x", "xy", "xyz", "xyz"};
    static const char *const integers[] = {"ivec2", "int", "ivec3", "ivec3", "ivec3"};
    const char *const along = gradients[c->target];
    const bool compares = c->sampler.compare != GN_COMPARE_DEFAULT;
    /* The reference value of comparisons is a component of the coordinates, except in gathers. */
    static const char *const compared[] = {"vec3(p.xy, dx.w)", "vec3(p.x, 0.0, dx.w)",
                                           "vec4(p.xyz, dx.w)", "", "vec4(p.xyz, dx.w)"};
    char at[32], call[160];

    snprintf(at, sizeof at, compares && c->kind != LOOKUP_GATHER ? "%s" : "p.%s",
             compares && c->kind != LOOKUP_GATHER ? compared[c->target] : coordinates[c->target]);
    switch (c->kind) {
    case LOOKUP_IMPLICIT:
        snprintf(call, sizeof call, "texture(image, %s)", at);
        break;
    case LOOKUP_BIAS:
        snprintf(call, sizeof call, "texture(image, %s, p.w)", at);
        break;
    case LOOKUP_LOD:
        snprintf(call, sizeof call, "textureLod(image, %s, p.w)", at);
        break;
    case LOOKUP_GRADIENTS:
        snprintf(call, sizeof call, "textureGrad(image, %s, dx.%s, dy.%s)", at, along, along);
        break;
    case LOOKUP_GATHER:
        if (compares)
            snprintf(call, sizeof call, "textureGather(image, %s, dx.w)", at);
        else
            snprintf(call, sizeof call, "textureGather(image, %s, %d)", at, c->channel);
        break;
    default:
        snprintf(call, sizeof call, "texelFetch(image, %s(%s), int(p.w))", integers[c->target], at);
    }
    snprintf(text, size,
             "layout(binding = 0) uniform sampler%s%s image;\n"
             "layout(binding = 1) uniform sampler2D places;\n"
             "layout(binding = 2) uniform sampler2D gradients_x;\n"
             "layout(binding = 3) uniform sampler2D gradients_y;\n"
             "out vec4 texel;\n"
             "void main() {\n"
             "  vec4 p = texelFetch(places, ivec2(gl_FragCoord.xy), 0);\n"
             "  vec4 dx = texelFetch(gradients_x, ivec2(gl_FragCoord.xy), 0);\n"
             "  vec4 dy = texelFetch(gradients_y, ivec2(gl_FragCoord.xy), 0);\n"
             "  texel = %s%s%s;\n"
             "}\n",
             samplers[c->target], compares ? "Shadow" : "",
             compares && c->kind != LOOKUP_GATHER ? "vec4(" : "", call,
             compares && c->kind != LOOKUP_GATHER ? ", 0.0, 0.0, 1.0)" : "");
}

/* Kept from one case to the next. */
static GLuint program_of(const lookup_case *c, char *error, size_t error_size)
{
    static GLuint programs[2][5][LOOKUP_KINDS][4];
    GLuint *const program = &programs[c->sampler.compare != GN_COMPARE_DEFAULT][c->target][c->kind]
                                     [c->kind == LOOKUP_GATHER ? c->channel : 0];
    char text[1024];

    if (!*program) {
        write_shader(c, text, sizeof text);
        *program = reference_link(vertex_text, text, error, error_size);
    }
    return *program;
}

static GLint wrap_of(gn_wrap wrap)
{
    static const GLint wraps[] = {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT,
                                  GL_CLAMP_TO_BORDER, GL_MIRROR_CLAMP_TO_EDGE};

    return wraps[wrap];
}

static void set_sampler(GLuint name, const gn_sampler *s)
{
    static const GLint minifiers[] = {GL_NEAREST_MIPMAP_LINEAR,
                                      GL_NEAREST,
                                      GL_LINEAR,
                                      GL_NEAREST_MIPMAP_NEAREST,
                                      GL_LINEAR_MIPMAP_NEAREST,
                                      GL_LINEAR_MIPMAP_LINEAR};

    glSamplerParameteri(name, GL_TEXTURE_WRAP_S, wrap_of(s->wrap_s));
    glSamplerParameteri(name, GL_TEXTURE_WRAP_T, wrap_of(s->wrap_t));
    glSamplerParameteri(name, GL_TEXTURE_WRAP_R, wrap_of(s->wrap_r));
    glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER, minifiers[s->minify]);
    glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER,
                        s->magnify == GN_MAGNIFY_LINEAR ? GL_LINEAR : GL_NEAREST);
    glSamplerParameterf(name, GL_TEXTURE_LOD_BIAS, s->lod_bias);
    if (s->lod_clamp_enabled) {
        glSamplerParameterf(name, GL_TEXTURE_MIN_LOD, s->min_lod);
        glSamplerParameterf(name, GL_TEXTURE_MAX_LOD, s->max_lod);
    }
    if (s->max_anisotropy > 1)
        glSamplerParameterf(name, MAX_ANISOTROPY, (float)s->max_anisotropy);
    glSamplerParameterfv(name, GL_TEXTURE_BORDER_COLOR, s->border);
    if (s->compare != GN_COMPARE_DEFAULT) {
        glSamplerParameteri(name, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        glSamplerParameteri(name, GL_TEXTURE_COMPARE_FUNC,
                            (GLint)gl_comparison(s->compare, GL_LEQUAL));
    }
}

static void upload_level(const lookup_case *c, uint32_t n)
{
    const reference_image_format f = reference_image_format_of(c->format);
    const GLint level = (GLint)(c->base + n);
    uint32_t size[3];

    case_level_size(c, c->base + n, size);

    const GLsizei w = (GLsizei)size[0], h = (GLsizei)size[1], d = (GLsizei)size[2];
    const size_t texels = (size_t)w * size[1] * size[2];

    reference_turn_pixels(c->format, c->packed[n], texels, true);
    if (c->target == GN_TEXTURE_1D)
        glTexSubImage1D(GL_TEXTURE_1D, level, 0, w, f.format, f.type, c->packed[n]);
    else if (c->target == GN_TEXTURE_2D)
        glTexSubImage2D(GL_TEXTURE_2D, level, 0, 0, w, h, f.format, f.type, c->packed[n]);
    else if (c->target != GN_TEXTURE_CUBE)
        glTexSubImage3D(targets[c->target], level, 0, 0, 0, w, h, d, f.format, f.type,
                        c->packed[n]);
    for (GLenum face = 0; c->target == GN_TEXTURE_CUBE && face < 6; ++face)
        glTexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, 0, 0, w, h, f.format, f.type,
                        (const unsigned char *)c->packed[n] +
                            face * (texels / 6) * gn_format_size(c->format));
    reference_turn_pixels(c->format, c->packed[n], texels, false);
}

static GLuint upload(const lookup_case *c)
{
    const GLenum target = targets[c->target];
    const GLenum format = reference_image_format_of(c->format).internal;
    const GLsizei levels = (GLsizei)(c->base + c->level_count);
    const GLsizei w = (GLsizei)c->size[0], h = (GLsizei)c->size[1], d = (GLsizei)c->size[2];
    GLuint name;

    glGenTextures(1, &name);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(target, name);
    if (c->target == GN_TEXTURE_1D)
        glTexStorage1D(target, levels, format, w);
    else if (c->target == GN_TEXTURE_2D || c->target == GN_TEXTURE_CUBE)
        glTexStorage2D(target, levels, format, w, h);
    else
        glTexStorage3D(target, levels, format, w, h, d);
    glTexParameteri(target, DEPTH_TEXTURE_MODE, GL_RED);
    glTexParameteri(target, GL_TEXTURE_BASE_LEVEL, (GLint)c->base);
    glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, levels - 1);
    for (uint32_t n = 0; n < c->level_count; ++n)
        upload_level(c, n);
    return name;
}

static GLuint upload_grid(GLenum unit, const float (*values)[4])
{
    GLuint name;

    glGenTextures(1, &name);
    glActiveTexture(unit);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, GRID_WIDTH, GRID_HEIGHT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, GRID_WIDTH, GRID_HEIGHT, GL_RGBA, GL_FLOAT, values);
    return name;
}

/* The framebuffer of all cases. */
static void bind_framebuffer(void)
{
    static GLuint grid, color;

    if (!grid) {
        glGenFramebuffers(1, &grid);
        glBindFramebuffer(GL_FRAMEBUFFER, grid);
        glGenRenderbuffers(1, &color);
        glBindRenderbuffer(GL_RENDERBUFFER, color);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, GRID_WIDTH, GRID_HEIGHT);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
        glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, grid);
    glViewport(0, 0, GRID_WIDTH, GRID_HEIGHT);
}

bool opengl_lookup(const lookup_case *c, float (*texel)[4], char *error, size_t error_size)
{
    const GLuint program = program_of(c, error, error_size);
    GLuint names[4], sampler;

    if (!program)
        return false;
    bind_framebuffer();
    names[1] = upload_grid(GL_TEXTURE1, (const float(*)[4])c->places.place);
    names[2] = upload_grid(GL_TEXTURE2, (const float(*)[4])c->places.gradient_x);
    names[3] = upload_grid(GL_TEXTURE3, (const float(*)[4])c->places.gradient_y);
    names[0] = upload(c);
    glGenSamplers(1, &sampler);
    set_sampler(sampler, &c->sampler);
    glBindSampler(0, sampler);
    glUseProgram(program);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glReadPixels(0, 0, GRID_WIDTH, GRID_HEIGHT, GL_RGBA, GL_FLOAT, texel);
    glBindSampler(0, 0);
    glDeleteSamplers(1, &sampler);
    glDeleteTextures(4, names);
    return reference_check("looking textures up", error, error_size);
}
