/* The directory, the runs and the pictures of the command's tests. */
#define _XOPEN_SOURCE 700
#include "runner.h"

#include <dirent.h>
#include <limits.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static char directory[64] = "/tmp/gnomon-test-XXXXXX";
static char last_line[4096]; /* what was run last */
static struct dirent **marked;
static int marked_count;

const char square_obj[] = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
                          "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                          "vn 0 0 1\n"
                          "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\n";

static void die(const char *what)
{
    perror(what);
    exit(1);
}

void suite_begin(int argc, char **argv)
{
    const char *command = argc > 1 ? argv[1] : getenv("GNOMON");
    char absolute[PATH_MAX];
    if (command == NULL || realpath(command, absolute) == NULL) {
        fprintf(stderr, "usage: %s PATH_OF_GNOMON (or set GNOMON)\n", argv[0]);
        exit(2);
    }
    char path[PATH_MAX + 4096];
    snprintf(path, sizeof path, "%.*s:%s", (int)(strrchr(absolute, '/') - absolute), absolute,
             getenv("PATH"));
    if (setenv("GNOMON", absolute, 1) != 0 || setenv("PATH", path, 1) != 0 ||
        mkdtemp(directory) == NULL)
        die(directory);
    write_text("square.obj", square_obj);
}

void suite_end(void)
{
    char line[128];
    snprintf(line, sizeof line, "rm -rf '%s'", directory);
    if (system(line) != 0)
        fprintf(stderr, "%s is left behind\n", directory);
}

const char *path_of(const char *name)
{
    static char path[512];
    snprintf(path, sizeof path, "%s/%s", directory, name);
    return path;
}

static void read_back(const char *name, char *text, size_t size)
{
    text[read_file(name, text, size - 1)] = '\0';
    unlink(path_of(name));
}

/* Runs a line of shell in the directory. */
static run run_line(const char *line)
{
    run result;
    char full[5120];
    snprintf(full, sizeof full, "cd '%s' && exec >.out 2>.error </dev/null; %s", directory, line);
    int status = system(full);
    result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    read_back(".out", result.out, sizeof result.out);
    read_back(".error", result.error, sizeof result.error);
    return result;
}

/* Runs `before` and the formatted line; fails if it must be good and is not. */
static run run_format(bool must_be_good, const char *before, const char *format, va_list arguments)
{
    const int length = snprintf(last_line, sizeof last_line, "%s", before);
    vsnprintf(last_line + length, sizeof last_line - (size_t)length, format, arguments);
    run r = run_line(last_line);
    if (must_be_good && r.status != 0)
        fail_run(&r);
    return r;
}

void fail_run(const run *r)
{
    fail_msg("%s\n  status %d\n%s%s", last_line, r->status, r->out, r->error);
}

#define COMMAND "timeout 60 gnomon "

/* A function that takes a format and runs it. */
#define RUN_FORMAT(name, must_be_good, before)                                                     \
    run name(const char *format, ...)                                                              \
    {                                                                                              \
        va_list arguments;                                                                         \
        va_start(arguments, format);                                                               \
        run r = run_format(must_be_good, before, format, arguments);                               \
        va_end(arguments);                                                                         \
        return r;                                                                                  \
    }

RUN_FORMAT(shell, false, "")
RUN_FORMAT(good_shell, true, "")
RUN_FORMAT(gnomon, false, COMMAND)
RUN_FORMAT(good, true, COMMAND)

void write_bytes(const char *name, const void *bytes, size_t size)
{
    FILE *file = fopen(path_of(name), "wb");
    if (file == NULL || fwrite(bytes, 1, size, file) != size || fclose(file) != 0)
        die(path_of(name));
}

void write_text(const char *name, const char *text)
{
    write_bytes(name, text, strlen(text));
}

size_t read_file(const char *name, void *bytes, size_t size)
{
    FILE *file = fopen(path_of(name), "rb");
    if (file == NULL)
        die(path_of(name));
    const size_t length = fread(bytes, 1, size, file);
    fclose(file);
    return length;
}

