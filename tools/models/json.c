/* Reads JSON.
 *
 * jsmn, the usual parser without allocation, takes 1.2.3 for a number and checks no string, so most
 * of what is here would be needed beside it. The links to the parents are the stack, so that depth
 * costs no memory of its own. */
#include "json.h"

#include <stdio.h>
#include <string.h>

#include "text.h"

typedef struct parser {
    model_reader *r;
    json *j;
    uint32_t at, size;
} parser;

/* Returns false with a fault at the line where reading is. */
static bool fail(parser *p, const char *what)
{
    uint64_t line = 1;
    for (uint32_t i = 0; i < p->at; ++i)
        line += p->j->text[i] == '\n';
    return reader_fail_at(p->r, reader_line(p->r, line), "%s",
                          p->at < p->size ? what : "the text ends within a value");
}

static void skip_blanks(parser *p)
{
    while (p->at < p->size && (p->j->text[p->at] == ' ' || p->j->text[p->at] == '\t' ||
                               p->j->text[p->at] == '\n' || p->j->text[p->at] == '\r'))
        ++p->at;
}

static bool is_digit(const parser *p)
{
    return p->at < p->size && p->j->text[p->at] >= '0' && p->j->text[p->at] <= '9';
}

/* Skips a character if it is there. */
static bool skip(parser *p, char c)
{
    const bool is_there = p->at < p->size && p->j->text[p->at] == c;
    p->at += is_there;
    return is_there;
}

static bool skip_digits(parser *p)
{
    if (!is_digit(p))
        return fail(p, "a digit is missing in a number");
    while (is_digit(p))
        ++p->at;
    return true;
}

/* RFC 8259, section 6. */
static bool skip_number(parser *p)
{
    skip(p, '-');
    if (skip(p, '0')) {
        if (is_digit(p))
            return fail(p, "a number begins with 0");
    } else if (!skip_digits(p)) {
        return false;
    }
    if (skip(p, '.') && !skip_digits(p))
        return false;
    if (skip(p, 'e') || skip(p, 'E')) {
        if (!skip(p, '+'))
            skip(p, '-');
        if (!skip_digits(p))
            return false;
    }
    return true;
}

/* Skips what follows a backslash. */
static bool skip_escape(parser *p)
{
    const char c = p->at < p->size ? p->j->text[p->at] : '\0';
    if (c == '\0' || strchr("\"\\/bfnrtu", c) == NULL)
        return fail(p, "a backslash begins no escape of JSON");
    ++p->at;
    for (int i = 0; i < 4 && c == 'u'; ++i, ++p->at)
        if (p->at >= p->size || text_hexadecimal(p->j->text[p->at]) < 0)
            return fail(p, "\\u is not followed by four hexadecimal digits");
    return true;
}

/* Skips a string behind its first quote, the last quote too. */
static bool skip_string(parser *p)
{
    while (p->at < p->size) {
        const unsigned char c = (unsigned char)p->j->text[p->at];
        if (c < 0x20)
            return fail(p, "a control character is in a string");
        ++p->at;
        if (c == '"')
            return true;
        if (c == '\\' && !skip_escape(p))
            return false;
    }
    return fail(p, "");
}

static bool skip_word(parser *p, const char *word)
{
    const size_t length = strlen(word);
    if (p->size - p->at < length || memcmp(p->j->text + p->at, word, length) != 0)
        return fail(p, "this is no value of JSON");
    p->at += (uint32_t)length;
    return true;
}

/* Adds a token that begins where reading is. */
static bool add(parser *p, json_kind kind, uint32_t parent, uint32_t index)
{
    json *const j = p->j;
    if (j->count >= UINT32_MAX)
        return fail(p, "there are too many values");
    if (!reader_grow(p->r, &j->tokens, &j->capacity, j->count + 1, sizeof *j->tokens))
        return false;
    j->tokens[j->count++] = (json_token){kind, p->at, p->at, parent, index, 0};
    return true;
}

static bool add_string(parser *p, uint32_t parent, uint32_t index)
{
    ++p->at;
    if (!add(p, JSON_STRING, parent, index))
        return false;
    const size_t token = p->j->count - 1;
    if (!skip_string(p))
        return false;
    p->j->tokens[token].end = p->at - 1;
    p->j->tokens[token].next = (uint32_t)p->j->count;
    return true;
}

