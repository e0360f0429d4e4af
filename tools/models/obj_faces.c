/* Reads faces, lines and points, and groups them by what they share. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "obj.h"

/* Vertices of one v that are compared with a new one. What lies beyond is not shared, so that no
 * file is slow. */
#define MOST_COMPARED 64

/* Reads digits behind an optional sign. What does not fit is a large number. */
static bool read_index(const char **at, const char *end, int64_t *value)
{
    const bool is_negative = *at < end && **at == '-';
    int64_t number = 0;
    if (*at < end && (**at == '-' || **at == '+'))
        ++*at;
    const char *const first = *at;
    for (; *at < end && **at >= '0' && **at <= '9'; ++*at)
        number = number < INT64_MAX / 20 ? 10 * number + (**at - '0') : number;
    *value = is_negative ? -number : number;
    return *at > first;
}

/* A corner as it stands in the file; false: there is no such index. */
typedef struct written_corner {
    int64_t index[3];
    bool is_given[3];
} written_corner;

/* v, v/vt, v//vn or v/vt/vn; exporters also write v/ and v//. */
static bool read_written(text_word word, written_corner *corner)
{
    const char *at = word.start;
    const char *const end = word.start + word.length;
    for (int i = 0; i < 3; ++i)
        corner->is_given[i] = false;
    for (int i = 0; i < 3; ++i) {
        const bool is_signed = at < end && (*at == '-' || *at == '+');
        corner->is_given[i] = read_index(&at, end, corner->index + i);
        if ((i == 0 || is_signed) && !corner->is_given[i])
            return false;
        if (at == end)
            return true;
        if (*at != '/')
            return false;
        ++at;
    }
    return false;
}

static bool fail_for_index(obj_reader *o, const text_cursor *t, text_word keyword, const char *what,
                           int64_t index, size_t count)
{
    const char *const before = index < 0 ? " before it" : "";
    char copy[8], number[32] = "are none";
    text_copy(keyword, copy, sizeof copy);
    if (index == 0)
        return reader_fail_at(o->r, reader_line(o->r, t->statement),
                              "%s names %s 0, but the first is 1", copy, what);
    if (count > 0)
        snprintf(number, sizeof number, "%s only %zu", count == 1 ? "is" : "are", count);
    return reader_fail_at(o->r, reader_line(o->r, t->statement), "%s names %s %lld, but there %s%s",
                          copy, what, (long long)index, number, before);
}

/* Turns the indices of a corner into numbers from 0. */
static bool resolve(obj_reader *o, const text_cursor *t, text_word keyword,
                    const written_corner *written, obj_corner *corner)
{
    static const char names[3][3] = {"v", "vt", "vn"};
    const obj_vertices *const v = &o->vertices;
    const size_t before[3] = {o->positions_before, o->texcoords_before, o->normals_before};
    const size_t all[3] = {v->position_count, v->texcoord_count, v->file_normal_count};
    uint32_t number[3];
    for (int i = 0; i < 3; ++i) {
        const int64_t index = written->index[i];
        number[i] = OBJ_NONE;
        if (!written->is_given[i])
            continue;
        const size_t count = index < 0 ? before[i] : all[i];
        const uint64_t distance = (uint64_t)(index < 0 ? -index : index);
        if (distance == 0 || distance > count)
            return fail_for_index(o, t, keyword, names[i], index, count);
        number[i] = (uint32_t)(index < 0 ? count - distance : distance - 1);
    }
    *corner = (obj_corner){number[0], number[1], number[2]};
    if (!isfinite(v->positions[corner->v][0] + v->positions[corner->v][1] +
                  v->positions[corner->v][2]))
        return reader_fail_at(o->r, reader_line(o->r, t->statement),
                              "the position of a vertex is not a finite number: that of v %llu",
                              (unsigned long long)corner->v + 1);
    return true;
}

