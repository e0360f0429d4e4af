/* gnomon info: says what is in model files and picture files. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bounds.h"
#include "command.h"
#include "help.h"
#include "import.h"
#include "model_formats.h"
#include "options.h"
#include "picture_file.h"
#include "report.h"

typedef struct attribute_count {
    const char *name;
    uint64_t vertices;
} attribute_count;

static void print_attributes(const model *m, uint64_t vertices)
{
    attribute_count counts[] = {{"normals", 0}, {"texture coordinates", 0}, {"vertex colours", 0}};
    for (size_t i = 0; i < m->part_count; ++i) {
        const model_part *part = m->parts + i;
        counts[0].vertices += part->has_normals ? part->vertex_count : 0;
        counts[1].vertices += part->has_texcoords ? part->vertex_count : 0;
        counts[2].vertices += part->has_vertex_colors ? part->vertex_count : 0;
    }
    printf("  attributes  positions");
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; ++i) {
        if (counts[i].vertices > 0)
            printf(", %s", counts[i].name);
        if (counts[i].vertices > 0 && counts[i].vertices < vertices)
            printf(" (of %" PRIu64 " vertices)", counts[i].vertices);
    }
    printf("\n");
}

/* So many digits that a millionth of the model's size shows, wherever the model is. */
static int digits_of(const double low[3], const double high[3])
{
    double size = 0.0, place = 0.0;
    for (int c = 0; c < 3; ++c) {
        size = fmax(size, high[c] - low[c]);
        place = fmax(place, fmax(fabs(low[c]), fabs(high[c])));
    }
    const int digits = size > 0.0 ? 6 + (int)ceil(log10(fmax(place / size, 1.0))) : 9;
    return digits < 17 ? digits : 17;
}

static void print_bounds(const model *m)
{
    double low[3], high[3];
    model_box(m, low, high);
    for (int c = 0; c < 3; ++c) {
        low[c] += m->origin[c];
        high[c] += m->origin[c];
    }
    const int digits = digits_of(low, high);
    printf("  bounds      %.*g %.*g %.*g to %.*g %.*g %.*g\n", digits, low[0], digits, low[1],
           digits, low[2], digits, high[0], digits, high[1], digits, high[2]);
    printf("  size        %.6g %.6g %.6g\n", high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

static void print_count(const char *name, uint64_t count)
{
    if (count > 0)
        printf("  %-12s%" PRIu64 "\n", name, count);
}

static void print_model(const char *path, const imported *from, const char *maps)
{
    const model *m = &from->model;
    uint64_t vertices = 0;
    for (size_t i = 0; i < m->part_count; ++i)
        vertices += m->parts[i].vertex_count;
    report_print(stdout, path);
    printf(": %s model\n", model_format_name(path));
    print_count("triangles", model_triangle_count(m));
    print_count("lines", model_primitive_count(m, MODEL_LINES));
    print_count("points", model_primitive_count(m, MODEL_POINTS));
    printf("  vertices    %" PRIu64 "\n", vertices);
    print_bounds(m);
    print_attributes(m, vertices);
    printf("  materials   %u\n  draws       %zu\n  maps        ", (unsigned)m->material_count,
           m->part_count);
    report_print(stdout, maps != NULL ? maps : "none");
    printf("\n");
}

static int tell_model(const options *o)
{
    const unsigned int all = shading_traits_of(SHADING_AUTOMATIC)->maps;
    imported from;
    char *maps;
    int fault = import_model(o, all, &from);
    if (fault != 0)
        return fault;
    if (maps_told_words(&from.told, all, &maps))
        print_model(o->model, &from, maps);
    else
        fault = report_fault(o->model, "not enough memory");
    free(maps);
    import_free(&from);
    return fault;
}

static int tell_picture(const char *path, const import_limits *limits)
{
    static const char channels[4][32] = {"grey", "grey, alpha", "red, green, blue",
                                         "red, green, blue, alpha"};
    image_values v;
    int fault = picture_file_read(path, limits, &v);
    if (fault != 0)
        return fault;
    report_print(stdout, path);
    printf(": %s picture\n  size        %ux%u\n  channels    %u: %s\n  bits        %u a channel\n",
           v.format, (unsigned)v.width, (unsigned)v.height, (unsigned)v.channels,
           channels[v.channels - 1], (unsigned)v.bits);
    if (v.orientation != 1)
        printf("  orientation %u in its Exif data, which is not applied\n",
               (unsigned)v.orientation);
    picture_file_free(&v);
    return 0;
}

int command_info(int argc, char **argv)
{
    options o;
    int status;
    int fault = 0;
    options_result result = options_parse(COMMAND_INFO, argc, argv, &o, &status);
    if (result == OPTIONS_HELP)
        return help_print(COMMAND_INFO, false);
    if (result == OPTIONS_WRONG)
        return status;
    for (size_t i = 0; i < o.model_count; ++i) {
        o.model = o.models[i].path;
        o.describes_maps = true;
        if ((model_format_name(o.model) != NULL ? tell_model(&o)
                                                : tell_picture(o.model, &o.limits)) != 0)
            fault = EXIT_FAULT;
        flush_output();
    }
    return finish_output(fault);
}