/* Reads a value; of an array or object only the bracket. */
static bool add_value(parser *p, uint32_t parent, uint32_t index)
{
    const char c = p->at < p->size ? p->j->text[p->at] : '\0';
    bool good;
    if (c == '"')
        return add_string(p, parent, index);
    if (c == '{' || c == '[') {
        good = add(p, c == '{' ? JSON_OBJECT : JSON_ARRAY, parent, index);
        ++p->at;
        return good;
    }
    if (c == 't')
        good = add(p, JSON_TRUE, parent, index) && skip_word(p, "true");
    else if (c == 'f')
        good = add(p, JSON_FALSE, parent, index) && skip_word(p, "false");
    else if (c == 'n')
        good = add(p, JSON_NULL, parent, index) && skip_word(p, "null");
    else if (c == '-' || (c >= '0' && c <= '9'))
        good = add(p, JSON_NUMBER, parent, index) && skip_number(p);
    else
        return fail(p, "a value is missing");
    if (good) {
        p->j->tokens[p->j->count - 1].end = p->at;
        p->j->tokens[p->j->count - 1].next = (uint32_t)p->j->count;
    }
    return good;
}

/* Reads a member's name and its colon. */
static bool add_name(parser *p, uint32_t parent)
{
    skip_blanks(p);
    if (p->at >= p->size || p->j->text[p->at] != '"')
        return fail(p, "the name of a member is missing");
    if (!add_string(p, parent, 0))
        return false;
    skip_blanks(p);
    return skip(p, ':') || fail(p, "a colon is missing behind the name of a member");
}

/* Reads the root and all that is in it. */
static bool add_all(parser *p)
{
    uint32_t open = JSON_NONE, index = 0;
    bool is_first = true;
    do {
        json_token *const t = p->j->tokens + open;
        skip_blanks(p);
        if (open != JSON_NONE && skip(p, t->kind == JSON_OBJECT ? '}' : ']')) {
            t->end = p->at;
            t->next = (uint32_t)p->j->count;
            index = t->index + 1;
            open = t->parent;
            is_first = false;
            continue;
        }
        if (!is_first) {
            if (!skip(p, ','))
                return fail(p, "a comma or a closing bracket is missing");
        } else {
            index = 0;
        }
        if (open != JSON_NONE && t->kind == JSON_OBJECT && !add_name(p, open))
            return false;
        skip_blanks(p);
        if (!add_value(p, open, index))
            return false;
        const size_t last = p->j->count - 1;
        is_first = p->j->tokens[last].kind >= JSON_ARRAY;
        if (is_first)
            open = (uint32_t)last;
        ++index;
    } while (open != JSON_NONE);
    return true;
}

bool json_parse(model_reader *r, const uint8_t *text, size_t size, json *j)
{
    memset(j, 0, sizeof *j);
    j->text = (const char *)text;
    if (size >= UINT32_MAX)
        return reader_fail(r, "its JSON has more than 4 GiB");
    parser p = {r, j, 0, (uint32_t)size};
    if (size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0)
        p.at = 3;
    if (!add(&p, JSON_NULL, JSON_NONE, 0) || !add_all(&p))
        return false;
    skip_blanks(&p);
    return p.at == p.size || fail(&p, "something follows the end of the JSON");
}

void json_free(model_reader *r, json *j)
{
    reader_release(r, j->tokens, j->capacity, sizeof *j->tokens);
    memset(j, 0, sizeof *j);
}

json_kind json_kind_of(const json *j, uint32_t token)
{
    return j->tokens[token].kind;
}

uint32_t json_first(const json *j, uint32_t container)
{
    const json_token *const t = j->tokens + container;
    if (t->kind < JSON_ARRAY || t->next == container + 1)
        return JSON_NONE;
    return container + (t->kind == JSON_OBJECT ? 2 : 1);
}

uint32_t json_after(const json *j, uint32_t element)
{
    const json_token *const parent = j->tokens + j->tokens[element].parent;
    const uint32_t next = j->tokens[element].next;
    if (next >= parent->next)
        return JSON_NONE;
    return parent->kind == JSON_OBJECT ? next + 1 : next;
}

uint32_t json_count(const json *j, uint32_t container)
{
    uint32_t count = 0;
    for (uint32_t e = json_first(j, container); e != JSON_NONE; e = json_after(j, e))
        ++count;
    return count;
}

uint32_t json_name(const json *j, uint32_t value)
{
    return j->tokens[j->tokens[value].parent].kind == JSON_OBJECT ? value - 1 : JSON_NONE;
}

uint32_t json_member(const json *j, uint32_t object, const char *name)
{
    if (j->tokens[object].kind != JSON_OBJECT)
        return JSON_NONE;
    for (uint32_t e = json_first(j, object); e != JSON_NONE; e = json_after(j, e))
        if (json_is(j, e - 1, name))
            return e;
    return JSON_NONE;
}

bool json_is(const json *j, uint32_t token, const char *text)
{
    const json_token *const t = j->tokens + token;
    const size_t length = strlen(text);
    return t->kind == JSON_STRING && t->end - t->start == length &&
           memcmp(j->text + t->start, text, length) == 0;
}

bool json_number(const json *j, uint32_t token, double *value)
{
    const json_token *const t = j->tokens + token;
    return t->kind == JSON_NUMBER &&
           text_number((text_word){j->text + t->start, t->end - t->start}, false, value);
}

