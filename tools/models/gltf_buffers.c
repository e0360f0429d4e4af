/* URIs, buffers and views of a glTF (section 3.6.1). A buffer is read at its first use: one that
 * only animations need may be missing. */
#include <string.h>

#include "gltf.h"
#include "text.h"

/* Decodes %20 and the like in place (RFC 3986, section 2.1). A percent sign without two digits
 * stays. Returns the length. */
static size_t decode_percent(char *text, size_t length)
{
    size_t to = 0;
    for (size_t i = 0; i < length; ++i) {
        int high = -1, low = -1;
        if (text[i] == '%' && length - i > 2) {
            high = text_hexadecimal(text[i + 1]);
            low = text_hexadecimal(text[i + 2]);
        }
        if (high >= 0 && low >= 0) {
            text[to++] = (char)(16 * high + low);
            i += 2;
        } else {
            text[to++] = text[i];
        }
    }
    return to;
}

/* The value of a digit of base64 (RFC 4648, section 4), or -1. */
static int digit_of_base64(char c)
{
    if (c >= 'A' && c <= 'Z')
        return c - 'A';
    if (c >= 'a' && c <= 'z')
        return c - 'a' + 26;
    if (c >= '0' && c <= '9')
        return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/* Decodes base64 with or without padding to a buffer of length / 4 * 3 + 3 bytes. Returns false at
 * a character that is none of it. */
static bool decode_base64(const char *text, size_t length, uint8_t *to, size_t *size)
{
    int8_t digits[256];
    for (int c = 0; c < 256; ++c)
        digits[c] = (int8_t)digit_of_base64((char)c);
    while (length > 0 && text[length - 1] == '=')
        --length;
    *size = length / 4 * 3 + (length % 4 == 3 ? 2 : length % 4 == 2 ? 1 : 0);
    for (size_t i = 0; i < length; i += 4) {
        int32_t bits = 0;
        for (size_t k = 0; k < 4; ++k) {
            const int32_t digit = i + k < length ? digits[(unsigned char)text[i + k]] : 0;
            if (digit < 0)
                return false;
            bits = bits * 64 + digit;
        }
        *to++ = (uint8_t)(bits >> 16);
        *to++ = (uint8_t)(bits >> 8 & 0xff);
        *to++ = (uint8_t)(bits & 0xff);
    }
    return length % 4 != 1;
}

bool gltf_is_data_uri(const gltf *g, uint32_t token)
{
    const json_token *const t = g->j.tokens + token;
    return t->kind == JSON_STRING && t->end - t->start >= 5 &&
           memcmp(g->j.text + t->start, "data:", 5) == 0;
}

/* The decoded string of a token, in memory of *capacity bytes; null with the fault recorded. */
static char *string_of(gltf *g, uint32_t token, size_t *length, size_t *capacity)
{
    const json_token *const t = g->j.tokens + token;
    *capacity = (size_t)t->end - t->start + 1;
    if (t->kind != JSON_STRING) {
        reader_fail_at(g->r, gltf_path(g, token), "is no string");
        return NULL;
    }
    char *const text = reader_allocate(g->r, *capacity, 1);
    if (text != NULL)
        *length = json_unescape(&g->j, token, text);
    return text;
}

/* What stands behind the comma of a data: URI (RFC 2397). */
typedef struct data_part {
    const char *text;
    size_t length;
    bool is_base64;
} data_part;

static bool find_data(const char *text, size_t length, data_part *data)
{
    static const char base64[] = ";base64";
    const size_t ending = sizeof base64 - 1;
    const char *const comma = memchr(text, ',', length);
    if (comma == NULL)
        return false;
    const size_t before = (size_t)(comma - text);
    data->text = comma + 1;
    data->length = length - before - 1;
    data->is_base64 = before >= ending && memcmp(comma - ending, base64, ending) == 0;
    return true;
}

/* Decodes data to memory of *size bytes; null if they cannot be decoded. */
static uint8_t *decode_data(gltf *g, uint32_t token, const data_part *data, size_t *size)
{
    const size_t room = (data->is_base64 ? data->length / 4 * 3 : data->length) + 3;
    uint8_t *const bytes = reader_allocate(g->r, room, 1);
    if (bytes == NULL)
        return NULL;
    if (data->is_base64 && !decode_base64(data->text, data->length, bytes, size)) {
        reader_fail_at(g->r, gltf_path(g, token), "is a data: URI whose base64 is wrong");
        reader_release(g->r, bytes, room, 1);
        return NULL;
    }
    if (!data->is_base64) {
        memcpy(bytes, data->text, data->length);
        *size = decode_percent((char *)bytes, data->length);
    }
    /* The caller releases *size bytes. */
    g->r->memory_left += room - *size;
    return bytes;
}

uint8_t *gltf_data_uri(gltf *g, uint32_t token, size_t *size)
{
    const json_token *const t = g->j.tokens + token;
    const char *text = g->j.text + t->start;
    size_t length = (size_t)t->end - t->start, capacity = 0;
    char *copy = NULL;
    data_part data;
    uint8_t *bytes = NULL;
    /* Few writers escape the slash. */
    if (memchr(text, '\\', length) != NULL) {
        copy = string_of(g, token, &length, &capacity);
        if (copy == NULL)
            return NULL;
        text = copy;
    }
    if (find_data(text, length, &data))
        bytes = decode_data(g, token, &data, size);
    else
        reader_fail_at(g->r, gltf_path(g, token), "is a data: URI without a comma");
    reader_release(g->r, copy, capacity, 1);
    return bytes;
}

char *gltf_file_name(gltf *g, uint32_t token, size_t *capacity)
{
    size_t length = 0;
    char *const name = string_of(g, token, &length, capacity);
    if (name == NULL)
        return NULL;
    length = decode_percent(name, length);
    name[length] = '\0';
    if (length > 0 && strlen(name) == length && json_is_utf8(name, length))
        return name;
    reader_fail_at(g->r, gltf_path(g, token), "names no file");
    reader_release(g->r, name, *capacity, 1);
    return NULL;
}

/* Opens the file of a buffer. */
static bool open_buffer(gltf *g, uint32_t uri, gltf_bytes *b)
{
    size_t capacity;
    const char *reason;
    char *const name = gltf_file_name(g, uri, &capacity);
    if (name == NULL)
        return false;
    b->is_file = reader_open(g->r, name, &b->file, &reason);
    if (!b->is_file)
        reader_fail_at(g->r, gltf_path(g, uri), "the file '%s' cannot be read: %s", name, reason);
    b->bytes = b->file.bytes;
    b->size = b->file.size;
    reader_release(g->r, name, capacity, 1);
    return b->is_file;
}

/* Finds the bytes of a buffer: in the binary chunk, in its data: URI or in its file. */
static bool find_bytes(gltf *g, uint32_t index, uint32_t token, gltf_bytes *b)
{
    const uint32_t uri = json_member(&g->j, token, "uri");
    if (uri == JSON_NONE) {
        if (index != 0 || g->binary == NULL)
            return reader_fail_at(g->r, gltf_path(g, token), "has no uri");
        b->bytes = g->binary;
        b->size = g->binary_size;
        return true;
    }
    if (!gltf_is_data_uri(g, uri))
        return open_buffer(g, uri, b);
    b->bytes = b->decoded = gltf_data_uri(g, uri, &b->decoded_size);
    b->size = b->decoded_size;
    return b->decoded != NULL;
}

static bool read_buffer(gltf *g, uint32_t index, const gltf_bytes **bytes)
{
    gltf_bytes *const b = g->buffers + index;
    const uint32_t token = gltf_element(g, GLTF_BUFFERS, index);
    uint64_t length = 0;
    *bytes = b;
    if (b->is_read)
        return true;
    if (!gltf_integer(g, token, "byteLength", UINT64_C(1) << 53, &length) ||
        !find_bytes(g, index, token, b))
        return false;
    if (b->size < length)
        return reader_fail_at(g->r, gltf_path(g, token),
                              "has %llu bytes, but its byteLength is %llu",
                              (unsigned long long)b->size, (unsigned long long)length);
    b->size = (size_t)length;
    b->is_read = true;
    return true;
}

bool gltf_view(gltf *g, uint32_t view, const uint8_t **bytes, size_t *size, size_t *stride)
{
    const uint32_t token = gltf_element(g, GLTF_BUFFER_VIEWS, view);
    const uint64_t most = UINT64_C(1) << 53;
    uint32_t buffer = GLTF_NONE;
    uint64_t offset = 0, length = 0, step = 0;
    const gltf_bytes *b;
    if (!gltf_index(g, token, "buffer", GLTF_BUFFERS, &buffer) ||
        !gltf_integer(g, token, "byteOffset", most, &offset) ||
        !gltf_integer(g, token, "byteLength", most, &length) ||
        !gltf_integer(g, token, "byteStride", 252, &step))
        return false;
    if (buffer == GLTF_NONE)
        return reader_fail_at(g->r, gltf_path(g, token), "has no buffer");
    if (!read_buffer(g, buffer, &b))
        return false;
    if (offset + length > b->size)
        return reader_fail_at(g->r, gltf_path(g, token),
                              "ends at byte %llu, but its buffer has only %llu",
                              (unsigned long long)(offset + length), (unsigned long long)b->size);
    *bytes = length > 0 ? b->bytes + offset : b->bytes;
    *size = (size_t)length;
    *stride = (size_t)step;
    return true;
}

void gltf_free_buffers(gltf *g)
{
    for (uint32_t i = 0; g->buffers != NULL && i < g->tables[GLTF_BUFFERS].count; ++i) {
        gltf_bytes *const b = g->buffers + i;
        reader_release(g->r, b->decoded, b->decoded_size, 1);
        if (b->is_file)
            reader_close(g->r, &b->file);
    }
    reader_release(g->r, g->buffers, g->tables[GLTF_BUFFERS].count, sizeof *g->buffers);
}
