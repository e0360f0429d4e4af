/* Implements sampler.h. */
#include "sampler.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "scene_pixel.h"

/* ---- Texels ---- */

typedef struct texel {
    long double channel[4];
} texel;

static long double fraction(uint32_t value, int bits)
{
    return (long double)value / (long double)((UINT64_C(1) << bits) - 1);
}

/* The inverse of the sRGB encoding, equation 8.15. */
static long double linear(long double encoded)
{
    return encoded <= 0.04045L ? encoded / 12.92L : powl((encoded + 0.055L) / 1.055L, 2.4L);
}

static texel decode(gn_format format, const void *at)
{
    const scene_format *const f = scene_format_of(format);
    texel t = {{0.0L, 0.0L, 0.0L, 1.0L}};
    uint32_t bits[4];

    scene_pixel_channels(at, format, 0, bits);
    for (int c = 0; c < (f->is_color ? f->channels : 1); ++c) {
        t.channel[c] = f->encoding == SCENE_FLOAT
                           ? (long double)scene_channel_value(format, c, bits[c])
                           : fraction(bits[c], f->width[c]);
        if (f->encoding == SCENE_SRGB && c < 3)
            t.channel[c] = linear(t.channel[c]);
    }
    return t;
}

/* ---- The state of a sample ---- */

typedef struct work {
    const gn_texture *texture;
    const gn_sampler *sampler;
    const exact_lookup *lookup;
    int64_t size[3]; /* of the level: columns, rows, slices */
    uint32_t level;
    int64_t layer; /* of an array; for a cube the face */
    long double doubt;
} work;

static void doubt(work *w, long double distance)
{
    w->doubt = fabsl(distance) < w->doubt ? fabsl(distance) : w->doubt;
}

static int64_t largest(int64_t a, int64_t b)
{
    return a > b ? a : b;
}

static int64_t within(int64_t i, int64_t low, int64_t high)
{
    return i < low ? low : i > high ? high : i;
}

/* Remainder that is never negative, whatever the sign of i. */
static int64_t modulo(int64_t i, int64_t n)
{
    return (i % n + n) % n;
}

static int64_t mirror(int64_t i)
{
    return i >= 0 ? i : -(1 + i);
}

/* Wrap modes, table 8.20. */
static int64_t wrapped(gn_wrap wrap, int64_t i, int64_t n)
{
    switch (wrap) {
    case GN_WRAP_REPEAT:
        return modulo(i, n);
    case GN_WRAP_CLAMP_TO_EDGE:
        return within(i, 0, n - 1);
    case GN_WRAP_MIRRORED_REPEAT:
        return n - 1 - mirror(modulo(i, 2 * n) - n);
    case GN_WRAP_CLAMP_TO_BORDER:
        return within(i, -1, n);
    case GN_WRAP_MIRROR_CLAMP_TO_EDGE:
        return within(mirror(i), 0, n - 1);
    }
    return 0;
}

static int64_t whole(long double x)
{
    return x > 1e15L    ? INT64_C(1000000000000000)
           : x < -1e15L ? -INT64_C(1000000000000000)
                        : (int64_t)floorl(x);
}

/* Section 8.23.1: the result of comparing a depth. */
static long double compared(work *w, long double depth)
{
    const bool fixed = !scene_is_float_format(w->texture->format);
    long double r = w->lookup->reference;
    bool holds = false;

    if (fixed)
        r = r < 0.0L ? 0.0L : r > 1.0L ? 1.0L : r;
    doubt(w, r - depth);
    switch (w->sampler->compare) {
    case GN_COMPARE_DEFAULT:
        return depth;
    case GN_LESS_OR_EQUAL:
        holds = r <= depth;
        break;
    case GN_GREATER_OR_EQUAL:
        holds = r >= depth;
        break;
    case GN_LESS:
        holds = r < depth;
        break;
    case GN_GREATER:
        holds = r > depth;
        break;
    case GN_EQUAL:
        holds = r == depth;
        break;
    case GN_NOT_EQUAL:
        holds = r != depth;
        break;
    case GN_ALWAYS:
        holds = true;
        break;
    case GN_NEVER:
        break;
    }
    return holds ? 1.0L : 0.0L;
}

/* The texel with these wrapped numbers, or the border. */
static texel fetch(work *w, int64_t i, int64_t j, int64_t k)
{
    const gn_texture *const t = w->texture;
    const gn_texture_level *const level = &t->level[w->level];
    const bool is_outside =
        i < 0 || i >= w->size[0] || j < 0 || j >= w->size[1] || k < 0 || k >= w->size[2];
    texel result;

    if (is_outside) {
        for (int c = 0; c < 4; ++c) {
            result.channel[c] =
                scene_has_depth(t->format) && c > 0 ? c == 3 : (long double)w->sampler->border[c];
        }
    } else {
        const int64_t layer = t->target == GN_TEXTURE_3D ? k : w->layer;

        result =
            decode(t->format, (const char *)level->texels + layer * level->layer_stride +
                                  j * level->row_stride + i * (int64_t)gn_format_size(t->format));
    }
    if (scene_has_depth(t->format) && w->sampler->compare != GN_COMPARE_DEFAULT)
        result.channel[0] = compared(w, result.channel[0]);
    return result;
}

