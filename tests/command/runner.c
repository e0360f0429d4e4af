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
static char **marked;
static size_t marked_count;

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
    if (setenv("GNOMON", absolute, 1) != 0 || mkdtemp(directory) == NULL)
        die(directory);
}

static void forget_marked(void)
{
    for (size_t i = 0; i < marked_count; ++i)
        free(marked[i]);
    free(marked);
    marked = NULL;
    marked_count = 0;
}

void suite_end(void)
{
    char line[128];
    forget_marked();
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
    FILE *file = fopen(path_of(name), "rb");
    if (file == NULL)
        die(path_of(name));
    size_t length = fread(text, 1, size - 1, file);
    text[length] = '\0';
    fclose(file);
    unlink(path_of(name));
}

run shell(const char *line)
{
    run result;
    char full[4096];
    snprintf(full, sizeof full, "cd '%s' && exec >.out 2>.error </dev/null; %s", directory, line);
    int status = system(full);
    result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    read_back(".out", result.out, sizeof result.out);
    read_back(".error", result.error, sizeof result.error);
    return result;
}

run gnomon(const char *format, ...)
{
    char line[2048] = "timeout 60 \"$GNOMON\" ";
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(line + strlen(line), sizeof line - strlen(line), format, arguments);
    va_end(arguments);
    return shell(line);
}

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
    DIR *d = opendir(directory);
    forget_marked();
    for (struct dirent *entry; (entry = readdir(d)) != NULL;) {
        marked = realloc(marked, (marked_count + 1) * sizeof *marked);
        marked[marked_count++] = strdup(entry->d_name);
    }
    closedir(d);
}

int new_files(void)
{
    int count = 0;
    DIR *d = opendir(directory);
    for (struct dirent *entry; (entry = readdir(d)) != NULL;) {
        bool known = false;
        for (size_t i = 0; i < marked_count && !known; ++i)
            known = strcmp(entry->d_name, marked[i]) == 0;
        if (!known) {
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

void expect(int status, const char *arguments, const char *first, const char *second)
{
    runner_mark();
    run r = gnomon("%s", arguments);
    size_t length = strlen(r.error);
    bool good = r.status == status && lines(r.error) == 1 && r.error[length - 1] == '\n' &&
                strncmp(r.error, "gnomon", 6) == 0 && strstr(r.error, first) != NULL &&
                strstr(r.error, second) != NULL && r.out[0] == '\0';
    if (!good)
        fail_msg("gnomon %s\n  status %d, expected %d with '%s' and '%s'\n  stderr: %s"
                 "  stdout: %s",
                 arguments, r.status, status, first, second, r.error, r.out);
    if (new_files() != 0)
        fail_msg("gnomon %s: files are left", arguments);
}

void expect_good(const run *r)
{
    if (r->status != 0 || r->error[0] != '\0')
        fail_msg("status %d: %s", r->status, r->error);
}

picture picture_read(const char *name)
{
    picture result = {0, 0, NULL, NULL};
    png_image image;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    assert_int_not_equal(png_image_begin_read_from_file(&image, path_of(name)), 0);
    image.format = PNG_FORMAT_RGBA;
    result.width = image.width;
    result.height = image.height;
    result.rgba = malloc(PNG_IMAGE_SIZE(image));
    assert_int_not_equal(png_image_finish_read(&image, NULL, result.rgba, 0, NULL), 0);
    return result;
}

/* png_image is not used, because it takes 16 bits for linear light. */
picture picture_read_grey16(const char *name)
{
    picture result = {0, 0, NULL, NULL};
    FILE *file = fopen(path_of(name), "rb");
    assert_non_null(file);
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    if (setjmp(png_jmpbuf(png)) != 0)
        fail_msg("%s is no readable PNG", name);
    png_init_io(png, file);
    png_read_png(png, info, PNG_TRANSFORM_IDENTITY, NULL);
    assert_int_equal(png_get_bit_depth(png, info), 16);
    assert_int_equal(png_get_color_type(png, info), PNG_COLOR_TYPE_GRAY);
    result.width = png_get_image_width(png, info);
    result.height = png_get_image_height(png, info);
    result.grey = malloc((size_t)result.width * result.height * sizeof *result.grey);
    png_bytepp rows = png_get_rows(png, info);
    for (uint32_t y = 0; y < result.height; ++y) {
        for (uint32_t x = 0; x < result.width; ++x)
            result.grey[(size_t)y * result.width + x] =
                (uint16_t)(rows[y][2 * x] << 8 | rows[y][2 * x + 1]);
    }
    png_destroy_read_struct(&png, &info, NULL);
    fclose(file);
    return result;
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
