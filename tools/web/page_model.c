/* The dropped model: read from the dropped files, completed with its maps, and checked. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bounds.h"
#include "page_files.h"
#include "page_json.h"
#include "page_maps.h"
#include "page_parts.h"
#include "read.h"

#define MAX_PARTS 4096
#define MAX_VERTICES (1u << 25)
#define MAX_INDICES (3u << 25)

/* Half of a module's largest memory, since the model is copied into a scene. */
#define MEMORY_BUDGET (UINT64_C(1) << 31)

static page_contents dropped;
static model_messages messages;
static char *name; /* of the model's file */
static enum { MODEL_ABSENT = 0, MODEL_READ, MODEL_COMPLETE } progress;
static uint32_t version;

static int fail_for_memory(void)
{
    return page_fail("there is not enough memory for the model", (const char *)NULL);
}

/* Gives the model up. */
static int abandon(int status)
{
    page_maps_forget();
    page_files_forget();
    page_contents_free(&dropped);
    model_messages_free(&messages);
    free(name);
    name = NULL;
    progress = MODEL_ABSENT;
    return status;
}

void page_model_begin(void)
{
    page_begin();
    abandon(0);
    ++version;
}

uint8_t *page_model_file(const char *file_name, uint32_t size)
{
    page_begin();
    uint8_t *const bytes = page_files_add(file_name, size);
    if (bytes == NULL)
        fail_for_memory();
    return bytes;
}

static bool open_dropped(void *user, const char *wanted, model_file *file, const char **reason)
{
    (void)user;
    const uint32_t number = page_files_find(wanted);
    *reason = "it was not dropped with the model";
    if (number == PAGE_NO_FILE)
        return false;
    file->bytes = page_files_at(number)->bytes;
    file->size = page_files_at(number)->size;
    return true;
}

static void close_dropped(void *user, model_file *file)
{
    (void)user, (void)file;
}

/* The number of the one file that is a model; PAGE_NO_FILE, with the message set, if there is none
 * or more than one. */
static uint32_t find_model(void)
{
    uint32_t found = PAGE_NO_FILE;
    for (uint32_t i = 0; i < page_files_count(); ++i) {
        if (model_format_of(page_files_at(i)->name) == MODEL_OTHER)
            continue;
        if (found != PAGE_NO_FILE) {
            page_fail(page_files_at(found)->name, ", ", page_files_at(i)->name,
                      ": drop one model at a time", (const char *)NULL);
            return PAGE_NO_FILE;
        }
        found = i;
    }
    if (found == PAGE_NO_FILE)
        page_fail(page_files_count() > 0 ? page_files_at(0)->name : "nothing",
                  ": there is no model among these files: .obj, .ply, .stl, .gltf or .glb",
                  (const char *)NULL);
    return found;
}

/* What readers and maps warn with. */
static model_reader reader_of_messages(void)
{
    model_reader r;
    memset(&r, 0, sizeof r);
    r.name = name;
    r.messages = &messages;
    return r;
}

static int fail_for_limit(const char *what, uint64_t most, uint64_t number)
{
    char words[128];
    snprintf(words, sizeof words, "%s at most %llu on this page, not %llu", what,
             (unsigned long long)most, (unsigned long long)number);
    return page_fail(name, ": ", words, (const char *)NULL);
}

static int check_limits(void)
{
    const model *const m = &dropped.model;
    if (m->part_count > MAX_PARTS)
        return fail_for_limit("parts are", MAX_PARTS, m->part_count);
    for (size_t p = 0; p < m->part_count; ++p) {
        if (m->parts[p].vertex_count > MAX_VERTICES)
            return fail_for_limit("the vertices of a part are", MAX_VERTICES,
                                  m->parts[p].vertex_count);
        if (m->parts[p].index_count > MAX_INDICES)
            return fail_for_limit("the corners of a part are", MAX_INDICES,
                                  m->parts[p].index_count);
    }
    return 0;
}

