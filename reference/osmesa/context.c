/* The GL context: the environment that Mesa reads, creation, version. */
#include "gl.h"

#include <stdlib.h>
#include <string.h>

/* These belong to the compatibility profile; the core header does not declare them. */
#define POINT_SPRITE 0x8861

#define ALPHA_TO_COVERAGE_DITHER_DISABLE 0x934F

/* The last Mesa that has OSMesa. */
#define MESA_VERSION "25.0.7"

/* Mesa reads these variables once, when the first context is created. The pinned values decide
 * about bits, except LP_NUM_THREADS: its value 0 keeps all work in the calling thread, so that this
 * thread's CPU time is the whole cost. */
void reference_set_environment(reference_profile profile)
{
    if (profile == REFERENCE_UNPINNED) {
        setenv("GALLIUM_DRIVER", "llvmpipe", 1);
        unsetenv("GALLIUM_OVERRIDE_CPU_CAPS");
        unsetenv("GALLIVM_PERF");
        unsetenv("MESA_GLSL_DISABLE_IO_OPT");
        unsetenv("LP_NATIVE_VECTOR_WIDTH");
        setenv("LP_NUM_THREADS", "0", 1);
    } else if (profile == REFERENCE_PINNED) {
        setenv("GALLIUM_DRIVER", "llvmpipe", 1);
        setenv("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1", 1);
        setenv("GALLIVM_PERF", "no_quad_lod,no_aos_sampling,nopt", 1);
        setenv("MESA_GLSL_DISABLE_IO_OPT", "true", 1);
        setenv("LP_NUM_THREADS", "0", 1);
    } else {
        setenv("LP_NUM_THREADS", "0", 0);
    }
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
}

/* Finds "25.0.7" in "4.5 (Core Profile) Mesa 25.0.7". */
static void read_version(reference *r)
{
    const char *text = (const char *)glGetString(GL_VERSION);
    const char *mesa = text ? strstr(text, "Mesa ") : NULL;
    const char *renderer = (const char *)glGetString(GL_RENDERER);

    snprintf(r->version, sizeof r->version, "%s", mesa ? mesa + 5 : text ? text : "unknown");
    snprintf(r->renderer, sizeof r->renderer, "%s", renderer ? renderer : "unknown");
}

/* Packagers add to the number: "25.0.7-2+deb13u1". */
static bool is_contract_version(const char *version)
{
    const size_t length = sizeof MESA_VERSION - 1;

    return strncmp(version, MESA_VERSION, length) == 0 &&
           (version[length] < '0' || version[length] > '9');
}

/* OpenGL allows both; Mesa dithers unless it is asked not to (NV_alpha_to_coverage_dither_control).
 */
static void disable_alpha_to_coverage_dither(const reference_driver *driver)
{
    void (*const control)(GLenum) =
        (void (*)(GLenum))driver->function("glAlphaToCoverageDitherControlNV");

    if (control)
        control(ALPHA_TO_COVERAGE_DITHER_DISABLE);
}

reference *reference_create(reference_profile profile, char *error, size_t error_size)
{
    /* The core profile has one polygon mode for both faces, so this is a context of the
     * compatibility profile, except where speed is measured. With point sprites on, it draws the
     * same pixels as the core profile. */
    const bool compatible = profile != REFERENCE_HOST;
    static bool created;
    reference *r;

    if (created) {
        reference_fail(error, error_size, "a process can have one reference only");
        return NULL;
    }
    created = true;
    reference_set_environment(profile);
    r = calloc(1, sizeof *r);
    if (!r) {
        reference_fail(error, error_size, "out of memory");
        return NULL;
    }
    r->driver = reference_choose_driver(error, error_size);
    r->context = r->driver ? r->driver->create(compatible, error, error_size) : NULL;
    if (!r->context || !reference_load_functions(r->driver, error, error_size)) {
        if (r->context)
            r->driver->destroy(r->context);
        free(r);
        return NULL;
    }
    r->is_pinned = profile == REFERENCE_PINNED;
    read_version(r);
    if (!is_contract_version(r->version)) {
        reference_fail(error, error_size,
                       "%s here is that of Mesa %s, the reference is that of Mesa " MESA_VERSION
                       ": 'make setup' fetches it, and 'make' then builds programs that use it",
                       r->driver->name, r->version);
        reference_destroy(r);
        return NULL;
    }
    if (profile != REFERENCE_HOST && strncmp(r->renderer, "llvmpipe", 8) != 0) {
        reference_fail(error, error_size, "%s draws with %s, the reference is llvmpipe",
                       r->driver->name, r->renderer);
        reference_destroy(r);
        return NULL;
    }
    glGenVertexArrays(1, &r->vertex_array);
    glBindVertexArray(r->vertex_array);
    glDisable(GL_DITHER);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    if (compatible)
        glEnable(POINT_SPRITE);
    if (profile == REFERENCE_PINNED)
        disable_alpha_to_coverage_dither(r->driver);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    return r;
}

void reference_destroy(reference *r)
{
    if (!r)
        return;
    for (int i = 0; i < FRAMEBUFFER_CACHE_SIZE; ++i)
        framebuffer_destroy(&r->framebuffers[i]);
    for (int i = 0; i < VERTEX_COLOR_PROGRAMS; ++i) {
        glDeleteProgram(r->vertex_color_programs[0][i]);
        glDeleteProgram(r->vertex_color_programs[1][i]);
        glDeleteProgram(r->derivatives_programs[0][i]);
        glDeleteProgram(r->derivatives_programs[1][i]);
    }
    for (int i = 0; i < SCENE_SHADER_COUNT; ++i) {
        glDeleteProgram(r->lit_programs[0][i]);
        glDeleteProgram(r->lit_programs[1][i]);
    }
    reference_free_twins(r);
    for (int i = 0; i < INPUTS_PROGRAMS; ++i) {
        glDeleteProgram(r->inputs_programs[0][i]);
        glDeleteProgram(r->inputs_programs[1][i]);
    }
    for (int i = 0; i < SAMPLED_PROGRAMS; ++i) {
        glDeleteProgram(r->sampled_programs[0][i]);
        glDeleteProgram(r->sampled_programs[1][i]);
    }
    for (int i = 0; i < 2; ++i)
        glDeleteProgram(r->sample_programs[i]);
    glDeleteVertexArrays(1, &r->vertex_array);
    for (int i = 0; i < GN_MAX_COLORS; ++i) {
        glDeleteProgram(r->outputs_programs[0][i]);
        glDeleteProgram(r->outputs_programs[1][i]);
    }
    r->driver->destroy(r->context);
    free(r);
}

const char *reference_driver_name(const reference *r)
{
    return r->driver->name;
}

const char *reference_mesa_version(const reference *r)
{
    return r->version;
}

const char *reference_renderer(const reference *r)
{
    return r->renderer;
}
