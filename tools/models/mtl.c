/* Reads material files. What is wrong or not drawn in them is a warning: a material never makes a
 * model unreadable. */
#include "mtl.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* What is known of a material before its end. */
typedef struct draft {
    mtl_material *material; /* null before the first newmtl */
    bool has_kd, has_illum, has_d, has_normals, has_heights;
    double illum;
    float ambient[3], glow[3];
    bool has_ambient;
    uint64_t ambient_line, kd_line, glow_line, d_line, illum_line, map_ka_line;
    text_word map_ka;
} draft;

static void warn_of_word(model_reader *r, const text_cursor *t, text_word keyword, text_word word,
                         const char *what)
{
    char copies[2][40];
    reader_warn(r, reader_line(r, t->statement), "%s %s: %s",
                text_copy(keyword, copies[0], sizeof copies[0]),
                text_copy(word, copies[1], sizeof copies[1]), what);
}

static void warn_not_drawn(model_reader *r, uint64_t line, text_word keyword)
{
    char copy[40];
    reader_warn(r, reader_line(r, line), "%s is not drawn", text_copy(keyword, copy, sizeof copy));
}

/* Reads a finite number that fits a float. Returns false after a warning. */
static bool read_number(model_reader *r, text_cursor *t, text_word keyword, float *value)
{
    text_word word;
    double number;
    char copy[40];
    if (!text_next_word(t, &word)) {
        reader_warn(r, reader_line(r, t->statement), "%s lacks its number; the default is used",
                    text_copy(keyword, copy, sizeof copy));
        return false;
    }
    if (!text_number(word, false, &number) || fabs(number) > (double)FLT_MAX) {
        warn_of_word(r, t, keyword, word, "this is not a number; the default is used");
        return false;
    }
    *value = (float)number;
    return true;
}

/* Reads red, green and blue, or one number for all three. Returns false after a warning. */
static bool read_color(model_reader *r, text_cursor *t, text_word keyword, float color[3])
{
    text_cursor ahead = *t;
    text_word word;
    float read[3];
    char copy[40];
    if (text_next_word(&ahead, &word) &&
        (text_is_any_case(word, "spectral") || text_is_any_case(word, "xyz"))) {
        warn_of_word(r, t, keyword, word, "this is not drawn; the default is used");
        return false;
    }
    if (!read_number(r, t, keyword, read))
        return false;
    ahead = *t;
    if (!text_next_word(&ahead, &word)) {
        color[0] = color[1] = color[2] = read[0];
        return true;
    }
    if (!read_number(r, t, keyword, read + 1) || !read_number(r, t, keyword, read + 2))
        return false;
    memcpy(color, read, sizeof read);
    if (text_next_word(t, &word))
        reader_warn(r, reader_line(r, t->statement), "%s has more than three numbers",
                    text_copy(keyword, copy, sizeof copy));
    return true;
}

static bool is_color(const float color[3], float value)
{
    return color[0] == value && color[1] == value && color[2] == value;
}

/* d, or Tr, which is 1 - d. */
static void read_opacity(model_reader *r, text_cursor *t, text_word keyword, draft *d)
{
    text_cursor ahead = *t;
    text_word word;
    float value;
    if (text_next_word(&ahead, &word) && text_is_any_case(word, "-halo")) {
        warn_of_word(r, t, keyword, word, "this is not drawn; the opacity is the same everywhere");
        *t = ahead;
        text_next_word(&ahead, &word);
    }
    if (!read_number(r, t, keyword, &value))
        return;
    if (value < 0.0f || value > 1.0f)
        warn_of_word(r, t, keyword, word, "this lies outside 0 to 1");
    value = value > 0.0f ? (value < 1.0f ? value : 1.0f) : 0.0f;
    if (keyword.length > 1)
        value = 1.0f - value;
    if (d->has_d && fabsf(value - d->material->color[3]) > 0.001f)
        reader_warn(r, reader_line(r, t->statement), "d and Tr disagree; the last one is used");
    d->material->color[3] = value;
    d->has_d = true;
    d->d_line = t->statement;
}

static void read_exponent(model_reader *r, text_cursor *t, text_word keyword, draft *d)
{
    float value;
    if (!read_number(r, t, keyword, &value))
        return;
    if (value > (float)MODEL_MAX_EXPONENT)
        reader_warn(r, reader_line(r, t->statement), "Ns above %d is drawn as %d",
                    MODEL_MAX_EXPONENT, MODEL_MAX_EXPONENT);
    value = value > 1.0f ? fminf(value, (float)MODEL_MAX_EXPONENT) : 1.0f;
    d->material->surface.shine.exponent = (uint32_t)lrintf(value);
}

static void read_illum(model_reader *r, text_cursor *t, text_word keyword, draft *d)
{
    float value;
    if (!read_number(r, t, keyword, &value))
        return;
    d->has_illum = true;
    d->illum = (double)value;
    d->illum_line = t->statement;
}