static int read_file(uint32_t number)
{
    const page_file *const file = page_files_at(number);
    const model_files files = {NULL, open_dropped, close_dropped};
    name = malloc(strlen(file->name) + 1);
    if (name == NULL)
        return fail_for_memory();
    strcpy(name, file->name);
    if (!model_read_bytes(name, model_format_of(name), file->bytes, file->size, &files,
                          MEMORY_BUDGET, MODEL_CREASE_DEGREES, &dropped.model, &messages))
        return page_fail(messages.fault_file, ": ", messages.fault, (const char *)NULL);
    page_files_forget_bytes();
    if (check_limits() != 0)
        return 1;
    model_reader warnings = reader_of_messages();
    if (dropped.model.light_count > 0)
        reader_warn(&warnings, NULL, "its lights are not used: the page has one of its own");
    dropped.maps = calloc(dropped.model.part_count, sizeof *dropped.maps);
    if (dropped.maps == NULL || !page_maps_find(&dropped.model, &warnings))
        return fail_for_memory();
    /* The state's eye and target are floats. They are relative to the model's place. */
    memset(dropped.model.origin, 0, sizeof dropped.model.origin);
    dropped.bounds = model_bounds(&dropped.model);
    return 0;
}

int page_model_read(void)
{
    page_begin();
    if (progress != MODEL_ABSENT)
        return page_fail("the model has been read", (const char *)NULL);
    const uint32_t number = find_model();
    if (number == PAGE_NO_FILE || read_file(number) != 0)
        return abandon(1);
    progress = MODEL_READ;
    return 0;
}

uint32_t *page_model_image(uint32_t number, uint32_t width, uint32_t height)
{
    page_begin();
    return page_maps_image(number, width, height);
}

int page_model_end(void)
{
    page_begin();
    if (progress != MODEL_READ)
        return page_fail("no model has been read", (const char *)NULL);
    model_reader warnings = reader_of_messages();
    if (!page_maps_complete(&dropped.model, dropped.maps, &warnings)) {
        fail_for_memory();
        return abandon(1);
    }
    progress = MODEL_COMPLETE;
    return 0;
}

static void describe_warnings(text *to)
{
    page_json_name(to, "warnings");
    text_add(to, "[");
    for (size_t i = 0; i < messages.warning_count; ++i) {
        const model_warning *const w = messages.warnings + i;
        text line = {0};
        text_add(&line, w->file);
        text_add(&line, ": ");
        text_add(&line, w->text);
        if (w->count > 1) {
            text_add(&line, " (");
            text_add_whole(&line, w->count);
            text_add(&line, " times)");
        }
        text_add(to, i == 0 ? "" : ", ");
        page_json_quoted(to, text_of(&line));
        free(line.chars);
    }
    text_add(to, "]");
}

const char *page_model_describe(void)
{
    static text json;
    const model *const m = &dropped.model;
    uint64_t vertices = 0;
    text_clear(&json);
    page_begin();
    if (progress == MODEL_ABSENT) {
        page_fail("no model has been read", (const char *)NULL);
        return "";
    }
    for (size_t p = 0; p < m->part_count; ++p)
        vertices += m->parts[p].vertex_count;
    text_add(&json, "{");
    page_json_string(&json, "name", name);
    page_json_whole(&json, "parts", m->part_count);
    page_json_whole(&json, "vertices", vertices);
    page_json_whole(&json, "triangles", model_primitive_count(m, MODEL_TRIANGLES));
    page_json_whole(&json, "lines", model_primitive_count(m, MODEL_LINES));
    page_json_whole(&json, "points", model_primitive_count(m, MODEL_POINTS));
    describe_warnings(&json);
    page_maps_describe(&json);
    page_json_end(&json);
    if (json.failed)
        fail_for_memory();
    return json.failed ? "" : text_of(&json);
}

const page_contents *page_dropped(void)
{
    if (progress == MODEL_COMPLETE)
        return &dropped;
    page_fail("no model has been dropped on this page", (const char *)NULL);
    return NULL;
}

uint32_t page_dropped_version(void)
{
    return version;
}
