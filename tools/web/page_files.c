/* The files that were dropped on the page, found by their names. */
#include "page_files.h"

#include <stdlib.h>
#include <string.h>

static page_file *files;
static uint32_t count;

static void forget_bytes(page_file *file)
{
    free(file->bytes);
    file->bytes = NULL;
}

void page_files_forget_bytes(void)
{
    for (uint32_t i = 0; i < count; ++i)
        forget_bytes(files + i);
}

void page_files_forget(void)
{
    page_files_forget_bytes();
    for (uint32_t i = 0; i < count; ++i)
        free(files[i].name);
    free(files);
    files = NULL;
    count = 0;
}

uint8_t *page_files_add(const char *name, uint32_t size)
{
    page_file *const longer = realloc(files, ((size_t)count + 1) * sizeof *files);
    if (longer == NULL)
        return NULL;
    files = longer;
    page_file *const file = files + count;
    *file = (page_file){malloc(strlen(name) + 1), malloc((size_t)size + 1), size};
    if (file->name == NULL || file->bytes == NULL) {
        free(file->name);
        free(file->bytes);
        return NULL;
    }
    strcpy(file->name, name);
    ++count;
    return file->bytes;
}

uint32_t page_files_count(void)
{
    return count;
}

const page_file *page_files_at(uint32_t number)
{
    return files + number;
}

/* The name without its folders. Backslashes are those of some exporters. */
static const char *plain_name(const char *path)
{
    const char *name = path;
    for (const char *c = path; *c != '\0'; ++c)
        if (*c == '/' || *c == '\\')
            name = c + 1;
    return name;
}

static int lower(char c)
{
    return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c;
}

uint32_t page_files_find(const char *name)
{
    const char *const wanted = plain_name(name);
    for (uint32_t i = 0; i < count; ++i) {
        const char *a = wanted, *b = plain_name(files[i].name);
        for (; *a != '\0' && lower(*a) == lower(*b); ++a)
            ++b;
        if (*a == '\0' && *b == '\0')
            return i;
    }
    return PAGE_NO_FILE;
}
