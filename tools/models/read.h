/* Reads models: OBJ with MTL, PLY, STL and glTF 2.0 (.gltf, .glb).
 *
 * What is drawn, what is warned of and what is refused in each format is in tools/guide/models.md.
 * Every reader takes a file's bytes as hostile: it allocates within a budget, recurses nowhere and
 * reads nothing outside the file. */
#ifndef READ_H
#define READ_H

#include "reader.h"

typedef enum model_format {
    MODEL_OBJ,
    MODEL_PLY,
    MODEL_STL,
    MODEL_GLTF, /* a text */
    MODEL_GLB,  /* binary */
    MODEL_OTHER /* none of these */
} model_format;

/* The format by the extension of a name, in upper or lower case. */
model_format model_format_of(const char *name);

/* Reads a model of a format. Files that it names are opened by `files`, which may be null; `name`
 * is for messages. At most `budget` bytes of memory are in use at a time. Normals that the file
 * lacks are computed (model_complete_normals). Returns true; free with model_free. Otherwise
 * returns false with the reason in `messages` and nothing to free. Warnings are in `messages`
 * either way; free with model_messages_free. */
bool model_read_bytes(const char *name, model_format format, const uint8_t *bytes, size_t size,
                      const model_files *files, uint64_t budget, double crease_degrees,
                      model *result, model_messages *messages);

/* The readers. They fill r->result: parts with positions, colours and indices, normals or zeros,
 * texture coordinates and tangents or room for them. They return false with the fault recorded;
 * what they have allocated for r->result is freed by the caller. */
bool read_obj(model_reader *r);
bool read_ply(model_reader *r);
bool read_stl(model_reader *r);
bool read_gltf(model_reader *r, bool is_binary);

#endif
