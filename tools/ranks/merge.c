/* Merges frames that ranks have drawn. */
#include "merge.h"

#include <stdlib.h>
#include <string.h>

#include "ranks.h"
#include "report.h"

/* Bytes of the pieces that a rank holds at a time, of all ranks together. */
#define PIECES_SIZE ((size_t)64 << 20)

static gn_compare function_of(const scene_draw *d)
{
    const gn_compare function = d->state.depth.function;
    return function == GN_COMPARE_DEFAULT ? GN_LESS : function;
}

static uint32_t colors_of(const scene_draw *d)
{
    const uint32_t count = d->state.program.color_count;
    return d->shader == SCENE_DEPTH_ONLY ? 0 : d->shader == SCENE_OUTPUTS && count > 0 ? count : 1;
}

static bool uses_centroids(const scene_draw *d)
{
    for (int v = 0; v < GN_MAX_VARYINGS; ++v)
        if (d->state.program.interpolated_at[v] == GN_AT_CENTROID)
            return true;
    return false;
}

static const char *depth_refusal(const scene *s, const scene_draw *d)
{
    if (!scene_has_depth(s->depth_format))
        return "the target has no depth";
    if (!d->state.depth.test_enabled)
        return "a draw without depth test";
    if (d->state.depth.write_disabled)
        return "a draw that writes no depth";
    /* Where an equal depth passes, a fragment at the cleared depth cannot be told from none. */
    if (function_of(d) != GN_LESS && function_of(d) != GN_GREATER)
        return "a depth function other than less or greater";
    if (function_of(d) != function_of(s->draws))
        return "draws with different depth functions";
    return NULL;
}

static const char *color_refusal(const scene *s, const scene_draw *d)
{
    const gn_pipeline *p = &d->state;
    for (int a = 0; a < GN_MAX_COLORS; ++a)
        if (scene_color_format(s, a) != GN_FORMAT_NONE && p->color.blend[a].enabled)
            return "blending";
    if (p->color.logic_enabled)
        return "a logic operation";
    if (memcmp(p->color.write_disabled, s->draws[0].state.color.write_disabled,
               sizeof p->color.write_disabled) != 0 ||
        colors_of(d) != colors_of(s->draws))
        return "draws that write different colours";
    return NULL;
}

static const char *draw_refusal(const scene *s, const scene_draw *d)
{
    const char *why = depth_refusal(s, d);
    if (why == NULL)
        why = color_refusal(s, d);
    if (why != NULL)
        return why;
    if (d->state.stencil.test_enabled)
        return "the stencil test";
    if (d->clear.color || d->clear.depth)
        return "a clear between draws";
    if (d->shader == SCENE_INPUTS && d->state.program.fragment_reads_primitive)
        return "a shader that reads the number of its primitive";
    /* Both depend on which samples pass the depth test. */
    if (scene_is_sampled(s) && uses_centroids(d))
        return "values at centroids";
    if (scene_is_sampled(s) && d->shader == SCENE_INPUTS &&
        d->state.program.fragment_reads_sample_mask)
        return "a shader that reads the sample mask";
    return NULL;
}

const char *merge_refusal(const scene *s)
{
    const char *why = NULL;
    for (size_t i = 0; i < s->draw_count && why == NULL; ++i)
        why = draw_refusal(s, s->draws + i);
    return why;
}

/* The attachments of a frame: colours, then depth. */
typedef struct attachments {
    int count;
    void *memory[GN_MAX_COLORS + 1];
    size_t size[GN_MAX_COLORS + 1]; /* of a pixel */
    size_t row;                     /* bytes of a row of all samples of all attachments */
    uint32_t samples;
} attachments;

static attachments list_attachments(const scene *s, const scene_frame *frame)
{
    attachments list;
    memset(&list, 0, sizeof list);
    list.samples = scene_is_sampled(s) ? GN_SAMPLES : 1;
    for (int a = 0; a <= GN_MAX_COLORS; ++a) {
        const bool is_depth = a == GN_MAX_COLORS;
        void *const memory = is_depth ? frame->depth : scene_frame_color(frame, a);
        const gn_format format = is_depth ? frame->depth_format : scene_frame_format(frame, a);
        if (memory == NULL)
            continue;
        list.memory[list.count] = memory;
        list.size[list.count++] = gn_format_size(format);
        list.row += list.samples * s->width * gn_format_size(format);
    }
    return list;
}

/* Copies rows of all samples of all attachments, one after the other, out of a frame or into it. */
static void copy_rows(const scene *s, const attachments *list, row_range rows, uint8_t *piece,
                      bool into_frame)
{
    const size_t lowest = s->height - rows.first - rows.count;
    for (int a = 0; a < list->count; ++a) {
        const size_t row = s->width * list->size[a], size = rows.count * row;
        for (size_t sample = 0; sample < list->samples; ++sample) {
            uint8_t *const place = (uint8_t *)list->memory[a] + (sample * s->height + lowest) * row;
            if (into_frame)
                memcpy(place, piece, size);
            else
                memcpy(piece, place, size);
            piece += size;
        }
    }
}

