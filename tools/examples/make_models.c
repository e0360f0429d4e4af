/* Makes the files that the lessons use when they are started without arguments: the teapot with its
 * maps, and a head with eyes, all computed. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "obj_tga.h"
#include "teapot.h"
#include "teapot_maps.h"

/* Segments of a side of a patch of the teapot, texels of a side of a patch's part of a map. */
#define TEAPOT_LEVEL 8
#define TEAPOT_TEXELS 64

/* Segments of the head around and from pole to pole, and texels of its texture. */
#define AROUND 64
#define HIGH 48
#define HEAD_TEXELS 256

#define EYE_RADIUS 0.155
static const double eye_center[3] = {0.27, 0.16, 0.54};
static const double pi = 3.14159265358979323846;

static FILE *create(const char *directory, const char *name, char path[4096])
{
    snprintf(path, 4096, "%s/%s", directory, name);
    FILE *file = fopen(path, "wb");
    if (file == NULL) {
        perror(path);
        exit(EXIT_FAILURE);
    }
    return file;
}

static void finish(FILE *file, const char *path)
{
    if (ferror(file) || fclose(file)) {
        fprintf(stderr, "%s: cannot be written\n", path);
        exit(EXIT_FAILURE);
    }
}

static void write_corner(FILE *file, uint32_t i)
{
    fprintf(file, " %u/%u/%u", (unsigned)i + 1, (unsigned)i + 1, (unsigned)i + 1);
}

static void write_teapot(const char *directory)
{
    static const float white[4] = {1.0f, 1.0f, 1.0f, 1.0f};
    char path[4096];
    model m;
    if (!teapot_create(TEAPOT_LEVEL, white, &m)) {
        fprintf(stderr, "not enough memory\n");
        exit(EXIT_FAILURE);
    }
    const model_part *p = m.parts;
    FILE *file = create(directory, "teapot.obj", path);
    for (uint32_t i = 0; i < p->vertex_count; ++i) {
        const float *v = p->positions + 3 * i;
        const float *n = p->normals + 3 * i;
        fprintf(file, "v %.9g %.9g %.9g\nvt %.9g %.9g\nvn %.9g %.9g %.9g\n", (double)v[0],
                (double)v[1], (double)v[2], (double)p->texcoords[2 * i],
                (double)p->texcoords[2 * i + 1], (double)n[0], (double)n[1], (double)n[2]);
    }
    for (uint32_t i = 0; i < p->index_count; ++i) {
        fputs(i % 3 == 0 ? "f" : "", file);
        write_corner(file, p->indices[i]);
        fputs(i % 3 == 2 ? "\n" : "", file);
    }
    finish(file, path);
    model_free(&m);
}

static void write_map(const char *directory, const char *name, map_kind kind)
{
    char path[4096];
    image maps[MAP_COUNT] = {{0}};
    if (!teapot_maps_create(1u << kind, true, TEAPOT_TEXELS, maps)) {
        fprintf(stderr, "not enough memory\n");
        exit(EXIT_FAILURE);
    }
    snprintf(path, sizeof path, "%s/%s", directory, name);
    tga_write(path, maps[kind].texels, maps[kind].width, maps[kind].height);
    free(maps[kind].texels);
}

/* A hill of height 1 at the origin, with these widths. */
static double hill(double x, double y, double width, double height)
{
    return exp(-(x * x) / (width * width) - (y * y) / (height * height));
}

/* The point of the head in a direction from its middle: an egg with nose, sockets, lips and chin on
 * the side of +z. */
