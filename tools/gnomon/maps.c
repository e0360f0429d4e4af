/* Finds and reads maps. */
#include "maps.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "files.h"
#include "image_alpha.h"
#include "near_name.h"
#include "report.h"

/* A map's option, its name in sentences, and the ending of its file name beside a model. */
static const struct {
    char option[16];
    char words[32];
    char suffix[16];
} kinds[MAP_COUNT] = {{"--texture", "diffuse", "_diffuse"},
                      {"--normal-map", "tangent-space normals", "_nm_tangent"},
                      {"--specular-map", "specular", "_spec"},
                      {"--glow-map", "glow", "_glow"},
                      {"", "opacity", ""},
                      {"", "roughness", ""},
                      {"", "occlusion", ""}};

static const char world_space_words[] = "world-space normals";
static const char world_space_suffix[] = "_nm";

size_t maps_stem_length(const char *model_path)
{
    const char *slash = strrchr(model_path, '/');
    const char *name = slash != NULL ? slash + 1 : model_path;
    const char *dot = strrchr(name, '.');
    return dot != NULL && dot > name ? (size_t)(dot - model_path) : strlen(model_path);
}

/* Returns MODEL without its extension + suffix + .tga, .png or .jpg, allocated, if such a file
 * exists; otherwise null. */
static char *conventional_file(const char *model_path, const char *suffix)
{
    static const char endings[][8] = {".tga", ".png", ".jpg"};
    size_t stem = maps_stem_length(model_path);
    char *path = malloc(stem + strlen(suffix) + sizeof endings[0]);
    if (path == NULL)
        return NULL;
    memcpy(path, model_path, stem);
    for (int i = 0; i < 3; ++i) {
        strcpy(path + stem, suffix);
        strcat(path + stem, endings[i]);
        if (access(path, F_OK) == 0)
            return path;
    }
    free(path);
    return NULL;
}

/* Whether the list has this entry. */
static bool is_told(const maps_told *told, const char *entry)
{
    const size_t length = strlen(entry);
    for (const char *at = told->text; at != NULL && (at = strstr(at, entry)) != NULL; ++at)
        if ((unsigned char)at[length] <= MAP_COUNT)
            return true;
    return false;
}

/* Adds "words file" to the list, once. If there is not enough memory, the list stays as it is. */
static void tell(maps_told *told, map_kind kind, const char *words, const char *file)
{
    size_t length = told->text != NULL ? strlen(told->text) : 0;
    size_t added = strlen(words) + strlen(file) + 3;
    char *entry = malloc(added);
    if (entry == NULL)
        return;
    snprintf(entry, added, "%c%s %s", 1 + (int)kind, words, file);
    for (char *c = entry + 1; *c != '\0'; ++c)
        if ((unsigned char)*c <= MAP_COUNT)
            *c = '?'; /* An entry begins with such a character. */
    if (!is_told(told, entry)) {
        char *longer = realloc(told->text, length + added);
        if (longer != NULL) {
            told->text = longer;
            strcpy(longer + length, entry);
        }
    }
    free(entry);
}

/* The arguments of maps_read, for the functions that it calls. */
typedef struct reader {
    const options *o;
    const model *m;
    const model_part *part;
    image_budget *budget;
    maps_told *told;
    map_kind kind; /* that is read */
} reader;

/* Adds a map that has been read, or why it cannot be. */
static void describe(const reader *r, const char *words, const char *name, const image *map,
                     const char *reason)
{
    char text[8192];
    if (!r->o->describes_maps)
        snprintf(text, sizeof text, "%s", name);
    else if (map->texels != NULL)
        snprintf(text, sizeof text, "%s (%ux%u)", name, (unsigned)map->width,
                 (unsigned)map->height);
    else
        snprintf(text, sizeof text, "%s (cannot be read: %s)", name, reason);
    tell(r->told, r->kind, words, text);
}

/* Warns, once for each file, that an image's orientation is not applied. */
static void warn_of_orientation(const reader *r, const char *path, bool is_inside, const image *map)
{
    const size_t count = r->told->oriented.count;
    if (map->orientation != 1 && files_list_add(&r->told->oriented, path) &&
        r->told->oriented.count > count)
        report_warning(path,
                       "the Exif data of %s asks for orientation %u, which is not applied: texture "
                       "coordinates refer to the picture as it is stored",
                       is_inside ? "a texture inside it" : "this picture",
                       (unsigned)map->orientation);
}

static int read_file(const reader *r, const char *path, const char *option, const char *words,
                     image *result)
{
    const char *reason = NULL;
    const bool good = image_read(path, r->budget, result, &reason);
    if (!good)
        reason = files_reason_with_nearest(path, NULL, reason);
    else
        warn_of_orientation(r, path, false, result);
    if (!good && !r->o->describes_maps)
        return report_fault(path, "cannot be read as a texture: %s (go on without it: %s none)",
                            reason, option);
    describe(r, words, path, result, reason);
    return 0;
}

