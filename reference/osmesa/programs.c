/* The GLSL twins of the ready-made shaders, of phong.h, inputs.h and outputs.h. Their expressions
 * have the library's order of operations. */
#include "gl.h"

#include <string.h>

static const char vertex_color_main[] = "void main()\n"
                                        "{\n"
                                        "    gl_Position = clip_from_model * position;\n"
                                        "    red = color.r;\n"
                                        "    green = color.g;\n"
                                        "    blue = color.b;\n"
                                        "    alpha = color.a;\n"
                                        "    %s\n"
                                        "    %s\n"
                                        "}\n";

static const char vertex_color_fragment_main[] = "layout(location = 0) out vec4 result;\n"
                                                 "void main()\n"
                                                 "{\n"
                                                 "    result = vec4(red, green, blue, alpha);\n"
                                                 "}\n";

static const char derivatives_fragment_main[] =
    "layout(location = 0) out vec4 result;\n"
    "void main()\n"
    "{\n"
    "    result = vec4(dFdx(red), dFdy(green), fwidth(blue), dFdy(alpha * red));\n"
    "}\n";

static const char flat_vertex[] = "flat out vec4 shade;\n"
                                  "void main()\n"
                                  "{\n"
                                  "    gl_Position = clip_from_model * position;\n"
                                  "    shade = lit();\n"
                                  "}\n";

static const char flat_fragment[] = "#version 450 core\n"
                                    "flat in vec4 shade;\n"
                                    "layout(location = 0) out vec4 result;\n"
                                    "void main() { result = shade; }\n";

static const char gouraud_vertex[] = "smooth out vec4 shade;\n"
                                     "void main()\n"
                                     "{\n"
                                     "    gl_Position = clip_from_model * position;\n"
                                     "    shade = lit();\n"
                                     "}\n";

static const char gouraud_fragment[] = "#version 450 core\n"
                                       "smooth in vec4 shade;\n"
                                       "layout(location = 0) out vec4 result;\n"
                                       "void main() { result = shade; }\n";

static const char textured_vertex[] = "smooth out vec4 shade;\n"
                                      "smooth out vec2 coordinates;\n"
                                      "void main()\n"
                                      "{\n"
                                      "    gl_Position = clip_from_model * position;\n"
                                      "    shade = lit();\n"
                                      "    coordinates = texcoord.st;\n"
                                      "}\n";

static const char textured_fragment[] =
    "#version 450 core\n"
    "smooth in vec4 shade;\n"
    "smooth in vec2 coordinates;\n"
    "layout(binding = 0) uniform sampler2D image;\n"
    "layout(location = 0) out vec4 result;\n"
    "void main() { result = shade * texture(image, coordinates); }\n";

static const char phong_vertex[] = "layout(location = 5) uniform mat4 view_from_model;\n"
                                   "smooth out vec3 turned_normal;\n"
                                   "smooth out vec3 to_eye;\n"
                                   "smooth out vec2 coordinates;\n"
                                   "void main()\n"
                                   "{\n"
                                   "    gl_Position = clip_from_model * position;\n"
                                   "    turned_normal = normal_matrix * normal.xyz;\n"
                                   "    to_eye = -(view_from_model * position).xyz;\n"
                                   "    coordinates = texcoord.st;\n"
                                   "}\n";

static const char phong_fragment[] =
    "#version 450 core\n"
    "smooth in vec3 turned_normal;\n"
    "smooth in vec3 to_eye;\n"
    "smooth in vec2 coordinates;\n"
    "layout(location = 2) uniform vec3 light_direction;\n"
    "layout(location = 3) uniform vec3 ambient;\n"
    "layout(location = 4) uniform vec3 diffuse;\n"
    "layout(location = 6) uniform vec3 specular;\n"
    "layout(binding = 0) uniform sampler2D image;\n"
    "layout(location = 0) out vec4 result;\n"
    "void main()\n"
    "{\n"
    "    vec4 texel = texture(image, coordinates);\n"
    "    vec3 n = normalize(turned_normal);\n"
    "    vec3 v = normalize(to_eye);\n"
    "    vec3 r = reflect(-light_direction, n);\n"
    "    float lit = max(dot(n, light_direction), 0.0);\n"
    "    float power = max(dot(r, v), 0.0);\n"
    "    power = power * power;\n"
    "    power = power * power;\n"
    "    power = power * power;\n"
    "    power = power * power;\n"
    "    power = power * power;\n"
    "    result = vec4(texel.rgb * (ambient + diffuse * lit) + specular * power, texel.a);\n"
    "}\n";

static const char inputs_vertex[] = "void main()\n"
                                    "{\n"
                                    "    gl_Position = clip_from_model * position;\n"
                                    "    shade = color;\n"
                                    "    %s\n"
                                    "    %s\n"
                                    "}\n";

