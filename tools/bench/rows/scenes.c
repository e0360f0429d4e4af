/* The scenes of `make bench` and `make bench-scale`, and the access to all tables. */
#include <string.h>

#include "rows.h"

#define NEAREST "uniforms.sampler.magnify nearest uniforms.sampler.minify nearest"
#define TEXELS "noise 2d rgba8 512 1 1 "
#define DRAW WORK_DRAW, ""
#define SCENE(name, shape, detail, text, across)                                                   \
    {                                                                                              \
        "scene", name, shape, 1024, detail, text, DRAW, across                                     \
    }
#define SCALE(name, shape, side, detail)                                                           \
    {                                                                                              \
        "scale", name, shape, side, detail, "", DRAW, 0.0f                                         \
    }

/* S3, S4 and S5 have 199,692, 10,092 and 1,002,252 triangles. */
static const bench_row scenes[] = {
    SCENE("S1", SHAPE_SCREENS, 64, "", 0.0f),
    SCENE("S1 rolled", SHAPE_ROLLED, 64, "", 0.0f),
    SCENE("S2", SHAPE_TEXTURED, 64, TEXELS, 0.0f),
    SCENE("S2 nearest", SHAPE_TEXTURED, 64, TEXELS NEAREST, 0.0f),
    SCENE("S2 levels", SHAPE_SAMPLED, 64, "noise 2d rgba8 512 1 10", 0.0f),
    SCENE("S2 cube", SHAPE_SAMPLED, 64, "noise cube rgba8 512 1 10", 0.0f),
    SCENE("S3", SHAPE_SPHERE, 129, "", 820.0f / 1024.0f),
    SCENE("S4", SHAPE_USER, 29, "", 1000.0f / 1024.0f),
    SCENE("S4 ready", SHAPE_PHONG, 29, "", 1000.0f / 1024.0f),
    SCENE("S5", SHAPE_SPHERE, 289, "", 564.0f / 1024.0f),
    SCENE("S6", SHAPE_NOTHING, 0, "", 0.0f),
};

static const bench_row scale[] = {
    SCALE("triangles/972", SHAPE_SPHERE, 1024, 9),
    SCALE("triangles/3888", SHAPE_SPHERE, 1024, 18),
    SCALE("triangles/16428", SHAPE_SPHERE, 1024, 37),
    SCALE("triangles/63948", SHAPE_SPHERE, 1024, 73),
    SCALE("triangles/255792", SHAPE_SPHERE, 1024, 146),
    SCALE("triangles/1002252", SHAPE_SPHERE, 1024, 289),
    SCALE("triangles/3995148", SHAPE_SPHERE, 1024, 577),
    SCALE("fill/256", SHAPE_SCREENS, 256, 4),
    SCALE("fill/512", SHAPE_SCREENS, 512, 4),
    SCALE("fill/1024", SHAPE_SCREENS, 1024, 4),
    SCALE("fill/2048", SHAPE_SCREENS, 2048, 4),
    SCALE("fill/4096", SHAPE_SCREENS, 4096, 4),
    SCALE("fill/8192", SHAPE_SCREENS, 8192, 4),
    SCALE("sphere/256", SHAPE_SPHERE, 256, 129),
    SCALE("sphere/512", SHAPE_SPHERE, 512, 129),
    SCALE("sphere/1024", SHAPE_SPHERE, 1024, 129),
    SCALE("sphere/2048", SHAPE_SPHERE, 2048, 129),
    SCALE("sphere/4096", SHAPE_SPHERE, 4096, 129),
    SCALE("sphere/8192", SHAPE_SPHERE, 8192, 129),
};

const bench_row *rows_of(row_table table, size_t *count)
{
    if (table == TABLE_STATES)
        return state_rows(count);
    *count = table == TABLE_SCENES ? sizeof scenes / sizeof *scenes : sizeof scale / sizeof *scale;
    return table == TABLE_SCENES ? scenes : scale;
}

bool rows_have(row_table table, const char *name)
{
    size_t count;
    const bench_row *const rows = rows_of(table, &count);
    bool found = false;

    for (size_t i = 0; i < count; ++i)
        found = found || strcmp(rows[i].name, name) == 0;
    return found;
}