static void head_point(double longitude, double latitude, double p[3])
{
    const double x = cos(latitude) * sin(longitude);
    const double y = sin(latitude);
    const double z = cos(latitude) * cos(longitude);
    const double front = z > 0.0 ? z : 0.0;
    const double jaw = y < 0.0 ? 1.0 + 0.2 * y : 1.0;
    double out = 0.20 * hill(x, y + 0.10, 0.13, 0.17) + 0.06 * hill(x, y - 0.12, 0.10, 0.22);
    out -= 0.17 * (hill(x - 0.33, y - 0.17, 0.20, 0.13) + hill(x + 0.33, y - 0.17, 0.20, 0.13));
    out += 0.07 * hill(x, y + 0.43, 0.26, 0.07) - 0.05 * hill(x, y + 0.43, 0.24, 0.025);
    out += 0.08 * hill(x, y + 0.78, 0.25, 0.16) + 0.05 * hill(x, y - 0.38, 0.5, 0.10);
    p[0] = 0.74 * x * jaw;
    p[1] = y;
    p[2] = 0.80 * z * jaw + out * front;
}

static void head_color(double longitude, double latitude, double color[3])
{
    static const double skin[3] = {0.80, 0.58, 0.46};
    static const double lips[3] = {0.62, 0.25, 0.24};
    static const double hair[3] = {0.22, 0.14, 0.09};
    const double x = cos(latitude) * sin(longitude);
    const double y = sin(latitude);
    const double z = cos(latitude) * cos(longitude);
    const double mouth = z > 0.0 ? hill(x, y + 0.44 - 0.5 * x * x, 0.24, 0.055) : 0.0;
    const double blush = z > 0.0 ? hill(fabs(x) - 0.48, y + 0.18, 0.2, 0.2) : 0.0;
    const double brow = z > 0.0 ? hill(fabs(x) - 0.33, y - 0.37, 0.17, 0.03) : 0.0;
    const double line = 0.55 + 0.05 * sin(23.0 * longitude) - 0.75 * (z > 0.0 ? 0.0 : -z);
    for (int c = 0; c < 3; ++c) {
        color[c] = skin[c] + (c == 0 ? 0.06 : -0.06) * blush;
        if (mouth > 0.35)
            color[c] = lips[c];
        if (y > line || brow > 0.4)
            color[c] = hair[c] * (0.85 + 0.15 * sin(90.0 * longitude));
    }
}

/* The normal of a surface: the cross product of two differences. */
static void normal_of(void point(double, double, double[3]), double a, double b, double n[3])
{
    const double step = 1e-4;
    double p[4][3];
    double u[3];
    double v[3];
    point(a - step, b, p[0]);
    point(a + step, b, p[1]);
    point(a, b - step, p[2]);
    point(a, b + step, p[3]);
    for (int c = 0; c < 3; ++c) {
        u[c] = p[1][c] - p[0][c];
        v[c] = p[3][c] - p[2][c];
    }
    for (int c = 0; c < 3; ++c)
        n[c] = u[(c + 1) % 3] * v[(c + 2) % 3] - u[(c + 2) % 3] * v[(c + 1) % 3];
    const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int c = 0; c < 3; ++c)
        n[c] /= length;
}

/* A ball with the radius of an eye, around the origin. */
static void ball_point(double longitude, double latitude, double p[3])
{
    p[0] = EYE_RADIUS * cos(latitude) * sin(longitude);
    p[1] = EYE_RADIUS * sin(latitude);
    p[2] = EYE_RADIUS * cos(latitude) * cos(longitude);
}

/* Writes a closed surface over longitude and latitude, moved by `offset`. The texture's middle is
 * at longitude 0; `front` shows it to +z, as seen from there. Returns the vertices written. */
