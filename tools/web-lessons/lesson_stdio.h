/* What the lessons call of <stdio.h>, and exit, without an operating system: files are memory, and
 * what a lesson prints is kept for the page. Every lesson is compiled with this header included
 * first, so that its text stays as it is. The module imports nothing, not even WASI. Numbers are
 * formatted and read by the C library's vsnprintf and sscanf, which touch no file. */
#ifndef LESSON_STDIO_H
#define LESSON_STDIO_H

#include <stdio.h>
#include <stdlib.h>

typedef struct lesson_file lesson_file;

extern lesson_file lesson_stdin, lesson_stdout, lesson_stderr;

lesson_file *lesson_fopen(const char *path, const char *mode);
int lesson_fclose(lesson_file *file);
size_t lesson_fread(void *to, size_t size, size_t count, lesson_file *file);
size_t lesson_fwrite(const void *from, size_t size, size_t count, lesson_file *file);
int lesson_fgetc(lesson_file *file);
int lesson_fputc(int c, lesson_file *file);
char *lesson_fgets(char *line, int size, lesson_file *file);
int lesson_fputs(const char *text, lesson_file *file);
int lesson_fseek(lesson_file *file, long offset, int whence);
int lesson_feof(lesson_file *file);
int lesson_ferror(lesson_file *file);
int lesson_printf(const char *format, ...) __attribute__((format(printf, 1, 2)));
int lesson_fprintf(lesson_file *file, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
_Noreturn void lesson_exit(int status);

#ifdef LESSON_ON_PAGE
#undef stdin
#undef stdout
#undef stderr
#undef putc
#define FILE lesson_file
#define stdin (&lesson_stdin)
#define stdout (&lesson_stdout)
#define stderr (&lesson_stderr)
#define fopen lesson_fopen
#define fclose lesson_fclose
#define fread lesson_fread
#define fwrite lesson_fwrite
#define fgetc lesson_fgetc
#define putc lesson_fputc
#define fgets lesson_fgets
#define fputs lesson_fputs
#define fseek lesson_fseek
#define feof lesson_feof
#define ferror lesson_ferror
#define printf lesson_printf
#define fprintf lesson_fprintf
#define exit lesson_exit
#endif

#endif
