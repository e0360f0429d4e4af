/* Writes what was found out as text and as JSON. */
#include "explain.h"
#include "told.h"

static void put_bytes(prose *t, uint32_t word)
{
    static const char name[4][8] = {"red ", "green ", "blue ", "alpha "};

    for (int c = 0; c < 4; ++c) {
        prose_put(t, c ? ", " : "");
        prose_put(t, name[c]);
        prose_integer(t, word >> 8 * c & 255);
    }
}

static void put_head(prose *t, const explained *e)
{
    prose_put(t, "Pixel ");
    prose_integer(t, e->x);
    prose_put(t, ",");
    prose_integer(t, e->height - 1 - e->y);
    prose_put(t, " of ");
    prose_integer(t, e->width);
    prose_put(t, "x");
    prose_integer(t, e->height);
    prose_put(t, ", counted from the left and from the top.");
    if (e->row == e->y) {
        prose_put(t, " The stages count rows from the\nbottom: there it is x = ");
        prose_integer(t, e->x);
        prose_put(t, ", y = ");
        prose_integer(t, e->row);
        prose_put(t, ".");
    } else {
        prose_put(t, " Here the stages count rows\nfrom the top too, as Vulkan does.");
    }
    prose_put(t, "\n\nIt is ");
    put_bytes(t, e->word);
    prose_put(t, ": the stored word is ");
    prose_hexadecimal(t, e->word, 8);
    prose_put(t, ".\n");
}

