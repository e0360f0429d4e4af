/* Finds and completes the maps of the dropped model. */
#include "page_maps.h"

#include <stdlib.h>
#include <string.h>

#include "image_alpha.h"
#include "page_files.h"
#include "page_json.h"

/* What a map is called in sentences, and the ending of its file's name beside a model. */
static const struct {
    char words[12];
    char suffix[12];
} kinds[MAP_COUNT] = {{"diffuse", "_diffuse"}, {"normal", "_nm_tangent"}, {"specular", "_spec"},
                      {"glow", "_glow"},       {"opacity", ""},           {"roughness", ""},
                      {"occlusion", ""}};

/* An image of the model, or behind those, one for each kind of map that is found by its name. */
typedef struct wanted_image {
    const model_image *inside; /* null: it is a file */
    uint32_t file;             /* or PAGE_NO_FILE: no texels are wanted */
    image texels;              /* the top row first, until they are complete */
} wanted_image;

static wanted_image *images;
static uint32_t count;
static uint32_t by_name; /* where those begin that are found by their names */

void page_maps_forget(void)
{
    for (uint32_t i = 0; i < count; ++i)
        free(images[i].texels.texels);
    free(images);
    images = NULL;
    count = by_name = 0;
}

/* The file MODEL_suffix with an ending of images. */
static uint32_t conventional_file(const char *model_name, const char *suffix)
{
    static const char endings[][8] = {".tga", ".png", ".jpg"};
    const char *const dot = strrchr(model_name, '.');
    uint32_t found = PAGE_NO_FILE;
    for (int i = 0; i < 3 && found == PAGE_NO_FILE && *suffix != '\0'; ++i) {
        text name = {0};
        text_add_part(&name, model_name, (size_t)(dot - model_name));
        text_add(&name, suffix);
        text_add(&name, endings[i]);
        found = name.failed ? PAGE_NO_FILE : page_files_find(text_of(&name));
        free(name.chars);
    }
    return found;
}

/* Whether pictures show a kind of map of a part at all. Normals need tangents, and an opaque part
 * has no opacity. */
static bool is_shown(const model_part *part, map_kind kind)
{
    return part->has_texcoords && kind <= MAP_OPACITY &&
           (kind != MAP_NORMAL || part->has_tangents) &&
           (kind != MAP_OPACITY || part->surface.alpha != MODEL_OPAQUE);
}

/* The number of the image of a part's map; `count` if it has none. */
static uint32_t image_of(const model_part *part, map_kind kind)
{
    if (!is_shown(part, kind))
        return count;
    return part->maps[kind].image != MODEL_NO_IMAGE ? part->maps[kind].image
                                                    : by_name + (uint32_t)kind;
}

/* Wants the texels of an image that a map of the model shows, or says why there are none. */
static void want(const model *m, uint32_t number, map_kind kind, model_reader *warnings)
{
    const model_image *const named = m->images + number;
    wanted_image *const wanted = images + number;
    if (named->bare) {
        reader_warn(warnings, NULL,
                    "its %s map inside the model cannot be read: its texels are bare; "
                    "it is left out",
                    kinds[kind].words);
    } else if (named->bytes != NULL) {
        wanted->inside = named;
    } else {
        wanted->file = page_files_find(named->name);
        if (wanted->file == PAGE_NO_FILE)
            reader_warn(warnings, NULL,
                        "its %s map '%s' cannot be read: it was not dropped with the model; "
                        "it is left out",
                        kinds[kind].words, named->name);
    }
}

bool page_maps_find(const model *m, model_reader *warnings)
{
    page_maps_forget();
    images = calloc((size_t)m->image_count + MAP_COUNT, sizeof *images);
    if (images == NULL)
        return false;
    by_name = m->image_count;
    count = by_name + MAP_COUNT;
    for (uint32_t i = 0; i < count; ++i)
        images[i].file = PAGE_NO_FILE;
    for (size_t p = 0; p < m->part_count; ++p) {
        for (int k = 0; k < MAP_COUNT; ++k) {
            const uint32_t number = image_of(m->parts + p, (map_kind)k);
            if (number < by_name && images[number].inside == NULL &&
                images[number].file == PAGE_NO_FILE)
                want(m, number, (map_kind)k, warnings);
            else if (number >= by_name && number < count)
                images[number].file = conventional_file(warnings->name, kinds[k].suffix);
        }
    }
    return true;
}

static bool is_wanted(uint32_t number)
{
    return images[number].inside != NULL || images[number].file != PAGE_NO_FILE;
}

void page_maps_describe(text *to)
{
    bool is_first = true;
    page_json_name(to, "images");
    text_add(to, "[");
    for (uint32_t i = 0; i < count; ++i) {
        if (!is_wanted(i))
            continue;
        text_add(to, is_first ? "{" : ", {");
        is_first = false;
        page_json_whole(to, "number", i);
        if (images[i].inside != NULL) {
            page_json_string(to, "name", images[i].inside->name);
            page_json_address(to, "at", images[i].inside->bytes);
            page_json_whole(to, "size", images[i].inside->size);
        } else {
            page_json_string(to, "name", page_files_at(images[i].file)->name);
            page_json_whole(to, "file", images[i].file);
        }
        page_json_end(to);
    }
    text_add(to, "]");
}

