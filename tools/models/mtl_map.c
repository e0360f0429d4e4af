/* Statements of MTL that name an image: options, and the name before, between or behind them. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "mtl.h"

/* The words of a statement. A name with more words than this is cut. */
#define MOST_WORDS 64

typedef struct option {
    const char *name;
    enum { ON_OFF, WORD, NUMBERS } takes;
    size_t least, most; /* of NUMBERS */
} option;

static const option options[] = {
    {"-blendu", ON_OFF, 1, 1}, {"-blendv", ON_OFF, 1, 1},   {"-boost", NUMBERS, 1, 1},
    {"-bm", NUMBERS, 1, 1},    {"-cc", ON_OFF, 1, 1},       {"-clamp", ON_OFF, 1, 1},
    {"-imfchan", WORD, 1, 1},  {"-mm", NUMBERS, 1, 2},      {"-o", NUMBERS, 1, 3},
    {"-s", NUMBERS, 1, 3},     {"-t", NUMBERS, 1, 3},       {"-texres", NUMBERS, 1, 1},
    {"-type", WORD, 1, 1},     {"-colorspace", WORD, 1, 1},
};

/* An option with what stands behind it. */
typedef struct setting {
    const option *option;
    double numbers[3]; /* on: 1, off: 0 */
    size_t count;
    text_word word;
    size_t length; /* words, the option's included */
} setting;

mtl_map mtl_no_map(void)
{
    mtl_map map;
    memset(&map, 0, sizeof map);
    map.scale[0] = map.scale[1] = map.strength = 1.0f;
    return map;
}

static const option *find_option(text_word word)
{
    for (size_t i = 0; i < sizeof options / sizeof options[0]; ++i)
        if (text_is_any_case(word, options[i].name))
            return options + i;
    return NULL;
}

/* Reads the option at words[0]. Returns false if it is none or if what it takes is not there. */
static bool read_setting(const text_word *words, size_t count, setting *s)
{
    s->option = count > 0 ? find_option(words[0]) : NULL;
    s->count = 0;
    s->length = 2;
    if (s->option == NULL || count < 2)
        return false;
    s->word = words[1];
    if (s->option->takes == ON_OFF) {
        s->numbers[0] = text_is_any_case(words[1], "on");
        return s->numbers[0] != 0.0 || text_is_any_case(words[1], "off");
    }
    if (s->option->takes == NUMBERS) {
        while (s->count < s->option->most && s->count + 1 < count &&
               text_number(words[s->count + 1], false, s->numbers + s->count) &&
               fabs(s->numbers[s->count]) <= (double)FLT_MAX)
            ++s->count;
        s->length = s->count + 1;
        return s->count >= s->option->least;
    }
    return true;
}

/* Whether all these words are options. */
static bool are_settings(const text_word *words, size_t count)
{
    setting s;
    for (size_t at = 0; at < count; at += s.length)
        if (!read_setting(words + at, count - at, &s))
            return false;
    return true;
}

/* A value that changes what is seen, of an option that is not drawn. */
static bool is_seen(const setting *s)
{
    const char *const name = s->option->name;
    if (strcmp(name, "-blendu") == 0 || strcmp(name, "-blendv") == 0)
        return s->numbers[0] == 0.0;
    if (strcmp(name, "-mm") == 0)
        return s->numbers[0] != 0.0 || (s->count > 1 && s->numbers[1] != 1.0);
    if (s->option->takes == NUMBERS && strcmp(name, "-texres") != 0) {
        bool is_zero = true;
        for (size_t i = 0; i < s->count; ++i)
            is_zero = is_zero && s->numbers[i] == 0.0;
        return !is_zero;
    }
    return s->option->takes != ON_OFF || s->numbers[0] != 0.0;
}

static void apply(model_reader *r, uint64_t line, text_word keyword, const setting *s, mtl_map *map)
{
    const char *const name = s->option->name;
    char copy[40];
    if (strcmp(name, "-s") == 0 || strcmp(name, "-o") == 0) {
        float *const vector = name[1] == 's' ? map->scale : map->offset;
        for (size_t i = 0; i < 2 && i < s->count; ++i)
            vector[i] = (float)s->numbers[i];
    } else if (strcmp(name, "-bm") == 0) {
        map->strength = (float)s->numbers[0];
    } else if (strcmp(name, "-clamp") == 0) {
        map->is_clamped = s->numbers[0] != 0.0;
    } else if (strcmp(name, "-imfchan") == 0) {
        const char letter = s->word.start[0];
        if (s->word.length == 1 && strchr("rgbmlz", letter) != NULL)
            map->channel = letter;
        else
            reader_warn(r, reader_line(r, line), "-imfchan %s is not known",
                        text_copy(s->word, copy, sizeof copy));
    } else if (is_seen(s)) {
        reader_warn(r, reader_line(r, line), "%s of %s is not drawn", name,
                    text_copy(keyword, copy, sizeof copy));
    }
}

/* Where the name ends that begins at words[0]: before words that are options up to the end. */
static size_t name_length(const text_word *words, size_t count)
{
    for (size_t i = 1; i < count; ++i)
        if (find_option(words[i]) != NULL && are_settings(words + i, count - i))
            return i;
    return count;
}

/* The words as they stand in the file, blanks between them included. */
static text_word join(const text_word *words, size_t count)
{
    text_word name = words[0];
    name.length = (size_t)(words[count - 1].start + words[count - 1].length - name.start);
    if (name.length > 2 && name.start[0] == '"' && name.start[name.length - 1] == '"') {
        ++name.start;
        name.length -= 2;
    }
    return name;
}

bool mtl_read_map(model_reader *r, text_cursor *t, text_word keyword, mtl_map *map)
{
    text_word words[MOST_WORDS], word;
    size_t count = 0, at = 0;
    setting s;
    char copy[40];
    *map = mtl_no_map();
    while (text_next_word(t, &word))
        if (count < MOST_WORDS)
            words[count++] = word;
    /* The last word is the name unless options stand behind it: -s 2 2 5 means a file 5. */
    while (at + 1 < count && find_option(words[at]) != NULL) {
        if (!read_setting(words + at, count - 1 - at, &s) &&
            !read_setting(words + at, count - at, &s)) {
            reader_warn(r, reader_line(r, t->statement), "%s of %s lacks its value", s.option->name,
                        text_copy(keyword, copy, sizeof copy));
            ++at;
            continue;
        }
        apply(r, t->statement, keyword, &s, map);
        at += s.length;
    }
    if (at >= count) {
        reader_warn(r, reader_line(r, t->statement), "%s names no file",
                    text_copy(keyword, copy, sizeof copy));
        return false;
    }
    const size_t length = name_length(words + at, count - at);
    map->name = join(words + at, length);
    for (at += length; at < count; at += s.length)
        if (read_setting(words + at, count - at, &s))
            apply(r, t->statement, keyword, &s, map);
    return true;
}