/* The depth of a pixel, as a number that is compared. Every depth of 24 bits is a double. */
static double depth_at(gn_format format, const uint8_t *pixel)
{
    uint16_t half;
    uint32_t word;
    float value;
    switch (format) {
    case GN_FORMAT_D16:
        memcpy(&half, pixel, sizeof half);
        return half;
    case GN_FORMAT_D24:
    case GN_FORMAT_D24S8:
        memcpy(&word, pixel, sizeof word);
        return word & 0xffffff;
    default:
        memcpy(&value, pixel, sizeof value);
        return (double)value;
    }
}

/* Merges `later` into `first`: both hold this many rows. */
static void merge(const scene *s, const attachments *list, gn_compare function, uint32_t rows,
                  uint8_t *first, const uint8_t *later)
{
    const size_t pixels = (size_t)rows * s->width * list->samples;
    size_t depths = 0;
    for (int a = 0; a < list->count - 1; ++a)
        depths += pixels * list->size[a];
    const size_t depth_size = list->size[list->count - 1];
    for (size_t i = 0; i < pixels; ++i) {
        const double old = depth_at(s->depth_format, first + depths + i * depth_size);
        const double new = depth_at(s->depth_format, later + depths + i * depth_size);
        if (function == GN_GREATER ? !(new > old) : !(new < old))
            continue;
        size_t begin = 0;
        for (int a = 0; a < list->count; ++a) {
            const size_t size = list->size[a];
            memcpy(first + begin + i * size, later + begin + i * size, size);
            begin += pixels * size;
        }
    }
}

/* Rows of a band from row `at` on. */
static row_range piece_of(row_range band, uint32_t at, uint32_t most)
{
    const uint32_t left = at < band.count ? band.count - at : 0;
    return (row_range){band.first + (left > 0 ? at : 0), left < most ? left : most};
}

/* What all pieces of a merge have in common. */
typedef struct exchange {
    const scene *s;
    attachments list;
    gn_compare function;
    uint32_t unit, most; /* rows of a piece */
    uint8_t *sent;
    uint8_t *pieces; /* of each rank one */
} exchange;

/* Sends rows to their owners, takes the others' rows of the own band, and merges them. */
static void exchange_rows(const exchange *e, uint32_t at)
{
    const uint32_t count = ranks_count(), me = ranks_number();
    const size_t size = e->list.row * e->most;
    const row_range own = piece_of(band_of_rank(e->s->height, e->unit, me, count), at, e->most);
    copy_rows(e->s, &e->list, own, e->pieces + me * size, false);
    for (uint32_t step = 1; step < count; ++step) {
        const uint32_t to = (me + step) % count, from = (me + count - step) % count;
        const row_range rows =
            piece_of(band_of_rank(e->s->height, e->unit, to, count), at, e->most);
        copy_rows(e->s, &e->list, rows, e->sent, false);
        ranks_swap(to, e->sent, e->list.row * rows.count, from, e->pieces + from * size,
                   e->list.row * own.count);
    }
    for (uint32_t r = 1; r < count; ++r)
        merge(e->s, &e->list, e->function, own.count, e->pieces, e->pieces + r * size);
    copy_rows(e->s, &e->list, own, e->pieces, true);
}

static uint32_t largest_band(uint32_t height, uint32_t unit)
{
    uint32_t largest = 0;
    for (uint32_t r = 0; r < ranks_count(); ++r) {
        const row_range band = band_of_rank(height, unit, r, ranks_count());
        largest = band.count > largest ? band.count : largest;
    }
    return largest;
}

int merge_bands(const scene *s, uint32_t unit, scene_frame *frame)
{
    exchange e = {s, list_attachments(s, frame), GN_LESS, unit, 1, NULL, NULL};
    const size_t count = ranks_count();
    const uint32_t rows = largest_band(s->height, unit);
    if (s->draw_count > 0)
        e.function = function_of(s->draws);
    if (count == 1)
        return 0;
    e.most = (uint32_t)(PIECES_SIZE / (count + 1) / e.list.row);
    e.most = e.most < 1 ? 1 : e.most < rows ? e.most : rows;
    e.sent = malloc(e.list.row * e.most);
    e.pieces = malloc(e.list.row * e.most * count);
    int fault = 0;
    if (e.sent == NULL || e.pieces == NULL)
        fault = report_fault("--sort last", "not enough memory");
    fault = ranks_agree(fault);
    for (uint32_t at = 0; fault == 0 && at < rows; at += e.most)
        exchange_rows(&e, at);
    free(e.sent);
    free(e.pieces);
    return fault;
}