uint32_t *page_maps_image(uint32_t number, uint32_t width, uint32_t height)
{
    if (number >= count || !is_wanted(number)) {
        page_fail("the model does not want such an image", (const char *)NULL);
        return NULL;
    }
    if (width == 0 || height == 0 || width > PAGE_MAX_MAP_SIZE || height > PAGE_MAX_MAP_SIZE) {
        page_fail("a map is 1x1 to 8192x8192 texels large", (const char *)NULL);
        return NULL;
    }
    image *const to = &images[number].texels;
    free(to->texels);
    *to = (image){width, height, calloc((size_t)width * height, sizeof *to->texels), 1};
    if (to->texels == NULL)
        page_fail("there is not enough memory for the model", (const char *)NULL);
    return to->texels;
}

/* From the order of JavaScript's bytes and rows to that of the library's texels. */
static void turn(image *map)
{
    for (uint32_t y = 0; y < map->height / 2; ++y) {
        uint32_t *const upper = map->texels + (size_t)y * map->width;
        uint32_t *const lower = map->texels + (size_t)(map->height - 1 - y) * map->width;
        for (uint32_t x = 0; x < map->width; ++x) {
            const uint32_t texel = upper[x];
            upper[x] = lower[x];
            lower[x] = texel;
        }
    }
    for (size_t i = 0; i < (size_t)map->width * map->height; ++i) {
        uint8_t bytes[4];
        memcpy(bytes, map->texels + i, sizeof bytes);
        map->texels[i] = (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 |
                         (uint32_t)bytes[3] << 24;
    }
}

static bool copy_image(const image *from, image *to)
{
    const size_t size = (size_t)from->width * from->height * sizeof *from->texels;
    *to = (image){from->width, from->height, malloc(size), 1};
    if (to->texels != NULL)
        memcpy(to->texels, from->texels, size);
    return to->texels != NULL;
}

static void drop_image(image *i)
{
    free(i->texels);
    *i = (image){0, 0, NULL, 1};
}

/* Settles what alpha the diffuse map has. The map of opacity goes into it. */
static bool settle_alpha(const model_part *part, part_maps *maps, model_reader *warnings)
{
    image *const opacity = maps->images + MAP_OPACITY;
    const bool is_opaque = part->surface.alpha == MODEL_OPAQUE;
    bool left_out;
    const bool good =
        image_settle_alpha(maps->images + MAP_DIFFUSE, opacity, part->maps[MAP_OPACITY].channel,
                           is_opaque, part->maps[MAP_DIFFUSE].has_opacity, &left_out);
    if (left_out)
        reader_warn(warnings, NULL, "alpha in its diffuse map is not drawn: the material %s",
                    is_opaque ? "is opaque" : "names no map of opacity");
    drop_image(opacity);
    return good;
}

/* Warns of maps that repeat otherwise than the first: the shaders have one sampler for all. */
static void check_samplers(const model_part *part, const part_maps *maps, model_reader *warnings)
{
    unsigned int present = 0;
    for (int k = 0; k < MAP_COUNT; ++k)
        present |= (maps->images[k].texels != NULL ? 1u : 0u) << k;
    const unsigned int others = model_maps_unlike_first(part, present);
    for (int k = 0; k < MAP_COUNT; ++k)
        if ((others >> k & 1) != 0)
            reader_warn(warnings, NULL,
                        "its %s map repeats otherwise than its first map; it is drawn as that",
                        kinds[k].words);
}

static bool complete_part(const model_part *part, part_maps *maps, model_reader *warnings)
{
    for (int k = 0; k < MAP_COUNT; ++k) {
        const uint32_t number = image_of(part, (map_kind)k);
        if (number >= count || images[number].texels.texels == NULL)
            continue;
        if (k == MAP_NORMAL && image_is_grey(&images[number].texels))
            reader_warn(warnings, NULL,
                        "its normal map holds heights, not normals; it is left out");
        else if (!copy_image(&images[number].texels, maps->images + k))
            return false;
    }
    maps->normals_in_tangent_space = true;
    maps->replaces_color =
        maps->images[MAP_DIFFUSE].texels != NULL && image_of(part, MAP_DIFFUSE) >= by_name;
    if (!settle_alpha(part, maps, warnings))
        return false;
    check_samplers(part, maps, warnings);
    return true;
}

bool page_maps_complete(const model *m, part_maps *maps, model_reader *warnings)
{
    bool good = true;
    for (uint32_t i = 0; i < count; ++i)
        if (images[i].texels.texels != NULL)
            turn(&images[i].texels);
    for (size_t p = 0; p < m->part_count && good; ++p)
        good = complete_part(m->parts + p, maps + p, warnings);
    page_maps_forget();
    return good;
}