/* Reads the corners of a statement. All have one form (appendix B1, "Elements"). */
static bool read_corners(obj_reader *o, text_cursor *t, text_word keyword)
{
    text_word word;
    written_corner written;
    char copies[2][40];
    o->corner_count = 0;
    while (text_next_word(t, &word)) {
        if (!read_written(word, &written) &&
            !(obj_cut_comment(t, &word) && read_written(word, &written)))
            return reader_fail_at(o->r, reader_line(o->r, t->statement),
                                  "\"%s\" behind %s is not v, v/vt, v//vn or v/vt/vn",
                                  text_copy(word, copies[0], sizeof copies[0]),
                                  text_copy(keyword, copies[1], sizeof copies[1]));
        if (!reader_grow(o->r, &o->corners, &o->corner_room, o->corner_count + 1,
                         sizeof *o->corners))
            return false;
        obj_corner *const corner = o->corners + o->corner_count++;
        if (!resolve(o, t, keyword, &written, corner))
            return false;
        if ((corner->vt == OBJ_NONE) != (o->corners[0].vt == OBJ_NONE) ||
            (corner->vn == OBJ_NONE) != (o->corners[0].vn == OBJ_NONE))
            return reader_fail_at(o->r, reader_line(o->r, t->statement),
                                  "the corners of %s do not have one form: \"%s\" differs",
                                  text_copy(keyword, copies[0], sizeof copies[0]),
                                  text_copy(word, copies[1], sizeof copies[1]));
    }
    return true;
}

/* The group of primitives with the present material and corners like these. */
static bool find_group(obj_reader *o, model_kind kind, uint32_t *number)
{
    const bool has_texcoords = o->corners[0].vt != OBJ_NONE;
    const bool has_normals = o->corners[0].vn != OBJ_NONE;
    bool has_colors = false;
    for (size_t i = 0; i < o->corner_count && o->vertices.colors != NULL; ++i)
        has_colors = has_colors || obj_has_color(&o->vertices, o->corners[i].v);
    const size_t of_material =
        (size_t)kind * 8 + has_texcoords * 4u + has_normals * 2u + has_colors;
    const size_t material = o->material == MTL_NO_MATERIAL ? o->materials.count : o->material;
    uint32_t *const slot = o->group_of + material * OBJ_GROUPS_OF_MATERIAL + of_material;
    if (*slot == 0) {
        if (!reader_grow(o->r, &o->groups, &o->group_room, o->group_count + 1, sizeof *o->groups))
            return false;
        obj_group *const group = o->groups + o->group_count;
        memset(group, 0, sizeof *group);
        group->kind = kind;
        group->material = o->material;
        group->has_texcoords = has_texcoords;
        group->has_normals = has_normals;
        group->has_colors = has_colors;
        *slot = (uint32_t)++o->group_count;
    }
    *number = *slot - 1;
    return true;
}

static bool is_same_corner(const obj_corner *a, const obj_corner *b)
{
    return a->v == b->v && a->vt == b->vt && a->vn == b->vn;
}

/* The index of a corner in its group; a vertex is added unless there is one like it. */
static bool add_vertex(obj_reader *o, uint32_t number, const obj_corner *corner, uint32_t smoothing,
                       uint32_t *index)
{
    obj_group *const group = o->groups + number;
    uint32_t *const last = o->last_vertex + corner->v;
    uint32_t next = *last;
    for (int i = 0; i < MOST_COMPARED && next != 0; ++i) {
        const obj_vertex *const other = o->group_vertices + (next - 1);
        if (other->group == number && other->smoothing == smoothing &&
            is_same_corner(&other->corner, corner)) {
            *index = other->index;
            return true;
        }
        next = other->next;
    }
    if (o->group_vertex_count >= OBJ_NONE - 1)
        return reader_fail(o->r, "it has too many vertices");
    if (!reader_grow(o->r, &o->group_vertices, &o->group_vertex_room, o->group_vertex_count + 1,
                     sizeof *o->group_vertices))
        return false;
    *index = group->vertex_count++;
    o->group_vertices[o->group_vertex_count++] =
        (obj_vertex){*corner, smoothing, number, *index, *last};
    *last = (uint32_t)o->group_vertex_count;
    group->has_smoothing = group->has_smoothing || smoothing != OBJ_SMOOTH_ALL;
    return true;
}

/* Room for so many more indices. */
static uint32_t *add_indices(obj_reader *o, obj_group *group, size_t count)
{
    const size_t needed = group->index_count + count;
    if (needed > UINT32_MAX) {
        reader_fail(o->r, "it has too many triangles, lines or points");
        return NULL;
    }
    if (!reader_grow(o->r, &group->indices, &group->index_room, needed, sizeof *group->indices))
        return NULL;
    group->index_count = needed;
    return group->indices + (needed - count);
}

/* Cuts the face into triangles of its corners, numbered from 0. */
static bool cut_face(obj_reader *o, const text_cursor *t)
{
    polygon *const p = &o->polygon;
    bool is_simple;
    if (!polygon_begin(o->r, p, o->corner_count))
        return false;
    for (size_t i = 0; i < p->count; ++i)
        memcpy(p->corners[i].position, o->vertices.positions[o->corners[i].v],
               sizeof p->corners[i].position);
    if (!polygon_cut(o->r, p, &is_simple))
        return false;
    if (!is_simple)
        reader_warn(o->r, reader_line(o->r, t->statement),
                    "a face crosses itself, or has very many corners; its triangles may overlap");
    return true;
}

