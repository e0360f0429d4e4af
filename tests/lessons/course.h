/* What the programs in tools/examples/from_your_course.md may use beside the library: functions
 * that print numbers as the page shows them, and a draw of two triangles. */
#ifndef COURSE_H
#define COURSE_H

#include <gnomon.h>
#include <stdio.h>

/* Numbers on one line; adding 0 makes a negative zero positive. */
static inline void show(int count, const float *number)
{
    for (int i = 0; i < count; ++i)
        printf("%s%g", i ? " " : "", (double)(number[i] + 0));
    printf("\n");
}

static inline void show1(float number)
{
    show(1, &number);
}

static inline void show3(gn_vec3 v)
{
    show(3, (const float[]){v.x, v.y, v.z});
}

static inline void show4(gn_vec4 v)
{
    show(4, (const float[]){v.x, v.y, v.z, v.w});
}

/* The rows of a matrix, as a book prints them, on one line. */
static inline void show_rows(const gn_mat4 *m)
{
    float row[16];

    gn_mat4_to_rows(m, row);
    for (int i = 0; i < 16; ++i)
        printf("%s%g", i == 0 ? "" : i % 4 == 0 ? ", " : " ", (double)(row[i] + 0));
    printf("\n");
}

static inline void show_status(gn_status status)
{
    printf("%s\n", gn_status_text(status));
}

static inline gn_mat4 rows(const float number[16])
{
    gn_mat4 m;

    gn_mat4_from_rows(number, &m);
    return m;
}

static inline gn_mat4 product(gn_mat4 a, gn_mat4 b)
{
    gn_mat4 m;

    gn_mat4_multiply(&a, &b, &m);
    return m;
}

/* The clip coordinates of (x, y, z, 1). */
static inline gn_vec4 clip_of(const gn_mat4 *m, float x, float y, float z)
{
    return gn_mat4_multiply_vec4(m, (gn_vec4){x, y, z, 1});
}

/* Clip coordinates divided by w, or what gn_clip_to_ndc says. */
static inline void show_ndc(gn_vec4 clip)
{
    gn_vec3 ndc;
    const gn_status status = gn_clip_to_ndc(clip, &ndc);

    if (status)
        show_status(status);
    else
        show3(ndc);
}

/* Draws two upright triangles, 1 wide and 1 high, first the one at z[0], each with a red of its
 * own. Prints what became of them, and the z of the one that is seen in the middle. */
static inline void show_draw(const gn_mat4 *clip_from_model, gn_pipeline pipeline,
                             float cleared_depth, const float z[2])
{
    enum { SIZE = 64, COUNT = 2 };
    static uint32_t color[SIZE * SIZE], depth[SIZE * SIZE];
    static unsigned char memory[GN_WORKSPACE_SIZE(3 * COUNT, GN_SHADER_VARYINGS)];
    float position[COUNT][3][3], rgb[COUNT][3][3];
    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, SIZE, SIZE)},
                        gn_surface_bottom_up(depth, GN_FORMAT_D24, SIZE, SIZE)};
    gn_draw_statistics counts = {0};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory, .statistics = &counts};
    gn_mesh mesh = {
        .attribute = {[GN_ATTRIBUTE_POSITION] = {.data = &position[0][0][0], .components = 3},
                      [GN_ATTRIBUTE_COLOR] = {.data = &rgb[0][0][0], .components = 3}},
        .vertex_count = 3 * COUNT,
        .count = 3 * COUNT};
    gn_color_uniforms uniforms = {*clip_from_model};

    for (int i = 0; i < 3 * COUNT; ++i) {
        static const float corner[3][2] = {{-0.5f, -0.5f}, {0.5f, -0.5f}, {0, 0.5f}};
        float *p = position[i / 3][i % 3], *c = rgb[i / 3][i % 3];

        p[0] = corner[i % 3][0];
        p[1] = corner[i % 3][1];
        p[2] = z[i / 3];
        c[0] = (float)(i / 3 + 1) / 255;
        c[1] = c[2] = 0;
    }
    gn_use_vertex_color(&pipeline, &uniforms);
    gn_clear_color(&target.color[0], 0, 0, 0, 1);
    gn_clear_depth(&target.depth, cleared_depth);
    const gn_status status = gn_draw(&target, &pipeline, &mesh, &workspace);
    if (status) {
        show_status(status);
        return;
    }
    const uint32_t middle = ((const unsigned char *)&color[SIZE * SIZE / 2 + SIZE / 2])[0];
    printf("drawn %d, outside %d, behind %d, seen: ", (int)counts.drawn, (int)counts.outside,
           (int)counts.behind);
    if (middle == 0)
        printf("nothing\n");
    else
        printf("z = %g\n", (double)z[middle - 1]);
}

#endif
