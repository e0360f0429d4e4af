/* The members of scene_draw that are switches, enumerations or numbers: one table, with a row for
 * each. Scene text, shrinking, hostile values and pairs of states go over its rows, so that a new
 * member of gn_pipeline, gn_sampler or gn_mesh is listed here alone.
 *
 * A member has one line or several, and a line has one value or several, as scene text shows them.
 * For example color.blend[0].source has GN_MAX_COLORS lines of one value, and color.blend_constant
 * has one line of four values. */
#ifndef SCENE_MEMBERS_H
#define SCENE_MEMBERS_H

#include "scene.h"
#include "scene_text.h"

typedef enum member_type {
    MEMBER_ELSEWHERE, /* pointers, bulk data and what the drawing side sets: other code handles
                         them */
    MEMBER_SWITCH,    /* bool */
    MEMBER_NAMED,     /* an enumeration */
    MEMBER_BYTE,      /* uint8_t */
    MEMBER_NUMBER,    /* uint32_t */
    MEMBER_INTEGER,   /* int32_t */
    MEMBER_FLOAT
} member_type;

typedef struct scene_member {
    const char *name; /* the path in scene_draw, without `state.`: color.blend[0].source */
    size_t offset;    /* of the first value, in scene_draw */
    member_type type;
    text_names names;  /* if type is MEMBER_NAMED */
    uint32_t largest;  /* the largest value, for MEMBER_BYTE and MEMBER_NUMBER */
    float low, high;   /* the range that gn_pipeline_check accepts, for MEMBER_FLOAT */
    uint32_t simplest; /* what shrinking prefers to the value of scene_add_draw; 0: nothing */
    size_t lines;      /* the length of an array; 0: it is no array */
    size_t stride;     /* bytes from line to line */
    size_t together;   /* values per line; 0 means 1 */
    size_t bytes;      /* the size, for MEMBER_ELSEWHERE */
} scene_member;

extern const scene_member scene_members[];
extern const size_t scene_member_count;

/* Whether a member is one of scene_draw.state. */
static inline bool scene_member_is_state(const scene_member *m)
{
    return m->offset - offsetof(scene_draw, state) < sizeof(gn_pipeline);
}

static inline size_t scene_member_lines(const scene_member *m)
{
    return m->lines ? m->lines : 1;
}

static inline size_t scene_member_values(const scene_member *m)
{
    return m->together ? m->together : 1;
}

/* Returns the bytes of a value. */
size_t scene_member_size(const scene_member *m);

/* Return and set a value of a draw: a number's bits, 0 or 1 for a switch. `line` must be below
 * scene_member_lines and `value` below scene_member_values. */
uint32_t scene_member_get(const scene_member *m, const scene_draw *d, size_t line, size_t value);
void scene_member_set(const scene_member *m, scene_draw *d, size_t line, size_t value,
                      uint32_t word);

/* Returns the row of a name such as color.blend[3].source, and its line, 3; null where there is no
 * such row or line. */
const scene_member *scene_member_named(const char *name, size_t *line);

/* Writes a line's name to memory of SCENE_MEMBER_NAME bytes. */
#define SCENE_MEMBER_NAME 64
void scene_member_name(const scene_member *m, size_t line, char *name);

/* Writes, as scene text, the lines whose values differ from scene_default_draw's
 * (scene_write.c). */
void scene_write_members(const scene_draw *d, FILE *out);

#endif