static uint32_t four_digits(const char *text)
{
    uint32_t value = 0;
    for (int i = 0; i < 4; ++i)
        value = 16 * value + (uint32_t)text_hexadecimal(text[i]);
    return value;
}

/* Writes a code point as UTF-8; returns the number of bytes. */
static size_t encode(uint32_t code, char *to)
{
    static const unsigned char first[4] = {0, 0xc0, 0xe0, 0xf0};
    const size_t length = code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
    for (size_t i = length; i-- > 1; code >>= 6)
        to[i] = (char)(0x80 | (code & 0x3f));
    to[0] = (char)(first[length - 1] | code);
    return length;
}

/* Writes the character of an escape, and moves behind it. Six bytes of \u give at most three, and
 * twelve give four. */
static size_t unescape_one(const char **from, const char *end, char *to)
{
    static const char names[] = "bfnrt", values[] = "\b\f\n\r\t";
    const char c = *(*from)++;
    if (c != 'u') {
        const char *const name = strchr(names, c);
        *to = name != NULL ? values[name - names] : c;
        return 1;
    }
    uint32_t code = four_digits(*from);
    *from += 4;
    if (code >= 0xd800 && code < 0xdc00 && end - *from >= 6 && (*from)[0] == '\\' &&
        (*from)[1] == 'u') {
        const uint32_t low = four_digits(*from + 2);
        if (low >= 0xdc00 && low < 0xe000) {
            *from += 6;
            return encode(0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00), to);
        }
    }
    return encode(code == 0 || (code >= 0xd800 && code < 0xe000) ? 0xfffd : code, to);
}

size_t json_unescape(const json *j, uint32_t token, char *buffer)
{
    const json_token *const t = j->tokens + token;
    const char *from = j->text + t->start, *const end = j->text + t->end;
    size_t length = 0;
    while (from < end)
        if (*from == '\\') {
            ++from;
            length += unescape_one(&from, end, buffer + length);
        } else {
            buffer[length++] = *from++;
        }
    buffer[length] = '\0';
    return length;
}

/* The bytes of the character at the beginning; 0 if it is no UTF-8. */
static size_t character(const unsigned char *text, size_t length)
{
    const unsigned char c = text[0];
    if (c < 0x80)
        return 1;
    const size_t bytes = c >= 0xf0 ? 4 : c >= 0xe0 ? 3 : 2;
    if (c < 0xc2 || c > 0xf4 || bytes > length)
        return 0;
    for (size_t i = 1; i < bytes; ++i)
        if ((text[i] & 0xc0) != 0x80)
            return 0;
    /* Longer than needed, halves of surrogate pairs, above U+10FFFF. */
    if ((c == 0xe0 && text[1] < 0xa0) || (c == 0xed && text[1] > 0x9f) ||
        (c == 0xf0 && text[1] < 0x90) || (c == 0xf4 && text[1] > 0x8f))
        return 0;
    return bytes;
}

bool json_is_utf8(const char *text, size_t length)
{
    size_t bytes = 1;
    for (size_t i = 0; i < length && bytes > 0; i += bytes)
        bytes = character((const unsigned char *)text + i, length - i);
    return bytes > 0;
}

const char *json_copy(const json *j, uint32_t token, char *buffer, size_t size)
{
    const json_token *const t = j->tokens + token;
    const char *from = j->text + t->start, *const end = j->text + t->end;
    size_t length = 0;
    while (from < end) {
        char one[4];
        const char *source = from;
        size_t bytes = character((const unsigned char *)from, (size_t)(end - from));
        if (*from == '\\' && t->kind == JSON_STRING) {
            ++from;
            bytes = unescape_one(&from, end, one);
            source = one;
        } else {
            from += bytes > 0 ? bytes : 1;
        }
        if (bytes == 0 || (unsigned char)*source < 0x20) {
            source = "?";
            bytes = 1;
        }
        if (length + bytes >= size)
            break;
        memcpy(buffer + length, source, bytes);
        length += bytes;
    }
    buffer[length] = '\0';
    return buffer;
}

const char *json_path(const json *j, uint32_t token, char *buffer, size_t size)
{
    size_t at = size - 1;
    buffer[at] = '\0';
    for (; j->tokens[token].parent != JSON_NONE; token = j->tokens[token].parent) {
        char step[64] = "/";
        if (json_name(j, token) != JSON_NONE)
            json_copy(j, token - 1, step + 1, sizeof step - 1);
        else
            snprintf(step, sizeof step, "/%u", (unsigned)j->tokens[token].index);
        const size_t length = strlen(step);
        if (length > at)
            break;
        at -= length;
        memcpy(buffer + at, step, length);
    }
    return at == size - 1 ? "/" : buffer + at;
}
