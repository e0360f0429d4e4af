/* The GLSL twins of sampled.h, one for each kind of sampler. */
#include "gl.h"

static const char vertex[] = "smooth out vec4 shade;\n"
                             "smooth out vec4 coordinates;\n"
                             "void main()\n"
                             "{\n"
                             "    gl_Position = clip_from_model * position;\n"
                             "    shade = color;\n"
                             "    coordinates = texcoord;\n"
                             "}\n";

/* The type of a sampler, and the expression that reads a texel. */
static const char fragment[] = "smooth in vec4 shade;\n"
                               "smooth in vec4 coordinates;\n"
                               "layout(binding = 0) uniform %s image;\n"
                               "layout(location = 0) out vec4 result;\n"
                               "void main() { result = shade * %s; }\n";

enum { COLORS, DEPTHS, COMPARED };

typedef struct sampler_kind {
    const char *type, *texel;
} sampler_kind;

/* In the order of gn_texture_target. For depths only red is the same in all versions of OpenGL. */
static const sampler_kind kinds[SAMPLED_PROGRAMS / 3][3] = {
    {{"sampler2D", "texture(image, coordinates.st)"},
     {"sampler2D", "vec4(texture(image, coordinates.st).r, 0.0, 0.0, 1.0)"},
     {"sampler2DShadow", "vec4(texture(image, coordinates.stq), 0.0, 0.0, 1.0)"}},
    {{"sampler1D", "texture(image, coordinates.s)"},
     {"sampler1D", "vec4(texture(image, coordinates.s).r, 0.0, 0.0, 1.0)"},
     {"sampler1DShadow", "vec4(texture(image, coordinates.stq), 0.0, 0.0, 1.0)"}},
    {{"sampler2DArray", "texture(image, coordinates.stp)"},
     {"sampler2DArray", "vec4(texture(image, coordinates.stp).r, 0.0, 0.0, 1.0)"},
     {"sampler2DArrayShadow", "vec4(texture(image, coordinates), 0.0, 0.0, 1.0)"}},
    {{"sampler3D", "texture(image, coordinates.stp)"}, {NULL, NULL}, {NULL, NULL}},
    {{"samplerCube", "texture(image, coordinates.stp)"},
     {"samplerCube", "vec4(texture(image, coordinates.stp).r, 0.0, 0.0, 1.0)"},
     {"samplerCubeShadow", "vec4(texture(image, coordinates), 0.0, 0.0, 1.0)"}},
};

GLuint reference_sampled_program(reference *r, const scene_draw *d, char *error, size_t error_size)
{
    const scene_uniforms *const u = &d->uniforms;
    const bool clipped = d->state.program.clip_distance_count > 0;
    const int what = reference_is_compared(&u->texture, &u->sampler) ? COMPARED
                     : scene_is_color_format(u->texture.format)      ? COLORS
                                                                     : DEPTHS;
    const sampler_kind *const kind = &kinds[u->texture.target][what];
    GLuint *const program = &r->sampled_programs[clipped][3 * (int)u->texture.target + what];

    if (!kind->type) {
        reference_fail(error, error_size, "OpenGL has no 3D textures of depths");
        return 0;
    }
    if (!*program) {
        char text[sizeof fragment + 128];

        snprintf(text, sizeof text, fragment, kind->type, kind->texel);
        *program = reference_link_clipped(vertex, text, clipped, error, error_size);
    }
    return *program;
}