static const char set_point_size[] = "gl_PointSize = texcoord.s;";

static const char inputs_fragment[] = "layout(location = 0) out vec4 result;\n"
                                      "void main()\n"
                                      "{\n"
                                      "    vec4 c = shade;\n"
                                      "    c.r = gl_FrontFacing ? c.r : 1.0 - c.r;\n"
                                      "#ifdef PRIMITIVE\n"
                                      "    c.g = c.g + float(gl_PrimitiveID & 1023) * 0.015625;\n"
                                      "#endif\n"
                                      "#ifdef POINT\n"
                                      "    c.rg = gl_PointCoord;\n"
                                      "#endif\n"
                                      "#ifdef POSITION\n"
                                      "    c.r = c.r + gl_FragCoord.x * 0.0078125;\n"
                                      "    c.g = c.g + gl_FragCoord.y * 0.0078125;\n"
                                      "    c.ba = gl_FragCoord.zw;\n"
                                      "#endif\n"
                                      "#ifdef SAMPLES\n"
                                      "    c.g = c.g + float(gl_SampleMaskIn[0]) * 0.0625;\n"
                                      "#endif\n"
                                      "#ifdef MASK\n"
                                      "    ivec2 at = ivec2(gl_FragCoord.xy);\n"
                                      "    gl_SampleMask[0] = at.x * 3 + at.y * 5;\n"
                                      "#ifdef SAMPLES\n"
                                      "    gl_SampleMask[0] ^= gl_SampleMaskIn[0];\n"
                                      "#endif\n"
                                      "#endif\n"
                                      "#ifdef DISCARD\n"
                                      "    if (shade.a < 0.5)\n"
                                      "        discard;\n"
                                      "#endif\n"
                                      "#ifdef DEPTH\n"
                                      "    gl_FragDepth = shade.b;\n"
                                      "#endif\n"
                                      "#ifdef SAMPLE\n"
                                      "    c.rb = c.rb + gl_SamplePosition * 0.25;\n"
                                      "    c.g = c.g + float(gl_SampleID) * 0.125;\n"
                                      "#endif\n"
                                      "    result = c;\n"
                                      "}\n";

/* A program that writes vertex colours or their derivatives. The colour is four scalars, because
 * each varying may have its own qualifiers. */
static GLuint link_colors(const scene_draw *d, const char *fragment_main, bool clipped, char *error,
                          size_t error_size)
{
    const gn_program *const p = &d->state.program;
    static const char *const names[] = {"red", "green", "blue", "alpha"};
    located_texts texts = {"", "", ""};
    char vertex[2 * LOCATED_TEXT + 512];
    char fragment[2048];
    int used;

    for (int c = 0; c < 4; ++c)
        reference_declare(d, c, p->interpolation[c], "float", names[c], &texts);
    used = snprintf(vertex, sizeof vertex, "%s", texts.outs);
    snprintf(vertex + used, sizeof vertex - (size_t)used, vertex_color_main,
             p->vertex_writes_point_size ? set_point_size : "", texts.divisions);
    snprintf(fragment, sizeof fragment, "%s%s", texts.ins, fragment_main);
    return reference_link_parts(vertex, "#version 450 core\n", fragment, clipped, error,
                                error_size);
}

static GLuint link_inputs(const scene_draw *d, bool clipped, char *error, size_t error_size)
{
    const gn_program *const p = &d->state.program;
    located_texts texts = {"", "", ""};
    char vertex[2 * LOCATED_TEXT + 512];
    char head[LOCATED_TEXT + 256];
    int used;

    reference_declare(d, 0, GN_SMOOTH, "vec4", "shade", &texts);
    used = snprintf(vertex, sizeof vertex, "%s", texts.outs);
    snprintf(vertex + used, sizeof vertex - (size_t)used, inputs_vertex,
             p->vertex_writes_point_size ? set_point_size : "", texts.divisions);
    snprintf(head, sizeof head, "#version 450 core\n%s%s%s%s%s%s%s%s%s",
             p->fragment_reads_point_coordinate ? "#define POINT\n" : "",
             p->fragment_reads_primitive ? "#define PRIMITIVE\n" : "",
             p->fragment_reads_position ? "#define POSITION\n" : "",
             p->fragment_discards ? "#define DISCARD\n" : "",
             p->fragment_writes_depth ? "#define DEPTH\n" : "",
             p->fragment_reads_sample_mask ? "#define SAMPLES\n" : "",
             p->fragment_reads_sample ? "#define SAMPLE\n" : "",
             p->fragment_writes_sample_mask ? "#define MASK\n" : "", texts.ins);
    return reference_link_parts(vertex, head, inputs_fragment, clipped, error, error_size);
}

