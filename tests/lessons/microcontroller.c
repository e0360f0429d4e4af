/* Lesson 21 as firmware: runs on a board without an operating system and without a C library, and
 * on this machine. Prints a hash of what the display was sent, and on a board the instructions of
 * the picture in thousands. */
#include <gnomon.h>

#include "../microcontrollers/board.h"

/* Instead of lesson.h, which needs a C library. */
#define LESSON_H

static void lesson_check(gn_status status)
{
    if (status != GN_OK)
        board_print(gn_status_text(status));
}

static void lesson_help(int argc, char **argv, int most, const char *help)
{
    (void)argc, (void)argv, (void)most, (void)help;
}

static const char *lesson_argument(int argc, char **argv, int n, const char *otherwise)
{
    (void)argc, (void)argv, (void)n;
    return otherwise;
}

static float lesson_slider(const char *name, float value, float least, float most)
{
    (void)name, (void)least, (void)most;
    return value;
}

static int print_nothing(const char *format, ...)
{
    (void)format;
    return 0;
}

static void print_number(uint32_t n)
{
    board_print_number(n);
    board_print("\n");
}

/* FNV-1a over the pixels' values. */
static void tga_write(const char *path, const uint32_t *pixel, uint32_t width, uint32_t height)
{
    uint32_t hash = 2166136261u, background = 0;

    (void)path;
    for (uint32_t i = 0; i < width * height; ++i) {
        background += pixel[i] == pixel[0];
        for (int shift = 0; shift < 32; shift += 8)
            hash = (hash ^ (pixel[i] >> shift & 255)) * 16777619u;
    }
    print_number(hash);
    print_number(background);
}

#define printf print_nothing
#define main lesson_main
#include "../../tools/examples/21_microcontroller.c"
#undef main
#undef printf

int main(void)
{
    board_start();
    const int status = lesson_main(0, NULL);

    print_number(board_instructions() / 1000);
    return status;
}
