/* Runs a fuzz target once on each of the files and of the folders' files that are named. Needs no
 * fuzzer. Prints one line when all inputs have run, with the number of those that the target does
 * not test; a claim that does not hold ends the program, with the name of its file as the last
 * thing on standard error. */
#define _POSIX_C_SOURCE 200809L
#include <dirent.h>
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "fuzz.h"

static char current[4096];
static unsigned long untested; /* inputs that the target refuses */

/* Names the input that a claim or a crash ended. */
static void name_input(int number)
{
    static const char words[] = "\nfuzz: with the input ";

    if (write(STDERR_FILENO, words, sizeof words - 1) < 0 ||
        write(STDERR_FILENO, current, strlen(current)) < 0 || write(STDERR_FILENO, "\n", 1) < 0)
        _exit(EXIT_FAILURE);
    signal(number, SIG_DFL);
    raise(number);
}

static unsigned long run_file(const char *path)
{
    FILE *const file = fopen(path, "rb");
    uint8_t *bytes = NULL;
    size_t size = 0, room = 0, read = 1;

    if (!file) {
        fprintf(stderr, "fuzz: %s: %s\n", path, strerror(errno));
        exit(EXIT_FAILURE);
    }
    for (; read > 0; size += read) {
        if (size == room) {
            uint8_t *const grown = realloc(bytes, room = room ? 2 * room : 4096);

            if (!grown)
                exit(EXIT_FAILURE);
            bytes = grown;
        }
        read = fread(bytes + size, 1, room - size, file);
    }
    fclose(file);

    /* Exactly as long as the input, so that a sanitizer sees what reads beyond its end. */
    uint8_t *const exact = fuzz_memory(size);

    if (size)
        memcpy(exact, bytes, size);
    free(bytes);
    snprintf(current, sizeof current, "%s", path);
    untested += LLVMFuzzerTestOneInput(exact, size) != 0;
    free(exact);
    return 1;
}

static unsigned long run(const char *path)
{
    struct stat status;
    struct dirent **list;
    unsigned long runs = 0;

    if (stat(path, &status) != 0 || !S_ISDIR(status.st_mode))
        return run_file(path);

    const int count = scandir(path, &list, NULL, alphasort);

    for (int i = 0; i < count; ++i) {
        char name[4096];

        snprintf(name, sizeof name, "%s/%s", path, list[i]->d_name);
        if (list[i]->d_name[0] != '.')
            runs += run(name);
        free(list[i]);
    }
    if (count >= 0)
        free(list);
    return runs;
}

int main(int argc, char **argv)
{
    unsigned long runs = 0;

    if (argc < 2 || strcmp(argv[1], "--help") == 0) {
        printf(
            "usage: %s FILE-OR-FOLDER...\n"
            "Runs this fuzz target on each input: a file, or all files of a folder. Exit status:\n"
            "0: every claim held; otherwise the program ends where one did not, and the last line\n"
            "on standard error names the input.\n",
            argv[0]);
        return argc < 2 ? 2 : 0;
    }
    signal(SIGABRT, name_input);
    for (int i = 1; i < argc; ++i)
        runs += run(argv[i]);
    printf("%s: %lu inputs, %lu not tested\n", argv[0], runs, untested);
    return runs == 0;
}
