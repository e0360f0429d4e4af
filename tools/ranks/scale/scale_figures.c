/* The figures' names, units and stated values. `make scale` measured the stated values, rounded, on
 * a virtual machine with two processors of an AMD EPYC with AVX-512, under Debian 12 with Open MPI,
 * while other programs ran. The last three are assumptions: Ethernet of 10 Gbit/s, and a file
 * system that takes 1 GB/s. */
#include "scale_figures.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *name, *unit, *text;
    double stated;
} rows[FIGURE_COUNT] = {
    [FIGURE_START] = {"start", "s", "starting the command over ranks", 0.5},
    [FIGURE_READ] = {"read", "ns/triangle", "reading the model's file, by one rank", 1500},
    [FIGURE_PREPARE] = {"prepare", "ns/triangle", "a rank's own copy of the model, to draw", 1.4},
    [FIGURE_EXTRACT] = {"extract", "ns/vertex", "choosing a rank's part of the model, by one rank",
                        0.65},
    [FIGURE_VERTEX] = {"vertex", "ns", "a vertex through the vertex shader", 5.3},
    [FIGURE_TRIANGLE] = {"triangle", "ns", "a triangle up to the decision to draw it", 1.6},
    [FIGURE_DRAWN] = {"drawn", "ns", "a drawn triangle's set-up", 10},
    [FIGURE_ROW] = {"row", "ns", "a row of pixels in a drawn triangle", 7.5},
    [FIGURE_FRAGMENT] = {"fragment", "ns", "a fragment", 1.45},
    [FIGURE_TOUCH] = {"touch", "ns/pixel", "the first use of a pixel's memory", 3.3},
    [FIGURE_CLEAR] = {"clear", "ns/pixel", "clearing colour and depth", 0.13},
    [FIGURE_MERGE] = {"merge", "ns/pixel", "merging a pixel of another rank", 0.72},
    [FIGURE_COMPRESS_EMPTY] = {"compress_empty", "ns/pixel", "compressing background", 27},
    [FIGURE_COMPRESS_DRAWN] = {"compress_drawn", "ns/pixel", "compressing what is drawn", 60},
    [FIGURE_FRAME_EMPTY] = {"frame_empty", "ns/pixel", "compressing background of a frame", 24},
    [FIGURE_FRAME_DRAWN] = {"frame_drawn", "ns/pixel", "compressing what a frame shows", 46},
    [FIGURE_BYTES_EMPTY] = {"bytes_empty", "bytes/pixel", "background in the file", 0.0064},
    [FIGURE_BYTES_DRAWN] = {"bytes_drawn", "bytes/pixel", "what is drawn, in the file", 0.167},
    [FIGURE_DISK] = {"disk", "MB/s", "writing to one machine's disk", 700},
    [FIGURE_LOCAL_LATENCY] = {"local_latency", "us", "a message inside a machine", 0.4},
    [FIGURE_LOCAL_BANDWIDTH] = {"local_bandwidth", "MB/s", "messages inside a machine", 1200},
    [FIGURE_LATENCY] = {"latency", "us", "a message between machines", 20},
    [FIGURE_BANDWIDTH] = {"bandwidth", "MB/s", "a machine's port", 1250},
    [FIGURE_SHARED_DISK] = {"shared_disk", "MB/s", "the machines' common file system", 1000},
};

const char *figure_name(figure_kind kind)
{
    return rows[kind].name;
}

const char *figure_unit(figure_kind kind)
{
    return rows[kind].unit;
}

const char *figure_text(figure_kind kind)
{
    return rows[kind].text;
}

void figures_state(figures *f)
{
    for (int k = 0; k < FIGURE_COUNT; ++k) {
        f->value[k] = rows[k].stated;
        f->source[k] = FIGURE_STATED;
    }
}

static bool is_bandwidth(int kind)
{
    return strcmp(rows[kind].unit, "MB/s") == 0;
}

bool figures_set(figures *f, const char *text, figure_source source)
{
    const size_t length = strcspn(text, "=");
    int kind = 0;
    char *end;
    while (kind < FIGURE_COUNT &&
           (strncmp(rows[kind].name, text, length) != 0 || rows[kind].name[length] != '\0'))
        ++kind;
    if (kind == FIGURE_COUNT || text[length] != '=') {
        fprintf(stderr, "scale: '%s': a figure is NAME=VALUE with a name that --list prints\n",
                text);
        return false;
    }
    const char *value = text + length + 1;
    const double number = strtod(value, &end);
    if (end == value || *end != '\0' || !isfinite(number) || number < 0.0 || number > 1e15 ||
        (is_bandwidth(kind) && number <= 0.0)) {
        fprintf(stderr, "scale: '%s': the value is a number%s\n", text,
                is_bandwidth(kind) ? " above 0" : " that is not negative");
        return false;
    }
    f->value[kind] = number;
    f->source[kind] = source;
    return true;
}

bool figures_read(figures *f, const char *path)
{
    char line[256];
    bool good = true;
    FILE *in = fopen(path, "r");
    if (in == NULL) {
        fprintf(stderr, "scale: cannot read %s: %s\n", path, strerror(errno));
        return false;
    }
    for (unsigned number = 1; good && fgets(line, sizeof line, in) != NULL; ++number) {
        line[strcspn(line, "#\r\n")] = '\0';
        size_t length = strlen(line);
        while (length > 0 && (line[length - 1] == ' ' || line[length - 1] == '\t'))
            line[--length] = '\0';
        good = length == 0 || figures_set(f, line, FIGURE_MEASURED);
        if (!good)
            fprintf(stderr, "scale: %s, line %u\n", path, number);
    }
    if (good && ferror(in)) {
        fprintf(stderr, "scale: cannot read %s: %s\n", path, strerror(errno));
        good = false;
    }
    fclose(in);
    return good;
}

void figures_write(FILE *out, figure_kind kind, double value)
{
    fprintf(out, "%s=%.6g # %s: %s\n", rows[kind].name, value, rows[kind].unit, rows[kind].text);
}
