/* Files in memory for lessons on a web page, and the lessons' exit. */
#include "lesson_stdio.h"

#include <stdarg.h>
#include <string.h>
#include <sys/types.h>

#include "lesson_page.h"

enum { MOST_FILES = 8, MOST_NAME = 128, MOST_PRINTED = 4096 };

struct lesson_file {
    char name[MOST_NAME];
    uint8_t *byte;
    size_t size, room, at;
    bool at_end, failed;
};

lesson_file lesson_stdin, lesson_stdout, lesson_stderr;

static lesson_file files[MOST_FILES], written;
static int status_of_exit = LESSON_DID_NOT_EXIT;

/* The page's side */

uint8_t *lesson_add_file(const char *name, uint32_t size)
{
    lesson_file *file = strcmp(name, "stdin") == 0 ? &lesson_stdin : files;

    while (file >= files && file < files + MOST_FILES && file->byte)
        ++file;
    if (file == files + MOST_FILES || strlen(name) >= MOST_NAME)
        return NULL;
    file->byte = malloc(size ? size : 1);
    file->size = file->byte ? size : 0;
    strcpy(file->name, name);
    return file->byte;
}

const uint8_t *lesson_picture(void)
{
    return written.byte;
}

uint32_t lesson_picture_size(void)
{
    return (uint32_t)written.size;
}

const uint8_t *lesson_printed(int errors)
{
    return errors ? lesson_stderr.byte : lesson_stdout.byte;
}

uint32_t lesson_printed_size(int errors)
{
    return (uint32_t)(errors ? lesson_stderr.size : lesson_stdout.size);
}

int lesson_exit_status(void)
{
    return status_of_exit;
}

/* The lesson's side */

/* A trap ends the lesson. The page reads the status to know this trap from any other. */
_Noreturn void lesson_exit(int status)
{
    status_of_exit = status;
    __builtin_trap();
}

/* A lesson writes one picture. If it writes a second file, that takes the place of the first. */
lesson_file *lesson_fopen(const char *path, const char *mode)
{
    if (mode[0] == 'w') {
        written.size = 0;
        return &written;
    }
    for (lesson_file *file = files; file < files + MOST_FILES; ++file) {
        if (file->byte && strcmp(file->name, path) == 0) {
            file->at = 0;
            file->at_end = false;
            return file;
        }
    }
    return NULL;
}

/* Bytes stay: the page reads the picture when the lesson has ended, and a lesson may read a file
 * twice. */
int lesson_fclose(lesson_file *file)
{
    (void)file;
    return 0;
}

size_t lesson_fread(void *to, size_t size, size_t count, lesson_file *file)
{
    const size_t left = file->size - file->at, wanted = size * count;
    const size_t bytes = wanted < left ? wanted : left;

    if (bytes)
        memcpy(to, file->byte + file->at, bytes);
    file->at += bytes;
    file->at_end = bytes < wanted;
    return size ? bytes / size : 0;
}

size_t lesson_fwrite(const void *from, size_t size, size_t count, lesson_file *file)
{
    const size_t bytes = size * count;

    if (bytes > file->room - file->size) {
        const size_t room = 2 * file->room + bytes;
        uint8_t *larger = realloc(file->byte, room);

        if (!larger) {
            file->failed = true;
            return 0;
        }
        file->byte = larger;
        file->room = room;
    }
    memcpy(file->byte + file->size, from, bytes);
    file->size += bytes;
    return count;
}

int lesson_fgetc(lesson_file *file)
{
    unsigned char c;

    return lesson_fread(&c, 1, 1, file) ? c : EOF;
}

int lesson_fputc(int c, lesson_file *file)
{
    const unsigned char byte = (unsigned char)c;

    return lesson_fwrite(&byte, 1, 1, file) ? byte : EOF;
}

char *lesson_fgets(char *line, int size, lesson_file *file)
{
    const size_t left = file->size - file->at, most = (size_t)size - 1;
    const uint8_t *from = left ? file->byte + file->at : NULL;
    const uint8_t *newline = left ? memchr(from, '\n', left) : NULL;
    const size_t length = newline ? (size_t)(newline - from) + 1 : left;
    const size_t bytes = length < most ? length : most;

    file->at_end = !newline && left < most;
    if (bytes == 0)
        return NULL;
    memcpy(line, from, bytes);
    line[bytes] = '\0';
    file->at += bytes;
    return line;
}

int lesson_fputs(const char *text, lesson_file *file)
{
    return lesson_fwrite(text, 1, strlen(text), file) == strlen(text) ? 0 : EOF;
}

/* From the current place only: the lessons need no other. */
int lesson_fseek(lesson_file *file, long offset, int whence)
{
    if (whence != SEEK_CUR || offset < 0 || (size_t)offset > file->size - file->at)
        return -1;
    file->at += (size_t)offset;
    return 0;
}

int lesson_feof(lesson_file *file)
{
    return file->at_end;
}

/* A file fails only for want of memory. */
int lesson_ferror(lesson_file *file)
{
    return file->failed;
}

static int print(lesson_file *file, const char *format, va_list arguments)
{
    char text[MOST_PRINTED];
    const int length = vsnprintf(text, sizeof text, format, arguments);

    if (length < 0 || length >= MOST_PRINTED)
        return -1;
    return lesson_fwrite(text, 1, (size_t)length, file) == (size_t)length ? length : -1;
}

int lesson_printf(const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    const int length = print(&lesson_stdout, format, arguments);
    va_end(arguments);
    return length;
}

int lesson_fprintf(lesson_file *file, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    const int length = print(file, format, arguments);
    va_end(arguments);
    return length;
}

/* How musl, wasi-libc's base, would write to its own stderr that it cannot print a long double. No
 * lesson does that, but the linker cannot know, and these functions would import WASI's. */

size_t __stdio_write(FILE *file, const unsigned char *from, size_t size);
off_t __stdio_seek(FILE *file, off_t offset, int whence);
int __stdio_close(FILE *file);

size_t __stdio_write(FILE *file, const unsigned char *from, size_t size)
{
    (void)file, (void)from, (void)size;
    return 0;
}

off_t __stdio_seek(FILE *file, off_t offset, int whence)
{
    (void)file, (void)offset, (void)whence;
    return -1;
}

int __stdio_close(FILE *file)
{
    (void)file;
    return -1;
}