void write_square(const char *name, const char *before)
{
    char text[1024];
    snprintf(text, sizeof text, "%s%s", before, square_obj);
    write_text(name, text);
}

void write_grid(const char *name, int size)
{
    FILE *file = fopen(path_of(name), "w");
    if (file == NULL)
        die(path_of(name));
    for (int i = 0; i < size * size; ++i)
        fprintf(file, "v %d %d 0\n", i % size, i / size);
    for (int i = size + 1; i < size * size; ++i)
        if (i % size != 0)
            fprintf(file, "f %d %d %d %d\n", i - size, i - size + 1, i + 1, i);
    fclose(file);
}

void write_color(const char *name, int red, int green, int blue)
{
    const uint8_t bytes[] = {'P',
                             '6',
                             ' ',
                             '1',
                             ' ',
                             '1',
                             ' ',
                             '2',
                             '5',
                             '5',
                             '\n',
                             (uint8_t)red,
                             (uint8_t)green,
                             (uint8_t)blue};
    write_bytes(name, bytes, sizeof bytes);
}

bool exists(const char *name)
{
    return access(path_of(name), F_OK) == 0;
}

void remove_file(const char *name)
{
    unlink(path_of(name));
}

void runner_mark(void)
{
    while (marked_count > 0)
        free(marked[--marked_count]);
    free(marked);
    marked_count = scandir(directory, &marked, NULL, NULL);
}

int new_files(void)
{
    int count = 0;
    DIR *d = opendir(directory);
    for (struct dirent *entry; (entry = readdir(d)) != NULL;) {
        int i = 0;
        while (i < marked_count && strcmp(entry->d_name, marked[i]->d_name) != 0)
            ++i;
        if (i == marked_count) {
            fprintf(stderr, "new file: %s\n", entry->d_name);
            ++count;
        }
    }
    closedir(d);
    return count;
}

bool has_program(const char *name, const char *what)
{
    char line[64];
    snprintf(line, sizeof line, "command -v %s", name);
    if (shell(line).status == 0)
        return true;
    print_message("skipped: %s: %s is absent: 'make setup' installs it\n", what, name);
    return false;
}

bool little_memory_works(void)
{
    run r = gnomon("--version");
    if (strstr(r.out, "--import-memory limits nothing") == NULL)
        return true;
    print_message("without limits of memory: %s", r.out);
    return false;
}

int lines(const char *text)
{
    int count = 0;
    for (; *text != '\0'; ++text)
        count += *text == '\n';
    return count;
}

/* Whether the text holds the parts of a message, which " ... " divides, in any order. */
static bool holds(const char *text, const char *message)
{
    char parts[1024];
    snprintf(parts, sizeof parts, "%s", message);
    for (char *part = parts, *next; part != NULL; part = next) {
        next = strstr(part, " ... ");
        if (next != NULL) {
            *next = '\0';
            next += 5;
        }
        if (strstr(text, part) == NULL)
            return false;
    }
    return true;
}

static void expect_line(int status, const char *arguments, const char *message)
{
    runner_mark();
    run r = gnomon("%s", arguments);
    size_t length = strlen(r.error);
    bool good = r.status == status && lines(r.error) == 1 && r.error[length - 1] == '\n' &&
                strncmp(r.error, "gnomon", 6) == 0 && holds(r.error, message) && r.out[0] == '\0';
    if (!good)
        fail_msg("gnomon %s\n  status %d, expected %d with '%s'\n  stderr: %s  stdout: %s",
                 arguments, r.status, status, message, r.error, r.out);
    if (new_files() != 0)
        fail_msg("gnomon %s: files are left", arguments);
}

void expect(int status, const char *arguments, const char *format, ...)
{
    char message[1024];
    va_list list;
    va_start(list, format);
    vsnprintf(message, sizeof message, format, list);
    va_end(list);
    expect_line(status, arguments, message);
}

void expect_each(int status, const char *before, const refusal *rows, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        char arguments[1024];
        snprintf(arguments, sizeof arguments, "%s %s", before, rows[i].arguments);
        expect_line(status, arguments, rows[i].message);
    }
}