static void add(texel *sum, const texel *t, long double weight)
{
    for (int c = 0; c < 4; ++c)
        sum->channel[c] += weight * t->channel[c];
}

/* ---- Cubes ---- */

/* Table 8.19: the axes of s, t and the major axis of face f, and whether each is negated. */
typedef struct cube_face {
    int axis[3];
    long double sign[3];
} cube_face;

static const cube_face faces[6] = {
    {{2, 1, 0}, {-1.0L, -1.0L, 1.0L}}, {{2, 1, 0}, {1.0L, -1.0L, -1.0L}},
    {{0, 2, 1}, {1.0L, 1.0L, 1.0L}},   {{0, 2, 1}, {1.0L, -1.0L, -1.0L}},
    {{0, 1, 2}, {1.0L, -1.0L, 1.0L}},  {{0, 1, 2}, {-1.0L, -1.0L, -1.0L}},
};

/* The face of a direction. If magnitudes tie, z wins over y and y over x. */
static int face_of(const long double d[3])
{
    const long double x = fabsl(d[0]), y = fabsl(d[1]), z = fabsl(d[2]);
    const int axis = z >= x && z >= y ? 2 : y >= x ? 1 : 0;

    return 2 * axis + (d[axis] < 0.0L);
}

/* The point where a direction meets the plane of a face: s and t are -1 to 1 within the face. */
static void on_face(int face, const long double d[3], long double s_t[2])
{
    const cube_face *const f = &faces[face];
    const long double major = f->sign[2] * d[f->axis[2]];

    for (int c = 0; c < 2; ++c)
        s_t[c] = f->sign[c] * d[f->axis[c]] / major;
}

/* A texel that may lie beyond one edge of its face: in that case it is a texel of the face that
 * touches that edge. */
static texel fetch_over_edge(work *w, int face, int64_t i, int64_t j)
{
    const cube_face *const f = &faces[face];
    const int64_t n = w->size[0];
    const int64_t number[2] = {i, j};
    long double d[3];

    /* The centre of the texel, folded over the edge that the texel lies beyond. */
    d[f->axis[2]] = f->sign[2];
    for (int c = 0; c < 2; ++c) {
        long double at = (2.0L * (long double)number[c] + 1.0L) / (long double)n - 1.0L;

        if (fabsl(at) > 1.0L) {
            d[f->axis[2]] = f->sign[2] * (2.0L - fabsl(at));
            at = at < 0.0L ? -1.0L : 1.0L;
        }
        d[f->axis[c]] = f->sign[c] * at;
    }

    const bool beyond = i < 0 || i >= n || j < 0 || j >= n;
    long double s_t[2];

    /* After folding, the neighbour's component is the largest: it is 1, the others are at most 1 -
     * 1/n. */
    w->layer = beyond ? face_of(d) : face;
    if (!beyond)
        return fetch(w, i, j, 0);
    on_face((int)w->layer, d, s_t);
    return fetch(w, within(whole((s_t[0] + 1.0L) / 2.0L * (long double)n), 0, n - 1),
                 within(whole((s_t[1] + 1.0L) / 2.0L * (long double)n), 0, n - 1), 0);
}

static texel cube_linear(work *w, int face, long double u, long double v)
{
    const int64_t n = w->size[0];
    const int64_t i0 = whole(u - 0.5L), j0 = whole(v - 0.5L);
    const long double a = u - 0.5L - floorl(u - 0.5L), b = v - 0.5L - floorl(v - 0.5L);
    texel sum = {{0.0L, 0.0L, 0.0L, 0.0L}}, corner[4];
    int missing = -1;

    for (int k = 0; k < 4; ++k) {
        const int64_t i = i0 + k % 2, j = j0 + k / 2;

        if ((i < 0 || i >= n) && (j < 0 || j >= n))
            missing = k;
        else
            corner[k] = fetch_over_edge(w, face, i, j);
    }
    if (missing >= 0) {
        memset(&corner[missing], 0, sizeof corner[missing]);
        for (int k = 0; k < 4; ++k)
            if (k != missing)
                add(&corner[missing], &corner[k], 1.0L / 3.0L);
    }
    for (int k = 0; k < 4; ++k)
        add(&sum, &corner[k], (k % 2 ? a : 1.0L - a) * (k / 2 ? b : 1.0L - b));
    return sum;
}

