/* Memory, messages and files of readers. */
#include "reader.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void model_messages_free(model_messages *m)
{
    for (size_t i = 0; i < m->warning_count; ++i) {
        free(m->warnings[i].file);
        free(m->warnings[i].text);
        free(m->warnings[i].what);
    }
    free(m->warnings);
    memset(m, 0, sizeof *m);
}

static bool fail(model_reader *r, const char *place, const char *format, va_list values)
{
    model_messages *const m = r->messages;
    if (m->fault_file[0] != '\0')
        return false;
    snprintf(m->fault_file, sizeof m->fault_file, "%s", r->name[0] != '\0' ? r->name : "model");
    size_t length = 0;
    if (place != NULL)
        length = (size_t)snprintf(m->fault, sizeof m->fault, "%s: ", place);
    if (length < sizeof m->fault)
        vsnprintf(m->fault + length, sizeof m->fault - length, format, values);
    return false;
}

bool reader_fail(model_reader *r, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    fail(r, NULL, format, values);
    va_end(values);
    return false;
}

bool reader_fail_at(model_reader *r, const char *place, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    fail(r, place, format, values);
    va_end(values);
    return false;
}

static char *copy_text(const char *text)
{
    char *const copy = malloc(strlen(text) + 1);
    return copy != NULL ? strcpy(copy, text) : NULL;
}

/* Different warnings of one file; what is beyond is counted as the last. */
#define MOST_WARNINGS 200

/* Finds the warning with these words, and counts it. */
static bool is_counted(model_messages *m, const char *file, const char *what)
{
    for (size_t i = 0; i < m->warning_count; ++i)
        if (strcmp(m->warnings[i].what, what) == 0 && strcmp(m->warnings[i].file, file) == 0) {
            ++m->warnings[i].count;
            return true;
        }
    return false;
}

static void add_warning(model_messages *m, const char *file, const char *place, const char *what)
{
    char text[640];
    model_warning w = {copy_text(file), NULL, 1, copy_text(what)};
    snprintf(text, sizeof text, "%s%s%s", place != NULL ? place : "", place != NULL ? ": " : "",
             what);
    w.text = copy_text(text);
    model_warning *const longer =
        realloc(m->warnings, (m->warning_count + 1) * sizeof *m->warnings);
    if (longer != NULL)
        m->warnings = longer;
    if (longer != NULL && w.file != NULL && w.text != NULL && w.what != NULL) {
        m->warnings[m->warning_count++] = w;
        return;
    }
    free(w.file);
    free(w.text);
    free(w.what);
}

void reader_warn(model_reader *r, const char *place, const char *format, ...)
{
    char what[512];
    va_list values;
    va_start(values, format);
    vsnprintf(what, sizeof what, format, values);
    va_end(values);
    model_messages *const m = r->messages;
    if (m->warning_count >= MOST_WARNINGS) {
        place = NULL;
        snprintf(what, sizeof what, "further warnings are left out");
    }
    if (!is_counted(m, r->name, what))
        add_warning(m, r->name, place, what);
}

const char *reader_line(model_reader *r, uint64_t line)
{
    snprintf(r->line, sizeof r->line, "line %llu", (unsigned long long)line);
    return r->line;
}

static bool fail_for_memory(model_reader *r)
{
    return reader_fail(r, "not enough memory");
}

/* Takes bytes from the budget. */
static bool take(model_reader *r, size_t count, size_t size)
{
    if (size != 0 && count > SIZE_MAX / size)
        return fail_for_memory(r);
    if ((uint64_t)count * size > r->memory_left)
        return fail_for_memory(r);
    r->memory_left -= (uint64_t)count * size;
    return true;
}

void *reader_allocate(model_reader *r, size_t count, size_t size)
{
    if (!take(r, count, size))
        return NULL;
    void *const memory = calloc(count > 0 ? count : 1, size);
    if (memory == NULL)
        fail_for_memory(r);
    return memory;
}

