/* Writes what was found out as text and as JSON. */
#include "explain.h"
#include "told.h"

static void put_bytes(text *t, uint32_t word)
{
    static const char name[4][8] = {"red ", "green ", "blue ", "alpha "};

    for (int c = 0; c < 4; ++c) {
        text_put(t, c ? ", " : "");
        text_put(t, name[c]);
        text_integer(t, word >> 8 * c & 255);
    }
}

static void put_head(text *t, const explained *e)
{
    text_put(t, "Pixel ");
    text_integer(t, e->x);
    text_put(t, ",");
    text_integer(t, e->height - 1 - e->y);
    text_put(t, " of ");
    text_integer(t, e->width);
    text_put(t, "x");
    text_integer(t, e->height);
    text_put(t, ", counted from the left and from the top. The stages count rows from the\n"
                "bottom: there it is x = ");
    text_integer(t, e->x);
    text_put(t, ", y = ");
    text_integer(t, e->y);
    text_put(t, ".\n\nIt is ");
    put_bytes(t, e->word);
    text_put(t, ": the stored word is ");
    text_hexadecimal(t, e->word, 8);
    text_put(t, ".\n");
}

static void put_legend(text *t)
{
    text_put(t, "\n"
                "Each line has a name, its value, its bits in hexadecimal, and after = the\n"
                "expression that made it. Expressions are C over 32-bit floats (IEEE 754\n"
                "binary32): each operation is rounded to nearest before the next one. These\n"
                "functions occur: sqrt, min, max, abs, floor, clamp(a, low, high); round (to\n"
                "the nearest integer, halves to even), int (towards zero), int_floor, float;\n"
                "byte(w, n) is byte n of a word times 1/255; to_byte(c) is round(255 * c)\n"
                "within 0 to 255; bytes(r, g, b, a) puts four bytes into a word.\n"
                "t1, t2, ... are steps of longer expressions.\n");
}

static size_t widest(const report_stage *stage, bool values)
{
    size_t most = 0;

    for (uint32_t n = stage->first; n < stage->first + stage->count; ++n) {
        const report_value *const v = &told.values[n];
        const char *words = report_words(values ? v->value : v->name);
        size_t length = 0;

        while (words[length])
            ++length;
        most = length > most && length <= 24 ? length : most;
    }
    return most;
}

static void put_stage(text *t, const report_stage *stage)
{
    const size_t names = widest(stage, false), values = widest(stage, true);

    text_put(t, "\n  ");
    text_put(t, report_words(stage->title));
    text_put(t, "\n");
    for (uint32_t n = stage->first; n < stage->first + stage->count; ++n) {
        const report_value *const v = &told.values[n];

        text_put(t, "    ");
        text_padded(t, report_words(v->name), names);
        text_put(t, "  ");
        text_padded(t, report_words(v->value), v->bits || v->expression ? values : 0);
        if (v->bits) {
            text_put(t, "  ");
            text_put(t, report_words(v->bits));
        } else if (v->expression) {
            text_padded(t, "", 10);
        }
        if (v->expression) {
            text_put(t, "  = ");
            text_put(t, report_words(v->expression));
        }
        text_put(t, "\n");
    }
}

static void put_stages(text *t, uint32_t from, uint32_t end)
{
    for (; from < end; ++from)
        if (told.stages[from].count)
            put_stage(t, &told.stages[from]);
}

static void put_overview(text *t, const explained *e)
{
    if (!e->fragments) {
        text_put(t, "\nNothing covers it: no primitive has a fragment here, so the pixel has the\n"
                    "colour of the background.\n");
        return;
    }
    text_put(t, e->fragments == 1 ? "\nOne fragment was made here:\n"
                                  : "\nThese fragments were made here, in this order:\n");
    for (uint32_t i = 0; i < told.fragment_count; ++i) {
        const report_fragment *const f = &told.fragments[i];

        text_put(t, "  ");
        text_integer(t, i + 1);
        text_put(t, ". ");
        text_put(t, f->kind);
        text_put(t, " of primitive ");
        text_integer(t, f->primitive);
        text_put(t, " of draw ");
        text_integer(t, f->draw);
        text_put(t, ": ");
        text_put(t, report_words(f->result));
        text_put(t, "\n");
    }
    text_put(t, "Primitives that are culled or lie elsewhere make no fragment.\n");
}