static texel sample_cube(work *w, bool is_linear)
{
    const long double *const d = w->lookup->coordinate;
    const int face = face_of(d);
    const int64_t n = w->size[0];
    long double s_t[2], at[2];

    on_face(face, d, s_t);
    for (int c = 0; c < 2; ++c) {
        at[c] = (s_t[c] + 1.0L) / 2.0L * (long double)n;
        if (!is_linear) {
            doubt(w, at[c] - roundl(at[c]));
            doubt(w, (fabsl(s_t[c]) - 1.0L) * (long double)n);
        }
    }
    if (is_linear)
        return cube_linear(w, face, at[0], at[1]);
    w->layer = face;
    return fetch(w, within(whole(at[0]), 0, n - 1), within(whole(at[1]), 0, n - 1), 0);
}

/* ---- A level ---- */

static int dimensions(gn_texture_target target)
{
    return target == GN_TEXTURE_1D ? 1 : target == GN_TEXTURE_3D ? 3 : 2;
}

/* Filtering within one level, section 8.14.2. */
static texel sample_level(work *w, uint32_t level, bool is_linear)
{
    const gn_texture *const t = w->texture;
    const gn_wrap wraps[3] = {w->sampler->wrap_s, w->sampler->wrap_t, w->sampler->wrap_r};
    const int count = dimensions(t->target);
    int64_t first[3] = {0, 0, 0}, second[3] = {0, 0, 0};
    long double weight[3] = {0.0L, 0.0L, 0.0L};
    texel sum = {{0.0L, 0.0L, 0.0L, 0.0L}};

    w->level = level;
    w->layer = 0;
    w->size[0] = largest(t->width >> level, 1);
    w->size[1] = largest(t->height >> level, 1);
    w->size[2] = t->target == GN_TEXTURE_3D ? largest(t->depth >> level, 1) : 1;
    if (t->target == GN_TEXTURE_CUBE)
        return sample_cube(w, is_linear);
    if (t->target == GN_TEXTURE_2D_ARRAY) {
        const long double r = w->lookup->coordinate[2];

        doubt(w, r + 0.5L - roundl(r + 0.5L));
        w->layer = within(whole(r + 0.5L), 0, (int64_t)t->depth - 1);
    }
    for (int c = 0; c < count; ++c) {
        const long double u = w->lookup->coordinate[c] * (long double)w->size[c];

        if (is_linear) {
            weight[c] = u - 0.5L - floorl(u - 0.5L);
            first[c] = wrapped(wraps[c], whole(u - 0.5L), w->size[c]);
            second[c] = wrapped(wraps[c], whole(u - 0.5L) + 1, w->size[c]);
        } else {
            doubt(w, u - roundl(u));
            first[c] = wrapped(wraps[c], whole(u), w->size[c]);
        }
    }
    for (int k = 0; k < (is_linear ? 1 << count : 1); ++k) {
        long double product = 1.0L;
        int64_t number[3];

        for (int c = 0; c < 3; ++c) {
            number[c] = k >> c & 1 ? second[c] : first[c];
            product *= k >> c & 1 ? weight[c] : 1.0L - weight[c];
        }

        const texel corner = fetch(w, number[0], number[1], number[2]);

        add(&sum, &corner, product);
    }
    return sum;
}

/* ---- Between levels ---- */

/* The clamps of equation 8.10. */
static long double clamped_lod(work *w, long double lod)
{
    const gn_sampler *const s = w->sampler;

    lod += (long double)s->lod_bias;
    if (s->lod_clamp_enabled) {
        lod = lod > (long double)s->max_lod   ? (long double)s->max_lod
              : lod < (long double)s->min_lod ? (long double)s->min_lod
                                              : lod;
    }
    return lod;
}

exact_texel exact_sample(const gn_texture *texture, const gn_sampler *sampler,
                         const exact_lookup *lookup)
{
    work w = {texture, sampler, lookup, {1, 1, 1}, 0, 0, HUGE_VALL};
    const gn_minify m = sampler->minify;
    const long double lod = clamped_lod(&w, lookup->lod);
    const long double last = (long double)(texture->level_count ? texture->level_count - 1 : 0);
    const bool between =
        m == GN_MINIFY_NEAREST_MIPMAP_LINEAR || m == GN_MINIFY_LINEAR_MIPMAP_LINEAR;
    const bool among =
        m == GN_MINIFY_NEAREST_MIPMAP_NEAREST || m == GN_MINIFY_LINEAR_MIPMAP_NEAREST;
    const bool magnifies_linear = sampler->magnify == GN_MAGNIFY_LINEAR;
    const bool minifies_linear = m == GN_MINIFY_LINEAR || m == GN_MINIFY_LINEAR_MIPMAP_NEAREST ||
                                 m == GN_MINIFY_LINEAR_MIPMAP_LINEAR;
    texel result;

    if (magnifies_linear != minifies_linear)
        doubt(&w, lod);
    if (lod <= 0.0L) {
        result = sample_level(&w, 0, magnifies_linear);
    } else if (between && lod < last) {
        const long double weight = lod - floorl(lod);
        const texel near = sample_level(&w, (uint32_t)lod, minifies_linear);
        const texel far = sample_level(&w, (uint32_t)lod + 1, minifies_linear);

        memset(&result, 0, sizeof result);
        add(&result, &near, 1.0L - weight);
        add(&result, &far, weight);
    } else if (between || among) {
        const long double nearest = ceill(lod + 0.5L) - 1.0L;

        if (among)
            doubt(&w, lod + 0.5L - roundl(lod + 0.5L));
        result = sample_level(&w, (uint32_t)(between || nearest > last ? last : nearest),
                              minifies_linear);
    } else {
        result = sample_level(&w, 0, minifies_linear);
    }

    exact_texel e;

    memcpy(e.channel, result.channel, sizeof e.channel);
    e.doubt = w.doubt;
    return e;
}

