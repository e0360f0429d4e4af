/* Reads what the corners of faces name: v, vt and vn; and the material files of mtllib. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "obj.h"

/* The most numbers behind a statement: x y z w r g b a. */
#define MOST_NUMBERS 8

/* What the colours of a file have in common. */
typedef struct color_range {
    double low, high;  /* of red, green and blue */
    double high_alpha; /* 0: no vertex has alpha */
    uint64_t line;     /* of the first above 1 */
} color_range;

text_cursor obj_begin(const model_reader *r)
{
    text_cursor t = text_begin(r->bytes, r->size);
    t.comment = '#';
    t.continues = true;
    return t;
}

bool obj_cut_comment(text_cursor *t, text_word *word)
{
    const char *const hash = word->length > 0 ? memchr(word->start, '#', word->length) : NULL;
    if (hash == NULL || hash == word->start)
        return false;
    word->length = (size_t)(hash - word->start);
    text_pass_line(t);
    return true;
}

/* Reads all numbers of a statement. Spellings of NaN are NaN. */
static bool read_numbers(model_reader *r, text_cursor *t, const char *keyword,
                         double numbers[MOST_NUMBERS], size_t *count)
{
    text_word word;
    char copy[40];
    for (*count = 0; text_next_word(t, &word); ++*count) {
        double number;
        if (!text_number(word, true, &number) &&
            !(obj_cut_comment(t, &word) && text_number(word, true, &number)))
            return reader_fail_at(r, reader_line(r, t->statement),
                                  "\"%s\" behind %s is not a number",
                                  text_copy(word, copy, sizeof copy), keyword);
        if (*count < MOST_NUMBERS)
            numbers[*count] = number;
    }
    return true;
}

static bool fail_for_count(model_reader *r, const text_cursor *t, const char *what, size_t count)
{
    return reader_fail_at(r, reader_line(r, t->statement), "%s, not %zu", what, count);
}

/* What fits no float is NaN. */
static float to_float(double number)
{
    return fabs(number) <= (double)FLT_MAX ? (float)number : NAN;
}

bool obj_has_color(const obj_vertices *v, uint32_t vertex)
{
    return v->colors != NULL && v->colors[vertex][3] >= 0.0f;
}

/* Stores the colour of the last vertex; null: it has none. The array begins with the first colour
 * of the file; alpha -1 stands for no colour. */
static bool store_color(model_reader *r, obj_vertices *v, const double *color)
{
    static const float none[4] = {1.0f, 1.0f, 1.0f, -1.0f};
    const size_t last = v->position_count - 1;
    if (v->colors == NULL && color == NULL)
        return true;
    const bool is_first = v->colors == NULL;
    if (!reader_grow(r, &v->colors, &v->color_room, v->position_count, sizeof none))
        return false;
    for (size_t i = is_first ? 0 : last; i <= last; ++i)
        memcpy(v->colors[i], none, sizeof none);
    for (int c = 0; color != NULL && c < 4; ++c)
        v->colors[last][c] = (float)color[c];
    return true;
}

/* Replaces what is no number, and widens the range. */
static void look_at_color(model_reader *r, uint64_t line, double color[4], bool has_alpha,
                          color_range *range)
{
    bool is_finite = true;
    for (int c = 0; c < 4; ++c) {
        const bool is_good = fabs(color[c]) <= (double)FLT_MAX;
        is_finite = is_finite && is_good;
        if (!is_good)
            color[c] = c < 3 ? 0.0 : 1.0;
    }
    if (!is_finite)
        reader_warn(r, reader_line(r, line), "the colour of v is not a finite number; 0 is used");
    for (int c = 0; c < 3; ++c) {
        range->low = fmin(range->low, color[c]);
        range->high = fmax(range->high, color[c]);
        if (range->line == 0 && (color[c] > 1.0 || color[c] < 0.0))
            range->line = line;
    }
    /* Alpha that is not given is 1, whatever the others are divided by. */
    color[3] = has_alpha ? fmax(color[3], 0.0) : INFINITY;
    if (has_alpha)
        range->high_alpha = fmax(range->high_alpha, color[3]);
}

/* v takes x y z, x y z w, or colours behind them. w is the weight of rational curves and surfaces
 * (appendix B1, "Vertex data"): polygons, lines and points do not depend on it. */