/* The image of the map that the material names; null: it names none. */
static const model_image *named_image(const reader *r, map_kind kind)
{
    const uint32_t number = r->part->maps[kind].image;
    return number != MODEL_NO_IMAGE ? r->m->images + number : NULL;
}

static bool is_inside(const model_image *named)
{
    return named->bytes != NULL || named->bare;
}

/* What a list calls the map that a material names. */
static const char *name_of(const model_image *named)
{
    return is_inside(named) ? "inside the model" : named->name;
}

/* Says that a map cannot be read. A kind of map that no option can turn off is left out. */
static int miss(const reader *r, const model_image *named, const char *path, const char *reason)
{
    const char *const option = kinds[r->kind].option;
    if (option[0] == '\0') {
        report_warning(r->o->model, "its %s map '%s' cannot be read: %s; it is left out",
                       kinds[r->kind].words, path != NULL ? path : name_of(named), reason);
        return 0;
    }
    if (is_inside(named))
        return report_fault(r->o->model,
                            "the texture inside it cannot be read: %s (go on without it: %s none)",
                            reason, option);
    return report_fault(r->o->model,
                        "its texture '%s' cannot be read: %s (go on without it: %s none)",
                        path != NULL ? path : named->name, reason, option);
}

/* Reads the map that the material names. If maps are only described, one that cannot be read is no
 * fault; *reason says why. */
static int read_named(const reader *r, const model_image *named, image *result, const char **reason)
{
    char *path = is_inside(named) ? NULL : files_beside(r->o->model, named->name);
    bool good = false;
    *reason = is_inside(named) ? "its texels are bare" : IMPORT_NO_MEMORY;
    if (path != NULL)
        good = image_read(path, r->budget, result, reason);
    else if (is_inside(named) && !named->bare)
        good = image_decode(named->bytes, named->size, r->budget, result, reason);
    if (!good && path != NULL)
        *reason = files_reason_with_nearest(path, r->o->model, *reason);
    if (good)
        warn_of_orientation(r, path != NULL ? path : r->o->model, path == NULL, result);
    const int fault = good || r->o->describes_maps ? 0 : miss(r, named, path, *reason);
    free(path);
    return fault;
}

/* Reads a file beside the model, found by its suffix; does nothing if there is none. */
static int read_conventional(const reader *r, const char *suffix, const char *option,
                             const char *words, image *result)
{
    char *path = conventional_file(r->o->model, suffix);
    int fault = path != NULL ? read_file(r, path, option, words, result) : 0;
    free(path);
    return fault;
}

/* Reads the normals that the material names; does nothing if they are heights. */
static int read_named_normals(const reader *r, const model_image *named, image *result)
{
    const char *reason;
    int fault = read_named(r, named, result, &reason);
    if (fault != 0)
        return fault;
    const bool has_heights = result->texels != NULL && image_is_grey(result);
    describe(r, has_heights ? "(heights, not used)" : kinds[MAP_NORMAL].words, name_of(named),
             result, reason);
    if (has_heights)
        image_free(result);
    return 0;
}

/* Normals in tangent space need tangents, so a part without tangents takes those in world space. */
static int read_normals(const reader *r, part_maps *result)
{
    const options *o = r->o;
    image *normals = result->images + MAP_NORMAL;
    const map_option *asked = o->maps + MAP_NORMAL;
    const model_image *named = named_image(r, MAP_NORMAL);
    const char *option = kinds[MAP_NORMAL].option;
    const char *tangent_words = kinds[MAP_NORMAL].words;
    bool may_be_tangent = o->normals != NORMALS_WORLD && r->part->has_tangents;
    bool may_be_world = o->normals != NORMALS_TANGENT;
    int fault = 0;
    if (asked->file != NULL) {
        if (o->normals == NORMALS_TANGENT && !r->part->has_tangents)
            return 0;
        result->normals_in_tangent_space = may_be_tangent;
        return read_file(r, asked->file, option, may_be_tangent ? tangent_words : world_space_words,
                         normals);
    }
    result->normals_in_tangent_space = true;
    if (may_be_tangent && named != NULL)
        return read_named_normals(r, named, normals);
    if (may_be_tangent)
        fault = read_conventional(r, kinds[MAP_NORMAL].suffix, option, tangent_words, normals);
    if (fault == 0 && normals->texels == NULL && may_be_world) {
        result->normals_in_tangent_space = false;
        fault = read_conventional(r, world_space_suffix, option, world_space_words, normals);
    }
    return fault;
}

/* Reads the map of r->kind that an option, the material or a file's name gives. */
static int read_map(const reader *r, part_maps *result)
{
    static const map_option nothing;
    const map_option *asked = r->kind < OPTIONS_MAP_COUNT ? r->o->maps + r->kind : &nothing;
    const char *const option = kinds[r->kind].option, *const words = kinds[r->kind].words;
    const model_image *const named = named_image(r, r->kind);
    image *const to = result->images + r->kind;
    const char *reason;
    if (asked->none)
        return 0;
    if (r->kind == MAP_NORMAL)
        return read_normals(r, result);
    if (asked->file != NULL)
        return read_file(r, asked->file, option, words, to);
    if (named == NULL)
        return kinds[r->kind].suffix[0] != '\0'
                   ? read_conventional(r, kinds[r->kind].suffix, option, words, to)
                   : 0;
    const int fault = read_named(r, named, to, &reason);
    if (fault == 0 && (to->texels != NULL || r->o->describes_maps))
        describe(r, words, name_of(named), to, reason);
    return fault;
}