static uint32_t write_surface(FILE *file, void point(double, double, double[3]), int around,
                              int high, const double offset[3], bool front, uint32_t before)
{
    double p[3];
    double n[3];
    for (int j = 0; j <= high; ++j) {
        for (int i = 0; i <= around; ++i) {
            const double longitude = (2.0 * i / around - 1.0) * pi;
            const double latitude = ((double)j / high - 0.5) * pi;
            /* Short of the poles, where the differences along a circle of latitude vanish. */
            const double inside = fmin(fmax(latitude, -0.4999 * pi), 0.4999 * pi);
            point(longitude, latitude, p);
            normal_of(point, longitude, inside, n);
            fprintf(file, "v %.6f %.6f %.6f\nvn %.6f %.6f %.6f\n", p[0] + offset[0],
                    p[1] + offset[1], p[2] + offset[2], n[0], n[1], n[2]);
            fprintf(file, "vt %.6f %.6f\n", front ? 0.5 + 0.5 * n[0] : (double)i / around,
                    front ? 0.5 + 0.5 * n[1] : (double)j / high);
        }
    }
    for (int j = 0; j < high; ++j) {
        for (int i = 0; i < around; ++i) {
            const uint32_t a = before + (uint32_t)(j * (around + 1) + i);
            const uint32_t b = a + (uint32_t)around + 1;
            fputs("f", file); /* a polygon: readers make triangles of it */
            write_corner(file, a);
            write_corner(file, a + 1);
            write_corner(file, b + 1);
            write_corner(file, b);
            fputs("\n", file);
        }
    }
    return before + (uint32_t)((around + 1) * (high + 1));
}

static uint32_t packed(const double color[3])
{
    uint32_t texel = UINT32_C(0xff000000);
    for (int c = 0; c < 3; ++c)
        texel |= (uint32_t)(fmin(fmax(color[c], 0.0), 1.0) * 255.0 + 0.5) << (8 * c);
    return texel;
}

static void eye_color(double x, double y, double color[3])
{
    static const double colors[4][3] = {
        {0.04, 0.04, 0.05}, {0.30, 0.50, 0.62}, {0.12, 0.22, 0.30}, {0.93, 0.91, 0.88}};
    const double r = sqrt(x * x + y * y);
    memcpy(color, colors[r < 0.20 ? 0 : r < 0.42 ? 1 : r < 0.48 ? 2 : 3], sizeof colors[0]);
}

static void write_head(const char *directory)
{
    static const double origin[3] = {0.0, 0.0, 0.0};
    const double left[3] = {-eye_center[0], eye_center[1], eye_center[2]};
    static uint32_t texels[HEAD_TEXELS * HEAD_TEXELS];
    char path[4096];
    FILE *file = create(directory, "head.obj", path);
    write_surface(file, head_point, AROUND, HIGH, origin, false, 0);
    finish(file, path);
    file = create(directory, "eyes.obj", path);
    write_surface(file, ball_point, 24, 16, left, true,
                  write_surface(file, ball_point, 24, 16, eye_center, true, 0));
    finish(file, path);
    for (int eyes = 0; eyes < 2; ++eyes) {
        for (int i = 0; i < HEAD_TEXELS * HEAD_TEXELS; ++i) {
            const double s = (i % HEAD_TEXELS + 0.5) / HEAD_TEXELS;
            const double t = ((double)(i / HEAD_TEXELS) + 0.5) / HEAD_TEXELS;
            double color[3];
            if (eyes)
                eye_color(2.0 * s - 1.0, 2.0 * t - 1.0, color);
            else
                head_color((2.0 * s - 1.0) * pi, (t - 0.5) * pi, color);
            texels[i] = packed(color);
        }
        snprintf(path, sizeof path, "%s/%s", directory, eyes ? "eyes.tga" : "head.tga");
        tga_write(path, texels, HEAD_TEXELS, HEAD_TEXELS);
    }
}

int main(int argc, char **argv)
{
    if (argc != 2 || strcmp(argv[1], "--help") == 0) {
        fputs("usage: make-models DIRECTORY    (the teapot and a head, with their maps)\n",
              argc == 2 ? stdout : stderr);
        return argc == 2 ? EXIT_SUCCESS : 2;
    }
    write_teapot(argv[1]);
    write_map(argv[1], "teapot_diffuse.tga", MAP_DIFFUSE);
    write_map(argv[1], "teapot_normal.tga", MAP_NORMAL);
    write_map(argv[1], "teapot_specular.tga", MAP_SPECULAR);
    write_head(argv[1]);
    return EXIT_SUCCESS;
}