/* Which map a statement states; MAP_COUNT: none that is drawn. */
static map_kind map_of(text_word keyword)
{
    static const struct {
        const char *keyword;
        map_kind kind;
    } maps[] = {
        {"map_Kd", MAP_DIFFUSE}, {"map_Ks", MAP_SPECULAR}, {"map_Ke", MAP_GLOW},
        {"map_d", MAP_OPACITY},  {"map_bump", MAP_NORMAL}, {"bump", MAP_NORMAL},
        {"map_Kn", MAP_NORMAL},  {"norm", MAP_NORMAL},
    };
    for (size_t i = 0; i < sizeof maps / sizeof maps[0]; ++i)
        if (text_is_any_case(keyword, maps[i].keyword))
            return maps[i].kind;
    return MAP_COUNT;
}

static void read_map(model_reader *r, text_cursor *t, text_word keyword, draft *d)
{
    const map_kind kind = map_of(keyword);
    mtl_map map;
    if (!mtl_read_map(r, t, keyword, &map))
        return;
    if (kind == MAP_NORMAL) {
        const bool is_heights =
            text_is_any_case(keyword, "bump") || text_is_any_case(keyword, "map_bump");
        d->has_heights = d->has_heights || is_heights;
        d->has_normals = d->has_normals || !is_heights;
        if (d->has_heights && d->has_normals)
            reader_warn(r, reader_line(r, t->statement),
                        "bump is not drawn where the material has a map of normals");
        if (is_heights && d->has_normals)
            return;
    }
    d->material->maps[kind] = map;
}

/* map_Ka is often the same file as map_Kd, which lights the surface from everywhere too. */
static void keep_map_ka(text_cursor *t, draft *d)
{
    text_word word;
    d->map_ka_line = t->statement;
    while (text_next_word(t, &word))
        d->map_ka = word;
}

static void read_statement(model_reader *r, text_cursor *t, text_word keyword, draft *d)
{
    mtl_material *const m = d->material;
    float filter[3];
    if (map_of(keyword) != MAP_COUNT) {
        read_map(r, t, keyword, d);
    } else if (text_is_any_case(keyword, "Kd")) {
        d->has_kd = read_color(r, t, keyword, m->color) || d->has_kd;
        d->kd_line = t->statement;
    } else if (text_is_any_case(keyword, "Ks")) {
        read_color(r, t, keyword, m->surface.shine.specular);
    } else if (text_is_any_case(keyword, "Ka")) {
        d->has_ambient = read_color(r, t, keyword, d->ambient);
        d->ambient_line = t->statement;
    } else if (text_is_any_case(keyword, "Ke")) {
        read_color(r, t, keyword, d->glow);
        d->glow_line = t->statement;
    } else if (text_is_any_case(keyword, "Tf")) {
        if (read_color(r, t, keyword, filter) && !is_color(filter, 1.0f))
            warn_not_drawn(r, t->statement, keyword);
    } else if (text_is_any_case(keyword, "d") || text_is_any_case(keyword, "Tr")) {
        read_opacity(r, t, keyword, d);
    } else if (text_is_any_case(keyword, "Ns")) {
        read_exponent(r, t, keyword, d);
    } else if (text_is_any_case(keyword, "illum")) {
        read_illum(r, t, keyword, d);
    } else if (text_is_any_case(keyword, "map_Ka")) {
        keep_map_ka(t, d);
    } else if (!text_is_any_case(keyword, "Ni") && !text_is_any_case(keyword, "sharpness")) {
        /* Those two matter only to refraction and reflection, which illum and refl warn of. */
        warn_not_drawn(r, t->statement, keyword);
    }
}

static void finish_colors(model_reader *r, const draft *d)
{
    mtl_material *const m = d->material;
    const bool has_map = m->maps[MAP_DIFFUSE].name.length > 0;
    if (has_map && !d->has_kd) {
        m->color[0] = m->color[1] = m->color[2] = 1.0f;
    } else if (has_map && is_color(m->color, 0.0f)) {
        /* Exporters that mean the map alone write this. */
        reader_warn(r, reader_line(r, d->kd_line), "Kd 0 0 0 would hide its map_Kd; 1 1 1 is used");
        m->color[0] = m->color[1] = m->color[2] = 1.0f;
    }
    /* The usual values: that of Kd, all of it, or nothing. */
    if (d->has_ambient && !is_color(d->ambient, 0.0f) && !is_color(d->ambient, 1.0f) &&
        memcmp(d->ambient, m->color, sizeof d->ambient) != 0)
        reader_warn(r, reader_line(r, d->ambient_line),
                    "Ka is not drawn: Kd is used for light from everywhere too");
    if (d->map_ka.length > 0 && (d->map_ka.length > m->maps[MAP_DIFFUSE].name.length ||
                                 memcmp(m->maps[MAP_DIFFUSE].name.start +
                                            m->maps[MAP_DIFFUSE].name.length - d->map_ka.length,
                                        d->map_ka.start, d->map_ka.length) != 0))
        reader_warn(r, reader_line(r, d->map_ka_line), "map_Ka is not drawn");
    if (m->maps[MAP_GLOW].name.length > 0)
        for (int c = 0; c < 3; ++c)
            m->surface.emissive[c] = is_color(d->glow, 0.0f) ? 1.0f : d->glow[c];
    else if (!is_color(d->glow, 0.0f))
        reader_warn(r, reader_line(r, d->glow_line), "Ke without map_Ke is not drawn");
}