/* The derivatives of a face's s and t, from 0 to 1 over the face: half of the derivatives on the
 * plane. */
static void cube_derivatives(const long double d[3], const long double step[3], long double out[3])
{
    const cube_face *const f = &faces[face_of(d)];
    const long double major = f->sign[2] * d[f->axis[2]];
    const long double major_step = f->sign[2] * step[f->axis[2]];

    for (int c = 0; c < 2; ++c) {
        const long double at = f->sign[c] * d[f->axis[c]];
        const long double by = f->sign[c] * step[f->axis[c]];

        out[c] = 0.5L * (by * major - at * major_step) / (major * major);
    }
    out[2] = 0.0L;
}

/* The lengths of two gradients, in texels of level 0. */
static void lengths(const gn_texture *texture, const long double coordinate[3],
                    const long double dx[3], const long double dy[3], long double length[2])
{
    const long double size[3] = {(long double)texture->width, (long double)texture->height,
                                 (long double)texture->depth};
    const int count = dimensions(texture->target);
    long double square[2] = {0.0L, 0.0L};
    long double x[3], y[3];

    memcpy(x, dx, sizeof x);
    memcpy(y, dy, sizeof y);
    if (texture->target == GN_TEXTURE_CUBE) {
        cube_derivatives(coordinate, dx, x);
        cube_derivatives(coordinate, dy, y);
    }
    for (int c = 0; c < count; ++c) {
        square[0] += x[c] * size[c] * x[c] * size[c];
        square[1] += y[c] * size[c] * y[c] * size[c];
    }
    length[0] = sqrtl(square[0]);
    length[1] = sqrtl(square[1]);
}

long double exact_lod(const gn_texture *texture, const long double coordinate[3],
                      const long double dx[3], const long double dy[3])
{
    long double length[2];

    lengths(texture, coordinate, dx, dy, length);
    return log2l(length[0] > length[1] ? length[0] : length[1]);
}

exact_texel exact_sample_anisotropic(const gn_texture *texture, const gn_sampler *sampler,
                                     const exact_lookup *lookup, const long double dx[3],
                                     const long double dy[3])
{
    const long double most = (long double)sampler->max_anisotropy;
    exact_texel mean = {{0.0L, 0.0L, 0.0L, 0.0L}, HUGE_VALL};
    exact_lookup sample = *lookup;
    long double length[2], count = 1.0L;

    lengths(texture, lookup->coordinate, dx, dy, length);

    const bool is_x = length[0] > length[1];
    const long double longer = is_x ? length[0] : length[1];
    const long double ratio = longer / (is_x ? length[1] : length[0]);

    if (texture->target != GN_TEXTURE_1D && sampler->max_anisotropy > 1) {
        mean.doubt = fabsl(longer - 1.0L);
        if (longer > 1.0L) {
            count = !(ratio < most) ? most : ceill(ratio);
            mean.doubt =
                fminl(mean.doubt, ratio < most + 0.5L ? fabsl(ratio - roundl(ratio)) : 1.0L);
        }
    }
    sample.lod = log2l(longer / count);
    for (long double i = 1.0L; i <= count; ++i) {
        for (int c = 0; c < 3; ++c) {
            const bool moves = count > 1.0L && !(texture->target == GN_TEXTURE_2D_ARRAY && c == 2);

            sample.coordinate[c] =
                lookup->coordinate[c] +
                (moves ? (i / (count + 1.0L) - 0.5L) * (is_x ? dx[c] : dy[c]) : 0.0L);
        }

        const exact_texel e = exact_sample(texture, sampler, &sample);

        for (int c = 0; c < 4; ++c)
            mean.channel[c] += e.channel[c] / count;
        mean.doubt = fminl(mean.doubt, e.doubt);
    }
    return mean;
}
