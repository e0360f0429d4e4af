/* make-documents: writes the man page and the completions of shells from the tables of commands and
 * options, when the command is built.
 * usage: make-documents TEMPLATE DIRECTORY */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "documents.h"

static FILE *opened(const char *path, const char *mode)
{
    FILE *file = fopen(path, mode);
    if (file == NULL) {
        perror(path);
        exit(1);
    }
    return file;
}

static FILE *created(const char *directory, const char *name)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", directory, name);
    return opened(path, "w");
}

static void finish(FILE *file)
{
    if (ferror(file) || fclose(file) != 0) {
        perror("make-documents");
        exit(1);
    }
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        fputs("usage: make-documents TEMPLATE DIRECTORY\n", stderr);
        return 2;
    }
    FILE *template = opened(argv[1], "r");
    FILE *out = created(argv[2], "gnomon.1");
    if (!write_man(template, out)) {
        fprintf(stderr, "make-documents: %s: no such part\n", argv[1]);
        return 1;
    }
    finish(template);
    finish(out);
    out = created(argv[2], "gnomon.bash");
    write_bash(out);
    finish(out);
    out = created(argv[2], "_gnomon");
    write_zsh(out);
    finish(out);
    return 0;
}
