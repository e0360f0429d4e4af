/* gnomon diff: counts the pixels in which two picture files differ. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "command.h"
#include "help.h"
#include "options.h"
#include "output.h"
#include "picture.h"
#include "picture_file.h"
#include "picture_write.h"
#include "report.h"

static const char channel_names[4][8] = {"red", "green", "blue", "alpha"};

typedef struct differences {
    uint64_t pixels, first; /* pixels that differ, and the first of them */
    uint64_t channel_pixels[4];
    uint32_t largest[4]; /* on the scale of 16 bits */
    double sum[4];
} differences;

typedef struct pair {
    image_values a, b;
} pair;

static uint32_t difference_at(const pair *p, size_t i, int c)
{
    const uint32_t a = picture_file_value(&p->a, i, c), b = picture_file_value(&p->b, i, c);
    return a > b ? a - b : b - a;
}

static size_t pixel_count(const pair *p)
{
    return (size_t)p->a.width * p->a.height;
}

static void count(const pair *p, differences *d)
{
    memset(d, 0, sizeof *d);
    for (size_t i = 0; i < pixel_count(p); ++i) {
        bool differs = false;
        for (int c = 0; c < 4; ++c) {
            const uint32_t difference = difference_at(p, i, c);
            if (difference == 0)
                continue;
            differs = true;
            ++d->channel_pixels[c];
            d->sum[c] += difference;
            if (difference > d->largest[c])
                d->largest[c] = difference;
        }
        if (differs && d->pixels++ == 0)
            d->first = i;
    }
}

static void print(FILE *words, const pair *p, const differences *d)
{
    const bool deep = p->a.bits == 16 || p->b.bits == 16;
    const double step = deep ? 1.0 : 257.0;
    const uint64_t pixels = pixel_count(p);
    fprintf(words, "%" PRIu64 " of %" PRIu64 " pixels differ\n", d->pixels, pixels);
    if (d->pixels == 0)
        return;
    fprintf(words, "channel      pixels     largest        mean, in steps of 1/%s\n",
            deep ? "65535" : "255");
    for (int c = 0; c < 4; ++c)
        fprintf(words, "%-7s%12" PRIu64 "%12g%12g\n", channel_names[c], d->channel_pixels[c],
                d->largest[c] / step, d->sum[c] / step / (double)pixels);
    fprintf(words, "first difference at x %" PRIu64 ", y %" PRIu64 " (from the upper left)\n",
            d->first % p->a.width, d->first / p->a.width);
}

/* Even the least difference is clearly not black. */
#define LEAST_HEAT 0.25

static uint8_t glow(double heat)
{
    return (uint8_t)(255.0 * fmin(fmax(heat, 0.0), 1.0) + 0.5);
}

static void heat_row(const void *context, uint32_t y, uint8_t *row)
{
    const pair *p = context;
    const size_t width = p->a.width;
    for (size_t x = 0; x < width; ++x) {
        uint32_t largest = 0;
        for (int c = 0; c < 4; ++c) {
            const uint32_t difference = difference_at(p, y * width + x, c);
            largest = difference > largest ? difference : largest;
        }
        const double heat =
            largest == 0 ? 0.0 : LEAST_HEAT + (1.0 - LEAST_HEAT) * sqrt(largest / 65535.0);
        row[3 * x] = glow(3.0 * heat);
        row[3 * x + 1] = glow(3.0 * heat - 1.0);
        row[3 * x + 2] = glow(3.0 * heat - 2.0);
    }
}

static int read_pair(const options *o, pair *p)
{
    const char *a = o->models[0].path, *b = o->models[1].path;
    int fault = picture_check_output(o, o->output, PICTURE_ANY);
    if (fault == 0)
        fault = picture_file_read(a, &o->limits, &p->a);
    if (fault == 0)
        fault = picture_file_read(b, &o->limits, &p->b);
    if (fault == 0 && (p->a.width != p->b.width || p->a.height != p->b.height))
        fault = report_fault(b, "has %ux%u pixels, and '%s' has %ux%u", (unsigned)p->b.width,
                             (unsigned)p->b.height, a, (unsigned)p->a.width, (unsigned)p->a.height);
    return fault;
}

int command_diff(int argc, char **argv)
{
    options o;
    int status;
    options_result result = options_parse(COMMAND_DIFF, argc, argv, &o, &status);
    if (result == OPTIONS_HELP)
        return help_print(COMMAND_DIFF, false);
    if (result == OPTIONS_WRONG)
        return EXIT_USAGE;
    pair p;
    differences d;
    memset(&p, 0, sizeof p);
    int fault = read_pair(&o, &p);
    if (fault == 0) {
        count(&p, &d);
        if (o.output != NULL)
            fault = picture_write_file(o.output, options_format(&o), PNG_RGB8, p.a.width,
                                       p.a.height, heat_row, &p);
    }
    if (fault == 0) {
        print(output_words(o.output, NULL), &p, &d);
        fault = finish_output(0);
    }
    picture_file_free(&p.a);
    picture_file_free(&p.b);
    return fault != 0 ? EXIT_USAGE : d.pixels > 0 ? EXIT_FAULT : 0;
}
