/* Random calls of this project's libOSMesa without the reference: random state, a scene in windows
 * of all kinds and sizes, and reads of pixels. What is drawn is not looked at. */
#include "play.h"

#include <stdlib.h>

#include "state_calls.h"

void set_own_functions(library *gl)
{
#define SET(name) gl->name = name;
    OSMESA_FUNCTIONS(SET)
#undef SET
#define SET(name) gl->name = gl##name;
    TESTED_FUNCTIONS(SET)
#undef SET
}

/* Kinds of calls that set pointers to arrays, which are null. */
static bool sets_array(unsigned kind)
{
    return kind >= 58 && kind <= 66;
}

/* What scenes and functions read is memory of just its size. */
static void reset_pixel_storage(const library *gl)
{
    static const GLenum names[] = {
        GL_PACK_ROW_LENGTH,     GL_PACK_SKIP_ROWS,    GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_IMAGES,
        GL_PACK_IMAGE_HEIGHT,   GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS,
        GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES};

    for (size_t i = 0; i < sizeof names / sizeof *names; ++i)
        gl->PixelStorei(names[i], 0);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

static void call_functions(const library *gl, random_source *r)
{
    const unsigned calls = random_below(r, 30);

    for (unsigned i = 0; i < calls; ++i) {
        const call_group *const group = choose_group(r);
        const unsigned kind = random_below(r, group->kinds);
        arguments a;

        choose_arguments(r, &a);
        if (group->call == call_lists || (group->call == call_function && sets_array(kind)))
            continue;
        if (group->call == call_pixels)
            reset_pixel_storage(gl);
        call_of_group(gl, group, kind, &a);
    }
}

static void disable_arrays(const library *gl)
{
    static const GLenum arrays[] = {
        GL_VERTEX_ARRAY,         GL_COLOR_ARRAY,     GL_NORMAL_ARRAY, GL_SECONDARY_COLOR_ARRAY,
        GL_FOG_COORDINATE_ARRAY, GL_EDGE_FLAG_ARRAY, GL_INDEX_ARRAY};

    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; ++i)
        gl->DisableClientState(arrays[i]);
    for (GLenum unit = 0; unit < 4; ++unit) {
        gl->ClientActiveTexture(GL_TEXTURE0 + unit);
        gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
    }
}

/* Reads rectangles, parts of which are outside the window, into memory of just their size. */
static void read_pixels(const library *gl, random_source *r, int width, int height)
{
    static const GLenum formats[] = {GL_RED,           GL_RGB,
                                     GL_BGRA,          GL_LUMINANCE,
                                     GL_RGBA,          GL_LUMINANCE_ALPHA,
                                     GL_STENCIL_INDEX, GL_DEPTH_COMPONENT,
                                     GL_DEPTH_STENCIL, GL_COLOR_INDEX};
    static const GLenum types[] = {GL_UNSIGNED_BYTE,
                                   GL_FLOAT,
                                   GL_SHORT,
                                   GL_UNSIGNED_INT,
                                   GL_HALF_FLOAT,
                                   GL_UNSIGNED_SHORT_5_6_5,
                                   GL_UNSIGNED_INT_24_8,
                                   GL_UNSIGNED_INT_10_10_10_2,
                                   GL_UNSIGNED_BYTE_2_3_3_REV,
                                   GL_BITMAP};

    gl->PixelStorei(GL_PACK_ROW_LENGTH, 0);
    gl->PixelStorei(GL_PACK_SKIP_ROWS, 0);
    gl->PixelStorei(GL_PACK_SKIP_PIXELS, 0);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
    for (int i = 0; i < 6; ++i) {
        const int x = random_between(r, -5, width), y = random_between(r, -5, height);
        const int columns = (int)random_below(r, (uint32_t)width + 5);
        const int rows = (int)random_below(r, (uint32_t)height + 5);
        const GLenum format = formats[random_below(r, 10)], type = types[random_below(r, 10)];
        void *const memory = malloc((size_t)columns * (size_t)rows * 16 + 1);

        gl->ReadPixels(x, y, columns, rows, format, type, memory);
        free(memory);
    }
}

bool play(library *gl, const scene_class *class, uint64_t seed)
{
    random_source r = random_seed(seed);
    const int width = 1 + (int)random_below(&r, 100), height = 1 + (int)random_below(&r, 100);
    const bool has_floats = random_chance(&r, 30), has_alpha = has_floats || random_chance(&r, 50);
    const size_t size = has_floats ? 16 : has_alpha ? 4 : 3;
    const int depth_bits = (int)random_below(&r, 33);
    void *const pixels = calloc((size_t)width * (size_t)height, size);
    bool is_bound;

    gl->context =
        gl->OSMesaCreateContextExt(has_alpha ? OSMESA_RGBA : OSMESA_RGB, depth_bits,
                                   (int)random_below(&r, 2), (int)random_below(&r, 2), NULL);
    is_bound = gl->context &&
               gl->OSMesaMakeCurrent(gl->context, pixels, has_floats ? GL_FLOAT : GL_UNSIGNED_BYTE,
                                     width, height);
    if (is_bound) {
        call_functions(gl, &r);
        disable_arrays(gl);
        reset_pixel_storage(gl);
        class->draw(gl, &r, width, height);
        gl->Finish();
        read_pixels(gl, &r, width, height);
    }
    gl->OSMesaDestroyContext(gl->context);
    free(pixels);
    return is_bound;
}
