/* Reads OBJ files: runs the stages of obj.h, and reads the statements between faces. */
#include "obj.h"

#include <stdlib.h>
#include <string.h>

static void use_material(obj_reader *o, text_cursor *t)
{
    text_cursor with_comment = *t;
    char copy[80];
    with_comment.comment = '\0';
    const text_word full_name = text_rest(&with_comment), name = text_rest(t);
    o->material = name.length > 0 ? mtl_find(&o->materials, name, full_name) : MTL_NO_MATERIAL;
    if (name.length > 0 && o->material == MTL_NO_MATERIAL && !o->materials.is_one_missing)
        reader_warn(o->r, reader_line(o->r, t->statement),
                    "no material file has the material '%s'; it is drawn light grey",
                    text_copy(name, copy, sizeof copy));
}

/* s N, s 0 and s off; exporters also write s on. */
static void set_smoothing(obj_reader *o, text_cursor *t)
{
    text_word word;
    int64_t number = 1;
    char copy[40];
    text_next_word(t, &word);
    if (text_is_any_case(word, "off"))
        number = 0;
    else if (!text_is_any_case(word, "on") &&
             (!text_integer(word, &number) || number < 0 || number >= (int64_t)OBJ_FLAT)) {
        reader_warn(o->r, reader_line(o->r, t->statement), "s %s names no smoothing group",
                    text_copy(word, copy, sizeof copy));
        return;
    }
    o->smoothing = number > 0 ? (uint32_t)number : OBJ_FLAT;
}

static void warn_not_drawn(obj_reader *o, const text_cursor *t, text_word keyword)
{
    char copy[40];
    reader_warn(o->r, reader_line(o->r, t->statement), "%s is not drawn",
                text_copy(keyword, copy, sizeof copy));
}

/* Statements of one letter are most of a file. */
static bool read_letter(obj_reader *o, text_cursor *t, text_word keyword)
{
    switch (keyword.start[0]) {
    case 'f':
    case 'l':
    case 'p':
        return obj_read_face(o, t, keyword);
    case 'v':
        ++o->positions_before;
        return true;
    case 's':
        set_smoothing(o, t);
        return true;
    case 'g':
    case 'o':
        return true;
    default:
        warn_not_drawn(o, t, keyword);
        return true;
    }
}

static bool read_statement(obj_reader *o, text_cursor *t, text_word keyword)
{
    if (keyword.length == 1)
        return read_letter(o, t, keyword);
    if (text_is(keyword, "vt"))
        ++o->texcoords_before;
    else if (text_is(keyword, "vn"))
        ++o->normals_before;
    else if (text_is(keyword, "usemtl"))
        use_material(o, t);
    else if (!text_is(keyword, "mtllib"))
        warn_not_drawn(o, t, keyword);
    return true;
}

/* Reads the statements in their order, all vertices and materials being known. */
static bool read_statements(obj_reader *o)
{
    text_cursor t = obj_begin(o->r);
    text_word word;
    o->group_of_count = (o->materials.count + 1) * OBJ_GROUPS_OF_MATERIAL;
    o->group_of = reader_allocate(o->r, o->group_of_count, sizeof *o->group_of);
    o->last_vertex = reader_allocate(o->r, o->vertices.position_count, sizeof *o->last_vertex);
    bool good = o->group_of != NULL && o->last_vertex != NULL;
    while (good && text_next_line(&t)) {
        text_next_word(&t, &word);
        good = read_statement(o, &t, word);
        text_pass_line(&t);
    }
    return good;
}

static void free_reader(obj_reader *o)
{
    model_reader *const r = o->r;
    obj_vertices *const v = &o->vertices;
    for (size_t i = 0; i < o->group_count; ++i)
        reader_release(r, o->groups[i].indices, o->groups[i].index_room,
                       sizeof *o->groups[i].indices);
    reader_release(r, o->groups, o->group_room, sizeof *o->groups);
    reader_release(r, o->group_of, o->group_of_count, sizeof *o->group_of);
    reader_release(r, o->group_vertices, o->group_vertex_room, sizeof *o->group_vertices);
    reader_release(r, o->last_vertex, v->position_count, sizeof *o->last_vertex);
    reader_release(r, o->corners, o->corner_room, sizeof *o->corners);
    polygon_release(r, &o->polygon);
    reader_release(r, v->positions, v->position_room, sizeof *v->positions);
    reader_release(r, v->colors, v->color_room, sizeof *v->colors);
    reader_release(r, v->texcoords, v->texcoord_room, sizeof *v->texcoords);
    reader_release(r, v->normals, v->normal_room, sizeof *v->normals);
    mtl_free(r, &o->materials);
    free(o);
}

bool read_obj(model_reader *r)
{
    if (memchr(r->bytes, '\0', r->size) != NULL)
        return reader_fail(r, "it has a NUL byte, so it is not a text");
    obj_reader *const o = calloc(1, sizeof *o);
    if (o == NULL)
        return reader_fail(r, "not enough memory");
    o->r = r;
    o->material = MTL_NO_MATERIAL;
    o->smoothing = OBJ_SMOOTH_ALL;
    o->polygon.work_left = POLYGON_MOST_WORK;
    bool good = obj_read_vertices(o);
    if (good) {
        mtl_sort(r, &o->materials);
        good = read_statements(o) && (o->group_count > 0 || obj_add_cloud(o)) && obj_make_parts(o);
    }
    free_reader(o);
    return good;
}
