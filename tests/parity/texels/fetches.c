/* Single texels, as texelFetch returns them: all values of the formats of up to 16 bits a channel,
 * random values of the others. */
#include "texels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The image has a texel for each of 65536 values. */
enum { SIZE = 256, COUNT = SIZE * SIZE };

typedef float color[4];

static const char fetch_text[] = "layout(binding = 0) uniform sampler2D image;\n"
                                 "out vec4 texel;\n"
                                 "void main() {\n"
                                 "  texel = texelFetch(image, ivec2(gl_FragCoord.xy), 0);\n"
                                 "}\n";
static const char vertex_text[] =
    "void main() {\n"
    "  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, "
    "1.0);\n"
    "}\n";

/* Makes texels that have every value in every channel, if there are as many texels. */
static void fill_all_values(random_source *r, gn_format format, void *texels)
{
    const size_t size = gn_format_size(format);

    fill_texels(r, format, true, texels, COUNT);
    for (uint32_t i = 0; i < COUNT; ++i) {
        if (size == 1)
            ((unsigned char *)texels)[i] = (unsigned char)i;
        else if (size == 2)
            ((uint16_t *)texels)[i] = (uint16_t)i;
        else if (size == 8 && scene_is_color_format(format))
            for (uint32_t c = 0; c < 4; ++c)
                ((uint16_t *)texels)[4 * i + c] = (uint16_t)(i ^ c * 0x1357);
        else if (size == 3 || (size == 4 && scene_is_color_format(format) &&
                               scene_channel_width(format, 0) != 32))
            for (uint32_t c = 0; c < size; ++c)
                ((unsigned char *)texels)[size * i + c] = (unsigned char)(i >> c * 2 ^ c * 0x35);
    }
    for (uint32_t i = 0; (format == GN_FORMAT_D24 || format == GN_FORMAT_D24S8) && i < 512; ++i)
        ((uint32_t *)texels)[i] = i < 256 ? i : 0x1000000u - (i - 255);
}

static bool opengl_fetches(gn_format format, const void *texels, color *out, char *error,
                           size_t error_size)
{
    static const uint32_t size[3] = {SIZE, SIZE, 1};
    static GLuint program, floats, target;
    GLuint name;

    if (!program) {
        program = reference_link(vertex_text, fetch_text, error, error_size);
        if (!program)
            return false;
        glGenFramebuffers(1, &floats);
        glBindFramebuffer(GL_FRAMEBUFFER, floats);
        glGenRenderbuffers(1, &target);
        glBindRenderbuffer(GL_RENDERBUFFER, target);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, SIZE, SIZE);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, floats);
    glViewport(0, 0, SIZE, SIZE);
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    upload_level(GN_TEXTURE_2D, format, 0, size, texels);
    glUseProgram(program);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_FLOAT, out);
    glDeleteTextures(1, &name);
    return reference_check("fetching texels", error, error_size);
}

typedef struct fetch_job {
    gn_texture texture;
    color *out;
} fetch_job;

/* Fetches by the input of a shader; null: by the public function. */
static void fetch_block(const fetch_job *job, const gn_fragment_input *input, const int32_t x[2],
                        const int32_t y[2])
{
    int32_t column[GN_LANES], row[GN_LANES];
    const int32_t *const coordinate[3] = {column, row, NULL};
    float texel[4][GN_LANES];

    for (int l = 0; l < GN_LANES; ++l) {
        column[l] = x[l / 8] + l % 4;
        row[l] = y[l / 8] + l / 4 % 2;
    }
    if (input)
        gn_fragment_fetch(input, &job->texture, coordinate, NULL, texel);
    else
        gn_texture_fetch(&job->texture, coordinate, NULL, texel);
    for (int l = 0; l < GN_LANES; ++l)
        for (int c = 0; c < 4; ++c)
            job->out[row[l] * SIZE + column[l]][c] = texel[c][l];
}

