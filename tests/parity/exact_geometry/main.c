/* make exact-geometry: the library against exact integers. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "../../command_line.h"
#include "exact.h"

#define DEFAULT_SEED 1
#define DEFAULT_TRIANGLES 1000000

/* One triangle of so many goes to oracle B, which is slower. */
#define CLIP_SPACE_PART 50

static const char help[] =
    "usage: exact-geometry [--seed S] [--triangles N] [--clip-space N]\n"
    "\n"
    "Compares coverage, depth and colour with exact integers (reference/exact).\n"
    "\n"
    "A. After snapping: random triangles on the grid of 1/256 pixel, one and four samples a\n"
    "   pixel, every back end, and OSMesa for one batch of 32. Every sample must be covered as\n"
    "   integers of 128 bits say.\n"
    "B. In clip space: random triangles of floats, drawn by every back end and by OSMesa, against\n"
    "   integers of any length, without a clipper. If a pixel is covered differently, its centre\n"
    "   must lie within 0.003 pixel of an exact edge; for triangles of 2^17 pixels and more the\n"
    "   rounding of clip coordinates is added. Tables show how far centres, depths and colours\n"
    "   are off, for Gnomon and for OSMesa. '99 % moved' is the distance from the centre, in\n"
    "   pixels, within which 99 % of the values drawn are exact: for slivers errors are large,\n"
    "   because the values change so fast. Centres exactly on an edge are not compared.\n"
    "\n"
    "  --seed S          seed of the triangles (1)\n"
    "  --triangles N     triangles for A (1000000)\n"
    "  --clip-space N    triangles for B (a fiftieth of A's)\n"
    "\n"
    "Exit status: 0: everything holds, 1: something does not, 2: wrong command line.\n";

void show_progress(const char *what, uint64_t done, uint64_t all)
{
    static time_t last;
    const bool is_terminal = isatty(STDERR_FILENO);
    const time_t now = time(NULL);

    if (last == 0)
        last = now;
    if (done < all && now - last < (is_terminal ? 1 : 10))
        return;
    last = now;
    if (is_terminal)
        fprintf(stderr, "\rexact-geometry: %s: %" PRIu64 " of %" PRIu64 " triangles%s", what, done,
                all, done < all ? "" : "\n");
    else if (done < all)
        fprintf(stderr, "exact-geometry: %s: %" PRIu64 " of %" PRIu64 " triangles\n", what, done,
                all);
}

int main(int argc, char **argv)
{
    uint64_t seed = DEFAULT_SEED, triangles = DEFAULT_TRIANGLES, clip_space = UINT64_MAX;
    const command_option known[] = {
        {"--seed", .number = &seed},
        {"--triangles", .number = &triangles},
        {"--clip-space", .number = &clip_space},
        {.name = NULL},
    };
    snapped_totals a;
    clip_totals b;
    char error[512];

    if (command_line_asks_help(argc, argv)) {
        fputs(help, stdout);
        return EXIT_SUCCESS;
    }
    if (!command_line_read("exact-geometry", argc, argv, known, NULL))
        return 2;
    if (clip_space == UINT64_MAX)
        clip_space = triangles / CLIP_SPACE_PART;

    reference *const r = reference_create(REFERENCE_PINNED, error, sizeof error);

    if (!r) {
        fprintf(stderr, "exact-geometry: no reference: %s\n", error);
        return EXIT_FAILURE;
    }
    printf("exact-geometry: seed %" PRIu64 "\n", seed);
    test_snapped(r, seed, triangles, &a);
    printf("A: %" PRIu64 " triangles in %" PRIu64 " frames, %" PRIu64
           " samples asked of the oracle, "
           "%" PRIu64 " covered, %" PRIu64 " on edges; the reference drew %" PRIu64
           " frames, %" PRIu64 " samples differ\n\n",
           a.triangles, a.frames, a.samples, a.covered, a.ties, a.reference_frames,
           a.reference_different);
    test_clip_space(r, seed, clip_space, &b);
    reference_destroy(r);

    const bool failed = a.broken || b.broken || a.different || a.reference_different || b.beyond ||
                        b.errors_beyond || b.unequal_pixels;

    printf("exact-geometry: A: %" PRIu64 " triangles, %" PRIu64 " samples differ; B: %" PRIu64
           " triangles, %" PRIu64 " of %" PRIu64
           " centres differ, at most %.5f pixel from an edge (from 2^17 pixels on %.2g), "
           "%" PRIu64 " beyond the bound, %" PRIu64 " rows of errors beyond theirs; %" PRIu64
           " pixels differ from OSMesa\n",
           a.triangles, a.different, b.triangles, b.different, b.pixels, b.largest,
           b.largest_of_vast, b.beyond, b.errors_beyond, b.unequal_pixels);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