static void put_fragments(text *t)
{
    for (uint32_t i = 0; i < told.fragment_count; ++i) {
        const report_fragment *const f = &told.fragments[i];
        const bool again = i > 0 && told.fragments[i - 1].shared == f->shared;

        text_put(t, "\nFragment ");
        text_integer(t, i + 1);
        text_put(t, ": ");
        text_put(t, f->kind);
        text_put(t, " of primitive ");
        text_integer(t, f->primitive);
        text_put(t, ", ");
        text_put(t, report_words(f->result));
        text_put(t, "\n");
        if (again)
            text_put(t, "\n  The vertices are those of the fragment before.\n");
        else
            put_stages(t, f->shared, f->shared_end);
        put_stages(t, f->own, f->own_end);
    }
}

static void put_resolve(text *t, const explained *e)
{
    if (e->samples == 1)
        return;
    text_put(t, "\nThe samples' words, and the pixel: each byte is the mean of the four\n");
    for (uint32_t s = 0; s < e->samples; ++s) {
        text_put(t, s ? ", " : "  ");
        text_hexadecimal(t, e->sample_word[s], 8);
    }
    text_put(t, "; resolved ");
    text_hexadecimal(t, e->word, 8);
    text_put(t, "\n");
}

static void put_checks(text *t, const explained *e)
{
    text_put(t, "\nChecked: ");
    text_integer(t, e->nodes);
    text_put(t, e->nodes == 1 ? " operation" : " operations");
    text_put(t, " of the stages were evaluated anew from the bits of their\n"
                "operands. gn_draw, which draws the whole picture without tracing, stores ");
    text_hexadecimal(t, e->drawn_word, 8);
    text_put(t, ".\n");
    if (e->faults) {
        text_put(t, "FAULT: ");
        text_integer(t, e->faults);
        text_put(t, " checks failed. The first: ");
        text_put(t, text_of(&told.fault));
        text_put(t, ".\n");
    } else {
        text_put(t, "All bits agree.\n");
    }
}

void explain_text(const explained *e, text *out)
{
    put_head(out, e);
    put_overview(out, e);
    if (e->fragments) {
        put_legend(out);
        put_fragments(out);
        put_resolve(out, e);
    }
    put_checks(out, e);
}

static void put_pair(text *t, const char *key, int64_t a, int64_t b)
{
    text_put(t, key);
    text_character(t, '[');
    text_integer(t, a);
    text_character(t, ',');
    text_integer(t, b);
    text_character(t, ']');
}

static void put_member(text *t, const char *key, uint32_t words)
{
    text_put(t, key);
    text_json(t, report_words(words));
}

static void put_json_stages(text *t, uint32_t from, uint32_t end, bool *is_first)
{
    for (; from < end; ++from) {
        const report_stage *const stage = &told.stages[from];

        if (!stage->count)
            continue;
        put_member(t, *is_first ? "{\"name\":" : ",{\"name\":", stage->title);
        *is_first = false;
        text_put(t, ",\"values\":[");
        for (uint32_t n = 0; n < stage->count; ++n) {
            const report_value *const v = &told.values[stage->first + n];

            put_member(t, n ? ",{\"name\":" : "{\"name\":", v->name);
            put_member(t, ",\"value\":", v->value);
            put_member(t, ",\"bits\":", v->bits);
            put_member(t, ",\"expression\":", v->expression);
            text_character(t, '}');
        }
        text_put(t, "]}");
    }
}

static void put_json_fragment(text *t, const report_fragment *f)
{
    bool is_first = true;

    text_put(t, "{\"draw\":");
    text_integer(t, f->draw);
    text_put(t, ",\"primitive\":");
    text_integer(t, f->primitive);
    text_put(t, ",\"kind\":");
    text_json(t, f->kind);
    put_member(t, ",\"result\":", f->result);
    text_put(t, ",\"corners\":[");
    for (uint32_t i = 0; i < f->corner_count; ++i)
        put_pair(t, i ? "," : "", f->corner[i][0], f->corner[i][1]);
    text_put(t, "],\"stages\":[");
    put_json_stages(t, f->shared, f->shared_end, &is_first);
    put_json_stages(t, f->own, f->own_end, &is_first);
    text_put(t, "]}");
}

void explain_json(const explained *e, text *out)
{
    text plain = {0};

    explain_text(e, &plain);
    put_pair(out, "{\"pixel\":", e->x, e->y);
    put_pair(out, ",\"size\":", e->width, e->height);
    text_put(out, ",\"color\":\"");
    text_hexadecimal(out, e->word, 8);
    text_put(out, "\",\"text\":");
    text_json(out, text_of(&plain));
    text_put(out, ",\"fragments\":[");
    for (uint32_t i = 0; i < told.fragment_count; ++i) {
        text_put(out, i ? "," : "");
        put_json_fragment(out, &told.fragments[i]);
    }
    text_put(out, "]}\n");
    out->failed |= plain.failed;
    text_free(&plain);
}