static void place_triangle(const void *uniforms, const gn_vertex_input *input,
                           gn_vertex_output *output)
{
    (void)uniforms;
    for (int l = 0; l < GN_LANES; ++l)
        for (int c = 0; c < 4; ++c)
            output->position[c][l] = input->attribute[0][c][l];
}

static void fetch_fragments(const void *uniforms, const gn_fragment_input *input,
                            gn_fragment_output *output)
{
    for (int c = 0; c < 4; ++c)
        for (int l = 0; l < GN_LANES; ++l)
            output->color[c][l] = 0.0f;
    fetch_block(uniforms, input, input->x, input->y);
}

static gn_status library_fetches(gn_backend backend, const fetch_job *job)
{
    static const float position[] = {-1, -1, 3, -1, -1, 3};
    static uint32_t pixels[COUNT];
    static char memory[65536];
    gn_target target = {0};
    gn_pipeline pipeline = {0};
    gn_mesh mesh = {0};
    gn_workspace workspace = {0};

    target.color[0] = gn_surface_bottom_up(pixels, GN_FORMAT_RGBA8, SIZE, SIZE);
    pipeline.program.vertex_shader = place_triangle;
    pipeline.program.fragment_shader = fetch_fragments;
    pipeline.program.uniforms = job;
    mesh.attribute[0].data = position;
    mesh.attribute[0].components = 2;
    mesh.vertex_count = mesh.count = 3;
    workspace.memory = memory;
    workspace.size = sizeof memory;
    workspace.backend = backend;
    return gn_draw(&target, &pipeline, &mesh, &workspace);
}

/* For depths only red is compared, because the other channels depend on the profile. */
static void count_differences(const char *by, gn_format format, color *ours, color *theirs,
                              tally *t)
{
    uint64_t differ = 0;

    for (int i = 0; i < COUNT; ++i) {
        for (int c = 0; c < (scene_has_depth(format) ? 1 : 4); ++c) {
            if ((isnan(ours[i][c]) && isnan(theirs[i][c])) ||
                memcmp(&ours[i][c], &theirs[i][c], sizeof ours[i][c]) == 0)
                continue;
            if (differ++ == 0)
                fprintf(stderr, "fetch of %s, %s, texel %d channel %d: ours %a, theirs %a\n",
                        text_name(TEXT_FORMAT, (int)format), by, i, c, (double)ours[i][c],
                        (double)theirs[i][c]);
            break;
        }
    }
    ++t->cases;
    t->failed += differ > 0;
    t->texels += COUNT;
    t->differ += differ;
}

bool compare_fetches(uint64_t seed, tally *t, char *error, size_t error_size)
{
    static unsigned char texels[COUNT * 16];
    static color ours[COUNT], theirs[COUNT];
    random_source r = random_seed(seed);

    for (int f = 0; f < SCENE_FORMATS; ++f) {
        const gn_format format = (gn_format)f;
        fetch_job job;

        if (!scene_is_color_format(format) && !scene_has_depth(format))
            continue;
        fill_all_values(&r, format, texels);
        if (!opengl_fetches(format, texels, theirs, error, error_size))
            return false;
        job.out = ours;
        if (gn_texture_packed(GN_TEXTURE_2D, format, SIZE, SIZE, 1, 1, texels, &job.texture))
            return reference_fail(error, error_size, "no texture of %s",
                                  text_name(TEXT_FORMAT, (int)format));
        for (int32_t y = 0; y < SIZE; y += 4)
            for (int32_t x = 0; x < SIZE; x += 4)
                fetch_block(&job, NULL, (const int32_t[2]){x, x}, (const int32_t[2]){y, y + 2});
        count_differences("gn_texture_fetch", format, ours, theirs, t);
        for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b) {
            if (!gn_backend_available((gn_backend)b))
                continue;
            memset(ours, 0xEE, sizeof ours);
            if (library_fetches((gn_backend)b, &job))
                return reference_fail(error, error_size, "%s does not draw",
                                      gn_backend_name((gn_backend)b));
            count_differences(gn_backend_name((gn_backend)b), format, ours, theirs, t);
        }
    }
    return true;
}
