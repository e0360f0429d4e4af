/* JSON, member by member, into a text. */
#ifndef PAGE_JSON_H
#define PAGE_JSON_H

#include "page_text.h"

/* Begins a member of an object, with a comma unless it is the first. */
void page_json_name(text *to, const char *name);

/* Members. A float that is not finite becomes null: JSON has no such numbers. */
void page_json_whole(text *to, const char *name, uint64_t value);
void page_json_address(text *to, const char *name, const void *address);
void page_json_float(text *to, const char *name, float value);
void page_json_floats(text *to, const char *name, const float *values, size_t count);
void page_json_string(text *to, const char *name, const char *value);
void page_json_truth(text *to, const char *name, bool value);

/* A string with its quotation marks. Control characters become spaces. */
void page_json_quoted(text *to, const char *value);

/* A member that is an object, and the end of an object. */
void page_json_begin(text *to, const char *name);
void page_json_end(text *to);

#endif
