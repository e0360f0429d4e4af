/* The table of options: what the command line takes, --help and --help-all print, and the man page
 * and the completions of shells say (tools/gnomon/documents). */
#ifndef OPTION_TABLE_H
#define OPTION_TABLE_H

#include "options.h"

/* What the value of an option is, and what is at its place in `options`. */
typedef enum option_kind {
    OPTION_HEADING = 0, /* no option, but the heading of those that follow */
    OPTION_HELP,        /* no value: ends the parsing, with help */
    OPTION_HELP_ALL,    /* likewise */
    OPTION_FLAG,        /* no value; a bool */
    OPTION_TEXT,        /* any; a const char * */
    OPTION_FILE,        /* not empty; a const char * */
    OPTION_CHOICE,      /* one of `words`, in the order of an enum from 0 on */
    OPTION_SHADER,      /* one of `words`; a shading */
    OPTION_BACKEND,     /* one of `words`; a gn_backend */
    OPTION_FORMAT,      /* one of `words`, in any case; a picture_format */
    OPTION_MAP,         /* a file or none; a map_option */
    OPTION_NORMAL_MAP,  /* a file, with its kind before it, or one of `words`; options.normals */
    OPTION_WHOLE,       /* a whole number from `least` to `most`; a uint32_t */
    OPTION_SAMPLES,     /* a whole number that is checked later; a uint32_t */
    OPTION_SIZE,        /* WxH; options.width and height */
    OPTION_PAIR,        /* X,Y; a pair_option */
    OPTION_BACKGROUND,  /* rrggbb or rrggbb,rrggbb; options.background and below */
    OPTION_EDGES,       /* rrggbb or no value; options.edges and edges_color */
    OPTION_POINTS,      /* a size or no value; options.points and point_size */
    OPTION_AXIS,        /* an axis; a gn_vec3 */
    /* Of the rest, the numbers must be finite as floats. */
    OPTION_NUMBER, /* a float */
    OPTION_VECTOR, /* X,Y,Z; a gn_vec3 */
    OPTION_PLACE,  /* likewise; camera.eye or target, with what floats lack */
    OPTION_ROTATE, /* transformations of the model before the option */
    OPTION_SCALE,
    OPTION_TRANSLATE
} option_kind;

/* An option may have several rows, for different commands. */
typedef struct option_row {
    const char *name;     /* without dashes; of a heading, its title in the man page */
    const char *argument; /* null: none; "[=SIZE]": it may be left out */
    int commands;         /* a set of `command` */
    struct {
        option_kind kind;
        size_t place, given; /* in `options`: of the value, and of a bool that is set; 0: none */
        uint32_t least, most;
        const char *form; /* the expected value, in messages; null: `words` */
    } value;
    /* What shells complete: the values with blanks between them, or FILE; null: nothing. */
    const char *words;
    /* In --help: a line, which begins with + if the option stands on the line of the one before it.
     * Null: the option is not in --help, and the heading is not printed. */
    const char *brief;
    /* In --help-all and in the man page; null: as `brief`. Its first words, up to a mark such as a
     * comma, are what zsh shows. */
    const char *text;
} option_row;

extern const option_row option_table[];
extern const size_t option_count;

/* The commands that draw models. They have --help-all. */
#define COMMANDS_OF_MODELS                                                                         \
    (COMMAND_RENDER | COMMAND_COMPARE | COMMAND_SPIN | COMMAND_VIEW | COMMAND_EXPLAIN)

/* The letter of an option, as in -o; 0 if it has none. */
char option_letter(const option_row *row);

#endif
