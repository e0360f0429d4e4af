/* JSON texts (RFC 8259) as a flat array of tokens. */
#ifndef JSON_H
#define JSON_H

#include "reader.h"

typedef enum json_kind {
    JSON_NULL = 0,
    JSON_FALSE,
    JSON_TRUE,
    JSON_NUMBER,
    JSON_STRING,
    JSON_ARRAY,
    JSON_OBJECT
} json_kind;

/* Tokens stand in the order of the text. A member of an object is two tokens: its name, a string,
 * and directly behind it its value. */
typedef struct json_token {
    json_kind kind;
    uint32_t start, end; /* bytes of the text; of a string without its quotes */
    uint32_t parent;     /* the array or object that it is in, or JSON_NONE */
    uint32_t index;      /* of an element of an array: its number there */
    uint32_t next;       /* the token behind it and behind all that is in it */
} json_token;

/* No token. It stands for a null, so that a search in what was not found finds nothing. */
#define JSON_NONE 0
#define JSON_ROOT 1

typedef struct json {
    const char *text;
    json_token *tokens;
    size_t count, capacity;
} json;

/* Reads a text, which must stay. A byte-order mark is skipped. Returns false with a fault that
 * names the line if it is no JSON; json_free frees the tokens either way. */
bool json_parse(model_reader *r, const uint8_t *text, size_t size, json *j);
void json_free(model_reader *r, json *j);

json_kind json_kind_of(const json *j, uint32_t token);

/* The value of an object's first member with this name; JSON_NONE if there is none, or if `object`
 * is no object. */
uint32_t json_member(const json *j, uint32_t object, const char *name);

/* Walks through the elements of an array, or the values of an object; JSON_NONE at the end, and for
 * what is neither. */
uint32_t json_first(const json *j, uint32_t container);
uint32_t json_after(const json *j, uint32_t element);
uint32_t json_count(const json *j, uint32_t container);

/* The name of a member, given its value; JSON_NONE for what is no member. */
uint32_t json_name(const json *j, uint32_t value);

/* Whether a token is a string of these bytes, none of which needs an escape. */
bool json_is(const json *j, uint32_t token, const char *text);

/* The value of a number. Returns false if the token is none, or one that a double cannot hold. */
bool json_number(const json *j, uint32_t token, double *value);

/* Writes a string without its escapes to a buffer of at least end - start + 1 bytes, and ends it
 * with a zero. Returns the length. U+0000 and halves of surrogate pairs become U+FFFD. */
size_t json_unescape(const json *j, uint32_t token, char *buffer);

/* Whether bytes are UTF-8 (RFC 3629). */
bool json_is_utf8(const char *text, size_t length);

/* Copies a string for a message: at most size - 1 bytes, cut between characters. Bytes that are no
 * UTF-8 become question marks. */
const char *json_copy(const json *j, uint32_t token, char *buffer, size_t size);

/* Returns where a token is, as a JSON pointer (RFC 6901): "/meshes/0/primitives/1". The beginning
 * of a long path is left out. */
const char *json_path(const json *j, uint32_t token, char *buffer, size_t size);

#endif
