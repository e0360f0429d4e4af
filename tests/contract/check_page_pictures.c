/* Draws the web page's pictures with every back end of the library, whole and in bands, and
 * compares with the committed hashes. Needs a C compiler alone, no OpenGL. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "page.h"

#define PROGRAM "page-pictures-check"
#define PICTURES_FILE "tests/contract/pictures.txt"

/* A file with fewer pictures is not the contract. */
#define LEAST_PICTURES 150

typedef struct check {
    unsigned int pictures, failed;
} check;

static void complain(check *k, const char *state, const char *what, const char *more)
{
    if (k->failed++ < 20)
        fprintf(stderr, PROGRAM ": \"%s\": %s%s\n", state, what, more);
}

/* Draws in bands of 1, 2, 3 and so on rows, the last band first, each over a picture that is
 * spoiled. Returns whether the bands are rows of `whole`. */
static bool bands_agree(const uint8_t *whole)
{
    const uint32_t height = page_height();
    const size_t row = (size_t)4 * page_width();
    uint32_t end = height;
    for (uint32_t rows = 1; end > 0; ++rows) {
        const uint32_t from = end > rows ? end - rows : 0;
        memset((uint8_t *)page_color(), 0x5a, row * height);
        if (page_draw(from, end) != 0 ||
            memcmp(page_color() + from * row, whole + from * row, (end - from) * row) != 0)
            return false;
        end = from;
    }
    return true;
}

static void check_backend(check *k, const char *state, const char *hash, gn_backend backend)
{
    page_use_backend(backend);
    if (page_build() != 0 || page_draw(0, page_height()) != 0) {
        complain(k, state, "not drawn: ", page_message());
        return;
    }
    const uint32_t width = page_width();
    const uint32_t height = page_height();
    const size_t size = (size_t)4 * width * height;
    const char *const drawn = page_hash(page_color(), width, height);
    if (strcmp(drawn, hash) != 0)
        complain(k, state, "another picture with the back end ", gn_backend_name(backend));
    /* Bands of one row of a picture of 480 take long. */
    if (size > (size_t)4 * 240 * 180)
        return;
    uint8_t *const whole = malloc(size);
    if (whole == NULL) {
        complain(k, state, "no memory", "");
        return;
    }
    memcpy(whole, page_color(), size);
    if (!bands_agree(whole))
        complain(k, state, "bands differ from the whole with the back end ",
                 gn_backend_name(backend));
    free(whole);
}

static void check_line(check *k, char *line)
{
    char *const space = strchr(line, ' ');
    const char *const state = space ? space + 1 : "";
    if (space)
        *space = '\0';
    ++k->pictures;
    if (page_set_state(state) != 0) {
        complain(k, state, "no state: ", page_message());
        return;
    }
    if (strcmp(page_state(), state) != 0)
        complain(k, state, "not canonical; it is ", page_state());
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
        if (gn_backend_available((gn_backend)b))
            check_backend(k, state, line, (gn_backend)b);
}

static void check_file(check *k, FILE *in)
{
    char line[1024];
    bool begun = false;
    while (fgets(line, sizeof line, in)) {
        line[strcspn(line, "\n")] = '\0';
        if (strcmp(line, "gnomon-pictures 1") == 0)
            begun = true;
        else if (begun && strncmp(line, "reference ", 10) != 0)
            check_line(k, line);
    }
}

int main(int argc, char **argv)
{
    const char *const name = argc > 1 ? argv[1] : PICTURES_FILE;
    const char *before = "";
    check k = {0, 0};
    if (argc > 2 || strncmp(name, "--", 2) == 0) {
        fprintf(stderr, "usage: page-pictures-check [FILE]: draws the pictures of " PICTURES_FILE
                        " with every back end and compares their hashes\n");
        return 2;
    }
    FILE *const in = fopen(name, "r");
    if (!in) {
        fprintf(stderr, PROGRAM ": cannot read %s: %s\n", name, strerror(errno));
        return 1;
    }
    check_file(&k, in);
    fclose(in);
    if (k.pictures < LEAST_PICTURES)
        complain(&k, name, "has too few pictures to be the contract", "");
    printf("pictures: %u states, %u differ (", k.pictures, k.failed);
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
        if (gn_backend_available((gn_backend)b)) {
            printf("%s%s", before, gn_backend_name((gn_backend)b));
            before = ", ";
        }
    printf(")\n");
    return k.failed == 0 ? 0 : 1;
}
