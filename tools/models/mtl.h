/* Materials of OBJ files: MTL as Wavefront's "File Formats, version 4.2" (1995), section 5, states
 * it, with the statements that exporters add: Ke, Tr, map_Ke, norm. */
#ifndef MTL_H
#define MTL_H

#include "reader.h"
#include "text.h"

/* A statement of a map. The name lies in the material file. */
typedef struct mtl_map {
    text_word name;            /* empty: there is no such map */
    float scale[2], offset[2]; /* texture coordinates become scale times themselves plus offset */
    float strength;            /* -bm */
    char channel;              /* -imfchan; 0: not given */
    bool is_clamped;
} mtl_map;

typedef struct mtl_material {
    text_word name;      /* without a comment behind it */
    text_word full_name; /* with it: the # of "Material #25" belongs to the name */
    uint32_t library;    /* the file that defines it */
    uint64_t line;
    float color[4]; /* Kd and d */
    model_surface surface;
    mtl_map maps[MAP_COUNT];
    float scale[2], offset[2]; /* of the part's texture coordinates */
} mtl_material;

/* A material file, which stays open as long as names in it are used. */
typedef struct mtl_library {
    char *name;
    size_t name_size;
    model_file file;
} mtl_library;

#define MTL_MOST_LIBRARIES 256
#define MTL_NO_MATERIAL UINT32_MAX

typedef struct mtl_materials {
    mtl_library libraries[MTL_MOST_LIBRARIES];
    uint32_t library_count;
    bool is_one_missing; /* a material file could not be read, which was warned of */
    mtl_material *all;
    size_t count, room;
} mtl_materials;

/* Opens and reads the files that a statement `mtllib` names: one name, which may have blanks, or
 * several names between blanks. A file that cannot be read is a warning. Returns false with the
 * fault recorded if there is not enough memory. */
bool mtl_add_libraries(model_reader *r, mtl_materials *m, text_word names, uint64_t line);

/* Sorts the materials by name, after the last library. The first material of a name stays the one
 * that is found. */
void mtl_sort(model_reader *r, mtl_materials *m);

/* The number of the material with this name, or MTL_NO_MATERIAL. */
uint32_t mtl_find(const mtl_materials *m, text_word name, text_word full_name);

/* Closes the files and frees the materials. */
void mtl_free(model_reader *r, mtl_materials *m);

/* Reads an open library. */
bool mtl_read(model_reader *r, mtl_materials *m, uint32_t library);

/* Reads the rest of a map's statement: options and a name, in any order. Warns of options that are
 * not drawn. Returns false after a warning if there is no name. */
bool mtl_read_map(model_reader *r, text_cursor *t, text_word keyword, mtl_map *map);

/* The map of no file. */
mtl_map mtl_no_map(void);

#endif