bool reader_grow(model_reader *r, void *array, size_t *capacity, size_t needed, size_t size)
{
    if (needed <= *capacity)
        return true;
    size_t count = *capacity < 32 ? 64 : *capacity + *capacity / 2;
    if (count < needed)
        count = needed;
    if (!take(r, count - *capacity, size))
        return false;
    void *memory;
    memcpy(&memory, array, sizeof memory);
    memory = count <= SIZE_MAX / size ? realloc(memory, count * size) : NULL;
    if (memory == NULL)
        return fail_for_memory(r);
    memcpy(array, &memory, sizeof memory);
    *capacity = count;
    return true;
}

void reader_release(model_reader *r, void *memory, size_t count, size_t size)
{
    if (memory != NULL)
        r->memory_left += (uint64_t)count * size;
    free(memory);
}

bool reader_open(model_reader *r, const char *name, model_file *file, const char **reason)
{
    *file = (model_file){NULL, 0, NULL};
    *reason = "no files are opened here";
    return r->files != NULL && r->files->open != NULL &&
           r->files->open(r->files->user, name, file, reason);
}

void reader_close(model_reader *r, model_file *file)
{
    if (r->files != NULL && r->files->close != NULL)
        r->files->close(r->files->user, file);
    *file = (model_file){NULL, 0, NULL};
}

size_t reader_add_part(model_reader *r)
{
    model *const m = r->result;
    if (!take(r, 1, sizeof *m->parts))
        return SIZE_MAX;
    /* The array grows by doubling: its room is the next power of two. */
    if ((m->part_count & (m->part_count - 1)) == 0) {
        const size_t room = m->part_count == 0 ? 1 : 2 * m->part_count;
        model_part *const longer = realloc(m->parts, room * sizeof *longer);
        if (longer == NULL) {
            fail_for_memory(r);
            return SIZE_MAX;
        }
        m->parts = longer;
    }
    model_part *const part = m->parts + m->part_count;
    memset(part, 0, sizeof *part);
    part->surface = model_surface_default();
    for (int i = 0; i < MAP_COUNT; ++i)
        part->maps[i] = model_map_of(MODEL_NO_IMAGE);
    return m->part_count++;
}

bool reader_allocate_part(model_reader *r, model_part *part, uint32_t vertex_count,
                          uint32_t index_count)
{
    const uint64_t size = model_part_size(part, vertex_count, index_count);
    if (size > SIZE_MAX || !take(r, (size_t)size, 1))
        return fail_for_memory(r);
    return model_part_allocate(part, vertex_count, index_count) || fail_for_memory(r);
}

/* Adds an image. Takes the bytes. */
static uint32_t add_image(model_reader *r, const char *name, uint8_t *bytes, size_t size)
{
    model *const m = r->result;
    char *const copy = copy_text(name);
    model_image *const longer =
        realloc(m->images, ((size_t)m->image_count + 1) * sizeof *m->images);
    if (longer != NULL)
        m->images = longer;
    if (longer == NULL || copy == NULL || !take(r, 1, sizeof *longer)) {
        free(copy);
        free(bytes);
        fail_for_memory(r);
        return MODEL_NO_IMAGE;
    }
    longer[m->image_count] = (model_image){copy, bytes, size, false};
    return m->image_count++;
}

uint32_t reader_image(model_reader *r, const char *name)
{
    const model *const m = r->result;
    for (uint32_t i = 0; i < m->image_count; ++i)
        if (m->images[i].bytes == NULL && strcmp(m->images[i].name, name) == 0)
            return i;
    return add_image(r, name, NULL, 0);
}

uint32_t reader_image_inside(model_reader *r, const char *name, const uint8_t *bytes, size_t size)
{
    uint8_t *const copy = reader_allocate(r, size, 1);
    if (copy == NULL)
        return MODEL_NO_IMAGE;
    memcpy(copy, bytes, size);
    return add_image(r, name, copy, size);
}