/* Adds the face's normal, and lets the corners name it. A face without area gets a zero. */
static bool add_flat_normal(obj_reader *o)
{
    obj_vertices *const v = &o->vertices;
    const double *const n = o->polygon.normal;
    const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (v->normal_count >= OBJ_NONE - 1)
        return reader_fail(o->r, "it has too many faces");
    if (!reader_grow(o->r, &v->normals, &v->normal_room, v->normal_count + 1, sizeof *v->normals))
        return false;
    for (int c = 0; c < 3; ++c)
        v->normals[v->normal_count][c] =
            length > 0.0 && isfinite(length) ? (float)(n[c] / length) : 0.0f;
    for (size_t i = 0; i < o->corner_count; ++i)
        o->corners[i].vn = (uint32_t)v->normal_count;
    ++v->normal_count;
    return true;
}

static bool add_face(obj_reader *o, const text_cursor *t)
{
    uint32_t number;
    uint32_t smoothing = o->corners[0].vn != OBJ_NONE ? OBJ_SMOOTH_ALL : o->smoothing;
    if (!find_group(o, MODEL_TRIANGLES, &number) || !cut_face(o, t))
        return false;
    if (smoothing == OBJ_FLAT && !add_flat_normal(o))
        return false;
    uint32_t *const indices = add_indices(o, o->groups + number, o->polygon.index_count);
    if (indices == NULL)
        return false;
    for (size_t i = 0; i < o->polygon.index_count; ++i)
        if (!add_vertex(o, number, o->corners + o->polygon.triangles[i], smoothing, indices + i))
            return false;
    return true;
}

static bool add_line(obj_reader *o)
{
    uint32_t number, index = 0;
    if (!find_group(o, MODEL_LINES, &number))
        return false;
    uint32_t *const indices = add_indices(o, o->groups + number, 2 * (o->corner_count - 1));
    if (indices == NULL)
        return false;
    for (size_t i = 0; i < o->corner_count; ++i) {
        if (!add_vertex(o, number, o->corners + i, OBJ_SMOOTH_ALL, &index))
            return false;
        if (i > 0)
            indices[2 * i - 1] = index;
        if (i + 1 < o->corner_count)
            indices[2 * i] = index;
    }
    return true;
}

static bool add_points(obj_reader *o)
{
    uint32_t number;
    if (!find_group(o, MODEL_POINTS, &number))
        return false;
    uint32_t *const indices = add_indices(o, o->groups + number, o->corner_count);
    if (indices == NULL)
        return false;
    for (size_t i = 0; i < o->corner_count; ++i)
        if (!add_vertex(o, number, o->corners + i, OBJ_SMOOTH_ALL, indices + i))
            return false;
    return true;
}

bool obj_add_cloud(obj_reader *o)
{
    const obj_vertices *const v = &o->vertices;
    if (!reader_grow(o->r, &o->corners, &o->corner_room, v->position_count, sizeof *o->corners))
        return false;
    o->corner_count = 0;
    for (size_t i = 0; i < v->position_count; ++i)
        if (isfinite(v->positions[i][0] + v->positions[i][1] + v->positions[i][2]))
            o->corners[o->corner_count++] = (obj_corner){(uint32_t)i, OBJ_NONE, OBJ_NONE};
    if (o->corner_count == 0)
        return true;
    reader_warn(o->r, NULL, "it has no faces, lines or points: its vertices are drawn as points");
    return add_points(o);
}

bool obj_read_face(obj_reader *o, text_cursor *t, text_word keyword)
{
    if (!read_corners(o, t, keyword))
        return false;
    const char letter = keyword.start[0];
    const size_t least = letter == 'f' ? 3 : letter == 'l' ? 2 : 1;
    if (letter == 'f' && o->corner_count == 2) {
        reader_warn(o->r, reader_line(o->r, t->statement),
                    "f has only 2 corners, and is drawn as a line");
        return add_line(o);
    }
    if (o->corner_count < least)
        return reader_fail_at(o->r, reader_line(o->r, t->statement),
                              "%c takes at least %zu corner%s, not %zu", letter, least,
                              least == 1 ? "" : "s", o->corner_count);
    return letter == 'f' ? add_face(o, t) : letter == 'l' ? add_line(o) : add_points(o);
}
