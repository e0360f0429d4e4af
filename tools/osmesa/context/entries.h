/* The table of all functions of OpenGL, which registry.py writes. */
#ifndef OSMESA_ENTRIES_H
#define OSMESA_ENTRIES_H

typedef void entry_function(void);

typedef struct entry_point {
    const char *name;
    entry_function *function;
} entry_point;

/* In the order of names. */
extern const entry_point entries[];
extern const unsigned entry_count;

/* Records that the program called a function that is not supported. The first time, its name is
 * written to standard error if the environment has GNOMON_DEBUG=1; *is_known tells. */
void unsupported(const char *function, unsigned char *is_known);

#endif
