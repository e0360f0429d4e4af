/* The one table of the state that can be queried: what glGet and glIsEnabled return, and what
 * glEnable and glEnableClientState set. */
#ifndef OSMESA_STATE_TABLE_H
#define OSMESA_STATE_TABLE_H

#include "gl_context.h"

/* How a value is kept, and so how it is converted (OpenGL 2.1 section 6.1.2). */
typedef enum state_kind {
    STATE_SWITCH,            /* GLboolean, set by glEnable and glDisable */
    STATE_CLIENT_SWITCH,     /* GLboolean, set by glEnableClientState */
    STATE_BOOLEAN,           /* GLboolean */
    STATE_INTEGER,           /* GLint */
    STATE_STENCIL,           /* GLint, clamped to what the window's stencil holds */
    STATE_UNSIGNED,          /* GLuint, enumerations too */
    STATE_FLOAT,             /* GLfloat */
    STATE_FRACTION,          /* GLfloat; 1 is the greatest integer */
    STATE_CLAMPED,           /* a fraction that is clamped to 0..1 unless the window has floats */
    STATE_DOUBLE,            /* GLdouble; 1 is the greatest integer */
    STATE_CONSTANT,          /* an integer: the offset itself */
    STATE_COMPUTED,          /* integers that a function returns */
    STATE_COMPUTED_FLOAT,    /* floats that a function returns */
    STATE_COMPUTED_FRACTION, /* the same; 1 is the greatest integer. Matrices too: the reference has
                                it so, whereas the specification rounds them */
} state_kind;

/* Writes values of the state; a double holds each GLint and GLfloat. */
typedef void compute_state(const context *gl, GLdouble *value);

typedef struct state_row {
    GLenum name;
    state_kind kind;
    unsigned count;         /* of values, up to 16 */
    size_t offset;          /* in the context; of STATE_CONSTANT the value */
    compute_state *compute; /* of the STATE_COMPUTED kinds */
    size_t step;            /* from a texture unit to the next; 0: one for all units */
    bool steps_by_client;   /* the unit is that of glClientActiveTexture */
} state_row;

/* Returns the row of a name, or null. */
const state_row *find_state(GLenum name);

/* Returns where in the context the values of a row are kept, for its texture unit. */
size_t state_offset(const context *gl, const state_row *row);

/* Writes where the switches are kept that GL_ENABLE_BIT saves, for all texture units. Returns how
 * many there are. As in the reference, these are not GL_LIGHT0 to 7, which GL_LIGHTING_BIT saves,
 * and not GL_COLOR_SUM and GL_TEXTURE_CUBE_MAP_SEAMLESS, which nothing saves. */
enum { MOST_SWITCHES = 128 };
size_t switch_places(context *gl, GLboolean *place[MOST_SWITCHES]);

/* Returns where a switch is kept, null for a name that is none. */
GLboolean *find_switch(context *gl, GLenum name, state_kind kind);

#endif
