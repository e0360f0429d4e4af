/* What the two programs share: drawing with the library, reading the file and options. */
#include "contract.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

contract_verdict contract_draw(const scene *s, gn_backend backend, const contract_scene *expected)
{
    scene_frame frame;
    hash pixels, srgb;
    uint64_t channels = 0;
    if (!scene_frame_allocate(&frame, s))
        return CONTRACT_NO_MEMORY;
    const gn_status status = scene_draw_library(s, &frame, 0, backend);
    contract_hash_frame(&frame, false, &pixels, &srgb, &channels);
    scene_frame_free(&frame);
    if (status != GN_OK)
        return CONTRACT_REFUSED;
    return pixels == expected->pixels && srgb == expected->srgb ? CONTRACT_EQUAL : CONTRACT_DIFFERS;
}

void contract_print_backends(FILE *out)
{
    const char *before = "";
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
        if (gn_backend_available((gn_backend)b)) {
            fprintf(out, "%s%s", before, gn_backend_name((gn_backend)b));
            before = ", ";
        }
}

bool contract_open(contract *c, const char *program, const char *name)
{
    char error[256] = "";
    const bool is_file = strcmp(name, "-") != 0;
    FILE *const in = is_file ? fopen(name, "r") : stdin;
    memset(c, 0, sizeof *c);
    if (!in) {
        fprintf(stderr, "%s: cannot read %s: %s\n", program, name, strerror(errno));
        return false;
    }
    const bool read = contract_read(c, in, error, sizeof error);
    if (!read)
        fprintf(stderr, "%s: %s, %s\n", program, name, error);
    if (is_file)
        fclose(in);
    return read;
}
