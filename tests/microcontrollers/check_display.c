/* Reads what a program sends to its display as the display does: a stream of pixels of two bytes
 * each, the higher byte first, the first one in the top left corner, rows downwards. Compares it
 * with the picture that OpenGL's conventions ask for: the same draw, into a whole surface whose
 * rows are stored from the bottom up, without bands.
 *
 *   PROGRAM  the file with the program: lesson 21, or with DISPLAY_H the firmware
 *   usage: check-display [STREAM]; STREAM is a file that an emulator wrote, of the first frame */
#include <gnomon.h>
#include <stdio.h>
#include <stdlib.h>

enum { SIDE = 240 };

static uint32_t at_once[SIDE * SIDE]; /* row 0 at the bottom */
static uint16_t at_once_depth[SIDE * SIDE];
static uint8_t stream[SIDE * SIDE * 2];
static bool is_drawn;

static gn_status draw_and_record(const gn_target *target, const gn_pipeline *pipeline,
                                 const gn_mesh *mesh, gn_workspace *workspace)
{
    if (!is_drawn) {
        const gn_target all = {{gn_surface_bottom_up(at_once, GN_FORMAT_RGBA8, SIDE, SIDE)},
                               gn_surface_bottom_up(at_once_depth, GN_FORMAT_D16, SIDE, SIDE)};
        gn_pipeline unbanded = *pipeline;

        unbanded.raster.viewport = (gn_viewport){0};
        gn_clear_color(&all.color[0], 0, 0, 0, 0);
        gn_clear_depth(&all.depth, 1);
        is_drawn = gn_draw(&all, &unbanded, mesh, workspace) == GN_OK;
    }
    return gn_draw(target, pipeline, mesh, workspace);
}

#if defined(DISPLAY_H)
enum { DISPLAY_WIDTH = SIDE, DISPLAY_HEIGHT = SIDE };
static size_t received;

static void display_begin(void)
{
    received = 0;
}

static void display_send(const void *bytes, uint32_t count)
{
    for (uint32_t i = 0; i < count && received < sizeof stream; ++i)
        stream[received++] = ((const uint8_t *)bytes)[i];
}

static bool display_end(void)
{
    return false;
}
#endif

#define gn_draw draw_and_record
#define main program_main
#include PROGRAM
#undef main
#undef gn_draw

/* Prints how many of the drawn pixels differ from the stream's, which stands upright or is read
 * upside down. A vertex may be rounded at another place when the viewport moves. */
static unsigned different(bool upside_down, unsigned *drawn)
{
    unsigned count = 0;

    *drawn = 0;
    for (int y = 0; y < SIDE; ++y)
        for (int x = 0; x < SIDE; ++x) {
            const uint32_t c = at_once[(SIDE - 1 - y) * SIDE + x];
            const int row = upside_down ? SIDE - 1 - y : y;
            const uint8_t *const pixel = stream + 2 * (row * SIDE + x);
            const uint32_t expected = (c & 0xF8) << 8 | (c >> 5 & 0x7E0) | (c >> 19 & 0x1F);

            *drawn += c != 0;
            count += c != 0 && (uint32_t)(pixel[0] << 8 | pixel[1]) != expected;
        }
    return count;
}

int main(int argc, char **argv)
{
    unsigned drawn;

#if defined(DISPLAY_H)
    const int status = program_main();
#else
    char *arguments[] = {argv[0], "/dev/null", NULL};
    const int status = program_main(2, arguments);

    memcpy(stream, display, sizeof stream);
#endif
    if (argc > 1) {
        static uint8_t written[sizeof stream + 1];
        FILE *const file = fopen(argv[1], "rb");
        unsigned other = 0;

        if (!file || fread(written, 1, sizeof written, file) != sizeof stream) {
            fprintf(stderr, "check-display: %s does not hold a frame\n", argv[1]);
            return 1;
        }
        fclose(file);
        for (size_t i = 0; i < sizeof stream; ++i)
            other += written[i] != stream[i];
        printf("%u bytes differ from those that this machine sends\n", other);
        if (other > 0)
            return 1;
    }
    const unsigned upright = different(false, &drawn), turned = different(true, &drawn);
    printf("%u of %u drawn pixels differ as the display shows them, %u upside down\n", upright,
           drawn, turned);
    return status != 0 || drawn < 5000 || upright > drawn / 200 || turned < drawn / 4;
}