/* Section 5 of the specification, "Illumination models". */
static void finish_illumination(model_reader *r, const draft *d)
{
    model_surface *const s = &d->material->surface;
    if (!d->has_illum)
        return;
    if (d->illum == 0.0)
        s->is_unlit = 1;
    else if (d->illum == 1.0)
        memset(s->shine.specular, 0, sizeof s->shine.specular);
    else if (d->illum != 2.0)
        reader_warn(r, reader_line(r, d->illum_line),
                    "illum %g is drawn as illum 2, without reflection and refraction", d->illum);
}

/* All maps of a part have one set of texture coordinates: the diffuse map's, or the first map's. */
static void finish_maps(model_reader *r, const draft *d)
{
    mtl_material *const m = d->material;
    const mtl_map *first = NULL;
    for (int i = 0; i < MAP_COUNT; ++i) {
        const mtl_map *const map = m->maps + i;
        if (map->name.length == 0)
            continue;
        if (first == NULL)
            first = map;
        else if (memcmp(map->scale, first->scale, sizeof map->scale) != 0 ||
                 memcmp(map->offset, first->offset, sizeof map->offset) != 0)
            reader_warn(r, reader_line(r, m->line),
                        "the maps of a material have different -s and -o; the first map's are "
                        "used for all");
    }
    if (first != NULL) {
        memcpy(m->scale, first->scale, sizeof m->scale);
        memcpy(m->offset, first->offset, sizeof m->offset);
    }
    m->surface.alpha =
        m->color[3] < 1.0f || m->maps[MAP_OPACITY].name.length > 0 ? MODEL_BLEND : MODEL_OPAQUE;
    if (m->color[3] == 0.0f)
        reader_warn(r, reader_line(r, d->d_line), "the opacity is 0: the material cannot be seen");
}

static void finish_material(model_reader *r, const draft *d)
{
    if (d->material == NULL)
        return;
    finish_colors(r, d);
    finish_illumination(r, d);
    finish_maps(r, d);
}

/* Adds a material with the values of statements that are missing. */
static bool begin_material(model_reader *r, mtl_materials *m, uint32_t library, text_cursor *t,
                           draft *d)
{
    text_cursor with_comment = *t;
    if (m->count >= MTL_NO_MATERIAL)
        return reader_fail(r, "it has too many materials");
    if (!reader_grow(r, &m->all, &m->room, m->count + 1, sizeof *m->all))
        return false;
    mtl_material *const material = m->all + m->count++;
    memset(material, 0, sizeof *material);
    with_comment.comment = '\0';
    material->full_name = text_rest(&with_comment);
    material->name = text_rest(t);
    material->library = library;
    material->line = t->statement;
    material->surface = model_surface_default();
    for (int c = 0; c < 3; ++c) {
        material->color[c] = 0.6f;
        material->surface.shine.specular[c] = 0.0f;
    }
    material->color[3] = material->scale[0] = material->scale[1] = 1.0f;
    for (int i = 0; i < MAP_COUNT; ++i)
        material->maps[i] = mtl_no_map();
    memset(d, 0, sizeof *d);
    d->material = material;
    if (material->name.length == 0)
        reader_warn(r, reader_line(r, t->statement), "newmtl has no name");
    return true;
}

static bool read_statements(model_reader *r, mtl_materials *m, uint32_t library, text_cursor *t)
{
    draft d;
    text_word keyword;
    char copy[40];
    memset(&d, 0, sizeof d);
    while (text_next_line(t)) {
        text_next_word(t, &keyword);
        if (text_is_any_case(keyword, "newmtl")) {
            finish_material(r, &d);
            if (!begin_material(r, m, library, t, &d))
                return false;
        } else if (d.material == NULL) {
            reader_warn(r, reader_line(r, t->statement), "%s stands before the first newmtl",
                        text_copy(keyword, copy, sizeof copy));
        } else {
            read_statement(r, t, keyword, &d);
        }
        text_pass_line(t);
    }
    finish_material(r, &d);
    return true;
}

bool mtl_read(model_reader *r, mtl_materials *m, uint32_t library)
{
    const char *const name = r->name;
    const model_file *const file = &m->libraries[library].file;
    text_cursor t = text_begin(file->bytes, file->size);
    bool good = true;
    t.comment = '#';
    t.continues = true;
    r->name = m->libraries[library].name;
    if (file->size > 0 && memchr(file->bytes, '\0', file->size) != NULL)
        reader_warn(r, NULL, "it has a NUL byte, so it is not a text, and is not read");
    else
        good = read_statements(r, m, library, &t);
    r->name = name;
    return good;
}