static void put_legend(prose *t)
{
    prose_put(t, "\n"
                 "Each line has a name, its value, its bits in hexadecimal, and after = the\n"
                 "expression that made it. Expressions are C over 32-bit floats (IEEE 754\n"
                 "binary32): each operation is rounded to nearest before the next one. These\n"
                 "functions occur: sqrt, min, max, abs, floor, clamp(a, low, high); round (to\n"
                 "the nearest integer, halves to even), int (towards zero), int_floor, float;\n"
                 "byte(w, n) is byte n of a word times 1/255; to_byte(c) is round(255 * c)\n"
                 "within 0 to 255; bytes(r, g, b, a) puts four bytes into a word.\n"
                 "The operators & | ^ << >> work on the bits of a number, also of a float.\n"
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

static void put_stage(prose *t, const report_stage *stage)
{
    const size_t names = widest(stage, false), values = widest(stage, true);

    prose_put(t, "\n  ");
    prose_put(t, report_words(stage->title));
    prose_put(t, "\n");
    for (uint32_t n = stage->first; n < stage->first + stage->count; ++n) {
        const report_value *const v = &told.values[n];

        prose_put(t, "    ");
        prose_padded(t, report_words(v->name), names);
        prose_put(t, "  ");
        prose_padded(t, report_words(v->value), v->bits || v->expression ? values : 0);
        if (v->bits) {
            prose_put(t, "  ");
            prose_put(t, report_words(v->bits));
        } else if (v->expression) {
            prose_padded(t, "", 10);
        }
        if (v->expression) {
            prose_put(t, "  = ");
            prose_put(t, report_words(v->expression));
        }
        prose_put(t, "\n");
    }
}

static void put_stages(prose *t, uint32_t from, uint32_t end)
{
    for (; from < end; ++from)
        if (told.stages[from].count)
            put_stage(t, &told.stages[from]);
}

static void put_primitive(prose *t, const report_fragment *f)
{
    prose_put(t, f->kind);
    prose_put(t, " of primitive ");
    prose_integer(t, f->primitive);
    prose_put(t, " of draw ");
    prose_integer(t, f->draw);
}

/* Puts a line for each fragment that was made. */
static void put_made(prose *t, const explained *e)
{
    if (!e->fragments) {
        prose_put(t, "\nNothing covers it: no primitive has a fragment here, so the pixel has the\n"
                     "colour of the background.\n");
        return;
    }
    prose_put(t, e->fragments == 1 ? "\nOne fragment was made here:\n"
                                   : "\nThese fragments were made here, in this order:\n");
    for (uint32_t i = 0; i < told.fragment_count; ++i) {
        const report_fragment *const f = &told.fragments[i];

        prose_put(t, "  ");
        prose_integer(t, i + 1);
        prose_put(t, ". ");
        put_primitive(t, f);
        prose_put(t, ": ");
        prose_put(t, report_words(f->result));
        prose_put(t, "\n");
    }
    prose_put(t, "Primitives that are culled or lie elsewhere make no fragment.\n");
}

/* Puts the primitive that was asked for, if it has no fragment. */
static void put_missing(prose *t)
{
    const report_fragment *const f = &told.missing;

    bool same_draw = false;

    if (!told.has_missing)
        return;
    for (uint32_t i = 0; i < told.fragment_count; ++i)
        same_draw |= told.fragments[i].draw == f->draw;
    prose_put(t, "\nThe ");
    put_primitive(t, f);
    prose_put(t, " has no fragment here:\n");
    prose_put(t, report_words(f->result));
    prose_put(t, ".\n");
    put_stages(t, f->shared + same_draw, f->own_end);
}

static void put_fragments(prose *t)
{
    for (uint32_t i = 0; i < told.fragment_count; ++i) {
        const report_fragment *const f = &told.fragments[i];
        const bool again = i > 0 && told.fragments[i - 1].shared == f->shared;
        const bool same_draw = i > 0 && told.fragments[i - 1].draw == f->draw;

        prose_put(t, "\nFragment ");
        prose_integer(t, i + 1);
        prose_put(t, ": ");
        prose_put(t, f->kind);
        prose_put(t, " of primitive ");
        prose_integer(t, f->primitive);
        prose_put(t, ", ");
        prose_put(t, report_words(f->result));
        prose_put(t, "\n");
        if (again)
            prose_put(t, "\n  The vertices are those of the fragment before.\n");
        else
            put_stages(t, f->shared + same_draw, f->shared_end); /* without the uniforms */
        put_stages(t, f->own, f->own_end);
    }
}

static void put_checks(prose *t, const explained *e)
{
    prose_put(t, "\nChecked: ");
    prose_integer(t, e->nodes);
    prose_put(t, e->nodes == 1 ? " operation" : " operations");
    prose_put(t, " of the stages were evaluated anew from the bits of their\n"
                 "operands. gn_draw, which draws the picture without tracing, stores ");
    prose_hexadecimal(t, e->drawn_word, 8);
    prose_put(t, ".\n");
    if (e->faults) {
        prose_put(t, "FAULT: ");
        prose_integer(t, e->faults);
        prose_put(t, " checks failed. The first: ");
        prose_put(t, prose_of(&told.fault));
        prose_put(t, ".\n");
    } else {
        prose_put(t, "All bits agree.\n");
    }
}

void explain_text(const explained *e, prose *out)
{
    put_head(out, e);
    put_made(out, e);
    if (e->fragments || told.has_missing)
        put_legend(out);
    put_fragments(out);
    put_missing(out);
    put_checks(out, e);
}

static void put_pair(prose *t, const char *key, int64_t a, int64_t b)
{
    prose_put(t, key);
    prose_character(t, '[');
    prose_integer(t, a);
    prose_character(t, ',');
    prose_integer(t, b);
    prose_character(t, ']');
}

static void put_member(prose *t, const char *key, uint32_t words)
{
    prose_put(t, key);
    prose_json(t, report_words(words));
}

static void put_json_stages(prose *t, uint32_t from, uint32_t end, bool *is_first)
{
    for (; from < end; ++from) {
        const report_stage *const stage = &told.stages[from];

        if (!stage->count)
            continue;
        put_member(t, *is_first ? "{\"name\":" : ",{\"name\":", stage->title);
        *is_first = false;
        prose_put(t, ",\"values\":[");
        for (uint32_t n = 0; n < stage->count; ++n) {
            const report_value *const v = &told.values[stage->first + n];

            put_member(t, n ? ",{\"name\":" : "{\"name\":", v->name);
            put_member(t, ",\"value\":", v->value);
            put_member(t, ",\"bits\":", v->bits);
            put_member(t, ",\"expression\":", v->expression);
            prose_character(t, '}');
        }
        prose_put(t, "]}");
    }
}

static void put_json_fragment(prose *t, const explained *e, const report_fragment *f)
{
    bool is_first = true;

    prose_put(t, "{\"draw\":");
    prose_integer(t, f->draw);
    prose_put(t, ",\"primitive\":");
    prose_integer(t, f->primitive);
    prose_put(t, ",\"kind\":");
    prose_json(t, f->kind);
    put_member(t, ",\"result\":", f->result);
    prose_put(t, ",\"corners\":[");
    for (uint32_t i = 0; i < f->corner_count; ++i)
        put_pair(t, i ? "," : "", f->corner[i][0],
                 e->row == e->y ? f->corner[i][1]
                                : 256 * ((int64_t)e->height - 1) - f->corner[i][1]);
    prose_put(t, "],\"stages\":[");
    put_json_stages(t, f->shared, f->shared_end, &is_first);
    put_json_stages(t, f->own, f->own_end, &is_first);
    prose_put(t, "]}");
}

void explain_json(const explained *e, prose *out)
{
    prose plain = {0};

    explain_text(e, &plain);
    put_pair(out, "{\"pixel\":", e->x, e->y);
    put_pair(out, ",\"size\":", e->width, e->height);
    prose_put(out, ",\"color\":\"");
    prose_hexadecimal(out, e->word, 8);
    prose_put(out, "\",\"text\":");
    prose_json(out, prose_of(&plain));
    prose_put(out, ",\"fragments\":[");
    for (uint32_t i = 0; i < told.fragment_count; ++i) {
        prose_put(out, i ? "," : "");
        put_json_fragment(out, e, &told.fragments[i]);
    }
    prose_put(out, "]");
    if (told.has_missing) {
        prose_put(out, ",\"missing\":");
        put_json_fragment(out, e, &told.missing);
    }
    prose_put(out, "}\n");
    out->failed |= plain.failed;
    prose_free(&plain);
}
