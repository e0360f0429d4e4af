/* Reads a model file and prints what the readers make of it: show-model FILE. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../tools/models/read.h"

static bool read_file(const char *path, model_file *file)
{
    FILE *const f = fopen(path, "rb");
    if (f == NULL || fseek(f, 0, SEEK_END) != 0)
        return false;
    const long size = ftell(f);
    rewind(f);
    uint8_t *const bytes = malloc((size_t)size + 1);
    file->bytes = bytes;
    file->size = bytes != NULL ? fread(bytes, 1, (size_t)size, f) : 0;
    fclose(f);
    return bytes != NULL;
}

static bool open_beside(void *user, const char *name, model_file *file, const char **reason)
{
    char path[4096];
    const char *const path_of_model = user, *const slash = strrchr(path_of_model, '/');
    const size_t directory = slash != NULL ? (size_t)(slash - path_of_model) + 1 : 0;
    snprintf(path, sizeof path, "%.*s%s", (int)directory, path_of_model, name);
    *reason = "it cannot be read";
    return read_file(path, file);
}

static void close_file(void *user, model_file *file)
{
    (void)user;
    free((void *)file->bytes);
}

static void print_part(size_t number, const model_part *part)
{
    static const char kinds[][12] = {"triangles", "lines", "points"};
    static const char alphas[][8] = {"opaque", "mask", "blend"};
    float low[3], high[3];
    for (size_t c = 0; c < 3; ++c)
        low[c] = high[c] = part->vertex_count > 0 ? part->positions[c] : 0.0f;
    for (size_t i = 0; i < 3 * (size_t)part->vertex_count; ++i) {
        low[i % 3] = part->positions[i] < low[i % 3] ? part->positions[i] : low[i % 3];
        high[i % 3] = part->positions[i] > high[i % 3] ? part->positions[i] : high[i % 3];
    }
    printf("part %zu: %u %s, %u vertices, %s%s%s%s%s%s%s\n", number,
           (unsigned)(part->index_count / model_corners(part->kind)), kinds[part->kind],
           (unsigned)part->vertex_count, alphas[part->surface.alpha],
           part->has_normals ? ", normals" : "", part->has_texcoords ? ", texcoords" : "",
           part->has_tangents ? ", tangents" : "", part->has_vertex_colors ? ", colours" : "",
           part->surface.is_unlit ? ", unlit" : "",
           part->surface.is_double_sided ? ", double-sided" : "");
    printf("  from %g %g %g to %g %g %g\n", low[0], low[1], low[2], high[0], high[1], high[2]);
    if (part->vertex_count > 0)
        printf("  colour %g %g %g %g\n", part->colors[0], part->colors[1], part->colors[2],
               part->colors[3]);
    if (part->surface.is_metallic_roughness)
        printf("  metallic %g, roughness %g, emissive %g %g %g\n", part->surface.metallic,
               part->surface.roughness, part->surface.emissive[0], part->surface.emissive[1],
               part->surface.emissive[2]);
    else
        printf("  specular %g %g %g, exponent %u\n", part->surface.shine.specular[0],
               part->surface.shine.specular[1], part->surface.shine.specular[2],
               (unsigned)part->surface.shine.exponent);
    for (int i = 0; i < MAP_COUNT; ++i)
        if (part->maps[i].image != MODEL_NO_IMAGE)
            printf("  map %d: image %u, wraps %d %d, filters %d: %d %d, channel %d, strength %g\n",
                   i, (unsigned)part->maps[i].image, part->maps[i].wrap_s, part->maps[i].wrap_t,
                   part->maps[i].has_filters, part->maps[i].minify, part->maps[i].magnify,
                   part->maps[i].channel, part->maps[i].strength);
}

int main(int argc, char **argv)
{
    model_file file;
    model m;
    model_messages messages;
    if (argc != 2 || !read_file(argv[1], &file)) {
        fputs("usage: show-model FILE\n", stderr);
        return 2;
    }
    const model_files files = {argv[1], open_beside, close_file};
    const bool good = model_read_bytes(argv[1], model_format_of(argv[1]), file.bytes, file.size,
                                       &files, (uint64_t)4 << 30, &m, &messages);
    for (size_t i = 0; i < messages.warning_count; ++i)
        printf("warning: %s: %s (%llu)\n", messages.warnings[i].file, messages.warnings[i].text,
               (unsigned long long)messages.warnings[i].count);
    if (!good)
        printf("fault: %s: %s\n", messages.fault_file, messages.fault);
    for (size_t i = 0; i < m.part_count; ++i)
        print_part(i, m.parts + i);
    for (uint32_t i = 0; i < m.image_count; ++i)
        printf("image %u: %s, %zu bytes\n", (unsigned)i, m.images[i].name, m.images[i].size);
    printf("origin %.17g %.17g %.17g, %u lights, %u materials\n", m.origin[0], m.origin[1],
           m.origin[2], (unsigned)m.light_count, (unsigned)m.material_count);
    model_free(&m);
    model_messages_free(&messages);
    free((void *)file.bytes);
    return !good;
}
