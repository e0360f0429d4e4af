/* Compiling and linking GLSL: the declarations before every vertex shader, and the code around it
 * for clip distances. Attributes and uniforms have fixed locations. */
#include "gl.h"

static const char vertex_head[] = "#version 450 core\n"
                                  "layout(location = 0) in vec4 position;\n"
                                  "layout(location = 1) in vec4 color;\n"
                                  "layout(location = 2) in vec4 normal;\n"
                                  "layout(location = 3) in vec4 texcoord;\n"
                                  "layout(location = 0) uniform mat4 clip_from_model;\n"
                                  "layout(location = 1) uniform mat3 normal_matrix;\n"
                                  "layout(location = 2) uniform vec3 light_direction;\n"
                                  "layout(location = 3) uniform vec3 ambient;\n"
                                  "layout(location = 4) uniform vec3 diffuse;\n"
                                  "vec4 lit()\n"
                                  "{\n"
                                  "    vec3 n = normalize(normal_matrix * normal.xyz);\n"
                                  "    float d = max(dot(n, light_direction), 0.0);\n"
                                  "    return vec4(color.rgb * (ambient + diffuse * d), color.a);\n"
                                  "}\n";

/* Code around a vertex shader, which writes clip distances besides what the shader's main
 * writes. */
static const char clipped_head[] = "#define main place_and_shade\n";
static const char clipped_tail[] =
    "#undef main\n"
    "layout(location = 8) uniform vec4 clip_plane[8];\n"
    "out float gl_ClipDistance[8];\n"
    "void main()\n"
    "{\n"
    "    place_and_shade();\n"
    "    for (int i = 0; i < 8; ++i) {\n"
    "        vec4 p = clip_plane[i];\n"
    "        gl_ClipDistance[i] = ((p.x * position.x + p.y * position.y) + p.z * position.z) +\n"
    "                             p.w * position.w;\n"
    "    }\n"
    "}\n";

static GLuint compile(GLenum stage, const char *head, const char *body, bool clipped, char *error,
                      size_t error_size)
{
    const char *parts[4] = {head, clipped ? clipped_head : "", body, clipped ? clipped_tail : ""};
    const GLuint shader = glCreateShader(stage);
    GLint compiled = 0;

    glShaderSource(shader, 4, parts, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        char log[1024] = "";

        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        reference_fail(error, error_size, "a GLSL shader does not compile: %s", log);
        glDeleteShader(shader);
        return 0;
    }
    return shader;
}

GLuint reference_link_parts(const char *vertex_body, const char *fragment_head,
                            const char *fragment_body, bool clipped, char *error, size_t error_size)
{
    const GLuint vertex =
        compile(GL_VERTEX_SHADER, vertex_head, vertex_body, clipped, error, error_size);
    const GLuint fragment =
        vertex ? compile(GL_FRAGMENT_SHADER, fragment_head, fragment_body, false, error, error_size)
               : 0;
    GLuint program = 0;

    if (vertex && fragment) {
        GLint linked = 0;

        program = glCreateProgram();
        glAttachShader(program, vertex);
        glAttachShader(program, fragment);
        glLinkProgram(program);
        glGetProgramiv(program, GL_LINK_STATUS, &linked);
        if (!linked) {
            char log[1024] = "";

            glGetProgramInfoLog(program, sizeof log, NULL, log);
            reference_fail(error, error_size, "a GLSL program does not link: %s", log);
            glDeleteProgram(program);
            program = 0;
        }
    }
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    return program;
}

GLuint reference_link_clipped(const char *vertex, const char *fragment, bool clipped, char *error,
                              size_t error_size)
{
    return reference_link_parts(vertex, "#version 450 core\n", fragment, clipped, error,
                                error_size);
}

GLuint reference_link(const char *vertex, const char *fragment, char *error, size_t error_size)
{
    return reference_link_clipped(vertex, fragment, false, error, error_size);
}