/* Whether the diffuse map is the one that the material names. */
static bool is_materials_own(const reader *r)
{
    return r->o->maps[MAP_DIFFUSE].file == NULL && named_image(r, MAP_DIFFUSE) != NULL;
}

/* Whether an earlier part has the same diffuse map and is opaque too, so that the warning has been
 * printed. */
static bool is_warned(const reader *r)
{
    for (const model_part *part = r->m->parts; part < r->part; ++part)
        if (part->maps[MAP_DIFFUSE].image == r->part->maps[MAP_DIFFUSE].image &&
            part->surface.alpha == MODEL_OPAQUE)
            return true;
    return false;
}

/* Settles what alpha the diffuse map has. The map of opacity goes into it. */
static int settle_alpha(const reader *r, part_maps *result)
{
    image *const opacity = result->images + MAP_OPACITY;
    const bool is_opaque = r->part->surface.alpha == MODEL_OPAQUE || r->o->opaque;
    bool left_out;
    const bool good = image_settle_alpha(result->images + MAP_DIFFUSE, opacity,
                                         r->part->maps[MAP_OPACITY].channel, is_opaque,
                                         r->part->maps[MAP_DIFFUSE].has_opacity, &left_out);
    if (left_out && !r->o->opaque && !is_warned(r))
        report_warning(r->o->model, "alpha in its diffuse map is not drawn: the material %s",
                       is_opaque ? "is opaque" : "names no map of opacity");
    image_free(opacity);
    return good ? 0 : report_fault(r->o->model, IMPORT_NO_MEMORY);
}

/* Warns of maps that repeat otherwise than the first: the shaders have one sampler for all. */
static void check_samplers(const reader *r, const part_maps *maps)
{
    unsigned int present = 0;
    for (int i = 0; i < MAP_COUNT; ++i)
        present |= (maps->images[i].texels != NULL ? 1u : 0u) << i;
    const unsigned int others = model_maps_unlike_first(r->part, present);
    for (int i = 0; i < MAP_COUNT; ++i)
        if ((others >> i & 1) != 0)
            report_warning(r->o->model,
                           "its %s map repeats otherwise than its first map; it is drawn as that",
                           kinds[i].words);
}

int maps_read(const options *o, const model *m, size_t part, unsigned int wanted,
              image_budget *budget, part_maps *result, maps_told *told)
{
    reader r = {o, m, m->parts + part, budget, told, MAP_DIFFUSE};
    int fault = 0;
    memset(result, 0, sizeof *result);
    if ((wanted & 1u << MAP_DIFFUSE) != 0)
        wanted |= 1u << MAP_OPACITY;
    for (int i = 0; i < MAP_COUNT && r.part->has_texcoords && fault == 0; ++i) {
        r.kind = (map_kind)i;
        if ((wanted >> i & 1) != 0)
            fault = read_map(&r, result);
    }
    result->replaces_color = result->images[MAP_DIFFUSE].texels != NULL && !is_materials_own(&r);
    if (fault == 0)
        fault = settle_alpha(&r, result);
    if (fault == 0)
        check_samplers(&r, result);
    if (fault != 0)
        maps_free(result);
    return fault;
}

void maps_free(part_maps *maps)
{
    for (int i = 0; i < MAP_COUNT; ++i)
        image_free(maps->images + i);
}

bool maps_told_append(maps_told *to, const maps_told *from)
{
    if (from->text == NULL)
        return true;
    const size_t length = to->text != NULL ? strlen(to->text) : 0;
    char *longer = realloc(to->text, length + strlen(from->text) + 1);
    if (longer == NULL)
        return false;
    to->text = longer;
    strcpy(longer + length, from->text);
    return true;
}

bool maps_told_words(const maps_told *told, unsigned int wanted, char **result)
{
    size_t length = 0;
    bool is_wanted = false;
    *result = NULL;
    if (told->text == NULL)
        return true;
    /* An entry's character makes room for one of the two that separate entries. */
    char *words = malloc(2 * strlen(told->text) + 1);
    if (words == NULL)
        return false;
    for (const char *c = told->text; *c != '\0'; ++c) {
        const bool begins = (unsigned char)*c <= MAP_COUNT;
        if (begins)
            is_wanted = (wanted >> (*c - 1) & 1) != 0;
        if (is_wanted && !begins)
            words[length++] = *c;
        else if (is_wanted && length > 0)
            length += (size_t)sprintf(words + length, ", ");
    }
    words[length] = '\0';
    if (length > 0)
        *result = words;
    else
        free(words);
    return true;
}

void maps_told_free(maps_told *told)
{
    free(told->text);
    files_list_free(&told->oriented);
    told->text = NULL;
}