static bool read_position(obj_reader *o, text_cursor *t, color_range *range)
{
    obj_vertices *const v = &o->vertices;
    double numbers[MOST_NUMBERS], color[4] = {1.0, 1.0, 1.0, 1.0};
    size_t count;
    if (!read_numbers(o->r, t, "v", numbers, &count))
        return false;
    if (count < 3 || count == 5 || count > MOST_NUMBERS)
        return fail_for_count(o->r, t, "v takes 3, 4, 6, 7 or 8 numbers", count);
    if ((count == 4 || count == 8) && numbers[3] != 1.0)
        reader_warn(o->r, reader_line(o->r, t->statement),
                    "the weight of v, its fourth number, is for curves and is not used");
    if (v->position_count >= OBJ_NONE - 1)
        return reader_fail_at(o->r, reader_line(o->r, t->statement), "there are too many v");
    if (!reader_grow(o->r, &v->positions, &v->position_room, v->position_count + 1,
                     sizeof *v->positions))
        return false;
    double *const position = v->positions[v->position_count++];
    for (int c = 0; c < 3; ++c)
        position[c] = fabs(numbers[c]) <= (double)FLT_MAX ? numbers[c] : (double)NAN;
    if (count < 6)
        return store_color(o->r, v, NULL);
    const size_t first = count == 8 ? 4 : 3;
    for (size_t c = first; c < count; ++c)
        color[c - first] = numbers[c];
    look_at_color(o->r, t->statement, color, count > 6, range);
    return store_color(o->r, v, color);
}

static bool read_texcoord(obj_reader *o, text_cursor *t)
{
    obj_vertices *const v = &o->vertices;
    double numbers[MOST_NUMBERS] = {0.0};
    size_t count;
    if (!read_numbers(o->r, t, "vt", numbers, &count))
        return false;
    if (count < 1 || count > 3)
        return fail_for_count(o->r, t, "vt takes 1 to 3 numbers", count);
    if (v->texcoord_count >= OBJ_NONE - 1)
        return reader_fail_at(o->r, reader_line(o->r, t->statement), "there are too many vt");
    if (!reader_grow(o->r, &v->texcoords, &v->texcoord_room, v->texcoord_count + 1,
                     sizeof *v->texcoords))
        return false;
    float *const texcoord = v->texcoords[v->texcoord_count++];
    texcoord[0] = to_float(numbers[0]);
    texcoord[1] = to_float(numbers[1]);
    return true;
}

static bool read_normal(obj_reader *o, text_cursor *t)
{
    obj_vertices *const v = &o->vertices;
    double numbers[MOST_NUMBERS];
    size_t count;
    if (!read_numbers(o->r, t, "vn", numbers, &count))
        return false;
    if (count != 3)
        return fail_for_count(o->r, t, "vn takes 3 numbers", count);
    if (v->normal_count >= OBJ_NONE - 1)
        return reader_fail_at(o->r, reader_line(o->r, t->statement), "there are too many vn");
    if (!reader_grow(o->r, &v->normals, &v->normal_room, v->normal_count + 1, sizeof *v->normals))
        return false;
    float *const normal = v->normals[v->normal_count++];
    for (int c = 0; c < 3; ++c)
        normal[c] = to_float(numbers[c]);
    return true;
}

/* Colours are 0 to 1; some programs write 0 to 255, in alpha too or not. */
static void scale_colors(obj_reader *o, const color_range *range)
{
    obj_vertices *const v = &o->vertices;
    const bool is_bytes = range->low >= 0.0 && range->high > 1.0 && range->high <= 255.0;
    const float alpha = range->high_alpha > 1.0 ? 255.0f : 1.0f;
    if (v->colors == NULL)
        return;
    if (is_bytes)
        reader_warn(o->r, reader_line(o->r, range->line),
                    "colours of v are above 1: all are divided by 255");
    else if (range->line != 0)
        reader_warn(o->r, reader_line(o->r, range->line), "a colour of v lies outside 0 to 255");
    for (size_t i = 0; i < v->position_count; ++i) {
        float *const color = v->colors[i];
        for (int c = 0; c < 3 && is_bytes && color[3] >= 0.0f; ++c)
            color[c] /= 255.0f;
        if (color[3] >= 0.0f)
            color[3] = fminf(color[3] / alpha, 1.0f);
    }
}

/* Reads v, vt or vn. */
static bool read_vertex(obj_reader *o, text_cursor *t, text_word keyword, color_range *range)
{
    if (keyword.length == 1)
        return read_position(o, t, range);
    if (text_is(keyword, "vt"))
        return read_texcoord(o, t);
    return !text_is(keyword, "vn") || read_normal(o, t);
}

bool obj_read_vertices(obj_reader *o)
{
    text_cursor t = obj_begin(o->r);
    color_range range = {0.0, 0.0, 0.0, 0};
    text_word word;
    bool good = true;
    while (good && text_next_line(&t)) {
        text_next_word(&t, &word);
        if (word.start[0] == 'v')
            good = read_vertex(o, &t, word, &range);
        else if (text_is(word, "mtllib"))
            good = mtl_add_libraries(o->r, &o->materials, text_rest(&t), t.statement);
        text_pass_line(&t);
    }
    o->vertices.file_normal_count = o->vertices.normal_count;
    scale_colors(o, &range);
    return good;
}