void expect_shell(int status, const char *line, const char *message)
{
    run r = shell("%s", line);
    if (r.status != status || !holds(r.error, message))
        fail_run(&r);
}

void expect_printed(const run *r, const char *words)
{
    if (strstr(r->out, words) == NULL)
        fail_msg("%s\n  no '%s' in:\n%s%s", last_line, words, r->out, r->error);
}

void expect_same_files(const char *first, const char *second)
{
    good_shell("cmp '%s' '%s'", first, second);
}

void expect_good(const run *r)
{
    if (r->status != 0 || r->error[0] != '\0')
        fail_msg("status %d: %s", r->status, r->error);
}

/* Begins to read a PNG. Returns the bytes that its pixels take in this format. */
static size_t begin_reading(const char *name, png_image *image, uint32_t format)
{
    memset(image, 0, sizeof *image);
    image->version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(image, path_of(name)) == 0)
        fail_msg("%s\n  %s: %s", last_line, name, image->message);
    if (format == PNG_FORMAT_LINEAR_Y)
        assert_int_equal(image->format, format); /* the file's own */
    image->format = format;
    return PNG_IMAGE_SIZE(*image);
}

picture picture_read(const char *name)
{
    png_image image;
    uint8_t *rgba = malloc(begin_reading(name, &image, PNG_FORMAT_RGBA));
    assert_int_not_equal(png_image_finish_read(&image, NULL, rgba, 0, NULL), 0);
    return (picture){image.width, image.height, rgba, NULL};
}

/* Numbers of 16 bits pass as they are, as if they were linear light. */
picture picture_read_grey16(const char *name)
{
    png_image image;
    uint16_t *grey = malloc(begin_reading(name, &image, PNG_FORMAT_LINEAR_Y));
    assert_int_not_equal(png_image_finish_read(&image, NULL, grey, 0, NULL), 0);
    return (picture){image.width, image.height, NULL, grey};
}

void picture_free(picture *p)
{
    free(p->rgba);
    free(p->grey);
    memset(p, 0, sizeof *p);
}

uint32_t pixel(const picture *p, uint32_t x, uint32_t y)
{
    const uint8_t *b = p->rgba + 4 * ((size_t)y * p->width + x);
    return (uint32_t)b[0] << 24 | (uint32_t)b[1] << 16 | (uint32_t)b[2] << 8 | b[3];
}

void expect_near(uint32_t got, uint32_t expected, int tolerance)
{
    for (int shift = 0; shift < 32; shift += 8)
        if (abs((int)(got >> shift & 255) - (int)(expected >> shift & 255)) > tolerance)
            fail_msg("%s\n  %08x, expected %08x", last_line, (unsigned)got, (unsigned)expected);
}

picture drawn(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    run r = run_format(true, COMMAND "render -o a.png --samples 1 ", format, arguments);
    va_end(arguments);
    if (r.error[0] != '\0')
        fail_run(&r);
    return picture_read("a.png");
}

void expect_inside(const picture *p, rectangle inside, uint32_t color, uint32_t outside)
{
    for (uint32_t y = 0; y < p->height; ++y) {
        for (uint32_t x = 0; x < p->width; ++x) {
            const bool is_inside =
                x >= inside.left && x < inside.right && y >= inside.top && y < inside.bottom;
            const uint32_t got = pixel(p, x, y), wanted = is_inside ? color : outside;
            if (is_inside && color == 0 ? got == outside : got != wanted)
                fail_msg("%s\n  %08x at %u, %u", last_line, (unsigned)got, (unsigned)x,
                         (unsigned)y);
        }
    }
}

void expect_rectangle(const char *arguments, rectangle inside, uint32_t color, uint32_t outside)
{
    picture p = drawn("%s", arguments);
    expect_inside(&p, inside, color, outside);
    picture_free(&p);
}

void expect_color(const char *arguments, uint32_t color)
{
    picture p = drawn(FRONT " --size 8x8 %s", arguments);
    for (uint32_t i = 0; i < 64; ++i)
        expect_near(pixel(&p, i % 8, i / 8), color, 1);
    picture_free(&p);
}
