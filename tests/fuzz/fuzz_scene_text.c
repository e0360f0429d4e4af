/* The reader of scenes: any text is a scene or a fault with a line's number; what was read and
 * written is read as the same scene; and a small scene that was read is drawn, or refused with a
 * status. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "scene.h"

static char *text_of(const scene *s, size_t *size)
{
    char *text = NULL;
    FILE *const out = open_memstream(&text, size);

    FUZZ_REQUIRE(out);
    FUZZ_REQUIRE(scene_write(s, out));
    FUZZ_REQUIRE(fclose(out) == 0);
    return text;
}

static scene *read_text(const char *text, size_t size, char *error, size_t error_size)
{
    FILE *const in = fmemopen((void *)text, size, "r");

    if (!in)
        return NULL;
    scene *const s = scene_read(in, error, error_size);

    fclose(in);
    return s;
}

/* Whether drawing takes no long time and no memory beyond the mesh's: indices are checked by the
 * library, elements without indices too. */
static bool is_small(const scene *s)
{
    uint64_t work = 0;

    for (size_t i = 0; i < s->draw_count; ++i) {
        const gn_mesh *const m = &s->draws[i].mesh;
        const uint64_t instances = m->instance_count ? m->instance_count : 1;

        if (instances > 4 || m->vertex_count > 1000)
            return false;
        for (int a = 0; a < GN_MAX_ATTRIBUTES; ++a) /* the reader does not lay out other arrays */
            if (m->attribute[a].divisor && instances > m->vertex_count)
                return false;
        work += m->count * instances;
    }
    return work < 500 && s->width * s->height <= 64 * 64 && s->draw_count < 9;
}

static void draw(const scene *s)
{
    scene_frame frame;

    FUZZ_REQUIRE(scene_frame_allocate(&frame, s));
    const gn_status status =
        scene_draw_library(s, &frame, gn_workspace_size(1000, 40), GN_BACKEND_AUTO);

    FUZZ_REQUIRE(status >= GN_OK && status < GN_STATUS_COUNT);
    scene_frame_free(&frame);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    char error[200];

    if (size == 0)
        return -1;
    memset(error, 'x', sizeof error);
    scene *const s = read_text((const char *)bytes, size, error, sizeof error);

    if (!s) {
        FUZZ_REQUIRE(memchr(error, 0, sizeof error) && strncmp(error, "line ", 5) == 0);
        return 0;
    }
    FUZZ_REQUIRE(error[0] == '\0');

    size_t written, again;
    char *const text = text_of(s, &written);
    scene *const same = read_text(text, written, error, sizeof error);

    FUZZ_REQUIRE(same);
    char *const twice = text_of(same, &again);

    FUZZ_REQUIRE(written == again && memcmp(text, twice, written) == 0);
    if (is_small(s))
        draw(s);
    free(text);
    free(twice);
    scene_free(same);
    scene_free(s);
    return 0;
}