/* One line per output: colour a is the colour with its channels turned by a places, and one minus
 * that for odd a. The vertex shader is that of inputs.h. */
static GLuint link_outputs(uint32_t count, bool clipped, char *error, size_t error_size)
{
    static const char *const turned[4] = {"rgba", "gbar", "barg", "argb"};
    char vertex[sizeof inputs_vertex + 32];
    char fragment[2048];
    size_t used = (size_t)snprintf(fragment, sizeof fragment, "smooth in vec4 shade;\n");

    for (uint32_t a = 0; a < count; ++a) {
        used += (size_t)snprintf(fragment + used, sizeof fragment - used,
                                 "layout(location = %u) out vec4 result%u;\n", a, a);
    }
    used += (size_t)snprintf(fragment + used, sizeof fragment - used, "void main()\n{\n");
    for (uint32_t a = 0; a < count; ++a) {
        used += (size_t)snprintf(fragment + used, sizeof fragment - used,
                                 "    result%u = %sshade.%s;\n", a, a % 2 ? "1.0 - " : "",
                                 turned[a % 4]);
    }
    snprintf(fragment + used, sizeof fragment - used, "}\n");
    const int declared = snprintf(vertex, sizeof vertex, "smooth out vec4 shade;\n");

    snprintf(vertex + declared, sizeof vertex - (size_t)declared, inputs_vertex, "", "");
    return reference_link_parts(vertex, "#version 450 core\n", fragment, clipped, error,
                                error_size);
}

GLuint reference_program(reference *r, const scene_draw *d, char *error, size_t error_size)
{
    const bool clipped = d->state.program.clip_distance_count > 0;
    GLuint *program = &r->lit_programs[clipped][d->shader < SCENE_SHADER_COUNT ? d->shader : 0];

    if (reference_has_twin(d))
        return reference_twin_program(r, d, error, error_size);
    switch (d->shader) {
    case SCENE_VERTEX_COLOR:
    case SCENE_DERIVATIVES: {
        const bool colors = d->shader == SCENE_VERTEX_COLOR;
        int variant = d->state.program.vertex_writes_point_size;

        if (reference_divides(d))
            variant += scene_shades_samples(&d->state) ? 4 : 2;

        for (int c = 0; c < 4; ++c)
            variant = 9 * variant + (int)d->state.program.interpolation[c] % 3 +
                      3 * ((int)d->state.program.interpolated_at[c] % 3);
        program = colors ? &r->vertex_color_programs[clipped][variant]
                         : &r->derivatives_programs[clipped][variant];
        if (!*program) {
            *program =
                link_colors(d, colors ? vertex_color_fragment_main : derivatives_fragment_main,
                            clipped, error, error_size);
        }
        break;
    }
    case SCENE_FLAT:
        if (!*program) {
            *program =
                reference_link_parts(flat_vertex, flat_fragment, "", clipped, error, error_size);
        }
        break;
    case SCENE_GOURAUD:
        if (!*program) {
            *program = reference_link_parts(gouraud_vertex, gouraud_fragment, "", clipped, error,
                                            error_size);
        }
        break;
    case SCENE_TEXTURED_GOURAUD:
        if (!*program) {
            *program = reference_link_parts(textured_vertex, textured_fragment, "", clipped, error,
                                            error_size);
        }
        break;
    case SCENE_PHONG:
        if (!*program) {
            *program =
                reference_link_parts(phong_vertex, phong_fragment, "", clipped, error, error_size);
        }
        break;
    case SCENE_INPUTS:
        program =
            &r->inputs_programs[clipped][d->state.program.fragment_reads_position +
                                         2 * d->state.program.fragment_discards +
                                         4 * d->state.program.fragment_writes_depth +
                                         8 * d->state.program.fragment_reads_primitive +
                                         16 * d->state.program.fragment_reads_point_coordinate +
                                         32 * d->state.program.vertex_writes_point_size +
                                         64 * d->state.program.fragment_reads_sample_mask +
                                         128 * d->state.program.fragment_writes_sample_mask +
                                         256 * d->state.program.fragment_reads_sample +
                                         512 * reference_divides_varying(d, 0) +
                                         1024 * ((int)d->state.program.interpolated_at[0] % 3)];
        if (!*program)
            *program = link_inputs(d, clipped, error, error_size);
        break;
    case SCENE_OUTPUTS: {
        const uint32_t count = d->state.program.color_count ? d->state.program.color_count : 1;

        program = &r->outputs_programs[clipped][(count - 1) % GN_MAX_COLORS];
        if (!*program)
            *program = link_outputs(count, clipped, error, error_size);
        break;
    }
    case SCENE_SAMPLED:
        return reference_sampled_program(r, d, error, error_size);
    default:
        reference_fail(error, error_size, "a draw has no shader");
        return 0;
    }
    return *program;
}
